// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtk/ErrorLog.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkMassProperties.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkWindingNumberNormals.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace spheres
{

inline constexpr double pi = 3.14159265358979323846;

/// A sphere of radius 1 with normals, in double precision.
inline vtkSmartPointer<vtkPolyData> sphere(double x = 0)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1);
  source->SetCenter(x, 0, 0);
  source->SetThetaResolution(60);
  source->SetPhiResolution(60);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

/// The points of the sphere without its triangles.
inline vtkSmartPointer<vtkPolyData> cloud(double x = 0)
{
  auto result = sphere(x);
  result->SetPolys(vtkSmartPointer<vtkCellArray>::New());
  return result;
}

inline double surfaceOf(vtkPolyData* mesh)
{
  vtkNew<vtkMassProperties> properties;
  properties->SetInputData(mesh);
  return properties->GetSurfaceArea();
}

/// The numbers of a data set's array, which must have a double for each point.
inline std::vector<double> areasIn(vtkDataObject* data, const char* name = "Area")
{
  auto* pointSet = vtkPointSet::SafeDownCast(data);
  auto* array =
    vtkDoubleArray::SafeDownCast(pointSet ? pointSet->GetPointData()->GetArray(name) : nullptr);
  if (!array || array->GetNumberOfComponents() != 1 ||
      array->GetNumberOfTuples() != pointSet->GetNumberOfPoints())
  {
    ADD_FAILURE() << "no array of areas";
    return {};
  }
  return {array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfTuples()};
}

inline double sumOf(const std::vector<double>& values)
{
  double sum = 0;
  for (const double value : values)
  {
    sum += value;
  }
  return sum;
}

} // namespace spheres

/// Areas of points, by a filter whose input a test may set.
class Normals : public testing::Test
{
protected:
  std::vector<double> areasOf(vtkDataObject* input)
  {
    filter->SetInputData(input);
    filter->Update();
    return spheres::areasIn(filter->GetOutput());
  }

  void expectRefused(vtkDataObject* input, const std::string& part)
  {
    ErrorLog log(filter);
    filter->SetInputData(input);
    filter->Update();
    EXPECT_NE(log.errors().find(part), std::string::npos) << log.errors();
    auto* output = vtkPointSet::SafeDownCast(filter->GetOutput());
    EXPECT_TRUE(!output || output->GetNumberOfPoints() == 0);
    EXPECT_EQ(filter->GetTotalArea(), 0);
  }

  vtkNew<vtkWindingNumberNormals> filter;
};
