// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"
#include "vtk/HowTo.h"
#include "vtk/LabelScenes.h"
#include "vtk/ProgressLog.h"

#include "vtkAppendPolyData.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkCubeSource.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkReverseSense.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindingNumberField.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

namespace
{

using Filter = vtkWindingNumberLabels;

/// Labels of five spheres, with the fields of each of them on the same grid.
class Labels : public testing::Test
{
protected:
  Labels()
  {
    labels->SetInputData(asAssembly(solids));
    labels->SetResolution(30);
  }

  std::vector<unsigned short> made(const char* name = "Label")
  {
    const ErrorLog log(labels);
    labels->Update();
    EXPECT_EQ(log.errors(), "");
    return shortsOf(labels->GetOutput()->GetPointData(), name);
  }

  /// The fields of all solids on the grid of the labels, with everything that they have.
  std::vector<vtkSmartPointer<vtkPointData>> fields() const
  {
    double bounds[6];
    int voxels[3];
    double first[3], spacing[3];
    labels->GetGrid(voxels, first, spacing);
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds[2 * axis] = first[axis] - spacing[axis] / 2;
      bounds[2 * axis + 1] = bounds[2 * axis] + voxels[axis] * spacing[axis];
    }
    std::vector<vtkSmartPointer<vtkPointData>> result;
    for (const auto& solid : solids)
    {
      vtkNew<vtkWindingNumberField> field;
      field->SetInputData(solid);
      field->SetSamplingDimensions(voxels);
      field->SetUseInputBounds(false);
      field->SetSamplingBounds(bounds);
      field->GenerateInsideOn();
      field->SetCoverage(labels->GetCoverage());
      field->SetInsideRule(labels->GetInsideRule());
      field->SetWindingThreshold(labels->GetWindingThreshold());
      field->Update();
      result.emplace_back(field->GetOutput()->GetPointData());
    }
    return result;
  }

  /// The label that a rule gives a voxel, found the long way round.
  static unsigned short expected(
    const std::vector<vtkSmartPointer<vtkPointData>>& fields, vtkIdType i, int rule)
  {
    const double volumes[] = {1, 0.512, 0.343, 0.064, 0.091125};
    unsigned short label = 0;
    for (unsigned short n = 1; n <= fields.size(); ++n)
    {
      const auto value = [&](unsigned short of, const char* name)
      {
        return fields[of - 1u]->GetArray(name)->GetTuple1(i);
      };
      if (value(n, "Inside") == 0)
      {
        continue;
      }
      const bool wins = label == 0 || rule == Filter::LAST ||
                        (rule == Filter::LARGEST_WINDING_NUMBER &&
                          value(n, "WindingNumber") > value(label, "WindingNumber")) ||
                        (rule == Filter::SMALLEST_VOLUME && volumes[n - 1] < volumes[label - 1]);
      label = wins ? n : label;
    }
    return label;
  }

  std::vector<vtkSmartPointer<vtkPolyData>> solids = fiveBalls();
  vtkNew<Filter> labels;
};

TEST_F(Labels, DefaultsAreTheDocumentedOnes)
{
  EXPECT_EQ(labels->GetOverlapRule(), Filter::FIRST);
  EXPECT_EQ(labels->GetCoverageArrays(), Filter::TWO_LARGEST);
  EXPECT_EQ(labels->GetGenerateSolidCount(), 0);
  EXPECT_EQ(labels->GetRegionArray(), nullptr);
  EXPECT_EQ(labels->GetLabelOffset(), 0);
}

/// The labels are those that the fields of single solids give, to the bit, by every rule and
/// coverage.
TEST_F(Labels, AreThoseOfSingleFieldsCombined)
{
  labels->GenerateSolidCountOn();
  for (const int coverage : {Filter::CENTER, Filter::ANY, Filter::FRACTION})
  {
    labels->SetCoverage(coverage);
    made();
    const auto single = this->fields();
    for (const int rule :
      {Filter::FIRST, Filter::LAST, Filter::LARGEST_WINDING_NUMBER, Filter::SMALLEST_VOLUME})
    {
      labels->SetOverlapRule(rule);
      const auto label = made(), count = made("SolidCount");
      ASSERT_EQ(label.size(), static_cast<std::size_t>(single[0]->GetNumberOfTuples()));
      std::vector<int> found(solids.size() + 1);
      for (std::size_t i = 0; i < label.size(); ++i)
      {
        const auto at = static_cast<vtkIdType>(i);
        ASSERT_EQ(label[i], expected(single, at, rule)) << i << " rule " << rule;
        double in = 0;
        for (const auto& field : single)
        {
          in += field->GetArray("Inside")->GetTuple1(at);
        }
        ASSERT_EQ(count[i], in);
        ++found[label[i]];
      }
      // The fourth lies in the first, which hides it unless a later or a smaller one wins.
      EXPECT_EQ(found[4] > 0, rule == Filter::LAST || rule == Filter::SMALLEST_VOLUME) << rule;
    }
  }
}

TEST_F(Labels, FollowRuleAndThreshold)
{
  for (const int rule : {Filter::SIGNED, Filter::ABSOLUTE, Filter::ODD})
  {
    for (const double threshold : {0.5, 0.1, -0.5})
    {
      labels->SetInsideRule(rule);
      labels->SetWindingThreshold(threshold);
      const auto label = made();
      const auto single = this->fields();
      for (std::size_t i = 0; i < label.size(); ++i)
      {
        ASSERT_EQ(label[i], expected(single, static_cast<vtkIdType>(i), Filter::FIRST))
          << rule << " " << threshold;
      }
    }
  }
}

/// A solid that is there twice and looks inward, w = −2, has the larger winding number by the
/// absolute rule alone.
TEST_F(Labels, LargestWindingNumbersAreThoseThatTheRuleCompares)
{
  vtkNew<vtkReverseSense> inward;
  inward->SetInputData(ball(0.5, 0, 0, 1));
  vtkNew<vtkAppendPolyData> twice;
  twice->AddInputConnection(inward->GetOutputPort());
  twice->AddInputConnection(inward->GetOutputPort());
  twice->Update();
  solids = {ball(0, 0, 0, 1), twice->GetOutput()};
  labels->SetInputData(asAssembly(solids));
  labels->SetOverlapRule(Filter::LARGEST_WINDING_NUMBER);
  labels->MendSourceOff();
  for (const int rule : {Filter::SIGNED, Filter::ABSOLUTE})
  {
    labels->SetInsideRule(rule);
    const auto label = made();
    const auto single = this->fields();
    std::size_t both = 0;
    for (std::size_t i = 0; i < label.size(); ++i)
    {
      const auto at = static_cast<vtkIdType>(i);
      const bool isInFirst = single[0]->GetArray("Inside")->GetTuple1(at) != 0;
      const bool isInSecond = single[1]->GetArray("Inside")->GetTuple1(at) != 0;
      both += isInFirst && isInSecond;
      ASSERT_EQ(label[i], isInSecond ? 2 : isInFirst ? 1 : 0) << i << " rule " << rule;
    }
    EXPECT_EQ(both > 1000, rule == Filter::ABSOLUTE) << both;
  }
}

TEST_F(Labels, SharesAreThoseOfSingleFields)
{
  labels->SetCoverage(Filter::FRACTION);
  const auto first = made("FirstLabel"), second = made("SecondLabel");
  vtkNew<vtkPointData> two;
  two->DeepCopy(labels->GetOutput()->GetPointData());
  labels->SetCoverageArrays(Filter::EACH_LABEL);
  made();
  vtkPointData* each = labels->GetOutput()->GetPointData();
  EXPECT_EQ(each->GetNumberOfArrays(), 6);
  const auto single = this->fields();
  std::size_t shared = 0;
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    const auto at = static_cast<vtkIdType>(i);
    std::vector<std::pair<double, int>> shares;
    for (std::size_t n = 0; n < single.size(); ++n)
    {
      const double share = single[n]->GetArray("Coverage")->GetTuple1(at);
      const std::string name = "Coverage " + std::to_string(n + 1);
      ASSERT_EQ(each->GetArray(name.c_str())->GetTuple1(at), share);
      shares.emplace_back(-share, static_cast<int>(n) + 1);
    }
    std::sort(shares.begin(), shares.end());
    ASSERT_EQ(two->GetArray("FirstShare")->GetTuple1(at), -shares[0].first);
    ASSERT_EQ(two->GetArray("SecondShare")->GetTuple1(at), -shares[1].first);
    ASSERT_EQ(first[i], shares[0].first < 0 ? shares[0].second : 0);
    ASSERT_EQ(second[i], shares[1].first < 0 ? shares[1].second : 0);
    shared += second[i] != 0;
  }
  EXPECT_GT(shared, 100u);
}

TEST_F(Labels, AreTheSameForPointsCellsPiecesAndThreads)
{
  labels->GenerateSolidCountOn();
  for (const int rule : {Filter::FIRST, Filter::LARGEST_WINDING_NUMBER, Filter::SMALLEST_VOLUME})
  {
    for (const int coverage : {Filter::CENTER, Filter::ANY, Filter::FRACTION})
    {
      labels->SetOverlapRule(rule);
      labels->SetCoverage(coverage);
      labels->SetOutputAssociationToPoints();
      labels->SetNumberOfThreads(0);
      const auto whole = made();
      vtkNew<vtkImageData> image;
      image->DeepCopy(labels->GetOutput());
      labels->SetNumberOfThreads(1);
      EXPECT_EQ(made(), whole);
      labels->SetOutputAssociationToCells();
      labels->Update();
      EXPECT_EQ(shortsOf(labels->GetOutput()->GetCellData()), whole);
      labels->SetOutputAssociationToPoints();
      for (int piece = 0; piece < 5; ++piece)
      {
        labels->Modified();
        labels->UpdatePiece(piece, 5, 0);
        vtkImageData* part = labels->GetOutput();
        ASSERT_GT(part->GetNumberOfPoints(), 0);
        for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
        {
          const vtkIdType same = image->FindPoint(part->GetPoint(i));
          for (int array = 0; array < image->GetPointData()->GetNumberOfArrays(); ++array)
          {
            ASSERT_EQ(part->GetPointData()->GetArray(array)->GetTuple1(i),
              image->GetPointData()->GetArray(array)->GetTuple1(same));
          }
        }
      }
    }
  }
}

/// Two solids of the same size in another order of their triangles: volumes are equal to the bit,
/// so the first wins.
TEST_F(Labels, VolumesDoNotDependOnTheOrderOfTriangles)
{
  vtkNew<vtkPolyData> reversed;
  reversed->SetPoints(solids[0]->GetPoints());
  vtkNew<vtkCellArray> cells;
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType i = solids[0]->GetNumberOfPolys(); i-- > 0;)
  {
    solids[0]->GetPolys()->GetCellAtId(i, size, ids);
    cells->InsertNextCell({ids[1], ids[2], ids[0]});
  }
  reversed->SetPolys(cells);
  labels->SetOverlapRule(Filter::SMALLEST_VOLUME);
  for (const bool isReversedFirst : {false, true})
  {
    labels->SetInputData(isReversedFirst ? asAssembly({reversed.Get(), solids[0]})
                                         : asAssembly({solids[0], reversed.Get()}));
    const auto label = made();
    EXPECT_GT(std::count(label.begin(), label.end(), 1), 0);
    EXPECT_EQ(std::count(label.begin(), label.end(), 2), 0);
  }
}

TEST_F(Labels, TellsFactsAboutAllSolids)
{
  ErrorLog log(labels);
  labels->Update();
  vtkIdType triangles = 0;
  for (const auto& solid : solids)
  {
    triangles += solid->GetNumberOfPolys();
  }
  EXPECT_EQ(labels->GetNumberOfPrimitives(), triangles);
  EXPECT_EQ(labels->GetNumberOfSolids(), 5);
  EXPECT_EQ(labels->GetNumberOfOpenSolids(), 1);
  EXPECT_EQ(labels->GetNumberOfEmptySolids(), 0);
  EXPECT_STREQ(labels->GetMethodUsed(), "rows");
  EXPECT_NE(log.warnings().find("close them where labels are not right; 1 of 5 solids ('solid 2')"),
    std::string::npos)
    << log.warnings();
  vtkFieldData* table = labels->GetOutput()->GetFieldData();
  ASSERT_TRUE(table->GetAbstractArray("LabelNames"));
  EXPECT_EQ(table->GetAbstractArray("LabelNames")->GetVariantValue(4).ToString(), "solid 4");
  EXPECT_EQ(table->GetArray("LabelValues")->GetTuple1(4), 5);
  const auto label = made();
  const double* h = labels->GetOutput()->GetSpacing();
  for (int number = 1; number <= 5; ++number)
  {
    const auto voxels = static_cast<double>(std::count(label.begin(), label.end(), number));
    EXPECT_NEAR(
      table->GetArray("LabelVolumes")->GetTuple1(number - 1), voxels * h[0] * h[1] * h[2], 1e-12);
  }
  const std::string volumes = labels->GetVolumesInWords();
  EXPECT_EQ(std::count(volumes.begin(), volumes.end(), '\n'), 4);
  EXPECT_NE(volumes.find("\nsolid 4: "), std::string::npos) << volumes;
  EXPECT_TRUE(table->GetAbstractArray("WindingNumberMethod"));
  EXPECT_GT(labels->GetExpectedSeconds(), 0);
  EXPECT_GT(labels->GetPrepareSeconds(), 0);
}

TEST_F(Labels, ProgressRisesToTheEndAndAbortEmptiesTheOutput)
{
  labels->SetResolution(60);
  {
    const ProgressLog log(labels);
    labels->Update();
    EXPECT_TRUE(log.isRising());
    EXPECT_EQ(log.last(), 1);
    EXPECT_GT(log.events(), 10);
  }
  labels->Modified();
  const ProgressLog log(labels, 0.5);
  labels->Update();
  EXPECT_GT(log.abortedAt(), 0);
  EXPECT_EQ(labels->GetStatus(), Filter::ABORTED);
  EXPECT_EQ(labels->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(Labels, RefuseWhatTheyCannotDoInOneLine)
{
  const auto expectRefused = [&](const std::string& words)
  {
    const ErrorLog log(labels);
    labels->Update();
    EXPECT_EQ(labels->GetStatus(), Filter::REFUSED);
    EXPECT_NE(log.errors().find(words), std::string::npos) << log.errors();
    EXPECT_EQ(labels->GetOutput()->GetNumberOfPoints(), 0);
  };
  labels->SetOverlapRule(4);
  expectRefused("OverlapRule is 4");
  labels->SetOverlapRule(Filter::FIRST);
  labels->SetCoverageArrays(-1);
  expectRefused("CoverageArrays is -1");
  labels->SetCoverageArrays(Filter::TWO_LARGEST);
  labels->SetLabelOffset(70000);
  expectRefused("LabelOffset is 70000");
  labels->SetLabelOffset(0);
  labels->SetVerifySamples(10);
  labels->SetMethod(Filter::PARITY);
  expectRefused("parity is no winding number");
  labels->SetMethod(Filter::AUTOMATIC);
  labels->SetVerifySamples(0);
  // Refusals of single solids have their names.
  vtkNew<vtkPoints> nowhere;
  nowhere->SetNumberOfPoints(solids[2]->GetNumberOfPoints());
  nowhere->GetData()->Fill(std::numeric_limits<double>::quiet_NaN());
  solids[2]->SetPoints(nowhere);
  labels->SetUseInputBounds(false);
  expectRefused("; solid 'solid 2'");
}

TEST_F(Labels, ErrorsOfAllSolidsCountInAnyOrder)
{
  // Errors of the fields of spheres of other sizes differ.
  labels->SetVerifySamples(200);
  labels->SetMethod(Filter::HIERARCHICAL);
  labels->SetTolerance(0.01);
  struct Errors
  {
    double max, rms, near;
  };
  const auto errorsOf = [this](const std::vector<vtkSmartPointer<vtkPolyData>>& parts)
  {
    labels->SetInputData(asAssembly(parts));
    this->made();
    return Errors{labels->GetMaxError(), labels->GetRMSError(), labels->GetNearMaxError()};
  };
  labels->SetUseInputBounds(false);
  labels->SetSamplingBounds(-1.5, 1.7, -1.6, 1.5, -1.4, 1.5);
  Errors expected = {};
  for (const auto& solid : solids)
  {
    const Errors own = errorsOf({solid});
    expected.max = std::max(expected.max, own.max);
    expected.near = std::max(expected.near, own.near);
    expected.rms += own.rms * own.rms / static_cast<double>(solids.size());
  }
  expected.rms = std::sqrt(expected.rms);
  EXPECT_GT(expected.rms, 1e-6);
  std::vector<vtkSmartPointer<vtkPolyData>> parts = solids;
  for (std::size_t first = 0; first < parts.size(); ++first)
  {
    const Errors found = errorsOf(parts);
    EXPECT_EQ(found.max, expected.max);
    EXPECT_EQ(found.near, expected.near);
    EXPECT_NEAR(found.rms, expected.rms, 1e-3 * expected.rms); // samples on the surface are apart
    std::rotate(parts.begin(), parts.begin() + 1, parts.end());
  }
}

TEST_F(Labels, ValuesOfAllSolidsAreVerified)
{
  labels->SetVerifySamples(50);
  for (int round = 0; round < 2; ++round)
  {
    labels->Modified();
    const auto verified = made();
    EXPECT_EQ(labels->GetNumberOfVerifiedSamples() + labels->GetNumberOfNearVerifiedSamples() +
                labels->GetNumberOfSamplesOnSurface(),
      2 * 5 * 50);
    EXPECT_LT(labels->GetMaxError(), 1e-3);
    EXPECT_LE(labels->GetRMSError(), labels->GetMaxError());
    labels->SetVerifySamples(0);
    EXPECT_EQ(made(), verified);
    EXPECT_EQ(labels->GetNumberOfVerifiedSamples(), 0);
    labels->SetVerifySamples(50);
  }
}

/// Samples on faces are apart for each solid, and are as many for the same solid twice.
TEST_F(Labels, SamplesOnAllSurfacesAreCounted)
{
  vtkNew<vtkCubeSource> cube;
  cube->Update();
  const vtkSmartPointer<vtkPolyData> one = cube->GetOutput();
  labels->SetUseInputBounds(false);
  labels->SetSamplingBounds(-0.75, 0.75, -0.75, 0.75, -0.75, 0.75);
  labels->SetResolution(3); // samples at -0.5, 0 and 0.5
  labels->SetVerifySamples(40);
  vtkIdType found[3] = {};
  for (const std::size_t count : {1, 2})
  {
    labels->SetInputData(asAssembly(std::vector<vtkSmartPointer<vtkPolyData>>(count, one)));
    made();
    found[count] = labels->GetNumberOfSamplesOnSurface();
    EXPECT_EQ(labels->GetNumberOfVerifiedSamples() + labels->GetNumberOfNearVerifiedSamples() +
                found[count],
      static_cast<vtkIdType>(2 * 40 * count));
  }
  EXPECT_GT(found[1], 40);
  EXPECT_EQ(found[2], 2 * found[1]);
}

TEST_F(Labels, LongWorkIsRefusedByTheSumOfAllSolids)
{
  labels->SetMethod(Filter::DIRECT);
  labels->SetResolution(12);
  vtkNew<vtkCallbackCommand> wait;
  wait->SetCallback([](vtkObject*, unsigned long, void*, void*)
    { std::this_thread::sleep_for(std::chrono::milliseconds(20)); });
  labels->AddObserver(vtkCommand::ProgressEvent, wait);
  labels->SetLongestExpectedTime(0.07); // each of five solids takes 20 ms or more
  const ErrorLog log(labels);
  labels->Update();
  EXPECT_EQ(labels->GetStatus(), Filter::REFUSED);
  EXPECT_NE(log.errors().find(howTo(winding::Parameter::longestExpectedTime)), std::string::npos)
    << log.errors();
}

TEST_F(Labels, SolidsThatLookInwardAreCounted)
{
  solids[4]->GetPolys();
  vtkNew<vtkCellArray> cells;
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType i = 0; i < solids[4]->GetNumberOfPolys(); ++i)
  {
    solids[4]->GetPolys()->GetCellAtId(i, size, ids);
    cells->InsertNextCell({ids[0], ids[2], ids[1]});
  }
  solids[4]->SetPolys(cells);
  labels->MendSourceOff();
  ErrorLog log(labels);
  labels->Update();
  EXPECT_EQ(labels->GetNumberOfInsideOutSolids(), 1);
  EXPECT_TRUE(labels->GetSourceIsInsideOut());
  EXPECT_NE(log.warnings().find("; 1 of 5 solids ('solid 4')"), std::string::npos)
    << log.warnings();
}

} // namespace
