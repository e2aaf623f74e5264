// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkType.h"
#include "vtkWindingABINamespace.h"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiBlockDataSet;
VTK_ABI_NAMESPACE_END

/// Red, green, blue and opacity.
using MeshColor = std::array<unsigned char, 4>;
constexpr MeshColor white = {255, 255, 255, 255};

/// Whether things of any of some colors can be seen through.
bool areAnyClear(const std::vector<MeshColor>& colors);

/// Points and cells of a block that a reader makes. Its numbers of points are not checked.
struct MeshBlock
{
  std::string name;
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals; ///< of a cloud
  std::vector<MeshColor> colors;        ///< of points; further ones are white
  std::vector<std::array<vtkIdType, 3>> triangles;
  std::vector<std::array<vtkIdType, 2>> lines;
  std::vector<vtkIdType> vertices;
};

/// Appends polydata of `block` to `output`, with its name and its colors, if it has any, which have
/// an opacity `withOpacity`. Normals are of points without faces.
void appendBlock(const MeshBlock& block, bool withOpacity, vtkMultiBlockDataSet* output);
