#include "surface/OpenParts.h"

#include "base/DisjointSets.h"
#include "base/FieldOutput.h"
#include "base/Progress.h"
#include "rays/PointCrossings.h"
#include "surface/Components.h"
#include "surface/NearlyClosed.h"
#include "surface/RepeatedFaces.h"

#include <algorithm>

namespace winding
{

namespace
{

/// Finds the triangles of sets that could be sheets by their edges.
std::vector<char> sheetsByEdges(const Surface& surface, const SurfaceEdges& edges)
{
  DisjointSets sets(surface.triangles.size());
  for (const SurfaceEdges::Pair& pair : edges.pairs)
  {
    sets.unite(pair.triangles[0], pair.triangles[1]);
  }
  std::vector<char> hasRim(surface.triangles.size(), 0), isWall(surface.triangles.size(), 0);
  for (const SurfaceEdges::Rim& rim : edges.rims)
  {
    hasRim[sets.find(rim.triangle)] = 1;
  }
  for (const SurfaceEdges::Crowd& crowd : edges.crowds)
  {
    std::int32_t net = 0;
    for (const SurfaceEdges::Use* use = edges.begin(crowd); use != edges.end(crowd); ++use)
    {
      net += use->sense;
    }
    edges.forEachSet(crowd, sets,
      [&](std::int32_t set, std::int32_t own) { isWall[set] |= static_cast<char>(own != net); });
  }
  std::vector<char> isSheet(surface.triangles.size());
  for (std::size_t i = 0; i < isSheet.size(); ++i)
  {
    const std::int32_t set = sets.find(static_cast<std::int32_t>(i));
    isSheet[i] = hasRim[set] && !isWall[set];
  }
  return isSheet;
}

Components nearlyClosedComponents(Surface& chain, Executor& executor)
{
  const SurfaceEdges edges = edgesOf(chain, executor);
  Components components = componentsOf(chain, edges);
  closeNearlyClosed(chain, edges, components);
  return components;
}

/// Finds by triangle of `sheets` whether it lies inside of the closed components of `walls`, by its
/// middle and by its corners that are not on walls.
std::vector<char> trianglesInside(
  const Surface& sheets, const Surface& walls, const Components& components, Executor& executor)
{
  Surface closed;
  closed.vertices = walls.vertices;
  closed.bounds = walls.bounds;
  std::vector<char> isOnWall(walls.vertices.size(), 0);
  for (std::size_t i = 0; i < walls.triangles.size(); ++i)
  {
    for (const std::int32_t vertex : walls.triangles[i])
    {
      isOnWall[vertex] = 1;
    }
    if (components.isClosed[components.ofTriangle[i]])
    {
      closed.triangles.push_back(walls.triangles[i]);
    }
  }
  std::vector<double> places;
  std::vector<std::size_t> triangles; // by place
  const auto add = [&](const Eigen::Vector3d& place, std::size_t triangle)
  {
    places.insert(places.end(), place.data(), place.data() + 3);
    triangles.push_back(triangle);
  };
  for (std::size_t i = 0; i < sheets.triangles.size(); ++i)
  {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const std::int32_t vertex : sheets.triangles[i])
    {
      middle += sheets.vertices[vertex] / 3;
      if (!isOnWall[vertex])
      {
        add(sheets.vertices[vertex], i);
      }
    }
    add(middle, i);
  }
  std::vector<float> values(triangles.size(), 0);
  if (!closed.triangles.empty())
  {
    FieldOutput output;
    output.values = values.data();
    BriefExecutor brief(executor);
    PointCrossings(closed).evaluate(VectorsView(places.data(), values.size()), output, brief);
  }
  std::vector<char> isInside(sheets.triangles.size(), 1);
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    isInside[triangles[n]] &= static_cast<char>(values[n] != 0);
  }
  return isInside;
}

} // namespace

OpenParts openPartsInside(const Surface& surface, const SurfaceEdges& edges, Executor& executor)
{
  OpenParts result;
  if (edges.rims.empty())
  {
    return result;
  }
  std::vector<char> isSheet = sheetsByEdges(surface, edges);
  if (std::find(isSheet.begin(), isSheet.end(), 1) == isSheet.end())
  {
    return result;
  }
  {
    // Parts that are nearly closed by themselves are walls.
    SurfacePart candidates(surface, isSheet, true);
    const Components components = nearlyClosedComponents(candidates.chain, executor);
    for (std::size_t i = 0; i < candidates.numbers.size(); ++i)
    {
      isSheet[candidates.numbers[i]] = !components.isClosed[components.ofTriangle[i]];
    }
  }
  SurfacePart sheets(surface, isSheet, true), walls(surface, isSheet, false);
  if (sheets.numbers.empty() || walls.numbers.empty())
  {
    return result;
  }
  const Components ofWalls = nearlyClosedComponents(walls.chain, executor);
  const std::vector<char> isInside = trianglesInside(sheets.chain, walls.chain, ofWalls, executor);
  const Components parts = componentsOf(sheets.chain, edgesOf(sheets.chain, executor));
  std::vector<char> isAllInside(parts.size(), 1);
  for (std::size_t i = 0; i < isInside.size(); ++i)
  {
    isAllInside[parts.ofTriangle[i]] &= isInside[i];
  }
  result.count =
    static_cast<std::size_t>(std::count(isAllInside.begin(), isAllInside.end(), char(1)));
  if (result.count > 0)
  {
    result.isInside.resize(surface.triangles.size(), 0);
    for (std::size_t i = 0; i < isInside.size(); ++i)
    {
      result.isInside[sheets.numbers[i]] = isAllInside[parts.ofTriangle[i]];
    }
  }
  return result;
}

} // namespace winding
