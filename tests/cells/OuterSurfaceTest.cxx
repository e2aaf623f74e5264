// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cells/FieldOfCells.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypeSource.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

namespace
{

using Map = std::function<void(double*)>;

/// Returns the cube [0, 2]³ as cells of a type, with its points moved.
vtkSmartPointer<vtkUnstructuredGrid> cubeOf(int cellType, const Map& map, int order = 2)
{
  vtkNew<vtkCellTypeSource> source;
  source->SetCellType(cellType);
  source->SetCellOrder(order);
  source->SetBlocksDimensions(2, 2, 2);
  source->SetOutputPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkSmartPointer<vtkUnstructuredGrid> cube = source->GetOutput();
  for (vtkIdType i = 0; i < cube->GetNumberOfPoints(); ++i)
  {
    double point[3];
    cube->GetPoint(i, point);
    map(point);
    cube->GetPoints()->SetPoint(i, point);
  }
  return cube;
}

void stay(double*) {}

void mirror(double* point)
{
  point[0] = 2 - point[0];
}

/// Bends the side at x = 2, so that the volume becomes 11.2. Cells of degree 2 can follow.
void bend(double* point)
{
  point[0] *= 1 + 0.3 * point[1] * point[1];
}

void bendAndMirror(double* point)
{
  bend(point);
  point[0] = -point[0];
}

/// Returns a grid with the nodes of every other cell in another order.
vtkSmartPointer<vtkUnstructuredGrid> withEveryOtherReordered(
  vtkUnstructuredGrid* grid, const std::vector<int>& order)
{
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result->SetPoints(grid->GetPoints());
  result->Allocate(grid->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    grid->GetCellPoints(cell, ids);
    std::vector<vtkIdType> nodes(ids->begin(), ids->end());
    if (cell % 2 == 1)
    {
      std::transform(
        order.begin(), order.end(), nodes.begin(), [&](int node) { return ids->GetId(node); });
    }
    result->InsertNextCell(
      grid->GetCellType(cell), static_cast<vtkIdType>(nodes.size()), nodes.data());
  }
  return result;
}

// VTK's source of cells has no voxels, no cells of both degrees, and prisms that leave gaps.
const std::vector<int> straight = {VTK_TETRA, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID};
const std::vector<int> curved = {VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_WEDGE,
  VTK_QUADRATIC_PYRAMID, VTK_LAGRANGE_TETRAHEDRON, VTK_LAGRANGE_HEXAHEDRON, VTK_LAGRANGE_WEDGE,
  VTK_BEZIER_TETRAHEDRON, VTK_BEZIER_HEXAHEDRON, VTK_BEZIER_WEDGE};

} // namespace

TEST(OuterSurface, LooksOutwardForAllTypesOfCells)
{
  for (const std::vector<int>* types : {&straight, &curved})
  {
    for (const int type : *types)
    {
      SCOPED_TRACE("type " + std::to_string(type));
      expectTheCube(cubeOf(type, stay));
      expectTheCube(cubeOf(type, mirror));
      const auto report = reportOn(cubeOf(type, mirror));
      EXPECT_TRUE(report->GetClosed());
      EXPECT_NEAR(report->GetVolume(), 8, 1e-6);
    }
  }
}

TEST(OuterSurface, TurnsCellsOfTheOtherOrderAndCountsThem)
{
  const std::vector<std::pair<int, std::vector<int>>> orders = {{VTK_TETRA, {1, 0, 2, 3}},
    {VTK_HEXAHEDRON, {4, 5, 6, 7, 0, 1, 2, 3}}, {VTK_WEDGE, {3, 4, 5, 0, 1, 2}},
    {VTK_PYRAMID, {0, 3, 2, 1, 4}}};
  for (const auto& [type, order] : orders)
  {
    SCOPED_TRACE("type " + std::to_string(type));
    const auto mesh = withEveryOtherReordered(cubeOf(type, stay), order);
    expectTheCube(mesh);
    const auto report = reportOn(mesh);
    EXPECT_TRUE(report->GetClosed());
    EXPECT_NEAR(report->GetVolume(), 8, 1e-12);
    EXPECT_GT(report->GetReport()->GetArray("turned_cells")->GetComponent(0, 0), 0);
  }
}

TEST(OuterSurface, TakesExplicitStructuredGrids)
{
  for (const Map& map : {Map(stay), Map(mirror)})
  {
    vtkNew<vtkExplicitStructuredGrid> grid;
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    points->SetDataTypeToDouble();
    grid->SetDimensions(3, 3, 3);
    grid->SetPoints(points);
    for (int cell = 0; cell < 8; ++cell)
    {
      vtkIdType corners[8];
      for (int corner = 0; corner < 8; ++corner)
      {
        const int x = ((corner + 1) / 2) % 2, y = (corner / 2) % 2, z = corner / 4;
        double point[3] = {1.0 * (cell % 2 + x), 1.0 * (cell / 2 % 2 + y), 1.0 * (cell / 4 + z)};
        map(point);
        corners[corner] = points->InsertNextPoint(point);
      }
      cells->InsertNextCell(8, corners);
    }
    grid->SetCells(cells);
    expectTheCube(grid);
  }
}

TEST(OuterSurface, TurnsFacesOfPolyhedra)
{
  const auto cube = cubeOf(VTK_HEXAHEDRON, stay);
  for (unsigned turned = 0; turned < 64; turned += 7)
  {
    SCOPED_TRACE("faces turned: " + std::to_string(turned));
    auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
    mesh->SetPoints(cube->GetPoints());
    for (vtkIdType cell = 0; cell < cube->GetNumberOfCells(); ++cell)
    {
      vtkCell* hexahedron = cube->GetCell(cell);
      vtkNew<vtkIdList> stream;
      stream->InsertNextId(hexahedron->GetNumberOfFaces());
      for (int face = 0; face < hexahedron->GetNumberOfFaces(); ++face)
      {
        vtkIdList* ids = hexahedron->GetFace(face)->GetPointIds();
        std::vector<vtkIdType> corners(ids->begin(), ids->end());
        if (((turned + static_cast<unsigned>(cell)) >> face) & 1u)
        {
          std::reverse(corners.begin(), corners.end());
        }
        stream->InsertNextId(static_cast<vtkIdType>(corners.size()));
        for (const vtkIdType corner : corners)
        {
          stream->InsertNextId(corner);
        }
      }
      mesh->InsertNextCell(VTK_POLYHEDRON, stream);
    }
    expectTheCube(mesh);
    EXPECT_NEAR(reportOn(mesh)->GetVolume(), 8, 1e-12);
  }
}

TEST(OuterSurface, FollowsCurvedCells)
{
  for (const int type : curved)
  {
    if (type == VTK_BEZIER_TETRAHEDRON || type == VTK_BEZIER_HEXAHEDRON || type == VTK_BEZIER_WEDGE)
    {
      continue; // their control points are not on the surface
    }
    SCOPED_TRACE("type " + std::to_string(type));
    for (const Map& map : {Map(bend), Map(bendAndMirror)})
    {
      const auto report = reportOn(cubeOf(type, map));
      EXPECT_TRUE(report->GetClosed());
      EXPECT_NEAR(report->GetVolume(), 11.2, 0.02);
    }
  }
}

TEST(OuterSurface, OfCubicCellsCloses)
{
  for (const int type : {VTK_LAGRANGE_TETRAHEDRON, VTK_LAGRANGE_HEXAHEDRON, VTK_LAGRANGE_WEDGE})
  {
    SCOPED_TRACE("type " + std::to_string(type));
    const auto report = reportOn(cubeOf(type, bend, 3));
    EXPECT_TRUE(report->GetClosed()) << "VTK has points twice, a rounding of float apart";
    EXPECT_NEAR(report->GetVolume(), 11.2, 0.02);
  }
}

TEST(OuterSurface, LooksOutwardForStraightCellsNextToCurvedOnes)
{
  // A hexahedron over a dart, whose middle is outside of one face, and a curved cell apart from it.
  const auto mesh = cubeOf(VTK_QUADRATIC_TETRA, stay);
  mesh->GetPointData()->Initialize();
  mesh->GetCellData()->Initialize();
  const double dart[4][2] = {{0, 0}, {2, 0.2}, {0.4, 0.4}, {0.2, 2}};
  std::vector<vtkIdType> corners;
  for (const double z : {5.0, 6.0})
  {
    for (const auto& [x, y] : dart)
    {
      corners.push_back(mesh->GetPoints()->InsertNextPoint(x, y, z));
    }
  }
  mesh->InsertNextCell(VTK_HEXAHEDRON, 8, corners.data());
  const auto report = reportOn(mesh);
  EXPECT_TRUE(report->GetClosed());
  EXPECT_NEAR(report->GetVolume(), 8.72, 1e-6);
}

TEST(OuterSurface, LeavesOutFacesOfCellsWithVolumeAndSaysSo)
{
  const auto solid = cubeOf(VTK_HEXAHEDRON, stay);
  for (const bool isInward : {false, true})
  {
    auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
    mesh->DeepCopy(solid);
    const auto skin = reportOn(solid);
    vtkPolyData* faces = skin->GetOutput();
    vtkIdType added = 0;
    for (vtkIdType i = 0; i < faces->GetNumberOfCells(); ++i, ++added)
    {
      vtkNew<vtkIdList> ids;
      faces->GetCellPoints(i, ids);
      std::vector<vtkIdType> corners;
      for (const vtkIdType id : *ids)
      {
        corners.push_back(mesh->FindPoint(faces->GetPoint(id)));
      }
      if (isInward)
      {
        std::reverse(corners.begin(), corners.end());
      }
      mesh->InsertNextCell(VTK_QUAD, 4, corners.data());
    }
    expectTheCube(mesh);
    std::string warning;
    valuesAt(mesh, insideAndOutside, &warning);
    EXPECT_NE(warning.find("cells with and without volume are mixed"), std::string::npos)
      << warning;
    EXPECT_NE(warning.find(std::to_string(added)), std::string::npos) << warning;
    EXPECT_EQ(reportOn(mesh)->GetReport()->GetArray("left_out_cells")->GetComponent(0, 0), added);
    EXPECT_NEAR(reportOn(mesh)->GetVolume(), 8, 1e-12);
    const double sense = isInward ? -1 : 1;
    EXPECT_NEAR(valuesAt(mesh, insideAndOutside, nullptr, true)[0], sense, 1e-6);
    EXPECT_NEAR(reportOn(mesh, true)->GetVolume(), 8 * sense, 1e-12);
  }
}

TEST(OuterSurface, LeavesOutRefinedCells)
{
  const auto mesh = cubeOf(VTK_HEXAHEDRON, stay);
  vtkUnsignedCharArray* flags = mesh->AllocateCellGhostArray();
  flags->SetValue(0, vtkDataSetAttributes::REFINEDCELL);
  EXPECT_NEAR(reportOn(mesh)->GetVolume(), 7, 1e-12);
  vtkNew<vtkPolyData> surface;
  surface->DeepCopy(reportOn(cubeOf(VTK_HEXAHEDRON, stay))->GetOutput());
  const vtkIdType faces = surface->GetNumberOfCells();
  surface->AllocateCellGhostArray()->SetValue(0, vtkDataSetAttributes::REFINEDCELL);
  EXPECT_EQ(
    reportOn(surface)->GetReport()->GetArray("triangles")->GetComponent(0, 0), 2 * (faces - 1));
}
