#include "vtkWindingNumberField.h"

#include "base/Executor.h"
#include "field/InsideOut.h"
#include "private/output/ResultArrays.h"
#include "private/pipeline/FreeMemory.h"
#include "private/pipeline/PropertyChecks.h"
#include "private/pipeline/SmpExecutor.h"
#include "private/source/ContentHash.h"
#include "source/Grid.h"
#include "voxels/VoxelEvaluation.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkWindingNumberField);

void vtkWindingNumberField::CheckProperties()
{
  this->Superclass::CheckProperties();
  winding::checkProperty(winding::Parameter::distanceBand, this->DistanceBand);
}

void vtkWindingNumberField::HashProperties(winding::ContentHash& hash)
{
  this->Superclass::HashProperties(hash);
  hash.addValue(this->DistanceBand);
}

double vtkWindingNumberField::GetDistanceLimit() const
{
  return this->DistanceBand > 0 ? this->DistanceBand * this->GetSampling().spacing.maxCoeff()
                                : this->Superclass::GetDistanceLimit();
}

int vtkWindingNumberField::GetActiveScalarType() const
{
  const bool scalarsAreSides = this->GenerateInside && !this->GenerateWindingNumber;
  return scalarsAreSides ? VTK_UNSIGNED_CHAR : this->OutputScalarType;
}

void vtkWindingNumberField::MakeImage(vtkDataObject* source, const int samples[6],
  vtkImageData* image, vtkDataSetAttributes* attributes)
{
  this->CheckVerification(this->GenerateWindingNumber != 0);
  winding::Extent extent;
  std::copy_n(samples, 6, extent.begin());
  const winding::ResultArrays results =
    this->MakeResults(static_cast<vtkIdType>(winding::sampleCount(extent)));
  const winding::Field& field = this->PrepareGridField(source);
  this->EvaluateVoxels(field, samples, results);
  this->AddResults(results, image, attributes);
  this->Verify(field, samples, results.values());
}

winding::ResultOptions vtkWindingNumberField::GetResultOptions() const
{
  winding::ResultOptions options = this->Superclass::GetResultOptions();
  options.withInside |= this->Coverage != CENTER;
  options.withCoverage = this->Coverage == FRACTION;
  return options;
}

void vtkWindingNumberField::EvaluateVoxels(
  const winding::Field& field, const int samples[6], const winding::ResultArrays& results)
{
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  winding::VoxelEvaluation voxels = this->GetVoxelEvaluation();
  voxels.output = this->OutputTo(results);
  voxels.fractions = results.coverage() ? results.coverage()->GetPointer(0) : nullptr;

  const winding::Grid& grid = this->GetSampling();
  winding::Extent extent;
  std::copy_n(samples, 6, extent.begin());
  const std::size_t count = winding::sampleCount(extent);
  if (voxels.coverage != winding::Coverage::center)
  {
    winding::refuseBeyondFreeMemory(this->GetResultBytes(static_cast<vtkIdType>(count)) +
                                      static_cast<double>(voxels.additionalBytes(field, count)),
      "the coverage of " + std::to_string(count) + " voxels",
      {winding::largerVoxels(), winding::inPieces()});
  }
  this->Evaluate(field, static_cast<vtkIdType>(count), executor,
    [&]
    {
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
    });
}

void vtkWindingNumberField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DistanceBand: " << this->DistanceBand << "\n";
}
