#include "report/GridAdvice.h"

#include <cstdio>

namespace winding
{

std::optional<Message> gridAdvice(const Grid& grid, const Bounds& source, bool isEmpty)
{
  const Eigen::Vector3d low = grid.inGridUnits(source.min()), high = grid.inGridUnits(source.max());
  if (missesSource(grid, source))
  {
    return Message(
      "the grid misses the source", {{"choose a grid around it", {Parameter::samplingBounds}}});
  }
  constexpr double fewest = 3;
  int thinnest = -1;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (high[axis] < -0.5 || low[axis] > grid.dimensions[axis] - 0.5)
    {
      return Message(
        "the grid misses the source", {{"choose a grid around it", {Parameter::samplingBounds}}});
    }
    const double voxels = high[axis] - low[axis];
    const bool isThin = voxels > 0 && voxels < fewest;
    if (isThin && (thinnest < 0 || voxels < high[thinnest] - low[thinnest]))
    {
      thinnest = axis;
    }
  }
  if (thinnest >= 0)
  {
    char facts[120];
    std::snprintf(facts, sizeof facts, "it has %.2g of them along %c%s",
      high[thinnest] - low[thinnest], "xyz"[thinnest], isEmpty ? ", and no sample is inside" : "");
    return Message("the source is thinner than three voxels",
      {smallerVoxels(), {"name voxels along each axis", {Parameter::samplingDimensions}}}, facts);
  }
  if (isEmpty)
  {
    return Message("no sample is inside",
      {smallerVoxels(), {"choose a grid around the source", {Parameter::samplingBounds}},
        {"look whether the source is closed", {Parameter::surfaceReport}}});
  }
  return std::nullopt;
}

bool missesSource(const Grid& grid, const Bounds& source)
{
  const Eigen::Vector3d low = grid.inGridUnits(source.min()), high = grid.inGridUnits(source.max());
  return (high.array() < -0.5).any() ||
         (low.array() > grid.dimensions.cast<double>().array() - 0.5).any();
}

} // namespace winding
