#pragma once

#include "base/Evaluator.h"
#include "base/Executor.h"
#include "base/Views.h"
#include "source/Grid.h"
#include "source/PointCloud.h"
#include "source/Surface.h"

/**
 * @file
 * What the benchmarks measure on, made in code.
 */
namespace shapes
{

/// Runs blocks on a number of threads.
class Threads final : public winding::Executor
{
public:
  explicit Threads(int threads)
    : threads_(threads)
  {
  }
  bool run(std::size_t count, const std::function<void(std::size_t)>& work) override;

private:
  int threads_;
};

/// A soup of triangles without common points, as in a .stl file.
struct Soup
{
  std::vector<double> corners;
  std::vector<std::int32_t> ids;

  winding::TrianglesView view() const
  {
    return {{corners.data(), corners.size() / 3}, {ids.data(), ids.size() / 3}};
  }
};

/// A closed sphere of 2·n² triangles whose radius varies; n at least 3.
Soup lumpySphereSoup(int n);

/// The same, welded.
winding::Surface lumpySphere(int n);

/// The surface without every `period`-th triangle: a hole each.
winding::Surface withHoles(const winding::Surface& surface, std::size_t period);

/// The centres of the triangles, with their normals and areas.
winding::PointCloud centroids(const winding::Surface& surface);

/// A full block of samples in and around the sphere.
winding::SampleBlock someSamples();

/// n³ samples over the sphere and a margin.
winding::Grid gridAround(int n);

} // namespace shapes
