// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/output/SurfaceFidelity.h"

#include "pipeline/FreeMemory.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace winding
{

namespace
{

TriangleList trianglesOf(vtkPolyData* surface)
{
  TriangleList triangles;
  auto polygons = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (polygons->GoToFirstCell(); !polygons->IsDoneWithTraversal(); polygons->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    polygons->GetCurrentCell(count, ids);
    for (vtkIdType n = 2; n < count; ++n)
    {
      triangles.push_back({static_cast<std::int32_t>(ids[0]), static_cast<std::int32_t>(ids[n - 1]),
        static_cast<std::int32_t>(ids[n])});
    }
  }
  return triangles;
}

/// Returns the points of a surface, which are packed numbers of single or double precision.
VectorsView viewOf(vtkPolyData* surface)
{
  const auto count = static_cast<std::size_t>(surface->GetNumberOfPoints());
  if (count == 0)
  {
    return {};
  }
  const void* const numbers = surface->GetPoints()->GetData()->GetVoidPointer(0);
  return surface->GetPoints()->GetDataType() == VTK_DOUBLE
           ? VectorsView(static_cast<const double*>(numbers), count)
           : VectorsView(static_cast<const float*>(numbers), count);
}

} // namespace

void addDistances(const Field& field, vtkPolyData* surface, Executor& executor)
{
  const VectorsView points = viewOf(surface);
  const std::vector<double> distances = field.distances(points, executor);
  const bool areDoubles = points.size() > 0 && surface->GetPoints()->GetDataType() == VTK_DOUBLE;
  const auto array =
    vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(areDoubles ? VTK_DOUBLE : VTK_FLOAT));
  array->SetName("DistanceToInput");
  array->SetNumberOfTuples(static_cast<vtkIdType>(distances.size()));
  for (std::size_t n = 0; n < distances.size(); ++n)
  {
    array->SetComponent(static_cast<vtkIdType>(n), 0, distances[n]);
  }
  surface->GetPointData()->SetScalars(array);
}

void refuseFidelityBeyondFreeMemory(const Field& field, double triangles, std::size_t samples)
{
  refuseBeyondFreeMemory(bytesForComparison(field, triangles, static_cast<double>(samples)),
    "the comparison of the surface with its source",
    {{"draw fewer points", {Parameter::fidelitySamples}}, largerVoxels()});
}

Fidelity addFidelity(const Field& field, double voxel, std::size_t samples,
  const WantedDistances* wanted, vtkPolyData* surface, Executor& executor)
{
  // A polygon of n corners is cut into n - 2 triangles.
  const vtkIdType triangles =
    surface->GetPolys()->GetNumberOfConnectivityIds() - 2 * surface->GetNumberOfPolys();
  refuseFidelityBeyondFreeMemory(field, static_cast<double>(triangles), samples);
  const VectorsView points = viewOf(surface);
  std::vector<Eigen::Vector3d> vertices(points.size());
  for (std::size_t n = 0; n < vertices.size(); ++n)
  {
    vertices[n] = points[n];
  }
  constexpr unsigned seed = 1;
  const Fidelity fidelity = compareWithSource(
    field, vertices, trianglesOf(surface), voxel, samples, seed, executor, wanted);
  const auto add = [surface](const char* name, double value)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->InsertNextValue(value);
    surface->GetFieldData()->AddArray(array);
  };
  add("LargestDistanceFromInput", fidelity.largestFromSource);
  add("MeanDistanceFromInput", fidelity.meanFromSource);
  add("LargestDistanceToInput", fidelity.largestToSource);
  add("MeanDistanceToInput", fidelity.meanToSource);
  add("InputVolume", fidelity.sourceVolume);
  add("Volume", fidelity.volume);
  add("InputComponents", static_cast<double>(fidelity.components));
  add("LostComponents", static_cast<double>(fidelity.lostComponents));
  add("SelfIntersections", static_cast<double>(fidelity.selfIntersections));
  if (wanted)
  {
    add("LargestShapeError", fidelity.largestShapeError);
    add("MeanShapeError", fidelity.meanShapeError);
  }
  return fidelity;
}

} // namespace winding
