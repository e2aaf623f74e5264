// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindingNumberSurfaceAlgorithm.h"

#include "field/Field.h"
#include "messages/Options.h"
#include "messages/PropertyChecks.h"
#include "pipeline/Ranks.h"
#include "pipeline/SmpExecutor.h"
#include "private/output/ArraySink.h"
#include "private/output/NearestAttributes.h"
#include "private/source/ContentHash.h"
#include "private/source/SourceProperties.h"
#include "tasks/SurfaceTask.h"

#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>

using Pipeline = vtkStreamingDemandDrivenPipeline;

namespace
{

// Properties become the core's choices by their numbers.
using winding::isNumber;
using Filter = vtkWindingNumberSurfaceAlgorithm;
static_assert(isNumber(winding::Features::smooth, Filter::SMOOTH));
static_assert(isNumber(winding::Features::sharp, Filter::SHARP));
static_assert(isNumber(winding::Features::voxels, Filter::VOXELS));

} // namespace

vtkWindingNumberSurfaceAlgorithm::vtkWindingNumberSurfaceAlgorithm()
{
  this->SetNumberOfOutputPorts(2);
  this->Resolution = 0;
}

vtkPolyData* vtkWindingNumberSurfaceAlgorithm::GetOutput()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
}

vtkImageData* vtkWindingNumberSurfaceAlgorithm::GetImage()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(1));
}

int vtkWindingNumberSurfaceAlgorithm::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

vtkInformation* vtkWindingNumberSurfaceAlgorithm::GetRequestedOutput(
  vtkInformation* request, vtkInformationVector* outputs)
{
  return outputs->GetInformationObject(std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT())));
}

int vtkWindingNumberSurfaceAlgorithm::RequestInformation(
  vtkInformation* request, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* outInfo = GetRequestedOutput(request, outputs);
  vtkInformation* ofImage = outputs->GetInformationObject(1);
  winding::Extent extent = {0, -1, 0, -1, 0, -1};
  ofImage->Set(Pipeline::WHOLE_EXTENT(), extent.data(), 6);
  this->InspectSource(this->MakeSource());
  this->GetRanks().requireSame(
    [this]() -> winding::Ranks::Number { return this->GenerateImage != 0; });
  this->FindBoundsOverAllTimes(outInfo);
  if (!this->GenerateImage)
  {
    return 1;
  }
  this->AgreeOnProperties();
  if (this->UseInputBounds)
  {
    this->UpdateSource(outInfo);
  }
  this->SetUpGrid(this->MakeSource());
  const winding::Grid& grid = this->GetSampling();
  extent = grid.wholeExtent();
  ofImage->Set(Pipeline::WHOLE_EXTENT(), extent.data(), 6);
  ofImage->Set(vtkDataObject::ORIGIN(), grid.firstSample.data(), 3);
  ofImage->Set(vtkDataObject::SPACING(), grid.spacing.data(), 3);
  vtkDataObject::SetPointDataActiveScalarInfo(ofImage, VTK_UNSIGNED_CHAR, 1);
  return 1;
}

void vtkWindingNumberSurfaceAlgorithm::SetUpGridOver(vtkDataObject* source)
{
  this->GetImage()->Initialize();
  if (this->GenerateImage)
  {
    this->MoveGrid(source);
  }
  else
  {
    this->SetUpGrid(source);
  }
}

void vtkWindingNumberSurfaceAlgorithm::CheckProperties()
{
  this->SolidInWords.clear();
  this->Superclass::CheckProperties();
  winding::checkProperty(winding::Parameter::features, this->Features);
  winding::checkProperty(winding::Parameter::outputPointsPrecision, this->OutputPointsPrecision);
  if (this->TransferAttributes || this->GenerateNearestCells)
  {
    winding::refuseNearestOfOtherRanks(
      this->GetRanks(), winding::sourceDistribution(this->SourceDistribution));
  }
}

void vtkWindingNumberSurfaceAlgorithm::HashProperties(winding::ContentHash& hash)
{
  this->Superclass::HashProperties(hash);
  hash.addValue(this->Features);
  hash.addValue(this->GenerateTriangles);
  hash.addValue(this->CloseBorder);
  hash.addValue(this->GenerateNormals);
  hash.addValue(this->OutputPointsPrecision);
  hash.addValue(this->TransferAttributes);
  hash.addValue(this->GenerateNearestCells);
  hash.addValue(this->GenerateImage);
}

winding::SurfaceOptions vtkWindingNumberSurfaceAlgorithm::GetSurfaceOptions() const
{
  winding::SurfaceOptions options;
  options.isInside = this->GetInsideTest();
  options.features = static_cast<winding::Features>(this->Features);
  options.areTriangles = this->GenerateTriangles != 0;
  options.mendsSource = this->MendsSource();
  options.closesBorder = this->CloseBorder != 0;
  options.hasNormals = this->GenerateNormals != 0;
  options.hasImage = this->GenerateImage != 0;
  if (this->OutputPointsPrecision != DEFAULT_PRECISION)
  {
    options.pointType = this->OutputPointsPrecision == DOUBLE_PRECISION
                          ? winding::PointType::float64
                          : winding::PointType::float32;
  }
  return options;
}

bool vtkWindingNumberSurfaceAlgorithm::IsLaterPiece(vtkInformation* output) const
{
  return output->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0 && this->GetRanks().isAlone();
}

void vtkWindingNumberSurfaceAlgorithm::AddResult(
  const winding::ArraySink& result, vtkPolyData* output)
{
  result.addTo(output);
  const auto number = [&result](winding::Output single)
  {
    vtkDataArray* const array = result.array(single);
    return array ? array->GetComponent(0, 0) : vtkMath::Nan();
  };
  this->SolidInWords = winding::solidInWords(number(winding::Output::isClosed) != 0,
    std::llround(number(winding::Output::parts)), number(winding::Output::volume),
    number(winding::Output::inputVolume));
  if (vtkDataArray* const inside = result.array(winding::Output::inside))
  {
    const winding::Grid& grid = this->GetSampling();
    winding::Extent extent = grid.wholeExtent();
    vtkImageData* const image = this->GetImage();
    image->SetExtent(extent.data());
    image->SetOrigin(grid.firstSample.data());
    image->SetSpacing(grid.spacing.data());
    image->GetPointData()->SetScalars(inside);
  }
  this->UpdateProgress(1);
}

std::size_t vtkWindingNumberSurfaceAlgorithm::GetBytesOfNearest(const winding::Field& field) const
{
  const winding::FieldInfo& info = field.info();
  return this->TransferAttributes || this->GenerateNearestCells
           ? winding::NearestAttributes::bytesFor(info.isSurface, info.inputPrimitives)
           : 0;
}

void vtkWindingNumberSurfaceAlgorithm::AddNearest(vtkDataObject* source, vtkPolyData* output)
{
  if (!this->TransferAttributes && !this->GenerateNearestCells)
  {
    return;
  }
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  executor.setShare(1, 1);
  const winding::NearestAttributes nearest(source, this->GetSourceOptions(),
    {this->GenerateNearestCells != 0, this->TransferAttributes != 0}, executor);
  nearest.addTo(output, executor);
  for (const winding::Message& note : nearest.notes())
  {
    vtkWarningMacro(<< winding::lineOf(note));
  }
}

const char* vtkWindingNumberSurfaceAlgorithm::GetFeaturesAsString() const
{
  return winding::nameOfChoice(winding::Parameter::features, this->Features);
}

void vtkWindingNumberSurfaceAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Features: " << this->Features << "\n";
  os << indent << "GenerateTriangles: " << this->GenerateTriangles << "\n";
  os << indent << "CloseBorder: " << this->CloseBorder << "\n";
  os << indent << "GenerateNormals: " << this->GenerateNormals << "\n";
  os << indent << "TransferAttributes: " << this->TransferAttributes << "\n";
  os << indent << "GenerateNearestCells: " << this->GenerateNearestCells << "\n";
  os << indent << "GenerateImage: " << this->GenerateImage << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "SolidInWords: " << this->SolidInWords << "\n";
}
