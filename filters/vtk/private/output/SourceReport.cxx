// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/output/SourceReport.h"

#include "base/Bounds.h"
#include "field/Field.h"
#include "messages/Options.h"
#include "private/output/FaultBlocks.h"
#include "private/source/InputViews.h"
#include "private/source/PolygonOrientation.h"
#include "report/Advice.h"
#include "report/SurfaceExamination.h"
#include "surface/CompletedSurface.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <memory>
#include <optional>

namespace winding
{

namespace
{

/// Appends arrays.
class Writer
{
public:
  explicit Writer(vtkFieldData* report)
    : report_(report)
  {
  }

  /// Adds advice in one line, and to the lines of advice.
  void advice(const std::vector<Message>& messages)
  {
    this->text("advice", lineOf(messages));
    for (const Message& message : messages)
    {
      lines.push_back(lineOf(message));
    }
  }

  void text(const char* name, const std::string& value) { this->add<vtkStringArray>(name, value); }
  void flag(const char* name, bool value) { this->add<vtkUnsignedCharArray>(name, value); }
  /// No value leaves the array without one.
  void measure(const char* name, std::optional<double> value)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    if (value)
    {
      array->InsertNextValue(*value);
    }
    report_->AddArray(array);
  }
  template <class Integer> void count(const char* name, Integer value)
  {
    this->add<vtkIdTypeArray>(name, static_cast<vtkIdType>(value));
  }

  void box(const char* name, const Bounds& bounds)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(6);
    if (!bounds.isEmpty())
    {
      const Eigen::Vector3d low = bounds.min(), high = bounds.max();
      array->InsertNextTuple6(low[0], low[1], low[2], high[0], high[1], high[2]);
    }
    report_->AddArray(array);
  }

  std::vector<std::string> lines; ///< of advice

private:
  template <class Array, class Value> void add(const char* name, const Value& value)
  {
    vtkNew<Array> array;
    array->SetName(name);
    array->InsertNextValue(value);
    report_->AddArray(array);
  }

  vtkFieldData* report_;
};

vtkSmartPointer<vtkMultiBlockDataSet> reportOnSurface(InputViews& source,
  const FieldOptions& completion, const FaultShape& shape, const CellCounts& cells,
  const OrientedPolygons* fix, Writer& writer, Executor& executor)
{
  std::vector<TrianglesView> triangles = source.triangles();
  std::vector<VectorsView> points = source.points();
  const Mirror mirror(completion.mirror, completion.weldTolerance);
  const FlatBase base(completion.flatBase);
  CompletedSurface completed;
  if (!mirror.isNone() || !base.isNone())
  {
    completed = completedSurface(triangles, mirror, base, executor);
    triangles = {completed.view()};
    points = {triangles[0].points};
  }
  const SurfaceExamination found = examineSurface(triangles, points, executor);
  const Surface& surface = *found.field->surface();
  const SurfaceReport& report = found.report;
  const EdgeCounts& edges = report.edges;
  writer.text("kind", "surface");
  writer.count("triangles", surface.inputTriangles);
  writer.count("vertices", found.vertices.points);
  writer.count("vertices_merged", found.vertices.different);
  writer.flag("closed", edges.isClosed() && !surface.triangles.empty());
  writer.count("boundary_edges", edges.boundary);
  writer.count("boundary_loops", edges.boundaryLoops);
  writer.measure("widest_slit", report.widestSlit);
  writer.count("nonmanifold_edges", edges.nonManifold);
  writer.count("inconsistent_edges", edges.inconsistent);
  writer.count("net_boundary_edges", edges.netBoundary);
  writer.count("components_vertex", report.vertexComponents);
  writer.count("components_edge", edges.components);
  writer.count("closed_components", report.orientation.closed);
  writer.count("inverted_components", report.orientation.inverted);
  writer.count("nested_solids", report.orientation.nestedSolids);
  writer.count("one_sided_components", report.orientation.oneSided);
  writer.count("open_parts_inside", report.openPartsInside);
  writer.count("duplicate_faces", report.duplicateTriangles);
  writer.count("degenerate", surface.collapsedTriangles);
  writer.count("zero_area", report.zeroAreaTriangles);
  writer.count("unreferenced_vertices", found.vertices.unreferenced);
  writer.count("euler", report.eulerCharacteristic);
  writer.measure("volume", report.volume);
  writer.measure("area", report.area);
  writer.measure("fractional_share", found.fractionalShare);
  writer.count("turned_cells", cells.turned);
  writer.count("left_out_cells", cells.leftOut);
  if (fix)
  {
    writer.count("flipped_triangles", fix->triangles);
    writer.count("flipped_components", fix->components);
    writer.count("left_out_faces", fix->leftOut);
  }
  writer.box("bbox", surface.bounds);
  writer.count("non_finite", surface.nonFiniteTriangles);
  writer.count("invalid_ids", surface.invalidIdTriangles);
  std::vector<Message> advice = adviceOn(surface, report);
  const std::vector<Message> notes = notesOn(cells);
  advice.insert(advice.end(), completed.notes.begin(), completed.notes.end());
  advice.insert(advice.end(), notes.begin(), notes.end());
  writer.advice(advice);
  return faultBlocks(surface, found.edges, report.slits, shape, executor);
}

void reportOnCloud(InputViews& source, Writer& writer, Executor& executor)
{
  const CloudReport report = reportOn(source.orientedPoints(), executor);
  writer.text("kind", "points");
  writer.count("points", report.points);
  writer.count("duplicates", report.duplicates);
  writer.flag("normals", report.hasNormals);
  writer.count("zero_normals", report.zeroNormals);
  writer.count("non_unit_normals", report.nonUnitNormals);
  writer.count("non_finite", report.nonFinite);
  writer.measure("spacing_min", report.spacing.smallest);
  writer.measure("spacing_median", report.spacing.median);
  writer.measure("spacing_mean", report.spacing.mean);
  writer.measure("spacing_max", report.spacing.largest);
  writer.measure("opposite_neighbors", report.oppositeNeighbors);
  const auto orientation = [&report](double CloudOrientation::*measure)
  {
    return report.orientation ? std::optional<double>((*report.orientation).*measure)
                              : std::nullopt;
  };
  writer.measure("w_behind", orientation(&CloudOrientation::behind));
  writer.measure("w_before", orientation(&CloudOrientation::before));
  writer.measure("outward_share", orientation(&CloudOrientation::outward));
  writer.measure("inward_share", orientation(&CloudOrientation::inward));
  writer.box("bbox", report.bounds);
  writer.advice(source.hasOnlyLines() ? std::vector<Message>{onlyLines()} : adviceOn(report));
}

} // namespace

SourceReport reportOn(InputViews& source, const FieldOptions& completion, const FaultShape& shape,
  const CellCounts& cells, const OrientedPolygons* fix, Executor& executor)
{
  SourceReport report;
  report.arrays = vtkSmartPointer<vtkFieldData>::New();
  Writer writer(report.arrays);
  if (source.isSurface())
  {
    report.faults = reportOnSurface(source, completion, shape, cells, fix, writer, executor);
  }
  else
  {
    reportOnCloud(source, writer, executor);
    report.faults = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  }
  report.advice = std::move(writer.lines);
  return report;
}

} // namespace winding
