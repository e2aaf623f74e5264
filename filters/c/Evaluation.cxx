// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation.h"

#include "Handles.h"
#include "base/SideCounts.h"
#include "messages/PropertyChecks.h"
#include "report/ExpectedTimeAdvice.h"
#include "report/Verify.h"
#include "tasks/MendedSource.h"
#include "tasks/ResultNotes.h"
#include "tasks/WallGrid.h"
#include "voxels/VoxelEvaluation.h"

#include <cmath>

namespace winding::c
{

void evaluateInTime(
  const Field& field, std::size_t samples, Call& call, const std::function<void()>& work)
{
  const double limit = call.longestExpectedTime();
  double nextLook = limit > 0 ? std::min(limit, 1.0) : 1;
  bool isAnnounced = false;
  call.executor.runByClock(work,
    [&](double elapsed, double expected)
    {
      if (elapsed < nextLook)
      {
        return;
      }
      nextLook = 2 * elapsed;
      const auto advice = expectedTimeAdvice(field.info(), {expected, limit, samples});
      if (advice && !isAnnounced)
      {
        isAnnounced = true;
        call.warn(*advice);
      }
    });
}

Extent extentOf(const Grid& grid, const int32_t* extent)
{
  Extent result = grid.wholeExtent();
  for (int i = 0; extent && i < 6; i += 2)
  {
    if (extent[i] < 0 || extent[i + 1] >= grid.dimensions[i / 2] || extent[i] > extent[i + 1])
    {
      throw Misuse("extent does not lie in the grid");
    }
    result[static_cast<std::size_t>(i)] = extent[i];
    result[static_cast<std::size_t>(i) + 1] = extent[i + 1];
  }
  return result;
}

} // namespace winding::c

using namespace winding::c;
using winding::Extent;
using winding::FieldOutput;
using winding::Grid;

namespace
{

winding_values defaultValues()
{
  winding_values values = {};
  values.size = sizeof values;
  values.type = WINDING_FLOAT32;
  values.coverage = WINDING_COVERAGE_CENTER;
  values.coverage_samples = 4;
  return values;
}

/// Returns the output that a caller's arrays make.
FieldOutput outputOf(const winding_values& values, const winding::InsideTest& isInside)
{
  if (values.type != WINDING_FLOAT32 && values.type != WINDING_FLOAT64)
  {
    throw Misuse("values.type is no type of floating-point numbers");
  }
  if (std::isnan(values.distance_limit) || values.distance_limit < 0)
  {
    throw Misuse("values.distance_limit is negative");
  }
  FieldOutput output;
  const bool areDoubles = values.type == WINDING_FLOAT64;
  output.values = areDoubles ? nullptr : static_cast<float*>(values.winding);
  output.doubleValues = areDoubles ? static_cast<double*>(values.winding) : nullptr;
  output.inside = values.inside;
  output.isInside = isInside;
  output.distances = areDoubles ? nullptr : static_cast<float*>(values.distance);
  output.doubleDistances = areDoubles ? static_cast<double*>(values.distance) : nullptr;
  if (values.distance_limit > 0)
  {
    output.distanceLimit = values.distance_limit;
  }
  return output;
}

/// Returns a wish for a grid, checked.
winding::GridRequest gridRequestOf(const winding_grid_request* request)
{
  winding_grid_request wished = {};
  wished = known(&required(request, "request"), wished);
  winding::checkProperty(winding::Parameter::resolution, wished.resolution);
  winding::checkProperty(winding::Parameter::voxelSize, wished.voxel_size);
  winding::checkProperty(winding::Parameter::padding, wished.padding);
  winding::GridRequest asked;
  asked.resolution = wished.resolution;
  asked.voxelSize = wished.voxel_size;
  asked.padding = wished.padding;
  const int32_t* dimensions = wished.sampling_dimensions;
  if (dimensions[0] != 0 || dimensions[1] != 0 || dimensions[2] != 0)
  {
    winding::checkDimensions(dimensions);
    asked.dimensions = Eigen::Vector3i(dimensions[0], dimensions[1], dimensions[2]);
  }
  asked.isCubic = wished.cubic != 0;
  const double* bounds = wished.sampling_bounds;
  asked.bounds = winding::Bounds(Eigen::Vector3d(bounds[0], bounds[2], bounds[4]),
    Eigen::Vector3d(bounds[1], bounds[3], bounds[5]));
  return asked;
}

} // namespace

void winding_rule_init(winding_rule* rule, size_t size)
{
  fill(rule, size, defaultRule());
}

void winding_values_init(winding_values* values, size_t size)
{
  fill(values, size, defaultValues());
}

void winding_grid_request_init(winding_grid_request* request, size_t size)
{
  const winding::GridRequest standard;
  winding_grid_request defaults = {};
  defaults.resolution = standard.resolution;
  defaults.padding = 0.05;
  fill(request, size, defaults);
}

winding_status winding_lay_out_grid(const winding_grid_request* request, const winding_run* run,
  winding_grid* grid, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      const Grid made = winding::setUpGrid(gridRequestOf(request));
      winding_grid& result = required(grid, "grid");
      for (int axis = 0; axis < 3; ++axis)
      {
        result.origin[axis] = made.firstSample[axis];
        result.spacing[axis] = made.spacing[axis];
        result.dimensions[axis] = made.dimensions[axis];
      }
    });
}

winding_status winding_wall_resolution(const winding_field* field,
  const winding_grid_request* request, const winding_rule* rule, int32_t mend_source,
  const winding_run* run, int32_t* resolution, char* reason, size_t reason_size,
  winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      const winding_field& handle = required(field, "field");
      Call call(run);
      winding::WallGrid grid(gridRequestOf(request));
      grid.add(*handle.field, insideTestOf(rule), mend_source != 0, call.executor);
      required(resolution, "resolution") = grid.resolution();
      if (reason && reason_size > 0)
      {
        copyText(grid.reason(), reason, reason_size);
      }
    });
}

winding_status winding_evaluate_grid(const winding_field* field, const winding_grid* grid,
  const int32_t* extent, const winding_rule* rule, winding_values* values, const winding_run* run,
  winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      const winding_field& handle = required(field, "field");
      const winding::InsideTest isInside = insideTestOf(rule);
      const winding_values wished = known(&required(values, "values"), defaultValues());
      const Grid samples = gridOf(grid);
      const Extent part = extentOf(samples, extent);
      const std::size_t count = winding::sampleCount(part);
      winding::checkProperty(winding::Parameter::coverage, wished.coverage);
      winding::checkProperty(winding::Parameter::coverageSamples, wished.coverage_samples);
      Call call(run);
      winding::SideTally sides;
      winding::VoxelEvaluation voxels;
      voxels.coverage = static_cast<winding::Coverage>(wished.coverage);
      voxels.samplesPerAxis = wished.coverage_samples;
      voxels.fractions = wished.fractions;
      voxels.united = wished.united;
      voxels.output = outputOf(wished, isInside);
      voxels.output.sides = &sides;
      if (wished.gradient)
      {
        throw Misuse("values.gradient is for points only");
      }
      if ((voxels.coverage == winding::Coverage::fraction) != (wished.fractions != nullptr))
      {
        throw Misuse("values.fractions goes with WINDING_COVERAGE_FRACTION");
      }
      if (wished.united && !wished.fractions)
      {
        throw Misuse("values.united goes with values.fractions");
      }
      // Voxels by coverage, and warnings of the whole grid, need an array of what is inside.
      const bool isWhole = part == samples.wholeExtent();
      const bool needsInside =
        voxels.coverage != winding::Coverage::center || (isWhole && !wished.winding);
      std::vector<unsigned char> own(needsInside && !wished.inside ? count : 0);
      voxels.output.inside = own.empty() ? wished.inside : own.data();
      const bool mayThicken = wished.coverage != WINDING_COVERAGE_ANY && !wished.united;
      winding::MendedSource source(
        *handle.field, samples, {wished.mend_source != 0, mayThicken, isInside}, call.run);
      evaluateInTime(*handle.field, count, call,
        [&]
        {
          source.decideByLayers();
          voxels.plate = source.plate();
          voxels.run(source.field(), samples, part, call.executor);
        });
      const winding::Field& used = source.field();
      const unsigned char* const inside = voxels.output.inside;
      winding::ResultOnGrid result;
      result.sides = sides.counts(count);
      std::size_t insideCount = result.sides.inside;
      if (inside)
      {
        insideCount = static_cast<std::size_t>(std::count(inside, inside + count, 1));
      }
      if (isWhole && voxels.plate == 0)
      {
        result.isEmpty = (wished.united ? result.sides.inside : insideCount) == 0;
        result.withoutAdvice = wished.without_advice != 0;
        result.takesTouchedVoxels = voxels.coverage == winding::Coverage::any;
        result.mayTouchVoxels = voxels.coverage == winding::Coverage::center;
        result.isInside = [&](int i, int j, int k)
        {
          const std::size_t n = winding::sampleNumber(part, i, j, k);
          return inside ? inside[n] != 0
                        : isInside(voxels.output.values ? voxels.output.values[n]
                                                        : voxels.output.doubleValues[n]);
        };
        call.executor.setShare(1, 1);
        winding::warnOfOpenSide(used, {isInside.threshold, result.takesTouchedVoxels}, call.run);
        winding::warnOfResult(used, samples, result, isInside, call.run);
      }
      winding_values written = wished;
      written.inside_count = static_cast<int64_t>(insideCount);
      give(written, *values);
    });
}

winding_status winding_evaluate_points(const winding_field* field, winding_array points,
  const winding_rule* rule, winding_values* values, const winding_run* run,
  winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      const winding_field& handle = required(field, "field");
      const winding::InsideTest isInside = insideTestOf(rule);
      const winding_values wished = known(&required(values, "values"), defaultValues());
      const winding::VectorsView samples = vectorsOf(points, "points");
      if (wished.fractions || wished.united || wished.coverage != WINDING_COVERAGE_CENTER)
      {
        throw Misuse("values.fractions, values.united and values.coverage are for grids only");
      }
      Call call(run);
      winding::SideTally sides;
      FieldOutput output = outputOf(wished, isInside);
      output.sides = &sides;
      evaluateInTime(*handle.field, samples.size(), call,
        [&]
        {
          const bool hasGradients = wished.gradient != nullptr;
          call.executor.setShare(0, hasGradients ? 0.5 : 1);
          handle.field->evaluate(samples, output, call.executor);
          if (hasGradients)
          {
            call.executor.setShare(0.5, 1);
            handle.field->gradient(samples, wished.gradient, call.executor);
          }
        });
      const winding::SideCounts counts = sides.counts(samples.size());
      call.executor.setShare(1, 1);
      winding::warnOfSides(*handle.field, counts, isInside, call.run);
      winding_values written = wished;
      written.inside_count = static_cast<int64_t>(counts.inside);
      give(written, *values);
    });
}

void winding_verification_init(winding_verification* verification, size_t size)
{
  fill(verification, size, winding_verification());
}

winding_status winding_verify(const winding_field* field, const winding_grid* grid,
  const int32_t* extent, winding_array winding, int64_t samples, const winding_run* run,
  winding_verification* verification, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      const winding_field& handle = required(field, "field");
      winding_verification& result = required(verification, "verification");
      const Grid all = gridOf(grid);
      const Extent part = extentOf(all, extent);
      const winding::ScalarsView values = scalarsOf(winding, "winding");
      if (samples < 0 || values.size() != winding::sampleCount(part))
      {
        throw Misuse("samples are less than 0, or winding has not a row for each sample");
      }
      constexpr unsigned seed = 20260101;
      Call call(run);
      const winding::Verification found = winding::verify(
        *handle.field, all, part, [&](std::size_t n) { return values[n]; },
        static_cast<std::size_t>(samples), seed, call.executor);
      winding_verification to = {};
      to.samples = static_cast<int64_t>(found.everywhere.samples);
      to.max_error = found.everywhere.max;
      to.rms_error = found.everywhere.rms();
      to.near_source = static_cast<int64_t>(found.nearSurface.samples);
      to.near_max_error = found.nearSurface.max;
      give(to, result);
    });
}
