// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"
#include "vtk/SurfaceMeasures.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFeatureEdges.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberVoxels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <vector>

namespace
{

/// An image of points with the given scalars, voxels of 2 x 1 x 0.5, first centre at (10, 0, 0).
vtkSmartPointer<vtkImageData> image(int nx, int ny, int nz, const std::vector<float>& values)
{
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->SetDimensions(nx, ny, nz);
  result->SetOrigin(10, 0, 0);
  result->SetSpacing(2, 1, 0.5);
  result->AllocateScalars(VTK_FLOAT, 1);
  std::copy(values.begin(), values.end(), static_cast<float*>(result->GetScalarPointer()));
  return result;
}

TEST(Voxels, OneVoxelIsABoxAroundItsSample)
{
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputData(image(1, 1, 1, {1}));
  voxels->Update();
  vtkPolyData* box = voxels->GetOutput();
  EXPECT_EQ(box->GetNumberOfPoints(), 8);
  EXPECT_EQ(box->GetNumberOfPolys(), 6);
  const double expected[6] = {9, 11, -0.5, 0.5, -0.25, 0.25};
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_EQ(box->GetBounds()[i], expected[i]);
  }
  EXPECT_NEAR(signedVolume(box), 1, 1e-12) << "2 x 1 x 0.5, faces outwards";
}

TEST(Voxels, NeighboursShareVerticesAndHaveNoFaceBetweenThem)
{
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputData(image(2, 2, 2, {1, 1, 1, 1, 1, 1, 1, 0}));
  voxels->Update();
  EXPECT_EQ(voxels->GetOutput()->GetNumberOfPoints(), 26) << "all corners of 2 x 2 x 2 but one";
  EXPECT_EQ(voxels->GetOutput()->GetNumberOfPolys(), 24);
  EXPECT_NEAR(signedVolume(voxels->GetOutput()), 7, 1e-12);
}

TEST(Voxels, AllOutsideGivesNothingAndNaNIsOutside)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputData(image(3, 1, 1, {0, nan, 0.49F}));
  voxels->Update();
  EXPECT_EQ(voxels->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(voxels->GetOutput()->GetNumberOfPolys(), 0);
}

TEST(Voxels, RulesAreThoseOfTheField)
{
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputData(image(4, 1, 1, {-1, 0, 1, 2}));
  const auto volume = [&]()
  {
    voxels->Update();
    return signedVolume(voxels->GetOutput());
  };
  EXPECT_NEAR(volume(), 2, 1e-12);
  voxels->SetInsideRule(vtkWindingNumberField::ABSOLUTE);
  EXPECT_NEAR(volume(), 3, 1e-12);
  voxels->SetInsideRule(vtkWindingNumberField::ODD);
  EXPECT_NEAR(volume(), 2, 1e-12);
  voxels->SetInsideRule(vtkWindingNumberField::SIGNED);
  voxels->SetWindingThreshold(1.5);
  EXPECT_NEAR(volume(), 1, 1e-12);
}

TEST(Voxels, RandomImagesGiveClosedOutwardSurfacesWithoutSpareParts)
{
  unsigned seed = 7;
  std::vector<float> values(9 * 8 * 7);
  std::size_t inside = 0;
  for (float& value : values)
  {
    seed = seed * 1664525u + 1013904223u;
    value = static_cast<float>(seed >> 31);
    inside += value == 1;
  }
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputData(image(9, 8, 7, values));
  voxels->Update();
  vtkPolyData* surface = voxels->GetOutput();
  EXPECT_NEAR(signedVolume(surface), static_cast<double>(inside), 1e-9);

  std::set<std::vector<double>> positions;
  std::set<std::vector<vtkIdType>> faces;
  std::set<vtkIdType> used;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* p = surface->GetPoint(i);
    EXPECT_TRUE(positions.insert({p[0], p[1], p[2]}).second) << "point " << i << " stands twice";
  }
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, size, ids);
    ASSERT_EQ(size, 4);
    std::vector<vtkIdType> face(ids, ids + size);
    used.insert(face.begin(), face.end());
    std::sort(face.begin(), face.end());
    EXPECT_TRUE(faces.insert(face).second) << "face " << cell << " stands twice";
  }
  EXPECT_EQ(used.size(), static_cast<std::size_t>(surface->GetNumberOfPoints()));

  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->FeatureEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ManifoldEdgesOff();
  edges->BoundaryEdgesOn();
  edges->Update();
  EXPECT_EQ(edges->GetOutput()->GetNumberOfCells(), 0) << "the surface is closed";
}

TEST(Voxels, FollowsPointsAndCellsOfTheFieldAlike)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetResolution(12);
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputConnection(field->GetOutputPort());
  voxels->Update();
  vtkNew<vtkPolyData> fromPoints;
  fromPoints->DeepCopy(voxels->GetOutput());
  field->SetOutputAssociationToCells();
  voxels->Update();
  vtkPolyData* fromCells = voxels->GetOutput();
  ASSERT_GT(fromCells->GetNumberOfPolys(), 0);
  ASSERT_EQ(fromPoints->GetNumberOfPoints(), fromCells->GetNumberOfPoints());
  ASSERT_EQ(fromPoints->GetNumberOfPolys(), fromCells->GetNumberOfPolys());
  for (vtkIdType i = 0; i < fromPoints->GetNumberOfPoints(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_NEAR(fromPoints->GetPoint(i)[axis], fromCells->GetPoint(i)[axis], 1e-15);
    }
  }
}

TEST(Voxels, FirstPieceHasItAll)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetResolution(12);
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputConnection(field->GetOutputPort());
  voxels->Update();
  const vtkIdType all = voxels->GetOutput()->GetNumberOfPolys();
  for (int piece : {0, 1})
  {
    field->Modified();
    voxels->UpdatePiece(piece, 2, 0);
    EXPECT_EQ(voxels->GetOutput()->GetNumberOfPolys(), piece == 0 ? all : 0);
  }
}

TEST(Voxels, UnknownArrayMeansTheActiveScalars)
{
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputData(image(1, 1, 1, {1}));
  voxels->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "");
  voxels->Update();
  EXPECT_EQ(voxels->GetOutput()->GetNumberOfPolys(), 6);
}

TEST(Voxels, DirectionsOfTheImageAreFollowed)
{
  // The image is turned by a quarter about z, and then also mirrored.
  for (const double mirror : {1.0, -1.0})
  {
    auto turned = image(1, 1, 1, {1});
    turned->SetOrigin(0, 0, 0);
    turned->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, mirror);
    vtkNew<vtkWindingNumberVoxels> voxels;
    voxels->SetInputData(turned);
    voxels->Update();
    const double expected[6] = {-0.5, 0.5, -1, 1, -0.25, 0.25};
    for (int i = 0; i < 6; ++i)
    {
      EXPECT_NEAR(voxels->GetOutput()->GetBounds()[i], expected[i], 1e-15);
    }
    EXPECT_NEAR(signedVolume(voxels->GetOutput()), 1, 1e-12) << "faces outwards";
  }
}

TEST(Voxels, AxesThatRunBackwardsAreFollowed)
{
  // VTK's images may have negative spacings: one or three of them mirror the voxels.
  for (const auto& [x, y, z] : {std::array{-1, 1, 1}, {1, -1, -1}, {-1, -1, -1}})
  {
    auto mirrored = image(1, 1, 1, {1});
    mirrored->SetSpacing(x, 2 * y, 3 * z);
    vtkNew<vtkWindingNumberVoxels> voxels;
    voxels->SetInputData(mirrored);
    voxels->Update();
    EXPECT_NEAR(signedVolume(voxels->GetOutput()), 6, 1e-12) << x << " " << y << " " << z;
  }
}

/// The voxels of an image whose extent does not begin at 0 lie around its points, or are its cells.
TEST(Voxels, ExtentsMayBeginAnywhere)
{
  for (const bool asCells : {false, true})
  {
    const int more = asCells ? 1 : 0;
    vtkNew<vtkImageData> part;
    part->SetExtent(3, 3 + more, -2, -2 + more, 7, 7 + more);
    part->SetOrigin(10, 20, 30);
    part->SetSpacing(2, 1, 0.5);
    vtkNew<vtkFloatArray> values;
    values->SetName("w");
    values->InsertNextValue(1);
    vtkDataSetAttributes* attributes = part->GetPointData();
    if (asCells)
    {
      attributes = part->GetCellData();
    }
    attributes->SetScalars(values);
    vtkNew<vtkWindingNumberVoxels> voxels;
    voxels->SetInputData(part);
    voxels->Update();
    const double shift = asCells ? 0.5 : 0;
    const double expected[6] = {16 - 1 + 2 * shift, 16 + 1 + 2 * shift, 18 - 0.5 + shift,
      18 + 0.5 + shift, 33.5 - 0.25 + 0.5 * shift, 33.5 + 0.25 + 0.5 * shift};
    for (int i = 0; i < 6; ++i)
    {
      EXPECT_EQ(voxels->GetOutput()->GetBounds()[i], expected[i]) << asCells << i;
    }
  }
}

TEST(Voxels, FlatImageOfCellsIsALayer)
{
  vtkNew<vtkImageData> flat;
  flat->SetDimensions(3, 3, 1);
  vtkNew<vtkFloatArray> values;
  values->SetName("w");
  values->SetNumberOfTuples(4);
  values->Fill(1);
  flat->GetCellData()->SetScalars(values);
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputData(flat);
  voxels->Update();
  EXPECT_EQ(voxels->GetOutput()->GetNumberOfPolys(), 16);
}

TEST(Voxels, ArrayThatIsNotOfTheVoxelsIsAnError)
{
  auto source = image(3, 3, 3, std::vector<float>(27, 1));
  vtkNew<vtkFloatArray> other;
  other->SetName("other");
  other->InsertNextValue(1);
  source->GetFieldData()->AddArray(other);
  vtkNew<vtkWindingNumberVoxels> voxels;
  ErrorLog log(voxels);
  voxels->SetInputData(source);
  voxels->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_NONE, "other");
  voxels->Update();
  EXPECT_NE(log.errors().find("has 1 values for 27 voxels"), std::string::npos) << log.errors();
}

TEST(Voxels, ImageWithoutScalarsIsAnError)
{
  vtkNew<vtkImageData> empty;
  empty->SetDimensions(3, 3, 3);
  vtkNew<vtkWindingNumberVoxels> voxels;
  ErrorLog log(voxels);
  voxels->SetInputData(empty);
  voxels->Update();
  EXPECT_NE(log.errors().find("the image has no scalar array"), std::string::npos) << log.errors();
}

} // namespace
