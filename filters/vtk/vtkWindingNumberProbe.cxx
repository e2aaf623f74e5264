// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindingNumberProbe.h"

#include "field/Field.h"
#include "messages/Options.h"
#include "messages/PropertyChecks.h"
#include "pipeline/FreeMemory.h"
#include "pipeline/Ranks.h"
#include "pipeline/SmpExecutor.h"
#include "private/output/NearestAttributes.h"
#include "private/output/ResultArrays.h"
#include "private/probe/InsidePart.h"
#include "private/probe/ProbeCells.h"
#include "private/probe/ProbeQueries.h"
#include "private/probe/ProbeWords.h"
#include "private/source/ContentHash.h"
#include "private/source/SourceProperties.h"
#include "voxels/CellFractions.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkWindingNumberProbe);

vtkWindingNumberProbe::vtkWindingNumberProbe()
{
  this->SetResultArrayName("WindingNumber");
  this->SetInsideArrayName("Inside");
}

vtkWindingNumberProbe::~vtkWindingNumberProbe()
{
  this->SetResultArrayName(nullptr);
  this->SetInsideArrayName(nullptr);
}

vtkSmartPointer<vtkDataObject> vtkWindingNumberProbe::NewOutput(vtkDataObject* input) const
{
  if (this->ExtractInside && vtkPolyData::SafeDownCast(input))
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  if (this->ExtractInside && vtkDataSet::SafeDownCast(input))
  {
    return vtkSmartPointer<vtkUnstructuredGrid>::New();
  }
  return this->Superclass::NewOutput(input);
}

const winding::ProbeWords& vtkWindingNumberProbe::GetWords() const
{
  return winding::wordsOfProbe;
}

void vtkWindingNumberProbe::CheckProperties()
{
  this->Superclass::CheckProperties();
  winding::checkProperty(winding::Parameter::probeAssociation, this->ProbeAssociation);
  winding::checkProperty(winding::Parameter::outputScalarType, this->OutputScalarType);
  if (this->GenerateNearestCells)
  {
    winding::refuseNearestOfOtherRanks(
      this->GetRanks(), winding::sourceDistribution(this->SourceDistribution));
  }
}

void vtkWindingNumberProbe::FinishSamples(
  const winding::Field&, const winding::ProbeQueries& queries, const unsigned char*)
{
  this->NearestCells->Initialize();
  if (!this->GenerateNearestCells)
  {
    return;
  }
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  executor.setShare(1, 1);
  const winding::NearestAttributes nearest(
    this->GetInputDataObject(1, 0), this->GetSourceOptions(), {true, false}, executor);
  if (queries.grid() && queries.frame().isStraight())
  {
    nearest.addNumbers(
      *queries.grid(), queries.grid()->wholeExtent(), this->NearestCells, executor);
    return;
  }
  nearest.addNumbers(
    static_cast<std::size_t>(queries.size()),
    [&](std::size_t n) { return queries.frame().inSpace(queries.position(n)); }, this->NearestCells,
    executor);
}

winding::ResultOptions vtkWindingNumberProbe::GetResultOptions() const
{
  winding::ResultOptions options;
  options.withValues = this->GenerateWindingNumber != 0;
  options.withInside = this->GenerateInside != 0;
  options.withDistances = this->WantsDistances();
  options.withFraction = this->GenerateFraction != 0;
  options.withNearest = this->GenerateNearestCells != 0;
  options.scalarType = this->OutputScalarType;
  options.name = winding::textOf(this->ResultArrayName);
  const std::string insideName = winding::textOf(this->InsideArrayName);
  options.insideName = insideName.empty() ? "Inside" : insideName;
  return options;
}

std::size_t vtkWindingNumberProbe::GetAdditionalBytes(const winding::Field& field, vtkIdType)
{
  const winding::FieldInfo& info = field.info();
  const auto cells = static_cast<std::size_t>(this->CellsToFill);
  const std::size_t ofFractions =
    cells == 0 ? 0 : winding::bytesOfCellFractions(field, cells) + cells * sizeof(float);
  const std::size_t ofNearest = this->GenerateNearestCells ? winding::NearestAttributes::bytesFor(
                                                               info.isSurface, info.inputPrimitives)
                                                           : 0;
  return ofFractions + ofNearest;
}

int vtkWindingNumberProbe::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Fractions = nullptr; // of a request that was refused
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  this->CellsToFill = this->GenerateFraction ? input->GetNumberOfElements(vtkDataObject::CELL) : 0;
  const int isDone = this->Superclass::RequestData(request, inputs, outputs);
  this->Fractions = nullptr;
  return isDone;
}

void vtkWindingNumberProbe::EvaluateMore(
  const winding::Field& field, const winding::ProbeQueries& queries, winding::SmpExecutor& executor)
{
  if (!this->GenerateFraction)
  {
    return;
  }
  const winding::ProbeCells cells(queries);
  const auto count = static_cast<vtkIdType>(cells.size());
  winding::refuseBeyondFreeMemory(
    static_cast<double>(
      winding::bytesOfCellFractions(field, cells.size()) + cells.size() * sizeof(float)),
    "the fractions of " + std::to_string(count) + " cells", winding::wordsOfProbe.remedies);
  this->Fractions = vtkSmartPointer<vtkFloatArray>::New();
  this->Fractions->SetName(winding::fractionName);
  this->Fractions->SetNumberOfTuples(count);
  float* const fractions = this->Fractions->GetPointer(0);
  executor.setShare(this->GetProgressOfSamples(), 1);
  const winding::CellsWithoutFraction counts =
    winding::evaluateFractions(field, cells, this->GetInsideTest(), fractions, executor);
  for (vtkIdType i = 0; this->InsideOut && i < count; ++i)
  {
    fractions[i] = 1 - fractions[i];
  }
  const std::vector<winding::Message> warnings = winding::warningsOf(counts, cells.size());
  if (!warnings.empty())
  {
    vtkWarningMacro(<< winding::lineOf(warnings));
  }
}

void vtkWindingNumberProbe::AddLeafArrays(vtkDataSet* answer, const winding::ProbeLeaf& leaf) const
{
  if (!this->Fractions)
  {
    return;
  }
  vtkSmartPointer<vtkFloatArray> part = this->Fractions;
  const vtkIdType count = leaf.data->GetNumberOfCells();
  if (count != part->GetNumberOfTuples())
  {
    part = vtkSmartPointer<vtkFloatArray>::New();
    part->SetName(winding::fractionName);
    part->SetNumberOfTuples(count);
    part->InsertTuples(0, count, leaf.firstCell, this->Fractions);
  }
  answer->GetCellData()->AddArray(part);
}

void vtkWindingNumberProbe::AddArrays(
  const winding::ResultArrays& results, vtkDataSetAttributes* ofAll) const
{
  results.addTo(ofAll);
  if (!this->GenerateInside)
  {
    ofAll->RemoveArray(results.inside()->GetName());
  }
  for (int i = 0; i < this->NearestCells->GetNumberOfArrays(); ++i)
  {
    ofAll->AddArray(this->NearestCells->GetArray(i));
  }
}

vtkSmartPointer<vtkDataSet> vtkWindingNumberProbe::PartOf(
  vtkDataSet* data, const winding::ProbeLeaf&, const unsigned char* inside)
{
  return winding::insidePart(data, inside, this->SamplesCells());
}

const char* vtkWindingNumberProbe::GetOutputScalarTypeAsString() const
{
  return winding::nameOfChoice(winding::Parameter::outputScalarType, this->OutputScalarType);
}

const char* vtkWindingNumberProbe::GetProbeAssociationAsString() const
{
  return winding::nameOfChoice(winding::Parameter::probeAssociation, this->ProbeAssociation);
}

void vtkWindingNumberProbe::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ProbeAssociation: " << this->ProbeAssociation << "\n";
  os << indent << "GenerateWindingNumber: " << this->GenerateWindingNumber << "\n";
  os << indent << "GenerateInside: " << this->GenerateInside << "\n";
  os << indent << "GenerateSignedDistance: " << this->GenerateSignedDistance << "\n";
  os << indent << "GenerateFraction: " << this->GenerateFraction << "\n";
  os << indent << "GenerateNearestCells: " << this->GenerateNearestCells << "\n";
  os << indent << "ResultArrayName: " << winding::textOf(this->ResultArrayName) << "\n";
  os << indent << "OutputScalarType: " << this->OutputScalarType << "\n";
  os << indent << "ExtractInside: " << this->ExtractInside << "\n";
  os << indent << "InsideArrayName: " << winding::textOf(this->InsideArrayName) << "\n";
}
