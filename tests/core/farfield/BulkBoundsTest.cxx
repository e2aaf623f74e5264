// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/BulkBounds.h"

#include "base/Bounds.h"
#include "base/FieldOutput.h"
#include "cloud/PointAreas.h"
#include "farfield/FarField.h"
#include "source/PointCloud.h"
#include "sums/ReferenceSum.h"
#include "support/Places.h"
#include "support/Samples.h"
#include "support/Serial.h"

#include <gtest/gtest.h>

namespace
{

using namespace shapes;

double longest(const winding::Bounds& bounds)
{
  return bounds.sizes().maxCoeff();
}
} // namespace

TEST(BulkBounds, AreTheBoundsOfWhatHasNoOutliers)
{
  SCOPED_TRACE("seed 85");
  for (const auto& points :
    {sphereCloud(1000).positions, randomPoints(10'000, -3, 7, 85), randomPoints(10, 0, 1, 85),
      std::vector<Point>(500, Point(1, 2, 3)), randomPoints(100, 0, 1e-309, 85)})
  {
    const winding::Bounds bounds = boundsOf(points),
                          bulk = winding::bulkBounds(points, bounds, serial);
    EXPECT_EQ(bulk.min(), bounds.min());
    EXPECT_EQ(bulk.max(), bounds.max());
  }
  EXPECT_TRUE(winding::bulkBounds({}, winding::Bounds(), serial).isEmpty());
}

TEST(BulkBounds, LeaveOutliersOut)
{
  std::vector<Point> points = sphereCloud(5000).positions;
  for (const double distance : {1e3, 1e6, 1e30, 1e300})
  {
    points.push_back({-distance, 0, distance});
    const winding::Bounds bounds = boundsOf(points);
    const double size = longest(winding::bulkBounds(points, bounds, serial));
    EXPECT_GE(size, 2);
    // Much smaller units would take the outlier out of the range of single precision.
    EXPECT_GE(size, 0.999e-7 * longest(bounds)) << distance; // measured: 1e-7 from 1e30 on
    EXPECT_LE(size, std::max(16.0, 1e-6 * distance)) << distance;
  }
}

TEST(BulkBounds, KeepTheFarFieldFastAndRightBesideAFarOutlier)
{
  SCOPED_TRACE("seed 86");
  Cloud cloud = sphereCloud(20'000);
  cloud.positions.push_back({3e6, 1e6, -2e6});
  cloud.normals.push_back({1, 0, 0});
  winding::PointCloud clean = shapes::clean(cloud);
  clean.areas =
    winding::voronoiAreas(clean, placesOf(clean.positions), winding::defaultNeighbors, serial);
  const auto accuracy = winding::FarFieldAccuracy::of(1e-4);
  const winding::FarField field(
    winding::farFieldSources(clean, clean.areas, serial), accuracy, serial);
  const std::vector<Point> around = randomPoints(4000, -1.5, 1.5, 86);
  std::vector<Point> aroundOutlier, between;
  for (const Point& sample : around)
  {
    aroundOutlier.push_back(cloud.positions.back() + sample);
    between.push_back(1e5 * sample);
  }
  for (const auto& [name, samples] : {std::pair(std::string("around"), around),
         std::pair(std::string("aroundOutlier"), aroundOutlier),
         std::pair(std::string("between"), between)})
  {
    std::vector<double> values(samples.size());
    winding::FieldOutput output;
    output.doubleValues = values.data();
    winding::FarFieldWork work;
    field.evaluate({samples[0].data(), samples.size()}, output, serial, &work);
    double worst = 0;
    for (std::size_t i = 0; i < samples.size(); i += 4)
    {
      worst = std::max(
        worst, std::abs(values[i] - winding::referenceSum<double>(clean, clean.areas, samples[i])));
    }
    record(name + "Worst", worst);
    EXPECT_LT(worst, 1e-4); // measured: 1.5e-5
    const double pairs = static_cast<double>(work.exactPairs) / static_cast<double>(samples.size());
    record(name + "PairsPerSample", pairs);
    EXPECT_LT(pairs, 1000); // measured: 521, of 20 001 points
  }
}
