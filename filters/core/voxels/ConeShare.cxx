// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/ConeShare.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace winding
{

namespace
{

/// Polygons of less than this part of the face are left out, which rounding leaves no sense.
constexpr double leastArea = 1e-14;

/// Overlaps of less than this part of a polygon are none: neighbors overlap by rounding.
constexpr double leastOverlap = 1e-9;

/// Corners of a polygon that are nearer than this are one: a side of rounding has no direction.
constexpr double leastSide = 1e-9;

/// Inverse depths that differ by less than this part of them, and their roundings, are equal:
/// triangles on each other.
constexpr double leastDifference = 1e-12;

/// Returns the work that a cone may take, in comparisons of boxes. Meshes of 86 000 triangles in a
/// cell take 600 for each polygon, the more the finer they are, and random solids 900 at most.
double mostWork(std::size_t polygons, double portion)
{
  constexpr double least = 3e6, perPolygon = 1024, perFineness = 32;
  const auto count = static_cast<double>(polygons);
  return portion * least + count * (perPolygon + perFineness * std::sqrt(count));
}

double cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double doubleAreaOf(const Eigen::Vector3d* corners, std::size_t count)
{
  double area = 0;
  for (std::size_t i = 2; i < count; ++i)
  {
    area += cross(corners[0], corners[i - 1], corners[i]);
  }
  return area;
}

Eigen::Vector3d liftedPoint(const Eigen::Vector3d& corner)
{
  return {corner[0], corner[1], 1};
}

/// Returns the line through two corners, as a linear function of (q₁, q₂, 1) that is positive to
/// their left.
Eigen::Vector3d lineThrough(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const double x = a[1] - b[1], y = b[0] - a[0];
  return {x, y, -(x * a[0] + y * a[1])};
}

/// Returns `normal` · (q₁, q₂, 1 − q₁ − q₂) as a linear function of (q₁, q₂, 1).
Eigen::Vector3d alongDirections(const Eigen::Vector3d& normal)
{
  return {normal[0] - normal[2], normal[1] - normal[2], normal[2]};
}

/// Keeps the part of a convex polygon where `distance` of a corner is not negative. The point of a
/// side where it is 0 is found from the corner that stays, whichever way the side is passed.
template <class Point, class Distance, class Put>
void keepPart(const Point* from, std::size_t count, const Distance& distance, const Put& put)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const Point &a = from[i], &b = from[i + 1 < count ? i + 1 : 0];
    const double ofA = distance(a), ofB = distance(b);
    if (ofA >= 0)
    {
      put(a);
      if (ofB < 0)
      {
        put(a + ofA / (ofA - ofB) * (b - a));
      }
    }
    else if (ofB >= 0)
    {
      put(b + ofB / (ofB - ofA) * (a - b));
    }
  }
}

/// The corners of a convex polygon; a triangle that four planes cut has seven at most.
struct Corners
{
  std::array<Eigen::Vector3d, 8> at;
  std::size_t count = 0;
};

/// Returns the part of a triangle, by its corners' weights, within the four sides of the cone.
Corners clipped(const std::array<Eigen::Vector3d, 3>& whole)
{
  const auto isBeyond = [&whole](const auto& distance)
  {
    return distance(whole[0]) < 0 && distance(whole[1]) < 0 && distance(whole[2]) < 0;
  };
  const auto first = [](const Eigen::Vector3d& at)
  {
    return at[0];
  };
  const auto second = [](const Eigen::Vector3d& at)
  {
    return at[1];
  };
  const auto third = [](const Eigen::Vector3d& at)
  {
    return at[2];
  };
  const auto face = [](const Eigen::Vector3d& at)
  {
    return 1 - at.sum();
  };
  Corners kept, next;
  if (isBeyond(first) || isBeyond(second) || isBeyond(third) || isBeyond(face))
  {
    return kept;
  }
  kept.count = 3;
  std::copy(whole.begin(), whole.end(), kept.at.begin());
  const auto cut = [&](const auto& distance)
  {
    next.count = 0;
    keepPart(kept.at.data(), kept.count, distance,
      [&next](const Eigen::Vector3d& at) { next.at[next.count++] = at; });
    kept = next;
  };
  cut(first);
  cut(second);
  cut(third);
  cut(face);
  return kept;
}

/// Returns corners as seen from the apex, those that only rounding leaves apart as one. Returns
/// none where a corner is the apex.
Corners projected(const Corners& clipped)
{
  const auto isOne = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b)
  {
    return (a - b).head<2>().cwiseAbs().maxCoeff() < leastSide;
  };
  Corners result;
  for (std::size_t i = 0; i < clipped.count; ++i)
  {
    const double sum = clipped.at[i].sum();
    if (!(sum > 0))
    {
      return {};
    }
    const Eigen::Vector3d corner(clipped.at[i][0] / sum, clipped.at[i][1] / sum, 1 / sum);
    if (result.count == 0 || !isOne(corner, result.at[result.count - 1]))
    {
      result.at[result.count++] = corner;
    }
  }
  if (result.count > 1 && isOne(result.at[0], result.at[result.count - 1]))
  {
    --result.count;
  }
  return result;
}

/// Whether a piece of a polygon reaches into a box.
template <class Piece>
bool reaches(const Piece& piece, const Eigen::Array2d& low, const Eigen::Array2d& high)
{
  Eigen::Array2d least = piece[0].template head<2>().array(), most = least;
  for (const auto& corner : piece)
  {
    least = least.min(corner.template head<2>().array());
    most = most.max(corner.template head<2>().array());
  }
  return (least < high).all() && (most > low).all();
}

/// Whether all corners of one polygon lie to the right of a side of the other.
template <class Polygon> bool isSeparated(const Polygon& sides, const Polygon& other)
{
  for (int i = 0; i < sides.count; ++i)
  {
    const Eigen::Vector3d line = lineThrough(
      sides.corners[std::size_t(i)], sides.corners[std::size_t(i + 1 < sides.count ? i + 1 : 0)]);
    const auto isOutside = [&line](const Eigen::Vector3d& corner)
    {
      return line.dot(liftedPoint(corner)) <= 0;
    };
    if (std::all_of(other.corners.begin(), other.corners.begin() + other.count, isOutside))
    {
      return true;
    }
  }
  return false;
}

} // namespace

double ConeShare::of(const Eigen::Matrix3d& corners, const std::vector<ConeTriangle>& triangles,
  double winding, std::size_t cones)
{
  constexpr double fewCones = 16; // of a cell that is not divided
  const double portion = std::min(1.0, fewCones / static_cast<double>(cones));
  polygons_.clear();
  lostEdges_.clear();
  const Eigen::Matrix3d weights = corners.inverse();
  const bool isInverted = corners.determinant() < 0;
  for (const ConeTriangle& triangle : triangles)
  {
    this->add(triangle, weights, isInverted);
  }
  std::sort(lostEdges_.begin(), lostEdges_.end());
  left_ = mostWork(polygons_.size(), portion);
  this->findPairs();
  double share = this->isInsideAt(winding) ? 1 : 0;
  for (std::size_t i = 0; left_ > 0 && i < polygons_.size(); ++i)
  {
    share += this->change(i, winding);
  }
  return left_ > 0 ? share : this->meanOverRays(winding, portion);
}

/// Cuts a triangle off at the four sides of the cone.
void ConeShare::add(const ConeTriangle& triangle, const Eigen::Matrix3d& weights, bool isInverted)
{
  Polygon polygon;
  for (std::size_t i = 0; i < 3; ++i)
  {
    polygon.whole[i] = weights * triangle.corners[i];
  }
  const std::array<Eigen::Vector3d, 3>& whole = polygon.whole;
  const Corners kept = clipped(whole);
  const Corners seen = kept.count < 3 ? Corners() : projected(kept);
  const std::size_t count = seen.count;
  if (count == 0)
  {
    return; // nothing within the cone, or only the apex
  }
  polygon.corners = seen.at;
  const double area = doubleAreaOf(polygon.corners.data(), count);
  const Eigen::Vector3d normal = (whole[1] - whole[0]).cross(whole[2] - whole[0]);
  const double height = normal.dot(whole[0]);
  if (!(std::abs(area) > leastArea) || height == 0)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      lostEdges_.push_back(std::minmax(triangle.ids[i], triangle.ids[(i + 1) % 3]));
    }
    return;
  }
  polygon.count = static_cast<int>(count);
  polygon.isTurned = area < 0;
  if (polygon.isTurned)
  {
    std::reverse(polygon.corners.begin(), polygon.corners.begin() + polygon.count);
  }
  polygon.doubleArea = std::abs(area);
  polygon.step = polygon.isTurned == isInverted ? -triangle.multiplicity : triangle.multiplicity;
  polygon.inverseDepth = alongDirections(normal) / height;
  // Seen at a small angle, or much larger than the cone, a triangle has a depth with few digits.
  // Random cases pass with 1 to 4 times this; with 8 two layers count as one, and a third may lie
  // between them.
  const double reach = std::max({whole[0].norm(), whole[1].norm(), whole[2].norm()}) *
                       (whole[1] - whole[0]).norm() * (whole[2] - whole[0]).norm();
  polygon.rounding = 4 * std::numeric_limits<double>::epsilon() * reach / std::abs(height);
  polygon.ids = triangle.ids;
  polygon.low = polygon.high = polygon.corners[0].head<2>().array();
  for (std::size_t i = 1; i < count; ++i)
  {
    polygon.low = polygon.low.min(polygon.corners[i].head<2>().array());
    polygon.high = polygon.high.max(polygon.corners[i].head<2>().array());
  }
  polygons_.push_back(polygon);
}

/// Finds the polygons that overlap each other, and where they are to be cut.
void ConeShare::findPairs()
{
  const std::size_t count = polygons_.size();
  if (others_.size() < count)
  {
    others_.resize(count);
    lines_.resize(count);
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    others_[i].clear();
    lines_[i].clear();
  }
  order_.resize(count);
  std::iota(order_.begin(), order_.end(), 0U);
  std::stable_sort(order_.begin(), order_.end(),
    [this](std::uint32_t a, std::uint32_t b) { return polygons_[a].low[0] < polygons_[b].low[0]; });
  for (std::size_t i = 0; i < count; ++i)
  {
    const Polygon& a = polygons_[order_[i]];
    for (std::size_t j = i + 1; j < count && polygons_[order_[j]].low[0] < a.high[0]; ++j)
    {
      if (!this->spend(1))
      {
        return;
      }
      const Polygon& b = polygons_[order_[j]];
      if (b.low[1] < a.high[1] && a.low[1] < b.high[1] && !isSeparated(a, b) && !isSeparated(b, a))
      {
        const auto [first, second] = std::minmax(order_[i], order_[j]);
        this->cutPair(first, second);
      }
    }
  }
}

void ConeShare::cutPair(std::size_t first, std::size_t second)
{
  constexpr double work = 64;
  this->spend(work);
  const Polygon &a = polygons_[first], &b = polygons_[second];
  std::array<Corner, 20> common, next;
  std::size_t count = static_cast<std::size_t>(a.count);
  std::copy(a.corners.begin(), a.corners.begin() + a.count, common.begin());
  for (int i = 0; i < b.count && count > 2; ++i)
  {
    const Eigen::Vector3d line =
      lineThrough(b.corners[std::size_t(i)], b.corners[std::size_t(i + 1 < b.count ? i + 1 : 0)]);
    std::size_t left = 0;
    keepPart(
      common.data(), count, [&line](const Corner& at) { return line.dot(liftedPoint(at)); },
      [&](const Corner& at) { next[left++] = at; });
    common = next;
    count = left;
  }
  const double area = count > 2 ? doubleAreaOf(common.data(), count) : 0;
  if (!(area > leastOverlap * std::min(a.doubleArea, b.doubleArea)))
  {
    return;
  }
  const Eigen::Vector3d difference = a.inverseDepth - b.inverseDepth;
  bool isFirstBefore = false, isSecondBefore = false, isMet = false;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double limit = (leastDifference + a.rounding + b.rounding) * common[i][2];
    const double value = difference.dot(liftedPoint(common[i]));
    isFirstBefore = isFirstBefore || value > limit;
    isSecondBefore = isSecondBefore || value < -limit;
    isMet = isMet || std::abs(value) <= limit;
  }
  const bool liesOn = !isFirstBefore && !isSecondBefore;
  others_[first].push_back({static_cast<std::uint32_t>(second), liesOn});
  others_[second].push_back({static_cast<std::uint32_t>(first), liesOn});
  // Triangles that only meet count, too: one on either side of a third, they pass through it.
  if ((isFirstBefore && isSecondBefore) || (isMet && (isFirstBefore || isSecondBefore)))
  {
    lines_[first].push_back({difference, static_cast<std::uint32_t>(second)});
    lines_[second].push_back({difference, static_cast<std::uint32_t>(first)});
  }
  else if (isMet)
  {
    const auto cutAtSides = [this](std::size_t of, std::size_t number)
    {
      const Polygon& sides = polygons_[number];
      for (int i = 0; i < sides.count; ++i)
      {
        lines_[of].push_back({lineThrough(sides.corners[std::size_t(i)],
                                sides.corners[std::size_t(i + 1 < sides.count ? i + 1 : 0)]),
          static_cast<std::uint32_t>(number)});
      }
    };
    cutAtSides(first, second);
    cutAtSides(second, first);
  }
  this->cutAtLostEdges(first, second);
  this->cutAtLostEdges(second, first);
}

/// Cuts polygon `number` at the edges of `other` where a triangle was left out: it may pass through
/// that one.
void ConeShare::cutAtLostEdges(std::size_t number, std::size_t otherNumber)
{
  const Polygon& other = polygons_[otherNumber];
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3;
    const Edge edge = std::minmax(other.ids[i], other.ids[j]);
    if (std::binary_search(lostEdges_.begin(), lostEdges_.end(), edge))
    {
      lines_[number].push_back({alongDirections(other.whole[i].cross(other.whole[j])),
        static_cast<std::uint32_t>(otherNumber)});
    }
  }
}

/// Returns by how much a polygon changes the share: the sum over its pieces.
double ConeShare::change(std::size_t number, double winding)
{
  const Polygon& polygon = polygons_[number];
  const auto count = static_cast<std::size_t>(polygon.count);
  if (others_[number].empty())
  {
    return this->shadowOf(polygon.corners.data(), count, winding, polygon.step);
  }
  pieces_.assign(1, Piece(polygon.corners.begin(), polygon.corners.begin() + polygon.count));
  constexpr double workOfCut = 8;
  for (const Line& line : lines_[number])
  {
    if (!this->spend(workOfCut * static_cast<double>(pieces_.size())))
    {
      return 0;
    }
    nextPieces_.clear();
    for (Piece& piece : pieces_)
    {
      if (!reaches(piece, polygons_[line.other].low, polygons_[line.other].high))
      {
        nextPieces_.push_back(std::move(piece));
        continue;
      }
      for (const double side : {1.0, -1.0})
      {
        Piece part;
        keepPart(
          piece.data(), piece.size(),
          [&](const Corner& at) { return side * line.along.dot(liftedPoint(at)); },
          [&](const Corner& at) { part.push_back(at); });
        if (part.size() > 2 && doubleAreaOf(part.data(), part.size()) > leastArea)
        {
          nextPieces_.push_back(std::move(part));
        }
      }
    }
    pieces_.swap(nextPieces_);
  }
  double sum = 0;
  if (!this->spend(
        static_cast<double>(pieces_.size()) * static_cast<double>(others_[number].size())))
  {
    return 0;
  }
  for (const Piece& piece : pieces_)
  {
    // Weights without a pattern keep the point off sides of other triangles, where meshes are
    // regular.
    constexpr double golden = 0.6180339887498949;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    double weights = 0;
    for (std::size_t i = 0; i < piece.size(); ++i)
    {
      const double weight = 1 + std::fmod(golden * static_cast<double>(i + 1), 1.0);
      at += weight * piece[i];
      weights += weight;
    }
    at /= weights;
    sum +=
      this->shadowOf(piece.data(), piece.size(), this->before(number, at, winding), polygon.step);
  }
  return sum;
}

bool ConeShare::isInsideAt(double winding) const
{
  return isInside_(isParity_ ? std::abs(std::fmod(winding, 2.0)) : winding);
}

/// Returns the part of the cone beyond a piece, if what is inside changes there.
double ConeShare::shadowOf(const Corner* corners, std::size_t count, double before, int step) const
{
  const int change = (this->isInsideAt(before + step) ? 1 : 0) - (this->isInsideAt(before) ? 1 : 0);
  double volume = 0;
  for (std::size_t i = 2; change != 0 && i < count; ++i)
  {
    // The cone over a triangle is that over its projection, times the three depths.
    const Corner &a = corners[0], &b = corners[i - 1], &c = corners[i];
    volume += cross(a, b, c) * (1 - 1 / (a[2] * b[2] * c[2]));
  }
  return change * volume;
}

/// Returns whether a ray from the apex meets the triangle of a polygon. A side that two triangles
/// share has the same sign for both, so a ray near it meets one of them.
bool ConeShare::isMet(const Polygon& polygon, const Eigen::Vector3d& direction)
{
  bool isMet = true;
  for (std::size_t i = 0; isMet && i < 3; ++i)
  {
    const std::size_t j = i < 2 ? i + 1 : 0;
    const bool isForward = polygon.ids[i] < polygon.ids[j];
    const Eigen::Vector3d &a = polygon.whole[isForward ? i : j],
                          &b = polygon.whole[isForward ? j : i];
    const bool isLeft = (a.cross(b).dot(direction) >= 0) == isForward;
    isMet = isLeft != polygon.isTurned;
  }
  return isMet;
}

/// Returns the mean share of rays to points of the face that fill it evenly, the more the fewer
/// polygons there are.
double ConeShare::meanOverRays(double winding, double portion) const
{
  constexpr double tests = 4e6, fewest = 256, fewestOfPart = 16, most = 4096;
  const double count =
    std::clamp(std::floor(portion * tests / static_cast<double>(polygons_.size())),
      std::max(fewestOfPart, std::floor(portion * fewest)), most);
  std::vector<std::pair<double, int>> met; // inverse depths and steps
  double sum = 0;
  for (double n = 0; n < count; ++n)
  {
    // Multiples of powers of the plastic number (Roberts, The Unreasonable Effectiveness of
    // Quasirandom Sequences, 2018), folded into the triangle.
    constexpr double first = 0.7548776662466927, second = 0.5698402909980532;
    Eigen::Vector2d at(std::fmod(0.5 + first * n, 1.0), std::fmod(0.5 + second * n, 1.0));
    at = at.sum() > 1 ? Eigen::Vector2d(1 - at[0], 1 - at[1]) : at;
    const Eigen::Vector3d direction(at[0], at[1], 1 - at.sum()), lifted(at[0], at[1], 1);
    met.clear();
    for (const Polygon& polygon : polygons_)
    {
      if ((polygon.low <= at.array()).all() && (polygon.high >= at.array()).all() &&
          isMet(polygon, direction))
      {
        met.emplace_back(-polygon.inverseDepth.dot(lifted), polygon.step);
      }
    }
    std::sort(met.begin(), met.end());
    double here = winding, volume = 0; // w, and the share of the cone up to here
    for (const auto& [negative, step] : met)
    {
      if (-negative < 1)
      {
        break; // beyond the face
      }
      const double next = -1 / (negative * negative * negative);
      sum += this->isInsideAt(here) ? next - volume : 0;
      volume = next;
      here += step;
    }
    sum += this->isInsideAt(here) ? 1 - volume : 0;
  }
  return sum / count;
}

/// Returns w just before a point of a polygon.
double ConeShare::before(std::size_t number, const Eigen::Vector3d& at, double winding) const
{
  const Eigen::Vector3d direction(at[0], at[1], 1 - at[0] - at[1]);
  for (const Overlap& other : others_[number])
  {
    const Polygon& polygon = polygons_[other.polygon];
    if (isMet(polygon, direction))
    {
      const double difference =
        (polygon.inverseDepth - polygons_[number].inverseDepth).dot(liftedPoint(at));
      const bool isBefore = other.liesOn ? other.polygon < number : difference > 0;
      winding += isBefore ? polygon.step : 0;
    }
  }
  return winding;
}

} // namespace winding
