#include "vtkCallbackCommand.h"
#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkCellTypeSource.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"
#include "vtkSurfaceReport.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWindingNumberProbe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

namespace
{

using Map = std::function<void(double*)>;

/// Returns the cube [0, 2]³ as cells of a type, with its points moved.
vtkSmartPointer<vtkUnstructuredGrid> cubeOf(int cellType, const Map& map, int order = 2)
{
  vtkNew<vtkCellTypeSource> source;
  source->SetCellType(cellType);
  source->SetCellOrder(order);
  source->SetBlocksDimensions(2, 2, 2);
  source->SetOutputPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkSmartPointer<vtkUnstructuredGrid> cube = source->GetOutput();
  for (vtkIdType i = 0; i < cube->GetNumberOfPoints(); ++i)
  {
    double point[3];
    cube->GetPoint(i, point);
    map(point);
    cube->GetPoints()->SetPoint(i, point);
  }
  return cube;
}

void stay(double*) {}

void mirror(double* point)
{
  point[0] = 2 - point[0];
}

/// Bends the side at x = 2, so that the volume becomes 11.2. Cells of degree 2 can follow.
void bend(double* point)
{
  point[0] *= 1 + 0.3 * point[1] * point[1];
}

void bendAndMirror(double* point)
{
  bend(point);
  point[0] = -point[0];
}

/// Returns a grid with the nodes of every other cell in another order.
vtkSmartPointer<vtkUnstructuredGrid> withEveryOtherReordered(
  vtkUnstructuredGrid* grid, const std::vector<int>& order)
{
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result->SetPoints(grid->GetPoints());
  result->Allocate(grid->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    grid->GetCellPoints(cell, ids);
    std::vector<vtkIdType> nodes(ids->begin(), ids->end());
    if (cell % 2 == 1)
    {
      std::transform(
        order.begin(), order.end(), nodes.begin(), [&](int node) { return ids->GetId(node); });
    }
    result->InsertNextCell(
      grid->GetCellType(cell), static_cast<vtkIdType>(nodes.size()), nodes.data());
  }
  return result;
}

vtkSmartPointer<vtkSurfaceReport> reportOn(vtkDataObject* mesh, bool usesSurfaceCells = false)
{
  auto report = vtkSmartPointer<vtkSurfaceReport>::New();
  report->SetUseSurfaceCells(usesSurfaceCells);
  report->SetInputDataObject(mesh);
  report->Update();
  return report;
}

/// Returns the winding numbers of a mesh at points, and the last warning if asked for.
std::vector<double> valuesAt(vtkDataObject* mesh, const std::vector<std::array<double, 3>>& places,
  std::string* warning = nullptr, bool usesSurfaceCells = false)
{
  vtkNew<vtkPolyData> samples;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& place : places)
  {
    points->InsertNextPoint(place.data());
  }
  samples->SetPoints(points);
  vtkNew<vtkWindingNumberProbe> probe;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(warning);
  observer->SetCallback(
    [](vtkObject*, unsigned long, void* text, void* said)
    {
      if (text)
      {
        *static_cast<std::string*>(text) = static_cast<const char*>(said);
      }
    });
  probe->AddObserver(vtkCommand::WarningEvent, observer);
  probe->SetInputData(samples);
  probe->SetSourceData(mesh);
  probe->SetUseSurfaceCells(usesSurfaceCells);
  probe->Update();
  auto* output = vtkDataSet::SafeDownCast(probe->GetOutputDataObject(0));
  vtkDataArray* array = output->GetPointData()->GetArray("WindingNumber");
  std::vector<double> values;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

const std::vector<std::array<double, 3>> insideAndOutside = {
  {0.3, 0.4, 0.55}, {1.7, 1.1, 1.3}, {0.9, 1.6, 0.2}, {2.5, 1, 1}, {-0.4, 1, 1}, {1, 1, 2.3}};

void expectTheCube(vtkDataObject* mesh)
{
  const std::vector<double> values = valuesAt(mesh, insideAndOutside);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_NEAR(values[i], i < 3 ? 1 : 0, 1e-6) << "at place " << i;
  }
}

// VTK's source of cells has no voxels, no cells of both degrees, and prisms that leave gaps.
const std::vector<int> straight = {VTK_TETRA, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID};
const std::vector<int> curved = {VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_WEDGE,
  VTK_QUADRATIC_PYRAMID, VTK_LAGRANGE_TETRAHEDRON, VTK_LAGRANGE_HEXAHEDRON, VTK_LAGRANGE_WEDGE,
  VTK_BEZIER_TETRAHEDRON, VTK_BEZIER_HEXAHEDRON, VTK_BEZIER_WEDGE};

} // namespace

TEST(OuterSurface, LooksOutwardForAllTypesOfCells)
{
  for (const std::vector<int>* types : {&straight, &curved})
  {
    for (const int type : *types)
    {
      SCOPED_TRACE("type " + std::to_string(type));
      expectTheCube(cubeOf(type, stay));
      expectTheCube(cubeOf(type, mirror));
      const auto report = reportOn(cubeOf(type, mirror));
      EXPECT_TRUE(report->GetClosed());
      EXPECT_NEAR(report->GetVolume(), 8, 1e-6);
    }
  }
}

TEST(OuterSurface, LooksOutwardForSingleCellsOfAllTypes)
{
  for (int type = 0; type < VTK_LAGRANGE_CURVE; ++type)
  {
    const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
    if (!cell || cell->GetCellDimension() < 3 || cell->GetNumberOfPoints() == 0 ||
        !cell->GetParametricCoords())
    {
      continue; // a polyhedron
    }
    SCOPED_TRACE("type " + std::to_string(type));
    double centre[3];
    cell->GetParametricCenter(centre);
    for (const double sign : {1.0, -1.0})
    {
      vtkNew<vtkUnstructuredGrid> mesh;
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      std::vector<vtkIdType> ids;
      for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
      {
        const double* place = cell->GetParametricCoords() + 3 * i;
        ids.push_back(points->InsertNextPoint(sign * place[0], place[1], place[2]));
      }
      mesh->SetPoints(points);
      mesh->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
      const std::vector<double> values =
        valuesAt(mesh, {{sign * centre[0], centre[1], centre[2]}, {0, 0, 3}});
      EXPECT_NEAR(values[0], 1, 1e-6);
      EXPECT_NEAR(values[1], 0, 1e-6);
      EXPECT_TRUE(reportOn(mesh)->GetClosed());
    }
  }
}

TEST(OuterSurface, TurnsCellsOfTheOtherOrderAndCountsThem)
{
  const std::vector<std::pair<int, std::vector<int>>> orders = {{VTK_TETRA, {1, 0, 2, 3}},
    {VTK_HEXAHEDRON, {4, 5, 6, 7, 0, 1, 2, 3}}, {VTK_WEDGE, {3, 4, 5, 0, 1, 2}},
    {VTK_PYRAMID, {0, 3, 2, 1, 4}}};
  for (const auto& [type, order] : orders)
  {
    SCOPED_TRACE("type " + std::to_string(type));
    const auto mesh = withEveryOtherReordered(cubeOf(type, stay), order);
    expectTheCube(mesh);
    const auto report = reportOn(mesh);
    EXPECT_TRUE(report->GetClosed());
    EXPECT_NEAR(report->GetVolume(), 8, 1e-12);
    EXPECT_GT(report->GetReport()->GetArray("turned_cells")->GetComponent(0, 0), 0);
  }
}

TEST(OuterSurface, TurnsFacesOfPolyhedra)
{
  const auto cube = cubeOf(VTK_HEXAHEDRON, stay);
  for (unsigned turned = 0; turned < 64; turned += 7)
  {
    SCOPED_TRACE("faces turned: " + std::to_string(turned));
    auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
    mesh->SetPoints(cube->GetPoints());
    for (vtkIdType cell = 0; cell < cube->GetNumberOfCells(); ++cell)
    {
      vtkCell* hexahedron = cube->GetCell(cell);
      vtkNew<vtkIdList> stream;
      stream->InsertNextId(hexahedron->GetNumberOfFaces());
      for (int face = 0; face < hexahedron->GetNumberOfFaces(); ++face)
      {
        vtkIdList* ids = hexahedron->GetFace(face)->GetPointIds();
        std::vector<vtkIdType> corners(ids->begin(), ids->end());
        if (((turned + static_cast<unsigned>(cell)) >> face) & 1u)
        {
          std::reverse(corners.begin(), corners.end());
        }
        stream->InsertNextId(static_cast<vtkIdType>(corners.size()));
        for (const vtkIdType corner : corners)
        {
          stream->InsertNextId(corner);
        }
      }
      mesh->InsertNextCell(VTK_POLYHEDRON, stream);
    }
    expectTheCube(mesh);
    EXPECT_NEAR(reportOn(mesh)->GetVolume(), 8, 1e-12);
  }
}

TEST(OuterSurface, TurnsAStructuredGridOfTheOtherHand)
{
  for (const double sign : {1.0, -1.0})
  {
    vtkNew<vtkStructuredGrid> grid;
    grid->SetDimensions(3, 3, 3);
    vtkNew<vtkPoints> points;
    for (int i = 0; i < 27; ++i)
    {
      points->InsertNextPoint(1 + sign * (i % 3 - 1), i / 3 % 3, i / 9);
    }
    grid->SetPoints(points);
    expectTheCube(grid);
  }
}

TEST(OuterSurface, FollowsCurvedCells)
{
  for (const int type : curved)
  {
    if (type == VTK_BEZIER_TETRAHEDRON || type == VTK_BEZIER_HEXAHEDRON || type == VTK_BEZIER_WEDGE)
    {
      continue; // their control points are not on the surface
    }
    SCOPED_TRACE("type " + std::to_string(type));
    for (const Map& map : {Map(bend), Map(bendAndMirror)})
    {
      const auto report = reportOn(cubeOf(type, map));
      EXPECT_TRUE(report->GetClosed());
      EXPECT_NEAR(report->GetVolume(), 11.2, 0.02);
    }
  }
}

TEST(OuterSurface, LeavesOutFacesOfCellsWithVolumeAndSaysSo)
{
  const auto solid = cubeOf(VTK_HEXAHEDRON, stay);
  for (const bool isInward : {false, true})
  {
    auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
    mesh->DeepCopy(solid);
    const auto skin = reportOn(solid);
    vtkPolyData* faces = skin->GetOutput();
    vtkIdType added = 0;
    for (vtkIdType i = 0; i < faces->GetNumberOfCells(); ++i, ++added)
    {
      vtkNew<vtkIdList> ids;
      faces->GetCellPoints(i, ids);
      std::vector<vtkIdType> corners;
      for (const vtkIdType id : *ids)
      {
        corners.push_back(mesh->FindPoint(faces->GetPoint(id)));
      }
      if (isInward)
      {
        std::reverse(corners.begin(), corners.end());
      }
      mesh->InsertNextCell(VTK_QUAD, 4, corners.data());
    }
    expectTheCube(mesh);
    std::string warning;
    valuesAt(mesh, insideAndOutside, &warning);
    EXPECT_NE(warning.find("cells with and without volume are mixed"), std::string::npos)
      << warning;
    EXPECT_NE(warning.find(std::to_string(added)), std::string::npos) << warning;
    EXPECT_EQ(reportOn(mesh)->GetReport()->GetArray("left_out_cells")->GetComponent(0, 0), added);
    EXPECT_NEAR(reportOn(mesh)->GetVolume(), 8, 1e-12);
    const double sense = isInward ? -1 : 1;
    EXPECT_NEAR(valuesAt(mesh, insideAndOutside, nullptr, true)[0], sense, 1e-6);
    EXPECT_NEAR(reportOn(mesh, true)->GetVolume(), 8 * sense, 1e-12);
  }
}

TEST(OuterSurface, LeavesOutRefinedCells)
{
  const auto mesh = cubeOf(VTK_HEXAHEDRON, stay);
  vtkUnsignedCharArray* flags = mesh->AllocateCellGhostArray();
  flags->SetValue(0, vtkDataSetAttributes::REFINEDCELL);
  EXPECT_NEAR(reportOn(mesh)->GetVolume(), 7, 1e-12);
  vtkNew<vtkPolyData> surface;
  surface->DeepCopy(reportOn(cubeOf(VTK_HEXAHEDRON, stay))->GetOutput());
  const vtkIdType faces = surface->GetNumberOfCells();
  surface->AllocateCellGhostArray()->SetValue(0, vtkDataSetAttributes::REFINEDCELL);
  EXPECT_EQ(
    reportOn(surface)->GetReport()->GetArray("triangles")->GetComponent(0, 0), 2 * (faces - 1));
}
