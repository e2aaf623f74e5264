#pragma once

#include "base/Executor.h"
#include "base/FieldOutput.h"
#include "rays/RowCrossings.h"
#include "source/Grid.h"
#include "source/Surface.h"
#include "sums/DirectSum.h"
#include "surface/Boundary.h"

#include <memory>

namespace winding
{

class TriangleFarField;

/**
 * The winding number of a surface on grids, as the difference of two parts that are each easy:
 *
 *   w_M = χ_{M+C} − w_C   for a cap C with ∂C = −∂M
 *
 * χ is an integer, found for whole rows at once (RowCrossings.h); w_C is that of the cap, which has
 * about as many triangles as the surface has boundary edges, and none if it is closed. Without a
 * tolerance it is the direct sum; within one, and for caps of more than a few triangles, it comes
 * from the far field (EvaluationCost.h).
 *
 * Guaranteed: (1) for a closed surface, integers, exact off the surface; (2) for an open one, equal to
 * the direct sum up to its rounding or the tolerance, next to the cap too: there χ and w_C jump by
 * the same 1, and where rounding could make them disagree about the side, another cap that is
 * elsewhere decides; (3) values have the same bits for any extent, executor and number of threads. On
 * the surface: one of the sides for a closed one; for an open one finite, and mostly one of the sides.
 */
class CappedSurface
{
public:
  /// How w_C is found where the tolerance admits a choice.
  enum class CapSum
  {
    cheapest,
    farField
  };

  /// Keeps a reference to the surface, which must outlive this; chain is its boundary. tolerance: the
  /// largest error of w, 0 for none.
  CappedSurface(const Surface& surface, const BoundaryChain& chain, double tolerance,
    CapSum capSum = CapSum::cheapest);
  ~CappedSurface();

  /// 0 if the surface is closed.
  std::size_t capTriangles() const { return cap_.size(); }

  /// Of the surface and its cap: χ.
  const RowCrossings& rows() const { return rows_; }

  /// Whether w_C comes from the far field.
  bool usesFarField() const { return capFarField_ != nullptr; }

  /// Builds what a grid needs beforehand, as Field::prepare() does.
  bool prepare(const Grid& grid, Executor& executor) const;

  /// False when the executor was interrupted.
  bool evaluate(
    const Grid& grid, const Extent& extent, const FieldOutput& output, Executor& executor) const;

private:
  class Bar;

  bool evaluateByFarField(
    const Grid& grid, const Extent& extent, const FieldOutput& output, Executor& executor) const;
  void evaluateRow(const Grid& grid, const Extent& extent, int j, int k,
    const std::vector<RowRun>& runs, const FieldOutput& output) const;
  double resolveOnCap(const Grid& grid, int i, int j, int k, int rowValue) const;

  std::vector<Triangle> cap_;
  std::vector<Eigen::Vector3d> fanVertices_;
  std::vector<Triangle> fan_; ///< the other cap
  RowCrossings rows_;         ///< of M + C
  RowCrossings capRows_, fanRows_;
  TriangleSum surfaceSum_, capSum_, fanSum_;
  std::unique_ptr<const TriangleFarField> capFarField_; ///< null where the cap is summed directly
};

} // namespace winding
