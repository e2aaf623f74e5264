// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/SourceProperties.h"

namespace winding
{

Method coreMethod(int method)
{
  checkProperty(Parameter::method, method);
  return static_cast<Method>(method);
}

InsideRule coreInsideRule(int rule)
{
  checkProperty(Parameter::insideRule, rule);
  return static_cast<InsideRule>(rule);
}

PointAreasFrom pointAreasFrom(int pointAreaMethod)
{
  checkProperty(Parameter::pointAreaMethod, pointAreaMethod);
  return static_cast<PointAreasFrom>(pointAreaMethod);
}

NormalEstimation coreNormalEstimation(int estimation)
{
  checkProperty(Parameter::normalEstimation, estimation);
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
