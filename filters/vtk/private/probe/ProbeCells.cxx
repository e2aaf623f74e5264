// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/probe/ProbeCells.h"

#include "private/probe/ProbeQueries.h"
#include "private/source/CellChecks.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace winding
{

namespace
{

void addPolyhedron(vtkUnstructuredGrid* mesh, vtkIdType cell, vtkIdList* own, CellShape& shape)
{
  std::vector<std::int64_t> ids;
  appendFaces(mesh, cell, ids);
  std::vector<int> face;
  for (std::size_t at = 1; at < ids.size();)
  {
    const std::size_t end = at + 1 + static_cast<std::size_t>(ids[at]);
    face.clear();
    for (++at; at < end; ++at)
    {
      face.push_back(static_cast<int>(own->IsId(ids[at])));
    }
    shape.addFace(face.data(), static_cast<int>(face.size()));
  }
}

/// Sets the shape to the tetrahedra that VTK cuts a cell into, each turned outward.
void setTetrahedra(vtkDataSet* data, vtkIdType number, CellShape& shape)
{
  vtkNew<vtkGenericCell> cell;
  data->GetCell(number, cell);
  vtkNew<vtkIdList> ids;
  vtkNew<vtkPoints> points;
  cell->Triangulate(0, ids, points);
  shape.clear();
  for (vtkIdType first = 0; first + 4 <= points->GetNumberOfPoints(); first += 4)
  {
    std::array<Eigen::Vector3d, 4> corners;
    for (vtkIdType i = 0; i < 4; ++i)
    {
      points->GetPoint(first + i, corners[static_cast<std::size_t>(i)].data());
    }
    const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    if (normal.dot(corners[3] - corners[0]) < 0)
    {
      std::swap(corners[0], corners[1]);
    }
    const int base = static_cast<int>(shape.points.size());
    shape.points.insert(shape.points.end(), corners.begin(), corners.end());
    for (const auto& [a, b, c] : {std::array{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 1}})
    {
      const int face[] = {base + a, base + b, base + c};
      shape.addFace(face, 3);
    }
  }
}

} // namespace

ProbeCells::ProbeCells(const ProbeQueries& queries)
  : frame_(queries.frame())
{
  for (const ProbeLeaf& leaf : queries.leaves())
  {
    data_.emplace_back(leaf.data);
    const vtkIdType count = leaf.data->GetNumberOfCells();
    starts_.push_back(starts_.back() + static_cast<std::size_t>(count));
    if (count > 0)
    {
      // A vtkPolyData makes its lists of cells when it is asked for one, which threads must not do.
      data_.back()->GetCellType(0);
    }
  }
}

void ProbeCells::get(std::size_t cell, CellShape& shape) const
{
  const auto next = std::upper_bound(starts_.begin(), starts_.end(), cell);
  const auto leaf = static_cast<std::size_t>(next - starts_.begin()) - 1;
  vtkDataSet* data = data_[leaf];
  const auto number = static_cast<vtkIdType>(cell - starts_[leaf]);
  const int type = data->GetCellType(number);
  if (type == VTK_EMPTY_CELL)
  {
    return;
  }
  vtkNew<vtkIdList> ids;
  data->GetCellPoints(number, ids);
  shape.points.resize(static_cast<std::size_t>(ids->GetNumberOfIds()));
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    data->GetPoint(ids->GetId(i), shape.points[static_cast<std::size_t>(i)].data());
  }
  if (type == VTK_CONVEX_POINT_SET)
  {
    setTetrahedra(data, number, shape);
  }
  else if (type == VTK_POLYHEDRON)
  {
    addPolyhedron(vtkUnstructuredGrid::SafeDownCast(data), number, ids, shape);
  }
  else
  {
    shape.addFacesOf(type);
  }
  if (!frame_.isStraight())
  {
    for (Eigen::Vector3d& point : shape.points)
    {
      point = frame_.position(point);
    }
  }
}

} // namespace winding
