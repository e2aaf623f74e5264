#pragma once

#include "base/Evaluator.h"
#include "farfield/MultipoleKernels.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace winding
{

/// A box of samples in a hierarchy of such; positions are in the sources' scaled coordinates.
struct TargetCell
{
  int level;             ///< 0 for the smallest cells
  Eigen::Vector3i index; ///< tells the cell from others of its level
  Eigen::Vector3d center;
  std::size_t samples;    ///< those that are asked for
  std::size_t allSamples; ///< what is decided by this number does not depend on what is asked for
};

struct TargetSphere
{
  Eigen::Vector3d center;
  double radius;
};

/// The eight matrices that make a parent's local expansion that of a child, by octant; by columns of
/// paddedCoefficients(order).
struct LocalShifts
{
  /// sideRatio: the children's side in units of the parents'. quarter: distances of the children's
  /// centres from the parent's, in the same units; 0 along axes that are not cut.
  LocalShifts(int order, double sideRatio, const Eigen::Vector3d& quarter);

  double sideRatio;
  Eigen::Vector3d quarter;
  std::vector<float> matrices[8];
};

/// What all cells of a level have in common.
struct TargetLevel
{
  double side;   ///< B: the longest side of a cell
  double radius; ///< R: no sample is farther from the centre
  /// From local expansions of parents to those of their children; null at the top.
  std::shared_ptr<const LocalShifts> fromParent;
};

/// Some samples of a cell.
struct TargetBlock
{
  SampleBlock samples; ///< positions in scaled coordinates
  /// Offsets from the cell's centre in units of B.
  alignas(64) float u[SampleBlock::capacity];
  alignas(64) float v[SampleBlock::capacity];
  alignas(64) float w[SampleBlock::capacity];
};

/**
 * Where a far field is evaluated: a hierarchy of cells of samples, and where their values go. The
 * cells' geometry never depends on which part of the samples is asked for.
 */
class TargetCells
{
public:
  virtual ~TargetCells() = default;

  const TargetLevel& level(int number) const { return levels_[static_cast<std::size_t>(number)]; }

  virtual TargetCell root() const = 0;

  struct Child
  {
    TargetCell cell;
    int octant;
  };

  /// Those children that have samples, up to eight; none at level 0.
  virtual int childrenOf(const TargetCell& cell, Child (&children)[8]) const = 0;

  /// A sphere around the samples of a cell that is not cut any further.
  virtual TargetSphere sphereOf(const TargetCell& cell) const;

  /// Samples first … first + block.samples.count − 1 of a cell, as many as fit.
  virtual void fill(const TargetCell& cell, std::size_t first, TargetBlock& block) const = 0;

  /// Takes the values of those samples. isSuspect may be null.
  virtual void store(const TargetCell& cell, std::size_t first, std::size_t count,
    const float* values, const bool* isSuspect) const = 0;

  /// The rows that storePolynomial() goes along there; 0 where it goes from sample to sample, which
  /// costs more.
  virtual std::size_t rowsOf(const TargetCell&) const { return 0; }

  /// Evaluates a polynomial at all samples of a cell, and takes the values.
  virtual void storePolynomial(const TargetCell& cell, int order, const float* coefficients) const;

protected:
  /// Sets the shifts from the next higher level; quarter in scaled coordinates. By descending level.
  void setShifts(int order, int level, const Eigen::Vector3d& quarter);

  std::vector<TargetLevel> levels_;
};

} // namespace winding
