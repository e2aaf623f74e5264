// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Evaluation.h"
#include "Handles.h"
#include "messages/PropertyChecks.h"
#include "source/Sanitize.h"
#include "surface/OpenParts.h"
#include "surface/Orientation.h"
#include "surface/SolidParts.h"
#include "tasks/LabelTask.h"

using namespace winding::c;
using winding::Field;
using winding::Grid;

namespace
{

winding_label_options defaultLabelOptions()
{
  winding_label_options options = {};
  options.size = sizeof options;
  options.coverage_samples = 4;
  options.mend_source = 1;
  return options;
}

winding_labels noLabels()
{
  winding_labels labels = {};
  labels.size = sizeof labels;
  return labels;
}

winding::LabelOptions optionsOf(const winding_rule* rule, const winding_label_options& wished)
{
  winding::checkProperty(winding::Parameter::overlapRule, wished.overlap_rule);
  winding::checkProperty(winding::Parameter::coverage, wished.coverage);
  winding::checkProperty(winding::Parameter::coverageSamples, wished.coverage_samples);
  winding::LabelOptions options;
  options.overlapRule = static_cast<winding::OverlapRule>(wished.overlap_rule);
  options.mendsSource = wished.mend_source != 0;
  options.voxels.coverage = static_cast<winding::Coverage>(wished.coverage);
  options.voxels.samplesPerAxis = wished.coverage_samples;
  options.voxels.output.isInside = insideTestOf(rule);
  return options;
}

/// Returns the arrays of a caller. Throws Misuse for shares without fractions.
winding::LabelArrays arraysOf(
  const winding_labels& labels, const winding::Extent& extent, int32_t coverage)
{
  const bool hasTwo =
    labels.first_labels && labels.first_shares && labels.second_labels && labels.second_shares;
  const bool hasAny =
    labels.first_labels || labels.first_shares || labels.second_labels || labels.second_shares;
  if (hasAny != hasTwo || ((hasAny || labels.shares) && coverage != WINDING_COVERAGE_FRACTION))
  {
    throw Misuse("arrays of shares go together, and with WINDING_COVERAGE_FRACTION");
  }
  winding::LabelArrays arrays;
  arrays.extent = extent;
  arrays.labels = &required(labels.labels, "labels.labels");
  arrays.counts = labels.counts;
  arrays.firstLabels = labels.first_labels;
  arrays.firstShares = labels.first_shares;
  arrays.secondLabels = labels.second_labels;
  arrays.secondShares = labels.second_shares;
  return arrays;
}

} // namespace

void winding_label_options_init(winding_label_options* options, size_t size)
{
  fill(options, size, defaultLabelOptions());
}

void winding_labels_init(winding_labels* labels, size_t size)
{
  fill(labels, size, noLabels());
}

winding_status winding_label(const winding_field* const* fields, const uint16_t* numbers,
  size_t count, const winding_grid* grid, const int32_t* extent, const winding_rule* rule,
  const winding_label_options* options, const winding_labels* labels, const winding_run* run,
  winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      if (count > winding::largestLabel)
      {
        throw Misuse("count exceeds 65535");
      }
      const Grid samples = gridOf(grid);
      const winding_label_options wished = known(options, defaultLabelOptions());
      const winding::LabelOptions rules = optionsOf(rule, wished);
      const winding::Extent part = extentOf(samples, extent);
      const std::size_t voxels = winding::sampleCount(part);
      Call call(run);
      const winding_labels given = known(&required(labels, "labels"), noLabels());
      winding::LabelArrays arrays = arraysOf(given, part, wished.coverage);
      std::vector<float> best(wished.overlap_rule == WINDING_OVERLAP_RULE_LARGEST ? voxels : 0);
      arrays.best = best.empty() ? nullptr : best.data();
      winding::LabelFacts facts;
      facts.expected = count;
      winding::LabelTask task(samples, arrays, rules, facts, call.run);
      const auto addSolid = [&](std::size_t i)
      {
        const Field& field = *required(fields ? fields[i] : nullptr, "a field").field;
        winding::LabeledSolid solid;
        solid.label = static_cast<unsigned short>(numbers ? numbers[i] : i + 1);
        if (solid.label == 0)
        {
          throw Misuse("a number of numbers is 0");
        }
        const char* const name = given.names ? given.names[i] : nullptr;
        solid.name = name ? std::string(name) : std::to_string(solid.label);
        solid.isOpenPart = given.are_open && given.are_open[i] != 0;
        solid.shares = given.shares ? given.shares[i] : nullptr;
        if (solid.shares)
        {
          std::fill_n(solid.shares, voxels, 0.0F);
        }
        winding::FieldInfo info = field.info();
        info.warnings.clear(); // they came with the field
        const auto all = static_cast<double>(count);
        call.executor.setShare(static_cast<double>(i) / all, static_cast<double>(i + 1) / all);
        task.add(field, info, solid, call.run);
      };
      if (count > 0)
      {
        const Field& first = *required(fields ? fields[0] : nullptr, "a field").field;
        evaluateInTime(first, count * voxels, call,
          [&]
          {
            for (std::size_t i = 0; i < count; ++i)
            {
              addSolid(i);
            }
          });
      }
      task.warn(wished.have_one_unit != 0, call.run);
      call.warn(facts.unused.messages());
    });
}

winding_status winding_solids(winding_array points, const winding_polygons* polygons,
  const winding_run* run, int32_t* solids, int64_t* count, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      const Triangles triangles(points, polygons);
      int32_t* const result = triangles.polygons() > 0 ? &required(solids, "solids") : solids;
      Call call(run);
      const winding::Surface surface = winding::sanitize(triangles.views(), call.executor);
      const winding::SolidParts parts =
        winding::solidPartsOf(surface, winding::polygonPartsOf(triangles.views()), call.executor);
      required(count, "count") = static_cast<int64_t>(parts.count);
      std::fill(result, result + triangles.polygons(), -1);
      triangles.forEachKept(
        [&](std::size_t polygon, std::size_t n) { result[polygon] = parts.ofTriangle[n]; });
    });
}

winding_status winding_open_parts(winding_array points, const winding_polygons* polygons,
  const winding_run* run, uint8_t* are_open, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      const Triangles triangles(points, polygons);
      uint8_t* const result = triangles.polygons() > 0 ? &required(are_open, "are_open") : are_open;
      Call call(run);
      const winding::Surface surface = winding::sanitize(triangles.views(), call.executor);
      const winding::OpenParts open =
        winding::openPartsInside(surface, winding::edgesOf(surface, call.executor), call.executor);
      std::fill(result, result + triangles.polygons(), 0);
      triangles.forEachKept([&](std::size_t polygon, std::size_t n)
        { result[polygon] = static_cast<uint8_t>(!open.isInside.empty() && open.isInside[n]); });
    });
}

winding_status winding_orient(winding_array points, const winding_polygons* polygons,
  const winding_run* run, uint8_t* turned, uint8_t* left_out, int64_t* turned_triangles,
  int64_t* turned_components, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      const Triangles triangles(points, polygons);
      const std::size_t count = triangles.polygons();
      if (count > 0 && (!turned || !left_out))
      {
        throw Misuse("turned or left_out is null");
      }
      Call call(run);
      const winding::Surface surface = winding::sanitize(triangles.views(), call.executor);
      const winding::PolygonParts parts = winding::polygonPartsOf(triangles.views());
      const winding::Orientation found = winding::orient(surface, parts, call.executor);
      if (turned_triangles)
      {
        *turned_triangles = static_cast<int64_t>(found.triangles);
      }
      if (turned_components)
      {
        *turned_components = static_cast<int64_t>(found.components);
      }
      std::fill(turned, turned + count, 0);
      std::fill(left_out, left_out + count, 0);
      triangles.forEachKept(
        [&](std::size_t polygon, std::size_t n)
        {
          turned[polygon] = static_cast<uint8_t>(found.isTurned[n]);
          left_out[polygon] =
            found.isLeftOut.empty() ? 0 : static_cast<uint8_t>(found.isLeftOut[n]);
        });
    });
}
