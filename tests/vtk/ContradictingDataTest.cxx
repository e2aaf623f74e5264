// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// Data sets that contradict themselves come to every filter by its pipeline, and are refused in
/// one line. VTK's classes would follow what they say, out of their memory.

#include "vtk/ErrorLog.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkImplicitWindingNumber.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberNormals.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberReport.h"
#include "vtkWindingNumberSurface.h"
#include "vtkWindingNumberVoxels.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace
{

constexpr vtkIdType largest = std::numeric_limits<vtkIdType>::max();

vtkSmartPointer<vtkPoints> fourPoints()
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0, 1, 0);
  points->InsertNextPoint(0, 0, 1);
  return points;
}

vtkSmartPointer<vtkPolyData> tetrahedron()
{
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({0, 2, 1});
  polygons->InsertNextCell({0, 1, 3});
  polygons->InsertNextCell({0, 3, 2});
  polygons->InsertNextCell({1, 2, 3});
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(fourPoints());
  data->SetPolys(polygons);
  return data;
}

vtkSmartPointer<vtkUnstructuredGrid> gridOf(int type, std::initializer_list<vtkIdType> ids)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(fourPoints());
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(ids);
  grid->SetCells(type, cells);
  return grid;
}

/// A cell array with offsets that nobody has made fit.
vtkSmartPointer<vtkCellArray> cellsOf(
  std::initializer_list<vtkIdType> offsetValues, std::initializer_list<vtkIdType> idValues)
{
  vtkNew<vtkIdTypeArray> offsets, ids;
  for (const vtkIdType value : offsetValues)
  {
    offsets->InsertNextValue(value);
  }
  for (const vtkIdType value : idValues)
  {
    ids->InsertNextValue(value);
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, ids);
  return cells;
}

/// Every filter that takes a source refuses this one, in one line that has the part.
void expectRefusedAsSource(vtkDataObject* source, const std::string& part)
{
  const auto expectLine = [&](const ErrorLog& log, const char* who)
  {
    EXPECT_NE(log.errors().find(part), std::string::npos) << who << ": " << log.errors();
  };
  const auto expectRefused = [&](vtkWindingNumberAlgorithm* filter, int port)
  {
    filter->SetInputDataObject(port, source);
    ErrorLog log(filter);
    filter->Update();
    expectLine(log, filter->GetClassName());
    EXPECT_EQ(filter->GetStatus(), vtkWindingNumberAlgorithm::REFUSED) << filter->GetClassName();
  };
  for (const bool asPoints : {false, true})
  {
    vtkNew<vtkWindingNumberField> field;
    field->SetSourceAsPoints(asPoints);
    field->SetEstimateNormals(asPoints);
    field->SetResolution(4);
    expectRefused(field, 0);
    vtkNew<vtkWindingNumberSurface> surface;
    surface->SetSourceAsPoints(asPoints);
    surface->SetEstimateNormals(asPoints);
    expectRefused(surface, 0);
    vtkNew<vtkWindingNumberProbe> probe;
    probe->SetSourceAsPoints(asPoints);
    probe->SetEstimateNormals(asPoints);
    probe->SetInputData(tetrahedron());
    expectRefused(probe, 1);
    EXPECT_FALSE(probe->GetQueriesWereRefused());
  }
  {
    vtkNew<vtkImplicitWindingNumber> function;
    function->SetInput(source);
    ErrorLog log(function);
    function->EvaluateFunction(0, 0, 0);
    expectLine(log, function->GetClassName());
  }
  {
    vtkNew<vtkWindingNumberNormals> areas;
    areas->SetInputDataObject(source);
    areas->SetEstimateNormals(true);
    ErrorLog log(areas);
    areas->Update();
    expectLine(log, areas->GetClassName());
  }
  for (const bool fixes : {false, true})
  {
    vtkNew<vtkWindingNumberReport> report;
    report->SetInputDataObject(source);
    report->SetFixOrientation(fixes);
    ErrorLog log(report);
    report->Update();
    expectLine(log, report->GetClassName());
  }
}

/// The probe refuses a data set to be probed, at points and at cells, whole and in part.
void expectRefusedAsQueries(
  vtkDataObject* queries, const std::string& part, bool alsoWhereCellsAreUnused = true)
{
  for (const int association : {vtkWindingNumberProbe::POINTS, vtkWindingNumberProbe::CELLS})
  {
    for (const bool extracts : {false, true})
    {
      const bool areUnused = association == vtkWindingNumberProbe::POINTS && !extracts;
      const bool isRefused = alsoWhereCellsAreUnused || !areUnused;
      vtkNew<vtkWindingNumberProbe> probe;
      probe->SetProbeAssociation(association);
      probe->SetExtractInside(extracts);
      probe->SetInputDataObject(queries);
      probe->SetSourceData(tetrahedron());
      ErrorLog log(probe);
      probe->Update();
      EXPECT_EQ(log.errors().find(part) != std::string::npos, isRefused) << log.errors();
      EXPECT_EQ(probe->GetQueriesWereRefused(), isRefused);
      probe->SetInputData(tetrahedron());
      probe->Update();
      EXPECT_FALSE(probe->GetQueriesWereRefused());
    }
  }
}

void expectRefused(vtkDataObject* data, const std::string& part)
{
  expectRefusedAsSource(data, part);
  expectRefusedAsQueries(data, part);
}

TEST(ContradictingData, OffsetsOutOfTheirIds)
{
  const std::string part = "offsets lead out";
  const vtkSmartPointer<vtkCellArray> bad[] = {cellsOf({0, 3, 60}, {0, 1, 2, 1, 2, 3}),
    cellsOf({0, 3, largest}, {0, 1, 2, 1, 2, 3}), cellsOf({0, 5, 3, 6}, {0, 1, 2, 1, 2, 3}),
    cellsOf({-3, 3, 6}, {0, 1, 2, 1, 2, 3}), cellsOf({}, {0, 1, 2})};
  for (const auto& cells : bad)
  {
    auto polygons = tetrahedron();
    polygons->SetPolys(cells);
    if (cells->GetNumberOfCells() > 0) // else these are points without cells to follow
    {
      expectRefused(polygons, part);
      vtkNew<vtkUnstructuredGrid> grid;
      grid->SetPoints(fourPoints());
      grid->SetCells(VTK_TRIANGLE, cells);
      expectRefused(grid, part);
    }
    auto strips = tetrahedron();
    strips->SetStrips(cells);
    expectRefused(strips, part);
    auto lines = tetrahedron();
    lines->SetLines(cells);
    expectRefused(lines, part);
  }
}

TEST(ContradictingData, IdsOfGrids)
{
  for (const vtkIdType id : {vtkIdType(-1), vtkIdType(4), vtkIdType(99999999), largest})
  {
    expectRefused(gridOf(VTK_TETRA, {0, 1, 2, id}), "cell 0 of the");
    expectRefused(
      gridOf(VTK_POLYGON, {0, 1, 2, id}), "refers to point " + std::to_string(id) + " of 4");
  }
}

TEST(ContradictingData, IdsOfPolyDataToBeProbed)
{
  for (const vtkIdType id : {vtkIdType(-1), vtkIdType(4), vtkIdType(99999999), largest})
  {
    auto data = tetrahedron();
    data->GetPolys()->InsertNextCell({0, 1, id});
    expectRefusedAsQueries(
      data, "cell 4 of the data set to be probed refers to point " + std::to_string(id) + " of 4");
  }
}

TEST(ContradictingData, SizesOfPolyDataToBeProbed)
{
  auto data = tetrahedron();
  data->GetPolys()->InsertNextCell({0, 1});
  expectRefusedAsQueries(
    data, "cell 4 of the data set to be probed has 2 points and needs 3", false);
}

/// Ghosts are taken out by filters of VTK, which follow all ids.
TEST(ContradictingData, IdsOfPolyDataWithGhosts)
{
  auto data = tetrahedron();
  data->GetPolys()->InsertNextCell({0, 1, 99999999});
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->InsertNextValue(vtkDataSetAttributes::DUPLICATECELL);
  for (int i = 0; i < 4; ++i)
  {
    ghosts->InsertNextValue(0);
  }
  data->GetCellData()->AddArray(ghosts);
  expectRefusedAsSource(data, "cell 4 of the source refers to point 99999999 of 4");
  auto few = tetrahedron();
  ghosts->SetNumberOfTuples(2);
  few->GetCellData()->AddArray(ghosts);
  expectRefusedAsSource(few, "'vtkGhostType' with 2 values for 4 cells");
}

TEST(ContradictingData, TypesOfCells)
{
  expectRefused(gridOf(200, {0, 1, 2, 3}), "has unknown type 200: use a VTK that knows it");
  expectRefused(gridOf(VTK_HEXAHEDRON, {0, 1, 2, 3}), "has 4 points");
  expectRefused(gridOf(VTK_QUADRATIC_TETRA, {0, 1, 2, 3}), "has 4 points");
  expectRefused(gridOf(VTK_TRIANGLE, {0, 1}), "has 2 points");
  for (const int type : {VTK_LAGRANGE_TRIANGLE, VTK_LAGRANGE_HEXAHEDRON, VTK_LAGRANGE_WEDGE,
         VTK_BEZIER_WEDGE, VTK_BEZIER_TRIANGLE})
  {
    expectRefused(gridOf(type, {0, 1, 2, 3}), "has 4 points");
  }
}

TEST(ContradictingData, DegreesOfCells)
{
  auto grid = gridOf(VTK_LAGRANGE_QUADRILATERAL, {0, 1, 2, 3});
  vtkNew<vtkDoubleArray> degrees;
  degrees->SetName("degrees");
  degrees->SetNumberOfComponents(3);
  degrees->InsertNextTuple3(2, 1, 1);
  grid->GetCellData()->SetHigherOrderDegrees(degrees);
  expectRefused(grid, "has 4 points");
}

TEST(ContradictingData, FewerTypesThanCells)
{
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(fourPoints());
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({0, 1, 2, 3});
  vtkNew<vtkUnsignedCharArray> types;
  types->InsertNextValue(VTK_TETRA);
  grid->SetCells(types, cells);
  cells->InsertNextCell({0, 1, 2, 3});
  expectRefused(grid, "has 2 cells but types for 1");
}

TEST(ContradictingData, FacesOfPolyhedra)
{
  vtkIdType faces[] = {3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3};
  const vtkIdType own[] = {0, 1, 2, 3};
  const auto polyhedron = [&]()
  {
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    grid->SetPoints(fourPoints());
    grid->InsertNextCell(VTK_POLYHEDRON, 4, own, 4, faces);
    return grid;
  };
  vtkNew<vtkWindingNumberProbe> probe;
  probe->SetInputData(tetrahedron());
  probe->SetSourceData(polyhedron());
  probe->Update();
  EXPECT_EQ(probe->GetStatus(), vtkWindingNumberProbe::DONE);
  for (const vtkIdType id : {vtkIdType(-1), vtkIdType(4), largest})
  {
    faces[2] = id;
    expectRefused(polyhedron(), "is a polyhedron with a face at point " + std::to_string(id));
  }
  faces[2] = 2;
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0) // the lists of faces have another form since
  vtkNew<vtkUnsignedCharArray> type;
  type->InsertNextValue(VTK_POLYHEDRON);
  auto bare = polyhedron();
  bare->SetCells(type, cellsOf({0, 4}, {0, 1, 2, 3}), nullptr, nullptr);
  expectRefused(bare, "is a polyhedron without faces");
  type->SetValue(0, VTK_TETRA);
  auto dressed = polyhedron();
  dressed->SetCells(type, dressed->GetCells(), dressed->GetFaceLocations(), dressed->GetFaces());
  expectRefused(dressed, "has faces that are not there");
  auto empty = polyhedron();
  empty->GetFaces()->SetValue(0, 0);
  expectRefused(empty, "is a polyhedron without faces");
  for (const vtkIdType count : {vtkIdType(-1), vtkIdType(5), vtkIdType(4000000000), largest})
  {
    auto grid = polyhedron();
    grid->GetFaces()->SetValue(5, count); // the size of the second face
    expectRefused(grid, "is a polyhedron without faces: read it with a newer VTK");
    grid = polyhedron();
    grid->GetFaces()->SetValue(0, count);
    expectRefused(grid, "is a polyhedron without faces: read it with a newer VTK");
    grid = polyhedron();
    grid->GetFaceLocations()->SetValue(0, count == 5 ? 17 : count);
    expectRefused(grid, "is a polyhedron without faces: read it with a newer VTK");
  }
#endif
}

TEST(ContradictingData, DimensionsOfStructuredGrids)
{
  vtkNew<vtkStructuredGrid> grid;
  grid->SetPoints(fourPoints());
  for (const int dimension : {3, 1000, std::numeric_limits<int>::max()})
  {
    grid->SetDimensions(dimension, dimension, dimension);
    expectRefused(grid, "more nodes than its 4 points");
  }
}

/// A grid of its own type with two points along each axis and one scalar at each.
template <class Grid> vtkSmartPointer<Grid> eightPoints()
{
  auto grid = vtkSmartPointer<Grid>::New();
  grid->SetDimensions(2, 2, 2);
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfTuples(8);
  values->Fill(1);
  grid->GetPointData()->SetScalars(values);
  return grid;
}

TEST(ContradictingData, CoordinatesOfRectilinearGrids)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto grid = eightPoints<vtkRectilinearGrid>();
    vtkNew<vtkDoubleArray> ends;
    ends->InsertNextValue(0);
    ends->InsertNextValue(1);
    vtkNew<vtkDoubleArray> one;
    one->InsertNextValue(0);
    grid->SetXCoordinates(axis == 0 ? one : ends);
    grid->SetYCoordinates(axis == 1 ? one : ends);
    grid->SetZCoordinates(axis == 2 ? nullptr : ends.Get());
    expectRefusedAsQueries(
      grid, std::string(axis == 2 ? "0" : "1") + " coordinates for 2 points along " + "xyz"[axis]);
  }
}

/// Announces an image whose extent ends before it begins, as a reader of a damaged file does.
class BackwardImage : public vtkImageAlgorithm
{
public:
  static BackwardImage* New() { VTK_STANDARD_NEW_BODY(BackwardImage); }
  vtkTypeMacro(BackwardImage, vtkImageAlgorithm);

protected:
  BackwardImage() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    const int extent[] = {0, 1, 10, 1, 0, 1};
    outputs->GetInformationObject(0)->Set(
      vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
    return 1;
  }
};

TEST(ContradictingData, ExtentsThatAreAnnouncedAreRefused)
{
  vtkNew<BackwardImage> image;
  vtkNew<vtkWindingNumberField> field;
  field->SetInputData(tetrahedron());
  field->SetLikeConnection(image->GetOutputPort());
  const ErrorLog log(field);
  field->UpdateInformation();
  EXPECT_NE(log.errors().find("from 10 to 1 along y"), std::string::npos) << log.errors();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::REFUSED);
}

TEST(ContradictingData, ExtentsThatEndBeforeTheyBegin)
{
  const int once[] = {0, 1, 10, 1, 0, 1}, twice[] = {10, 1, 10, 1, 0, 1};
  for (const int* extent : {once, twice})
  {
    const std::string fault = extent == once ? "from 10 to 1 along y" : "from 10 to 1 along x";
    const auto rectilinear = eightPoints<vtkRectilinearGrid>();
    rectilinear->SetExtent(const_cast<int*>(extent)); // VTK takes no const extents there
    expectRefusedAsQueries(rectilinear, fault);
    const auto structured = eightPoints<vtkStructuredGrid>();
    structured->SetPoints(fourPoints());
    structured->SetExtent(const_cast<int*>(extent));
    expectRefusedAsQueries(structured, fault);
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 6, 0) // assertions of VTK end these since
    const auto image = eightPoints<vtkImageData>();
    image->SetExtent(const_cast<int*>(extent));
    expectRefusedAsQueries(image, fault);
    vtkNew<vtkWindingNumberVoxels> voxels;
    voxels->SetInputData(image);
    vtkNew<vtkWindingNumberField> field;
    field->SetInputData(tetrahedron());
    field->SetLikeData(image);
    for (vtkAlgorithm* filter :
      {static_cast<vtkAlgorithm*>(voxels), static_cast<vtkAlgorithm*>(field)})
    {
      ErrorLog log(filter);
      filter->Update();
      EXPECT_NE(log.errors().find(fault), std::string::npos) << log.errors();
    }
#endif
  }
}

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 6, 0) // images take memory for each axis since
TEST(ContradictingData, ExtentBeyondIds)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(std::numeric_limits<int>::max(), std::numeric_limits<int>::max(), 3);
  expectRefusedAsQueries(image, "more points than there are ids");
}
#endif

TEST(ContradictingData, ArraysThatAreTooShort)
{
  const auto shortArray = [](const char* name, int components)
  {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(2);
    array->Fill(1);
    return array;
  };
  auto data = tetrahedron();
  data->GetPointData()->SetNormals(shortArray("Normals", 3));
  expectRefusedAsQueries(data, "'Normals' with 2 values for 4 points");
  vtkNew<vtkWindingNumberProbe> probe;
  probe->SetInputData(tetrahedron());
  probe->SetSourceData(data);
  {
    ErrorLog log(probe);
    probe->Update();
    EXPECT_EQ(log.errors(), ""); // a surface needs no normals
    probe->SourceAsPointsOn();
    probe->Update();
    EXPECT_NE(log.errors().find("'Normals' has 2 values for 4 points"), std::string::npos)
      << log.errors();
  }
  data->GetPointData()->SetNormals(nullptr);
  data->GetPointData()->AddArray(shortArray("Area", 1));
  probe->EstimateNormalsOn();
  probe->SetPointAreaMethod(vtkWindingNumberProbe::ARRAY);
  ErrorLog log(probe);
  probe->Update();
  EXPECT_NE(log.errors().find("'Area' has 2 values for 4 points"), std::string::npos)
    << log.errors();
}

TEST(ContradictingData, BlocksAreNamed)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, gridOf(VTK_TETRA, {0, 1, 2, 3}));
  blocks->SetBlock(1, gridOf(VTK_TETRA, {0, 1, 2, 4}));
  expectRefusedAsSource(blocks, "cell 0 of block 2 refers to point 4 of 4");
  expectRefusedAsQueries(blocks, "cell 0 of the data set to be probed refers to point 4 of 4");
}

} // namespace
