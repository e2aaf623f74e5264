// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/probe/ClippedPart.h"

#include "private/probe/InsidePart.h"
#include "private/probe/ProbeWords.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkTableBasedClipDataSet.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace winding
{

namespace
{

constexpr const char* numbersName = "vtkWindingNumberClip::Distance";

/// The points alone, without cells.
vtkSmartPointer<vtkUnstructuredGrid> pointsOf(vtkPointSet* data)
{
  auto points = vtkSmartPointer<vtkUnstructuredGrid>::New();
  points->SetPoints(data->GetPoints());
  points->GetPointData()->ShallowCopy(data->GetPointData());
  points->GetFieldData()->ShallowCopy(data->GetFieldData());
  return points;
}

/// A copy with the numbers as an array, less the cells of points that are nowhere.
vtkSmartPointer<vtkDataSet> withNumbers(vtkDataSet* data, const double* numbers)
{
  const vtkIdType count = data->GetNumberOfPoints();
  vtkNew<vtkDoubleArray> array;
  array->SetName(numbersName);
  array->SetNumberOfTuples(count);
  std::copy_n(numbers, count, array->GetPointer(0));
  auto copy = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
  copy->ShallowCopy(data);
  // VTK 9.2 makes the array active, and throws out what was active until then.
  copy->GetPointData()->AddArray(array);
  copy->GetPointData()->SetActiveScalars(numbersName);

  std::vector<unsigned char> isSomewhere(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    double position[3];
    data->GetPoint(i, position);
    isSomewhere[static_cast<std::size_t>(i)] =
      std::all_of(position, position + 3, [](double x) { return std::isfinite(x); });
  }
  if (std::count(isSomewhere.begin(), isSomewhere.end(), 0) > 0)
  {
    copy = insidePart(copy, isSomewhere.data(), false);
  }
  return copy;
}

double bytesPerTuple(vtkDataSetAttributes* attributes)
{
  double bytes = 0;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = attributes->GetAbstractArray(i);
    bytes += array->GetNumberOfComponents() * array->GetDataTypeSize();
  }
  return bytes;
}

/// Throws OutOfMemory where the part would not fit. Cells that are cut count as if they were whole.
void refuseHugePart(vtkDataSet* data, const double* numbers, HostMemory (*memory)())
{
  constexpr double bytesPerCell = 9, bytesPerId = 8, bytesPerPoint = 24;
  const double bytesOfCell = bytesPerCell + bytesPerTuple(data->GetCellData());
  const double bytesOfPoint = bytesPerPoint + bytesPerTuple(data->GetPointData());
  const vtkIdType cells = data->GetNumberOfCells(), points = data->GetNumberOfPoints();
  const double most =
    bytesOfPoint * static_cast<double>(points) +
    (bytesOfCell + bytesPerId * data->GetMaxCellSize()) * static_cast<double>(cells);
  if (isFree(most, [memory] { return freeBytes(memory); }))
  {
    return;
  }
  double bytes = bytesOfPoint * static_cast<double>(std::count_if(
                                  numbers, numbers + points, [](double x) { return x > 0; }));
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    data->GetCellPoints(cell, ids);
    if (std::any_of(ids->begin(), ids->end(), [numbers](vtkIdType id) { return numbers[id] > 0; }))
    {
      bytes += bytesOfCell + bytesPerId * static_cast<double>(ids->GetNumberOfIds());
    }
  }
  refuseBeyondFreeMemory(
    bytes, "the clipped part of " + std::to_string(cells) + " cells", wordsOfClip.remedies, memory);
}

int precisionOf(vtkDataSet* data)
{
  auto* points = vtkPointSet::SafeDownCast(data);
  const bool isSingle =
    points && points->GetPoints() && points->GetPoints()->GetDataType() == VTK_FLOAT;
  return isSingle ? vtkAlgorithm::SINGLE_PRECISION : vtkAlgorithm::DOUBLE_PRECISION;
}

} // namespace

vtkSmartPointer<vtkUnstructuredGrid> clippedPart(
  vtkDataSet* data, const double* numbers, HostMemory (*memory)())
{
  auto* points = vtkPointSet::SafeDownCast(data);
  if (points && data->GetNumberOfCells() == 0)
  {
    std::vector<unsigned char> kept(static_cast<std::size_t>(data->GetNumberOfPoints()));
    std::transform(numbers, numbers + kept.size(), kept.begin(), [](double x) { return x > 0; });
    return vtkUnstructuredGrid::SafeDownCast(insidePart(pointsOf(points), kept.data(), false));
  }
  refuseHugePart(data, numbers, memory);
  vtkNew<vtkTableBasedClipDataSet> clip;
  clip->SetInputData(withNumbers(data, numbers));
  clip->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, numbersName);
  clip->SetOutputPointsPrecision(precisionOf(data));
  clip->Update();
  vtkSmartPointer<vtkUnstructuredGrid> part = clip->GetOutput();
  part->GetPointData()->RemoveArray(numbersName);
  if (vtkDataArray* active = data->GetPointData()->GetScalars())
  {
    part->GetPointData()->SetActiveScalars(active->GetName());
  }
  part->GetFieldData()->PassData(data->GetFieldData());
  return part;
}

} // namespace winding
