#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>

/**
 * @file
 * The two kernels of the winding number: the solid angle of a triangle and of an oriented point.
 * Divided by 4π and summed over a surface, either gives w.
 *
 * Notation: q the sample; a, b, c the vertices of a triangle minus q.
 *
 * Guaranteed: (1) no absolute epsilon, so a uniform scale of all coordinates changes nothing but
 * rounding; (2) odd under a flip of orientation, to the bit where
 * it exchanges b and c; (3) a sample in the plane of a
 * triangle receives 0 from it: on the surface the sums are therefore principal values, the mean of
 * the two sides (0.5 on a face of a closed mesh); (4) degenerate triangles give 0. Not guaranteed:
 * (3) for a sample that is in the plane only up to rounding; it gets one side.
 */
namespace winding
{

template <class Scalar> using Vector3 = Eigen::Matrix<Scalar, 3, 1>;

/**
 * Solid angle of a triangle, in (−2π, 2π), positive where its normal points away from q, so that an
 * outward oriented closed surface gives +4π inside.
 *
 * tan(Ω/2) = a·(b×c) / (|a||b||c| + (a·b)|c| + (b·c)|a| + (c·a)|b|)
 * (van Oosterom and Strackee, The solid angle of a plane triangle, IEEE TBME 1983.) The numerator
 * is taken as a·((b−a)×(c−a)), which does not cancel for small far triangles.
 */
template <class Scalar>
Scalar solidAngle(const Vector3<Scalar>& a, const Vector3<Scalar>& b, const Vector3<Scalar>& c)
{
  const Scalar numerator = a.dot((b - a).cross(c - a));
  if (numerator == 0)
  {
    return 0;
  }
  const Scalar la = a.norm(), lb = b.norm(), lc = c.norm();
  // Symmetric in b and c to the bit.
  const Scalar denominator = (lb * lc + b.dot(c)) * la + (a.dot(b) * lc + a.dot(c) * lb);
  return 2 * std::atan2(numerator, denominator);
}

/**
 * Solid angle of a small patch of the given area and unit normal at offset p − q:
 * area · normal·(p−q) / |p−q|³ (Barill et al., Fast winding numbers for soups and clouds, 2018).
 * 0 at the point itself.
 */
template <class Scalar>
Scalar dipoleSolidAngle(
  const Vector3<Scalar>& offset, const Vector3<Scalar>& unitNormal, Scalar area)
{
  const Scalar squared = offset.squaredNorm();
  return squared == 0 ? 0 : area * unitNormal.dot(offset) / (squared * std::sqrt(squared));
}

} // namespace winding
