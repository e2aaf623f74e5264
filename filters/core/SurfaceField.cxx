#include "SurfaceField.h"

#include "DirectSum.h"
#include "RayParity.h"
#include "ReferenceSum.h"
#include "Refusal.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace winding
{

SurfaceField::SurfaceField(
  const std::vector<TrianglesView>& views, const FieldOptions& options, Executor& executor)
  : surface_(sanitize(views, executor))
{
  info_.inputPrimitives = surface_.inputTriangles;
  info_.primitives = surface_.triangles.size();
  info_.dropped = surface_.dropped();
  info_.weldedVertices = surface_.vertices.size();
  info_.bounds = surface_.bounds;
  if (surface_.dropped() > 0)
  {
    info_.warning =
      std::to_string(surface_.dropped()) + " of " + std::to_string(surface_.inputTriangles) +
      " triangles were unusable and left out (" + std::to_string(surface_.nonFiniteTriangles) +
      " with NaN or infinite coordinates, " + std::to_string(surface_.invalidIdTriangles) +
      " with ids of points that do not exist)";
  }
  this->chooseMethod(options, executor);
}

SurfaceField::~SurfaceField() = default;

void SurfaceField::chooseMethod(const FieldOptions& options, Executor& executor)
{
  const Method asked = options.method;
  if (asked == Method::rows && options.scattered)
  {
    throw Refusal("rows needs a grid and these are scattered samples; choose another method");
  }
  const BoundaryChain chain = boundaryChain(surface_, executor);
  info_.boundaryEdges = chain.edgesOfOneTriangle;
  info_.netBoundaryEdges = chain.edges.size();
  if (asked == Method::parity)
  {
    info_.method = Method::parity;
    info_.why = chain.edges.empty() ? "asked for" : "asked for, though the surface is not closed";
    evaluator_ = std::make_unique<RayParity>(surface_);
    return;
  }
  evaluator_ = std::make_unique<TriangleSum>(surface_);
  if (asked == Method::direct || options.scattered)
  {
    info_.why = asked == Method::direct ? "asked for" : "exact for every surface, open or closed";
    return;
  }

  capped_ = std::make_unique<CappedSurface>(surface_, chain);
  info_.capTriangles = capped_->capTriangles();
  const std::string cap = std::to_string(info_.capTriangles) + " triangles over " +
                          std::to_string(chain.edges.size()) + " boundary edges";
  if (asked == Method::automatic && info_.capTriangles >= surface_.triangles.size())
  {
    // What is summed at every sample is the cap or the surface; finding the rows' crossings costs
    // nothing beside either.
    capped_ = nullptr;
    info_.why = "a cap would have " + cap + ", no fewer than the surface itself";
    return;
  }
  info_.method = Method::rows;
  info_.why = chain.edges.empty()
                ? "closed after welding: integers, found for whole rows"
                : "open: rows find the integer part, a cap of " + cap + " gives the rest";
}

bool SurfaceField::evaluate(
  const Grid& grid, const Extent& extent, const FieldOutput& output, Executor& executor) const
{
  return capped_ ? capped_->evaluate(grid, extent, output, executor)
                 : Field::evaluate(grid, extent, output, executor);
}

double SurfaceField::reference(const Eigen::Vector3d& sample) const
{
  return referenceSum<double>(surface_, sample);
}

Field::PointOnSource SurfaceField::pointOnSource() const
{
  std::vector<double> cumulativeAreas;
  cumulativeAreas.reserve(surface_.triangles.size());
  double area = 0;
  for (const Triangle& t : surface_.triangles)
  {
    const Eigen::Vector3d& a = surface_.vertices[t[0]];
    area += (surface_.vertices[t[1]] - a).cross(surface_.vertices[t[2]] - a).stableNorm();
    cumulativeAreas.push_back(area);
  }
  return [this, areas = std::move(cumulativeAreas)](double u, double v, double t)
  {
    const auto found = std::upper_bound(areas.begin(), areas.end(), t * areas.back());
    const std::size_t i = std::min<std::size_t>(
      static_cast<std::size_t>(found - areas.begin()), surface_.triangles.size() - 1);
    const Triangle& triangle = surface_.triangles[i];
    const double root = std::sqrt(u);
    return Eigen::Vector3d((1 - root) * surface_.vertices[triangle[0]] +
                           root * (1 - v) * surface_.vertices[triangle[1]] +
                           root * v * surface_.vertices[triangle[2]]);
  };
}

} // namespace winding
