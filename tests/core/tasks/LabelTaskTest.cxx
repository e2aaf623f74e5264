// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/LabelTask.h"

#include "support/Serial.h"
#include "support/SolidOnGrid.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using namespace shapes;
using winding::OverlapRule;

const winding::Grid grid = gridOf({-0.45, -0.45, -0.45}, Point::Constant(0.1), {20, 20, 20});

/// The labels of some solids, and the warnings about them.
struct Labeled
{
  explicit Labeled(const std::vector<Mesh>& solids, OverlapRule overlapRule = OverlapRule::first,
    const winding::Extent& extent = grid.wholeExtent(), bool mendsSource = false)
    : labels(winding::sampleCount(extent))
  {
    winding::Run run{
      serial, [this](const winding::Message& message) { warnings.push_back(message.fault); }, {}};
    winding::LabelArrays arrays;
    arrays.extent = extent;
    arrays.labels = labels.data();
    winding::LabelOptions options;
    options.overlapRule = overlapRule;
    options.mendsSource = mendsSource;
    facts.expected = solids.size();
    winding::LabelTask task(grid, arrays, options, facts, run);
    for (const Mesh& solid : solids)
    {
      const auto field = fieldOf(solid);
      const auto label = static_cast<unsigned short>(facts.solids + 1);
      task.add(*field, field->info(), {label, "solid " + std::to_string(label)}, run);
    }
    task.warn(false, run);
  }

  std::ptrdiff_t count(int label) const { return std::count(labels.begin(), labels.end(), label); }

  std::vector<unsigned short> labels;
  std::vector<std::string> warnings;
  winding::LabelFacts facts;
};

using Warnings = std::vector<std::string>;

} // namespace

TEST(LabelTask, GivesVoxelsTheLabelOfTheirSolid)
{
  const Mesh first = cube({0, 0, 0}, {1, 1, 1}), second = cube({0.5, 0, 0}, {1.4, 1, 1});
  const Labeled found({first, second});
  EXPECT_EQ(found.warnings, Warnings());
  EXPECT_EQ(found.count(1), 1000);
  EXPECT_EQ(found.count(2), 400);
  EXPECT_EQ(found.count(0), 8000 - 1400);
  const Labeled smallest({first, second}, OverlapRule::smallestVolume);
  EXPECT_EQ(smallest.count(1), 500);
  EXPECT_EQ(smallest.count(2), 900);
}

TEST(LabelTask, WarnsOfSolidsThatAreNotAsTheirOwnerExpects)
{
  const Mesh box = cube({0, 0, 0}, {1, 1, 1});
  const Mesh within = cube({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8});
  EXPECT_EQ(Labeled({}).warnings, Warnings({"there is no solid, so all labels are 0"}));
  EXPECT_EQ(Labeled({box, Mesh()}).warnings, Warnings({"no voxel has the labels of empty blocks"}));
  EXPECT_EQ(Labeled({box.part(0, 10)}).warnings, Warnings({"some solids have holes"}));
  EXPECT_EQ(Labeled({box.reversed(), within}).warnings,
    Warnings({"some solids look inward and have no label"}));
  EXPECT_EQ(
    Labeled({box, within.moved({9, 9, 9})}).warnings, Warnings({"the grid misses some solids"}));
  EXPECT_EQ(Labeled({box, cube({0.06, 0.06, 1.06}, {0.14, 0.14, 1.14})}).warnings,
    Warnings({"some solids have no voxel inside"}));
  EXPECT_EQ(Labeled({box, within}).warnings, Warnings({"others hide all voxels of some solids"}));
  EXPECT_EQ(Labeled({box, within}, OverlapRule::smallestVolume).warnings, Warnings());
}

TEST(LabelTask, SaysNothingOfTheGridForAPieceOfIt)
{
  const Mesh box = cube({0, 0, 0}, {1, 1, 1});
  const Labeled found({box, box.moved({9, 9, 9})}, OverlapRule::first, {0, 19, 0, 19, 5, 6});
  EXPECT_EQ(found.warnings, Warnings());
  EXPECT_EQ(found.count(1), 200);
}

TEST(LabelTask, MendsSolidsThatBoundNothing)
{
  const Mesh box = cube({0, 0, 0}, {1, 1, 1}), other = cube({1.05, 0, 0}, {1.45, 1, 1});
  const Mesh sheet = cube({0, 0, 0}, {1, 1, 1.32}).part(10, 12);
  const std::vector<Mesh> solids = {box.reversed(), other.reversed(), sheet};
  const Labeled found(solids, OverlapRule::first, grid.wholeExtent(), true);
  EXPECT_EQ(found.count(1), 1000);
  EXPECT_EQ(found.count(2), 400);
  // Three layers of the sheet, and half of a disc of 1.5 voxels at its rim.
  EXPECT_NEAR(static_cast<double>(found.count(3)), 440, 20);
  EXPECT_EQ(
    found.warnings, Warnings({"faces were turned", "open sheets became a plate of three voxels",
                      "some solids have holes"}));
  const winding::Extent piece = {0, 19, 0, 19, 3, 18};
  const Labeled part(solids, OverlapRule::first, piece, true);
  for (std::size_t n = 0; n < part.labels.size(); ++n)
  {
    ASSERT_EQ(part.labels[n], found.labels[n + 3 * 400]);
  }
}
