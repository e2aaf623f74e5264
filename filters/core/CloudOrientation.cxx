#include "CloudOrientation.h"

#include "FarField.h"
#include "FieldOutput.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace winding
{

namespace
{

/// Runs briefly what would otherwise show progress.
class BriefExecutor final : public Executor
{
public:
  explicit BriefExecutor(Executor& executor)
    : executor_(executor)
  {
  }
  bool run(std::size_t count, const std::function<void(std::size_t)>& work) override
  {
    return executor_.runBriefly(count, work);
  }

private:
  Executor& executor_;
};

double median(std::vector<float>& values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool isAbout(double w, double expected)
{
  return std::abs(w - expected) < 0.25;
}

} // namespace

CloudOrientation orientationOf(const PointCloud& cloud, Executor& executor)
{
  CloudOrientation orientation;
  const std::size_t points = cloud.positions.size();
  if (points == 0)
  {
    return orientation;
  }
  constexpr std::size_t mostPoints = 2000;
  constexpr double spacings = 2;
  const std::size_t count = std::min(points, mostPoints);
  std::vector<Eigen::Vector3d> samples;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t point = i * points / count;
    const Eigen::Vector3d step = spacings * std::sqrt(cloud.areas[point]) * cloud.normals[point];
    samples.emplace_back(cloud.positions[point] - step);
    samples.emplace_back(cloud.positions[point] + step);
  }
  constexpr double tolerance = 1e-2;
  const FarField field(
    farFieldSources(cloud, cloud.areas), FarFieldAccuracy::of(tolerance), executor);
  std::vector<float> values(samples.size());
  FieldOutput output;
  output.values = values.data();
  BriefExecutor briefly(executor);
  if (!field.evaluate({samples[0].data(), samples.size()}, output, briefly))
  {
    throw Interrupted();
  }
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
