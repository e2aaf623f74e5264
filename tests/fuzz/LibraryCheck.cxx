// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FieldValues.h"
#include "RandomSources.h"

#include "base/Refusal.h"
#include "c/Calls.h"
#include "support/Serial.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <vector>

/**
 * @file
 * Calls of libwinding with random sources in arrays of random types and strides: right calls have
 * the bits of the core, and calls that are spoiled end with a status and a reason.
 */
namespace fuzz
{

namespace
{

using calls::with;
using shapes::Mesh;
using shapes::Point;
using shapes::serial;

/// Rows of numbers in any type, with any stride.
class RandomRows
{
public:
  /// Numbers in double precision are kept as they are.
  RandomRows(Choices& choices, const std::vector<Point>& points)
    : stride_(3 + choices.below(3))
    , numbers_(static_cast<std::size_t>(stride_) * points.size(), 7)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      std::copy_n(points[i].data(), 3, numbers_.begin() + static_cast<std::ptrdiff_t>(i) * stride_);
    }
    array_ = {numbers_.data(), static_cast<int64_t>(points.size()), stride_, WINDING_FLOAT64};
  }

  const winding_array& array() const { return array_; }

private:
  std::int64_t stride_;
  std::vector<double> numbers_;
  winding_array array_;
};

/// The triangles of a mesh, as triangles of any type or as polygons.
class RandomPolygons
{
public:
  RandomPolygons(Choices& choices, const Mesh& mesh)
    : arePolygons_(choices.oneIn(3))
    , areLong_(choices.oneIn(2))
    , stride_(arePolygons_ ? 1 : 3 + choices.below(2))
  {
    for (const auto& triangle : mesh.triangles)
    {
      ids_.insert(ids_.end(), triangle.begin(), triangle.end());
      ids_.resize(arePolygons_ ? ids_.size() : ids_.size() + static_cast<std::size_t>(stride_ - 3));
      offsets_.push_back(3 * static_cast<std::int64_t>(offsets_.size()));
    }
    offsets_.push_back(3 * static_cast<std::int64_t>(mesh.triangles.size()));
    shortIds_.assign(ids_.begin(), ids_.end());
    const auto rows = static_cast<int64_t>(mesh.triangles.size()) * (arePolygons_ ? 3 : 1);
    polygons_.corners = {areLong_ ? static_cast<const void*>(ids_.data()) : shortIds_.data(), rows,
      stride_, areLong_ ? WINDING_INT64 : WINDING_INT32};
    polygons_.offsets = {nullptr, 0, 0, 0};
    if (arePolygons_)
    {
      polygons_.offsets = {
        offsets_.data(), static_cast<int64_t>(offsets_.size()), 0, WINDING_INT64};
    }
  }

  winding_polygons& get() { return polygons_; }

private:
  bool arePolygons_, areLong_;
  std::int64_t stride_;
  std::vector<std::int64_t> ids_, offsets_;
  std::vector<std::int32_t> shortIds_;
  winding_polygons polygons_;
};

/// Returns the fault in how a call ended, if it made a result or none.
std::string checkEnd(winding_status status, const winding_refusal& refusal, bool hasResult)
{
  const bool isSilent = refusal.text[0] == 0;
  if (status == WINDING_FAILED)
  {
    return std::string("the library is at fault: ") + refusal.text;
  }
  if (hasResult != (status == WINDING_OK) || isSilent != (status == WINDING_OK))
  {
    return "status " + std::to_string(status) + " with " + (hasResult ? "a" : "no") +
           " result says: " + refusal.text;
  }
  return "";
}

/// Spoils one of the things that a call is given.
void spoil(Choices& choices, winding_array& array, winding_options& options)
{
  switch (choices.below(7))
  {
  case 0:
    array.data = nullptr;
    break;
  case 1:
    // Another width would have the call read what is not there, which nobody can notice.
    array.type = choices.oneIn(2)                ? 7 + choices.below(9)
                 : array.type == WINDING_FLOAT64 ? WINDING_INT32
                                                 : WINDING_FLOAT32;
    break;
  case 2:
    array.stride = choices.below(3) - 1;
    break;
  case 3:
    array.rows = choices.oneIn(2) ? -1 : std::numeric_limits<std::int64_t>::max() / 3;
    break;
  case 4:
    options.size = static_cast<uint32_t>(choices.below(4));
    break;
  case 5:
    options.method = choices.below(9) - 2;
    break;
  default:
    options.tolerance = choices.oneIn(2) ? -1 : std::numeric_limits<double>::quiet_NaN();
  }
}

/// Compares values at samples with the core's.
std::string compareWithCore(Choices& choices, const Mesh& mesh, winding_field* field)
{
  const auto expected = winding::Field::build(viewsOf(mesh), {}, serial);
  if (expected->info().primitives == 0)
  {
    return "";
  }
  const std::vector<Point> samples = randomSamples(choices, mesh.points, 1 + choices.below(20));
  const FieldValues values = valuesOf(*expected, samples, true, serial);
  std::vector<double> w(samples.size()), distances(samples.size());
  std::vector<std::uint8_t> inside(samples.size());
  auto output = with(winding_values_init);
  output.type = WINDING_FLOAT64;
  output.winding = w.data();
  output.inside = inside.data();
  output.distance = distances.data();
  const RandomRows rows(choices, samples);
  auto run = with(winding_run_init);
  run.number_of_threads = 1 + choices.below(3);
  winding_refusal refusal;
  const winding_status status =
    winding_evaluate_points(field, rows.array(), nullptr, &output, &run, &refusal);
  if (status != WINDING_OK)
  {
    return std::string("samples are refused: ") + refusal.text;
  }
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const double signedDistance = values.inside[i] ? -values.distances[i] : values.distances[i];
    if (std::memcmp(&w[i], &values.values[i], sizeof(double)) != 0 ||
        inside[i] != values.inside[i] ||
        !(distances[i] == signedDistance ||
          (std::isnan(distances[i]) && std::isnan(signedDistance))))
    {
      std::ostringstream line;
      line.precision(17);
      line << "sample " << i << " has w " << w[i] << ", inside " << int(inside[i]) << ", distance "
           << distances[i] << "; the core gives " << values.values[i] << ", "
           << int(values.inside[i]) << ", " << signedDistance;
      return line.str();
    }
  }
  return "";
}

} // namespace

std::string checkLibrary(Choices& choices)
{
  const Mesh mesh = randomMesh(choices, 30);
  const RandomRows points(choices, mesh.points);
  RandomPolygons polygons(choices, mesh);
  winding_array array = points.array();
  auto options = with(winding_options_init);
  const bool isSpoiled = choices.oneIn(2);
  if (isSpoiled)
  {
    spoil(choices, choices.oneIn(2) ? array : polygons.get().corners, options);
  }
  auto run = with(winding_run_init);
  run.number_of_threads = 1 + choices.below(2);
  winding_field* field = nullptr;
  winding_refusal refusal;
  const winding_status status =
    winding_faces(array, &polygons.get(), &options, &run, &field, &refusal);
  std::string failure = checkEnd(status, refusal, field != nullptr);
  if (failure.empty() && field && !isSpoiled)
  {
    failure = compareWithCore(choices, mesh, field);
  }
  winding_field_free(field);
  return failure;
}

} // namespace fuzz
