#include "FieldRun.h"

#include "Failure.h"
#include "FilterSettings.h"
#include "Interrupt.h"
#include "Options.h"
#include "Progress.h"
#include "ReadInput.h"
#include "WriteOutput.h"

#include "vtkCommand.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <cmath>

FieldRun::FieldRun(
  vtkWindingNumberGridAlgorithm& filter, const Options& options, Messages& messages)
  : options_(options)
  , messages_(messages)
  , filter_(&filter)
{
  const auto input = readInput(options.input, options, messages);
  readSeconds_ = stopwatch_.total();
  filter_->SetInputDataObject(input);
  applyMethod(options, filter_);
  applyGrid(options, filter_);
  startObserver_ = filter_->AddObserver(vtkCommand::StartEvent, this, &FieldRun::startExecution);
  endObserver_ = filter_->AddObserver(vtkCommand::EndEvent, this, &FieldRun::addExecution);
  filter_->UpdateInformation();
  this->check();
  warnOfIdleOptions(options, *filter_, messages);
}

FieldRun::~FieldRun()
{
  filter_->RemoveObserver(startObserver_);
  filter_->RemoveObserver(endObserver_);
}

void FieldRun::update()
{
  const Progress progress(filter_, "field", options_.quiet);
  filter_->Update();
  this->check();
}

void FieldRun::write(OutputFile& file)
{
  const Progress progress(filter_, "field", options_.quiet);
  const Stopwatch writing;
  const double before = executionSeconds_;
  writeImage(filter_->GetOutputPort(), file, options_, messages_, [this] { checkExecutions(); });
  writeSeconds_ = writing.total() - (executionSeconds_ - before);
}

void FieldRun::write(vtkPolyData* surface, OutputFile& file)
{
  const Stopwatch writing;
  writeSurface(surface, file, options_, messages_);
  writeSeconds_ = writing.total();
}

void FieldRun::check()
{
  checkFilter(filter_->GetStatus(), options_.input, messages_);
}

void FieldRun::checkExecutions()
{
  interrupt::check();
  if (status_ != vtkWindingNumberAlgorithm::DONE)
  {
    checkFilter(status_, options_.input, messages_);
  }
}

void FieldRun::startExecution()
{
  execution_ = Stopwatch();
}

void FieldRun::addExecution()
{
  const double seconds = execution_.total();
  executionSeconds_ += seconds;
  if (status_ == vtkWindingNumberAlgorithm::DONE)
  {
    status_ = filter_->GetStatus();
  }
  prepareSeconds_ += filter_->GetPrepareSeconds();
  expectedSeconds_ = filter_->GetExpectedSeconds();
  expectedMemory_ = filter_->GetExpectedMemory();
  evaluateSeconds_ += filter_->GetEvaluateSeconds();
  if (options_.verify > 0)
  {
    // The filter's own figures leave this one over, and next to nothing beside it.
    verifySeconds_ +=
      std::max(0.0, seconds - filter_->GetPrepareSeconds() - filter_->GetEvaluateSeconds());
  }
  const vtkIdType samples = filter_->GetNumberOfVerifiedSamples();
  maxError_ = std::max(maxError_, filter_->GetMaxError());
  nearMaxError_ = std::max(nearMaxError_, filter_->GetNearMaxError());
  sumOfSquares_ += std::pow(filter_->GetRMSError(), 2) * static_cast<double>(samples);
  verified_ += samples;
  nearVerified_ += filter_->GetNumberOfNearVerifiedSamples();
}

Json FieldRun::describeGrid() const
{
  int voxels[3];
  double firstSample[3], spacing[3];
  filter_->GetGrid(voxels, firstSample, spacing);
  Json dimensions, origins, spacings, bounds;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = firstSample[axis] - spacing[axis] / 2;
    dimensions.push_back(voxels[axis]);
    origins.push_back(options_.cells ? low : firstSample[axis]);
    spacings.push_back(spacing[axis]);
    bounds.push_back(low);
    bounds.push_back(low + voxels[axis] * spacing[axis]);
  }
  return {{"dimensions", dimensions}, {"origin", origins}, {"spacing", spacings},
    {"bounds", bounds}, {"association", options_.cells ? "cells" : "points"}};
}

/// In the unit of the input.
double FieldRun::distanceBand() const
{
  int voxels[3];
  double firstSample[3], spacing[3];
  filter_->GetGrid(voxels, firstSample, spacing);
  return options_.distanceBand * *std::max_element(spacing, spacing + 3);
}

void FieldRun::addErrors(Json& report) const
{
  // Null where the grid does not reach the source, so that nothing could be compared.
  const auto errorOf = [](vtkIdType samples, double error)
  {
    return samples > 0 ? Json(error) : Json(nullptr);
  };
  report["max_error"] = errorOf(verified_, maxError_);
  report["rms_error"] = errorOf(
    verified_, std::sqrt(sumOfSquares_ / std::max<double>(1, static_cast<double>(verified_))));
  report["near_max_error"] = errorOf(nearVerified_, nearMaxError_);
}

Json FieldRun::report()
{
  Json seconds = {
    {"read", readSeconds_}, {"prepare", prepareSeconds_}, {"evaluate", evaluateSeconds_}};
  if (options_.verify > 0)
  {
    seconds["verify"] = verifySeconds_;
  }
  seconds["write"] = writeSeconds_;
  seconds["total"] = stopwatch_.total();
  Json report = {{"input", describeInput(options_.input, *filter_)},
    {"method", filter_->GetMethodUsed()}, {"why", filter_->GetMethodReason()},
    {"tolerance", options_.tolerance}, {"grid", this->describeGrid()},
    {"expected", {{"seconds", expectedSeconds_}, {"memory", expectedMemory_}}},
    {"seconds", seconds}, {"peak_memory", peakMemory()}, {"threads", threadsOf(options_)}};
  if (report["method"] == "rows")
  {
    report["cap_triangles"] = filter_->GetNumberOfCapTriangles();
  }
  if (options_.distance)
  {
    report["distance_band"] =
      options_.distanceBand > 0 ? Json(this->distanceBand()) : Json(nullptr);
  }
  if (options_.verify > 0)
  {
    this->addErrors(report);
  }
  return report;
}

std::string FieldRun::summary(const Json& report) const
{
  const Json& input = report["input"];
  const Json& grid = report["grid"]["dimensions"];
  const std::string about =
    input["kind"] == "surface"
      ? "surface, " + input["primitives"].dump() + " triangles, " + input["boundary_edges"].dump() +
          " boundary edges"
      : input["primitives"].dump() + " points, mean area " +
          shown(input["mean_area"].get<double>(), 3) +
          (input["normals_estimated"] == true
              ? ", estimated normals, clear at " +
                  shown(std::round(100 * input["clear_share"].get<double>()), 3) + " %"
              : "");
  std::string text =
    options_.input + ": " + about + "\n" + "method " + report["method"].get<std::string>() + " (" +
    report["why"].get<std::string>() + "), " + std::to_string(grid[0].get<int>()) + " x " +
    std::to_string(grid[1].get<int>()) + " x " + std::to_string(grid[2].get<int>()) + " voxels, " +
    shown(report["seconds"]["total"].get<double>(), 3) + " s\n";
  if (options_.verify > 0)
  {
    text += "error max " + report["max_error"].dump() + ", rms " + report["rms_error"].dump() +
            ", max near the surface " + report["near_max_error"].dump() + "\n";
  }
  return text + "wrote " + options_.output;
}
