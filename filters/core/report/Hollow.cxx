// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/Hollow.h"

#include "base/Digits.h"
#include "base/DisjointSets.h"
#include "diagnosis/Diagnosis.h"
#include "field/Field.h"
#include "report/ReportGrid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace winding
{

namespace
{

/// A connected set of samples outside that are farther from the surface than some distance.
struct Basin
{
  float deepest = 0; ///< the largest of their distances
  std::int32_t samples = 0;
  bool isOutside = false; ///< whether any is at the border of the grid
};

/// The basins of samples, from the farthest of the surface to the nearest. Openings where samples
/// are farther than `widest` from the surface are not told apart.
class Basins
{
public:
  Basins(const Grid& grid, const std::vector<float>& distances, double widest)
    : extent_(grid.wholeExtent())
    , dimensions_(grid.dimensions)
    , distances_(distances)
    , widest_(static_cast<float>(widest))
    , sets_(distances.size())
    , basins_(distances.size())
  {
  }

  /// Calls visit(basin, distance) for each basin that the outside reaches, with the distance at
  /// which it does.
  template <class Visit> void flood(const Visit& visit)
  {
    std::vector<std::int32_t> order;
    const auto addThose = [&](const auto& areTaken)
    {
      for (std::size_t i = 0; i < distances_.size(); ++i)
      {
        if (distances_[i] > 0 && areTaken(distances_[i]))
        {
          order.push_back(static_cast<std::int32_t>(i));
        }
      }
    };
    addThose([this](float distance) { return distance > widest_; });
    const auto far = static_cast<std::ptrdiff_t>(order.size());
    addThose([this](float distance) { return distance <= widest_; });
    std::sort(order.begin() + far, order.end(),
      [this](std::int32_t a, std::int32_t b)
      {
        const float first = distances_[static_cast<std::size_t>(a)];
        const float second = distances_[static_cast<std::size_t>(b)];
        return first != second ? first > second : a < b;
      });
    for (const std::int32_t sample : order)
    {
      const float distance = distances_[static_cast<std::size_t>(sample)];
      const Eigen::Vector3i at = sampleIndex(extent_, static_cast<std::size_t>(sample));
      const bool isAtBorder =
        (at.array() == 0).any() || (at.array() == dimensions_.array() - 1).any();
      basins_[static_cast<std::size_t>(sample)] = {distance, 1, isAtBorder};
      for (int axis = 0; axis < 3; ++axis)
      {
        for (const int step : {-1, 1})
        {
          Eigen::Vector3i next = at;
          next[axis] += step;
          if (next[axis] >= 0 && next[axis] < dimensions_[axis])
          {
            this->join(sample,
              static_cast<std::int32_t>(sampleNumber(extent_, next[0], next[1], next[2])), distance,
              visit);
          }
        }
      }
    }
  }

private:
  template <class Visit>
  void join(std::int32_t sample, std::int32_t next, float distance, const Visit& visit)
  {
    if (basins_[static_cast<std::size_t>(next)].samples == 0)
    {
      return; // it is nearer to the surface, or inside
    }
    const Basin a = basins_[static_cast<std::size_t>(sets_.find(sample))];
    const Basin b = basins_[static_cast<std::size_t>(sets_.find(next))];
    if (!sets_.unite(sample, next))
    {
      return;
    }
    if (a.isOutside != b.isOutside)
    {
      visit(a.isOutside ? b : a, distance);
    }
    basins_[static_cast<std::size_t>(sets_.find(sample))] = {
      std::max(a.deepest, b.deepest), a.samples + b.samples, a.isOutside || b.isOutside};
  }

  Extent extent_;
  Eigen::Vector3i dimensions_;
  const std::vector<float>& distances_;
  float widest_;
  DisjointSets sets_;
  std::vector<Basin> basins_; ///< by the first sample of a set; without samples where none is yet
};

} // namespace

Remedy Hollow::remedy() const
{
  return {"close gaps up to " + inDigits(gapWidth, 2) + " for one solid",
    {{Parameter::fillCavities, 1}, Parameter::gapWidth}};
}

double thicknessOfWalls(const Field& field, const InsideTest& isInside, Executor& executor)
{
  const WallSamples walls = field.diagnosis().boundingWalls(isInside, executor);
  const double most = 0.1 * field.info().bounds.sizes().maxCoeff();
  std::vector<std::pair<double, double>> thin; // thickness and area
  double all = 0, area = 0;
  for (std::size_t i = 0; i < walls.points.size(); ++i)
  {
    all += walls.points[i].weight;
    if (walls.lines[i].wall < most)
    {
      thin.emplace_back(walls.lines[i].wall, walls.points[i].weight / walls.shares[i]);
      area += thin.back().second;
    }
  }
  std::sort(thin.begin(), thin.end());
  double sum = 0;
  for (const auto& [thickness, weight] : thin)
  {
    sum += weight;
    if (2 * area >= all && 2 * sum >= area)
    {
      return thickness;
    }
  }
  return 0;
}

std::optional<Hollow> findHollow(
  const Field& field, const InsideTest& isInside, Executor& executor, double smallestVoxel)
{
  if (!field.diagnosis().hasEnclosedPoints(executor))
  {
    return std::nullopt;
  }
  // About 112³ voxels, whatever the proportions.
  const Eigen::Vector3d sizes = field.info().bounds.sizes();
  const double finest = smallestVoxel > 0 ? std::max(1.0, sizes.maxCoeff() / smallestVoxel) : 256;
  const double resolution =
    std::min({256.0, finest, 112 / std::cbrt((sizes / sizes.maxCoeff()).prod())});
  const std::optional<Grid> grid = reportGrid(field.info().bounds, static_cast<int>(resolution));
  if (!grid)
  {
    return std::nullopt;
  }
  const Extent extent = grid->wholeExtent();
  std::vector<float> distances(sampleCount(extent));
  FieldOutput output;
  output.distances = distances.data();
  output.isInside = isInside;
  const double limit = sizes.maxCoeff() / 8;
  output.distanceLimit = limit;
  field.evaluate(*grid, extent, output, executor);
  const double voxel = grid->spacing.maxCoeff();
  const double least = 0.01 * sizes.prod() / grid->spacing.prod();
  std::optional<Hollow> hollow;
  std::int32_t largest = 0;
  constexpr double narrow = 3; // times the opening is narrower than the cavity
  Basins(*grid, distances, limit / narrow)
    .flood(
      [&](const Basin& basin, double distance)
      {
        const bool isNarrow = basin.deepest > narrow * distance && distance > 0.5 * voxel;
        if (isNarrow && basin.samples > least && basin.samples > largest)
        {
          largest = basin.samples;
          hollow = {2 * distance + voxel / 2, 1.2 * (2 * distance + voxel)};
        }
      });
  return hollow;
}

} // namespace winding
