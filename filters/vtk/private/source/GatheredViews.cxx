// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/GatheredViews.h"

#include "base/Refusal.h"
#include "private/source/ContentHash.h"

#include <algorithm>
#include <limits>

namespace winding
{

namespace
{

void append(std::vector<double>& numbers, const VectorsView& vectors)
{
  for (std::size_t i = 0; i < vectors.size(); ++i)
  {
    const Eigen::Vector3d vector = vectors[i];
    numbers.insert(numbers.end(), vector.data(), vector.data() + 3);
  }
}

template <class View> void add(const View& view, ContentHash& hash)
{
  hash.addValue(view.size());
  for (std::size_t i = 0; i < view.size(); ++i)
  {
    hash.addValue(view[i]);
  }
}

/// The vectors of a rank.
VectorsView vectorsOf(const OfRanks<double>& numbers, int rank)
{
  return {numbers.begin(rank), numbers.count(rank) / 3};
}

} // namespace

Ranks::Number hashOf(const std::vector<TrianglesView>& part)
{
  ContentHash hash;
  for (const TrianglesView& view : part)
  {
    add(view.points, hash);
    hash.addValue(view.triangles.size());
    for (std::size_t i = 0; i < view.triangles.size(); ++i)
    {
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        hash.addValue(static_cast<std::int64_t>(view.triangles(i, corner)));
      }
    }
  }
  return hash.value();
}

Ranks::Number hashOf(const std::vector<OrientedPointsView>& part)
{
  ContentHash hash;
  for (const OrientedPointsView& view : part)
  {
    add(view.positions, hash);
    add(view.normals, hash);
    add(view.areas, hash);
  }
  return hash.value();
}

bool GatheredViews::gather(Ranks& ranks, const std::vector<TrianglesView>& own, bool onlyOnFirst)
{
  std::vector<double> positions;
  std::vector<int> ids, continued;
  ranks.agree(
    [&]
    {
      std::size_t points = 0;
      for (const TrianglesView& view : own)
      {
        points += view.points.size();
      }
      if (points > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      {
        throw Refusal("use more ranks: a rank has more than 2147483647 points");
      }
      positions.reserve(3 * points);
      for (const TrianglesView& view : own)
      {
        const auto first = static_cast<std::int64_t>(positions.size() / 3);
        const auto count = static_cast<std::int64_t>(view.points.size());
        append(positions, view.points);
        for (std::size_t i = 0; i < view.triangles.size(); ++i)
        {
          for (std::size_t corner = 0; corner < 3; ++corner)
          {
            // An id of no point must not become the id of another part's.
            const std::int64_t id = view.triangles(i, corner);
            ids.push_back(id >= 0 && id < count ? static_cast<int>(first + id) : -1);
          }
          continued.push_back(view.isContinued && view.isContinued[i]);
        }
      }
    });
  positions_ = ranks.gather(positions, onlyOnFirst);
  ids_ = ranks.gather(ids, onlyOnFirst);
  // Triangles alone need not say that each is a polygon of its own.
  const bool areTriangles = std::find(continued.begin(), continued.end(), 1) == continued.end();
  continued_ = ranks.gather(areTriangles ? std::vector<int>() : continued, onlyOnFirst);
  if (onlyOnFirst && ranks.rank() > 0)
  {
    return false;
  }
  triangles_.clear();
  isContinued_.clear();
  isContinued_.reserve(static_cast<std::size_t>(ranks.count()));
  for (int rank = 0; rank < ranks.count(); ++rank)
  {
    const int* ofRank = continued_.begin(rank);
    isContinued_.emplace_back(ofRank, ofRank + continued_.count(rank));
    triangles_.push_back(
      {vectorsOf(positions_, rank), TriangleIdsView(ids_.begin(rank), ids_.count(rank) / 3),
        isContinued_.back().empty() ? nullptr : isContinued_.back().data()});
  }
  return true;
}

bool GatheredViews::gather(
  Ranks& ranks, const std::vector<OrientedPointsView>& own, bool onlyOnFirst)
{
  enum Lack : unsigned
  {
    normals = 1,
    areas = 2
  };
  std::vector<double> positions, ownNormals, ownAreas;
  unsigned lacks = 0;
  const std::vector<Ranks::Number> ofRanks = ranks.allGather(
    [&]
    {
      for (const OrientedPointsView& view : own)
      {
        append(positions, view.positions);
        append(ownNormals, view.normals);
        for (std::size_t i = 0; i < view.areas.size(); ++i)
        {
          ownAreas.push_back(view.areas[i]);
        }
      }
      lacks = (ownNormals.size() < positions.size() ? +normals : 0u) |
              (3 * ownAreas.size() < positions.size() ? +areas : 0u);
      return lacks;
    });
  for (const Ranks::Number ofRank : ofRanks)
  {
    lacks |= static_cast<unsigned>(ofRank);
  }
  positions_ = ranks.gather(positions, onlyOnFirst);
  ownNormals.resize(lacks & normals ? 0 : ownNormals.size());
  ownAreas.resize(lacks & areas ? 0 : ownAreas.size());
  normals_ = ranks.gather(ownNormals, onlyOnFirst);
  areas_ = ranks.gather(ownAreas, onlyOnFirst);
  if (onlyOnFirst && ranks.rank() > 0)
  {
    return false;
  }
  points_.clear();
  for (int rank = 0; rank < ranks.count(); ++rank)
  {
    OrientedPointsView view;
    view.positions = vectorsOf(positions_, rank);
    if (normals_.count(rank) > 0)
    {
      view.normals = vectorsOf(normals_, rank);
    }
    if (areas_.count(rank) > 0)
    {
      view.areas = ScalarsView(areas_.begin(rank), areas_.count(rank));
    }
    points_.push_back(view);
  }
  return true;
}

} // namespace winding
