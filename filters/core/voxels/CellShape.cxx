// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/CellShape.h"

#include "mesh/CellTypes.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace winding
{

namespace
{

/// The points of a shape that lie on an edge between two others, from its first end on.
std::vector<int> pointsOn(const CellShape& shape, int from, int to)
{
  constexpr double near = 1e-9; // of the edge's length
  const Eigen::Vector3d& a = shape.points[std::size_t(from)];
  const Eigen::Vector3d along = shape.points[std::size_t(to)] - a;
  const double squared = along.squaredNorm();
  std::vector<std::pair<double, int>> found;
  for (std::size_t n = 0; n < shape.points.size(); ++n)
  {
    const Eigen::Vector3d place = shape.points[n] - a;
    const double share = place.dot(along) / squared;
    const bool isFirst =
      std::find(shape.points.begin(), shape.points.end(), shape.points[n]) - shape.points.begin() ==
      static_cast<std::ptrdiff_t>(n);
    if (isFirst && share > near && share < 1 - near &&
        (place - share * along).squaredNorm() < near * near * squared)
    {
      found.emplace_back(share, static_cast<int>(n));
    }
  }
  std::sort(found.begin(), found.end());
  std::vector<int> ids;
  for (const auto& [share, id] : found)
  {
    ids.push_back(id);
  }
  return ids;
}

/// Whether edges of faces, between the ids of their corners, cancel. With `areCut` they are cut at
/// all points that lie on them: a face may have a corner where its neighbour has none.
template <class IdOf>
bool doEdgesCancel(const CellShape& shape, const IdOf& idOf, bool areCut = false)
{
  std::vector<std::pair<int, int>> forth, back;
  for (std::size_t face = 0; face < shape.faces(); ++face)
  {
    const int begin = shape.faceEnds[face], end = shape.faceEnds[face + 1];
    for (int at = begin; at < end; ++at)
    {
      int from = idOf(shape.faceCorners[std::size_t(at)]);
      const int last = idOf(shape.faceCorners[std::size_t(at + 1 < end ? at + 1 : begin)]);
      std::vector<int> stops;
      if (areCut && from != last)
      {
        stops = pointsOn(shape, from, last);
      }
      stops.push_back(last);
      for (const int to : stops)
      {
        if (from < to)
        {
          forth.emplace_back(from, to);
        }
        else if (to < from)
        {
          back.emplace_back(to, from);
        }
        from = to;
      }
    }
  }
  std::sort(forth.begin(), forth.end());
  std::sort(back.begin(), back.end());
  return forth == back;
}

} // namespace

void CellShape::clear()
{
  points.clear();
  faceCorners.clear();
  faceEnds.assign(1, 0);
  areLinear = false;
  isStraightened = false;
}

void CellShape::addFace(const int* corners, int count)
{
  faceCorners.insert(faceCorners.end(), corners, corners + count);
  faceEnds.push_back(static_cast<int>(faceCorners.size()));
  areLinear = false;
}

bool CellShape::isClosed() const
{
  if (areLinear || doEdgesCancel(*this, [](int corner) { return corner; }))
  {
    return true;
  }
  const auto placeOf = [this](int corner)
  {
    const auto found = std::find(points.begin(), points.end(), points[std::size_t(corner)]);
    return static_cast<int>(found - points.begin());
  };
  return doEdgesCancel(*this, placeOf) || doEdgesCancel(*this, placeOf, true);
}

bool CellShape::addFacesOf(int type)
{
  const int straight = straightTypeOf(type);
  const auto corners = static_cast<std::size_t>(fewestPointsOf(straight));
  isStraightened = straight != type;
  if (isStraightened && corners > 0 && corners < points.size())
  {
    points.resize(corners);
  }
  const FaceTable& table = facesOf(straight);
  if (table.empty() || points.size() < corners)
  {
    return false;
  }
  areLinear = this->faces() == 0;
  for (const int corner : table)
  {
    if (corner >= 0)
    {
      faceCorners.push_back(corner);
    }
    else
    {
      faceEnds.push_back(static_cast<int>(faceCorners.size()));
    }
  }
  return true;
}

} // namespace winding
