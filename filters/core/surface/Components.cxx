#include "surface/Components.h"

#include "base/DisjointSets.h"
#include "source/UnitScale.h"

#include <algorithm>

namespace winding
{

namespace
{

/// Finds which triangles are of one set, and which sets have an edge that does not cancel within
/// them.
class OpenSets
{
public:
  OpenSets(const Surface& surface, const SurfaceEdges& edges)
    : edges_(edges)
    , sets_(surface.triangles.size())
    , isOpen_(surface.triangles.size(), 0)
  {
  }

  DisjointSets& sets() { return sets_; }

  bool isOpen(std::int32_t triangle) { return isOpen_[sets_.find(triangle)] != 0; }

  /// Finds which of the sets, as they are now, are open.
  void findOpenOnes()
  {
    std::fill(isOpen_.begin(), isOpen_.end(), 0);
    for (const SurfaceEdges::Rim& rim : edges_.rims)
    {
      isOpen_[sets_.find(rim.triangle)] = 1;
    }
    for (const SurfaceEdges::Pair& pair : edges_.pairs)
    {
      if (!pair.agrees)
      {
        isOpen_[sets_.find(pair.triangles[0])] = 1;
      }
    }
    for (const SurfaceEdges::Crowd& crowd : edges_.crowds)
    {
      edges_.forEachSet(crowd, sets_,
        [this](std::int32_t set, std::int32_t net)
        { isOpen_[set] |= static_cast<char>(net != 0); });
    }
  }

private:
  const SurfaceEdges& edges_;
  DisjointSets sets_;
  std::vector<char> isOpen_; ///< by representative
};

} // namespace

Components componentsOf(
  const Surface& surface, const SurfaceEdges& edges, const PolygonParts& parts)
{
  OpenSets pieces(surface, edges);
  for (const SurfaceEdges::Pair& pair : edges.pairs)
  {
    pieces.sets().unite(pair.triangles[0], pair.triangles[1]);
  }
  for (std::size_t i = 1; i < parts.size(); ++i)
  {
    if (parts[i])
    {
      pieces.sets().unite(static_cast<std::int32_t>(i - 1), static_cast<std::int32_t>(i));
    }
  }
  pieces.findOpenOnes();
  // Only open sets are joined here, and a set that is open now counts as open until all are joined.
  std::vector<std::pair<std::int32_t, std::int32_t>> joints;
  for (const SurfaceEdges::Crowd& crowd : edges.crowds)
  {
    std::int32_t first = -1;
    for (const SurfaceEdges::Use* use = edges.begin(crowd); use != edges.end(crowd); ++use)
    {
      if (pieces.isOpen(use->triangle))
      {
        first = first < 0 ? use->triangle : first;
        joints.emplace_back(first, use->triangle);
      }
    }
  }
  for (const auto& [a, b] : joints)
  {
    pieces.sets().unite(a, b);
  }
  pieces.findOpenOnes();

  Components components;
  components.ofTriangle.resize(surface.triangles.size());
  for (std::size_t i = 0; i < components.ofTriangle.size(); ++i)
  {
    const auto triangle = static_cast<std::int32_t>(i);
    const std::int32_t first = pieces.sets().find(triangle);
    if (first == triangle)
    {
      components.ofTriangle[i] = static_cast<std::int32_t>(components.size());
      components.isClosed.push_back(!pieces.isOpen(triangle));
    }
    else
    {
      components.ofTriangle[i] = components.ofTriangle[first]; // `first` is less than i
    }
  }
  return components;
}

double areaOf(const Surface& surface, const Triangle& triangle, double scale)
{
  const Eigen::Vector3d& a = surface.vertices[triangle[0]];
  const Eigen::Vector3d u = (surface.vertices[triangle[1]] - a) * scale;
  const Eigen::Vector3d v = (surface.vertices[triangle[2]] - a) * scale;
  return u.cross(v).norm();
}

void addMiddles(Surface& surface, Components& components, const std::vector<char>& isChosen,
  std::size_t triangles)
{
  const double scale = unitScale(surface.bounds);
  for (std::size_t i = 0; i < triangles; ++i)
  {
    if (isChosen[components.ofTriangle[i]])
    {
      const Triangle& t = surface.triangles[i];
      const Eigen::Vector3d& a = surface.vertices[t[0]];
      const Eigen::Vector3d offsets =
        (surface.vertices[t[1]] - a) / 3 + (surface.vertices[t[2]] - a) / 3;
      surface.vertices.emplace_back(a + offsets);
      components.middles.push_back({components.ofTriangle[i], areaOf(surface, t, scale)});
    }
  }
}

} // namespace winding
