// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/FreeMemory.h"
#include "vtk/ErrorLog.h"
#include "vtk/HowTo.h"
#include "vtk/ProgressLog.h"
#include "vtk/Spheres.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypeSource.h"
#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkTetra.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWindingNumberProbe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace
{

vtkSmartPointer<vtkPolyData> sphere(double x, double y, double z, double radius)
{
  return sphereOf(30, 25, radius, {x, y, z});
}

/// The volume of the solid that triangles around a point bound.
double enclosedVolume(vtkPolyData* surface, const double center[3])
{
  double volume = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    surface->GetCellPoints(i, ids);
    double corners[3][3];
    for (int j = 0; j < 3; ++j)
    {
      surface->GetPoint(ids->GetId(j), corners[j]);
    }
    volume += std::abs(
      vtkTetra::ComputeVolume(const_cast<double*>(center), corners[0], corners[1], corners[2]));
  }
  return volume;
}

/// The volume of a convex cell, by the tetrahedra that VTK makes of it.
double volumeOf(vtkDataSet* data, vtkIdType number)
{
  vtkNew<vtkGenericCell> cell;
  vtkNew<vtkIdList> ids;
  vtkNew<vtkPoints> points;
  data->GetCell(number, cell);
  cell->Triangulate(0, ids, points);
  double volume = 0;
  for (vtkIdType i = 0; cell->GetCellDimension() == 3 && i + 4 <= points->GetNumberOfPoints();
       i += 4)
  {
    double corners[4][3];
    for (vtkIdType j = 0; j < 4; ++j)
    {
      points->GetPoint(i + j, corners[j]);
    }
    volume += std::abs(vtkTetra::ComputeVolume(corners[0], corners[1], corners[2], corners[3]));
  }
  return volume;
}

vtkSmartPointer<vtkUnstructuredGrid> meshOf(int type, int blocks)
{
  vtkNew<vtkCellTypeSource> source;
  source->SetCellType(type);
  source->SetBlocksDimensions(blocks, blocks, blocks);
  source->Update();
  return source->GetOutput();
}

vtkDataArray* fractionsOf(vtkDataSet* data)
{
  return data->GetCellData()->GetArray("Fraction");
}

double insideOf(vtkDataSet* data)
{
  double sum = 0;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    sum += volumeOf(data, i) * fractionsOf(data)->GetComponent(i, 0);
  }
  return sum;
}

/// A unit cube of polyhedra: hexahedra as lists of faces.
vtkSmartPointer<vtkUnstructuredGrid> polyhedraOf(vtkUnstructuredGrid* hexahedra)
{
  auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  mesh->SetPoints(hexahedra->GetPoints());
  mesh->Allocate(hexahedra->GetNumberOfCells());
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType i = 0; i < hexahedra->GetNumberOfCells(); ++i)
  {
    hexahedra->GetCell(i, cell);
    vtkNew<vtkIdList> stream;
    stream->InsertNextId(cell->GetNumberOfFaces());
    for (int face = 0; face < cell->GetNumberOfFaces(); ++face)
    {
      vtkIdList* ids = cell->GetFace(face)->GetPointIds();
      stream->InsertNextId(ids->GetNumberOfIds());
      for (vtkIdType j = 0; j < ids->GetNumberOfIds(); ++j)
      {
        stream->InsertNextId(ids->GetId(j));
      }
    }
    mesh->InsertNextCell(VTK_POLYHEDRON, stream);
  }
  return mesh;
}

class Fraction : public testing::Test
{
protected:
  Fraction()
  {
    probe->SetSourceData(source);
    probe->GenerateFractionOn();
  }

  vtkDataSet* probed(vtkDataSet* data)
  {
    probe->SetInputData(data);
    probe->Update();
    return probe->GetOutput();
  }

  const double center[3] = {1.4, 1.6, 1.5};
  vtkSmartPointer<vtkPolyData> source = sphere(center[0], center[1], center[2], 1.2);
  vtkNew<vtkWindingNumberProbe> probe;
};

TEST_F(Fraction, AddsUpToTheVolumeInCellsOfAnyType)
{
  const double volume = enclosedVolume(source, center);
  for (const int type :
    {VTK_TETRA, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID, VTK_VOXEL, VTK_POLYHEDRON})
  {
    vtkSmartPointer<vtkUnstructuredGrid> mesh = type == VTK_POLYHEDRON
                                                  ? polyhedraOf(meshOf(VTK_HEXAHEDRON, 3))
                                                : type == VTK_VOXEL ? meshOf(VTK_HEXAHEDRON, 3)
                                                                    : meshOf(type, 3);
    if (type == VTK_VOXEL)
    {
      auto voxels = vtkSmartPointer<vtkUnstructuredGrid>::New();
      voxels->SetPoints(mesh->GetPoints());
      voxels->Allocate(mesh->GetNumberOfCells());
      vtkNew<vtkIdList> ids;
      for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
      {
        mesh->GetCellPoints(i, ids);
        std::swap(*ids->GetPointer(2), *ids->GetPointer(3));
        std::swap(*ids->GetPointer(6), *ids->GetPointer(7));
        voxels->InsertNextCell(VTK_VOXEL, ids);
      }
      mesh = voxels;
    }
    ErrorLog log(probe);
    vtkDataSet* result = this->probed(mesh);
    EXPECT_EQ(log.warnings() + log.errors(), "") << "type " << type;
    ASSERT_NE(fractionsOf(result), nullptr);
    EXPECT_NEAR(insideOf(result), volume, 1e-6 * volume) << "type " << type;
    EXPECT_EQ(fractionsOf(result)->GetDataType(), VTK_FLOAT);
    EXPECT_NE(result->GetPointData()->GetArray("WindingNumber"), nullptr);
  }
}

TEST_F(Fraction, IsTheSameForConvexSetsOfPoints)
{
  const auto mesh = meshOf(VTK_HEXAHEDRON, 3);
  vtkNew<vtkUnstructuredGrid> sets;
  sets->SetPoints(mesh->GetPoints());
  sets->Allocate(mesh->GetNumberOfCells());
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    mesh->GetCellPoints(i, ids);
    sets->InsertNextCell(VTK_CONVEX_POINT_SET, ids);
  }
  vtkSmartPointer<vtkDataArray> expected = fractionsOf(this->probed(mesh));
  vtkDataArray* fractions = fractionsOf(this->probed(sets));
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    EXPECT_NEAR(fractions->GetComponent(i, 0), expected->GetComponent(i, 0), 1e-6) << i;
  }
}

TEST_F(Fraction, IsTheSameOnImagesAndGrids)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(7, 6, 5);
  image->SetSpacing(0.5, 0.6, 0.75);
  vtkNew<vtkRectilinearGrid> rectilinear;
  rectilinear->SetDimensions(image->GetDimensions());
  vtkNew<vtkStructuredGrid> structured;
  structured->SetDimensions(image->GetDimensions());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkNew<vtkFloatArray> coordinates;
    for (int i = 0; i < image->GetDimensions()[axis]; ++i)
    {
      coordinates->InsertNextValue(static_cast<float>(image->GetSpacing()[axis] * i));
    }
    axis == 0   ? rectilinear->SetXCoordinates(coordinates)
    : axis == 1 ? rectilinear->SetYCoordinates(coordinates)
                : rectilinear->SetZCoordinates(coordinates);
  }
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(image->GetPoint(i));
  }
  structured->SetPoints(points);
  for (const int association : {vtkWindingNumberProbe::POINTS, vtkWindingNumberProbe::CELLS})
  {
    probe->SetProbeAssociation(association);
    vtkSmartPointer<vtkDataArray> expected = fractionsOf(this->probed(structured));
    double sum = 0;
    for (vtkDataSet* data :
      {static_cast<vtkDataSet*>(image), static_cast<vtkDataSet*>(rectilinear)})
    {
      vtkDataArray* fractions = fractionsOf(this->probed(data));
      ASSERT_EQ(fractions->GetNumberOfTuples(), image->GetNumberOfCells());
      for (vtkIdType i = 0; i < image->GetNumberOfCells(); ++i)
      {
        EXPECT_NEAR(fractions->GetComponent(i, 0), expected->GetComponent(i, 0), 1e-6) << i;
        sum += fractions->GetComponent(i, 0);
      }
    }
    EXPECT_NEAR(0.5 * sum * 0.5 * 0.6 * 0.75, enclosedVolume(source, center), 1e-5);
  }
}

TEST_F(Fraction, IsThatOfTurnedImagesWhereTheyLie)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 8);
  image->SetSpacing(0.5, 0.5, 0.5);
  image->SetOrigin(3, -0.5, -0.2);
  const double c = std::cos(0.3), s = std::sin(0.3);
  const double directions[] = {-c, s, 0, s, c, 0, 0, 0, 1}; // mirrored, too
  image->SetDirectionMatrix(directions);
  for (const int association : {vtkWindingNumberProbe::POINTS, vtkWindingNumberProbe::CELLS})
  {
    probe->SetProbeAssociation(association);
    vtkDataArray* fractions = fractionsOf(this->probed(image));
    double sum = 0;
    for (vtkIdType i = 0; i < image->GetNumberOfCells(); ++i)
    {
      sum += fractions->GetComponent(i, 0);
    }
    EXPECT_NEAR(sum / 8, enclosedVolume(source, center), 1e-5);
  }
}

TEST_F(Fraction, FollowsRuleThresholdAndInsideOut)
{
  const auto mesh = meshOf(VTK_HEXAHEDRON, 3);
  vtkSmartPointer<vtkDataArray> inside = fractionsOf(this->probed(mesh));
  probe->InsideOutOn();
  vtkSmartPointer<vtkDataArray> outside = fractionsOf(this->probed(mesh));
  probe->InsideOutOff();
  probe->SetWindingThreshold(1.5);
  vtkSmartPointer<vtkDataArray> none = fractionsOf(this->probed(mesh));
  bool isPartial = false;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    const double share = inside->GetComponent(i, 0);
    isPartial = isPartial || (share > 0.1 && share < 0.9);
    EXPECT_NEAR(outside->GetComponent(i, 0), 1 - share, 1e-7);
    EXPECT_EQ(none->GetComponent(i, 0), 0);
  }
  EXPECT_TRUE(isPartial);
}

TEST_F(Fraction, GoesToEachLeafOfACompositeDataSet)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 4);
  const auto hexahedra = meshOf(VTK_HEXAHEDRON, 3), tetrahedra = meshOf(VTK_TETRA, 3);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, hexahedra);
  blocks->SetBlock(1, vtkSmartPointer<vtkPolyData>::New());
  blocks->SetBlock(3, image);
  blocks->SetBlock(4, tetrahedra);
  vtkNew<vtkWindingNumberProbe> together;
  together->SetSourceData(source);
  together->GenerateFractionOn();
  together->SetInputData(blocks);
  together->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(together->GetOutputDataObject(0));
  for (const unsigned block : {0U, 3U, 4U})
  {
    auto* found = vtkDataSet::SafeDownCast(output->GetBlock(block));
    vtkDataSet* alone = this->probed(vtkDataSet::SafeDownCast(blocks->GetBlock(block)));
    ASSERT_EQ(fractionsOf(found)->GetNumberOfTuples(), alone->GetNumberOfCells());
    for (vtkIdType i = 0; i < alone->GetNumberOfCells(); ++i)
    {
      EXPECT_EQ(fractionsOf(found)->GetComponent(i, 0), fractionsOf(alone)->GetComponent(i, 0));
    }
  }
}

TEST_F(Fraction, StaysWithTheCellsOfAPart)
{
  const auto mesh = meshOf(VTK_HEXAHEDRON, 3);
  probe->SetProbeAssociationToCells();
  probe->ExtractInsideOn();
  vtkDataSet* part = this->probed(mesh);
  ASSERT_GT(part->GetNumberOfCells(), 0);
  ASSERT_LT(part->GetNumberOfCells(), mesh->GetNumberOfCells());
  for (vtkIdType i = 0; i < part->GetNumberOfCells(); ++i)
  {
    EXPECT_GT(fractionsOf(part)->GetComponent(i, 0), 0.3);
  }
}

TEST_F(Fraction, MayBeTheOnlyArray)
{
  probe->GenerateWindingNumberOff();
  vtkDataSet* result = this->probed(meshOf(VTK_TETRA, 2));
  EXPECT_NE(fractionsOf(result), nullptr);
  EXPECT_EQ(result->GetPointData()->GetArray("Inside"), nullptr);
  probe->GenerateFractionOff();
  ErrorLog log(probe);
  probe->Update();
  EXPECT_NE(log.errors(), "");
}

TEST_F(Fraction, SaysWhichCellsHaveNone)
{
  const auto mesh = meshOf(VTK_QUADRATIC_TETRA, 3);
  {
    ErrorLog log(probe);
    vtkDataSet* result = this->probed(mesh);
    EXPECT_NE(log.warnings().find("have curved faces"), std::string::npos) << log.warnings();
    // They are straight all the same.
    const double volume = enclosedVolume(source, center);
    EXPECT_NEAR(insideOf(result), volume, 1e-6 * volume);
  }
  ErrorLog log(probe);
  vtkDataSet* flat = this->probed(source);
  const std::string count = std::to_string(source->GetNumberOfCells());
  EXPECT_NE(
    log.warnings().find(count + " of " + count + " cells have no volume"), std::string::npos)
    << log.warnings();
  EXPECT_EQ(fractionsOf(flat)->GetNumberOfTuples(), source->GetNumberOfCells());
}

TEST_F(Fraction, IsNaNWhereACellIsNowhere)
{
  const auto mesh = meshOf(VTK_HEXAHEDRON, 1);
  mesh->GetPoints()->SetPoint(0, std::numeric_limits<double>::quiet_NaN(), 0, 0);
  ErrorLog log(probe);
  vtkDataSet* result = this->probed(mesh);
  EXPECT_NE(log.warnings().find("1 of 1 cells are empty or not finite"), std::string::npos)
    << log.warnings();
  EXPECT_TRUE(std::isnan(fractionsOf(result)->GetComponent(0, 0)));
}

TEST_F(Fraction, IsNaNWhereFacesOfAPolyhedronDoNotClose)
{
  vtkNew<vtkUnstructuredGrid> mesh;
  mesh->SetPoints(meshOf(VTK_TETRA, 1)->GetPoints());
  const vtkIdType ids[] = {0, 1, 2, 4};
  const vtkIdType faces[] = {3, 0, 1, 2, 3, 0, 4, 1, 3, 1, 4, 2, 3, 2, 4, 0};
  mesh->InsertNextCell(VTK_POLYHEDRON, 4, ids, 4, faces);
  mesh->InsertNextCell(VTK_POLYHEDRON, 4, ids, 3, faces);
  ErrorLog log(probe);
  vtkDataSet* result = this->probed(mesh);
  EXPECT_NE(log.warnings().find("1 of 2 cells are not closed"), std::string::npos)
    << log.warnings();
  EXPECT_FALSE(std::isnan(fractionsOf(result)->GetComponent(0, 0)));
  EXPECT_TRUE(std::isnan(fractionsOf(result)->GetComponent(1, 0)));
}

TEST_F(Fraction, RefusesOtherArraysOfItsName)
{
  probe->SetResultArrayName("Fraction");
  ErrorLog log(probe);
  this->probed(meshOf(VTK_HEXAHEDRON, 1));
  EXPECT_NE(log.errors().find("two arrays of the result are named 'Fraction'"), std::string::npos)
    << log.errors();
}

TEST_F(Fraction, KeepsGhostCells)
{
  const auto mesh = meshOf(VTK_HEXAHEDRON, 3);
  vtkSmartPointer<vtkDataArray> expected = fractionsOf(this->probed(mesh));
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(mesh->GetNumberOfCells());
  ghosts->Fill(vtkDataSetAttributes::DUPLICATECELL);
  mesh->GetCellData()->AddArray(ghosts);
  vtkDataArray* fractions = fractionsOf(this->probed(mesh));
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    EXPECT_EQ(fractions->GetComponent(i, 0), expected->GetComponent(i, 0));
  }
}

TEST_F(Fraction, HasTheSameBitsForAnyThreadsAndCanBeAborted)
{
  const auto mesh = meshOf(VTK_HEXAHEDRON, 12);
  probe->SetNumberOfThreads(1);
  vtkSmartPointer<vtkDataArray> expected = fractionsOf(this->probed(mesh));
  probe->SetNumberOfThreads(3);
  {
    const ProgressLog progress(probe);
    vtkDataArray* fractions = fractionsOf(this->probed(mesh));
    EXPECT_TRUE(progress.isRising());
    EXPECT_EQ(progress.last(), 1);
    for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
    {
      EXPECT_EQ(fractions->GetComponent(i, 0), expected->GetComponent(i, 0));
    }
  }
  probe->Modified();
  const ProgressLog progress(probe, 0.5);
  probe->Update();
  EXPECT_GT(progress.abortedAt(), 0);
  EXPECT_EQ(fractionsOf(probe->GetOutput()), nullptr);
}

TEST_F(Fraction, CountsInExpectedMemory)
{
  const auto mesh = meshOf(VTK_HEXAHEDRON, 8);
  this->probed(mesh);
  const vtkIdType with = probe->GetExpectedMemory();
  probe->GenerateFractionOff();
  probe->Update();
  EXPECT_GE(with - probe->GetExpectedMemory(), 45 * mesh->GetNumberOfCells());
}

} // namespace
