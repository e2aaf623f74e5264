#include "level/LevelRoots.h"

#include "base/Executor.h"
#include "base/Views.h"
#include "core/support/LatticeChain.h"
#include "core/support/ShuffledThreads.h"
#include "source/Surface.h"

#include <gtest/gtest.h>

namespace
{

using namespace shapes;
using winding::Field;
using winding::InsideRule;

/// The edges of a grid on which a field crosses its level, and the roots on them.
struct Roots
{
  Roots(const Field& field, const winding::Grid& grid, InsideRule rule, winding::Executor& executor)
    : edges(field, grid, rule, 0.5, false)
  {
    while (!edges.isDone())
    {
      EXPECT_TRUE(edges.advance(executor));
    }
    roots = std::make_unique<winding::LevelRoots>(field, grid, edges, rule, 0.5, 0.0, executor);
    while (!roots->isDone())
    {
      EXPECT_TRUE(roots->advance(executor));
    }
  }

  winding::LevelEdges edges;
  std::unique_ptr<winding::LevelRoots> roots;
};

} // namespace

/// Many samples lie on the surface, where w is that of either side; roots may be right beside such
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
    winding::SerialExecutor serial;
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
      EXPECT_EQ(found.roots->fractions(), again.roots->fractions());
      EXPECT_EQ(found.roots->normals(), again.roots->normals());
      for (std::size_t i = 0; i < found.edges.size(); ++i)
      {
        const winding::GridEdge& edge = found.edges[i];
        const double root = found.roots->fractions()[i];
        ++roots;
        withNormal += found.roots->normals()[i].norm() > 0;
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
          EXPECT_EQ(winding::isInside(w, rule, 0.5), edge.firstIsInside == (side < 0))
            << "edge " << i << " along " << int(edge.axis) << ", root " << root << ", w " << w;
        }
      }
    }
  }
  EXPECT_GT(checked, 1000u);
  EXPECT_GT(10 * withNormal, 8 * roots);
}
