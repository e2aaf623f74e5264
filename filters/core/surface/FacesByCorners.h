#pragma once

#include "source/Surface.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace winding
{

/// Faces by their corners, each from its lowest on towards the lower one of its neighbours.
class FacesByCorners
{
public:
  /// Adds a face with these corners around it.
  void add(const std::vector<std::int32_t>& corners, const std::vector<std::int32_t>& triangles)
  {
    corners_.insert(corners_.end(), corners.begin(), corners.end());
    isForward_.push_back(this->putInOrder(starts_.back()));
    starts_.push_back(corners_.size());
    triangles_.insert(triangles_.end(), triangles.begin(), triangles.end());
    trianglesEnds_.push_back(triangles_.size());
  }

  std::size_t size() const { return isForward_.size(); }
  bool isForward(std::size_t face) const { return isForward_[face] != 0; }

  std::vector<std::int32_t> corners(std::size_t face) const
  {
    return {this->begin(face), this->begin(face + 1)};
  }

  std::vector<std::int32_t> triangles(std::size_t face) const
  {
    const auto at = [this](std::size_t i)
    {
      return triangles_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    return {at(trianglesEnds_[face]), at(trianglesEnds_[face + 1])};
  }

  /// Calls visit(first, last) for the numbers of all faces with the same corners.
  template <class Visit> void forEachGroup(const Visit& visit) const
  {
    std::vector<std::size_t> order(this->size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
      [this](std::size_t a, std::size_t b) { return this->isLess(a, b); });
    for (auto first = order.begin(), last = first; first != order.end(); first = last)
    {
      last = std::find_if(
        first, order.end(), [&](std::size_t face) { return this->isLess(*first, face); });
      visit(first, last);
    }
  }

private:
  using Corner = std::vector<std::int32_t>::const_iterator;

  Corner begin(std::size_t face) const
  {
    return corners_.begin() + static_cast<std::ptrdiff_t>(starts_[face]);
  }

  bool isLess(std::size_t a, std::size_t b) const
  {
    return std::lexicographical_compare(
      this->begin(a), this->begin(a + 1), this->begin(b), this->begin(b + 1));
  }

  /// Puts the corners from `start` on in order. Returns whether the face runs as they do.
  bool putInOrder(std::size_t start)
  {
    const auto first = corners_.begin() + static_cast<std::ptrdiff_t>(start);
    std::rotate(first, std::min_element(first, corners_.end()), corners_.end());
    const bool isForward = *(first + 1) <= corners_.back();
    if (!isForward)
    {
      std::reverse(first + 1, corners_.end());
    }
    return isForward;
  }

  std::vector<std::int32_t> corners_, triangles_;
  std::vector<std::size_t> starts_ = {0}, trianglesEnds_ = {0};
  std::vector<char> isForward_;
};

/// Returns the triangles and polygons of a surface. `parts` says which triangles are of a polygon.
FacesByCorners facesOf(const Surface& surface, const PolygonParts& parts);

/**
 * Returns the quadrilaterals among the faces of the numbers `single`: polygons of two triangles,
 * and pairs of triangles that make a nearly flat one. Only those at crowded edges are sought, which
 * more than two of these faces use, or two of them that are folded: where no face is there twice,
 * there are few. A triangle may be in several pairs. Takes O(n log n) time.
 */
FacesByCorners quadsOf(
  const Surface& surface, const FacesByCorners& faces, const std::vector<std::size_t>& single);

} // namespace winding
