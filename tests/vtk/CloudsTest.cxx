// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"
#include "vtk/HowTo.h"
#include "vtk/PointProbe.h"
#include "vtk/SphereCloud.h"
#include "vtk/Spheres.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkWindingNumberProbe.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

class Clouds : public PointProbe
{
};

TEST_F(Clouds, NormalsAreEstimatedOnRequestAndOutward)
{
  {
    ErrorLog log(probe);
    this->windingNumber(sphereCloud(2000, 0));
    EXPECT_NE(log.errors().find(howTo({winding::Parameter::estimateNormals, 1})), std::string::npos)
      << log.errors();
  }
  probe->EstimateNormalsOn();
  ErrorLog log(probe);
  EXPECT_NEAR(this->windingNumber(sphereCloud(2000, 0)), 1, 0.01);
  EXPECT_TRUE(probe->GetNormalsWereEstimated());
  EXPECT_STREQ(probe->GetNormalEstimationUsed(), "spanning tree");
  EXPECT_EQ(probe->GetClearShare(), 1);
  vtkFieldData* data = probe->GetOutputDataObject(0)->GetFieldData();
  auto* used =
    vtkStringArray::SafeDownCast(data->GetAbstractArray("WindingNumberNormalEstimation"));
  ASSERT_TRUE(used);
  EXPECT_EQ(used->GetValue(0), "spanning tree");
  ASSERT_TRUE(data->GetArray("WindingNumberClearShare"));
  EXPECT_EQ(data->GetArray("WindingNumberClearShare")->GetTuple1(0), 1);
  EXPECT_EQ(log.errors() + log.warnings(), "");
}

/// The spanning tree takes both spheres for outer surfaces.
TEST_F(Clouds, NormalsOfNestedShellsAreThoseThatTheFieldAgreesWith)
{
  vtkNew<vtkMultiBlockDataSet> shells;
  shells->SetBlock(0, sphereCloud(4000, 0));
  vtkNew<vtkPoints> inner;
  const auto sphere = sphereCloud(2000, 0);
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    double x[3];
    sphere->GetPoint(i, x);
    inner->InsertNextPoint(0.7 * x[0], 0.7 * x[1], 0.7 * x[2]);
  }
  vtkNew<vtkPolyData> cavity;
  cavity->SetPoints(inner);
  shells->SetBlock(1, cavity);
  probe->EstimateNormalsOn();
  EXPECT_NEAR(this->windingNumber(shells), 0, 0.01);
  EXPECT_STREQ(probe->GetNormalEstimationUsed(), "winding consistent");
  EXPECT_GT(probe->GetClearShare(), 0.95);

  probe->SetNormalEstimation(vtkWindingNumberAlgorithm::SPANNING_TREE);
  EXPECT_GT(std::abs(this->windingNumber(shells)), 1.9);
  EXPECT_STREQ(probe->GetNormalEstimationUsed(), "spanning tree");
}

TEST_F(Clouds, NormalsThatThereAreAreKept)
{
  probe->EstimateNormalsOn();
  EXPECT_NEAR(this->windingNumber(sphereCloud(2000, -1)), -1, 0.01);
  EXPECT_FALSE(probe->GetNormalsWereEstimated());
  EXPECT_STREQ(probe->GetNormalEstimationUsed(), "");
}

TEST_F(Clouds, BlocksAreOrientedTogetherWhereOneHasNoNormals)
{
  probe->EstimateNormalsOn();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, sphereCloud(2000, -1)); // as it is, it would count −1
  blocks->SetBlock(1, sphereCloud(2000, 0, 5));
  EXPECT_NEAR(this->windingNumber(blocks), 1, 0.01);
  EXPECT_NEAR(this->windingNumber(blocks, 5), 1, 0.01);
}

TEST_F(Clouds, ThatEncloseNothingAreSaidToBeSo)
{
  auto sheet = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 900; ++i)
  {
    points->InsertNextPoint(i % 30, i / 30, 0);
  }
  sheet->SetPoints(points);
  probe->EstimateNormalsOn();
  ErrorLog log(probe);
  this->windingNumber(sheet);
  EXPECT_NE(log.warnings().find("estimated normals are not right everywhere"), std::string::npos)
    << log.warnings();
  EXPECT_LT(probe->GetClearShare(), 0.1);
}

TEST_F(Clouds, EachKindOfAreasGivesAPlateau)
{
  const auto mesh = sphereOf(60, 60, 1);
  probe->SourceAsPointsOn();
  for (const int method : {vtkWindingNumberProbe::VORONOI, vtkWindingNumberProbe::MESH})
  {
    probe->SetPointAreaMethod(method);
    EXPECT_NEAR(this->windingNumber(mesh), 1, 0.01) << method;
    EXPECT_NEAR(this->windingNumber(mesh, 0.5, 0.3, 0.2), 1, 0.01) << method;
  }
  // The poles are sampled far more densely than the equator.
  probe->SetPointAreaMethod(vtkWindingNumberProbe::CONSTANT);
  EXPECT_GT(std::abs(this->windingNumber(mesh, 0.5, 0.3, 0.2) - 1), 0.03);
}

TEST_F(Clouds, AreasOfTheMeshNeedOne)
{
  probe->SetPointAreaMethod(vtkWindingNumberProbe::MESH);
  ErrorLog log(probe);
  this->windingNumber(sphereCloud(100, 1));
  EXPECT_NE(log.errors().find("need triangles"), std::string::npos) << log.errors();
}

TEST_F(Clouds, UnknownMethodsOfAreasAreRefused)
{
  for (const int method : {-1, 4})
  {
    probe->SetPointAreaMethod(method);
    ErrorLog log(probe);
    this->windingNumber(sphereCloud(100, 1));
    EXPECT_NE(log.errors().find("VORONOI (0)"), std::string::npos) << log.errors();
  }
}

TEST_F(Clouds, OptionsOfCloudsRebuildTheField)
{
  const auto cloud = sphereCloud(2000, 1);
  EXPECT_NEAR(this->windingNumber(cloud), 1, 0.01);
  const double mean = probe->GetMeanPointArea();
  EXPECT_NEAR(mean, 4 * 3.14159265358979 / 2000, 0.01 * mean);
  probe->SetPointAreaMethod(vtkWindingNumberProbe::CONSTANT);
  probe->SetPointArea(2 * mean);
  EXPECT_NEAR(this->windingNumber(cloud), 2, 0.02);
  EXPECT_NEAR(probe->GetMeanPointArea(), 2 * mean, 1e-12 * mean);
  probe->SetPointAreaMethod(vtkWindingNumberProbe::VORONOI);
  probe->SetNumberOfNeighbors(4);
  EXPECT_NEAR(this->windingNumber(cloud), 1, 0.1);
  EXPECT_NE(probe->GetMeanPointArea(), mean);
}

TEST_F(Clouds, ValuesBesideAPointStaySmallWhereItIsSpread)
{
  const auto cloud = sphereCloud(2000, 1);
  double p[3];
  cloud->GetPoint(777, p);
  const auto justInside = [&](double factor)
  {
    return this->windingNumber(cloud, factor * p[0], factor * p[1], factor * p[2]);
  };
  EXPECT_GT(justInside(0.999), 100);
  probe->SetRegularization(0.5);
  EXPECT_NEAR(justInside(0.999), 0.5, 0.05);
  EXPECT_NEAR(justInside(1), 0.5, 0.05);
  EXPECT_NEAR(justInside(0.9), 1, 0.01);
  EXPECT_NEAR(justInside(1.1), 0, 0.01);
  probe->SetRegularization(-1);
  ErrorLog log(probe);
  justInside(1);
  EXPECT_NE(log.errors().find("Regularization is -1"), std::string::npos) << log.errors();
}

} // namespace
