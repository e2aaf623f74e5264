// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "laboratory/VtkContestants.h"

#include "laboratory/BenchGrid.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkExtractEnclosedPoints.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkImageStencilData.h"
#include "vtkImageStencilToImage.h"
#include "vtkImplicitPolyDataDistance.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataToImageStencil.h"
#include "vtkSelectEnclosedPoints.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberProbe.h"

#include <random>

namespace
{

const char* const numberArray = "number";

bool isWrongSide(double answer, double w)
{
  return (answer != 0) != (w >= 0.5);
}

/// A contest about random points, without contestants so far.
Contest pointContest(const std::string& question, vtkPolyData* points)
{
  Contest contest;
  contest.question = question;
  contest.count = static_cast<std::size_t>(points->GetNumberOfPoints());
  contest.samples = std::to_string(contest.count) + " points";
  contest.sample = [points = vtkSmartPointer<vtkPolyData>(points)](std::size_t number)
  {
    Eigen::Vector3d x;
    points->GetPoint(static_cast<vtkIdType>(number), x.data());
    return x;
  };
  contest.isWrong = isWrongSide;
  return contest;
}

/// A function that reads the answers from an array of the output's points.
std::function<std::vector<double>(vtkDataObject*)> fromArray(const char* name)
{
  return [name](vtkDataObject* output)
  {
    vtkDataArray* array = vtkDataSet::SafeDownCast(output)->GetPointData()->GetArray(name);
    std::vector<double> answers;
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      answers.push_back(array->GetTuple1(i));
    }
    return answers;
  };
}

/// A function whose answer is 1 for the points that the output still has, and 0 for the others.
std::function<std::vector<double>(vtkDataObject*)> fromNumbers(std::size_t count)
{
  return [count](vtkDataObject* output)
  {
    std::vector<double> answers(count, 0);
    for (const double number : fromArray(numberArray)(output))
    {
      answers[static_cast<std::size_t>(number)] = 1;
    }
    return answers;
  };
}

} // namespace

vtkSmartPointer<vtkPolyData> randomPoints(const winding::Bounds& bounds, std::size_t count)
{
  std::mt19937_64 random(20260101);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName(numberArray);
  for (std::size_t i = 0; i < count; ++i)
  {
    double x[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double t = static_cast<double>(random() >> 11) * 0x1p-53;
      x[axis] = bounds.min()[axis] + (1.1 * t - 0.05) * bounds.sizes()[axis];
    }
    points->InsertNextPoint(x);
    numbers->InsertNextValue(static_cast<vtkIdType>(i));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(numbers);
  return data;
}

Contest insideContest(const winding::Bounds& bounds, std::size_t count)
{
  const vtkSmartPointer<vtkPolyData> points = randomPoints(bounds, count);
  Contest contest = pointContest("inside", points);
  contest.contestants.push_back({"vtkWindingNumberProbe",
    [points](vtkPolyData* surface) -> vtkSmartPointer<vtkDataObject>
    {
      vtkNew<vtkWindingNumberProbe> probe;
      probe->SetInputData(points);
      probe->SetSourceData(surface);
      probe->GenerateInsideOn();
      probe->Update();
      return probe->GetOutput();
    },
    fromArray("Inside")});
  contest.contestants.push_back({"vtkSelectEnclosedPoints",
    [points](vtkPolyData* surface) -> vtkSmartPointer<vtkDataObject>
    {
      vtkNew<vtkSelectEnclosedPoints> select;
      select->SetInputData(points);
      select->SetSurfaceData(surface);
      select->Update();
      return select->GetOutput();
    },
    fromArray("SelectedPoints")});
  return contest;
}

Contest extractionContest(const winding::Bounds& bounds, std::size_t count)
{
  const vtkSmartPointer<vtkPolyData> points = randomPoints(bounds, count);
  Contest contest = pointContest("extract", points);
  contest.contestants.push_back({"vtkWindingNumberProbe",
    [points](vtkPolyData* surface) -> vtkSmartPointer<vtkDataObject>
    {
      vtkNew<vtkWindingNumberProbe> probe;
      probe->SetInputData(points);
      probe->SetSourceData(surface);
      probe->ExtractInsideOn();
      probe->Update();
      return probe->GetOutput();
    },
    fromNumbers(count)});
  contest.contestants.push_back({"vtkExtractEnclosedPoints",
    [points](vtkPolyData* surface) -> vtkSmartPointer<vtkDataObject>
    {
      vtkNew<vtkExtractEnclosedPoints> extract;
      extract->SetInputData(points);
      extract->SetSurfaceData(surface);
      extract->Update();
      return extract->GetOutput();
    },
    fromNumbers(count)});
  return contest;
}

Contest distanceContest(const winding::Bounds& bounds, std::size_t count)
{
  const vtkSmartPointer<vtkPolyData> points = randomPoints(bounds, count);
  Contest contest = pointContest("distance", points);
  contest.isWrong = [](double answer, double w)
  {
    return (answer < 0) != (w >= 0.5);
  };
  contest.contestants.push_back({"vtkWindingNumberProbe",
    [points](vtkPolyData* surface) -> vtkSmartPointer<vtkDataObject>
    {
      vtkNew<vtkWindingNumberProbe> probe;
      probe->SetInputData(points);
      probe->SetSourceData(surface);
      probe->GenerateSignedDistanceOn();
      probe->Update();
      return probe->GetOutput();
    },
    fromArray("SignedDistance")});
  contest.contestants.push_back({"vtkImplicitPolyDataDistance",
    [points](vtkPolyData* surface) -> vtkSmartPointer<vtkDataObject>
    {
      vtkNew<vtkImplicitPolyDataDistance> distance;
      distance->SetInput(surface);
      vtkNew<vtkDoubleArray> values;
      values->SetName("SignedDistance");
      distance->FunctionValue(points->GetPoints()->GetData(), values);
      auto answer = vtkSmartPointer<vtkPolyData>::New();
      answer->SetPoints(points->GetPoints());
      answer->GetPointData()->AddArray(values);
      return answer;
    },
    fromArray("SignedDistance")});
  return contest;
}

Contest voxelContest(const winding::Bounds& bounds, int resolution)
{
  const winding::Grid grid = benchGrid(bounds, resolution);
  Contest contest;
  contest.question = "inside";
  contest.samples = sizeOf(grid);
  contest.count = winding::sampleCount(grid.wholeExtent());
  contest.sample = [grid](std::size_t number)
  {
    return grid.sample(number);
  };
  contest.isWrong = isWrongSide;
  contest.contestants.push_back({"vtkWindingNumberField",
    [resolution](vtkPolyData* surface) -> vtkSmartPointer<vtkDataObject>
    {
      vtkNew<vtkWindingNumberField> field;
      field->SetInputData(surface);
      field->SetResolution(resolution);
      field->GenerateWindingNumberOff();
      field->GenerateInsideOn();
      field->Update();
      return field->GetOutputDataObject(0);
    },
    fromArray("Inside")});
  contest.contestants.push_back({"vtkPolyDataToImageStencil",
    [grid](vtkPolyData* surface) -> vtkSmartPointer<vtkDataObject>
    {
      winding::Extent extent = grid.wholeExtent();
      vtkNew<vtkPolyDataToImageStencil> stencil;
      stencil->SetInputData(surface);
      stencil->SetOutputOrigin(grid.firstSample[0], grid.firstSample[1], grid.firstSample[2]);
      stencil->SetOutputSpacing(grid.spacing[0], grid.spacing[1], grid.spacing[2]);
      stencil->SetOutputWholeExtent(extent.data());
      stencil->Update();
      return stencil->GetOutput();
    },
    [](vtkDataObject* output)
    {
      vtkNew<vtkImageStencilToImage> image;
      image->SetInputData(vtkImageStencilData::SafeDownCast(output));
      image->Update();
      return fromArray(image->GetOutput()->GetPointData()->GetScalars()->GetName())(
        image->GetOutput());
    }});
  return contest;
}
