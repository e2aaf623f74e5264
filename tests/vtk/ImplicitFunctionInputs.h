// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtk/Spheres.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

/// A sphere of radius 0.5, unless another is given; open at the bottom if phi ends before 180.
inline vtkSmartPointer<vtkPolyData> sphere(double endPhi = 180, double radius = 0.5, double x = 0)
{
  return sphereOf(60, 40, radius, {x, 0, 0}, endPhi);
}

/// The points of a sphere, with normals.
inline vtkSmartPointer<vtkPolyData> cloud()
{
  auto points = sphere();
  points->SetPolys(vtkSmartPointer<vtkCellArray>::New());
  return points;
}

/// A closed surface, an open one, and a cloud.
inline std::vector<vtkSmartPointer<vtkPolyData>> someInputs()
{
  return {sphere(), sphere(120), cloud()};
}
