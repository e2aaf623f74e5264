// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation.h"
#include "Handles.h"
#include "diagnosis/GridAdvice.h"
#include "messages/PropertyChecks.h"
#include "report/Fidelity.h"
#include "report/UnusedOptions.h"
#include "tasks/SurfaceTask.h"
#include "voxels/BlockSurface.h"

#include <algorithm>
#include <stdexcept>

using namespace winding::c;
using winding::Field;
using winding::Grid;
using winding::Output;

namespace
{

winding_surface_options defaultSurfaceOptions()
{
  winding_surface_options options = {};
  options.size = sizeof options;
  options.features = WINDING_FEATURES_SMOOTH;
  options.generate_normals = 1;
  options.mend_source = 1;
  return options;
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

/// Gives a task the memory of a mesh.
class MeshSink final : public winding::Sink
{
public:
  explicit MeshSink(winding_mesh& mesh)
    : mesh_(mesh)
  {
  }

protected:
  void* memoryOf(Output output, winding::NumberType type, std::size_t tuples) override
  {
    const auto sized = [&](auto& numbers) -> void*
    {
      numbers.resize(winding::componentsOf(output) * tuples);
      return numbers.data();
    };
    switch (output)
    {
    case Output::points:
      return type == winding::NumberType::float64 ? sized(mesh_.doublePoints)
                                                  : sized(mesh_.floatPoints);
    case Output::offsets:
      return sized(mesh_.offsets);
    case Output::corners:
      return sized(mesh_.corners);
    case Output::pointNormals:
      return sized(mesh_.pointNormals);
    case Output::polygonNormals:
      return sized(mesh_.polygonNormals);
    case Output::operands:
      return sized(mesh_.operands);
    case Output::inside:
      return sized(mesh_.inside);
    case Output::isClosed:
      return &mesh_.isClosed;
    case Output::parts:
      return &mesh_.parts;
    case Output::volume:
      return &mesh_.volume;
    case Output::inputVolume:
      return &mesh_.inputVolume;
    }
    throw std::logic_error("meshes do not have this array");
  }

private:
  winding_mesh& mesh_;
};

/// Returns what a mesh that a task has made encloses, for people.
std::string wordsOfSolid(const winding_mesh& mesh)
{
  return winding::solidInWords(mesh.isClosed != 0, mesh.parts, mesh.volume, mesh.inputVolume);
}

/// Returns the options of a task on a grid. Throws Refusal and Misuse for values out of range.
winding::SurfaceOptions optionsOf(
  const winding_surface_options& wished, const winding_rule* rule, const Grid& grid)
{
  winding::checkProperty(winding::Parameter::features, wished.features);
  winding::checkProperty(winding::Parameter::gapWidth, wished.gap_width);
  winding::checkProperty(winding::Parameter::offset, wished.offset);
  winding::checkProperty(winding::Parameter::shell, wished.shell);
  winding::checkProperty(winding::Parameter::shellSide, wished.shell_side);
  winding::SurfaceOptions options;
  options.isInside = insideTestOf(rule);
  options.shape.fillsCavities = wished.fill_cavities != 0;
  options.shape.gapWidth = wished.gap_width;
  options.shape.offset = wished.offset;
  options.shape.shell = wished.shell;
  options.shape.shellSide = static_cast<winding::ShellSide>(wished.shell_side);
  options.features = static_cast<winding::Features>(wished.features);
  options.areTriangles = wished.generate_triangles != 0;
  options.mendsSource = wished.mend_source != 0;
  options.closesBorder = wished.close_border != 0;
  options.hasNormals = wished.generate_normals != 0;
  options.hasImage = wished.generate_image != 0;
  switch (wished.type)
  {
  case 0:
    break;
  case WINDING_FLOAT32:
    options.pointType = winding::PointType::float32;
    break;
  case WINDING_FLOAT64:
    options.pointType = winding::PointType::float64;
    break;
  default:
    throw Misuse("options.type is no type of floating-point numbers");
  }
  if (!options.closesBorder)
  {
    winding::refuseFlatGrid(grid);
  }
  return options;
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
      const Field& source = *required(field, "field").field;
      const Grid samples = gridOf(grid);
      const winding::SurfaceOptions wished =
        optionsOf(known(options, defaultSurfaceOptions()), rule, samples);
      Call call(run);
      giveHandle(*mesh,
        [&](winding_mesh& made)
        {
          MeshSink sink(made);
          winding::SurfaceResult result;
          evaluateInTime(source, winding::sampleCount(samples.wholeExtent()), call,
            [&] { result = winding::makeSurface(source, samples, wished, sink, call.run); });
          made.solidInWords = wordsOfSolid(made);
          made.filledCavities = static_cast<std::int64_t>(result.cavities);
          if (wished.shape.hasDistances())
          {
            made.distancesFrom = result.distancesFrom == winding::DistanceBase::source
                                   ? WINDING_DISTANCES_FROM_SOURCE
                                   : WINDING_DISTANCES_FROM_SURFACE;
            made.distances = wished.shape.band();
            made.distanceTree = result.surfaceTree;
          }
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
      const Grid samples = gridOf(grid);
      const winding_surface_options wished = known(options, defaultSurfaceOptions());
      const winding::SurfaceOptions ofResult = optionsOf(wished, nullptr, samples);
      winding::BooleanTask task(
        samples, static_cast<winding::BooleanOperation>(operation), ofResult);
      if (!ofResult.shape.isPlain())
      {
        throw Misuse("options have a shape, which a result of several solids does not take");
      }
      std::vector<winding::InsideTest> areInside;
      for (std::size_t i = 0; i < count; ++i)
      {
        required(first[i], "fields[i]");
        areInside.push_back(insideTestOf(rules ? elementOf(rules, i) : nullptr));
      }
      Call call(run);
      const double parts = static_cast<double>(count) + 1;
      winding::UnusedOptions unused;
      for (std::size_t i = 0; i < count; ++i)
      {
        const Field& field = *first[i]->field;
        unused.add(field.info());
        call.nameSource(wished.names ? &required(wished.names[i], "options.names[i]") : "");
        call.executor.setShare(static_cast<double>(i) / parts, static_cast<double>(i + 1) / parts);
        evaluateInTime(field, winding::sampleCount(samples.wholeExtent()), call,
          [&] { task.add(field, areInside[i], call.run); });
      }
      call.nameSource("");
      call.warn(unused.messages());
      call.executor.setShare(1 - 1 / parts, 1);
      giveHandle(*mesh,
        [&](winding_mesh& made)
        {
          MeshSink sink(made);
          task.run(sink, call.run);
          made.solidInWords = wordsOfSolid(made);
          made.numbers.assign(made.operands.begin(), made.operands.end());
        });
    });
}

winding_status winding_expect_surface(const winding_field* field, const winding_grid* grid,
  const winding_rule* rule, const winding_surface_options* options, const winding_run* run,
  double* bytes, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      const Field& source = *required(field, "field").field;
      const Grid samples = gridOf(grid);
      const winding::SurfaceOptions wished =
        optionsOf(known(options, defaultSurfaceOptions()), rule, samples);
      Call call(run);
      required(bytes, "bytes") = winding::claimSurface(source, samples, wished, call.run).bytes;
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
      to.is_closed = from.isClosed;
      to.part_count = from.parts;
      to.volume = from.volume;
      to.input_volume = from.inputVolume;
      to.solid_in_words = from.solidInWords.empty() ? nullptr : from.solidInWords.c_str();
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
