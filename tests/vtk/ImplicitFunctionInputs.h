// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <vector>

/// A sphere of radius 0.5, unless another is given; open at the bottom if phi ends before 180.
inline vtkSmartPointer<vtkPolyData> sphere(double endPhi = 180, double radius = 0.5, double x = 0)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(x, 0, 0);
  source->SetRadius(radius);
  source->SetThetaResolution(60);
  source->SetPhiResolution(40);
  source->SetEndPhi(endPhi);
  source->Update();
  vtkSmartPointer<vtkPolyData> result = source->GetOutput();
  return result;
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
