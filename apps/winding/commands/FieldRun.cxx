#include "commands/FieldRun.h"

#include "commands/CommandFiles.h"
#include "commands/FidelityReport.h"
#include "commands/FieldParts.h"
#include "commands/FilterSettings.h"
#include "commands/ReportParts.h"
#include "options/Options.h"
#include "output/OutputFile.h"
#include "output/PiecesFile.h"
#include "output/WriteOutput.h"
#include "program/Interrupt.h"
#include "program/Messages.h"
#include "program/ParallelRun.h"
#include "program/Progress.h"
#include "program/Threads.h"

#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkHyperTreeGrid.h"
#include "vtkImageData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

FieldRun::FieldRun(
  vtkWindingNumberGridAlgorithm& filter, const Options& options, Messages& messages)
  : FieldRun(filter, options, messages,
      [&]() -> vtkSmartPointer<vtkDataObject> { return readOnFirstRank(options.input, messages); })
{
}

FieldRun::FieldRun(vtkWindingNumberGridAlgorithm& filter, const Options& options,
  Messages& messages, const std::function<vtkSmartPointer<vtkDataObject>()>& read)
  : options_(options)
  , messages_(messages)
  , filter_(&filter)
{
  const vtkSmartPointer<vtkDataObject> input = read();
  readSeconds_ = stopwatch_.seconds();
  filter_->SetInputDataObject(input);
  filter_->SetSourceDistribution(vtkWindingNumberAlgorithm::DISTRIBUTED);
  applyMethod(options, filter_);
  applyGrid(options, filter_);
  startObserver_ = filter_->AddObserver(vtkCommand::StartEvent, this, &FieldRun::startExecution);
  endObserver_ = filter_->AddObserver(vtkCommand::EndEvent, this, &FieldRun::addExecution);
  parallel::agree(
    [this]
    {
      filter_->UpdateInformation();
      this->check();
    });
  warnOfIdleOptions(options, *filter_, messages);
}

FieldRun::~FieldRun()
{
  filter_->RemoveObserver(startObserver_);
  filter_->RemoveObserver(endObserver_);
}

void FieldRun::update()
{
  const Progress progress(filter_, Phase::evaluating, messages_.isQuiet());
  parallel::agree(
    [this]
    {
      filter_->Update();
      this->check();
    });
}

void FieldRun::write(OutputFile& file)
{
  Progress::setPieces(this->pieces());
  const Progress progress(filter_, Phase::evaluating, messages_.isQuiet());
  const Stopwatch writing;
  const double before = executionSeconds_;
  writeImage(
    filter_->GetOutputPort(), this->pieces(), file, messages_, [this] { this->checkExecutions(); });
  file.commit();
  writeSeconds_ = writing.seconds() - (executionSeconds_ - before);
}

void FieldRun::write(const PiecesFile& file)
{
  const Stopwatch writing;
  const double before = executionSeconds_;
  const auto perRank = static_cast<std::size_t>(options_.pieces);
  const std::vector<SlabExtent> slabs =
    this->slabs(perRank * static_cast<std::size_t>(parallel::count()), true);
  // Every rank makes as many slabs, for an execution is collective. A rank's own follow each other.
  const std::size_t ranks = static_cast<std::size_t>(parallel::count());
  const std::size_t rounds = (slabs.size() + ranks - 1) / ranks;
  const std::size_t first = rounds * static_cast<std::size_t>(parallel::rank());
  Progress::setPieces(static_cast<int>(rounds));
  SlabExtent whole = slabs.front();
  whole[5] = slabs.back()[5];
  file.write(
    whole, slabs, first, rounds,
    [&](std::size_t round) { return this->makeSlab(slabs, first + round); }, messages_);
  writeSeconds_ = writing.seconds() - (executionSeconds_ - before);
}

vtkSmartPointer<vtkImageData> FieldRun::gather()
{
  if (parallel::isAlone())
  {
    this->update();
    return vtkImageData::SafeDownCast(filter_->GetOutputDataObject(0));
  }
  const std::vector<SlabExtent> slabs =
    this->slabs(static_cast<std::size_t>(parallel::count()), false);
  vtkImageData* const own = this->makeSlab(slabs, static_cast<std::size_t>(parallel::rank()));
  return gatheredImage(own, slabs);
}

void FieldRun::write(vtkImageData* image, OutputFile* file)
{
  const Stopwatch writing;
  parallel::agreeOnFirst(
    [&]
    {
      writeImage(image, *file, messages_);
      file->commit();
    });
  writeSeconds_ = writing.seconds();
}

void FieldRun::write(vtkPolyData* surface, OutputFile* file)
{
  const Stopwatch writing;
  parallel::agreeOnFirst(
    [&]
    {
      writeSurface(surface, *file, messages_);
      file->commit();
      output_ = {{"file", file->name()}, {"points", surface->GetNumberOfPoints()},
        {"cells", surface->GetNumberOfCells()}};
      fidelity_ = describeFidelity(surface);
    });
  writeSeconds_ = writing.seconds();
}

void FieldRun::write(vtkHyperTreeGrid* trees, vtkIdType leaves, OutputFile* file)
{
  const Stopwatch writing;
  parallel::agreeOnFirst(
    [&]
    {
      writeHyperTrees(trees, *file, messages_);
      file->commit();
      vtkDataArray* const tolerance = trees->GetFieldData()->GetArray("MergeTolerance");
      output_ = {{"file", file->name()}, {"cells", leaves},
        {"merge_tolerance", tolerance ? tolerance->GetTuple1(0) : 0}};
    });
  writeSeconds_ = writing.seconds();
}

void FieldRun::print()
{
  this->gatherFigures();
  parallel::agreeOnFirst(
    [this]
    {
      const Json report = this->report();
      if (options_.json)
      {
        ::print(report);
      }
      else if (!options_.quiet)
      {
        ::print(this->summary(report));
      }
    });
}

/// Times and errors become the largest of all ranks, counts their sums.
void FieldRun::gatherFigures()
{
  totalSeconds_ = stopwatch_.seconds();
  for (double* figure : {&readSeconds_, &prepareSeconds_, &evaluateSeconds_, &verifySeconds_,
         &writeSeconds_, &totalSeconds_, &maxError_, &nearMaxError_, &maxErrorBesidePoints_})
  {
    *figure = parallel::maximum(*figure);
  }
  for (vtkIdType* number : {&verified_, &nearVerified_, &onSurface_, &besidePoints_})
  {
    *number = static_cast<vtkIdType>(parallel::sum(static_cast<double>(*number)));
  }
  sumOfSquares_ = parallel::sum(sumOfSquares_);
  peakMemories_ = parallel::ofAll(static_cast<double>(peakMemory()));
}

/// The image of a slab, or null if there are fewer. Then this rank takes part in the execution with
/// a single voxel.
vtkImageData* FieldRun::makeSlab(const std::vector<SlabExtent>& slabs, std::size_t number)
{
  isIdle_ = number >= slabs.size();
  const int last = options_.cells ? 1 : 0;
  const SlabExtent extent = isIdle_ ? SlabExtent{0, last, 0, last, 0, last} : slabs[number];
  // The memory is free for the next slab; and the filter executes even if the last one had it all.
  filter_->GetOutputDataObject(0)->ReleaseData();
  {
    const Progress progress(filter_, Phase::evaluating, messages_.isQuiet());
    parallel::agree(
      [&]
      {
        filter_->UpdateExtent(extent.data());
        this->check();
      });
  }
  return isIdle_ ? nullptr : vtkImageData::SafeDownCast(filter_->GetOutputDataObject(0));
}

std::vector<SlabExtent> FieldRun::slabs(std::size_t wanted, bool overlap) const
{
  int voxels[3];
  double firstSample[3], spacing[3];
  filter_->GetGrid(voxels, firstSample, spacing);
  std::vector<SlabExtent> slabs = slabsOf(voxels, options_.cells, overlap, wanted);
  if (slabs.size() < wanted && options_.pieces > 1)
  {
    messages_.warn(options_.input + ": --pieces " + std::to_string(options_.pieces) +
                   " is more than the grid can be cut into; it is written in " +
                   std::to_string(slabs.size()));
  }
  return slabs;
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
  const double seconds = execution_.seconds();
  executionSeconds_ += seconds;
  if (isIdle_)
  {
    return;
  }
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
    // Verification is the only long work apart from what the filter itself measures.
    verifySeconds_ +=
      std::max(0.0, seconds - filter_->GetPrepareSeconds() - filter_->GetEvaluateSeconds());
  }
  const vtkIdType samples = filter_->GetNumberOfVerifiedSamples();
  maxError_ = std::max(maxError_, filter_->GetMaxError());
  nearMaxError_ = std::max(nearMaxError_, filter_->GetNearMaxError());
  sumOfSquares_ += std::pow(filter_->GetRMSError(), 2) * static_cast<double>(samples);
  verified_ += samples;
  nearVerified_ += filter_->GetNumberOfNearVerifiedSamples();
  onSurface_ += filter_->GetNumberOfSamplesOnSurface();
  besidePoints_ += filter_->GetNumberOfSamplesBesidePoints();
  maxErrorBesidePoints_ = std::max(maxErrorBesidePoints_, filter_->GetMaxErrorBesidePoints());
}

/// The pieces to write. VTK halves the longest side again and again; more pieces than it has steps
/// between samples (or cells, which are voxels then) would be empty, or keep VTK busy for ever.
int FieldRun::pieces() const
{
  int voxels[3];
  double firstSample[3], spacing[3];
  filter_->GetGrid(voxels, firstSample, spacing);
  const int most = std::max(1, *std::max_element(voxels, voxels + 3) - (options_.cells ? 0 : 1));
  if (options_.pieces > most)
  {
    messages_.warn(options_.input + ": --pieces " + std::to_string(options_.pieces) +
                   " is more than the grid can be cut into; it is written in " +
                   std::to_string(most));
  }
  return std::min(options_.pieces, most);
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

/// How far distances reach, in the unit of the input.
double FieldRun::distanceBand() const
{
  int voxels[3];
  double firstSample[3], spacing[3];
  filter_->GetGrid(voxels, firstSample, spacing);
  return options_.distanceBand * *std::max_element(spacing, spacing + 3);
}

void FieldRun::addErrors(Json& report) const
{
  // An error is null where the grid does not reach the source, so that nothing could be compared.
  const auto errorOf = [](vtkIdType samples, double error)
  {
    return samples > 0 ? Json(error) : Json(nullptr);
  };
  report["max_error"] = errorOf(verified_, maxError_);
  report["rms_error"] = errorOf(
    verified_, std::sqrt(sumOfSquares_ / std::max<double>(1, static_cast<double>(verified_))));
  report["near_max_error"] = errorOf(nearVerified_, nearMaxError_);
  report["on_surface"] = onSurface_;
  report["beside_points"] = besidePoints_;
  report["beside_points_max_error"] = errorOf(besidePoints_, maxErrorBesidePoints_);
}

Json FieldRun::report() const
{
  Json seconds = {
    {"read", readSeconds_}, {"prepare", prepareSeconds_}, {"evaluate", evaluateSeconds_}};
  if (options_.verify > 0)
  {
    seconds["verify"] = verifySeconds_;
  }
  seconds["write"] = writeSeconds_;
  seconds["total"] = totalSeconds_;
  Json report = {{"input", describeInput(options_.input, *filter_)},
    {"method", filter_->GetMethodUsed()}, {"why", filter_->GetMethodReason()},
    {"tolerance", options_.tolerance}, {"grid", this->describeGrid()},
    {"expected", {{"seconds", expectedSeconds_}, {"memory", expectedMemory_}}},
    {"seconds", seconds}, {"peak_memory", largestMemory(peakMemories_)},
    {"threads", threadsUsed(options_.threads)}};
  addRanks(report, peakMemories_);
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
  report.update(additions_);
  if (!output_.is_null())
  {
    report["output"] = output_;
  }
  if (!fidelity_.is_null())
  {
    report["fidelity"] = fidelity_;
  }
  return report;
}

std::string FieldRun::errorsInWords(const Json& report) const
{
  if (verified_ + nearVerified_ == 0)
  {
    return besidePoints_ > 0 ? "all samples that could be compared lie beside points"
                             : "no sample could be compared";
  }
  const std::string everywhere = verified_ > 0 ? "error max " + report["max_error"].dump() +
                                                   ", rms " + report["rms_error"].dump()
                                               : "no random sample could be compared";
  return everywhere + (nearVerified_ > 0
                          ? ", max near the surface " + report["near_max_error"].dump()
                          : ", no sample near the surface could be compared");
}

std::string FieldRun::summary(const Json& report) const
{
  const Json& input = report["input"];
  std::string text = options_.input + ": ";
  if (input["kind"] == "surface")
  {
    text += "surface, " + input["primitives"].dump() + " triangles, " +
            input["boundary_edges"].dump() + " boundary edges";
  }
  else
  {
    text += input["primitives"].dump() + " points, mean area " +
            shown(input["mean_area"].get<double>(), 3);
    if (input["normals_estimated"] == true)
    {
      const double percent = std::round(100 * input["clear_share"].get<double>());
      text += ", normals by " + input["normal_estimation"].get<std::string>() + ", clear at " +
              shown(percent, 3) + " %";
    }
  }
  const Json& grid = report["grid"]["dimensions"];
  text += "\nmethod " + report["method"].get<std::string>() + " (" +
          report["why"].get<std::string>() + "), " + grid[0].dump() + " x " + grid[1].dump() +
          " x " + grid[2].dump() + " voxels, " +
          shown(report["seconds"]["total"].get<double>(), 3) + " s\n";
  if (options_.verify > 0)
  {
    text += this->errorsInWords(report) + "\n";
    const std::string all = std::to_string(verified_ + nearVerified_ + onSurface_ + besidePoints_);
    if (besidePoints_ > 0)
    {
      text += std::to_string(besidePoints_) + " of " + all +
              (besidePoints_ == 1 ? " samples lies " : " samples lie ") +
              "beside a point, where w is large: error max " +
              report["beside_points_max_error"].dump() + "\n";
    }
    if (onSurface_ > 0)
    {
      const bool isSurface = input["kind"] == "surface";
      text += std::to_string(onSurface_) + " of " + all +
              (onSurface_ == 1 ? " samples lies " : " samples lie ") +
              (isSurface ? "on the surface, where either side is right"
                         : "at a point, where w has no value") +
              ", and were not compared\n";
    }
  }
  if (!fidelity_.is_null())
  {
    text += fidelityInWords(fidelity_) + "\n";
  }
  text += "wrote " + options_.output;
  if (!output_.is_null())
  {
    text += ": " + (output_.contains("points")
                       ? output_["points"].dump() + " points, " + output_["cells"].dump() + " faces"
                       : output_["cells"].dump() + " cells");
  }
  return text;
}
