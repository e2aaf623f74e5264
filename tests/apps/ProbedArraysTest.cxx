// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// Data sets come through the program with all of their arrays: readers of VTK are in another
/// process, from which they have to come back to the bit.

#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include "vtkBitArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLUnstructuredGridReader.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

template <class Array>
vtkSmartPointer<Array> arrayOf(const char* name, vtkIdType tuples, int components)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < tuples * components; ++i)
  {
    array->SetVariantValue(i, (i * 7) % 2);
  }
  return array;
}

void addArrays(vtkPointSet* data)
{
  const vtkIdType points = data->GetNumberOfPoints(), cells = data->GetNumberOfCells();
  const auto normals = arrayOf<vtkFloatArray>("up", points, 3);
  normals->SetComponentName(2, "z, of course");
  data->GetPointData()->SetNormals(normals);
  const auto doubles = arrayOf<vtkDoubleArray>("doubles", points, 1);
  doubles->SetValue(0, 0.1);
  doubles->SetValue(1, std::numeric_limits<double>::quiet_NaN());
  doubles->SetValue(2, -0.0);
  doubles->SetValue(3, std::numeric_limits<double>::denorm_min());
  data->GetPointData()->AddArray(doubles);
  data->GetPointData()->AddArray(arrayOf<vtkBitArray>("bits", points, 1));
  const auto ids = arrayOf<vtkIdTypeArray>("ids", points, 1);
  ids->SetValue(0, std::numeric_limits<vtkIdType>::max());
  data->GetPointData()->SetGlobalIds(ids);
  data->GetCellData()->SetScalars(arrayOf<vtkUnsignedCharArray>("bytes", cells, 2));
  data->GetFieldData()->AddArray(arrayOf<vtkDoubleArray>("none", 0, 4));
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  for (const char* word : {"", "two words", "<&\">"})
  {
    words->InsertNextValue(word);
  }
  data->GetFieldData()->AddArray(words);
}

void expectEqual(vtkAbstractArray* before, vtkAbstractArray* after)
{
  ASSERT_NE(after, nullptr) << before->GetName();
  EXPECT_EQ(after->GetDataType(), before->GetDataType()) << before->GetName();
  ASSERT_EQ(after->GetNumberOfComponents(), before->GetNumberOfComponents()) << before->GetName();
  ASSERT_EQ(after->GetNumberOfTuples(), before->GetNumberOfTuples()) << before->GetName();
  for (int i = 0; before->HasAComponentName() && i < before->GetNumberOfComponents(); ++i)
  {
    const char *was = before->GetComponentName(i), *is = after->GetComponentName(i);
    EXPECT_STREQ(is ? is : "", was ? was : "") << before->GetName();
  }
  for (vtkIdType i = 0; i < before->GetNumberOfValues(); ++i)
  {
    EXPECT_EQ(after->GetVariantValue(i).ToString(), before->GetVariantValue(i).ToString())
      << before->GetName() << " " << i;
  }
}

void expectEqual(vtkFieldData* before, vtkFieldData* after)
{
  for (int i = 0; i < before->GetNumberOfArrays(); ++i)
  {
    expectEqual(
      before->GetAbstractArray(i), after->GetAbstractArray(before->GetAbstractArray(i)->GetName()));
  }
}

void expectEqual(vtkPointSet* before, vtkPointSet* after)
{
  expectEqual(before->GetPoints()->GetData(), after->GetPoints()->GetData());
  expectEqual(before->GetPointData(), after->GetPointData());
  expectEqual(before->GetCellData(), after->GetCellData());
  expectEqual(before->GetFieldData(), after->GetFieldData());
  EXPECT_STREQ(after->GetPointData()->GetNormals()->GetName(), "up");
  EXPECT_STREQ(after->GetPointData()->GetGlobalIds()->GetName(), "ids");
  EXPECT_STREQ(after->GetCellData()->GetScalars()->GetName(), "bytes");
  ASSERT_EQ(after->GetNumberOfCells(), before->GetNumberOfCells());
  vtkNew<vtkIdList> wanted, found;
  for (vtkIdType i = 0; i < before->GetNumberOfCells(); ++i)
  {
    EXPECT_EQ(after->GetCellType(i), before->GetCellType(i));
    before->GetCellPoints(i, wanted);
    after->GetCellPoints(i, found);
    EXPECT_EQ(std::vector<vtkIdType>(found->begin(), found->end()),
      std::vector<vtkIdType>(wanted->begin(), wanted->end()));
  }
}

/// Names of arrays may have anything in them. VTK's writers of XML do not escape them, so the input
/// is a legacy file.
TEST(ProbedArrays, OfAnyName)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.vtk",
    "# vtk DataFile Version 4.2\nt\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n0 0 0\n"
    "VERTICES 1 2\n1 0\nPOINT_DATA 1\nFIELD FieldData 3\n%22<&>' 1 1 int\n1\n"
    "h%c3%b6he 1 1 int\n2\nh%f6he%09 1 1 int\n3\n");
  for (const std::string suffix : {".vtp", ".vtu"})
  {
    const std::string out = folder.path("out" + suffix);
    const Outcome run =
      runProgram({"probe", folder.write("source.off", asOff(sphere(1))), in, "-o", out});
    ASSERT_EQ(run.status, 0) << run;
    const auto read = [&out](auto& reader)
    {
      reader->SetFileName(out.c_str());
      reader->Update();
      return vtkSmartPointer<vtkPointData>(reader->GetOutput()->GetPointData());
    };
    vtkNew<vtkXMLPolyDataReader> surfaces;
    vtkNew<vtkXMLUnstructuredGridReader> grids;
    const vtkSmartPointer<vtkPointData> data = suffix == ".vtp" ? read(surfaces) : read(grids);
    for (const auto& [name, value] :
      {std::pair("\"<&>'", 1), {"h\xc3\xb6he", 2}, {"h\xc3\xb6he?", 3}})
    {
      ASSERT_NE(data->GetArray(name), nullptr) << name << contentsOf(out);
      EXPECT_EQ(data->GetArray(name)->GetTuple1(0), value);
    }
  }
}

/// Data that was written, probed by the program, and read again.
template <class Writer, class Reader, class Data>
vtkSmartPointer<Data> probed(Data* data, const std::string& suffix)
{
  const TemporaryFolder folder;
  const std::string in = folder.path("in" + suffix), out = folder.path("out" + suffix);
  vtkNew<Writer> writer;
  writer->SetInputData(data);
  writer->SetFileName(in.c_str());
  writer->Write();
  const Outcome run =
    runProgram({"probe", folder.write("source.off", asOff(sphere(1))), in, "-o", out, "--quiet"});
  EXPECT_EQ(run.status, 0) << run;
  EXPECT_EQ(run.err, "");
  vtkNew<Reader> reader;
  reader->SetFileName(out.c_str());
  reader->Update();
  return reader->GetOutput();
}

vtkNew<vtkPoints> fivePoints(int type)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  points->InsertNextPoint(0.1, 0.2, 0.3);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0, 1, 0);
  points->InsertNextPoint(0, 0, 1);
  points->InsertNextPoint(1e-30, -1e30, 0);
  return points;
}

TEST(ProbedArrays, OfPolyData)
{
  for (const int type : {VTK_FLOAT, VTK_DOUBLE})
  {
    vtkNew<vtkPolyData> data;
    data->SetPoints(fivePoints(type));
    vtkNew<vtkCellArray> verts, lines, polys, strips;
    verts->InsertNextCell({4});
    lines->InsertNextCell({0, 1, 2});
    polys->InsertNextCell({0, 1, 2});
    polys->InsertNextCell({0, 3, 2, 1});
    strips->InsertNextCell({0, 1, 2, 3, 4});
    data->SetVerts(verts);
    data->SetLines(lines);
    data->SetPolys(polys);
    data->SetStrips(strips);
    addArrays(data);
    expectEqual(data, probed<vtkXMLPolyDataWriter, vtkXMLPolyDataReader>(data.Get(), ".vtp"));
  }
}

TEST(ProbedArrays, OfGridsWithPolyhedra)
{
  vtkNew<vtkUnstructuredGrid> data;
  data->SetPoints(fivePoints(VTK_DOUBLE));
  const vtkIdType tetra[] = {0, 1, 2, 3};
  vtkIdType faces[] = {3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3};
  data->InsertNextCell(VTK_TETRA, 4, tetra);
  data->InsertNextCell(VTK_POLYHEDRON, 4, tetra, 4, faces);
  addArrays(data);
  const auto after =
    probed<vtkXMLUnstructuredGridWriter, vtkXMLUnstructuredGridReader>(data.Get(), ".vtu");
  expectEqual(data, after);
  vtkNew<vtkIdList> wanted, found;
  data->GetFaceStream(1, wanted);
  after->GetFaceStream(1, found);
  EXPECT_EQ(std::vector<vtkIdType>(found->begin(), found->end()),
    std::vector<vtkIdType>(wanted->begin(), wanted->end()));
}

TEST(ProbedArrays, OfNothing)
{
  vtkNew<vtkPolyData> data;
  data->SetPoints(vtkNew<vtkPoints>());
  const auto after = probed<vtkXMLPolyDataWriter, vtkXMLPolyDataReader>(data.Get(), ".vtp");
  EXPECT_EQ(after->GetNumberOfPoints(), 0);
}

} // namespace
