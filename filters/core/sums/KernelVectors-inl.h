// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause

// Vectors of three numbers per lane, for kernels of gradients. The file is compiled once for every
// instruction set: a file that uses it includes it after foreach_target.h.
#if defined(WINDING_KERNEL_VECTORS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WINDING_KERNEL_VECTORS_INL_H
#undef WINDING_KERNEL_VECTORS_INL_H
#else
#define WINDING_KERNEL_VECTORS_INL_H
#endif

#include "sums/KernelTypes.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace winding
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::ScalableTag<double>;
using Vec = hn::Vec<Tag>;

/// One vector of three numbers per lane.
struct Vectors
{
  Vec x, y, z;
};

HWY_INLINE Vectors broadcast(const double (&from)[3])
{
  const Tag d;
  return {hn::Set(d, from[0]), hn::Set(d, from[1]), hn::Set(d, from[2])};
}

HWY_INLINE Vectors operator-(const Vectors& a, const Vectors& b)
{
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

HWY_INLINE Vec dot(const Vectors& a, const Vectors& b)
{
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

/// The cross product without fused operations, so that it is exactly 0 for exactly parallel
/// vectors.
HWY_INLINE Vectors cross(const Vectors& a, const Vectors& b)
{
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)),
    hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)), hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

/// Adds a share unless it is too large or not a number.
HWY_INLINE void add(const Vectors& share, Vectors& sum)
{
  const Vec size = hn::Add(hn::Abs(share.x), hn::Add(hn::Abs(share.y), hn::Abs(share.z)));
  const auto isUsable = hn::Lt(size, hn::Set(Tag(), 1e290));
  sum.x = hn::Add(sum.x, hn::IfThenElseZero(isUsable, share.x));
  sum.y = hn::Add(sum.y, hn::IfThenElseZero(isUsable, share.y));
  sum.z = hn::Add(sum.z, hn::IfThenElseZero(isUsable, share.z));
}

/// Calls shareOf(source, q) for all sources and samples, and adds what it returns.
template <class Source, class ShareOf>
HWY_INLINE void addShares(const Source* HWY_RESTRICT sources, std::size_t count,
  const SampleBlock& samples, GradientSums& sums, const ShareOf& shareOf)
{
  const Tag d;
  for (std::size_t s = 0; s < samples.count; s += hn::Lanes(d))
  {
    const Vectors q = {
      hn::Load(d, samples.x + s), hn::Load(d, samples.y + s), hn::Load(d, samples.z + s)};
    Vectors sum = {hn::Load(d, sums.x + s), hn::Load(d, sums.y + s), hn::Load(d, sums.z + s)};
    for (const Source* source = sources; source != sources + count; ++source)
    {
      add(shareOf(*source, q), sum);
    }
    hn::Store(sum.x, d, sums.x + s);
    hn::Store(sum.y, d, sums.y + s);
    hn::Store(sum.z, d, sums.z + s);
  }
}

} // namespace HWY_NAMESPACE
} // namespace winding
HWY_AFTER_NAMESPACE();

#endif
