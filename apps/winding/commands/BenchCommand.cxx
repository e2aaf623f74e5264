// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Commands.h"
#include "commands/FilterSettings.h"
#include "input/ReadInput.h"
#include "options/Options.h"
#include "program/BenchTable.h"
#include "program/Failure.h"
#include "program/Messages.h"
#include "program/Progress.h"
#include "program/Stopwatch.h"
#include "program/Threads.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberProbe.h"

#include <algorithm>
#include <cmath>

namespace
{

/// Longest time for a measurement, in seconds.
constexpr double longTime = 2;

/// Samples at which errors are measured.
constexpr int verified = 500;

/// Measures the methods on one surface.
class MethodsBench
{
public:
  MethodsBench(const std::string& file, const Options& options, Messages& messages)
    : file_(file)
    , options_(options)
    , messages_(messages)
    , source_(readInput(file, messages))
  {
    messages.throwIfError(file);
  }

  BenchTable table()
  {
    std::vector<Json> rows;
    const std::vector<int> usual = {64, 128, 256};
    for (const int resolution : options_.resolutions.empty() ? usual : options_.resolutions)
    {
      const Json chosen = this->rowOfGrid(vtkWindingNumberField::AUTOMATIC, resolution);
      rows.push_back(chosen);
      if (chosen["method"] != "hierarchical")
      {
        rows.push_back(this->rowOfGrid(vtkWindingNumberField::HIERARCHICAL, resolution));
      }
      if (chosen["method"] != "direct")
      {
        rows.push_back(this->rowOfLongMethod(vtkWindingNumberField::DIRECT, resolution));
      }
      rows.push_back(this->rowOfLongMethod(vtkWindingNumberField::PARITY, resolution));
    }
    const std::string threads = std::to_string(threadsUsed(options_.threads));
    BenchTable table(
      file_ + ": " + std::to_string(triangles_) + " triangles, " + threads + " threads",
      {"the first method of each size is the one that automatic chooses",
        "scaled: measured at random voxels; all of them would take more than 2 s",
        "errors: against the direct sum, term by term, at 500 random voxels, and 500 near the "
        "surface unless the method is parity or scaled"});
    for (const Json& row : rows)
    {
      table.add(row);
    }
    return table;
  }

private:
  /// Makes a filter with the method and without limits.
  template <class Filter> vtkSmartPointer<Filter> filterFor(int method) const
  {
    auto filter = vtkSmartPointer<Filter>::New();
    filter->SetNamesInMessages(vtkWindingNumberAlgorithm::PROGRAM_NAMES);
    filter->SetMethod(method);
    filter->SetTolerance(options_.tolerance);
    filter->SetNumberOfThreads(options_.threads);
    filter->SetLongestExpectedTime(0);
    return filter;
  }

  /// Executes a filter until it is done or the program is interrupted.
  void execute(vtkWindingNumberAlgorithm* filter)
  {
    const Progress progress(filter, Phase::evaluating, true);
    filter->Update();
    checkFilter(filter->GetStatus(), file_, messages_);
    if (!filter->GetSourceIsSurface())
    {
      throw Failure(
        EXIT_REFUSED, file_, "has no triangles; bench compares the methods for surfaces");
    }
  }

  Json rowOf(const vtkWindingNumberAlgorithm* filter, double prepare, double evaluate) const
  {
    int dimensions[3];
    grid_->GetDimensions(dimensions);
    const std::string voxels = std::to_string(dimensions[0]) + " x " +
                               std::to_string(dimensions[1]) + " x " +
                               std::to_string(dimensions[2]);
    return {{"voxels", voxels}, {"method", filter->GetMethodUsed()}, {"prepare s", prepare},
      {"evaluate s", evaluate}, {"scaled", "no"},
      {"ns/voxel", 1e9 * evaluate / static_cast<double>(grid_->GetNumberOfPoints())},
      {"boundary edges", filter->GetNumberOfNetBoundaryEdges()},
      {"cap triangles", filter->GetNumberOfCapTriangles()}};
  }

  /// Measures whole grids: the least times of up to five.
  Json rowOfGrid(int method, int resolution)
  {
    vtkSmartPointer<vtkWindingNumberField> field;
    double prepare = 0, evaluate = 0;
    const Stopwatch all;
    for (int run = 0; run < 5 && (run == 0 || all.seconds() < longTime); ++run)
    {
      field = this->filterFor<vtkWindingNumberField>(method);
      field->SetInputData(source_);
      field->SetResolution(resolution);
      field->SetVerifySamples(method == vtkWindingNumberField::PARITY ? 0 : verified);
      this->execute(field);
      prepare =
        run == 0 ? field->GetPrepareSeconds() : std::min(prepare, field->GetPrepareSeconds());
      evaluate =
        run == 0 ? field->GetEvaluateSeconds() : std::min(evaluate, field->GetEvaluateSeconds());
    }
    grid_ = field->GetOutput();
    triangles_ = field->GetNumberOfPrimitives();
    Json row = this->rowOf(field, prepare, evaluate);
    row["max error"] = field->GetMaxError();
    row["RMS error"] = field->GetRMSError();
    row["near max error"] =
      field->GetNumberOfNearVerifiedSamples() > 0 ? Json(field->GetNearMaxError()) : Json(nullptr);
    if (method == vtkWindingNumberField::PARITY)
    {
      this->addErrors(this->probeAt(verified, method, VTK_FLOAT), row); // no filter verifies it
    }
    return row;
  }

  /// Measures a whole grid, or random voxels of it where it would take more than `longTime`.
  Json rowOfLongMethod(int method, int resolution)
  {
    const double voxels = static_cast<double>(grid_->GetNumberOfPoints());
    const auto few = std::min(voxels, 1024.0);
    auto probe = this->probeAt(few, method, VTK_FLOAT);
    if (probe->GetEvaluateSeconds() / few * voxels <= longTime)
    {
      return this->rowOfGrid(method, resolution);
    }
    const double count = std::clamp(longTime / 4 / probe->GetEvaluateSeconds() * few, few, voxels);
    probe = this->probeAt(std::floor(count), method, VTK_FLOAT);
    Json row =
      this->rowOf(probe, probe->GetPrepareSeconds(), probe->GetEvaluateSeconds() / count * voxels);
    row["scaled"] = "yes";
    this->addErrors(probe, row);
    return row;
  }

  /// Compares a probe of random voxels with direct sums.
  void addErrors(vtkWindingNumberProbe* probe, Json& row)
  {
    const auto exact = this->probeAt(verified, vtkWindingNumberField::DIRECT, VTK_DOUBLE);
    double largest = 0, squares = 0;
    for (int i = 0; i < verified; ++i)
    {
      const double error = std::abs(valueOf(probe, i) - valueOf(exact, i));
      largest = std::max(largest, error);
      squares += error * error;
    }
    row["max error"] = largest;
    row["RMS error"] = std::sqrt(squares / verified);
    row["near max error"] = nullptr;
  }

  static double valueOf(vtkWindingNumberProbe* probe, vtkIdType point)
  {
    return probe->GetOutput()->GetPointData()->GetArray("WindingNumber")->GetComponent(point, 0);
  }

  /// Evaluates random voxels, the same in every call.
  vtkSmartPointer<vtkWindingNumberProbe> probeAt(double count, int method, int type)
  {
    vtkNew<vtkMinimalStandardRandomSequence> random;
    random->Initialize(20260101);
    const auto voxels = static_cast<double>(grid_->GetNumberOfPoints());
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (double i = 0; i < count; ++i, random->Next())
    {
      points->InsertNextPoint(
        grid_->GetPoint(static_cast<vtkIdType>(random->GetRangeValue(0, voxels - 1))));
    }
    vtkNew<vtkPolyData> queries;
    queries->SetPoints(points);
    auto probe = this->filterFor<vtkWindingNumberProbe>(method);
    probe->SetInputData(queries);
    probe->SetSourceData(source_);
    probe->SetOutputScalarType(type);
    this->execute(probe);
    return probe;
  }

  const std::string file_;
  const Options& options_;
  Messages& messages_;
  vtkSmartPointer<vtkDataObject> source_;
  vtkSmartPointer<vtkImageData> grid_; ///< the field that was made last
  vtkIdType triangles_ = 0;
};

} // namespace

void runBench(const Options& options, Messages& messages)
{
  std::vector<BenchTable> tables;
  for (const std::string& file : options.inputs)
  {
    tables.push_back(MethodsBench(file, options, messages).table());
  }
  printTables(tables, options.threads, options.json);
}
