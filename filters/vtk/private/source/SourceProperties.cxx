#include "private/source/SourceProperties.h"

namespace winding
{

Method coreMethod(int method)
{
  checkChoice("Method", method, {"AUTOMATIC", "ROWS", "HIERARCHICAL", "DIRECT", "PARITY"});
  return static_cast<Method>(method);
}

InsideRule coreInsideRule(int rule)
{
  checkChoice("InsideRule", rule, {"SIGNED", "ABSOLUTE", "ODD"});
  return static_cast<InsideRule>(rule);
}

PointAreasFrom pointAreasFrom(int pointAreaMethod)
{
  checkChoice("PointAreaMethod", pointAreaMethod, {"VORONOI", "MESH", "CONSTANT", "ARRAY"});
  return static_cast<PointAreasFrom>(pointAreaMethod);
}

NormalEstimation coreNormalEstimation(int estimation)
{
  checkChoice("NormalEstimation", estimation,
    {"ESTIMATION_AUTOMATIC", "SPANNING_TREE", "WINDING_CONSISTENT"});
  return static_cast<NormalEstimation>(estimation);
}

PointAreaMethod corePointAreaMethod(PointAreasFrom areas)
{
  // An input with areas of its own leaves nothing to find.
  return areas == PointAreasFrom::constant ? PointAreaMethod::constant : PointAreaMethod::voronoi;
}

AreaSource areaSource(PointAreasFrom areas)
{
  switch (areas)
  {
  case PointAreasFrom::mesh:
    return AreaSource::mesh;
  case PointAreasFrom::array:
    return AreaSource::array;
  default:
    return AreaSource::none;
  }
}

} // namespace winding
