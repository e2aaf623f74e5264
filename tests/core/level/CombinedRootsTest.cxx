// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/CombinedRoots.h"

#include "base/Executor.h"
#include "support/Serial.h"
#include "support/ShuffledThreads.h"
#include "support/SolidOnGrid.h"

#include <gtest/gtest.h>

namespace
{

using namespace shapes;
using winding::BooleanOperation;

constexpr BooleanOperation operations[] = {BooleanOperation::unite, BooleanOperation::intersect,
  BooleanOperation::subtract, BooleanOperation::exclude};

struct Operands
{
  Operands(const std::vector<Mesh>& meshes, const winding::Grid& grid, bool withBorder,
    winding::Executor& executor)
  {
    for (const Mesh& mesh : meshes)
    {
      parts.push_back(std::make_unique<SolidOnGrid>(mesh, grid, withBorder, executor));
      edges.push_back(&parts.back()->edges);
      level.push_back({&parts.back()->edges, &parts.back()->roots});
    }
  }

  bool isInside(BooleanOperation operation, const std::array<int, 3>& sample) const
  {
    std::size_t inside = 0;
    for (const winding::LevelEdges* part : edges)
    {
      inside += part->isSampleInside(sample);
    }
    const bool isInFirst = edges.front()->isSampleInside(sample);
    switch (operation)
    {
    case BooleanOperation::unite:
      return inside >= 1;
    case BooleanOperation::intersect:
      return inside == edges.size();
    case BooleanOperation::subtract:
      return isInFirst && inside < 2;
    default:
      return inside % 2 == 1;
    }
  }

  std::vector<std::unique_ptr<SolidOnGrid>> parts;
  std::vector<const winding::LevelEdges*> edges;
  std::vector<winding::LevelOperand> level;
};

} // namespace

/// Some solids reach over the border of the grid; some samples lie on faces of lattice solids.
TEST(BooleanEdges, AreThoseOfEachSamplesOwnAnswer)
{
  ShuffledThreads shuffled(1);
  std::size_t crossed = 0;
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::vector<Mesh> meshes = {surfaceOf(randomCells(3, seed)),
      surfaceOf(randomCells(3, seed + 1000)), icosphere(2).moved({1.4, 1.3, 1.6})};
    const winding::Grid grid = gridOf({0.25, -0.5, -0.5}, Point::Constant(0.25), {14, 17, 16});
    for (const bool withBorder : {false, true})
    {
      const Operands operands(meshes, grid, withBorder, serial);
      for (const BooleanOperation operation : operations)
      {
        const winding::LevelEdges edges(operands.edges, operation, grid, serial);
        const winding::LevelEdges again(operands.edges, operation, grid, shuffled);
        ASSERT_EQ(again.size(), edges.size());
        std::size_t expected = 0;
        const int first = -edges.border();
        const Eigen::Vector3i last =
          grid.dimensions + Eigen::Vector3i::Constant(edges.border() - 1);
        for (int k = first; k <= last[2]; ++k)
        {
          for (int j = first; j <= last[1]; ++j)
          {
            for (int i = first; i <= last[0]; ++i)
            {
              const std::array<int, 3> sample = {i, j, k};
              const bool isInside = operands.isInside(operation, sample);
              ASSERT_EQ(edges.isSampleInside(sample), isInside);
              for (int axis = 0; axis < 3; ++axis)
              {
                std::array<int, 3> next = sample;
                ++next[static_cast<std::size_t>(axis)];
                const bool hasNext = next[static_cast<std::size_t>(axis)] <= last[axis];
                const bool changes = hasNext && operands.isInside(operation, next) != isInside;
                const std::size_t found = hasNext ? edges.find(sample, axis) : edges.size();
                ASSERT_EQ(found < edges.size(), changes);
                if (changes)
                {
                  ASSERT_EQ(edges[found].firstIsInside, isInside);
                  ASSERT_EQ(again[found].sample, edges[found].sample);
                  ++expected;
                }
              }
            }
          }
        }
        ASSERT_EQ(edges.size(), expected);
        crossed += expected;
      }
    }
  }
  EXPECT_GT(crossed, 100000u);
}

/// Walks along every edge: the answers of all operands on it change at their roots only.
TEST(CombinedRoots, LieWhereTheAnswerChanges)
{
  ShuffledThreads shuffled(1);
  std::size_t contested = 0;
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const double shift = 0.01 * seed;
    const std::vector<Mesh> meshes = {icosphere(3), icosphere(3).moved({0.3 + shift, 0.1, 0.2}),
      cube().moved({0.05 + shift, -0.4, 0.07})};
    const winding::Grid grid = gridOf({-1.3, -1.31, -1.32}, Point::Constant(0.2), {17, 16, 15});
    const Operands operands(meshes, grid, false, serial);
    for (const BooleanOperation operation : operations)
    {
      const winding::LevelEdges edges(operands.edges, operation, grid, serial);
      const winding::CombinedRoots combined(edges, operands.level, operation, serial);
      const winding::CombinedRoots again(edges, operands.level, operation, shuffled);
      ASSERT_EQ(again.roots.fractions, combined.roots.fractions);
      ASSERT_EQ(again.operands, combined.operands);
      for (std::size_t n = 0; n < edges.size(); ++n)
      {
        const winding::GridEdge& edge = edges[n];
        const std::uint32_t operand = combined.operands[n];
        const std::size_t own = operands.edges[operand]->find(edge.sample, edge.axis);
        ASSERT_LT(own, operands.edges[operand]->size());
        const winding::EdgeRoots& roots = *operands.level[operand].roots;
        ASSERT_EQ(combined.roots.fractions[n], roots.fractions[own]);
        ASSERT_EQ(combined.roots.normals[n], roots.normals[own]);
        // Right before and behind the root, by the other operands as they are there.
        std::size_t inside = 0, changing = 0;
        bool isFirst = false, isOwn = false;
        for (std::size_t other = 0; other < operands.edges.size(); ++other)
        {
          bool is = operands.edges[other]->isSampleInside(edge.sample);
          const std::size_t found = operands.edges[other]->find(edge.sample, edge.axis);
          if (found < operands.edges[other]->size())
          {
            ++changing;
            is =
              is != (operands.level[other].roots->fractions[found] < combined.roots.fractions[n]);
          }
          inside += is;
          isFirst = other == 0 ? is : isFirst;
          isOwn = other == operand ? is : isOwn;
        }
        contested += changing > 1;
        const bool before = isInResult(operation, 3, inside, isFirst);
        const bool behind = isInResult(
          operation, 3, isOwn ? inside - 1 : inside + 1, operand == 0 ? !isFirst : isFirst);
        ASSERT_EQ(before, edge.firstIsInside);
        ASSERT_NE(behind, edge.firstIsInside);
      }
    }
  }
  EXPECT_GT(contested, 1000u);
}

/// An operand twice, and operands that share faces, leave nothing behind.
TEST(OperandOf, ATriangleIsTheOneOfTwoCornersOrOfTheFirst)
{
  const std::vector<std::uint32_t> operands = {0, 1, 2, 0, 1, 2};
  const auto of = [&operands](std::int64_t a, std::int64_t b, std::int64_t c)
  {
    const std::int64_t corners[] = {a, b, c};
    return winding::operandOf(corners, operands);
  };
  EXPECT_EQ(of(0, 3, 1), 0u);
  EXPECT_EQ(of(0, 1, 3), 0u);
  EXPECT_EQ(of(1, 0, 3), 0u);
  EXPECT_EQ(of(2, 1, 4), 1u);
  EXPECT_EQ(of(0, 1, 2), 0u);
  EXPECT_EQ(of(2, 0, 1), 2u);
}

TEST(BooleanEdges, HaveNoSlivers)
{
  // Samples lie on the faces of the cubes, or do not.
  for (const double first : {-0.5, -0.46})
  {
    const winding::Grid grid = gridOf(Point::Constant(first), Point::Constant(0.125), {40, 20, 20});
    const Mesh one = cube(), next = cube({1, 0, 0}, {2, 1, 1}), both = cube({0, 0, 0}, {2, 1, 1});
    const auto sizeOf = [&](const std::vector<Mesh>& meshes, BooleanOperation operation)
    {
      const Operands operands(meshes, grid, false, serial);
      return winding::LevelEdges(operands.edges, operation, grid, serial).size();
    };
    const Operands whole({both}, grid, false, serial), single({one}, grid, false, serial);
    EXPECT_EQ(sizeOf({one, one}, BooleanOperation::subtract), 0u);
    EXPECT_EQ(sizeOf({one, one}, BooleanOperation::exclude), 0u);
    EXPECT_EQ(sizeOf({one, one}, BooleanOperation::unite), single.edges[0]->size());
    EXPECT_EQ(sizeOf({one, next}, BooleanOperation::intersect), 0u);
    EXPECT_EQ(sizeOf({one, next}, BooleanOperation::unite), whole.edges[0]->size());
    EXPECT_EQ(sizeOf({both, next}, BooleanOperation::subtract), single.edges[0]->size());
  }
}
