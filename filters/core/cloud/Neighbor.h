// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstdint>

namespace winding
{

/// A place near to another one.
struct Neighbor
{
  std::uint32_t place;
  double squaredDistance; ///< squared distance in the scaled coordinates of the places
};

/// The order of neighbours: by their distances, and by their numbers where these are equal.
inline bool isNearer(const Neighbor& a, const Neighbor& b)
{
  return a.squaredDistance < b.squaredDistance ||
         (a.squaredDistance == b.squaredDistance && a.place < b.place);
}

/// The squared distance of two places, summed in the one order that gives all searches the same
/// bits.
inline double squaredDistanceBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return x * x + y * y + z * z;
}

} // namespace winding
