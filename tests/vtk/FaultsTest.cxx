// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/RealMeshes.h"
#include "vtk/ErrorLog.h"
#include "vtk/ReadMesh.h"
#include "vtk/Spheres.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkFeatureEdges.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkWindingNumberReport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace
{

using Place = std::array<double, 3>;
using Edge = std::pair<Place, Place>;

Place placeOf(vtkPolyData* data, vtkIdType point)
{
  Place place;
  data->GetPoint(point, place.data());
  return place;
}

/// A copy of a surface with some cells, given by their numbers, left out, turned round or repeated.
vtkSmartPointer<vtkPolyData> damaged(vtkPolyData* surface, const std::vector<vtkIdType>& left,
  const std::vector<vtkIdType>& turned, const std::vector<vtkIdType>& twice)
{
  const auto has = [](const std::vector<vtkIdType>& list, vtkIdType cell)
  {
    return std::find(list.begin(), list.end(), cell) != list.end();
  };
  vtkNew<vtkCellArray> cells;
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, size, ids);
    if (has(left, cell))
    {
      continue;
    }
    if (has(turned, cell))
    {
      cells->InsertNextCell({ids[0], ids[2], ids[1]});
    }
    else
    {
      cells->InsertNextCell(size, ids);
    }
    if (has(twice, cell))
    {
      cells->InsertNextCell(size, ids);
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(surface->GetPoints());
  result->SetPolys(cells);
  return result;
}

class Faults : public testing::Test
{
protected:
  void reportOn(vtkDataObject* source)
  {
    filter->SetInputDataObject(source);
    filter->Update();
  }

  vtkPolyData* block(const std::string& name)
  {
    for (unsigned int i = 0; i < filter->GetFaults()->GetNumberOfBlocks(); ++i)
    {
      auto* found = vtkPolyData::SafeDownCast(filter->GetFaults()->GetBlock(i));
      if (found && filter->GetFaults()->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()) == name)
      {
        return found;
      }
    }
    static const vtkNew<vtkPolyData> none;
    return none;
  }

  /// The number of edges whose sides in a surface's and its caps' triangles do not cancel.
  std::size_t uncancelledEdgesWithCaps(vtkPolyData* surface)
  {
    std::map<Edge, int> nets;
    for (vtkPolyData* part : {surface, this->block("Caps")})
    {
      vtkIdType size;
      const vtkIdType* ids;
      for (vtkIdType cell = 0; cell < part->GetNumberOfPolys(); ++cell)
      {
        part->GetPolys()->GetCellAtId(cell, size, ids);
        for (vtkIdType i = 0; i < size; ++i)
        {
          const Place a = placeOf(part, ids[i]), b = placeOf(part, ids[(i + 1) % size]);
          nets[std::minmax(a, b)] += a < b ? 1 : -1;
        }
      }
    }
    std::size_t result = 0;
    for (const auto& [edge, net] : nets)
    {
      result += net != 0;
    }
    return result;
  }

  vtkNew<vtkWindingNumberReport> filter;
};

TEST_F(Faults, OfAClosedSurfaceAndOfPointsAreNoBlocks)
{
  auto points = sphereOf(20, 20);
  points->SetPolys(vtkSmartPointer<vtkCellArray>::New());
  for (const auto& source : {sphereOf(20, 20), points, vtkSmartPointer<vtkPolyData>::New()})
  {
    this->reportOn(source);
    EXPECT_EQ(filter->GetFaults()->GetNumberOfBlocks(), 0u);
  }
}

TEST_F(Faults, CanBeThickEnoughToBeSeen)
{
  this->reportOn(damaged(sphereOf(20, 20), {30}, {}, {}));
  const double* lines = this->block("Boundary")->GetBounds();
  const double before[2] = {lines[0], lines[1]};
  filter->SetFaultThickness(0.01);
  filter->Update();
  vtkPolyData* tube = this->block("Boundary");
  EXPECT_EQ(tube->GetNumberOfLines(), 0);
  EXPECT_GT(tube->GetNumberOfStrips(), 0);
  EXPECT_NE(tube->GetCellData()->GetArray("Loop"), nullptr);
  const double radius = 0.01 * filter->GetOutput()->GetLength();
  EXPECT_NEAR(tube->GetBounds()[0], before[0] - radius, radius);
  EXPECT_NEAR(tube->GetBounds()[1], before[1] + radius, radius);
  EXPECT_GT(this->block("Caps")->GetNumberOfPolys(), 0) << "caps are no lines";
  filter->SetFaultThickness(-1);
  ErrorLog log(filter);
  filter->Update();
  EXPECT_NE(log.errors().find("FaultThickness is -1"), std::string::npos) << log.errors();
}

TEST_F(Faults, OfHolesAreLoopsAndTheirCaps)
{
  auto source = damaged(sphereOf(20, 20), {30, 200, 201, 350}, {}, {});
  this->reportOn(source);
  vtkPolyData* boundary = this->block("Boundary");
  EXPECT_EQ(boundary->GetNumberOfCells(), filter->GetNumberOfBoundaryLoops());
  EXPECT_EQ(boundary->GetNumberOfPoints(), filter->GetNumberOfBoundaryEdges());
  vtkDataArray* edges = boundary->GetCellData()->GetArray("Edges");
  vtkIdType sum = 0;
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType i = 0; i < boundary->GetNumberOfCells(); ++i)
  {
    boundary->GetLines()->GetCellAtId(i, size, ids);
    EXPECT_EQ(ids[0], ids[size - 1]) << "closed";
    EXPECT_EQ(edges->GetTuple1(i), size - 1);
    EXPECT_EQ(boundary->GetCellData()->GetArray("Loop")->GetTuple1(i), i);
    EXPECT_EQ(boundary->GetCellData()->GetArray("Multiplicity")->GetTuple1(i), 1);
    sum += size - 1;
  }
  EXPECT_EQ(sum, filter->GetNumberOfBoundaryEdges());
  vtkPolyData* caps = this->block("Caps");
  EXPECT_EQ(caps->GetNumberOfCells(), sum - 2 * boundary->GetNumberOfCells());
  EXPECT_EQ(caps->GetCellData()->GetArray("Loop")->GetRange()[1], boundary->GetNumberOfCells() - 1);
  EXPECT_EQ(this->uncancelledEdgesWithCaps(source), 0u);
}

TEST_F(Faults, OfABoundaryHaveTheWidthsOfItsSlits)
{
  // The left half of a strip ends a little before the right half begins.
  constexpr double width = 1e-9;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const double x : {0.0, 1.0, 1 + width, 2.0})
  {
    points->InsertNextPoint(x, 0, 0);
    points->InsertNextPoint(x, 1, 0);
  }
  vtkNew<vtkCellArray> cells;
  for (const vtkIdType first : {0, 4})
  {
    cells->InsertNextCell({first, first + 2, first + 1});
    cells->InsertNextCell({first + 1, first + 2, first + 3});
  }
  vtkNew<vtkPolyData> strip;
  strip->SetPoints(points);
  strip->SetPolys(cells);
  this->reportOn(strip);
  vtkDataArray* widths = this->block("Boundary")->GetCellData()->GetArray("SlitWidth");
  ASSERT_NE(widths, nullptr);
  ASSERT_EQ(widths->GetNumberOfTuples(), 2);
  // The outer edges are a unit away from what runs the opposite way.
  EXPECT_NEAR(widths->GetTuple1(0), 1, 1e-8);
  EXPECT_NEAR(widths->GetTuple1(1), 1, 1e-8);
  EXPECT_EQ(filter->GetWidestSlit(), widths->GetRange()[1]);
  // Edges that two triangles use have no width.
  this->reportOn(damaged(sphereOf(20, 20), {}, {100}, {}));
  widths = this->block("Boundary")->GetCellData()->GetArray("SlitWidth");
  ASSERT_GT(widths->GetNumberOfTuples(), 0);
  EXPECT_TRUE(std::isnan(widths->GetTuple1(0)));
}

TEST_F(Faults, KnowTheirKindsAndAreColouredByThem)
{
  this->reportOn(damaged(sphereOf(20, 20), {30}, {100}, {250}));
  for (const double thickness : {0.0, 0.01})
  {
    filter->SetFaultThickness(thickness);
    filter->Update();
    const char* const names[] = {"Caps", "Boundary", "NonManifoldEdges", "InconsistentEdges"};
    for (int kind = 0; kind < 4; ++kind)
    {
      vtkPolyData* block = this->block(names[kind]);
      vtkDataArray* kinds = block->GetCellData()->GetScalars();
      ASSERT_NE(kinds, nullptr) << names[kind];
      EXPECT_STREQ(kinds->GetName(), "FaultKind");
      ASSERT_EQ(kinds->GetNumberOfTuples(), block->GetNumberOfCells());
      EXPECT_EQ(kinds->GetRange()[0], kind);
      EXPECT_EQ(kinds->GetRange()[1], kind);
    }
  }
}

TEST_F(Faults, OfTurnedAndRepeatedTrianglesAreEdges)
{
  auto source = damaged(sphereOf(20, 20), {}, {100}, {250});
  this->reportOn(source);
  EXPECT_EQ(this->block("InconsistentEdges")->GetNumberOfLines(), 3);
  EXPECT_EQ(this->block("NonManifoldEdges")->GetNumberOfLines(), 3);
  for (vtkIdType i = 0; i < 3; ++i)
  {
    EXPECT_EQ(
      this->block("NonManifoldEdges")->GetCellData()->GetArray("Triangles")->GetTuple1(i), 3);
  }
  // The turned triangle is missing twice; the repeated one is one too many.
  vtkPolyData* boundary = this->block("Boundary");
  ASSERT_EQ(boundary->GetNumberOfCells(), 3);
  double most = 0;
  for (vtkIdType i = 0; i < 3; ++i)
  {
    most = std::max(most, boundary->GetCellData()->GetArray("Multiplicity")->GetTuple1(i));
  }
  EXPECT_EQ(most, 2);
  EXPECT_EQ(this->uncancelledEdgesWithCaps(source), 0u);
}

TEST_F(Faults, EdgeUsedTwiceIsTheLargestOfItsLoopsWhereverItStands)
{
  // Both triangles run along one edge in the same direction.
  const vtkIdType books[][4] = {{2, 0, 1, 3}, {0, 1, 2, 3}, {1, 3, 0, 2}};
  for (const auto& [from, to, one, other] : books)
  {
    vtkNew<vtkPoints> points;
    for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
    {
      points->InsertNextPoint(x, y, x * y);
    }
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell({from, to, one});
    cells->InsertNextCell({from, to, other});
    vtkNew<vtkPolyData> book;
    book->SetPoints(points);
    book->SetPolys(cells);
    this->reportOn(book);
    vtkDataArray* largest = this->block("Boundary")->GetCellData()->GetArray("Multiplicity");
    ASSERT_EQ(largest->GetNumberOfTuples(), 2);
    EXPECT_EQ(largest->GetTuple1(0), 2) << from << " " << to;
    EXPECT_EQ(largest->GetTuple1(1), 2) << from << " " << to;
  }
}

TEST_F(Faults, AreOfTheSurfaceThatComesOut)
{
  ErrorLog log(filter);
  filter->FixOrientationOn();
  this->reportOn(damaged(sphereOf(20, 20), {}, {100, 101, 102}, {}));
  EXPECT_EQ(this->block("InconsistentEdges")->GetNumberOfLines(), 0);
  EXPECT_EQ(this->block("Boundary")->GetNumberOfLines(), 0);
}

TEST_F(Faults, HaveThePrecisionOfTheSource)
{
  auto source = damaged(sphereOf(20, 20), {30}, {}, {});
  this->reportOn(source);
  EXPECT_EQ(this->block("Caps")->GetPoints()->GetDataType(), VTK_FLOAT);
  vtkNew<vtkPoints> exact;
  exact->SetDataTypeToDouble();
  exact->DeepCopy(source->GetPoints());
  exact->SetPoint(0, 1.0 / 3, 0, 0);
  auto fine = vtkSmartPointer<vtkPolyData>::New();
  fine->SetPoints(exact);
  fine->SetPolys(source->GetPolys());
  this->reportOn(fine);
  EXPECT_EQ(this->block("Caps")->GetPoints()->GetDataType(), VTK_DOUBLE);
}

TEST_F(Faults, AreTheSecondOutputInAPipeline)
{
  vtkNew<vtkWindingNumberReport> first;
  first->SetInputData(damaged(sphereOf(20, 20), {30}, {}, {}));
  first->UpdatePiece(1, 2, 0); // the first piece has all blocks
  EXPECT_EQ(first->GetFaults()->GetNumberOfBlocks(), 0u);
  first->Update(1);
  EXPECT_EQ(first->GetFaults()->GetNumberOfBlocks(), 2u);
}

TEST_F(Faults, OfRealMeshesAreThoseOfOthers)
{
  // The points of these meshes are welded, as vtkFeatureEdges needs them.
  for (const char* name : shapes::present({"bunny_res2_nonmanifold.ply", "truck_soup.obj",
         "maxplanck_open_90k.obj", "bunny_10k.obj", "self_intersectA.obj"}))
  {
    SCOPED_TRACE(name);
    auto source = readMesh(shapes::realMesh(name));
    this->reportOn(source);
    vtkNew<vtkFeatureEdges> edges;
    edges->SetInputData(source);
    edges->FeatureEdgesOff();
    edges->BoundaryEdgesOff();
    edges->NonManifoldEdgesOn();
    edges->Update();
    // vtkFeatureEdges gives an edge once for each triangle beyond the second or so, so that only
    // the places of edges are compared.
    std::map<Edge, int> found, expected;
    const auto collect = [](vtkPolyData* lines, std::map<Edge, int>& places)
    {
      vtkIdType size;
      const vtkIdType* ids;
      for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
      {
        lines->GetLines()->GetCellAtId(i, size, ids);
        const Place a = placeOf(lines, ids[0]), b = placeOf(lines, ids[1]);
        places[std::minmax(a, b)] = 1;
      }
    };
    collect(this->block("NonManifoldEdges"), found);
    collect(edges->GetOutput(), expected);
    EXPECT_EQ(found, expected);
    EXPECT_EQ(
      this->block("NonManifoldEdges")->GetNumberOfLines(), filter->GetNumberOfNonManifoldEdges());
    EXPECT_EQ(
      this->block("InconsistentEdges")->GetNumberOfLines(), filter->GetNumberOfInconsistentEdges());
    EXPECT_EQ(this->uncancelledEdgesWithCaps(source), 0u);
  }
}

} // namespace
