// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Border.h"

#include "messages/PropertyChecks.h"
#include "source/Sanitize.h"
#include "source/SnappedPoints.h"

#include <cmath>
#include <limits>
#include <utility>

namespace winding::c
{

namespace
{

/// Throws Misuse unless an array can have rows of `width` numbers.
void checkArray(const winding_array& array, std::int64_t width, const char* name)
{
  const auto refuse = [name](const char* fault)
  {
    throw Misuse(std::string(name) + fault);
  };
  if (array.rows < 0)
  {
    refuse(".rows is negative");
  }
  if (array.rows > 0 && !array.data)
  {
    refuse(".data is null");
  }
  if (array.stride != 0 && array.stride < width)
  {
    refuse(".stride is less than the numbers of a row");
  }
  if (array.rows > 0 &&
      std::max(array.stride, width) > std::numeric_limits<std::int64_t>::max() / 8 / array.rows)
  {
    refuse(".rows and .stride exceed the memory");
  }
}

template <class View> View viewOf(const winding_array& array, std::int64_t width, const char* name)
{
  checkArray(array, width, name);
  if (array.rows == 0)
  {
    return View();
  }
  const auto rows = static_cast<std::size_t>(array.rows);
  const auto stride = static_cast<std::size_t>(array.stride == 0 ? width : array.stride);
  if (array.type == WINDING_FLOAT32)
  {
    return View(static_cast<const float*>(array.data), rows, stride);
  }
  if (array.type == WINDING_FLOAT64)
  {
    return View(static_cast<const double*>(array.data), rows, stride);
  }
  throw Misuse(std::string(name) + ".type is no type of floating-point numbers");
}

/// The setting that a message is about, or that it proposes first.
const Setting* settingOf(const Message& message)
{
  for (const Remedy& remedy : message.remedies)
  {
    if (!remedy.settings.empty())
    {
      return &remedy.settings.front();
    }
  }
  return nullptr;
}

} // namespace

Ids::Ids(const winding_array& array, std::int64_t width, const char* name)
  : array_(array)
  , stride_(array.stride == 0 ? width : array.stride)
{
  checkArray(array, width, name);
  if (array.rows > 0 && array.type != WINDING_INT32 && array.type != WINDING_INT64)
  {
    throw Misuse(std::string(name) + ".type is no type of ids");
  }
}

IdsView idsOf(const winding_array& array, const char* name)
{
  const Ids checked(array, 1, name);
  const auto stride = static_cast<std::size_t>(std::max<std::int64_t>(array.stride, 1));
  return array.type == WINDING_INT32
           ? IdsView(static_cast<const std::int32_t*>(array.data), checked.rows(), stride)
           : IdsView(static_cast<const std::int64_t*>(array.data), checked.rows(), stride);
}

void copyText(const std::string& text, char* to, std::size_t size)
{
  std::size_t length = std::min(text.size(), size - 1);
  // A character of several bytes is not cut.
  while (length < text.size() && length > 0 && (text[length] & 0xC0) == 0x80)
  {
    --length;
  }
  std::memcpy(to, text.data(), length);
  to[length] = 0;
}

void giveBounds(const Bounds& bounds, double (&to)[6])
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (int axis = 0; axis < 3; ++axis)
  {
    to[2 * axis] = bounds.isEmpty() ? none : bounds.min()[axis];
    to[2 * axis + 1] = bounds.isEmpty() ? none : bounds.max()[axis];
  }
}

winding_run defaultRun()
{
  winding_run run = {};
  run.size = sizeof run;
  run.words = WINDING_WORDS_C;
  run.interval = 0.05;
  return run;
}

winding_options defaultOptions()
{
  const FieldOptions standard;
  winding_options options = {};
  options.size = sizeof options;
  options.method = static_cast<std::int32_t>(standard.method);
  options.tolerance = standard.tolerance;
  options.number_of_neighbors = standard.neighbors;
  options.normal_estimation = static_cast<std::int32_t>(standard.normalEstimation);
  return options;
}

winding_rule defaultRule()
{
  winding_rule rule = {};
  rule.size = sizeof rule;
  rule.inside_rule = WINDING_INSIDE_RULE_SIGNED;
  rule.winding_threshold = 0.5;
  return rule;
}

VectorsView vectorsOf(const winding_array& array, const char* name)
{
  return viewOf<VectorsView>(array, 3, name);
}

ScalarsView scalarsOf(const winding_array& array, const char* name)
{
  return viewOf<ScalarsView>(array, 1, name);
}

void Triangles::weld(double tolerance, Executor& executor)
{
  if (tolerance > 0)
  {
    welded_ = snappedPoints({view_.points}, tolerance, executor).front();
    view_.points = VectorsView(welded_.data(), view_.points.size());
  }
}

Triangles::Triangles(const winding_array& points, const winding_polygons* polygons)
{
  const winding_polygons& given = required(polygons, "polygons");
  view_.points = vectorsOf(points, "points");
  const bool areTriangles = !given.offsets.data && given.offsets.rows == 0;
  if (areTriangles)
  {
    const Ids corners(given.corners, 3, "polygons.corners");
    const bool arePacked = given.corners.stride == 0 || given.corners.stride == 3;
    if (arePacked && given.corners.type == WINDING_INT32)
    {
      view_.triangles = {static_cast<const std::int32_t*>(given.corners.data), corners.rows()};
      return;
    }
    if (arePacked && given.corners.type == WINDING_INT64)
    {
      view_.triangles = {static_cast<const std::int64_t*>(given.corners.data), corners.rows()};
      return;
    }
    for (std::size_t row = 0; row < corners.rows(); ++row)
    {
      ids_.insert(ids_.end(), {corners(row, 0), corners(row, 1), corners(row, 2)});
    }
  }
  else
  {
    const Ids corners(given.corners, 1, "polygons.corners");
    const Ids offsets(given.offsets, 1, "polygons.offsets");
    starts_.push_back(0);
    for (std::size_t polygon = 0; polygon + 1 < offsets.rows(); ++polygon)
    {
      const std::int64_t first = offsets(polygon, 0), last = offsets(polygon + 1, 0);
      if (first < 0 || last < first || last > given.corners.rows)
      {
        throw Misuse("polygons.offsets do not ascend from 0 to the rows of polygons.corners");
      }
      for (std::int64_t corner = first + 2; corner < last; ++corner)
      {
        ids_.insert(ids_.end(), {corners(static_cast<std::size_t>(first), 0),
                                  corners(static_cast<std::size_t>(corner - 1), 0),
                                  corners(static_cast<std::size_t>(corner), 0)});
        isContinued_.push_back(static_cast<char>(corner > first + 2));
      }
      starts_.push_back(isContinued_.size());
    }
    view_.isContinued = isContinued_.data();
  }
  view_.triangles = {ids_.data(), ids_.size() / 3};
}

bool Triangles::isKept(std::size_t triangle) const
{
  return isUsable(view_, triangle);
}

InsideTest insideTestOf(const winding_rule* rule)
{
  const winding_rule inside = known(rule, defaultRule());
  checkProperty(Parameter::insideRule, inside.inside_rule);
  checkProperty(Parameter::windingThreshold, inside.winding_threshold);
  return {static_cast<InsideRule>(inside.inside_rule), inside.winding_threshold};
}

FieldOptions optionsOf(const winding_options* options)
{
  const winding_options wished = known(options, defaultOptions());
  checkProperty(Parameter::method, wished.method);
  checkProperty(Parameter::tolerance, wished.tolerance);
  checkProperty(Parameter::regularization, wished.regularization);
  checkProperty(Parameter::pointArea, wished.point_area);
  checkProperty(Parameter::numberOfNeighbors, wished.number_of_neighbors);
  checkProperty(Parameter::normalEstimation, wished.normal_estimation);
  FieldOptions result;
  result.method = static_cast<Method>(wished.method);
  result.tolerance = wished.tolerance;
  result.regularization = wished.regularization;
  result.pointAreaMethod = wished.point_area > 0 || wished.mean_point_area != 0
                             ? PointAreaMethod::constant
                             : PointAreaMethod::voronoi;
  result.pointArea = wished.point_area;
  result.neighbors = wished.number_of_neighbors;
  result.estimateNormals = wished.estimate_normals != 0;
  result.normalEstimation = static_cast<NormalEstimation>(wished.normal_estimation);
  result.toward = wished.toward ? wished.toward : "";
  result.lookAtViewpoints = wished.look_at_viewpoints != 0;
  result.mirror = wished.mirror ? wished.mirror : "";
  result.weldTolerance = toleranceOf(options);
  result.flatBase = wished.flat_base ? wished.flat_base : "";
  result.sheetSide = wished.sheet_side ? wished.sheet_side : "";
  result.mendsSource = wished.mend_source != 0;
  result.orientFaces = wished.orient_faces != 0;
  result.ignoreOpenParts = wished.ignore_open_parts != 0;
  result.scattered = wished.scattered != 0;
  result.isOneOfSeveral = wished.is_one_of_several != 0;
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const Eigen::Matrix3d inverseAxes = wished.frame
                                        ? Eigen::Matrix3d(Eigen::Map<const RowMajor>(wished.frame))
                                        : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  const Eigen::Vector3d origin =
    wished.frame ? Eigen::Vector3d(wished.frame + 9) : Eigen::Vector3d(0, 0, 0);
  const FieldOptions inFrame = optionsAlong(result, inverseAxes, origin); // refuses wrong texts
  return wished.frame ? inFrame : result;
}

double toleranceOf(const winding_options* options)
{
  const double tolerance = known(options, defaultOptions()).weld_tolerance;
  checkProperty(Parameter::weldTolerance, tolerance);
  return tolerance;
}

Grid gridOf(const winding_grid* grid)
{
  const winding_grid& given = required(grid, "grid");
  Grid result;
  for (int axis = 0; axis < 3; ++axis)
  {
    result.firstSample[axis] = given.origin[axis];
    result.spacing[axis] = given.spacing[axis];
    result.dimensions[axis] = given.dimensions[axis];
    if (!std::isfinite(given.origin[axis]) || !(given.spacing[axis] > 0) ||
        !std::isfinite(given.spacing[axis]) || given.dimensions[axis] < 1)
    {
      throw Misuse("grid has an axis without samples, or with spacing that is not more than 0");
    }
  }
  checkGrid(result);
  return result;
}

void Call::warn(const Message& message) const
{
  if (run_.warn)
  {
    run_.warn((prefix_ + lineOf(message, frontEndOf(&run_))).c_str(), run_.user);
  }
}

void Call::warn(const std::vector<Message>& messages) const
{
  for (const Message& message : messages)
  {
    this->warn(message);
  }
}

FrontEnd frontEndOf(const winding_run* run)
{
  switch (run ? known(run, defaultRun()).words : WINDING_WORDS_C)
  {
  case WINDING_WORDS_PYTHON:
    return FrontEnd::python;
  case WINDING_WORDS_PARAVIEW:
    return FrontEnd::paraview;
  default:
    return FrontEnd::c;
  }
}

void write(winding_refusal* refusal, const char* parameter, const std::string& text)
{
  if (refusal)
  {
    copyText(parameter, refusal->parameter, sizeof refusal->parameter);
    copyText(text, refusal->text, sizeof refusal->text);
  }
}

void write(winding_refusal* refusal, const Message& message, const winding_run* run)
{
  const Setting* proposed = settingOf(message);
  const std::string parameter = message.subject ? nameOf(*message.subject, FrontEnd::c)
                                : proposed      ? nameOf(proposed->parameter, FrontEnd::c)
                                                : std::string();
  write(refusal, parameter.c_str(), lineOf(message, frontEndOf(run)));
}

} // namespace winding::c
