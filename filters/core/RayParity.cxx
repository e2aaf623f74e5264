#include "RayParity.h"

#include "Predicates.h"
#include "UnitScale.h"

#include <algorithm>

namespace winding
{

namespace
{

/// A triangle prepared for many rays along +x; u, v are the coordinates y, z across them.
class RayTarget
{
public:
  RayTarget(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
    : corners_{a, b, c}
    , across_{a.tail<2>(), b.tail<2>(), c.tail<2>()}
    , low_(a.cwiseMin(b).cwiseMin(c))
    , high_(a.cwiseMax(b).cwiseMax(c))
  {
  }

  bool isCrossedFrom(double x, double y, double z) const
  {
    if (x > high_[0] || y < low_[1] || y > high_[1] || z < low_[2] || z > high_[2])
    {
      return false;
    }
    const Eigen::Vector2d q(y, z);
    const int side = sideOfEdge(across_[0], across_[1], q);
    if (side == 0 || sideOfEdge(across_[1], across_[2], q) != side ||
        sideOfEdge(across_[2], across_[0], q) != side)
    {
      return false;
    }
    if (x < low_[0])
    {
      return true;
    }
    // The sample is within the triangle's extent along the ray: which side of its plane is it on?
    return sideOfPlane(corners_[0], corners_[1], corners_[2], {x, y, z}) * side > 0;
  }

private:
  Eigen::Vector3d corners_[3];
  Eigen::Vector2d across_[3];
  Eigen::Vector3d low_, high_;
};

} // namespace

RayParity::RayParity(const Surface& surface)
  : surface_(surface)
  , scale_(unitScale(surface.bounds))
{
}

void RayParity::evaluate(const SampleBlock& block, double* values) const
{
  SampleBlock scaled;
  scaleSamples(block, scale_, scaled);
  bool odd[SampleBlock::capacity] = {};
  for (const Triangle& triangle : surface_.triangles)
  {
    const RayTarget target(surface_.vertices[triangle[0]] * scale_,
      surface_.vertices[triangle[1]] * scale_, surface_.vertices[triangle[2]] * scale_);
    for (std::size_t i = 0; i < scaled.count; ++i)
    {
      odd[i] ^= target.isCrossedFrom(scaled.x[i], scaled.y[i], scaled.z[i]);
    }
  }
  std::copy_n(odd, scaled.count, values);
}

} // namespace winding
