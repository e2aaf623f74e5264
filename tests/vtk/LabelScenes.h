// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtk/Spheres.h"

#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedShortArray.h"
#include "vtkWindingNumberLabels.h"

#include <string>
#include <vector>

/// A sphere, or of it the part down to an angle from its pole.
inline vtkSmartPointer<vtkPolyData> ball(
  double x, double y, double z, double radius, double endPhi = 180)
{
  return sphereOf(24, 16, radius, {x, y, z}, endPhi);
}

/// Spheres that overlap: the third is open, the fourth lies in the first, the fifth alone.
inline std::vector<vtkSmartPointer<vtkPolyData>> fiveBalls()
{
  return {ball(0, 0, 0, 1), ball(1.2, 0.1, 0, 0.8), ball(0.4, 1, 0.1, 0.7, 140),
    ball(-0.3, 0, 0.1, 0.4), ball(0.3, -1.6, 0.2, 0.45)};
}

inline vtkSmartPointer<vtkMultiBlockDataSet> asAssembly(
  const std::vector<vtkSmartPointer<vtkPolyData>>& solids)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (unsigned int i = 0; i < solids.size(); ++i)
  {
    blocks->SetBlock(i, solids[i]);
    blocks->GetMetaData(i)->Set(
      vtkCompositeDataSet::NAME(), ("solid " + std::to_string(i)).c_str());
  }
  return blocks;
}

/// The values of an array of shorts.
inline std::vector<unsigned short> shortsOf(vtkDataSetAttributes* data, const char* name = "Label")
{
  auto* array = vtkUnsignedShortArray::SafeDownCast(data->GetArray(name));
  return array ? std::vector<unsigned short>(
                   array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfTuples())
               : std::vector<unsigned short>();
}
