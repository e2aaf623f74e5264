// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindingNumberSurface.h"

#include "base/Executor.h"
#include "diagnosis/GridAdvice.h"
#include "field/Field.h"
#include "level/EdgeRoots.h"
#include "level/ShapedSolid.h"
#include "messages/Options.h"
#include "messages/PropertyChecks.h"
#include "pipeline/FreeMemory.h"
#include "pipeline/Ranks.h"
#include "pipeline/SmpExecutor.h"
#include "private/output/ResultArrays.h"
#include "private/output/SurfaceFidelity.h"
#include "private/source/ContentHash.h"
#include "private/source/SourceProperties.h"

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
  hash.addValue(this->Offset);
  hash.addValue(this->Shell);
  hash.addValue(this->ShellSide);
}

winding::SolidShape vtkWindingNumberSurface::GetShape() const
{
  winding::SolidShape shape;
  shape.fillsCavities = this->FillCavities != 0;
  shape.offset = this->Offset;
  shape.shell = this->Shell;
  shape.shellSide = static_cast<winding::ShellSide>(this->ShellSide);
  return shape;
}

bool vtkWindingNumberSurface::InsideMatters(const winding::FieldInfo& info) const
{
  return !winding::isSheet(info, this->GetShape());
}

double vtkWindingNumberSurface::GetReachBeyondSource() const
{
  return this->GetShape().reach();
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
  this->LayGridOver(source);
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
  double edges = 0;
  double ofSurface = this->GetBytesOfSurface(field, edges);
  const double ofShape =
    winding::ShapedSolid::bytesFor(field, this->GetSampling(), this->GetShape(), edges);
  if (ofShape > 0)
  {
    ofSurface += ofShape;
    winding::refuseBeyondFreeMemory(ofSurface, "the surface", {winding::largerVoxels()});
  }
  auto bytes = static_cast<std::size_t>(ofSurface) + this->GetBytesOfNearest(field);
  if (this->FidelitySamples > 0)
  {
    // The surface has about two triangles for each edge of the grid that it crosses.
    winding::refuseFidelityBeyondFreeMemory(
      field, 2 * edges, static_cast<std::size_t>(this->FidelitySamples));
  }
  if (this->GenerateDistanceToInput)
  {
    // A vertex has its place and its distance, in double.
    constexpr std::size_t perVertex = 4 * sizeof(double);
    const auto vertices = static_cast<std::size_t>(edges);
    bytes += field.expectedBytesOfDistances(vertices) + perVertex * vertices;
  }
  return bytes;
}

/// Returns the tree of the surface that distances are measured from, or null.
std::shared_ptr<const winding::DistanceTree> vtkWindingNumberSurface::MakeSurface(
  const winding::Field& field, vtkPolyData* output)
{
  std::shared_ptr<const winding::DistanceTree> surfaceTree;
  const winding::Grid& grid = this->GetSampling();
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  this->Evaluate(field, static_cast<vtkIdType>(winding::sampleCount(grid.wholeExtent())), executor,
    [&]
    {
      winding::LevelEdges edges(field, grid, winding::coreInsideRule(this->InsideRule),
        this->WindingThreshold, this->CloseBorder != 0);
      this->FindEdges(edges, field, executor);
      const winding::SolidShape shape = this->GetShape();
      const bool isAllInside = shape.isPlain() ? this->TellAllInside(edges) : edges.areAllInside();
      if (this->InsideMatters(field.info()))
      {
        this->WarnOfGrid(field, edges.size() == 0 && !isAllInside,
          [&edges](int i, int j, int k) {
            return edges.isSampleInside({i, j, k});
          });
      }
      winding::EdgeRoots roots(0);
      const auto findRoots = [&]() -> const winding::EdgeRoots&
      {
        roots = this->FindRoots(field, edges, executor);
        return roots;
      };
      if (shape.isPlain())
      {
        this->MakePolyData(edges, findRoots, nullptr, executor, output);
        this->TellOpen(edges);
        this->MakeImage(edges, executor);
      }
      else
      {
        findRoots();
        const winding::ShapedSolid shaped(field, grid, winding::coreInsideRule(this->InsideRule),
          this->WindingThreshold, this->Tolerance, edges, roots, shape, this->Features == SHARP,
          executor);
        this->MakePolyData(
          shaped.edges(), [&]() -> const winding::EdgeRoots& { return shaped.roots(); }, nullptr,
          executor, output);
        this->TellOpen(shaped.edges());
        this->MakeImage(shaped.edges(), executor);
        this->TellShape(shaped, output);
        surfaceTree = shaped.surfaceTree();
      }
      this->UpdateProgress(1);
    });
  return surfaceTree;
}

/// Adds to the field data of the output how its shape came about, and warns of what it lost.
void vtkWindingNumberSurface::TellShape(const winding::ShapedSolid& shaped, vtkPolyData* output)
{
  const winding::SolidShape shape = this->GetShape();
  if (shape.fillsCavities)
  {
    vtkNew<vtkIntArray> cavities;
    cavities->SetName("FilledCavities");
    cavities->InsertNextValue(static_cast<int>(shaped.cavities()));
    output->GetFieldData()->AddArray(cavities);
  }
  if (shape.hasDistances())
  {
    vtkNew<vtkStringArray> base;
    base->SetName("DistancesFrom");
    base->InsertNextValue(shaped.base() == winding::DistanceBase::source ? "source" : "surface");
    output->GetFieldData()->AddArray(base);
  }
  const bool isEmpty = shaped.edges().size() == 0;
  const bool isAllInside = shaped.edges().areAllInside();
  const auto advice = winding::shapeAdvice(this->GetSampling(), shape, isEmpty, isAllInside);
  if (advice && !(isAllInside && this->GenerateImage))
  {
    vtkWarningMacro(<< winding::lineOf(*advice));
  }
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
    const winding::SolidShape shape = this->GetShape();
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
    field.evaluate(grid, extent,
      values.output(winding::coreInsideRule(this->InsideRule), this->WindingThreshold), executor);
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
  os << indent << "Offset: " << this->Offset << "\n";
  os << indent << "Shell: " << this->Shell << "\n";
  os << indent << "ShellSide: " << this->ShellSide << "\n";
  os << indent << "GenerateDistanceToInput: " << this->GenerateDistanceToInput << "\n";
  os << indent << "FidelitySamples: " << this->FidelitySamples << "\n";
  os << indent << "FidelityInWords: " << this->FidelityInWords << "\n";
}
