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

/// A sphere whose centre moves by 10 along x and whose radius grows by its half from time to time.
class MovingSphere : public vtkPolyDataAlgorithm
{
public:
  static MovingSphere* New() { VTK_STANDARD_NEW_BODY(MovingSphere); }
  vtkTypeMacro(MovingSphere, vtkPolyDataAlgorithm);

  void SetResolution(int resolution) { resolution_ = resolution; }

protected:
  MovingSphere() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    const double times[3] = {0, 1, 2}, range[2] = {0, 2};
    vtkInformation* info = outputs->GetInformationObject(0);
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times, 3);
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    vtkNew<vtkSphereSource> sphere;
    const double time = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
    sphere->SetCenter(10 * time, 0, 0);
    sphere->SetRadius(0.5 + 0.25 * time);
    sphere->SetThetaResolution(resolution_);
    sphere->SetPhiResolution(resolution_);
    sphere->Update();
    vtkPolyData::GetData(info)->ShallowCopy(sphere->GetOutput());
    return 1;
  }

private:
  int resolution_ = 24;
};
