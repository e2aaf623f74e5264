// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/SurfaceTask.h"

#include "diagnosis/GridAdvice.h"
#include "level/CombinedRoots.h"
#include "level/GridContour.h"
#include "level/LevelMemory.h"
#include "level/LevelRoots.h"
#include "level/SharpContour.h"

#include <algorithm>
#include <functional>

namespace winding
{

namespace
{

/// About what finding edges takes of the time: much where there is something to search for.
constexpr double progressOfEdges = 0.5;

/// Writes the surface that crosses edges, and the samples inside if so wished. `findRoots` finds
/// where it crosses; `operands` are the edges' operands, which polygons get, or null. Warns of a
/// surface that is open at the border of the grid.
void writeSurface(const Grid& grid, const LevelEdges& edges,
  const std::function<const EdgeRoots&()>& findRoots, const std::vector<std::uint32_t>* operands,
  const SurfaceOptions& options, Sink& sink, Run& run)
{
  Executor& executor = run.executor;
  if (options.hasImage)
  {
    edges.writeInside(
      sink.array<std::uint8_t>(Output::inside, sampleCount(grid.wholeExtent())), executor);
  }
  else if (!options.closesBorder && edges.size() > 0 && edges.reachesBorder())
  {
    run.warn(openResultAdvice());
  }
  const bool areDoubles = options.pointType == PointType::automatic
                            ? needsDoublePoints(grid)
                            : options.pointType == PointType::float64;
  const auto writePoints = [&](std::size_t count, const auto& write)
  {
    areDoubles ? write(sink.array<double>(Output::points, count))
               : write(sink.array<float>(Output::points, count));
  };
  if (options.features != Features::smooth)
  {
    const EdgeRoots* const roots = options.features == Features::sharp ? &findRoots() : nullptr;
    const SharpContour contour(grid, edges, roots, options.areTriangles, executor);
    writePoints(contour.vertices(), [&](auto* points) { contour.place(points, executor); });
    contour.writePolygons(sink.array<std::int64_t>(Output::offsets, contour.polygons() + 1),
      sink.array<std::int64_t>(Output::corners, contour.corners()), executor);
    if (options.hasNormals)
    {
      contour.writeNormals(sink.array<float>(Output::polygonNormals, contour.polygons()), executor);
    }
    if (operands)
    {
      std::vector<std::uint32_t> edgeOf(contour.polygons());
      contour.writeEdges(edgeOf.data(), executor);
      std::transform(edgeOf.begin(), edgeOf.end(),
        sink.array<std::int32_t>(Output::operands, edgeOf.size()),
        [operands](std::uint32_t edge) { return (*operands)[edge]; });
    }
    return;
  }
  GridContour contour(grid, edges, executor);
  const std::size_t triangles = contour.triangles();
  auto* const offsets = sink.array<std::int64_t>(Output::offsets, triangles + 1);
  for (std::size_t i = 0; i <= triangles; ++i)
  {
    offsets[i] = static_cast<std::int64_t>(3 * i);
  }
  auto* const corners = sink.array<std::int64_t>(Output::corners, 3 * triangles);
  contour.takeTriangles(corners, executor);
  const EdgeRoots& roots = findRoots();
  writePoints(contour.vertices(),
    [&](auto* points)
    {
      contour.place(roots, points, executor);
      if (options.hasNormals)
      {
        contour.writeNormals(corners, points, roots.normals,
          sink.array<float>(Output::pointNormals, contour.vertices()), executor);
      }
    });
  if (operands)
  {
    auto* const ofTriangles = sink.array<std::int32_t>(Output::operands, triangles);
    for (std::size_t i = 0; i < triangles; ++i)
    {
      ofTriangles[i] = static_cast<std::int32_t>(operandOf(corners + 3 * i, *operands));
    }
  }
}

/// Finds the edges that the surface of a solid crosses, as the first half of the executor's share
/// of progress, and leaves the other half. Throws OutOfMemory where the surface does not fit.
std::unique_ptr<LevelEdges> findEdges(
  const Field& field, const Grid& grid, const SurfaceOptions& options, Run& run)
{
  const auto [first, last] = run.executor.share();
  const double length = progressOfEdges * (last - first);
  auto edges = std::make_unique<LevelEdges>(field, grid, options.isInside, options.closesBorder);
  while (!edges->isDone())
  {
    run.executor.setShare(
      first + length * edges->progress(), first + length * edges->nextProgress());
    edges->advance(run.executor);
  }
  run.executor.setShare(first + length, last);
  // The edges are counted now, however many the source's area promised.
  refuseUnlessFree(
    static_cast<double>(bytesOfLevelSurface(field, static_cast<double>(edges->size()))),
    run.freeMemory, "the surface", {largerVoxels()});
  return edges;
}

/// Finds where the surface crosses these edges, as the executor's share of progress.
EdgeRoots findRoots(const Field& field, const Grid& grid, const LevelEdges& edges,
  const SurfaceOptions& options, Run& run)
{
  LevelRoots roots(field, grid, edges, options.isInside, field.info().tolerance, run.executor);
  const auto [first, last] = run.executor.share();
  for (double progress = first; !roots.isDone();)
  {
    const double next = progress + (last - progress) / 8;
    run.executor.setShare(progress, next);
    progress = next;
    roots.advance(run.executor);
  }
  if (options.features == Features::sharp)
  {
    roots.addGradients(run.executor);
  }
  return roots.take();
}

/// Warns of what edges show of a field; `isWhole` says whether they are all of a result. Returns
/// how the source faces.
Facing warnOfEdges(const Field& field, const Grid& grid, const LevelEdges& edges,
  const SurfaceOptions& options, bool isWhole, Run& run)
{
  ResultOnGrid result;
  result.sides = edges.sides();
  result.isEmpty = edges.areAllOutside();
  // Operands may lie outside the grid, or end there.
  const bool isLost = result.isEmpty && !missesSource(grid, field.info().bounds);
  result.withoutAdvice = !isWhole && !isLost;
  result.isInside = [&edges](int i, int j, int k)
  {
    return edges.isSampleInside({i, j, k});
  };
  return warnOfResult(field, grid, result, options.isInside, run);
}

/// Warns of a source that is open on a side.
void warnOfOpenSource(const Field& field, const SurfaceOptions& options, Run& run)
{
  warnOfOpenSide(field, {options.isInside.threshold, false, !options.closesBorder}, run);
}

} // namespace

SurfaceNeeds claimSurface(
  const Field& field, const Grid& grid, const SurfaceOptions& options, Run& run)
{
  const FieldInfo& info = field.info();
  const bool hasSlabs = info.capTriangles > 0 || info.method != Method::rows;
  const double ofGrid =
    LevelEdges::bytesOfRows(grid) + (hasSlabs ? LevelEdges::bytesOfSlab(grid) : 0) +
    (options.hasImage ? static_cast<double>(sampleCount(grid.wholeExtent())) : 0);
  SurfaceNeeds needs;
  const auto setEdges = [&](double edges)
  {
    needs.edges = edges;
    needs.bytes = ofGrid + static_cast<double>(bytesOfLevelSurface(field, edges)) +
                  ShapedSolid::bytesFor(field, grid, options.shape, edges);
  };
  setEdges(levelEdgesByArea(field, grid));
  if (!isFree(needs.bytes, run.freeMemory))
  {
    const auto [first, last] = run.executor.share();
    run.executor.setShare(first, first);
    setEdges(std::min(needs.edges,
      levelEdgesByCoarseGrid(field, grid, options.isInside, options.closesBorder, run.executor)));
    run.executor.setShare(first, last);
  }
  refuseUnlessFree(needs.bytes, run.freeMemory, "the surface", {largerVoxels()});
  return needs;
}

SurfaceResult makeSurface(
  const Field& field, const Grid& grid, const SurfaceOptions& options, Sink& sink, Run& run)
{
  SurfaceResult result;
  const SolidShape& shape = options.shape;
  const bool insideMatters = !isSheet(field.info(), shape);
  if (insideMatters)
  {
    warnOfOpenSource(field, options, run);
  }
  const auto edges = findEdges(field, grid, options, run);
  if (shape.isPlain() && edges->areAllInside() && !options.hasImage)
  {
    run.warn(allInsideAdvice());
  }
  if (insideMatters)
  {
    result.facing = warnOfEdges(field, grid, *edges, options, true, run);
  }
  EdgeRoots roots(0);
  const auto foundRoots = [&]() -> const EdgeRoots&
  {
    roots = findRoots(field, grid, *edges, options, run);
    return roots;
  };
  if (shape.isPlain())
  {
    writeSurface(grid, *edges, foundRoots, nullptr, options, sink, run);
    return result;
  }
  const ShapedSolid shaped(field, grid, options.isInside, field.info().tolerance, *edges,
    foundRoots(), shape, options.features == Features::sharp, run.executor);
  result.cavities = shaped.cavities();
  result.distancesFrom = shaped.base();
  result.surfaceTree = shaped.surfaceTree();
  const bool isAllInside = shaped.edges().areAllInside();
  const auto advice = shapeAdvice(grid, shape, shaped.edges().size() == 0, isAllInside);
  if (advice && !(isAllInside && options.hasImage))
  {
    run.warn(*advice);
  }
  writeSurface(
    grid, shaped.edges(), [&]() -> const EdgeRoots& { return shaped.roots(); }, nullptr, options,
    sink, run);
  return result;
}

BooleanTask::BooleanTask(
  const Grid& grid, BooleanOperation operation, const SurfaceOptions& options)
  : grid_(grid)
  , operation_(operation)
  , options_(options)
{
}

double BooleanTask::claim(const Field& field, const InsideTest& isInside, Run& run)
{
  options_.isInside = isInside;
  const SurfaceNeeds ofOperand = claimSurface(field, grid_, options_, run);
  return ofOperand.bytes + keptBytes_ +
         static_cast<double>(bytesOfCombinedSurface(grid_, keptEdges_ + ofOperand.edges));
}

Facing BooleanTask::add(const Field& field, const InsideTest& isInside, Run& run)
{
  options_.isInside = isInside;
  warnOfOpenSource(field, options_, run);
  auto edges = findEdges(field, grid_, options_, run);
  const Facing facing = warnOfEdges(field, grid_, *edges, options_, false, run);
  EdgeRoots roots = findRoots(field, grid_, *edges, options_, run);
  constexpr double perEdge =
    sizeof(GridEdge) + 2 * sizeof(float) + sizeof(double) + sizeof(Eigen::Vector3f);
  const auto count = static_cast<double>(edges->size());
  keptBytes_ += LevelEdges::bytesOfRows(grid_) + perEdge * count;
  keptEdges_ += count;
  operands_.push_back({std::move(edges), std::move(roots)});
  return facing;
}

void BooleanTask::run(Sink& sink, Run& run)
{
  refuseUnlessFree(static_cast<double>(bytesOfCombinedSurface(grid_, keptEdges_)), run.freeMemory,
    "the surface of the result", {largerVoxels()});
  std::vector<const LevelEdges*> edges;
  std::vector<LevelOperand> parts;
  for (const Operand& operand : operands_)
  {
    edges.push_back(operand.edges.get());
    parts.push_back({operand.edges.get(), &operand.roots});
  }
  const LevelEdges result(edges, operation_, grid_, run.executor);
  const CombinedRoots combined(result, parts, operation_, run.executor);
  writeSurface(
    grid_, result, [&]() -> const EdgeRoots& { return combined.roots; }, &combined.operands,
    options_, sink, run);
  if (result.areAllInside() && !options_.hasImage)
  {
    run.warn(allInsideAdvice());
  }
  if (result.areAllOutside())
  {
    run.warn(emptyResultAdvice(operation_ != BooleanOperation::unite));
  }
}

} // namespace winding
