// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkMultiBlockDataSetAlgorithm.h"

#include <string>

/**
 * Reads the meshes of a 3MF package (3MF core specification 1.3, production extension 1.1).
 *
 * Each mesh in the build becomes a block in its place; a build without items is all its objects.
 * A mesh in which a slicer has marked parts becomes a block for each, and one for the rest. Blocks
 * have the names of parts, or of objects. Transforms that mirror turn faces round, so that they
 * still look outward. Supports, modifiers and negative parts are left out, as PrusaSlicer, Bambu
 * Studio and Cura mark them. Coordinates stay in the unit of the first model part.
 *
 * Sends moreBytesEvent, and lines by vtkCommand::MessageEvent: for what is left out, and for
 * another unit than the millimetre. Throws Failure for packages that are damaged, or that need
 * another extension.
 */
class ThreeMfReader : public vtkMultiBlockDataSetAlgorithm
{
public:
  static ThreeMfReader* New();
  vtkTypeMacro(ThreeMfReader, vtkMultiBlockDataSetAlgorithm);

  void SetFileName(const char* name) { fileName_ = name; }

protected:
  ThreeMfReader();
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;

private:
  std::string fileName_;
};
