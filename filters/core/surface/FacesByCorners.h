// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "source/Surface.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace winding
{

/// Some numbers that follow each other.
struct Numbers
{
  const std::int32_t *first, *last;

  const std::int32_t* begin() const { return first; }
  const std::int32_t* end() const { return last; }
  std::size_t size() const { return static_cast<std::size_t>(last - first); }
  std::int32_t operator[](std::size_t i) const { return first[i]; }
};

/// The numbers of faces, group by group.
struct FaceGroups
{
  std::vector<std::size_t> members;
  std::vector<std::size_t> starts = {0}; ///< first member of each group; at last their number

  std::size_t size() const { return starts.size() - 1; }

  /// Calls visit(first, last) for the numbers of the faces of each group.
  template <class Visit> void forEach(const Visit& visit) const
  {
    for (std::size_t group = 0; group < this->size(); ++group)
    {
      visit(&members[starts[group]], members.data() + starts[group + 1]);
    }
  }
};

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
  std::size_t cornerCount(std::size_t face) const { return starts_[face + 1] - starts_[face]; }

  ///@{
  /// The corners and the triangles of a face, until one is added.
  Numbers corners(std::size_t face) const
  {
    return {corners_.data() + starts_[face], corners_.data() + starts_[face + 1]};
  }
  Numbers triangles(std::size_t face) const
  {
    return {triangles_.data() + trianglesEnds_[face], triangles_.data() + trianglesEnds_[face + 1]};
  }
  ///@}

  std::int32_t firstTriangle(std::size_t face) const { return this->triangles(face)[0]; }

  /// Groups the faces with the same corners, in the order of these and then of their numbers.
  FaceGroups groups() const
  {
    FaceGroups groups;
    std::vector<std::size_t>& order = groups.members;
    order.resize(this->size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
      [this](std::size_t a, std::size_t b) { return this->isLess(a, b); });
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      if (i + 1 == order.size() || this->isLess(order[i], order[i + 1]))
      {
        groups.starts.push_back(i + 1);
      }
    }
    return groups;
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

/// Polygons that are cut into faces.
struct CutPolygons
{
  FacesByCorners faces;
  std::vector<std::int32_t> cuts; ///< by polygon: a number for each way in which it is cut
};

/**
 * Returns the flat polygons that faces make together, each copy of one as a face. Faces with the
 * same corners, which `groups` has, stand for each other here. Polygons end at crowded edges, where
 * more than two faces meet, or two that are folded, and have all of their corners on their rim.
 * Polygons of one face are among them only with four corners or more, all at crowded edges: where
 * no face is there twice, there are few. Each triangle is in one polygon at most.
 * Takes O(n log n) time.
 */
CutPolygons polygonsOf(
  const Surface& surface, const FacesByCorners& faces, const FaceGroups& groups);

} // namespace winding
