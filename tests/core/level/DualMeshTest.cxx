// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/DualMesh.h"

#include "support/BitField.h"
#include "support/Dual.h"
#include "support/Manifold.h"
#include "support/Serial.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <bitset>
#include <map>
#include <set>

namespace
{

using namespace shapes;
using winding::DualMesh;
using winding::LevelEdges;

/// Expects that a solid's quads, whole and cut at random, are closed and manifold.
void expectManifold(const BitField& field, const winding::Grid& grid, std::uint64_t cuts)
{
  const Dual dual(field, grid, serial);
  for (const std::uint64_t cut : {std::uint64_t(0), cuts | 1})
  {
    const ManifoldFaults faults = manifoldFaults(dual.polygons(cut));
    ASSERT_FALSE(faults.any()) << faults.edges << " edges, " << faults.fans << " fans";
  }
}

/// The quads of a mesh like DualMesh without its rule for patches that come to a face twice: every
/// cell keeps its inside corners apart.
struct RulelessDual
{
  RulelessDual(const LevelEdges& edges, const winding::Grid& grid)
    : polygons(edges.size(), std::vector<std::uint32_t>(4))
  {
    for (int k = -1; k < grid.dimensions[2]; ++k)
    {
      for (int j = -1; j < grid.dimensions[1]; ++j)
      {
        winding::forCrossedCells(edges, j, k, -1, grid.dimensions[0],
          [&](int i, int inside, const winding::CellEdges& ofCell)
          {
            this->add(edges, {i, j, k},
              winding::cellPatches(inside, winding::AmbiguousFaces::insideApart), ofCell);
          });
      }
    }
    for (std::size_t edge = 0; edge < edges.size(); ++edge)
    {
      if (!edges[edge].firstIsInside)
      {
        std::reverse(polygons[edge].begin(), polygons[edge].end());
      }
    }
  }

  void add(const LevelEdges& edges, const std::array<int, 3>& cell,
    const winding::CellPatches& patches, const winding::CellEdges& ofCell)
  {
    if (patches.doubledFace >= 0)
    {
      doubled.insert({cell, patches.doubledFace});
    }
    for (std::size_t n = 0; n < ofCell.size(); ++n)
    {
      if (patches.ofEdge[n] >= 0)
      {
        const winding::GridEdge& edge = edges[ofCell[n]];
        const std::size_t u = (edge.axis + 1u) % 3, v = (edge.axis + 2u) % 3;
        const bool isBehindU = edge.sample[u] == cell[u], isBehindV = edge.sample[v] == cell[v];
        polygons[ofCell[n]][isBehindV ? (isBehindU ? 2 : 3) : (isBehindU ? 1 : 0)] =
          vertices + static_cast<std::uint32_t>(patches.ofEdge[n]);
      }
    }
    vertices += static_cast<std::uint32_t>(patches.count);
  }

  /// Whether the patches on both sides of a face come to it twice.
  bool isDoubledOnBothSides() const
  {
    return std::any_of(doubled.begin(), doubled.end(),
      [this](const auto& found)
      {
        auto neighbour = found;
        neighbour.first[static_cast<std::size_t>(found.second / 2)] += 1;
        neighbour.second -= 1;
        return found.second % 2 == 1 && doubled.count(neighbour) > 0;
      });
  }

  Polygons polygons;
  std::uint32_t vertices = 0;
  std::set<std::pair<std::array<int, 3>, int>> doubled; ///< cells with a doubled face, and the face
};

/// Calls visit(field, grid, bits) for all fields on two cells that share a face, whichever it is.
/// Stops where it fails.
template <class Visit> void forAllPairsOfCells(const Visit& visit)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    Eigen::Vector3i dimensions(2, 2, 2);
    dimensions[axis] = 3;
    const winding::Grid grid = gridOf({0, 0, 0}, {1, 1, 1}, dimensions);
    for (std::uint64_t bits = 0; bits < 4096; ++bits)
    {
      BitField field;
      setBits(field, 12, bits);
      ASSERT_NO_FATAL_FAILURE(visit(field, grid, bits))
        << std::bitset<12>(bits) << " along axis " << axis;
    }
  }
}

} // namespace

TEST(CellPatches, OfOneCellAreDiscsAndTheDoubledFaceIsTheOnlyAmbiguousOne)
{
  int doubled = 0;
  for (int inside = 0; inside < 256; ++inside)
  {
    int ambiguous = 0;
    for (int face = 0; face < 6; ++face)
    {
      const std::array<int, 4>& corners = winding::cornersOfFace(face);
      const auto isInside = [&](std::size_t n)
      {
        return (inside >> corners[n] & 1) != 0;
      };
      ambiguous +=
        isInside(0) == isInside(2) && isInside(1) == isInside(3) && isInside(0) != isInside(1);
    }
    const auto& patches = winding::cellPatches(inside, winding::AmbiguousFaces::insideApart);
    std::map<int, int> sizes;
    for (const int patch : patches.ofEdge)
    {
      sizes[patch] += 1;
    }
    sizes.erase(-1);
    EXPECT_EQ(sizes.size(), static_cast<std::size_t>(patches.count));
    for (const auto& [patch, size] : sizes)
    {
      EXPECT_TRUE(patch < patches.count && size >= 3) << inside;
    }
    if (patches.doubledFace >= 0)
    {
      ++doubled;
      EXPECT_EQ(ambiguous, 1) << inside;
      const auto& cut = winding::cellPatches(inside, winding::AmbiguousFaces::outsideApart);
      EXPECT_EQ(cut.count, patches.count + 1) << inside;
      EXPECT_EQ(cut.doubledFace, -1) << inside;
    }
  }
  // Two corners outside, on a diagonal of one of six faces; or one more next to one of these, not
  // in the face.
  EXPECT_EQ(doubled, 12 + 24);
}

/// An edge of the mesh depends on two cells that share a face and on nothing else, so this is all
/// that can happen.
TEST(DualMesh, OfAllPairsOfCellsIsClosedAndManifold)
{
  forAllPairsOfCells([](const BitField& field, const winding::Grid& grid, std::uint64_t bits)
    { expectManifold(field, grid, bits * 0x9e3779b97f4a7c15); });
}

/// The check of manifolds finds what the rule for faces prevents, and nothing else.
TEST(DualMesh, WouldNotBeManifoldWithoutItsRuleForFaces)
{
  int faulty = 0;
  forAllPairsOfCells(
    [&](const BitField& field, const winding::Grid& grid, std::uint64_t)
    {
      const Dual dual(field, grid, serial);
      const RulelessDual ruleless(dual.edges, grid);
      const bool isFaulty = manifoldFaults(ruleless.polygons).any();
      ASSERT_EQ(isFaulty, ruleless.isDoubledOnBothSides());
      ASSERT_EQ(isFaulty, ruleless.vertices != dual.mesh->size());
      if (!isFaulty)
      {
        ASSERT_EQ(ruleless.polygons, dual.polygons(0));
      }
      faulty += isFaulty;
    });
  EXPECT_EQ(faulty, 3 * 18); // 18 along each axis
}

/// The check "lattice" of the program differential tries as many as there is time for.
TEST(DualMesh, OfRandomLatticeSolidsIsClosedAndManifold)
{
  Random random(1);
  for (int n = 0; n < 1000; ++n)
  {
    const LatticeCase lattice(random);
    ASSERT_NO_FATAL_FAILURE(expectManifold(lattice.field, lattice.grid, random.bits()))
      << lattice.bits << ", " << lattice.grid.dimensions.transpose();
  }
}

TEST(DualMesh, OfLargeRandomSolidsIsClosedAndManifoldAndTheSameForAnyExecutor)
{
  const winding::Grid grid = gridOf({0, 0, 0}, {1, 1, 1}, {24, 23, 22});
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    Random random(seed);
    BitField field;
    for (int n = 0; n < grid.dimensions.prod(); ++n)
    {
      field.inside.push_back(random(0, 1) < 0.1 + 0.04 * seed);
    }
    ASSERT_NO_FATAL_FAILURE(expectManifold(field, grid, random.bits())) << seed;
    ShuffledThreads threads(seed);
    const Dual dual(field, grid, serial), again(field, grid, threads);
    EXPECT_EQ(dual.polygons(0), again.polygons(0));
    // Quads have no two diagonals, and no diagonal and side, in common.
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    std::size_t count = 0;
    for (const auto& quad : dual.polygons(0))
    {
      for (std::size_t a = 0; a < 4; ++a)
      {
        for (std::size_t b = a + 1; b < 4; ++b)
        {
          pairs.insert(std::minmax(quad[a], quad[b]));
          count += (b - a) % 2 == 0 ? 2 : 1; // each side is that of two quads
        }
      }
    }
    EXPECT_EQ(2 * pairs.size(), count);
  }
}

TEST(DualMesh, VisitsTheVerticesInOrderWithTheEdgesOfTheirPatches)
{
  const winding::Grid grid = gridOf({0, 0, 0}, {1, 1, 1}, {9, 8, 7});
  Random random(5);
  BitField field;
  for (int n = 0; n < grid.dimensions.prod(); ++n)
  {
    field.inside.push_back(random(0, 1) < 0.5);
  }
  const Dual dual(field, grid, serial);
  std::size_t expected = 0, crossings = 0;
  for (std::size_t layer = 0; layer < dual.mesh->layers(); ++layer)
  {
    dual.mesh->forVertices(layer,
      [&](std::size_t vertex, const DualMesh::Patch& patch)
      {
        EXPECT_EQ(vertex, expected++);
        for (int n = 0; n < patch.size; ++n)
        {
          const std::size_t edge = patch.edges[static_cast<std::size_t>(n)];
          const DualMesh::Quad& quad = dual.mesh->quad(edge);
          EXPECT_EQ(std::count(quad.begin(), quad.end(), vertex), 1);
          for (std::size_t axis = 0; axis < 3; ++axis)
          {
            const int off = dual.edges[edge].sample[axis] - patch.cell[axis];
            EXPECT_TRUE(off == 0 || (off == 1 && axis != dual.edges[edge].axis));
          }
          ++crossings;
        }
      });
  }
  EXPECT_EQ(expected, dual.mesh->size());
  EXPECT_EQ(crossings, 4 * dual.edges.size());
}
