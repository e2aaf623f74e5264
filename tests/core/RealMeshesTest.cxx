#include "CappedSurface.h"

#include "DirectSum.h"
#include "ReadObj.h"
#include "RowValues.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace shapes;
using winding::CappedSurface;
using winding::Extent;
using winding::FieldOutput;
using winding::Grid;

namespace
{

std::vector<float> valuesOn(const CappedSurface& capped, const Grid& grid, const Extent& extent)
{
  std::vector<float> values(winding::sampleCount(extent), std::nanf(""));
  FieldOutput output;
  output.values = values.data();
  winding::SerialExecutor serial;
  EXPECT_TRUE(capped.evaluate(grid, extent, output, serial));
  return values;
}

/// Anywhere, and those next to vertices.
std::vector<std::size_t> someSamples(const winding::Surface& surface, const Grid& grid)
{
  Random random(151);
  std::vector<std::size_t> samples;
  for (int i = 0; i < 300; ++i)
  {
    samples.push_back(random.bits() % winding::sampleCount(grid.wholeExtent()));
  }
  for (int i = 0; i < 150; ++i)
  {
    const Point& vertex = surface.vertices[random.bits() % surface.vertices.size()];
    const Eigen::Vector3i nearest =
      (vertex - grid.firstSample).cwiseQuotient(grid.spacing).array().round().cast<int>();
    const Eigen::Vector3i last = grid.dimensions - Eigen::Vector3i::Ones();
    samples.push_back(
      placeIn(grid.wholeExtent(), nearest.cwiseMin(last).cwiseMax(Eigen::Vector3i::Zero())));
  }
  return samples;
}

class RealMeshes : public testing::TestWithParam<const char*>
{
};

} // namespace

TEST_P(RealMeshes, EqualTheDirectSumAndHaveTheSameBitsInSevenPieces)
{
  const Mesh mesh = readObj(std::string(WINDING_SHARED_DATA) + "/" + GetParam());
  if (mesh.triangles.empty())
  {
    GTEST_SKIP() << "absent: " << GetParam();
  }
  SCOPED_TRACE("seed 151");
  const winding::Surface surface = clean(mesh);
  const CappedSurface capped(surface, boundaryOf(surface));
  const winding::TriangleSum sum(surface);
  record("capTriangles", static_cast<double>(capped.capTriangles()));
  double largest = 0;
  for (const int resolution : {16, 33})
  {
    winding::GridRequest request;
    request.bounds = surface.bounds;
    request.padding = 0.03;
    request.resolution = resolution;
    const Grid grid = winding::layOutGrid(request);
    const Extent whole = grid.wholeExtent();
    const std::vector<float> values = valuesOn(capped, grid, whole);

    const std::vector<std::size_t> samples = someSamples(surface, grid);
    for (std::size_t first = 0; first < samples.size(); first += winding::SampleBlock::capacity)
    {
      winding::SampleBlock block;
      block.count = std::min(winding::SampleBlock::capacity, samples.size() - first);
      for (std::size_t i = 0; i < block.count; ++i)
      {
        const Eigen::Vector3i index = winding::sampleIndex(whole, samples[first + i]);
        const Point q = grid.sample(index[0], index[1], index[2]);
        block.x[i] = q[0];
        block.y[i] = q[1];
        block.z[i] = q[2];
      }
      double expected[winding::SampleBlock::capacity];
      bool isOnSurface[winding::SampleBlock::capacity];
      sum.evaluateWatching(block, expected, isOnSurface);
      for (std::size_t i = 0; i < block.count; ++i)
      {
        const float value = values[samples[first + i]];
        ASSERT_TRUE(std::isfinite(value));
        if (!isOnSurface[i])
        {
          largest = std::max(largest, std::abs(value - expected[i]));
        }
        if (capped.capTriangles() == 0)
        {
          ASSERT_EQ(value, std::round(value));
        }
      }
    }

    for (int piece = 0; piece < 7; ++piece)
    {
      Extent part = whole;
      part[4] = grid.dimensions[2] * piece / 7;
      part[5] = grid.dimensions[2] * (piece + 1) / 7 - 1;
      const std::vector<float> values7 = valuesOn(capped, grid, part);
      ASSERT_TRUE(std::equal(values7.begin(), values7.end(),
        values.begin() + static_cast<std::ptrdiff_t>(placeIn(whole, {0, 0, part[4]}))));
    }
  }
  record("largestError", largest);
  EXPECT_LT(largest, 2e-6); // measured: 5.6e-8, the rounding to float
}

INSTANTIATE_TEST_SUITE_P(OfSharedData, RealMeshes,
  testing::Values("armadillo_86k.obj", "bunny_1k.obj", "bunny_10k.obj", "bunny_70k.obj",
    "maxplanck_open_90k.obj", "self_intersectA.obj", "sphere_quads.obj", "teapot.obj",
    "truck_soup.obj"),
  [](const auto& mesh)
  {
    std::string name = mesh.param;
    name.resize(name.size() - 4);
    return name;
  });
