#include "private/SourceProperties.h"

#include "base/Refusal.h"

#include "vtkWindingNumberAlgorithm.h"

namespace winding
{

using Filter = vtkWindingNumberAlgorithm;

Method coreMethod(int method)
{
  switch (method)
  {
  case Filter::AUTOMATIC:
    return Method::automatic;
  case Filter::ROWS:
    return Method::rows;
  case Filter::HIERARCHICAL:
    return Method::hierarchical;
  case Filter::DIRECT:
    return Method::direct;
  case Filter::PARITY:
    return Method::parity;
  }
  throw Refusal("the method is " + std::to_string(method) +
                "; it must be AUTOMATIC (0), ROWS (1), HIERARCHICAL (2), DIRECT (3) or PARITY (4)");
}

PointAreaMethod corePointAreaMethod(int method)
{
  if (method < Filter::VORONOI || method > Filter::ARRAY)
  {
    throw Refusal("the point area method is " + std::to_string(method) +
                  "; it must be VORONOI (0), MESH (1), CONSTANT (2) or ARRAY (3)");
  }
  // With areas of its own the input leaves nothing to find.
  return method == Filter::CONSTANT ? PointAreaMethod::constant : PointAreaMethod::voronoi;
}

AreaSource areaSource(int pointAreaMethod)
{
  switch (pointAreaMethod)
  {
  case Filter::MESH:
    return AreaSource::mesh;
  case Filter::ARRAY:
    return AreaSource::array;
  default:
    return AreaSource::none;
  }
}

} // namespace winding
