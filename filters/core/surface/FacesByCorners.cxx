// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/FacesByCorners.h"

#include "base/DisjointSets.h"

#include <limits>
#include <tuple>
#include <utility>

namespace winding
{

namespace
{

/// Finds flat polygons that end at crowded edges.
class Polygons
{
public:
  Polygons(const Surface& surface, const FacesByCorners& faces, const FaceGroups& groups)
    : surface_(surface)
    , faces_(faces)
    , members_(groups.members)
    , starts_(groups.starts)
    , isCrowded_(surface.vertices.size(), 0)
  {
    groups.forEach(
      [this](const std::size_t* first, const std::size_t* last)
      {
        forward_.push_back(
          std::count_if(first, last, [this](std::size_t face) { return faces_.isForward(face); }));
        normals_.push_back(this->normalOf(*first));
      });
    this->findSides();
    SensedSets sets(this->kinds());
    const std::vector<Side> rims = this->unite(sets);
    if (std::find(isCrowded_.begin(), isCrowded_.end(), 1) != isCrowded_.end())
    {
      this->addPolygons(sets, rims);
    }
  }

  CutPolygons take() { return std::move(polygons_); }

private:
  /// A side of the faces with the same corners, which are a kind of their own.
  struct Side
  {
    std::int32_t low, high;
    std::int32_t kind;
    bool isForward; ///< whether its faces run from `low` to `high` as they are in FacesByCorners
  };

  /// The faces of a kind that run as its corners do in FacesByCorners, and those that do not.
  struct Copies
  {
    std::vector<std::size_t> forward, backward;
  };

  std::size_t kinds() const { return starts_.size() - 1; }
  std::size_t firstOf(std::int32_t kind) const { return members_[starts_[kind]]; }

  Copies copiesOf(std::int32_t kind) const
  {
    Copies copies;
    for (std::size_t i = starts_[kind]; i < starts_[kind + 1]; ++i)
    {
      (faces_.isForward(members_[i]) ? copies.forward : copies.backward).push_back(members_[i]);
    }
    return copies;
  }

  void findSides()
  {
    sides_.reserve(3 * this->kinds());
    for (std::size_t kind = 0; kind < this->kinds(); ++kind)
    {
      const Numbers corners = faces_.corners(members_[starts_[kind]]);
      for (std::size_t i = 0; i < corners.size(); ++i)
      {
        const std::int32_t from = corners[i], to = corners[(i + 1) % corners.size()];
        sides_.push_back(
          {std::min(from, to), std::max(from, to), static_cast<std::int32_t>(kind), from < to});
      }
    }
    std::sort(sides_.begin(), sides_.end(),
      [](const Side& a, const Side& b)
      { return std::tie(a.low, a.high, a.kind) < std::tie(b.low, b.high, b.kind); });
  }

  /// Unites the kinds that go on at edges with two of them, and returns all other sides.
  std::vector<Side> unite(SensedSets& sets)
  {
    std::vector<Side> rims;
    for (std::size_t first = 0, last; first < sides_.size(); first = last)
    {
      const Side& side = sides_[first];
      for (last = first;
           last < sides_.size() && sides_[last].low == side.low && sides_[last].high == side.high;
           ++last)
      {
      }
      const bool isPair = last - first == 2 && side.kind != sides_[first + 1].kind;
      const bool isFolded = isPair && this->areFolded(side, sides_[first + 1]);
      if (last - first > 2 || isFolded)
      {
        isCrowded_[side.low] = isCrowded_[side.high] = 1;
      }
      const bool areOpposite = isPair && side.isForward == sides_[first + 1].isForward;
      if (!isPair || isFolded || !this->areAsMany(side.kind, sides_[first + 1].kind, areOpposite) ||
          !sets.unite(side.kind, sides_[first + 1].kind, areOpposite))
      {
        rims.insert(rims.end(), sides_.begin() + static_cast<std::ptrdiff_t>(first),
          sides_.begin() + static_cast<std::ptrdiff_t>(last));
      }
    }
    return rims;
  }

  /// Returns twice the vector area of a face, as its corners run in FacesByCorners.
  Eigen::Vector3d normalOf(std::size_t face) const
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const std::int32_t triangle : faces_.triangles(face))
    {
      const Triangle& t = surface_.triangles[triangle];
      const Eigen::Vector3d& a = surface_.vertices[t[0]];
      sum += (surface_.vertices[t[1]] - a).cross(surface_.vertices[t[2]] - a);
    }
    return faces_.isForward(face) ? sum : Eigen::Vector3d(-sum);
  }

  /// Returns whether two kinds at an edge may be the two sides of the rim of a sheet.
  bool areFolded(const Side& a, const Side& b) const
  {
    const double product = normals_[a.kind].dot(normals_[b.kind]);
    return a.isForward == b.isForward ? product > 0 : product < 0;
  }

  /// Returns whether as many faces of `a` run either way as of `b`, turned round if `areOpposite`.
  bool areAsMany(std::int32_t a, std::int32_t b, bool areOpposite) const
  {
    const auto count = [this](std::int32_t kind)
    {
      return static_cast<std::ptrdiff_t>(starts_[kind + 1] - starts_[kind]);
    };
    return count(a) == count(b) &&
           forward_[a] == (areOpposite ? count(b) - forward_[b] : forward_[b]);
  }

  void addPolygons(SensedSets& sets, const std::vector<Side>& rims)
  {
    std::vector<Directed> ends; // of all rims, by polygon
    std::vector<char> isEnded(this->kinds(), 0);
    for (const Side& side : rims)
    {
      isEnded[sets.find(side.kind).representative] = 1;
    }
    for (const Side& side : rims)
    {
      const SensedSets::Place place = sets.find(side.kind);
      const bool runsUp = side.isForward != place.isOpposite;
      ends.push_back(
        {place.representative, runsUp ? side.low : side.high, runsUp ? side.high : side.low});
      isEnded[place.representative] &= isCrowded_[side.low] & isCrowded_[side.high];
    }
    std::sort(ends.begin(), ends.end());
    std::vector<std::pair<std::int32_t, std::int32_t>> kinds; // by polygon
    for (std::size_t kind = 0; kind < this->kinds(); ++kind)
    {
      const std::int32_t own = static_cast<std::int32_t>(kind);
      const std::int32_t polygon = sets.find(own).representative;
      if (isEnded[polygon])
      {
        kinds.emplace_back(polygon, own);
      }
    }
    std::sort(kinds.begin(), kinds.end());
    for (std::size_t first = 0, last; first < kinds.size(); first = last)
    {
      const std::int32_t polygon = kinds[first].first;
      std::vector<std::int32_t> own;
      for (last = first; last < kinds.size() && kinds[last].first == polygon; ++last)
      {
        own.push_back(kinds[last].second);
      }
      const auto [begin, end] = std::equal_range(ends.begin(), ends.end(), Directed{polygon, 0, 0},
        [](const Directed& a, const Directed& b) { return a.polygon < b.polygon; });
      this->addPolygon(own, std::vector<Directed>(begin, end), sets);
    }
  }

  /// An edge of the rim of a polygon.
  struct Directed
  {
    std::int32_t polygon, from, to;

    bool operator<(const Directed& other) const
    {
      return std::tie(polygon, from, to) < std::tie(other.polygon, other.from, other.to);
    }
  };

  /// Adds all copies of a polygon of some kinds, if these are flat and have no corners within it.
  void addPolygon(
    const std::vector<std::int32_t>& kinds, const std::vector<Directed>& rim, SensedSets& sets)
  {
    std::size_t pieces = 0;
    for (const std::int32_t kind : kinds)
    {
      pieces += faces_.cornerCount(this->firstOf(kind)) - 2;
    }
    if (rim.size() < 4 || rim.size() != pieces + 2)
    {
      return;
    }
    const std::vector<std::int32_t> corners = loopOf(rim);
    if (corners.size() != rim.size() || !this->isFlat(kinds, corners, sets))
    {
      return;
    }
    struct Copy
    {
      std::vector<std::int32_t> triangles;
      bool isForward;
    };
    std::vector<Copy> all;
    for (const bool isForward : {true, false})
    {
      const std::size_t first = all.size();
      for (const std::int32_t kind : kinds)
      {
        const Copies copies = this->copiesOf(kind);
        const std::vector<std::size_t>& faces =
          sets.find(kind).isOpposite == isForward ? copies.backward : copies.forward;
        all.resize(first + faces.size(), {{}, isForward});
        for (std::size_t i = 0; i < faces.size(); ++i)
        {
          const Numbers own = faces_.triangles(faces[i]);
          std::vector<std::int32_t>& triangles = all[first + i].triangles;
          triangles.insert(triangles.end(), own.begin(), own.end());
        }
      }
    }
    for (Copy& copy : all)
    {
      std::sort(copy.triangles.begin(), copy.triangles.end());
      std::vector<std::int32_t> around = corners;
      if (!copy.isForward)
      {
        std::reverse(around.begin(), around.end());
      }
      polygons_.faces.add(around, copy.triangles);
      polygons_.cuts.push_back(kinds.front());
    }
  }

  /// Returns the corners along a rim, or fewer unless it is one loop.
  static std::vector<std::int32_t> loopOf(const std::vector<Directed>& rim)
  {
    std::vector<std::int32_t> corners;
    std::int32_t corner = rim.front().from;
    do
    {
      corners.push_back(corner);
      const auto [next, end] = std::equal_range(rim.begin(), rim.end(), Directed{0, corner, 0},
        [](const Directed& one, const Directed& other) { return one.from < other.from; });
      if (end - next != 1)
      {
        return {};
      }
      corner = next->to;
    } while (corner != rim.front().from && corners.size() <= rim.size());
    return corners;
  }

  /// Returns whether all kinds look the same way, and the corners are nearly in a plane.
  bool isFlat(const std::vector<std::int32_t>& kinds, const std::vector<std::int32_t>& corners,
    SensedSets& sets) const
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    std::vector<Eigen::Vector3d> normals;
    for (const std::int32_t kind : kinds)
    {
      const Eigen::Vector3d& normal = normals_[kind];
      normals.push_back(sets.find(kind).isOpposite ? Eigen::Vector3d(-normal) : normal);
      sum += normals.back();
    }
    double least = 0, most = 0, shortest = std::numeric_limits<double>::infinity();
    for (const std::int32_t corner : corners)
    {
      const double height = sum.dot(surface_.vertices[corner] - surface_.vertices[corners.front()]);
      least = std::min(least, height);
      most = std::max(most, height);
    }
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const std::int32_t next = corners[(i + 2) % corners.size()];
      shortest =
        std::min(shortest, (surface_.vertices[next] - surface_.vertices[corners[i]]).norm());
    }
    // The distance between the diagonals of a quadrilateral, as a share of the shorter one, is 0
    // for flat ones and √½ for a regular tetrahedron.
    constexpr double mostOfDiagonal = 1e-3;
    return sum != Eigen::Vector3d::Zero() &&
           most - least <= mostOfDiagonal * shortest * sum.norm() &&
           std::all_of(normals.begin(), normals.end(),
             [&sum](const Eigen::Vector3d& normal) { return normal.dot(sum) >= 0; });
  }

  const Surface& surface_;
  const FacesByCorners& faces_;
  const std::vector<std::size_t>& members_; ///< faces, kind by kind
  const std::vector<std::size_t>& starts_;
  std::vector<std::ptrdiff_t> forward_;  ///< by kind: number of faces that run forward
  std::vector<Eigen::Vector3d> normals_; ///< by kind: twice the vector area
  std::vector<Side> sides_;
  std::vector<char> isCrowded_; ///< by vertex
  CutPolygons polygons_;
};

} // namespace

FacesByCorners facesOf(const Surface& surface, const PolygonParts& parts)
{
  const TriangleList& triangles = surface.triangles;
  FacesByCorners faces;
  std::vector<std::int32_t> corners, numbers;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    if (i < parts.size() && parts[i] && i > 0)
    {
      // A fan goes on from the last corner, unless a triangle between them bounds nothing.
      if (corners.back() != triangles[i][1])
      {
        corners.push_back(triangles[i][1]);
      }
      corners.push_back(triangles[i][2]);
    }
    else
    {
      corners.assign(triangles[i].begin(), triangles[i].end());
      numbers.clear();
    }
    numbers.push_back(static_cast<std::int32_t>(i));
    if (i + 1 >= triangles.size() || i + 1 >= parts.size() || !parts[i + 1])
    {
      faces.add(corners, numbers);
    }
  }
  return faces;
}

CutPolygons polygonsOf(
  const Surface& surface, const FacesByCorners& faces, const FaceGroups& groups)
{
  return Polygons(surface, faces, groups).take();
}

} // namespace winding
