// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/FilterSettings.h"

#include "input/Leaves.h"
#include "options/Options.h"
#include "program/Failure.h"
#include "program/Interrupt.h"
#include "program/Messages.h"

#include "vtkPolyData.h"
#include "vtkWindingNumberBoolean.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberLabels.h"

namespace
{

/// Returns whether an operand is a cloud, which options for points are for.
bool hasCloud(vtkWindingNumberAlgorithm& filter)
{
  bool found = false;
  if (vtkWindingNumberBoolean::SafeDownCast(&filter))
  {
    forEachLeaf(filter.GetInputDataObject(0, 0),
      [&found](vtkDataObject* leaf)
      {
        auto* points = vtkPolyData::SafeDownCast(leaf);
        found |= points && points->GetNumberOfPoints() > 0 &&
                 points->GetNumberOfPolys() + points->GetNumberOfStrips() == 0;
      });
  }
  return found;
}

} // namespace

void applyMethod(const Options& options, vtkWindingNumberAlgorithm* filter)
{
  filter->SetNamesInMessages(vtkWindingNumberAlgorithm::PROGRAM_NAMES);
  filter->SetMethod(options.method);
  filter->SetTolerance(options.tolerance);
  filter->SetSourceAsPoints(options.asPoints);
  filter->SetUseSurfaceCells(options.surfaceCells);
  filter->SetOrientFaces(options.orientFaces);
  filter->SetIgnoreOpenParts(options.ignoreOpenParts);
  filter->SetMirror(options.mirror.c_str());
  filter->SetFlatBase(options.flatBase.c_str());
  filter->SetSheetSide(options.sheetSide.c_str());
  filter->SetWeldTolerance(options.weldTolerance);
  filter->SetEstimateNormals(options.estimateNormals);
  filter->SetNormalEstimation(options.normalEstimation);
  filter->SetToward(options.toward.c_str());
  filter->SetPointAreaMethod(options.areas);
  filter->SetNumberOfNeighbors(options.neighbors);
  filter->SetRegularization(options.regularization);
  filter->SetPointArea(options.area);
  filter->SetWindingThreshold(options.threshold);
  filter->SetInsideRule(options.rule);
  filter->SetNumberOfThreads(options.threads);
  filter->SetLongestExpectedTime(options.longestExpectedTime);
}

void applyGrid(const Options& options, vtkWindingNumberGridAlgorithm* filter)
{
  if (options.resolution)
  {
    filter->SetResolution(*options.resolution);
  }
  filter->SetVoxelSize(options.voxelSize);
  if (!options.dimensions.empty())
  {
    filter->SetSamplingDimensions(options.dimensions.data());
  }
  if (!options.bounds.empty())
  {
    filter->SetUseInputBounds(0);
    filter->SetSamplingBounds(options.bounds.data());
  }
  filter->SetPadding(options.padding);
  filter->SetVerifySamples(options.verify);
  if (options.asIs)
  {
    filter->MendSourceOff();
  }
}

void applyImage(const Options& options, vtkWindingNumberImageAlgorithm* filter)
{
  filter->SetOutputAssociation(
    options.cells ? vtkWindingNumberField::CELLS : vtkWindingNumberField::POINTS);
  filter->SetCoverage(options.coverage);
  filter->SetCoverageSamples(options.coverageSamples);
}

void applyField(const Options& options, vtkWindingNumberField* filter)
{
  applyImage(options, filter);
  filter->SetGenerateInside(options.inside || options.insideOnly);
  filter->SetGenerateWindingNumber(!options.insideOnly);
  filter->SetResultArrayName(options.array.c_str());
  filter->SetOutputScalarType(options.asDouble ? VTK_DOUBLE : VTK_FLOAT);
  filter->SetGenerateSignedDistance(options.distance);
  filter->SetDistanceBand(options.distanceBand);
  filter->SetGenerateNearestCells(options.nearestCells);
}

void applyLabels(const Options& options, vtkWindingNumberLabels* filter)
{
  applyImage(options, filter);
  filter->SetOverlapRule(options.overlap);
  filter->SetGenerateSolidCount(options.count);
  filter->SetCoverageArrays(options.shares);
  filter->SetRegionArray(options.regionArray.empty() ? nullptr : options.regionArray.c_str());
  filter->SetLabelOffset(options.labelOffset);
}

void warnOfIdleOptions(
  const Options& options, vtkWindingNumberAlgorithm& filter, Messages& messages)
{
  if (options.asPoints || filter.GetSourceKind() != vtkWindingNumberField::MESH_SOURCE ||
      hasCloud(filter))
  {
    return;
  }
  const std::pair<const char*, bool> forPoints[] = {{"--estimate-normals", options.estimateNormals},
    {"--normal-estimation", options.normalEstimation != Options().normalEstimation},
    {"--toward", !options.toward.empty()}, {"--regularization", options.regularization > 0},
    {"--areas", options.areas != vtkWindingNumberField::VORONOI},
    {"--neighbors", options.neighbors != Options().neighbors}};
  for (const auto& [option, isGiven] : forPoints)
  {
    if (isGiven)
    {
      messages.warn(options.input + ": " + option +
                    " is for points and the input is a surface; --points takes its vertices");
    }
  }
}

void checkFilter(int status, const std::string& fileName, Messages& messages)
{
  interrupt::check();
  checkStatus(status, fileName, messages);
}

void checkStatus(int status, const std::string& fileName, Messages& messages)
{
  try
  {
    messages.throwIfError(fileName);
  }
  catch (const Failure& failure)
  {
    throw Failure(
      status == vtkWindingNumberAlgorithm::OUT_OF_MEMORY ? EXIT_NO_MEMORY : EXIT_REFUSED,
      failure.what());
  }
  if (status == vtkWindingNumberAlgorithm::ABORTED)
  {
    throw Failure(EXIT_INTERRUPTED, "interrupted"); // on another rank
  }
  if (status != vtkWindingNumberAlgorithm::DONE && status != vtkWindingNumberAlgorithm::NOT_RUN)
  {
    throw Failure(EXIT_REFUSED, fileName, "the winding field could not be made");
  }
}
