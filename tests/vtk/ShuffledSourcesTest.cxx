// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/RealMeshes.h"
#include "vtk/ReadMesh.h"

#include "support/ShuffledNumbers.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberNormals.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberSurface.h"
#include "vtkWindingNumberVoxels.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

namespace
{

/// A data set whose points and cells were written in another order, and where each point went.
struct Shuffled
{
  vtkSmartPointer<vtkPolyData> mesh;
  std::vector<std::size_t> from; ///< by point of the mesh: its number in the original
};

/// Shuffles points with their arrays and, if there are any, polygons. Triangles begin with any of
/// their corners; other polygons keep their first, from which they are cut.
Shuffled shuffledCopyOf(vtkPolyData* original, unsigned seed)
{
  std::mt19937_64 random(seed);
  const auto below = [&random](std::size_t count)
  {
    return static_cast<std::size_t>(random() % count);
  };
  const vtkIdType count = original->GetNumberOfPoints();
  Shuffled result = {vtkSmartPointer<vtkPolyData>::New(),
    shapes::shuffledNumbers(static_cast<std::size_t>(count), below)};
  std::vector<vtkIdType> numbers(result.from.size());
  vtkNew<vtkPoints> points;
  points->SetDataType(original->GetPoints()->GetDataType());
  points->SetNumberOfPoints(count);
  vtkPointData* const data = result.mesh->GetPointData();
  data->CopyAllocate(original->GetPointData(), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto from = static_cast<vtkIdType>(result.from[static_cast<std::size_t>(i)]);
    numbers[static_cast<std::size_t>(from)] = i;
    points->SetPoint(i, original->GetPoint(from));
    data->CopyData(original->GetPointData(), from, i);
  }
  result.mesh->SetPoints(points);
  vtkCellArray* const cells = original->GetPolys();
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkIdList> ids;
  for (const std::size_t cell :
    shapes::shuffledNumbers(static_cast<std::size_t>(cells->GetNumberOfCells()), below))
  {
    cells->GetCellAtId(static_cast<vtkIdType>(cell), ids);
    const vtkIdType corners = ids->GetNumberOfIds();
    const auto first = corners == 3 ? static_cast<vtkIdType>(below(3)) : 0;
    polygons->InsertNextCell(static_cast<int>(corners));
    for (vtkIdType i = 0; i < corners; ++i)
    {
      polygons->InsertCellPoint(
        numbers[static_cast<std::size_t>(ids->GetId((first + i) % corners))]);
    }
  }
  result.mesh->SetPolys(polygons);
  return result;
}

/// The cells of a mesh as two blocks, each with points of its own.
vtkSmartPointer<vtkMultiBlockDataSet> inTwoBlocks(vtkPolyData* mesh)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  vtkNew<vtkIdList> ids;
  for (unsigned number = 0; number < 2; ++number)
  {
    vtkNew<vtkPolyData> block;
    vtkNew<vtkPoints> points;
    points->SetDataType(mesh->GetPoints()->GetDataType());
    vtkNew<vtkCellArray> polygons;
    for (vtkIdType cell = number; cell < mesh->GetPolys()->GetNumberOfCells(); cell += 2)
    {
      mesh->GetPolys()->GetCellAtId(cell, ids);
      polygons->InsertNextCell(static_cast<int>(ids->GetNumberOfIds()));
      for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      {
        polygons->InsertCellPoint(points->InsertNextPoint(mesh->GetPoint(ids->GetId(i))));
      }
    }
    block->SetPoints(points);
    block->SetPolys(polygons);
    blocks->SetBlock(number, block);
  }
  return blocks;
}

void expectSameBits(vtkDataArray* found, vtkDataArray* expected)
{
  ASSERT_TRUE(found && expected);
  ASSERT_EQ(found->GetDataType(), expected->GetDataType());
  ASSERT_EQ(found->GetNumberOfValues(), expected->GetNumberOfValues());
  const auto bytes = static_cast<std::size_t>(found->GetNumberOfValues()) *
                     static_cast<std::size_t>(found->GetDataTypeSize());
  EXPECT_EQ(std::memcmp(found->GetVoidPointer(0), expected->GetVoidPointer(0), bytes), 0)
    << (expected->GetName() ? expected->GetName() : "without a name");
}

void expectSameArrays(vtkPointData* found, vtkPointData* expected)
{
  ASSERT_EQ(found->GetNumberOfArrays(), expected->GetNumberOfArrays());
  for (int i = 0; i < expected->GetNumberOfArrays(); ++i)
  {
    expectSameBits(found->GetArray(i), expected->GetArray(i));
  }
}

void expectSameMesh(vtkPolyData* found, vtkPolyData* expected)
{
  ASSERT_GT(expected->GetNumberOfPoints(), 100);
  ASSERT_EQ(found->GetNumberOfPoints(), expected->GetNumberOfPoints());
  expectSameBits(found->GetPoints()->GetData(), expected->GetPoints()->GetData());
  expectSameBits(
    found->GetPolys()->GetConnectivityArray(), expected->GetPolys()->GetConnectivityArray());
  expectSameArrays(found->GetPointData(), expected->GetPointData());
}

/// Meshes and clouds that were made elsewhere, and the same ones with their points and triangles in
/// other orders.
class ShuffledSharedData : public testing::TestWithParam<const char*>
{
protected:
  void SetUp() override
  {
    original_ = readMesh(shapes::realMesh(GetParam()));
    isCloud_ = original_->GetPolys()->GetNumberOfCells() == 0;
    others_.push_back(shuffledCopyOf(original_, 2300));
    others_.push_back(shuffledCopyOf(original_, 2301));
  }

  /// The outputs of a filter for the original, and for one of the others after the other.
  template <class Filter, class Compare> void compare(Filter* filter, const Compare& compareOutputs)
  {
    using Output = std::remove_pointer_t<decltype(filter->GetOutput())>;
    const auto outputOf = [filter](vtkDataObject* data)
    {
      filter->SetInputDataObject(data);
      filter->Update();
      auto output = vtkSmartPointer<Output>::New();
      output->DeepCopy(filter->GetOutput());
      return output;
    };
    const auto expected = outputOf(original_);
    compareOutputs(outputOf(others_[0].mesh), expected);
    if (isCloud_)
    {
      compareOutputs(outputOf(others_[1].mesh), expected);
    }
    else
    {
      compareOutputs(outputOf(inTwoBlocks(others_[1].mesh)), expected);
    }
  }

  vtkSmartPointer<vtkPolyData> original_;
  std::vector<Shuffled> others_;
  bool isCloud_ = false;
};

/// Samples for each method so that it takes a second or two.
int resolutionFor(int method, vtkIdType primitives)
{
  const bool isSlow =
    method == vtkWindingNumberField::DIRECT || method == vtkWindingNumberField::PARITY;
  return !isSlow ? 48 : primitives > 20'000 ? 8 : 16;
}

} // namespace

TEST_P(ShuffledSharedData, GivesFieldsOfTheSameBits)
{
  for (const int method : {vtkWindingNumberField::AUTOMATIC, vtkWindingNumberField::ROWS,
         vtkWindingNumberField::HIERARCHICAL, vtkWindingNumberField::DIRECT,
         vtkWindingNumberField::PARITY})
  {
    if (isCloud_ &&
        (method == vtkWindingNumberField::ROWS || method == vtkWindingNumberField::PARITY))
    {
      continue;
    }
    SCOPED_TRACE("method " + std::to_string(method));
    vtkNew<vtkWindingNumberField> field;
    field->SetMethod(method);
    field->SetResolution(resolutionFor(
      method, isCloud_ ? original_->GetNumberOfPoints() : original_->GetNumberOfPolys()));
    field->SetOutputScalarTypeToDouble();
    field->GenerateInsideOn();
    field->GenerateSignedDistanceOn();
    field->SetEstimateNormals(isCloud_);
    this->compare(field.GetPointer(), [](vtkImageData* found, vtkImageData* expected)
      { expectSameArrays(found->GetPointData(), expected->GetPointData()); });
  }
}

TEST_P(ShuffledSharedData, GivesSmoothSurfacesOfTheSameBits)
{
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetResolution(std::string(GetParam()) == "tray_thin_cad.stl" ? 160 : 40); // it is thin
  surface->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  surface->SetEstimateNormals(isCloud_);
  this->compare(surface.GetPointer(), expectSameMesh);
}

TEST_P(ShuffledSharedData, GivesSharpSurfacesOfTheSameBits)
{
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetFeatures(vtkWindingNumberSurface::SHARP);
  surface->SetResolution(std::string(GetParam()) == "tray_thin_cad.stl" ? 160 : 40); // it is thin
  surface->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  surface->SetEstimateNormals(isCloud_);
  this->compare(surface.GetPointer(), expectSameMesh);
}

TEST_P(ShuffledSharedData, GivesPointsTheSameAreas)
{
  for (const int method : {vtkWindingNumberNormals::VORONOI, vtkWindingNumberNormals::MESH})
  {
    if (isCloud_ && method == vtkWindingNumberNormals::MESH)
    {
      continue;
    }
    SCOPED_TRACE("method " + std::to_string(method));
    vtkNew<vtkWindingNumberNormals> areas;
    areas->SetPointAreaMethod(method);
    areas->SetEstimateNormals(isCloud_);
    areas->SetInputData(original_);
    areas->Update();
    vtkNew<vtkPolyData> expected;
    expected->DeepCopy(areas->GetOutput());
    areas->SetInputData(others_[0].mesh);
    areas->Update();
    vtkDataArray* const found =
      vtkPolyData::SafeDownCast(areas->GetOutput())->GetPointData()->GetArray("Area");
    vtkDataArray* const original = expected->GetPointData()->GetArray("Area");
    ASSERT_TRUE(found && original);
    vtkIdType different = 0;
    for (vtkIdType i = 0; i < found->GetNumberOfTuples(); ++i)
    {
      const auto from = static_cast<vtkIdType>(others_[0].from[static_cast<std::size_t>(i)]);
      different += found->GetTuple1(i) != original->GetTuple1(from);
    }
    EXPECT_EQ(different, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(OfSharedData, ShuffledSharedData,
  testing::ValuesIn(shapes::present({"bunny_10k.obj", "maxplanck_open_90k.obj", "truck_soup.obj",
    "conrod_flipped.stl", "aneurysm_open.stl", "bunny_res2_nonmanifold.ply", "self_intersectA.obj",
    "tray_thin_cad.stl", "teapot.obj", "kitten_points_normals.ply", "bunny_noised_points.ply"})),
  [](const auto& mesh) { return shapes::testNameOf(mesh.param); });
