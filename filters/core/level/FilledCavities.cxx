// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/FilledCavities.h"

#include "level/BandRoots.h"
#include "level/BandSamples.h"
#include "level/CombinedRoots.h"
#include "level/ConnectedRuns.h"
#include "level/LevelSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace winding
{

namespace
{

/// Sets the runs of a row with value 0 to 1 where they are in cavities, and joins equal ones.
/// `areCavities` says which are, for the first run of the row with that value and all after it.
void fill(const char* areCavities, std::vector<RowRun>& runs)
{
  std::size_t last = 0;
  for (std::size_t n = 0; n < runs.size(); ++n)
  {
    RowRun run = runs[n];
    if (run.value == 0)
    {
      run.value = *areCavities++ != 0;
    }
    if (n > 0 && runs[last].value == run.value)
    {
      runs[last].end = run.end;
    }
    else
    {
      last = n > 0 ? last + 1 : 0;
      runs[last] = run;
    }
  }
  runs.resize(last + 1);
}

/// Makes the edges of a solid from its rows.
std::unique_ptr<const LevelEdges> edgesOf(
  const Grid& grid, bool hasBorder, const LevelEdges::RowRuns& rows, Executor& executor)
{
  return std::make_unique<const LevelEdges>(
    grid, hasBorder, 1, [&](int, int) { return rows; }, executor);
}

/// Combines two descriptions of a row by the values of both.
template <class Combination>
std::vector<RowRun> combined(
  const std::vector<RowRun>& a, const std::vector<RowRun>& b, const Combination& valueOf)
{
  std::vector<RowRun> runs;
  for (std::size_t m = 0, n = 0; m < a.size() && n < b.size();)
  {
    const int begin = std::max(a[m].begin, b[n].begin), end = std::min(a[m].end, b[n].end);
    const int value = valueOf(a[m].value, b[n].value);
    if (!runs.empty() && runs.back().value == value)
    {
      runs.back().end = end;
    }
    else
    {
      runs.push_back({begin, end, value});
    }
    m += a[m].end == end;
    n += b[n].end == end;
  }
  return runs;
}

/// Finds the sets of runs that hold a run with a mark. `rows` are these runs with value 1; the
/// marked ones are those with value 0 of `others`, whose indices are `marks`'. Returns by run
/// whether its set does.
std::vector<char> setsWithMark(const Grid& grid, const ConnectedRuns& sets,
  const LevelEdges::RowRuns& rows, const ConnectedRuns& others,
  const LevelEdges::RowRuns& otherRows, const std::vector<char>& marks)
{
  std::vector<char> haveMark(sets.size(), 0);
  std::vector<RowRun> runs, marked;
  for (int k = 0; k < grid.dimensions[2]; ++k)
  {
    for (int j = 0; j < grid.dimensions[1]; ++j)
    {
      rows(j, k, runs);
      otherRows(j, k, marked);
      std::size_t n = others.firstOf(j, k);
      for (RowRun& run : marked)
      {
        run.value = run.value == 0 && marks[n++] != 0;
      }
      n = sets.firstOf(j, k);
      auto mark = marked.begin();
      for (const RowRun& run : runs)
      {
        if (run.value == 0)
        {
          continue;
        }
        for (; mark->end <= run.begin; ++mark)
        {
        }
        for (auto other = mark; other != marked.end() && other->begin < run.end; ++other)
        {
          haveMark[sets.setOf(n)] |= static_cast<char>(other->value);
        }
        ++n;
      }
    }
  }
  for (std::size_t n = 0; n < haveMark.size(); ++n)
  {
    haveMark[n] = haveMark[sets.setOf(n)];
  }
  return haveMark;
}

std::vector<char> negated(std::vector<char> flags)
{
  for (char& flag : flags)
  {
    flag = flag == 0;
  }
  return flags;
}

/// Returns whether all samples at the border of a grid that are outside of a solid are outside of a
/// thicker one, too.
bool reachesAround(const LevelEdges& solid, const LevelEdges& thick, const Grid& grid)
{
  const Eigen::Vector3i last = grid.dimensions.array() - 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int i = 0; i <= last[u]; ++i)
    {
      for (int j = 0; j <= last[v]; ++j)
      {
        for (const int end : {0, last[axis]})
        {
          std::array<int, 3> sample;
          sample[static_cast<std::size_t>(axis)] = end;
          sample[static_cast<std::size_t>(u)] = i;
          sample[static_cast<std::size_t>(v)] = j;
          if (thick.isSampleInside(sample) && !solid.isSampleInside(sample))
          {
            return false;
          }
        }
      }
    }
  }
  return true;
}

} // namespace

FilledCavities::FilledCavities(const LevelEdges& solid, const EdgeRoots& solidRoots,
  const Grid& grid, double gapWidth, const DistanceTree* tree, Executor& executor)
{
  const bool hasBorder = solid.border() > 0;
  const ConnectedRuns outside(grid, rowsOf(solid), 0, executor);
  const std::vector<char> areSealed = negated(outside.reachBorder());
  const auto fillSealed = [&]
  {
    for (std::size_t n = 0; n < areSealed.size(); ++n)
    {
      count += areSealed[n] != 0 && outside.setOf(n) == n;
    }
    edges = edgesOf(
      grid, hasBorder,
      [&](int j, int k, std::vector<RowRun>& runs)
      {
        solid.findRuns(j, k, runs);
        fill(areSealed.data() + outside.firstOf(j, k), runs);
      },
      executor);
    // All edges are the solid's own, so these are the roots of a union of one.
    roots = CombinedRoots(*edges, {{&solid, &solidRoots}}, BooleanOperation::unite, executor).roots;
  };
  if (!(gapWidth > 0))
  {
    fillSealed();
    return;
  }
  const double distance = std::hypot(gapWidth, grid.spacing.maxCoeff()) / 2;
  DistanceBand outward, inward;
  outward.high = distance;
  inward.high = -distance;
  // The outside spreads away from the surface.
  const auto thickEdges = bandEdges(*tree, solid, grid, outward, executor);
  const LevelEdges& thick = *thickEdges;
  const ConnectedRuns around(grid, rowsOf(thick), 0, executor);
  const std::vector<char> areCores = negated(around.reachBorder());
  if (!reachesAround(solid, thick, grid))
  {
    // Nothing says what is outside where the border is near the surface.
    isTight = true;
    fillSealed();
    return;
  }
  const auto unreached = edgesOf(
    grid, hasBorder,
    [&](int j, int k, std::vector<RowRun>& runs)
    {
      thick.findRuns(j, k, runs);
      fill(areCores.data() + around.firstOf(j, k), runs);
    },
    executor);
  const EdgeRoots unreachedRoots =
    bandRoots(*tree, grid, *unreached, solid, solidRoots, outward, executor);
  // It grows back.
  const DistanceTree growthTree(
    surfaceOf(grid, *unreached, unreachedRoots, false, executor), executor);
  const auto outsideSolid = edgesOf(
    grid, hasBorder,
    [&](int j, int k, std::vector<RowRun>& runs)
    {
      std::vector<RowRun> ofSolid, ofUnreached;
      solid.findRuns(j, k, ofSolid);
      unreached->findRuns(j, k, ofUnreached);
      runs = combined(ofSolid, ofUnreached, [](int inside, int within) { return within > inside; });
    },
    executor);
  const auto betweenEdges = bandEdges(growthTree, *outsideSolid, grid, inward, executor);
  const LevelEdges::RowRuns findBetween = rowsOf(*betweenEdges);
  const ConnectedRuns between(grid, findBetween, 1, executor);
  std::vector<char> areCavities =
    setsWithMark(grid, between, findBetween, around, rowsOf(thick), areCores);
  const std::vector<char> areAnyway =
    setsWithMark(grid, between, findBetween, outside, rowsOf(solid), areSealed);
  for (std::size_t n = 0; n < areCavities.size(); ++n)
  {
    areCavities[n] |= areAnyway[n];
    count += areCavities[n] != 0 && between.setOf(n) == n;
  }
  edges = edgesOf(
    grid, hasBorder,
    [&](int j, int k, std::vector<RowRun>& runs)
    {
      std::vector<RowRun> ofSolid, ofCavities;
      findBetween(j, k, ofCavities);
      std::size_t n = between.firstOf(j, k);
      for (RowRun& run : ofCavities)
      {
        run.value = run.value != 0 && areCavities[n++] != 0;
      }
      solid.findRuns(j, k, ofSolid);
      runs = combined(ofSolid, ofCavities, [](int inside, int filled) { return inside | filled; });
    },
    executor);
  roots = bandRoots(growthTree, grid, *edges, *unreached, unreachedRoots, inward, executor, &solid);
  // The result has the solid's own surface wherever that crosses an edge.
  forEachItem(
    edges->size(),
    [&](std::size_t n)
    {
      const std::size_t own = solid.find((*edges)[n].sample, (*edges)[n].axis);
      if (own < solid.size())
      {
        roots.fractions[n] = solidRoots.fractions[own];
        roots.normals[n] = solidRoots.normals[own];
      }
    },
    executor);
}

double FilledCavities::bytesFor(const Grid& grid, double edges)
{
  const double rows =
    static_cast<double>(grid.dimensions[1]) * static_cast<double>(grid.dimensions[2]);
  // A row has one run more than it has cavities and solids between them.
  constexpr double perRun = 2 * sizeof(int) + sizeof(std::int32_t) + 2 * sizeof(char);
  return rows * sizeof(std::size_t) + (rows + edges) * perRun;
}

} // namespace winding
