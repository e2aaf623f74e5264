#include "vtkWindingNumberField.h"

#include "base/Executor.h"
#include "base/Refusal.h"
#include "level/InsideOut.h"
#include "private/ContentHash.h"
#include "private/FreeMemory.h"
#include "private/PropertyChecks.h"
#include "private/ResultArrays.h"
#include "private/SmpExecutor.h"
#include "private/Stopwatch.h"
#include "private/VoxelEvaluation.h"
#include "source/Grid.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <string>

using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkStandardNewMacro(vtkWindingNumberField);

// The property becomes the helper's choice by its number.
static_assert(static_cast<int>(winding::Coverage::center) == vtkWindingNumberField::CENTER);
static_assert(static_cast<int>(winding::Coverage::any) == vtkWindingNumberField::ANY);
static_assert(static_cast<int>(winding::Coverage::fraction) == vtkWindingNumberField::FRACTION);

vtkImageData* vtkWindingNumberField::GetOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkWindingNumberField::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

/// Brings the source up to date, whole: the grid depends on its bounds, and must be known before
/// anybody can ask for a part of it.
void vtkWindingNumberField::UpdateSource(vtkInformation* outInfo)
{
  vtkAlgorithmOutput* connection = this->GetInputConnection(0, 0);
  vtkAlgorithm* producer = connection->GetProducer();
  const int port = connection->GetIndex();
  vtkNew<vtkInformation> request;
  producer->UpdateInformation();
  vtkInformation* produced = producer->GetOutputInformation(port);
  if (produced->Has(Pipeline::WHOLE_EXTENT()))
  {
    request->Set(Pipeline::WHOLE_EXTENT(), produced->Get(Pipeline::WHOLE_EXTENT()), 6);
  }
  this->AskForSource(request);
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
    throw winding::Refusal("look at the filter or reader before this one first: it failed");
  }
}

int vtkWindingNumberField::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  // The pipeline hands on the grid of an image that the source was made of, such as a contour's.
  // It would stay where this filter has no grid to tell of.
  outInfo->Remove(vtkDataObject::ORIGIN());
  outInfo->Remove(vtkDataObject::SPACING());
  const int nothing[6] = {0, -1, 0, -1, 0, -1};
  outInfo->Set(Pipeline::WHOLE_EXTENT(), nothing, 6);
  vtkDataObject* source = vtkDataObject::GetData(inputs[0]);
  this->LookAtSource(source);
  this->AgreeOnProperties();
  if (this->UseInputBounds)
  {
    this->UpdateSource(outInfo);
    source = vtkDataObject::GetData(inputs[0]);
    this->LookAtSource(source);
  }
  this->LayOutGrid(source);

  const bool asCells = this->OutputAssociation == CELLS;
  // An image of n cells has n + 1 points.
  const Eigen::Vector3i last =
    this->GetSampling().dimensions - Eigen::Vector3i::Constant(asCells ? 0 : 1);
  const int extent[6] = {0, last[0], 0, last[1], 0, last[2]};
  outInfo->Set(Pipeline::WHOLE_EXTENT(), extent, 6);
  this->TellGrid(outInfo);
  outInfo->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  if (!asCells)
  {
    const bool scalarsAreSides = this->GenerateInside && !this->GenerateWindingNumber;
    vtkDataObject::SetPointDataActiveScalarInfo(
      outInfo, scalarsAreSides ? VTK_UNSIGNED_CHAR : this->OutputScalarType, 1);
  }
  return 1;
}

void vtkWindingNumberField::TellGrid(vtkInformation* outInfo) const
{
  const winding::Grid& grid = this->GetSampling();
  const Eigen::Vector3d origin =
    this->OutputAssociation == CELLS ? grid.corner() : grid.firstSample;
  outInfo->Set(vtkDataObject::ORIGIN(), origin.data(), 3);
  outInfo->Set(vtkDataObject::SPACING(), grid.spacing.data(), 3);
}

void vtkWindingNumberField::CheckProperties()
{
  this->Superclass::CheckProperties();
  winding::checkChoice("OutputAssociation", this->OutputAssociation, {"POINTS", "CELLS"});
  winding::checkChoice("Coverage", this->Coverage, {"CENTER", "ANY", "FRACTION"});
  winding::checkRange("CoverageSamples", this->CoverageSamples, 1, 10);
  winding::checkRange("DistanceBand", this->DistanceBand, 0);
}

void vtkWindingNumberField::HashProperties(winding::ContentHash& hash)
{
  this->Superclass::HashProperties(hash);
  hash.addValue(this->OutputAssociation);
  hash.addValue(this->Coverage);
  hash.addValue(this->CoverageSamples);
  hash.addValue(this->DistanceBand);
}

double vtkWindingNumberField::GetDistanceLimit() const
{
  return this->DistanceBand > 0 ? this->DistanceBand * this->GetSampling().spacing.maxCoeff()
                                : this->Superclass::GetDistanceLimit();
}

int vtkWindingNumberField::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(outInfo);
  // The pipeline keeps an image's old arrays to be used again, which these are not.
  output->Initialize();
  this->AgreeOnProperties();
  if (!outInfo->Has(vtkDataObject::ORIGIN()) || !outInfo->Has(Pipeline::UPDATE_EXTENT()))
  {
    throw winding::Refusal("ask for information and an extent first: there is no grid");
  }
  int extent[6];
  outInfo->Get(Pipeline::UPDATE_EXTENT(), extent);
  this->CheckVerification(this->GenerateWindingNumber != 0);
  // The source may be that of another time than the one at which the grid was laid.
  vtkDataObject* source = vtkDataObject::GetData(inputs[0]);
  this->MoveGrid(source);
  this->TellGrid(outInfo);

  const bool asCells = this->OutputAssociation == CELLS;
  winding::Extent samples;
  std::copy_n(extent, 6, samples.begin());
  for (int axis = 0; asCells && axis < 3; ++axis)
  {
    --samples[2 * axis + 1];
  }

  const winding::ResultArrays results =
    this->MakeResults(static_cast<vtkIdType>(winding::sampleCount(samples)));
  const winding::Field& field = this->PrepareGridField(source);
  this->EvaluateVoxels(field, samples.data(), results);
  output->SetExtent(extent);
  output->SetOrigin(outInfo->Get(vtkDataObject::ORIGIN()));
  output->SetSpacing(outInfo->Get(vtkDataObject::SPACING()));
  vtkDataSetAttributes* attributes = output->GetPointData();
  if (asCells)
  {
    attributes = output->GetCellData();
  }
  this->AddResults(results, output, attributes);
  this->Verify(field, samples.data(), results.values());
  return 1;
}

winding::ResultOptions vtkWindingNumberField::GetResultOptions() const
{
  winding::ResultOptions options = this->Superclass::GetResultOptions();
  options.withInside |= this->Coverage != CENTER;
  options.withCoverage = this->Coverage == FRACTION;
  return options;
}

winding::VoxelEvaluation vtkWindingNumberField::GetVoxelEvaluation() const
{
  winding::VoxelEvaluation voxels;
  voxels.coverage = static_cast<winding::Coverage>(this->Coverage);
  voxels.samplesPerAxis = this->CoverageSamples;
  return voxels;
}

winding::EvaluationCost vtkWindingNumberField::GetAdditionalCost(
  const winding::Field& field, vtkIdType samples)
{
  return this->GetVoxelEvaluation().additionalCost(field, static_cast<std::size_t>(samples));
}

void vtkWindingNumberField::EvaluateVoxels(
  const winding::Field& field, const int samples[6], const winding::ResultArrays& results)
{
  const winding::Stopwatch stopwatch(this->EvaluateSeconds);
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  winding::VoxelEvaluation voxels = this->GetVoxelEvaluation();
  voxels.output = this->OutputTo(results);
  voxels.fractions = results.coverage() ? results.coverage()->GetPointer(0) : nullptr;

  const winding::Grid& grid = this->GetSampling();
  winding::Extent extent;
  std::copy_n(samples, 6, extent.begin());
  if (voxels.coverage != winding::Coverage::center)
  {
    const std::size_t count = winding::sampleCount(extent);
    winding::refuseBeyondFreeMemory(
      this->GetResultBytes(static_cast<vtkIdType>(count)) +
        static_cast<double>(voxels.additionalCost(field, count).bytes),
      "the coverage of " + std::to_string(count) + " voxels",
      "choose larger voxels or write it in pieces");
  }
  voxels.run(field, grid, extent, executor);
  if (extent == grid.wholeExtent() && this->InsideRule == SIGNED)
  {
    executor.setShare(1, 1);
    const double threshold = this->WindingThreshold;
    winding::SideCounts sides = results.countSides(threshold);
    if (!results.values() && results.hasNothingInside())
    {
      sides = winding::countNegative(field, grid, threshold, executor);
    }
    this->TellSides(field, sides, executor);
  }
}

void vtkWindingNumberField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OutputAssociation: " << this->OutputAssociation << "\n";
  os << indent << "Coverage: " << this->Coverage << "\n";
  os << indent << "CoverageSamples: " << this->CoverageSamples << "\n";
  os << indent << "DistanceBand: " << this->DistanceBand << "\n";
}
