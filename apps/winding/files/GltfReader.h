// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkMultiBlockDataSetAlgorithm.h"

#include <string>

/**
 * Reads the meshes of a glTF 2.0 file: .gltf, with its buffers in files or in the text, or .glb.
 *
 * Each node of the scene that has a mesh becomes a block of its name, or of its mesh's, in the
 * place where it stands: nodes, instances, skins and morph targets move it. Nodes that mirror turn
 * faces round, so that they still look outward. Nodes of lines or points alone are cells of the
 * first block with faces, if there is one. Pictures, materials and optional extensions are not
 * looked at. Throws Failure for files that are not right, or that need another extension.
 */
class GltfReader : public vtkMultiBlockDataSetAlgorithm
{
public:
  static GltfReader* New();
  vtkTypeMacro(GltfReader, vtkMultiBlockDataSetAlgorithm);

  void SetFileName(const char* name) { fileName_ = name; }

protected:
  GltfReader();
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;

private:
  std::string fileName_;
};
