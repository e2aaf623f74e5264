// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/Advice.h"

#include "base/Digits.h"
#include "base/InsideRule.h"
#include "cloud/OutwardNormals.h"
#include "cloud/PointAreas.h"
#include "surface/RepeatedFaces.h"

#include <algorithm>
#include <cmath>

namespace winding
{

namespace
{

std::string counted(std::size_t count, const char* one, const char* many)
{
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

using Advice = std::vector<Message>;

const char* const nothingToMend = "nothing to mend; ";
const char* const outwardPoints =
  "oriented points, outward: winding numbers are approximate, and best away from the points";

/// Adds what `statement` says of `count` things, and what to do, unless there are none.
void add(Advice& advice, std::size_t count, const char* one, const char* many,
  const std::string& statement, const std::vector<Remedy>& remedies = {})
{
  if (count > 0)
  {
    advice.emplace_back(counted(count, one, many) + " " + statement, remedies);
  }
}

const Remedy turnedFaces = {"turn the faces", {{Parameter::orientFaces, 1}}};
const Remedy absoluteRule = {
  "", {{Parameter::insideRule, static_cast<int>(InsideRule::absoluteThreshold)}}};

/// Whether all solids are inverted, and their cavities with them.
bool isInsideOut(const OrientationCounts& counts)
{
  return counts.inverted > 0 &&
         counts.inverted + counts.nestedSolids == counts.closed + counts.nearlyClosed;
}

/// Adds which components are oriented wrongly.
void addOrientation(Advice& advice, const OrientationCounts& counts, bool isInsideOutSaid)
{
  if (!isInsideOutSaid)
  {
    const std::size_t solids = counts.closed + counts.nearlyClosed;
    if (counts.inverted > 0)
    {
      advice.emplace_back(std::to_string(counts.inverted) + " of " +
                            counted(solids, "solid part is", "solid parts are") + " inside out",
        std::vector<Remedy>{turnedFaces});
    }
    add(advice, counts.nestedSolids, "part is", "parts are",
      "oriented outward inside others, with winding numbers of 2",
      {{"where they are cavities", {{Parameter::orientFaces, 1}}}});
  }
  add(advice, counts.oneSided, "part has", "parts have", "one side only, and no orientation");
}

/// Returns what to do about a surface that only slits keep from being closed.
Message slitAdviceOn(const SurfaceReport& report)
{
  Message advice("closed, except for slits of " + inDigits(report.widestSlit.value_or(0), 1), {},
    counted(report.edges.boundary, "boundary edge in ", "boundary edges in ") +
      counted(report.edges.boundaryLoops, "loop", "loops") +
      "; winding numbers are between integers only next to these");
  if (report.canBeWelded())
  {
    // Rounded up, so that points at exactly that distance are welded, too.
    const double farthest =
      *std::max_element(report.slits.endDistances.begin(), report.slits.endDistances.end());
    advice.remedies.push_back(
      {"weld points up to " + inDigits(1.1 * farthest, 2) + " from each other",
        {Parameter::weldTolerance}});
  }
  else
  {
    advice.facts += "; points of one side lie on edges of the other, so that welding leaves slits";
  }
  return advice;
}

/// Whether the first advice is that all of it is inside out.
bool isSaidInsideOut(const SurfaceReport& report)
{
  return isInsideOut(report.orientation) &&
         (report.edges.isClosed() || report.edges.inconsistent == 0);
}

Advice mainAdviceOn(const Surface& surface, const SurfaceReport& report)
{
  const EdgeCounts& edges = report.edges;
  if (report.isTwoSided)
  {
    return {twoSidedAdvice()};
  }
  if (surface.triangles.empty())
  {
    return {{"nothing to evaluate: there are no triangles that bound anything, so the field is 0"}};
  }
  Advice advice;
  if (isSaidInsideOut(report))
  {
    advice.emplace_back("inside out", std::vector<Remedy>{absoluteRule, turnedFaces});
  }
  if (edges.isClosed())
  {
    return advice;
  }
  if (edges.inconsistent > 0)
  {
    add(advice, edges.inconsistent, "edge is", "edges are",
      "inconsistently oriented, so that parts cancel each other",
      report.orientation.contradictions > 0 ? std::vector<Remedy>{turnedFaces}
                                            : std::vector<Remedy>());
    return advice;
  }
  if (edges.boundary == 0)
  {
    return {{"open, though every edge has two triangles or more: at non-manifold edges they do not "
             "cancel; near those winding numbers are between integers"}};
  }
  if (report.isClosedExceptForSlits())
  {
    advice.push_back(slitAdviceOn(report));
    return advice;
  }
  if (report.openings.areWide() || report.openings.lookInward)
  {
    advice.push_back(openSideAdvice(report.openings));
  }
  advice.emplace_back(
    "open: " + counted(edges.boundary, "boundary edge in ", "boundary edges in ") +
    counted(edges.boundaryLoops, "loop", "loops") +
    "; near them winding numbers are between integers" +
    ", and the volume is that up to the middle of the bounds");
  return advice;
}

Message mainAdviceOn(const CloudReport& report)
{
  if (report.points == 0)
  {
    return {"nothing to evaluate: there are no points"};
  }
  if (report.nonFinite == report.points)
  {
    return {"nothing to evaluate: all points are NaN or infinite"};
  }
  const bool onlyZeros = report.zeroNormals + report.nonFinite == report.points;
  if (!report.hasNormals || onlyZeros)
  {
    return missingNormals(report.hasNormals);
  }
  if (report.equalNormalsExcept)
  {
    return equalNormals(*report.equalNormalsExcept);
  }
  if (report.places == 1)
  {
    return missingPointArea("nothing tells what area they stand for");
  }
  // Normals that point to either side at random have a share of ½. The vertices of meshes whose
  // triangles agree have 0 to 0.08 (measured), a teapot's 0.15, and an icosahedron's, which has
  // few points, 0.38; two meshes with flipped parts have 0.19 and 0.24.
  constexpr double manyOpposite = 0.2;
  if (report.oppositeNeighbors > manyOpposite)
  {
    return {percentOf(report.oppositeNeighbors) +
            " of neighbours have opposite normals: unless parts are as thin as the points are far "
            "apart, the normals contradict each other and cancel; orient them first"};
  }
  const CloudOrientation orientation = report.orientation.value_or(CloudOrientation());
  if (!orientation.isClear())
  {
    return {"the field tells inside from outside at " +
            percentOf(std::max(orientation.outward, orientation.inward)) +
            " of the points (it is mostly " + inPlaces(orientation.behind, 2) + " and " +
            inPlaces(orientation.before, 2) +
            " behind and before them): the cloud is open, has parts as thin as its points are far "
            "apart, or its normals contradict each other"};
  }
  if (orientation.isInward())
  {
    return {"oriented points, but inside out", {absoluteRule, {"turn the normals round", {}}},
      "winding numbers inside are -1"};
  }
  return {outwardPoints};
}

/// Whether some point is alone in a large part of the bounds, which would be smaller without it.
bool hasOutlier(const CloudReport& report)
{
  const Spacing& spacing = report.spacing;
  return spacing.largest > 100 * spacing.median &&
         spacing.largest > 0.25 * report.bounds.diagonal().norm();
}

/// Adds what is wrong with parts of a surface.
void addFaults(Advice& advice, const Surface& surface, const SurfaceReport& report)
{
  if (report.hollow)
  {
    const double size = surface.bounds.sizes().maxCoeff();
    advice.emplace_back(
      "two walls with openings up to about " + inDigits(report.hollow->opening, 1),
      std::vector<Remedy>{report.hollow->remedy()},
      "they are " + percentOf(report.wallThickness / size) + " of the size apart");
  }
  addOrientation(advice, report.orientation, isSaidInsideOut(report));
  add(advice, report.openPartsInside, "open part lies", "open parts lie",
    "inside of closed ones: they bound nothing, but change winding numbers around them",
    {{"leave them out", {{Parameter::ignoreOpenParts, 1}}}});
  add(advice, report.edges.nonManifold, "edge is", "edges are",
    "non-manifold (more than two triangles meet there): where parts overlap, and do not just "
    "touch, winding numbers may be other than 0 and 1");
  std::vector<Remedy> takenOnce;
  if (report.mendableTriangles > 0)
  {
    takenOnce = {{"take each once", {{Parameter::orientFaces, 1}}}};
  }
  if (report.shareOnce < 1)
  {
    advice.emplace_back("parts overlap, where winding numbers are 2 or more", std::vector<Remedy>(),
      "the volume is their integral; counted once it is about " +
        inDigits(report.shareOnce * report.volume, 2));
  }
  // Closed parts that share faces are right as they are.
  if (!report.edges.isClosed() || report.mendableTriangles > 0)
  {
    add(advice, report.duplicateTriangles, "triangle repeats", "triangles repeat",
      "others: equal ones add up, opposite ones cancel", takenOnce);
  }
}

/// Has remedies that turn faces name what the report itself can do, first.
void nameOwnRemedies(Advice& advice)
{
  for (Message& message : advice)
  {
    for (Remedy& remedy : message.remedies)
    {
      const auto turning = std::find_if(remedy.settings.begin(), remedy.settings.end(),
        [](const Setting& setting) { return setting.parameter == Parameter::orientFaces; });
      if (turning != remedy.settings.end())
      {
        remedy.settings.insert(turning, {Parameter::fixOrientation, 1});
      }
    }
  }
}

} // namespace

Advice adviceOn(const Surface& surface, const SurfaceReport& report)
{
  Advice advice = mainAdviceOn(surface, report);
  if (!report.isTwoSided)
  {
    addFaults(advice, surface, report);
  }
  add(advice, surface.nonFiniteTriangles, "triangle is", "triangles are",
    "left out for NaN or infinite coordinates");
  add(advice, surface.invalidIdTriangles, "triangle is", "triangles are",
    "left out for points that do not exist");
  if (report.edges.isClosed() && !report.isTwoSided && !surface.triangles.empty())
  {
    const char* const verdict = advice.empty() ? nothingToMend : "";
    advice.emplace_back(verdict + std::string("closed: every winding number is an integer"));
  }
  nameOwnRemedies(advice);
  return advice;
}

Advice adviceOn(const CloudReport& report)
{
  Advice advice = {mainAdviceOn(report)};
  add(advice, report.duplicates, "point lies", "points lie",
    "where others do: with one area for all they count once more");
  if (hasOutlier(report))
  {
    advice.emplace_back("at least one point is far from all others, so that a grid reaches far",
      std::vector<Remedy>{{"name bounds", {Parameter::samplingBounds}}});
  }
  const std::size_t finite = report.points - report.nonFinite;
  if (report.zeroNormals < finite)
  {
    add(advice, report.zeroNormals, "point is", "points are", "left out for normals of length 0");
  }
  if (finite > 0)
  {
    add(advice, report.nonFinite, "point is", "points are", "left out for NaN or infinite values");
  }
  if (advice.size() == 1 && advice[0].fault == outwardPoints)
  {
    advice[0].fault = nothingToMend + advice[0].fault;
  }
  return advice;
}

} // namespace winding
