// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/SurfaceTask.h"

#include "base/Digits.h"
#include "diagnosis/GridAdvice.h"
#include "diagnosis/MendNotes.h"
#include "level/CombinedRoots.h"
#include "level/ConnectedRuns.h"
#include "level/GridContour.h"
#include "level/LevelMemory.h"
#include "level/LevelRoots.h"
#include "level/SharpContour.h"
#include "report/Hollow.h"
#include "tasks/MendedSource.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <type_traits>
#include <vector>

namespace winding
{

namespace
{

/// About what finding edges takes of the time: much where there is something to search for.
constexpr double progressOfEdges = 0.5;

/// Polygons with points.
template <class Real> struct Polygons
{
  const Real* points;
  std::size_t vertices;
  const std::int64_t *offsets, *corners; ///< corners begin at `offsets`, one more than polygons
  std::size_t count;

  Eigen::Vector3d point(std::int64_t vertex) const
  {
    return Eigen::Map<const Eigen::Matrix<Real, 3, 1>>(points + 3 * vertex).template cast<double>();
  }

  /// Calls visit(a, b, c) for the triangles of a fan.
  template <class Visit> void forEachTriangle(std::size_t polygon, const Visit& visit) const
  {
    const std::int64_t first = offsets[polygon];
    for (std::int64_t corner = first + 1; corner + 1 < offsets[polygon + 1]; ++corner)
    {
      visit(corners[first], corners[corner], corners[corner + 1]);
    }
  }
};

/// Returns the volume that polygons enclose.
template <class Real>
double volumeOf(const Grid& grid, const Polygons<Real>& polygons, Executor& executor)
{
  const Eigen::Vector3d middle = grid.sample(0, 0, 0);
  return sumOverItems(
    polygons.count,
    [&](std::size_t i, double& sum)
    {
      polygons.forEachTriangle(i,
        [&](std::int64_t a, std::int64_t b, std::int64_t c)
        {
          const Eigen::Vector3d u = polygons.point(a) - middle;
          const Eigen::Vector3d v = polygons.point(b) - middle;
          sum += u.dot(v.cross(polygons.point(c) - middle)) / 6;
        });
    },
    executor);
}

/// Returns polygons as a surface of triangles.
template <class Real> Surface triangulated(const Polygons<Real>& polygons)
{
  Surface surface;
  surface.vertices.reserve(polygons.vertices);
  for (std::size_t i = 0; i < polygons.vertices; ++i)
  {
    surface.vertices.push_back(polygons.point(static_cast<std::int64_t>(i)));
    surface.bounds.extend(surface.vertices.back());
  }
  for (std::size_t i = 0; i < polygons.count; ++i)
  {
    polygons.forEachTriangle(i,
      [&surface](std::int64_t a, std::int64_t b, std::int64_t c)
      {
        surface.triangles.push_back({static_cast<std::int32_t>(a), static_cast<std::int32_t>(b),
          static_cast<std::int32_t>(c)});
      });
  }
  return surface;
}

/// The parts and the volume of a solid that came out; the volume of an open one is NaN.
struct SolidMeasures
{
  std::size_t parts = 0, crumbs = 0;
  double volume = 0;
  double volumeRatio = 1; ///< to the volume of the operation; 1 if that is not known

  /// Returns the volume that may be compared with the source's, or 0: voxels round it.
  double comparable(const SurfaceOptions& options) const
  {
    return options.features == Features::voxels || std::isnan(volume) ? 0 : volume;
  }
};

/// The operation on solids that a surface comes from.
struct Combination
{
  const std::vector<std::uint32_t>& operands; ///< of each edge
  const ResultVolume& volume;
};

/// Measures a solid, and writes that. `expected` may be null.
template <class Real>
SolidMeasures measured(const Grid& grid, const LevelEdges& edges, bool isClosed,
  const Polygons<Real>& polygons, const ResultVolume* expected, Sink& sink, Executor& executor)
{
  const ConnectedRuns runs(grid, rowsOf(edges), 1, executor);
  const double volume = volumeOf(grid, polygons, executor);
  SolidMeasures found;
  found.parts = runs.sets();
  found.crumbs = runs.setsUpTo(ResultOnGrid::mostOfCrumb);
  found.volume = isClosed ? volume : std::numeric_limits<double>::quiet_NaN();
  // Finer results lose little, and their triangles would take as much memory again.
  constexpr std::int64_t mostCorners = 1 << 22;
  if (expected && !edges.reachesBorder() && polygons.offsets[polygons.count] <= mostCorners)
  {
    found.volumeRatio = expected->ratioOf(triangulated(polygons), volume, executor);
  }
  *sink.array<std::uint8_t>(Output::isClosed, 1) = isClosed;
  *sink.array<std::int64_t>(Output::parts, 1) = static_cast<std::int64_t>(found.parts);
  *sink.array<double>(Output::volume, 1) = found.volume;
  return found;
}

/// Writes the surface that crosses edges, and the samples inside if so wished. `findRoots` finds
/// where it crosses. Polygons of a `combination`, which may be null, get the operands of its edges.
/// Warns of a surface that is open at the border of the grid. Writes whether the surface is closed,
/// its parts and its volume, and returns the last two.
SolidMeasures writeSurface(const Grid& grid, const LevelEdges& edges,
  const std::function<const EdgeRoots&()>& findRoots, const Combination* combination,
  const SurfaceOptions& options, Sink& sink, Run& run)
{
  Executor& executor = run.executor;
  const bool isClosed = options.closesBorder || !edges.reachesBorder();
  if (options.hasImage)
  {
    edges.writeInside(
      sink.array<std::uint8_t>(Output::inside, sampleCount(grid.wholeExtent())), executor);
  }
  else if (edges.size() > 0 && (!isClosed || (options.mendsSource && edges.reachesBorder())))
  {
    run.warn(isClosed ? closedBorderNote() : openResultAdvice());
  }
  const bool areDoubles = options.pointType == PointType::automatic
                            ? needsDoublePoints(grid)
                            : options.pointType == PointType::float64;
  const auto writePoints = [&](std::size_t count, const auto& write)
  {
    return areDoubles ? write(sink.array<double>(Output::points, count))
                      : write(sink.array<float>(Output::points, count));
  };
  // Voxels lie round a solid.
  const bool isExact = options.features != Features::voxels;
  const bool isExpected = combination && isExact && combination->volume.isKnown();
  const ResultVolume* const expected = isExpected ? &combination->volume : nullptr;
  SolidMeasures found;
  const auto measure = [&](const auto* points, std::size_t vertices, const std::int64_t* offsets,
                         const std::int64_t* corners, std::size_t count)
  {
    using Real = std::decay_t<decltype(*points)>;
    const Polygons<Real> polygons = {points, vertices, offsets, corners, count};
    found = measured(grid, edges, isClosed, polygons, expected, sink, executor);
  };
  if (options.features != Features::smooth)
  {
    const EdgeRoots* const roots = options.features == Features::sharp ? &findRoots() : nullptr;
    const SharpContour contour(grid, edges, roots, options.areTriangles, executor);
    auto* const offsets = sink.array<std::int64_t>(Output::offsets, contour.polygons() + 1);
    auto* const corners = sink.array<std::int64_t>(Output::corners, contour.corners());
    contour.writePolygons(offsets, corners, executor);
    writePoints(contour.vertices(),
      [&](auto* points)
      {
        contour.place(points, executor);
        measure(points, contour.vertices(), offsets, corners, contour.polygons());
      });
    if (options.hasNormals)
    {
      contour.writeNormals(sink.array<float>(Output::polygonNormals, contour.polygons()), executor);
    }
    if (combination)
    {
      std::vector<std::uint32_t> edgeOf(contour.polygons());
      contour.writeEdges(edgeOf.data(), executor);
      std::transform(edgeOf.begin(), edgeOf.end(),
        sink.array<std::int32_t>(Output::operands, edgeOf.size()),
        [combination](std::uint32_t edge) { return combination->operands[edge]; });
    }
    return found;
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
      measure(points, contour.vertices(), offsets, corners, triangles);
    });
  if (combination)
  {
    auto* const ofTriangles = sink.array<std::int32_t>(Output::operands, triangles);
    for (std::size_t i = 0; i < triangles; ++i)
    {
      ofTriangles[i] = static_cast<std::int32_t>(operandOf(corners + 3 * i, combination->operands));
    }
  }
  return found;
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

/// Returns the wishes of a task that closes the surface at the border where it may mend.
SurfaceOptions closedIfMended(SurfaceOptions options)
{
  options.mendsSource = options.mendsSource && !options.closesBorder; // it need not be said
  options.closesBorder = options.closesBorder || options.mendsSource;
  return options;
}

/// Finds the edges of a source that is mended, as findEdges() does, and again where it was turned.
/// Warns of an open side where the inside matters.
std::unique_ptr<LevelEdges> findMendedEdges(
  MendedSource& source, const Grid& grid, const SurfaceOptions& options, Run& run)
{
  if (source.plate() == 0 && !isSheet(source.field().info(), options.shape))
  {
    warnOfOpenSide(source.field(), {options.isInside.threshold, false, !options.closesBorder}, run);
  }
  const auto [first, last] = run.executor.share();
  auto edges = findEdges(source.field(), grid, options, run);
  while (source.decide(edges->sides()))
  {
    edges.reset();
    run.executor.setShare(first, last);
    edges = findEdges(source.field(), grid, options, run);
  }
  return edges;
}

/// Makes the shape of a source a plate. Throws OutOfMemory where that does not fit.
void thicken(const Field& field, const Grid& grid, double plate, SurfaceOptions& options, Run& run)
{
  options.shape.shell = plate;
  options.shape.shellSide = ShellSide::centered;
  claimSurface(field, grid, options, run);
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

/// Returns the facts that edges show of a field.
ResultOnGrid resultOn(const LevelEdges& edges)
{
  ResultOnGrid result;
  result.sides = edges.sides();
  result.isEmpty = edges.areAllOutside();
  result.isInside = [&edges](int i, int j, int k)
  {
    return edges.isSampleInside({i, j, k});
  };
  return result;
}

/// Warns of walls of a result, or of its voids, that a grid does not show, and of a volume that is
/// off. Thin edges of a result with the volume `volume` are no loss; nothing is known of a volume
/// of 0. Returns whether there is any loss.
bool warnOfWalls(const WallSamples& walls, const Grid& grid, double volume, double volumeRatio,
  const IsSampleInside& isInside, const std::string& what, Run& run)
{
  ThinParts parts = thinPartsOf(walls, grid, isInside);
  parts.volumeRatio = volumeRatio;
  constexpr double least = 0.02;
  const bool isThin = parts.areMany() && parts.thinVolume > least * volume;
  const bool isLoss = isThin || parts.isVolumeOff();
  if (isLoss)
  {
    run.warn(thinPartsAdvice(parts, grid, false, what));
  }
  return isLoss;
}

/// Warns of walls that a shape leaves thinner than a voxel, and of voids that its shell should
/// leave in the `solid`.
void warnOfShape(const Field& field, const Grid& grid, const LevelEdges& edges,
  const LevelEdges& solid, double volume, const SurfaceOptions& options, Run& run)
{
  const DistanceBand band = options.shape.band();
  const bool isShell = options.shape.shell > 0;
  bool isLoss = false;
  const double moved = isShell ? band.low : band.high;
  if (moved < 0 && field.info().jumpsOnly())
  {
    WallSamples walls = field.diagnosis().boundingWalls(options.isInside, run.executor);
    walls.move(moved);
    isLoss = warnOfWalls(
      walls, grid, volume, 1,
      [&](int i, int j, int k) {
        return edges.isSampleInside({i, j, k}) != isShell;
      },
      isShell ? "voids" : "parts of the result", run);
  }
  if (!isLoss && isShell && band.high == 0 && edges.size() == solid.size())
  {
    run.warn({"the shell fills the solid, so there is no void",
      {{"choose a thinner shell", {Parameter::shell}}}});
  }
}

/// Warns of cavities that are not filled: openings let the outside in, or may do so. Returns
/// whether it warned.
bool warnOfOpenCavities(const Field& field, const Grid& grid, const SurfaceOptions& options,
  std::size_t cavities, Run& run)
{
  const double voxel = grid.spacing.maxCoeff(), gapWidth = options.shape.gapWidth;
  if (!options.shape.fillsCavities)
  {
    return false;
  }
  if (gapWidth > 0 && 2 * voxel > gapWidth)
  {
    run.warn({"voxels are longer than half of the gap width, so gaps may stay open",
      {smallerVoxels(), {"choose wider gaps", {Parameter::gapWidth}}},
      joined("they are ", inDigits(voxel, 3), " long")});
    return true;
  }
  if (cavities == 0)
  {
    const auto hollow = findHollow(field, options.isInside, run.executor, voxel / 2);
    if (hollow && hollow->gapWidth > gapWidth)
    {
      run.warn({"no cavity was filled", {hollow->remedy()},
        "the outside reaches in by openings up to about " + inDigits(hollow->opening, 1)});
      return true;
    }
  }
  return false;
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
  const Field& given, const Grid& grid, const SurfaceOptions& wished, Sink& sink, Run& run)
{
  SurfaceResult result;
  SurfaceOptions options = closedIfMended(wished);
  SolidShape& shape = options.shape;
  MendedSource source(given, grid,
    {wished.mendsSource && !isSheet(given.info(), shape), shape.isPlain() || shape.isShell(),
      options.isInside, shape.shell},
    run);
  const auto edges = findMendedEdges(source, grid, options, run);
  const Field& field = source.field();
  const double inputVolume = field.diagnosis().volume(run.executor);
  *sink.array<double>(Output::inputVolume, 1) =
    inputVolume != 0 ? inputVolume : std::numeric_limits<double>::quiet_NaN();
  if (source.plate() > 0)
  {
    thicken(field, grid, source.plate(), options, run);
  }
  const bool insideMatters = !isSheet(field.info(), shape);
  if (shape.isPlain() && edges->areAllInside() && !options.hasImage)
  {
    run.warn(allInsideAdvice());
  }
  ResultOnGrid onGrid = resultOn(*edges);
  if (insideMatters)
  {
    result.facing = warnOfSides(field, onGrid.sides, options.isInside, run);
  }
  // The inside of a sheet reaches the border of any grid.
  options.mendsSource = options.mendsSource && field.info().added == 0 && !result.facing.isOfSheets;
  const auto warnOfSource = [&]
  {
    if (insideMatters)
    {
      warnOfGrid(field, grid, onGrid, result.facing, options.isInside, run);
    }
  };
  EdgeRoots roots(0);
  const auto foundRoots = [&]() -> const EdgeRoots&
  {
    roots = findRoots(field, grid, *edges, options, run);
    return roots;
  };
  if (shape.isPlain())
  {
    const SolidMeasures found = writeSurface(grid, *edges, foundRoots, nullptr, options, sink, run);
    onGrid.volume = found.comparable(options);
    onGrid.pieces = found.parts;
    onGrid.crumbs = found.crumbs;
    warnOfSource();
    return result;
  }
  const ShapedSolid shaped(field, grid, options.isInside, field.info().tolerance, *edges,
    foundRoots(), shape, options.features == Features::sharp, run.executor);
  result.cavities = shaped.cavities();
  if (shaped.isTight())
  {
    run.warn({"the grid is too tight to close gaps",
      {{"choose more padding", {Parameter::padding}},
        {"choose a larger grid", {Parameter::samplingBounds}}},
      "its border is nearer to the source than half of the gap width"});
  }
  else
  {
    onGrid.withoutAdvice = warnOfOpenCavities(field, grid, options, result.cavities, run);
  }
  // Walls of cavities do not matter where gaps that lead to them are closed.
  onGrid.withoutAdvice |= shape.gapWidth > 0 && result.cavities > 0;
  result.distancesFrom = shaped.base();
  result.surfaceTree = shaped.surfaceTree();
  const bool isAllInside = shaped.edges().areAllInside();
  const auto advice = shapeAdvice(grid, shape, shaped.edges().size() == 0, isAllInside);
  if (advice && !(isAllInside && options.hasImage))
  {
    run.warn(*advice);
  }
  const double volume = writeSurface(
    grid, shaped.edges(), [&]() -> const EdgeRoots& { return shaped.roots(); }, nullptr, options,
    sink, run)
                          .comparable(options);
  onGrid.volume = shape.hasDistances() || result.cavities > 0 ? 0 : volume;
  warnOfSource();
  if (!advice && insideMatters && !result.facing.looksInward && result.cavities == 0)
  {
    warnOfShape(field, grid, shaped.edges(), *edges, volume, options, run);
  }
  return result;
}

std::string solidInWords(bool isClosed, std::int64_t parts, double volume, double inputVolume)
{
  const std::string text = std::to_string(parts) + (parts == 1 ? " part" : " parts");
  if (!isClosed)
  {
    return text + ", open";
  }
  const std::string ofInput =
    std::isfinite(inputVolume) ? " (input " + inDigits(inputVolume, 4) + ")" : "";
  return text + ", volume " + inDigits(volume, 4) + ofInput;
}

BooleanTask::BooleanTask(
  const Grid& grid, BooleanOperation operation, const SurfaceOptions& options)
  : grid_(grid)
  , operation_(operation)
  , options_(closedIfMended(options))
  , walls_(operation)
  , volume_(grid, operation)
{
}

/// Returns whether a point of a further operand may be on the surface of the result: of an
/// intersection, samples near it are inside of all operands before.
bool BooleanTask::mayBound(const Eigen::Vector3d& point) const
{
  return operation_ != BooleanOperation::intersect ||
         std::all_of(operands_.begin(), operands_.end(),
           [&](const Operand& operand)
           {
             return isInsideNear(grid_, point,
               [&](int i, int j, int k) {
                 return operand.shown().isSampleInside({i, j, k});
               });
           });
}

double BooleanTask::claim(const Field& field, const InsideTest& isInside, Run& run)
{
  options_.isInside = isInside;
  const SurfaceNeeds ofOperand = claimSurface(field, grid_, options_, run);
  return ofOperand.bytes + keptBytes_ +
         static_cast<double>(bytesOfCombinedSurface(grid_, keptEdges_ + ofOperand.edges));
}

Facing BooleanTask::add(const Field& given, const InsideTest& isInside, Run& run)
{
  options_.isInside = isInside;
  MendedSource source(given, grid_, {options_.mendsSource, true, isInside}, run);
  auto edges = findMendedEdges(source, grid_, options_, run);
  const Field& field = source.field();
  if (source.plate() > 0)
  {
    volume_.forget();
    this->keepPlate(field, source.plate(), std::move(edges), run);
    return {};
  }
  ResultOnGrid onGrid = resultOn(*edges);
  // Operands may lie outside the grid, or end there.
  onGrid.withoutAdvice = !onGrid.isEmpty || missesSource(grid_, field.info().bounds);
  isAnyLost_ |= !onGrid.withoutAdvice;
  const Facing facing = warnOfResult(field, grid_, onGrid, isInside, run);
  if (!facing.looksInward)
  {
    walls_.add(
      field.diagnosis(), isInside,
      [this](const Eigen::Vector3d& point) { return this->mayBound(point); }, run.executor);
    volume_.add(field.diagnosis(), isInside, run.executor);
  }
  else
  {
    volume_.forget();
  }
  EdgeRoots roots = findRoots(field, grid_, *edges, options_, run);
  this->keep({std::move(edges), std::move(roots), nullptr});
  return facing;
}

/// Keeps the plate of an open sheet as the next operand.
void BooleanTask::keepPlate(
  const Field& field, double plate, std::unique_ptr<const LevelEdges> edges, Run& run)
{
  SurfaceOptions options = options_;
  thicken(field, grid_, plate, options, run);
  Operand operand = {std::move(edges), EdgeRoots(0), nullptr};
  operand.plate = std::make_unique<const ShapedSolid>(field, grid_, options.isInside,
    field.info().tolerance, *operand.edges, operand.roots, options.shape,
    options.features == Features::sharp, run.executor);
  this->keep(std::move(operand));
}

/// Keeps the next operand, and counts what that takes.
void BooleanTask::keep(Operand operand)
{
  constexpr double perEdge =
    sizeof(GridEdge) + 2 * sizeof(float) + sizeof(double) + sizeof(Eigen::Vector3f);
  const auto count = static_cast<double>(operand.shown().size());
  keptBytes_ += LevelEdges::bytesOfRows(grid_) + perEdge * count;
  keptEdges_ += count;
  operands_.push_back(std::move(operand));
}

void BooleanTask::run(Sink& sink, Run& run)
{
  refuseUnlessFree(static_cast<double>(bytesOfCombinedSurface(grid_, keptEdges_)), run.freeMemory,
    "the surface of the result", {largerVoxels()});
  std::vector<const LevelEdges*> edges;
  std::vector<LevelOperand> parts;
  for (const Operand& operand : operands_)
  {
    edges.push_back(&operand.shown());
    parts.push_back({&operand.shown(), &operand.shownRoots()});
  }
  const LevelEdges result(edges, operation_, grid_, run.executor);
  const CombinedRoots combined(result, parts, operation_, run.executor);
  const Combination combination = {combined.operands, volume_};
  const SolidMeasures found = writeSurface(
    grid_, result, [&]() -> const EdgeRoots& { return combined.roots; }, &combination, options_,
    sink, run);
  const auto isInside = [&](int i, int j, int k)
  {
    return result.isSampleInside({i, j, k});
  };
  const bool isThin = !isAnyLost_ && warnOfWalls(walls_.walls(), grid_, found.comparable(options_),
                                       found.volumeRatio, isInside, "parts of the result", run);
  if (result.areAllInside() && !options_.hasImage)
  {
    run.warn(allInsideAdvice());
  }
  if (result.areAllOutside() && !isThin)
  {
    run.warn(emptyResultAdvice(operation_ != BooleanOperation::unite));
  }
}

} // namespace winding
