// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/Shells.h"

#include "base/Pi.h"
#include "surface/UsesByAngle.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>
#include <utility>

namespace winding
{

namespace
{

/// Returns a side of a triangle: the one that faces the triangles that come next around an edge, by
/// angles that grow, or the one that faces those before. `sense` is a sense of SurfaceEdges::Use.
std::int32_t sideOf(std::int32_t triangle, std::int32_t sense, bool facesNext)
{
  const bool isFront = (sense > 0) == facesNext;
  return 2 * triangle + (isFront ? 0 : 1);
}

} // namespace

Shells::Shells(const Surface& surface, const SurfaceEdges& edges)
  : sets_(2 * surface.triangles.size())
{
  std::vector<std::int32_t> unclearSides;
  for (const SurfaceEdges::Rim& rim : edges.rims)
  {
    sets_.unite(2 * rim.triangle, 2 * rim.triangle + 1);
  }
  for (const SurfaceEdges::Pair& pair : edges.pairs)
  {
    // Fronts see fronts where the triangles agree.
    const std::int32_t front = 2 * pair.triangles[0], other = 2 * pair.triangles[1];
    sets_.unite(front, other + (pair.agrees ? 0 : 1));
    sets_.unite(front + 1, other + (pair.agrees ? 1 : 0));
  }
  for (const SurfaceEdges::Crowd& crowd : edges.crowds)
  {
    this->joinAround(surface, edges, crowd, unclearSides);
  }
  this->measure(surface, unclearSides);
}

/// Unites the sides that face each other around an edge. Notes sides where the order is not clear.
void Shells::joinAround(const Surface& surface, const SurfaceEdges& edges,
  const SurfaceEdges::Crowd& crowd, std::vector<std::int32_t>& unclearSides)
{
  const std::vector<AngledUse> uses = usesByAngle(surface, edges, crowd);
  for (std::size_t i = 0; i < uses.size(); ++i)
  {
    const bool isLast = i + 1 == uses.size();
    const AngledUse &here = uses[i], &next = uses[isLast ? 0 : i + 1];
    const std::int32_t side = sideOf(here.use.triangle, here.use.sense, true);
    const std::int32_t facing = sideOf(next.use.triangle, next.use.sense, false);
    sets_.unite(side, facing);
    const double between = next.angle - here.angle + (isLast ? 2 * pi : 0);
    if (!here.hasDirection || !next.hasDirection || between < leastAngle)
    {
      unclearSides.insert(unclearSides.end(), {side, side ^ 1, facing ^ 1});
    }
  }
}

/// Finds the shells round bounded regions: the volumes within are negative seen from there.
void Shells::measure(const Surface& surface, const std::vector<std::int32_t>& unclearSides)
{
  const std::size_t sides = 2 * surface.triangles.size();
  shells_.resize(sides);
  std::vector<double> volumes(sides, 0), sizes(sides, 0);
  for (std::size_t side = 0; side < sides; ++side)
  {
    const std::int32_t shell = sets_.find(static_cast<std::int32_t>(side));
    shells_[side] = shell;
    const Triangle& t = surface.triangles[side / 2];
    const Eigen::Vector3d& origin = surface.vertices[surface.triangles[shell / 2][0]];
    const double volume =
      (surface.vertices[t[0]] - origin)
        .dot((surface.vertices[t[1]] - origin).cross(surface.vertices[t[2]] - origin));
    volumes[shell] += side % 2 == 0 ? volume : -volume;
    sizes[shell] += std::abs(volume);
  }
  constexpr double rounding = 1e-10;
  byVolume_.resize(sides, Region::unclear);
  for (std::size_t shell = 0; shell < sides; ++shell)
  {
    if (std::abs(volumes[shell]) > rounding * sizes[shell])
    {
      byVolume_[shell] = volumes[shell] < 0 ? Region::solid : Region::empty;
    }
  }
  for (const std::int32_t side : unclearSides)
  {
    byVolume_[shells_[side]] = Region::unclear;
  }
}

namespace
{

/// The step from the shell before a triangle to the one behind it, or back.
struct Step
{
  std::int32_t from, to;
  std::int32_t value;
  std::size_t triangles; ///< number of triangles with this step

  bool isAlike(const Step& step) const
  {
    return from == step.from && to == step.to && value == step.value;
  }
};

/// Returns distinct steps in order, each with the number of its triangles.
std::vector<Step> takenTogether(std::vector<Step> steps)
{
  std::sort(steps.begin(), steps.end(),
    [](const Step& a, const Step& b)
    { return std::tie(a.from, a.to, a.value) < std::tie(b.from, b.to, b.value); });
  std::size_t kept = 0;
  for (const Step& step : steps)
  {
    if (kept > 0 && steps[kept - 1].isAlike(step))
    {
      ++steps[kept - 1].triangles;
    }
    else
    {
      steps[kept++] = step;
    }
  }
  steps.resize(kept);
  return steps;
}

/// Keeps one step from each shell to each other: the most common one, the least of several.
void keepMostCommon(std::vector<Step>& steps)
{
  std::size_t kept = 0;
  for (const Step& step : steps)
  {
    if (kept == 0 || steps[kept - 1].from != step.from || steps[kept - 1].to != step.to)
    {
      steps[kept++] = step;
    }
    else if (step.triangles > steps[kept - 1].triangles)
    {
      steps[kept - 1] = step;
    }
  }
  steps.resize(kept);
}

constexpr std::int32_t unknown = std::numeric_limits<std::int32_t>::min();

/// Hands the numbers of shells on by steps, one step after the other from those that have one.
/// after(number, value) is the number behind a step, or unknown. Where several steps reach a shell
/// first, the most common one counts, and then the least number.
template <class After>
void propagate(
  const std::vector<Step>& steps, std::vector<std::int32_t>& numbers, const After& after)
{
  std::vector<std::int32_t> reached;
  for (std::size_t shell = 0; shell < numbers.size(); ++shell)
  {
    if (numbers[shell] != unknown)
    {
      reached.push_back(static_cast<std::int32_t>(shell));
    }
  }
  struct Found
  {
    std::int32_t shell, number;
    std::size_t triangles;
  };
  while (!reached.empty())
  {
    std::vector<Found> found;
    for (const std::int32_t from : reached)
    {
      const auto first = std::lower_bound(steps.begin(), steps.end(), from,
        [](const Step& step, std::int32_t shell) { return step.from < shell; });
      for (auto step = first; step != steps.end() && step->from == from; ++step)
      {
        const std::int32_t number = after(numbers[from], step->value);
        if (numbers[step->to] == unknown && number != unknown)
        {
          found.push_back({step->to, number, step->triangles});
        }
      }
    }
    std::sort(found.begin(), found.end(),
      [](const Found& a, const Found& b)
      {
        return std::make_tuple(a.shell, b.triangles, a.number) <
               std::make_tuple(b.shell, a.triangles, b.number);
      });
    reached.clear();
    for (const Found& next : found)
    {
      if (numbers[next.shell] == unknown)
      {
        numbers[next.shell] = next.number;
        reached.push_back(next.shell);
      }
    }
  }
}

} // namespace

std::vector<Shells::Region> Shells::regions(const std::vector<std::int32_t>& counts) const
{
  std::vector<Region> byShell = byVolume_;
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    const std::int32_t front = shells_[2 * i];
    if (front == shells_[2 * i + 1] && counts[i] % 2 == 1)
    {
      byShell[front] = Region::unclear;
    }
  }
  std::vector<Step> steps;
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    const std::int32_t front = shells_[2 * i], back = shells_[2 * i + 1];
    const bool isClear = byShell[front] != Region::unclear && byShell[back] != Region::unclear;
    if (counts[i] > 0 && front != back && isClear)
    {
      steps.push_back({front, back, counts[i], 1});
      steps.push_back({back, front, counts[i], 1});
    }
  }
  steps = takenTogether(std::move(steps));
  keepMostCommon(steps);
  std::vector<std::int32_t> numbers(shells_.size(), unknown);
  for (const std::int32_t shell : shells_)
  {
    if (byShell[shell] == Region::empty)
    {
      numbers[shell] = 0;
    }
  }
  propagate(steps, numbers,
    [](std::int32_t number, std::int32_t count)
    { return count >= number ? count - number : unknown; });
  DisjointSets reached(shells_.size());
  std::vector<std::int32_t> contradictions;
  for (const Step& step : steps)
  {
    if (numbers[step.from] != unknown)
    {
      reached.unite(step.from, step.to);
      const std::int32_t number = step.value - numbers[step.from];
      if (number < 0 || (number > 0) != (numbers[step.to] > 0))
      {
        contradictions.push_back(step.from);
      }
    }
  }
  std::vector<char> isUnclear(shells_.size(), 0);
  for (const std::int32_t shell : contradictions)
  {
    isUnclear[reached.find(shell)] = 1;
  }
  std::vector<Region> result;
  result.reserve(shells_.size());
  for (const std::int32_t shell : shells_)
  {
    result.push_back(numbers[shell] == unknown || isUnclear[reached.find(shell)] ? Region::unclear
                     : numbers[shell] == 0                                       ? Region::empty
                                                                                 : Region::solid);
  }
  return result;
}

std::vector<char> Shells::contradict(
  const std::vector<char>& isTurned, const std::vector<std::int32_t>& counts) const
{
  std::vector<Step> steps;
  DisjointSets connected(shells_.size());
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    const std::int32_t front = shells_[2 * i], back = shells_[2 * i + 1];
    if (counts[i] > 0)
    {
      const std::int32_t inward = isTurned[i] ? -1 : 1;
      steps.push_back({front, back, inward, 1});
      steps.push_back({back, front, -inward, 1});
      connected.unite(front, back);
    }
  }
  steps = takenTogether(std::move(steps));
  std::vector<std::int32_t> numbers(shells_.size(), unknown);
  for (std::size_t shell = 0; shell < numbers.size(); ++shell)
  {
    if (connected.find(static_cast<std::int32_t>(shell)) == static_cast<std::int32_t>(shell))
    {
      numbers[shell] = 0;
    }
  }
  propagate(steps, numbers, std::plus<>());
  std::vector<char> setContradicts(shells_.size(), 0), result(counts.size());
  for (const Step& step : steps)
  {
    setContradicts[connected.find(step.from)] |=
      static_cast<char>(numbers[step.to] != numbers[step.from] + step.value);
  }
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    result[i] = setContradicts[connected.find(shells_[2 * i])];
  }
  return result;
}

} // namespace winding
