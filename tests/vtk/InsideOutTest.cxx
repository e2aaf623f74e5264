// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"
#include "vtk/HowTo.h"
#include "vtk/SphereCloud.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkSphereSource.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberSurface.h"
#include "vtkWindingNumberVoxels.h"

#include <gtest/gtest.h>

#include <functional>
#include <regex>
#include <sstream>
#include <string>

/**
 * Filters whose result is empty or wrong because the faces of their source look inward say so, and
 * what to do first.
 */
namespace
{

using winding::Parameter;

const std::string rule = " look inward: use " +
                         howTo({Parameter::insideRule, vtkWindingNumberAlgorithm::ABSOLUTE}) +
                         ", or ";
const std::string turned = " (" + howTo({Parameter::orientFaces, 1}) + ")";
const std::string inwardHere = "; w is -0.5 or less at ";
const std::string advice = "faces" + rule + "turn the faces" + turned + inwardHere;

class InsideOut : public testing::Test
{
protected:
  InsideOut()
  {
    sphere->SetRadius(1);
    inward->SetInputConnection(sphere->GetOutputPort());
    inward->ReverseCellsOn();
  }

  void openTheSphere() { sphere->SetStartTheta(40); }

  /// Executes a filter that has the inward sphere as its source.
  static void expectAdvice(vtkWindingNumberAlgorithm* filter, bool isExpected)
  {
    ErrorLog log(filter);
    filter->Modified();
    filter->Update();
    EXPECT_EQ(filter->GetStatus(), vtkWindingNumberAlgorithm::DONE);
    EXPECT_EQ(filter->GetSourceIsInsideOut(), isExpected);
    EXPECT_EQ(log.warnings().find(advice) != std::string::npos, isExpected) << log.warnings();
    EXPECT_EQ(log.warnings().find("look inward") != std::string::npos, isExpected)
      << log.warnings();
    const bool isOtherwiseEmpty =
      log.warnings().find("no sample is inside") != std::string::npos ||
      log.warnings().find("no point is inside") != std::string::npos ||
      log.warnings().find("the grid misses the source") != std::string::npos;
    EXPECT_FALSE(isOtherwiseEmpty && isExpected) << log.warnings();
    EXPECT_EQ(log.warnings().empty(), !isExpected && !isOtherwiseEmpty) << log.warnings();
    filter->RemoveAllObservers();
  }

  /// Expects of a filter on grids what all of them have in common: advice where faces look inward.
  void expectAdviceOnGrids(vtkWindingNumberGridAlgorithm* filter)
  {
    filter->SetInputConnection(inward->GetOutputPort());
    filter->SetResolution(12);
    filter->MendSourceOff();
    expectAdvice(filter, true);
    filter->SetInsideRule(vtkWindingNumberAlgorithm::ABSOLUTE);
    expectAdvice(filter, false);
    filter->SetInsideRule(vtkWindingNumberAlgorithm::SIGNED);
    openTheSphere();
    expectAdvice(filter, true);
    filter->SetUseInputBounds(false);
    const double beside[6] = {1.5, 2.5, -1, 1, -1, 1};
    filter->SetSamplingBounds(beside);
    expectAdvice(filter, false);
    filter->SetInputConnection(sphere->GetOutputPort());
    expectAdvice(filter, false);
    filter->SetUseInputBounds(true);
    expectAdvice(filter, false);
  }

  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkReverseSense> inward;
};

TEST_F(InsideOut, SourcesOfSurfaces)
{
  vtkNew<vtkWindingNumberSurface> surface;
  expectAdviceOnGrids(surface);
  EXPECT_GT(surface->GetOutput()->GetNumberOfCells(), 0);
  surface->SetInputConnection(inward->GetOutputPort());
  surface->CloseBorderOn();
  expectAdvice(surface, true);
  EXPECT_EQ(surface->GetOutput()->GetNumberOfCells(), 0);
}

TEST_F(InsideOut, SourcesOfFieldsWithAnInside)
{
  for (const bool withValues : {true, false})
  {
    vtkNew<vtkWindingNumberField> field;
    field->GenerateInsideOn();
    field->SetGenerateWindingNumber(withValues);
    sphere->SetStartTheta(0);
    expectAdviceOnGrids(field);
    field->SetInputConnection(inward->GetOutputPort());
    field->SetCoverage(vtkWindingNumberField::FRACTION);
    expectAdvice(field, true);
  }
  vtkNew<vtkWindingNumberField> valuesOnly;
  valuesOnly->SetInputConnection(inward->GetOutputPort());
  expectAdvice(valuesOnly, true);
}

TEST_F(InsideOut, PartsAreToldWithTheirShare)
{
  vtkNew<vtkSphereSource> outward;
  outward->SetRadius(1);
  outward->SetCenter(5, 0, 0);
  vtkNew<vtkAppendPolyData> both;
  both->AddInputConnection(outward->GetOutputPort());
  both->AddInputConnection(inward->GetOutputPort());
  vtkNew<vtkWindingNumberSurface> surface;
  vtkNew<vtkWindingNumberField> field;
  for (auto* filter : {static_cast<vtkWindingNumberGridAlgorithm*>(surface),
         static_cast<vtkWindingNumberGridAlgorithm*>(field)})
  {
    filter->SetInputConnection(both->GetOutputPort());
    filter->MendSourceOff();
    for (const auto method : {vtkWindingNumberField::ROWS, vtkWindingNumberField::HIERARCHICAL})
    {
      filter->SetMethod(method);
      ErrorLog log(filter);
      filter->Update();
      // A ball of 8 by 8 triangles fills about 15 % of a box of 7.7 by 2.7 by 2.7.
      EXPECT_NE(log.warnings().find(advice), std::string::npos) << log.warnings();
      double negative = 0, positive = 0;
      std::smatch shares;
      ASSERT_TRUE(std::regex_search(log.warnings(), shares,
        std::regex(
          R"(w is -0\.5 or less at (\S+) % of the samples, and 0\.5 or more at (\S+) %)")));
      std::istringstream(shares.str(1)) >> negative; // in any locale
      std::istringstream(shares.str(2)) >> positive;
      EXPECT_NEAR(negative, positive, 1);
      EXPECT_GT(negative, 2);
      EXPECT_LT(negative, 12);
      filter->RemoveAllObservers();
    }
  }
}

TEST_F(InsideOut, SourcesOfPiecesAreNotJudged)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(inward->GetOutputPort());
  field->SetResolution(12);
  field->GenerateInsideOn();
  ErrorLog log(field);
  field->UpdatePiece(1, 3, 0);
  EXPECT_FALSE(field->GetSourceIsInsideOut());
  EXPECT_EQ(log.warnings(), "");
}

TEST_F(InsideOut, AllPiecesTogetherAreJudgedAsTheWhole)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetResolution(12);
  field->SetOutputAssociation(vtkWindingNumberField::CELLS);
  const auto warningsOf = [&](vtkAlgorithm* source, int pieces)
  {
    field->SetInputConnection(source->GetOutputPort());
    field->Modified();
    ErrorLog log(field);
    vtkIdType sums[4] = {};
    for (int piece = 0; piece < pieces; ++piece)
    {
      field->UpdatePiece(piece, pieces, 0);
      for (int i = 0; i < 4; ++i)
      {
        sums[i] += field->GetSampleCounts()[i];
      }
    }
    EXPECT_EQ(sums[0], 12 * 12 * 12) << pieces;
    if (pieces > 1)
    {
      EXPECT_EQ(log.warnings(), "");
      field->WarnOfPieces(sums);
    }
    EXPECT_EQ(field->GetStatus(), vtkWindingNumberAlgorithm::DONE);
    field->RemoveAllObservers();
    return log.warnings().substr(log.warnings().find("): ") + 3);
  };
  const std::string whole = warningsOf(inward, 1);
  EXPECT_NE(whole.find("look inward"), std::string::npos) << whole;
  EXPECT_EQ(warningsOf(inward, 3), whole);
  EXPECT_TRUE(field->GetSourceIsInsideOut());
  EXPECT_EQ(warningsOf(inward, 8), whole);
  field->SetWindingThreshold(5);
  const std::string nothing = warningsOf(sphere, 1);
  EXPECT_NE(nothing.find("no sample is inside: choose a lower threshold"), std::string::npos)
    << nothing;
  EXPECT_EQ(warningsOf(sphere, 4), nothing);
}

TEST_F(InsideOut, SourcesOfParts)
{
  vtkNew<vtkSphereSource> part;
  part->SetRadius(0.5);
  for (const bool withValues : {true, false})
  {
    sphere->SetStartTheta(0);
    vtkNew<vtkWindingNumberProbe> probe;
    probe->SetInputConnection(part->GetOutputPort());
    probe->SetSourceConnection(inward->GetOutputPort());
    probe->SetGenerateWindingNumber(withValues);
    probe->ExtractInsideOn();
    expectAdvice(probe, true);
    EXPECT_EQ(probe->GetOutput()->GetNumberOfCells(), 0);
    openTheSphere();
    expectAdvice(probe, true);
    probe->InsideOutOn();
    expectAdvice(probe, true);
    probe->InsideOutOff();
    part->SetCenter(3, 0, 0);
    expectAdvice(probe, false);
    part->SetCenter(0, 0, 0);
    probe->SetInsideRule(vtkWindingNumberAlgorithm::ABSOLUTE);
    expectAdvice(probe, false);
    EXPECT_GT(probe->GetOutput()->GetNumberOfCells(), 0);
  }
}

TEST_F(InsideOut, SourcesOfVoxels)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(inward->GetOutputPort());
  field->SetResolution(12);
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputConnection(field->GetOutputPort());
  const auto warnings = [&]
  {
    ErrorLog log(voxels);
    voxels->Update();
    voxels->RemoveAllObservers();
    return log.warnings();
  };
  const std::string adviceOnImage =
    "faces or normals" + rule + "turn the faces or normals" + turned + inwardHere;
  EXPECT_NE(warnings().find(adviceOnImage), std::string::npos);
  EXPECT_EQ(voxels->GetOutput()->GetNumberOfCells(), 0);
  openTheSphere();
  EXPECT_NE(warnings().find(adviceOnImage), std::string::npos);
  voxels->SetInsideRule(vtkWindingNumberAlgorithm::ABSOLUTE);
  EXPECT_EQ(warnings(), "");
  EXPECT_GT(voxels->GetOutput()->GetNumberOfCells(), 0);
  voxels->SetInsideRule(vtkWindingNumberAlgorithm::SIGNED);
  voxels->SetWindingThreshold(1.5);
  EXPECT_EQ(warnings(), "") << "w is above −1.5";
}

TEST_F(InsideOut, SourcesOfPointsHaveNormals)
{
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputData(sphereCloud(500, -1));
  surface->MendSourceOff();
  surface->SetRegularization(1);
  surface->SetResolution(12);
  ErrorLog log(surface);
  surface->Update();
  EXPECT_TRUE(surface->GetSourceIsInsideOut());
  EXPECT_NE(
    log.warnings().find("normals" + rule + "turn the normals" + inwardHere), std::string::npos)
    << log.warnings();
}

} // namespace
