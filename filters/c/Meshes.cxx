#include "Evaluation.h"
#include "Handles.h"
#include "level/GridContour.h"
#include "level/LevelMemory.h"
#include "level/LevelRoots.h"
#include "level/SharpContour.h"
#include "messages/PropertyChecks.h"
#include "report/Fidelity.h"
#include "report/GridAdvice.h"
#include "voxels/BlockSurface.h"

#include <algorithm>

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

/// The surface between inside and outside, for one call.
class LevelSurface
{
public:
  LevelSurface(const winding_field& handle, const Grid& grid, const winding_rule& rule,
    const winding_surface_options& options, Call& call)
    : handle_(handle)
    , field_(*handle.field)
    , grid_(grid)
    , rule_(rule)
    , options_(options)
    , call_(call)
    , edges_(field_, grid, ruleOf(rule), rule.winding_threshold, options.close_border != 0)
  {
  }

  void make(winding_mesh& mesh)
  {
    while (!edges_.isDone())
    {
      call_.executor.setShare(0.5 * edges_.progress(), 0.5 * edges_.nextProgress());
      edges_.advance(call_.executor);
    }
    this->warn();
    const bool areDoubles =
      options_.type == 0 ? winding::needsDoublePoints(grid_) : options_.type == WINDING_FLOAT64;
    if (options_.features == WINDING_FEATURES_SHARP)
    {
      this->makeSharp(mesh, areDoubles);
    }
    else
    {
      this->makeSmooth(mesh, areDoubles);
    }
  }

private:
  void warn()
  {
    const bool isAllInside = edges_.size() == 0 && edges_.beginsInside(0, 0);
    if (isAllInside)
    {
      call_.warn(winding::allInsideAdvice());
    }
    ResultOnGrid result;
    result.sides = edges_.sides();
    result.isEmpty = edges_.size() == 0 && !isAllInside;
    result.mayCloseBorder = options_.close_border == 0;
    result.isInside = [this](int i, int j, int k)
    {
      return edges_.isSampleInside({i, j, k});
    };
    warnOfResult(handle_, grid_, result, rule_, call_);
  }

  void findRoots(winding::LevelRoots& roots) const
  {
    for (double progress = 0.5; !roots.isDone();)
    {
      const double next = progress + (1 - progress) / 8;
      call_.executor.setShare(progress, next);
      progress = next;
      roots.advance(call_.executor);
    }
  }

  winding::LevelRoots newRoots() const
  {
    return winding::LevelRoots(field_, grid_, edges_, ruleOf(rule_), rule_.winding_threshold,
      handle_.tolerance, call_.executor);
  }

  void makeSmooth(winding_mesh& mesh, bool areDoubles)
  {
    winding::GridContour contour(grid_, edges_, call_.executor);
    mesh.corners.resize(3 * contour.triangles());
    writeOffsets(mesh, contour.triangles(), 3);
    contour.takeTriangles(mesh.corners.data(), call_.executor);
    winding::LevelRoots roots = this->newRoots();
    this->findRoots(roots);
    writePoints(mesh, contour.vertices(), areDoubles,
      [&](auto* points)
      {
        contour.place(roots.fractions(), points, call_.executor);
        if (options_.generate_normals)
        {
          mesh.pointNormals.resize(3 * contour.vertices());
          contour.writeNormals(
            mesh.corners.data(), points, roots.normals(), mesh.pointNormals.data(), call_.executor);
        }
      });
  }

  void makeSharp(winding_mesh& mesh, bool areDoubles)
  {
    winding::LevelRoots roots = this->newRoots();
    this->findRoots(roots);
    const winding::SharpContour contour(
      field_, grid_, edges_, roots, options_.generate_triangles != 0, call_.executor);
    writePoints(mesh, contour.vertices(), areDoubles,
      [&](auto* points) { contour.place(points, call_.executor); });
    mesh.offsets.resize(contour.polygons() + 1);
    mesh.corners.resize(contour.corners());
    contour.writePolygons(mesh.offsets.data(), mesh.corners.data(), call_.executor);
    if (options_.generate_normals)
    {
      mesh.polygonNormals.resize(3 * contour.polygons());
      contour.writeNormals(mesh.polygonNormals.data(), call_.executor);
    }
  }

  const winding_field& handle_;
  const Field& field_;
  const Grid& grid_;
  const winding_rule& rule_;
  const winding_surface_options& options_;
  Call& call_;
  winding::LevelEdges edges_;
};

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
      const winding_surface_options wished = known(options, defaultSurfaceOptions());
      winding::checkProperty(winding::Parameter::features, wished.features);
      if (wished.type != 0 && wished.type != WINDING_FLOAT32 && wished.type != WINDING_FLOAT64)
      {
        throw Misuse("options.type is no type of floating-point numbers");
      }
      if (!wished.close_border)
      {
        winding::refuseFlatGrid(samples);
      }
      Call call(run);
      giveHandle(*mesh,
        [&](winding_mesh& made)
        {
          LevelSurface surface(handle, samples, inside, wished, call);
          evaluateInTime(*handle.field, handle.tolerance,
            winding::sampleCount(samples.wholeExtent()), call, [&] { surface.make(made); });
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
      const winding::Fidelity found = winding::compareWithSource(*handle.field, vertices, triangles,
        voxel, static_cast<std::size_t>(samples), seed, call.executor);
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
      give(to, result);
    });
}
