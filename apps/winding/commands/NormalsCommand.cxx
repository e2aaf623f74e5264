// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/CommandFiles.h"
#include "commands/Commands.h"
#include "commands/FilterSettings.h"
#include "commands/ReportParts.h"
#include "input/ReadInput.h"
#include "options/Options.h"
#include "output/CloudFile.h"
#include "output/OutputFile.h"
#include "program/Failure.h"
#include "program/Messages.h"
#include "program/Print.h"
#include "program/Progress.h"
#include "program/Stopwatch.h"
#include "program/Threads.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkWindingNumberNormals.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{

/// Some points of others, with their arrays, all in one vertex cell.
vtkSmartPointer<vtkPolyData> cloudOf(vtkPointSet* points, const std::vector<vtkIdType>& taken)
{
  const auto count = static_cast<vtkIdType>(taken.size());
  vtkPoints* const all = points->GetPoints();
  vtkNew<vtkPoints> positions;
  vtkNew<vtkCellArray> vertices;
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  positions->SetDataType(all ? all->GetDataType() : VTK_FLOAT);
  positions->SetNumberOfPoints(count);
  cloud->GetPointData()->CopyAllOn();
  cloud->GetPointData()->CopyAllocate(points->GetPointData(), count);
  if (count > 0) // VTK's writers crash on a cell without points
  {
    vertices->InsertNextCell(count);
  }
  for (vtkIdType id = 0; id < count; ++id)
  {
    const vtkIdType from = taken[static_cast<std::size_t>(id)];
    positions->SetPoint(id, all->GetPoint(from));
    cloud->GetPointData()->CopyData(points->GetPointData(), from, id);
    vertices->InsertCellPoint(id);
  }
  cloud->SetPoints(positions);
  cloud->SetVerts(vertices);
  return cloud;
}

/// The points of a data set without cells and normals, whose arrays are shared.
vtkSmartPointer<vtkPolyData> bare(vtkPointSet* data)
{
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(data->GetPoints());
  cloud->GetPointData()->ShallowCopy(data->GetPointData());
  if (vtkDataArray* const normals = cloud->GetPointData()->GetNormals())
  {
    cloud->GetPointData()->RemoveArray(normals->GetName());
  }
  return cloud;
}

/// The points that have a place and a normal; the filter has warned of others.
vtkSmartPointer<vtkPolyData> oriented(vtkPointSet* found)
{
  vtkDataArray* const normals = found->GetPointData()->GetNormals();
  std::vector<vtkIdType> usable;
  for (vtkIdType id = 0; normals && id < found->GetNumberOfPoints(); ++id)
  {
    double position[3], normal[3];
    found->GetPoint(id, position);
    normals->GetTuple(id, normal);
    const double square = vtkMath::Dot(normal, normal);
    if (std::isfinite(position[0] + position[1] + position[2]) && std::isfinite(square) &&
        square > 0)
    {
      usable.push_back(id);
    }
  }
  return cloudOf(found, usable);
}

/// Figures of a run that its report has.
struct Figures
{
  vtkIdType given; ///< points of the input
  bool haveNormals, areMesh;
  double read, find, total; ///< seconds
};

/// The words for where the normals come from.
std::string originOf(vtkWindingNumberNormals& filter, const Figures& figures)
{
  const std::string estimation = filter.GetNormalEstimationUsed();
  if (!estimation.empty())
  {
    const double percent = std::round(100 * filter.GetClearShare());
    return "normals by " + estimation + ", clear at " + shown(percent, 3) + " %";
  }
  return figures.haveNormals ? "normals as given" : "normals of the faces";
}

void printReport(const Options& options, vtkWindingNumberNormals& filter, vtkPolyData* cloud,
  const Figures& figures)
{
  const vtkIdType points = cloud->GetNumberOfPoints();
  const double meanArea = points > 0 ? filter.GetTotalArea() / static_cast<double>(points) : 0;
  if (!options.json)
  {
    if (!options.quiet)
    {
      const std::string ofGiven =
        figures.given > points ? " of " + std::to_string(figures.given) : std::string();
      print(options.input + ": " + std::to_string(points) + ofGiven + " points, mean area " +
            shown(meanArea, 3) + ", " + originOf(filter, figures) + ", " + shown(figures.total, 3) +
            " s\nwrote " + options.output);
    }
    return;
  }
  const std::string estimation = filter.GetNormalEstimationUsed();
  Json input = {{"file", options.input}, {"kind", figures.areMesh ? "surface" : "points"},
    {"primitives", points}, {"dropped", figures.given - points}, {"mean_area", meanArea},
    {"normals_estimated", !estimation.empty()}};
  if (!estimation.empty())
  {
    input["normal_estimation"] = estimation;
    input["clear_share"] = filter.GetClearShare();
  }
  const double write = std::max(0.0, figures.total - figures.read - figures.find);
  print(Json{{"input", input}, {"output", {{"file", options.output}, {"points", points}}},
    {"seconds",
      {{"read", figures.read}, {"find", figures.find}, {"write", write}, {"total", figures.total}}},
    {"peak_memory", peakMemory()}, {"threads", threadsUsed(options.threads)}});
}

} // namespace

void runNormals(const Options& options, Messages& messages)
{
  const Stopwatch stopwatch;
  OutputFile output(options.output, filesToKeep(options));
  const vtkSmartPointer<vtkPointSet> input =
    readPoints(options.inputs[0], messages, {options.columns, true});
  Figures figures = {input->GetNumberOfPoints(), input->GetPointData()->GetNormals() != nullptr,
    false, stopwatch.seconds(), 0, 0};
  if (figures.given == 0)
  {
    throw Failure(EXIT_REFUSED, options.input, "has no points; give a file that has some");
  }
  vtkNew<vtkWindingNumberNormals> filter;
  filter->SetNamesInMessages(vtkWindingNumberAlgorithm::PROGRAM_NAMES);
  filter->SetInputDataObject(options.replace ? bare(input).Get() : input.Get());
  filter->EstimateNormalsOn();
  filter->SetNormalEstimation(options.normalEstimation);
  filter->SetToward(options.toward.c_str());
  filter->SetPointAreaMethod(options.areas);
  filter->SetNumberOfNeighbors(options.neighbors);
  filter->SetPointArea(options.area);
  filter->SetNumberOfThreads(options.threads);
  {
    const Progress progress(filter, Phase::evaluating, messages.isQuiet(), "orienting");
    filter->Update();
  }
  checkFilter(filter->GetStatus(), options.input, messages);
  figures.find = stopwatch.seconds() - figures.read;
  const bool areEstimated = *filter->GetNormalEstimationUsed() != '\0';
  figures.areMesh = !areEstimated && !figures.haveNormals;
  const auto cloud = oriented(vtkPointSet::SafeDownCast(filter->GetOutput()));
  writeCloud(cloud, output, messages);
  output.commit();
  figures.total = stopwatch.seconds();
  printReport(options, *filter, cloud, figures);
}
