#pragma once

#include "base/Bounds.h"
#include "base/EvaluationCost.h"
#include "base/Executor.h"
#include "base/FieldOutput.h"
#include "base/Views.h"
#include "cloud/CloudOrientation.h"
#include "cloud/PointAreas.h"
#include "rays/RowCrossings.h"
#include "source/Grid.h"

#include <functional>
#include <memory>
#include <mutex>
#include <string>

namespace winding
{

class DistanceTree;
class Evaluator;
class GradientEvaluator;
class RowCrossings;
struct PointCloud;
struct Surface;

/// How w is found. Every method but parity gives the winding number.
enum class Method
{
  automatic, ///< the fastest that keeps the tolerance
  /// Crossings, of triangles only: whole grid rows at once, a cap over holes (CappedSurface.h); closed
  /// surfaces at scattered samples, too (PointCrossings.h).
  rows,
  hierarchical, ///< a far field of all primitives (FarField.h)
  direct,       ///< the sum over all primitives, exact up to rounding
  parity        ///< ray casting, the baseline; triangles only
};

const char* nameOf(Method method);

/// The largest regularization: beyond, sums near points take over what the far field is for.
constexpr double mostRegularization = 4;

struct FieldOptions
{
  Method method = Method::automatic;
  /// Largest absolute error of w at any sample that an approximation may make. Below
  /// FarFieldAccuracy::finest (1e-6), and so with 0, there is none.
  double tolerance = 1e-3;
  /// Whether points without normals get estimated ones (NormalEstimation.h).
  bool estimateNormals = false;
  PointAreaMethod pointAreaMethod = PointAreaMethod::voronoi;
  /// Method constant: the area of every point; 0: the mean of what method voronoi gives.
  double pointArea = 0;
  /// How many neighbours of a point tell its area and normal; 3 or more.
  int neighbors = defaultNeighbors;
  /// Clouds: length over which a point's dipole is spread (SolidAngle.h), in units of its spacing, the
  /// square root of its area; 0: the pure dipole.
  double regularization = 0;
  /// Whether scattered samples will be asked for, not grids: methods that share work along the rows
  /// of a grid are no use then.
  bool scattered = false;

  bool operator==(const FieldOptions& other) const
  {
    return method == other.method && tolerance == other.tolerance && pointArea == other.pointArea &&
           estimateNormals == other.estimateNormals && pointAreaMethod == other.pointAreaMethod &&
           neighbors == other.neighbors && regularization == other.regularization &&
           scattered == other.scattered;
  }
};

/// What a field is made of and how it will be evaluated: for reports, not for computing.
struct FieldInfo
{
  bool isSurface = true;
  std::size_t inputPrimitives = 0;  ///< triangles or points that came in
  std::size_t primitives = 0;       ///< those that are summed over
  std::size_t dropped = 0;          ///< unusable ones: NaN, bad ids, zero normals, negative areas
  std::size_t weldedVertices = 0;   ///< surfaces: different vertices; clouds: points
  std::size_t boundaryEdges = 0;    ///< edges used by one triangle
  std::size_t netBoundaryEdges = 0; ///< edges whose uses do not cancel: 0 makes w an integer
  std::size_t capTriangles = 0;     ///< method rows: triangles that close the surface
  double pointArea = 0;             ///< clouds: the mean area of a point
  bool normalsAreEstimated = false; ///< clouds
  CloudOrientation orientation;     ///< of estimated normals, turned outward
  Bounds bounds;
  Method method = Method::direct; ///< the one chosen, never automatic
  std::string why;                ///< why this one, for the user
  std::string warning;            ///< what the user should know about the input; may be empty
};

/**
 * The winding field of one source, built once and immutable. All evaluation is const and may run
 * from several threads at once.
 *
 * Guaranteed: on a grid, the bits of a sample's value depend on the source and on the grid as a whole
 * only: not on the extent, the pieces that a grid is cut into, the executor or its threads. Scattered,
 * they depend on the source and the sample's position; where a far field is used, on the other
 * samples too, within the tolerance, unless there is one only. On a grid and scattered, a sample has
 * the same value up to rounding and the tolerance, and the same bits with method direct or parity.
 * A field without primitives is 0 everywhere.
 *
 * Distances, where an output wants them, are those from the nearest point of the triangles that the
 * field is of, or from the nearest of its points: exact up to rounding (double), whatever the method and
 * the tolerance. Of a sample they depend on the source and on the sample's position only, and on a grid
 * on the grid as a whole. Their signs are those of `inside`; where an output has neither that nor values,
 * a byte per sample more is needed. Without primitives every distance is infinite.
 */
class Field
{
public:
  /// Throws Refusal for unusable input (see Sanitize.h) or a method that cannot serve it. Null when
  /// the executor was interrupted; never otherwise.
  static std::shared_ptr<const Field> build(
    const std::vector<TrianglesView>& views, const FieldOptions& options, Executor& executor);
  static std::shared_ptr<const Field> build(
    const std::vector<OrientedPointsView>& views, const FieldOptions& options, Executor& executor);

  Field();
  virtual ~Field();

  virtual const FieldInfo& info() const = 0;

  ///@{
  /**
   * Builds what an evaluation of these samples needs beyond what build() has made (FarField.h), and
   * keeps it for the next. An evaluation does so itself where it has to; this is for who wants to
   * tell the time that it takes apart. False when the executor was interrupted.
   */
  virtual bool prepare(const Grid& grid, Executor& executor) const;
  virtual bool prepare(const VectorsView& samples, Executor& executor) const;
  ///@}

  /// Builds what distances need, and keeps it, likewise.
  bool prepareDistances(Executor& executor) const;

  /// Evaluates the samples of an extent of a grid. False when the executor was interrupted.
  bool evaluate(
    const Grid& grid, const Extent& extent, const FieldOutput& output, Executor& executor) const;

  /// Evaluates scattered samples; where the method needs a grid, as open surfaces by rows do,
  /// hierarchically as far as the tolerance admits that. False when the executor was interrupted.
  bool evaluate(const VectorsView& samples, const FieldOutput& output, Executor& executor) const;

  /**
   * The gradient of the winding number at scattered samples, whatever the method, into #samples by 3
   * numbers: in 1/length, with respect to the coordinates of the samples. False when the executor was
   * interrupted.
   *
   * Surfaces: exact up to rounding, from the boundary alone (BoundaryGradient.h): exactly 0 where that
   * is empty, the same from both sides on triangles; on a boundary edge that edge counts as 0. Clouds:
   * exact up to rounding with method direct; within a tolerance with method hierarchical
   * (FarField::gradient()); on a point that is not regularized that point counts as 0.
   *
   * NaN at samples that are NaN or infinite, finite at all others. Bits depend on what those of values
   * at scattered samples depend on.
   */
  virtual bool gradient(const VectorsView& samples, double* gradients, Executor& executor) const;

  /// The triangles that it is the field of; null for points.
  virtual const Surface* surface() const { return nullptr; }

  /// The points that it is the field of; null for triangles.
  virtual const PointCloud* cloud() const { return nullptr; }

  /// The rows that are all there is to the values on grids: those of a closed surface with method rows;
  /// null for any other.
  virtual const RowCrossings* integerRows() const { return nullptr; }

  /// What an evaluation of so many samples is expected to take, from the input on: an estimate.
  virtual EvaluationCost expectedCost(std::size_t samples) const = 0;

  /// What distances of so many samples are expected to take beside that.
  EvaluationCost expectedCostOfDistances(std::size_t samples) const;

  /// The definition's own value by an independent, slow sum in double (ReferenceSum.h).
  virtual double reference(const Eigen::Vector3d& sample) const = 0;

  /// Points of the source, evenly distributed for u, v, t evenly distributed over [0, 1).
  using PointOnSource = std::function<Eigen::Vector3d(double u, double v, double t)>;

  /// Made on request, in linear time, and valid as long as the field; not for one without primitives.
  virtual PointOnSource pointOnSource() const = 0;

protected:
  ///@{
  /// evaluate(), but for distances.
  virtual bool evaluateValues(
    const Grid& grid, const Extent& extent, const FieldOutput& output, Executor& executor) const;
  virtual bool evaluateValues(
    const VectorsView& samples, const FieldOutput& output, Executor& executor) const;
  ///@}

  /// Throws Interrupted.
  virtual std::unique_ptr<const DistanceTree> makeDistanceTree(Executor& executor) const = 0;

  virtual const Evaluator& evaluator() const = 0;
  virtual const GradientEvaluator& gradientEvaluator() const = 0;

private:
  template <class PositionOf>
  bool evaluateBlocks(std::size_t samples, const PositionOf& positionOf, const FieldOutput& output,
    Executor& executor) const;
  template <class EvaluateValues, class EvaluateDistances>
  bool evaluateBoth(std::size_t samples, const FieldOutput& output, Executor& executor,
    const EvaluateValues& evaluateValues, const EvaluateDistances& evaluateDistances) const;
  const DistanceTree* distanceTree(Executor& executor) const;

  mutable std::mutex distanceTreeLock_;
  mutable std::unique_ptr<const DistanceTree> distanceTree_; ///< made when it is first needed
};

} // namespace winding
