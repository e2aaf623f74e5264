#include "report/Advice.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace winding
{

namespace
{

std::string counted(std::size_t count, const char* one, const char* many)
{
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// A clause that says something of so many things; empty where there are none.
std::string clause(
  std::size_t count, const char* one, const char* many, const std::string& statement)
{
  return count > 0 ? "; " + counted(count, one, many) + " " + statement : "";
}

/// Whether all solids are inverted, and their cavities with them.
bool isInsideOut(const OrientationCounts& counts)
{
  return counts.inverted > 0 &&
         counts.inverted + counts.nestedSolids == counts.closed + counts.nearlyClosed;
}

/// The part of the advice that says which components are oriented wrongly.
std::string orientationAdviceOn(const SurfaceReport& report)
{
  const OrientationCounts& counts = report.orientation;
  std::string advice;
  if (!isInsideOut(counts))
  {
    advice =
      clause(counts.inverted, "part is", "parts are",
        "inside out: FixOrientation (--fix-orientation) turns what is") +
      clause(counts.nestedSolids, "part is", "parts are",
        "oriented outward inside others: solids in solids, with winding numbers of 2, or "
        "cavities turned inside out, which FixOrientation (--fix-orientation) takes them for");
  }
  return advice +
         clause(counts.oneSided, "part has", "parts have", "one side only, and no orientation");
}

const std::string turnFaces =
  "inside out: have the faces turned round (FixOrientation, --fix-orientation), or use the inside "
  "rule absolute (--rule absolute)";

std::string mainAdviceOn(const Surface& surface, const SurfaceReport& report)
{
  const EdgeCounts& edges = report.edges;
  if (surface.triangles.empty())
  {
    return "nothing to evaluate: there are no triangles that bound anything, so the field is 0";
  }
  if (edges.isClosed())
  {
    return isInsideOut(report.orientation)
             ? turnFaces + "; closed: every winding number is an integer"
             : "closed: every winding number is an integer";
  }
  if (edges.inconsistent > 0)
  {
    return counted(edges.inconsistent, "edge is", "edges are") +
           " inconsistently oriented: parts cancel each other; FixOrientation (--fix-orientation) "
           "orients what can be";
  }
  if (edges.boundary == 0)
  {
    return "open, though every edge has two triangles or more: at non-manifold edges they do not "
           "cancel; near those winding numbers are between integers";
  }
  return (isInsideOut(report.orientation) ? turnFaces + "; open: " : "open: ") +
         counted(edges.boundary, "boundary edge in ", "boundary edges in ") +
         counted(edges.boundaryLoops, "loop", "loops") +
         "; near them winding numbers are between integers";
}

std::string percent(double share)
{
  return std::to_string(std::lround(100 * share)) + " %";
}

std::string mainAdviceOn(const CloudReport& report)
{
  if (report.points == 0)
  {
    return "nothing to evaluate: there are no points";
  }
  if (report.nonFinite == report.points)
  {
    return "nothing to evaluate: all points are NaN or infinite";
  }
  const bool onlyZeros = report.zeroNormals + report.nonFinite == report.points;
  if (!report.hasNormals || onlyZeros)
  {
    return std::string(
             onlyZeros ? "all normals have length 0: leave them out, then" : "no normals:") +
           " have them estimated (EstimateNormals, --estimate-normals), or compute oriented ones "
           "first, for instance by vtkPCANormalEstimation with NormalOrientation set to graph "
           "traversal";
  }
  if (report.places == 1)
  {
    return "all points lie at one place: nothing tells what area they stand for; name it "
           "(PointArea, --area)";
  }
  // Normals that point to either side at random have a share of ½. The vertices of meshes whose
  // triangles agree have 0 to 0.08 (measured), those of a teapot 0.15, and those of an icosahedron,
  // which has few points, 0.38; two meshes with flipped parts have 0.19 and 0.24.
  constexpr double manyOpposite = 0.2;
  if (report.oppositeNeighbors > manyOpposite)
  {
    return percent(report.oppositeNeighbors) +
           " of neighbours have opposite normals: unless parts are as thin as the points are far "
           "apart, the normals contradict each other and cancel; orient them first";
  }
  const CloudOrientation orientation = report.orientation.value_or(CloudOrientation());
  if (!orientation.isClear())
  {
    char medians[80];
    std::snprintf(medians, sizeof medians, "%.2f and %.2f", orientation.behind, orientation.before);
    return "the field tells inside from outside at " +
           percent(std::max(orientation.outward, orientation.inward)) +
           " of the points (it is mostly " + medians +
           " behind and before them): the cloud is open, has parts as thin as its points are far "
           "apart, or its normals contradict each other";
  }
  return orientation.isInward()
           ? "oriented points, but inside out: winding numbers inside are -1; turn the normals "
             "round, or use the inside rule absolute (--rule absolute)"
           : "oriented points, outward: winding numbers are approximate, and best away from the "
             "points";
}

/// Whether some point is alone in a large part of the bounds, which would be smaller without it.
bool hasOutlier(const CloudReport& report)
{
  const Spacing& spacing = report.spacing;
  return spacing.largest > 100 * spacing.median &&
         spacing.largest > 0.25 * report.bounds.diagonal().norm();
}

} // namespace

std::string adviceOn(const Surface& surface, const SurfaceReport& report)
{
  return mainAdviceOn(surface, report) + orientationAdviceOn(report) +
         clause(report.edges.nonManifold, "edge is", "edges are",
           "non-manifold (more than two triangles meet there): where parts overlap, winding "
           "numbers may be other than 0 and 1") +
         clause(report.duplicateTriangles, "triangle repeats", "triangles repeat",
           "others: equal ones add up, opposite ones cancel") +
         clause(surface.nonFiniteTriangles, "triangle is", "triangles are",
           "left out for NaN or infinite coordinates") +
         clause(surface.invalidIdTriangles, "triangle is", "triangles are",
           "left out for points that do not exist");
}

std::string adviceOn(const CloudReport& report)
{
  std::string advice =
    mainAdviceOn(report) + clause(report.duplicates, "point lies", "points lie",
                             "where others do: with one area for all (--areas constant) they count "
                             "once more");
  if (hasOutlier(report))
  {
    advice += "; at least one point is far from all others: the grid of a field reaches out to it "
              "unless bounds are named";
  }
  const std::size_t finite = report.points - report.nonFinite;
  if (report.zeroNormals < finite)
  {
    advice +=
      clause(report.zeroNormals, "point is", "points are", "left out for normals of length 0");
  }
  if (finite > 0)
  {
    advice +=
      clause(report.nonFinite, "point is", "points are", "left out for NaN or infinite values");
  }
  return advice;
}

} // namespace winding
