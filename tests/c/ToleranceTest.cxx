// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Calls.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace
{

using namespace calls;
using shapes::Mesh;
using shapes::Point;

/// Values of a field of points or of faces at samples.
std::vector<double> valuesOf(const Mesh& mesh, bool asPoints, const std::vector<Point>& samples,
  double tolerance, int method, int type)
{
  auto options = with(winding_options_init);
  options.method = method;
  options.tolerance = tolerance;
  options.scattered = 1;
  winding_field* field = nullptr;
  winding_refusal refusal;
  const winding_polygons polygons = polygonsOf(mesh);
  std::vector<Point> normals;
  for (const Point& point : mesh.points)
  {
    normals.push_back(point - mesh.points.front() + Point(0.1, 0.2, 0.3));
  }
  const winding_status status =
    asPoints ? winding_points(arrayOf(mesh.points), arrayOf(normals), {nullptr, 0, 0, 0}, &options,
                 nullptr, &field, &refusal)
             : winding_faces(arrayOf(mesh.points), &polygons, &options, nullptr, &field, &refusal);
  EXPECT_EQ(status, WINDING_OK) << refusal.text;
  const Field owned(field, winding_field_free);
  std::vector<double> doubles(samples.size());
  std::vector<float> floats(samples.size());
  auto values = with(winding_values_init);
  values.type = type;
  values.winding = type == WINDING_FLOAT64 ? static_cast<void*>(doubles.data()) : floats.data();
  EXPECT_EQ(winding_evaluate_points(field, arrayOf(samples), nullptr, &values, nullptr, nullptr),
    WINDING_OK);
  return type == WINDING_FLOAT64 ? doubles : std::vector<double>(floats.begin(), floats.end());
}

std::vector<Point> mapped(std::vector<Point> points, double scale, double offset)
{
  for (Point& point : points)
  {
    point = scale * point + Point(offset, -offset, 0.5 * offset);
  }
  return points;
}

} // namespace

/// Approximations keep every tolerance at every size and place, in both precisions. Prints a row of
/// the table of docs/library.md for each tolerance.
TEST(Tolerances, AreKeptAtEveryMagnitude)
{
  constexpr unsigned seed = 3907;
  const Mesh soup = shapes::triangleSoup(4000, seed);
  std::vector<Point> samples = shapes::pointsNear(soup, 500, 0.05, seed + 1);
  shapes::Random random(seed + 2);
  for (int i = 0; i < 500; ++i)
  {
    samples.push_back(random.point(-4, 4));
  }
  struct Magnitude
  {
    double scale, offset;
  };
  constexpr Magnitude magnitudes[] = {{1, 0}, {1e-6, 0}, {1e6, 0}, {1e-40, 0}, {1, 1e4}};
  std::printf(
    "| tolerance | faces, float64 | faces, float32 | points, float64 | points, float32 |\n"
    "|---|---|---|---|---|\n");
  for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
  {
    std::printf("| %.0e |", tolerance);
    for (const bool asPoints : {false, true})
    {
      for (const int type : {WINDING_FLOAT64, WINDING_FLOAT32})
      {
        double largest = 0;
        for (const Magnitude& m : magnitudes)
        {
          Mesh mesh = soup;
          mesh.points = mapped(soup.points, m.scale, m.offset);
          const std::vector<Point> places = mapped(samples, m.scale, m.offset);
          const std::vector<double> found =
            valuesOf(mesh, asPoints, places, tolerance, WINDING_METHOD_HIERARCHICAL, type);
          const std::vector<double> expected =
            valuesOf(mesh, asPoints, places, tolerance, WINDING_METHOD_DIRECT, WINDING_FLOAT64);
          for (std::size_t i = 0; i < places.size(); ++i)
          {
            // Single precision rounds what is larger than 1, too.
            const double rounding = type == WINDING_FLOAT32 ? 6e-8 * std::abs(expected[i]) : 1e-9;
            const double error = std::abs(found[i] - expected[i]);
            EXPECT_LE(error, tolerance + rounding)
              << "seed " << seed << ", scale " << m.scale << ", offset " << m.offset;
            largest = std::max(largest, error - rounding);
          }
        }
        std::printf(" %.1e |", largest);
      }
    }
    std::printf("\n");
  }
}
