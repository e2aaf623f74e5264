// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindingNumberHyperTree.h"

#include "level/VoxelTreesMemory.h"
#include "messages/Options.h"
#include "messages/PropertyChecks.h"
#include "pipeline/FreeMemory.h"
#include "pipeline/Ranks.h"
#include "pipeline/SmpExecutor.h"
#include "private/output/TreeGrid.h"
#include "private/source/ContentHash.h"
#include "private/source/SourceProperties.h"
#include "voxels/VoxelEvaluation.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkHyperTreeGrid.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <string>

using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkStandardNewMacro(vtkWindingNumberHyperTree);

vtkWindingNumberHyperTree::vtkWindingNumberHyperTree()
{
  this->SetResultArrayName("WindingNumber");
}

vtkWindingNumberHyperTree::~vtkWindingNumberHyperTree()
{
  this->SetResultArrayName(nullptr);
}

vtkHyperTreeGrid* vtkWindingNumberHyperTree::GetOutput()
{
  return vtkHyperTreeGrid::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkWindingNumberHyperTree::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkHyperTreeGrid");
  return 1;
}

int vtkWindingNumberHyperTree::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  this->LookAtSource(this->GetSource());
  this->FindBoundsOverAllTimes(outputs->GetInformationObject(0));
  // The pipeline wants an extent of this kind of data. The bricks are not known before the source
  // is, and nobody can ask for some of them.
  const int extent[6] = {0, 1, 0, 1, 0, 1};
  outputs->GetInformationObject(0)->Set(Pipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

void vtkWindingNumberHyperTree::CheckProperties()
{
  this->Superclass::CheckProperties();
  winding::checkProperty(winding::Parameter::coverage, this->Coverage);
  winding::checkProperty(winding::Parameter::coverageSamples, this->CoverageSamples);
  winding::checkProperty(winding::Parameter::mergeTolerance, this->MergeTolerance);
  winding::checkProperty(winding::Parameter::outputScalarType, this->OutputScalarType);
}

void vtkWindingNumberHyperTree::HashProperties(winding::ContentHash& hash)
{
  this->Superclass::HashProperties(hash);
  winding::addTo(hash, this->GetResultOptions());
  hash.addValue(this->Coverage);
  hash.addValue(this->CoverageSamples);
  hash.addValue(this->MergeTolerance);
  hash.addValue(this->MaskOutside);
}

winding::ResultOptions vtkWindingNumberHyperTree::GetResultOptions() const
{
  winding::ResultOptions options;
  const auto coverage = static_cast<winding::Coverage>(this->Coverage);
  options.withValues = this->GenerateWindingNumber != 0;
  options.withInside = this->GenerateInside != 0 || coverage != winding::Coverage::center;
  options.withCoverage = coverage == winding::Coverage::fraction;
  options.scalarType = this->OutputScalarType;
  options.name = winding::textOf(this->ResultArrayName);
  return options;
}

winding::VoxelTreeOptions vtkWindingNumberHyperTree::GetTreeOptions() const
{
  winding::VoxelTreeOptions options;
  const auto coverage = static_cast<winding::Coverage>(this->Coverage);
  options.withValues = this->GenerateWindingNumber != 0;
  options.asDouble = this->OutputScalarType == VTK_DOUBLE;
  options.withCoverage = coverage == winding::Coverage::fraction;
  options.byCenters = coverage == winding::Coverage::center;
  options.rule = winding::coreInsideRule(this->InsideRule);
  options.threshold = this->WindingThreshold;
  options.tolerance = this->MergeTolerance;
  return options;
}

/// Returns 0: GetAdditionalBytes() has everything that the result takes.
double vtkWindingNumberHyperTree::GetResultBytes(vtkIdType) const
{
  return 0;
}

std::size_t vtkWindingNumberHyperTree::GetAdditionalBytes(
  const winding::Field& field, vtkIdType samples)
{
  const winding::Grid& grid = this->GetSampling();
  const winding::VoxelTreeOptions options = this->GetTreeOptions();
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  executor.setShare(0, 0);
  const std::size_t bytes = winding::bytesOfVoxelTrees(
    field, grid, options, winding::expectedVertices(field, grid, options, executor));
  std::vector<winding::Remedy> remedies = {winding::largerVoxels()};
  if (options.withValues && !field.integerRows())
  {
    remedies.push_back(
      {"choose a larger tolerance of cells", {winding::Parameter::mergeTolerance}});
    remedies.push_back({"choose Inside alone", {{winding::Parameter::generateWindingNumber, 0}}});
  }
  winding::refuseBeyondFreeMemory(static_cast<double>(bytes),
    "the hyper tree grid of " + std::to_string(samples) + " voxels", remedies);
  return bytes;
}

int vtkWindingNumberHyperTree::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  vtkHyperTreeGrid* output = vtkHyperTreeGrid::GetData(outInfo);
  output->Initialize();
  if (outInfo->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0 && this->GetRanks().isAlone())
  {
    return 1;
  }
  this->AgreeOnProperties();
  this->CheckVerification(this->GenerateWindingNumber != 0);
  vtkDataObject* source = this->GetSource();
  this->LayOutGrid(source);
  const winding::Field& field = this->PrepareGridField(source);
  if (this->IsHelper())
  {
    return 1;
  }
  this->MakeTrees(field, output);
  this->DescribeMethod(output);
  this->TellTolerance(field, output);
  return 1;
}

void vtkWindingNumberHyperTree::MakeTrees(const winding::Field& field, vtkHyperTreeGrid* output)
{
  const winding::Grid& grid = this->GetSampling();
  const winding::VoxelTreeOptions options = this->GetTreeOptions();
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  winding::SideTally sides;
  std::size_t samples = 0;
  winding::VoxelTrees trees(field, grid, options,
    [&](const winding::Extent& extent, const winding::VoxelArrays& arrays)
    {
      winding::VoxelEvaluation voxels;
      voxels.coverage = static_cast<winding::Coverage>(this->Coverage);
      voxels.samplesPerAxis = this->CoverageSamples;
      voxels.output.values = arrays.values;
      voxels.output.doubleValues = arrays.doubleValues;
      voxels.output.inside = arrays.inside;
      voxels.output.rule = options.rule;
      voxels.output.threshold = options.threshold;
      voxels.output.sides = &sides;
      samples += winding::sampleCount(extent);
      voxels.fractions = arrays.coverage;
      voxels.run(field, grid, extent, executor);
    });
  winding::TreeGrid made(
    grid, trees.bricks(), this->GetResultOptions(), this->MaskOutside != 0, output);
  const winding::Extent extent = grid.wholeExtent();
  this->Evaluate(field, static_cast<vtkIdType>(winding::sampleCount(extent)), executor,
    [&]
    {
      while (!trees.isDone())
      {
        executor.setShare(trees.progress(), trees.nextProgress());
        for (const winding::VoxelTree& tree : trees.advance(executor))
        {
          made.add(tree);
        }
      }
      made.finish();
      this->NumberOfVertices = made.size();
      this->NumberOfLeaves = made.leaves();
      executor.setShare(1, 1);
      winding::SideCounts counts = sides.counts(samples);
      counts += trees.sides();
      this->TellSides(field, counts, executor);
      this->NumberOfInsideSamples = static_cast<vtkIdType>(trees.inside());
      this->WarnOfGrid(field, trees.inside() == 0,
        [&](int i, int j, int k) {
          return made.isInside({i, j, k}, options.rule, options.threshold);
        });
      this->UpdateProgress(1);
    });
  this->Verify(
    field, extent, [&](std::size_t n) { return made.valueAt(winding::sampleIndex(extent, n)); });
}

void vtkWindingNumberHyperTree::TellTolerance(
  const winding::Field& field, vtkHyperTreeGrid* output) const
{
  if (this->GenerateWindingNumber && this->MergeTolerance > 0 && !field.integerRows())
  {
    vtkNew<vtkDoubleArray> tolerance;
    tolerance->SetName("MergeTolerance");
    tolerance->InsertNextValue(this->MergeTolerance);
    output->GetFieldData()->AddArray(tolerance);
  }
}

const char* vtkWindingNumberHyperTree::GetCoverageAsString() const
{
  return winding::nameOfChoice(winding::Parameter::coverage, this->Coverage);
}

const char* vtkWindingNumberHyperTree::GetOutputScalarTypeAsString() const
{
  return winding::nameOfChoice(winding::Parameter::outputScalarType, this->OutputScalarType);
}

void vtkWindingNumberHyperTree::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GenerateWindingNumber: " << this->GenerateWindingNumber << "\n";
  os << indent << "GenerateInside: " << this->GenerateInside << "\n";
  os << indent << "ResultArrayName: " << winding::textOf(this->ResultArrayName) << "\n";
  os << indent << "OutputScalarType: " << this->OutputScalarType << "\n";
  os << indent << "Coverage: " << this->Coverage << "\n";
  os << indent << "CoverageSamples: " << this->CoverageSamples << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "MaskOutside: " << this->MaskOutside << "\n";
  os << indent << "NumberOfInsideSamples: " << this->NumberOfInsideSamples << "\n";
  os << indent << "NumberOfLeaves: " << this->NumberOfLeaves << "\n";
  os << indent << "NumberOfVertices: " << this->NumberOfVertices << "\n";
}
