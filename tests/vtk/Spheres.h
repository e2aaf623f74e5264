// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <array>

/// Makes a sphere with normals of `theta` meridians and `phi` parallels, as vtkSphereSource does;
/// with an `endPhi` of less than 180 it is open at the bottom.
inline vtkSmartPointer<vtkPolyData> sphereOf(int theta, int phi, double radius = 0.5,
  const std::array<double, 3>& center = {}, double endPhi = 180)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(center.data());
  source->SetRadius(radius);
  source->SetThetaResolution(theta);
  source->SetPhiResolution(phi);
  source->SetEndPhi(endPhi);
  source->Update();
  return source->GetOutput();
}
