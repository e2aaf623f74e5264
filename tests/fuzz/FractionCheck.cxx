// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FieldValues.h"
#include "RandomSources.h"
#include "support/Serial.h"

#include "voxels/CellFractions.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

/**
 * @file
 * The shares of random cells are compared with those of their parts, which add up, and with samples
 * of the field in them. They lie between 0 and 1, and do not depend on the executor, or on other
 * cells where w changes at triangles only.
 */
namespace fuzz
{

namespace
{

using namespace winding;
using shapes::Point;
using shapes::serial;

constexpr int tetrahedron = 10, hexahedron = 12;

class CellList final : public CellShapes
{
public:
  std::size_t size() const override { return shapes_.size(); }
  void get(std::size_t cell, CellShape& shape) const override { shape = shapes_[cell]; }
  void add(int type, std::vector<Point> points)
  {
    CellShape shape;
    shape.points = std::move(points);
    shape.addFacesOf(type);
    shapes_.push_back(std::move(shape));
  }

private:
  std::vector<CellShape> shapes_;
};

/// A parallelepiped: a corner, and its sides as columns.
struct Block
{
  Point corner;
  Eigen::Matrix3d sides;

  Point at(double x, double y, double z) const { return corner + sides * Point(x, y, z); }

  /// The corners of the part from `low` to `high` along the first side, in VTK's order.
  std::vector<Point> corners(double low, double high) const
  {
    return {at(low, 0, 0), at(high, 0, 0), at(high, 1, 0), at(low, 1, 0), at(low, 0, 1),
      at(high, 0, 1), at(high, 1, 1), at(low, 1, 1)};
  }
};

/// A block near a source: along the axes or not, from the size of the source to a thousandth, often
/// with corners at vertices.
Block randomBlock(Choices& choices, const Field& field)
{
  const Bounds& bounds = field.info().bounds;
  const double size = bounds.sizes().maxCoeff() > 0 ? bounds.sizes().maxCoeff() : 1;
  const double length = size * std::pow(10.0, -choices.between(-0.3, 3));
  Block block;
  const Surface* const surface = field.surface();
  block.corner = surface && choices.oneIn(3)
                   ? surface->vertices[choices.below(surface->vertices.size())]
                   : (bounds.min() + choices.between(-0.2, 1) * bounds.sizes()).eval();
  if (choices.oneIn(2))
  {
    block.sides = (length * choices.point(0.2, 1)).asDiagonal();
    return block;
  }
  for (int i = 0; i < 3; ++i)
  {
    block.sides.col(i) = length * choices.point(-1, 1);
  }
  return block;
}

/// The share of random samples of a block that are inside, and how many there are.
std::pair<double, int> sampledShare(
  Choices& choices, const Field& field, const Block& block, const InsideTest& isInside)
{
  constexpr int count = 500;
  std::vector<Point> samples;
  for (int i = 0; i < count; ++i)
  {
    const Point at = choices.point(0, 1);
    samples.push_back(block.at(at[0], at[1], at[2]));
  }
  std::vector<unsigned char> inside(samples.size());
  FieldOutput output;
  output.inside = inside.data();
  output.isInside = isInside;
  field.evaluate(VectorsView(samples[0].data(), samples.size()), output, serial);
  return {static_cast<double>(std::count(inside.begin(), inside.end(), 1)) / count, count};
}

std::string numbersOf(double a, double b)
{
  return std::to_string(a) + " and " + std::to_string(b);
}

} // namespace

std::string checkFractions(Choices& choices)
{
  const auto field = randomField(choices);
  if (!field || field->info().primitives == 0)
  {
    return {};
  }
  const InsideTest isInside = {randomRule(choices), randomThreshold(choices)};
  const Block block = randomBlock(choices, *field);
  const double part = choices.between(0.1, 0.9);
  CellList cells;
  cells.add(hexahedron, block.corners(0, 1));
  cells.add(hexahedron, block.corners(0, part));
  cells.add(hexahedron, block.corners(part, 1));
  const std::vector<Point> corners = block.corners(0, 1);
  for (const auto& [a, b] : {std::pair(1, 2), {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}})
  {
    cells.add(tetrahedron, {corners[0], corners[static_cast<std::size_t>(a)],
                             corners[static_cast<std::size_t>(b)], corners[6]});
  }
  BackwardExecutor backward;
  std::vector<float> fractions(cells.size()), again(cells.size());
  const CellsWithoutFraction counts =
    evaluateFractions(*field, cells, isInside, fractions.data(), serial);
  evaluateFractions(*field, cells, isInside, again.data(), backward);
  if (fractions != again)
  {
    return "fractions depend on the executor";
  }
  if (!std::all_of(fractions.begin(), fractions.end(), [](float f) { return f >= 0 && f <= 1; }))
  {
    return "a fraction is not between 0 and 1";
  }
  const double size = block.sides.colwise().norm().maxCoeff();
  const double volume = std::abs((block.sides / size).determinant());
  // Corners are rounded, to what may be much where a block is far from the origin.
  const double rounding =
    corners[0].cwiseAbs().maxCoeff() / size * std::numeric_limits<double>::epsilon();
  // A ray of method parity that meets an edge counts it as often as it may.
  if (counts.flat > 0 || volume < 1e-4 || rounding > 1e-9 || field->info().method == Method::parity)
  {
    return {};
  }
  const double whole = fractions[0];
  if (field->info().jumpsOnly())
  {
    const double ofTwo = part * fractions[1] + (1 - part) * fractions[2];
    double ofSix = 0;
    for (std::size_t i = 3; i < cells.size(); ++i)
    {
      ofSix += fractions[i] / 6.0;
    }
    // Meshes flattened to a billionth, with layers nearer to each other than rounding, miss 2e-6.
    if (std::abs(ofTwo - whole) > 1e-5 || std::abs(ofSix - whole) > 1e-5)
    {
      return "parts do not add up: " + numbersOf(whole, ofTwo) + ", " + numbersOf(whole, ofSix);
    }
  }
  // At points of clouds w has no bound, and changes from even to odd and back without end.
  if (isInside.rule == InsideRule::odd && !field->info().jumpsOnly())
  {
    return {};
  }
  // Six standard deviations, and what is interpolated near holes and points.
  const auto [sampled, count] = sampledShare(choices, *field, block, isInside);
  const double deviation = std::sqrt(std::max(whole * (1 - whole), 1.0 / count) / count);
  const double limit = 6 * deviation + (field->info().jumpsOnly() ? 0 : 0.5);
  return std::abs(sampled - whole) > limit
           ? "samples give another share: " + numbersOf(sampled, whole)
           : std::string();
}

} // namespace fuzz
