// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"
#include "vtk/PointProbe.h"
#include "vtk/SphereCloud.h"

#include "vtkDataSet.h"
#include "vtkImplicitWindingNumber.h"
#include "vtkSphereSource.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberNormals.h"
#include "vtkWindingNumberReport.h"
#include "vtkWindingNumberSurface.h"
#include "vtkWindingNumberVoxels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

/**
 * Numbers that are finite but out of range are refused with the value and the number of the point,
 * by every class.
 */

namespace
{

vtkSmartPointer<vtkPolyData> sphere(double size = 1)
{
  vtkNew<vtkSphereSource> source;
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkSmartPointer<vtkPolyData> mesh = source->GetOutput();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    mesh->GetPoints()->SetPoint(i, size * p[0], size * p[1], size * p[2]);
  }
  return mesh;
}

void expectOneLine(const std::string& errors, const std::string& mention)
{
  EXPECT_NE(errors.find(mention), std::string::npos) << errors;
  EXPECT_NE(errors.find("ERROR: "), std::string::npos) << errors;
  EXPECT_EQ(errors.find("ERROR: "), errors.rfind("ERROR: ")) << errors;
}

template <class Filter> void expectRefused(vtkDataObject* source, const std::string& mention)
{
  vtkNew<Filter> filter;
  SCOPED_TRACE(filter->GetClassName());
  ErrorLog log(filter);
  filter->SetInputDataObject(source);
  filter->Update();
  expectOneLine(log.errors(), mention);
  auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_TRUE(!output || output->GetNumberOfPoints() == 0);
}

void expectRefusedByProbeAndFunction(vtkDataObject* source, const std::string& mention)
{
  vtkNew<vtkWindingNumberProbe> probe;
  ErrorLog log(probe);
  probe->SetInputData(sphere());
  probe->SetSourceData(source);
  probe->Update();
  expectOneLine(log.errors(), mention);

  vtkNew<vtkImplicitWindingNumber> function;
  ErrorLog functionLog(function);
  function->SetInput(source);
  EXPECT_FALSE(function->BuildField());
  expectOneLine(functionLog.errors(), mention);
}

} // namespace

TEST(Ranges, CoordinatesOutOfRangeAreRefusedByEveryClass)
{
  for (const double bad : {1e101, -1e300})
  {
    const std::string mention = bad > 0 ? "point 7 lies at 1e+101" : "point 7 lies at -1e+300";
    auto mesh = sphere();
    double p[3];
    mesh->GetPoint(7, p);
    mesh->GetPoints()->SetPoint(7, bad, p[1], p[2]);
    auto cloud = sphereCloud(500, 1);
    cloud->GetPoints()->SetPoint(7, bad, 0, 0);
    for (vtkDataObject* source : {mesh.Get(), cloud.Get()})
    {
      expectRefused<vtkWindingNumberField>(source, mention);
      expectRefused<vtkWindingNumberSurface>(source, mention);
      expectRefused<vtkWindingNumberReport>(source, mention);
      expectRefused<vtkWindingNumberNormals>(source, mention);
      expectRefusedByProbeAndFunction(source, mention);
    }
  }
}

TEST(Ranges, SourcesThatAreTooSmallAreRefused)
{
  for (const auto& source : {sphere(1e-150), sphere(1e-300)})
  {
    expectRefused<vtkWindingNumberField>(source, "along its longest side");
    expectRefused<vtkWindingNumberReport>(source, "along its longest side");
    expectRefusedByProbeAndFunction(source, "along its longest side");
  }
}

TEST(Ranges, AreasOutOfRangeAreRefused)
{
  auto cloud = sphereCloud(500, 1);
  vtkNew<vtkDoubleArray> areas;
  areas->SetName("Area");
  areas->SetNumberOfTuples(500);
  areas->Fill(0.02);
  areas->SetValue(123, 1e200);
  cloud->GetPointData()->AddArray(areas);
  const std::string mention = "point 123 has the area 1e+200;";
  vtkNew<vtkWindingNumberField> field;
  {
    ErrorLog log(field);
    field->SetInputData(cloud);
    field->SetPointAreaMethod(vtkWindingNumberField::ARRAY);
    field->Update();
    expectOneLine(log.errors(), mention);
    field->RemoveAllObservers();
  }
  ErrorLog log(field);
  field->SetPointAreaMethod(vtkWindingNumberField::CONSTANT);
  field->SetPointArea(1e200);
  field->Update();
  expectOneLine(log.errors(), "PointArea is 1e+200;");
}

TEST(Ranges, GridsOutOfRangeAreRefused)
{
  vtkNew<vtkWindingNumberField> field;
  ErrorLog log(field);
  field->SetInputData(sphere());
  field->UseInputBoundsOff();
  field->SetSamplingBounds(-1, 1, -1e200, 1, -1, 1);
  field->Update();
  expectOneLine(
    log.errors(), "the grid reaches too far: scale the source down; it reaches to -3.9");
}

TEST(Ranges, SurfacesOfTheLargestSourcesHaveFinitePoints)
{
  vtkNew<vtkWindingNumberSurface> filter;
  for (const double size : {1e-99, 1e30, 1e60, 2e100})
  {
    filter->SetInputData(sphere(size));
    filter->Update();
    const double longest = filter->GetOutput()->GetLength();
    EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 1000) << size;
    EXPECT_NEAR(longest / size, std::sqrt(3.0), 0.1) << size;

    vtkNew<vtkWindingNumberField> field;
    field->SetInputData(sphere(size));
    field->SetResolution(16);
    vtkNew<vtkWindingNumberVoxels> voxels;
    voxels->SetInputConnection(field->GetOutputPort());
    voxels->Update();
    EXPECT_GT(voxels->GetOutput()->GetNumberOfCells(), 100) << size;
    EXPECT_NEAR(voxels->GetOutput()->GetLength() / size, std::sqrt(3.0), 0.2) << size;
  }
}

using RangesProbe = PointProbe;

TEST_F(RangesProbe, FarSamplesGetNothing)
{
  for (const int method : {vtkWindingNumberProbe::AUTOMATIC, vtkWindingNumberProbe::HIERARCHICAL,
         vtkWindingNumberProbe::DIRECT})
  {
    probe->SetMethod(method);
    for (const auto& source : {sphere(), sphereCloud(500, 1)})
    {
      for (const double far : {1e30, 1e150, -1e200, 1.7e308})
      {
        EXPECT_NEAR(this->windingNumber(source, far), 0, 1e-30);
        EXPECT_NEAR(this->windingNumber(source, 0, far, -far), 0, 1e-30);
      }
    }
  }
}
