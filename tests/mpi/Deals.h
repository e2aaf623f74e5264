// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/Shapes.h"

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/// A way to deal a source's primitives out to ranks.
struct Deal
{
  std::string name;
  /// The rank that gets primitive i of n.
  int (*rankOf)(std::size_t i, std::size_t n, int ranks);
};

/// Singly, in slabs, all to the last rank, to every other rank.
const std::vector<Deal>& deals();

/// The triangles that a rank gets, with the points that they use, in another order on each rank.
vtkSmartPointer<vtkPolyData> partOf(
  const shapes::Mesh& mesh, const Deal& deal, int rank, int ranks);

/// The points of a mesh that a rank gets, with the mesh's positions as their normals.
vtkSmartPointer<vtkPolyData> pointsOf(
  const shapes::Mesh& mesh, const Deal& deal, int rank, int ranks);
