// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/output/TimeUnion.h"

#include "private/output/ResultArrays.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace winding
{

namespace
{

/// Takes the values of another array that are better, where both arrays have this type.
template <class Array, class IsBetter>
void takeBetterOf(vtkDataArray* all, vtkDataArray* other, const IsBetter& isBetter)
{
  auto* const to = Array::SafeDownCast(all);
  auto* const from = Array::SafeDownCast(other);
  if (to && from)
  {
    const auto* const values = from->GetPointer(0);
    std::transform(values, values + from->GetNumberOfTuples(), to->GetPointer(0), to->GetPointer(0),
      [&isBetter](auto theirs, auto ours) { return isBetter(theirs, ours) ? theirs : ours; });
  }
}

/// Takes the values of another array that are better. Arrays that are not there have none.
template <class IsBetter>
void takeBetter(vtkDataArray* all, vtkDataArray* other, const IsBetter& isBetter)
{
  takeBetterOf<vtkDoubleArray>(all, other, isBetter);
  takeBetterOf<vtkFloatArray>(all, other, isBetter);
  takeBetterOf<vtkUnsignedCharArray>(all, other, isBetter);
  takeBetterOf<vtkUnsignedShortArray>(all, other, isBetter);
}

template <class IsBetter>
void takeBetter(vtkDataSetAttributes* all, vtkDataSetAttributes* other, const std::string& name,
  const IsBetter& isBetter)
{
  takeBetter(all->GetArray(name.c_str()), other->GetArray(name.c_str()), isBetter);
}

template <class Array, class IsInside>
vtkIdType countOf(vtkDataArray* array, const IsInside& isInside)
{
  auto* const values = Array::SafeDownCast(array);
  return values ? std::count_if(values->GetPointer(0),
                    values->GetPointer(0) + values->GetNumberOfTuples(), isInside)
                : 0;
}

template <class IsInside> vtkIdType countNumbers(vtkDataArray* array, const IsInside& isInside)
{
  return countOf<vtkDoubleArray>(array, isInside) + countOf<vtkFloatArray>(array, isInside);
}

} // namespace

vtkIdType uniteResults(vtkDataSetAttributes* all, vtkDataSetAttributes* other,
  const std::string& name, const InsideTest& isInside)
{
  takeBetter(all, other, name,
    [isInside](double theirs, double ours)
    { return isInside.levelOf(theirs) > isInside.levelOf(ours); });
  const auto takeOther = [&](const std::string& of, auto isBetter)
  {
    if (of != name) // else it has winding numbers
    {
      takeBetter(all, other, of, isBetter);
    }
  };
  takeOther("Inside", std::greater<>());
  takeOther(coverageName, std::greater<>());
  takeOther(distanceName, std::less<>());
  if (vtkDataArray* inside = name == "Inside" ? nullptr : all->GetArray("Inside"))
  {
    return countOf<vtkUnsignedCharArray>(inside, [](auto side) { return side != 0; });
  }
  if (vtkDataArray* values = all->GetArray(name.c_str()))
  {
    return countNumbers(values, [=](double value) { return isInside(value); });
  }
  return countNumbers(all->GetArray(distanceName), [](double distance) { return distance < 0; });
}

void uniteLabels(vtkDataSetAttributes* all, vtkDataSetAttributes* other)
{
  takeBetter(all, other, "Label", [](auto theirs, auto ours) { return ours == 0 && theirs != 0; });
  takeBetter(all, other, "SolidCount", std::greater<>());
  for (int i = 0; i < all->GetNumberOfArrays(); ++i)
  {
    const std::string name = all->GetArrayName(i) ? all->GetArrayName(i) : "";
    if (name.rfind("Coverage ", 0) == 0)
    {
      takeBetter(all, other, name, std::greater<>());
    }
  }
  vtkDataArray* const shares = all->GetArray("FirstShare");
  vtkDataArray* const theirShares = other->GetArray("FirstShare");
  for (vtkIdType n = 0; shares && theirShares && n < shares->GetNumberOfTuples(); ++n)
  {
    if (theirShares->GetComponent(n, 0) > shares->GetComponent(n, 0))
    {
      for (const char* const name : {"FirstShare", "FirstLabel", "SecondShare", "SecondLabel"})
      {
        all->GetArray(name)->SetComponent(n, 0, other->GetArray(name)->GetComponent(n, 0));
      }
    }
  }
}

} // namespace winding
