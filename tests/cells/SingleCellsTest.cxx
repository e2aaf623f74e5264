// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cells/FieldOfCells.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

TEST(SingleCells, LookOutwardForAllTypes)
{
  for (int type = 0; type < VTK_LAGRANGE_CURVE; ++type)
  {
    const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
    if (!cell || cell->GetCellDimension() < 3 || cell->GetNumberOfPoints() == 0 ||
        !cell->GetParametricCoords())
    {
      continue; // a polyhedron
    }
    SCOPED_TRACE("type " + std::to_string(type));
    double centre[3];
    cell->GetParametricCenter(centre);
    for (const double sign : {1.0, -1.0})
    {
      vtkNew<vtkUnstructuredGrid> mesh;
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      std::vector<vtkIdType> ids;
      for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
      {
        const double* place = cell->GetParametricCoords() + 3 * i;
        ids.push_back(points->InsertNextPoint(sign * place[0], place[1], place[2]));
      }
      mesh->SetPoints(points);
      mesh->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
      const std::vector<double> values =
        valuesAt(mesh, {{sign * centre[0], centre[1], centre[2]}, {0, 0, 3}});
      EXPECT_NEAR(values[0], 1, 1e-6);
      EXPECT_NEAR(values[1], 0, 1e-6);
      EXPECT_TRUE(reportOn(mesh)->GetClosed());
    }
  }
}

TEST(SingleCells, OfAStructuredGridLookOutwardForEitherHand)
{
  for (const double sign : {1.0, -1.0})
  {
    vtkNew<vtkStructuredGrid> grid;
    grid->SetDimensions(3, 3, 3);
    vtkNew<vtkPoints> points;
    for (int i = 0; i < 27; ++i)
    {
      points->InsertNextPoint(1 + sign * (i % 3 - 1), i / 3 % 3, i / 9);
    }
    grid->SetPoints(points);
    expectTheCube(grid);
  }
}
