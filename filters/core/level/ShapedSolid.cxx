#include "level/ShapedSolid.h"

#include "level/BandRoots.h"
#include "level/BandSamples.h"
#include "level/GridContour.h"
#include "level/SharpContour.h"
#include "source/Surface.h"

#include <algorithm>
#include <cmath>

namespace winding
{

namespace
{

/**
 * Returns whether every triangle has the inside on one side and the outside on the other. Places
 * on both sides of its middle are asked, nearer than a sixteenth of the circle in it. Triangles
 * without area do not count.
 */
bool areAllBetweenSides(
  const Field& field, const Grid& grid, InsideRule rule, double threshold, Executor& executor)
{
  const Surface& surface = *field.distinctSurface();
  const double farthest = grid.spacing.minCoeff() / 1024;
  constexpr std::size_t atOnce = 1 << 18;
  std::vector<double> places;
  std::vector<unsigned char> inside;
  for (std::size_t first = 0; first < surface.triangles.size(); first += atOnce)
  {
    places.clear();
    for (std::size_t n = first; n < std::min(first + atOnce, surface.triangles.size()); ++n)
    {
      const Triangle& t = surface.triangles[n];
      const Eigen::Vector3d a = surface.vertices[t[0]], ab = surface.vertices[t[1]] - a,
                            ac = surface.vertices[t[2]] - a;
      const Eigen::Vector3d areas = ab.cross(ac);
      const double doubled = areas.stableNorm();
      const double radius = doubled / (ab.norm() + ac.norm() + (ac - ab).norm());
      const Eigen::Vector3d step = std::min(farthest, radius / 16) * areas / doubled;
      if (step.allFinite() && !step.isZero(0))
      {
        const Eigen::Vector3d middle = a + (ab + ac) / 3;
        for (const Eigen::Vector3d& place :
          {Eigen::Vector3d(middle + step), Eigen::Vector3d(middle - step)})
        {
          places.insert(places.end(), place.data(), place.data() + 3);
        }
      }
    }
    inside.resize(places.size() / 3);
    if (inside.empty())
    {
      continue;
    }
    FieldOutput output;
    output.inside = inside.data();
    output.rule = rule;
    output.threshold = threshold;
    field.evaluate(VectorsView(places.data(), inside.size()), output, executor);
    for (std::size_t n = 0; n < inside.size(); n += 2)
    {
      if (inside[n] == inside[n + 1])
      {
        return false;
      }
    }
  }
  return true;
}

/// Makes triangles of the surface that crosses edges at their roots.
Surface surfaceOf(const Grid& grid, const LevelEdges& edges, const EdgeRoots& roots, bool isSharp,
  Executor& executor)
{
  Surface surface;
  std::vector<std::int64_t> ids;
  const auto place = [&](const auto& write, std::size_t vertices)
  {
    std::vector<double> coordinates(3 * vertices);
    write(coordinates.data());
    surface.vertices.resize(vertices);
    for (std::size_t n = 0; n < vertices; ++n)
    {
      surface.vertices[n] = Eigen::Map<const Eigen::Vector3d>(&coordinates[3 * n]);
      surface.bounds.extend(surface.vertices[n]);
    }
  };
  if (isSharp)
  {
    const SharpContour contour(grid, edges, &roots, true, executor);
    std::vector<std::int64_t> offsets(contour.polygons() + 1);
    ids.resize(contour.corners());
    contour.writePolygons(offsets.data(), ids.data(), executor);
    place([&](double* to) { contour.place(to, executor); }, contour.vertices());
  }
  else
  {
    GridContour contour(grid, edges, executor);
    ids.resize(3 * contour.triangles());
    contour.takeTriangles(ids.data(), executor);
    place([&](double* to) { contour.place(roots, to, executor); }, contour.vertices());
  }
  surface.triangles.resize(ids.size() / 3);
  for (std::size_t n = 0; n < ids.size(); ++n)
  {
    surface.triangles[n / 3][n % 3] = static_cast<std::int32_t>(ids[n]);
  }
  surface.inputTriangles = surface.triangles.size();
  return surface;
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

ShapedSolid::ShapedSolid(const Field& field, const Grid& grid, InsideRule rule, double threshold,
  const LevelEdges& solid, const EdgeRoots& roots, const SolidShape& shape, bool isSharp,
  Executor& executor)
  : edges_(&solid)
  , roots_(&roots)
{
  if (shape.fillsCavities)
  {
    filled_ = std::make_unique<FilledCavities>(solid, roots, grid, executor);
    edges_ = &filled_->edges;
    roots_ = &filled_->roots;
  }
  if (shape.hasDistances())
  {
    this->move(
      field, grid, rule, threshold, shape.band(), isSheet(field.info(), shape), isSharp, executor);
  }
}

/// Moves the surface of the solid to the limits of a band.
void ShapedSolid::move(const Field& field, const Grid& grid, InsideRule rule, double threshold,
  const DistanceBand& band, bool isSheet, bool isSharp, Executor& executor)
{
  const bool isFromSource =
    isSheet || (field.info().jumpsOnly() && this->cavities() == 0 &&
                 areAllBetweenSides(field, grid, rule, threshold, executor));
  base_ = isFromSource ? DistanceBase::source : DistanceBase::surface;
  if (!isFromSource)
  {
    surfaceTree_ = std::make_shared<const DistanceTree>(
      surfaceOf(grid, *edges_, *roots_, isSharp, executor), executor);
  }
  const DistanceTree& tree = isFromSource ? field.distanceTree(executor) : *surfaceTree_;
  const bool hasBorder = edges_->border() > 0;
  std::unique_ptr<const LevelEdges> none;
  if (isSheet)
  {
    none = noEdges(grid, hasBorder, executor);
    edges_ = none.get();
  }
  const auto [begin, end] = executor.share();
  constexpr double shareOfSamples = 0.5;
  const double middle = begin + shareOfSamples * (end - begin);
  executor.setShare(begin, middle);
  movedEdges_ = std::make_unique<const LevelEdges>(
    grid, hasBorder, BandSamples::layersAtOnce,
    [&](int first, int last) -> LevelEdges::RowRuns
    {
      const auto samples =
        std::make_shared<const BandSamples>(tree, *edges_, grid, band, first, last);
      return [samples](int j, int k, std::vector<RowRun>& runs)
      {
        samples->findRuns(j, k, runs);
      };
    },
    executor);
  executor.setShare(middle, end);
  movedRoots_ = bandRoots(tree, grid, *movedEdges_, *edges_, *roots_, band, executor);
  edges_ = movedEdges_.get();
  roots_ = &movedRoots_;
}

double ShapedSolid::bytesFor(
  const Field& field, const Grid& grid, const SolidShape& shape, double edges)
{
  constexpr double perRoot = sizeof(GridEdge) + sizeof(double) + sizeof(Eigen::Vector3f);
  double bytes = 0;
  if (shape.fillsCavities)
  {
    bytes += LevelEdges::bytesOfRows(grid) + perRoot * edges;
  }
  if (shape.hasDistances())
  {
    // The surface has two triangles and one vertex for an edge; a shell has two surfaces.
    constexpr double perTriangle = sizeof(Triangle) + 0.5 * sizeof(Eigen::Vector3d);
    const double surfaces = shape.shell > 0 ? 2 : 1;
    const double ofTree = std::max(static_cast<double>(field.expectedBytesOfDistances(0)),
      2 * edges * (perTriangle + static_cast<double>(DistanceTree::bytesFor(true, 1))));
    bytes += LevelEdges::bytesOfRows(grid) + surfaces * perRoot * edges + ofTree;
  }
  return bytes;
}

} // namespace winding
