// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindingNumberGridAlgorithm.h"

#include "base/Bounds.h"
#include "base/Refusal.h"
#include "field/Field.h"
#include "messages/Options.h"
#include "messages/PropertyChecks.h"
#include "pipeline/FreeMemory.h"
#include "pipeline/Ranks.h"
#include "pipeline/SmpExecutor.h"
#include "private/source/ContentHash.h"
#include "private/source/SourceProperties.h"
#include "report/Verify.h"
#include "source/Grid.h"
#include "tasks/ResultNotes.h"
#include "tasks/Sentences.h"
#include "tasks/WallGrid.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <optional>
#include <set>
#include <utility>

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

winding::Bounds toBounds(const double (&b)[6])
{
  return {Eigen::Vector3d(b[0], b[2], b[4]), Eigen::Vector3d(b[1], b[3], b[5])};
}

/// Returns whether bounds are a box. A user interface that follows an empty input has none, or
/// zeros.
bool isBox(const winding::Bounds& bounds)
{
  return !bounds.isEmpty() && bounds.sizes().allFinite() && bounds.sizes().maxCoeff() > 0;
}

bool areSame(const winding::Bounds& a, const winding::Bounds& b)
{
  return a.min() == b.min() && a.max() == b.max();
}

} // namespace

vtkWindingNumberGridAlgorithm::vtkWindingNumberGridAlgorithm()
  : Request(std::make_unique<winding::GridRequest>())
  , LaidOut(std::make_unique<winding::Grid>())
  , Sampling(std::make_unique<winding::Grid>())
{
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(1);
}

vtkWindingNumberGridAlgorithm::~vtkWindingNumberGridAlgorithm() = default;

int vtkWindingNumberGridAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  FillSourcePortInformation(info);
  return 1;
}

int vtkWindingNumberGridAlgorithm::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  for (int port = 0; port < this->GetNumberOfSourcePorts(); ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      this->RequestSource(inputs[port]->GetInformationObject(i));
    }
  }
  return 1;
}

void vtkWindingNumberGridAlgorithm::CheckProperties()
{
  this->Superclass::CheckProperties();
  winding::checkProperty(winding::Parameter::resolution, this->Resolution);
  winding::checkProperty(winding::Parameter::voxelSize, this->VoxelSize);
  const int* dimensions = this->SamplingDimensions;
  if (dimensions[0] != 0 || dimensions[1] != 0 || dimensions[2] != 0)
  {
    winding::checkDimensions(dimensions);
  }
  winding::checkProperty(winding::Parameter::padding, this->Padding);
  winding::checkProperty(winding::Parameter::verifySamples, this->VerifySamples);
}

void vtkWindingNumberGridAlgorithm::HashProperties(winding::ContentHash& hash)
{
  this->Superclass::HashProperties(hash);
  hash.addValue(this->MendSource);
  hash.addValue(this->Resolution);
  hash.addValue(this->VoxelSize);
  hash.addValue(this->SamplingDimensions);
  hash.addValue(this->UseInputBounds);
  hash.addValue(this->BoundsOverAllTimes);
  hash.addValue(this->SamplingBounds);
  hash.addValue(this->Padding);
}

void vtkWindingNumberGridAlgorithm::GetGrid(
  int dimensions[3], double firstSample[3], double spacing[3]) const
{
  const winding::Grid& grid = *this->Sampling;
  for (int axis = 0; axis < 3; ++axis)
  {
    dimensions[axis] = grid.dimensions[axis];
    firstSample[axis] = grid.firstSample[axis];
    spacing[axis] = grid.spacing[axis];
  }
}

vtkDataObject* vtkWindingNumberGridAlgorithm::MakeSource()
{
  return this->GetInputDataObject(0, 0);
}

std::vector<vtkAlgorithmOutput*> vtkWindingNumberGridAlgorithm::GetSourceConnections()
{
  std::vector<vtkAlgorithmOutput*> connections;
  for (int port = 0; port < this->GetNumberOfSourcePorts(); ++port)
  {
    for (int i = 0; i < this->GetNumberOfInputConnections(port); ++i)
    {
      connections.push_back(this->GetInputConnection(port, i));
    }
  }
  return connections;
}

void vtkWindingNumberGridAlgorithm::UpdateSource(vtkInformation* outInfo)
{
  for (vtkAlgorithmOutput* connection : this->GetSourceConnections())
  {
    this->UpdateConnection(connection, outInfo);
  }
}

void vtkWindingNumberGridAlgorithm::UpdateConnection(
  vtkAlgorithmOutput* connection, vtkInformation* outInfo)
{
  vtkAlgorithm* producer = connection->GetProducer();
  const int port = connection->GetIndex();
  vtkNew<vtkInformation> request;
  producer->UpdateInformation();
  vtkInformation* produced = producer->GetOutputInformation(port);
  if (produced->Has(Pipeline::WHOLE_EXTENT()))
  {
    request->Set(Pipeline::WHOLE_EXTENT(), produced->Get(Pipeline::WHOLE_EXTENT()), 6);
  }
  this->RequestSource(request);
  request->Remove(Pipeline::WHOLE_EXTENT());
  if (outInfo->Has(Pipeline::UPDATE_TIME_STEP()))
  {
    request->Set(Pipeline::UPDATE_TIME_STEP(), outInfo->Get(Pipeline::UPDATE_TIME_STEP()));
  }
  vtkNew<vtkInformationVector> requests;
  requests->SetNumberOfInformationObjects(port + 1);
  requests->SetInformationObject(port, request);
  if (!producer->Update(port, requests))
  {
    throw winding::Refusal(winding::messageOf(winding::Sentence::producerFailed));
  }
}

/// The times of all sources.
struct vtkWindingNumberGridAlgorithm::Times
{
  std::set<double> steps;
  double current = 0;        ///< the time of the first source that has times, or its first one
  bool isContinuous = false; ///< whether a source has a range of times without steps
  winding::ContentHash hash;
};

vtkWindingNumberGridAlgorithm::Times vtkWindingNumberGridAlgorithm::GetTimes()
{
  Times times;
  vtkInformation* moving = nullptr;
  for (vtkAlgorithmOutput* connection : this->GetSourceConnections())
  {
    vtkAlgorithm* producer = connection->GetProducer();
    producer->UpdateInformation();
    vtkInformation* produced = producer->GetOutputInformation(connection->GetIndex());
    const int count = produced->Length(Pipeline::TIME_STEPS());
    const double* const first = count > 0 ? produced->Get(Pipeline::TIME_STEPS()) : nullptr;
    times.steps.insert(first, first + count);
    times.isContinuous =
      times.isContinuous || (count == 0 && produced->Has(Pipeline::TIME_RANGE()));
    moving = moving || count == 0 ? moving : produced;
    times.hash.addValue(reinterpret_cast<std::uintptr_t>(producer));
    times.hash.addValue(connection->GetIndex());
    times.hash.addValue(
      vtkDemandDrivenPipeline::SafeDownCast(producer->GetExecutive())->GetPipelineMTime());
  }
  if (moving)
  {
    times.current = moving->Has(Pipeline::UPDATE_TIME_STEP())
                      ? moving->Get(Pipeline::UPDATE_TIME_STEP())
                      : *times.steps.begin();
  }
  return times;
}

/// Has the source at each of its times and calls `work`. Then has it at the time that `outInfo`
/// asks for; who asks for none gets the source as it was.
void vtkWindingNumberGridAlgorithm::Visit(
  const Times& times, vtkInformation* outInfo, const std::function<void()>& work)
{
  vtkNew<vtkInformation> request;
  std::exception_ptr failure;
  try
  {
    for (const double step : times.steps)
    {
      request->Set(Pipeline::UPDATE_TIME_STEP(), step);
      // Where one rank fails, all restore the source, which may be an execution of all ranks, too.
      this->GetRanks().agree(
        [&]
        {
          this->UpdateSource(request);
          work();
        });
    }
  }
  catch (...)
  {
    failure = std::current_exception();
  }
  // Whoever asks next finds the source at its time, even after a failure, which is reported first.
  request->Set(Pipeline::UPDATE_TIME_STEP(), outInfo->Has(Pipeline::UPDATE_TIME_STEP())
                                               ? outInfo->Get(Pipeline::UPDATE_TIME_STEP())
                                               : times.current);
  try
  {
    this->UpdateSource(request);
  }
  catch (const winding::Refusal&)
  {
    failure = failure ? failure : std::current_exception();
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}

void vtkWindingNumberGridAlgorithm::AgreeOnTimes(const Times& times)
{
  const auto hash = [&times]
  {
    winding::ContentHash steps;
    for (const double step : times.steps)
    {
      steps.addValue(step);
    }
    return steps.value();
  };
  if (!winding::areEqual(this->GetRanks().allGather(hash)))
  {
    throw winding::Refusal(winding::messageOf(winding::Sentence::otherTimesOnRanks));
  }
}

bool vtkWindingNumberGridAlgorithm::HasTimeSteps()
{
  const Times times = this->GetTimes();
  if (times.isContinuous)
  {
    throw winding::Refusal(winding::messageOf(winding::Sentence::noTimeSteps));
  }
  return !times.steps.empty();
}

bool vtkWindingNumberGridAlgorithm::ForEachTime(
  vtkInformation* outInfo, const std::function<void(std::size_t number, std::size_t count)>& work)
{
  const Times times = this->GetTimes();
  this->AgreeOnTimes(times);
  std::size_t number = 0;
  if (!times.steps.empty())
  {
    this->Visit(times, outInfo, [&] { work(number++, times.steps.size()); });
  }
  return !times.steps.empty();
}

void vtkWindingNumberGridAlgorithm::HashBounds(winding::ContentHash& hash)
{
  hash.addValue(winding::hashOf(this->GetSourceOptions()));
}

void vtkWindingNumberGridAlgorithm::FindBoundsOverAllTimes(vtkInformation* outInfo)
{
  Times times = this->GetTimes();
  const bool isAsked = this->UseInputBounds && (this->BoundsOverAllTimes || this->IsOfAllTimes());
  this->GetRanks().requireSame([isAsked]() -> winding::Ranks::Number { return isAsked; });
  if (isAsked)
  {
    this->AgreeOnTimes(times);
  }
  if (!isAsked || times.steps.empty())
  {
    this->BoundsOfTimes.clear();
    return;
  }
  this->HashBounds(times.hash);
  const auto areKept = [&]
  {
    return !this->BoundsOfTimes.empty() && this->SourceOfTimes == times.hash.value();
  };
  if (this->GetRanks().allOf(areKept))
  {
    return;
  }
  winding::Bounds all;
  this->Visit(times, outInfo,
    [&]
    {
      double bounds[6];
      if (this->GetSourceBounds(this->MakeSource(), bounds))
      {
        all.extend(toBounds(bounds).min());
        all.extend(toBounds(bounds).max());
      }
    });
  this->BoundsOfTimes.clear();
  for (int axis = 0; axis < 3 && !all.isEmpty(); ++axis)
  {
    this->BoundsOfTimes.insert(this->BoundsOfTimes.end(), {all.min()[axis], all.max()[axis]});
  }
  this->SourceOfTimes = times.hash.value();
}

/// Finds the bounds that UseInputBounds lays the grid over; returns whether there are any.
bool vtkWindingNumberGridAlgorithm::GetBoundsOfGrid(vtkDataObject* source, double bounds[6])
{
  if (!this->BoundsOfTimes.empty())
  {
    std::copy(this->BoundsOfTimes.begin(), this->BoundsOfTimes.end(), bounds);
  }
  else if (!this->GetSourceBounds(source, bounds))
  {
    return false;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] -= this->GetReachBeyondSource();
    bounds[2 * axis + 1] += this->GetReachBeyondSource();
  }
  return true;
}

winding::GridRequest vtkWindingNumberGridAlgorithm::GetGridRequest(vtkDataObject* source)
{
  winding::GridRequest request;
  double bounds[6];
  if (this->UseInputBounds && this->GetBoundsOfGrid(source, bounds))
  {
    request.bounds = toBounds(bounds);
    request.padding = this->Padding;
  }
  else
  {
    request.bounds = toBounds(this->SamplingBounds);
    if (this->UseInputBounds && !isBox(request.bounds))
    {
      throw winding::Refusal(winding::messageOf(winding::Sentence::noBounds));
    }
  }
  request.dimensions = Eigen::Vector3i(this->SamplingDimensions);
  request.voxelSize = this->VoxelSize;
  request.resolution = this->Resolution;
  return request;
}

void vtkWindingNumberGridAlgorithm::AddSolids(vtkDataObject* source, winding::WallGrid& grid)
{
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  executor.setShare(0, 0);
  grid.add(this->FieldOf(source, executor), this->GetInsideTest(), this->MendsSource(), executor);
}

/// Returns the number of voxels that the walls of a source ask for.
int vtkWindingNumberGridAlgorithm::GetWallResolution(vtkDataObject* source)
{
  winding::WallGrid grid(*this->Request);
  const bool isGiven = this->Request->voxelSize > 0 || this->SamplingDimensions[0] != 0;
  if (!isGiven && this->UseInputBounds && this->GetRanks().isAlone())
  {
    this->SetProgressText("Preparing");
    const winding::Clock::time_point start = winding::Clock::now();
    this->AddSolids(source, grid);
    this->WallSeconds = winding::secondsSince(start);
  }
  this->ResolutionReason = grid.reason();
  return grid.resolution();
}

void vtkWindingNumberGridAlgorithm::SetUpGrid(vtkDataObject* source)
{
  this->ResolutionReason.clear();
  *this->Request = this->GetGridRequest(source);
  if (this->Request->resolution == 0)
  {
    this->Request->resolution = this->GetWallResolution(source);
  }
  *this->LaidOut = winding::setUpGrid(*this->Request);
  *this->Sampling = *this->LaidOut;
}

void vtkWindingNumberGridAlgorithm::MoveGrid(vtkDataObject* source)
{
  double bounds[6];
  *this->Sampling = *this->LaidOut;
  if (!this->UseInputBounds || !this->GetBoundsOfGrid(source, bounds) ||
      areSame(toBounds(bounds), this->Request->bounds))
  {
    return;
  }
  winding::GridRequest request = *this->Request;
  request.bounds = toBounds(bounds);
  request.padding = this->Padding;
  request.isCubic = request.dimensions == Eigen::Vector3i::Zero();
  request.dimensions = this->LaidOut->dimensions;
  *this->Sampling = winding::setUpGrid(request);
}

void vtkWindingNumberGridAlgorithm::UseGrid(const winding::Grid& grid)
{
  *this->LaidOut = grid;
  *this->Sampling = grid;
}

const winding::Field& vtkWindingNumberGridAlgorithm::PrepareGridField(vtkDataObject* source)
{
  const auto makers =
    static_cast<std::size_t>(this->WorksOnFirstRank() ? 1 : this->GetRanks().count());
  const winding::Grid& grid = this->GetSampling();
  const winding::Field& field =
    this->PrepareField(source, grid, winding::sampleCount(grid.wholeExtent()) / makers);
  this->PrepareSeconds += std::exchange(this->WallSeconds, 0);
  return field;
}

const winding::Field& vtkWindingNumberGridAlgorithm::PrepareGridFieldOf(
  vtkDataObject* source, const std::string& name)
{
  try
  {
    return this->PrepareGridField(source);
  }
  catch (const winding::OutOfMemory&)
  {
    throw;
  }
  catch (const winding::Refusal& refusal)
  {
    winding::Message message = refusal.message();
    message.facts += (message.facts.empty() ? "solid '" : ", solid '") + name + "'";
    throw winding::Refusal(message);
  }
}

void vtkWindingNumberGridAlgorithm::WarnOfResult(
  const winding::Field& field, winding::ResultOnGrid result)
{
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  executor.setShare(1, 1);
  winding::Run run = this->MakeRun(executor);
  result.mayTouchVoxels = this->MayTouchVoxels();
  result.takesTouchedVoxels = this->TakesTouchedVoxels();
  this->SourceIsInsideOut =
    winding::warnOfResult(field, this->GetSampling(), result, this->GetInsideTest(), run)
      .isInsideOut;
}

void vtkWindingNumberGridAlgorithm::CheckVerification(bool hasValues) const
{
  if (this->VerifySamples > 0 && this->Method == PARITY)
  {
    throw winding::Refusal(winding::messageOf(winding::Sentence::parityIsNotVerified));
  }
  if (this->VerifySamples > 0 && !hasValues)
  {
    throw winding::Refusal(winding::messageOf(winding::Sentence::onlyWindingIsVerified));
  }
}

void vtkWindingNumberGridAlgorithm::Verify(
  const winding::Field& field, const winding::Extent& samples, vtkDataArray* values)
{
  this->Verify(field, samples,
    [values](std::size_t n) { return values->GetComponent(static_cast<vtkIdType>(n), 0); });
}

void vtkWindingNumberGridAlgorithm::Verify(const winding::Field& field,
  const winding::Extent& samples, const std::function<double(std::size_t)>& valueOf)
{
  this->SetVerification(winding::Verification());
  if (this->VerifySamples > 0)
  {
    constexpr unsigned seed = 20260101;
    winding::SmpExecutor executor(this, this->NumberOfThreads);
    this->SetVerification(winding::verify(field, *this->Sampling, samples, valueOf,
      static_cast<std::size_t>(this->VerifySamples), seed, executor));
  }
}

void vtkWindingNumberGridAlgorithm::VerifyAnother(
  const winding::Field& field, const winding::Extent& extent)
{
  if (this->VerifySamples == 0 || field.info().primitives == 0)
  {
    return;
  }
  const double maxError = this->MaxError, nearMaxError = this->NearMaxError;
  const double besideMaxError = this->MaxErrorBesidePoints;
  const double squares = std::pow(this->RMSError, 2) * this->NumberOfVerifiedSamples;
  const vtkIdType verified = this->NumberOfVerifiedSamples;
  const vtkIdType near = this->NumberOfNearVerifiedSamples;
  const vtkIdType onSurface = this->NumberOfSamplesOnSurface;
  const vtkIdType besidePoints = this->NumberOfSamplesBesidePoints;

  const std::size_t samples = winding::sampleCount(extent);
  winding::refuseBeyondFreeMemory(static_cast<double>(samples * sizeof(float)),
    "the verification of " + std::to_string(samples) + " voxels",
    {{"verify fewer voxels at a time", {winding::Parameter::pieces}}});
  std::vector<float> values(samples);
  winding::FieldOutput output;
  output.values = values.data();
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  executor.setShare(1, 1);
  field.evaluate(this->GetSampling(), extent, output, executor);
  this->Verify(field, extent, [&values](std::size_t n) { return values[n]; });

  const double more = std::pow(this->RMSError, 2) * this->NumberOfVerifiedSamples;
  this->MaxError = std::max(maxError, this->MaxError);
  this->NearMaxError = std::max(nearMaxError, this->NearMaxError);
  this->MaxErrorBesidePoints = std::max(besideMaxError, this->MaxErrorBesidePoints);
  this->NumberOfVerifiedSamples += verified;
  this->NumberOfNearVerifiedSamples += near;
  this->NumberOfSamplesOnSurface += onSurface;
  this->NumberOfSamplesBesidePoints += besidePoints;
  this->RMSError = std::sqrt((squares + more) / std::max<double>(1, this->NumberOfVerifiedSamples));
}

void vtkWindingNumberGridAlgorithm::SetVerification(const winding::Verification& found)
{
  this->MaxError = found.everywhere.max;
  this->RMSError = found.everywhere.rms();
  this->NearMaxError = found.nearSurface.max;
  this->NumberOfVerifiedSamples = static_cast<vtkIdType>(found.everywhere.samples);
  this->NumberOfNearVerifiedSamples = static_cast<vtkIdType>(found.nearSurface.samples);
  this->NumberOfSamplesOnSurface = static_cast<vtkIdType>(found.onSurface);
  this->NumberOfSamplesBesidePoints = static_cast<vtkIdType>(found.besidePoints.samples);
  this->MaxErrorBesidePoints = found.besidePoints.max;
}

void vtkWindingNumberGridAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const int* dimensions = this->SamplingDimensions;
  const double* bounds = this->SamplingBounds;
  os << indent << "MendSource: " << this->MendSource << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "VoxelSize: " << this->VoxelSize << "\n";
  os << indent << "SamplingDimensions: " << dimensions[0] << " " << dimensions[1] << " "
     << dimensions[2] << "\n";
  os << indent << "UseInputBounds: " << this->UseInputBounds << "\n";
  os << indent << "BoundsOverAllTimes: " << this->BoundsOverAllTimes << "\n";
  os << indent << "SamplingBounds: " << bounds[0] << " " << bounds[1] << " " << bounds[2] << " "
     << bounds[3] << " " << bounds[4] << " " << bounds[5] << "\n";
  os << indent << "Padding: " << this->Padding << "\n";
  os << indent << "VerifySamples: " << this->VerifySamples << "\n";
  os << indent << "ResolutionReason: " << this->ResolutionReason << "\n";
  os << indent << "MaxError: " << this->MaxError << "\n";
  os << indent << "RMSError: " << this->RMSError << "\n";
  os << indent << "NearMaxError: " << this->NearMaxError << "\n";
  os << indent << "NumberOfVerifiedSamples: " << this->NumberOfVerifiedSamples << "\n";
  os << indent << "NumberOfNearVerifiedSamples: " << this->NumberOfNearVerifiedSamples << "\n";
  os << indent << "NumberOfSamplesOnSurface: " << this->NumberOfSamplesOnSurface << "\n";
  os << indent << "NumberOfSamplesBesidePoints: " << this->NumberOfSamplesBesidePoints << "\n";
  os << indent << "MaxErrorBesidePoints: " << this->MaxErrorBesidePoints << "\n";
}
