// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/CellTypes.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{

vtkSmartPointer<vtkCell> cellOf(int type)
{
  return vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
}

} // namespace

TEST(CellTypes, AreThoseOfVtk)
{
  int known = 0;
  for (int type = 0; type < 256; ++type)
  {
    SCOPED_TRACE("type " + std::to_string(type));
    const auto cell = cellOf(type);
    if (!cell)
    {
      continue; // versions of VTK have more or fewer
    }
    ++known;
    EXPECT_EQ(winding::dimensionOf(type), cell->GetCellDimension());
    EXPECT_EQ(winding::isCurved(type), !cell->IsLinear());
    EXPECT_EQ(winding::fewestPointsOf(type), cell->GetNumberOfPoints());
    if (cell->GetCellDimension() == 3 && !cell->IsLinear())
    {
      const auto straight = cellOf(winding::straightTypeOf(type));
      EXPECT_EQ(straight->GetNumberOfEdges(), cell->GetNumberOfEdges());
      EXPECT_EQ(straight->GetNumberOfFaces(), cell->GetNumberOfFaces());
    }
  }
  EXPECT_GT(known, 45);
  for (const int type : {-1, 17, 40, 50, 200, 255, 256})
  {
    EXPECT_EQ(winding::dimensionOf(type), -1);
    EXPECT_EQ(winding::straightTypeOf(type), type);
  }
}

TEST(CellTypes, FacesAreThoseOfVtkAndClose)
{
  for (int type = VTK_TETRA; type <= VTK_HEXAGONAL_PRISM; ++type)
  {
    SCOPED_TRACE("type " + std::to_string(type));
    const auto cell = cellOf(type);
    std::vector<std::vector<int>> faces(1);
    for (const int corner : winding::facesOf(type))
    {
      if (corner < 0)
      {
        faces.emplace_back();
        continue;
      }
      faces.back().push_back(corner);
    }
    faces.pop_back();
    ASSERT_EQ(static_cast<int>(faces.size()), cell->GetNumberOfFaces());
    std::multiset<std::pair<int, int>> edges, reversed;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      for (vtkIdType id = 0; id < cell->GetNumberOfPoints(); ++id)
      {
        cell->GetPointIds()->SetId(id, id);
      }
      vtkIdList* const ids = cell->GetFace(static_cast<int>(i))->GetPointIds();
      EXPECT_EQ(std::set<vtkIdType>(ids->begin(), ids->end()),
        std::set<vtkIdType>(faces[i].begin(), faces[i].end()));
      for (std::size_t at = 0; at < faces[i].size(); ++at)
      {
        const int from = faces[i][at], to = faces[i][(at + 1) % faces[i].size()];
        edges.emplace(from, to);
        reversed.emplace(to, from);
      }
    }
    EXPECT_EQ(edges, reversed);
  }
  EXPECT_TRUE(winding::facesOf(VTK_POLYHEDRON).empty());
}

TEST(CellTypes, HaveTheNumbersOfPointsOfTheirDegrees)
{
  const std::pair<int, std::vector<int>> counts[] = {{VTK_LAGRANGE_TRIANGLE, {3, 6, 7, 10, 15, 21}},
    {VTK_LAGRANGE_QUADRILATERAL, {4, 9, 16, 25}}, {VTK_LAGRANGE_TETRAHEDRON, {4, 10, 20, 15}},
    {VTK_LAGRANGE_HEXAHEDRON, {8, 27, 64}}, {VTK_BEZIER_WEDGE, {6, 18, 40, 21}}};
  for (const auto& [type, right] : counts)
  {
    for (int points = 0; points < 28; ++points)
    {
      EXPECT_EQ(winding::canHavePoints(type, points),
        std::find(right.begin(), right.end(), points) != right.end())
        << type << " with " << points;
    }
  }
  const double degrees[] = {1, 2, 3}, none[] = {1, 0, 1};
  EXPECT_TRUE(winding::canHavePoints(VTK_LAGRANGE_HEXAHEDRON, 24, degrees));
  EXPECT_FALSE(winding::canHavePoints(VTK_LAGRANGE_HEXAHEDRON, 27, degrees));
  EXPECT_FALSE(winding::canHavePoints(VTK_LAGRANGE_HEXAHEDRON, 4, none));
  EXPECT_TRUE(winding::canHavePoints(VTK_POLYGON, 17));
  EXPECT_FALSE(winding::canHavePoints(VTK_HEXAHEDRON, 7));
}
