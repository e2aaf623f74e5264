// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/SampleShares.h"

#include "source/Surface.h"
#include "sums/ReferenceSum.h"
#include "support/Fields.h"
#include "support/Grids.h"
#include "support/Serial.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace shapes;

std::optional<double> shareOf(const Mesh& mesh)
{
  const auto field = fieldOf(mesh);
  return winding::sampleShares(*field, serial).fractional;
}

/// The share found by sums in double.
double naiveShareOf(const Mesh& mesh)
{
  const winding::Surface surface = clean(mesh);
  const winding::Grid grid = gridAround(surface.bounds, 32, 0.05);
  std::size_t fractional = 0, count = 0;
  for (int k = 0; k < grid.dimensions[2]; ++k)
  {
    for (int j = 0; j < grid.dimensions[1]; ++j)
    {
      for (int i = 0; i < grid.dimensions[0]; ++i)
      {
        const double w = winding::referenceSum<double>(surface, grid.sample(i, j, k));
        fractional += std::abs(w - std::round(w)) > 0.1;
        ++count;
      }
    }
  }
  return static_cast<double>(fractional) / static_cast<double>(count);
}

Mesh withoutSome(Mesh mesh, std::size_t triangles)
{
  mesh.triangles.resize(mesh.triangles.size() - triangles);
  return mesh;
}

} // namespace

TEST(SampleShares, FractionalIsNothingForClosedSurfaces)
{
  EXPECT_EQ(shareOf(cube()), 0);
  EXPECT_EQ(shareOf(cube().with(icosphere(2)).reversed()), 0);
  EXPECT_EQ(shareOf(Mesh()), 0);
}

TEST(SampleShares, FractionalIsThatOfSumsInDouble)
{
  for (const Mesh& mesh : {openCube(), withoutSome(icosphere(2), 1), withoutSome(icosphere(2), 200),
         triangleSoup(50, 821)})
  {
    const double expected = naiveShareOf(mesh);
    EXPECT_GT(expected, 0);
    // Some samples lie within the tolerance, 1e-3, of the limit: the difference was measured as 0
    // to 0.0006.
    EXPECT_NEAR(shareOf(mesh).value_or(-1), expected, 0.005);
  }
}

TEST(SampleShares, FractionalGrowsWithTheHole)
{
  double before = 0;
  for (const std::size_t missing : {20, 80, 160})
  {
    const double share = shareOf(withoutSome(icosphere(2), missing)).value_or(-1);
    EXPECT_GT(share, before);
    before = share;
  }
}

TEST(SampleShares, FractionalOfFlatSheetsAndAtAnySize)
{
  const Mesh sheet{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}}};
  EXPECT_GT(shareOf(sheet).value_or(-1), 0.5);
  const double expected = shareOf(openCube()).value_or(-1);
  for (const double scale : {0x1p-300, 0x1p300})
  {
    EXPECT_EQ(shareOf(openCube().scaled(scale)), expected);
  }
  // No grid has room between coordinates that are next to each other.
  const double next = std::nextafter(1.0, 2.0);
  const Mesh tiny{{{1, 1, 1}, {next, 1, 1}, {1, next, 1}}, {{0, 1, 2}}};
  EXPECT_EQ(shareOf(tiny), std::nullopt);
}

TEST(SampleShares, CountOverlapsOnce)
{
  const auto onceOf = [](const Mesh& mesh)
  {
    return winding::sampleShares(*fieldOf(mesh), serial).once;
  };
  EXPECT_EQ(onceOf(cube()), 1);
  // Two bars of length 2 overlap by a half, and share the faces along them.
  const Mesh bars = cube({0, 0, 0}, {2, 1, 1}).with(cube({1, 0, 0}, {3, 1, 1}));
  EXPECT_NEAR(onceOf(bars), 0.75, 0.01); // measured 0.75
  EXPECT_EQ(onceOf(cube().with(cube().reversed().moved({2, 0, 0}))), 1);
}
