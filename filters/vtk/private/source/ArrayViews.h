// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkAOSDataArrayTemplate.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <vector>

namespace winding
{

/// Returns a VectorsView or ScalarsView of `array`, over the array's memory where floats or doubles
/// lie there in order. Otherwise `copies` keeps a copy.
template <class View>
View viewOf(vtkDataArray* array, std::vector<vtkSmartPointer<vtkDataArray>>& copies)
{
  const auto count = static_cast<std::size_t>(array->GetNumberOfTuples());
  if (auto* floats = vtkAOSDataArrayTemplate<float>::FastDownCast(array))
  {
    return View(floats->GetPointer(0), count);
  }
  auto* doubles = vtkAOSDataArrayTemplate<double>::FastDownCast(array);
  if (!doubles)
  {
    auto copy = vtkSmartPointer<vtkDoubleArray>::New();
    copy->DeepCopy(array);
    doubles = copy;
    copies.emplace_back(copy);
  }
  return View(doubles->GetPointer(0), count);
}

} // namespace winding
