// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/LevelRoots.h"

#include "base/Executor.h"
#include "base/Views.h"
#include "source/Surface.h"
#include "support/Fields.h"
#include "support/LatticeChain.h"
#include "support/RowValues.h"
#include "support/Serial.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

namespace
{

using namespace shapes;
using winding::Field;
using winding::InsideRule;
using winding::InsideTest;

/// The edges of a grid on which a field crosses its level, and the roots on them.
struct Roots
{
  Roots(const Field& field, const winding::Grid& grid, InsideRule rule, winding::Executor& executor)
    : edges(field, grid, {rule}, false)
  {
    while (!edges.isDone())
    {
      edges.advance(executor);
    }
    roots =
      std::make_unique<winding::LevelRoots>(field, grid, edges, InsideTest{rule}, 0.0, executor);
    while (!roots->isDone())
    {
      roots->advance(executor);
    }
  }

  winding::LevelEdges edges;
  std::unique_ptr<winding::LevelRoots> roots;
};

} // namespace

/// Many samples lie on the surface, where w is that of either side; roots may be right next to such
/// samples.
TEST(LevelRoots, OfClosedLatticeChainsAreWhereTheFieldJumpsOverTheLevel)
{
  constexpr double beside = 1.0 / (1 << 12);
  std::size_t checked = 0, withNormal = 0, roots = 0;
  for (unsigned seed = 0; seed < 400; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const LatticeChain chain = randomLatticeChain(seed, 12, 3);
    const winding::Surface& surface = chain.surface;
    if (!chain.isExact || surface.triangles.empty())
    {
      continue;
    }
    const winding::TrianglesView view{{surface.vertices[0].data(), surface.vertices.size()},
      {surface.triangles[0].data(), surface.triangles.size()}};
    for (const auto method : {winding::Method::automatic, winding::Method::direct})
    {
      winding::FieldOptions options;
      options.method = method;
      const auto field = Field::build(std::vector<winding::TrianglesView>{view}, options, serial);
      if (field->info().netBoundaryEdges != 0)
      {
        continue;
      }
      const InsideRule rule = static_cast<InsideRule>(seed % 3);
      const Roots found(*field, chain.grid, rule, serial);
      ShuffledThreads threads(seed);
      const Roots again(*field, chain.grid, rule, threads);
      EXPECT_EQ(found.roots->roots().fractions, again.roots->roots().fractions);
      EXPECT_EQ(found.roots->roots().normals, again.roots->roots().normals);
      for (std::size_t i = 0; i < found.edges.size(); ++i)
      {
        const winding::GridEdge& edge = found.edges[i];
        const double root = found.roots->roots().fractions[i];
        ++roots;
        withNormal += found.roots->roots().normals[i].norm() > 0;
        for (const double side : {-beside, beside})
        {
          Eigen::Vector3d steps(edge.sample[0], edge.sample[1], edge.sample[2]);
          steps[edge.axis] += root + side;
          const auto w = static_cast<double>(winding::referenceSum<long double>(
            surface, chain.grid.firstSample + steps.cwiseProduct(chain.grid.spacing)));
          if (root + side <= 0 || root + side >= 1 || std::abs(w - std::round(w)) > 1e-6)
          {
            continue; // the sample is on another edge, or in a face
          }
          ++checked;
          EXPECT_EQ(InsideTest{rule}(w), edge.firstIsInside == (side < 0))
            << "edge " << i << " along " << int(edge.axis) << ", root " << root << ", w " << w;
        }
      }
    }
  }
  EXPECT_GT(checked, 1000u);
  EXPECT_GT(10 * withNormal, 8 * roots);
}

TEST(LevelRoots, NeedNoEvaluationWhereASingleCrossingExplainsTheChange)
{
  // Ray parity falls from 1 to 0 at the inner sphere, where w rises from 1 to 2.
  const Mesh mesh = icosphere(2).with(icosphere(2).scaled(0.51));
  const winding::Grid grid = gridOf({-1.1, -1.12, -1.13}, {0.201, 0.203, 0.204}, {12, 12, 12});
  for (const auto method :
    {winding::Method::automatic, winding::Method::direct, winding::Method::parity})
  {
    const auto field = fieldOf(mesh, method);
    winding::LevelEdges edges(*field, grid, InsideTest(), false);
    while (!edges.isDone())
    {
      edges.advance(serial);
    }
    EXPECT_GT(edges.size(), 300u);
    const winding::LevelRoots roots(*field, grid, edges, InsideTest(), 0.0, serial);
    EXPECT_TRUE(roots.isDone()) << winding::nameOf(method);
  }
}

TEST(LevelRoots, BesideSamplesOnFacesHaveTheNormalsOfTheFaces)
{
  // Samples 1 and 4 lie on faces, though in units of the grid rounding puts some of these faces
  // next to them.
  const winding::Grid grid = gridOf({0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {6, 6, 6});
  const Point low = grid.sample(1, 1, 1), high = grid.sample(4, 4, 4);
  ASSERT_GT(grid.inGridUnits(low)[0], 1);
  const Mesh mesh = cube(low, high);
  const auto field = fieldOf(mesh, winding::Method::direct);
  const Roots found(*field, grid, InsideRule::signedThreshold, serial);
  std::size_t onFaces = 0;
  for (std::size_t i = 0; i < found.edges.size(); ++i)
  {
    const winding::GridEdge& edge = found.edges[i];
    const int j = edge.sample[(edge.axis + 1) % 3], k = edge.sample[(edge.axis + 2) % 3];
    if (j > 1 && j < 4 && k > 1 && k < 4)
    {
      ++onFaces;
      Eigen::Vector3f normal = Eigen::Vector3f::Zero();
      normal[edge.axis] = edge.firstIsInside ? 1 : -1;
      EXPECT_EQ(found.roots->roots().normals[i], normal)
        << edge.sample[edge.axis] << " " << j << " " << k;
    }
  }
  EXPECT_EQ(onFaces, 24u);
}
