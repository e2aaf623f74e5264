// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindingNumberImageAlgorithm.h"

#include "base/Refusal.h"
#include "messages/Options.h"
#include "messages/PropertyChecks.h"
#include "pipeline/DistinctWarnings.h"
#include "pipeline/Temporarily.h"
#include "private/source/CellChecks.h"
#include "private/source/ContentHash.h"
#include "private/source/ImageGrid.h"
#include "tasks/Sentences.h"
#include "voxels/VoxelEvaluation.h"

#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
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

vtkWindingNumberImageAlgorithm::vtkWindingNumberImageAlgorithm()
{
  this->SetNumberOfInputPorts(2);
}

void vtkWindingNumberImageAlgorithm::SetLikeConnection(vtkAlgorithmOutput* image)
{
  this->SetInputConnection(1, image);
}

void vtkWindingNumberImageAlgorithm::SetLikeData(vtkImageData* image)
{
  this->SetInputDataObject(1, image);
}

bool vtkWindingNumberImageAlgorithm::HasRightAngles(vtkImageData* image)
{
  return winding::hasRightAngles(image, winding::mostSkewToLieOn);
}

vtkImageData* vtkWindingNumberImageAlgorithm::GetOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkWindingNumberImageAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkWindingNumberImageAlgorithm::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

int vtkWindingNumberImageAlgorithm::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (vtkInformation* like = inputs[1]->GetInformationObject(0))
  {
    // One voxel, for nothing but the place of the image is of use.
    const int* whole = like->Get(Pipeline::WHOLE_EXTENT());
    if (whole && whole[0] <= whole[1] && whole[2] <= whole[3] && whole[4] <= whole[5])
    {
      const int first[6] = {whole[0], whole[0], whole[2], whole[2], whole[4], whole[4]};
      like->Set(Pipeline::UPDATE_EXTENT(), first, 6);
    }
  }
  return this->Superclass::RequestUpdateExtent(request, inputs, outputs);
}

/// Takes over the place that the pipeline announces for the image on port 1, if there is any.
void vtkWindingNumberImageAlgorithm::InspectLike(vtkInformationVector* like)
{
  this->Like = nullptr;
  *this->Frame = winding::ImageFrame();
  vtkInformation* info = like->GetInformationObject(0);
  if (!info)
  {
    return;
  }
  this->Like = vtkSmartPointer<vtkImageData>::New();
  if (info->Has(Pipeline::WHOLE_EXTENT()))
  {
    winding::checkExtent(info->Get(Pipeline::WHOLE_EXTENT()), "the image to lie on");
    this->Like->SetExtent(info->Get(Pipeline::WHOLE_EXTENT()));
  }
  this->Like->CopyInformationFromPipeline(info);
}

/// Throws a refusal for an image that lies elsewhere than its pipeline has announced.
void vtkWindingNumberImageAlgorithm::CheckLike(vtkImageData* image) const
{
  const auto areSame = [](const double* a, const double* b, int count)
  {
    return std::equal(a, a + count, b);
  };
  const auto isInside = [](const int* part, const int* whole)
  {
    return part[0] >= whole[0] && part[1] <= whole[1] && part[2] >= whole[2] &&
           part[3] <= whole[3] && part[4] >= whole[4] && part[5] <= whole[5];
  };
  if (image && image->GetNumberOfPoints() > 0 &&
      !(isInside(image->GetExtent(), this->Like->GetExtent()) &&
        areSame(image->GetOrigin(), this->Like->GetOrigin(), 3) &&
        areSame(image->GetSpacing(), this->Like->GetSpacing(), 3) &&
        areSame(
          image->GetDirectionMatrix()->GetData(), this->Like->GetDirectionMatrix()->GetData(), 9)))
  {
    throw winding::Refusal(winding::messageOf(winding::Sentence::imageLiesElsewhere));
  }
}

void vtkWindingNumberImageAlgorithm::SetUpGridLike()
{
  const winding::ImageGrid image =
    winding::requiredGridOf(this->Like, this->OutputAssociation == CELLS, this->Coverage != CENTER);
  *this->Frame = image.frame;
  this->UseGrid(image.grid);
}

/// Lays the grid over a source, as the properties say, which is brought up to date for its bounds.
void vtkWindingNumberImageAlgorithm::SetUpGridOverSource(vtkInformation* outInfo)
{
  this->FindBoundsOverAllTimes(outInfo);
  if (this->UseInputBounds)
  {
    // The grid depends on the source's bounds, and is known before anybody asks for a part of it.
    this->UpdateSource(outInfo);
  }
  vtkDataObject* const source = this->MakeSource();
  if (this->UseInputBounds)
  {
    this->InspectSource(source);
  }
  this->CheckSource(source);
  this->SetUpGrid(source);
}

int vtkWindingNumberImageAlgorithm::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  // The pipeline hands on the grid of an image that the source was made of, such as a contour's.
  // It would stay where this filter has no grid.
  outInfo->Remove(vtkDataObject::ORIGIN());
  outInfo->Remove(vtkDataObject::SPACING());
  outInfo->Remove(vtkDataObject::DIRECTION());
  const int nothing[6] = {0, -1, 0, -1, 0, -1};
  outInfo->Set(Pipeline::WHOLE_EXTENT(), nothing, 6);
  this->InspectSource(this->MakeSource());
  this->InspectLike(inputs[1]);
  this->AgreeOnProperties();
  const bool asCells = this->OutputAssociation == CELLS;
  int extent[6];
  if (this->Like)
  {
    this->SetUpGridLike();
    this->Like->GetExtent(extent);
  }
  else
  {
    this->SetUpGridOverSource(outInfo);
    for (int axis = 0; axis < 3; ++axis)
    {
      // An image of n cells has n + 1 points.
      extent[2 * axis] = 0;
      extent[2 * axis + 1] = this->GetSampling().dimensions[axis] - (asCells ? 0 : 1);
    }
  }
  outInfo->Set(Pipeline::WHOLE_EXTENT(), extent, 6);
  this->AnnounceGrid(outInfo);
  outInfo->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  if (this->UnionOverAllTimes && this->HasTimeSteps())
  {
    outInfo->Remove(Pipeline::TIME_STEPS());
    outInfo->Remove(Pipeline::TIME_RANGE());
  }
  if (!asCells)
  {
    vtkDataObject::SetPointDataActiveScalarInfo(outInfo, this->GetActiveScalarType(), 1);
  }
  return 1;
}

void vtkWindingNumberImageAlgorithm::AnnounceGrid(vtkInformation* outInfo) const
{
  if (this->Like)
  {
    outInfo->Set(vtkDataObject::ORIGIN(), this->Like->GetOrigin(), 3);
    outInfo->Set(vtkDataObject::SPACING(), this->Like->GetSpacing(), 3);
    outInfo->Set(vtkDataObject::DIRECTION(), this->Like->GetDirectionMatrix()->GetData(), 9);
    return;
  }
  const winding::Grid& grid = this->GetSampling();
  const Eigen::Vector3d origin =
    this->OutputAssociation == CELLS ? grid.corner() : grid.firstSample;
  outInfo->Set(vtkDataObject::ORIGIN(), origin.data(), 3);
  outInfo->Set(vtkDataObject::SPACING(), grid.spacing.data(), 3);
  const vtkNew<vtkMatrix3x3> straight;
  outInfo->Set(vtkDataObject::DIRECTION(), straight->GetData(), 9);
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
  hash.addValue(this->UnionOverAllTimes);
  hash.addValue(this->Like != nullptr);
  if (this->Like)
  {
    int extent[6];
    this->Like->GetExtent(extent);
    hash.addValue(extent);
    for (int axis = 0; axis < 3; ++axis)
    {
      hash.addValue(this->Like->GetOrigin()[axis]);
      hash.addValue(this->Like->GetSpacing()[axis]);
    }
    for (int n = 0; n < 9; ++n)
    {
      hash.addValue(this->Like->GetDirectionMatrix()->GetData()[n]);
    }
  }
}

int vtkWindingNumberImageAlgorithm::RequestData(
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
  vtkDataObject* source = this->MakeSource();
  if (this->Like)
  {
    this->CheckLike(vtkImageData::GetData(inputs[1]));
    this->CheckSource(source);
    this->SetUpGridLike();
  }
  else
  {
    // The source may belong to another time than the one at which the grid was laid.
    this->MoveGrid(source);
  }
  this->AnnounceGrid(outInfo);

  const bool asCells = this->OutputAssociation == CELLS;
  winding::Extent samples;
  for (int axis = 0; axis < 3; ++axis)
  {
    // Samples have numbers from 0 on. A flat image has a layer of cells, too.
    const int first = this->Like ? this->Like->GetExtent()[2 * axis] : 0;
    const bool isFlat = this->Like && this->Like->GetDimensions()[axis] == 1;
    samples[2 * axis] = extent[2 * axis] - first;
    samples[2 * axis + 1] = extent[2 * axis + 1] - first - (asCells && !isFlat ? 1 : 0);
  }

  output->SetExtent(extent);
  output->CopyInformationFromPipeline(outInfo);
  if (!this->UnionOverAllTimes || !this->MakeUnion(outInfo, samples, output))
  {
    this->MakeImage(source, samples, output, this->GetAttributes(output));
  }
  return 1;
}

vtkDataSetAttributes* vtkWindingNumberImageAlgorithm::GetAttributes(vtkImageData* image) const
{
  return image->GetAttributes(
    this->OutputAssociation == CELLS ? vtkDataObject::CELL : vtkDataObject::POINT);
}

/// Makes the arrays of an image as the union of all times. Returns false where the source has no
/// times.
bool vtkWindingNumberImageAlgorithm::MakeUnion(
  vtkInformation* outInfo, const winding::Extent& samples, vtkImageData* image)
{
  const winding::Temporarily<double> runsLeft(this->RunsLeft, 1), earlier(this->EarlierSeconds, 0);
  const winding::Temporarily<decltype(this->SweptSamples)> swept(
    this->SweptSamples, std::vector<std::uint64_t>());
  winding::DistinctWarnings warnings(this);
  const bool isUnion = this->ForEachTime(outInfo,
    [&](std::size_t number, std::size_t count)
    {
      this->CheckUnion();
      warnings.begin();
      const auto share = 1 / static_cast<double>(count);
      this->SetProgressShiftScale(static_cast<double>(number) * share, share);
      this->RunsLeft = static_cast<double>(count - number);
      vtkNew<vtkImageData> part;
      part->CopyStructure(image);
      vtkDataObject* const source = this->MakeSource();
      this->CheckSource(source);
      this->MakeImage(source, samples, part, this->GetAttributes(part));
      this->EarlierSeconds += this->PrepareSeconds + this->EvaluateSeconds;
      if (number == 0)
      {
        image->ShallowCopy(part);
      }
      else
      {
        this->UniteTimes(image, part);
      }
    });
  this->InspectSource(this->MakeSource()); // which has its time back; the last one may be empty
  return isUnion;
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
  // Earlier times have arrays, too.
  const double united = this->UnionOverAllTimes ? this->GetResultBytes(samples) : 0;
  return static_cast<std::size_t>(united) +
         this->GetVoxelEvaluation().additionalBytes(field, static_cast<std::size_t>(samples));
}

const char* vtkWindingNumberImageAlgorithm::GetOutputAssociationAsString() const
{
  return winding::nameOfChoice(winding::Parameter::outputAssociation, this->OutputAssociation);
}

const char* vtkWindingNumberImageAlgorithm::GetCoverageAsString() const
{
  return winding::nameOfChoice(winding::Parameter::coverage, this->Coverage);
}

void vtkWindingNumberImageAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OutputAssociation: " << this->OutputAssociation << "\n";
  os << indent << "Coverage: " << this->Coverage << "\n";
  os << indent << "CoverageSamples: " << this->CoverageSamples << "\n";
  os << indent << "UnionOverAllTimes: " << this->UnionOverAllTimes << "\n";
}
