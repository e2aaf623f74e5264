// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/NodeAcceptance.h"
#include "base/Pi.h"

#include "farfield/Expansions.h"
#include "farfield/MultipoleKernels.h"
#include "sums/SolidAngle.h"
#include "support/Samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace
{

using shapes::Point;
using shapes::Random;
using winding::CellCriteria;
using winding::Expansion;
using winding::NodeCriteria;

NodeCriteria randomNodes(std::size_t count, Random& random)
{
  NodeCriteria nodes;
  nodes.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    nodes.x[i] = static_cast<float>(random(-1, 1));
    nodes.y[i] = static_cast<float>(random(-1, 1));
    nodes.z[i] = static_cast<float>(random(-1, 1));
    nodes.radius[i] = static_cast<float>(random(0.01, 0.3));
    nodes.rho[i] = static_cast<float>(random(0, 0.8));
    nodes.tau[i] = static_cast<float>(random(0, 2));
    nodes.splitRadius[i] = i % 3 == 0 ? -1 : nodes.radius[i];
  }
  return nodes;
}

/// The class of a node by the header's formulas, in double; null where rounding decides.
const char* classOf(const NodeCriteria& nodes, std::size_t i, const CellCriteria& cell)
{
  const double d = Point(cell.x - nodes.x[i], cell.y - nodes.y[i], cell.z - nodes.z[i]).norm();
  const double needed = std::max({(nodes.radius[i] + cell.radius) * double(cell.inverseTheta),
    cell.radius + double(cell.momentMargin) * nodes.radius[i], double(cell.radius) + nodes.rho[i],
    nodes.radius[i] + double(nodes.tau[i]) * cell.reach});
  if (std::abs(d - needed) < 1e-6)
  {
    return nullptr;
  }
  return d > needed ? "accepted" : nodes.splitRadius[i] > cell.splitRadius ? "split" : "kept";
}

winding::FarFieldAccuracy accuracyOf(int order, double epsilon)
{
  return {order, 0.5f, static_cast<float>(epsilon)};
}

/// A node of dipoles within a distance of 1 from its centre.
struct Node
{
  std::vector<Point> positions, moments;
  Expansion exact;
  NodeCriteria criteria;
  double radius;

  Node(int order, double epsilon, double size, bool isFlat, Random& random)
    : exact(static_cast<std::size_t>(winding::coefficientCount(order)))
    , radius(size)
  {
    const Point normal = random.direction();
    const int count = isFlat ? 100 : 1 + static_cast<int>(random.bits() % 30);
    for (int i = 0; i < count; ++i)
    {
      Point p = random.direction() * std::sqrt(random(0, 1));
      Point n = random.direction();
      if (isFlat)
      {
        // The points are pairs on either side of the centre: symmetric patches lose every other
        // degree.
        p -= p.dot(normal) * normal;
        p = i % 2 ? Point(-positions.back() / size) : p;
        n = normal;
      }
      // The moments come from a patch of a surface that fills the node, or from as strong a set
      // of points.
      positions.push_back(size * p);
      moments.push_back(n * (winding::pi * size * size / (4 * winding::pi) / count));
      winding::addDipole(order, p, moments.back() / size, exact);
    }
    criteria.resize(1);
    criteria.radius[0] = static_cast<float>(size);
    std::vector<float> floats(exact.begin(), exact.end());
    criteria.setErrors(0, accuracyOf(order, epsilon), {floats.data(), 0, 0});
    for (int k = 0; k <= order; ++k)
    {
      for (int at = k * k; at < (k + 1) * (k + 1); ++at)
      {
        exact[static_cast<std::size_t>(at)] *= std::pow(size, k);
      }
    }
  }

  double at(const Point& q) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      sum += winding::dipoleSolidAngle<double>(positions[i] - q, moments[i], 1.0);
    }
    return sum;
  }
};

} // namespace

TEST(NodeAcceptance, SortsAnyNumberOfCandidates)
{
  SCOPED_TRACE("seed 361");
  Random random(361);
  const NodeCriteria nodes = randomNodes(200, random);
  std::size_t found[3] = {};
  for (std::size_t count = 0; count <= 50; ++count)
  {
    for (int repeat = 0; repeat < 20; ++repeat)
    {
      const auto number = [&](double low, double high)
      {
        return static_cast<float>(random(low, high));
      };
      const CellCriteria cell{number(-1, 1), number(-1, 1), number(-1, 1), number(0, 0.3),
        number(0, 0.3), number(1, 2), number(1, 3), number(0, 0.3)};
      // The array holds exactly `count` candidates, and nothing may be read beyond them.
      const std::unique_ptr<std::int32_t[]> candidates(new std::int32_t[count]);
      std::vector<std::int32_t> expected[3];
      bool isClear = true;
      for (std::size_t i = 0; i < count; ++i)
      {
        candidates[i] = static_cast<std::int32_t>(random.bits() % 200);
        const char* name = classOf(nodes, static_cast<std::size_t>(candidates[i]), cell);
        isClear = isClear && name;
        expected[!name || *name == 'a' ? 0 : *name == 's' ? 1 : 2].push_back(candidates[i]);
      }
      std::vector<std::int32_t> to[3];
      for (auto& list : to)
      {
        list.resize(count + winding::nodeListSlack, -7);
      }
      winding::NodeLists lists{to[0].data(), to[1].data(), to[2].data()};
      winding::classifyNodes(nodes, cell, candidates.get(), count, lists);
      if (isClear)
      {
        to[0].resize(lists.acceptedCount);
        to[1].resize(lists.splitCount);
        to[2].resize(lists.keptCount);
        for (int i = 0; i < 3; ++i)
        {
          ASSERT_EQ(to[i], expected[i]) << count << ", list " << i;
          found[i] += to[i].size();
        }
      }
    }
  }
  shapes::record("accepted", static_cast<double>(found[0]));
  EXPECT_GT(found[0], 10000u); // measured: 22727
  EXPECT_GT(found[1], 500u);   // measured: 998
  EXPECT_GT(found[2], 1000u);  // measured: 1775
}

TEST(NodeAcceptance, KeepsTheErrorNearItsEstimate)
{
  SCOPED_TRACE("seed 362");
  for (const bool isFlat : {false, true})
  {
    Random random(362);
    double largest = 0;
    std::size_t byError = 0;
    for (int i = 0; i < 600; ++i)
    {
      const int order = 3 + 2 * static_cast<int>(random.bits() % 4);
      const double theta = random(0.4, 0.8);
      const double epsilon = std::exp2(random(-4 - 2 * order, -4 - order));
      const Node node(order, epsilon, std::exp2(random(-6, 3)), isFlat, random);
      // The cell is as near as can be accepted.
      const double radius = node.radius * std::exp2(random(-3, 2));
      const double reach = CellCriteria::reachOf(order, radius);
      const double byAngle = (node.radius + radius) / theta;
      const double needed = std::max({byAngle, radius + (2 / theta - 1) * node.radius,
        radius + double(node.criteria.rho[0]), node.radius + double(node.criteria.tau[0]) * reach});
      byError += needed > byAngle;
      const Point center = needed * random.direction();
      const Expansion local = winding::momentsToLocal(order, node.exact, center);
      for (int s = 0; s < 20; ++s)
      {
        const Point q = radius * (s == 0 ? Point(-center.normalized()) : random.direction());
        const double error = winding::localAt(order, local, q) - node.at(center + q);
        largest = std::max(largest, std::abs(error) / epsilon);
      }
    }
    shapes::record(isFlat ? "flat" : "any", largest);
    EXPECT_LT(largest, isFlat ? 2 : 4); // measured: 0.64 and 1.76
    shapes::record(isFlat ? "flat by error" : "any by error", static_cast<double>(byError));
    EXPECT_GT(byError, 100u); // measured: 390 and 440
  }
}

TEST(NodeAcceptance, OfNodesWithoutAreaIsByTheAngleAlone)
{
  NodeCriteria criteria;
  criteria.resize(1);
  criteria.radius[0] = 1;
  const std::vector<float> moments(static_cast<std::size_t>(winding::coefficientCount(5)), 0.0f);
  criteria.setErrors(0, accuracyOf(5, 1e-3), {moments.data(), 0, 0});
  EXPECT_EQ(criteria.rho[0], 0);
  EXPECT_EQ(criteria.tau[0], 0);
  // Nodes whose sources are spread must be farther away than their radius and that length.
  criteria.setErrors(0, accuracyOf(5, 1e-3), {moments.data(), 0, 3.5});
  EXPECT_EQ(criteria.rho[0], 4.5f);
  EXPECT_EQ(criteria.tau[0], 0);
}
