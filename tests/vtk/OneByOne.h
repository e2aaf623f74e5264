// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

/// A surface of its own at each of the times from 0 on.
class OneByOne : public vtkPolyDataAlgorithm
{
public:
  static OneByOne* New() { VTK_STANDARD_NEW_BODY(OneByOne); }
  vtkTypeMacro(OneByOne, vtkPolyDataAlgorithm);

  /// Gives the source spheres around the origin by their radii; 0 stands for none.
  void SetRadii(std::vector<double> radii) { radii_ = std::move(radii); }

protected:
  OneByOne() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    std::vector<double> times(radii_.size());
    std::iota(times.begin(), times.end(), 0.0);
    const double range[2] = {times.front(), times.back()};
    vtkInformation* info = outputs->GetInformationObject(0);
    info->Set(
      vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    const double time = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
    const double radius = radii_[static_cast<std::size_t>(std::lround(time))];
    if (radius > 0)
    {
      vtkNew<vtkSphereSource> sphere;
      sphere->SetRadius(radius);
      sphere->Update();
      vtkPolyData::GetData(info)->ShallowCopy(sphere->GetOutput());
    }
    return 1;
  }

private:
  std::vector<double> radii_;
};
