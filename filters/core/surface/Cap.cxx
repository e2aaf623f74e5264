#include "surface/Cap.h"

#include "base/Bounds.h"

namespace winding
{

std::vector<Triangle> capOf(const std::vector<BoundaryLoop>& loops)
{
  std::vector<Triangle> cap;
  for (BoundaryLoop rim : loops)
  {
    while (rim.size() > 2)
    {
      const std::size_t n = rim.size();
      BoundaryLoop inner;
      for (std::size_t i = 0; i < n; i += 2)
      {
        inner.push_back(rim[i]);
        if (i + 1 < n)
        {
          // An ear runs against the sense of the rim, whose two edges it cancels.
          cap.push_back({rim[i], rim[(i + 2) % n], rim[i + 1]});
        }
      }
      if (n == 3)
      {
        break; // a rim of three vertices is one ear, so nothing is left
      }
      rim = std::move(inner);
    }
  }
  return cap;
}

std::vector<Triangle> fanOf(
  const std::vector<BoundaryLoop>& loops, std::vector<Eigen::Vector3d>& vertices)
{
  std::vector<Triangle> fan;
  for (const BoundaryLoop& loop : loops)
  {
    Bounds bounds;
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (std::int32_t vertex : loop)
    {
      bounds.extend(vertices[vertex]);
      center += vertices[vertex] / static_cast<double>(loop.size());
    }
    // The new vertex lies beside the loop's centre by π/18, e/12 and ln 2 · 3/8 of its size. These
    // are neither simple fractions nor, as sizes are, roots of such, which grids and CAD are full
    // of.
    const double size = bounds.diagonal().norm();
    const Eigen::Vector3d aside(0.17453292519943295, 0.22652348570492042, 0.25993019270997947);
    const std::int32_t apex = static_cast<std::int32_t>(vertices.size());
    vertices.push_back(center + size * aside);
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      fan.push_back({loop[(i + 1) % loop.size()], loop[i], apex});
    }
  }
  return fan;
}

} // namespace winding
