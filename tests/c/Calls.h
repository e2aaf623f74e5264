// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/Shapes.h"
#include "winding.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/// Helpers by which tests call the library.
namespace calls
{

using Field = std::unique_ptr<winding_field, void (*)(winding_field*)>;
using OwnedMesh = std::unique_ptr<winding_mesh, void (*)(winding_mesh*)>;

/// Makes a struct with its defaults.
template <class Struct> Struct with(void (*init)(Struct*, size_t))
{
  Struct result;
  init(&result, sizeof result);
  return result;
}

inline winding_array arrayOf(const std::vector<shapes::Point>& points)
{
  return {points.data(), static_cast<int64_t>(points.size()), 0, WINDING_FLOAT64};
}

inline winding_array arrayOf(const std::vector<double>& numbers)
{
  return {numbers.data(), static_cast<int64_t>(numbers.size()), 0, WINDING_FLOAT64};
}

/// The triangles of a mesh.
inline winding_polygons polygonsOf(const shapes::Mesh& mesh)
{
  return {{mesh.triangles.data(), static_cast<int64_t>(mesh.triangles.size()), 0, WINDING_INT32},
    {nullptr, 0, 0, 0}};
}

/// The field of a mesh, which must not be refused.
inline Field fieldOf(const shapes::Mesh& mesh, const winding_options* options = nullptr,
  const winding_run* run = nullptr)
{
  winding_field* field = nullptr;
  winding_refusal refusal;
  const winding_polygons polygons = polygonsOf(mesh);
  EXPECT_EQ(
    winding_faces(arrayOf(mesh.points), &polygons, options, run, &field, &refusal), WINDING_OK)
    << refusal.text;
  return {field, winding_field_free};
}

/// A wish for a grid around a box.
inline winding_grid_request requestAround(const shapes::Point& low, const shapes::Point& high)
{
  auto request = with(winding_grid_request_init);
  for (int axis = 0; axis < 3; ++axis)
  {
    request.sampling_bounds[2 * axis] = low[axis];
    request.sampling_bounds[2 * axis + 1] = high[axis];
  }
  return request;
}

/// A grid around a box.
inline winding_grid gridAround(const shapes::Point& low, const shapes::Point& high, int resolution)
{
  auto request = requestAround(low, high);
  request.resolution = resolution;
  winding_grid grid;
  EXPECT_EQ(winding_lay_out_grid(&request, nullptr, &grid, nullptr), WINDING_OK);
  return grid;
}

inline std::size_t sizeOf(const winding_grid& grid)
{
  return static_cast<std::size_t>(grid.dimensions[0]) *
         static_cast<std::size_t>(grid.dimensions[1]) *
         static_cast<std::size_t>(grid.dimensions[2]);
}

/// A run that collects warnings.
class Warnings
{
public:
  Warnings()
    : run(with(winding_run_init))
  {
    run.user = this;
    run.warn = [](const char* text, void* user)
    {
      static_cast<Warnings*>(user)->texts.emplace_back(text);
    };
  }
  Warnings(const Warnings&) = delete;
  void operator=(const Warnings&) = delete;

  winding_run run;
  std::vector<std::string> texts;
};

} // namespace calls
