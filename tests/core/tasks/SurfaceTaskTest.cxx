// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/SurfaceTask.h"

#include "support/SolidOnGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>

namespace
{

using namespace shapes;
using winding::BooleanOperation;
using winding::Output;

/// Keeps the arrays of a task.
class KeepingSink final : public winding::Sink
{
public:
  template <class Number> std::vector<Number> numbers(Output output) const
  {
    const auto found = bytes_.find(output);
    if (found == bytes_.end())
    {
      return {};
    }
    const auto* const first = reinterpret_cast<const Number*>(found->second.data());
    return {first, first + found->second.size() / sizeof(Number)};
  }

  bool has(Output output) const { return bytes_.count(output) > 0; }

  /// Returns the volume within the polygons, taken as fans.
  double volume() const
  {
    const auto points = this->numbers<float>(Output::points);
    const auto offsets = this->numbers<std::int64_t>(Output::offsets);
    const auto corners = this->numbers<std::int64_t>(Output::corners);
    const auto at = [&](std::int64_t corner)
    {
      const float* const point = &points[3 * static_cast<std::size_t>(corners[corner])];
      return Point(point[0], point[1], point[2]);
    };
    double volume = 0;
    for (std::size_t i = 0; i + 1 < offsets.size(); ++i)
    {
      for (std::int64_t corner = offsets[i] + 2; corner < offsets[i + 1]; ++corner)
      {
        volume += at(offsets[i]).dot(at(corner - 1).cross(at(corner))) / 6;
      }
    }
    return volume;
  }

protected:
  void* memoryOf(Output output, winding::NumberType type, std::size_t tuples) override
  {
    constexpr std::size_t sizes[] = {1, 4, 8, 4, 8};
    std::vector<char>& bytes = bytes_[output];
    bytes.resize(
      sizes[static_cast<int>(type)] * tuples * static_cast<std::size_t>(componentsOf(output)));
    return bytes.data();
  }

private:
  std::map<Output, std::vector<char>> bytes_;
};

/// A run that keeps its warnings.
struct KeptRun
{
  winding::SerialExecutor executor;
  std::vector<std::string> faults;
  winding::Run run{
    executor, [this](const winding::Message& message) { faults.push_back(message.fault); }, {}};
};

const winding::Grid grid = gridOf({-0.45, -0.45, -0.45}, Point::Constant(0.1), {20, 20, 20});

KeepingSink surfaceOf(const Mesh& mesh, const winding::SurfaceOptions& options, KeptRun& run)
{
  const auto field = fieldOf(mesh);
  KeepingSink sink;
  winding::makeSurface(*field, grid, options, sink, run.run);
  return sink;
}

} // namespace

TEST(SurfaceTask, MakesTheArraysThatAreWanted)
{
  const Mesh box = cube({0, 0, 0}, {1, 1, 1});
  for (const winding::Features features :
    {winding::Features::smooth, winding::Features::sharp, winding::Features::voxels})
  {
    SCOPED_TRACE(static_cast<int>(features));
    KeptRun run;
    winding::SurfaceOptions options;
    options.features = features;
    options.hasImage = true;
    const KeepingSink found = surfaceOf(box, options, run);
    EXPECT_EQ(run.faults, std::vector<std::string>());
    const bool isSmooth = features == winding::Features::smooth;
    EXPECT_EQ(found.has(Output::pointNormals), isSmooth);
    EXPECT_EQ(found.has(Output::polygonNormals), !isSmooth);
    EXPECT_FALSE(found.has(Output::operands));
    const auto inside = found.numbers<unsigned char>(Output::inside);
    EXPECT_EQ(inside.size(), 8000u);
    EXPECT_EQ(std::accumulate(inside.begin(), inside.end(), 0), 1000);
    // The smooth surface cuts edges off: measured 0.9857.
    EXPECT_NEAR(found.volume(), 1, isSmooth ? 0.02 : 1e-5);
  }
}

TEST(SurfaceTask, WarnsOfWhatSpoilsTheSurface)
{
  struct Case
  {
    Mesh mesh;
    bool hasImage, closesBorder;
    std::vector<std::string> faults;
  };
  const Mesh large = cube({-5, -5, -5}, {5, 5, 5}), half = cube({-5, 0, 0}, {0.5, 1, 1});
  const Case cases[] = {
    {large, false, false, {"all samples are inside, so the surface is empty"}},
    {large, true, false, {}},
    {large, false, true, {}},
    {half, false, false, {"the surface reaches the border of the grid, where it is open"}},
    {half, true, false, {}},
    {half, false, true, {}},
    {cube({9, 9, 9}, {10, 10, 10}), false, false, {"the grid misses the source"}},
  };
  for (const Case& one : cases)
  {
    SCOPED_TRACE(&one - cases);
    KeptRun run;
    winding::SurfaceOptions options;
    options.hasImage = one.hasImage;
    options.closesBorder = one.closesBorder;
    surfaceOf(one.mesh, options, run);
    EXPECT_EQ(run.faults, one.faults);
  }
}

TEST(SurfaceTask, TellsHowItsShapeCameAbout)
{
  winding::SurfaceOptions options;
  options.shape.offset = 0.2;
  const auto field = fieldOf(cube({0, 0, 0}, {1, 1, 1}));
  KeptRun run;
  KeepingSink sink;
  const winding::SurfaceResult found = winding::makeSurface(*field, grid, options, sink, run.run);
  EXPECT_EQ(found.distancesFrom, winding::DistanceBase::source);
  EXPECT_EQ(found.surfaceTree, nullptr);
  // Steiner's formula: V + A r + M r² + 4/3 π r³. Measured 1 % less, as edges are cut off.
  const double r = options.shape.offset, pi = std::acos(-1);
  EXPECT_NEAR(sink.volume(), 1 + 6 * r + 3 * pi * r * r + 4.0 / 3 * pi * r * r * r, 0.03);
}

TEST(SurfaceTask, RefusesMoreThanTheFreeMemory)
{
  const auto field = fieldOf(icosphere(3));
  const winding::Grid fine = gridOf({-1.1, -1.1, -1.1}, Point::Constant(0.001), {2200, 2200, 2200});
  KeptRun run;
  EXPECT_GT(winding::claimSurface(*field, fine, {}, run.run).bytes, 1e9);
  run.run.freeMemory = []
  {
    return 1e9;
  };
  try
  {
    winding::claimSurface(*field, fine, {}, run.run);
    ADD_FAILURE() << "nothing is refused";
  }
  catch (const winding::OutOfMemory& refusal)
  {
    EXPECT_EQ(std::string(refusal.what()).rfind("not enough memory: choose larger voxels", 0), 0u)
      << refusal.what();
  }
}

TEST(BooleanTask, WritesTheOperandOfEachPolygon)
{
  const auto first = fieldOf(cube({0, 0, 0}, {1, 1, 1}));
  const auto second = fieldOf(cube({0.5, 0, 0}, {1.4, 1, 1}));
  const double volumes[] = {1.4, 0.5, 0.5, 0.9};
  for (int operation = 0; operation < 4; ++operation)
  {
    SCOPED_TRACE(operation);
    KeptRun run;
    winding::SurfaceOptions options;
    options.features = winding::Features::sharp;
    winding::BooleanTask task(grid, static_cast<BooleanOperation>(operation), options);
    task.add(*first, {}, run.run);
    task.add(*second, {}, run.run);
    KeepingSink sink;
    task.run(sink, run.run);
    EXPECT_EQ(run.faults, std::vector<std::string>());
    EXPECT_NEAR(sink.volume(), volumes[operation], 1e-4);
    const auto operands = sink.numbers<std::int32_t>(Output::operands);
    EXPECT_EQ(operands.size() + 1, sink.numbers<std::int64_t>(Output::offsets).size());
    EXPECT_GT(std::count(operands.begin(), operands.end(), 0), 0);
    EXPECT_GT(std::count(operands.begin(), operands.end(), 1), 0);
  }
}

TEST(BooleanTask, WarnsOfOperandsAndResultsThatAreLost)
{
  const auto box = fieldOf(cube({0, 0, 0}, {1, 1, 1}));
  const auto other = fieldOf(cube({1.2, 1.2, 1.2}, {1.4, 1.4, 1.4}));
  const auto between = fieldOf(cube({0.06, 0.06, 0.06}, {0.14, 0.14, 0.14}));
  KeptRun run;
  winding::BooleanTask task(grid, BooleanOperation::intersect, {});
  task.add(*box, {}, run.run);
  task.add(*other, {}, run.run);
  KeepingSink sink;
  task.run(sink, run.run);
  EXPECT_EQ(run.faults,
    std::vector<std::string>({"nothing is inside of the result, so the surface is empty"}));
  KeptRun another;
  winding::BooleanTask lost(grid, BooleanOperation::unite, {});
  lost.add(*box, {}, another.run);
  lost.add(*between, {}, another.run);
  EXPECT_EQ(another.faults, std::vector<std::string>({"the source is thinner than three voxels"}));
}
