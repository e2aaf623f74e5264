// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "diagnosis/GridAdvice.h"

#include "base/Digits.h"
#include "base/Refusal.h"

#include <cmath>
#include <string>
#include <vector>

namespace winding
{

std::optional<Message> gridAdvice(const Grid& grid, const Bounds& source, const GridResult& result)
{
  if (missesSource(grid, source))
  {
    return Message(
      "the grid misses the source", {{"choose a grid around it", {Parameter::samplingBounds}}});
  }
  const Eigen::Vector3d voxels = grid.inGridUnits(source.max()) - grid.inGridUnits(source.min());
  constexpr double fewest = 3 - 1e-9; // up to rounding
  int thinnest = -1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool isThin = voxels[axis] > 0 && voxels[axis] < fewest;
    if (isThin && (thinnest < 0 || voxels[axis] < voxels[thinnest]))
    {
      thinnest = axis;
    }
  }
  if (thinnest >= 0)
  {
    std::string facts = joined("it has ", inDigits(voxels[thinnest], 2), " of them along ",
      "xyz"[thinnest], result.isEmpty ? ", and no sample is inside" : "");
    if (const int needed = resolutionFor(source.sizes()[thinnest] / fewest, grid))
    {
      facts += "; a resolution of " + std::to_string(needed) + " would give it three";
    }
    return Message("the source is thinner than three voxels",
      {smallerVoxels(), {"name voxels along each axis", {Parameter::samplingDimensions}}}, facts);
  }
  if (result.parts && result.parts->areWorthTelling())
  {
    return thinPartsAdvice(*result.parts, grid, result.mayTouch);
  }
  if (result.isEmpty)
  {
    std::vector<Remedy> remedies;
    if (result.hasHighThreshold)
    {
      remedies.push_back(lowerThreshold());
    }
    if (!result.isSheet)
    {
      remedies.push_back(smallerVoxels());
      remedies.push_back({"choose a grid around the source", {Parameter::samplingBounds}});
    }
    remedies.push_back({"look whether the source is closed", {Parameter::surfaceReport}});
    if (result.mayTouch)
    {
      remedies.push_back(touchedVoxels());
    }
    return Message("no sample is inside", remedies);
  }
  if (result.parts && (result.parts->lostComponents > 0 || result.parts->lostPlace))
  {
    return thinPartsAdvice(*result.parts, grid, result.mayTouch);
  }
  constexpr double leastUnbound = 0.05;
  if (result.parts && result.parts->unboundShare >= leastUnbound)
  {
    return Message("open parts bound nothing, and are left out",
      {{"look which parts are open", {Parameter::surfaceReport}}},
      "about " + percentOf(result.parts->unboundShare) + " of the surface");
  }
  return std::nullopt;
}

Message crumbsNote(std::size_t crumbs, std::size_t pieces, std::size_t sourcePieces)
{
  return {"crumbs came out",
    sourcePieces >= pieces ? std::vector<Remedy>{smallerVoxels()} : std::vector<Remedy>(),
    std::to_string(crumbs) + " of " + std::to_string(pieces) + " parts have eight voxels or fewer"};
}

Message sparseFacesAdvice(double middle)
{
  return {"faces are too sparse for the threshold", {lowerThreshold()},
    "w is about " + inDigits(middle, 2) + " at them, which should be the threshold"};
}

void refuseFlatGrid(const Grid& grid)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (grid.dimensions[axis] < 2)
    {
      throw Refusal(Message(
        std::string("the grid has one voxel along ") + "xyz" [axis],
        {
          smallerVoxels(),
          {
            "choose more padding",
            {
              Parameter::padding
            }
          }
        },
        "a surface needs two or more"));
    }
  }
}

Message allInsideAdvice()
{
  return Message("all samples are inside, so the surface is empty",
    {{"close the border", {{Parameter::closeBorder, 1}}},
      {"choose a larger grid", {Parameter::padding, Parameter::samplingBounds}}});
}

Message emptyResultAdvice(bool mayMiss)
{
  std::vector<Remedy> remedies;
  if (mayMiss)
  {
    remedies.push_back({"see whether the solids meet", {}});
  }
  remedies.push_back(smallerVoxels());
  return Message("nothing is inside of the result, so the surface is empty", remedies);
}

Message openResultAdvice()
{
  return Message("the surface reaches the border of the grid, where it is open",
    {{"close the border", {{Parameter::closeBorder, 1}}},
      {"choose a larger grid", {Parameter::padding, Parameter::samplingBounds}}});
}

std::optional<Message> shapeAdvice(
  const Grid& grid, const SolidShape& shape, bool isEmpty, bool isAllInside)
{
  if (isAllInside)
  {
    return allInsideAdvice();
  }
  // A wall of this thickness has a sample on each of its lines through neighbours.
  const double thick = std::sqrt(3.0) * grid.spacing.maxCoeff();
  if (shape.shell > 0 && shape.shell < thick)
  {
    const std::string needed = resolutionFact(shape.shell / std::sqrt(3.0), grid);
    return Message("the shell is thinner than a voxel's diagonal, so it may have holes",
      {smallerVoxels(), {"choose a thicker shell", {Parameter::shell}}},
      joined("voxels are ", inDigits(grid.spacing.maxCoeff(), 3), " long") +
        (needed.empty() ? "" : "; " + needed));
  }
  if (isEmpty && shape.shell > 0 && shape.shellSide != ShellSide::centered && shape.offset == 0)
  {
    return Message("nothing is left of the solid, so the surface is empty",
      {{"thicken an open sheet on both sides",
         {{Parameter::shellSide, static_cast<int>(ShellSide::centered)}}},
        smallerVoxels()});
  }
  if (isEmpty && shape.hasDistances())
  {
    std::vector<Remedy> remedies = {smallerVoxels()};
    if (shape.offset < 0)
    {
      remedies.insert(remedies.begin(), {"move its surface less far inward", {Parameter::offset}});
    }
    return Message("nothing is left of the solid, so the surface is empty", remedies);
  }
  return std::nullopt;
}

bool hasWhole(const Grid& grid, const Bounds& source)
{
  const Eigen::Vector3d low = grid.inGridUnits(source.min()), high = grid.inGridUnits(source.max());
  return (low.array() >= -0.5).all() &&
         (high.array() <= grid.dimensions.cast<double>().array() - 0.5).all();
}

bool missesSource(const Grid& grid, const Bounds& source)
{
  const Eigen::Vector3d low = grid.inGridUnits(source.min()), high = grid.inGridUnits(source.max());
  return (high.array() < -0.5).any() ||
         (low.array() > grid.dimensions.cast<double>().array() - 0.5).any();
}

} // namespace winding
