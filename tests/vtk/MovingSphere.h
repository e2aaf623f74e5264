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

#include <utility>
#include <vector>

/// A sphere whose centre moves along x, by 10 unless it is set, and whose radius grows by its half
/// from time to time.
class MovingSphere : public vtkPolyDataAlgorithm
{
public:
  static MovingSphere* New() { VTK_STANDARD_NEW_BODY(MovingSphere); }
  vtkTypeMacro(MovingSphere, vtkPolyDataAlgorithm);

  void SetResolution(int resolution) { resolution_ = resolution; }

  void SetStep(double step)
  {
    step_ = step;
    this->Modified();
  }

  /// Gives the sphere other times than 0, 1 and 2, in their order.
  void SetTimes(std::vector<double> times)
  {
    times_ = std::move(times);
    this->Modified();
  }

  /// Opens the sphere below an angle of less than 180 degrees from its north pole.
  void SetEndPhi(double degrees)
  {
    endPhi_ = degrees;
    this->Modified();
  }

protected:
  MovingSphere() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    const double range[2] = {times_.front(), times_.back()};
    vtkInformation* info = outputs->GetInformationObject(0);
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times_.data(),
      static_cast<int>(times_.size()));
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    info->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1); // whoever asks gets all of it
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    vtkNew<vtkSphereSource> sphere;
    const double time = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
    sphere->SetCenter(step_ * time, 0, 0);
    sphere->SetRadius(0.5 + 0.25 * time);
    sphere->SetThetaResolution(resolution_);
    sphere->SetPhiResolution(resolution_);
    sphere->SetEndPhi(endPhi_);
    sphere->Update();
    vtkPolyData::GetData(info)->ShallowCopy(sphere->GetOutput());
    return 1;
  }

private:
  int resolution_ = 24;
  double step_ = 10;
  double endPhi_ = 180;
  std::vector<double> times_ = {0, 1, 2};
};
