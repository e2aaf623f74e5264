// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/RealMeshes.h"
#include "vtk/ErrorLog.h"
#include "vtk/ProgressLog.h"
#include "vtk/ReadMesh.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMassProperties.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberVoxels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <random>
#include <set>

namespace
{

using Filter = vtkWindingNumberField;

/// A sphere with a part cut off, or a whole one.
class Coverage : public testing::Test
{
protected:
  Coverage()
  {
    sphere->SetThetaResolution(30);
    sphere->SetPhiResolution(20);
    field->SetInputConnection(sphere->GetOutputPort());
    field->SetResolution(22);
  }

  vtkSmartPointer<vtkImageData> made(int coverage)
  {
    field->SetCoverage(coverage);
    field->Update();
    auto copy = vtkSmartPointer<vtkImageData>::New();
    copy->DeepCopy(field->GetOutput());
    return copy;
  }

  static unsigned char* insideOf(vtkImageData* image)
  {
    return vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetArray("Inside"))
      ->GetPointer(0);
  }

  static float* sharesOf(vtkImageData* image)
  {
    return vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("Coverage"))->GetPointer(0);
  }

  vtkNew<vtkSphereSource> sphere;
  vtkNew<Filter> field;
};

TEST_F(Coverage, DefaultsAreTheDocumentedOnes)
{
  EXPECT_EQ(field->GetCoverage(), Filter::CENTER);
  EXPECT_EQ(field->GetCoverageSamples(), 4);
}

TEST_F(Coverage, AddsItsArraysAndLeavesWindingNumbersAlone)
{
  const auto plain = made(Filter::CENTER);
  EXPECT_EQ(plain->GetPointData()->GetNumberOfArrays(), 1);
  field->GenerateInsideOn();
  const auto center = made(Filter::CENTER);
  field->GenerateInsideOff();
  const auto any = made(Filter::ANY);
  EXPECT_EQ(any->GetPointData()->GetNumberOfArrays(), 2) << "Inside, though not asked for";
  const auto fraction = made(Filter::FRACTION);
  EXPECT_EQ(fraction->GetPointData()->GetNumberOfArrays(), 3);
  EXPECT_STREQ(center->GetPointData()->GetScalars()->GetName(), "WindingNumber");
  EXPECT_STREQ(any->GetPointData()->GetScalars()->GetName(), "Inside");
  EXPECT_STREQ(fraction->GetPointData()->GetScalars()->GetName(), "Inside");
  const auto count = plain->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double w = plain->GetPointData()->GetScalars()->GetTuple1(i);
    ASSERT_EQ(any->GetPointData()->GetArray("WindingNumber")->GetTuple1(i), w);
    ASSERT_EQ(fraction->GetPointData()->GetArray("WindingNumber")->GetTuple1(i), w);
    ASSERT_EQ(insideOf(center)[i], w >= 0.5);
    ASSERT_GE(insideOf(any)[i], insideOf(center)[i]);
    ASSERT_EQ(insideOf(fraction)[i], sharesOf(fraction)[i] >= 0.5F);
    ASSERT_LE(sharesOf(fraction)[i] > 0, insideOf(any)[i]) << "what is partly inside overlaps";
  }
  // The arrays of the voxels are the same without w.
  field->GenerateWindingNumberOff();
  const auto only = made(Filter::FRACTION);
  EXPECT_EQ(only->GetPointData()->GetNumberOfArrays(), 2);
  EXPECT_STREQ(only->GetPointData()->GetScalars()->GetName(), "Inside");
  EXPECT_TRUE(std::equal(sharesOf(only), sharesOf(only) + count, sharesOf(fraction)));
  const auto onlyAny = made(Filter::ANY);
  EXPECT_TRUE(std::equal(insideOf(onlyAny), insideOf(onlyAny) + count, insideOf(any)));
}

TEST_F(Coverage, IsTheSameForPointsAndCellsAndPiecesOfThem)
{
  for (const double end : {180.0, 120.0})
  {
    sphere->SetEndPhi(end);
    for (const int coverage : {Filter::ANY, Filter::FRACTION})
    {
      field->SetOutputAssociationToPoints();
      const auto whole = made(coverage);
      field->SetOutputAssociationToCells();
      field->Update();
      const auto cells = field->GetOutput()->GetCellData();
      ASSERT_EQ(0, std::memcmp(insideOf(whole), cells->GetArray("Inside")->GetVoidPointer(0),
                     static_cast<std::size_t>(whole->GetNumberOfPoints())));
      field->SetOutputAssociationToPoints();
      const char* const name = coverage == Filter::ANY ? "Inside" : "Coverage";
      for (int piece = 0; piece < 7; ++piece)
      {
        field->Modified();
        field->UpdatePiece(piece, 7, 0);
        vtkImageData* part = field->GetOutput();
        for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
        {
          const vtkIdType same = whole->FindPoint(part->GetPoint(i));
          ASSERT_EQ(part->GetPointData()->GetArray(name)->GetTuple1(i),
            whole->GetPointData()->GetArray(name)->GetTuple1(same));
        }
      }
    }
  }
}

/// The sum of all shares is the volume of the polyhedron, much better than the number of centres
/// inside.
TEST_F(Coverage, SharesAddUpToTheVolume)
{
  sphere->SetCenter(0.013, -0.027, 0.041);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkMassProperties> mass;
  mass->SetInputConnection(triangles->GetOutputPort());
  const double expected = mass->GetVolume();
  const int resolutions[] = {10, 18, 32, 64};
  // Measured errors: 1.2e-3, 1.2e-4, 1.2e-4, 4.8e-5; by centres 5.9e-2, 2.9e-2, 2.3e-3, 2.2e-4.
  const double largest[] = {2e-3, 3e-4, 3e-4, 1e-4};
  for (int i = 0; i < 4; ++i)
  {
    field->SetResolution(resolutions[i]);
    field->GenerateInsideOn();
    const auto center = made(Filter::CENTER), fraction = made(Filter::FRACTION);
    double shares = 0, centers = 0;
    for (vtkIdType n = 0; n < center->GetNumberOfPoints(); ++n)
    {
      shares += sharesOf(fraction)[n];
      centers += insideOf(center)[n];
    }
    const double* h = center->GetSpacing();
    const double error = std::abs(shares * h[0] * h[1] * h[2] / expected - 1);
    const double errorOfCenters = std::abs(centers * h[0] * h[1] * h[2] / expected - 1);
    RecordProperty("error" + std::to_string(resolutions[i]), std::to_string(error));
    RecordProperty(
      "errorOfCenters" + std::to_string(resolutions[i]), std::to_string(errorOfCenters));
    EXPECT_LT(error, largest[i]) << resolutions[i];
    EXPECT_LT(3 * error, errorOfCenters) << resolutions[i];
  }
}

TEST_F(Coverage, MoreSamplesAreFinerShares)
{
  field->SetResolution(10);
  for (const int samples : {1, 2, 5})
  {
    field->SetCoverageSamples(samples);
    const auto image = made(Filter::FRACTION);
    const float whole = static_cast<float>(samples * samples * samples);
    std::set<float> different(sharesOf(image), sharesOf(image) + image->GetNumberOfPoints());
    EXPECT_LE(different.size(), static_cast<std::size_t>(whole) + 1);
    EXPECT_GE(different.size(), static_cast<std::size_t>(samples) + 1);
    for (const float share : different)
    {
      EXPECT_NEAR(share * whole, std::round(share * whole), 1e-4);
    }
  }
}

TEST_F(Coverage, VoxelsShowWhatIsInsideByAnotherThresholdToo)
{
  field->GenerateInsideOn();
  for (const double threshold : {0.5, 0.25})
  {
    field->SetWindingThreshold(threshold);
    const auto image = made(Filter::CENTER);
    EXPECT_STREQ(image->GetPointData()->GetScalars()->GetName(),
      threshold == 0.5 ? "WindingNumber" : "Inside");
  }
  field->SetWindingThreshold(0.5);
  field->SetInsideRuleToAbsolute();
  EXPECT_STREQ(made(Filter::CENTER)->GetPointData()->GetScalars()->GetName(), "Inside");
}

/// The array says which voxels are beyond any share, and quads carry the share of their voxel.
TEST_F(Coverage, VoxelsFollowInsideAndShares)
{
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputConnection(field->GetOutputPort());
  for (const int association : {Filter::POINTS, Filter::CELLS})
  {
    field->SetOutputAssociation(association);
    field->SetCoverage(Filter::FRACTION);
    const auto from = association == Filter::CELLS ? vtkDataObject::FIELD_ASSOCIATION_CELLS
                                                   : vtkDataObject::FIELD_ASSOCIATION_POINTS;
    vtkIdType last = VTK_ID_MAX;
    for (const double share : {0.01, 0.5, 0.99})
    {
      voxels->SetInputArrayToProcess(0, 0, 0, from, "Coverage");
      voxels->SetWindingThreshold(share);
      voxels->Update();
      vtkPolyData* surface = voxels->GetOutput();
      vtkDataArray* shares = surface->GetCellData()->GetArray("Coverage");
      ASSERT_NE(shares, nullptr);
      ASSERT_EQ(shares->GetNumberOfTuples(), surface->GetNumberOfCells());
      EXPECT_LT(surface->GetNumberOfCells(), last);
      last = surface->GetNumberOfCells();
      EXPECT_GE(shares->GetRange()[0], share) << "all are of voxels inside";
      if (share == 0.5)
      {
        voxels->SetInputArrayToProcess(0, 0, 0, from, "Inside");
        voxels->Update();
        EXPECT_EQ(voxels->GetOutput()->GetNumberOfCells(), last);
      }
    }
    // A quad's own voxel is on the side that it does not look at.
    voxels->SetInputArrayToProcess(0, 0, 0, from, "Coverage");
    voxels->SetWindingThreshold(0.2);
    voxels->Update();
    vtkPolyData* surface = voxels->GetOutput();
    vtkImageData* image = field->GetOutput();
    vtkDataArray* all = association == Filter::CELLS ? image->GetCellData()->GetArray("Coverage")
                                                     : image->GetPointData()->GetArray("Coverage");
    for (vtkIdType quad = 0; quad < surface->GetNumberOfCells(); ++quad)
    {
      double corners[4][3], behind[3];
      for (int i = 0; i < 4; ++i)
      {
        surface->GetPoint(surface->GetCell(quad)->GetPointId(i), corners[i]);
      }
      const double h = image->GetSpacing()[0];
      for (int axis = 0; axis < 3; ++axis)
      {
        const int b = (axis + 1) % 3, c = (axis + 2) % 3;
        const double normal = (corners[1][b] - corners[0][b]) * (corners[3][c] - corners[0][c]) -
                              (corners[1][c] - corners[0][c]) * (corners[3][b] - corners[0][b]);
        behind[axis] = 0.5 * (corners[0][axis] + corners[2][axis]) - 0.5 * normal / h;
      }
      vtkIdType voxel = image->FindPoint(behind);
      if (association == Filter::CELLS)
      {
        double place[3], weights[8];
        int sub;
        voxel = image->FindCell(behind, nullptr, 0, 0, sub, place, weights);
      }
      ASSERT_EQ(
        surface->GetCellData()->GetArray("Coverage")->GetTuple1(quad), all->GetTuple1(voxel));
    }
  }
}

TEST_F(Coverage, ExpectsMoreMemoryThanTheField)
{
  field->SetResolution(40);
  sphere->SetEndPhi(120);
  vtkIdType memory[3];
  for (const int coverage : {Filter::CENTER, Filter::ANY, Filter::FRACTION})
  {
    made(coverage);
    memory[coverage] = field->GetExpectedMemory();
  }
  EXPECT_GT(memory[1], memory[0] + field->GetOutput()->GetNumberOfPoints());
  EXPECT_GT(memory[2], memory[0] + 60 * field->GetOutput()->GetNumberOfPoints());
}

TEST_F(Coverage, ProgressRisesAndAbortLeavesNothing)
{
  for (const double end : {180.0, 120.0})
  {
    sphere->SetEndPhi(end);
    for (const int coverage : {Filter::ANY, Filter::FRACTION})
    {
      field->SetCoverage(coverage);
      field->Modified();
      {
        const ProgressLog log(field);
        field->Update();
        EXPECT_TRUE(log.isRising());
        EXPECT_EQ(log.last(), 1);
      }
      const ProgressLog log(field, 0);
      field->Modified();
      field->Update();
      EXPECT_EQ(field->GetStatus(), Filter::ABORTED);
      EXPECT_EQ(field->GetOutput()->GetNumberOfPoints(), 0);
    }
  }
}

TEST_F(Coverage, NameOfItsArrayIsTaken)
{
  ErrorLog log(field);
  field->SetResultArrayName("Coverage");
  field->SetCoverageToFraction();
  field->Update();
  EXPECT_EQ(field->GetStatus(), Filter::REFUSED);
  EXPECT_NE(log.errors().find("two arrays of the result are named 'Coverage'"), std::string::npos)
    << log.errors();
  field->SetCoverageToAny();
  field->Update();
  EXPECT_EQ(field->GetStatus(), Filter::DONE);
}

TEST_F(Coverage, NothingIsInsideOfNothing)
{
  vtkNew<vtkPolyData> nothing;
  vtkNew<Filter> empty;
  empty->SetInputData(nothing);
  empty->SetResolution(4);
  ErrorLog log(empty); // catches the warning that the source is empty
  for (const int coverage : {Filter::ANY, Filter::FRACTION})
  {
    empty->SetCoverage(coverage);
    empty->Update();
    EXPECT_EQ(empty->GetOutput()->GetPointData()->GetArray("Inside")->GetRange()[1], 0);
  }
}

/// The voxels of ANY hold the surface.
class CoverageOfSharedMeshes : public testing::TestWithParam<const char*>
{
};

TEST_P(CoverageOfSharedMeshes, HoldsEveryVertexAndPointsOfEveryTriangle)
{
  const vtkSmartPointer<vtkPolyData> read = readMesh(shapes::realMesh(GetParam()));
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(read);
  triangulate->Update();
  vtkPolyData* mesh = triangulate->GetOutput();
  const bool isCloud = mesh->GetNumberOfPolys() == 0;
  vtkNew<Filter> field;
  field->SetInputData(isCloud ? read.Get() : mesh);
  field->SetResolution(48);
  field->GenerateWindingNumberOff();
  field->GenerateInsideOn();
  field->Update();
  vtkNew<vtkImageData> center;
  center->DeepCopy(field->GetOutput());
  field->SetCoverageToAny();
  field->Update();
  vtkImageData* any = field->GetOutput();
  const auto insideAt = [](vtkImageData* image, const double* p)
  {
    const vtkIdType voxel = image->FindPoint(const_cast<double*>(p));
    return voxel >= 0 && image->GetPointData()->GetArray("Inside")->GetTuple1(voxel) != 0;
  };
  for (vtkIdType i = 0; i < any->GetNumberOfPoints(); ++i)
  {
    ASSERT_GE(any->GetPointData()->GetArray("Inside")->GetTuple1(i),
      center->GetPointData()->GetArray("Inside")->GetTuple1(i));
  }
  vtkIdType missed = 0;
  if (isCloud)
  {
    for (vtkIdType i = 0; i < read->GetNumberOfPoints(); ++i)
    {
      ASSERT_TRUE(insideAt(any, read->GetPoint(i))) << i;
    }
  }
  SCOPED_TRACE("seed 81");
  std::mt19937 random(81);
  std::uniform_real_distribution<double> uniform;
  const int perTriangle =
    static_cast<int>(200000 / std::max<vtkIdType>(1, mesh->GetNumberOfPolys())) + 2;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    mesh->GetPolys()->GetCellAtId(cell, size, ids);
    for (int n = 0; n < 3 + perTriangle; ++n)
    {
      double weights[3] = {n == 0 ? 1.0 : 0.0, n == 1 ? 1.0 : 0.0, n == 2 ? 1.0 : 0.0};
      if (n >= 3)
      {
        const double root = std::sqrt(uniform(random)), along = uniform(random);
        weights[0] = 1 - root;
        weights[1] = root * (1 - along);
        weights[2] = root * along;
      }
      double p[3] = {0, 0, 0};
      for (int corner = 0; corner < 3; ++corner)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          p[axis] += weights[corner] * mesh->GetPoint(ids[corner])[axis];
        }
      }
      ASSERT_TRUE(insideAt(any, p))
        << "triangle " << cell << " at " << p[0] << " " << p[1] << " " << p[2];
      missed += !insideAt(center, p);
    }
  }
  RecordProperty("missedByCentres",
    std::to_string(
      100.0 * static_cast<double>(missed) /
      std::max(1.0, static_cast<double>(mesh->GetNumberOfPolys() * (3 + perTriangle)))));
  EXPECT_TRUE(isCloud || missed > 0) << "by the centres";
}

INSTANTIATE_TEST_SUITE_P(All, CoverageOfSharedMeshes,
  testing::ValuesIn(shapes::present({"aneurysm_open.stl", "armadillo_86k.obj", "bunny_70k.obj",
    "bunny_res2_nonmanifold.ply", "fractures_dfn2.vtp", "kitten_points_normals.ply",
    "maxplanck_open_90k.obj", "self_intersectA.obj", "tray_thin_cad.stl", "truck_soup.obj"})),
  [](const auto& parameter)
  {
    const std::string name = parameter.param;
    return name.substr(0, name.find('.'));
  });

} // namespace
