// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberReport.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

inline vtkSmartPointer<vtkWindingNumberReport> reportOn(
  vtkDataObject* mesh, bool usesSurfaceCells = false)
{
  auto report = vtkSmartPointer<vtkWindingNumberReport>::New();
  report->SetUseSurfaceCells(usesSurfaceCells);
  report->SetInputDataObject(mesh);
  report->Update();
  return report;
}

/// Returns the winding numbers of a mesh at points, and the last warning if asked for.
inline std::vector<double> valuesAt(vtkDataObject* mesh,
  const std::vector<std::array<double, 3>>& places, std::string* warning = nullptr,
  bool usesSurfaceCells = false)
{
  vtkNew<vtkPolyData> samples;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& place : places)
  {
    points->InsertNextPoint(place.data());
  }
  samples->SetPoints(points);
  vtkNew<vtkWindingNumberProbe> probe;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(warning);
  observer->SetCallback(
    [](vtkObject*, unsigned long, void* text, void* said)
    {
      if (text)
      {
        *static_cast<std::string*>(text) = static_cast<const char*>(said);
      }
    });
  probe->AddObserver(vtkCommand::WarningEvent, observer);
  probe->SetInputData(samples);
  probe->SetSourceData(mesh);
  probe->SetUseSurfaceCells(usesSurfaceCells);
  probe->Update();
  auto* output = vtkDataSet::SafeDownCast(probe->GetOutputDataObject(0));
  vtkDataArray* array = output->GetPointData()->GetArray("WindingNumber");
  std::vector<double> values;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

inline const std::vector<std::array<double, 3>> insideAndOutside = {
  {0.3, 0.4, 0.55}, {1.7, 1.1, 1.3}, {0.9, 1.6, 0.2}, {2.5, 1, 1}, {-0.4, 1, 1}, {1, 1, 2.3}};

/// Expects the field of the cube [0, 2]³.
inline void expectTheCube(vtkDataObject* mesh)
{
  const std::vector<double> values = valuesAt(mesh, insideAndOutside);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_NEAR(values[i], i < 3 ? 1 : 0, 1e-6) << "at place " << i;
  }
}
