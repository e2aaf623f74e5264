// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FieldValues.h"
#include "RandomSources.h"

#include "distance/SampleDistances.h"
#include "level/CombinedRoots.h"
#include "level/LevelRoots.h"
#include "level/ShapedSolid.h"
#include "support/Serial.h"

#include <algorithm>
#include <cmath>

/**
 * @file
 * The edges of a grid that a level crosses are compared with the sides of its samples, whatever the
 * slabs; the roots on them lie on their edges, are the same for every executor and are found in few
 * rounds. So are the edges of operations on several sources, with the answers at each sample, and
 * the shapes of solids, with each sample's own distance.
 */
namespace fuzz
{

namespace
{

using namespace winding;
using shapes::serial;

/// Rounds after which a search for roots does not end.
constexpr int mostRounds = 100;

/// The edges between samples on different sides, counted one by one.
std::size_t countChanges(const Grid& grid, const std::vector<unsigned char>& inside, bool border)
{
  std::size_t changes = 0;
  const Extent whole = grid.wholeExtent();
  for (std::size_t n = 0; n < inside.size(); ++n)
  {
    const Eigen::Vector3i at = sampleIndex(whole, n);
    for (int axis = 0; axis < 3; ++axis)
    {
      Eigen::Vector3i next = at;
      ++next[axis];
      changes += border && inside[n] && at[axis] == 0;
      changes += next[axis] < grid.dimensions[axis] ? inside[n] != inside[sampleNumber(whole, next)]
                                                    : border && inside[n];
    }
  }
  return changes;
}

void findEdges(LevelEdges& edges, Executor& executor)
{
  while (!edges.isDone())
  {
    edges.advance(executor);
  }
}

bool areSame(const LevelEdges& a, const LevelEdges& b)
{
  bool same = a.size() == b.size();
  for (std::size_t i = 0; same && i < a.size(); ++i)
  {
    same = a[i].sample == b[i].sample && a[i].axis == b[i].axis &&
           a[i].firstIsInside == b[i].firstIsInside;
  }
  return same;
}

std::string findRoots(LevelRoots& roots, Executor& executor)
{
  for (int round = 0; !roots.isDone(); ++round)
  {
    if (round > mostRounds)
    {
      return "the search for roots does not end";
    }
    roots.advance(executor);
  }
  for (const double fraction : roots.roots().fractions)
  {
    if (!(fraction >= 0 && fraction <= 1))
    {
      return "a root lies at " + std::to_string(fraction) + " of its edge";
    }
  }
  const bool areFinite = std::all_of(roots.roots().normals.begin(), roots.roots().normals.end(),
    [](const Eigen::Vector3f& normal) { return normal.allFinite(); });
  return areFinite ? std::string() : "a normal is not finite";
}

} // namespace

std::string checkLevel(Choices& choices)
{
  const auto field = randomField(choices);
  if (!field || field->info().primitives == 0)
  {
    return {};
  }
  const Grid grid = randomGrid(choices, field->info().bounds);
  const InsideTest isInside = {randomRule(choices), randomThreshold(choices)};
  const bool border = choices.oneIn(2);
  BackwardExecutor backward;

  LevelEdges edges(*field, grid, isInside, border);
  LevelEdges slabs(*field, grid, isInside, border, 1);
  findEdges(edges, serial);
  findEdges(slabs, backward);
  if (!areSame(edges, slabs))
  {
    return "edges depend on the slabs";
  }
  std::vector<unsigned char> inside(sampleCount(grid.wholeExtent()));
  std::vector<float> values(inside.size());
  FieldOutput output;
  output.inside = inside.data();
  output.values = values.data();
  output.isInside = isInside;
  field->evaluate(grid, grid.wholeExtent(), output, serial);
  if (countChanges(grid, inside, border) != edges.size())
  {
    return "there are other edges than the sides of the samples tell";
  }
  LevelRoots roots(*field, grid, edges, isInside, 1e-3, serial);
  LevelRoots again(*field, grid, edges, isInside, 1e-3, backward);
  const std::string failure = findRoots(roots, serial) + findRoots(again, backward);
  if (!failure.empty())
  {
    return failure;
  }
  const bool same = roots.roots().fractions == again.roots().fractions &&
                    roots.roots().normals == again.roots().normals;
  return same ? std::string() : "roots depend on the executor";
}

namespace
{

/// An operand of an operation, with the sides of all samples of a grid.
struct Operand
{
  Operand(std::shared_ptr<const Field> source, const Grid& grid, Choices& choices, bool border,
    Executor& executor)
    : field(std::move(source))
    , isInside{randomRule(choices), randomThreshold(choices)}
    , edges(*field, grid, isInside, border)
    , roots(0)
    , inside(sampleCount(grid.wholeExtent()))
  {
    findEdges(edges, executor);
    LevelRoots found(*field, grid, edges, isInside, 1e-3, executor);
    failure = findRoots(found, executor);
    roots = found.take();
    FieldOutput output;
    output.inside = inside.data();
    output.isInside = isInside;
    field->evaluate(grid, grid.wholeExtent(), output, executor);
  }

  std::shared_ptr<const Field> field;
  InsideTest isInside;
  LevelEdges edges;
  EdgeRoots roots;
  std::vector<unsigned char> inside;
  std::string failure;
};

/// The answers of an operation at each sample, by its definition.
std::vector<unsigned char> answersOf(
  BooleanOperation operation, const std::vector<std::unique_ptr<Operand>>& operands)
{
  std::vector<unsigned char> answers = operands.front()->inside;
  for (std::size_t n = 1; n < operands.size(); ++n)
  {
    for (std::size_t i = 0; i < answers.size(); ++i)
    {
      const bool before = answers[i] != 0, own = operands[n]->inside[i] != 0;
      answers[i] = operation == BooleanOperation::unite       ? before || own
                   : operation == BooleanOperation::intersect ? before && own
                   : operation == BooleanOperation::subtract  ? before && !own
                                                              : before != own;
    }
  }
  return answers;
}

/// Whether all edges lie between samples with these answers.
bool lieBetween(
  const LevelEdges& edges, const Grid& grid, const std::vector<unsigned char>& answers)
{
  const auto answer = [&](const std::array<int, 3>& sample)
  {
    const Eigen::Map<const Eigen::Vector3i> at(sample.data());
    return (at.array() >= 0).all() && (at.array() < grid.dimensions.array()).all() &&
           answers[sampleNumber(grid.wholeExtent(), at)] != 0;
  };
  for (std::size_t n = 0; n < edges.size(); ++n)
  {
    std::array<int, 3> next = edges[n].sample;
    ++next[edges[n].axis];
    if (answer(edges[n].sample) != edges[n].firstIsInside || answer(next) == edges[n].firstIsInside)
    {
      return false;
    }
  }
  return true;
}

} // namespace

std::string checkBoolean(Choices& choices)
{
  const bool border = choices.oneIn(2);
  BackwardExecutor backward;
  Grid grid;
  std::vector<std::unique_ptr<Operand>> operands;
  std::vector<const LevelEdges*> edges;
  std::vector<LevelOperand> parts;
  for (int n = choices.oneIn(3) ? 3 : 2; n > 0; --n)
  {
    auto field = randomField(choices);
    if (!field || field->info().primitives == 0)
    {
      return {};
    }
    grid = operands.empty() ? randomGrid(choices, field->info().bounds) : grid;
    operands.push_back(std::make_unique<Operand>(std::move(field), grid, choices, border, serial));
    if (!operands.back()->failure.empty())
    {
      return operands.back()->failure;
    }
    edges.push_back(&operands.back()->edges);
    parts.push_back({&operands.back()->edges, &operands.back()->roots});
  }
  for (const auto operation : {BooleanOperation::unite, BooleanOperation::intersect,
         BooleanOperation::subtract, BooleanOperation::exclude})
  {
    const LevelEdges result(edges, operation, grid, serial);
    const LevelEdges again(edges, operation, grid, backward);
    const std::vector<unsigned char> answers = answersOf(operation, operands);
    if (countChanges(grid, answers, border) != result.size() || !lieBetween(result, grid, answers))
    {
      return "there are other edges than the answers at samples tell";
    }
    const CombinedRoots combined(result, parts, operation, serial);
    const CombinedRoots other(again, parts, operation, backward);
    if (!areSame(result, again) || combined.roots.fractions != other.roots.fractions ||
        combined.operands != other.operands)
    {
      return "the result depends on the executor";
    }
    for (std::size_t n = 0; n < result.size(); ++n)
    {
      const LevelOperand& part = parts[combined.operands[n]];
      const std::size_t own = part.edges->find(result[n].sample, result[n].axis);
      if (own == part.edges->size() || part.roots->fractions[own] != combined.roots.fractions[n])
      {
        return "a root is not one of its operand's";
      }
    }
  }
  return {};
}

namespace
{

SolidShape randomShape(Choices& choices, double unit)
{
  SolidShape shape;
  shape.fillsCavities = choices.oneIn(3);
  shape.gapWidth = choices.oneIn(2) ? 0 : choices.between(0, 3) * unit;
  shape.offset = choices.oneIn(2) ? 0 : choices.between(-3, 3) * unit;
  shape.shell = choices.oneIn(2) ? 0 : choices.between(0, 3) * unit;
  shape.shellSide = static_cast<ShellSide>(choices.below(3));
  return shape;
}

/// The places of all samples of a grid, or of the roots of edges that are not at the border.
std::vector<double> placesOf(const Grid& grid)
{
  std::vector<double> places;
  for (std::size_t n = 0; n < sampleCount(grid.wholeExtent()); ++n)
  {
    const Eigen::Vector3d place = grid.sample(n);
    places.insert(places.end(), place.data(), place.data() + 3);
  }
  return places;
}

std::vector<double> placesOf(const Grid& grid, const LevelEdges& edges, const EdgeRoots& roots)
{
  std::vector<double> places;
  for (std::size_t n = 0; n < edges.size(); ++n)
  {
    if (!edges.isAtBorder(edges[n]))
    {
      const std::array<int, 3>& sample = edges[n].sample;
      Eigen::Vector3d steps(sample[0], sample[1], sample[2]);
      steps[edges[n].axis] += roots.fractions[n];
      const Eigen::Vector3d place = grid.firstSample + steps.cwiseProduct(grid.spacing);
      places.insert(places.end(), place.data(), place.data() + 3);
    }
  }
  return places;
}

/// How far a distance is off the nearer limit of a band.
double offLimits(const DistanceBand& band, double distance)
{
  return std::min(
    std::abs(distance - std::abs(band.low)), std::abs(distance - std::abs(band.high)));
}

} // namespace

std::string checkShape(Choices& choices)
{
  auto field = randomField(choices);
  if (!field || field->info().primitives == 0)
  {
    return {};
  }
  const Grid grid = randomGrid(choices, field->info().bounds);
  const bool border = choices.oneIn(2), isSharp = choices.oneIn(2);
  BackwardExecutor backward;
  const Operand solid(std::move(field), grid, choices, border, serial);
  const SolidShape shape = randomShape(choices, grid.spacing.maxCoeff());
  const auto make = [&](Executor& executor)
  {
    return std::make_unique<const ShapedSolid>(
      *solid.field, grid, solid.isInside, 1e-3, solid.edges, solid.roots, shape, isSharp, executor);
  };
  const auto shaped = make(serial), again = make(backward);
  if (!areSame(shaped->edges(), again->edges()) ||
      shaped->roots().fractions != again->roots().fractions ||
      shaped->roots().normals != again->roots().normals)
  {
    return "the shape depends on the executor";
  }
  for (const double fraction : shaped->roots().fractions)
  {
    if (!(fraction >= 0 && fraction <= 1))
    {
      return "a root of the shape lies at " + std::to_string(fraction) + " of its edge";
    }
  }
  if (!shape.hasDistances())
  {
    return {};
  }
  const bool isFromSource = shaped->base() == DistanceBase::source;
  const DistanceTree& tree =
    isFromSource ? solid.field->distanceTree(serial) : *shaped->surfaceTree();
  const bool isSheet = isFromSource && !solid.field->info().jumpsOnly();
  std::unique_ptr<const FilledCavities> filled;
  if (shape.fillsCavities)
  {
    filled = std::make_unique<const FilledCavities>(
      solid.edges, solid.roots, grid, shape.gapWidth, &solid.field->distanceTree(serial), serial);
  }
  const LevelEdges& own = filled ? *filled->edges : solid.edges;
  const DistanceBand band = shape.band();
  const double size = (grid.spacing.cwiseProduct(grid.dimensions.cast<double>())).norm() +
                      grid.firstSample.cwiseAbs().maxCoeff();
  const std::vector<double> places = placesOf(grid);
  const std::vector<double> distances =
    distancesFrom(tree, VectorsView(places.data(), places.size() / 3), serial);
  for (std::size_t n = 0; n < distances.size(); ++n)
  {
    const Eigen::Vector3i at = sampleIndex(grid.wholeExtent(), n);
    const std::array<int, 3> sample = {at[0], at[1], at[2]};
    const bool isInside = !isSheet && own.isSampleInside(sample);
    const bool isClear = offLimits(band, distances[n]) > 1e-12 * (distances[n] + size);
    if (isClear && shaped->edges().isSampleInside(sample) != band.contains(isInside, distances[n]))
    {
      return "a sample of the shape is not on the side of its distance";
    }
  }
  // Roots on the solid's own surface lie where its roots do.
  if (!isFromSource || tree.empty() || band.low == 0 || band.high == 0)
  {
    return {};
  }
  const std::vector<double> roots = placesOf(grid, shaped->edges(), shaped->roots());
  for (const double distance :
    distancesFrom(tree, VectorsView(roots.data(), roots.size() / 3), serial))
  {
    if (offLimits(band, distance) > 1e-5 * grid.spacing.maxCoeff() + 1e-12 * size)
    {
      return "a root of the shape is off its distance by " +
             std::to_string(offLimits(band, distance) / grid.spacing.maxCoeff()) + " voxels";
    }
  }
  return {};
}

} // namespace fuzz
