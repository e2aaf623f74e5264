// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FieldValues.h"
#include "RandomSources.h"

#include "base/Pi.h"
#include "base/Refusal.h"
#include "source/Sanitize.h"
#include "sums/ReferenceSum.h"
#include "support/NaiveDistance.h"
#include "support/Serial.h"
#include "support/Shuffled.h"

#include <algorithm>
#include <cmath>
#include <limits>

/**
 * @file
 * Every method is compared with the definition in long double, and with itself on the same
 * triangles, written in another way, to the bit. Samples that lie on a triangle as far as
 * coordinates can tell must be finite only.
 */
namespace fuzz
{

namespace
{

using namespace winding;
using shapes::Mesh;
using shapes::Point;
using shapes::serial;

/// Samples nearer to a triangle, in sizes of coordinates, may be on either side of it.
constexpr double onSurface = 0x1p-42;

/// A sample as it is known without any method.
struct Place
{
  double distance = std::numeric_limits<double>::infinity(); ///< from the nearest triangle
  double strength = 0; ///< sum of the sizes of all triangles' shares of w
  double rounding = 0; ///< how much rounding alone may change w
  bool isOff = true;   ///< whether no triangle is so near that the sample may be on either side
};

/// The samples of a grid or scattered ones.
struct Samples
{
  std::vector<Point> positions;
  double size = 0; ///< largest coordinate of the samples and the surface
  std::vector<Place> places;
  std::vector<double> exact; ///< values by definition
};

std::shared_ptr<const Field> build(
  const Mesh& mesh, Method method, double tolerance, bool scattered = false)
{
  FieldOptions options;
  options.method = method;
  options.tolerance = tolerance;
  options.scattered = scattered;
  return Field::build(viewsOf(mesh), options, serial);
}

double largestCoordinate(const std::vector<Point>& points)
{
  double largest = 0;
  for (const Point& point : points)
  {
    largest = std::max(largest, point.cwiseAbs().maxCoeff());
  }
  return largest;
}

/**
 * Adds what a triangle may do to a sample. Coordinates are right to some 2⁻⁵² of `size`: a triangle
 * that moves by as much changes w by that over its distance, and so does rounding (DirectSum.h).
 */
void addTriangle(const Point (&corners)[3], const Point& sample, double size, Place& place)
{
  using Vector = Eigen::Matrix<long double, 3, 1>;
  const double distance = shapes::naiveDistance(sample, corners[0], corners[1], corners[2]);
  place.distance = std::min(place.distance, distance);
  place.isOff = place.isOff && distance > onSurface * size;
  const auto seen = [&](int i) -> Vector
  {
    const Vector offset = corners[i].cast<long double>() - sample.cast<long double>();
    const long double length = offset.stableNorm();
    return length > 0 ? Vector(offset / length) : offset;
  };
  const Vector a = seen(0), b = seen(1), c = seen(2);
  const long double numerator = a.dot(b.cross(c));
  const long double denominator = 1 + a.dot(b) + b.dot(c) + c.dot(a);
  place.strength += std::abs(static_cast<double>(std::atan2(numerator, denominator))) / (2 * pi);
  place.rounding += 0x1p-46 * size / distance;
}

void measure(const Surface& surface, Samples& samples)
{
  samples.size =
    std::max(largestCoordinate(surface.vertices), largestCoordinate(samples.positions));
  for (const Point& sample : samples.positions)
  {
    Place place;
    for (const Triangle& t : surface.triangles)
    {
      const Point corners[] = {
        surface.vertices[t[0]], surface.vertices[t[1]], surface.vertices[t[2]]};
      addTriangle(corners, sample, samples.size, place);
    }
    samples.places.push_back(place);
    samples.exact.push_back(static_cast<double>(referenceSum<long double>(surface, sample)));
  }
}

std::string compareDistances(const Samples& samples, const std::vector<double>& distances)
{
  std::vector<double> expected;
  for (const Place& place : samples.places)
  {
    expected.push_back(place.distance);
  }
  return compare("distance", samples.positions, distances, expected,
    [&](std::size_t) { return 0x1p-40 * samples.size; });
}

/// Compares values of a method with the definition.
std::string compareWithDefinition(const Field& field, const Surface& surface,
  const Samples& samples, const std::vector<double>& values, double tolerance,
  const std::string& where)
{
  std::vector<double> expected = samples.exact;
  const bool isParity = field.info().method == Method::parity;
  const bool isDirect = field.info().method == Method::direct;
  const bool isClosed = field.info().netBoundaryEdges == 0;
  for (double& value : expected)
  {
    value = isParity ? std::fmod(std::abs(std::round(value)), 2) : value;
  }
  const auto triangles = static_cast<double>(surface.triangles.size());
  return compare(nameOf(field.info().method) + where, samples.positions, values, expected,
    [&](std::size_t i)
    {
      const Place& place = samples.places[i];
      if (!place.isOff || (isParity && !isClosed))
      {
        return triangles + 1;
      }
      // The far field is in single precision beyond the nearest triangles.
      const double approximation = isDirect ? 0 : tolerance + 2e-7 * place.strength;
      return isParity ? 0 : 1e-12 + place.rounding + approximation;
    });
}

std::string checkIntegers(const std::vector<double>& values)
{
  const bool areIntegers = std::all_of(
    values.begin(), values.end(), [](double value) { return value == std::round(value); });
  return areIntegers ? std::string() : "rows of a closed surface give values that are no integers";
}

/// All that a field gives on a grid and at scattered samples.
struct FoundValues
{
  FieldValues onGrid, atSamples;
};

/// Compares a method's field with the definition, on a grid and at scattered samples.
std::string checkMethod(Choices& choices, const Field& field, const Grid& grid,
  const Samples& onGrid, const Samples& scattered, double tolerance, const FoundValues& found)
{
  const Surface& surface = *field.surface();
  const FieldValues &grids = found.onGrid, &others = found.atSamples;
  for (const std::string& failure : {grids.failure, others.failure,
         compareDistances(onGrid, grids.distances), compareDistances(scattered, others.distances),
         compareWithDefinition(field, surface, onGrid, grids.values, tolerance, " on the grid"),
         compareWithDefinition(field, surface, scattered, others.values, tolerance, " at samples"),
         checkBits(choices, field, grid, grids, scattered.positions, others),
         checkGradients(field, scattered.positions), checkNonFinite(field)})
  {
    if (!failure.empty())
    {
      return failure;
    }
  }
  return field.info().method == Method::rows && field.info().netBoundaryEdges == 0
           ? checkIntegers(grids.values) + checkIntegers(others.values)
           : std::string();
}

/// Compares a field with that of the same triangles, written in another way.
std::string checkOrder(Choices& choices, const Mesh& mesh, Method method, double tolerance,
  const Grid& grid, const std::vector<Point>& samples, const FoundValues& found)
{
  const Mesh other =
    shapes::shuffled(mesh, [&](std::size_t count) { return choices.below(count); });
  const auto field = build(other, method, tolerance);
  return checkShuffled(*field, grid, found.onGrid, samples, found.atSamples);
}

/// A surface announced for scattered samples, which rows take, too.
std::string checkScattered(const Mesh& mesh, const Samples& scattered, double tolerance)
{
  for (const Method method : {Method::automatic, Method::rows})
  {
    try
    {
      const auto field = build(mesh, method, tolerance, true);
      const FieldValues found = valuesOf(*field, scattered.positions, false, serial);
      std::string failure = compareWithDefinition(
        *field, *field->surface(), scattered, found.values, tolerance, " for scattered samples");
      if (!failure.empty())
      {
        return failure;
      }
    }
    catch (const Refusal& refusal)
    {
      return std::string("refused: ") + refusal.what();
    }
  }
  return {};
}

} // namespace

std::string checkSurfaceField(Choices& choices)
{
  const Mesh mesh = randomMesh(choices, choices.oneIn(50) ? 300 : choices.oneIn(4) ? 24 : 12);
  const double tolerance = randomTolerance(choices);
  const Method methods[] = {
    Method::direct, Method::rows, Method::hierarchical, Method::automatic, Method::parity};
  const Method method = choices.oneOf(methods);
  std::shared_ptr<const Field> field;
  try
  {
    field = build(mesh, method, tolerance);
  }
  catch (const Refusal& refusal)
  {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
      if (isUsable(mesh.view(), i))
      {
        return std::string("a surface with usable triangles is refused: ") + refusal.what();
      }
    }
    return {};
  }
  const Surface& surface = *field->surface();
  if (surface.triangles.empty())
  {
    return {};
  }
  const Grid grid = randomGrid(choices, surface.bounds);
  Samples onGrid, scattered;
  onGrid.positions = samplesOf(grid);
  scattered.positions = randomSamples(choices, surface.vertices, 1 + choices.below(24));
  measure(surface, onGrid);
  measure(surface, scattered);
  const FoundValues found = {valuesOf(*field, grid, grid.wholeExtent(), true, serial),
    valuesOf(*field, scattered.positions, true, serial)};
  std::string failure = checkMethod(choices, *field, grid, onGrid, scattered, tolerance, found);
  if (failure.empty() && choices.oneIn(3))
  {
    failure = checkScattered(mesh, scattered, tolerance);
  }
  return failure.empty()
           ? checkOrder(choices, mesh, method, tolerance, grid, scattered.positions, found)
           : failure;
}

} // namespace fuzz
