// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/CellParts.h"

#include <Eigen/LU>

#include <algorithm>

namespace winding
{

Bounds boxOf(const CellPart& part, const LocalCell& cell)
{
  Bounds box;
  for (const Eigen::Vector3d& corner : part.corners)
  {
    box.extend(cell.global(corner));
  }
  return box;
}

void addCones(const LocalCell& cell, std::uint32_t number, std::vector<CellPart>& to)
{
  for (std::size_t j = 0; j < cell.cones(); ++j)
  {
    const Eigen::Matrix3d corners = cell.cone(j, cell.middle());
    CellPart part = {};
    part.corners[0] = cell.middle();
    for (int k = 0; k < 3; ++k)
    {
      part.corners[std::size_t(k) + 1] = cell.middle() + corners.col(k);
    }
    part.cell = number;
    part.volume = corners.determinant();
    to.push_back(part);
  }
}

void addEighths(const CellPart& part, std::vector<CellPart>& to)
{
  const auto& v = part.corners;
  const auto mid = [&v](std::size_t i, std::size_t j) -> Eigen::Vector3d
  {
    return 0.5 * (v[i] + v[j]);
  };
  const Eigen::Vector3d m01 = mid(0, 1), m02 = mid(0, 2), m03 = mid(0, 3), m12 = mid(1, 2),
                        m13 = mid(1, 3), m23 = mid(2, 3);
  const std::array<std::array<Eigen::Vector3d, 4>, 8> eighths = {
    {{v[0], m01, m02, m03}, {m01, v[1], m12, m13}, {m02, m12, v[2], m23}, {m03, m13, m23, v[3]},
      {m01, m02, m03, m13}, {m01, m02, m12, m13}, {m02, m03, m13, m23}, {m02, m12, m13, m23}}};
  for (const std::array<Eigen::Vector3d, 4>& corners : eighths)
  {
    to.push_back({corners, part.cell, part.volume / 8, CellState::clear});
  }
}

double positivePart(std::array<double, 4> values)
{
  std::sort(values.begin(), values.end());
  const auto cornerPart = [&values](std::size_t corner)
  {
    double part = 1;
    for (std::size_t i = 0; i < 4; ++i)
    {
      part *= i == corner ? 1 : values[corner] / (values[corner] - values[i]);
    }
    return part;
  };
  if (values[0] >= 0)
  {
    return 1;
  }
  if (values[3] <= 0)
  {
    return 0;
  }
  if (values[1] >= 0)
  {
    return 1 - cornerPart(0);
  }
  if (values[2] <= 0)
  {
    return cornerPart(3);
  }
  // Two corners on either side: a prism, cut into three tetrahedra (a, b negative, c, d positive).
  const auto [a, b, c, d] = values;
  const double ac = c / (c - a), ad = d / (d - a), bc = c / (c - b), bd = d / (d - b);
  return ac * bc * (1 - bd) + bd * (ac * (1 - ad) + ad);
}

} // namespace winding
