// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "diagnosis/Diagnosis.h"

#include "base/Digits.h"
#include "base/Evenly.h"
#include "cloud/OutwardNormals.h"
#include "diagnosis/InsideOutAdvice.h"
#include "diagnosis/MendNotes.h"
#include "source/CoordinateOrder.h"
#include "source/UnitScale.h"
#include "sums/DirectSum.h"
#include "surface/Components.h"
#include "surface/OpenParts.h"
#include "surface/Orientation.h"
#include "surface/RepeatedFaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace winding
{

namespace
{

/// Returns the number of points that walls are measured at: more of large surfaces, for which few
/// other sides are met.
std::size_t wallPoints(const Surface& surface)
{
  constexpr std::size_t large = 1 << 17;
  return surface.triangles.size() > large ? 1024 : 512;
}

/// Returns whether a triangle is so thin that rounding of its corners decides which way it looks.
bool isNeedle(const Surface& surface, const Triangle& t)
{
  const double scale = unitScale(surface.bounds);
  const Eigen::Vector3d u = scale * (surface.vertices[t[1]] - surface.vertices[t[0]]);
  const Eigen::Vector3d v = scale * (surface.vertices[t[2]] - surface.vertices[t[0]]);
  const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()});
  constexpr double thin = 1e-6;
  return u.cross(v).norm() <= thin * longest;
}

/// Returns whether a face that is there several times has copies too many. Closed solids that
/// overlap may share faces.
bool addsUp(const SampleLine& line)
{
  return std::abs(line.step) > 1 && !line.isClear();
}

/// Returns whether all faces that some lines meet are there as often as the one at the first line's
/// point, as they are of a solid that is there several times.
bool areSeveralSolids(const SampleLine* first, const SampleLine* last)
{
  const int times = std::abs(first->step);
  return times > 1 && std::all_of(first, last,
                        [times](const SampleLine& line)
                        { return line.times == times * (line.facesBefore + line.facesBehind); });
}

/// Returns whether the two senses of a face cancel that may be the skin of a solid: nothing is
/// inside on either side, and there is another face behind it. Between two solids they should
/// cancel. There are `copies` triangles for each face that a line meets.
bool mayCancelSkin(const SampleLine& line, int copies)
{
  return line.step == 0 && line.isClear() && line.before == 0 &&
         (line.facesBefore + line.facesBehind) / copies % 2 != 0;
}

/// Returns whether the outside lies before a point and the inside behind, as far as both ends of
/// its line agree.
bool isBound(const SampleLine& line, const InsideTest& isInside)
{
  return line.isClear() && isInside(line.behind) && !isInside(line.before);
}

/// Adds a place at some height above a point three times, for lines along each axis.
void addAlongAxes(const SurfaceSample& point, double height, std::vector<SurfaceSample>& to)
{
  SurfaceSample place = point;
  place.position += height * point.normal;
  place.triangle = -1;
  for (int axis = 0; axis < 3; ++axis)
  {
    place.normal = Eigen::Vector3d::Unit(axis);
    to.push_back(place);
  }
}

/// Returns whether a surface looks inward at a point, by the line along its normal and the lines
/// along all axes after it: an open one may do so along a single axis by chance.
bool isInward(const SampleLine* lines)
{
  return lines->isClear() && lines->before < 0 && lines->behind <= 0 &&
         std::count_if(lines + 1, lines + 4,
           [](const SampleLine& line) { return line.isClear() && line.before < 0; }) >= 2;
}

/// Returns whether a face with two senses lies on the skin of a solid, by three lines each through
/// places just behind it and just before it. Seen along the axes, an odd number of faces lies on
/// either side of one of them, and an even number of the other. One of the axes may pass a hole.
bool areOnSkin(const SampleLine* lines)
{
  const auto areMost = [](const SampleLine* first, int parity)
  {
    return std::count_if(first, first + 3,
             [parity](const SampleLine& line)
             { return line.facesBefore % 2 == parity && line.facesBehind % 2 == parity; }) >= 2;
  };
  return (areMost(lines, 0) && areMost(lines + 3, 1)) ||
         (areMost(lines, 1) && areMost(lines + 3, 0));
}

} // namespace

Message emptySourceAdvice(bool isWelded)
{
  const Remedy give = {"give a surface or points", {}};
  const Remedy weldLess = {"weld less", {Parameter::weldTolerance}};
  return Message("the source is empty, so its field is 0",
    isWelded ? std::vector<Remedy>{give, weldLess} : std::vector<Remedy>{give});
}

Diagnosis::Diagnosis(SurfaceFacts facts)
  : facts_(std::move(facts))
{
}

Diagnosis::Diagnosis(const PointCloud& cloud, bool hasNoSides, bool areEstimated)
  : cloud_(&cloud)
  , areNormalsEstimated_(areEstimated)
{
  facts_.hasNoSides = hasNoSides;
}

const SurfaceSamples& Diagnosis::points(Executor& executor) const
{
  const std::lock_guard<std::recursive_mutex> lock(lock_);
  if (!points_)
  {
    points_ = sampleSurface(*facts_.distinct, wallPoints(*facts_.distinct), executor);
  }
  return *points_;
}

const Diagnosis::Lines& Diagnosis::lines(Executor& executor) const
{
  const std::lock_guard<std::recursive_mutex> lock(lock_);
  if (!lines_)
  {
    const Surface& surface = *facts_.distinct;
    const SurfaceSamples& all = this->points(executor);
    std::vector<std::int32_t> repeated;
    for (std::size_t i = 0; i < surface.multiplicities.size(); ++i)
    {
      if (surface.multiplicities[i] != 1)
      {
        repeated.push_back(static_cast<std::int32_t>(i));
      }
    }
    constexpr std::size_t most = 40, mostRepeated = 16;
    Lines lines;
    lines.points = evenly(all.points, most);
    lines.repeated = sampleTriangles(surface, chooseTriangles(surface, repeated, mostRepeated));
    const double share = affordableShare(surface, lines.places(surface.bounds), all);
    constexpr double least = 0.2; // fewer lines say nothing
    const auto some = [share](const std::vector<SurfaceSample>& samples)
    {
      const double count = share * static_cast<double>(samples.size());
      return evenly(samples, share < least ? 0 : static_cast<std::size_t>(count));
    };
    lines.points = some(lines.points);
    lines.repeated = some(lines.repeated);
    lines.lines = linesThrough(surface, lines.places(surface.bounds), all, executor);
    lines_ = std::move(lines);
  }
  return *lines_;
}

/// Returns the places that lines run through, along their normals.
std::vector<SurfaceSample> Diagnosis::Lines::places(const Bounds& bounds) const
{
  std::vector<SurfaceSample> places;
  const double height = 1e-4 * bounds.sizes().maxCoeff();
  for (const SurfaceSample& point : points)
  {
    places.push_back(point);
    addAlongAxes(point, height, places);
  }
  for (const SurfaceSample& point : repeated)
  {
    places.push_back(point);
    addAlongAxes(point, -height, places);
    addAlongAxes(point, height, places);
  }
  return places;
}

const WallSamples& Diagnosis::walls(Executor& executor) const
{
  const std::lock_guard<std::recursive_mutex> lock(lock_);
  if (!walls_)
  {
    const Surface& surface = *facts_.distinct;
    const SurfaceSamples& all = this->points(executor);
    WallSamples walls;
    walls.points = this->affordable(evenly(all.points, wallPoints(surface)), executor);
    walls.areWhole = all.some.empty();
    walls.lines =
      linesThrough(surface, walls.points, all, executor, walls.areWhole ? nullptr : &all.some);
    for (const SampleLine& line : walls.lines)
    {
      walls.shares.push_back(line.wallTriangle < 0 ? 1 : all.shareOf(surface, line.wallTriangle));
    }
    walls_ = std::move(walls);
  }
  return *walls_;
}

std::vector<SurfaceSample> Diagnosis::affordable(
  const std::vector<SurfaceSample>& samples, Executor& executor, double more) const
{
  const double share = affordableShare(*facts_.distinct, samples, this->points(executor), more);
  return evenly(samples, static_cast<std::size_t>(share * static_cast<double>(samples.size())));
}

bool Diagnosis::hasNoSides(Executor& executor) const
{
  if (facts_.hasNoSides || cloud_ || !facts_.hasManyCrowds)
  {
    return facts_.hasNoSides;
  }
  // Copies of polygons may be cut into other triangles.
  const Lines& found = this->lines(executor);
  for (std::size_t i = 0; i < found.points.size(); ++i)
  {
    if (!found.ofPoint(i)->isRepeated || found.ofPoint(i)->step != 0)
    {
      return false;
    }
  }
  return !found.points.empty();
}

std::vector<Message> Diagnosis::ofSource(Executor& executor) const
{
  const std::lock_guard<std::recursive_mutex> lock(lock_);
  if (!faults_)
  {
    faults_ = this->findFaults(executor);
  }
  return *faults_;
}

std::optional<Message> Diagnosis::faultToTurn(Executor& executor) const
{
  if (facts_.isOriented || facts_.isSheet) // its side is given
  {
    return std::nullopt;
  }
  std::vector<Message> faults = this->ofSource(executor);
  if (const auto open = this->ofOpenSide({}))
  {
    faults.push_back(*open);
  }
  const auto found = std::find_if(faults.begin(), faults.end(), proposesTurning);
  return found == faults.end() ? std::nullopt : std::optional<Message>(*found);
}

bool Diagnosis::isSheet(Executor& executor) const
{
  if (cloud_ || facts_.isSheet || this->isClosed())
  {
    return false;
  }
  const std::lock_guard<std::recursive_mutex> lock(lock_);
  this->ofSource(executor);
  return facts_.openings.boundNothing() || (isOneSided_ && facts_.hasRims);
}

std::vector<Message> Diagnosis::findFaults(Executor& executor) const
{
  std::vector<Message> faults;
  if (cloud_)
  {
    return faults;
  }
  if (this->hasNoSides(executor))
  {
    return {twoSidedAdvice()};
  }
  const Surface& surface = *facts_.surface;
  Contradictions found;
  constexpr std::size_t mostForPatches = 16384;
  if (this->doContradictionsMatter() && surface.triangles.size() <= mostForPatches)
  {
    found = contradictionsOf(surface, edgesOf(surface, executor));
  }
  else if (this->doContradictionsMatter())
  {
    found.edges = facts_.contradictions.size();
  }
  isOneSided_ = 2 * found.oneSidedTriangles > surface.triangles.size();
  if (found.oneSided > 0)
  {
    faults.emplace_back(std::to_string(found.oneSided) +
                        (found.oneSided == 1 ? " part has" : " parts have") +
                        " one side only, and no orientation");
  }
  if (found.edges > 0)
  {
    faults.emplace_back("faces contradict each other, so that parts cancel",
      std::vector<Remedy>{{"turn them", {{Parameter::orientFaces, 1}}}},
      "two have the same sense at " + std::to_string(found.edges) +
        (found.edges == 1 ? " edge" : " edges"));
  }
  const auto repeated =
    facts_.isOriented ? std::optional<Message>() : this->findRepeatedFaces(executor);
  if (repeated)
  {
    // The larger fault comes first.
    const bool areFew = surface.triangles.size() - facts_.distinct->triangles.size() < found.edges;
    faults.insert(areFew ? faults.end() : faults.begin(), *repeated);
  }
  if (const auto open = this->findOpenParts(executor))
  {
    faults.push_back(*open);
  }
  return faults;
}

/// Returns whether edges of faces that contradict each other are long enough together to matter:
/// where the surface has holes, too, short ones do not. Needles bound nothing.
bool Diagnosis::doContradictionsMatter() const
{
  const Surface& surface = *facts_.surface;
  double length = 0;
  for (const Contradiction& edge : facts_.contradictions)
  {
    const bool isOfNeedle = isNeedle(surface, surface.triangles[edge.triangles[0]]) ||
                            isNeedle(surface, surface.triangles[edge.triangles[1]]);
    length +=
      isOfNeedle ? 0 : (surface.vertices[edge.low] - surface.vertices[edge.high]).stableNorm();
  }
  const double least = facts_.hasRims ? 0.15 : 1e-3;
  return length > least * surface.bounds.sizes().maxCoeff();
}

std::optional<Message> Diagnosis::findRepeatedFaces(Executor& executor) const
{
  const std::size_t repeats = facts_.surface->triangles.size() - facts_.distinct->triangles.size();
  if (repeats == 0 ? !facts_.hasManyCrowds : !this->areLarge(repeats))
  {
    return std::nullopt;
  }
  const Lines& found = this->lines(executor);
  const std::vector<Remedy> remedies = {{"take each once", {{Parameter::orientFaces, 1}}}};
  const std::string fault = "faces are there more than once: they add up, or cancel";
  for (std::size_t i = 0; i < found.repeated.size(); ++i)
  {
    const SampleLine* const lines = found.ofRepeated(i);
    if (addsUp(lines[0]) || areSeveralSolids(lines, lines + Lines::perRepeated) ||
        (mayCancelSkin(lines[0], 1) && areOnSkin(lines + 1)))
    {
      return Message(fault, remedies,
        std::to_string(repeats) + " of " + std::to_string(facts_.surface->triangles.size()) +
          " triangles");
    }
  }
  // Copies that are cut into other triangles lie in the same place.
  double wrong = 0, all = 0;
  for (std::size_t i = 0; i < found.points.size(); ++i)
  {
    const SampleLine& line = *found.ofPoint(i);
    all += found.points[i].weight;
    const bool isWrong = line.isRepeated && (addsUp(line) || mayCancelSkin(line, 2));
    wrong += isWrong ? found.points[i].weight : 0;
  }
  constexpr double least = 0.1; // chance may find less
  const std::string share = "about " + percentOf(wrong / all) + " of the surface";
  return facts_.hasManyCrowds && wrong > least * all
           ? std::optional<Message>({fault, remedies, share})
           : std::nullopt;
}

/// Returns whether repeated triangles may matter: in large surfaces they have a thousandth of the
/// area.
bool Diagnosis::areLarge(std::size_t repeats) const
{
  constexpr std::size_t large = 1 << 16;
  const Surface& surface = *facts_.distinct;
  if (surface.triangles.size() <= large || 100 * repeats > surface.triangles.size())
  {
    return true;
  }
  const ChainView chain(surface);
  const double scale = unitScale(surface.bounds);
  double area = 0;
  for (std::size_t i = 0; i < chain.size(); ++i)
  {
    area += chain.multiplicity(i) == 1 ? 0 : areaOf(surface, chain[i], scale) / 2;
  }
  const Eigen::Vector3d sizes = scale * surface.bounds.sizes();
  return area > 1e-3 * sizes.maxCoeff() * sizes.maxCoeff();
}

std::optional<Message> Diagnosis::findOpenParts(Executor& executor) const
{
  if (!facts_.hasRims || facts_.isSheet)
  {
    return std::nullopt;
  }
  const Lines& found = this->lines(executor);
  double all = 0, open = 0;
  std::vector<SurfaceSample> inside;
  for (std::size_t i = 0; i < found.points.size(); ++i)
  {
    const SampleLine* const lines = found.ofPoint(i);
    all += found.points[i].weight;
    // Seen along the other axes, open parts lie in closed ones.
    const auto axes = std::count_if(lines + 1, lines + 4,
      [](const SampleLine& line) { return line.isClear() && line.before > 0; });
    if (!lines->isClear() && lines->step != 0 && lines->before > 0 && axes >= 2)
    {
      inside.push_back(found.points[i]);
      open += found.points[i].weight;
    }
  }
  constexpr double least = 0.01;
  // The remedy leaves out what is found so.
  const auto areFound = [&]
  {
    const Surface& surface = *facts_.surface;
    return openPartsInside(surface, edgesOf(surface, executor), executor).count > 0;
  };
  return open > least * all && this->changeInside(inside) && areFound()
           ? std::optional<Message>(openPartsAdvice("w changes around them, which are about " +
                                                    percentOf(open / all) + " of the surface"))
           : std::nullopt;
}

/// Returns whether the pieces that some points lie on have few others, and make w less than ½ just
/// before these points, where it is 1 without them. A single plane sheet leaves more than ½.
bool Diagnosis::changeInside(const std::vector<SurfaceSample>& points) const
{
  const Surface& surface = *facts_.distinct;
  VertexPieces pieces(surface);
  const auto pieceOf = [&](std::int32_t triangle)
  {
    return static_cast<std::size_t>(pieces.sets.find(surface.triangles[triangle][0]));
  };
  std::vector<char> isChosen(surface.vertices.size(), 0);
  double chosen = 0, all = 0;
  for (const SurfaceSample& point : points)
  {
    isChosen[pieceOf(point.triangle)] = 1;
    chosen += point.weight;
  }
  for (const SurfaceSample& point : lines_->points)
  {
    all += isChosen[pieceOf(point.triangle)] ? point.weight : 0;
  }
  constexpr double most = 0.8;
  if (!(chosen > most * all))
  {
    return false;
  }
  TriangleList triangles;
  Multiplicities multiplicities;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    if (isChosen[pieceOf(static_cast<std::int32_t>(i))])
    {
      triangles.push_back(surface.triangles[i]);
      if (!surface.multiplicities.empty())
      {
        multiplicities.push_back(surface.multiplicities[i]);
      }
    }
  }
  constexpr std::size_t places = 8;
  const double step = 1e-3 * surface.bounds.sizes().maxCoeff();
  SampleBlock block;
  for (const SurfaceSample& point : evenly(points, places))
  {
    block.set(block.count++, point.position + step * point.normal);
  }
  double values[SampleBlock::capacity];
  TriangleSum(surface.vertices, {triangles, multiplicities}, surface.bounds)
    .evaluate(block, values);
  constexpr double margin = 1e-2;
  return std::any_of(
    values, values + block.count, [](double value) { return 1 + value < 0.5 - margin; });
}

std::optional<Message> Diagnosis::ofOpenSide(const OpenSideUse& use) const
{
  const Openings& openings = facts_.openings;
  const bool isUnclear = use.threshold > 0 && !(openings.areOfSheet() && use.takesTouchedVoxels);
  if (cloud_ || !openings.areWide() || !facts_.contradictions.empty() ||
      !(openings.lookInward || isUnclear))
  {
    return std::nullopt;
  }
  Message advice = openSideAdvice(openings);
  if (!openings.lookInward && use.mayCloseBorder)
  {
    // All behind the surface is inside then, up to the border.
    advice.remedies.back().settings.emplace_back(Parameter::closeBorder, 1);
  }
  return advice;
}

/// Returns whether parts that lines see from both ends look inward.
bool Diagnosis::hasInwardPart(Executor& executor) const
{
  const std::lock_guard<std::recursive_mutex> lock(lock_);
  if (!hasInwardPart_)
  {
    hasInwardPart_ =
      this->isClosed() ? this->hasInwardSolid(executor) : this->looksMostlyInward(executor);
  }
  return *hasInwardPart_;
}

/// Returns whether any part of a closed surface has a negative volume, and lies in no other.
bool Diagnosis::hasInwardSolid(Executor& executor) const
{
  const Surface& surface = *facts_.distinct;
  constexpr std::size_t mostForParts = 1 << 16;
  if (surface.triangles.size() > mostForParts)
  {
    const Lines& found = this->lines(executor);
    for (std::size_t i = 0; i < found.points.size(); ++i)
    {
      if (isInward(found.ofPoint(i)))
      {
        return true;
      }
    }
    return false;
  }
  // The first vertex of a part is its origin, so that volumes of small parts are not rounded away.
  VertexPieces pieces(surface);
  const double scale = unitScale(surface.bounds);
  struct Part
  {
    double volume = 0, area = 0;
    std::int32_t largest = -1; ///< triangle
    double areaOfLargest = 0;
  };
  std::vector<Part> parts(surface.vertices.size());
  const ChainView chain(surface);
  for (std::size_t i = 0; i < chain.size(); ++i)
  {
    const Triangle t = lowestFirst(surface.vertices, chain[i]); // for the same bits in any order
    const std::int32_t first = pieces.sets.find(t[0]);
    Part& part = parts[static_cast<std::size_t>(first)];
    const Eigen::Vector3d a = scale * (surface.vertices[t[0]] - surface.vertices[first]);
    const Eigen::Vector3d u = scale * (surface.vertices[t[1]] - surface.vertices[t[0]]);
    const Eigen::Vector3d v = scale * (surface.vertices[t[2]] - surface.vertices[t[0]]);
    const Eigen::Vector3d across = u.cross(v);
    const double area = chain.multiplicity(i) * across.norm();
    part.volume += chain.multiplicity(i) * a.dot(across);
    part.area += area;
    // The lowest corner decides between equal areas.
    if (area > part.areaOfLargest ||
        (area == part.areaOfLargest && part.largest >= 0 &&
          compareTriangles(surface.vertices, t,
            lowestFirst(surface.vertices, chain[static_cast<std::size_t>(part.largest)])) < 0))
    {
      part.largest = static_cast<std::int32_t>(i);
      part.areaOfLargest = area;
    }
  }
  std::vector<std::int32_t> inward;
  for (const Part& part : parts)
  {
    constexpr double flat = 1e-9;
    if (part.largest >= 0 && -part.volume > flat * std::pow(part.area, 1.5))
    {
      inward.push_back(part.largest);
    }
  }
  constexpr std::size_t most = 256;
  const std::vector<SurfaceSample> samples =
    this->affordable(sampleTriangles(surface, chooseTriangles(surface, inward, most)), executor);
  const std::vector<SampleLine> lines =
    linesThrough(surface, samples, this->points(executor), executor);
  return std::any_of(
    lines.begin(), lines.end(), [](const SampleLine& line) { return line.before < 0; });
}

/// Returns whether most of an open surface, or of one of its parts, looks inward where both ends of
/// lines agree.
bool Diagnosis::looksMostlyInward(Executor& executor) const
{
  const Surface& surface = *facts_.distinct;
  const Lines& found = this->lines(executor);
  std::vector<char> areInward;
  for (std::size_t i = 0; i < found.points.size(); ++i)
  {
    areInward.push_back(isInward(found.ofPoint(i)));
  }
  if (std::find(areInward.begin(), areInward.end(), 1) == areInward.end())
  {
    return false;
  }
  constexpr std::size_t mostForParts = 1 << 17;
  const bool areParts = surface.triangles.size() <= mostForParts;
  std::vector<double> balance(areParts ? surface.vertices.size() : 1, 0); // by first vertex
  std::optional<VertexPieces> pieces;
  if (areParts)
  {
    pieces.emplace(surface);
  }
  for (std::size_t i = 0; i < found.points.size(); ++i)
  {
    const std::int32_t vertex = surface.triangles[found.points[i].triangle][0];
    balance[static_cast<std::size_t>(areParts ? pieces->sets.find(vertex) : 0)] +=
      areInward[i] ? found.points[i].weight : -found.points[i].weight;
  }
  return std::any_of(balance.begin(), balance.end(), [](double sum) { return sum > 0; });
}

const CloudOrientation& Diagnosis::orientation(Executor& executor) const
{
  const std::lock_guard<std::recursive_mutex> lock(lock_);
  if (!orientation_)
  {
    orientation_ = orientationOf(*cloud_, executor);
  }
  return *orientation_;
}

/// Finds out how a cloud faces, by the sides of its result.
Facing Diagnosis::facingOfCloud(const SideCounts& sides, double threshold, Executor& executor) const
{
  Facing facing;
  constexpr std::size_t few = 30; // single points have negative samples around them
  if (few * sides.negative < sides.negative + sides.inside)
  {
    return facing;
  }
  const CloudOrientation& found = this->orientation(executor);
  constexpr std::size_t fewest = 64; // points that make a surface
  const bool isInward = sides.negative > sides.inside && found.isMostlyInward();
  const bool mayBeWrong = !areNormalsEstimated_ && cloud_->positions.size() >= fewest;
  if (isInward || (mayBeWrong && found.isInwardInPart()))
  {
    facing.looksInward = true;
    facing.isInsideOut = isInward;
    facing.warning = insideOutAdvice("normals", sides, threshold);
  }
  else if (!mayBeWrong)
  {
    // A warning has named estimated normals that are unclear.
    facing.isOfSheets = found.isOfSheet();
  }
  else if (found.isOfSheet())
  {
    facing.isOfSheets = true;
    facing.warning = openSheetsAdvice("the points", {Parameter::sheetSide});
  }
  else if (!found.isClear())
  {
    facing.contradicts = true;
    facing.warning = contradictingNormals(found);
  }
  return facing;
}

Facing Diagnosis::facing(
  const SideCounts& sides, const InsideTest& isInside, Executor& executor) const
{
  Facing facing;
  if (isInside.rule != InsideRule::signedThreshold || facts_.isSheet || sides.negative == 0 ||
      this->hasNoSides(executor))
  {
    return facing;
  }
  if (cloud_)
  {
    return this->facingOfCloud(sides, isInside.threshold, executor);
  }
  bool areSheets = false;
  if (100 * sides.negative < sides.negative + sides.inside)
  {
    // Small pockets of closed surfaces that cut themselves are common, small parts are meant.
    facing.looksInward = this->isClosed() && this->hasInwardPart(executor);
  }
  else
  {
    areSheets = facts_.openings.areWide() || (!this->isClosed() && facts_.contradictions.empty() &&
                                               !this->hasInwardPart(executor));
    facing.looksInward = !areSheets;
  }
  if (facing.looksInward)
  {
    facing.isInsideOut = sides.negative > sides.inside;
    facing.warning = insideOutAdvice("faces", sides, isInside.threshold);
  }
  else if (areSheets && !facts_.openings.areWide())
  {
    facing.isOfSheets = true;
    facing.warning = openSheetsAdvice("parts", {});
  }
  return facing;
}

std::optional<ThinParts> Diagnosis::thinParts(const Grid& grid,
  const IsSampleInside& isSampleInside, const InsideTest& isInside, Executor& executor) const
{
  if (cloud_ || facts_.distinct->triangles.empty())
  {
    return std::nullopt;
  }
  ThinParts parts = thinPartsOf(this->boundingWalls(isInside, executor), grid, isSampleInside);
  // Parts of larger surfaces are looked at where some of it is not shown.
  constexpr std::size_t few = 1 << 15, most = 1 << 16;
  const std::size_t triangles = facts_.distinct->triangles.size();
  if (isSampleInside && !parts.areWorthTelling() && this->isClosed() &&
      triangles <= (parts.hasLostPoints ? most : few))
  {
    countLostComponents(*facts_.distinct, grid, isSampleInside, parts);
  }
  if (isSampleInside && !parts.areWorthTelling() && parts.lostComponents == 0)
  {
    this->findLost(grid, isSampleInside, isInside, parts, executor);
  }
  return parts;
}

/// Finds a part that is far from all samples inside: a wall of a closed surface, or an open one.
void Diagnosis::findLost(const Grid& grid, const IsSampleInside& isSampleInside,
  const InsideTest& isInside, ThinParts& parts, Executor& executor) const
{
  const Surface& surface = *facts_.distinct;
  const SurfaceSamples& points = this->points(executor);
  if (!this->isClosed())
  {
    constexpr std::size_t mostPoints = 256;
    double all = 0, unbound = 0;
    for (const SurfaceSample& point : evenly(points.points, mostPoints))
    {
      all += point.weight;
      unbound += isInsideWithinReach(grid, point.position, isSampleInside) ? 0 : point.weight;
    }
    parts.unboundShare = all > 0 ? unbound / all : 0;
    return;
  }
  constexpr std::size_t few = 1 << 16, most = 2048;
  std::vector<std::int32_t> triangles;
  if (surface.triangles.size() <= few)
  {
    triangles.resize(surface.triangles.size());
    std::iota(triangles.begin(), triangles.end(), 0);
    triangles = chooseTriangles(surface, std::move(triangles), most);
  }
  else
  {
    for (const SurfaceSample& point : points.points)
    {
      triangles.push_back(point.triangle);
    }
  }
  const std::vector<SurfaceSample> samples = this->affordable(
    sampleTriangles(surface, trianglesOutOfReach(surface, triangles, grid, isSampleInside)),
    executor);
  if (samples.empty())
  {
    return;
  }
  const std::vector<SampleLine> lines = linesThrough(surface, samples, points, executor);
  double thinnest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    const double voxel = lines[i].wall / samples[i].normal.cwiseAbs().sum();
    if (isBound(lines[i], isInside) && voxel > 0 && voxel < thinnest)
    {
      thinnest = voxel;
      parts.lostPlace = samples[i].position;
      parts.voxels = {voxel};
    }
  }
}

WallSamples Diagnosis::boundingWalls(const InsideTest& isInside, Executor& executor) const
{
  if (cloud_)
  {
    return {};
  }
  WallSamples walls = this->walls(executor);
  const double scale = unitScale(facts_.distinct->bounds);
  for (SurfaceSample& point : walls.points)
  {
    point.weight /= scale * scale;
  }
  if (walls.areWhole)
  {
    for (SampleLine& line : walls.lines)
    {
      line.wall = isBound(line, isInside) ? line.wall : std::numeric_limits<double>::infinity();
    }
  }
  else if (!this->isClosed())
  {
    const Lines& lines = this->lines(executor);
    double all = 0, bounds = 0;
    for (std::size_t i = 0; i < lines.points.size(); ++i)
    {
      all += lines.points[i].weight;
      bounds += isBound(*lines.ofPoint(i), isInside) ? lines.points[i].weight : 0;
    }
    for (double& share : walls.shares)
    {
      share = bounds > 0 ? share * all / bounds : std::numeric_limits<double>::infinity();
    }
  }
  return walls;
}

bool Diagnosis::hasEnclosedPoints(Executor& executor) const
{
  if (cloud_ || facts_.distinct->triangles.empty())
  {
    return false;
  }
  const Lines& found = this->lines(executor);
  int places = 0;
  for (std::size_t i = 0; i < found.points.size(); ++i)
  {
    const SampleLine* const lines = found.ofPoint(i);
    places += std::all_of(lines + 1, lines + Lines::perPoint,
      [](const SampleLine& line) { return line.facesBefore > 0 && line.facesBehind > 0; });
  }
  return places > 1;
}

std::vector<SampleLine> Diagnosis::linesAlong(WallSamples& walls, Executor& executor) const
{
  if (cloud_)
  {
    return {};
  }
  walls.leave(this->affordable(walls.points, executor).size());
  std::vector<SurfaceSample> places = walls.points;
  for (SurfaceSample& place : places)
  {
    place.triangle = -1; // it is one of another surface
  }
  return linesThrough(*facts_.distinct, places, this->points(executor), executor);
}

std::vector<LineHit> Diagnosis::hits(
  const std::vector<SurfaceSample>& samples, Executor& executor) const
{
  return hitsOfLines(*facts_.distinct, samples, this->points(executor), executor);
}

double Diagnosis::middleAtFaces(Executor& executor) const
{
  if (cloud_ || this->isClosed())
  {
    return 0.5;
  }
  const Surface& surface = *facts_.distinct;
  constexpr std::size_t places = 32;
  const double step = 1e-6 * surface.bounds.sizes().maxCoeff();
  SampleBlock block;
  for (const SurfaceSample& point : evenly(this->points(executor).points, places))
  {
    block.set(block.count++, point.position - step * point.normal);
    block.set(block.count++, point.position + step * point.normal);
  }
  double values[SampleBlock::capacity];
  TriangleSum(surface.vertices, {surface.triangles, surface.multiplicities}, surface.bounds)
    .evaluate(block, values);
  std::vector<double> middles;
  for (std::size_t i = 0; i + 1 < block.count; i += 2)
  {
    middles.push_back((values[i] + values[i + 1]) / 2);
  }
  std::sort(middles.begin(), middles.end());
  return middles.empty() ? 0.5 : middles[middles.size() / 2];
}

std::size_t Diagnosis::pieces() const
{
  constexpr std::size_t most = 1 << 16;
  const std::lock_guard<std::recursive_mutex> lock(lock_);
  if (!pieces_)
  {
    const bool areFew = !cloud_ && facts_.distinct->triangles.size() <= most;
    pieces_ = areFew ? piecesOf(*facts_.distinct) : 0;
  }
  return *pieces_;
}

double Diagnosis::volume(Executor& executor) const
{
  const std::lock_guard<std::recursive_mutex> lock(lock_);
  if (!volume_ && !this->isClosedSurface())
  {
    volume_ = 0;
  }
  if (!volume_)
  {
    const Surface& surface = *facts_.distinct;
    const ChainView chain(surface);
    const Eigen::Vector3d middle = surface.bounds.center();
    volume_ = sumOverItems(
      chain.size(),
      [&](std::size_t i, double& sum)
      {
        const Triangle& t = chain[i];
        const Eigen::Vector3d a = surface.vertices[t[0]] - middle;
        const Eigen::Vector3d b = surface.vertices[t[1]] - middle;
        const Eigen::Vector3d c = surface.vertices[t[2]] - middle;
        sum += chain.multiplicity(i) * a.dot(b.cross(c)) / 6;
      },
      executor);
  }
  return *volume_;
}

} // namespace winding
