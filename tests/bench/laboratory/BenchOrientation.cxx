// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "laboratory/BenchOptions.h"
#include "laboratory/BenchSubjects.h"
#include "laboratory/Meshes.h"
#include "laboratory/ThreadExecutor.h"
#include "laboratory/Timing.h"
#include "program/Interrupt.h"
#include "program/Threads.h"

#include "base/FieldOutput.h"
#include "field/Field.h"
#include "source/Sanitize.h"
#include "source/Surface.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

namespace
{

/// Points on a surface, with the normals of the triangles that they lie on.
struct Samples
{
  std::vector<Eigen::Vector3d> positions, normals;
};

/// Points on triangles, as many as there are for the triangles' areas, and moved by normally
/// distributed steps.
Samples sampled(const winding::Surface& surface, std::size_t count, double noise, unsigned seed)
{
  std::vector<double> areas;
  std::vector<Eigen::Vector3d> corners;
  for (const auto& triangle : surface.triangles)
  {
    for (const auto vertex : triangle)
    {
      corners.push_back(surface.vertices[static_cast<std::size_t>(vertex)]);
    }
    const Eigen::Vector3d* const a = &corners[corners.size() - 3];
    areas.push_back((a[1] - a[0]).cross(a[2] - a[0]).norm());
  }
  std::mt19937_64 random(seed);
  std::discrete_distribution<std::size_t> triangles(areas.begin(), areas.end());
  std::uniform_real_distribution<double> share(0, 1);
  std::normal_distribution<double> step(0, 1);
  const double size = noise * surface.bounds.sizes().norm();
  Samples samples;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Eigen::Vector3d* const a = &corners[3 * triangles(random)];
    const double root = std::sqrt(share(random)), along = share(random);
    Eigen::Vector3d position = (1 - root) * a[0] + root * ((1 - along) * a[1] + along * a[2]);
    for (int axis = 0; axis < 3 && size > 0; ++axis)
    {
      position[axis] += size * step(random);
    }
    samples.positions.push_back(position);
    samples.normals.push_back((a[1] - a[0]).cross(a[2] - a[0]).normalized());
  }
  return samples;
}

std::vector<float> valuesOf(
  const winding::Field& field, const std::vector<Eigen::Vector3d>& at, winding::Executor& executor)
{
  std::vector<float> values(at.size());
  winding::FieldOutput output;
  output.values = values.data();
  field.evaluate(winding::VectorsView(at[0].data(), at.size()), output, executor);
  interrupt::check();
  return values;
}

/// The part that two sets of places have in common, of all places in either.
double overlap(const std::vector<unsigned char>& first, const std::vector<float>& second)
{
  double both = 0, any = 0;
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    const bool isInside = second[i] >= 0.5f;
    both += first[i] && isInside;
    any += first[i] || isInside;
  }
  return any > 0 ? both / any : 1;
}

class OrientationBench
{
public:
  OrientationBench(const winding::Surface& surface, const Triangles& triangles)
    : surface_(surface)
  {
    constexpr std::size_t places = 40'000;
    constexpr double margin = 0.02;
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> share(-margin, 1 + margin);
    for (std::size_t i = 0; i < places; ++i)
    {
      const Eigen::Vector3d at(share(random), share(random), share(random));
      places_.push_back(surface.bounds.min() + surface.bounds.sizes().cwiseProduct(at));
    }
    winding::FieldOptions options;
    options.scattered = true;
    const auto field = winding::Field::build(std::vector{triangles.view()}, options, executor_);
    double sum = 0;
    for (const float w : valuesOf(*field, places_, executor_))
    {
      sum += w;
      isInside_.push_back(std::abs(w) >= 0.5f);
    }
    isInward_ = sum < 0;
  }

  void addRow(BenchTable& table, std::size_t points, double noise, unsigned seed)
  {
    Samples samples = sampled(surface_, points, noise, seed);
    if (isInward_)
    {
      for (Eigen::Vector3d& normal : samples.normals)
      {
        normal = -normal;
      }
    }
    Json row = {{"points", points}, {"noise %", 100 * noise}, {"seed", seed}};
    winding::OrientedPointsView view = {{samples.positions[0].data(), points}, {}, {}};
    winding::OrientedPointsView known = view;
    known.normals = {samples.normals[0].data(), points};
    row["true"] = this->overlapOf(known, {});
    for (const auto estimation : {winding::NormalEstimation::spanningTree,
           winding::NormalEstimation::consistent, winding::NormalEstimation::automatic})
    {
      winding::FieldOptions options;
      options.estimateNormals = true;
      options.normalEstimation = estimation;
      row[winding::nameOf(estimation)] = this->overlapOf(view, options);
      row[std::string(winding::nameOf(estimation)) + " s"] = seconds_;
    }
    row["outward"] = outward_;
    table.add(row);
  }

private:
  double overlapOf(const winding::OrientedPointsView& view, winding::FieldOptions options)
  {
    options.scattered = true;
    std::shared_ptr<const winding::Field> field;
    seconds_ =
      secondsOf([&] { field = winding::Field::build(std::vector{view}, options, executor_); }, 1);
    outward_ = field->info().orientation.outward;
    return overlap(isInside_, valuesOf(*field, places_, executor_));
  }

  const winding::Surface& surface_;
  ThreadExecutor executor_;
  std::vector<Eigen::Vector3d> places_;
  std::vector<unsigned char> isInside_;
  bool isInward_ = false;
  double seconds_ = 0, outward_ = 0;
};

} // namespace

std::vector<BenchTable> benchOrientation(const BenchOptions& options, Messages& messages)
{
  std::vector<BenchTable> tables;
  const auto measureMesh = [&](const std::string& file, const Triangles& triangles)
  {
    ThreadExecutor executor;
    const winding::Surface surface = winding::sanitize({triangles.view()}, executor);
    BenchTable table(file + ", " + std::to_string(threadsUsed(options.threads)) + " threads",
      {"points on the triangles, moved by steps in percent of the diagonal",
        "true, …: with the true normals and with estimated ones, the part that w >= 0.5 and the "
        "inside of the mesh have in common, of what is in either, at random places in the bounds",
        "outward: the share of the points of automatic with w about 1 behind and 0 before them"});
    OrientationBench bench(surface, triangles);
    for (const auto points : givenOr(options.points, {50'000}))
    {
      for (const double noise : {0.0, 0.005})
      {
        for (const unsigned seed : {1U, 2U, 3U})
        {
          bench.addRow(table, static_cast<std::size_t>(points), noise, seed);
        }
      }
    }
    tables.push_back(table);
  };
  forEachMesh(options, messages, measureMesh);
  return tables;
}
