// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImplicitWindingNumber.h"
#include "vtkNew.h"
#include "vtkWindingNumberBoolean.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberLabels.h"
#include "vtkWindingNumberNormals.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberReader.h"
#include "vtkWindingNumberReport.h"
#include "vtkWindingNumberSurface.h"
#include "vtkWindingNumberVoxels.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace
{

/// An object is expected to print these words as it is made, such as "Resolution: 128".
template <class Class> void expectPrinted(const std::vector<std::string>& words)
{
  vtkNew<Class> object;
  std::ostringstream text;
  object->Print(text);
  for (const std::string& word : words)
  {
    EXPECT_NE(text.str().find(word), std::string::npos) << word << "\n" << text.str();
  }
}

} // namespace

TEST(Print, HasThePropertiesOfEveryClass)
{
  const std::vector<std::string> ofSources = {"Method: 0", "Tolerance: 0.001", "PointAreaMethod: 0",
    "NormalEstimation: 0", "NumberOfNeighbors: 20", "WindingThreshold: 0.5", "InsideRule: 0"};
  const std::vector<std::string> ofArrays = {"GenerateWindingNumber: 1", "GenerateInside: 0",
    "ResultArrayName: WindingNumber", "OutputScalarType: 10"};
  expectPrinted<vtkWindingNumberField>(ofSources);
  expectPrinted<vtkWindingNumberField>(ofArrays);
  expectPrinted<vtkWindingNumberField>(
    {"Resolution: 128", "VoxelSize: 0", "Padding: 0.05", "UseInputBounds: 1",
      "BoundsOverAllTimes: 0", "SamplingDimensions: 0 0 0", "Coverage: 0", "UnionOverAllTimes: 0",
      "CoverageSamples: 4", "OutputAssociation: 0", "DistanceBand: 0", "NumberOfThreads: 0"});
  expectPrinted<vtkWindingNumberSurface>(ofSources);
  expectPrinted<vtkWindingNumberSurface>(
    {"Resolution: 0", "CloseBorder: 0", "GenerateNormals:", "Features: 0", "GenerateTriangles: 0",
      "FidelitySamples: 0", "GenerateDistanceToInput: 0", "FidelityInWords: "});
  expectPrinted<vtkWindingNumberBoolean>(ofSources);
  expectPrinted<vtkWindingNumberBoolean>({"Operation: 0", "Features: 0", "CloseBorder: 0"});
  expectPrinted<vtkWindingNumberLabels>(ofSources);
  expectPrinted<vtkWindingNumberLabels>({"Resolution: 128", "Coverage: 0", "OutputAssociation: 0",
    "OverlapRule: 0", "GenerateSolidCount: 0", "CoverageArrays: 0",
    "RegionArray: ", "LabelOffset: 0", "NumberOfSolids: 0"});
  expectPrinted<vtkWindingNumberProbe>(ofSources);
  expectPrinted<vtkWindingNumberProbe>(ofArrays);
  expectPrinted<vtkWindingNumberProbe>(
    {"ProbeAssociation: 0", "InsideOut: 0", "ExtractInside: 0", "InsideArrayName: Inside"});
  expectPrinted<vtkImplicitWindingNumber>(ofSources);
  expectPrinted<vtkWindingNumberVoxels>({"WindingThreshold: 0.5", "InsideRule: 0", "ByLabel: 2"});
  expectPrinted<vtkWindingNumberNormals>({"PointAreaMethod: 0", "NumberOfNeighbors: 20",
    "PointArea: 0", "EstimateNormals: 0", "NormalEstimation: 0", "ResultArrayName: Area",
    "Status: 4", "TotalArea: 0", "NormalEstimationUsed: ", "ClearShare: 0"});
  expectPrinted<vtkWindingNumberReport>({"FixOrientation: 0", "Advice: ", "FractionalShare: 0"});
  expectPrinted<vtkWindingNumberReader>(
    {"FileName: (none)", "ReadNormalsAndAreas: 1", "ReadAllColumns: 1", "KeepRows: 0"});
}
