// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/DistinctWarnings.h"
#include "vtk/ErrorLog.h"
#include "vtk/MovingSphere.h"
#include "vtk/OneByOne.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiBlockDataSetAlgorithm.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberLabels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

namespace
{

std::size_t countOf(const std::string& word, const std::string& text)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
  {
    ++count;
  }
  return count;
}

/// The results of all times of a source together.
class TimeUnion : public testing::Test
{
protected:
  vtkNew<MovingSphere> sphere;
};

/// The volume that the sphere sweeps: every array is that of the times together, whatever the rule.
TEST_F(TimeUnion, IsTheSweptVolume)
{
  for (const int rule :
    {vtkWindingNumberField::SIGNED, vtkWindingNumberField::ABSOLUTE, vtkWindingNumberField::ODD})
  {
    vtkNew<vtkWindingNumberField> swept, single;
    for (vtkWindingNumberField* field : {swept.Get(), single.Get()})
    {
      field->SetInputConnection(sphere->GetOutputPort());
      field->SetInsideRule(rule);
      field->GenerateInsideOn();
      field->GenerateSignedDistanceOn();
      field->SetCoverageToFraction();
      field->SetResolution(60);
      field->BoundsOverAllTimesOn();
    }
    swept->BoundsOverAllTimesOff(); // they are taken anyway
    swept->UnionOverAllTimesOn();
    swept->Update();
    vtkInformation* const info = swept->GetOutputInformation(0);
    EXPECT_FALSE(info->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()));
    EXPECT_FALSE(info->Has(vtkStreamingDemandDrivenPipeline::TIME_RANGE()));
    const std::vector<std::string> names = {
      "WindingNumber", "Inside", "Coverage", "SignedDistance"};
    std::map<std::string, std::vector<double>> expected;
    for (const int time : {0, 1, 2})
    {
      single->UpdateTimeStep(time);
      for (const std::string& name : names)
      {
        vtkDataArray* values = single->GetOutput()->GetPointData()->GetArray(name.c_str());
        std::vector<double>& all = expected[name];
        all.resize(static_cast<std::size_t>(values->GetNumberOfTuples()),
          name == "SignedDistance" ? 1e300 : 0);
        for (std::size_t n = 0; n < all.size(); ++n)
        {
          const double value = values->GetComponent(static_cast<vtkIdType>(n), 0);
          all[n] = name == "SignedDistance" ? std::min(all[n], value) : std::max(all[n], value);
        }
      }
    }
    ASSERT_EQ(swept->GetOutput()->GetBounds()[1], single->GetOutput()->GetBounds()[1]);
    for (const std::string& name : names)
    {
      vtkDataArray* values = swept->GetOutput()->GetPointData()->GetArray(name.c_str());
      ASSERT_NE(values, nullptr) << name;
      std::size_t wrong = 0;
      for (std::size_t n = 0; n < expected[name].size(); ++n)
      {
        wrong += values->GetComponent(static_cast<vtkIdType>(n), 0) != expected[name][n];
      }
      EXPECT_EQ(wrong, 0) << name << " by rule " << rule;
    }
    const std::vector<double>& inside = expected["Inside"];
    EXPECT_EQ(swept->GetNumberOfInsideSamples(), std::count(inside.begin(), inside.end(), 1));
    // Three spheres, which do not meet, of radii 0.5, 0.75 and 1: (0.125 + 0.422 + 1) 4π/3.
    const double voxel = std::pow(swept->GetOutput()->GetSpacing()[0], 3);
    EXPECT_NEAR(voxel * swept->GetNumberOfInsideSamples(), 6.48, 0.3); // 6.4 measured
  }
}

/// Spheres that look inward are farthest inside where w is -1, by the rules for which they are.
TEST_F(TimeUnion, TakesTheValueThatIsFarthestInside)
{
  vtkNew<vtkReverseSense> inward;
  inward->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(inward->GetOutputPort());
  field->SetResolution(60);
  field->UnionOverAllTimesOn();
  for (const int rule :
    {vtkWindingNumberField::SIGNED, vtkWindingNumberField::ABSOLUTE, vtkWindingNumberField::ODD})
  {
    field->SetInsideRule(rule);
    field->Update();
    vtkDataArray* const values = field->GetOutput()->GetPointData()->GetScalars();
    vtkIdType negative = 0, others = 0;
    for (vtkIdType n = 0; n < values->GetNumberOfTuples(); ++n)
    {
      negative += values->GetTuple1(n) == -1;
      others += values->GetTuple1(n) != -1 && values->GetTuple1(n) != 0;
    }
    EXPECT_EQ(others, 0) << rule;
    EXPECT_EQ(negative > 50, rule != vtkWindingNumberField::SIGNED) << rule;
    EXPECT_EQ(field->GetNumberOfInsideSamples(), negative) << rule;
  }
}

/// Samples inside are counted by the arrays that there are, and by the coverage first.
TEST_F(TimeUnion, CountsSamplesByAnyArrays)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetResolution(60);
  field->UnionOverAllTimesOn();
  for (const int type : {VTK_FLOAT, VTK_DOUBLE})
  {
    vtkIdType inside = 0;
    for (const auto& [hasValues, hasInside, hasDistances] : {std::array{true, true, true},
           {true, false, false}, {false, true, false}, {false, false, true}})
    {
      field->SetOutputScalarType(type);
      field->SetGenerateWindingNumber(hasValues);
      field->SetGenerateInside(hasInside);
      field->SetGenerateSignedDistance(hasDistances);
      field->Update();
      inside = inside == 0 ? field->GetNumberOfInsideSamples() : inside;
      EXPECT_GT(inside, 50);
      EXPECT_EQ(field->GetNumberOfInsideSamples(), inside) << hasValues << hasInside;
      EXPECT_EQ(field->GetSampleCounts()[1], inside) << hasValues << hasInside;
    }
    field->GenerateWindingNumberOn();
    field->SetCoverageToAny();
    field->Update();
    vtkDataArray* const touched = field->GetOutput()->GetPointData()->GetArray("Inside");
    vtkIdType count = 0;
    for (vtkIdType n = 0; n < touched->GetNumberOfTuples(); ++n)
    {
      count += touched->GetTuple1(n) != 0;
    }
    EXPECT_GT(count, inside);
    EXPECT_EQ(field->GetNumberOfInsideSamples(), count);
    EXPECT_EQ(field->GetSampleCounts()[1], count);
    field->SetCoverageToCenter();
  }
}

/// The share of a voxel that a sweep covers is that of its samples inside at any time: more than at
/// each time alone.
TEST_F(TimeUnion, HasTheShareThatIsSwept)
{
  sphere->SetStep(1);
  constexpr int k = 3, dimensions[3] = {11, 15, 13};
  const double bounds[6] = {-0.8, 3.3, -1.2, 1.1, -1.1, 1.2};
  vtkNew<vtkWindingNumberField> swept, single;
  for (vtkWindingNumberField* field : {swept.Get(), single.Get()})
  {
    field->SetInputConnection(sphere->GetOutputPort());
    field->UseInputBoundsOff();
    field->SetSamplingBounds(bounds);
  }
  swept->SetSamplingDimensions(dimensions[0], dimensions[1], dimensions[2]);
  swept->SetCoverageToFraction();
  swept->SetCoverageSamples(k);
  swept->GenerateWindingNumberOff();
  swept->UnionOverAllTimesOn();
  single->SetSamplingDimensions(k * dimensions[0], k * dimensions[1], k * dimensions[2]);
  single->GenerateInsideOn();
  for (const bool isOpen : {false, true})
  {
    sphere->SetEndPhi(isOpen ? 150 : 180);
    std::vector<double> shares(dimensions[0] * dimensions[1] * dimensions[2], 0), most = shares;
    std::vector<char> isSwept(k * k * k * shares.size(), 0);
    for (const int time : {0, 1, 2})
    {
      single->UpdateTimeStep(time);
      vtkDataArray* inside = single->GetOutput()->GetPointData()->GetArray("Inside");
      std::vector<double> now(shares.size(), 0);
      std::fill(shares.begin(), shares.end(), 0);
      for (std::size_t n = 0; n < isSwept.size(); ++n)
      {
        const std::size_t width = k * dimensions[0], height = k * dimensions[1];
        const std::size_t i = n % width / k, j = n / width % height / k,
                          l = n / (width * height) / k;
        const std::size_t voxel = i + dimensions[0] * (j + dimensions[1] * l);
        const bool isInside = inside->GetComponent(static_cast<vtkIdType>(n), 0) != 0;
        isSwept[n] |= static_cast<char>(isInside);
        now[voxel] += isInside;
        shares[voxel] += isSwept[n];
      }
      std::transform(most.begin(), most.end(), now.begin(), most.begin(),
        [](double one, double other) { return std::max(one, other); });
    }
    swept->Update();
    vtkPointData* data = swept->GetOutput()->GetPointData();
    int larger = 0, halves = 0;
    for (std::size_t n = 0; n < shares.size(); ++n)
    {
      const auto id = static_cast<vtkIdType>(n);
      ASSERT_EQ(
        std::lround(k * k * k * data->GetArray("Coverage")->GetComponent(id, 0)), shares[n]);
      ASSERT_EQ(data->GetArray("Inside")->GetComponent(id, 0), 2 * shares[n] >= k * k * k);
      larger += shares[n] > most[n];
      halves += 2 * shares[n] >= k * k * k && 2 * most[n] < k * k * k;
    }
    EXPECT_GT(larger, 30);
    EXPECT_GT(halves, 0);
  }
}

TEST_F(TimeUnion, MayHaveAnyNameOfTheArray)
{
  vtkNew<vtkReverseSense> turned; // w is negative
  turned->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(turned->GetOutputPort());
  field->SetInsideRuleToAbsolute();
  field->SetResolution(60);
  field->UnionOverAllTimesOn();
  field->Update();
  const vtkIdType inside = field->GetNumberOfInsideSamples();
  EXPECT_GT(inside, 50);
  for (const char* name :
    {"", static_cast<const char*>(nullptr), "w", "Inside", "Coverage", "SignedDistance"})
  {
    field->SetResultArrayName(name);
    field->Update();
    EXPECT_EQ(field->GetNumberOfInsideSamples(), inside);
    vtkDataArray* values = field->GetOutput()->GetPointData()->GetScalars();
    EXPECT_STREQ(values->GetName(), name && *name ? name : "WindingNumber");
    vtkIdType count = 0;
    for (vtkIdType n = 0; n < values->GetNumberOfTuples(); ++n)
    {
      count += values->GetComponent(n, 0) <= -0.5;
    }
    EXPECT_EQ(count, inside) << (name ? name : "none");
  }
  field->GenerateWindingNumberOff(); // the name is that of no array then
  for (const char* name : {"Inside", "SignedDistance"})
  {
    const bool isInside = std::string(name) == "Inside";
    field->SetResultArrayName(name);
    field->SetGenerateInside(isInside);
    field->SetGenerateSignedDistance(!isInside);
    field->Update();
    EXPECT_EQ(field->GetNumberOfInsideSamples(), inside) << name;
    vtkDataArray* const found = field->GetOutput()->GetPointData()->GetArray(name);
    vtkIdType count = 0;
    for (vtkIdType n = 0; n < found->GetNumberOfTuples(); ++n)
    {
      count += isInside ? found->GetTuple1(n) != 0 : found->GetTuple1(n) < 0;
    }
    EXPECT_EQ(count, inside) << name;
  }
}

/// Memory is expected for the arrays of earlier times, and for a bit of each sample of a voxel.
TEST_F(TimeUnion, CountsWhatItKeeps)
{
  const auto expected = [&](bool isUnion, bool hasFractions)
  {
    vtkNew<vtkWindingNumberField> field;
    field->SetInputConnection(sphere->GetOutputPort());
    field->UseInputBoundsOff();
    field->SetSamplingBounds(-1, 22, -2, 2, -2, 2);
    field->SetSamplingDimensions(46, 8, 8);
    field->SetUnionOverAllTimes(isUnion);
    if (hasFractions)
    {
      field->SetCoverageToFraction();
      field->SetCoverageSamples(5);
    }
    field->UpdateTimeStep(2);
    return static_cast<double>(field->GetExpectedMemory());
  };
  constexpr double voxels = 46 * 8 * 8, words = 2;
  EXPECT_EQ(expected(true, false) - expected(false, false), voxels * sizeof(float));
  EXPECT_EQ(expected(true, true) - expected(false, true),
    voxels * (2 * sizeof(float) + 1 + words * sizeof(std::uint64_t)));
}

/// Both shares of a voxel, and what has them, are of the time with the largest first share.
TEST_F(TimeUnion, TakesBothSharesFromOneTime)
{
  vtkNew<MovingSphere> large;
  for (MovingSphere* ball : {sphere.Get(), large.Get()})
  {
    ball->SetStep(0.3);
  }
  large->SetResolution(12);
  vtkNew<vtkTransform> aside;
  aside->Translate(0.2, 0.3, 0);
  vtkNew<vtkTransformPolyDataFilter> moved;
  moved->SetInputConnection(large->GetOutputPort());
  moved->SetTransform(aside);
  vtkNew<vtkWindingNumberLabels> swept, single;
  for (vtkWindingNumberLabels* labels : {swept.Get(), single.Get()})
  {
    labels->AddInputConnection(sphere->GetOutputPort());
    labels->AddInputConnection(moved->GetOutputPort());
    labels->UseInputBoundsOff();
    labels->SetSamplingBounds(-1.5, 2, -1.5, 2, -1.5, 1.5);
    labels->SetResolution(16);
    labels->SetCoverageToFraction();
  }
  swept->UnionOverAllTimesOn();
  swept->Update();
  const char* names[] = {"FirstShare", "FirstLabel", "SecondShare", "SecondLabel"};
  const auto shareOf = [&](vtkWindingNumberLabels* labels, vtkIdType n)
  {
    std::vector<double> all;
    for (const char* name : names)
    {
      all.push_back(labels->GetOutput()->GetPointData()->GetArray(name)->GetComponent(n, 0));
    }
    return all;
  };
  std::vector<std::vector<double>> best;
  int later = 0;
  for (const int time : {0, 1, 2})
  {
    single->UpdateTimeStep(time);
    best.resize(static_cast<std::size_t>(single->GetOutput()->GetNumberOfPoints()));
    for (std::size_t n = 0; n < best.size(); ++n)
    {
      const std::vector<double> now = shareOf(single, static_cast<vtkIdType>(n));
      if (best[n].empty() || now[0] > best[n][0])
      {
        later += time > 0 && now[3] != best[n][3];
        best[n] = now;
      }
    }
  }
  EXPECT_GT(later, 20);
  for (std::size_t n = 0; n < best.size(); ++n)
  {
    ASSERT_EQ(shareOf(swept, static_cast<vtkIdType>(n)), best[n]) << n;
  }
}

/// Each label has its largest share of any time, and each voxel the largest count of solids.
TEST_F(TimeUnion, HasTheLargestShareOfEachLabel)
{
  vtkNew<MovingSphere> other;
  sphere->SetStep(0.3);
  other->SetStep(-0.2);
  vtkNew<vtkWindingNumberLabels> swept, single;
  for (vtkWindingNumberLabels* labels : {swept.Get(), single.Get()})
  {
    labels->AddInputConnection(sphere->GetOutputPort());
    labels->AddInputConnection(other->GetOutputPort());
    labels->UseInputBoundsOff();
    labels->SetSamplingBounds(-1.5, 2, -1.5, 1.5, -1.5, 1.5);
    labels->SetResolution(16);
    labels->SetCoverageToFraction();
    labels->SetCoverageArrays(vtkWindingNumberLabels::EACH_LABEL);
    labels->GenerateSolidCountOn();
  }
  swept->UnionOverAllTimesOn();
  swept->Update();
  for (const char* const name : {"Coverage 1", "Coverage 2", "SolidCount"})
  {
    vtkDataArray* const found = swept->GetOutput()->GetPointData()->GetArray(name);
    ASSERT_NE(found, nullptr) << name;
    std::vector<double> largest(static_cast<std::size_t>(found->GetNumberOfTuples()));
    int later = 0;
    for (const int time : {0, 1, 2})
    {
      single->UpdateTimeStep(time);
      vtkDataArray* const now = single->GetOutput()->GetPointData()->GetArray(name);
      for (std::size_t n = 0; n < largest.size(); ++n)
      {
        const double value = now->GetTuple1(static_cast<vtkIdType>(n));
        later += time > 0 && value > largest[n];
        largest[n] = std::max(largest[n], value);
      }
    }
    EXPECT_GT(later, 20) << name;
    for (std::size_t n = 0; n < largest.size(); ++n)
    {
      ASSERT_EQ(found->GetTuple1(static_cast<vtkIdType>(n)), largest[n]) << name << " " << n;
    }
  }
}

TEST_F(TimeUnion, KeepsLabelsOfEveryTime)
{
  vtkNew<vtkWindingNumberLabels> labels;
  labels->SetInputConnection(sphere->GetOutputPort());
  labels->SetCoverageToFraction();
  labels->GenerateSolidCountOn();
  labels->UnionOverAllTimesOn();
  labels->SetResolution(60);
  labels->Update();
  vtkPointData* data = labels->GetOutput()->GetPointData();
  ASSERT_EQ(data->GetScalars(), data->GetArray("Label"));
  int found[3] = {0, 0, 0};
  for (vtkIdType n = 0; n < labels->GetOutput()->GetNumberOfPoints(); ++n)
  {
    const double label = data->GetArray("Label")->GetComponent(n, 0);
    EXPECT_EQ(data->GetArray("SolidCount")->GetComponent(n, 0), label) << "one solid, label 1";
    EXPECT_EQ(data->GetArray("FirstLabel")->GetComponent(n, 0) != 0,
      data->GetArray("FirstShare")->GetComponent(n, 0) > 0);
    if (label != 0)
    {
      ++found[std::lround(labels->GetOutput()->GetPoint(n)[0] / 10)];
    }
  }
  EXPECT_GT(found[0], 5);
  EXPECT_GT(found[1], found[0]);
  EXPECT_GT(found[2], found[1]);
}

/// Only at one of three times is the sphere in the box, and so the warning is about the others.
TEST_F(TimeUnion, SaysAtHowManyTimesItWarns)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->UseInputBoundsOff();
  field->SetSamplingBounds(-1, 1, -1, 1, -1, 1);
  field->SetResolution(20);
  field->UnionOverAllTimesOn();
  const ErrorLog log(field);
  field->Update();
  EXPECT_GT(field->GetNumberOfInsideSamples(), 0);
  EXPECT_EQ(log.errors(), "");
  EXPECT_EQ(countOf("Warning: ", log.warnings()), 1) << log.warnings();
  EXPECT_EQ(countOf("at 2 of 3 times", log.warnings()), 1) << log.warnings();
  const double before = field->GetOutput()->GetScalarRange()[1];
  field->Modified();
  field->UpdateTimeStep(2);
  EXPECT_EQ(field->GetOutput()->GetScalarRange()[1], before) << "no time of the output's own";
}

/// Nothing is inside at the second time, whatever the union has from the first.
TEST_F(TimeUnion, WarnsOfWhatIsLostAtOneTime)
{
  vtkNew<OneByOne> source;
  source->SetRadii({1, 0.05});
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(source->GetOutputPort());
  field->UseInputBoundsOff();
  field->SetSamplingBounds(-1.25, 1.25, -1.25, 1.25, -1.25, 1.25);
  field->SetResolution(10); // the origin is a corner of voxels
  field->UnionOverAllTimesOn();
  for (const int coverage : {vtkWindingNumberField::CENTER, vtkWindingNumberField::FRACTION})
  {
    field->SetCoverage(coverage);
    const ErrorLog log(field);
    field->Update();
    EXPECT_GT(field->GetNumberOfInsideSamples(), 100);
    EXPECT_EQ(countOf("Warning: ", log.warnings()), 1) << log.warnings();
    EXPECT_EQ(countOf("would give it three, at 1 of 2 times", log.warnings()), 1)
      << log.warnings();
  }
}

/// A filter may warn of several sources at a time, which is one time.
TEST_F(TimeUnion, WarningsOfOneKindCountOnceForEachTime)
{
  vtkNew<vtkSphereSource> object;
  const ErrorLog log(object);
  {
    winding::DistinctWarnings warnings(object);
    for (const int holes : {0, 3})
    {
      warnings.begin();
      for (int part = 0; part < holes; ++part)
      {
        vtkWarningWithObjectMacro(object, << "there are " << part << " holes");
      }
    }
    warnings.begin();
    vtkWarningWithObjectMacro(object, << "there are 9 holes");
  }
  EXPECT_EQ(countOf("Warning: ", log.warnings()), 1) << log.warnings();
  EXPECT_EQ(countOf("there are 0 holes; at 2 of 3 times", log.warnings()), 1) << log.warnings();
}

/// Warnings about two solids are two, whatever their names have in common.
TEST_F(TimeUnion, WarningsThatDifferByNumbersOnlyAreOneForEachName)
{
  vtkNew<vtkSphereSource> object;
  const ErrorLog log(object);
  {
    winding::DistinctWarnings warnings(object);
    warnings.begin();
    vtkWarningWithObjectMacro(object, << "'Part 1' has 3 holes");
    vtkWarningWithObjectMacro(object, << "'Part 2' has 3 holes");
    warnings.begin();
    vtkWarningWithObjectMacro(object, << "'Part 1' has 4 holes");
    EXPECT_EQ(log.warnings(), "");
  }
  EXPECT_EQ(countOf("Warning: ", log.warnings()), 2) << log.warnings();
  EXPECT_EQ(countOf("'Part 1' has 3 holes\n", log.warnings()), 1) << log.warnings();
  EXPECT_EQ(countOf("'Part 2' has 3 holes; at 1 of 2 times", log.warnings()), 1) << log.warnings();
}

/// Two cubes, of which one or both are there, or none: by time, a solid for each name.
class ComingAndGoing : public vtkMultiBlockDataSetAlgorithm
{
public:
  static ComingAndGoing* New() { VTK_STANDARD_NEW_BODY(ComingAndGoing); }
  vtkTypeMacro(ComingAndGoing, vtkMultiBlockDataSetAlgorithm);

  std::vector<std::string> names = {"", "left", "left"}; ///< of the solids at each time
  bool hasSteps = true;

protected:
  ComingAndGoing() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    const double times[3] = {0, 1, 2}, range[2] = {0, 2};
    vtkInformation* info = outputs->GetInformationObject(0);
    if (hasSteps)
    {
      info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times, 3);
    }
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    auto* key = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
    const int time = info->Has(key) ? static_cast<int>(info->Get(key)) : 0;
    auto* blocks = vtkMultiBlockDataSet::GetData(info);
    const std::string& name = names[static_cast<std::size_t>(time)];
    if (!name.empty())
    {
      vtkNew<vtkSphereSource> sphere;
      sphere->SetCenter(3 * time, 0, 0);
      sphere->Update();
      blocks->SetBlock(0, sphere->GetOutput());
      blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), name.c_str());
    }
    return 1;
  }
};

TEST_F(TimeUnion, OfLabelsNamesOneSolidAtAllTimes)
{
  const auto labelsOf = [](ComingAndGoing* source)
  {
    const auto labels = vtkSmartPointer<vtkWindingNumberLabels>::New();
    labels->SetInputConnection(source->GetOutputPort());
    labels->UnionOverAllTimesOn();
    labels->SetResolution(40);
    return labels;
  };
  vtkNew<ComingAndGoing> same;
  const auto labels = labelsOf(same);
  const ErrorLog log(labels);
  labels->Update();
  EXPECT_EQ(log.errors(), "");
  EXPECT_STREQ(labels->GetLabelLegend(), "1\tleft\n") << "the first time has no solid";
  EXPECT_EQ(labels->GetOutput()->GetScalarRange()[1], 1);
  vtkNew<ComingAndGoing> gone;
  gone->names = {"left", "left", ""};
  const auto last = labelsOf(gone);
  const ErrorLog ofLast(last);
  last->Update();
  EXPECT_STREQ(last->GetLabelLegend(), "1\tleft\n") << "the last time has no solid";
  EXPECT_EQ(last->GetOutput()->GetFieldData()->GetArray("LabelValues")->GetNumberOfTuples(), 1);
  vtkNew<ComingAndGoing> other;
  other->names = {"left", "left", "right"};
  const auto refused = labelsOf(other);
  const ErrorLog ofRefused(refused);
  refused->Update();
  EXPECT_EQ(refused->GetStatus(), vtkWindingNumberLabels::REFUSED);
  EXPECT_NE(ofRefused.errors().find("others at another time"), std::string::npos)
    << ofRefused.errors();
}

/// A source that is empty at the last time still has its kind.
TEST_F(TimeUnion, KeepsTheKindOfTheSource)
{
  vtkNew<ComingAndGoing> solids;
  solids->names = {"left", "left", ""};
  vtkNew<vtkWindingNumberLabels> labels;
  labels->SetInputConnection(solids->GetOutputPort());
  labels->SetResolution(10);
  labels->UnionOverAllTimesOn();
  labels->Update();
  EXPECT_EQ(labels->GetSourceKind(), vtkWindingNumberLabels::MESH_SOURCE);
  EXPECT_EQ(labels->GetOutput()->GetPointData()->GetScalars()->GetRange()[1], 1);
}

/// A source whose union is refused is at its own time after it.
TEST_F(TimeUnion, GivesTheSourceItsTimeBack)
{
  vtkNew<ComingAndGoing> source;
  source->names = {"left", "left", "right"};
  source->UpdateTimeStep(1);
  vtkNew<vtkWindingNumberLabels> labels;
  labels->SetInputConnection(source->GetOutputPort());
  labels->UseInputBoundsOff();
  labels->SetSamplingBounds(-1, 7, -1, 1, -1, 1);
  labels->UnionOverAllTimesOn();
  labels->SetResolution(20);
  const ErrorLog log(labels);
  labels->Update();
  ASSERT_EQ(labels->GetStatus(), vtkWindingNumberLabels::REFUSED);
  EXPECT_EQ(
    source->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()), 1);
  labels->UnionOverAllTimesOff();
  labels->Update();
  EXPECT_EQ(labels->GetStatus(), vtkWindingNumberLabels::DONE) << log.errors();
  EXPECT_STREQ(labels->GetLabelLegend(), "1\tleft\n");
}

TEST_F(TimeUnion, OfARangeWithoutStepsIsRefused)
{
  vtkNew<ComingAndGoing> source;
  source->hasSteps = false;
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(source->GetOutputPort());
  field->UnionOverAllTimesOn();
  const ErrorLog log(field);
  field->Update();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::REFUSED);
  EXPECT_NE(log.errors().find("no steps"), std::string::npos) << log.errors();
}

/// Each time alone is within the limit, three times the seconds of one, and thirty are not.
TEST_F(TimeUnion, KeepsTheLongestExpectedTime)
{
  vtkNew<MovingSphere> large;
  large->SetResolution(100);
  std::vector<double> times(30);
  std::iota(times.begin(), times.end(), 0.0);
  large->SetTimes(times);
  large->SetStep(0.1);
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(large->GetOutputPort());
  field->SetMethod(vtkWindingNumberField::DIRECT);
  field->SetSamplingDimensions(10, 20, 20);
  field->BoundsOverAllTimesOn();
  double shortest = 1e300;
  for (const int time : {0, 1, 2})
  {
    field->UpdateTimeStep(time);
    shortest = std::min(shortest, field->GetPrepareSeconds() + field->GetEvaluateSeconds());
  }
  field->SetLongestExpectedTime(3 * shortest);
  const ErrorLog log(field);
  field->UpdateTimeStep(3);
  if (field->GetStatus() != vtkWindingNumberField::DONE)
  {
    GTEST_SKIP() << "the machine is too busy to tell: one time took longer than three did";
  }
  field->UnionOverAllTimesOn();
  field->Update();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::REFUSED) << shortest;
}

/// Eight times take longer than one, which is said at the first.
TEST_F(TimeUnion, ExpectsTheSecondsOfThoseThatFollow)
{
  std::vector<double> times(8);
  std::iota(times.begin(), times.end(), 0.0);
  sphere->SetTimes(times);
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetMethod(vtkWindingNumberField::DIRECT);
  field->UseInputBoundsOff();
  field->SetSamplingBounds(-1, 1, -1, 1, -1, 1);
  field->SetResolution(40);
  field->SetNumberOfThreads(1);
  vtkNew<vtkCallbackCommand> wait, count;
  wait->SetCallback(
    [](vtkObject* filter, unsigned long, void*, void*)
    {
      // The clock is looked at after a second, and a time takes a few.
      const char* const text = vtkAlgorithm::SafeDownCast(filter)->GetProgressText();
      if (text && std::string(text) == "Evaluating")
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(1100));
      }
    });
  field->AddObserver(vtkCommand::ProgressEvent, wait);
  int executions = 0;
  count->SetClientData(&executions);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* number, void*) { ++*static_cast<int*>(number); });
  sphere->AddObserver(vtkCommand::StartEvent, count);
  const ErrorLog log(field);
  field->SetLongestExpectedTime(10); // measured at that look: 31 s for one time, 250 s for all
  field->Update();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::REFUSED);
  const double secondsOfOne = field->GetExpectedSeconds();
  field->UnionOverAllTimesOn();
  field->SetLongestExpectedTime(60);
  executions = 0;
  field->Update();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::REFUSED);
  EXPECT_GT(field->GetExpectedSeconds(), 5 * secondsOfOne);
  EXPECT_LT(field->GetExpectedSeconds(), 13 * secondsOfOne);
  EXPECT_LE(executions, 3) << "before, at the first time and after it";
}

TEST_F(TimeUnion, IsRefusedWithNearestCells)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->UnionOverAllTimesOn();
  field->GenerateNearestCellsOn();
  const ErrorLog log(field);
  field->Update();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::REFUSED);
  EXPECT_NE(log.errors().find("UnionOverAllTimesOff()"), std::string::npos) << log.errors();
}

/// A source without times is the only one there is.
TEST_F(TimeUnion, OfOneTimeIsThat)
{
  vtkNew<vtkSphereSource> still;
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(still->GetOutputPort());
  field->SetResolution(10);
  field->Update();
  const vtkIdType inside = field->GetNumberOfInsideSamples();
  field->UnionOverAllTimesOn();
  field->Update();
  EXPECT_GT(inside, 0);
  EXPECT_EQ(field->GetNumberOfInsideSamples(), inside);
}

} // namespace
