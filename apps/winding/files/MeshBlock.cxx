// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/MeshBlock.h"

#include "vtkCellArray.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

bool areAnyClear(const std::vector<MeshColor>& colors)
{
  return std::any_of(
    colors.begin(), colors.end(), [](const MeshColor& color) { return color[3] != white[3]; });
}

void appendBlock(const MeshBlock& block, bool withOpacity, vtkMultiBlockDataSet* output)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Eigen::Vector3d& point : block.points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> triangles, lines, vertices;
  for (const auto& triangle : block.triangles)
  {
    triangles->InsertNextCell(3, triangle.data());
  }
  for (const auto& line : block.lines)
  {
    lines->InsertNextCell(2, line.data());
  }
  for (const vtkIdType vertex : block.vertices)
  {
    vertices->InsertNextCell(1, &vertex);
  }
  data->SetPoints(points);
  data->SetPolys(triangles);
  data->SetLines(lines);
  data->SetVerts(vertices);
  if (block.triangles.empty() && !block.normals.empty())
  {
    vtkNew<vtkDoubleArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    for (std::size_t i = 0; i < block.points.size(); ++i)
    {
      const Eigen::Vector3d normal =
        i < block.normals.size() ? block.normals[i] : Eigen::Vector3d(0, 0, 0);
      normals->InsertNextTuple(normal.data());
    }
    data->GetPointData()->SetNormals(normals);
  }
  if (!block.colors.empty())
  {
    vtkNew<vtkUnsignedCharArray> colors; // as vtkWindingNumberReader names them
    colors->SetName(withOpacity ? "RGBA" : "RGB");
    colors->SetNumberOfComponents(withOpacity ? 4 : 3);
    colors->SetNumberOfTuples(points->GetNumberOfPoints());
    for (std::size_t i = 0; i < block.points.size(); ++i)
    {
      const MeshColor color = i < block.colors.size() ? block.colors[i] : white;
      colors->SetTypedTuple(static_cast<vtkIdType>(i), color.data());
    }
    data->GetPointData()->SetScalars(colors);
  }
  const unsigned int number = output->GetNumberOfBlocks();
  output->SetBlock(number, data);
  if (!block.name.empty())
  {
    output->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), block.name.c_str());
  }
}
