#include "vtkWindingNumberImageAlgorithm.h"

#include "base/Refusal.h"
#include "messages/PropertyChecks.h"
#include "private/source/ContentHash.h"
#include "source/Grid.h"
#include "voxels/VoxelEvaluation.h"

#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

using Pipeline = vtkStreamingDemandDrivenPipeline;

// The property becomes the helper's choice by its number.
static_assert(
  static_cast<int>(winding::Coverage::center) == vtkWindingNumberImageAlgorithm::CENTER);
static_assert(static_cast<int>(winding::Coverage::any) == vtkWindingNumberImageAlgorithm::ANY);
static_assert(
  static_cast<int>(winding::Coverage::fraction) == vtkWindingNumberImageAlgorithm::FRACTION);

vtkImageData* vtkWindingNumberImageAlgorithm::GetOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkWindingNumberImageAlgorithm::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

int vtkWindingNumberImageAlgorithm::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  // The pipeline hands on the grid of an image that the source was made of, such as a contour's.
  // It would stay where this filter has no grid.
  outInfo->Remove(vtkDataObject::ORIGIN());
  outInfo->Remove(vtkDataObject::SPACING());
  const int nothing[6] = {0, -1, 0, -1, 0, -1};
  outInfo->Set(Pipeline::WHOLE_EXTENT(), nothing, 6);
  vtkDataObject* source = this->GetSource();
  this->LookAtSource(source);
  this->AgreeOnProperties();
  this->FindBoundsOverAllTimes(outInfo);
  if (this->UseInputBounds)
  {
    // The grid depends on the source's bounds, and is known before anybody asks for a part of it.
    this->UpdateSource(outInfo);
    source = this->GetSource();
    this->LookAtSource(source);
  }
  this->CheckSource(source);
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
    vtkDataObject::SetPointDataActiveScalarInfo(outInfo, this->GetActiveScalarType(), 1);
  }
  return 1;
}

void vtkWindingNumberImageAlgorithm::TellGrid(vtkInformation* outInfo) const
{
  const winding::Grid& grid = this->GetSampling();
  const Eigen::Vector3d origin =
    this->OutputAssociation == CELLS ? grid.corner() : grid.firstSample;
  outInfo->Set(vtkDataObject::ORIGIN(), origin.data(), 3);
  outInfo->Set(vtkDataObject::SPACING(), grid.spacing.data(), 3);
}

void vtkWindingNumberImageAlgorithm::CheckProperties()
{
  this->Superclass::CheckProperties();
  winding::checkProperty(winding::Parameter::outputAssociation, this->OutputAssociation);
  winding::checkProperty(winding::Parameter::coverage, this->Coverage);
  winding::checkProperty(winding::Parameter::coverageSamples, this->CoverageSamples);
}

void vtkWindingNumberImageAlgorithm::HashProperties(winding::ContentHash& hash)
{
  this->Superclass::HashProperties(hash);
  hash.addValue(this->OutputAssociation);
  hash.addValue(this->Coverage);
  hash.addValue(this->CoverageSamples);
}

int vtkWindingNumberImageAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
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
  // The source may belong to another time than the one at which the grid was laid.
  vtkDataObject* source = this->GetSource();
  this->MoveGrid(source);
  this->TellGrid(outInfo);

  const bool asCells = this->OutputAssociation == CELLS;
  winding::Extent samples;
  std::copy_n(extent, 6, samples.begin());
  for (int axis = 0; asCells && axis < 3; ++axis)
  {
    --samples[2 * axis + 1];
  }

  output->SetExtent(extent);
  output->SetOrigin(outInfo->Get(vtkDataObject::ORIGIN()));
  output->SetSpacing(outInfo->Get(vtkDataObject::SPACING()));
  vtkDataSetAttributes* attributes = output->GetPointData();
  if (asCells)
  {
    attributes = output->GetCellData();
  }
  this->MakeImage(source, samples, output, attributes);
  return 1;
}

winding::VoxelEvaluation vtkWindingNumberImageAlgorithm::GetVoxelEvaluation() const
{
  winding::VoxelEvaluation voxels;
  voxels.coverage = static_cast<winding::Coverage>(this->Coverage);
  voxels.samplesPerAxis = this->CoverageSamples;
  return voxels;
}

std::size_t vtkWindingNumberImageAlgorithm::GetAdditionalBytes(
  const winding::Field& field, vtkIdType samples)
{
  return this->GetVoxelEvaluation().additionalBytes(field, static_cast<std::size_t>(samples));
}

void vtkWindingNumberImageAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OutputAssociation: " << this->OutputAssociation << "\n";
  os << indent << "Coverage: " << this->Coverage << "\n";
  os << indent << "CoverageSamples: " << this->CoverageSamples << "\n";
}
