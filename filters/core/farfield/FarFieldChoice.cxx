// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/FarFieldChoice.h"

#include "farfield/SplitTriangles.h"

#include <algorithm>
#include <cmath>

namespace winding
{

namespace
{

constexpr double weightOfValue = 0.7e-9;

/// Returns the cost of expansions of an order, relative to order 5.
double orderFactor(int order)
{
  return order <= 3 ? 0.6 : order <= 5 ? 1 : order <= 7 ? 2.5 : 5;
}

} // namespace

std::size_t bytesOfFarField(Primitive kind, std::size_t primitives, int order)
{
  const auto coefficients = static_cast<std::size_t>((order + 1) * (order + 1));
  const std::size_t bytesPerSource = (kind == Primitive::triangle ? 120 : 90) + coefficients * 3;
  return (bytesPerPrimitive + bytesPerSource) * primitives;
}

double weightOfDirectSum(std::size_t triangles, std::size_t samples)
{
  constexpr double perPair = 1.6e-9;
  const double perSample = perPair * static_cast<double>(triangles) + weightOfValue;
  return perSample * static_cast<double>(samples);
}

double weightOfFarField(const SampledSource& triangles, int order)
{
  const auto primitives = static_cast<double>(triangles.primitives);
  const auto samples = static_cast<double>(triangles.samples);
  // Samples near the source take most of the time. They are as many as its area has squares
  // between them, and a sample is near to no more than all triangles.
  const double near = std::min(orderFactor(order) * (5.5e-6 * triangles.area),
    weightOfDirectSum(triangles.primitives, triangles.samples));
  const double perSample = triangles.primitives == 0 ? 0 : 160e-9;
  // Triangles that are cut have pieces of 12 squares on average.
  const double items = std::clamp(triangles.area / 12, primitives,
    static_cast<double>(mostPieces(triangles.primitives, triangles.samples, order)));
  return orderFactor(order) * (0.5e-6 * items + perSample * samples) + near +
         weightOfValue * samples;
}

FarFieldGain gainOfFarField(
  const std::vector<Eigen::Vector3d>& vertices, const TriangleList& triangles, const Bounds& bounds)
{
  constexpr std::size_t parts = 4;
  const double length = bounds.isEmpty() ? 0 : bounds.sizes().maxCoeff() / 8;
  const auto isLarge = [&](const Triangle& t)
  {
    const Eigen::Vector3d &a = vertices[t[0]], &b = vertices[t[1]], &c = vertices[t[2]];
    return (a.cwiseMax(b).cwiseMax(c) - a.cwiseMin(b).cwiseMin(c)).maxCoeff() > length;
  };
  const auto large = std::count_if(triangles.begin(), triangles.end(), isLarge);
  return parts * static_cast<std::size_t>(large) >= triangles.size() ? FarFieldGain::doubtful
                                                                     : FarFieldGain::likely;
}

bool isCheaperDirectly(Primitive kind, std::size_t primitives, int order)
{
  constexpr std::size_t usual = 64 * 64 * 64;
  return isCheaperDirectly(kind, primitives, usual, order);
}

bool isCheaperDirectly(Primitive kind, std::size_t primitives, std::size_t samples, int order,
  FarFieldState state, FarFieldGain gain)
{
  // All figures are nanoseconds on a processor of 2025. The tree's are those beyond what the direct
  // sum takes before its first sample. The number of cells near sources grows like the number of
  // voxels on a surface, with the power 2/3; few sources are near to few cells.
  const bool isTriangle = kind == Primitive::triangle;
  const auto count = static_cast<double>(primitives), places = static_cast<double>(samples);
  const double pairs = (isTriangle ? 0.9 : 0.36) * count * places;
  const double tree = state == FarFieldState::built
                        ? 0
                        : ((isTriangle ? 500 : 200) * std::sqrt(orderFactor(order)) - 80) * count;
  const double cells = (isTriangle ? 11'000 : 5'500) * orderFactor(order) *
                       std::min(1.0, std::cbrt(count / 10'000)) * std::pow(places, 2.0 / 3);
  // The matrices that shift expansions are made for every evaluation: 0.1 ms at order 3, 7 at 9.
  const double shifts = 1'000 * std::pow(order, 4);
  // A far field has to promise a gain. Where it may have none, the tree has to take little of the
  // direct sum's time, too.
  constexpr double margin = 1.3, marginOfTree = 4.5;
  const double doubt = gain == FarFieldGain::doubtful ? marginOfTree * tree : 0;
  return pairs < std::max(margin * (tree + cells + shifts), doubt);
}

} // namespace winding
