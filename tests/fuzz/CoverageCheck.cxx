// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FieldValues.h"
#include "RandomSources.h"

#include "base/Refusal.h"
#include "support/NaiveDistance.h"
#include "support/Serial.h"
#include "voxels/CoverageFractions.h"
#include "voxels/TouchedVoxels.h"
#include "voxels/VoxelOverlap.h"

#include <algorithm>
#include <cmath>

/**
 * @file
 * Voxels that are touched are compared with places on the triangles, and with the distances of
 * triangles from voxels; shares of voxels with samples of the field that are counted one by one;
 * parts of grids with the whole.
 */
namespace fuzz
{

namespace
{

using namespace winding;
using shapes::Mesh;
using shapes::Point;
using shapes::serial;

std::vector<unsigned char> touchedIn(
  const Surface& surface, const Grid& grid, const Extent& extent, Executor& executor)
{
  std::vector<unsigned char> marks(sampleCount(extent));
  markTouched(surface, grid, extent, marks.data(), executor);
  return marks;
}

/// A place on a triangle: a corner, a place on a side, or inside.
Point placeOn(Choices& choices, const Surface& surface)
{
  const Triangle& t = surface.triangles[choices.below(surface.triangles.size())];
  const double u = choices.oneIn(4) ? 0 : choices.between(0, 1);
  const double v = choices.oneIn(4) ? 0 : choices.between(0, 1 - u);
  return (1 - u - v) * surface.vertices[t[0]] + u * surface.vertices[t[1]] +
         v * surface.vertices[t[2]];
}

/// Whether the voxels of places on triangles are marked.
std::string checkTouched(Choices& choices, const Surface& surface, const Grid& grid,
  const std::vector<unsigned char>& marks)
{
  for (int i = 0; i < 40; ++i)
  {
    const Point at = grid.inGridUnits(placeOn(choices, surface));
    const Point nearest = at.array().round();
    // Places near to faces of voxels may be rounded into the next one.
    const bool isWithin = ((at - nearest).cwiseAbs().array() < 0.5 - 1e-6).all() &&
                          (nearest.array() >= 0).all() &&
                          (nearest.array() < grid.dimensions.cast<double>().array()).all();
    if (isWithin && !marks[sampleNumber(grid.wholeExtent(), nearest.cast<int>())])
    {
      return "a voxel that a triangle goes through is not marked";
    }
  }
  return {};
}

/// Whether all marked voxels are near to a triangle: nearer to it than half of their diagonal.
std::string checkMarked(
  const Surface& surface, const Grid& grid, const std::vector<unsigned char>& marks)
{
  const double reach = 0.5 * grid.spacing.stableNorm();
  for (std::size_t n = 0; n < marks.size(); ++n)
  {
    const Point sample = grid.sample(n);
    double nearest = HUGE_VAL;
    for (std::size_t i = 0; marks[n] && i < surface.triangles.size() && nearest > reach; ++i)
    {
      const Triangle& t = surface.triangles[i];
      nearest = std::min(nearest, shapes::naiveDistance(sample, surface.vertices[t[0]],
                                    surface.vertices[t[1]], surface.vertices[t[2]]));
    }
    const double size = std::max(sample.cwiseAbs().maxCoeff(), surface.bounds.max().norm());
    if (marks[n] && nearest > reach * (1 + 1e-9) + 0x1p-46 * size)
    {
      return "a voxel is marked that no triangle touches";
    }
  }
  return {};
}

std::vector<float> fractionsIn(const Field& field, const Grid& grid, const Extent& extent,
  int perAxis, InsideRule rule, Executor& executor)
{
  std::vector<float> fractions(sampleCount(extent), -1);
  const CoverageFractions sampling(field, grid, extent, perAxis, {rule}, fractions.data());
  for (int part = 0; part < sampling.parts(); ++part)
  {
    sampling.evaluate(part, executor);
  }
  return fractions;
}

/// Whether shares are multiples of 1/k³ in 0 … 1, and 0 or 1 where nothing touches the voxel.
std::string checkFractions(const Field& field, const Grid& grid,
  const std::vector<float>& fractions, const std::vector<unsigned char>& marks, int perAxis)
{
  // Solid angles lose all digits at a 1e-8th of the length of an edge from it: sums, as opposed to
  // rows, do not tell the sides of samples so near to a flat source.
  const bool isFlat = grid.spacing.minCoeff() < 1e-5 * field.info().bounds.sizes().maxCoeff();
  const bool isClosed = field.info().netBoundaryEdges == 0 && (field.integerRows() || !isFlat);
  const auto samples = static_cast<double>(perAxis * perAxis * perAxis);
  for (std::size_t n = 0; n < fractions.size(); ++n)
  {
    const double counted = samples * static_cast<double>(fractions[n]);
    if (!(fractions[n] >= 0 && fractions[n] <= 1 && std::abs(counted - std::round(counted)) < 1e-3))
    {
      return "the share " + std::to_string(fractions[n]) + " of a voxel is no count of samples";
    }
    if (isClosed && !marks[n] && fractions[n] != 0 && fractions[n] != 1)
    {
      return "a voxel that no triangle touches is neither inside nor outside";
    }
  }
  return {};
}

template <class T>
std::string checkPiece(const std::string& what, const Grid& grid, const Extent& extent,
  const std::vector<T>& whole, const std::vector<T>& piece)
{
  const std::vector<std::size_t> numbers = numbersIn(grid, extent);
  for (std::size_t n = 0; n < numbers.size(); ++n)
  {
    if (piece[n] != whole[numbers[n]])
    {
      return what + " differ in a piece of the grid";
    }
  }
  return {};
}

} // namespace

std::string checkCoverage(Choices& choices)
{
  const Mesh mesh = randomMesh(choices, 16);
  FieldOptions options;
  const Method methods[] = {Method::automatic, Method::rows, Method::direct, Method::hierarchical};
  options.method = choices.oneOf(methods);
  std::shared_ptr<const Field> field;
  try
  {
    field = Field::build(viewsOf(mesh), options, serial);
  }
  catch (const Refusal&)
  {
    return {};
  }
  const Surface& surface = *field->surface();
  if (surface.triangles.empty())
  {
    return {};
  }
  const InsideRule rule = randomRule(choices);
  const Grid grid = randomGrid(choices, surface.bounds);
  const Extent whole = grid.wholeExtent(), piece = randomExtent(choices, grid);
  const int perAxis = 1 + choices.below(4);
  BackwardExecutor backward;

  const auto marks = touchedIn(surface, grid, whole, serial);
  const auto fractions = fractionsIn(*field, grid, whole, perAxis, rule, serial);
  const auto overlapIn = [&](const Extent& extent, Executor& executor)
  {
    std::vector<unsigned char> inside(sampleCount(extent));
    FieldOutput output;
    output.inside = inside.data();
    output.isInside.rule = rule;
    field->evaluate(grid, extent, output, executor);
    addOverlap(*field, grid, extent, output.isInside, inside.data(), executor);
    return inside;
  };
  const auto overlap = overlapIn(whole, serial);
  for (std::size_t n = 0; n < marks.size(); ++n)
  {
    if (marks[n] && !overlap[n])
    {
      return "a voxel that a triangle touches does not overlap";
    }
  }
  for (const std::string& failure : {checkTouched(choices, surface, grid, marks),
         checkMarked(surface, grid, marks), checkFractions(*field, grid, fractions, marks, perAxis),
         checkPiece("marks", grid, piece, marks, touchedIn(surface, grid, piece, backward)),
         checkPiece("overlaps", grid, piece, overlap, overlapIn(piece, backward)),
         checkPiece("shares", grid, piece, fractions,
           fractionsIn(*field, grid, piece, perAxis, rule, backward))})
  {
    if (!failure.empty())
    {
      return failure;
    }
  }
  return {};
}

} // namespace fuzz
