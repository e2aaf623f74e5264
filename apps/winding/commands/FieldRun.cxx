#include "commands/FieldRun.h"

#include "commands/CommandFiles.h"
#include "commands/FilterSettings.h"
#include "options/Options.h"
#include "program/Interrupt.h"
#include "program/Messages.h"
#include "program/ParallelRun.h"
#include "program/Progress.h"

#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkPointSet.h"

#include <algorithm>

FieldRun::FieldRun(
  vtkWindingNumberGridAlgorithm& filter, const Options& options, Messages& messages)
  : filter_(filter)
  , options_(options)
  , messages_(messages)
  , report_(filter, options)
{
  const Stopwatch reading;
  const vtkSmartPointer<vtkDataObject> input = readSource(options, messages);
  report_.setReadSeconds(reading.seconds());
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
  if (slabs.size() < wanted && options_.pieces > 1)
  {
    this->warnOfPieces(slabs.size());
  }
  return slabs;
}

void FieldRun::warnOfPieces(std::size_t most) const
{
  messages_.warn(options_.input + ": --pieces " + std::to_string(options_.pieces) +
                 " is more than the grid can be cut into; it is written in " +
                 std::to_string(most));
}

vtkImageData* FieldRun::makeSlab(const std::vector<SlabExtent>& slabs, std::size_t number)
{
  isIdle_ = number >= slabs.size();
  const int last = options_.cells ? 1 : 0;
  const SlabExtent extent = isIdle_ ? SlabExtent{0, last, 0, last, 0, last} : slabs[number];
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
      this->check();
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
