#include "vtkWindingNumberSurface.h"

#include "base/Executor.h"
#include "field/Field.h"
#include "level/EdgeRoots.h"
#include "messages/Options.h"
#include "messages/PropertyChecks.h"
#include "private/output/ResultArrays.h"
#include "private/output/SurfaceFidelity.h"
#include "private/pipeline/FreeMemory.h"
#include "private/pipeline/Ranks.h"
#include "private/pipeline/SmpExecutor.h"
#include "private/source/ContentHash.h"
#include "private/source/SourceProperties.h"
#include "report/GridAdvice.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <string>

vtkStandardNewMacro(vtkWindingNumberSurface);

void vtkWindingNumberSurface::CheckProperties()
{
  this->Superclass::CheckProperties();
  winding::checkProperty(winding::Parameter::fidelitySamples, this->FidelitySamples);
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
}

int vtkWindingNumberSurface::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  vtkPolyData* output = vtkPolyData::GetData(outInfo);
  if (this->IsLaterPiece(outInfo))
  {
    return 1;
  }
  this->FidelityInWords.clear();
  this->AgreeOnProperties();
  vtkDataObject* source = vtkDataObject::GetData(inputs[0]);
  this->LayOutGrid(source);
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
  this->MakeSurface(field, output);
  this->DescribeMethod(output);
  this->CompareWithSource(field, output);
  this->VerifyWholeGrid(field);
  return 1;
}

std::size_t vtkWindingNumberSurface::GetAdditionalBytes(const winding::Field& field, vtkIdType)
{
  double edges = 0;
  auto bytes = static_cast<std::size_t>(this->GetBytesOfSurface(field, edges));
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

void vtkWindingNumberSurface::MakeSurface(const winding::Field& field, vtkPolyData* output)
{
  const winding::Grid& grid = this->GetSampling();
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  this->Evaluate(field, static_cast<vtkIdType>(winding::sampleCount(grid.wholeExtent())), executor,
    [&]
    {
      winding::LevelEdges edges(field, grid, winding::coreInsideRule(this->InsideRule),
        this->WindingThreshold, this->CloseBorder != 0);
      this->FindEdges(edges, field, executor);
      const bool isAllInside = this->TellAllInside(edges);
      this->WarnOfGrid(field, edges.size() == 0 && !isAllInside,
        [&edges](int i, int j, int k) {
          return edges.isSampleInside({i, j, k});
        });
      winding::EdgeRoots roots(0);
      this->MakePolyData(
        edges,
        [&]() -> const winding::EdgeRoots&
        {
          roots = this->FindRoots(field, edges, executor);
          return roots;
        },
        nullptr, executor, output);
      this->UpdateProgress(1);
    });
}

void vtkWindingNumberSurface::CompareWithSource(const winding::Field& field, vtkPolyData* output)
{
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  executor.setShare(1, 1);
  if (this->GenerateDistanceToInput)
  {
    winding::addDistances(field, output, executor);
  }
  if (this->FidelitySamples > 0)
  {
    this->FidelityInWords =
      winding::inWords(winding::addFidelity(field, this->GetSampling().spacing.maxCoeff(),
        static_cast<std::size_t>(this->FidelitySamples), output, executor));
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

void vtkWindingNumberSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GenerateDistanceToInput: " << this->GenerateDistanceToInput << "\n";
  os << indent << "FidelitySamples: " << this->FidelitySamples << "\n";
  os << indent << "FidelityInWords: " << this->FidelityInWords << "\n";
}
