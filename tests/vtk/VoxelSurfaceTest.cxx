// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/Backends.h"
#include "vtk/ErrorLog.h"
#include "vtk/Spheres.h"
#include "vtk/SurfaceMeasures.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindingNumberBoolean.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberSurface.h"
#include "vtkWindingNumberVoxels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace
{

/// A side of a voxel: its middle in halves of the spacing from the middle of the first voxel, and
/// the direction that it looks in, as axis and sign.
using Side = std::array<long, 5>;

/// The sides that the polygons of a surface are, sorted. `first` and `spacing` are the grid's.
std::vector<Side> sidesOf(
  vtkPolyData* surface, const std::array<double, 3>& first, const double* spacing)
{
  std::vector<Side> sides;
  for (vtkIdType id = 0; id < surface->GetNumberOfCells(); ++id)
  {
    vtkCell* const quad = surface->GetCell(id);
    EXPECT_EQ(quad->GetNumberOfPoints(), 4);
    double corners[4][3];
    std::array<double, 3> middle = {};
    for (int corner = 0; corner < 4; ++corner)
    {
      quad->GetPoints()->GetPoint(corner, corners[corner]);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        middle[axis] += corners[corner][axis] / 4;
      }
    }
    Side side = {};
    double normal[3];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      side[axis] = std::lround(2 * (middle[axis] - first[axis]) / spacing[axis]);
      const std::size_t second = (axis + 1) % 3, third = (axis + 2) % 3;
      const auto along = [&corners](int corner, std::size_t of)
      {
        return corners[corner][of] - corners[0][of];
      };
      normal[axis] = along(1, second) * along(2, third) - along(1, third) * along(2, second);
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double across = spacing[(axis + 1) % 3] * spacing[(axis + 2) % 3];
      const long sign = std::lround(normal[axis] / across);
      if (sign != 0)
      {
        side[3] = static_cast<long>(axis);
        side[4] += sign; // of one axis only
      }
    }
    EXPECT_EQ(std::abs(side[4]), 1);
    sides.push_back(side);
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// Expects the quads that vtkWindingNumberVoxels makes of the field of the same grid. Returns the
/// number of points that repeat others.
vtkIdType expectVoxelsOfTheField(vtkPolyData* source, double threshold)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputData(source);
  field->SetSamplingDimensions(17, 23, 12);
  field->Update();
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputConnection(field->GetOutputPort());
  voxels->SetWindingThreshold(threshold);
  voxels->Update();
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputData(source);
  surface->SetSamplingDimensions(17, 23, 12);
  surface->SetWindingThreshold(threshold);
  surface->SetFeatures(vtkWindingNumberSurface::VOXELS);
  surface->CloseBorderOn();
  surface->Update();
  std::array<double, 3> first;
  field->GetOutput()->GetOrigin(first.data());
  const double* const spacing = field->GetOutput()->GetSpacing();
  const auto made = sidesOf(surface->GetOutput(), first, spacing);
  EXPECT_GT(made.size(), 100);
  EXPECT_TRUE(made == sidesOf(voxels->GetOutput(), first, spacing));
  const EdgeCounts edges = countEdges(surface->GetOutput());
  EXPECT_EQ(edges.open, 0);
  EXPECT_EQ(edges.nonManifold, 0);
  return surface->GetOutput()->GetNumberOfPoints() - voxels->GetOutput()->GetNumberOfPoints();
}

vtkSmartPointer<vtkPolyData> sphereUpTo(double endPhi)
{
  return sphereOf(40, 40, 0.5, {}, endPhi);
}

vtkSmartPointer<vtkPolyData> cubeOf(double x0, double x1)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(x0, x1, 0, 1, 0, 1);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cube->GetOutputPort());
  triangles->Update();
  return triangles->GetOutput();
}

TEST(VoxelSurfaces, AreTheVoxelsOfTheField)
{
  expectVoxelsOfTheField(sphereUpTo(180), 0.5);
  expectVoxelsOfTheField(sphereUpTo(120), 0.4);
}

/// Random triangles around a low threshold leave voxels that touch at edges and corners only.
TEST(VoxelSurfaces, AreManifoldWhereVoxelsTouchAtEdges)
{
  std::mt19937 random(5);
  vtkNew<vtkPoints> corners;
  vtkNew<vtkCellArray> triangles;
  const auto place = [&random]
  {
    return static_cast<double>(random()) / 4294967296.0;
  };
  for (vtkIdType id = 0; id < 300; id += 3)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const double x = place(), y = place();
      corners->InsertNextPoint(x, y, place());
    }
    triangles->InsertNextCell({id, id + 1, id + 2});
  }
  vtkNew<vtkPolyData> soup;
  soup->SetPoints(corners);
  soup->SetPolys(triangles);
  const vtkIdType repeated = expectVoxelsOfTheField(soup, 0.3);
  EXPECT_GT(repeated, 10);
}

TEST(VoxelSurfaces, GetTrianglesAndNormals)
{
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputData(sphereUpTo(180));
  surface->SetResolution(20);
  surface->SetFeatures(vtkWindingNumberSurface::VOXELS);
  surface->Update();
  const vtkIdType quads = surface->GetOutput()->GetNumberOfCells();
  vtkDataArray* const normals = surface->GetOutput()->GetCellData()->GetNormals();
  ASSERT_NE(normals, nullptr);
  for (vtkIdType i = 0; i < quads; ++i)
  {
    const double* const normal = normals->GetTuple3(i);
    EXPECT_EQ(std::abs(normal[0]) + std::abs(normal[1]) + std::abs(normal[2]), 1);
  }
  surface->GenerateTrianglesOn();
  surface->Update();
  EXPECT_EQ(surface->GetOutput()->GetNumberOfCells(), 2 * quads);
}

/// The cube of side 1 moved outward by 0.3: its samples, 0.1 apart, are inside as distances say.
TEST(VoxelSurfaces, OfOffsets)
{
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputData(cubeOf(0, 1));
  surface->SetVoxelSize(0.1);
  surface->UseInputBoundsOff();
  surface->SetSamplingBounds(-1, 2, -1, 2, -1, 2);
  surface->SetFeatures(vtkWindingNumberSurface::VOXELS);
  surface->GenerateTrianglesOn();
  surface->SetOffset(0.3);
  surface->Update();
  int inside = 0;
  for (int n = 0; n < 30 * 30 * 30; ++n)
  {
    const int index[3] = {n % 30, n / 30 % 30, n / 900};
    double square = 0;
    for (const int i : index)
    {
      const double place = -0.95 + 0.1 * i;
      const double beyond = std::max({0.0, -place, place - 1});
      square += beyond * beyond;
    }
    inside += square < 0.09;
  }
  EXPECT_NEAR(signedVolume(surface->GetOutput()), inside * 0.001, 1e-6);
}

TEST(VoxelSurfaces, OfBooleansSayWhoseTheyAre)
{
  vtkNew<vtkWindingNumberBoolean> boolean;
  boolean->SetInputDataObject(0, cubeOf(0, 1));
  boolean->SetInputDataObject(1, cubeOf(0.5, 1.5));
  boolean->SetOperationToDifference();
  boolean->SetVoxelSize(0.1);
  boolean->UseInputBoundsOff();
  boolean->SetSamplingBounds(-1, 2, -1, 2, -1, 2);
  boolean->SetFeatures(vtkWindingNumberBoolean::VOXELS);
  boolean->GenerateTrianglesOn();
  boolean->Update();
  vtkPolyData* const surface = boolean->GetOutput();
  EXPECT_NEAR(signedVolume(surface), 0.5, 1e-6);
  ASSERT_EQ(surface->GetNumberOfCells(), 2 * (2 * 100 + 4 * 50));
  vtkDataArray* const operands = surface->GetCellData()->GetArray("Operand");
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    double bounds[6];
    surface->GetCellBounds(i, bounds);
    const bool isOfSecond = bounds[0] > 0.499 && bounds[1] < 0.501;
    EXPECT_EQ(operands->GetTuple1(i), isOfSecond ? 1 : 0);
  }
}

/// A random sphere with a hole, and a box, on grids of three spacings.
class ImagesOfSolids : public testing::Test
{
protected:
  static void layGrid(vtkWindingNumberGridAlgorithm* filter)
  {
    filter->SetSamplingDimensions(17, 23, 12);
    filter->UseInputBoundsOff();
    filter->SetSamplingBounds(-1, 2, -0.75, 1.5, -1, 1);
  }

  /// The answers of vtkWindingNumberField at the samples.
  static std::vector<unsigned char> insideOf(vtkPolyData* source)
  {
    vtkNew<vtkWindingNumberField> field;
    field->SetInputData(source);
    layGrid(field);
    field->GenerateInsideOn();
    field->Update();
    return bytesOf(field->GetOutput());
  }

  static std::vector<unsigned char> bytesOf(vtkImageData* image)
  {
    auto* const array =
      vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetArray("Inside"));
    EXPECT_NE(array, nullptr);
    return array ? std::vector<unsigned char>(
                     array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfTuples())
                 : std::vector<unsigned char>();
  }

  const vtkSmartPointer<vtkPolyData> scan = sphereUpTo(120), box = cubeOf(0.2, 1.2);
};

TEST_F(ImagesOfSolids, AreWhatTheFieldSays)
{
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputData(scan);
  layGrid(surface);
  surface->Update();
  EXPECT_EQ(surface->GetImage()->GetNumberOfPoints(), 0);
  surface->GenerateImageOn();
  surface->Update();
  EXPECT_EQ(bytesOf(surface->GetImage()), insideOf(scan));
  EXPECT_GT(surface->GetOutput()->GetNumberOfCells(), 0);
}

TEST_F(ImagesOfSolids, FollowTheOperation)
{
  const auto a = insideOf(scan), b = insideOf(box);
  vtkNew<vtkWindingNumberBoolean> boolean;
  boolean->SetInputDataObject(0, scan);
  boolean->SetInputDataObject(1, box);
  boolean->GenerateImageOn();
  layGrid(boolean);
  for (int operation = 0; operation < 4; ++operation)
  {
    boolean->SetOperation(operation);
    boolean->Update();
    const auto made = bytesOf(boolean->GetImage());
    ASSERT_EQ(made.size(), a.size());
    std::size_t wrong = 0;
    for (std::size_t n = 0; n < a.size(); ++n)
    {
      const int results[] = {a[n] | b[n], a[n] & b[n], a[n] & ~b[n], a[n] ^ b[n]};
      wrong += made[n] != results[operation];
    }
    EXPECT_EQ(wrong, 0) << operation;
  }
}

/// The pipeline learns of the grid before there are data, and filters of images go on from there.
TEST_F(ImagesOfSolids, GoThroughThePipeline)
{
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputData(box);
  surface->SetResolution(20);
  surface->SetOffset(0.2);
  surface->GenerateImageOn();
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputConnection(surface->GetOutputPort(1));
  voxels->Update();
  surface->SetFeatures(vtkWindingNumberSurface::VOXELS);
  surface->Update();
  const double* const spacing = surface->GetImage()->GetSpacing();
  std::array<double, 3> first;
  surface->GetImage()->GetOrigin(first.data());
  const auto sides = sidesOf(voxels->GetOutput(), first, spacing);
  EXPECT_GT(sides.size(), 100);
  EXPECT_TRUE(sides == sidesOf(surface->GetOutput(), first, spacing));
  surface->SetInputData(cubeOf(0, 3)); // another grid
  voxels->Update();
  int extent[6];
  surface->GetImage()->GetExtent(extent);
  EXPECT_EQ(extent[1], 19);
  EXPECT_NEAR(signedVolume(voxels->GetOutput()), signedVolume(surface->GetOutput()), 1e-5);
}

TEST_F(ImagesOfSolids, AreEmptyAfterErrors)
{
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputData(box);
  surface->GenerateImageOn();
  surface->Update();
  EXPECT_GT(surface->GetImage()->GetNumberOfPoints(), 0);
  surface->SetVoxelSize(-1);
  const ErrorLog log(surface);
  surface->Update();
  EXPECT_NE(log.errors(), "");
  EXPECT_EQ(surface->GetImage()->GetNumberOfPoints(), 0);
}

} // namespace
