// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation.h"
#include "Handles.h"
#include "diagnosis/GridAdvice.h"
#include "level/CombinedRoots.h"
#include "level/GridContour.h"
#include "level/LevelMemory.h"
#include "level/LevelRoots.h"
#include "level/ShapedSolid.h"
#include "level/SharpContour.h"
#include "messages/PropertyChecks.h"
#include "report/Fidelity.h"
#include "voxels/BlockSurface.h"

#include <algorithm>
#include <functional>
#include <memory>

using namespace winding::c;
using winding::Field;
using winding::Grid;

namespace
{

winding_surface_options defaultSurfaceOptions()
{
  winding_surface_options options = {};
  options.size = sizeof options;
  options.features = WINDING_FEATURES_SMOOTH;
  options.generate_normals = 1;
  return options;
}

/// Sizes the points of a mesh, in the precision that is wanted, and has `write` write them.
template <class Write>
void writePoints(winding_mesh& mesh, std::size_t count, bool areDoubles, const Write& write)
{
  if (areDoubles)
  {
    mesh.doublePoints.resize(3 * count);
    write(mesh.doublePoints.data());
  }
  else
  {
    mesh.floatPoints.resize(3 * count);
    write(mesh.floatPoints.data());
  }
}

/// Makes the offsets of polygons of `corners` corners each.
void writeOffsets(winding_mesh& mesh, std::size_t polygons, std::int64_t corners)
{
  mesh.offsets.resize(polygons + 1);
  for (std::size_t i = 0; i <= polygons; ++i)
  {
    mesh.offsets[i] = corners * static_cast<std::int64_t>(i);
  }
}

/// A share of the progress of a call.
struct Share
{
  double begin = 0, end = 1;

  double at(double part) const { return begin + part * (end - begin); }
};

void setShare(Call& call, const Share& share, double begin, double end)
{
  call.executor.setShare(share.at(begin), share.at(end));
}

/// The surface between inside and outside of a field, for one call.
class LevelSurface
{
public:
  LevelSurface(const winding_field& handle, const Grid& grid, const winding_rule& rule,
    const winding_surface_options& options, Call& call, Share share = {})
    : handle_(handle)
    , field_(*handle.field)
    , grid_(grid)
    , rule_(rule)
    , options_(options)
    , call_(call)
    , share_(share)
    , edges_(field_, grid, ruleOf(rule), rule.winding_threshold, options.close_border != 0)
  {
  }

  /// Finds the edges of the grid that the surface crosses.
  void findEdges()
  {
    while (!edges_.isDone())
    {
      setShare(call_, share_, 0.5 * edges_.progress(), 0.5 * edges_.nextProgress());
      edges_.advance(call_.executor);
    }
  }

  /// Warns of what the edges say of the field; `isWhole` says whether it is a whole result, and
  /// `isLast` whether its surface is.
  void warn(bool isWhole, bool isLast)
  {
    const bool isAllInside = edges_.areAllInside();
    if (isAllInside && isLast && !options_.generate_image)
    {
      call_.warn(winding::allInsideAdvice());
    }
    ResultOnGrid result;
    result.sides = edges_.sides();
    result.isEmpty = edges_.size() == 0 && !isAllInside;
    result.mayCloseBorder = options_.close_border == 0;
    // Operands may lie beyond the grid, or end there.
    const bool isLost = result.isEmpty && !winding::missesSource(grid_, field_.info().bounds);
    result.withoutAdvice = !isWhole && !isLost;
    result.isInside = [this](int i, int j, int k)
    {
      return edges_.isSampleInside({i, j, k});
    };
    warnOfResult(handle_, grid_, result, rule_, call_);
  }

  /// Finds where the surface crosses the edges.
  const winding::EdgeRoots& findRoots()
  {
    winding::LevelRoots roots(field_, grid_, edges_, ruleOf(rule_), rule_.winding_threshold,
      handle_.tolerance, call_.executor);
    for (double progress = 0.5; !roots.isDone();)
    {
      const double next = progress + (1 - progress) / 8;
      setShare(call_, share_, progress, next);
      progress = next;
      roots.advance(call_.executor);
    }
    if (options_.features == WINDING_FEATURES_SHARP)
    {
      roots.addGradients(call_.executor);
    }
    roots_ = roots.take();
    return roots_;
  }

  /// Makes the shape of the solid, whose roots are found, and warns of what it lost.
  winding::ShapedSolid shaped(const winding::SolidShape& shape)
  {
    setShare(call_, share_, 0.5, 1);
    winding::ShapedSolid made(field_, grid_, ruleOf(rule_), rule_.winding_threshold,
      handle_.tolerance, edges_, roots_, shape, options_.features == WINDING_FEATURES_SHARP,
      call_.executor);
    const bool isEmpty = made.edges().size() == 0;
    const bool isAllInside = made.edges().areAllInside();
    const auto advice = winding::shapeAdvice(grid_, shape, isEmpty, isAllInside);
    if (advice && !(isAllInside && options_.generate_image))
    {
      call_.warn(*advice);
    }
    return made;
  }

  const winding::LevelEdges& edges() const { return edges_; }
  const winding::EdgeRoots& roots() const { return roots_; }

private:
  const winding_field& handle_;
  const Field& field_;
  const Grid& grid_;
  const winding_rule& rule_;
  const winding_surface_options& options_;
  Call& call_;
  Share share_;
  winding::LevelEdges edges_;
  winding::EdgeRoots roots_ = winding::EdgeRoots(0);
};

/// Writes the surface that crosses edges, and which samples are inside if so wished. `findRoots`
/// finds where it crosses; `operands` are numbers of the edges that polygons get, or null. Warns of
/// a surface that is open at the border of the grid.
void writeSurface(const Grid& grid, const winding::LevelEdges& edges,
  const std::function<const winding::EdgeRoots&()>& findRoots,
  const std::vector<std::uint32_t>* operands, const winding_surface_options& options, Call& call,
  winding_mesh& mesh)
{
  if (options.generate_image)
  {
    mesh.inside.resize(winding::sampleCount(grid.wholeExtent()));
    edges.writeInside(mesh.inside.data(), call.executor);
  }
  else if (!options.close_border && edges.size() > 0 && edges.reachesBorder())
  {
    call.warn(winding::openResultAdvice());
  }
  const bool areDoubles =
    options.type == 0 ? winding::needsDoublePoints(grid) : options.type == WINDING_FLOAT64;
  if (options.features != WINDING_FEATURES_SMOOTH)
  {
    const winding::EdgeRoots* const roots =
      options.features == WINDING_FEATURES_SHARP ? &findRoots() : nullptr;
    const winding::SharpContour contour(
      grid, edges, roots, options.generate_triangles != 0, call.executor);
    writePoints(mesh, contour.vertices(), areDoubles,
      [&](auto* points) { contour.place(points, call.executor); });
    mesh.offsets.resize(contour.polygons() + 1);
    mesh.corners.resize(contour.corners());
    contour.writePolygons(mesh.offsets.data(), mesh.corners.data(), call.executor);
    if (options.generate_normals)
    {
      mesh.polygonNormals.resize(3 * contour.polygons());
      contour.writeNormals(mesh.polygonNormals.data(), call.executor);
    }
    if (operands)
    {
      std::vector<std::uint32_t> edgeOf(contour.polygons());
      contour.writeEdges(edgeOf.data(), call.executor);
      mesh.numbers.resize(edgeOf.size());
      std::transform(edgeOf.begin(), edgeOf.end(), mesh.numbers.begin(),
        [operands](std::uint32_t edge) { return (*operands)[edge]; });
    }
    return;
  }
  winding::GridContour contour(grid, edges, call.executor);
  mesh.corners.resize(3 * contour.triangles());
  writeOffsets(mesh, contour.triangles(), 3);
  contour.takeTriangles(mesh.corners.data(), call.executor);
  const winding::EdgeRoots& roots = findRoots();
  writePoints(mesh, contour.vertices(), areDoubles,
    [&](auto* points)
    {
      contour.place(roots, points, call.executor);
      if (options.generate_normals)
      {
        mesh.pointNormals.resize(3 * contour.vertices());
        contour.writeNormals(
          mesh.corners.data(), points, roots.normals, mesh.pointNormals.data(), call.executor);
      }
    });
  if (operands)
  {
    mesh.numbers.resize(contour.triangles());
    for (std::size_t triangle = 0; triangle < mesh.numbers.size(); ++triangle)
    {
      mesh.numbers[triangle] = winding::operandOf(&mesh.corners[3 * triangle], *operands);
    }
  }
}

winding::SolidShape shapeOf(const winding_surface_options& options)
{
  winding::SolidShape shape;
  shape.fillsCavities = options.fill_cavities != 0;
  shape.offset = options.offset;
  shape.shell = options.shell;
  shape.shellSide = static_cast<winding::ShellSide>(options.shell_side);
  return shape;
}

winding_surface_options checkedOptions(const winding_surface_options* options, const Grid& grid)
{
  const winding_surface_options wished = known(options, defaultSurfaceOptions());
  winding::checkProperty(winding::Parameter::features, wished.features);
  winding::checkProperty(winding::Parameter::offset, wished.offset);
  winding::checkProperty(winding::Parameter::shell, wished.shell);
  winding::checkProperty(winding::Parameter::shellSide, wished.shell_side);
  if (wished.type != 0 && wished.type != WINDING_FLOAT32 && wished.type != WINDING_FLOAT64)
  {
    throw Misuse("options.type is no type of floating-point numbers");
  }
  if (!wished.close_border)
  {
    winding::refuseFlatGrid(grid);
  }
  return wished;
}

/// Makes the quads between voxels, with labels on both sides of them.
template <class Label>
void makeBlocks(const winding_array& voxels, const Grid& grid, Call& call, winding_mesh& mesh)
{
  const std::size_t stride = voxels.stride == 0 ? 1 : static_cast<std::size_t>(voxels.stride);
  winding::VoxelSides<Label> sides;
  std::copy_n(grid.dimensions.data(), 3, sides.dimensions.begin());
  sides.labels.resize(static_cast<std::size_t>(voxels.rows));
  for (std::size_t i = 0; i < sides.labels.size(); ++i)
  {
    sides.labels[i] = static_cast<const Label*>(voxels.data)[i * stride];
  }
  using Blocks = winding::BlockSurface<Label>;
  const std::size_t faces = Blocks::countFaces(sides);
  Blocks blocks(sides, false, faces);
  mesh.corners.resize(4 * faces);
  writeOffsets(mesh, faces, 4);
  blocks.build(
    mesh.corners.data(),
    [&](int i, int j, int k)
    {
      const Eigen::Array3d index(i - 0.5, j - 0.5, k - 0.5);
      const Eigen::Array3d corner = index * grid.spacing.array() + grid.firstSample.array();
      mesh.doublePoints.insert(mesh.doublePoints.end(), corner.begin(), corner.end());
    },
    call.executor);
  mesh.labels.resize(2 * faces);
  for (std::size_t face = 0; face < faces; ++face)
  {
    mesh.labels[2 * face] = sides.labels[static_cast<std::size_t>(blocks.voxels()[face])];
    mesh.labels[2 * face + 1] = blocks.seenLabels()[face];
  }
}

} // namespace

void winding_surface_options_init(winding_surface_options* options, size_t size)
{
  fill(options, size, defaultSurfaceOptions());
}

winding_status winding_level_surface(const winding_field* field, const winding_grid* grid,
  const winding_rule* rule, const winding_surface_options* options, const winding_run* run,
  winding_mesh** mesh, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      required(mesh, "mesh") = nullptr;
      const winding_field& handle = required(field, "field");
      const Grid samples = gridOf(grid);
      const winding_rule inside = known(rule, defaultRule());
      const winding_surface_options wished = checkedOptions(options, samples);
      Call call(run);
      giveHandle(*mesh,
        [&](winding_mesh& made)
        {
          LevelSurface surface(handle, samples, inside, wished, call);
          evaluateInTime(*handle.field, handle.tolerance,
            winding::sampleCount(samples.wholeExtent()), call,
            [&]
            {
              surface.findEdges();
              const winding::SolidShape shape = shapeOf(wished);
              if (!winding::isSheet(handle.field->info(), shape))
              {
                surface.warn(true, shape.isPlain());
              }
              if (shape.isPlain())
              {
                writeSurface(
                  samples, surface.edges(),
                  [&]() -> const winding::EdgeRoots& { return surface.findRoots(); }, nullptr,
                  wished, call, made);
                return;
              }
              surface.findRoots();
              const winding::ShapedSolid shaped = surface.shaped(shape);
              made.filledCavities = static_cast<std::int64_t>(shaped.cavities());
              if (shape.hasDistances())
              {
                made.distancesFrom = shaped.base() == winding::DistanceBase::source
                                       ? WINDING_DISTANCES_FROM_SOURCE
                                       : WINDING_DISTANCES_FROM_SURFACE;
                made.distances = shape.band();
                made.distanceTree = shaped.surfaceTree();
              }
              writeSurface(
                samples, shaped.edges(),
                [&]() -> const winding::EdgeRoots& { return shaped.roots(); }, nullptr, wished,
                call, made);
            });
        });
    });
}

winding_status winding_boolean(const winding_field* const* fields, size_t count, int32_t operation,
  const winding_grid* grid, const winding_rule* rules, const winding_surface_options* options,
  const winding_run* run, winding_mesh** mesh, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      required(mesh, "mesh") = nullptr;
      const winding_field* const* first = &required(fields, "fields");
      if (count < 2)
      {
        throw winding::Refusal(winding::Message("there are fewer than two solids"));
      }
      winding::checkProperty(winding::Parameter::booleanOperation, operation);
      const auto kind = static_cast<winding::BooleanOperation>(operation);
      const Grid samples = gridOf(grid);
      const winding_surface_options wished = checkedOptions(options, samples);
      if (wished.fill_cavities || wished.offset != 0 || wished.shell != 0)
      {
        throw Misuse("options have a shape, which a result of several solids does not take");
      }
      std::vector<winding_rule> inside(count, defaultRule());
      for (std::size_t i = 0; i < count; ++i)
      {
        required(first[i], "fields[i]");
        inside[i] = rules ? known(elementOf(rules, i), defaultRule()) : inside[i];
      }
      Call call(run);
      giveHandle(*mesh,
        [&](winding_mesh& made)
        {
          std::vector<std::unique_ptr<LevelSurface>> surfaces;
          std::vector<const winding::LevelEdges*> edges;
          std::vector<winding::LevelOperand> operands;
          const double parts = static_cast<double>(count) + 1;
          for (std::size_t i = 0; i < count; ++i)
          {
            const auto done = static_cast<double>(i);
            surfaces.push_back(std::make_unique<LevelSurface>(*first[i], samples, inside[i], wished,
              call, Share{done / parts, (done + 1) / parts}));
            LevelSurface& surface = *surfaces.back();
            call.nameSource(wished.names ? &required(wished.names[i], "options.names[i]") : "");
            evaluateInTime(*first[i]->field, first[i]->tolerance,
              winding::sampleCount(samples.wholeExtent()), call,
              [&]
              {
                surface.findEdges();
                surface.warn(false, false);
                surface.findRoots();
              });
            edges.push_back(&surface.edges());
            operands.push_back({&surface.edges(), &surface.roots()});
          }
          call.nameSource("");
          setShare(call, {1 - 1 / parts, 1}, 0, 1);
          const winding::LevelEdges result(edges, kind, samples, call.executor);
          const winding::CombinedRoots combined(result, operands, kind, call.executor);
          writeSurface(
            samples, result, [&]() -> const winding::EdgeRoots& { return combined.roots; },
            &combined.operands, wished, call, made);
          if (result.size() == 0)
          {
            const bool isAllInside = result.areAllInside();
            if (!(isAllInside && wished.generate_image))
            {
              call.warn(isAllInside
                          ? winding::allInsideAdvice()
                          : winding::emptyResultAdvice(kind != winding::BooleanOperation::unite));
            }
          }
        });
    });
}

winding_status winding_expect_surface(const winding_field* field, const winding_grid* grid,
  const winding_rule* rule, const winding_run* run, double* bytes, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      const Field& source = *required(field, "field").field;
      const Grid samples = gridOf(grid);
      const winding_rule inside = known(rule, defaultRule());
      Call call(run);
      double edges = winding::levelEdgesByArea(source, samples);
      constexpr double many = 1e7; // a coarse grid takes no time then
      if (edges > many)
      {
        edges = std::min(edges, winding::levelEdgesByCoarseGrid(source, samples, ruleOf(inside),
                                  inside.winding_threshold, true, call.executor));
      }
      required(bytes, "bytes") = winding::LevelEdges::bytesOfRows(samples) +
                                 winding::LevelEdges::bytesOfSlab(samples) +
                                 static_cast<double>(winding::bytesOfLevelSurface(source, edges));
    });
}

winding_status winding_voxel_surface(winding_array voxels, const winding_grid* grid,
  const winding_run* run, winding_mesh** mesh, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      required(mesh, "mesh") = nullptr;
      const Grid samples = gridOf(grid);
      const std::size_t count = winding::sampleCount(samples.wholeExtent());
      if (voxels.rows < 0 || static_cast<std::size_t>(voxels.rows) != count || !voxels.data ||
          voxels.stride < 0)
      {
        throw Misuse("voxels do not have a row for each sample of the grid");
      }
      if (voxels.type != WINDING_UINT8 && voxels.type != WINDING_UINT16)
      {
        throw Misuse("voxels.type is neither WINDING_UINT8 nor WINDING_UINT16");
      }
      Call call(run);
      giveHandle(*mesh,
        [&](winding_mesh& made)
        {
          if (voxels.type == WINDING_UINT8)
          {
            makeBlocks<unsigned char>(voxels, samples, call, made);
          }
          else
          {
            makeBlocks<unsigned short>(voxels, samples, call, made);
          }
        });
    });
}

void winding_mesh_arrays_init(winding_mesh_arrays* arrays, size_t size)
{
  fill(arrays, size, winding_mesh_arrays());
}

winding_status winding_mesh_show(
  const winding_mesh* mesh, winding_mesh_arrays* arrays, winding_refusal* refusal)
{
  return guarded(nullptr, refusal,
    [&]
    {
      const winding_mesh& from = required(mesh, "mesh");
      winding_mesh_arrays to = {};
      const bool areDoubles = !from.doublePoints.empty();
      to.type = areDoubles ? WINDING_FLOAT64 : WINDING_FLOAT32;
      to.point_count =
        static_cast<int64_t>((from.doublePoints.size() + from.floatPoints.size()) / 3);
      to.polygon_count = from.offsets.empty() ? 0 : static_cast<int64_t>(from.offsets.size() - 1);
      to.corner_count = static_cast<int64_t>(from.corners.size());
      to.points = areDoubles ? static_cast<const void*>(pointerTo(from.doublePoints))
                             : pointerTo(from.floatPoints);
      to.offsets = pointerTo(from.offsets);
      to.corners = pointerTo(from.corners);
      const bool areDoubleNormals = !from.doublePointNormals.empty();
      to.normals_type = areDoubleNormals ? WINDING_FLOAT64 : WINDING_FLOAT32;
      to.point_normals = areDoubleNormals
                           ? static_cast<const void*>(pointerTo(from.doublePointNormals))
                           : pointerTo(from.pointNormals);
      to.polygon_normals = pointerTo(from.polygonNormals);
      to.point_areas = pointerTo(from.pointAreas);
      to.labels = pointerTo(from.labels);
      to.numbers = pointerTo(from.numbers);
      to.slit_widths = pointerTo(from.slitWidths);
      to.distances_from = from.distancesFrom;
      to.filled_cavities = from.filledCavities;
      to.sample_count = static_cast<int64_t>(from.inside.size());
      to.inside = pointerTo(from.inside);
      to.line_count =
        from.lineOffsets.empty() ? 0 : static_cast<int64_t>(from.lineOffsets.size() - 1);
      to.line_offsets = pointerTo(from.lineOffsets);
      to.line_corners = pointerTo(from.lineCorners);
      to.vertex_count =
        from.vertexOffsets.empty() ? 0 : static_cast<int64_t>(from.vertexOffsets.size() - 1);
      to.vertex_offsets = pointerTo(from.vertexOffsets);
      to.vertex_corners = pointerTo(from.vertexCorners);
      to.colors = pointerTo(from.colors);
      to.color_components = from.colorComponents;
      to.texture_coordinates = pointerTo(from.textureCoordinates);
      to.column_count = static_cast<int64_t>(from.columns.size());
      to.regions_count = static_cast<int64_t>(from.regions.size());
      give(to, required(arrays, "arrays"));
    });
}

void winding_mesh_free(winding_mesh* mesh)
{
  delete mesh;
}

void winding_fidelity_init(winding_fidelity* fidelity, size_t size)
{
  fill(fidelity, size, winding_fidelity());
}

winding_status winding_compare(const winding_field* field, const winding_mesh* mesh, double voxel,
  int64_t samples, const winding_run* run, winding_fidelity* fidelity, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      const winding_field& handle = required(field, "field");
      const winding_mesh& compared = required(mesh, "mesh");
      winding_fidelity& result = required(fidelity, "fidelity");
      if (samples < 1 || !(voxel >= 0))
      {
        throw Misuse("samples are less than 1, or voxel is negative");
      }
      Call call(run);
      const winding::VectorsView points =
        compared.doublePoints.empty()
          ? winding::VectorsView(compared.floatPoints.data(), compared.floatPoints.size() / 3)
          : winding::VectorsView(compared.doublePoints.data(), compared.doublePoints.size() / 3);
      std::vector<Eigen::Vector3d> vertices(points.size());
      for (std::size_t i = 0; i < vertices.size(); ++i)
      {
        vertices[i] = points[i];
      }
      winding::TriangleList triangles;
      for (std::size_t polygon = 0; polygon + 1 < compared.offsets.size(); ++polygon)
      {
        const auto first = static_cast<std::size_t>(compared.offsets[polygon]);
        const auto last = static_cast<std::size_t>(compared.offsets[polygon + 1]);
        for (std::size_t corner = first + 2; corner < last; ++corner)
        {
          triangles.push_back({static_cast<std::int32_t>(compared.corners[first]),
            static_cast<std::int32_t>(compared.corners[corner - 1]),
            static_cast<std::int32_t>(compared.corners[corner])});
        }
      }
      constexpr unsigned seed = 1;
      winding::WantedDistances wanted = {compared.distanceTree.get(), compared.distances};
      const bool isMoved = compared.distancesFrom != WINDING_DISTANCES_FROM_NOTHING;
      if (compared.distancesFrom == WINDING_DISTANCES_FROM_SOURCE)
      {
        wanted.from = &handle.field->distanceTree(call.executor);
      }
      const winding::Fidelity found = winding::compareWithSource(*handle.field, vertices, triangles,
        voxel, static_cast<std::size_t>(samples), seed, call.executor, isMoved ? &wanted : nullptr);
      winding_fidelity to = {};
      to.samples = static_cast<int64_t>(found.samples);
      to.largest_from_source = found.largestFromSource;
      to.mean_from_source = found.meanFromSource;
      to.largest_to_source = found.largestToSource;
      to.mean_to_source = found.meanToSource;
      to.source_volume = found.sourceVolume;
      to.volume = found.volume;
      to.components = static_cast<int64_t>(found.components);
      to.lost_components = static_cast<int64_t>(found.lostComponents);
      to.self_intersections = static_cast<int64_t>(found.selfIntersections);
      to.largest_shape_error = found.largestShapeError;
      to.mean_shape_error = found.meanShapeError;
      give(to, result);
    });
}
