// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/Evaluator.h"
#include "base/Executor.h"
#include "base/Lazy.h"
#include "source/CoordinateOrder.h"
#include "source/PointCloud.h"
#include "source/Surface.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace winding
{

struct AngleProducts;

/**
 * The direct sum over all triangles, in double, vectorised over samples.
 *
 * The angles are not summed but multiplied: each triangle gives the complex factor
 * denominator + i·numerator of SolidAngle.h, whose argument is Ω/2; the product's argument is the
 * sum, and the turns that it loses at the branch cut are counted. One atan2 per sample remains.
 *
 * Guaranteed: (1) the properties of SolidAngle.h; (2) a sample's value has the same bits whatever
 * other samples are evaluated with it; (3) values are finite for finite samples, also of surfaces
 * and clouds with coordinates of size 1e±100; (4) rounding changes the share of a
 * triangle by some 1e-16 (1 + L/d) at most, for its longest side L and the distance d of the sample
 * from its sides (measured: 7e-17 (1 + L/d) against numbers of 113 bits; 8e-15 in all on 70 k
 * triangles of a scan, 3e-15 in boxes, wires and open troughs along the axes that are 1e8 times as
 * long as wide); (5) the bits depend on the set of
 * oriented triangles and how often each counts, not on the order of triangles, vertices or corners:
 * they are summed in an order by coordinates (CoordinateOrder.h), which the first value waits for
 * and which is kept, 12 bytes per triangle.
 * Not guaranteed: the same bits on machines with and without fused multiply-add (they differ by
 * rounding, as in (4)).
 */
class TriangleSum final : public Evaluator
{
public:
  /// Keeps references: vertices and triangles must outlive this. The bounds need not be tight; only
  /// the order of magnitude of their size matters. Triangles that count several times are summed
  /// once, those that count 0 times never.
  TriangleSum(
    const std::vector<Eigen::Vector3d>& vertices, const ChainView& triangles, const Bounds& bounds);

  explicit TriangleSum(const Surface& surface)
    : TriangleSum(surface.vertices, surface, surface.bounds)
  {
  }

  void evaluate(const SampleBlock& block, double* values) const override;

  /// Evaluates as evaluate() does, and sets isSuspect[i] to whether sample i lies on a triangle
  /// within rounding, so that chance decides which of the values around it the sample gets. Returns
  /// whether there is any.
  bool evaluateWatching(const SampleBlock& block, double* values, bool* isSuspect) const;

  /// Evaluates `count` samples as evaluateWatching() does, in blocks that `executor` runs. Sample n
  /// lies at positionOf(n), and visit(n, value, isSuspect) receives what is found there.
  template <class PositionOf, class Visit>
  void watch(
    std::size_t count, const PositionOf& positionOf, const Visit& visit, Executor& executor) const
  {
    constexpr std::size_t perBlock = SampleBlock::capacity;
    executor.run((count + perBlock - 1) / perBlock,
      [&](std::size_t number)
      {
        const std::size_t first = number * perBlock;
        SampleBlock block;
        block.count = std::min(perBlock, count - first);
        for (std::size_t n = 0; n < block.count; ++n)
        {
          block.set(n, positionOf(first + n));
        }
        double values[SampleBlock::capacity];
        bool isSuspect[SampleBlock::capacity];
        const bool any = this->evaluateWatching(block, values, isSuspect);
        for (std::size_t n = 0; n < block.count; ++n)
        {
          visit(first + n, values[n], any && isSuspect[n]);
        }
      });
  }

private:
  void sum(const SampleBlock& block, double* values, bool* isSuspect) const;
  void multiply(const TriangleList& triangles, std::size_t first, std::size_t last,
    const SampleBlock& scaled, AngleProducts& products, bool watching) const;

  const std::vector<Eigen::Vector3d>& vertices_;
  ChainView triangles_;
  Lazy<OrderedTriangles> ordered_; ///< the triangles
  double scale_; ///< a power of two that brings the surface to about unit size, without rounding
};

/**
 * The direct sum over all points of a cloud, in double, and over their gradients; the guarantees
 * are TriangleSum's, the order taking 4 bytes per point. Points are spread over the lengths
 * that the cloud has, if any (SolidAngle.h). No point adds to the value at its own place, and a
 * point that is not spread adds nothing to the gradient there, either.
 */
class DipoleSum final : public Evaluator, public GradientEvaluator
{
public:
  /// Keeps references: cloud and areas (one per point) must outlive this.
  DipoleSum(const PointCloud& cloud, const std::vector<double>& areas);

  void evaluate(const SampleBlock& block, double* values) const override;
  void evaluateGradients(const SampleBlock& block, double* gradients) const override;

private:
  template <class AddChunk> void forEachChunk(const AddChunk& addChunk) const;

  const PointCloud& cloud_;
  const std::vector<double>& areas_;
  Lazy<std::vector<std::uint32_t>> order_; ///< numbers of the points
  double scale_;
};

} // namespace winding
