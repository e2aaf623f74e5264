#include "source/MeshVertices.h"

#include "source/CoordinateOrder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>

namespace winding
{

namespace
{

using Ids = std::array<std::size_t, 3>;

/// A triangle's area vector, and its area.
struct Share
{
  Eigen::Vector3d areaVector;
  double area;
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

/// The share of a triangle, whichever of its corners it begins with; an area that is not finite
/// where the area vector is not.
Share shareOf(const TrianglesView& view, const Ids& ids)
{
  Eigen::Vector3d corners[3] = {view.points[ids[0]], view.points[ids[1]], view.points[ids[2]]};
  const double x = corners[0][0], y = corners[1][0], z = corners[2][0];
  if (x == y || y == z || z == x)
  {
    turnToFirstOrder(corners);
  }
  const bool areApart = x != y && y != z && z != x;
  const int first = !areApart ? 0 : y < x ? (z < y ? 2 : 1) : (z < x ? 2 : 0);
  const Eigen::Vector3d& a = corners[first];
  const Eigen::Vector3d u = corners[first < 2 ? first + 1 : 0] - a;
  const Eigen::Vector3d v = corners[first > 0 ? first - 1 : 2] - a;
  Share share;
  share.areaVector = 0.5 * u.cross(v);
  share.area = share.areaVector.allFinite() ? lengthOf(share.areaVector)
                                            : std::numeric_limits<double>::infinity();
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
    // Ascending numbers of 0 or more have ascending bits.
    std::int64_t bits;
    std::memcpy(&bits, &area, sizeof bits);
    sums_[0] = std::max(sums_[0], bits);
    ++sums_[1];
  }

  void chooseUnit()
  {
    double largest;
    std::memcpy(&largest, &sums_[0], sizeof largest);
    constexpr int bits = 62, smallest = -1000; // 2^1000 is a number, too
    int bitsOfCount = 0;
    while (sums_[1] >> bitsOfCount != 0)
    {
      ++bitsOfCount;
    }
    const int exponent = largest > 0 ? std::ilogb(largest) + 1 + bitsOfCount - bits : 0;
    unit_ = std::ldexp(1.0, std::max(exponent, smallest));
    perUnit_ = 1 / unit_;
    sums_ = {};
  }

  void add(const Share& share)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      sums_[axis] +=
        static_cast<std::int64_t>(share.areaVector[static_cast<Eigen::Index>(axis)] * perUnit_);
    }
    sums_[3] += static_cast<std::int64_t>(share.area * perUnit_);
  }

  Eigen::Vector3d areaVector() const
  {
    return {this->valueOf(sums_[0]), this->valueOf(sums_[1]), this->valueOf(sums_[2])};
  }
  double area() const { return this->valueOf(sums_[3]); }

private:
  double valueOf(std::int64_t sum) const { return static_cast<double>(sum) * unit_; }

  /// The sums, in units; before the unit is known, the bits of the largest area and the number of
  /// shares.
  std::array<std::int64_t, 4> sums_ = {};
  double unit_ = 0, perUnit_ = 0;
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
  std::size_t triangles = 0;
  for (const TrianglesView& view : views)
  {
    triangles += view.triangles.size();
  }
  std::vector<Share> shares;
  shares.reserve(triangles);
  std::vector<PointSum> sums(points);
  forEachTriangle(views, points,
    [&](const TrianglesView& view, const Ids& ids)
    {
      const Share& share = shares.emplace_back(shareOf(view, ids));
      for (std::size_t i = 0; std::isfinite(share.area) && i < 3; ++i)
      {
        sums[ids[i]].announce(share.area);
      }
    });
  std::for_each(sums.begin(), sums.end(), [](PointSum& sum) { sum.chooseUnit(); });
  auto share = shares.cbegin();
  forEachTriangle(views, points,
    [&](const TrianglesView&, const Ids& ids)
    {
      for (std::size_t i = 0; std::isfinite(share->area) && i < 3; ++i)
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
