// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/BitField.h"
#include "support/Manifold.h"
#include "support/Shapes.h"

#include "level/DualMesh.h"

#include <algorithm>
#include <memory>

namespace shapes
{

/// The edges and the dual mesh of a solid of samples, closed at the border of its grid.
struct Dual
{
  Dual(const BitField& field, const winding::Grid& grid, winding::Executor& executor)
    : edges(field, grid, winding::InsideTest(), true)
  {
    while (!edges.isDone())
    {
      edges.advance(executor);
    }
    mesh = std::make_unique<winding::DualMesh>(grid, edges, executor);
  }

  /// Returns the quads, facing outward. Unless `cuts` is 0, its bits say along which diagonal each
  /// is cut.
  Polygons polygons(std::uint64_t cuts) const
  {
    Polygons polygons;
    for (std::size_t edge = 0; edge < edges.size(); ++edge)
    {
      const winding::DualMesh::Quad& quad = mesh->quad(edge);
      std::vector<std::uint32_t> corners(quad.begin(), quad.end());
      if (!edges[edge].firstIsInside)
      {
        std::reverse(corners.begin(), corners.end());
      }
      if (cuts == 0)
      {
        polygons.push_back(corners);
        continue;
      }
      std::rotate(corners.begin(), corners.begin() + (cuts >> edge % 64 & 1), corners.end());
      polygons.push_back({corners[0], corners[1], corners[2]});
      polygons.push_back({corners[0], corners[2], corners[3]});
    }
    return polygons;
  }

  winding::LevelEdges edges;
  std::unique_ptr<winding::DualMesh> mesh;
};

inline void setBits(BitField& field, std::size_t count, std::uint64_t bits)
{
  field.inside.resize(count);
  for (std::size_t n = 0; n < count; ++n)
  {
    field.inside[n] = bits >> n & 1;
  }
}

/// A random solid on a grid of 2 or 3 × 2 or 3 × 3 samples.
struct LatticeCase
{
  explicit LatticeCase(Random& random)
  {
    const int i = 2 + static_cast<int>(random.bits() % 2);
    const int j = 2 + static_cast<int>(random.bits() % 2);
    grid = gridOf({0, 0, 0}, {1, 1, 1}, {i, j, 3});
    // Bits are set in 1 of 2, or in 1 of 4, or in 3 of 4.
    const std::uint64_t share = random.bits() % 3;
    bits = random.bits();
    bits = share == 0 ? bits : share == 1 ? bits & random.bits() : bits | random.bits();
    setBits(field, static_cast<std::size_t>(grid.dimensions.prod()), bits);
  }

  winding::Grid grid;
  BitField field;
  std::uint64_t bits;
};

} // namespace shapes
