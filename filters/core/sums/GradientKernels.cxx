// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sums/GradientKernels.h"

#include "sums/DirectSumKernels.h"

// Highway compiles the rest of this file once for every instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sums/GradientKernels.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// This header stands after highway.h, which sets the instruction set.
#include "sums/KernelVectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace winding
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE Vectors edgeGradient(const KernelEdge& edge, const Vectors& q)
{
  const Tag d;
  const Vectors a = broadcast(edge.from) - q, b = broadcast(edge.to) - q;
  const Vec aa = dot(a, a), bb = dot(b, b), ab = dot(a, b);
  // The cross product is a×b = a×(b−a) = b×(b−a): the shorter of a and b loses fewer digits.
  const auto isNearA = hn::Le(aa, bb);
  const Vectors shorter = {hn::IfThenElse(isNearA, a.x, b.x), hn::IfThenElse(isNearA, a.y, b.y),
    hn::IfThenElse(isNearA, a.z, b.z)};
  const Vectors c = cross(shorter, broadcast(edge.along));
  const Vec la = hn::Sqrt(aa), lb = hn::Sqrt(bb), product = hn::Mul(la, lb);
  // The sum |a||b| + a·b would cancel near the edge; there it is |a×b|² / (|a||b| − a·b).
  const auto isBeside = hn::Lt(ab, hn::Zero(d));
  const Vec numerator = hn::IfThenElse(isBeside, hn::Sub(product, ab), hn::Set(d, 1.0));
  const Vec denominator = hn::IfThenElse(isBeside, dot(c, c), hn::Add(product, ab));
  const Vec weight = hn::Mul(hn::Set(d, edge.weight), hn::Div(hn::Add(la, lb), product));
  const Vec factor = hn::Mul(weight, hn::Div(numerator, denominator));
  return {hn::Mul(factor, c.x), hn::Mul(factor, c.y), hn::Mul(factor, c.z)};
}

void addEdgeGradientsLoop(
  const KernelEdge* edges, std::size_t count, const SampleBlock& samples, GradientSums& sums)
{
  addShares(edges, count, samples, sums,
    [](const KernelEdge& edge, const Vectors& q) HWY_ATTR { return edgeGradient(edge, q); });
}

HWY_INLINE Vectors dipoleGradient(const KernelDipole& dipole, const Vectors& q)
{
  const Tag d;
  const Vectors r = broadcast(dipole.position) - q, m = broadcast(dipole.moment);
  const Vec squared = dot(r, r), length = hn::Sqrt(squared);
  const Vec inverse = hn::Div(hn::Set(d, 1.0), hn::Mul(squared, length));
  // The flux is 3 m·r / r².
  const Vec flux = hn::Mul(hn::Mul(hn::Set(d, 3.0), dot(m, r)), hn::Mul(length, inverse));
  return {hn::Mul(inverse, hn::MulSub(flux, r.x, m.x)),
    hn::Mul(inverse, hn::MulSub(flux, r.y, m.y)), hn::Mul(inverse, hn::MulSub(flux, r.z, m.z))};
}

void addDipoleGradientsLoop(
  const KernelDipole* dipoles, std::size_t count, const SampleBlock& samples, GradientSums& sums)
{
  addShares(dipoles, count, samples, sums,
    [](const KernelDipole& dipole, const Vectors& q) HWY_ATTR
    { return dipoleGradient(dipole, q); });
}

} // namespace HWY_NAMESPACE
} // namespace winding
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace winding
{

HWY_EXPORT(addEdgeGradientsLoop);
HWY_EXPORT(addDipoleGradientsLoop);

void addEdgeGradients(
  const KernelEdge* edges, std::size_t count, const SampleBlock& samples, GradientSums& sums)
{
  HWY_DYNAMIC_DISPATCH(addEdgeGradientsLoop)(edges, count, samples, sums);
}

void addDipoleGradients(
  const KernelDipole* dipoles, std::size_t count, const SampleBlock& samples, GradientSums& sums)
{
  HWY_DYNAMIC_DISPATCH(addDipoleGradientsLoop)(dipoles, count, samples, sums);
}

} // namespace winding
#endif
