#include "Checks.h"
#include "FieldValues.h"
#include "RandomSources.h"

#include "base/Refusal.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <time.h>

/**
 * @file
 * Method automatic takes no more than 1.5 times as long as the direct sum, and 10 ms, whatever the
 * triangles: Field.h promises so. Times are those of the processor for this thread, so that other
 * programs matter little, and a time that is too long must be so in each of several attempts.
 */
namespace fuzz
{

namespace
{

using namespace winding;
using shapes::Mesh;
using shapes::Point;

constexpr int attempts = 5;

double threadSeconds()
{
  struct timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The seconds to build a field and to evaluate it at samples or, if there are none, on a grid.
double secondsOf(const Mesh& mesh, const FieldOptions& options, const Grid& grid,
  const std::vector<Point>& samples)
{
  SerialExecutor serial;
  const double start = threadSeconds();
  const auto field = Field::build(viewsOf(mesh), options, serial);
  samples.empty() ? valuesOf(*field, grid, grid.wholeExtent(), false, serial)
                  : valuesOf(*field, samples, false, serial);
  return threadSeconds() - start;
}

} // namespace

std::string checkTime(Choices& choices)
{
  const Mesh mesh = randomMesh(choices, choices.oneIn(4) ? 4000 : 600);
  FieldOptions options;
  options.tolerance = randomTolerance(choices);
  FieldOptions direct = options;
  direct.method = Method::direct;
  SerialExecutor serial;
  Bounds bounds;
  try
  {
    bounds = Field::build(viewsOf(mesh), direct, serial)->info().bounds;
  }
  catch (const Refusal&)
  {
  }
  if (bounds.isEmpty() || !(bounds.sizes().minCoeff() > 0))
  {
    return {};
  }
  GridRequest request;
  request.bounds = bounds;
  request.padding = 0.05;
  request.resolution = 2 + choices.below(31);
  const Grid grid = layOutGrid(request);
  const std::vector<Point> samples =
    choices.oneIn(3) ? randomSamples(choices, mesh.points, 1 + choices.below(3000))
                     : std::vector<Point>();
  double least = HUGE_VAL, allowed = 0;
  for (int attempt = 0; attempt < attempts && !(least <= allowed); ++attempt)
  {
    allowed = std::max(allowed, 1.5 * secondsOf(mesh, direct, grid, samples) + 0.01);
    least = std::min(least, secondsOf(mesh, options, grid, samples));
  }
  if (least <= allowed)
  {
    return {};
  }
  std::ostringstream text;
  text << nameOf(options.method) << " takes " << least << " s, more than " << allowed << ": "
       << mesh.triangles.size() << " triangles, tolerance " << options.tolerance << ", "
       << (samples.empty() ? sampleCount(grid.wholeExtent()) : samples.size())
       << (samples.empty() ? " samples of a grid" : " scattered samples");
  return text.str();
}

} // namespace fuzz
