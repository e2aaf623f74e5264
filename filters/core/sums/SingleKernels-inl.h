// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause

// Sums in single precision from offsets in double. The file is compiled once for every instruction
// set: a file that uses it includes it after foreach_target.h.
#if defined(WINDING_SINGLE_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WINDING_SINGLE_KERNELS_INL_H
#undef WINDING_SINGLE_KERNELS_INL_H
#else
#define WINDING_SINGLE_KERNELS_INL_H
#endif

#include "sums/KernelTypes.h"

#include <hwy/highway.h>

#include <array>

HWY_BEFORE_NAMESPACE();
namespace winding
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

using SingleTag = hn::CappedTag<float, 16>;
using SingleVec = hn::Vec<SingleTag>;

/// The offsets position − samples, two vectors of doubles as one of floats, cut off where powers of
/// them would leave the range; shares have long been 0 there.
HWY_INLINE SingleVec offsetsTo(double position, const double* HWY_RESTRICT samples)
{
  const SingleTag d;
  const hn::Half<SingleTag> half;
  const hn::Rebind<double, hn::Half<SingleTag>> wide;
  const auto convert = [&](const double* from)
  {
    return hn::DemoteTo(half, hn::Sub(hn::Set(wide, position), hn::Load(wide, from)));
  };
  const SingleVec farthest = hn::Set(d, 1e12f);
#if HWY_TARGET == HWY_SCALAR
  const SingleVec offsets = convert(samples);
#else
  const SingleVec offsets = hn::Combine(d, convert(samples + hn::Lanes(wide)), convert(samples));
#endif
  return hn::Min(hn::Max(offsets, hn::Neg(farthest)), farthest);
}

/// 1/√value to the full 24 bits of single precision, or nearly so.
HWY_INLINE SingleVec inverseRoot(SingleVec value)
{
  const SingleTag d;
#if HWY_TARGET == HWY_SCALAR
  // The estimate of this target has a few bits only.
  return hn::Div(hn::Set(d, 1.0f), hn::Sqrt(value));
#else
  // A step of Newton's method doubles the bits of the estimate: 12 at least on x86, 7 elsewhere.
  const SingleVec half = hn::Mul(hn::Set(d, 0.5f), value);
  const auto improved = [&](SingleVec guess)
  {
    return hn::Mul(guess, hn::NegMulAdd(half, hn::Mul(guess, guess), hn::Set(d, 1.5f)));
  };
  const SingleVec guess = improved(hn::ApproximateReciprocalSqrt(value));
  return HWY_ARCH_X86 ? guess : improved(guess);
#endif
}

/// Adds a vector of floats to two of doubles.
HWY_INLINE void addInDouble(SingleVec values, double* HWY_RESTRICT sums)
{
  const hn::Half<SingleTag> half;
  const hn::Rebind<double, hn::Half<SingleTag>> wide;
  const auto add = [&](auto part, double* to)
  {
    hn::Store(hn::Add(hn::Load(wide, to), hn::PromoteTo(wide, part)), wide, to);
  };
  add(hn::LowerHalf(half, values), sums);
#if HWY_TARGET != HWY_SCALAR
  add(hn::UpperHalf(half, values), sums + hn::Lanes(wide));
#endif
}

/// The least |d|² whose half is a normal number: inverseRoot() needs that, whether or not
/// smaller numbers count as 0. Samples nearer than its root count as at the dipole itself.
constexpr float leastSquare = 0x1p-125f;

/// Adds shareOf(i, m·d, |d|², 1/|d|) for each dipole i to all samples but those at the dipole
/// itself.
template <class ShareOf>
HWY_INLINE void addInSingle(const KernelDipole* HWY_RESTRICT dipoles,
  const std::array<float, 3>* HWY_RESTRICT moments, std::size_t count, const SampleBlock& samples,
  KernelSums& sums, const ShareOf& shareOf)
{
  // A run has as many shares as may be summed in single precision before rounding errors add up.
  constexpr std::size_t run = 8;
  const SingleTag d;
  const SingleVec zero = hn::Zero(d), least = hn::Set(d, leastSquare);
  for (std::size_t first = 0; first < count; first += run)
  {
    const std::size_t last = std::min(count, first + run);
    for (std::size_t s = 0; s < samples.count; s += hn::Lanes(d))
    {
      SingleVec sum = zero;
      for (std::size_t i = first; i < last; ++i)
      {
        const SingleVec x = offsetsTo(dipoles[i].position[0], samples.x + s);
        const SingleVec y = offsetsTo(dipoles[i].position[1], samples.y + s);
        const SingleVec z = offsetsTo(dipoles[i].position[2], samples.z + s);
        const SingleVec r2 = hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)));
        const SingleVec flux = hn::MulAdd(x, hn::Set(d, moments[i][0]),
          hn::MulAdd(y, hn::Set(d, moments[i][1]), hn::Mul(z, hn::Set(d, moments[i][2]))));
        const SingleVec share = shareOf(i, flux, r2, inverseRoot(r2));
        sum = hn::Add(sum, hn::IfThenElseZero(hn::Ge(r2, least), share));
      }
      addInDouble(sum, sums.sum + s);
    }
  }
}

} // namespace HWY_NAMESPACE
} // namespace winding
HWY_AFTER_NAMESPACE();

#endif
