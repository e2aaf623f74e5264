// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/probe/ProbeQueries.h"

#include "pipeline/FreeMemory.h"
#include "private/probe/ProbeWords.h"
#include "private/source/CellChecks.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkGenericCell.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace winding
{

namespace
{

/// The coordinates where they stand; empty if they have no array of float or double.
VectorsView ownPoints(vtkDataSet* data)
{
  auto* points = vtkPointSet::SafeDownCast(data);
  vtkDataArray* array = points && points->GetPoints() ? points->GetPoints()->GetData() : nullptr;
  const auto count = static_cast<std::size_t>(data->GetNumberOfPoints());
  if (auto* floats = vtkFloatArray::SafeDownCast(array))
  {
    return {floats->GetPointer(0), count};
  }
  if (auto* doubles = vtkDoubleArray::SafeDownCast(array))
  {
    return {doubles->GetPointer(0), count};
  }
  return {};
}

void copyPoints(vtkDataSet* data, double* positions)
{
  const VectorsView own = ownPoints(data);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double* const position = positions + 3 * i;
    if (own.empty())
    {
      data->GetPoint(i, position);
      continue;
    }
    const Eigen::Vector3d at = own[static_cast<std::size_t>(i)];
    std::copy_n(at.data(), 3, position);
  }
}

void copyCellCenters(vtkDataSet* data, double* positions)
{
  std::vector<double> weights(static_cast<std::size_t>(data->GetMaxCellSize()));
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    data->GetCell(i, cell);
    double* const center = positions + 3 * i;
    if (cell->GetCellType() == VTK_EMPTY_CELL || cell->GetNumberOfPoints() == 0)
    {
      center[0] = center[1] = center[2] = vtkMath::Nan();
      continue;
    }
    double parametric[3];
    int subId = cell->GetParametricCenter(parametric);
    cell->EvaluateLocation(subId, parametric, center, weights.data());
  }
}

std::vector<vtkDataSet*> dataSetsOf(vtkDataObject* queries)
{
  std::vector<vtkDataSet*> found;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(queries))
  {
    auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      if (auto* data = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject()))
      {
        found.push_back(data);
      }
    }
  }
  else if (auto* data = vtkDataSet::SafeDownCast(queries))
  {
    found.push_back(data);
  }
  return found;
}

} // namespace

ProbeQueries::ProbeQueries(
  vtkDataObject* queries, bool atCells, bool areCellsUsed, const ProbeWords& words)
{
  vtkIdType cells = 0;
  for (vtkDataSet* data : dataSetsOf(queries))
  {
    (atCells || areCellsUsed ? checkCells : checkUnusedCells)(data, words.dataSet);
    checkArrays(data, words.dataSet);
    const vtkIdType count = atCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
    leaves_.push_back({data, size_, count, cells});
    size_ += count;
    cells += data->GetNumberOfCells();
  }
  if (leaves_.size() == 1)
  {
    if (const auto image = gridOfImage(leaves_[0].data, atCells))
    {
      grid_ = image->grid;
      frame_ = image->frame;
    }
    samples_ = atCells ? VectorsView() : ownPoints(leaves_[0].data);
  }
  if (!grid_ && samples_.empty())
  {
    refuseBeyondFreeMemory(3.0 * sizeof(double) * static_cast<double>(size_),
      "the positions of " + std::to_string(size_) + " samples", words.remedies);
    positions_.resize(3 * static_cast<std::size_t>(size_));
    for (const ProbeLeaf& leaf : leaves_)
    {
      (atCells ? copyCellCenters : copyPoints)(leaf.data, positions_.data() + 3 * leaf.first);
    }
    samples_ = VectorsView(positions_.data(), static_cast<std::size_t>(size_));
  }
}

void ProbeQueries::addPart(
  const ProbeLeaf& leaf, vtkDataSetAttributes* ofAll, vtkDataSetAttributes* attributes) const
{
  for (int i = 0; i < ofAll->GetNumberOfArrays(); ++i)
  {
    vtkSmartPointer<vtkDataArray> part = ofAll->GetArray(i);
    if (leaf.count != size_)
    {
      vtkDataArray* all = part;
      part = vtkSmartPointer<vtkDataArray>::Take(all->NewInstance());
      part->SetName(all->GetName());
      part->SetNumberOfComponents(all->GetNumberOfComponents());
      part->SetNumberOfTuples(leaf.count);
      part->InsertTuples(0, leaf.count, leaf.first, all);
    }
    attributes->AddArray(part);
  }
  if (vtkDataArray* active = ofAll->GetScalars())
  {
    attributes->SetActiveScalars(active->GetName());
  }
}

} // namespace winding
