// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/Refusal.h"
#include "base/Views.h"
#include "field/Field.h"
#include "source/Grid.h"
#include "support/RowValues.h"
#include "support/Serial.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

/**
 * Whatever numbers a source, its areas, grids and samples have: either they are refused or all that
 * comes out is finite.
 */

namespace
{

using namespace shapes;
using winding::Field;
using winding::FieldOptions;
using winding::FieldOutput;
using winding::Grid;
using winding::Method;

struct Case
{
  std::string name;
  std::shared_ptr<const Field> field;
  double size; ///< about the size of the source
};

class Sources
{
public:
  void addMeshes(const std::string& name, const Mesh& mesh, double size)
  {
    const Mesh scaled = mesh.scaled(size);
    for (const Method method :
      {Method::automatic, Method::rows, Method::hierarchical, Method::direct, Method::parity})
    {
      for (const bool scattered : {false, true})
      {
        FieldOptions options;
        options.method = method;
        options.scattered = scattered;
        this->add(name + " " + winding::nameOf(method), std::vector{scaled.view()}, options, size);
      }
    }
  }

  /// Adds clouds whose points have `area` squares of the size each, as far as they may.
  void addClouds(const std::string& name, const Cloud& cloud, double size, double area)
  {
    Cloud scaled = cloud;
    for (Point& position : scaled.positions)
    {
      position *= size;
    }
    const std::vector<double> areas(cloud.positions.size(), std::min(area * size * size, 1e210));
    winding::OrientedPointsView view = scaled.view();
    view.areas = {areas.data(), areas.size()};
    for (const Method method : {Method::automatic, Method::hierarchical, Method::direct})
    {
      for (const double regularization : {0.0, 1.0, 4.0})
      {
        for (const double tolerance : {1e-2, 1e-6})
        {
          FieldOptions options;
          options.method = method;
          options.tolerance = tolerance;
          options.regularization = regularization;
          this->add(name + " " + winding::nameOf(method), std::vector{view}, options, size);
        }
      }
    }
  }

  const std::vector<Case>& cases() const { return cases_; }

private:
  template <class View>
  void add(const std::string& name, const std::vector<View>& views, const FieldOptions& options,
    double size)
  {
    try
    {
      cases_.push_back({name, Field::build(views, options, serial), size});
    }
    catch (const winding::Refusal&)
    {
      EXPECT_TRUE(options.method == Method::rows && options.scattered) << name;
    }
  }

  std::vector<Case> cases_;
};

/// Sources of the smallest, the usual and the largest size.
const std::vector<Case>& someCases()
{
  static const Sources sources = []()
  {
    Sources made;
    for (const double size : {6e-101, 1.0, 9e99})
    {
      made.addMeshes("closed", icosphere(2), size);
      made.addMeshes("open", icosphere(2).part(0, 250), size);
      made.addMeshes(
        "soup", triangleSoup(300, 23).mapped([](const Point& p) -> Point { return p / 2; }), size);
      for (const double area : {0.0, 1e-300, 1e-100, 0.01, 1e10, 1e29})
      {
        made.addClouds(
          "cloud of areas " + std::to_string(std::log10(area)), sphereCloud(600), size, area);
      }
      made.addClouds("one place", Cloud{{{1, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, {1, 0, 0}}}, size, 0.5);
    }
    return made;
  }();
  return sources.cases();
}

std::vector<Point> someSamples(double size)
{
  std::vector<Point> samples = {{0, 0, 0}, {1.7e308, 0, 0}, {1.7e308, -1.7e308, 1.7e308},
    {0, -1e308, 1e-3}, {1e200, 1e150, 0}, {1e101, 1e99, -1e101}, {0, 1e60, 0}, {1e30, -1e30, 1e30},
    {0x1p-1074, 0, 0}, {0x1p-1022, -0x1p-1022, 0}, {1e-300, 1e-200, 0}, {1e-150, 0, 1e-140}};
  const std::vector<Point> near = randomPoints(60, -1.3, 1.3, 29);
  std::vector<Point> unit = icosphere(2).points;
  unit.insert(unit.end(), near.begin(), near.end());
  for (const Point& p : sphereCloud(600).positions)
  {
    unit.push_back(p);
    unit.push_back(p + Point(1e-9, 0, 1e-13));
    unit.push_back(p * (1 + 1e-16));
  }
  for (const Point& p : unit)
  {
    samples.push_back(size * p);
  }
  return samples;
}

/// All that a field gives at `count` samples.
struct Results
{
  explicit Results(std::size_t count)
    : values(count)
    , distances(count)
    , doubleValues(count)
    , doubleDistances(count)
  {
  }

  FieldOutput output()
  {
    FieldOutput output;
    output.values = values.data();
    output.distances = distances.data();
    output.doubleValues = doubleValues.data();
    output.doubleDistances = doubleDistances.data();
    return output;
  }

  bool isFinite(std::size_t i) const
  {
    return std::isfinite(values[i]) && std::isfinite(distances[i]) &&
           std::isfinite(doubleValues[i]) && std::isfinite(doubleDistances[i]);
  }

  std::vector<float> values, distances;
  std::vector<double> doubleValues, doubleDistances;
};

} // namespace

TEST(Ranges, ScatteredSamplesGetFiniteNumbersAndFarOnesNothing)
{
  for (const Case& one : someCases())
  {
    SCOPED_TRACE(one.name + " of size " + std::to_string(std::log10(one.size)));
    const std::vector<Point> samples = someSamples(one.size);
    const winding::VectorsView view(samples[0].data(), samples.size());
    Results results(samples.size());
    one.field->evaluate(view, results.output(), serial);
    std::vector<Point> gradients(samples.size());
    one.field->gradient(view, gradients[0].data(), serial);
    std::size_t bad = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      const bool isGood = results.isFinite(i) && gradients[i].allFinite();
      EXPECT_TRUE(isGood || bad++ > 0) << samples[i].transpose() << ": " << results.doubleValues[i]
                                       << ", " << gradients[i].transpose();
      if (samples[i].cwiseAbs().maxCoeff() > 1e50 * one.size)
      {
        EXPECT_NEAR(results.doubleValues[i], 0, 1e-30) << samples[i].transpose();
      }
    }
    EXPECT_EQ(bad, 0u);
  }
}

TEST(Ranges, GridsGetFiniteNumbers)
{
  for (const Case& one : someCases())
  {
    if (one.field->info().isScattered)
    {
      continue;
    }
    SCOPED_TRACE(one.name + " of size " + std::to_string(std::log10(one.size)));
    const double s = one.size;
    std::vector<Grid> grids = {gridOf({-1.2 * s, -s, -1.1 * s}, Point(s, s, s) / 4, {10, 9, 8}),
      gridOf({-s, -s, -s}, {1e-3 * s, s, 1e30 * std::min(s, 1e70)}, {4, 3, 3}),
      gridOf({1e60 * s, 0, 0}, {1e60 * s, 1e59 * s, s}, {3, 4, 3}),
      gridOf({0, 0, 0}, {1e101, 1e101, 1e101}, {3, 2, 3}),
      gridOf({0, 0, 0}, {1e-109, 1e-105, 1e-102}, {3, 4, 3})};
    for (const double far : {1e2, 1e4, 1e6, 1e8, 1e10, 1e12, 1e14, 1e18, 1e20})
    {
      grids.push_back(gridOf({-s, -s, -s}, {0.3 * s, 0.5 * s, 0.3 * far * s}, {7, 6, 4}));
      grids.push_back(gridOf(Point::Constant(-far * s), Point::Constant(0.2 * far * s), {9, 9, 9}));
      grids.push_back(gridOf({far * s, 0, 0}, {s, s, s}, {5, 5, 5}));
    }
    for (const Grid& grid : grids)
    {
      Results results(winding::sampleCount(grid.wholeExtent()));
      one.field->evaluate(grid, grid.wholeExtent(), results.output(), serial);
      std::size_t bad = 0;
      for (std::size_t i = 0; i < results.values.size(); ++i)
      {
        EXPECT_TRUE(results.isFinite(i) || bad++ > 0)
          << grid.sample(i).transpose() << ": " << results.doubleValues[i];
      }
      EXPECT_EQ(bad, 0u) << grid.spacing.transpose();
    }
  }
}
