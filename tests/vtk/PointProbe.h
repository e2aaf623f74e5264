// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkWindingNumberProbe.h"

#include <gtest/gtest.h>

#include <limits>

/// The winding number of a source at one point, in double, by a filter whose properties tests set.
class PointProbe : public testing::Test
{
protected:
  PointProbe() { probe->SetOutputScalarTypeToDouble(); }

  /// The winding number of a source at a point; NaN where there is none.
  double windingNumber(vtkDataObject* source, double x = 0, double y = 0, double z = 0)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->InsertNextPoint(x, y, z);
    vtkNew<vtkPolyData> query;
    query->SetPoints(points);
    probe->SetInputData(query);
    probe->SetSourceData(source);
    probe->Update();
    vtkDataArray* values = probe->GetOutput()->GetPointData()->GetArray("WindingNumber");
    return values ? values->GetTuple1(0) : std::numeric_limits<double>::quiet_NaN();
  }

  vtkNew<vtkWindingNumberProbe> probe;
};
