// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindingNumberVoxels.h"

#include "base/Digits.h"
#include "base/InsideRule.h"
#include "base/Refusal.h"
#include "diagnosis/InsideOutAdvice.h"
#include "messages/Options.h"
#include "pipeline/ErrorReports.h"
#include "pipeline/FreeMemory.h"
#include "pipeline/SmpExecutor.h"
#include "pipeline/VtkVersions.h"
#include "private/output/Legends.h"
#include "private/output/NearestAttributes.h"
#include "private/source/CellChecks.h"
#include "private/source/SourceParts.h"
#include "private/source/SourceProperties.h"
#include "tasks/Sentences.h"
#include "voxels/BlockSurface.h"

#include "vtkArrayDispatch.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArrayRange.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{

struct Classify
{
  template <class Array>
  void operator()(
    Array* values, const winding::InsideTest& isInside, std::vector<unsigned char>& inside) const
  {
    const auto range = vtk::DataArrayValueRange<1>(values);
    inside.reserve(static_cast<std::size_t>(range.size()));
    for (const auto value : range)
    {
      inside.push_back(isInside(static_cast<double>(value)));
    }
  }
};

/// 1 for each value that is inside, and 0 for any other.
std::vector<unsigned char> classify(vtkDataArray* values, const winding::InsideTest& isInside)
{
  std::vector<unsigned char> inside;
  if (!vtkArrayDispatch::Dispatch::Execute(values, Classify{}, isInside, inside))
  {
    Classify{}(values, isInside, inside);
  }
  return inside;
}

bool isAny(const std::vector<unsigned char>& inside)
{
  return std::find(inside.begin(), inside.end(), 1) != inside.end();
}

struct ReadLabels
{
  template <class Array> void operator()(Array* values, std::vector<unsigned short>& labels) const
  {
    constexpr double largest = std::numeric_limits<unsigned short>::max();
    const auto range = vtk::DataArrayValueRange<1>(values);
    labels.reserve(static_cast<std::size_t>(range.size()));
    for (const auto value : range)
    {
      const auto number = static_cast<double>(value);
      if (!(number >= 0 && number <= largest && number == std::floor(number)))
      {
        throw winding::Refusal(winding::messageOf(winding::Sentence::noLabels,
          {winding::textOf(values->GetName()), winding::inDigits(number)}));
      }
      labels.push_back(static_cast<unsigned short>(number));
    }
  }
};

/// Returns whether `values` are by name, type and range what vtkWindingNumberLabels gives.
bool areCalledLabels(vtkDataArray* values)
{
  const int type = values->GetDataType();
  return winding::textOf(values->GetName()) == "Label" && type != VTK_FLOAT && type != VTK_DOUBLE &&
         values->GetRange()[0] >= 0 &&
         values->GetRange()[1] <= std::numeric_limits<unsigned short>::max();
}

/// Throws a Refusal for values that are no labels.
std::vector<unsigned short> labelsOf(vtkDataArray* values)
{
  std::vector<unsigned short> labels;
  if (!vtkArrayDispatch::Dispatch::Execute(values, ReadLabels{}, labels))
  {
    ReadLabels{}(values, labels);
  }
  return labels;
}

const std::vector<winding::Remedy> lessMemory = {
  {"choose larger voxels", {}}, {"extract a part of the image", {}}};

/// Finds the continuous index of an image at which its first voxel begins.
std::array<double, 3> firstIndexOf(vtkImageData* image, bool asCells)
{
  const int* extent = image->GetExtent();
  const double half = asCells ? 0.0 : 0.5;
  return {extent[0] - half, extent[2] - half, extent[4] - half};
}

/// Makes the voxels of an image, without their labels. Throws a Refusal if the array does not have
/// as many values, or if there is no memory for the labels.
template <class Label>
winding::VoxelSides<Label> voxelsOf(vtkImageData* image, vtkDataArray* values, bool asCells)
{
  int extent[6];
  image->GetExtent(extent);
  winding::VoxelSides<Label> sides;
  vtkIdType voxelCount = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    // A flat image has a layer of cells, too.
    const int points = extent[2 * axis + 1] - extent[2 * axis] + 1;
    const int voxels = asCells ? std::max(1, points - 1) : points;
    sides.dimensions[static_cast<std::size_t>(axis)] = voxels;
    voxelCount *= voxels;
  }
  if (values->GetNumberOfTuples() != voxelCount)
  {
    throw winding::Refusal(winding::messageOf(winding::Sentence::otherArrayLength,
      {winding::textOf(values->GetName()), std::to_string(values->GetNumberOfTuples()),
        std::to_string(voxelCount)}));
  }
  winding::refuseBeyondFreeMemory(
    static_cast<double>(voxelCount) * sizeof(Label), "telling inside from outside", lessMemory);
  return sides;
}

bool isMirrored(vtkImageData* image)
{
  const double* spacing = image->GetSpacing();
  return image->GetDirectionMatrix()->Determinant() * spacing[0] * spacing[1] * spacing[2] < 0;
}

/// Adds the quads between voxels whose labels are known to `output`, and calls `addData` with the
/// surface, for data of the quads. Throws a Refusal if there is no memory for them.
template <class Label, class AddData>
void addQuads(const winding::VoxelSides<Label>& sides, vtkImageData* image,
  const std::array<double, 3>& firstIndex, vtkAlgorithm* filter, vtkPolyData* output,
  const AddData& addData)
{
  using Surface = winding::BlockSurface<Label>;
  const std::size_t faces = Surface::countFaces(sides);
  winding::refuseBeyondFreeMemory(Surface::bytesOf(faces), "the surface", lessMemory);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  winding::reserve(points.Get(), static_cast<vtkIdType>(faces) + 2);
  const auto addCorner = [&](int i, int j, int k)
  {
    double position[3];
    image->TransformContinuousIndexToPhysicalPoint(
      firstIndex[0] + i, firstIndex[1] + j, firstIndex[2] + k, position);
    points->InsertNextPoint(position);
  };
  vtkNew<vtkTypeInt64Array> ids;
  ids->SetNumberOfValues(4 * static_cast<vtkIdType>(faces));
  winding::SmpExecutor executor(filter, 1);
  Surface surface(sides, isMirrored(image), faces);
  surface.build(static_cast<std::int64_t*>(ids->GetVoidPointer(0)), addCorner, executor);
  points->Squeeze();
  output->SetPoints(points);
  vtkNew<vtkCellArray> quads;
  quads->SetData(4, ids);
  output->SetPolys(quads);
  addData(surface);
}

/// Gives each quad the labels on both of its sides.
void addLabels(const winding::VoxelSides<unsigned short>& sides,
  const winding::BlockSurface<unsigned short>& surface, vtkCellData* data)
{
  const auto count = static_cast<vtkIdType>(surface.voxels().size());
  vtkNew<vtkUnsignedShortArray> both, own;
  both->SetName("BoundaryLabels");
  both->SetNumberOfComponents(2);
  both->SetComponentName(0, "From");
  both->SetComponentName(1, "To");
  both->SetNumberOfTuples(count);
  own->SetName("Label");
  own->SetNumberOfTuples(count);
  for (vtkIdType quad = 0; quad < count; ++quad)
  {
    const auto n = static_cast<std::size_t>(quad);
    const unsigned short label = sides.labels[static_cast<std::size_t>(surface.voxels()[n])];
    own->SetValue(quad, label);
    both->SetTypedComponent(quad, 0, label);
    both->SetTypedComponent(quad, 1, surface.seenLabels()[n]);
  }
  data->AddArray(both);
  data->SetScalars(own);
}

/// Gives each quad the coverage of its voxel, if the image has any.
void addCoverage(vtkDataSetAttributes* from, vtkIdType voxels,
  const std::vector<std::int64_t>& ofQuads, vtkCellData* data)
{
  vtkDataArray* coverage = from->GetArray("Coverage");
  if (coverage && coverage->GetNumberOfTuples() == voxels)
  {
    const auto shares = vtkSmartPointer<vtkDataArray>::Take(coverage->NewInstance());
    shares->SetName(coverage->GetName());
    shares->SetNumberOfComponents(coverage->GetNumberOfComponents());
    shares->SetNumberOfTuples(static_cast<vtkIdType>(ofQuads.size()));
    for (std::size_t quad = 0; quad < ofQuads.size(); ++quad)
    {
      shares->SetTuple(static_cast<vtkIdType>(quad), ofQuads[quad], coverage);
    }
    data->SetScalars(shares);
  }
}

} // namespace

vtkStandardNewMacro(vtkWindingNumberVoxels);

vtkWindingNumberVoxels::~vtkWindingNumberVoxels()
{
  this->SetMirror(nullptr);
}

vtkWindingNumberVoxels::vtkWindingNumberVoxels()
{
  this->SetNumberOfInputPorts(2);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS, vtkDataSetAttributes::SCALARS);
}

int vtkWindingNumberVoxels::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkWindingNumberVoxels::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  for (vtkInformationVector* input : {inputs[0], inputs[1]})
  {
    if (vtkInformation* info = input->GetInformationObject(0))
    {
      winding::requestPiece(info, 0, 1);
    }
  }
  return 1;
}

int vtkWindingNumberVoxels::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  if (outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1;
  }
  vtkPolyData* const output = vtkPolyData::GetData(outInfo);
  const winding::Outcome outcome = winding::reportErrors(this, this->NamesInMessages,
    {"not enough memory for the surface", lessMemory},
    [&]()
    {
      this->MakeSurface(vtkImageData::GetData(inputs[0]), output);
      this->AddNearest(vtkDataObject::GetData(inputs[1]), output);
    });
  this->ErrorCode = winding::errorCodeOf(outcome);
  if (outcome != winding::Outcome::done)
  {
    output->Initialize();
  }
  return 1;
}

vtkDataArray* vtkWindingNumberVoxels::FindValues(vtkImageData* image, int& association)
{
  association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* values = this->GetInputArrayToProcess(0, image, association);
  if (!values)
  {
    // ParaView asks for an array of no name where it does not know the image's arrays yet.
    values = image->GetPointData()->GetScalars();
    association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  }
  if (!values)
  {
    values = image->GetCellData()->GetScalars();
    association = vtkDataObject::FIELD_ASSOCIATION_CELLS;
  }
  if (!values || values->GetNumberOfComponents() != 1)
  {
    throw winding::Refusal(winding::messageOf(winding::Sentence::noScalars));
  }
  return values;
}

void vtkWindingNumberVoxels::MakeSurface(vtkImageData* image, vtkPolyData* output)
{
  this->LabelLegend.clear();
  winding::checkProperty(winding::Parameter::windingThreshold, this->WindingThreshold);
  const winding::InsideTest isInside = {
    winding::coreInsideRule(this->InsideRule), this->WindingThreshold};
  winding::checkProperty(winding::Parameter::byLabel, this->ByLabel);
  winding::checkStructure(image, "the image");
  if (image->GetNumberOfPoints() == 0)
  {
    return;
  }
  int association;
  vtkDataArray* values = this->FindValues(image, association);
  const bool asCells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  const std::array<double, 3> firstIndex = firstIndexOf(image, asCells);
  if (this->ByLabel == LABELS_ON || (this->ByLabel == LABELS_AUTOMATIC && areCalledLabels(values)))
  {
    this->LabelLegend = winding::legendOfLabels(image->GetFieldData());
    auto voxels = voxelsOf<unsigned short>(image, values, asCells);
    voxels.labels = labelsOf(values);
    addQuads(voxels, image, firstIndex, this, output,
      [&](const auto& surface) { addLabels(voxels, surface, output->GetCellData()); });
    return;
  }
  auto voxels = voxelsOf<unsigned char>(image, values, asCells);
  voxels.labels = classify(values, isInside);
  if (isInside.rule == winding::InsideRule::signedThreshold && !isAny(voxels.labels))
  {
    this->WarnOfNegative(values);
  }
  vtkDataSetAttributes* attributes = image->GetPointData();
  if (asCells)
  {
    attributes = image->GetCellData();
  }
  addQuads(voxels, image, firstIndex, this, output,
    [&](const auto& surface) {
      addCoverage(attributes, values->GetNumberOfTuples(), surface.voxels(), output->GetCellData());
    });
}

void vtkWindingNumberVoxels::AddNearest(vtkDataObject* source, vtkPolyData* output)
{
  if (!source || output->GetNumberOfCells() == 0 ||
      (!this->TransferAttributes && !this->GenerateNearestCells))
  {
    return;
  }
  winding::SourceOptions options;
  options.input.estimateNormals = true; // none are needed
  options.field.mirror = winding::textOf(this->Mirror);
  winding::SmpExecutor executor(this, 0);
  executor.setShare(1, 1);
  const winding::NearestAttributes nearest(
    source, options, {this->GenerateNearestCells != 0, this->TransferAttributes != 0}, executor);
  nearest.addTo(output, executor);
  for (const winding::Message& note : nearest.notes())
  {
    vtkWarningMacro(<< winding::lineOf(note));
  }
}

void vtkWindingNumberVoxels::WarnOfNegative(vtkDataArray* values)
{
  const winding::SideCounts counts = winding::countSides(
    static_cast<std::size_t>(values->GetNumberOfTuples()), this->WindingThreshold,
    [values](std::size_t i) { return values->GetComponent(static_cast<vtkIdType>(i), 0); });
  if (counts.negative > 0)
  {
    vtkWarningMacro(<< winding::lineOf(winding::insideOutAdvice(
                      "faces or normals", counts, this->WindingThreshold)));
  }
}

const char* vtkWindingNumberVoxels::GetInsideRuleAsString() const
{
  return winding::nameOfChoice(winding::Parameter::insideRule, this->InsideRule);
}

const char* vtkWindingNumberVoxels::GetByLabelAsString() const
{
  return winding::nameOfChoice(winding::Parameter::byLabel, this->ByLabel);
}

void vtkWindingNumberVoxels::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NamesInMessages: " << this->NamesInMessages << "\n";
  os << indent << "WindingThreshold: " << this->WindingThreshold << "\n";
  os << indent << "InsideRule: " << this->InsideRule << "\n";
  os << indent << "ByLabel: " << this->ByLabel << "\n";
  os << indent << "LabelLegend: " << this->LabelLegend.size() << " bytes\n";
  os << indent << "TransferAttributes: " << this->TransferAttributes << "\n";
  os << indent << "GenerateNearestCells: " << this->GenerateNearestCells << "\n";
  os << indent << "Mirror: " << winding::textOf(this->Mirror) << "\n";
}
