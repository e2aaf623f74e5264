// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/ShapedSolid.h"

#include "base/Refusal.h"
#include "level/BandRoots.h"
#include "level/BandSamples.h"
#include "level/LevelRoots.h"
#include "level/LevelSurface.h"
#include "source/Surface.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <utility>

namespace winding
{

namespace
{

/// The number of parts that a triangle's sides are cut into, so that points of it are no farther
/// apart than `distance`.
double partsOf(const Surface& surface, const Triangle& ids, double distance)
{
  const Eigen::Vector3d &a = surface.vertices[ids[0]], &b = surface.vertices[ids[1]],
                        &c = surface.vertices[ids[2]];
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  return std::max(1.0, std::ceil(longest / distance));
}

/// Returns the distance at which to look at points of triangles: two voxels, or more where that
/// would make too many.
double distanceOfPlaces(const Surface& surface, double voxel)
{
  constexpr double most = 1 << 20;
  double places = 0;
  for (const Triangle& ids : surface.triangles)
  {
    const double parts = partsOf(surface, ids, 2 * voxel);
    places += parts > 1 ? parts * parts : 0;
  }
  return 2 * voxel * std::max(1.0, std::sqrt(places / most));
}

/// Adds places on both sides of a triangle, at points no farther apart than about `distance`. They
/// lie nearer to it than a 1024th of a voxel, and than a sixteenth of the circle in each part.
/// Triangles without area have none.
void addSidesOf(const Surface& surface, const Triangle& ids, double voxel, double distance,
  std::vector<double>& to)
{
  const Eigen::Vector3d a = surface.vertices[ids[0]], ab = surface.vertices[ids[1]] - a,
                        ac = surface.vertices[ids[2]] - a;
  const Eigen::Vector3d areas = ab.cross(ac);
  const double doubled = areas.stableNorm(), parts = partsOf(surface, ids, distance);
  const double radius = doubled / (ab.norm() + ac.norm() + (ac - ab).norm()) / parts;
  const Eigen::Vector3d step = std::min(voxel / 1024, radius / 16) * areas / doubled;
  if (!step.allFinite() || step.isZero(0))
  {
    return;
  }
  const auto add = [&](double u, double v)
  {
    const Eigen::Vector3d middle = a + (u / parts) * ab + (v / parts) * ac;
    for (const Eigen::Vector3d& place :
      {Eigen::Vector3d(middle + step), Eigen::Vector3d(middle - step)})
    {
      to.insert(to.end(), place.data(), place.data() + 3);
    }
  };
  constexpr double third = 1.0 / 3;
  for (double i = 0; i < parts; ++i)
  {
    for (double j = 0; i + j < parts; ++j)
    {
      add(i + third, j + third);
      if (i + j + 1 < parts)
      {
        add(i + 2 * third, j + 2 * third);
      }
    }
  }
}

/// Returns whether every triangle has the inside on one side and the outside on the other, at
/// points about two voxels apart.
bool areAllBetweenSides(
  const Field& field, const Grid& grid, const InsideTest& isInside, Executor& executor)
{
  const Surface& surface = *field.distinctSurface();
  const double voxel = grid.spacing.minCoeff(), distance = distanceOfPlaces(surface, voxel);
  constexpr std::size_t atOnce = 3 << 18;
  std::vector<double> places;
  std::vector<unsigned char> inside;
  for (std::size_t n = 0; n < surface.triangles.size();)
  {
    places.clear();
    for (; n < surface.triangles.size() && places.size() < atOnce; ++n)
    {
      addSidesOf(surface, surface.triangles[n], voxel, distance, places);
    }
    inside.resize(places.size() / 3);
    if (inside.empty())
    {
      continue;
    }
    FieldOutput output;
    output.inside = inside.data();
    output.isInside = isInside;
    field.evaluate(VectorsView(places.data(), inside.size()), output, executor);
    for (std::size_t place = 0; place < inside.size(); place += 2)
    {
      if (inside[place] == inside[place + 1])
      {
        return false;
      }
    }
  }
  return true;
}

/// Returns a grid of as many voxels over a source as `grid` has over the result, which reaches
/// beyond it; none where its voxels would hardly be smaller.
std::optional<Grid> gridOverSource(const Grid& grid, const Bounds& source)
{
  constexpr double worthwhile = 0.9, padding = 1.1;
  if (source.isEmpty())
  {
    return std::nullopt;
  }
  const Eigen::Vector3d lengths = grid.spacing.cwiseProduct(grid.dimensions.cast<double>());
  const double share = padding * source.sizes().cwiseQuotient(lengths).maxCoeff();
  if (!(share > 0 && share < worthwhile))
  {
    return std::nullopt;
  }
  Grid finer;
  finer.spacing = share * grid.spacing;
  finer.dimensions =
    (source.sizes().cwiseQuotient(finer.spacing).array().ceil() + 4).matrix().cast<int>();
  finer.firstSample =
    source.center() -
    0.5 * (finer.dimensions.array() - 1).matrix().cast<double>().cwiseProduct(finer.spacing);
  try
  {
    checkGrid(finer);
  }
  catch (const Refusal&)
  {
    return std::nullopt;
  }
  return finer;
}

/// Returns the tree of the source that gaps are measured in; null where none are closed.
const DistanceTree* treeForGaps(const Field& field, const SolidShape& shape, Executor& executor)
{
  return shape.gapWidth > 0 ? &field.distanceTree(executor) : nullptr;
}

/// A solid on a grid, and the same without its cavities.
struct FilledOnGrid
{
  const Grid& grid;
  const LevelEdges &solid, &filled;
};

/// Returns whether a solid has the same cavities on another grid. There the sample nearest to the
/// middle of each outside run must be inside if the run is in a cavity, and in no cavity if not.
bool haveSameCavities(const FilledOnGrid& given, const FilledOnGrid& other, Executor& executor)
{
  std::atomic<bool> areSame(true);
  runBlocks(
    static_cast<std::size_t>(given.grid.dimensions[2]), 1,
    [&](std::size_t layer, std::size_t, std::size_t)
    {
      const int k = static_cast<int>(layer);
      std::vector<RowRun> runs;
      for (int j = 0; j < given.grid.dimensions[1]; ++j)
      {
        given.solid.findRuns(j, k, runs);
        for (const RowRun& run : runs)
        {
          const int i = run.begin + (run.end - run.begin) / 2;
          const Eigen::Vector3d place = other.grid.inGridUnits(given.grid.sample(i, j, k));
          const Eigen::Array3i nearest = place.array()
                                           .max(-1)
                                           .min(other.grid.dimensions.array().cast<double>())
                                           .round()
                                           .cast<int>();
          if (run.value != 0 || (nearest < 0).any() ||
              (nearest >= other.grid.dimensions.array()).any())
          {
            continue;
          }
          const std::array<int, 3> sample = {nearest[0], nearest[1], nearest[2]};
          const bool isInside = other.filled.isSampleInside(sample);
          const bool isSame = given.filled.isSampleInside({i, j, k})
                                ? isInside
                                : !isInside || other.solid.isSampleInside(sample);
          if (!isSame)
          {
            areSame = false;
          }
        }
      }
    },
    executor);
  return areSame;
}

/// Makes the surface of the solid of a field on a grid, by all that it takes; none where its
/// cavities are others than those on the `given` grid.
std::optional<Surface> surfaceOn(const Grid& grid, const Field& field, const InsideTest& isInside,
  double tolerance, const SolidShape& shape, bool isSharp, const FilledOnGrid& given,
  Executor& executor)
{
  LevelEdges edges(field, grid, isInside, true);
  while (!edges.isDone())
  {
    edges.advance(executor);
  }
  LevelRoots search(field, grid, edges, isInside, tolerance, executor);
  while (!search.isDone())
  {
    search.advance(executor);
  }
  if (isSharp)
  {
    search.addGradients(executor);
  }
  const EdgeRoots roots = search.take();
  if (!shape.fillsCavities)
  {
    return surfaceOf(grid, edges, roots, isSharp, executor);
  }
  const FilledCavities filled(
    edges, roots, grid, shape.gapWidth, treeForGaps(field, shape, executor), executor);
  if (!haveSameCavities(given, {grid, edges, *filled.edges}, executor))
  {
    return std::nullopt;
  }
  return surfaceOf(grid, *filled.edges, filled.roots, isSharp, executor);
}

/// Returns the edges of a solid without a sample.
std::unique_ptr<const LevelEdges> noEdges(const Grid& grid, bool withBorder, Executor& executor)
{
  const auto rowRuns = [&grid](int, int, std::vector<RowRun>& runs)
  {
    runs.assign(1, {0, grid.dimensions[0], 0});
  };
  return std::make_unique<const LevelEdges>(
    grid, withBorder, 64, [&](int, int) { return rowRuns; }, executor);
}

} // namespace

bool isSheet(const FieldInfo& info, const SolidShape& shape)
{
  return shape.shell > 0 && shape.shellSide == ShellSide::centered && shape.offset == 0 &&
         !shape.fillsCavities && info.isSurface && !info.jumpsOnly();
}

ShapedSolid::ShapedSolid(const Field& field, const Grid& grid, const InsideTest& isInside,
  double tolerance, const LevelEdges& solid, const EdgeRoots& roots, const SolidShape& shape,
  bool isSharp, Executor& executor)
  : edges_(&solid)
  , roots_(&roots)
{
  if (shape.fillsCavities)
  {
    filled_ = std::make_unique<FilledCavities>(
      solid, roots, grid, shape.gapWidth, treeForGaps(field, shape, executor), executor);
    edges_ = filled_->edges.get();
    roots_ = &filled_->roots;
  }
  if (shape.hasDistances())
  {
    this->move(field, grid, isInside, tolerance, solid, shape, isSharp, executor);
  }
}

/// Moves the surface of the solid to the limits of its band.
void ShapedSolid::move(const Field& field, const Grid& grid, const InsideTest& isInside,
  double tolerance, const LevelEdges& solid, const SolidShape& shape, bool isSharp,
  Executor& executor)
{
  const DistanceBand band = shape.band();
  const auto [begin, end] = executor.share();
  const bool isSheet = winding::isSheet(field.info(), shape);
  executor.setShare(begin, begin);
  const bool isFromSource = isSheet || (field.info().jumpsOnly() && this->cavities() == 0 &&
                                         areAllBetweenSides(field, grid, isInside, executor));
  base_ = isFromSource ? DistanceBase::source : DistanceBase::surface;
  if (!isFromSource)
  {
    // A hole that one grid closes may be open on the other. The given one decides.
    const auto finer = gridOverSource(grid, field.info().bounds);
    std::optional<Surface> surface;
    if (finer)
    {
      surface = surfaceOn(
        *finer, field, isInside, tolerance, shape, isSharp, {grid, solid, *edges_}, executor);
    }
    surfaceTree_ = std::make_shared<const DistanceTree>(
      surface ? std::move(*surface) : surfaceOf(grid, *edges_, *roots_, isSharp, executor),
      executor);
  }
  const DistanceTree& tree = isFromSource ? field.distanceTree(executor) : *surfaceTree_;
  const bool hasBorder = edges_->border() > 0;
  std::unique_ptr<const LevelEdges> none;
  if (isSheet)
  {
    none = noEdges(grid, hasBorder, executor);
    edges_ = none.get();
  }
  constexpr double shareOfSamples = 0.5;
  const double middle = begin + shareOfSamples * (end - begin);
  executor.setShare(begin, middle);
  movedEdges_ = bandEdges(tree, *edges_, grid, band, executor);
  executor.setShare(middle, end);
  movedRoots_ = bandRoots(tree, grid, *movedEdges_, *edges_, *roots_, band, executor);
  edges_ = movedEdges_.get();
  roots_ = &movedRoots_;
}

double ShapedSolid::bytesFor(
  const Field& field, const Grid& grid, const SolidShape& shape, double edges)
{
  constexpr double perRoot = sizeof(GridEdge) + sizeof(double) + sizeof(Eigen::Vector3f);
  // The surface has two triangles and one vertex for an edge.
  constexpr double perTriangle = sizeof(Triangle) + 0.5 * sizeof(Eigen::Vector3d);
  double bytes = 0;
  if (shape.fillsCavities)
  {
    const double solids = shape.gapWidth > 0 ? 4 : 1; // with what is near them, and hulls
    bytes += solids * (LevelEdges::bytesOfRows(grid) + perRoot * edges) +
             FilledCavities::bytesFor(grid, edges);
    if (shape.gapWidth > 0)
    {
      bytes += static_cast<double>(field.expectedBytesOfDistances(0)) +
               2 * edges * (perTriangle + static_cast<double>(DistanceTree::bytesFor(true, 1)));
    }
  }
  if (shape.hasDistances())
  {
    if (const auto finer = gridOverSource(grid, field.info().bounds))
    {
      // Its surface is finer by the square of the voxels.
      edges *= std::pow(grid.spacing.maxCoeff() / finer->spacing.maxCoeff(), 2);
      bytes += LevelEdges::bytesOfRows(*finer) + LevelEdges::bytesOfSlab(*finer) + perRoot * edges;
    }
    const double surfaces = shape.shell > 0 ? 2 : 1;
    const double ofTree = std::max(static_cast<double>(field.expectedBytesOfDistances(0)),
      2 * edges * (perTriangle + static_cast<double>(DistanceTree::bytesFor(true, 1))));
    bytes += LevelEdges::bytesOfRows(grid) + surfaces * perRoot * edges + ofTree;
  }
  return bytes;
}

} // namespace winding
