// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/FieldParts.h"

#include "program/AvailableMemory.h"
#include "program/Failure.h"
#include "program/ParallelRun.h"
#include "program/Print.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

namespace
{

bool hasCells(vtkImageData* image)
{
  return image->GetCellData()->GetNumberOfArrays() > 0;
}

vtkDataSetAttributes* arraysOf(vtkImageData* image)
{
  if (hasCells(image))
  {
    return image->GetCellData();
  }
  return image->GetPointData();
}

std::size_t bytesOfValue(vtkDataArray* array)
{
  return static_cast<std::size_t>(array->GetDataTypeSize());
}

std::size_t bytesOf(vtkDataArray* array)
{
  return static_cast<std::size_t>(array->GetNumberOfValues()) * bytesOfValue(array);
}

/// An image of the whole with arrays like a slab's, whose values are not set.
vtkSmartPointer<vtkImageData> emptyImage(vtkImageData* slab, const std::vector<SlabExtent>& slabs)
{
  SlabExtent whole = slabs.front();
  whole[5] = slabs.back()[5];
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(whole.data());
  image->SetOrigin(slab->GetOrigin());
  image->SetSpacing(slab->GetSpacing());
  image->SetDirectionMatrix(slab->GetDirectionMatrix());
  image->GetFieldData()->ShallowCopy(slab->GetFieldData());
  const bool asCells = hasCells(slab);
  const vtkIdType samples = asCells ? image->GetNumberOfCells() : image->GetNumberOfPoints();
  vtkDataSetAttributes* const from = arraysOf(slab);
  vtkDataSetAttributes* to = image->GetPointData();
  if (asCells)
  {
    to = image->GetCellData();
  }
  double bytes = 0;
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    bytes += static_cast<double>(samples) * static_cast<double>(bytesOfValue(from->GetArray(i)));
  }
  if (bytes > availableMemory())
  {
    throw Failure(EXIT_NO_MEMORY,
      "give the output the suffix .pvti, which every rank writes a part of: a .vti file needs " +
        shown(1e-9 * bytes, 3) + " GB on the first rank");
  }
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = from->GetArray(i);
    const auto all = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
    all->SetName(array->GetName());
    all->SetNumberOfTuples(samples);
    to->AddArray(all);
  }
  if (from->GetScalars())
  {
    to->SetActiveScalars(from->GetScalars()->GetName());
  }
  return image;
}

/// Adds up the volumes of labels in slabs, which share no voxel, on the first of `ranks` ranks.
void addUpVolumes(vtkImageData* own, vtkImageData* whole, std::size_t ranks)
{
  vtkDataArray* const part = own ? own->GetFieldData()->GetArray("LabelVolumes") : nullptr;
  if (!part)
  {
    return;
  }
  const double* const spacing = own->GetSpacing();
  const double voxel = std::abs(spacing[0] * spacing[1] * spacing[2]);
  std::vector<double> voxels;
  for (vtkIdType i = 0; i < part->GetNumberOfTuples(); ++i)
  {
    voxels.push_back(std::round(part->GetComponent(i, 0) / voxel));
  }
  const std::size_t bytes = voxels.size() * sizeof(double);
  if (!parallel::isFirst())
  {
    parallel::send(voxels.data(), bytes, 0);
    return;
  }
  std::vector<double> others(voxels.size());
  for (std::size_t rank = 1; rank < ranks; ++rank)
  {
    parallel::receive(others.data(), bytes, static_cast<int>(rank));
    std::transform(
      voxels.begin(), voxels.end(), others.begin(), voxels.begin(), std::plus<double>());
  }
  const auto sum = vtkSmartPointer<vtkDataArray>::Take(part->NewInstance());
  sum->SetName(part->GetName());
  for (const double count : voxels)
  {
    sum->InsertNextTuple1(voxel * count);
  }
  whole->GetFieldData()->AddArray(sum);
}

} // namespace

std::vector<SlabExtent> slabsOf(
  const int (&samples)[3], bool asCells, bool overlap, std::size_t slabs)
{
  // An image of n cells has n + 1 points, and n layers of points have n - 1 steps between them.
  const int more = asCells ? 1 : 0;
  const int units = std::max(1, samples[2] - (!asCells && overlap ? 1 : 0));
  const std::size_t count = std::min(slabs, static_cast<std::size_t>(units));
  std::vector<SlabExtent> extents;
  for (std::size_t n = 0; n < count; ++n)
  {
    const auto at = [&](std::size_t i)
    {
      return static_cast<int>(static_cast<std::size_t>(units) * i / count);
    };
    const int last = at(n + 1) - (asCells || overlap ? 0 : 1);
    extents.push_back({0, samples[0] - 1 + more, 0, samples[1] - 1 + more, at(n),
      std::min(last, samples[2] - 1 + more)});
  }
  return extents;
}

vtkSmartPointer<vtkImageData> gatheredImage(vtkImageData* own, const std::vector<SlabExtent>& slabs)
{
  vtkSmartPointer<vtkImageData> whole;
  parallel::agreeOnFirst([&] { whole = emptyImage(own, slabs); });
  const int arrays =
    own ? arraysOf(own)->GetNumberOfArrays() : 0; // the same on all ranks that have a slab
  for (int i = 0; i < arrays; ++i)
  {
    vtkDataArray* const part = arraysOf(own)->GetArray(i);
    if (!parallel::isFirst())
    {
      parallel::send(part->GetVoidPointer(0), bytesOf(part), 0);
      continue;
    }
    // The layers of a slab follow the previous slab's.
    auto* to = static_cast<unsigned char*>(arraysOf(whole)->GetArray(i)->GetVoidPointer(0));
    std::memcpy(to, part->GetVoidPointer(0), bytesOf(part));
    to += bytesOf(part);
    const auto layers = [&](std::size_t slab)
    {
      return static_cast<std::size_t>(slabs[slab][5] - slabs[slab][4] + (hasCells(own) ? 0 : 1));
    };
    const std::size_t bytesOfLayer = bytesOf(part) / layers(0);
    for (std::size_t rank = 1; rank < slabs.size(); ++rank)
    {
      parallel::receive(to, layers(rank) * bytesOfLayer, static_cast<int>(rank));
      to += layers(rank) * bytesOfLayer;
    }
  }
  addUpVolumes(own, whole, slabs.size());
  return whole;
}
