// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause

// A fuzzer of the surfaces that come out: closed ones, without edges of more than two faces, smooth
// ones without two points at one place and sharp ones (vtkWindingNumberSurface), and closed ones of
// voxels (vtkWindingNumberVoxels). Sources are random meshes and clouds.

#include "RandomSources.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberSurface.h"
#include "vtkWindingNumberVoxels.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>

namespace
{

using shapes::Point;

[[noreturn]] void fail(const char* what)
{
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

vtkSmartPointer<vtkPoints> pointsOf(const std::vector<Point>& positions)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (const Point& position : positions)
  {
    points->InsertNextPoint(position.data());
  }
  return points;
}

vtkSmartPointer<vtkPolyData> dataOf(const shapes::Mesh& mesh)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(pointsOf(mesh.points));
  vtkNew<vtkCellArray> polys;
  for (const auto& triangle : mesh.triangles)
  {
    const vtkIdType ids[] = {triangle[0], triangle[1], triangle[2]};
    polys->InsertNextCell(3, ids);
  }
  data->SetPolys(polys);
  return data;
}

vtkSmartPointer<vtkPolyData> dataOf(const fuzz::RandomCloud& cloud)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(pointsOf(cloud.cloud.positions));
  const auto normals = pointsOf(cloud.cloud.normals);
  normals->GetData()->SetName("Normals");
  data->GetPointData()->SetNormals(normals->GetData());
  return data;
}

/// How often each undirected edge is used, and in which direction more often.
std::map<std::array<vtkIdType, 2>, std::array<int, 2>> edgesOf(vtkPolyData* surface)
{
  std::map<std::array<vtkIdType, 2>, std::array<int, 2>> edges;
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      const vtkIdType from = ids[i], to = ids[(i + 1) % size];
      auto& [uses, excess] = edges[{std::min(from, to), std::max(from, to)}];
      ++uses;
      excess += from < to ? 1 : -1;
    }
  }
  return edges;
}

void checkSurface(vtkPolyData* surface, bool isManifold, bool arePlacesDistinct)
{
  std::set<std::array<double, 3>> places;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> place;
    surface->GetPoint(i, place.data());
    if (!std::isfinite(place[0]) || !std::isfinite(place[1]) || !std::isfinite(place[2]))
    {
      fail("a vertex is not finite");
    }
    if (!places.insert(place).second && arePlacesDistinct)
    {
      fail("two vertices have one place");
    }
  }
  for (const auto& [edge, use] : edgesOf(surface))
  {
    if (use[1] != 0)
    {
      fail("the surface is not closed");
    }
    if (isManifold && use[0] != 2)
    {
      fail("an edge has more than two faces");
    }
  }
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  vtkOutputWindow::GetInstance()->SetDisplayModeToNever();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  fuzz::Choices choices(bytes, size);
  const auto data = choices.oneIn(4) ? dataOf(fuzz::randomCloud(choices, 20))
                                     : dataOf(fuzz::randomMesh(choices, 16));
  const int resolution = 2 + choices.below(7), method = choices.oneIn(2) ? 0 : choices.below(5);
  const int rule = choices.below(3);
  vtkNew<vtkWindingNumberSurface> smooth;
  smooth->SetInputData(data);
  smooth->SetResolution(resolution);
  smooth->SetMethod(method);
  smooth->SetInsideRule(rule);
  smooth->SetNumberOfThreads(1);
  smooth->CloseBorderOn();
  smooth->SetPadding(choices.oneIn(2) ? 0 : 0.1);
  smooth->Update();
  checkSurface(smooth->GetOutput(), true, true);
  smooth->SetOffset(choices.oneIn(2) ? choices.between(-1, 1) : 0);
  smooth->SetShell(choices.oneIn(2) ? choices.between(0, 1) : 0);
  smooth->SetShellSide(choices.below(3));
  smooth->SetFillCavities(choices.oneIn(2));
  smooth->SetGapWidth(choices.oneIn(2) ? 0 : choices.between(0, 0.5));
  smooth->Update();
  checkSurface(smooth->GetOutput(), true, true);
  // The vertices of two patches in one cell may have one place.
  smooth->SetFeatures(vtkWindingNumberSurface::SHARP);
  smooth->SetGenerateTriangles(choices.oneIn(2));
  smooth->Update();
  checkSurface(smooth->GetOutput(), true, false);
  vtkNew<vtkWindingNumberField> field;
  field->SetInputData(data);
  field->SetResolution(resolution);
  field->SetMethod(method);
  field->SetNumberOfThreads(1);
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputConnection(field->GetOutputPort());
  voxels->SetInsideRule(rule);
  voxels->Update();
  checkSurface(voxels->GetOutput(), false, true);
  return 0;
}
