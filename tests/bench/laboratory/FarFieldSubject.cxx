// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "laboratory/FarFieldSubject.h"

#include "laboratory/NaiveSums.h"
#include "laboratory/Timing.h"

#include "base/Views.h"
#include "farfield/FarFieldChoice.h"
#include "farfield/GridCells.h"
#include "farfield/TriangleFarField.h"
#include "field/CappedSurface.h"
#include "rays/RowCrossings.h"
#include "source/PointCloud.h"
#include "source/Sanitize.h"
#include "surface/Cap.h"

namespace
{

using winding::FarField;
using winding::FarFieldAccuracy;
using winding::Grid;

class Soup final : public FarFieldSubject
{
public:
  Soup(const Triangles& triangles, const winding::Surface& surface)
    : triangles_(triangles)
    , surface_(surface)
  {
  }

  const char* name() const override { return "triangles"; }
  std::size_t sources() const override { return surface_.triangles.size(); }
  const winding::Bounds& bounds() const override { return surface_.bounds; }

  std::shared_ptr<const winding::Field> field(
    double tolerance, winding::Executor& executor) const override
  {
    winding::FieldOptions options;
    options.method = winding::Method::hierarchical;
    options.tolerance = tolerance;
    return winding::Field::build({triangles_.view()}, options, executor);
  }

  std::shared_ptr<const FarField> farField(
    double tolerance, const Grid& grid, winding::Executor& executor) const override
  {
    return winding::TriangleFarField(
      surface_.vertices, surface_.triangles, surface_.bounds, FarFieldAccuracy::of(tolerance))
      .suiting(grid, executor);
  }

  ExactCosts exactCosts() const override
  {
    winding::SerialExecutor serial;
    const auto sources = winding::farFieldSources(
      surface_.vertices, surface_.triangles, surface_.bounds, winding::SplitRule(), serial);
    return measureExactCosts(*sources, false);
  }

private:
  const Triangles& triangles_;
  const winding::Surface& surface_;
};

class Cloud final : public FarFieldSubject
{
public:
  explicit Cloud(const winding::Surface& surface)
    : Cloud(verticesOf(surface), winding::SerialExecutor())
  {
  }

  const char* name() const override { return "points"; }
  std::size_t sources() const override { return cloud_.positions.size(); }
  const winding::Bounds& bounds() const override { return cloud_.bounds; }

  std::shared_ptr<const winding::Field> field(
    double tolerance, winding::Executor& executor) const override
  {
    winding::FieldOptions options;
    options.method = winding::Method::hierarchical;
    options.tolerance = tolerance;
    return winding::Field::build(std::vector{viewOf(cloud_)}, options, executor);
  }

  std::shared_ptr<const FarField> farField(
    double tolerance, const Grid&, winding::Executor& executor) const override
  {
    return std::make_shared<FarField>(winding::farFieldSources(cloud_, cloud_.areas, executor),
      FarFieldAccuracy::of(tolerance), executor);
  }

  ExactCosts exactCosts() const override
  {
    winding::SerialExecutor serial;
    return measureExactCosts(*winding::farFieldSources(cloud_, cloud_.areas, serial), false);
  }

private:
  /// sanitize() leaves vertices without a normal out.
  Cloud(const winding::PointCloud& vertices, winding::SerialExecutor executor)
    : cloud_(winding::sanitize(std::vector{viewOf(vertices)}, executor))
  {
  }

  static winding::OrientedPointsView viewOf(const winding::PointCloud& cloud)
  {
    return {{cloud.positions[0].data(), cloud.positions.size()},
      {cloud.normals[0].data(), cloud.normals.size()}, {cloud.areas.data(), cloud.areas.size()}};
  }

  winding::PointCloud cloud_;
};

class Capped final : public FarFieldSubject
{
public:
  Capped(const Triangles& triangles, const winding::Surface& surface)
    : triangles_(triangles)
    , surface_(surface)
  {
    winding::SerialExecutor executor;
    cap_ = winding::capOf(winding::boundaryLoops(
      winding::boundaryChain(surface, executor).edges, surface.vertices.size(), executor));
  }

  /// Whether the cap has a far field by the default tolerance.
  bool hasFarField() const
  {
    const int order = winding::FarFieldAccuracy::of(winding::FieldOptions().tolerance).order;
    return !cap_.empty() &&
           !winding::isCheaperDirectly(winding::Primitive::triangle, cap_.size(), order);
  }

  const char* name() const override { return "cap"; }
  std::size_t sources() const override { return cap_.size(); }
  const winding::Bounds& bounds() const override { return surface_.bounds; }

  std::shared_ptr<const winding::Field> field(
    double tolerance, winding::Executor& executor) const override
  {
    winding::FieldOptions options;
    options.method = winding::Method::rows;
    options.tolerance = tolerance;
    return winding::Field::build({triangles_.view()}, options, executor);
  }

  std::shared_ptr<const FarField> farField(
    double tolerance, const Grid& grid, winding::Executor& executor) const override
  {
    return winding::TriangleFarField(
      surface_.vertices, cap_, surface_.bounds, FarFieldAccuracy::of(tolerance))
      .suiting(grid, executor);
  }

  ExactCosts exactCosts() const override
  {
    winding::SerialExecutor serial;
    const auto sources = winding::farFieldSources(
      surface_.vertices, cap_, surface_.bounds, winding::SplitRule(), serial);
    return measureExactCosts(*sources, true);
  }

  double secondsForRows(const Grid& grid) const override
  {
    const winding::RowCrossings rows(surface_.vertices, surface_.triangles, cap_);
    // CappedSurface works in such bars, too, as high and deep as the cells of a task.
    const winding::Extent all = grid.wholeExtent();
    const winding::GridCells cells(grid, all, 1, 3);
    const winding::RowBands bands = {0, static_cast<int>(cells.sizeOf(cells.taskLevel(), 1))};
    const auto findCrossings = [&]
    {
      winding::SerialExecutor serial;
      const auto onGrid = rows.on(grid, all, bands, serial);
      for (int k = all[4]; k <= all[5]; ++k)
      {
        for (std::size_t band = 0; band < bands.countIn(all); ++band)
        {
          onGrid->evaluate(k, band, [](int, int, const std::vector<winding::RowRun>&) {});
        }
      }
    };
    return secondsOfOne(findCrossings);
  }

private:
  const Triangles& triangles_;
  const winding::Surface& surface_;
  winding::TriangleList cap_;
};

} // namespace

std::unique_ptr<FarFieldSubject> soupOf(const Triangles& triangles, const winding::Surface& surface)
{
  return std::make_unique<Soup>(triangles, surface);
}

std::unique_ptr<FarFieldSubject> cloudOf(const winding::Surface& surface)
{
  return std::make_unique<Cloud>(surface);
}

std::unique_ptr<FarFieldSubject> capOf(const Triangles& triangles, const winding::Surface& surface)
{
  auto capped = std::make_unique<Capped>(triangles, surface);
  return capped->hasFarField() ? std::move(capped) : nullptr;
}
