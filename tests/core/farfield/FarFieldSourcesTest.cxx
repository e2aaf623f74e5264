// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/FarFieldSources.h"
#include "source/SourceTree.h"
#include "source/Surface.h"
#include "support/FarFields.h"
#include "support/Serial.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace
{

using namespace shapes;
using winding::FarFieldSources;

constexpr std::uint32_t count = 20000; // several blocks of items

/// Makes sources and puts them in the order of their tree.
using Make = std::function<std::unique_ptr<FarFieldSources>(winding::Executor&)>;

std::unique_ptr<FarFieldSources> arranged(const Make& make, winding::Executor& executor)
{
  std::unique_ptr<FarFieldSources> sources = make(executor);
  const winding::SourceTree tree(sources->centers(executor), sources->leafSize(), executor,
    [&](std::uint32_t a, std::uint32_t b) { return sources->isBefore(a, b); });
  sources->arrange(tree.order(), true, executor);
  return sources;
}

/// Compares sources made on one thread with those made on several: their dipoles and their sums,
/// the latter in the precision that they are summed in, have the same bits.
void compareThreads(const Make& make)
{
  ShuffledThreads threads(361);
  const auto one = arranged(make, serial), several = arranged(make, threads);
  EXPECT_EQ(one->scale(), several->scale());
  ASSERT_EQ(one->wholeSize(), several->wholeSize());
  std::vector<FarFieldSources::Dipole> expected, found;
  one->appendDipoles({0, count}, 3, expected);
  several->appendDipoles({0, count}, 3, found);
  ASSERT_EQ(expected.size(), found.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    ASSERT_EQ(expected[i].position, found[i].position) << i;
    ASSERT_EQ(expected[i].moment, found[i].moment) << i;
  }
  winding::SampleBlock samples;
  samples.count = 2;
  samples.set(0, one->scale() * Point(0.1, 0.2, 0.3));
  samples.set(1, one->scale() * Point(3, 2, 1));
  double sums[2], others[2];
  one->sum(one->whole(), samples, sums, nullptr);
  several->sum(several->whole(), samples, others, nullptr);
  EXPECT_EQ(sums[0], others[0]);
  EXPECT_EQ(sums[1], others[1]);
  EXPECT_NE(sums[0], sums[1]);
}

} // namespace

TEST(FarFieldSources, OfPointsAreTheSameForAnyThreads)
{
  SCOPED_TRACE("seed 362");
  winding::PointCloud cloud = clean(randomCloud(count, 362));
  const std::vector<double> areas(count, 1e-3);
  const Make make = [&](winding::Executor& executor)
  {
    return winding::farFieldSources(cloud, areas, executor);
  };
  compareThreads(make);
  Random random(363);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    cloud.regularizationLengths.push_back(random(0.01, 0.1));
  }
  compareThreads(make);
}

TEST(FarFieldSources, OfTrianglesAreTheSameForAnyThreads)
{
  SCOPED_TRACE("seed 364");
  const winding::Surface surface = clean(triangleSoup(count, 364));
  compareThreads(
    [&](winding::Executor& executor)
    {
      return winding::farFieldSources(
        surface.vertices, surface.triangles, surface.bounds, {}, executor);
    });
}
