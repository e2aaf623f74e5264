// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRTAnalyticSource.h"
#include "vtkRectilinearGrid.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWindingNumberProbe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <set>

namespace
{

constexpr double side = 0.851; // side of the cube around the origin, whose faces meet no query

bool isInCube(const double x[3])
{
  return std::abs(x[0]) < side / 2 && std::abs(x[1]) < side / 2 && std::abs(x[2]) < side / 2;
}

vtkSmartPointer<vtkIdTypeArray> numbers(vtkIdType count)
{
  auto array = vtkSmartPointer<vtkIdTypeArray>::New();
  array->SetName("number");
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->InsertNextValue(i);
  }
  return array;
}

/// Numbers the points and the cells, twice each: as an array, and as global ids.
void addNumbers(vtkDataSet* data)
{
  for (auto [attributes, count] :
    {std::pair<vtkDataSetAttributes*, vtkIdType>(data->GetPointData(), data->GetNumberOfPoints()),
      std::pair<vtkDataSetAttributes*, vtkIdType>(data->GetCellData(), data->GetNumberOfCells())})
  {
    attributes->AddArray(numbers(count));
    auto ids = numbers(count);
    ids->SetName("global");
    attributes->SetGlobalIds(ids);
  }
  vtkNew<vtkStringArray> note;
  note->SetName("note");
  note->InsertNextValue("kept");
  data->GetFieldData()->AddArray(note);
}

vtkIdType numberOf(vtkDataSetAttributes* attributes, vtkIdType i)
{
  return static_cast<vtkIdType>(attributes->GetArray("number")->GetTuple1(i));
}

class ProbeExtraction : public testing::Test
{
protected:
  ProbeExtraction()
  {
    this->makeCube(side);
    probe->SetSourceConnection(cube->GetOutputPort());
    probe->ExtractInsideOn();
  }

  void makeCube(double length)
  {
    cube->SetXLength(length);
    cube->SetYLength(length);
    cube->SetZLength(length);
  }

  /// Expects points and cells that were kept to be the queries', with all that belongs to
  /// them.
  void expectKept(vtkDataSet* queries, const std::set<vtkIdType>& cells)
  {
    vtkDataSet* part = probe->GetOutput();
    ASSERT_NE(part, nullptr);
    ASSERT_EQ(part->GetNumberOfCells(), static_cast<vtkIdType>(cells.size()));
    std::set<vtkIdType> points;
    vtkNew<vtkIdList> ids, expectedIds;
    vtkIdType last = -1;
    for (vtkIdType i = 0; i < part->GetNumberOfCells(); ++i)
    {
      const vtkIdType cell = numberOf(part->GetCellData(), i);
      EXPECT_EQ(cells.count(cell), 1u) << cell;
      EXPECT_GT(cell, last) << "in their order";
      last = cell;
      EXPECT_EQ(part->GetCellType(i), queries->GetCellType(cell));
      EXPECT_EQ(part->GetCellData()->GetGlobalIds()->GetTuple1(i), cell);
      part->GetCellPoints(i, ids);
      queries->GetCellPoints(cell, expectedIds);
      ASSERT_EQ(ids->GetNumberOfIds(), expectedIds->GetNumberOfIds());
      for (vtkIdType corner = 0; corner < ids->GetNumberOfIds(); ++corner)
      {
        const vtkIdType point = numberOf(part->GetPointData(), ids->GetId(corner));
        EXPECT_EQ(point, expectedIds->GetId(corner));
        points.insert(point);
      }
    }
    EXPECT_EQ(part->GetNumberOfPoints(), static_cast<vtkIdType>(points.size()))
      << "no point twice, and none that is not needed";
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      const vtkIdType point = numberOf(part->GetPointData(), i);
      EXPECT_EQ(part->GetPointData()->GetGlobalIds()->GetTuple1(i), point);
      double x[3], expected[3];
      part->GetPoint(i, x);
      queries->GetPoint(point, expected);
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_EQ(x[axis], expected[axis]);
      }
    }
    EXPECT_NE(part->GetFieldData()->GetAbstractArray("note"), nullptr);
    EXPECT_NE(part->GetFieldData()->GetAbstractArray("WindingNumberMethod"), nullptr);
  }

  /// The cells for which isKept() is true.
  static std::set<vtkIdType> cellsOf(
    vtkDataSet* queries, const std::function<bool(vtkIdType cell)>& isKept)
  {
    std::set<vtkIdType> cells;
    for (vtkIdType i = 0; i < queries->GetNumberOfCells(); ++i)
    {
      if (isKept(i))
      {
        cells.insert(i);
      }
    }
    return cells;
  }

  /// The cells all of whose points are in the cube, or out of it.
  static std::set<vtkIdType> cellsInCube(vtkDataSet* queries, bool inside = true)
  {
    return cellsOf(queries,
      [&](vtkIdType cell)
      {
        vtkNew<vtkIdList> ids;
        queries->GetCellPoints(cell, ids);
        bool all = ids->GetNumberOfIds() > 0;
        for (const vtkIdType id : *ids)
        {
          all = all && isInCube(queries->GetPoint(id)) == inside;
        }
        return all;
      });
  }

  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkWindingNumberProbe> probe;
};

vtkSmartPointer<vtkImageData> image()
{
  auto queries = vtkSmartPointer<vtkImageData>::New();
  queries->SetDimensions(12, 11, 10);
  queries->SetSpacing(0.11, 0.12, 0.13);
  queries->SetOrigin(-0.6, -0.61, -0.62);
  addNumbers(queries);
  return queries;
}

TEST_F(ProbeExtraction, OfAnImageIsAnUnstructuredGridOfItsVoxels)
{
  const auto queries = image();
  probe->SetInputData(queries);
  probe->GenerateInsideOn();
  probe->Update();
  EXPECT_NE(vtkUnstructuredGrid::SafeDownCast(probe->GetOutput()), nullptr);
  EXPECT_GT(cellsInCube(queries).size(), 50u);
  this->expectKept(queries, cellsInCube(queries));
  vtkPointData* data = probe->GetOutput()->GetPointData();
  EXPECT_EQ(data->GetArray("Inside")->GetRange()[0], 1);
  EXPECT_NEAR(data->GetArray("WindingNumber")->GetRange()[0], 1, 1e-6);
  EXPECT_EQ(data->GetScalars(), data->GetArray("WindingNumber"));

  // The output is of the queries' class again when extraction is off.
  probe->ExtractInsideOff();
  probe->Update();
  EXPECT_NE(vtkImageData::SafeDownCast(probe->GetOutput()), nullptr);
  EXPECT_EQ(probe->GetOutput()->GetNumberOfPoints(), queries->GetNumberOfPoints());
}

TEST_F(ProbeExtraction, WithInsideOutIsWhatIsOutside)
{
  const auto queries = image();
  probe->SetInputData(queries);
  probe->InsideOutOn();
  probe->Update();
  this->expectKept(queries, cellsInCube(queries, false));
  EXPECT_EQ(probe->GetOutput()->GetPointData()->GetArray("Inside"), nullptr) << "not asked for";
  EXPECT_NEAR(
    probe->GetOutput()->GetPointData()->GetArray("WindingNumber")->GetRange()[1], 0, 1e-6);
}

TEST_F(ProbeExtraction, ByCellsGoesByTheirCentres)
{
  const auto queries = image();
  probe->SetInputData(queries);
  probe->SetProbeAssociationToCells();
  const auto inside = cellsOf(queries,
    [&](vtkIdType cell)
    {
      double bounds[6], center[3];
      queries->GetCellBounds(cell, bounds);
      for (int axis = 0; axis < 3; ++axis)
      {
        center[axis] = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
      }
      return isInCube(center);
    });
  EXPECT_GT(inside.size(), cellsInCube(queries).size());
  probe->Update();
  this->expectKept(queries, inside);
  probe->InsideOutOn();
  probe->Update();
  this->expectKept(queries, cellsOf(queries, [&](vtkIdType cell) { return !inside.count(cell); }));
}

TEST_F(ProbeExtraction, OfPolyDataIsPolyDataWithAllKindsOfCells)
{
  vtkNew<vtkPolyData> queries;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 40; ++i)
  {
    points->InsertNextPoint(0.04 * i - 0.6, 0.02 * (i % 3), 0.03 * (i % 2));
  }
  queries->SetPoints(points);
  vtkNew<vtkCellArray> vertices, lines, polygons, strips;
  for (vtkIdType i = 0; i < 38; i += 2)
  {
    vertices->InsertNextCell({i});
    lines->InsertNextCell({i, i + 1});
    polygons->InsertNextCell({i, i + 1, i + 2});
  }
  vertices->InsertNextCell({12, 13, 14, 39});
  lines->InsertNextCell({12, 14, 16, 18});
  polygons->InsertNextCell({10, 12, 14, 16, 18});
  strips->InsertNextCell({11, 12, 13, 14, 15});
  strips->InsertNextCell({1, 2, 3, 4});
  queries->SetVerts(vertices);
  queries->SetLines(lines);
  queries->SetPolys(polygons);
  queries->SetStrips(strips);
  addNumbers(queries);
  probe->SetInputData(queries);
  probe->Update();
  auto* part = vtkPolyData::SafeDownCast(probe->GetOutput());
  ASSERT_NE(part, nullptr);
  EXPECT_EQ(part->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(part->GetNumberOfStrips(), 1);
  EXPECT_GT(part->GetNumberOfPolys(), 5);
  this->expectKept(queries, cellsInCube(queries));
}

TEST_F(ProbeExtraction, OfPointsIsThosePoints)
{
  vtkNew<vtkPointSource> source;
  source->SetNumberOfPoints(500);
  source->SetRadius(0.8);
  source->Update();
  vtkNew<vtkPolyData> bare, polyVertex;
  bare->SetPoints(source->GetOutput()->GetPoints());
  polyVertex->ShallowCopy(source->GetOutput());
  ASSERT_EQ(polyVertex->GetNumberOfCells(), 1) << "one cell of all points";
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(bare->GetPoints());
  for (vtkPointSet* queries : std::initializer_list<vtkPointSet*>{bare, polyVertex, grid})
  {
    addNumbers(queries);
    probe->SetInputData(queries);
    probe->Update();
    vtkDataSet* part = probe->GetOutput();
    EXPECT_STREQ(part->GetClassName(), queries->GetClassName());
    vtkIdType next = 0;
    for (vtkIdType i = 0; i < queries->GetNumberOfPoints(); ++i)
    {
      if (isInCube(queries->GetPoint(i)))
      {
        ASSERT_LT(next, part->GetNumberOfPoints());
        EXPECT_EQ(numberOf(part->GetPointData(), next), i);
        EXPECT_EQ(part->GetPointData()->GetGlobalIds()->GetTuple1(next), i);
        EXPECT_EQ(part->GetCellType(next), VTK_VERTEX);
        ++next;
      }
    }
    EXPECT_GT(next, 50);
    EXPECT_EQ(part->GetNumberOfPoints(), next);
    EXPECT_EQ(part->GetNumberOfCells(), next);
    EXPECT_EQ(part->GetCellData()->GetNumberOfArrays(), 0);
  }
}

TEST_F(ProbeExtraction, OfAnyStructuredGrid)
{
  vtkNew<vtkRectilinearGrid> queries;
  vtkNew<vtkDoubleArray> coordinates;
  for (const double x : {-0.7, -0.3, -0.1, 0.0, 0.2, 0.4, 0.9})
  {
    coordinates->InsertNextValue(x);
  }
  queries->SetDimensions(7, 7, 7);
  queries->SetXCoordinates(coordinates);
  queries->SetYCoordinates(coordinates);
  queries->SetZCoordinates(coordinates);
  addNumbers(queries);
  probe->SetInputData(queries);
  probe->Update();
  EXPECT_GT(probe->GetOutput()->GetNumberOfCells(), 10);
  this->expectKept(queries, cellsInCube(queries));
}

TEST_F(ProbeExtraction, TakesPointsThatAreNowhereForNeither)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(3, 0, 0);
  points->InsertNextPoint(0, std::numeric_limits<double>::infinity(), 0);
  vtkNew<vtkPolyData> queries;
  queries->SetPoints(points);
  addNumbers(queries);
  probe->SetInputData(queries);
  for (const bool insideOut : {false, true})
  {
    probe->SetInsideOut(insideOut);
    probe->Update();
    ASSERT_EQ(probe->GetOutput()->GetNumberOfPoints(), 1);
    EXPECT_EQ(numberOf(probe->GetOutput()->GetPointData(), 0), insideOut ? 2 : 1);
    const int expected[] = {0, !insideOut, insideOut, 0};
    for (vtkIdType i = 0; i < 4; ++i)
    {
      EXPECT_EQ(probe->IsInside(i), expected[i]) << i;
    }
  }
}

TEST_F(ProbeExtraction, OfNothingIsNothing)
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPolyData> polyData;
  vtkNew<vtkPoints> far;
  far->InsertNextPoint(9, 9, 9);
  vtkNew<vtkPolyData> outside;
  outside->SetPoints(far);
  ErrorLog log(probe);
  for (vtkDataSet* queries : std::initializer_list<vtkDataSet*>{grid, polyData, outside})
  {
    for (const int association : {vtkWindingNumberProbe::POINTS, vtkWindingNumberProbe::CELLS})
    {
      probe->SetProbeAssociation(association);
      probe->SetInputData(queries);
      probe->Update();
      EXPECT_EQ(log.errors(), "");
      EXPECT_EQ(probe->GetOutput()->GetNumberOfPoints(), 0);
      EXPECT_EQ(probe->GetOutput()->GetNumberOfCells(), 0);
    }
  }
}

/// Cells that the pieces of the queries share are extracted with each piece that has them.
TEST_F(ProbeExtraction, LeavesCellsWithoutPointsOut)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.1, 0, 0);
  points->InsertNextPoint(0, 0.1, 0);
  points->InsertNextPoint(7, 0, 0);
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  const vtkIdType ids[3] = {0, 1, 2};
  grid->InsertNextCell(VTK_EMPTY_CELL, 0, ids);
  grid->InsertNextCell(VTK_LINE, 2, ids);
  grid->InsertNextCell(VTK_LINE, 2, ids + 1);
  addNumbers(grid);
  probe->SetInputData(grid);
  probe->Update();
  this->expectKept(grid, {1});
}

TEST_F(ProbeExtraction, FollowsThePiecesOfTheQueries)
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-9, 9, -9, 9, -9, 9);
  this->makeCube(12.1);
  probe->SetInputConnection(wavelet->GetOutputPort());
  probe->Update();
  const vtkIdType whole = probe->GetOutput()->GetNumberOfCells();
  EXPECT_GT(whole, 300);
  vtkIdType sum = 0;
  for (int piece = 0; piece < 3; ++piece)
  {
    probe->UpdatePiece(piece, 3, 0);
    EXPECT_LT(probe->GetOutput()->GetNumberOfCells(), whole);
    sum += probe->GetOutput()->GetNumberOfCells();
  }
  EXPECT_EQ(sum, whole);
}

/// Without other arrays only the geometry is left.
TEST_F(ProbeExtraction, NeedsNoArrays)
{
  const auto queries = image();
  probe->SetInputData(queries);
  probe->GenerateWindingNumberOff();
  probe->Update();
  this->expectKept(queries, cellsInCube(queries));
  EXPECT_EQ(probe->GetOutput()->GetPointData()->GetArray("WindingNumber"), nullptr);
  EXPECT_EQ(probe->GetOutput()->GetPointData()->GetArray("Inside"), nullptr);
  ErrorLog log(probe);
  probe->ExtractInsideOff();
  probe->Update();
  EXPECT_NE(log.errors().find("nothing is to be generated"), std::string::npos) << log.errors();
}

} // namespace
