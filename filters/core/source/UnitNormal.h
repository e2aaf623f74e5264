// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace winding
{

/// The unit vector along a normal, which may have any length but 0.
inline Eigen::Vector3d unitNormal(const Eigen::Vector3d& normal)
{
  // Dividing by the largest component first keeps the square of a very long or short normal in the
  // range of double.
  return (normal / normal.cwiseAbs().maxCoeff()).normalized();
}

} // namespace winding
