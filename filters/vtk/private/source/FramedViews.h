// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Views.h"
#include "private/source/ImageFrame.h"

#include <cstdint>
#include <deque>
#include <vector>

namespace winding
{

/**
 * Views of a source in the coordinates of an image, with the winding numbers that the source has in
 * space: triangles of a mirrored image have the other sense. Views of straight frames are the ones
 * that came in; others are valid as long as this object.
 */
class FramedViews
{
public:
  explicit FramedViews(const ImageFrame& frame)
    : frame_(frame)
  {
  }

  std::vector<TrianglesView> of(std::vector<TrianglesView> views);
  std::vector<OrientedPointsView> of(std::vector<OrientedPointsView> views);

private:
  template <class Map> VectorsView mapped(const VectorsView& vectors, const Map& map);
  TriangleIdsView reversed(const TriangleIdsView& triangles);

  ImageFrame frame_;
  std::deque<std::vector<double>> vectors_;
  std::deque<std::vector<std::int64_t>> ids_;
};

} // namespace winding
