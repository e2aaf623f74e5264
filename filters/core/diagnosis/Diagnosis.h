// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/InsideRule.h"
#include "base/Message.h"
#include "base/SideCounts.h"
#include "cloud/CloudOrientation.h"
#include "diagnosis/ThinParts.h"
#include "rays/SampleLines.h"
#include "source/PointCloud.h"
#include "source/Surface.h"
#include "surface/Boundary.h"
#include "surface/Openings.h"

#include <mutex>
#include <optional>
#include <vector>

namespace winding
{

/// The facts that building a field has found about its surface.
struct SurfaceFacts
{
  const Surface* surface;  ///< as it came in, or was completed
  const Surface* distinct; ///< the same triangles, equal ones taken together
  std::size_t netBoundaryEdges = 0;
  bool hasRims = false;    ///< whether there are edges that one triangle uses
  bool hasNoSides = false; ///< whether all triangles are there in both senses
  /// Whether edges that more than two triangles share, or two in the same sense, have more ends
  /// than a tenth of the vertices.
  bool hasManyCrowds = false;
  std::vector<Contradiction> contradictions; ///< edges that two triangles use in the same sense
  Openings openings;
  bool isOriented = false; ///< whether faces were turned and taken once
  bool isSheet = false;    ///< whether sheets divide space
};

/// The use of a source, by which it matters whether it is open on a whole side.
struct OpenSideUse
{
  double threshold = 0.5;
  bool takesTouchedVoxels = false; ///< whether voxels that the source touches are inside
  bool mayCloseBorder = false;     ///< whether the result ends at the grid's border, open
};

/// The way in which a source faces, by the winding numbers of samples.
struct Facing
{
  bool looksInward = false; ///< as a whole or in part
  bool contradicts = false; ///< whether normals of a cloud contradict each other
  bool isInsideOut = false; ///< as a whole
  bool isOfSheets = false;  ///< whether it is of open sheets, which bound nothing
  std::optional<Message> warning;
};

/// Returns what to do about a source without faces or points, which welding may have taken away.
Message emptySourceAdvice(bool isWelded);

/**
 * All that is found out about a source and its results only to be said. It changes no number. Each
 * question is answered when it is first asked and once for a source, whatever the grids, thresholds
 * and front ends, on any number of threads. Answers depend on the set of triangles alone: neither
 * on their order nor on threads, clocks or machines.
 *
 * Answers come from samples of fixed numbers, and fewer where lines would have to be tested by more
 * triangles than affordableShare() admits. Shares of walls are good to a few hundredths. Times are
 * for a triangle of a mesh of 100 000:
 *
 * | question | from | time |
 * |---|---|---|
 * | are faces there in both senses | equal triangles, which the field finds | 0 |
 * | are faces there twice | lines through 40 points and 16 equal triangles | 30 ns |
 * | do faces contradict each other | edges, which the field finds | 0 |
 * | do open parts lie in closed ones | the same lines | 0 |
 * | does the source look inward | the result, the same lines, and volumes of parts | 40 ns |
 * | do a cloud's normals | the result, and w at 2000 points where that is in doubt | 500 ns |
 * | are walls thinner than a voxel | lines through 512 or 1024 points, some triangles | 30 ns |
 *
 * Few surfaces need more than one of these. So a tenth of the time of a field, and 2 ms, are enough
 * (tests/core/diagnosis). Volumes are found for up to 65 536 triangles, patches with one side for
 * up to 16 384. Less than a hundredth of the area may go unnoticed, and what lines along the axes
 * do not show: stacks of slanted open parts, and faces that are there twice among many that are
 * not. Members throw Interrupted.
 */
class Diagnosis
{
public:
  /// Keeps references. Takes no time.
  explicit Diagnosis(SurfaceFacts facts);

  /// Keeps a reference to a cloud with normals. `hasNoSides` says that all of these are equal, and
  /// `areEstimated` that they were not given.
  Diagnosis(const PointCloud& cloud, bool hasNoSides, bool areEstimated);

  /// Returns whether no side is inside: all faces are there in both senses, or all normals equal.
  bool hasNoSides(Executor& executor) const;

  /// Returns what is wrong with the source, what spoils most first.
  std::vector<Message> ofSource(Executor& executor) const;

  /// Returns the fault for which faces are best turned: they contradict each other, are there more
  /// than once, or look inward through one open side. Others take the result (facing()).
  std::optional<Message> faultToTurn(Executor& executor) const;

  /// Returns whether a surface bounds nothing: its openings leave no room for an inside, or most
  /// of it has one side only.
  bool isSheet(Executor& executor) const;

  /// Returns what to do about a source that is open on a whole side, where it matters.
  std::optional<Message> ofOpenSide(const OpenSideUse& use) const;

  /**
   * Finds out whether a source looks inward, or is of open sheets, by the sides of its result.
   * Nothing is found with rules other than InsideRule::signedThreshold, and for sources without
   * sides.
   *
   * Surfaces look inward where a hundredth or more of the samples off the outside are negative, or
   * fewer of a closed one with parts that look inward, unless they are open on a whole side
   * (Openings.h). Parts of an open surface must look inward where lines tell. Near single points of
   * a cloud w has any value; so for clouds most of these samples must be negative, and most normals
   * must point inward as well (CloudOrientation.h). Where a thirtieth or more are negative and the
   * field is not clear, clouds are open sheets, or their normals contradict each other.
   */
  Facing facing(const SideCounts& sides, const InsideTest& isInside, Executor& executor) const;

  /// Finds the parts of a surface that a grid does not show. Nothing is found for clouds. Callers
  /// leave out surfaces that look inward, whose inside is another one.
  std::optional<ThinParts> thinParts(const Grid& grid, const IsSampleInside& isSampleInside,
    const InsideTest& isInside, Executor& executor) const;

  /// Returns the walls of a surface. They are thick where they do not bound the inside: the outside
  /// lies before them and the inside behind, as far as both ends of lines agree. All walls of large
  /// closed surfaces bound it, and of large open ones a share. Weights are areas. A cloud has no
  /// walls.
  WallSamples boundingWalls(const InsideTest& isInside, Executor& executor) const;

  /// Finds what lines through walls of other surfaces meet, and leaves as many of these walls as
  /// lines can be drawn through. Returns nothing for clouds, and leaves all.
  std::vector<SampleLine> linesAlong(WallSamples& walls, Executor& executor) const;

  /// Returns as many of some samples as lines can be drawn through, evenly chosen, by `more` tests
  /// than the source alone would get. Not for clouds.
  std::vector<SurfaceSample> affordable(
    const std::vector<SurfaceSample>& samples, Executor& executor, double more = 0) const;

  /// Finds all triangles of a surface that lines along axes meet, ordered by triangle.
  std::vector<LineHit> hits(const std::vector<SurfaceSample>& samples, Executor& executor) const;

  /// Returns the orientation of a cloud, by its field.
  const CloudOrientation& orientation(Executor& executor) const;

  bool isClosedSurface() const { return !cloud_ && this->isClosed(); }

  /// Returns whether cavities are likely: of two or more places just outside of the surface, lines
  /// along all axes meet it in both directions.
  bool hasEnclosedPoints(Executor& executor) const;

  /// Returns the median winding number at points of the faces of a surface, between both sides: ½
  /// where it is closed, and less where faces are sparse. ½ for clouds.
  double middleAtFaces(Executor& executor) const;

  /// Returns the number of connected sets of four triangles or more, or 0 where there are more than
  /// 65 536 triangles.
  std::size_t pieces() const;

  /// Returns the integral of w over space, or 0 where the source is not closed.
  double volume(Executor& executor) const;

private:
  /// Lines through some points of the area and of repeated triangles.
  struct Lines
  {
    std::vector<SurfaceSample> points, repeated;
    std::vector<SampleLine> lines;

    /// The lines for each point, and for each repeated triangle.
    static constexpr std::size_t perPoint = 4, perRepeated = 7;

    std::vector<SurfaceSample> places(const Bounds& bounds) const;

    /// Returns the line along the normal of a point, and after it these along the axes through a
    /// place just before it.
    const SampleLine* ofPoint(std::size_t i) const { return lines.data() + perPoint * i; }

    /// Returns the line along the normal of a repeated triangle, and after it these along the axes
    /// through a place just behind it and one just before it.
    const SampleLine* ofRepeated(std::size_t i) const
    {
      return lines.data() + perPoint * points.size() + perRepeated * i;
    }
  };

  void findLost(const Grid& grid, const IsSampleInside& isSampleInside, const InsideTest& isInside,
    ThinParts& parts, Executor& executor) const;
  bool isClosed() const { return facts_.netBoundaryEdges == 0; }
  const SurfaceSamples& points(Executor& executor) const;
  const Lines& lines(Executor& executor) const;
  const WallSamples& walls(Executor& executor) const;
  std::vector<Message> findFaults(Executor& executor) const;
  bool doContradictionsMatter() const;
  std::optional<Message> findRepeatedFaces(Executor& executor) const;
  bool areLarge(std::size_t repeats) const;
  std::optional<Message> findOpenParts(Executor& executor) const;
  bool hasInwardPart(Executor& executor) const;
  bool hasInwardSolid(Executor& executor) const;
  bool looksMostlyInward(Executor& executor) const;
  Facing facingOfCloud(const SideCounts& sides, double threshold, Executor& executor) const;
  bool changeInside(const std::vector<SurfaceSample>& points) const;

  SurfaceFacts facts_ = {};
  const PointCloud* cloud_ = nullptr;
  bool areNormalsEstimated_ = false;

  mutable std::recursive_mutex lock_;
  mutable std::optional<SurfaceSamples> points_;
  mutable std::optional<Lines> lines_;
  mutable std::optional<WallSamples> walls_;
  mutable std::optional<std::vector<Message>> faults_;
  mutable bool isOneSided_ = false; ///< whether most triangles have one side only; with faults_
  mutable std::optional<double> volume_;
  mutable std::optional<std::size_t> pieces_;
  mutable std::optional<bool> hasInwardPart_;
  mutable std::optional<CloudOrientation> orientation_;
};

} // namespace winding
