#include "field/InsideOut.h"

#include "cloud/CloudOrientation.h"
#include "surface/ClosedComponents.h"
#include "surface/NearlyClosed.h"

#include <algorithm>
#include <vector>

namespace winding
{

namespace
{

/// Returns whether a closed or nearly closed part of a surface is inside out. Others have no side
/// that is inside, however they are turned.
bool hasInvertedPart(const Surface& surface, Executor& executor)
{
  Surface closed = surface;
  const SurfaceEdges edges = edgesOf(surface, executor);
  Components components = componentsOf(surface, edges);
  closeNearlyClosed(closed, edges, components);
  const std::vector<ClosedComponent> parts = closedComponents(closed, components, executor);
  return std::any_of(
    parts.begin(), parts.end(), [](const ClosedComponent& part) { return part.isInverted(); });
}

} // namespace

Inwardness inwardnessOf(const Field& field, const SideCounts& sides, Executor& executor)
{
  if (field.cloud())
  {
    return sides.negative > sides.inside && orientationOf(*field.cloud(), executor).isInward()
             ? Inwardness::solids
             : Inwardness::none;
  }
  if (sides.negative == 0 || 100 * sides.negative < sides.negative + sides.inside)
  {
    return Inwardness::none;
  }
  const FieldInfo& info = field.info();
  const bool areSheets =
    info.openings.areWide() ||
    (info.netBoundaryEdges > 0 && info.contradictingEdges == 0 && !info.openings.lookInward &&
      !hasInvertedPart(*field.surface(), executor));
  return areSheets ? Inwardness::sheets : Inwardness::solids;
}

} // namespace winding
