// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceTree.h"

#include "support/Serial.h"
#include "support/ShuffledThreads.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using shapes::Point;
using shapes::Random;
using shapes::serial;
using winding::SourceNode;
using winding::SourceTree;

struct Items
{
  std::string name;
  std::vector<Point> centers;
};

std::vector<Point> onLine(std::size_t count, unsigned seed)
{
  Random random(seed);
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    points.emplace_back(Point(1, 2, 3) + random(-1, 1) * Point(0.3, -0.7, 0.1));
  }
  return points;
}

std::vector<Items> manyItems()
{
  std::vector<Items> all;
  all.push_back({"none", {}});
  all.push_back({"one", {Point(1, 2, 3)}});
  all.push_back({"random", shapes::randomPoints(5000, -1, 1, 341)});
  all.push_back({"collinear", onLine(2000, 342)});

  Items clusters{"clusters 1e6 diagonals apart", shapes::randomPoints(1000, -1, 1, 343)};
  for (std::size_t i = 0; i < 1000; ++i)
  {
    clusters.centers.emplace_back(clusters.centers[i] + Point(3e6, 0, -1e6));
  }
  all.push_back(clusters);

  Items equal{"equal", std::vector<Point>(5000, Point(0.1, 0.2, 0.3))};
  all.push_back(equal);
  const std::vector<Point> others = shapes::randomPoints(1000, -1, 1, 344);
  equal.name = "many equal, some not";
  equal.centers.insert(equal.centers.begin() + 2500, others.begin(), others.end());
  all.push_back(equal);

  Items exponential{"exponentially spaced", {}};
  for (int k = 0; k < 1070; ++k)
  {
    exponential.centers.emplace_back(std::ldexp(1.0, -k), 0, 0);
  }
  all.push_back(exponential);

  Items lattice{"multiples of the least number", {}};
  Items neighbours{"neighbouring numbers", {}};
  double next = 1;
  for (int i = 0; i < 500; ++i)
  {
    lattice.centers.push_back(Point(i % 7, i % 11, i) * std::numeric_limits<double>::denorm_min());
    neighbours.centers.emplace_back(1, 1, next);
    next = std::nextafter(next, 2);
  }
  all.push_back(lattice);
  all.push_back(neighbours);

  Items huge{"as far apart as numbers go", {}};
  for (const Point& p : shapes::randomPoints(500, -0x1p1022, 0x1p1022, 345))
  {
    huge.centers.push_back(p);
  }
  all.push_back(huge);
  return all;
}

bool areEqual(const std::vector<Point>& centers, const SourceTree& tree, const SourceNode& node)
{
  for (std::uint32_t i = node.begin; i < node.end; ++i)
  {
    if (centers[tree.order()[i]] != centers[tree.order()[node.begin]])
    {
      return false;
    }
  }
  return true;
}

double longestSide(
  const std::vector<Point>& centers, const SourceTree& tree, const SourceNode& node)
{
  Eigen::AlignedBox3d box;
  for (std::uint32_t i = node.begin; i < node.end; ++i)
  {
    box.extend(centers[tree.order()[i]]);
  }
  return box.sizes().maxCoeff();
}

void checkTree(const std::vector<Point>& centers, const SourceTree& tree, std::size_t leafSize)
{
  const std::vector<SourceNode>& nodes = tree.nodes();
  // Every item stands at one place.
  std::vector<std::uint32_t> sorted = tree.order();
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::uint32_t> all(centers.size());
  std::iota(all.begin(), all.end(), 0u);
  ASSERT_EQ(sorted, all);
  ASSERT_EQ(nodes.empty(), centers.empty());
  ASSERT_EQ(tree.depthStarts().front(), 0u);
  ASSERT_EQ(tree.depthStarts().back(), nodes.size());
  if (nodes.empty())
  {
    return;
  }
  EXPECT_EQ(nodes[0].begin, 0u);
  EXPECT_EQ(nodes[0].end, centers.size());

  std::vector<int> depths(nodes.size(), -1);
  depths[0] = 0;
  std::size_t inLeaves = 0, leaves = 0;
  for (std::size_t n = 0; n < nodes.size(); ++n)
  {
    const SourceNode& node = nodes[n];
    ASSERT_LT(node.begin, node.end);
    ASSERT_GE(depths[n], 0) << "has a parent, which stands before it";
    const auto depth = static_cast<std::size_t>(depths[n]);
    ASSERT_GE(n, tree.depthStarts()[depth]);
    ASSERT_LT(n, tree.depthStarts()[depth + 1]);
    if (node.children == 0)
    {
      ++leaves;
      inLeaves += node.size();
      EXPECT_TRUE(node.size() <= leafSize || areEqual(centers, tree, node));
      continue;
    }
    ASSERT_GE(node.children, 2u);
    ASSERT_LE(node.children, 4u);
    EXPECT_GT(node.size(), leafSize);
    ASSERT_GT(node.firstChild, n);
    const double side = longestSide(centers, tree, node);
    std::uint32_t next = node.begin;
    for (std::size_t child = node.firstChild; child < node.firstChild + node.children; ++child)
    {
      ASSERT_EQ(nodes[child].begin, next);
      ASSERT_EQ(depths[child], -1) << "has one parent";
      depths[child] = depths[n] + 1;
      next = nodes[child].end;
      EXPECT_LE(longestSide(centers, tree, nodes[child]), side);
    }
    ASSERT_EQ(next, node.end);
  }
  EXPECT_EQ(inLeaves, centers.size());
  // No node has a single child.
  EXPECT_LE(nodes.size(), 2 * leaves - 1);
}

std::size_t depthOf(const SourceTree& tree)
{
  return tree.depthStarts().size() - 1;
}

} // namespace

TEST(SourceTree, KeepsItsPromises)
{
  SCOPED_TRACE("seeds 341 … 345");
  for (const Items& items : manyItems())
  {
    for (const std::size_t leafSize : {1, 12, 24, 10000})
    {
      SCOPED_TRACE(items.name + ", leaves of " + std::to_string(leafSize));
      checkTree(items.centers, SourceTree(items.centers, leafSize, serial), leafSize);
    }
  }
}

TEST(SourceTree, IsTheSameOnAnyThreads)
{
  for (const Items& items : manyItems())
  {
    SCOPED_TRACE(items.name);
    const SourceTree expected(items.centers, 3, serial);
    for (unsigned seed = 346; seed < 349; ++seed)
    {
      shapes::ShuffledThreads threads(seed);
      const SourceTree tree(items.centers, 3, threads);
      EXPECT_EQ(tree.order(), expected.order());
      EXPECT_EQ(tree.depthStarts(), expected.depthStarts());
      ASSERT_EQ(tree.nodes().size(), expected.nodes().size());
      for (std::size_t n = 0; n < tree.nodes().size(); ++n)
      {
        const SourceNode &a = tree.nodes()[n], &b = expected.nodes()[n];
        EXPECT_TRUE(a.begin == b.begin && a.end == b.end && a.firstChild == b.firstChild &&
                    a.children == b.children);
      }
    }
  }
}

TEST(SourceTree, MakesOneLeafOfEqualItems)
{
  std::vector<Point> centers(240001, Point(0.1, 0.2, 0.3));
  EXPECT_EQ(SourceTree(centers, 24, serial).nodes().size(), 1u);
  // Items at two places get one leaf for each.
  std::fill_n(centers.begin(), 100, Point(0.1, 0.2, 0.4));
  EXPECT_EQ(SourceTree(centers, 24, serial).nodes().size(), 3u);
}

TEST(SourceTree, HasFewLevelsForSourcesOfAnySizeFarApart)
{
  SCOPED_TRACE("seed 349");
  std::vector<Point> centers;
  for (const double size : {1.0, 1e-6, 1e-12})
  {
    for (const Point& p : shapes::randomPoints(2000, -size, size, 349))
    {
      centers.push_back(p);
    }
  }
  const SourceTree tree(centers, 24, serial);
  shapes::record("nodes", static_cast<double>(tree.nodes().size()));
  shapes::record("depth", static_cast<double>(depthOf(tree)));
  EXPECT_LT(tree.nodes().size(), 1200u); // measured: 612
  EXPECT_LT(depthOf(tree), 30u);         // measured: 17
}

TEST(SourceTree, TakesALevelForFourExponentiallySpacedItems)
{
  for (const Items& items : manyItems())
  {
    if (items.name == "exponentially spaced")
    {
      const SourceTree tree(items.centers, 1, serial);
      EXPECT_EQ(tree.nodes().size(), 1604u);
      EXPECT_EQ(depthOf(tree), 281u); // a quarter of 1070, and some
    }
  }
}

TEST(SourceTree, MakesChildrenOfHalfTheSizeOfFlatSources)
{
  SCOPED_TRACE("seed 350");
  std::vector<Point> centers = shapes::randomPoints(4096, -1, 1, 350);
  for (Point& p : centers)
  {
    p[2] = 0;
  }
  const SourceTree tree(centers, 16, serial);
  for (std::size_t n = 0; n < tree.depthStarts()[3]; ++n)
  {
    const SourceNode& node = tree.nodes()[n];
    EXPECT_EQ(node.children, 4u);
    const double side = longestSide(centers, tree, node);
    for (std::size_t child = node.firstChild; child < node.firstChild + node.children; ++child)
    {
      EXPECT_LT(longestSide(centers, tree, tree.nodes()[child]), 0.6 * side); // measured: 0.5
    }
  }
}
