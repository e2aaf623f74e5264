// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/FramedViews.h"

#include <algorithm>

namespace winding
{

template <class Map> VectorsView FramedViews::mapped(const VectorsView& vectors, const Map& map)
{
  vectors_.emplace_back(3 * vectors.size());
  double* next = vectors_.back().data();
  for (std::size_t i = 0; i < vectors.size(); ++i)
  {
    const Eigen::Vector3d result = map(vectors[i]);
    next = std::copy_n(result.data(), 3, next);
  }
  return {vectors_.back().data(), vectors.size()};
}

TriangleIdsView FramedViews::reversed(const TriangleIdsView& triangles)
{
  ids_.emplace_back();
  ids_.back().reserve(3 * triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    ids_.back().insert(ids_.back().end(), {triangles(i, 0), triangles(i, 2), triangles(i, 1)});
  }
  return {ids_.back().data(), triangles.size()};
}

std::vector<TrianglesView> FramedViews::of(std::vector<TrianglesView> views)
{
  for (TrianglesView& view : views)
  {
    if (!frame_.isStraight())
    {
      view.points =
        this->mapped(view.points, [this](const Eigen::Vector3d& p) { return frame_.position(p); });
    }
    if (frame_.isMirrored())
    {
      view.triangles = this->reversed(view.triangles);
    }
  }
  return views;
}

std::vector<OrientedPointsView> FramedViews::of(std::vector<OrientedPointsView> views)
{
  for (OrientedPointsView& view : views)
  {
    if (!frame_.isStraight())
    {
      view.positions = this->mapped(
        view.positions, [this](const Eigen::Vector3d& p) { return frame_.position(p); });
      view.normals = this->mapped(
        view.normals, [this](const Eigen::Vector3d& n) { return frame_.direction(n); });
    }
  }
  return views;
}

} // namespace winding
