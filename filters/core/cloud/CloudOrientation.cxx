// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/CloudOrientation.h"

#include "base/FieldOutput.h"
#include "base/Progress.h"
#include "farfield/FarField.h"
#include "source/CoordinateOrder.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace winding
{

namespace
{

double median(std::vector<float>& values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Chooses points at equal steps of area along an order, so that thousands at one place count no
/// more than one elsewhere.
std::vector<std::size_t> evenlyChosen(
  const std::vector<double>& areas, const std::vector<std::uint32_t>& order)
{
  // Areas are taken in units of the largest, so that their sum stays within range.
  const double largest = areas.empty() ? 0 : *std::max_element(areas.begin(), areas.end());
  std::vector<std::size_t> chosen;
  if (!(largest > 0))
  {
    return chosen;
  }
  double sum = 0;
  for (const std::uint32_t point : order)
  {
    sum += areas[point] / largest;
  }
  constexpr std::size_t most = 2000;
  const std::size_t steps = std::min(areas.size(), most);
  double passed = 0;
  for (const std::uint32_t point : order)
  {
    const auto stepAt = [&](double area)
    {
      return std::floor(area / sum * static_cast<double>(steps) + 0.5);
    };
    const double before = passed;
    passed += areas[point] / largest;
    if (stepAt(passed) > stepAt(before))
    {
      chosen.push_back(point);
    }
  }
  return chosen;
}

bool isAbout(double w, double expected)
{
  return std::abs(w - expected) < 0.25;
}

} // namespace

CloudOrientation orientationOf(const PointCloud& cloud, Executor& executor, double added)
{
  CloudOrientation orientation;
  constexpr double spacings = 2;
  const std::vector<std::size_t> chosen =
    evenlyChosen(cloud.areas, coordinateOrder(cloud, cloud.areas, executor));
  const std::size_t count = chosen.size();
  if (count == 0)
  {
    return orientation;
  }
  std::vector<Eigen::Vector3d> samples;
  for (const std::size_t point : chosen)
  {
    const Eigen::Vector3d step = spacings * std::sqrt(cloud.areas[point]) * cloud.normals[point];
    samples.emplace_back(cloud.positions[point] - step);
    samples.emplace_back(cloud.positions[point] + step);
  }
  constexpr double tolerance = 1e-2;
  const FarField field(
    farFieldSources(cloud, cloud.areas, executor), FarFieldAccuracy::of(tolerance), executor);
  std::vector<float> values(samples.size());
  FieldOutput output;
  output.values = values.data();
  output.added = added;
  BriefExecutor briefly(executor);
  field.evaluate({samples[0].data(), samples.size()}, output, briefly);
  std::vector<float> behind, before;
  std::size_t outward = 0, inward = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    behind.push_back(values[2 * i]);
    before.push_back(values[2 * i + 1]);
    outward += isAbout(behind.back(), 1) && isAbout(before.back(), 0);
    inward += isAbout(behind.back(), 0) && isAbout(before.back(), -1);
  }
  orientation.behind = median(behind);
  orientation.before = median(before);
  orientation.outward = static_cast<double>(outward) / static_cast<double>(count);
  orientation.inward = static_cast<double>(inward) / static_cast<double>(count);
  return orientation;
}

} // namespace winding
