// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"
#include "vtk/HowTo.h"
#include "vtk/Spheres.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellTypeSource.h"
#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkGenericCell.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkStripper.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWindingNumberBoolean.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberSurface.h"
#include "vtkWindingNumberVoxels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{

using Position = std::array<double, 3>;

vtkSmartPointer<vtkPolyData> sphere(double x = 0, double radius = 1)
{
  const auto result = sphereOf(60, 40, radius, {x, 0, 0});
  result->GetPointData()->Initialize();
  return result;
}

Position pointOf(vtkDataSet* data, vtkIdType point)
{
  Position position;
  data->GetPoint(point, position.data());
  return position;
}

Position middleOf(vtkDataSet* data, vtkIdType cell)
{
  Position sum = {0, 0, 0};
  vtkNew<vtkIdList> corners;
  data->GetCellPoints(cell, corners);
  for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
  {
    const Position corner = pointOf(data, corners->GetId(i));
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      sum[axis] += corner[axis] / static_cast<double>(corners->GetNumberOfIds());
    }
  }
  return sum;
}

/// The colour of a place: a linear function of it, so that interpolation makes it again.
double colorOf(const Position& position, int component)
{
  return 128 + 60 * position[static_cast<std::size_t>(component)] + 20 * position[0];
}

/// Adds arrays of all kinds to the points and cells of a data set.
void addArrays(vtkDataSet* data)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("RGB");
  colors->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TCoords");
  coordinates->SetNumberOfComponents(2);
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  vtkNew<vtkIntArray> labels;
  labels->SetName("PointLabel");
  vtkNew<vtkStringArray> names;
  names->SetName("PointName");
  for (vtkIdType n = 0; n < data->GetNumberOfPoints(); ++n)
  {
    const Position at = pointOf(data, n);
    for (int component = 0; component < 3; ++component)
    {
      colors->InsertNextValue(static_cast<unsigned char>(std::lround(colorOf(at, component))));
    }
    coordinates->InsertNextTuple2(at[0], at[1]);
    height->InsertNextValue(at[2]);
    labels->InsertNextValue(at[2] > 0 ? 7 : 1000000007);
    names->InsertNextValue(at[2] > 0 ? "north" : "south");
  }
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName("Cell");
  vtkNew<vtkIntArray> regions;
  regions->SetName("GroupIds");
  for (vtkIdType n = 0; n < data->GetNumberOfCells(); ++n)
  {
    cells->InsertNextValue(n);
    regions->InsertNextValue(static_cast<int>(n % 5));
  }
  vtkNew<vtkStringArray> groups;
  groups->SetName("GroupNames");
  for (const char* name : {"a", "b", "c", "d", "e"})
  {
    groups->InsertNextValue(name);
  }
  data->GetPointData()->SetScalars(colors);
  data->GetPointData()->SetTCoords(coordinates);
  data->GetPointData()->AddArray(height);
  data->GetPointData()->AddArray(labels);
  data->GetPointData()->AddArray(names);
  data->GetCellData()->AddArray(cells);
  data->GetCellData()->AddArray(regions);
  data->GetFieldData()->AddArray(groups);
}

/// The distance of a position from a cell.
double distanceFrom(vtkDataSet* data, vtkIdType id, const Position& position)
{
  vtkNew<vtkGenericCell> cell;
  data->GetCell(id, cell);
  double closest[3], parameters[3], squared = 0;
  std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()));
  int part = 0;
  cell->EvaluatePosition(position.data(), closest, part, parameters, squared, weights.data());
  return std::sqrt(squared);
}

/// The most by which a result's nearest cell is farther than the nearest of all cells from `first`
/// on, at some of its faces.
double worstOf(vtkPolyData* result, vtkDataSet* source, vtkIdType first = 0)
{
  auto* const cells = vtkIdTypeArray::SafeDownCast(result->GetCellData()->GetArray("NearestCell"));
  double worst = 0;
  for (vtkIdType face = 0; face < result->GetNumberOfCells();
       face += 1 + result->GetNumberOfCells() / 15)
  {
    const Position at = middleOf(result, face);
    double nearest = std::numeric_limits<double>::infinity();
    for (vtkIdType cell = first; cell < source->GetNumberOfCells(); ++cell)
    {
      nearest = std::min(nearest, distanceFrom(source, cell, at));
    }
    worst = std::max(worst, distanceFrom(source, cells->GetValue(face), at) - nearest);
  }
  return worst;
}

class NearestAttributes : public testing::Test
{
protected:
  NearestAttributes()
  {
    filter->SetResolution(40);
    filter->TransferAttributesOn();
    filter->GenerateNearestCellsOn();
  }

  vtkPolyData* resultOf(vtkDataObject* source)
  {
    filter->SetInputDataObject(source);
    const ErrorLog log(filter);
    filter->Update();
    EXPECT_EQ(log.errors(), "");
    warnings = log.warnings();
    EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 0);
    return filter->GetOutput();
  }

  vtkNew<vtkWindingNumberSurface> filter;
  std::string warnings;
};

} // namespace

TEST_F(NearestAttributes, AreInterpolatedAtVerticesAndCopiedToFaces)
{
  const auto source = sphere();
  addArrays(source);
  for (const int features : {vtkWindingNumberSurface::SMOOTH, vtkWindingNumberSurface::SHARP})
  {
    filter->SetFeatures(features);
    vtkPolyData* const result = resultOf(source);
    vtkPointData* const points = result->GetPointData();
    ASSERT_TRUE(points->GetArray("RGB"));
    EXPECT_EQ(points->GetScalars(), points->GetArray("RGB"));
    EXPECT_EQ(points->GetTCoords(), points->GetArray("TCoords"));
    double ofHeight = 0, ofColor = 0;
    for (vtkIdType n = 0; n < result->GetNumberOfPoints(); ++n)
    {
      const Position at = pointOf(result, n);
      ofHeight = std::max(ofHeight, std::abs(points->GetArray("Height")->GetTuple1(n) - at[2]));
      for (int component = 0; component < 3; ++component)
      {
        ofColor = std::max(ofColor,
          std::abs(points->GetArray("RGB")->GetComponent(n, component) - colorOf(at, component)));
      }
      const double label = points->GetArray("PointLabel")->GetTuple1(n);
      ASSERT_TRUE(label == 7 || label == 1000000007) << "labels are not mixed";
      ASSERT_EQ(vtkStringArray::SafeDownCast(points->GetAbstractArray("PointName"))->GetValue(n),
        label == 7 ? "north" : "south");
    }
    // Vertices of smooth surfaces lie on the source. The corners of a cell see its flat faces.
    const bool isSmooth = features == vtkWindingNumberSurface::SMOOTH;
    EXPECT_LT(ofHeight, isSmooth ? 1e-7 : 0.005); // measured: 2.9e-8 and 0.0016
    EXPECT_LT(ofColor, 1.1); // measured: 0.90 and 0.97, for bytes are rounded twice
    vtkCellData* const cells = result->GetCellData();
    for (vtkIdType n = 0; n < result->GetNumberOfCells(); ++n)
    {
      ASSERT_EQ(
        cells->GetArray("Cell")->GetTuple1(n), cells->GetArray("NearestCell")->GetTuple1(n));
    }
    EXPECT_TRUE(cells->HasArray("GroupIds"));
    EXPECT_TRUE(result->GetFieldData()->HasArray("GroupNames"));
    EXPECT_FALSE(cells->HasArray("NearestBlock"));
    EXPECT_LT(worstOf(result, source), 1e-12); // measured: 0
  }
}

/// Bytes are colours where they have three or four components, and numbers of something else.
TEST_F(NearestAttributes, OfBytesAreInterpolatedWhereTheyAreColours)
{
  const auto source = sphere();
  for (int components = 1; components <= 5; ++components)
  {
    vtkNew<vtkUnsignedCharArray> bytes;
    bytes->SetName(("Bytes" + std::to_string(components)).c_str());
    bytes->SetNumberOfComponents(components);
    bytes->SetNumberOfTuples(source->GetNumberOfPoints());
    for (vtkIdType point = 0; point < source->GetNumberOfPoints(); ++point)
    {
      for (int component = 0; component < components; ++component)
      {
        bytes->SetComponent(point, component, point % 2 == 0 ? 0 : 200);
      }
    }
    source->GetPointData()->AddArray(bytes);
  }
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputData(source);
  surface->SetResolution(24);
  surface->TransferAttributesOn();
  surface->Update();
  for (int components = 1; components <= 5; ++components)
  {
    vtkDataArray* const found = surface->GetOutput()->GetPointData()->GetArray(
      ("Bytes" + std::to_string(components)).c_str());
    ASSERT_NE(found, nullptr);
    vtkIdType between = 0;
    for (vtkIdType point = 0; point < found->GetNumberOfTuples(); ++point)
    {
      const double value = found->GetComponent(point, components - 1);
      between += value > 0 && value < 200;
    }
    EXPECT_EQ(between > found->GetNumberOfTuples() / 2, components == 3 || components == 4);
    EXPECT_EQ(between == 0, components != 3 && components != 4);
  }
}

TEST_F(NearestAttributes, AreNotThereUnlessAskedFor)
{
  const auto source = sphere();
  addArrays(source);
  filter->TransferAttributesOff();
  EXPECT_FALSE(resultOf(source)->GetPointData()->HasArray("RGB"));
  EXPECT_TRUE(resultOf(source)->GetPointData()->HasArray("NearestCell"));
  filter->GenerateNearestCellsOff();
  EXPECT_FALSE(resultOf(source)->GetPointData()->HasArray("NearestCell"));
  EXPECT_FALSE(resultOf(source)->GetCellData()->HasArray("NearestCell"));
}

TEST_F(NearestAttributes, OfTheResultItselfStay)
{
  const auto source = sphere();
  addArrays(source);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(source->GetNumberOfPoints());
  normals->Fill(5);
  source->GetPointData()->AddArray(normals);
  filter->GenerateDistanceToInputOn();
  vtkPointData* const points = resultOf(source)->GetPointData();
  EXPECT_LT(points->GetArray("Normals")->GetRange()[1], 1.01);
  EXPECT_STREQ(points->GetScalars()->GetName(), "DistanceToInput");
  EXPECT_TRUE(points->HasArray("RGB"));
}

TEST_F(NearestAttributes, NumberCellsAsVtkDoesAmongPolygonsStripsAndPoints)
{
  // Points and lines come first, then polygons of 3 to 6 corners, then strips.
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkStripper> stripper;
  stripper->SetInputConnection(triangles->GetOutputPort());
  stripper->Update();
  vtkNew<vtkPolyData> source;
  source->SetPoints(vtkSmartPointer<vtkPoints>::New());
  source->GetPoints()->DeepCopy(stripper->GetOutput()->GetPoints());
  source->SetStrips(stripper->GetOutput()->GetStrips());
  source->SetPolys(stripper->GetOutput()->GetPolys());
  const vtkIdType first = source->GetNumberOfPoints();
  constexpr int corners = 6;
  vtkNew<vtkCellArray> polygons;
  for (int end = 0; end < 2; ++end)
  {
    vtkNew<vtkIdList> ids;
    for (int i = 0; i < corners; ++i)
    {
      const double angle = 2 * 3.14159265358979 / corners * (end == 0 ? -i : i);
      ids->InsertNextId(
        source->GetPoints()->InsertNextPoint(3 + std::cos(angle), std::sin(angle), end));
    }
    polygons->InsertNextCell(ids);
  }
  for (int i = 0; i < corners; ++i)
  {
    // The side of the prism between two corners, which the two ends have in opposite orders.
    const vtkIdType next = (i + 1) % corners;
    const vtkIdType low = first + (corners - i) % corners,
                    lowNext = first + (corners - next) % corners;
    polygons->InsertNextCell({low, lowNext, first + corners + next, first + corners + i});
  }
  source->SetPolys(polygons);
  vtkNew<vtkCellArray> vertices, lines;
  vertices->InsertNextCell({0});
  vertices->InsertNextCell({1});
  lines->InsertNextCell({0, 1, 2});
  source->SetVerts(vertices);
  source->SetLines(lines);
  addArrays(source);
  vtkPolyData* const result = resultOf(source);
  EXPECT_LT(worstOf(result, source, 3), 1e-12);
  const double* const range = result->GetCellData()->GetArray("NearestCell")->GetRange();
  EXPECT_GE(range[0], 3);
  EXPECT_EQ(range[1], static_cast<double>(source->GetNumberOfCells() - 1));
  for (vtkIdType n = 0; n < result->GetNumberOfCells(); ++n)
  {
    ASSERT_EQ(result->GetCellData()->GetArray("Cell")->GetTuple1(n),
      result->GetCellData()->GetArray("NearestCell")->GetTuple1(n));
  }
}

TEST_F(NearestAttributes, NumberCellsOfVolumeMeshesAndThoseBehindGhosts)
{
  vtkNew<vtkCellTypeSource> cells;
  cells->SetCellType(VTK_TETRA);
  cells->SetBlocksDimensions(3, 3, 3);
  cells->Update();
  vtkNew<vtkUnstructuredGrid> mesh;
  mesh->ShallowCopy(cells->GetOutput());
  addArrays(mesh);
  EXPECT_LT(worstOf(resultOf(mesh), mesh), 1e-12);
  vtkCellData* const data = filter->GetOutput()->GetCellData();
  for (vtkIdType n = 0; n < filter->GetOutput()->GetNumberOfCells(); ++n)
  {
    ASSERT_EQ(data->GetArray("Cell")->GetTuple1(n), data->GetArray("NearestCell")->GetTuple1(n));
  }
  EXPECT_EQ(data->GetNumberOfArrays(), 3) << "Cell, GroupIds and NearestCell";

  const auto source = sphere();
  addArrays(source);
  vtkUnsignedCharArray* const ghosts = source->AllocateCellGhostArray();
  for (vtkIdType n = 0; n < 100; ++n)
  {
    ghosts->SetValue(n, vtkDataSetAttributes::HIDDENCELL);
  }
  vtkPolyData* const result = resultOf(source);
  EXPECT_LT(worstOf(result, source, 100), 1e-12);
  EXPECT_GE(result->GetCellData()->GetArray("NearestCell")->GetRange()[0], 100);
  EXPECT_FALSE(result->GetCellData()->HasArray(vtkDataSetAttributes::GhostArrayName()));
}

TEST_F(NearestAttributes, OfBlocksAreTheOnesThatAllHave)
{
  const auto first = sphere(), second = sphere(3);
  addArrays(first);
  addArrays(second);
  second->GetPointData()->RemoveArray("Height");
  second->GetPointData()->GetAbstractArray("PointLabel")->SetName("Other");
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, first);
  blocks->SetBlock(2, second);
  vtkPolyData* const result = resultOf(blocks);
  EXPECT_TRUE(result->GetPointData()->HasArray("RGB"));
  EXPECT_FALSE(result->GetPointData()->HasArray("Height"));
  EXPECT_NE(warnings.find("Height, PointLabel, Other"), std::string::npos) << warnings;
  for (vtkIdType n = 0; n < result->GetNumberOfPoints(); ++n)
  {
    const int block = pointOf(result, n)[0] > 1.5 ? 3 : 1;
    ASSERT_EQ(result->GetPointData()->GetArray("NearestBlock")->GetTuple1(n), block);
  }
}

/// Colours of some blocks stay, and the others are white.
TEST_F(NearestAttributes, OfColorsAreTakenWhereOnlySomeBlocksHaveThem)
{
  for (const bool areOfCells : {false, true})
  {
    for (const unsigned colored : {0U, 1U})
    {
      const auto first = sphere(), second = sphere(3);
      vtkPolyData* const scan = colored == 0 ? first : second;
      vtkDataSetAttributes* const from =
        areOfCells ? static_cast<vtkDataSetAttributes*>(scan->GetCellData()) : scan->GetPointData();
      vtkNew<vtkUnsignedCharArray> red;
      red->SetName("RGBA");
      red->SetNumberOfComponents(4);
      for (vtkIdType n = 0; n < (areOfCells ? scan->GetNumberOfCells() : scan->GetNumberOfPoints());
           ++n)
      {
        red->InsertNextTuple4(200, 10, 20, 128);
      }
      from->SetScalars(red);
      vtkNew<vtkMultiBlockDataSet> blocks;
      blocks->SetBlock(0, first);
      blocks->SetBlock(1, second);
      vtkPolyData* const result = resultOf(blocks);
      EXPECT_NE(warnings.find("some inputs have no colors"), std::string::npos) << warnings;
      EXPECT_NE(warnings.find("RGBA is white there"), std::string::npos) << warnings;
      vtkDataSetAttributes* const to = areOfCells
                                         ? static_cast<vtkDataSetAttributes*>(result->GetCellData())
                                         : result->GetPointData();
      vtkDataArray* const found = to->GetScalars();
      ASSERT_TRUE(found);
      vtkDataArray* const block = to->GetArray("NearestBlock");
      for (vtkIdType n = 0; n < found->GetNumberOfTuples(); ++n)
      {
        const bool isRed = block->GetTuple1(n) == 1 + colored;
        ASSERT_EQ(found->GetComponent(n, 0), isRed ? 200 : 255);
        ASSERT_EQ(found->GetComponent(n, 3), isRed ? 128 : 255);
      }
    }
  }
}

TEST_F(NearestAttributes, OfColorsAreOpaqueWhereOnlyOthersHaveAnOpacity)
{
  for (const int first : {3, 4})
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    for (const int components : {first, 7 - first})
    {
      const auto part = sphere(components == first ? 0 : 3);
      vtkNew<vtkUnsignedCharArray> colors;
      colors->SetName(components == 3 ? "RGB" : "RGBA");
      colors->SetNumberOfComponents(components);
      colors->SetNumberOfTuples(part->GetNumberOfPoints());
      colors->Fill(10 * components);
      part->GetPointData()->SetScalars(colors);
      blocks->SetBlock(components == first ? 0 : 1, part);
    }
    vtkPointData* const points = resultOf(blocks)->GetPointData();
    EXPECT_EQ(warnings, "");
    EXPECT_FALSE(points->HasArray("RGB"));
    vtkDataArray* const found = points->GetScalars();
    ASSERT_TRUE(found);
    EXPECT_STREQ(found->GetName(), "RGBA");
    for (vtkIdType n = 0; n < found->GetNumberOfTuples(); ++n)
    {
      const bool isClear = (points->GetArray("NearestBlock")->GetTuple1(n) == 1) == (first == 4);
      ASSERT_EQ(found->GetComponent(n, 0), isClear ? 40 : 30);
      ASSERT_EQ(found->GetComponent(n, 3), isClear ? 40 : 255);
    }
  }
}

TEST_F(NearestAttributes, ThatAreNotThereAreSaidToBeNone)
{
  const auto bare = sphere();
  const std::string words = "the input has no arrays to be taken over";
  resultOf(bare);
  EXPECT_NE(warnings.find(words), std::string::npos) << warnings;
  vtkNew<vtkFloatArray> normals; // the result has its own
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(bare->GetNumberOfPoints());
  normals->Fill(1);
  bare->GetPointData()->SetNormals(normals);
  resultOf(bare);
  EXPECT_NE(warnings.find(words), std::string::npos) << warnings;
  filter->TransferAttributesOff();
  resultOf(bare);
  EXPECT_EQ(warnings.find(words), std::string::npos) << warnings;
  addArrays(bare);
  filter->TransferAttributesOn();
  resultOf(bare);
  EXPECT_EQ(warnings.find(words), std::string::npos) << warnings;
}

/// Numbers of regions stay the numbers of their names, which each block has in its own order.
TEST_F(NearestAttributes, OfBlocksUniteTheNamesOfRegions)
{
  const auto first = sphere(), second = sphere(3);
  addArrays(first);
  addArrays(second);
  auto* const names =
    vtkStringArray::SafeDownCast(second->GetFieldData()->GetAbstractArray("GroupNames"));
  const std::vector<std::string> ofSecond = {"c", "x", "a"}; // none for 3 and 4
  names->SetNumberOfValues(3);
  for (vtkIdType n = 0; n < 3; ++n)
  {
    names->SetValue(n, ofSecond[static_cast<std::size_t>(n)]);
  }
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, first);
  blocks->SetBlock(1, second);
  vtkPolyData* const result = resultOf(blocks);
  EXPECT_EQ(warnings, "");
  auto* const united =
    vtkStringArray::SafeDownCast(result->GetFieldData()->GetAbstractArray("GroupNames"));
  ASSERT_TRUE(united && united->GetNumberOfValues() == 6);
  EXPECT_EQ(united->GetValue(5), "x");
  vtkDataArray* const ids = result->GetCellData()->GetArray("GroupIds");
  ASSERT_TRUE(ids);
  std::array<int, 2> ofBlocks = {0, 0};
  for (vtkIdType face = 0; face < result->GetNumberOfCells(); ++face)
  {
    const auto cell =
      static_cast<std::size_t>(result->GetCellData()->GetArray("NearestCell")->GetTuple1(face));
    const bool isFirst = result->GetCellData()->GetArray("NearestBlock")->GetTuple1(face) == 1;
    ++ofBlocks[isFirst ? 0 : 1];
    const std::size_t number = cell % 5;
    const auto id = static_cast<vtkIdType>(ids->GetTuple1(face));
    if (!isFirst && number >= ofSecond.size())
    {
      ASSERT_EQ(id, -1) << "it has no name";
      continue;
    }
    ASSERT_EQ(united->GetValue(id), isFirst ? std::string(1, "abcde"[number]) : ofSecond[number]);
  }
  EXPECT_GT(ofBlocks[0], 1000);
  EXPECT_GT(ofBlocks[1], 1000);
}

TEST_F(NearestAttributes, WhoseNamesTheResultHasAreNamed)
{
  const auto source = sphere();
  addArrays(source);
  source->GetCellData()->GetAbstractArray("Cell")->SetName("NearestCell");
  resultOf(source);
  EXPECT_NE(warnings.find("the result has arrays of the same names"), std::string::npos);
  EXPECT_NE(warnings.find("; NearestCell is not taken over"), std::string::npos) << warnings;
  vtkNew<vtkWindingNumberBoolean> boolean;
  boolean->SetResolution(20);
  const auto other = sphere(0.8);
  addArrays(other);
  for (vtkPolyData* operand : {source.Get(), other.Get()})
  {
    operand->GetCellData()->GetAbstractArray("GroupIds")->SetName("Operand");
  }
  boolean->SetInputDataObject(0, source);
  boolean->SetInputDataObject(1, other);
  boolean->TransferAttributesOn();
  const ErrorLog log(boolean);
  boolean->Update();
  EXPECT_NE(log.warnings().find("NearestCell, Cell are not taken over, nor is Operand, which"),
    std::string::npos)
    << log.warnings();
}

TEST_F(NearestAttributes, OfCloudsAreThoseOfTheNearestPoint)
{
  const auto source = sphere();
  addArrays(source);
  filter->SourceAsPointsOn();
  vtkPolyData* const result = resultOf(source);
  vtkDataArray* const nearest = result->GetPointData()->GetArray("NearestCell");
  for (vtkIdType n = 0; n < result->GetNumberOfPoints(); n += 17)
  {
    const Position at = pointOf(result, n);
    const auto squared = [&](vtkIdType point)
    {
      const Position other = pointOf(source, point);
      return std::pow(at[0] - other[0], 2) + std::pow(at[1] - other[1], 2) +
             std::pow(at[2] - other[2], 2);
    };
    double least = std::numeric_limits<double>::infinity();
    for (vtkIdType point = 0; point < source->GetNumberOfPoints(); ++point)
    {
      least = std::min(least, squared(point));
    }
    const auto id = static_cast<vtkIdType>(nearest->GetTuple1(n));
    ASSERT_LE(squared(id), least * (1 + 1e-12));
    ASSERT_EQ(result->GetPointData()->GetArray("Height")->GetTuple1(n), pointOf(source, id)[2]);
  }
  EXPECT_FALSE(result->GetCellData()->HasArray("Cell"));
}

TEST_F(NearestAttributes, OfMirroredSourcesAreTheHalves)
{
  const auto source = sphere(1.5);
  addArrays(source);
  filter->SetMirror("x=0");
  vtkPolyData* const result = resultOf(source);
  for (vtkIdType n = 0; n < result->GetNumberOfPoints(); ++n)
  {
    const Position at = pointOf(result, n);
    ASSERT_NEAR(
      result->GetPointData()->GetArray("TCoords")->GetComponent(n, 0), std::abs(at[0]), 1e-5);
  }
}

TEST_F(NearestAttributes, HaveTheSameBitsForAnyNumberOfThreads)
{
  const auto source = sphere();
  addArrays(source);
  filter->SetNumberOfThreads(1);
  vtkNew<vtkPolyData> serial;
  serial->ShallowCopy(resultOf(source));
  filter->SetNumberOfThreads(4);
  vtkPolyData* const result = resultOf(source);
  for (const char* name : {"RGB", "TCoords", "Height", "PointLabel", "NearestCell"})
  {
    vtkDataArray* const a = serial->GetPointData()->GetArray(name);
    vtkDataArray* const b = result->GetPointData()->GetArray(name);
    ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues());
    for (vtkIdType n = 0; n < a->GetNumberOfTuples(); ++n)
    {
      for (int component = 0; component < a->GetNumberOfComponents(); ++component)
      {
        ASSERT_EQ(a->GetComponent(n, component), b->GetComponent(n, component)) << name;
      }
    }
  }
}

TEST(NearestAttributesOfBooleans, RefuseSurfacesAndCloudsByTheNameOfTheOption)
{
  const auto mesh = sphere();
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(sphere(0.8)->GetPoints());
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (vtkIdType n = 0; n < cloud->GetNumberOfPoints(); ++n)
  {
    const Position at = pointOf(cloud, n);
    normals->InsertNextTuple3(at[0] - 0.8, at[1], at[2]);
  }
  cloud->GetPointData()->SetNormals(normals);
  vtkNew<vtkWindingNumberBoolean> filter;
  filter->SetResolution(20);
  filter->SetInputDataObject(0, mesh);
  filter->SetInputDataObject(1, cloud);
  filter->GenerateNearestCellsOn();
  const ErrorLog log(filter);
  filter->Update();
  EXPECT_NE(
    log.errors().find("surfaces and clouds have no common nearest cells"), std::string::npos)
    << log.errors();
  EXPECT_NE(
    log.errors().find(howTo({winding::Parameter::generateNearestCells, 0})), std::string::npos)
    << log.errors();
}

TEST(NearestAttributesOfBooleans, SayWhichOperandAFaceLiesOn)
{
  const auto first = sphere(), second = sphere(0.8);
  addArrays(first);
  addArrays(second);
  vtkNew<vtkWindingNumberBoolean> filter;
  filter->SetResolution(40);
  filter->SetInputDataObject(0, first);
  filter->SetInputDataObject(1, second);
  filter->SetOperation(vtkWindingNumberBoolean::DIFFERENCE);
  filter->TransferAttributesOn();
  filter->GenerateNearestCellsOn();
  const ErrorLog log(filter);
  filter->Update();
  EXPECT_EQ(log.errors(), "");
  vtkCellData* const cells = filter->GetOutput()->GetCellData();
  vtkIdType others = 0;
  for (vtkIdType n = 0; n < filter->GetOutput()->GetNumberOfCells(); ++n)
  {
    const double block = cells->GetArray("NearestBlock")->GetTuple1(n);
    others += block != 1 + cells->GetArray("Operand")->GetTuple1(n);
    ASSERT_EQ(cells->GetArray("Cell")->GetTuple1(n), cells->GetArray("NearestCell")->GetTuple1(n));
    const Position at = middleOf(filter->GetOutput(), n);
    const auto id = static_cast<vtkIdType>(cells->GetArray("NearestCell")->GetTuple1(n));
    vtkPolyData* const operand = block == 1 ? first : second;
    ASSERT_LT(distanceFrom(operand, id, at), 0.06) << "more than a voxel";
  }
  // Faces along the seam have corners on both.
  EXPECT_LT(others, filter->GetOutput()->GetNumberOfCells() / 200); // measured: 20 of 12 212
  EXPECT_TRUE(filter->GetOutput()->GetPointData()->HasArray("RGB"));
}

namespace
{

/// Expects the nearest cell of each position to be no farther than any other, of some of them.
void expectNearest(vtkDataArray* cells, vtkDataSet* source, vtkIdType count,
  const std::function<Position(vtkIdType)>& positionOf)
{
  ASSERT_TRUE(cells);
  ASSERT_EQ(cells->GetNumberOfTuples(), count);
  for (vtkIdType n = 0; n < count; n += 1 + count / 12)
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (vtkIdType cell = 0; cell < source->GetNumberOfCells(); ++cell)
    {
      nearest = std::min(nearest, distanceFrom(source, cell, positionOf(n)));
    }
    const auto id = static_cast<vtkIdType>(cells->GetTuple1(n));
    EXPECT_LT(distanceFrom(source, id, positionOf(n)), nearest + 1e-12);
  }
}

} // namespace

TEST(NearestCellsOfFields, AreTheSameAsPointsCellsInPiecesAndOnTurnedImages)
{
  const auto source = sphere();
  vtkNew<vtkWindingNumberField> field;
  field->SetInputData(source);
  field->SetResolution(20);
  field->GenerateNearestCellsOn();
  const ErrorLog log(field);
  field->Update();
  EXPECT_EQ(log.errors(), "");
  vtkNew<vtkImageData> whole;
  whole->ShallowCopy(field->GetOutput());
  vtkDataArray* const cells = whole->GetPointData()->GetArray("NearestCell");
  expectNearest(
    cells, source, whole->GetNumberOfPoints(), [&](vtkIdType n) { return pointOf(whole, n); });
  EXPECT_STREQ(whole->GetPointData()->GetScalars()->GetName(), "WindingNumber");
  EXPECT_FALSE(whole->GetPointData()->HasArray("NearestBlock"));
  // A part has the ids of the whole.
  int extent[6] = {3, 12, 0, 19, 5, 9};
  field->UpdateExtent(extent);
  vtkImageData* const part = field->GetOutput();
  for (vtkIdType n = 0; n < part->GetNumberOfPoints(); ++n)
  {
    const vtkIdType same = whole->FindPoint(part->GetPoint(n));
    ASSERT_EQ(part->GetPointData()->GetArray("NearestCell")->GetTuple1(n), cells->GetTuple1(same));
  }
  field->SetOutputAssociationToCells();
  field->UpdateWholeExtent();
  vtkDataArray* const ofCells = field->GetOutput()->GetCellData()->GetArray("NearestCell");
  ASSERT_EQ(ofCells->GetNumberOfTuples(), cells->GetNumberOfTuples());
  for (vtkIdType n = 0; n < cells->GetNumberOfTuples(); ++n)
  {
    ASSERT_EQ(ofCells->GetTuple1(n), cells->GetTuple1(n));
  }
  vtkNew<vtkImageData> turned;
  turned->SetDimensions(6, 7, 8);
  turned->SetSpacing(0.3, 0.3, 0.3);
  turned->SetOrigin(-1, -0.5, -1);
  turned->SetDirectionMatrix(0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1);
  field->SetLikeData(turned);
  field->SetOutputAssociationToPoints();
  field->Update();
  EXPECT_EQ(log.errors(), "");
  expectNearest(field->GetOutput()->GetPointData()->GetArray("NearestCell"), source,
    turned->GetNumberOfPoints(), [&](vtkIdType n) { return pointOf(turned, n); });
  field->SetResultArrayName("NearestCell");
  field->Update();
  EXPECT_NE(log.errors().find("NearestCell"), std::string::npos) << log.errors();
}

/// More than a million samples are found a part at a time.
TEST(NearestCellsOfFields, OfManySamplesAreThoseOfTheirPieces)
{
  const auto source = sphere();
  vtkNew<vtkWindingNumberField> whole, piece;
  for (vtkWindingNumberField* field : {whole.Get(), piece.Get()})
  {
    field->SetInputData(source);
    field->SetSamplingDimensions(104, 103, 101);
    field->GenerateWindingNumberOff();
    field->GenerateInsideOn();
    field->GenerateNearestCellsOn();
  }
  whole->Update();
  const auto numbersOf = [](vtkWindingNumberField* field)
  {
    return vtkIdTypeArray::SafeDownCast(
      field->GetOutput()->GetPointData()->GetArray("NearestCell"));
  };
  vtkIdTypeArray* const all = numbersOf(whole);
  ASSERT_EQ(all->GetNumberOfValues(), 104 * 103 * 101);
  const int extent[] = {0, 103, 0, 102, 98, 100};
  piece->UpdateInformation();
  piece->UpdateExtent(extent);
  vtkIdTypeArray* const last = numbersOf(piece);
  ASSERT_EQ(last->GetNumberOfValues(), 104 * 103 * 3);
  const vtkIdType* const expected = all->GetPointer(all->GetNumberOfValues() - 104 * 103 * 3);
  EXPECT_TRUE(std::equal(expected, expected + 104 * 103 * 3, last->GetPointer(0)));
}

TEST(NearestCellsOfProbes, AreOfPointsCellsAndBlocks)
{
  const auto source = sphere(), queries = sphere(0.7);
  vtkNew<vtkWindingNumberProbe> probe;
  probe->SetInputData(queries);
  probe->SetSourceData(source);
  probe->GenerateNearestCellsOn();
  const ErrorLog log(probe);
  probe->Update();
  EXPECT_EQ(log.errors(), "");
  expectNearest(probe->GetOutput()->GetPointData()->GetArray("NearestCell"), source,
    queries->GetNumberOfPoints(), [&](vtkIdType n) { return pointOf(queries, n); });
  EXPECT_STREQ(probe->GetOutput()->GetPointData()->GetScalars()->GetName(), "WindingNumber");
  const auto between = sphere(2.5);
  probe->SetInputData(between);
  probe->SetProbeAssociationToCells();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(1, sphere(5));
  blocks->SetBlock(0, source);
  probe->SetSourceData(blocks);
  probe->Update();
  EXPECT_EQ(log.errors(), "");
  vtkCellData* const data = probe->GetOutput()->GetCellData();
  ASSERT_TRUE(data->HasArray("NearestCell"));
  for (vtkIdType n = 0; n < between->GetNumberOfCells(); ++n)
  {
    const Position at = middleOf(between, n);
    // Faces near the plane in the middle may be nearer to either sphere, whose faces are flat.
    if (std::abs(at[0] - 2.5) > 0.01)
    {
      ASSERT_EQ(data->GetArray("NearestBlock")->GetTuple1(n), at[0] < 2.5 ? 1 : 2) << at[0];
    }
  }
}

TEST(NearestCellsOfVoxels, ComeFromTheirSource)
{
  const auto source = sphere();
  addArrays(source);
  vtkNew<vtkWindingNumberField> field;
  field->SetInputData(source);
  field->SetResolution(20);
  field->GenerateInsideOn();
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputConnection(field->GetOutputPort());
  voxels->Update();
  EXPECT_FALSE(voxels->GetOutput()->GetPointData()->HasArray("RGB"));
  voxels->SetSourceData(source);
  voxels->TransferAttributesOn();
  voxels->GenerateNearestCellsOn();
  const ErrorLog log(voxels);
  voxels->Update();
  EXPECT_EQ(log.errors(), "");
  vtkPolyData* const surface = voxels->GetOutput();
  EXPECT_LT(worstOf(surface, source), 1e-12); // measured: 0
  ASSERT_TRUE(surface->GetPointData()->HasArray("RGB"));
  for (vtkIdType n = 0; n < surface->GetNumberOfCells(); ++n)
  {
    ASSERT_EQ(surface->GetCellData()->GetArray("Cell")->GetTuple1(n),
      surface->GetCellData()->GetArray("NearestCell")->GetTuple1(n));
  }
}

TEST(NearestCellsOfVoxels, ComeFromMirroredHalves)
{
  const auto source = sphere(1.5);
  addArrays(source);
  vtkNew<vtkWindingNumberField> field;
  field->SetInputData(source);
  field->SetMirror("x=0");
  field->SetResolution(30);
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputConnection(field->GetOutputPort());
  voxels->SetSourceData(source);
  voxels->SetMirror("x=0");
  voxels->TransferAttributesOn();
  voxels->Update();
  vtkPolyData* const surface = voxels->GetOutput();
  const double side = field->GetOutput()->GetSpacing()[0];
  int mirrored = 0;
  for (vtkIdType n = 0; n < surface->GetNumberOfPoints(); ++n)
  {
    const double x = pointOf(surface, n)[0];
    mirrored += x < 0;
    ASSERT_NEAR(
      surface->GetPointData()->GetArray("TCoords")->GetComponent(n, 0), std::abs(x), 2 * side);
  }
  EXPECT_GT(mirrored, 100);
}
