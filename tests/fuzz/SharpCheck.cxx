// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FieldValues.h"
#include "RandomSources.h"

#include "level/DualMesh.h"
#include "level/LevelRoots.h"
#include "level/SharpVertices.h"
#include "report/SelfIntersections.h"
#include "support/Manifold.h"
#include "support/Serial.h"

#include <algorithm>
#include <memory>

/**
 * @file
 * Sharp surfaces of random sources, closed at the border of the grid: they are 2-manifold, their
 * vertices lie in their cells, and the bits are the same for every executor. Where no cell has two
 * patches no triangle passes through another.
 */
namespace fuzz
{

namespace
{

using namespace winding;
using shapes::serial;

/// Rounds after which a search for roots does not end.
constexpr int mostRounds = 100;

/// Everything that a sharp surface is made of.
struct Sharp
{
  Sharp(const Field& field, const Grid& grid, const InsideTest& isInside, Executor& executor)
    : edges(field, grid, isInside, true)
  {
    while (!edges.isDone())
    {
      edges.advance(executor);
    }
    roots = std::make_unique<LevelRoots>(field, grid, edges, isInside, 1e-3, executor);
    for (int round = 0; !roots->isDone() && round < mostRounds; ++round)
    {
      roots->advance(executor);
    }
    roots->addGradients(executor);
    mesh = std::make_unique<DualMesh>(grid, edges, executor);
    vertices = std::make_unique<SharpVertices>(grid, edges, &roots->roots(), *mesh, executor);
  }

  LevelEdges edges;
  std::unique_ptr<LevelRoots> roots;
  std::unique_ptr<DualMesh> mesh;
  std::unique_ptr<SharpVertices> vertices;
};

/// The triangles that quads are cut into, and the vertices with those of fans, in units of the
/// grid.
struct Cut
{
  explicit Cut(const Sharp& sharp)
    : vertices(sharp.vertices->places())
  {
    for (std::size_t edge = 0; edge < sharp.edges.size(); ++edge)
    {
      const DualMesh::Quad& quad = sharp.mesh->quad(edge);
      std::vector<std::uint32_t> corners(quad.begin(), quad.end());
      if (!sharp.edges[edge].firstIsInside)
      {
        std::reverse(corners.begin(), corners.end());
      }
      const QuadSplit split = sharp.vertices->splitOf(edge);
      if (split == QuadSplit::fan)
      {
        const auto middle = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(sharp.vertices->crossing(edge));
        for (std::size_t n = 0; n < 4; ++n)
        {
          triangles.push_back({middle, corners[n], corners[(n + 1) % 4]});
        }
        continue;
      }
      // Corners 0 and 2 are at the ends also when they come the other way round.
      const bool isReversed = !sharp.edges[edge].firstIsInside;
      const std::size_t from = (split == QuadSplit::second) != isReversed ? 1 : 0;
      std::rotate(
        corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(from), corners.end());
      triangles.push_back({corners[0], corners[1], corners[2]});
      triangles.push_back({corners[0], corners[2], corners[3]});
    }
  }

  std::vector<Eigen::Vector3d> vertices;
  shapes::Polygons triangles;
};

/// Tells what is wrong with the vertices, and sets isSingle to whether each is alone in its cell.
std::string faultOfVertices(const Sharp& sharp, bool& isSingle)
{
  constexpr double margin = 1.0 / (1 << 12);
  std::string failure;
  isSingle = true;
  for (std::size_t layer = 0; layer < sharp.mesh->layers(); ++layer)
  {
    sharp.mesh->forVertices(layer,
      [&](std::size_t vertex, const DualMesh::Patch& patch)
      {
        isSingle = isSingle && patch.isAlone;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          // Patches of a cell with several keep to boxes of their own, which may be flat.
          const double least = patch.isAlone ? margin * (1 - 1e-6) : 0;
          const double place =
            sharp.vertices->places()[vertex][static_cast<Eigen::Index>(axis)] - patch.cell[axis];
          if (!(place >= least && place <= 1 - least))
          {
            failure = "a vertex lies at " + std::to_string(place) + " of its cell";
          }
        }
      });
  }
  return failure;
}

std::size_t selfIntersections(const Cut& cut, Executor& executor)
{
  TriangleList triangles;
  for (const auto& corners : cut.triangles)
  {
    triangles.push_back({static_cast<std::int32_t>(corners[0]),
      static_cast<std::int32_t>(corners[1]), static_cast<std::int32_t>(corners[2])});
  }
  return countSelfIntersections(cut.vertices, triangles, executor);
}

} // namespace

std::string checkSharp(Choices& choices)
{
  const auto field = randomField(choices);
  if (!field || field->info().primitives == 0)
  {
    return {};
  }
  const Grid grid = randomGrid(choices, field->info().bounds);
  const InsideTest isInside = {randomRule(choices), randomThreshold(choices)};
  BackwardExecutor backward;
  const Sharp sharp(*field, grid, isInside, serial);
  const Sharp again(*field, grid, isInside, backward);
  if (!sharp.roots->isDone())
  {
    return "the search for roots does not end";
  }
  bool isSingle = true;
  const std::string failure = faultOfVertices(sharp, isSingle);
  if (!failure.empty())
  {
    return failure;
  }
  const Cut cut(sharp);
  const shapes::ManifoldFaults faults = shapes::manifoldFaults(cut.triangles);
  if (faults.any())
  {
    return std::to_string(faults.edges) + " edges and " + std::to_string(faults.fans) +
           " vertices are not manifold";
  }
  if (isSingle && selfIntersections(cut, serial) > 0)
  {
    return "triangles pass through each other, though each cell has one vertex";
  }
  const Cut cutAgain(again);
  const bool isSame = cut.vertices == cutAgain.vertices && cut.triangles == cutAgain.triangles;
  return isSame ? std::string() : "a sharp surface depends on the executor";
}

} // namespace fuzz
