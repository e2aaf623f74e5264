// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ImplicitFunctionInputs.h"

#include "vtkClipDataSet.h"
#include "vtkClipPolyData.h"
#include "vtkCutter.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkExtractGeometry.h"
#include "vtkImageData.h"
#include "vtkImplicitWindingNumber.h"
#include "vtkMath.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkSampleFunction.h"
#include "vtkTetra.h"
#include "vtkTriangle.h"
#include "vtkTriangleFilter.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWindingNumberField.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

/// A grid of cubes with sides of 0.1 around the sphere, whose centre is no point of the grid.
vtkSmartPointer<vtkImageData> grid()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(16, 16, 16);
  image->SetSpacing(0.1, 0.1, 0.1);
  image->SetOrigin(-0.76, -0.74, -0.73);
  return image;
}

vtkSmartPointer<vtkDataSet> tetrahedra(vtkDataSet* of)
{
  vtkNew<vtkDataSetTriangleFilter> filter;
  filter->SetInputData(of);
  filter->Update();
  vtkSmartPointer<vtkDataSet> result = filter->GetOutput();
  return result;
}

double volumeOf(vtkDataSet* cells)
{
  const auto tetrahedral = tetrahedra(cells);
  double volume = 0;
  for (vtkIdType i = 0; i < tetrahedral->GetNumberOfCells(); ++i)
  {
    double p[4][3];
    for (int corner = 0; corner < 4; ++corner)
    {
      tetrahedral->GetPoint(tetrahedral->GetCell(i)->GetPointId(corner), p[corner]);
    }
    volume += std::abs(vtkTetra::ComputeVolume(p[0], p[1], p[2], p[3]));
  }
  return volume;
}

/// Tests the function in VTK's own filters that take an implicit function.
class ImplicitFunction : public testing::Test
{
protected:
  vtkNew<vtkImplicitWindingNumber> function;
};

TEST_F(ImplicitFunction, ClipsVolumes)
{
  const double volume = vtkMath::Pi() / 6;
  function->SetInput(sphere());
  for (const auto& input : {vtkSmartPointer<vtkDataSet>(grid()), tetrahedra(grid())})
  {
    vtkNew<vtkClipDataSet> clip;
    clip->SetInputData(input);
    clip->SetClipFunction(function);
    clip->InsideOutOn();
    clip->Update();
    EXPECT_NEAR(volumeOf(clip->GetOutput()), volume, 0.05 * volume);
    clip->InsideOutOff();
    clip->Update();
    EXPECT_NEAR(volumeOf(clip->GetOutput()), 1.5 * 1.5 * 1.5 - volume, 0.05 * volume);
  }
}

TEST_F(ImplicitFunction, ClipsSurfaces)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1, -1, 0.01);
  plane->SetPoint1(1, -1, 0.01);
  plane->SetPoint2(-1, 1, 0.01);
  plane->SetResolution(57, 57);
  for (const auto& input : {sphere(), cloud()})
  {
    function->SetInput(input);
    vtkNew<vtkClipPolyData> clip;
    clip->SetInputConnection(plane->GetOutputPort());
    clip->SetClipFunction(function);
    clip->InsideOutOn();
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputConnection(clip->GetOutputPort());
    triangles->Update();
    double area = 0;
    for (vtkIdType i = 0; i < triangles->GetOutput()->GetNumberOfCells(); ++i)
    {
      double p[3][3];
      for (int corner = 0; corner < 3; ++corner)
      {
        triangles->GetOutput()->GetPoint(
          triangles->GetOutput()->GetCell(i)->GetPointId(corner), p[corner]);
      }
      area += vtkTriangle::TriangleArea(p[0], p[1], p[2]);
    }
    EXPECT_NEAR(area, vtkMath::Pi() / 4, 0.03 * vtkMath::Pi() / 4);
  }
}

TEST_F(ImplicitFunction, CutsWhereTheSurfaceIs)
{
  function->SetInput(sphere());
  for (const auto& input : {vtkSmartPointer<vtkDataSet>(grid()), tetrahedra(grid())})
  {
    vtkNew<vtkCutter> cutter;
    cutter->SetInputData(input);
    cutter->SetCutFunction(function);
    cutter->Update();
    vtkPolyData* cut = cutter->GetOutput();
    EXPECT_GT(cut->GetNumberOfPoints(), 300);
    for (vtkIdType i = 0; i < cut->GetNumberOfPoints(); ++i)
    {
      // Points lie half way along an edge or a diagonal of a cube, which is up to 0.17 long.
      EXPECT_NEAR(vtkMath::Norm(cut->GetPoint(i)), 0.5, 0.09);
    }
  }
}

TEST_F(ImplicitFunction, ExtractsTheCellsInside)
{
  function->SetInput(sphere(120));
  vtkNew<vtkExtractGeometry> extract;
  const auto image = grid();
  extract->SetInputData(image);
  extract->SetImplicitFunction(function);
  extract->Update();
  vtkIdType expected = 0;
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    bool isInside = true;
    for (int corner = 0; corner < 8; ++corner)
    {
      double p[3];
      image->GetPoint(image->GetCell(cell)->GetPointId(corner), p);
      isInside = isInside && function->FunctionValue(p) < 0;
    }
    expected += isInside;
  }
  EXPECT_GT(expected, 100);
  EXPECT_EQ(extract->GetOutput()->GetNumberOfCells(), expected);
}

TEST_F(ImplicitFunction, IsSampledAsTheFieldIs)
{
  for (const auto& input : someInputs())
  {
    vtkNew<vtkWindingNumberField> field;
    field->SetInputData(input);
    field->SetResolution(24);
    field->SetOutputScalarTypeToDouble();
    field->Update();
    vtkImageData* expected = field->GetOutput();
    function->SetInput(input);
    vtkNew<vtkSampleFunction> sample;
    sample->SetImplicitFunction(function);
    sample->SetModelBounds(expected->GetBounds());
    sample->SetSampleDimensions(expected->GetDimensions());
    sample->ComputeNormalsOff();
    sample->Update();
    vtkDataArray* values = sample->GetOutput()->GetPointData()->GetScalars();
    vtkDataArray* w = expected->GetPointData()->GetScalars();
    ASSERT_EQ(values->GetNumberOfTuples(), w->GetNumberOfTuples());
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      ASSERT_NEAR(values->GetTuple1(i), 0.5 - w->GetTuple1(i), 2e-3) << i;
    }
    // A new input reaches what lies downstream.
    function->SetInput(sphere(180, 0.5, 9));
    sample->Update();
    values = sample->GetOutput()->GetPointData()->GetScalars();
    EXPECT_NEAR(values->GetRange()[0], 0.5, 1e-3);
  }
}

} // namespace
