// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindingNumberField.h"

#include "base/Executor.h"
#include "messages/Options.h"
#include "messages/PropertyChecks.h"
#include "pipeline/ErrorReports.h"
#include "pipeline/FreeMemory.h"
#include "pipeline/Ranks.h"
#include "pipeline/SmpExecutor.h"
#include "private/output/NearestAttributes.h"
#include "private/output/ResultArrays.h"
#include "private/output/TimeUnion.h"
#include "private/source/ContentHash.h"
#include "private/source/SourceProperties.h"
#include "source/Grid.h"
#include "tasks/MendedSource.h"
#include "tasks/ResultNotes.h"
#include "tasks/Sentences.h"
#include "voxels/SampleBits.h"
#include "voxels/VoxelEvaluation.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cstdint>
#include <string>

vtkStandardNewMacro(vtkWindingNumberField);

vtkWindingNumberField::vtkWindingNumberField()
{
  this->MendSource = 0; // w is of the source as it is
  this->SetResultArrayName("WindingNumber");
}

vtkWindingNumberField::~vtkWindingNumberField()
{
  this->SetResultArrayName(nullptr);
}

void vtkWindingNumberField::CheckProperties()
{
  this->Superclass::CheckProperties();
  winding::checkProperty(winding::Parameter::outputScalarType, this->OutputScalarType);
  winding::checkProperty(winding::Parameter::distanceBand, this->DistanceBand);
  if (this->GenerateNearestCells)
  {
    winding::refuseNearestOfOtherRanks(
      this->GetRanks(), winding::sourceDistribution(this->SourceDistribution));
  }
}

void vtkWindingNumberField::HashProperties(winding::ContentHash& hash)
{
  this->Superclass::HashProperties(hash);
  winding::addTo(hash, this->GetResultOptions());
  hash.addValue(this->DistanceBand);
}

double vtkWindingNumberField::GetDistanceLimit() const
{
  return this->DistanceBand > 0 ? this->DistanceBand * this->GetSampling().spacing.maxCoeff()
                                : this->Superclass::GetDistanceLimit();
}

int vtkWindingNumberField::GetActiveScalarType() const
{
  const bool scalarsAreSides =
    this->ShowsInside() || (this->GenerateInside && !this->GenerateWindingNumber);
  return scalarsAreSides ? VTK_UNSIGNED_CHAR : this->OutputScalarType;
}

bool vtkWindingNumberField::ShowsInside() const
{
  const winding::InsideTest plain;
  const bool isPlain = this->InsideRule == SIGNED && this->WindingThreshold == plain.threshold;
  return this->Coverage != CENTER || (this->GenerateInside && !isPlain);
}

void vtkWindingNumberField::MakeImage(vtkDataObject* source, const winding::Extent& samples,
  vtkImageData* image, vtkDataSetAttributes* attributes)
{
  this->CheckVerification(this->GenerateWindingNumber != 0);
  const winding::ResultArrays results(
    static_cast<vtkIdType>(winding::sampleCount(samples)), this->GetResultOptions());
  const winding::Field& field = this->PrepareGridField(source);
  this->EvaluateVoxels(field, samples, results);
  results.addTo(attributes);
  this->AddNearestCells(source, samples, attributes);
  this->DescribeMethod(image);
  this->Verify(field, samples, results.values());
}

void vtkWindingNumberField::CheckUnion() const
{
  if (this->GenerateNearestCells)
  {
    throw winding::Refusal(winding::messageOf(winding::Sentence::nearestCellsOfTimes));
  }
}

void vtkWindingNumberField::UniteTimes(vtkImageData* all, vtkImageData* other)
{
  const std::string name = winding::textOf(this->ResultArrayName);
  const std::string ofValues = name.empty() ? "WindingNumber" : name;
  this->NumberOfInsideSamples = winding::uniteResults(this->GetAttributes(all),
    this->GetAttributes(other), this->GenerateWindingNumber ? ofValues : "", this->GetInsideTest());
  this->SampleCounts[1] = this->NumberOfInsideSamples;
}

winding::ResultOptions vtkWindingNumberField::GetResultOptions() const
{
  winding::ResultOptions options;
  options.withValues = this->GenerateWindingNumber != 0;
  options.withInside = this->GenerateInside != 0 || this->Coverage != CENTER;
  options.showsInside = this->ShowsInside();
  options.withDistances = this->WantsDistances();
  options.withCoverage = this->Coverage == FRACTION;
  options.withNearest = this->GenerateNearestCells != 0;
  options.scalarType = this->OutputScalarType;
  options.name = winding::textOf(this->ResultArrayName);
  return options;
}

double vtkWindingNumberField::GetResultBytes(vtkIdType samples) const
{
  return winding::bytesOf(this->GetResultOptions(), samples);
}

std::size_t vtkWindingNumberField::GetAdditionalBytes(
  const winding::Field& field, vtkIdType samples)
{
  const winding::FieldInfo& info = field.info();
  std::size_t bytes = this->Superclass::GetAdditionalBytes(field, samples);
  if (this->GenerateNearestCells)
  {
    bytes += winding::NearestAttributes::bytesFor(info.isSurface, info.inputPrimitives);
  }
  return bytes + this->GetSweptWords(samples) * sizeof(std::uint64_t);
}

std::size_t vtkWindingNumberField::GetSweptWords(vtkIdType voxels) const
{
  return this->SweptSamples && this->Coverage == FRACTION
           ? static_cast<std::size_t>(voxels) *
               winding::SampleBits::wordsPerVoxel(this->CoverageSamples)
           : 0;
}

void vtkWindingNumberField::AddNearestCells(
  vtkDataObject* source, const winding::Extent& samples, vtkDataSetAttributes* attributes)
{
  if (!this->GenerateNearestCells)
  {
    return;
  }
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  executor.setShare(1, 1);
  const winding::NearestAttributes nearest(
    source, this->GetSourceOptions(), {true, false}, executor);
  const winding::Grid& grid = this->GetSampling();
  if (this->Frame->isStraight())
  {
    nearest.addNumbers(grid, samples, attributes, executor);
    return;
  }
  nearest.addNumbers(
    winding::sampleCount(samples),
    [&](std::size_t n) { return this->Frame->inSpace(grid.sample(samples, n)); }, attributes,
    executor);
}

void vtkWindingNumberField::EvaluateVoxels(
  const winding::Field& given, const winding::Extent& samples, const winding::ResultArrays& results)
{
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  const winding::Grid& grid = this->GetSampling();
  winding::VoxelEvaluation voxels = this->GetVoxelEvaluation();
  voxels.output = results.output(this->GetInsideTest());
  voxels.output.distanceLimit = this->GetDistanceLimit();
  winding::SideTally sides;
  const bool isWhole = samples == grid.wholeExtent();
  voxels.output.sides = &sides;
  voxels.fractions = results.coverage() ? results.coverage()->GetPointer(0) : nullptr;

  const std::size_t count = winding::sampleCount(samples);
  const std::size_t sweptWords = this->GetSweptWords(static_cast<vtkIdType>(count));
  if (voxels.coverage != winding::Coverage::center)
  {
    const std::size_t present = this->SweptSamples ? this->SweptSamples->size() : 0;
    const std::size_t additional =
      voxels.additionalBytes(given, count) +
      (sweptWords - std::min(present, sweptWords)) * sizeof(std::uint64_t);
    winding::refuseBeyondFreeMemory(
      this->GetResultBytes(static_cast<vtkIdType>(count)) + static_cast<double>(additional),
      "the coverage of " + std::to_string(count) + " voxels",
      {winding::largerVoxels(), winding::inPieces()});
  }
  if (sweptWords > 0)
  {
    this->SweptSamples->resize(sweptWords);
    voxels.united = this->SweptSamples->data();
  }
  this->Evaluate(given, static_cast<vtkIdType>(count), executor,
    [&]
    {
      winding::Run run = this->MakeRun(executor);
      const bool mayThicken = this->Coverage != ANY && sweptWords == 0;
      winding::MendedSource source(
        given, grid, {this->MendsSource(), mayThicken, voxels.output.isInside}, run);
      source.decideByLayers();
      const winding::Field& field = source.field();
      voxels.plate = source.plate();
      voxels.run(field, grid, samples, executor);
      const winding::SideCounts counts = sides.counts(count);
      this->NumberOfInsideSamples =
        results.countInside().value_or(static_cast<vtkIdType>(counts.inside));
      const vtkIdType all[4] = {static_cast<vtkIdType>(count), this->NumberOfInsideSamples,
        static_cast<vtkIdType>(counts.inside), static_cast<vtkIdType>(counts.negative)};
      std::copy_n(all, 4, this->SampleCounts);
      if (isWhole && voxels.plate == 0)
      {
        if (this->MendsSource())
        {
          winding::warnOfOpenSide(field, {this->WindingThreshold, this->TakesTouchedVoxels()}, run);
        }
        winding::ResultOnGrid result;
        result.sides = counts;
        result.isInside = [&](int i, int j, int k)
        {
          return results.isInside(winding::sampleNumber(samples, i, j, k), voxels.output.isInside);
        };
        // Warnings are about this time, whatever earlier ones have inside.
        result.isEmpty = sweptWords > 0 ? counts.inside == 0 : this->NumberOfInsideSamples == 0;
        this->WarnOfResult(field, result);
      }
    });
}

void vtkWindingNumberField::WarnOfPieces(const vtkIdType counts[4])
{
  winding::ResultOnGrid result;
  result.sides.samples = static_cast<std::size_t>(counts[0]);
  result.sides.inside = static_cast<std::size_t>(counts[2]);
  result.sides.negative = static_cast<std::size_t>(counts[3]);
  result.isEmpty = counts[1] == 0;
  const winding::Outcome outcome = winding::reportErrors(this, this->NamesInMessages,
    {"not enough memory for this source", {winding::largerVoxels()}},
    [&]
    {
      winding::SmpExecutor executor(this, this->NumberOfThreads);
      executor.setShare(1, 1);
      const winding::Field& field = this->FieldOf(this->MakeSource(), executor);
      if (this->GetRanks().rank() == 0)
      {
        this->WarnOfResult(field, result);
      }
    });
  this->Status = static_cast<int>(outcome);
  this->ErrorCode = winding::errorCodeOf(outcome);
}

const char* vtkWindingNumberField::GetOutputScalarTypeAsString() const
{
  return winding::nameOfChoice(winding::Parameter::outputScalarType, this->OutputScalarType);
}

void vtkWindingNumberField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GenerateWindingNumber: " << this->GenerateWindingNumber << "\n";
  os << indent << "GenerateInside: " << this->GenerateInside << "\n";
  os << indent << "GenerateSignedDistance: " << this->GenerateSignedDistance << "\n";
  os << indent << "GenerateNearestCells: " << this->GenerateNearestCells << "\n";
  os << indent << "ResultArrayName: " << winding::textOf(this->ResultArrayName) << "\n";
  os << indent << "OutputScalarType: " << this->OutputScalarType << "\n";
  os << indent << "DistanceBand: " << this->DistanceBand << "\n";
  os << indent << "NumberOfInsideSamples: " << this->NumberOfInsideSamples << "\n";
}
