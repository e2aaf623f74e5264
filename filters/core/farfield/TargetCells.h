// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Evaluator.h"
#include "farfield/MultipoleKernels.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace winding
{

/// A box of samples in a hierarchy of boxes; positions are in the sources' scaled coordinates.
struct TargetCell
{
  int level;             ///< 0 for the smallest cells
  Eigen::Vector3i index; ///< distinguishes the cells of a level
  Eigen::Vector3d center;
  std::size_t samples;    ///< samples that are asked for
  std::size_t allSamples; ///< all samples, asked for or not: decisions are made by this number
};

struct TargetSphere
{
  Eigen::Vector3d center;
  double radius;
};

/// The matrices that turn a parent's local expansion into a child's, one for each octant; stored by
/// columns of paddedCoefficients(order).
struct LocalShifts
{
  /// sideRatio: the children's side in units of the parent's. quarter: distances of the children's
  /// centres from the parent's along each axis, in the same units; 0 along axes that are not cut.
  LocalShifts(int order, double sideRatio, const Eigen::Vector3d& quarter);

  double sideRatio;
  Eigen::Vector3d quarter;
  std::vector<float> matrices[8];
};

/// The properties that all cells of a level have in common.
struct TargetLevel
{
  double side;   ///< B: the longest side of a cell
  double radius; ///< R: no sample is farther from the centre
  /// Turns local expansions of parents into this level's cells'; null at the top.
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
 * The samples at which a far field is evaluated, as a hierarchy of cells, and the place where their
 * values go. The cells' geometry never depends on which part of the samples is asked for.
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

  /// Writes the children of a cell that have samples, up to eight, and returns their number; a cell
  /// of level 0 has none.
  virtual int childrenOf(const TargetCell& cell, Child (&children)[8]) const = 0;

  /// Whether all cells of a level hold about as many samples. Where they do not, small ones lose
  /// time, since sums take as long for one sample as for a vector of them.
  virtual bool isRegular() const { return true; }

  /// A sphere around the samples of a cell that is not cut any further.
  virtual TargetSphere sphereOf(const TargetCell& cell) const;

  /// Fills a block with samples first … first + block.samples.count − 1 of a cell, as many as fit.
  virtual void fill(const TargetCell& cell, std::size_t first, TargetBlock& block) const = 0;

  /// Takes the values of samples first … first + count − 1 of a cell. `isSuspect` says which of
  /// them lie on a source; it may be null.
  virtual void store(const TargetCell& cell, std::size_t first, std::size_t count,
    const float* values, const bool* isSuspect) const = 0;

  /// The number of rows that storePolynomial() goes along in a cell; 0 where it goes from sample to
  /// sample, which costs more.
  virtual std::size_t rowsOf(const TargetCell&) const { return 0; }

  /// Evaluates a polynomial at all samples of a cell, and takes the values.
  virtual void storePolynomial(const TargetCell& cell, int order, const float* coefficients) const;

protected:
  /// Sets a level's shifts from the next higher level, whose shifts must be set before; quarter: as
  /// for LocalShifts, but in scaled coordinates.
  void setShifts(int order, int level, const Eigen::Vector3d& quarter);

  std::vector<TargetLevel> levels_;
};

} // namespace winding
