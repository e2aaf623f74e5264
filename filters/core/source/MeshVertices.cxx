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

/// 2^exponent, for exponents from −1022 to 1023; std::ldexp() is a call.
double powerOfTwo(int exponent)
{
  const std::uint64_t bits = static_cast<std::uint64_t>(exponent + 1023) << 52;
  double power;
  std::memcpy(&power, &bits, sizeof power);
  return power;
}

/// The exponent of a positive number, −1023 for those below the normal ones.
int exponentOf(double number)
{
  std::uint64_t bits;
  std::memcpy(&bits, &number, sizeof bits);
  return static_cast<int>(bits >> 52) - 1023;
}

/**
 * The unit in which the shares around a point are summed as integers, so that their order does not
 * matter: a power of two, so small that rounding a share is 2⁻⁵⁶ of the largest share at most,
 * times the number of shares, and so large that no sum leaves the range.
 */
class Unit
{
public:
  void announce(double area)
  {
    exponent_ = std::max(exponent_, exponentOf(area));
    ++count_;
  }

  void choose()
  {
    constexpr int bits = 62;
    int bitsOfCount = 0;
    while (count_ >> bitsOfCount != 0)
    {
      ++bitsOfCount;
    }
    exponent_ = std::max(exponent_ + 1 + bitsOfCount - bits, lowest);
  }

  /// The unit, or its inverse; both are powers of two, and so exact.
  double size() const { return powerOfTwo(exponent_); }
  double inverse() const { return powerOfTwo(-exponent_); }

private:
  static constexpr int lowest = -1000; ///< 2^1000 is a number, too

  int exponent_ = lowest; ///< that of the largest area, until the unit is chosen
  std::uint32_t count_ = 0;
};

/// The sums of area vectors and of areas around a point, in units.
using PointSum = std::array<std::int64_t, 4>;

void add(const Share& share, double inverseUnit, PointSum& sum)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double value = share.areaVector[static_cast<Eigen::Index>(axis)];
    sum[axis] += static_cast<std::int64_t>(value * inverseUnit);
  }
  sum[3] += static_cast<std::int64_t>(share.area * inverseUnit);
}

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
  std::vector<Unit> units(points);
  forEachTriangle(views, points,
    [&](const TrianglesView& view, const Ids& ids)
    {
      const Share& share = shares.emplace_back(shareOf(view, ids));
      for (std::size_t i = 0; std::isfinite(share.area) && i < 3; ++i)
      {
        units[ids[i]].announce(share.area);
      }
    });
  std::for_each(units.begin(), units.end(), [](Unit& unit) { unit.choose(); });
  std::vector<PointSum> sums(points, PointSum{});
  auto share = shares.cbegin();
  forEachTriangle(views, points,
    [&](const TrianglesView&, const Ids& ids)
    {
      for (std::size_t i = 0; std::isfinite(share->area) && i < 3; ++i)
      {
        add(*share, units[ids[i]].inverse(), sums[ids[i]]);
      }
      ++share;
    });
  MeshVertices vertices;
  vertices.normals.resize(3 * points);
  vertices.areas.resize(points);
  for (std::size_t point = 0; point < points; ++point)
  {
    const double unit = units[point].size();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      vertices.normals[3 * point + axis] = static_cast<double>(sums[point][axis]) * unit;
    }
    vertices.areas[point] = static_cast<double>(sums[point][3]) * unit / 3;
  }
  return vertices;
}

} // namespace winding
