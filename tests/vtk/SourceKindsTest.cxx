// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"
#include "vtk/PointProbe.h"

#include "vtkAppendFilter.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkDataSetAttributes.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberProbe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

class SourceKinds : public PointProbe
{
protected:
  void expectRefused(vtkDataObject* source, const std::string& part)
  {
    ErrorLog log(probe);
    this->windingNumber(source, 0, 0, 0);
    EXPECT_NE(log.errors().find(part), std::string::npos) << log.errors();
    EXPECT_EQ(probe->GetStatus(), vtkWindingNumberProbe::REFUSED);
  }
};

vtkSmartPointer<vtkPolyData> sphere(double radius = 0.5, bool normals = true)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetThetaResolution(60);
  source->SetPhiResolution(60);
  source->SetGenerateNormals(normals);
  source->Update();
  vtkSmartPointer<vtkPolyData> result = source->GetOutput();
  return result;
}

/// The points of a sphere without its triangles.
vtkSmartPointer<vtkPolyData> cloud(bool normals = true)
{
  auto result = sphere(0.5, normals);
  result->SetPolys(vtkSmartPointer<vtkCellArray>::New());
  return result;
}

TEST_F(SourceKinds, QuadsTrianglesAndStripsAreOneSurface)
{
  vtkNew<vtkCubeSource> cube;
  cube->Update();
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(triangles->GetOutputPort());
  strips->Update();
  ASSERT_GT(strips->GetOutput()->GetNumberOfStrips(), 0);
  for (vtkPolyData* source : {cube->GetOutput(), triangles->GetOutput(), strips->GetOutput()})
  {
    EXPECT_NEAR(this->windingNumber(source, 0.1, 0.2, 0.3), 1, 1e-14);
    EXPECT_NEAR(this->windingNumber(source, 0.1, 0.2, 0.6), 0, 1e-14);
  }
}

TEST_F(SourceKinds, NonConvexPolygonsGiveTheChainThatTheyAre)
{
  // The caps of a prism over an L are hexagons whose fans overlap outside the L, and cancel there.
  const double outline[6][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (int first = 0; first < 6; ++first)
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> polys;
    for (int i = 0; i < 12; ++i)
    {
      const double* p = outline[(i + first) % 6];
      points->InsertNextPoint(p[0], p[1], i < 6 ? 0 : 1);
    }
    const vtkIdType bottom[6] = {5, 4, 3, 2, 1, 0}, top[6] = {6, 7, 8, 9, 10, 11};
    polys->InsertNextCell(6, bottom);
    polys->InsertNextCell(6, top);
    for (vtkIdType i = 0; i < 6; ++i)
    {
      const vtkIdType j = (i + 1) % 6;
      const vtkIdType side[4] = {i, j, j + 6, i + 6};
      polys->InsertNextCell(4, side);
    }
    vtkNew<vtkPolyData> prism;
    prism->SetPoints(points);
    prism->SetPolys(polys);
    EXPECT_NEAR(this->windingNumber(prism, 0.5, 1.5, 0.5), 1, 1e-14) << first;
    EXPECT_NEAR(this->windingNumber(prism, 1.5, 0.5, 0.5), 1, 1e-14) << first;
    EXPECT_NEAR(this->windingNumber(prism, 1.5, 1.5, 0.5), 0, 1e-14) << first;
    EXPECT_NEAR(this->windingNumber(prism, 1.4, 1.4, 0.1), 0, 1e-14) << first;
  }
}

TEST_F(SourceKinds, CompositeLeavesAreOneSource)
{
  vtkNew<vtkMultiBlockDataSet> nested, blocks;
  nested->SetBlock(0, sphere(0.25));
  blocks->SetBlock(0, sphere(0.5));
  blocks->SetBlock(1, nested);
  blocks->SetBlock(2, nullptr);
  EXPECT_NEAR(this->windingNumber(blocks, 0, 0, 0), 2, 1e-12);
  EXPECT_NEAR(this->windingNumber(blocks, 0.4, 0, 0), 1, 1e-12);
}

TEST_F(SourceKinds, VolumeMeshesCountThroughTheirSkin)
{
  vtkNew<vtkPoints> points;
  const double corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const auto& corner : corners)
  {
    points->InsertNextPoint(corner);
  }
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  const vtkIdType ids[4] = {0, 1, 2, 3};
  grid->InsertNextCell(VTK_TETRA, 4, ids);
  EXPECT_NEAR(this->windingNumber(grid, 0.1, 0.1, 0.1), 1, 1e-14);
  EXPECT_NEAR(this->windingNumber(grid, 0.5, 0.5, 0.5), 0, 1e-14);
}

TEST_F(SourceKinds, VolumeMeshesWithIdsOfNoPointAreRefused)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  const vtkIdType ids[4] = {0, 1, 2, 3};
  grid->InsertNextCell(VTK_TETRA, 4, ids);
  expectRefused(grid, "cell 0 of the source refers to point 1 of 1");
}

TEST_F(SourceKinds, CoordinatesOfAnyArrayTypeAreRead)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(4);
  cube->SetYLength(4);
  cube->SetZLength(4);
  cube->Update();
  vtkNew<vtkIntArray> integers;
  integers->DeepCopy(cube->GetOutput()->GetPoints()->GetData());
  cube->GetOutput()->GetPoints()->SetData(integers);
  EXPECT_NEAR(this->windingNumber(cube->GetOutput(), 0, 0, 0), 1, 1e-14);
}

TEST_F(SourceKinds, CloudGivesAPlateauOfOneWithEstimatedAreas)
{
  // The sphere's poles are sampled far more densely than its equator, so no constant area is right.
  EXPECT_NEAR(this->windingNumber(cloud(), 0, 0, 0), 1, 0.01); // measured 0.9987
  EXPECT_FALSE(probe->GetSourceIsSurface());
  EXPECT_NEAR(this->windingNumber(cloud(), 1, 0, 0), 0, 0.01);
  probe->SetPointAreaMethod(vtkWindingNumberProbe::CONSTANT);
  EXPECT_GT(std::abs(this->windingNumber(cloud(), 0.3, 0, 0) - 1), 0.02);
}

TEST_F(SourceKinds, ConstantAreaScalesTheCloudsField)
{
  probe->SetTolerance(0);
  probe->SetPointAreaMethod(vtkWindingNumberProbe::CONSTANT);
  probe->SetPointArea(1e-3);
  const double w = this->windingNumber(cloud(), 0, 0, 0);
  probe->SetPointArea(2e-3);
  EXPECT_NEAR(this->windingNumber(cloud(), 0, 0, 0), 2 * w, 1e-15);
  // All points are at distance 1/2 with outward normals, so w = n · area / (4π/4).
  const double n = static_cast<double>(cloud()->GetNumberOfPoints());
  EXPECT_NEAR(w, n * 1e-3 / 3.14159265358979, 1e-6);
}

TEST_F(SourceKinds, AreasFromAnArrayAreUsed)
{
  auto points = cloud();
  vtkNew<vtkFloatArray> areas;
  areas->SetName("Area");
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    areas->InsertNextValue(i == 5 ? 1.0F : 0.0F);
  }
  points->GetPointData()->AddArray(areas);
  probe->SetPointAreaMethod(vtkWindingNumberProbe::ARRAY);
  EXPECT_NEAR(this->windingNumber(points, 0, 0, 0), 1 / 3.14159265358979, 1e-6);
  probe->SetAreaArray("no such");
  expectRefused(points, "no point array 'no such'");
  probe->SetAreaArray("Normals");
  expectRefused(points, "has 3 components, not 1");
}

TEST_F(SourceKinds, NormalsNeedNoUnitLengthAndMayBeNamed)
{
  auto points = cloud();
  const double w = this->windingNumber(points, 0, 0, 0);
  vtkNew<vtkDoubleArray> scaled;
  scaled->SetName("scaled");
  scaled->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double n[3];
    points->GetPointData()->GetNormals()->GetTuple(i, n);
    scaled->InsertNextTuple3(-7 * n[0], -7 * n[1], -7 * n[2]);
  }
  points->GetPointData()->AddArray(scaled);
  probe->SetNormalsArray("scaled");
  EXPECT_NEAR(this->windingNumber(points, 0, 0, 0), -w, 1e-6);

  probe->SetNormalsArray("None");
  EXPECT_EQ(this->windingNumber(points, 0, 0, 0), w) << "the active normals";
  scaled->SetName("None");
  points->Modified();
  EXPECT_NEAR(this->windingNumber(points, 0, 0, 0), -w, 1e-6) << "the array of that name";
}

TEST_F(SourceKinds, CloudWithoutNormalsIsRefusedWithTheRemedy)
{
  expectRefused(cloud(false), "vtkPCANormalEstimation");
}

/// Programs write zeros, or NaN, where they have no normals.
TEST_F(SourceKinds, NormalsWithoutDirectionsAreNone)
{
  probe->EstimateNormalsOn();
  const double estimated = this->windingNumber(cloud(false), 0, 0, 0);
  EXPECT_NEAR(estimated, 1, 0.1);
  for (const double value : {0.0, nan})
  {
    auto empty = cloud();
    empty->GetPointData()->GetNormals()->Fill(value);
    probe->EstimateNormalsOn();
    EXPECT_EQ(this->windingNumber(empty, 0, 0, 0), estimated);
    EXPECT_TRUE(probe->GetNormalsWereEstimated());
    EXPECT_EQ(probe->GetNumberOfDroppedPrimitives(), 0);
    probe->EstimateNormalsOff();
    this->expectRefused(empty, "all normals have length 0: use EstimateNormalsOn()");
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, empty);
    blocks->SetBlock(1, cloud());
    EXPECT_NEAR(this->windingNumber(blocks, 0, 0, 0), 1, 0.1) << "some have directions";
    EXPECT_EQ(probe->GetNumberOfDroppedPrimitives(), empty->GetNumberOfPoints());
    auto mesh = sphere();
    mesh->GetPointData()->GetNormals()->Fill(value);
    probe->SetSourceAsPoints(1);
    EXPECT_NEAR(this->windingNumber(mesh, 0, 0, 0), 1, 0.1) << "the normals of the faces";
    probe->SetSourceAsPoints(0);
  }
}

TEST_F(SourceKinds, MissingNormalsAreRefusedWhenTheyAreNeeded)
{
  // The information is not refused: a user interface asks for it before it can offer to estimate
  // normals.
  vtkNew<vtkWindingNumberField> field;
  field->SetInputData(cloud(false));
  field->SetResolution(4);
  ErrorLog log(field);
  field->UpdateInformation();
  EXPECT_EQ(log.errors(), "");
  field->Update();
  EXPECT_NE(log.errors().find("the points have no normals"), std::string::npos) << log.errors();
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::REFUSED);
  ErrorLog later(field);
  field->EstimateNormalsOn();
  field->Update();
  EXPECT_EQ(later.errors(), "");
  EXPECT_GT(field->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(SourceKinds, MeshAsPointsIsItsCloud)
{
  probe->SetSourceAsPoints(1);
  EXPECT_NEAR(this->windingNumber(sphere(), 0, 0, 0), 1, 0.1); // measured 1.051
  EXPECT_FALSE(probe->GetSourceIsSurface());
  // The triangles of a mesh give the normals if it has none of its own.
  EXPECT_NEAR(
    this->windingNumber(sphere(0.5, false), 0, 0, 0), this->windingNumber(sphere(), 0, 0, 0), 1e-3);
}

TEST_F(SourceKinds, VolumeMeshAsPointsIsTheCloudOfItsSurface)
{
  vtkNew<vtkImageData> box;
  box->SetDimensions(9, 9, 9);
  vtkNew<vtkAppendFilter> hexahedra; // makes an unstructured grid
  hexahedra->SetInputData(box);
  hexahedra->Update();
  vtkNew<vtkDataSetSurfaceFilter> skin;
  skin->SetInputConnection(hexahedra->GetOutputPort());
  skin->Update();
  probe->SetSourceAsPoints(1);
  const double w = this->windingNumber(hexahedra->GetOutput(), 4, 4, 4);
  EXPECT_NEAR(w, 1, 0.1); // measured 1.04
  EXPECT_EQ(w, this->windingNumber(skin->GetOutput(), 4, 4, 4));
}

TEST_F(SourceKinds, GhostsAndWhatIsHiddenAreLeftOut)
{
  probe->SetPointAreaMethod(vtkWindingNumberProbe::CONSTANT);
  probe->SetPointArea(1e-3);
  for (const bool isHidden : {false, true})
  {
    probe->SetSourceAsPoints(0);
    auto own = sphere(), ghost = sphere();
    vtkNew<vtkUnsignedCharArray> flags;
    flags->SetName(vtkDataSetAttributes::GhostArrayName());
    flags->SetNumberOfTuples(ghost->GetNumberOfCells());
    flags->Fill(isHidden ? vtkDataSetAttributes::HIDDENCELL : vtkDataSetAttributes::DUPLICATECELL);
    ghost->GetCellData()->AddArray(flags);
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, own);
    blocks->SetBlock(1, ghost);
    EXPECT_NEAR(this->windingNumber(blocks, 0, 0, 0), 1, 1e-12) << isHidden;

    auto points = cloud();
    const double w = this->windingNumber(points, 0, 0, 0);
    auto ghostPoints = cloud();
    vtkNew<vtkUnsignedCharArray> pointFlags;
    pointFlags->SetName(vtkDataSetAttributes::GhostArrayName());
    pointFlags->SetNumberOfTuples(ghostPoints->GetNumberOfPoints());
    pointFlags->Fill(
      isHidden ? vtkDataSetAttributes::HIDDENPOINT : vtkDataSetAttributes::DUPLICATEPOINT);
    ghostPoints->GetPointData()->AddArray(pointFlags);
    blocks->SetBlock(0, points);
    blocks->SetBlock(1, ghostPoints);
    EXPECT_EQ(this->windingNumber(blocks, 0, 0, 0), w) << isHidden;
    probe->SetSourceAsPoints(1);
    EXPECT_EQ(this->windingNumber(blocks, 0, 0, 0), w) << isHidden;
  }
}

TEST_F(SourceKinds, OtherArraysOfTheSameSourceAreNotForgotten)
{
  // The two clouds differ only in the array that is used second.
  const auto withNormals = [](const char* name, double sign, vtkPolyData* points)
  {
    vtkNew<vtkDoubleArray> normals;
    normals->DeepCopy(points->GetPointData()->GetNormals());
    for (vtkIdType i = 0; i < normals->GetNumberOfValues(); ++i)
    {
      normals->SetValue(i, sign * normals->GetValue(i));
    }
    normals->SetName(name);
    points->GetPointData()->AddArray(normals);
  };
  auto first = cloud(), second = cloud();
  withNormals("A", 1, first);
  withNormals("B", -1, first);
  withNormals("A", 1, second);
  withNormals("B", 1, second);
  probe->SetNormalsArray("A");
  const double w = this->windingNumber(first, 0, 0, 0);
  probe->SetNormalsArray("B");
  EXPECT_NEAR(this->windingNumber(first, 0, 0, 0), -w, 1e-12);
  EXPECT_EQ(this->windingNumber(second, 0, 0, 0), w);
}

TEST_F(SourceKinds, EveryPartOfASourceMakesItAnother)
{
  // Each source is a new data set that differs from the one before it in one part only.
  const auto copyOf = [](vtkPolyData* source)
  {
    auto copy = vtkSmartPointer<vtkPolyData>::New();
    copy->DeepCopy(source);
    return copy;
  };
  auto points = cloud();
  vtkNew<vtkDoubleArray> areas;
  areas->SetName("Area");
  areas->SetNumberOfTuples(points->GetNumberOfPoints());
  areas->Fill(1e-3);
  points->GetPointData()->AddArray(areas);
  probe->SetPointAreaMethod(vtkWindingNumberProbe::ARRAY);
  const double w = this->windingNumber(points, 0, 0, 0);
  EXPECT_GT(w, 0);

  auto largerAreas = copyOf(points);
  vtkDataArray* doubled = largerAreas->GetPointData()->GetArray("Area");
  doubled->Fill(2e-3);
  EXPECT_NEAR(this->windingNumber(largerAreas, 0, 0, 0), 2 * w, 1e-12);

  auto turned = copyOf(largerAreas);
  vtkDataArray* normals = turned->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    const double* n = normals->GetTuple3(i);
    normals->SetTuple3(i, -n[0], -n[1], -n[2]);
  }
  EXPECT_NEAR(this->windingNumber(turned, 0, 0, 0), -2 * w, 1e-12);

  auto moved = copyOf(turned);
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    const double* p = moved->GetPoint(i);
    moved->GetPoints()->SetPoint(i, 2 * p[0], 2 * p[1], 2 * p[2]);
  }
  EXPECT_NEAR(this->windingNumber(moved, 0, 0, 0), -w / 2, 1e-12);

  auto mesh = sphere();
  const double inside = this->windingNumber(mesh, 0, 0, 0);
  EXPECT_NEAR(inside, 1, 1e-6);
  auto reversed = copyOf(mesh);
  reversed->ReverseCell(0);
  EXPECT_LT(this->windingNumber(reversed, 0, 0, 0), inside - 1e-5);
}

TEST_F(SourceKinds, RefusedSourcesAreRefusedAgainWhenOnlyInformationIsAskedFor)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputData(sphere());
  field->UpdateInformation();
  auto bad = sphere();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(bad->GetPoints());
  points->SetPoint(3, 1e300, 0, 0);
  bad->SetPoints(points);
  field->SetInputData(bad);
  for (int time = 0; time < 3; ++time)
  {
    ErrorLog log(field);
    field->Modified();
    field->UpdateInformation();
    EXPECT_NE(log.errors().find("point 3 lies at 1e+300"), std::string::npos) << time;
    field->RemoveAllObservers();
  }
  ErrorLog log(field);
  field->SetInputData(sphere());
  field->UpdateInformation();
  EXPECT_EQ(log.errors(), "");
}

TEST_F(SourceKinds, ParityNeedsTriangles)
{
  probe->SetMethod(vtkWindingNumberProbe::PARITY);
  expectRefused(cloud(), "parity needs triangles");
}

TEST_F(SourceKinds, KindIsKnownWithTheInformation)
{
  const auto expectKind = [](int kind, vtkDataObject* source)
  {
    vtkNew<vtkWindingNumberProbe> fresh;
    EXPECT_EQ(fresh->GetSourceKind(), vtkWindingNumberProbe::NO_SOURCE);
    fresh->SetInputData(sphere());
    fresh->SetSourceData(source);
    fresh->SetSourceAsPoints(
      kind == vtkWindingNumberProbe::MESH_SOURCE); // the option says nothing of the source
    fresh->UpdateInformation();
    EXPECT_EQ(fresh->GetSourceKind(), kind) << source->GetClassName();
    for (const bool useBounds : {true, false})
    {
      vtkNew<vtkWindingNumberField> field;
      field->SetInputData(source);
      field->SetUseInputBounds(useBounds);
      field->UpdateInformation();
      EXPECT_EQ(field->GetSourceKind(), kind) << useBounds;
    }
  };
  vtkNew<vtkStripper> strips;
  strips->SetInputData(sphere());
  strips->Update();
  vtkNew<vtkAppendFilter> cells, vertices;
  cells->SetInputData(sphere());
  cells->Update();
  vertices->SetInputData(cloud());
  vertices->Update();
  vtkNew<vtkMultiBlockDataSet> spheres, clouds;
  spheres->SetBlock(0, vtkSmartPointer<vtkPolyData>::New());
  spheres->SetBlock(2, sphere());
  clouds->SetBlock(0, cloud());
  clouds->SetBlock(1, vtkSmartPointer<vtkPolyData>::New());
  expectKind(vtkWindingNumberProbe::MESH_SOURCE, sphere());
  expectKind(vtkWindingNumberProbe::MESH_SOURCE, strips->GetOutput());
  expectKind(vtkWindingNumberProbe::MESH_SOURCE, cells->GetOutput());
  expectKind(vtkWindingNumberProbe::MESH_SOURCE, spheres);
  expectKind(vtkWindingNumberProbe::CLOUD_SOURCE, cloud());
  expectKind(vtkWindingNumberProbe::CLOUD_SOURCE, vertices->GetOutput());
  expectKind(vtkWindingNumberProbe::CLOUD_SOURCE, clouds);
  expectKind(vtkWindingNumberProbe::NO_SOURCE, vtkSmartPointer<vtkPolyData>::New());
}

TEST_F(SourceKinds, KindFollowsASourceThatIsUpdatedLater)
{
  vtkNew<vtkSphereSource> source;
  probe->SetInputData(sphere());
  probe->SetSourceConnection(source->GetOutputPort());
  probe->UpdateInformation();
  EXPECT_EQ(probe->GetSourceKind(), vtkWindingNumberProbe::NO_SOURCE);
  probe->Update();
  EXPECT_EQ(probe->GetSourceKind(), vtkWindingNumberProbe::MESH_SOURCE);
  probe->SetSourceData(cloud());
  probe->UpdateInformation();
  EXPECT_EQ(probe->GetSourceKind(), vtkWindingNumberProbe::CLOUD_SOURCE);
}

TEST_F(SourceKinds, KindIsFoundForSourcesThatAreRefusedLater)
{
  // Information needs no usable source if the box is given, and must not fail for the kind's sake.
  vtkNew<vtkMultiBlockDataSet> mixed, images;
  mixed->SetBlock(0, cloud());
  mixed->SetBlock(1, sphere());
  images->SetBlock(0, vtkSmartPointer<vtkImageData>::New());
  vtkNew<vtkWindingNumberField> field;
  field->UseInputBoundsOff();
  ErrorLog log(field);
  field->SetInputData(mixed);
  field->UpdateInformation();
  EXPECT_EQ(field->GetSourceKind(), vtkWindingNumberField::MESH_SOURCE);
  field->SetInputData(cloud(false));
  field->UpdateInformation();
  EXPECT_EQ(field->GetSourceKind(), vtkWindingNumberField::CLOUD_SOURCE);
  field->SetInputData(images);
  field->UpdateInformation();
  EXPECT_EQ(field->GetSourceKind(), vtkWindingNumberField::NO_SOURCE);
  EXPECT_EQ(log.errors(), "");
}

TEST_F(SourceKinds, SurfacesAndCloudsDoNotMix)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, sphere());
  blocks->SetBlock(1, cloud());
  expectRefused(blocks, "mixes surfaces and point clouds");
}

TEST_F(SourceKinds, LeavesThatAreNoPointsAreRefused)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, vtkSmartPointer<vtkImageData>::New());
  expectRefused(blocks, "is a vtkImageData");
}

TEST_F(SourceKinds, NothingToSumOverGivesZeroAndAWarning)
{
  vtkNew<vtkPolyData> empty;
  ErrorLog log(probe);
  EXPECT_EQ(this->windingNumber(empty, 0, 0, 0), 0);
  EXPECT_NE(log.warnings().find("its field is 0"), std::string::npos) << log.warnings();
  vtkNew<vtkMultiBlockDataSet> blocks;
  EXPECT_EQ(this->windingNumber(blocks, 0, 0, 0), 0);

  vtkNew<vtkWindingNumberField> field;
  ErrorLog fieldLog(field);
  field->SetInputData(empty);
  field->SetResolution(4);
  field->Update();
  EXPECT_EQ(fieldLog.errors(), "");
  EXPECT_EQ(field->GetOutput()->GetNumberOfPoints(), 64) << "over the sampling bounds";
  EXPECT_EQ(field->GetOutput()->GetPointData()->GetScalars()->GetRange()[1], 0);
}

TEST_F(SourceKinds, BadPrimitivesAreDroppedAndCounted)
{
  auto source = sphere();
  const double before = this->windingNumber(source, 0, 0, 0);
  vtkIdType bad = source->GetPoints()->InsertNextPoint(nan, 0, 0);
  const vtkIdType withNaN[3] = {0, 1, bad}, beyond[3] = {0, 1, 999999};
  source->GetPolys()->InsertNextCell(3, withNaN);
  source->GetPolys()->InsertNextCell(3, beyond);
  source->Modified();
  ErrorLog log(probe);
  EXPECT_EQ(this->windingNumber(source, 0, 0, 0), before);
  EXPECT_EQ(probe->GetNumberOfDroppedPrimitives(), 2);
  EXPECT_NE(
    log.warnings().find("1 with NaN or infinite coordinates, 1 with ids"), std::string::npos)
    << log.warnings();
}

TEST_F(SourceKinds, OnlyBadPrimitivesAreAnError)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(nan, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0, 1, 0);
  vtkNew<vtkCellArray> polys;
  const vtkIdType ids[3] = {0, 1, 2};
  polys->InsertNextCell(3, ids);
  vtkNew<vtkPolyData> source;
  source->SetPoints(points);
  source->SetPolys(polys);
  expectRefused(source, "all 1 triangles are unusable");
}

} // namespace
