// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/RealMeshes.h"
#include "vtk/Backends.h"
#include "vtk/ReadMesh.h"
#include "vtk/SphereCloud.h"
#include "vtk/Spheres.h"
#include "vtk/SurfaceMeasures.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointLocator.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkTriangle.h"
#include "vtkTriangleFilter.h"
#include "vtkWindingNumberSurface.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace
{

/// A prism over a polygon, with its corners: a machine part of known edges.
struct Part
{
  std::string name;
  std::vector<std::array<double, 2>> outline;
  double height;
  double volume;
};

std::vector<Part> parts()
{
  std::vector<std::array<double, 2>> gear;
  for (int n = 0; n < 24; ++n)
  {
    const double radius = n % 4 < 2 ? 1 : 0.7, angle = n * vtkMath::Pi() / 12;
    gear.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  double area = 0;
  for (std::size_t n = 0; n < gear.size(); ++n)
  {
    const auto &a = gear[n], &b = gear[(n + 1) % gear.size()];
    area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return {{"cube", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1, 1},
    {"bracket", {{0, 0}, {2, 0}, {2, 0.5}, {0.5, 0.5}, {0.5, 1.5}, {0, 1.5}}, 0.7, 0.7 * 1.5},
    {"prism", {{0, 0}, {2, 0}, {1, 1.7}}, 1, 1.7}, {"gear", gear, 0.5, 0.5 * area}};
}

/// The part, turned about anything.
vtkSmartPointer<vtkPolyData> turned(const Part& part, unsigned seed)
{
  vtkNew<vtkPolyData> solid;
  vtkNew<vtkPoints> corners;
  corners->SetDataTypeToDouble();
  const auto count = static_cast<vtkIdType>(part.outline.size());
  for (const double z : {0.0, part.height})
  {
    for (const auto& corner : part.outline)
    {
      corners->InsertNextPoint(corner[0], corner[1], z);
    }
  }
  vtkNew<vtkCellArray> faces;
  faces->InsertNextCell(static_cast<int>(count));
  for (vtkIdType n = count; n-- > 0;)
  {
    faces->InsertCellPoint(n);
  }
  faces->InsertNextCell(static_cast<int>(count));
  for (vtkIdType n = 0; n < count; ++n)
  {
    faces->InsertCellPoint(count + n);
  }
  for (vtkIdType n = 0; n < count; ++n)
  {
    const vtkIdType next = (n + 1) % count;
    const vtkIdType side[4] = {n, next, count + next, count + n};
    faces->InsertNextCell(4, side);
  }
  solid->SetPoints(corners);
  solid->SetPolys(faces);
  std::mt19937 random(seed);
  const auto number = [&random]
  {
    return static_cast<double>(random()) / 4294967296.0;
  };
  vtkNew<vtkTransform> transform;
  transform->RotateWXYZ(360 * number(), number() - 0.5, number() - 0.5, number() - 0.5);
  transform->Translate(number(), number(), number());
  vtkNew<vtkTransformPolyDataFilter> result;
  // Caps that are not convex are no fans of triangles.
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(solid);
  result->SetInputConnection(triangles->GetOutputPort());
  result->SetTransform(transform);
  result->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  result->Update();
  return result->GetOutput();
}

std::array<std::array<double, 3>, 3> cornersOf(vtkPolyData* surface, vtkIdType triangle)
{
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  surface->GetCellPoints(triangle, count, ids);
  std::array<std::array<double, 3>, 3> corners = {};
  for (vtkIdType n = 0; n < std::min<vtkIdType>(count, 3); ++n)
  {
    surface->GetPoint(ids[n], corners[static_cast<std::size_t>(n)].data());
  }
  return corners;
}

/// Returns the lengths of the common side of a triangle and the next one, and of the other diagonal
/// of the quad that they make; none if it is no flat and convex quad.
std::optional<std::array<double, 2>> diagonalsOfFlat(vtkPolyData* surface, vtkIdType triangle)
{
  const auto a = cornersOf(surface, triangle), b = cornersOf(surface, triangle + 1);
  for (std::size_t m = 0; m < 3; ++m)
  {
    for (std::size_t n = 0; n < 3; ++n)
    {
      const auto &from = a[m], &to = a[(m + 1) % 3], &third = a[(m + 2) % 3];
      const auto& other = b[(n + 2) % 3];
      if (from != b[(n + 1) % 3] || to != b[n])
      {
        continue;
      }
      double normals[4][3];
      vtkTriangle::ComputeNormal(from.data(), to.data(), third.data(), normals[0]);
      vtkTriangle::ComputeNormal(to.data(), from.data(), other.data(), normals[1]);
      vtkTriangle::ComputeNormal(third.data(), other.data(), to.data(), normals[2]);
      vtkTriangle::ComputeNormal(other.data(), third.data(), from.data(), normals[3]);
      const bool isFlat = vtkMath::Dot(normals[0], normals[1]) > 1 - 1e-9;
      const bool isConvex = vtkMath::Dot(normals[2], normals[0]) > 1 - 1e-9 &&
                            vtkMath::Dot(normals[3], normals[0]) > 1 - 1e-9;
      if (isFlat && isConvex)
      {
        return std::array<double, 2>{
          std::sqrt(vtkMath::Distance2BetweenPoints(from.data(), to.data())),
          std::sqrt(vtkMath::Distance2BetweenPoints(third.data(), other.data()))};
      }
    }
  }
  return std::nullopt;
}

class SharpSurfaces : public testing::Test
{
protected:
  SharpSurfaces()
  {
    filter->SetFeatures(vtkWindingNumberSurface::SHARP);
    filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    filter->SetResolution(64);
  }

  vtkPolyData* update(vtkDataObject* source)
  {
    filter->SetInputDataObject(source);
    filter->Update();
    EXPECT_EQ(filter->GetStatus(), vtkWindingNumberSurface::DONE);
    return filter->GetOutput();
  }

  double figure(const char* name)
  {
    return filter->GetOutput()->GetFieldData()->GetArray(name)->GetTuple1(0);
  }

  static void expectClosed(vtkPolyData* surface)
  {
    EXPECT_GT(surface->GetNumberOfCells(), 0);
    const EdgeCounts edges = countEdges(surface);
    EXPECT_EQ(edges.open, 0);
    EXPECT_EQ(edges.nonManifold, 0);
  }

  vtkNew<vtkWindingNumberSurface> filter;
};

} // namespace

TEST_F(SharpSurfaces, KeepEdgesAndCornersOfTurnedParts)
{
  filter->SetFidelitySamples(20000);
  for (const Part& part : parts())
  {
    for (unsigned seed = 0; seed < 8; ++seed)
    {
      SCOPED_TRACE(part.name + " turned by seed " + std::to_string(seed));
      const auto solid = turned(part, seed);
      vtkPolyData* surface = this->update(solid);
      this->expectClosed(surface);
      const double voxel = voxelOf(filter);
      // Measured: 0.56, 0.4, 0.0031, 0.0008.
      EXPECT_LT(figure("LargestDistanceFromInput"), 0.6 * voxel);
      EXPECT_LT(figure("LargestDistanceToInput"), 0.5 * voxel);
      EXPECT_LT(figure("MeanDistanceFromInput"), 0.004 * voxel);
      EXPECT_NEAR(figure("InputVolume"), part.volume, 1e-9);
      EXPECT_NEAR(figure("Volume"), part.volume, 0.001 * part.volume);
      EXPECT_EQ(figure("SelfIntersections"), 0);
      EXPECT_EQ(figure("LostComponents"), 0);
      vtkNew<vtkPointLocator> locator;
      locator->SetDataSet(surface);
      locator->BuildLocator();
      double farthest = 0;
      for (vtkIdType corner = 0; corner < solid->GetNumberOfPoints(); ++corner)
      {
        double at[3], nearest[3];
        solid->GetPoint(corner, at);
        surface->GetPoint(locator->FindClosestPoint(at), nearest);
        farthest = std::max(farthest, std::sqrt(vtkMath::Distance2BetweenPoints(at, nearest)));
      }
      EXPECT_LT(farthest, 0.75 * voxel); // measured: 0.67, where a cell does not see all planes
    }
  }
}

TEST_F(SharpSurfaces, AreNearerToPartsThanSmoothOnes)
{
  filter->SetFidelitySamples(20000);
  for (const Part& part : parts())
  {
    this->update(turned(part, 3));
    const double sharp = figure("MeanDistanceFromInput"), sharpVolume = figure("Volume");
    filter->SetFeatures(vtkWindingNumberSurface::SMOOTH);
    this->update(turned(part, 3));
    // Measured: 5 to 20 times as far.
    EXPECT_LT(4 * sharp, figure("MeanDistanceFromInput")) << part.name;
    EXPECT_LT(std::abs(sharpVolume - part.volume), std::abs(figure("Volume") - part.volume));
    filter->SetFeatures(vtkWindingNumberSurface::SHARP);
  }
}

TEST_F(SharpSurfaces, HaveQuadsOrTrianglesWithOutwardNormals)
{
  const auto sphere = sphereOf(40, 40, 1);
  for (const bool areTriangles : {false, true})
  {
    filter->SetGenerateTriangles(areTriangles);
    vtkPolyData* surface = this->update(sphere);
    this->expectClosed(surface);
    EXPECT_EQ(surface->GetPointData()->GetNormals(), nullptr);
    vtkDataArray* normals = surface->GetCellData()->GetNormals();
    ASSERT_NE(normals, nullptr);
    vtkIdType quads = 0, turned = 0;
    for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      surface->GetCellPoints(cell, count, ids);
      quads += count == 4;
      double middle[3];
      surface->GetPoint(ids[0], middle);
      vtkMath::Normalize(middle);
      // Measured: 0.68, at slivers.
      const double along = vtkMath::Dot(normals->GetTuple3(cell), middle);
      EXPECT_GT(along, 0.5);
      turned += along < 0.95;
    }
    EXPECT_LE(turned, surface->GetNumberOfCells() / 200); // measured: 1 of 260
    EXPECT_EQ(areTriangles, quads == 0);
    EXPECT_GE(quads, areTriangles ? 0 : surface->GetNumberOfCells() * 9 / 10);
    filter->GenerateNormalsOff();
    EXPECT_EQ(this->update(sphere)->GetCellData()->GetNormals(), nullptr);
    filter->GenerateNormalsOn();
  }
}

TEST_F(SharpSurfaces, OfVoxelsWithThreeSidesKeepPlanesNormalsAndShortDiagonals)
{
  filter->SetFidelitySamples(20000);
  filter->SetGenerateTriangles(true);
  const vtkSmartPointer<vtkPolyData> solid = turned(parts()[2], 3);
  for (const auto& voxels : {std::array<int, 3>{18, 37, 75}, {75, 18, 37}, {37, 75, 18}})
  {
    SCOPED_TRACE(std::to_string(voxels[0]) + " voxels along x");
    filter->SetSamplingDimensions(voxels.data());
    vtkPolyData* surface = this->update(solid);
    this->expectClosed(surface);
    EXPECT_LT(figure("MeanDistanceFromInput"), 0.0055 * voxelOf(filter)); // measured: 0.0044
    EXPECT_EQ(figure("LostComponents"), 0);
    vtkDataArray* const normals = surface->GetCellData()->GetNormals();
    vtkIdType longer = 0, flat = 0;
    for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
    {
      const std::array<std::array<double, 3>, 3> corners = cornersOf(surface, cell);
      double normal[3];
      vtkTriangle::ComputeNormal(corners[0].data(), corners[1].data(), corners[2].data(), normal);
      if (vtkTriangle::TriangleArea(corners[0].data(), corners[1].data(), corners[2].data()) > 1e-9)
      {
        EXPECT_GT(vtkMath::Dot(normal, normals->GetTuple3(cell)), 0.9999);
      }
    }
    // Two triangles follow each other in a quad. Where it is flat, its shorter diagonal is taken.
    for (vtkIdType cell = 0; cell + 1 < surface->GetNumberOfCells(); cell += 2)
    {
      const std::optional<std::array<double, 2>> lengths = diagonalsOfFlat(surface, cell);
      flat += lengths.has_value();
      longer += lengths && (*lengths)[0] > (1 + 1e-6) * (*lengths)[1];
    }
    EXPECT_GT(flat, 3000); // measured: 3844
    EXPECT_LE(longer, 10); // measured: 3, of quads in planes up to rounding
  }
}

/// A part is lost where the surface is farther than half of the longest side of a voxel.
TEST_F(SharpSurfaces, OfVoxelsWithThreeSidesLoseNoPartThatTheyShow)
{
  filter->SetFidelitySamples(1000);
  filter->UseInputBoundsOff();
  filter->SetSamplingBounds(-0.5, 1.5, -0.5, 1.5, -0.5, 1.5);
  for (int turn = 0; turn < 3; ++turn)
  {
    // A plate at 45 degrees is seen at three layers of the coarse samples. Its corners, and the
    // middles of its triangles, lie a quarter of the way between two layers.
    vtkNew<vtkPoints> points;
    for (int corner = 0; corner < 8; ++corner)
    {
      const double along = 0.75 * (corner / 2 % 2);
      const double place[3] = {along + 0.05 * (corner % 2), 0.8 * (corner / 4), along + 0.0625};
      double turned[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        turned[(axis + turn) % 3] = place[axis];
      }
      points->InsertNextPoint(turned);
    }
    vtkNew<vtkCellArray> triangles;
    for (const auto& ids : {std::array<vtkIdType, 3>{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6},
           {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}})
    {
      triangles->InsertNextCell({ids[0], ids[2], ids[1]});
    }
    vtkNew<vtkPolyData> plate;
    plate->SetPoints(points);
    plate->SetPolys(triangles);
    const int counts[3] = {100, 50, 8};
    int voxels[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      voxels[(axis + turn) % 3] = counts[axis];
    }
    filter->SetSamplingDimensions(voxels);
    vtkPolyData* surface = this->update(plate);
    EXPECT_GT(surface->GetNumberOfCells(), 0);
    EXPECT_EQ(figure("InputComponents"), 1);
    EXPECT_EQ(figure("LostComponents"), 0);
  }
}

TEST_F(SharpSurfaces, AreClosedAtTheBorderByPlanes)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(2);
  sphere->Update();
  filter->UseInputBoundsOff();
  filter->SetSamplingBounds(-1, 1, -1, 1, -1, 1);
  filter->SetResolution(10);
  filter->CloseBorderOn();
  filter->SetFidelitySamples(100);
  vtkPolyData* surface = this->update(sphere->GetOutput());
  this->expectClosed(surface);
  // The grid's corners come closer to the sphere than one voxel, but not out of it.
  EXPECT_NEAR(figure("Volume"), 8, 1e-9);
  EXPECT_EQ(figure("SelfIntersections"), 0);
}

TEST_F(SharpSurfaces, OfOpenAndOfScatteredSourcesAreClosed)
{
  filter->SetFidelitySamples(1000);
  this->expectClosed(this->update(sphereOf(40, 40, 0.5, {}, 140))); // a hole at one pole
  EXPECT_TRUE(std::isnan(figure("InputVolume")));
  EXPECT_LT(figure("MeanDistanceFromInput"), 0.05 * voxelOf(filter));
  this->expectClosed(this->update(sphereCloud(2000, 1)));
  EXPECT_EQ(figure("InputComponents"), 0);
  EXPECT_NEAR(figure("Volume"), 4.0 / 3 * vtkMath::Pi(), 0.1);
}

TEST_F(SharpSurfaces, AreTheSameForAnyNumberOfThreads)
{
  const auto solid = turned(parts().back(), 5);
  filter->SetNumberOfThreads(1);
  vtkNew<vtkPolyData> expected;
  expected->DeepCopy(this->update(solid));
  onEachBackend(
    [&](const char* backend)
    {
      for (const int threads : {2, 3})
      {
        SCOPED_TRACE(backend);
        filter->SetNumberOfThreads(threads);
        filter->Modified();
        vtkPolyData* surface = this->update(solid);
        ASSERT_EQ(surface->GetNumberOfPoints(), expected->GetNumberOfPoints());
        ASSERT_EQ(surface->GetNumberOfCells(), expected->GetNumberOfCells());
        for (vtkIdType n = 0; n < surface->GetNumberOfPoints(); ++n)
        {
          for (int axis = 0; axis < 3; ++axis)
          {
            ASSERT_EQ(surface->GetPoint(n)[axis], expected->GetPoint(n)[axis]);
          }
        }
      }
    });
}

TEST_F(SharpSurfaces, WithoutAnythingInsideAreEmptyAndCompareNothing)
{
  vtkNew<vtkPolyData> nothing;
  filter->SetFidelitySamples(10);
  vtkPolyData* surface = this->update(nothing);
  EXPECT_EQ(surface->GetNumberOfCells(), 0);
  EXPECT_EQ(figure("LargestDistanceFromInput"), 0);
  EXPECT_EQ(figure("Volume"), 0);
}

/// Two cubes, of which one is smaller than a voxel and in none of its samples.
TEST_F(SharpSurfaces, TellWhatVoxelsLose)
{
  vtkNew<vtkPolyData> both;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> faces;
  const auto add = [&](double low, double high)
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetBounds(low, high, low, high, low, high);
    cube->Update();
    const vtkIdType first = points->GetNumberOfPoints();
    for (vtkIdType n = 0; n < cube->GetOutput()->GetNumberOfPoints(); ++n)
    {
      points->InsertNextPoint(cube->GetOutput()->GetPoint(n));
    }
    for (vtkIdType cell = 0; cell < cube->GetOutput()->GetNumberOfCells(); ++cell)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      cube->GetOutput()->GetCellPoints(cell, count, ids);
      faces->InsertNextCell(static_cast<int>(count));
      for (vtkIdType n = 0; n < count; ++n)
      {
        faces->InsertCellPoint(first + ids[n]);
      }
    }
  };
  add(0, 1);
  add(1.58, 1.582);
  both->SetPoints(points);
  both->SetPolys(faces);
  filter->SetResolution(16);
  filter->SetFidelitySamples(1000);
  this->update(both);
  EXPECT_EQ(figure("InputComponents"), 2);
  EXPECT_EQ(figure("LostComponents"), 1);
}

namespace
{

struct SharedCad
{
  const char* name;
  double mean, largest; ///< distances of the input from the surface, in voxels
};

class SharpSurfacesOfSharedData : public testing::TestWithParam<SharedCad>
{
};

} // namespace

/// Inner faces of self_intersectA are in no surface of what it encloses.
TEST_P(SharpSurfacesOfSharedData, AreClosedAndDoNotIntersectThemselves)
{
  vtkNew<vtkWindingNumberSurface> filter;
  filter->SetInputData(readMesh(shapes::realMesh(GetParam().name)));
  filter->SetFeatures(vtkWindingNumberSurface::SHARP);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->SetResolution(128);
  filter->SetFidelitySamples(50000);
  filter->Update();
  const EdgeCounts edges = countEdges(filter->GetOutput());
  EXPECT_EQ(edges.open, 0);
  EXPECT_EQ(edges.nonManifold, 0);
  vtkFieldData* data = filter->GetOutput()->GetFieldData();
  EXPECT_EQ(data->GetArray("SelfIntersections")->GetTuple1(0), 0);
  const double voxel = voxelOf(filter);
  EXPECT_LT(data->GetArray("MeanDistanceFromInput")->GetTuple1(0), GetParam().mean * voxel);
  EXPECT_LT(data->GetArray("LargestDistanceFromInput")->GetTuple1(0), GetParam().largest * voxel);
  EXPECT_LT(data->GetArray("LargestDistanceToInput")->GetTuple1(0), 0.55 * voxel);
}

// Measured: 0.0004 and 0.49, 0.0000 and 0.06, 0.0004 and 0.03, 0.1 and 6, 0.01 and 0.3.
INSTANTIATE_TEST_SUITE_P(OfSharedData, SharpSurfacesOfSharedData,
  testing::ValuesIn(shapes::present(
    {SharedCad{"tray_thin_cad.stl", 0.0008, 0.55}, SharedCad{"icosahedron.stl", 0.0001, 0.12},
      SharedCad{"sphere_quads.obj", 0.0008, 0.06}, SharedCad{"self_intersectA.obj", 0.15, 8},
      SharedCad{"bunny_70k.obj", 0.012, 0.4}},
    [](const SharedCad& mesh) { return mesh.name; })),
  [](const auto& mesh) { return shapes::testNameOf(mesh.param.name); });
