// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Views.h"

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace winding
{

class Executor;

/// The points of a mesh as oriented points, numbered as in the mesh.
class MeshVertices
{
public:
  MeshVertices() = default;
  /// Three numbers for the normal of each point and one for its area.
  explicit MeshVertices(std::vector<Eigen::Array4d> normalsAndAreas)
    : normalsAndAreas_(std::move(normalsAndAreas))
  {
  }

  /// The sum of the area vectors of the triangles around each point, not of unit length; 0 for
  /// points without triangles.
  VectorsView normals() const { return {this->data(), normalsAndAreas_.size(), 4}; }

  /// A third of the areas of the triangles around each point; the sum over all points is the area
  /// of the mesh.
  ScalarsView areas() const
  {
    return {this->data() ? this->data() + 3 : nullptr, normalsAndAreas_.size(), 4};
  }

private:
  const double* data() const
  {
    return normalsAndAreas_.empty() ? nullptr : normalsAndAreas_[0].data();
  }

  std::vector<Eigen::Array4d> normalsAndAreas_;
};

/// Normals and areas from triangles of several views over the same points; there are
/// `points`. Triangles with invalid ids or corners that are not finite are left out. The bits
/// depend on the set of oriented triangles around each point, not on their order nor on threads:
/// shares are rounded such that their sums are exact, by 2⁻⁴⁸ of the product of the two shortest
/// sides of a triangle around the point, times their number, at most. Areas beyond 2⁹⁰⁰ are summed
/// without that. Takes linear time, on two threads at most, and 80 bytes per point while it runs,
/// and 32 of them stay. Throws Interrupted.
MeshVertices meshVertices(
  const std::vector<TrianglesView>& views, std::size_t points, Executor& executor);

} // namespace winding
