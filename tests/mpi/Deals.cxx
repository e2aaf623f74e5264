// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/Deals.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <map>

const std::vector<Deal>& deals()
{
  static const std::vector<Deal> all = {{"singly",
                                          [](std::size_t i, std::size_t, int ranks) -> int
                                          {
                                            return i % ranks;
                                          }},
    {"slabs",
      [](std::size_t i, std::size_t n, int ranks) -> int
      {
        return i * ranks / n;
      }},
    {"all to the last",
      [](std::size_t, std::size_t, int ranks)
      {
        return ranks - 1;
      }},
    {"every other",
      [](std::size_t i, std::size_t, int ranks) -> int
      {
        return i % ((ranks + 1) / 2) * 2;
      }}};
  return all;
}

vtkSmartPointer<vtkPolyData> partOf(const shapes::Mesh& mesh, const Deal& deal, int rank, int ranks)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  std::map<std::int32_t, vtkIdType> ids;
  const std::size_t count = mesh.triangles.size();
  for (std::size_t n = 0; n < count; ++n)
  {
    const std::size_t i = rank % 2 == 0 ? n : count - 1 - n;
    if (deal.rankOf(i, count, ranks) != rank)
    {
      continue;
    }
    vtkIdType triangle[3];
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const std::int32_t vertex = mesh.triangles[i][corner];
      const auto [place, isNew] = ids.emplace(vertex, points->GetNumberOfPoints());
      if (isNew)
      {
        points->InsertNextPoint(mesh.points[static_cast<std::size_t>(vertex)].data());
      }
      triangle[corner] = place->second;
    }
    triangles->InsertNextCell(3, triangle);
  }
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->SetPoints(points);
  part->SetPolys(triangles);
  return part;
}

vtkSmartPointer<vtkPolyData> pointsOf(
  const shapes::Mesh& mesh, const Deal& deal, int rank, int ranks)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    if (deal.rankOf(i, mesh.points.size(), ranks) == rank)
    {
      points->InsertNextPoint(mesh.points[i].data());
      normals->InsertNextTuple(mesh.points[i].data());
    }
  }
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->SetPoints(points);
  part->GetPointData()->SetNormals(normals);
  return part;
}
