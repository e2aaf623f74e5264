#include "surface/FacesByCorners.h"

#include <cmath>
#include <tuple>
#include <utility>

namespace winding
{

namespace
{

/// Finds quadrilaterals at crowded edges.
class Quads
{
public:
  Quads(const Surface& surface, const FacesByCorners& faces, const std::vector<std::size_t>& single)
    : surface_(surface)
    , isCrowded_(surface.vertices.size(), 0)
  {
    std::vector<Side> sides;
    for (const std::size_t face : single)
    {
      this->addSides(faces.corners(face), faces.triangles(face), sides);
    }
    std::sort(sides.begin(), sides.end(),
      [](const Side& a, const Side& b)
      { return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle); });
    const auto forEachEdge = [&sides](const auto& visit)
    {
      for (std::size_t first = 0, last; first < sides.size(); first = last)
      {
        for (last = first; last < sides.size() && sides[last].low == sides[first].low &&
                           sides[last].high == sides[first].high;
             ++last)
        {
        }
        visit(&sides[first], last - first);
      }
    };
    forEachEdge(
      [this](const Side* side, std::size_t count)
      {
        if (count > 2 || (count == 2 && this->areFolded(side[0], side[1])))
        {
          isCrowded_[side->low] = isCrowded_[side->high] = 1;
        }
      });
    for (const std::size_t face : single)
    {
      const std::vector<std::int32_t> corners = faces.corners(face);
      if (corners.size() == 4 && faces.triangles(face).size() == 2 && this->areCrowded(corners))
      {
        std::vector<std::int32_t> around = corners;
        if (!faces.isForward(face))
        {
          std::reverse(around.begin() + 1, around.end());
        }
        quads_.add(around, faces.triangles(face));
      }
    }
    forEachEdge(
      [this](const Side* side, std::size_t count)
      {
        if (count == 2)
        {
          this->addQuad(side[0], side[1]);
        }
      });
  }

  FacesByCorners take() { return std::move(quads_); }

private:
  /// A side of a triangle, or of a polygon.
  struct Side
  {
    std::int32_t low, high;
    std::int32_t triangle;
    std::int32_t opposite; ///< the third corner of a triangle; −1 for polygons
    bool isForward;        ///< whether it runs from `low` to `high`
  };

  void addSides(const std::vector<std::int32_t>& corners,
    const std::vector<std::int32_t>& triangles, std::vector<Side>& sides) const
  {
    const Triangle& own = surface_.triangles[triangles.front()];
    const bool isTriangle = corners.size() == 3;
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::int32_t from = isTriangle ? own[i] : corners[i];
      const std::int32_t to = isTriangle ? own[(i + 1) % 3] : corners[(i + 1) % count];
      sides.push_back({std::min(from, to), std::max(from, to), triangles.front(),
        isTriangle ? own[(i + 2) % 3] : -1, from < to});
    }
  }

  Eigen::Vector3d normalOf(std::int32_t triangle) const
  {
    const Triangle& t = surface_.triangles[triangle];
    const Eigen::Vector3d& a = surface_.vertices[t[0]];
    return (surface_.vertices[t[1]] - a).cross(surface_.vertices[t[2]] - a);
  }

  /// Returns whether two faces at an edge may be the two sides of the rim of a sheet.
  bool areFolded(const Side& a, const Side& b) const
  {
    return a.isForward != b.isForward &&
           this->normalOf(a.triangle).dot(this->normalOf(b.triangle)) < 0;
  }

  bool areCrowded(const std::vector<std::int32_t>& corners) const
  {
    return std::all_of(corners.begin(), corners.end(),
      [this](std::int32_t corner) { return isCrowded_[corner] != 0; });
  }

  /// Adds the quadrilateral of two triangles at an edge, if it is nearly flat.
  void addQuad(const Side& a, const Side& b)
  {
    const Side& forward = a.isForward ? a : b;
    const Side& backward = a.isForward ? b : a;
    if (a.isForward == b.isForward || a.opposite < 0 || b.opposite < 0)
    {
      return;
    }
    const std::vector<std::int32_t> corners = {
      forward.low, backward.opposite, forward.high, forward.opposite};
    if (!this->areCrowded(corners) ||
        !(this->normalOf(a.triangle).dot(this->normalOf(b.triangle)) > 0))
    {
      return;
    }
    // The distance between the diagonals, as a share of the shorter one, is 0 for flat ones and
    // √½ for a regular tetrahedron.
    constexpr double mostOfDiagonal = 0.1;
    const auto at = [&](std::size_t i) -> const Eigen::Vector3d&
    {
      return surface_.vertices[corners[i]];
    };
    const Eigen::Vector3d first = at(2) - at(0), second = at(3) - at(1);
    const Eigen::Vector3d across = first.cross(second);
    const double distance = std::abs((at(1) - at(0)).dot(across));
    if (distance <= mostOfDiagonal * std::min(first.norm(), second.norm()) * across.norm())
    {
      quads_.add(corners, {forward.triangle, backward.triangle});
    }
  }

  const Surface& surface_;
  std::vector<char> isCrowded_; ///< by vertex
  FacesByCorners quads_;
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

FacesByCorners quadsOf(
  const Surface& surface, const FacesByCorners& faces, const std::vector<std::size_t>& single)
{
  return Quads(surface, faces, single).take();
}

} // namespace winding
