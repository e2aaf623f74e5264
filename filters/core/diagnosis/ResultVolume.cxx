// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "diagnosis/ResultVolume.h"

#include "base/Evenly.h"
#include "base/UnitRandom.h"

#include <algorithm>
#include <cmath>

namespace winding
{

namespace
{

/// Returns where each line enters and leaves a solid, in turn, by the triangles that it meets.
std::vector<std::vector<double>> sidesOf(
  std::vector<LineHit> hits, std::size_t lines, const InsideTest& isInside)
{
  std::stable_sort(
    hits.begin(), hits.end(), [](const LineHit& a, const LineHit& b) { return a.place < b.place; });
  std::vector<std::vector<double>> sides(lines);
  std::vector<int> windingNumbers(lines, 0);
  for (const LineHit& hit : hits)
  {
    const auto line = static_cast<std::size_t>(hit.sample);
    const bool wasInside = isInside(windingNumbers[line]);
    windingNumbers[line] -= hit.times; // a triangle that looks along the axis is left
    if (isInside(windingNumbers[line]) != wasInside)
    {
      sides[line].push_back(hit.place);
    }
  }
  return sides;
}

/// Returns the sides of an operation on two solids.
std::vector<double> combined(
  BooleanOperation operation, const std::vector<double>& a, const std::vector<double>& b)
{
  std::vector<double> sides;
  std::size_t ofA = 0, ofB = 0; // passed
  bool isInside = false;
  while (ofA < a.size() || ofB < b.size())
  {
    const bool isA = ofB == b.size() || (ofA < a.size() && a[ofA] <= b[ofB]);
    const double place = isA ? a[ofA++] : b[ofB++];
    if (isInResult(operation, 2, ofA % 2 + ofB % 2, ofA % 2 == 1) != isInside)
    {
      isInside = !isInside;
      sides.push_back(place);
    }
  }
  return sides;
}

} // namespace

ResultVolume::ResultVolume(const Grid& grid, BooleanOperation operation)
  : voxel_(grid.spacing)
  , tests_(static_cast<double>(sampleCount(grid.wholeExtent())) / 16)
  , operation_(operation)
{
  box_.extend(grid.firstSample);
  box_.extend(grid.sample(grid.dimensions - Eigen::Vector3i::Ones()));
  const int perSide = std::clamp(grid.dimensions.maxCoeff() / 2, 8, 48);
  UnitRandom random(1);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int cell = 0; cell < perSide * perSide; ++cell)
    {
      Eigen::Vector3d shares = Eigen::Vector3d::Zero();
      shares[(axis + 1) % 3] = (cell % perSide + random()) / perSide;
      shares[(axis + 2) % 3] = (cell / perSide + random()) / perSide;
      const Eigen::Vector3d place = box_.min() + shares.cwiseProduct(box_.sizes());
      lines_.push_back({{-1, 1, place, Eigen::Vector3d::Unit(axis)}, {}});
    }
  }
}

std::vector<SurfaceSample> ResultVolume::samples() const
{
  std::vector<SurfaceSample> samples;
  for (const Line& line : lines_)
  {
    samples.push_back(line.sample);
  }
  return samples;
}

double ResultVolume::lengthInside(const std::vector<double>& sides, int axis) const
{
  double length = 0;
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
  {
    const double low = std::max(sides[i], box_.min()[axis]);
    const double high = std::min(sides[i + 1], box_.max()[axis]);
    length += std::max(high - low, 0.0);
  }
  return length;
}

void ResultVolume::add(const Diagnosis& operand, const InsideTest& isInside, Executor& executor)
{
  if (!operand.isClosedSurface() || isInside(0) || lines_.empty())
  {
    this->forget();
    return;
  }
  lines_ = evenly(lines_, operand.affordable(this->samples(), executor, tests_).size());
  const auto sides = sidesOf(operand.hits(this->samples(), executor), lines_.size(), isInside);
  for (std::size_t i = 0; i < lines_.size(); ++i)
  {
    lines_[i].sides = isFirst_ ? sides[i] : combined(operation_, lines_[i].sides, sides[i]);
  }
  isFirst_ = false;
}

double ResultVolume::ratioOf(const Surface& result, double volume, Executor& executor) const
{
  SurfaceSamples ofResult;
  ofResult.box = result.bounds;
  ofResult.extents = voxel_;
  const auto sides =
    sidesOf(hitsOfLines(result, this->samples(), ofResult, executor), lines_.size(), InsideTest());
  double missing = 0, variance = 0; // of the mean of three axes
  for (int axis = 0; axis < 3; ++axis)
  {
    double count = 0, sum = 0, sumOfSquares = 0;
    for (std::size_t i = 0; i < lines_.size(); ++i)
    {
      if (axisOf(lines_[i].sample) == axis)
      {
        const double length =
          this->lengthInside(lines_[i].sides, axis) - this->lengthInside(sides[i], axis);
        ++count;
        sum += length;
        sumOfSquares += length * length;
      }
    }
    const Eigen::Vector3d sizes = box_.sizes();
    const double share = sizes[(axis + 1) % 3] * sizes[(axis + 2) % 3] / std::max(count, 1.0) / 3;
    missing += share * sum;
    variance += share * share * (sumOfSquares - sum * sum / std::max(count, 1.0));
  }
  constexpr double standardErrors = 3;
  const bool mayBeChance = missing * missing <= standardErrors * standardErrors * variance;
  return mayBeChance ? 1 : volume / (volume + missing);
}

} // namespace winding
