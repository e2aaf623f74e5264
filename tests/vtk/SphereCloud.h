// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cmath>

/// An evenly sampled unit sphere, with normals outward (1), inward (−1) or none (0).
inline vtkSmartPointer<vtkPolyData> sphereCloud(int count, double sense, double x = 0)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < count; ++i)
  {
    const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - z * z), a = 2.39996322972865 * i;
    const double p[3] = {r * std::cos(a), r * std::sin(a), z};
    points->InsertNextPoint(x + p[0], p[1], p[2]);
    normals->InsertNextTuple3(sense * p[0], sense * p[1], sense * p[2]);
  }
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(points);
  if (sense != 0)
  {
    cloud->GetPointData()->SetNormals(normals);
  }
  return cloud;
}
