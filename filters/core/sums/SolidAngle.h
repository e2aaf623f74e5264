// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

/**
 * @file
 * The kernels of the winding number: the solid angle of a triangle and of an oriented point, the
 * latter also spread over some length. Divided by 4π and summed over a surface, each gives w.
 *
 * Notation: q is the sample; a, b, c are the vertices of a triangle minus q.
 *
 * Guaranteed: (1) there is no absolute epsilon, so a uniform scale of all coordinates changes
 * nothing but rounding; (2) solid angles are odd under a flip of orientation, to the bit where the
 * flip exchanges b and c; (3) a sample in the plane of a triangle, or at one of its vertices,
 * receives 0 from it: on the surface the sums are therefore principal values, the mean of the two
 * sides (0.5 on a face of a closed mesh) and, at a vertex, the share of directions that lead
 * inside; (4) degenerate triangles give 0. Not guaranteed is (3) for a sample that is in the plane
 * only up to rounding and at no vertex; it gets one side.
 */
namespace winding
{

template <class Scalar> using Vector3 = Eigen::Matrix<Scalar, 3, 1>;

/// Where numerator and denominator of a solid angle are both at most this times |a||b||c|, they are
/// taken in the form that does not cancel.
constexpr double smallSolidAngle = 0x1p-6;

/// Returns (b − a) × (c − a), the cross product of any two sides; it takes the shorter two, whose
/// product cancels least. Where b and c are exchanged, it turns round to the bit. It is exactly 0
/// where the shorter sides are exactly parallel.
template <class Scalar>
Vector3<Scalar> triangleNormal(
  const Vector3<Scalar>& a, const Vector3<Scalar>& b, const Vector3<Scalar>& c)
{
  const Vector3<Scalar> ab = b - a, ac = c - a, bc = c - b;
  const Scalar lab = ab.squaredNorm(), lac = ac.squaredNorm(), lbc = bc.squaredNorm();
  if (lac > std::max(lab, lbc))
  {
    return ab.cross(bc);
  }
  if (lab > std::max(lac, lbc))
  {
    return ac.cross(bc);
  }
  if (lab > lbc) // and as long as ac
  {
    return (Scalar(0.5) * (ab + ac)).cross(bc);
  }
  return ab.cross(ac);
}

/**
 * Solid angle of a triangle, in (−2π, 2π), positive where its normal points away from q, so that an
 * outward oriented closed surface gives +4π inside.
 *
 * tan(Ω/2) = a·(b×c) / (|a||b||c| + (a·b)|c| + (b·c)|a| + (c·a)|b|)
 * (van Oosterom and Strackee, The solid angle of a plane triangle, IEEE TBME 1983.) The numerator
 * is taken as a·((b−a)×(c−a)), which does not cancel for small far triangles (triangleNormal()).
 * Both are small differences where corners are seen in nearly opposite directions, as from the
 * middle of a needle. There, with u = a/|a|,
 *
 * tan(Ω/2) = u·((u×b)×(u×c)) / ((|b| + u·b)(|c| + u·c) + (u×b)·(u×c)),
 *
 * by (u×b)×(u×c) = u (u·(b×c)) and (u×b)·(u×c) = b·c − (u·b)(u·c); and where u·b < 0,
 * |b| + u·b = |u×b|² / (|b| − u·b). So rounding costs the angle some
 * 2e-15 (1 + L/d) at most in double, for a longest side L and a distance d from the three sides.
 */
template <class Scalar>
Scalar solidAngle(const Vector3<Scalar>& a, const Vector3<Scalar>& b, const Vector3<Scalar>& c)
{
  const Scalar numerator = a.dot(triangleNormal<Scalar>(a, b, c));
  const Scalar la = a.norm(), lb = b.norm(), lc = c.norm();
  // At a vertex the numerator may be rounding instead of 0.
  if (numerator == 0 || la == 0 || lb == 0 || lc == 0)
  {
    return 0;
  }
  // Denominators are symmetric in b and c to the bit.
  const Scalar denominator = (lb * lc + b.dot(c)) * la + (a.dot(b) * lc + a.dot(c) * lb);
  if (std::max(std::abs(numerator), std::abs(denominator)) > smallSolidAngle * (lb * lc * la))
  {
    return 2 * std::atan2(numerator, denominator);
  }
  const Vector3<Scalar> u = a / la, ub = u.cross(b), uc = u.cross(c);
  const auto lengthPlus = [](Scalar along, const Vector3<Scalar>& across, Scalar length)
  {
    return along < 0 ? across.squaredNorm() / (length - along) : length + along;
  };
  const Scalar volume = u.dot(ub.cross(uc));
  const Scalar sum = lengthPlus(u.dot(b), ub, lb) * lengthPlus(u.dot(c), uc, lc) + ub.dot(uc);
  return volume == 0 ? 0 : 2 * std::atan2(volume, sum);
}

/**
 * Solid angle of a small patch of the given area and unit normal at offset p − q:
 * area · normal·(p−q) / |p−q|³ (Barill et al., Fast winding numbers for soups and clouds, 2018);
 * 0 at the point itself.
 */
template <class Scalar>
Scalar dipoleSolidAngle(
  const Vector3<Scalar>& offset, const Vector3<Scalar>& unitNormal, Scalar area)
{
  const Scalar squared = offset.squaredNorm();
  return squared == 0 ? 0 : area * unitNormal.dot(offset) / (squared * std::sqrt(squared));
}

/**
 * Solid angle of a patch that is spread over a length e > 0: dipoleSolidAngle() times S(t),
 * t = |p−q| / e,
 *
 *   S(t) = erf t − 2t/√π exp(−t²),   S(t)/t³ = 4/√π Σ_k (−t²)^k / (k! (2k+3)).
 *
 * The product is the field of dipoles distributed like (e√π)^−3 exp(−|x|²/e²) around p, since the
 * field of a charge with this distribution is S(t) times a point's (Gauss's law). So it is
 * smooth, odd in p−q and 0 at the point itself, and from t = 6.3 on, where 1 − S is below 1e-16, it
 * is the patch's. A length of 0 spreads nothing.
 */
template <class Scalar>
Scalar regularizedDipoleSolidAngle(
  const Vector3<Scalar>& offset, const Vector3<Scalar>& unitNormal, Scalar area, Scalar length)
{
  constexpr Scalar twoOverRootPi = static_cast<Scalar>(1.1283791670955125738961589031215452L);
  if (length == 0)
  {
    return dipoleSolidAngle<Scalar>(offset, unitNormal, area);
  }
  const Scalar t = offset.norm() / length;
  if (t > 1)
  {
    return (std::erf(t) - twoOverRootPi * t * std::exp(-t * t)) *
           dipoleSolidAngle<Scalar>(offset, unitNormal, area);
  }
  // The series is for t ≤ 1, where the difference above would cancel.
  Scalar sum = 0, power = 1, term;
  int k = 0;
  do
  {
    term = power / static_cast<Scalar>(2 * k + 3);
    sum += term;
    power *= -t * t / static_cast<Scalar>(++k);
  } while (std::abs(term) > std::numeric_limits<Scalar>::epsilon() / 16);
  return 2 * twoOverRootPi * sum * (area / length) * (unitNormal.dot(offset) / length) / length;
}

} // namespace winding
