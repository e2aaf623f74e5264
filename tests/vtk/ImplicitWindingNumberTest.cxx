// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"
#include "vtk/ImplicitFunctionInputs.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkImplicitWindingNumber.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSampleFunction.h"
#include "vtkSphereSource.h"
#include "vtkTransform.h"
#include "vtkWindingNumberProbe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <thread>

namespace
{

using Algorithm = vtkWindingNumberAlgorithm;
using Position = std::array<double, 3>;

/// Positions in and around the sphere.
std::vector<Position> positions(std::size_t count = 300)
{
  std::mt19937 random(711);
  std::vector<Position> result(count);
  for (Position& position : result)
  {
    for (double& coordinate : position)
    {
      coordinate = 1.6 * (static_cast<double>(random()) / 0x1p32 - 0.5);
    }
  }
  return result;
}

vtkSmartPointer<vtkDoubleArray> arrayOf(const std::vector<Position>& points)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfComponents(3);
  for (const Position& point : points)
  {
    array->InsertNextTuple(point.data());
  }
  return array;
}

/// The values that the probe, set up alike, gives at positions.
std::vector<double> probed(vtkDataObject* source, const std::vector<Position>& at,
  int method = Algorithm::AUTOMATIC, double tolerance = 1e-3)
{
  vtkNew<vtkPoints> points;
  points->SetData(arrayOf(at));
  vtkNew<vtkPolyData> queries;
  queries->SetPoints(points);
  vtkNew<vtkWindingNumberProbe> probe;
  probe->SetInputData(queries);
  probe->SetSourceData(source);
  probe->SetMethod(method);
  probe->SetTolerance(tolerance);
  probe->SetOutputScalarTypeToDouble();
  probe->Update();
  vtkDataArray* values = probe->GetOutput()->GetPointData()->GetArray("WindingNumber");
  std::vector<double> result;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    result.push_back(values->GetTuple1(i));
  }
  return result;
}

/// The largest difference between the gradient and central differences of values.
double differenceOfGradients(vtkImplicitFunction* function, const std::vector<Position>& at)
{
  constexpr double step = 1e-4;
  double largest = 0;
  for (const Position& x : at)
  {
    double gradient[3];
    function->FunctionGradient(x.data(), gradient);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      Position before = x, after = x;
      before[axis] -= step;
      after[axis] += step;
      const double slope =
        (function->FunctionValue(after.data()) - function->FunctionValue(before.data())) /
        (2 * step);
      largest = std::max(largest, std::abs(slope - gradient[axis]));
    }
  }
  return largest;
}

/// The positions that are not so near to the sphere that central differences would cross it.
std::vector<Position> offTheSphere(std::vector<Position> at)
{
  at.erase(std::remove_if(at.begin(), at.end(),
             [](const Position& x) { return std::abs(vtkMath::Norm(x.data()) - 0.5) < 0.05; }),
    at.end());
  return at;
}

class ImplicitWindingNumber : public testing::Test
{
protected:
  vtkNew<vtkImplicitWindingNumber> function;
};

TEST_F(ImplicitWindingNumber, IsThresholdLessWindingNumber)
{
  function->SetInput(sphere());
  EXPECT_NEAR(function->FunctionValue(0.1, 0.2, 0.1), -0.5, 1e-3) << "inside";
  EXPECT_NEAR(function->FunctionValue(0.1, 0.2, 0.6), 0.5, 1e-3) << "outside";
  function->GetField()->SetWindingThreshold(0.25);
  EXPECT_NEAR(function->FunctionValue(0.1, 0.2, 0.1), -0.75, 1e-3);
}

TEST_F(ImplicitWindingNumber, HasTheValuesOfTheProbe)
{
  for (const auto& input : someInputs())
  {
    function->SetInput(input);
    const auto at = positions();
    const auto expectNear = [&](double tolerance)
    {
      const std::vector<double> expected =
        probed(input, at, function->GetField()->GetMethod(), function->GetField()->GetTolerance());
      vtkNew<vtkDoubleArray> all;
      function->FunctionValue(arrayOf(at), all);
      for (std::size_t i = 0; i < at.size(); ++i)
      {
        EXPECT_NEAR(function->FunctionValue(at[i].data()), 0.5 - expected[i], tolerance);
        EXPECT_NEAR(all->GetValue(static_cast<vtkIdType>(i)), 0.5 - expected[i], tolerance);
      }
    };
    function->GetField()->SetMethod(Algorithm::AUTOMATIC);
    function->GetField()->SetTolerance(1e-3);
    expectNear(2e-3);
    function->GetField()->SetTolerance(0);
    expectNear(1e-13); // the probe counts crossings of closed surfaces
    function->GetField()->SetMethod(Algorithm::DIRECT);
    expectNear(0);
  }
}

TEST_F(ImplicitWindingNumber, HasTheGradientOfItsValues)
{
  function->GetField()->SetTolerance(0);
  function->SetInput(sphere(120));
  EXPECT_LT(differenceOfGradients(function, offTheSphere(positions())), 1e-5); // measured: 1.5e-6
  function->SetInput(cloud());
  EXPECT_LT(differenceOfGradients(function, offTheSphere(positions())), 1e-5); // measured: 3.5e-6

  // w falls toward the hole at the bottom, so values grow.
  function->SetInput(sphere(120));
  double gradient[3];
  const double x[3] = {0, 0, -0.2};
  function->FunctionGradient(x, gradient);
  EXPECT_LT(gradient[2], -0.1);
}

TEST_F(ImplicitWindingNumber, HasTheGradientOfItsValuesWithinATolerance)
{
  vtkNew<vtkImplicitWindingNumber> exact;
  exact->GetField()->SetMethod(Algorithm::DIRECT);
  for (const auto& input : someInputs())
  {
    function->SetInput(input);
    exact->SetInput(input);
    for (const Position& x : offTheSphere(positions()))
    {
      double expected[3], gradient[3];
      exact->FunctionGradient(x.data(), expected);
      function->FunctionGradient(x.data(), gradient);
      // The limit is the tolerance over the distance to the source, which is 0.05 at least.
      // Measured: 0.0093.
      EXPECT_LT(std::sqrt(vtkMath::Distance2BetweenPoints(expected, gradient)), 0.02);
    }
  }
  function->SetInput(sphere());
  double* gradient = function->FunctionGradient(0.3, 0.1, 0.45);
  EXPECT_EQ(vtkMath::Norm(gradient), 0) << "of a closed surface";
}

TEST_F(ImplicitWindingNumber, TakesTheAbsoluteValueOnRequest)
{
  auto insideOut = sphere(120);
  for (vtkIdType i = 0; i < insideOut->GetNumberOfCells(); ++i)
  {
    insideOut->ReverseCell(i);
  }
  insideOut->Modified();
  function->GetField()->SetTolerance(0);
  function->SetInput(insideOut);
  EXPECT_GT(function->FunctionValue(0, 0, 0.2), 1);
  function->GetField()->SetInsideRule(Algorithm::ABSOLUTE);
  EXPECT_LT(function->FunctionValue(0, 0, 0.2), -0.3);
  EXPECT_LT(differenceOfGradients(function, offTheSphere(positions())), 1e-5);
}

TEST_F(ImplicitWindingNumber, TakesArraysOfAnyType)
{
  function->SetInput(sphere());
  vtkNew<vtkIntArray> integers;
  integers->SetNumberOfComponents(3);
  integers->InsertNextTuple3(0, 0, 0);
  integers->InsertNextTuple3(1, 0, 0);
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfComponents(2); // a wrong number, which is put right
  function->FunctionValue(integers, values);
  ASSERT_EQ(values->GetNumberOfValues(), 2);
  EXPECT_NEAR(values->GetValue(0), -0.5, 1e-3);
  EXPECT_NEAR(values->GetValue(1), 0.5, 1e-3);
  vtkNew<vtkDoubleArray> none;
  none->SetNumberOfComponents(3);
  function->FunctionValue(none, values);
  EXPECT_EQ(values->GetNumberOfTuples(), 0);

  vtkNew<vtkDoubleArray> flat;
  flat->SetNumberOfComponents(2);
  flat->InsertNextTuple2(0, 0);
  ErrorLog log(function);
  function->FunctionValue(flat, values);
  EXPECT_NE(log.errors().find("3 coordinates"), std::string::npos) << log.errors();
  EXPECT_EQ(values->GetValue(0), 0.5);
}

TEST_F(ImplicitWindingNumber, IsNaNWhereThereIsNoPlace)
{
  function->SetInput(sphere());
  EXPECT_TRUE(std::isnan(function->FunctionValue(std::nan(""), 0, 0)));
  EXPECT_TRUE(
    std::isnan(function->FunctionGradient(0, std::numeric_limits<double>::infinity(), 0)[0]));
}

TEST_F(ImplicitWindingNumber, IsEvaluatedInTransformedPlaces)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(0.3, -0.2, 0.1);
  transform->RotateWXYZ(40, 1, 2, 3);
  transform->Scale(2, 0.5, 1);
  function->GetField()->SetTolerance(0);
  function->SetInput(sphere(120));
  const auto at = positions(50);
  std::vector<double> expected;
  std::vector<Position> off;
  for (const Position& x : at)
  {
    Position there;
    transform->TransformPoint(x.data(), there.data());
    expected.push_back(function->FunctionValue(there.data()));
    if (!offTheSphere({there}).empty())
    {
      off.push_back(x);
    }
  }
  function->SetTransform(transform);
  vtkNew<vtkFloatArray> all;
  function->FunctionValue(arrayOf(at), all);
  for (std::size_t i = 0; i < at.size(); ++i)
  {
    EXPECT_EQ(function->FunctionValue(at[i].data()), expected[i]);
    EXPECT_EQ(all->GetValue(static_cast<vtkIdType>(i)), static_cast<float>(expected[i]));
  }
  EXPECT_LT(differenceOfGradients(function, off), 1e-5);
}

TEST_F(ImplicitWindingNumber, IsBuiltOnceForAllTransforms)
{
  auto source = sphere();
  const vtkIdType beyond[3] = {0, 1, 999999};
  source->GetPolys()->InsertNextCell(3, beyond);
  source->Modified();
  function->SetInput(source);
  ErrorLog log(function);
  vtkNew<vtkTransform> transform;
  function->SetTransform(transform);
  EXPECT_NEAR(function->FunctionValue(0, 0, 0), -0.5, 1e-3);
  const std::string once = log.warnings();
  EXPECT_NE(once.find("1 of"), std::string::npos) << once;
  const vtkMTimeType time = function->GetMTime();
  transform->Translate(2, 0, 0);
  EXPECT_GT(function->GetMTime(), time);
  EXPECT_NEAR(function->FunctionValue(0, 0, 0), 0.5, 1e-3);
  EXPECT_EQ(log.warnings(), once);
}

TEST_F(ImplicitWindingNumber, FollowsAnInputThatIsModified)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(20);
  source->SetPhiResolution(20);
  source->Update();
  function->SetInput(source->GetOutput());
  EXPECT_EQ(function->GetInput(), source->GetOutput());
  const double x[3] = {0.7, 0, 0};
  EXPECT_NEAR(function->FunctionValue(x), 0.5, 1e-3);
  vtkMTimeType time = function->GetMTime();
  source->SetRadius(1);
  source->Update();
  EXPECT_GT(function->GetMTime(), time);
  EXPECT_NEAR(function->FunctionValue(x), -0.5, 1e-3);

  time = function->GetMTime();
  vtkPoints* points = source->GetOutput()->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    points->SetPoint(i, p[0] + 2, p[1], p[2]);
  }
  points->Modified();
  EXPECT_GT(function->GetMTime(), time);
  EXPECT_NEAR(function->FunctionValue(x), 0.5, 1e-3);

  // Triangles are turned round within the array of their ids.
  const double inside[3] = {2, 0, 0};
  EXPECT_NEAR(function->FunctionValue(inside), -0.5, 1e-3);
  vtkDataArray* ids = source->GetOutput()->GetPolys()->GetConnectivityArray();
  for (vtkIdType i = 0; i < ids->GetNumberOfValues(); i += 3)
  {
    const double second = ids->GetComponent(i + 1, 0);
    ids->SetComponent(i + 1, 0, ids->GetComponent(i + 2, 0));
    ids->SetComponent(i + 2, 0, second);
  }
  time = function->GetMTime();
  ids->Modified();
  EXPECT_GT(function->GetMTime(), time);
  EXPECT_NEAR(function->FunctionValue(inside), 1.5, 1e-3);

  function->SetInput(sphere(180, 0.8));
  EXPECT_NEAR(function->FunctionValue(x), -0.5, 1e-3);
}

TEST_F(ImplicitWindingNumber, FollowsTheLeavesOfCompositeInput)
{
  vtkNew<vtkMultiBlockDataSet> blocks, nested;
  auto leaf = sphere();
  nested->SetBlock(0, leaf);
  blocks->SetBlock(0, sphere(180, 0.1, 5));
  blocks->SetBlock(1, nested);
  function->SetInput(blocks);
  EXPECT_NEAR(function->FunctionValue(0, 0, 0), -0.5, 1e-3);
  EXPECT_NEAR(function->FunctionValue(5, 0, 0), -0.5, 1e-3);

  vtkMTimeType time = function->GetMTime();
  leaf->ShallowCopy(sphere(180, 0.5, 2));
  EXPECT_GT(function->GetMTime(), time);
  EXPECT_NEAR(function->FunctionValue(0, 0, 0), 0.5, 1e-3);
  EXPECT_NEAR(function->FunctionValue(2, 0, 0), -0.5, 1e-3);

  time = function->GetMTime();
  nested->SetBlock(0, sphere(180, 0.5, 3));
  leaf = nullptr;
  EXPECT_GT(function->GetMTime(), time);
  EXPECT_NEAR(function->FunctionValue(2, 0, 0), 0.5, 1e-3);
  EXPECT_NEAR(function->FunctionValue(3, 0, 0), -0.5, 1e-3);
}

TEST_F(ImplicitWindingNumber, TakesPropertiesOfClouds)
{
  auto points = cloud();
  function->SetInput(points);
  EXPECT_NEAR(function->FunctionValue(0, 0, 0), -0.5, 0.01);
  const double area = vtkMath::Pi() / static_cast<double>(points->GetNumberOfPoints());
  function->GetField()->SetPointAreaMethod(Algorithm::CONSTANT);
  function->GetField()->SetPointArea(area);
  const double w = 0.5 - function->FunctionValue(0, 0, 0);
  function->GetField()->SetPointArea(2 * area);
  EXPECT_NEAR(0.5 - function->FunctionValue(0, 0, 0), 2 * w, 1e-6);
  vtkNew<vtkDoubleArray> areas;
  areas->SetName("Area");
  areas->SetNumberOfTuples(points->GetNumberOfPoints());
  areas->Fill(3 * area);
  points->GetPointData()->AddArray(areas);
  function->GetField()->SetPointAreaMethod(Algorithm::ARRAY);
  EXPECT_NEAR(0.5 - function->FunctionValue(0, 0, 0), 3 * w, 1e-6);
  function->SetInput(sphere());
  function->GetField()->SourceAsPointsOn();
  function->GetField()->SetPointAreaMethod(Algorithm::MESH);
  EXPECT_NEAR(function->FunctionValue(0, 0, 0), -0.5, 0.01);
}

TEST_F(ImplicitWindingNumber, SaysOnceThatThereIsNoInputAndIsOutside)
{
  ErrorLog log(function);
  EXPECT_EQ(function->FunctionValue(0, 0, 0), 0.5);
  const std::string once = log.errors();
  EXPECT_NE(once.find("no input"), std::string::npos) << once;
  EXPECT_EQ(function->FunctionValue(1, 0, 0), 0.5);
  EXPECT_EQ(vtkMath::Norm(function->FunctionGradient(0, 0, 0)), 0);
  vtkNew<vtkDoubleArray> values;
  function->FunctionValue(arrayOf(positions()), values);
  EXPECT_EQ(values->GetRange()[0], 0.5);
  EXPECT_EQ(values->GetRange()[1], 0.5);
  EXPECT_FALSE(function->BuildField());
  EXPECT_EQ(log.errors(), once);
  function->SetInput(sphere());
  EXPECT_TRUE(function->BuildField());
  EXPECT_NEAR(function->FunctionValue(0, 0, 0), -0.5, 1e-3);
  EXPECT_EQ(log.errors(), once);
}

TEST_F(ImplicitWindingNumber, SaysOnceThatAnInputIsRefused)
{
  auto points = cloud();
  points->GetPointData()->SetNormals(nullptr);
  function->SetInput(points);
  ErrorLog log(function);
  vtkNew<vtkSampleFunction> sample;
  sample->SetImplicitFunction(function);
  sample->SetSampleDimensions(10, 10, 10);
  sample->Update();
  const std::string once = log.errors();
  EXPECT_EQ(once.find("the points have no normals"), once.rfind("the points have no normals"))
    << once;
  EXPECT_NE(once.find("the points have no normals"), std::string::npos) << once;
  EXPECT_EQ(sample->GetOutput()->GetPointData()->GetScalars()->GetRange()[0], 0.5);
  function->GetField()->EstimateNormalsOn();
  EXPECT_NEAR(function->FunctionValue(0, 0, 0), -0.5, 0.02);
  EXPECT_EQ(log.errors(), once);
  function->GetField()->SetMethod(Algorithm::ROWS);
  function->SetInput(sphere());
  EXPECT_FALSE(function->BuildField());
  EXPECT_NE(log.errors().find("rows needs all samples at once"), std::string::npos) << log.errors();
}

TEST_F(ImplicitWindingNumber, RefusesAPieceOfAnInput)
{
  vtkNew<vtkSphereSource> source;
  source->UpdatePiece(1, 4, 0);
  function->SetInput(source->GetOutput());
  ErrorLog log(function);
  EXPECT_FALSE(function->BuildField());
  EXPECT_NE(log.errors().find("the input is piece 1 of 4"), std::string::npos) << log.errors();
  source->UpdatePiece(0, 1, 0);
  EXPECT_TRUE(function->BuildField());
  EXPECT_NEAR(function->FunctionValue(0, 0, 0), -0.5, 1e-3);
}

TEST_F(ImplicitWindingNumber, HasTheSameBitsFromManyThreads)
{
  const auto at = positions(2000);
  for (const auto& input : someInputs())
  {
    vtkNew<vtkImplicitWindingNumber> serial, concurrent, parallel;
    std::vector<std::array<double, 4>> expected(at.size()), values(at.size()), more(at.size());
    const auto evaluate = [&at](vtkImplicitFunction* one, std::size_t i, std::array<double, 4>& to)
    {
      to[0] = one->FunctionValue(at[i].data());
      one->FunctionGradient(at[i].data(), &to[1]);
    };
    serial->SetInput(input);
    for (std::size_t i = 0; i < at.size(); ++i)
    {
      evaluate(serial, i, expected[i]);
    }
    // Nothing is built before the first calls, which come together.
    concurrent->SetInput(input);
    std::vector<std::thread> threads;
    for (std::size_t first = 0; first < 4; ++first)
    {
      threads.emplace_back(
        [&, first]
        {
          for (std::size_t i = first; i < at.size(); i += 4)
          {
            evaluate(concurrent, i, values[i]);
          }
        });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
    EXPECT_EQ(values, expected);
    parallel->SetInput(input);
    vtkSMPTools::For(0, static_cast<vtkIdType>(at.size()), 10,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
        {
          evaluate(parallel, i, more[i]);
        }
      });
    EXPECT_EQ(more, expected);
  }
}

} // namespace
