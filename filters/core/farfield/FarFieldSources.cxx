#include "farfield/FarFieldSources.h"

#include "base/Pi.h"
#include "farfield/BulkBounds.h"
#include "source/CoordinateOrder.h"
#include "source/UnitScale.h"
#include "sums/MultipleAngles.h"
#include "sums/RegularizedKernels.h"

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

void store(const Eigen::Vector3d& from, double (&to)[3])
{
  std::copy_n(from.data(), 3, to);
}

template <class Item>
void rearrange(std::vector<Item>& items, const std::vector<std::uint32_t>& order)
{
  std::vector<Item> arranged;
  arranged.reserve(items.size());
  for (const std::uint32_t item : order)
  {
    arranged.push_back(items[item]);
  }
  items = std::move(arranged);
}

double largestOf(const std::vector<double>& values)
{
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

/// The scale that suits a cloud, the areas of its points and the lengths over which they are
/// spread: these may be much larger than a cloud of few points. Samples many units away are then
/// beyond all spreading.
double scaleOf(const PointCloud& cloud, const std::vector<double>& areas)
{
  const double largest =
    std::max(std::sqrt(largestOf(areas)), largestOf(cloud.regularizationLengths));
  Bounds bounds = bulkBounds(cloud.positions, cloud.bounds);
  if (largest > 0)
  {
    bounds.extend(bounds.min() + Eigen::Vector3d::Constant(largest));
  }
  return unitScale(bounds);
}

class PointSources final : public FarFieldSources
{
public:
  PointSources(const PointCloud& cloud, const std::vector<double>& areas)
    : FarFieldSources(scaleOf(cloud, areas))
    , items_(cloud.positions.size())
  {
    for (std::size_t i = 0; i < items_.size(); ++i)
    {
      store(cloud.positions[i] * scale(), items_[i].position);
      // The scale is multiplied in twice, since its square alone may leave the range.
      store(cloud.normals[i] * (areas[i] * scale() * scale() / (4 * pi)), items_[i].moment);
    }
    inverseLengths_.reserve(cloud.regularizationLengths.size());
    for (const double length : cloud.regularizationLengths)
    {
      inverseLengths_.push_back(inverseOfLength(length * scale()));
    }
  }

  std::vector<Eigen::Vector3d> centers() const override
  {
    std::vector<Eigen::Vector3d> centers;
    centers.reserve(items_.size());
    for (const KernelDipole& item : items_)
    {
      centers.emplace_back(Vector(item.position));
    }
    return centers;
  }

  bool isBefore(std::uint32_t item, std::uint32_t other) const override
  {
    const int byMoment =
      compareCoordinates(Vector(items_[item].moment), Vector(items_[other].moment));
    return byMoment != 0 ? byMoment < 0
                         : this->isSpread() && inverseLengths_[item] < inverseLengths_[other];
  }

  void arrange(const std::vector<std::uint32_t>& order, bool inSingle) override
  {
    rearrange(items_, order);
    if (this->isSpread())
    {
      rearrange(inverseLengths_, order);
    }
    this->setWhole({{0, static_cast<std::uint32_t>(items_.size())}});
    inSingle_ = inSingle;
    singleMoments_.resize(inSingle_ ? items_.size() : 0);
    for (std::size_t i = 0; i < singleMoments_.size(); ++i)
    {
      std::transform(items_[i].moment, items_[i].moment + 3, singleMoments_[i].begin(),
        [](double moment) { return static_cast<float>(moment); });
    }
  }

  void appendDipoles(ItemRange items, int, std::vector<Dipole>& dipoles) const override
  {
    for (std::uint32_t i = items.begin; i < items.end; ++i)
    {
      dipoles.push_back({Vector(items_[i].position), Vector(items_[i].moment)});
    }
  }

  double reach(ItemRange items, const Eigen::Vector3d& center) const override
  {
    double squared = 0;
    for (std::uint32_t i = items.begin; i < items.end; ++i)
    {
      squared = std::max(squared, (Vector(items_[i].position) - center).squaredNorm());
    }
    return std::sqrt(squared);
  }

  double spread(ItemRange items) const override
  {
    if (!this->isSpread())
    {
      return 0;
    }
    const double* const first = &inverseLengths_[items.begin];
    return 1 / *std::min_element(first, first + (items.end - items.begin));
  }

  bool sum(const std::vector<ItemRange>& items, const SampleBlock& samples, double* values,
    bool*) const override
  {
    KernelSums sums;
    for (const ItemRange& range : items)
    {
      const KernelDipole* const first = &items_[range.begin];
      const std::size_t count = range.end - range.begin;
      if (this->isSpread() && inSingle_)
      {
        addRegularizedDipolesInSingle(
          first, &singleMoments_[range.begin], &inverseLengths_[range.begin], count, samples, sums);
      }
      else if (this->isSpread())
      {
        addRegularizedDipoles(first, &inverseLengths_[range.begin], count, samples, sums);
      }
      else if (inSingle_)
      {
        addDipolesInSingle(first, &singleMoments_[range.begin], count, samples, sums);
      }
      else
      {
        addDipoles(first, count, samples, sums);
      }
    }
    std::copy_n(sums.sum, samples.count, values);
    return false;
  }

  void addGradients(const std::vector<ItemRange>& items, const SampleBlock& samples,
    GradientSums& sums) const override
  {
    for (const ItemRange& range : items)
    {
      const KernelDipole* const first = &items_[range.begin];
      const std::size_t count = range.end - range.begin;
      if (this->isSpread())
      {
        addRegularizedDipoleGradients(first, &inverseLengths_[range.begin], count, samples, sums);
      }
      else
      {
        addDipoleGradients(first, count, samples, sums);
      }
    }
  }

  double secondsPerPair() const override
  {
    // The figures for spread points lie between the costs of points near enough to feel their
    // spreading, 1.1 ns in single and 2 ns in double precision, and of points farther away.
    return this->isSpread() ? (inSingle_ ? 0.6e-9 : 1.5e-9) : (inSingle_ ? 0.25e-9 : 0.4e-9);
  }
  double secondsPerCutAndCoefficient() const override { return 0.7e-6; }
  std::size_t leafSize() const override { return 8; }

private:
  bool isSpread() const { return !inverseLengths_.empty(); }

  std::vector<KernelDipole> items_;
  std::vector<double> inverseLengths_; ///< by item; empty if items are not spread
  bool inSingle_ = false;
  std::vector<std::array<float, 3>> singleMoments_; ///< by item; empty if summed in double
};

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
    const Bounds& bounds, const SplitRule& rule)
    : FarFieldSources(unitScale(bulkBounds(vertices, bounds)))
  {
    multiplicities_.reserve(triangles.isOnceEach() ? 0 : triangles.size());
    items_.reserve(triangles.size());
    std::vector<std::size_t> cut;
    const auto add = [&](const TrianglePiece& piece)
    {
      const Eigen::Vector3d a = piece.a * scale(), b = piece.b * scale(), c = piece.c * scale();
      KernelTriangle& item = items_.emplace_back();
      store(a, item.a);
      store(b, item.b);
      store(c, item.c);
      store((b - a).cross(c - a), item.normal);
      if (!triangles.isOnceEach())
      {
        multiplicities_.push_back(triangles.multiplicity(piece.triangle));
      }
      if (piece.isCut && (cut.empty() || cut.back() != piece.triangle))
      {
        cut.push_back(piece.triangle);
      }
      isCut_.push_back(piece.isCut);
    };
    const auto addWhole = [&](std::size_t i)
    {
      const Triangle t = lowestFirst(vertices, triangles[i]);
      add({vertices[t[0]], vertices[t[1]], vertices[t[2]], i, false});
    };
    if (rule == SplitRule())
    {
      triangles.forEachRun(
        [&](std::size_t first, std::size_t last, std::int32_t)
        {
          for (; first < last; ++first)
          {
            addWhole(first);
          }
        });
    }
    else
    {
      forEachPiece(rule, vertices, triangles, add);
    }
    treeItems_ = items_.size();
    std::for_each(cut.begin(), cut.end(), addWhole);
  }

  std::vector<Eigen::Vector3d> centers() const override
  {
    std::vector<Eigen::Vector3d> centers;
    centers.reserve(treeItems_);
    std::for_each(items_.begin(), items_.begin() + static_cast<std::ptrdiff_t>(treeItems_),
      [&](const KernelTriangle& item)
      { centers.emplace_back((Vector(item.a) + (Vector(item.b) + Vector(item.c))) / 3); });
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
  void arrange(const std::vector<std::uint32_t>& order, bool) override
  {
    std::vector<std::uint32_t> all = order;
    all.resize(items_.size());
    const auto behind = all.begin() + static_cast<std::ptrdiff_t>(treeItems_);
    std::iota(behind, all.end(), static_cast<std::uint32_t>(treeItems_));
    std::sort(
      behind, all.end(), [this](std::uint32_t a, std::uint32_t b) { return this->isBefore(a, b); });
    rearrange(items_, all);
    rearrange(isCut_, all);
    if (!multiplicities_.empty())
    {
      rearrange(multiplicities_, all);
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
  /// triangles are opposite, so that they cancel but for the order of the sum.
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
  std::size_t leafSize() const override { return 4; }

private:
  std::int32_t multiplicity(std::size_t item) const
  {
    return multiplicities_.empty() ? 1 : multiplicities_[item];
  }

  /// Calls visit(multiplicity, ranges) for the items of each multiplicity among some.
  template <class Visit>
  void forEachMultiplicity(const std::vector<ItemRange>& items, const Visit& visit) const
  {
    if (multiplicities_.empty())
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

  std::vector<KernelTriangle> items_; ///< those of the tree in its order, then triangles it has cut
  std::size_t treeItems_ = 0;
  std::vector<char> isCut_;       ///< by item, until they are arranged
  Multiplicities multiplicities_; ///< by item, in no order; none where each counts once
};

} // namespace

std::size_t itemsIn(const std::vector<ItemRange>& ranges)
{
  std::size_t items = 0;
  for (const ItemRange& range : ranges)
  {
    items += range.end - range.begin;
  }
  return items;
}

std::unique_ptr<FarFieldSources> farFieldSources(
  const PointCloud& cloud, const std::vector<double>& areas)
{
  return std::make_unique<PointSources>(cloud, areas);
}

std::unique_ptr<FarFieldSources> farFieldSources(const std::vector<Eigen::Vector3d>& vertices,
  const ChainView& triangles, const Bounds& bounds, const SplitRule& rule)
{
  return std::make_unique<TriangleSources>(vertices, triangles, bounds, rule);
}

} // namespace winding
