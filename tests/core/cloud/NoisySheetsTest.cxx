// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// Planes of noisy sheets that are close to each other, and normals smoothed along them.

#include "cloud/NoisySheets.h"

#include "support/Samples.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace shapes;

/// Level sheets three spacings apart, with noise of half a spacing, whose normals point up and down
/// in turn. The spacing is 1.
class NoisySheets : public testing::Test
{
protected:
  static constexpr double apart = 3;
  static constexpr std::size_t sheets = 4, neighbors = 40;

  NoisySheets()
    : places_(positions(), 1, serial_)
    , graph_(places_, neighbors, serial_)
    , spacings_(places_.size(), 1)
  {
  }

  static std::vector<Point> positions()
  {
    constexpr std::size_t perSheet = 1600;
    constexpr double size = 40; // the square root of perSheet
    Random random(21);
    std::vector<Point> positions;
    for (std::size_t i = 0; i < sheets * perSheet; ++i)
    {
      const double height = apart * static_cast<double>(i % sheets) + 0.5 * random.normal();
      positions.push_back(Point{random(0, size), random(0, size), height});
    }
    return positions;
  }

  /// The sheet that a place is nearest to.
  static int sheetOf(const Point& place) { return static_cast<int>(std::lround(place[2] / apart)); }

  /// The share of normals within 20 degrees of a vertical line.
  static double steepShare(const std::vector<Point>& normals)
  {
    const auto steep = std::count_if(normals.begin(), normals.end(),
      [](const Point& normal) { return std::abs(normal[2]) > 0.94; });
    return static_cast<double>(steep) / static_cast<double>(normals.size());
  }

  winding::SheetPlanes planes(winding::Executor& executor) const
  {
    return winding::sheetPlanes(places_, graph_, spacings_, {8, 20, neighbors}, executor);
  }

  winding::SerialExecutor serial_;
  const winding::DistinctPoints places_;
  const winding::NeighborGraph graph_;
  const std::vector<double> spacings_;
};

} // namespace

TEST_F(NoisySheets, HavePlanesOfTheirOwn)
{
  const winding::SheetPlanes planes = this->planes(serial_);
  const double byAll = steepShare(winding::planeNormals(places_, graph_, neighbors, serial_));
  EXPECT_LT(byAll, 0.4);                       // 0.34
  EXPECT_GT(steepShare(planes.normals), 0.65); // 0.70
  std::vector<double> before, after;
  for (std::size_t place = 0; place < places_.size(); ++place)
  {
    EXPECT_NEAR(planes.normals[place].norm(), 1, 1e-12);
    const double sheet = apart * sheetOf(places_.positions()[place]);
    before.push_back(std::abs(places_.positions()[place][2] - sheet));
    after.push_back(std::abs(planes.feet[place][2] - sheet));
  }
  for (std::vector<double>* distances : {&before, &after})
  {
    std::nth_element(distances->begin(),
      distances->begin() + static_cast<std::ptrdiff_t>(distances->size() / 2), distances->end());
  }
  EXPECT_LT(after[after.size() / 2], 0.55 * before[before.size() / 2]); // 0.50
}

TEST_F(NoisySheets, AreSmoothedApartFromEachOther)
{
  winding::SheetPlanes planes = this->planes(serial_);
  std::vector<Point> normals = std::move(planes.normals);
  for (std::size_t place = 0; place < places_.size(); ++place)
  {
    const bool isUp = sheetOf(places_.positions()[place]) % 2 == 0;
    normals[place] *= (normals[place][2] > 0) == isUp ? 1 : -1;
  }
  for (int round = 0; round < 3; ++round)
  {
    normals = winding::smoothedAlongSheets(places_, graph_, spacings_, normals, serial_);
  }
  std::size_t right = 0;
  for (std::size_t place = 0; place < places_.size(); ++place)
  {
    const bool isUp = sheetOf(places_.positions()[place]) % 2 == 0;
    right += (normals[place][2] > 0) == isUp;
    EXPECT_NEAR(normals[place].norm(), 1, 1e-12);
  }
  EXPECT_GT(static_cast<double>(right), 0.99 * static_cast<double>(places_.size())); // 0.997
  EXPECT_GT(steepShare(normals), 0.98);                                              // 0.995
}

TEST_F(NoisySheets, AreTheSameForAnyThreads)
{
  ShuffledThreads threads(5);
  const winding::SheetPlanes expected = this->planes(serial_), planes = this->planes(threads);
  EXPECT_EQ(planes.normals, expected.normals);
  EXPECT_EQ(planes.feet, expected.feet);
  EXPECT_EQ(winding::smoothedAlongSheets(places_, graph_, spacings_, planes.normals, threads),
    winding::smoothedAlongSheets(places_, graph_, spacings_, planes.normals, serial_));
}
