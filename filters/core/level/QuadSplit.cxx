// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/QuadSplit.h"

#include <cmath>
#include <limits>

namespace winding
{

namespace
{

/// Crossings that differ by less than this fraction of the edge are equally near.
constexpr double equallyNear = 1e-6;

/// Triangles stay this far away, as a share of the tetrahedra's sizes, from where they would leave
/// them or lose their area: more than single precision rounds.
constexpr double margin = 1.0 / (1 << 10);

double cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/// Where the triangles on both sides of the diagonal from corner `from` to the opposite one cross
/// the edge; NaN if they leave the tetrahedra.
double crossingOfSplit(const QuadAroundEdge& quad, int from)
{
  const Eigen::Vector3d &a = quad.corners[from], &c = quad.corners[(from + 2) % 4];
  const double side = cross(a, c);
  // The edge goes through the triangle that has this third corner, or through the diagonal.
  const Eigen::Vector3d& third = quad.corners[(from + (side >= 0 ? 3 : 1)) % 4];
  const Eigen::Vector3d& other = quad.corners[(from + (side >= 0 ? 1 : 3)) % 4];
  const double nan = std::numeric_limits<double>::quiet_NaN();

  const double ofA = std::abs(cross(c, third)), ofC = std::abs(cross(third, a));
  const double ofThird = std::abs(side);
  const double crossing = (ofA * a[2] + ofC * c[2] + ofThird * third[2]) / (ofA + ofC + ofThird);
  if (!(crossing >= margin && crossing <= 1 - margin))
  {
    return nan;
  }
  // The diagonal meets the half plane of the edge and the other corner in this point, which must
  // be in the triangle that these form.
  const double shareOfA = std::abs(cross(other, c));
  const double shareOfC = std::abs(cross(a, other));
  const Eigen::Vector3d met = (shareOfA * a + shareOfC * c) / (shareOfA + shareOfC);
  const double share = met.head<2>().dot(other.head<2>()) / other.head<2>().squaredNorm();
  const double along = met[2] - share * other[2];
  const double room = 1 - share;
  const bool isInside = room >= margin && along >= margin * room && along <= (1 - margin) * room;
  return isInside ? crossing : nan;
}

} // namespace

QuadSplit betterSplit(const QuadAroundEdge& quad)
{
  double off[2], lengths[2];
  for (int n = 0; n < 2; ++n)
  {
    const double crossing = crossingOfSplit(quad, n);
    off[n] = std::isnan(crossing) ? std::numeric_limits<double>::infinity()
                                  : std::abs(crossing - quad.crossing);
    lengths[n] = (quad.corners[n + 2] - quad.corners[n]).cwiseProduct(quad.spacing).squaredNorm();
  }
  if (std::isinf(off[0]) && std::isinf(off[1]))
  {
    return QuadSplit::fan;
  }
  const bool areEquallyNear = std::abs(off[0] - off[1]) <= equallyNear;
  const bool isFirst = areEquallyNear ? lengths[0] <= lengths[1] : off[0] < off[1];
  return isFirst ? QuadSplit::first : QuadSplit::second;
}

} // namespace winding
