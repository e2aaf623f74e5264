// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "c/Calls.h"
#include "support/RealMeshes.h"
#include "vtk/ReadMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberLabels.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberSurface.h"
#include "vtkWindingNumberVoxels.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

/**
 * @file
 * The library of the interface in C gives the bits that the filters give.
 */
namespace
{

using calls::with;

constexpr int resolution = 40;

/// A source that both are given, and a grid around it.
class Library : public testing::TestWithParam<const char*>
{
protected:
  void SetUp() override
  {
    data = readMesh(shapes::realMesh(GetParam()));
    const bool isSurface = data->GetNumberOfPolys() > 0;
    vtkDataArray* const coordinates = data->GetPoints()->GetData();
    const winding_array points = arrayOf(coordinates, coordinates->GetNumberOfTuples());
    if (isSurface)
    {
      corners.resize(static_cast<std::size_t>(data->GetPolys()->GetNumberOfConnectivityIds()));
      offsets = {0};
      vtkIdType size;
      const vtkIdType* ids;
      auto corner = corners.begin();
      for (vtkIdType i = 0; i < data->GetNumberOfPolys(); ++i)
      {
        data->GetPolys()->GetCellAtId(i, size, ids);
        corner = std::copy(ids, ids + size, corner);
        offsets.push_back(corner - corners.begin());
      }
      const winding_polygons polygons = {
        {corners.data(), static_cast<int64_t>(corners.size()), 0, WINDING_INT64},
        {offsets.data(), static_cast<int64_t>(offsets.size()), 0, WINDING_INT64}};
      ASSERT_EQ(winding_faces(points, &polygons, nullptr, nullptr, &field, &refusal), WINDING_OK)
        << refusal.text;
    }
    else
    {
      vtkDataArray* const normals = data->GetPointData()->GetNormals();
      auto options = with(winding_options_init);
      options.estimate_normals = normals == nullptr;
      estimates = normals == nullptr;
      const winding_array none = {nullptr, 0, 0, 0};
      ASSERT_EQ(
        winding_points(points, normals ? arrayOf(normals, normals->GetNumberOfTuples()) : none,
          none, &options, nullptr, &field, &refusal),
        WINDING_OK)
        << refusal.text;
    }
  }

  void TearDown() override { winding_field_free(field); }

  static winding_array arrayOf(vtkDataArray* array, vtkIdType rows)
  {
    return {array->GetVoidPointer(0), rows, 0,
      array->GetDataType() == VTK_FLOAT ? WINDING_FLOAT32 : WINDING_FLOAT64};
  }

  template <class Filter> vtkSmartPointer<Filter> filterOf() const
  {
    auto filter = vtkSmartPointer<Filter>::New();
    filter->SetInputData(data);
    filter->SetResolution(resolution);
    filter->SetEstimateNormals(estimates);
    return filter;
  }

  /// The grid that the filters lay around the source.
  winding_grid grid() const
  {
    auto info = with(winding_field_info_init);
    EXPECT_EQ(winding_describe(field, &info, nullptr), WINDING_OK);
    auto request = with(winding_grid_request_init);
    request.resolution = resolution;
    std::copy_n(info.bounds, 6, request.sampling_bounds);
    winding_grid result;
    EXPECT_EQ(winding_lay_out_grid(&request, nullptr, &result, nullptr), WINDING_OK);
    return result;
  }

  static void expectSame(vtkDataArray* found, const void* expected, const char* name)
  {
    const auto bytes = static_cast<std::size_t>(found->GetNumberOfValues()) *
                       static_cast<std::size_t>(found->GetDataTypeSize());
    EXPECT_EQ(std::memcmp(found->GetVoidPointer(0), expected, bytes), 0) << name;
  }

  void expectSameSurface(int features) const
  {
    const auto filter = filterOf<vtkWindingNumberSurface>();
    filter->SetFeatures(features);
    filter->Update();
    vtkPolyData* const surface = filter->GetOutput();
    auto options = with(winding_surface_options_init);
    options.features = features;
    winding_mesh* mesh = nullptr;
    const winding_grid samples = grid();
    ASSERT_EQ(winding_level_surface(field, &samples, nullptr, &options, nullptr, &mesh, nullptr),
      WINDING_OK);
    auto arrays = with(winding_mesh_arrays_init);
    winding_mesh_show(mesh, &arrays, nullptr);
    ASSERT_EQ(arrays.point_count, surface->GetNumberOfPoints());
    ASSERT_EQ(arrays.polygon_count, surface->GetNumberOfPolys());
    if (arrays.point_count > 0)
    {
      expectSame(surface->GetPoints()->GetData(), arrays.points, "points");
      expectSame(surface->GetPolys()->GetConnectivityArray(), arrays.corners, "corners");
      const bool isSharp = features == vtkWindingNumberSurface::SHARP;
      expectSame(
        isSharp ? surface->GetCellData()->GetNormals() : surface->GetPointData()->GetNormals(),
        isSharp ? arrays.polygon_normals : arrays.point_normals, "normals");
    }
    winding_mesh_free(mesh);
  }

  vtkSmartPointer<vtkPolyData> data;
  bool estimates = false;
  std::vector<std::int64_t> corners, offsets;
  winding_field* field = nullptr;
  winding_refusal refusal = {};
};

TEST_P(Library, HasTheBitsOfFields)
{
  const auto filter = filterOf<vtkWindingNumberField>();
  filter->GenerateInsideOn();
  filter->GenerateSignedDistanceOn();
  filter->Update();
  vtkPointData* const expected = filter->GetOutput()->GetPointData();
  const auto count = static_cast<std::size_t>(filter->GetOutput()->GetNumberOfPoints());
  std::vector<float> w(count), distances(count);
  std::vector<std::uint8_t> inside(count);
  auto values = with(winding_values_init);
  values.winding = w.data();
  values.inside = inside.data();
  values.distance = distances.data();
  const winding_grid samples = grid();
  ASSERT_EQ(winding_evaluate_grid(field, &samples, nullptr, nullptr, &values, nullptr, &refusal),
    WINDING_OK)
    << refusal.text;
  expectSame(expected->GetArray("WindingNumber"), w.data(), "w");
  expectSame(expected->GetArray("Inside"), inside.data(), "inside");
  expectSame(expected->GetArray("SignedDistance"), distances.data(), "distance");
  EXPECT_EQ(values.inside_count, filter->GetNumberOfInsideSamples());
}

TEST_P(Library, HasTheBitsOfSurfaces)
{
  expectSameSurface(vtkWindingNumberSurface::SMOOTH);
  expectSameSurface(vtkWindingNumberSurface::SHARP);
}

TEST_P(Library, HasTheBitsOfVoxelsAndLabels)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, data);
  const auto labels = filterOf<vtkWindingNumberLabels>();
  labels->SetInputData(blocks);
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputConnection(labels->GetOutputPort());
  voxels->Update();
  vtkImageData* const image = labels->GetOutput();
  std::vector<std::uint16_t> found(static_cast<std::size_t>(image->GetNumberOfPoints()));
  const winding_field* const fields[] = {field};
  const winding_grid samples = grid();
  winding_labels labelling = {};
  winding_labels_init(&labelling, sizeof labelling);
  labelling.labels = found.data();
  ASSERT_EQ(winding_label(fields, nullptr, 1, &samples, nullptr, nullptr, nullptr, &labelling,
              nullptr, &refusal),
    WINDING_OK)
    << refusal.text;
  expectSame(image->GetPointData()->GetArray("Label"), found.data(), "labels");
  winding_mesh* mesh = nullptr;
  ASSERT_EQ(
    winding_voxel_surface({found.data(), static_cast<int64_t>(found.size()), 0, WINDING_UINT16},
      &samples, nullptr, &mesh, nullptr),
    WINDING_OK);
  auto arrays = with(winding_mesh_arrays_init);
  winding_mesh_show(mesh, &arrays, nullptr);
  vtkPolyData* const quads = voxels->GetOutput();
  ASSERT_EQ(arrays.polygon_count, quads->GetNumberOfPolys());
  if (arrays.polygon_count > 0)
  {
    expectSame(quads->GetPoints()->GetData(), arrays.points, "points");
    expectSame(quads->GetPolys()->GetConnectivityArray(), arrays.corners, "corners");
    expectSame(quads->GetCellData()->GetArray("BoundaryLabels"), arrays.labels, "labels");
  }
  winding_mesh_free(mesh);
}

TEST_P(Library, HasTheBitsOfPoints)
{
  vtkNew<vtkPolyData> queries;
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  double bounds[6];
  data->GetBounds(bounds);
  for (int i = 0; i < 1000; ++i)
  {
    const auto between = [&](int axis, int prime)
    {
      return bounds[2 * axis] +
             (bounds[2 * axis + 1] - bounds[2 * axis]) * (i * prime % 1009) / 1009.0;
    };
    places->InsertNextPoint(between(0, 1), between(1, 37), between(2, 211));
  }
  queries->SetPoints(places);
  vtkNew<vtkWindingNumberProbe> probe;
  probe->SetInputData(queries);
  probe->SetSourceData(data);
  probe->SetEstimateNormals(estimates);
  probe->SetOutputScalarType(VTK_DOUBLE);
  probe->Update();
  std::vector<double> w(1000);
  auto values = with(winding_values_init);
  values.type = WINDING_FLOAT64;
  values.winding = w.data();
  winding_field* scattered = nullptr;
  auto options = with(winding_options_init);
  options.scattered = 1;
  options.estimate_normals = estimates;
  const winding_array points = arrayOf(data->GetPoints()->GetData(), data->GetNumberOfPoints());
  const winding_polygons polygons = {
    {corners.data(), static_cast<int64_t>(corners.size()), 0, WINDING_INT64},
    {offsets.data(), static_cast<int64_t>(offsets.size()), 0, WINDING_INT64}};
  vtkDataArray* const normals = data->GetPointData()->GetNormals();
  const winding_array none = {nullptr, 0, 0, 0};
  const winding_status status =
    data->GetNumberOfPolys() > 0
      ? winding_faces(points, &polygons, &options, nullptr, &scattered, nullptr)
      : winding_points(points, normals ? arrayOf(normals, normals->GetNumberOfTuples()) : none,
          none, &options, nullptr, &scattered, nullptr);
  ASSERT_EQ(status, WINDING_OK);
  ASSERT_EQ(
    winding_evaluate_points(scattered, {places->GetVoidPointer(0), 1000, 0, WINDING_FLOAT64},
      nullptr, &values, nullptr, nullptr),
    WINDING_OK);
  expectSame(
    vtkPolyData::SafeDownCast(probe->GetOutput())->GetPointData()->GetArray("WindingNumber"),
    w.data(), "w");
  winding_field_free(scattered);
}

INSTANTIATE_TEST_SUITE_P(OfSharedData, Library,
  testing::ValuesIn(shapes::present(
    {"aneurysm_open.stl", "armadillo_86k.obj", "bunny_10k.obj", "bunny_noised_points.ply",
      "bunny_res2_nonmanifold.ply", "conrod_flipped.stl", "fractures_dfn2.vtp", "icosahedron.stl",
      "kitten_points_normals.ply", "maxplanck_open_90k.obj", "self_intersectA.obj",
      "sphere_quads.obj", "teapot.obj", "tray_thin_cad.stl", "truck_soup.obj"})),
  [](const auto& mesh) { return shapes::testNameOf(mesh.param); });

} // namespace
