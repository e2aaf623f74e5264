// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/NodeAcceptance.h"

#include "farfield/Expansions.h"
#include "farfield/MultipoleKernels.h"

// Highway compiles the rest of this file once for every instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "farfield/NodeAcceptance.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace winding
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

void classifyNodesLoop(const NodeCriteria& nodes, const CellCriteria& cell,
  const std::int32_t* HWY_RESTRICT candidates, std::size_t count, NodeLists& lists)
{
  const hn::CappedTag<float, nodeListSlack> d;
  const hn::RebindToSigned<decltype(d)> di;
  const std::size_t lanes = hn::Lanes(d);
  const auto set = [&d](float value)
  {
    return hn::Set(d, value);
  };
  for (std::size_t s = 0; s < count; s += lanes)
  {
    // Lanes beyond the count look at node 0 and are written nowhere.
    const std::size_t used = std::min(lanes, count - s);
    const auto inUse = hn::FirstN(di, used);
    std::int32_t last[nodeListSlack] = {};
    std::copy_n(candidates + s, used < lanes ? used : 0, last);
    const auto node = hn::LoadU(di, used < lanes ? last : candidates + s);
    const auto gather = [&](const std::vector<float>& values)
    {
      return hn::GatherIndex(d, values.data(), node);
    };
    const auto dx = hn::Sub(set(cell.x), gather(nodes.x));
    const auto dy = hn::Sub(set(cell.y), gather(nodes.y));
    const auto dz = hn::Sub(set(cell.z), gather(nodes.z));
    const auto squared = hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz)));
    const auto radius = gather(nodes.radius);
    const auto apart = hn::Mul(hn::Add(radius, set(cell.radius)), set(cell.inverseTheta));
    const auto forMoments = hn::Add(set(cell.radius), gather(nodes.rho));
    const auto forLocal = hn::MulAdd(gather(nodes.tau), set(cell.reach), radius);
    const auto inSight = hn::MulAdd(radius, set(cell.momentMargin), set(cell.radius));
    const auto needed = hn::Max(hn::Max(apart, inSight), hn::Max(forMoments, forLocal));

    const auto isInUse = hn::RebindMask(d, inUse);
    const auto isAccepted = hn::And(isInUse, hn::Ge(squared, hn::Mul(needed, needed)));
    const auto isSplit = hn::AndNot(
      isAccepted, hn::And(isInUse, hn::Gt(gather(nodes.splitRadius), set(cell.splitRadius))));
    const auto isKept = hn::AndNot(hn::Or(isAccepted, isSplit), isInUse);
    // Nodes are compressed in the register, since storing compressed is slow on some machines.
    const auto append = [&](auto mask, std::int32_t* to, std::size_t& size)
    {
      const auto chosen = hn::RebindMask(di, mask);
      hn::StoreU(hn::Compress(node, chosen), di, to + size);
      size += hn::CountTrue(di, chosen);
    };
    append(isAccepted, lists.accepted, lists.acceptedCount);
    append(isSplit, lists.split, lists.splitCount);
    append(isKept, lists.kept, lists.keptCount);
  }
}

} // namespace HWY_NAMESPACE
} // namespace winding
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace winding
{

HWY_EXPORT(classifyNodesLoop);

void classifyNodes(const NodeCriteria& nodes, const CellCriteria& cell,
  const std::int32_t* candidates, std::size_t count, NodeLists& lists)
{
  HWY_DYNAMIC_DISPATCH(classifyNodesLoop)(nodes, cell, candidates, count, lists);
}

void NodeCriteria::resize(std::size_t nodes)
{
  for (std::vector<float>* values : {&x, &y, &z, &radius, &rho, &tau, &splitRadius})
  {
    values->resize(nodes);
  }
}

void NodeCriteria::setErrors(
  std::size_t node, const FarFieldAccuracy& accuracy, const Content& content)
{
  static const std::array<double, 2 * largestOrder + 1> factorial = []
  {
    std::array<double, 2 * largestOrder + 1> values = {1};
    for (std::size_t i = 1; i < values.size(); ++i)
    {
      values[i] = static_cast<double>(i) * values[i - 1];
    }
    return values;
  }();
  const int order = accuracy.order;
  const double epsilon = accuracy.epsilon;
  // powers[k] is p_k / r^k, as the moments are scaled.
  double powers[largestOrder + 1] = {};
  for (int k = 1; k <= order; ++k)
  {
    double sum = 0;
    for (int m = 0; m <= k; ++m)
    {
      const double re = content.moments[realPlace(k, m)];
      const double im = m > 0 ? content.moments[imaginaryPlace(k, m)] : 0;
      sum += (m > 0 ? 2 : 1) * factorial[static_cast<std::size_t>(k + m)] *
             factorial[static_cast<std::size_t>(k - m)] * (re * re + im * im);
    }
    powers[k] = std::sqrt(sum);
  }
  const double r = radius[node];
  // Every other degree vanishes for symmetric patches, so the last but one counts, too.
  const double next = std::max({powers[order], 0.7 * powers[order - 1], content.expectedNext});
  double strength = 0;
  for (int k = 1; k <= order; ++k)
  {
    strength = std::max(strength, r * powers[k] / k);
  }
  // The root of p_{P+1} = next · r^{P+1} is taken factor by factor, for the sake of the range.
  const double forMoments = r * std::pow(next / (r * epsilon), 1.0 / (order + 2));
  const double forSpread = content.spread > 0 ? r + content.spread : 0;
  rho[node] = static_cast<float>(std::max(forMoments, forSpread));
  tau[node] = static_cast<float>(std::pow(strength / epsilon, 1.0 / (order + 3)));
}

float CellCriteria::reachOf(int order, double radius)
{
  return static_cast<float>(
    std::pow(order + 2, 1.0 / (order + 3)) * std::pow(radius, (order + 1.0) / (order + 3)));
}

} // namespace winding
#endif
