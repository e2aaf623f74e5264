// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/SurfaceMeasures.h"

#include "vtkCellArray.h"
#include "vtkFeatureEdges.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace
{

/// w - 0.5 at points, by the direct sum.
std::vector<double> distancesFromLevel(vtkPoints* points, vtkDataObject* source)
{
  vtkNew<vtkPolyData> queries;
  queries->SetPoints(points);
  vtkNew<vtkWindingNumberProbe> probe;
  probe->SetInputData(queries);
  probe->SetSourceData(source);
  probe->SetMethod(vtkWindingNumberProbe::DIRECT);
  probe->SetOutputScalarTypeToDouble();
  probe->Update();
  vtkDataArray* values = probe->GetOutput()->GetPointData()->GetScalars();
  std::vector<double> found;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    found.push_back(values->GetTuple1(i) - 0.5);
  }
  return found;
}

} // namespace

EdgeCounts countEdges(vtkPolyData* surface)
{
  const auto count = [surface](bool open)
  {
    vtkNew<vtkFeatureEdges> edges;
    edges->SetInputData(surface);
    edges->SetBoundaryEdges(open);
    edges->SetNonManifoldEdges(!open);
    edges->FeatureEdgesOff();
    edges->ManifoldEdgesOff();
    edges->Update();
    return edges->GetOutput()->GetNumberOfLines();
  };
  return {count(true), count(false)};
}

double signedVolume(vtkPolyData* surface)
{
  double sum = 0, a[3], b[3], c[3], cross[3];
  vtkIdType corners;
  const vtkIdType* ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, corners, ids);
    for (vtkIdType i = 2; i < corners; ++i)
    {
      surface->GetPoint(ids[0], a);
      surface->GetPoint(ids[i - 1], b);
      surface->GetPoint(ids[i], c);
      vtkMath::Cross(b, c, cross);
      sum += vtkMath::Dot(a, cross) / 6;
    }
  }
  return sum;
}

vtkIdType countDuplicatePoints(vtkPolyData* surface)
{
  std::set<std::array<double, 3>> different;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> p;
    surface->GetPoint(i, p.data());
    different.insert(p);
  }
  return surface->GetNumberOfPoints() - static_cast<vtkIdType>(different.size());
}

double voxelOf(vtkWindingNumberGridAlgorithm* filter)
{
  int dimensions[3];
  double first[3], spacing[3];
  filter->GetGrid(dimensions, first, spacing);
  return *std::max_element(spacing, spacing + 3);
}

std::vector<double> distances(vtkPolyData* surface, vtkPolyData* mesh, double voxel)
{
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(mesh);
  locator->BuildLocator();
  std::vector<double> found;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double point[3], closest[3], distance2;
    vtkIdType cell;
    int subId;
    surface->GetPoint(i, point);
    locator->FindClosestPoint(point, closest, cell, subId, distance2);
    found.push_back(std::sqrt(distance2) / voxel);
  }
  std::sort(found.begin(), found.end());
  return found;
}

int countOffLevel(
  vtkWindingNumberSurface* filter, vtkDataObject* source, vtkIdType most, double tolerance)
{
  vtkPolyData* surface = filter->GetOutput();
  const vtkIdType step = std::max<vtkIdType>(1, surface->GetNumberOfPoints() / most);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); i += step)
  {
    double point[3];
    surface->GetPoint(i, point);
    points->InsertNextPoint(point);
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const double shift : {-1e-3, 1e-3})
      {
        double moved[3] = {point[0], point[1], point[2]};
        moved[axis] += shift * voxelOf(filter);
        points->InsertNextPoint(moved);
      }
    }
  }
  const std::vector<double> levels = distancesFromLevel(points, source);
  int off = 0;
  for (std::size_t i = 0; i < levels.size(); i += 7)
  {
    bool isAtLevel = std::abs(levels[i]) <= tolerance;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      isAtLevel = isAtLevel || levels[i + 2 * axis + 1] * levels[i + 2 * axis + 2] <= 0;
    }
    off += !isAtLevel;
  }
  return off;
}
