// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/FarFieldSources.h"

#include "base/Pi.h"
#include "farfield/BulkBounds.h"
#include "farfield/SourceItems.h"
#include "source/CoordinateOrder.h"
#include "source/PrefetchCorners.h"
#include "source/UnitScale.h"
#include "sums/MultipleAngles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace winding
{

namespace
{

using Vector = Eigen::Map<const Eigen::Vector3d>;

/// A quadrature rule: points and weights on [0, 1].
using Rule = std::vector<std::pair<double, double>>;

/**
 * The n Gauss-Legendre points and weights on [0, 1], exact for polynomials of degree 2n − 1. They
 * are found by Newton's method from Tricomi's starting values.
 */
Rule gaussLegendre(int n)
{
  Rule rule;
  for (int i = 1; i <= n; ++i)
  {
    double x = std::cos(pi * (i - 0.25) / (n + 0.5)), slope = 0;
    for (int step = 0; step < 20; ++step)
    {
      double p = 1, before = 0;
      for (int k = 1; k <= n; ++k)
      {
        const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = next;
      }
      slope = n * (x * p - before) / (x * x - 1);
      x -= p / slope;
    }
    rule.emplace_back(0.5 * (1 + x), 1 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

/**
 * The rule for moments up to an order. Moments of degree k integrate polynomials of degree k − 1
 * over triangles; a product rule on the square, one side of which is collapsed to a corner, needs
 * one degree more for the Jacobian.
 */
const Rule& ruleFor(int order)
{
  static const std::array<Rule, 6> rules = {gaussLegendre(0), gaussLegendre(1), gaussLegendre(2),
    gaussLegendre(3), gaussLegendre(4), gaussLegendre(5)};
  return rules[static_cast<std::size_t>((order + 2) / 2)];
}

/**
 * Triangles, those that are too large in pieces: these are the items of the tree. Behind them stand
 * the triangles that were cut, as they were before.
 */
class TriangleSources final : public FarFieldSources
{
public:
  TriangleSources(const std::vector<Eigen::Vector3d>& vertices, const ChainView& triangles,
    const Bounds& bounds, const SplitRule& rule, Executor& executor)
    : FarFieldSources(unitScale(bulkBounds(vertices, bounds, executor)))
    , hasMultiplicities_(!triangles.isOnceEach())
  {
    if (rule == SplitRule())
    {
      this->addWhole(vertices, triangles, executor);
    }
    else
    {
      this->addPieces(vertices, triangles, rule);
    }
  }

  std::vector<Eigen::Vector3d> centers(Executor& executor) const override
  {
    std::vector<Eigen::Vector3d> centers(treeItems_);
    forEachItem(
      treeItems_,
      [&](std::size_t i)
      {
        const KernelTriangle& item = items_[i];
        centers[i] = (Vector(item.a) + (Vector(item.b) + Vector(item.c))) / 3;
      },
      executor);
    return centers;
  }

  bool isBefore(std::uint32_t item, std::uint32_t other) const override
  {
    const KernelTriangle &t = items_[item], &u = items_[other];
    int order = compareCoordinates(Vector(t.a), Vector(u.a));
    order = order != 0 ? order : compareCoordinates(Vector(t.b), Vector(u.b));
    order = order != 0 ? order : compareCoordinates(Vector(t.c), Vector(u.c));
    order = order != 0 ? order : this->multiplicity(item) - this->multiplicity(other);
    return order != 0 ? order < 0 : isCut_[item] < isCut_[other];
  }

  /// Puts the items of the tree in order; the triangles behind them are sorted by themselves.
  void arrange(const std::vector<std::uint32_t>& order, bool, Executor& executor) override
  {
    std::vector<std::uint32_t> all = order;
    all.resize(items_.size());
    const auto behind = all.begin() + static_cast<std::ptrdiff_t>(treeItems_);
    std::iota(behind, all.end(), static_cast<std::uint32_t>(treeItems_));
    std::sort(
      behind, all.end(), [this](std::uint32_t a, std::uint32_t b) { return this->isBefore(a, b); });
    rearrange(items_, all, executor);
    rearrange(isCut_, all, executor);
    if (hasMultiplicities_)
    {
      rearrange(multiplicities_, all, executor);
    }
    const auto count = static_cast<std::uint32_t>(items_.size());
    std::vector<ItemRange> whole;
    for (std::uint32_t first = 0, last = 0; first < count; first = last + 1)
    {
      for (last = first; last < count && !isCut_[last]; ++last)
      {
      }
      if (last > first)
      {
        whole.push_back({first, last});
      }
    }
    isCut_.clear();
    isCut_.shrink_to_fit();
    this->setWhole(std::move(whole));
  }

  void appendDipoles(ItemRange items, int order, std::vector<Dipole>& dipoles) const override
  {
    const Rule& rule = ruleFor(order);
    dipoles.reserve(dipoles.size() + (items.end - items.begin) * rule.size() * rule.size());
    for (std::uint32_t i = items.begin; i < items.end; ++i)
    {
      const Vector a(items_[i].a), b(items_[i].b), c(items_[i].c), normal(items_[i].normal);
      for (const auto& [u, weightU] : rule)
      {
        for (const auto& [v, weightV] : rule)
        {
          // The area element is |normal| u du dv.
          const double weight = this->multiplicity(i) * u * weightU * weightV / (4 * pi);
          dipoles.push_back({(1 - u) * a + u * (1 - v) * b + u * v * c, weight * normal});
        }
      }
    }
  }

  double reach(ItemRange items, const Eigen::Vector3d& center) const override
  {
    double squared = 0;
    for (std::uint32_t i = items.begin; i < items.end; ++i)
    {
      for (const double* corner : {items_[i].a, items_[i].b, items_[i].c})
      {
        squared = std::max(squared, (Vector(corner) - center).squaredNorm());
      }
    }
    return std::sqrt(squared);
  }

  double spread(ItemRange) const override { return 0; }

  bool sum(const std::vector<ItemRange>& items, const SampleBlock& samples, double* values,
    bool* isSuspect) const override
  {
    MultipleAngles sums(samples.count, values, isSuspect);
    this->forEachMultiplicity(items,
      [&](std::int32_t multiplicity, const std::vector<ItemRange>& ranges)
      {
        AngleProducts products(samples.count);
        const auto multiply = isSuspect ? multiplyAnglesWatching : multiplyAngles;
        for (const ItemRange& range : ranges)
        {
          multiply(&items_[range.begin], range.end - range.begin, samples, products);
        }
        sums.add(products, multiplicity);
      });
    return isSuspect &&
           std::any_of(isSuspect, isSuspect + samples.count, [](bool is) { return is; });
  }

  /// Adds the gradients of the sides of all triangles. The two shares of a side between two
  /// triangles are opposite, so that they cancel except for the order of the sum.
  void addGradients(const std::vector<ItemRange>& items, const SampleBlock& samples,
    GradientSums& sums) const override
  {
    for (const ItemRange& range : items)
    {
      for (std::uint32_t i = range.begin; i < range.end; ++i)
      {
        const Vector a(items_[i].a), b(items_[i].b), c(items_[i].c);
        const std::int32_t m = this->multiplicity(i);
        const KernelEdge sides[] = {kernelEdge(a, b, m), kernelEdge(b, c, m), kernelEdge(c, a, m)};
        addEdgeGradients(sides, 3, samples, sums);
      }
    }
  }

  double secondsPerPair() const override { return 1e-9; }
  double secondsPerCutAndCoefficient() const override { return 2e-6; }
  double secondsPerLook() const override { return 5e-9; }
  double secondsPerTranslation() const override { return 0.05e-9; }
  std::size_t leafSize() const override { return 4; }

private:
  /// Makes items of all triangles that count, as they are.
  void addWhole(
    const std::vector<Eigen::Vector3d>& vertices, const ChainView& triangles, Executor& executor)
  {
    const std::size_t first = triangles.firstThatCounts();
    treeItems_ = triangles.size() - first;
    this->resize(treeItems_);
    forEachItem(
      treeItems_,
      [&](std::size_t i)
      {
        prefetchCorners(vertices.data(), triangles.triangles(), first + i);
        this->setTriangle(i, vertices, triangles, first + i);
      },
      executor);
  }

  /// Makes items of the pieces of all triangles, and of those that were cut as they were before.
  void addPieces(
    const std::vector<Eigen::Vector3d>& vertices, const ChainView& triangles, const SplitRule& rule)
  {
    std::vector<std::size_t> cut;
    items_.reserve(triangles.size());
    forEachPiece(rule, vertices, triangles,
      [&](const TrianglePiece& piece)
      {
        if (piece.isCut && (cut.empty() || cut.back() != piece.triangle))
        {
          cut.push_back(piece.triangle);
        }
        this->resize(items_.size() + 1);
        this->set(items_.size() - 1, piece, triangles.multiplicity(piece.triangle));
      });
    treeItems_ = items_.size();
    this->resize(treeItems_ + cut.size());
    for (std::size_t i = 0; i < cut.size(); ++i)
    {
      this->setTriangle(treeItems_ + i, vertices, triangles, cut[i]);
    }
  }

  void resize(std::size_t items)
  {
    items_.resize(items);
    isCut_.resize(items);
    multiplicities_.resize(hasMultiplicities_ ? items : 0);
  }

  void set(std::size_t place, const TrianglePiece& piece, std::int32_t multiplicity)
  {
    items_[place] = kernelTriangle(piece.a * scale(), piece.b * scale(), piece.c * scale());
    isCut_[place] = piece.isCut;
    if (hasMultiplicities_)
    {
      multiplicities_[place] = multiplicity;
    }
  }

  void setTriangle(std::size_t place, const std::vector<Eigen::Vector3d>& vertices,
    const ChainView& triangles, std::size_t number)
  {
    const Triangle t = lowestFirst(vertices, triangles[number]);
    this->set(place, {vertices[t[0]], vertices[t[1]], vertices[t[2]], number, false},
      triangles.multiplicity(number));
  }

  std::int32_t multiplicity(std::size_t item) const
  {
    return hasMultiplicities_ ? multiplicities_[item] : 1;
  }

  /// Calls visit(multiplicity, ranges) for the items of each multiplicity among some.
  template <class Visit>
  void forEachMultiplicity(const std::vector<ItemRange>& items, const Visit& visit) const
  {
    if (!hasMultiplicities_)
    {
      visit(1, items);
      return;
    }
    std::map<std::int32_t, std::vector<ItemRange>> byMultiplicity;
    for (const ItemRange& range : items)
    {
      for (std::uint32_t first = range.begin, last = first; first < range.end; first = last)
      {
        while (last < range.end && multiplicities_[last] == multiplicities_[first])
        {
          ++last;
        }
        byMultiplicity[multiplicities_[first]].push_back({first, last});
      }
    }
    for (const auto& [multiplicity, ranges] : byMultiplicity)
    {
      visit(multiplicity, ranges);
    }
  }

  /// The items of the tree in its order, then triangles that it has cut.
  UninitializedVector<KernelTriangle> items_;
  std::size_t treeItems_ = 0;
  UninitializedVector<char> isCut_;                  ///< by item, until they are arranged
  bool hasMultiplicities_;                           ///< false where each item counts once
  UninitializedVector<std::int32_t> multiplicities_; ///< by item, in no order
};

} // namespace

std::unique_ptr<FarFieldSources> farFieldSources(const std::vector<Eigen::Vector3d>& vertices,
  const ChainView& triangles, const Bounds& bounds, const SplitRule& rule, Executor& executor)
{
  return std::make_unique<TriangleSources>(vertices, triangles, bounds, rule, executor);
}

} // namespace winding
