// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/RealMeshes.h"
#include "vtk/ReadMesh.h"
#include "vtk/SurfaceMeasures.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkWindingNumberSurface.h"

#include <gtest/gtest.h>

#include <fstream>
#include <vector>

namespace
{

/// Tests surfaces of meshes and clouds that were made elsewhere.
class SurfacesOfSharedData : public testing::TestWithParam<const char*>
{
protected:
  void SetUp() override
  {
    mesh = readMesh(shapes::realMesh(GetParam()));
    filter->SetInputData(mesh);
    filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  }

  vtkSmartPointer<vtkPolyData> mesh;
  vtkNew<vtkWindingNumberSurface> filter;
};

using SurfacesOfClosedMeshes = SurfacesOfSharedData;
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(SurfacesOfOpenData); // a fresh clone has none

TEST_P(SurfacesOfClosedMeshes, LieOnThemAndAreClosed)
{
  for (const int resolution : {33, 64, 128})
  {
    filter->SetResolution(resolution);
    filter->Update();
    const std::vector<double> found = distances(filter->GetOutput(), mesh, voxelOf(filter));
    ASSERT_GT(found.size(), 500u);
    EXPECT_LT(found[found.size() * 99 / 100], 1e-3); // measured: 4e-6, the locator's error
    EXPECT_LT(found.back(), 3e-4);                   // measured: 2.4e-4, near samples
    const EdgeCounts edges = countEdges(filter->GetOutput());
    EXPECT_EQ(edges.open, 0);
    EXPECT_EQ(edges.nonManifold, 0);
    EXPECT_GT(signedVolume(filter->GetOutput()), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(OfSharedData, SurfacesOfClosedMeshes,
  testing::ValuesIn(shapes::present({"bunny_70k.obj", "armadillo_86k.obj", "teapot.obj"})),
  [](const auto& mesh) { return shapes::testNameOf(mesh.param); });

using SurfacesOfOpenData = SurfacesOfSharedData;

TEST_P(SurfacesOfOpenData, LieAtTheLevelOrOnAJumpOverIt)
{
  filter->SetResolution(64);
  filter->Update();
  ASSERT_GT(filter->GetOutput()->GetNumberOfPoints(), 1000);
  const EdgeCounts edges = countEdges(filter->GetOutput());
  EXPECT_EQ(edges.open, 0);
  EXPECT_EQ(edges.nonManifold, 0);
  EXPECT_EQ(countOffLevel(filter, mesh, 600, 1e-3), 0);
}

INSTANTIATE_TEST_SUITE_P(OfSharedData, SurfacesOfOpenData,
  testing::ValuesIn(shapes::present(
    {"bunny_res2_nonmanifold.ply", "maxplanck_open_90k.obj", "kitten_points_normals.ply"})),
  [](const auto& mesh) { return shapes::testNameOf(mesh.param); });

} // namespace
