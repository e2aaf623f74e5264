#include "Checks.h"
#include "FieldValues.h"
#include "RandomSources.h"

#include "level/LevelRoots.h"

#include <algorithm>
#include <cmath>

/**
 * @file
 * The edges of a grid that a level crosses are compared with the sides of its samples, whatever the
 * slabs; the roots on them lie on their edges, are the same for every executor and are found in few
 * rounds.
 */
namespace fuzz
{

namespace
{

using namespace winding;

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
  const InsideRule rule = randomRule(choices);
  const double threshold = randomThreshold(choices);
  const bool border = choices.oneIn(2);
  SerialExecutor serial;
  BackwardExecutor backward;

  LevelEdges edges(*field, grid, rule, threshold, border);
  LevelEdges slabs(*field, grid, rule, threshold, border, 1);
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
  output.rule = rule;
  output.threshold = threshold;
  field->evaluate(grid, grid.wholeExtent(), output, serial);
  if (countChanges(grid, inside, border) != edges.size())
  {
    return "there are other edges than the sides of the samples tell";
  }
  LevelRoots roots(*field, grid, edges, rule, threshold, 1e-3, serial);
  LevelRoots again(*field, grid, edges, rule, threshold, 1e-3, backward);
  const std::string failure = findRoots(roots, serial) + findRoots(again, backward);
  if (!failure.empty())
  {
    return failure;
  }
  const bool same = roots.roots().fractions == again.roots().fractions &&
                    roots.roots().normals == again.roots().normals;
  return same ? std::string() : "roots depend on the executor";
}

} // namespace fuzz
