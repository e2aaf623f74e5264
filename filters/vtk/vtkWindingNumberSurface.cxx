// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindingNumberSurface.h"

#include "base/Executor.h"
#include "diagnosis/GridAdvice.h"
#include "field/Field.h"
#include "messages/Options.h"
#include "messages/PropertyChecks.h"
#include "pipeline/Ranks.h"
#include "pipeline/SmpExecutor.h"
#include "private/output/ArraySink.h"
#include "private/output/ResultArrays.h"
#include "private/output/SurfaceFidelity.h"
#include "private/source/ContentHash.h"
#include "private/source/SourceProperties.h"
#include "tasks/SurfaceTask.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <string>

vtkStandardNewMacro(vtkWindingNumberSurface);

void vtkWindingNumberSurface::CheckProperties()
{
  this->Superclass::CheckProperties();
  winding::checkProperty(winding::Parameter::fidelitySamples, this->FidelitySamples);
  winding::checkProperty(winding::Parameter::gapWidth, this->GapWidth);
  winding::checkProperty(winding::Parameter::offset, this->Offset);
  winding::checkProperty(winding::Parameter::shell, this->Shell);
  winding::checkProperty(winding::Parameter::shellSide, this->ShellSide);
}

const char* vtkWindingNumberSurface::GetFidelityInWords() const
{
  return this->FidelityInWords.c_str();
}

void vtkWindingNumberSurface::HashProperties(winding::ContentHash& hash)
{
  this->Superclass::HashProperties(hash);
  hash.addValue(this->FidelitySamples);
  hash.addValue(this->GenerateDistanceToInput);
  hash.addValue(this->FillCavities);
  hash.addValue(this->GapWidth);
  hash.addValue(this->Offset);
  hash.addValue(this->Shell);
  hash.addValue(this->ShellSide);
}

winding::SurfaceOptions vtkWindingNumberSurface::GetSurfaceOptions() const
{
  winding::SurfaceOptions options = this->Superclass::GetSurfaceOptions();
  options.shape.fillsCavities = this->FillCavities != 0;
  options.shape.gapWidth = this->GapWidth;
  options.shape.offset = this->Offset;
  options.shape.shell = this->Shell;
  options.shape.shellSide = static_cast<winding::ShellSide>(this->ShellSide);
  return options;
}

double vtkWindingNumberSurface::GetReachBeyondSource() const
{
  return this->GetSurfaceOptions().shape.reach();
}

int vtkWindingNumberSurface::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (this->IsLaterPiece(GetRequestedOutput(request, outputs)))
  {
    return 1;
  }
  this->FidelityInWords.clear();
  this->AgreeOnProperties();
  vtkDataObject* source = vtkDataObject::GetData(inputs[0]);
  this->SetUpGridOver(source);
  if (!this->CloseBorder)
  {
    winding::refuseFlatGrid(this->GetSampling());
  }
  this->CheckVerification(true);
  const winding::Field& field = this->PrepareGridField(source);
  if (this->IsHelper())
  {
    return 1;
  }
  const auto surfaceTree = this->MakeSurface(field, output);
  this->DescribeMethod(output);
  this->CompareWithSource(field, surfaceTree.get(), output);
  this->AddNearest(source, output);
  this->VerifyWholeGrid(field);
  return 1;
}

std::size_t vtkWindingNumberSurface::GetAdditionalBytes(const winding::Field& field, vtkIdType)
{
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  winding::Run run = this->MakeRun(executor);
  const winding::SurfaceNeeds needs =
    winding::claimSurface(field, this->GetSampling(), this->GetSurfaceOptions(), run);
  auto bytes = static_cast<std::size_t>(needs.bytes) + this->GetBytesOfNearest(field);
  if (this->FidelitySamples > 0)
  {
    // The surface has about two triangles for each edge of the grid that it crosses.
    winding::refuseFidelityBeyondFreeMemory(
      field, 2 * needs.edges, static_cast<std::size_t>(this->FidelitySamples));
  }
  if (this->GenerateDistanceToInput)
  {
    // A vertex has its place and its distance, in double.
    constexpr std::size_t perVertex = 4 * sizeof(double);
    const auto vertices = static_cast<std::size_t>(needs.edges);
    bytes += field.expectedBytesOfDistances(vertices) + perVertex * vertices;
  }
  return bytes;
}

/// Returns the tree of the surface that distances are measured from, or null.
std::shared_ptr<const winding::DistanceTree> vtkWindingNumberSurface::MakeSurface(
  const winding::Field& field, vtkPolyData* output)
{
  const winding::Grid& grid = this->GetSampling();
  const winding::SurfaceOptions options = this->GetSurfaceOptions();
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  winding::Run run = this->MakeRun(executor);
  winding::ArraySink sink;
  winding::SurfaceResult result;
  this->Evaluate(field, static_cast<vtkIdType>(winding::sampleCount(grid.wholeExtent())), executor,
    [&] { result = winding::makeSurface(field, grid, options, sink, run); });
  this->SourceIsInsideOut = result.facing.isInsideOut;
  this->AddResult(sink, output);
  if (this->FillCavities)
  {
    vtkNew<vtkIntArray> cavities;
    cavities->SetName("FilledCavities");
    cavities->InsertNextValue(static_cast<int>(result.cavities));
    output->GetFieldData()->AddArray(cavities);
  }
  if (options.shape.hasDistances())
  {
    vtkNew<vtkStringArray> base;
    base->SetName("DistancesFrom");
    base->InsertNextValue(
      result.distancesFrom == winding::DistanceBase::source ? "source" : "surface");
    output->GetFieldData()->AddArray(base);
  }
  return result.surfaceTree;
}

void vtkWindingNumberSurface::CompareWithSource(
  const winding::Field& field, const winding::DistanceTree* surfaceTree, vtkPolyData* output)
{
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  executor.setShare(1, 1);
  if (this->GenerateDistanceToInput)
  {
    winding::addDistances(field, output, executor);
  }
  if (this->FidelitySamples > 0)
  {
    const winding::SolidShape shape = this->GetSurfaceOptions().shape;
    winding::WantedDistances wanted = {surfaceTree, shape.band()};
    if (shape.hasDistances() && !wanted.from)
    {
      wanted.from = &field.distanceTree(executor);
    }
    this->FidelityInWords = winding::inWords(winding::addFidelity(field,
      this->GetSampling().spacing.maxCoeff(), static_cast<std::size_t>(this->FidelitySamples),
      shape.hasDistances() ? &wanted : nullptr, output, executor));
  }
}

/// Nothing else needs all of its values.
void vtkWindingNumberSurface::VerifyWholeGrid(const winding::Field& field)
{
  const winding::Grid& grid = this->GetSampling();
  const winding::Extent extent = grid.wholeExtent();
  winding::ResultOptions options;
  const vtkIdType samples = this->VerifySamples > 0 ? winding::sampleCount(extent) : 0;
  const winding::ResultArrays values(samples, options);
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  if (samples > 0)
  {
    field.evaluate(grid, extent, values.output(this->GetInsideTest()), executor);
  }
  this->Verify(field, extent, values.values());
}

const char* vtkWindingNumberSurface::GetShellSideAsString() const
{
  return winding::nameOfChoice(winding::Parameter::shellSide, this->ShellSide);
}

void vtkWindingNumberSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FillCavities: " << this->FillCavities << "\n";
  os << indent << "GapWidth: " << this->GapWidth << "\n";
  os << indent << "Offset: " << this->Offset << "\n";
  os << indent << "Shell: " << this->Shell << "\n";
  os << indent << "ShellSide: " << this->ShellSide << "\n";
  os << indent << "GenerateDistanceToInput: " << this->GenerateDistanceToInput << "\n";
  os << indent << "FidelitySamples: " << this->FidelitySamples << "\n";
  os << indent << "FidelityInWords: " << this->FidelityInWords << "\n";
}
