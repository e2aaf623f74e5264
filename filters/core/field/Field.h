// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/Executor.h"
#include "base/FieldOutput.h"
#include "base/Lazy.h"
#include "base/Message.h"
#include "base/SampledSource.h"
#include "base/Views.h"
#include "cloud/CloudOrientation.h"
#include "cloud/NormalEstimation.h"
#include "cloud/PointAreas.h"
#include "rays/RowCrossings.h"
#include "source/Grid.h"
#include "surface/Openings.h"

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace winding
{

class Diagnosis;
class DistanceTree;
class Evaluator;
class GradientEvaluator;
struct PointCloud;
struct Surface;

/// The way in which w is found. Every method but parity gives the winding number.
enum class Method
{
  automatic, ///< the method that is expected to be the fastest within the tolerance
  /// Crossings of triangles. On grids they are found for whole rows at once, with a cap over the
  /// holes of an open surface (CappedSurface.h); at scattered samples a ray from each
  /// finds them (PointCrossings.h). Points have none.
  rows,
  hierarchical, ///< a far field of all primitives (FarField.h)
  direct,       ///< the sum over all primitives, exact up to rounding
  parity        ///< ray casting, the baseline; for triangles only
};

const char* nameOf(Method method);

/// The largest regularization. Points that are spread farther have many others near them, to be
/// summed one by one, that a far field saves little.
constexpr double mostRegularization = 4;

struct FieldOptions
{
  Method method = Method::automatic;
  /// The largest absolute error of w that an approximation may make at any sample. Tolerances below
  /// FarFieldAccuracy::finest (1e-6), 0 among them, forbid approximations.
  double tolerance = 1e-3;
  /// Whether points without normals get estimated ones (NormalEstimation.h).
  bool estimateNormals = false;
  /// Whether a warning names normals that are kept though others are to be estimated.
  bool warnsOfKeptNormals = true;
  NormalEstimation normalEstimation = NormalEstimation::automatic;
  /// Where the points were seen from, for estimated normals; see Viewpoints. Empty: not known.
  std::string toward;
  /// Whether the normals only look to where each point was seen from: others are estimated, which
  /// look there unless `toward` says where.
  bool lookAtViewpoints = false;
  PointAreaMethod pointAreaMethod = PointAreaMethod::voronoi;
  /// The area of every point, for PointAreaMethod::constant only; 0 stands for the mean of the
  /// areas that PointAreaMethod::voronoi gives.
  double pointArea = 0;
  /// The number of neighbours that the area and the normal of a point are taken from; 3 or more.
  int neighbors = defaultNeighbors;
  /// The length over which the dipole of each point of a cloud is spread (SolidAngle.h), in units
  /// of the point's spacing, which is the square root of its area; 0 to mostRegularization. 0
  /// leaves the pure dipole.
  double regularization = 0;
  /// Whether the source is to be a solid: points without normals get estimated ones, and faces are
  /// turned as with orientFaces if Diagnosis::faultToTurn() asks for it.
  bool mendsSource = false;
  /// Whether triangles are turned first, so that solids have an outside, and doubled faces are
  /// taken once (Orientation.h). Property (5) of Field holds no longer where areas are equal.
  bool orientFaces = false;
  /// Whether open parts inside of closed ones are left out (OpenParts.h), after that.
  bool ignoreOpenParts = false;
  /// The planes of symmetry, where the source is one side of them (Mirror.h). Empty: none.
  std::string mirror;
  /// The base that closes a surface that is open on one side (FlatBase.h). Empty: none.
  std::string flatBase;
  /// The direction of the side of open sheets that is inside (SheetSide.h). Empty: none. Points
  /// are one sheet, unless their normals look to all sides alike.
  std::string sheetSide;
  /// The distance up to which the caller has welded points (SnappedPoints.h), which is the reach of
  /// the planes of symmetry, too.
  double weldTolerance = 0;
  /// Whether scattered samples will be asked for rather than grids: methods that share work along
  /// the rows of a grid are no use then.
  bool scattered = false;
  /// Whether other sources have the same options, so that one of these may be for them alone.
  bool isOneOfSeveral = false;

  bool operator==(const FieldOptions& other) const
  {
    return method == other.method && tolerance == other.tolerance && pointArea == other.pointArea &&
           estimateNormals == other.estimateNormals && normalEstimation == other.normalEstimation &&
           toward == other.toward && lookAtViewpoints == other.lookAtViewpoints &&
           pointAreaMethod == other.pointAreaMethod && neighbors == other.neighbors &&
           regularization == other.regularization && orientFaces == other.orientFaces &&
           ignoreOpenParts == other.ignoreOpenParts && mirror == other.mirror &&
           weldTolerance == other.weldTolerance && flatBase == other.flatBase &&
           sheetSide == other.sheetSide && scattered == other.scattered &&
           mendsSource == other.mendsSource;
  }
};

/// Returns options whose texts are about space for a source in other coordinates: those that begin
/// at `origin`, along axes at right angles with this inverse. Throws Refusal for texts that are not
/// right.
FieldOptions optionsAlong(
  const FieldOptions& options, const Eigen::Matrix3d& inverseAxes, const Eigen::Vector3d& origin);

/// An option that a source has no use for, and what to say of that.
struct UnusedOption
{
  Parameter option;
  Message message;
};

/// The make-up of a field and the way it will be evaluated: for reports, not for computing.
struct FieldInfo
{
  bool isSurface = true;
  std::size_t inputPrimitives = 0; ///< triangles or points that came in
  std::size_t primitives = 0;      ///< triangles or points that w is the sum over
  std::size_t distinct = 0;        ///< those that differ: equal triangles are summed once
  std::size_t dropped = 0;         ///< primitives with NaN, bad ids, zero normals, negative areas
  std::size_t weldedVertices = 0;  ///< a surface's different vertices, or a cloud's points
  std::size_t boundaryEdges = 0;   ///< edges used by one triangle
  std::size_t contradictingEdges = 0; ///< edges that two triangles use in the same sense
  std::size_t netBoundaryEdges = 0;   ///< edges whose uses do not cancel: 0 makes w an integer
  /// Triangles that close the surface for method rows. It is 0 where the boundary alone shows that
  /// they are too many: then they are not made.
  std::size_t capTriangles = 0;
  Openings openings;       ///< of a surface
  bool isOriented = false; ///< whether faces were turned and taken once, or all normals turned
  bool turnedLooseParts = false; ///< whether parts that share no edges were turned (LooseParts.h)
  /// The number that values have in addition to the sum: ½ for sheets of faces or of points, which
  /// divide space and which a half sphere at infinity closes (SheetSide.h).
  double added = 0;
  double sheetHeight = 0;           ///< coordinate of their middle along the side that is inside
  double pointArea = 0;             ///< mean area of a cloud's points
  bool normalsAreEstimated = false; ///< true only for clouds that came without normals
  /// The way in which normals were estimated, if they were: never automatic.
  NormalEstimation normalEstimation = NormalEstimation::spanningTree;
  CloudOrientation orientation;     ///< of estimated normals, once turned outward
  Bounds bounds;                    ///< box of the vertices or points
  bool isScattered = false;         ///< whether scattered samples were announced, not grids
  Method method = Method::direct;   ///< method that was chosen, never automatic
  double tolerance = 0;             ///< FieldOptions::tolerance
  std::string why;                  ///< reason for the choice of the method, for the user
  std::vector<Message> warnings;    ///< notes on the input that the user should read
  std::vector<UnusedOption> unused; ///< of FieldOptions::isOneOfSeveral; else among the warnings

  /// Notes an option that the source has no use for.
  void addUnused(Parameter option, const Message& message, const FieldOptions& options)
  {
    if (options.isOneOfSeveral)
    {
      unused.push_back({option, message});
    }
    else
    {
      warnings.push_back(message);
    }
  }

  /// Whether w changes at triangles only, as for a closed surface.
  bool jumpsOnly() const { return isSurface && netBoundaryEdges == 0; }
};

/**
 * The winding field of one source: the way into the core. It is built once by build() and
 * immutable. All evaluation is const and may run on several threads at once. Every function that
 * takes an executor throws Interrupted.
 *
 * Guaranteed: (1) the value of a sample of a grid depends, to the bit, on the source and on the
 * grid as a whole only, never on the extent, the pieces that the grid is cut into, the executor or
 * its threads; (2) the value of a scattered sample depends, to the bit, on the source and the
 * sample's position only, except that a far field makes it depend, within the tolerance, on the
 * other samples, if there are any; (3) a position has the same value as a sample of a grid and as a
 * scattered sample, up to rounding and the tolerance, and to the bit with method direct or parity;
 * (4) a field without primitives is 0 everywhere; (5) the source is the set of its primitives, each
 * as often as it is there: the bits on grids and at scattered samples, of distances and
 * gradients too, depend neither on the order of triangles, of points and of views, nor on the
 * corner that a triangle begins with, nor on whether triangles share points or have equal ones
 * (CoordinateOrder.h). A polygon that is cut into other triangles is another source. Estimates of
 * costs, the mean area in FieldInfo, reference() and pointOnSource() are left out of (5): they may
 * differ by rounding, or give other points, for another order.
 *
 * Method automatic is to take no more than 1.5 times as long as method direct, and 10 ms, for any
 * triangles, on a whole grid or at scattered samples. Of 400 dense soups of 500 to 50 000 triangles
 * none took longer, on one thread with AVX2: the worst took 1.36 times as long, and 10 ms
 * (SoupTimeTest.cxx, and the differential program). One of 10 000 small soups took 2 ms longer,
 * where crossings had to be decided exactly. A grid in pieces of one layer took up to 1.7 times as
 * long, since cells look at their nodes for each piece. For clouds nothing is promised: of 31 with
 * 500 to 50 000 points the worst took 1.3 times as long.
 *
 * Triangles that are there several times are summed once (DistinctTriangles.h). A far field gives
 * way to the direct sum where it would save nothing. It does as a whole for few samples, and in
 * cells that would look at too many nodes, or are near to more pieces of large triangles than there
 * are triangles (FarFieldTraversal.h). Method rows gives way to a far field where its cap has a
 * sixth of the surface's triangles.
 *
 * Distances, where an output wants them, are measured to the nearest point of the triangles, or to
 * the nearest of the cloud's points: exact up to rounding (double), whatever the method and the
 * tolerance. Their bits depend on the source and on the sample's position only, and on a grid on
 * the grid as a whole. Their signs follow `inside`; an output that has neither `inside` nor
 * values takes one more byte of memory per sample for the signs. Without primitives every distance
 * is infinite.
 */
class Field
{
public:
  /// Builds the field of all views together. Throws Refusal for unusable input (see Sanitize.h) or
  /// a method that cannot serve it.
  static std::shared_ptr<const Field> build(
    const std::vector<TrianglesView>& views, const FieldOptions& options, Executor& executor);
  static std::shared_ptr<const Field> build(
    const std::vector<OrientedPointsView>& views, const FieldOptions& options, Executor& executor);

  Field();
  virtual ~Field();

  virtual const FieldInfo& info() const = 0;

  /// Returns what is to be said of the source and of results, which is found out when it is asked.
  virtual const Diagnosis& diagnosis() const = 0;

  ///@{
  /**
   * Builds what an evaluation of these samples needs beyond what build() has made
   * (TriangleFarField.h), and keeps it for the next evaluation. evaluate() does so itself where it
   * has to: prepare() is for callers who want to time the building apart.
   */
  virtual void prepare(const Grid& grid, Executor& executor) const;
  virtual void prepare(const VectorsView& samples, Executor& executor) const;
  ///@}

  /// Builds what distances need (DistanceTree.h), and keeps it, as prepare() does for values.
  void prepareDistances(Executor& executor) const;

  /// Returns the tree that all distances are found with, which is made when it is first needed.
  const DistanceTree& distanceTree(Executor& executor) const;

  /// Evaluates the samples of an extent of a grid.
  void evaluate(
    const Grid& grid, const Extent& extent, const FieldOutput& output, Executor& executor) const;

  /// Evaluates scattered samples. An open surface with a method that was chosen automatically gets
  /// the values of few samples from the direct sum where that is faster.
  void evaluate(const VectorsView& samples, const FieldOutput& output, Executor& executor) const;

  /// Returns the distances of scattered samples from the source, without signs.
  std::vector<double> distances(const VectorsView& samples, Executor& executor) const;

  /**
   * Writes the gradient of the winding number at scattered samples, whatever the method, as
   * #samples by 3 numbers, in 1/length, with respect to the coordinates of the samples.
   *
   * The gradient of a surface is exact up to rounding and comes from the boundary alone
   * (BoundaryGradient.h): it is exactly 0 where the boundary is empty, and the same on both sides
   * of a triangle; a boundary edge adds 0 to samples on it. The gradient of a cloud is exact up to
   * rounding with method direct, and within a tolerance with method hierarchical
   * (FarField::gradient()); a point that is not regularized adds 0 to samples on it.
   *
   * Gradients are NaN at samples that are NaN or infinite, and finite at all others. Their bits
   * depend on no more than the bits of values at scattered samples do.
   */
  virtual void gradient(const VectorsView& samples, double* gradients, Executor& executor) const;

  /// Returns the field of the source turned, or itself if that is unclear: as orientFaces says, or
  /// by LooseParts.h where that has been done or turns nothing, or with all normals of a cloud
  /// turned round. It is built once and kept.
  const Field& turned(Executor& executor) const;

  /// The triangles that it is the field of, as they came in; null for points.
  virtual const Surface* surface() const { return nullptr; }

  /// The same triangles, equal ones taken together (DistinctTriangles.h); null for points.
  virtual const Surface* distinctSurface() const { return nullptr; }

  /// The points that it is the field of; null for triangles.
  virtual const PointCloud* cloud() const { return nullptr; }

  /// The row crossings that alone give all values on grids: a closed surface with method rows has
  /// them; null for any other field.
  virtual const RowCrossings* integerRows() const { return nullptr; }

  /// The area of the source, in squares of its unit of length; equal triangles count once.
  virtual double area() const = 0;

  /// Returns the measures of the source and of `samples` samples that choices depend on.
  SampledSource sampledSource(std::size_t samples) const;

  /// Returns the expected memory of the field and its values at `samples` samples. They are a
  /// grid's, or scattered if these were announced (FieldOptions::scattered).
  virtual std::size_t expectedBytes(std::size_t samples) const = 0;

  /// Returns the expected memory of the distances of `samples` samples, without expectedBytes().
  std::size_t expectedBytesOfDistances(std::size_t samples) const;

  /// The value by definition: an independent, slow sum in double (ReferenceSum.h).
  virtual double reference(const Eigen::Vector3d& sample) const = 0;

  /**
   * Bounds by how much w may change within a distance from a sample where w is right: each triangle
   * that is so near adds 1, by which its two sides differ; a point that is so near and not
   * regularized makes it infinite. It is 0 elsewhere. Slow, as reference() is.
   */
  virtual double jumpWithin(const Eigen::Vector3d& sample, double distance) const = 0;

  /// Gives points of the source that are evenly distributed if u, v, t are so over [0, 1).
  using PointOnSource = std::function<Eigen::Vector3d(double u, double v, double t)>;

  /// Makes a PointOnSource in linear time, which is valid as long as the field. The field must have
  /// primitives.
  virtual PointOnSource pointOnSource() const = 0;

protected:
  ///@{
  /// The part of evaluate() that gives values and sides; distances are left out.
  virtual void evaluateValues(
    const Grid& grid, const Extent& extent, const FieldOutput& output, Executor& executor) const;
  virtual void evaluateValues(
    const VectorsView& samples, const FieldOutput& output, Executor& executor) const;
  ///@}

  /// Makes the field of the source turned, or none if that is unclear. Throws Interrupted.
  virtual std::shared_ptr<const Field> makeTurned(Executor& executor) const = 0;

  /// Makes the tree that all distances are found with. Throws Interrupted.
  virtual std::unique_ptr<const DistanceTree> makeDistanceTree(Executor& executor) const = 0;

  virtual const Evaluator& evaluator() const = 0;
  virtual const GradientEvaluator& gradientEvaluator() const = 0;

private:
  template <class PositionOf>
  void evaluateBlocks(std::size_t samples, const PositionOf& positionOf, const FieldOutput& output,
    Executor& executor) const;
  template <class EvaluateValues, class EvaluateDistances>
  void evaluateBoth(std::size_t samples, const FieldOutput& output, Executor& executor,
    const EvaluateValues& evaluateValues, const EvaluateDistances& evaluateDistances) const;

  Lazy<std::unique_ptr<const DistanceTree>> distanceTree_;
  Lazy<std::shared_ptr<const Field>> turned_;
};

} // namespace winding
