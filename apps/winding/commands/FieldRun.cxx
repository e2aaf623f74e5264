// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/FieldRun.h"

#include "commands/CommandFiles.h"
#include "commands/FilterSettings.h"
#include "files/Formats.h"
#include "options/Options.h"
#include "output/ImageFile.h"
#include "program/Interrupt.h"
#include "program/Messages.h"
#include "program/ParallelRun.h"
#include "program/Progress.h"

#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkWindingNumberImageAlgorithm.h"

#include <algorithm>

FieldRun::FieldRun(
  vtkWindingNumberGridAlgorithm& filter, const Options& options, Messages& messages)
  : filter_(filter)
  , options_(options)
  , messages_(messages)
  , report_(filter, options)
{
  const Stopwatch reading;
  like_ = readLike(options, messages);
  parallel::agree([this] { this->checkPiecesKeepDirections(); });
  const vtkSmartPointer<vtkDataObject> input = readSource(options, messages);
  report_.setReadSeconds(reading.seconds());
  report_.setLike(like_);
  if (auto* image = vtkWindingNumberImageAlgorithm::SafeDownCast(&filter_))
  {
    image->SetLikeData(like_.image);
  }
  filter_.SetInputDataObject(input);
  filter_.SetSourceDistribution(vtkWindingNumberAlgorithm::DISTRIBUTED);
  applyMethod(options, &filter_);
  applyGrid(options, &filter_);
  startObserver_ = filter_.AddObserver(vtkCommand::StartEvent, this, &FieldRun::startExecution);
  endObserver_ = filter_.AddObserver(vtkCommand::EndEvent, this, &FieldRun::addExecution);
  parallel::agree(
    [this]
    {
      filter_.UpdateInformation();
      this->check();
    });
  warnOfIdleOptions(options, filter_, messages);
  parallel::agreeOnFirst([this] { this->checkOutput(); });
}

FieldRun::~FieldRun()
{
  filter_.RemoveObserver(startObserver_);
  filter_.RemoveObserver(endObserver_);
}

void FieldRun::update()
{
  this->execute([this] { filter_.Update(); });
}

void FieldRun::execute(const std::function<void()>& update)
{
  const Progress progress(&filter_, Phase::evaluating, messages_.isQuiet());
  parallel::agree(
    [&]
    {
      update();
      this->check();
    });
}

int FieldRun::pieces() const
{
  // VTK halves the longest side again and again; more pieces than it has steps between samples (or
  // cells, which are voxels then) would be empty, or keep VTK busy for ever.
  int voxels[3];
  double firstSample[3], spacing[3];
  filter_.GetGrid(voxels, firstSample, spacing);
  const int most = std::max(1, *std::max_element(voxels, voxels + 3) - (options_.cells ? 0 : 1));
  if (options_.pieces > most)
  {
    this->warnOfPieces(static_cast<std::size_t>(most));
  }
  return std::min(options_.pieces, most);
}

std::vector<SlabExtent> FieldRun::slabs(std::size_t wanted, bool overlap) const
{
  int voxels[3];
  double firstSample[3], spacing[3];
  filter_.GetGrid(voxels, firstSample, spacing);
  std::vector<SlabExtent> slabs = slabsOf(voxels, options_.cells, overlap, wanted);
  // The image that the result lies on may begin elsewhere than at 0.
  const SlabExtent whole = this->wholeExtent();
  for (SlabExtent& slab : slabs)
  {
    const int first = whole[4] + slab[4], last = std::min(whole[4] + slab[5], whole[5]);
    slab = {whole[0], whole[1], whole[2], whole[3], first, last};
  }
  if (slabs.size() < wanted && options_.pieces > 1)
  {
    this->warnOfPieces(slabs.size());
  }
  return slabs;
}

/// Throws Failure for pieces of an image that is turned: no VTK up to 9.7 reads directions of them.
void FieldRun::checkPiecesKeepDirections() const
{
  if (like_.image && suffixOf(options_.output) == ".pvti" &&
      !like_.image->GetDirectionMatrix()->IsIdentity())
  {
    throw Failure(EXIT_REFUSED, options_.output,
      "would lose the directions of " + options_.like +
        ", for VTK reads none from .pvti; give it the suffix .vti");
  }
}

/// Throws Failure, before anything is computed, where the output cannot hold the grid.
void FieldRun::checkOutput() const
{
  if (isMedical(suffixOf(options_.output)))
  {
    const vtkNew<vtkImageData> image;
    image->SetExtent(this->wholeExtent().data());
    image->CopyInformationFromPipeline(this->imageInformation());
    checkMedicalImage(this->placed(image), options_.output, messages_);
  }
}

PlacedImage FieldRun::placed(vtkImageData* image) const
{
  PlacedImage placed = like_;
  placed.image = image;
  return placed;
}

/// Returns the pipeline's information on the image: the only output, or the one after a surface.
vtkInformation* FieldRun::imageInformation() const
{
  return filter_.GetOutputInformation(filter_.GetNumberOfOutputPorts() - 1);
}

SlabExtent FieldRun::wholeExtent() const
{
  SlabExtent extent;
  this->imageInformation()->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent.data());
  return extent;
}

void FieldRun::warnOfPieces(std::size_t most) const
{
  const std::string ofRanks =
    parallel::isAlone() ? "" : " on each of " + std::to_string(parallel::count()) + " ranks";
  messages_.warn(options_.input + ": --pieces " + std::to_string(options_.pieces) + ofRanks +
                 " is more than the grid can be cut into; it is written in " +
                 std::to_string(most));
}

vtkImageData* FieldRun::makeSlab(const std::vector<SlabExtent>& slabs, std::size_t number)
{
  isIdle_ = number >= slabs.size();
  SlabExtent extent = isIdle_ ? this->wholeExtent() : slabs[number];
  for (std::size_t axis = 0; isIdle_ && axis < 3; ++axis)
  {
    extent[2 * axis + 1] =
      std::min(extent[2 * axis] + (options_.cells ? 1 : 0), extent[2 * axis + 1]);
  }
  // The memory is free for the next slab; and the filter executes even if the last one had it all.
  filter_.GetOutputDataObject(0)->ReleaseData();
  this->execute([&] { filter_.UpdateExtent(extent.data()); });
  return isIdle_ ? nullptr : vtkImageData::SafeDownCast(filter_.GetOutputDataObject(0));
}

void FieldRun::check()
{
  checkFilter(filter_.GetStatus(), options_.input, messages_);
}

void FieldRun::checkExecutions()
{
  interrupt::check();
  if (status_ != vtkWindingNumberAlgorithm::DONE)
  {
    checkFilter(status_, options_.input, messages_);
  }
}

void FieldRun::printReport()
{
  report_.print();
  parallel::agree(
    [this]
    {
      report_.warnOfPieces();
      // The result has its name, and so it is too late for an interrupted run.
      checkStatus(filter_.GetStatus(), options_.input, messages_);
    });
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
    status_ = filter_.GetStatus();
  }
  report_.addExecution(seconds);
}
