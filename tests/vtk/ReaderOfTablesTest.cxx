// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"
#include "vtk/FileReading.h"
#include "vtk/ReadMesh.h"

#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"
#include "vtkWindingNumberReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>

using namespace reading;

namespace
{

TEST(ReaderOfTables, PointsNormalsAndAreas)
{
  for (const std::string suffix : {".csv", ".tsv", ".TSV"})
  {
    std::string contents = "x,y,z,nx,ny,nz,area\n0.1,2,-3,0,2,0,0.25\n4,5,6,0,0,1,0.5";
    if (suffix != ".csv")
    {
      std::replace(contents.begin(), contents.end(), ',', '\t');
    }
    const auto cloud = read(contents, suffix);
    EXPECT_EQ(cloud->GetNumberOfPoints(), 2);
    EXPECT_EQ(cloud->GetNumberOfVerts(), 1) << "points are to be seen";
    EXPECT_EQ(cloud->GetPoints()->GetDataType(), VTK_DOUBLE);
    expectRow(cloud->GetPoints()->GetData(), 0, 0.1, 2, -3);
    expectRow(cloud->GetPointData()->GetNormals(), 0, 0, 2, 0);
    EXPECT_STREQ(cloud->GetPointData()->GetNormals()->GetName(), "Normals");
    EXPECT_EQ(cloud->GetPointData()->GetArray("Area")->GetTuple1(1), 0.5);
    EXPECT_EQ(cloud->GetPointData()->GetNumberOfArrays(), 2);
  }
}

TEST(ReaderOfTables, ColumnsBecomeArrays)
{
  const TextFile file(
    "name,x,y,z,nx,ny,nz,t\r\n\"a, b\",1,2,3,0,0,1,7\r\nc,4,5,6,0,0,1,8\r\n", ".csv");
  vtkNew<vtkWindingNumberReader> reader;
  const ErrorLog log(reader);
  reader->SetFileName(file.path());
  reader->Update();
  vtkPointData* const arrays = reader->GetOutput()->GetPointData();
  EXPECT_EQ(arrays->GetNumberOfArrays(), 3);
  auto* const names = vtkStringArray::SafeDownCast(arrays->GetAbstractArray("name"));
  ASSERT_NE(names, nullptr);
  EXPECT_EQ(names->GetValue(0), "a, b");
  EXPECT_EQ(arrays->GetArray("t")->GetTuple1(1), 8);
  EXPECT_EQ(reader->GetHeader(), "name,x,y,z,nx,ny,nz,t\r\n");
  ASSERT_EQ(reader->GetColumnNames()->GetNumberOfValues(), 8);
  EXPECT_EQ(reader->GetColumnNames()->GetValue(7), "t");

  reader->ReadNormalsAndAreasOff();
  reader->Update();
  EXPECT_EQ(arrays->GetNormals(), nullptr);
  EXPECT_EQ(arrays->GetArray("nz")->GetTuple1(0), 1);

  reader->ReadAllColumnsOff();
  reader->KeepRowsOn();
  reader->Update();
  EXPECT_EQ(arrays->GetNumberOfArrays(), 0);
  EXPECT_EQ(reader->GetRow(0), "\"a, b\",1,2,3,0,0,1,7");
  EXPECT_EQ(reader->GetRow(1), "c,4,5,6,0,0,1,8");
  EXPECT_EQ(reader->GetRow(2), "") << "there is no third point";
  EXPECT_EQ(log.errors(), "");
}

TEST(ReaderOfTables, NoColumnHidesAnother)
{
  const auto cloud = read(
    "t,x,y,z,area,Area,nx,ny,nz,Normals,t,,Column 12,RowPlace\n1,2,3,4,5,6,7,8,9,10,11,12,13,14\n",
    ".csv");
  vtkPointData* const arrays = cloud->GetPointData();
  const std::pair<const char*, double> expected[] = {{"Area", 5}, {"Area 6", 6}, {"Normals", 7},
    {"Normals 10", 10}, {"t", 1}, {"t 11", 11}, {"Column 12", 13}, {"Column 12 12", 12},
    {"RowPlace", 14}};
  EXPECT_EQ(arrays->GetNumberOfArrays(), 9);
  for (const auto& [name, value] : expected)
  {
    ASSERT_NE(arrays->GetArray(name), nullptr) << name;
    EXPECT_EQ(arrays->GetArray(name)->GetComponent(0, 0), value) << name;
  }
}

TEST(ReaderOfTables, WithoutRows)
{
  const TextFile file("x,y,z,t\n", ".csv");
  vtkNew<vtkWindingNumberReader> reader;
  reader->SetFileName(file.path());
  reader->KeepRowsOn();
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  vtkPointData* const arrays = reader->GetOutput()->GetPointData();
  ASSERT_NE(arrays->GetArray("t"), nullptr);
  EXPECT_EQ(arrays->GetArray("t")->GetNumberOfTuples(), 0);
  EXPECT_EQ(reader->GetRow(0), "");
}

TEST(ReaderOfTables, Refusals)
{
  expectRefusal("", "is empty", end, ".csv");
  expectRefusal("x y z\n1 2 3\n", "has no columns x, y and z", format, ".csv");
  expectRefusal("x y z\n1 2 3\n", "give it the suffix .xyz", format, ".tsv");
  expectRefusal("x,y,z\n1,2,3\n1,2\n", "line 3: has 2 fields", format, ".csv");
  expectRefusal("x,y,z\n1,2,three\n", "line 2: \"three\" in column z", format, ".csv");
  expectRefusal("x,y,z,nx,ny,nz\n1,2,3,4,5,-\n", "column nz is no number", format, ".csv");
  expectRefusal("x,y,z,t\n1,2,3,\"a\n", "line 2: a quotation mark", format, ".csv");
}

TEST(ReaderOfTables, ColumnsThatMakeNoSenseAreTheUsersError)
{
  const TextFile file("x,y,z\n1,2,3\n", ".csv");
  vtkNew<vtkWindingNumberReader> reader;
  const ErrorLog log(reader);
  reader->SetFileName(file.path());
  reader->SetColumns("nonsense");
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  reader->SetColumns("");
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
}

TEST(ReaderOfTables, SaysWhatSeparates)
{
  vtkNew<vtkWindingNumberReader> reader;
  const TextFile file("x;y;z\n1,5;2;3\n", ".csv");
  reader->SetFileName(file.path());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetPoint(0)[0], 1.5);
  EXPECT_EQ(reader->GetSeparator(), ';');
  EXPECT_TRUE(reader->GetHasDecimalCommas());
}

TEST(ReaderOfTables, NothingIsLeftOfTheFileBefore)
{
  vtkNew<vtkWindingNumberReader> reader;
  const ErrorLog log(reader);
  const TextFile file("x,y,z\n1,2,3\n", ".csv");
  reader->SetFileName(file.path());
  reader->KeepRowsOn();
  reader->Update();
  EXPECT_EQ(reader->GetRow(0), "1,2,3");
  EXPECT_EQ(reader->GetColumnNames()->GetNumberOfValues(), 3);
  reader->SetFileName("/nowhere.csv");
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::FileNotFoundError));
  EXPECT_NE(log.errors().find("/nowhere.csv: no such file"), std::string::npos);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(reader->GetColumnNames()->GetNumberOfValues(), 0);
  EXPECT_EQ(reader->GetRow(0), "");
  EXPECT_EQ(reader->GetHeader(), "");
  reader->SetFileName(nullptr);
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoFileNameError));
}

/// 17 digits bring every double back, on any number of threads.
TEST(ReaderOfTables, SharedCloudWithAllItsBits)
{
  const std::string path = std::string(WINDING_SHARED_DATA) + "/kitten_points_normals.ply";
  if (!std::filesystem::exists(path))
  {
    GTEST_SKIP() << path << " is not there";
  }
  const auto cloud = readMesh(path);
  vtkDataArray* const normals = cloud->GetPointData()->GetNormals();
  std::ostringstream text;
  text.precision(17);
  text << "x,y,z,nx,ny,nz\n";
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    const double* const point = cloud->GetPoint(i);
    text << point[0] / 3 << ',' << point[1] << ',' << point[2];
    const double* const normal = normals->GetTuple3(i);
    text << ',' << normal[0] << ',' << normal[1] << ',' << normal[2] << '\n';
  }
  for (const int threads : {1, 2, 0})
  {
    vtkSMPTools::Initialize(threads);
    const auto found = read(text.str(), ".csv");
    ASSERT_EQ(found->GetNumberOfPoints(), cloud->GetNumberOfPoints());
    for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
    {
      const double* const point = cloud->GetPoint(i);
      ASSERT_NO_FATAL_FAILURE(
        expectRow(found->GetPoints()->GetData(), i, point[0] / 3, point[1], point[2]));
      const double* const normal = normals->GetTuple3(i);
      expectRow(found->GetPointData()->GetNormals(), i, normal[0], normal[1], normal[2]);
    }
  }
}

TEST(ReaderOfTables, TakesChosenColumns)
{
  const TextFile table("id,E,N,H\n7,1,2,3\n", ".csv"), points("7 1 2 3\n", ".xyz");
  for (const auto& [file, columns] :
    {std::make_pair(&table, "x=E y=N z=H"), std::make_pair(&points, "x=2 y=3 z=4")})
  {
    vtkNew<vtkWindingNumberReader> reader;
    const ErrorLog log(reader);
    reader->SetFileName(file->path());
    reader->SetColumns(columns);
    reader->Update();
    EXPECT_EQ(log.errors(), "");
    expectRow(reader->GetOutput()->GetPoints()->GetData(), 0, 1, 2, 3);
    ASSERT_EQ(reader->GetOutput()->GetPointData()->GetNumberOfArrays(), 1);
    EXPECT_EQ(reader->GetOutput()->GetPointData()->GetArray(0)->GetTuple1(0), 7);
    reader->SetColumns("x=E,y");
    reader->Update();
    EXPECT_NE(log.errors(), "");
    EXPECT_NE(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
  }
}

} // namespace
