#include "source/MeshVertices.h"

#include "source/CoordinateOrder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace winding
{

namespace
{

using Ids = std::array<std::size_t, 3>;

/// A triangle's area vector, and its area; an area below 0 marks a triangle that is left out.
struct Share
{
  Eigen::Vector3d areaVector;
  double area = -1;
};

std::optional<Ids> validIds(const TrianglesView& view, std::size_t triangle, std::size_t points)
{
  Ids ids;
  for (std::size_t i = 0; i < 3; ++i)
  {
    ids[i] = static_cast<std::size_t>(view.triangles(triangle, i));
    if (ids[i] >= view.points.size() || ids[i] >= points)
    {
      return std::nullopt;
    }
  }
  return ids;
}

/// The length of a vector of any size. The bits of Eigen's stableNorm() depend on where in memory
/// the vector stands.
double lengthOf(const Eigen::Vector3d& vector)
{
  const double squared = vector.squaredNorm();
  if (squared > 1e-280 && squared < 1e280)
  {
    return std::sqrt(squared);
  }
  const double largest = vector.cwiseAbs().maxCoeff();
  return largest > 0 ? largest * (vector / largest).norm() : 0;
}

Share shareOf(const TrianglesView& view, const Ids& ids)
{
  Eigen::Vector3d corners[3] = {view.points[ids[0]], view.points[ids[1]], view.points[ids[2]]};
  turnToFirstOrder(corners);
  Share share;
  share.areaVector = 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  if (share.areaVector.allFinite())
  {
    const double area = lengthOf(share.areaVector);
    share.area = std::isfinite(area) ? area : -1;
  }
  return share;
}

/**
 * The sum of the shares of the triangles around a point, in integers: it is the same in any order.
 * The unit is a power of two, so small that the rounding of a share is 2⁻⁵⁶ of the largest share at
 * most, times the number of shares, and so large that no sum leaves the range.
 */
class PointSum
{
public:
  void announce(double area)
  {
    largest_ = std::max(largest_, area);
    ++count_;
  }

  void chooseUnit()
  {
    constexpr int bits = 62, smallest = -1000; // 2^1000 is a number, too
    int bitsOfCount = 0;
    while (count_ >> bitsOfCount != 0)
    {
      ++bitsOfCount;
    }
    const int exponent = largest_ > 0 ? std::ilogb(largest_) + 1 + bitsOfCount - bits : 0;
    unit_ = std::max(exponent, smallest);
    perUnit_ = std::ldexp(1.0, -unit_);
  }

  void add(const Share& share)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      sums_[axis] += this->inUnits(share.areaVector[static_cast<Eigen::Index>(axis)]);
    }
    sums_[3] += this->inUnits(share.area);
  }

  Eigen::Vector3d areaVector() const
  {
    return {this->valueOf(sums_[0]), this->valueOf(sums_[1]), this->valueOf(sums_[2])};
  }
  double area() const { return this->valueOf(sums_[3]); }

private:
  std::int64_t inUnits(double value) const { return static_cast<std::int64_t>(value * perUnit_); }
  double valueOf(std::int64_t sum) const { return std::ldexp(static_cast<double>(sum), unit_); }

  double largest_ = 0, perUnit_ = 0;
  std::uint32_t count_ = 0;
  int unit_ = 0; ///< exponent of the unit
  std::array<std::int64_t, 4> sums_ = {};
};

/// Calls visit(view, ids) for all triangles with valid ids.
template <class Visit>
void forEachTriangle(
  const std::vector<TrianglesView>& views, std::size_t points, const Visit& visit)
{
  for (const TrianglesView& view : views)
  {
    for (std::size_t t = 0; t < view.triangles.size(); ++t)
    {
      if (const std::optional<Ids> ids = validIds(view, t, points))
      {
        visit(view, *ids);
      }
    }
  }
}

} // namespace

MeshVertices meshVertices(const std::vector<TrianglesView>& views, std::size_t points)
{
  std::vector<PointSum> sums(points);
  std::vector<Share> shares;
  forEachTriangle(views, points,
    [&](const TrianglesView& view, const Ids& ids)
    {
      const Share& share = shares.emplace_back(shareOf(view, ids));
      for (std::size_t i = 0; share.area >= 0 && i < 3; ++i)
      {
        sums[ids[i]].announce(share.area);
      }
    });
  std::for_each(sums.begin(), sums.end(), [](PointSum& sum) { sum.chooseUnit(); });
  auto share = shares.cbegin();
  forEachTriangle(views, points,
    [&](const TrianglesView&, const Ids& ids)
    {
      for (std::size_t i = 0; share->area >= 0 && i < 3; ++i)
      {
        sums[ids[i]].add(*share);
      }
      ++share;
    });
  MeshVertices vertices;
  vertices.normals.resize(3 * points);
  vertices.areas.resize(points);
  for (std::size_t point = 0; point < points; ++point)
  {
    Eigen::Map<Eigen::Vector3d>(&vertices.normals[3 * point]) = sums[point].areaVector();
    vertices.areas[point] = sums[point].area() / 3;
  }
  return vertices;
}

} // namespace winding
