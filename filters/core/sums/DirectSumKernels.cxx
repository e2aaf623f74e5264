// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sums/DirectSumKernels.h"

#include <limits>

// Highway compiles the rest of this file once for every instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sums/DirectSumKernels.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// These headers stand after highway.h, which sets the instruction set.
#include "sums/SingleKernels-inl.h"
#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace winding
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::ScalableTag<double>;
using Vec = hn::Vec<Tag>;

HWY_INLINE Vec dot(Vec ax, Vec ay, Vec az, Vec bx, Vec by, Vec bz)
{
  return hn::MulAdd(ax, bx, hn::MulAdd(ay, by, hn::Mul(az, bz)));
}

/// 2^−k for values of magnitude 2^k … 2^(k+1): scaling by it rounds nothing.
HWY_INLINE Vec inverseMagnitude(Tag d, Vec value)
{
  const hn::RebindToUnsigned<Tag> du;
  const auto exponent = hn::And(hn::BitCast(du, value), hn::Set(du, 0x7FF0000000000000ull));
  return hn::BitCast(d, hn::Sub(hn::Set(du, 0x7FE0000000000000ull), exponent));
}

/// Returns ab − cd. Where a and d are exchanged with c and b, it changes its sign to the bit, as a
/// fused operation would not.
HWY_INLINE Vec crossed(Vec a, Vec b, Vec c, Vec d)
{
  return hn::Sub(hn::Mul(a, b), hn::Mul(c, d));
}

/// Returns |v| + u·v, which does not cancel at an obtuse angle to the unit vector u. `along` is
/// u·v, and `across` is |u×v|².
HWY_INLINE Vec lengthPlus(Vec along, Vec across, Vec length)
{
  const Tag d;
  const Vec sum = hn::Add(length, hn::Abs(along));
  return hn::IfThenElse(hn::Lt(along, hn::Zero(d)), hn::Div(across, sum), sum);
}

/// Finds the numerator `volume` and the denominator `sum` of the form of SolidAngle.h that does not
/// cancel, from the corners minus the sample and their lengths. At a corner they are no numbers.
HWY_INLINE void formWithoutCancelling(Vec ax, Vec ay, Vec az, Vec a, Vec bx, Vec by, Vec bz, Vec b,
  Vec cx, Vec cy, Vec cz, Vec c, Vec& volume, Vec& sum)
{
  const Tag d;
  const Vec inverse = hn::Div(hn::Set(d, 1.0), a);
  const Vec ux = hn::Mul(ax, inverse), uy = hn::Mul(ay, inverse), uz = hn::Mul(az, inverse);
  const Vec ubx = crossed(uy, bz, uz, by), ucx = crossed(uy, cz, uz, cy);
  const Vec uby = crossed(uz, bx, ux, bz), ucy = crossed(uz, cx, ux, cz);
  const Vec ubz = crossed(ux, by, uy, bx), ucz = crossed(ux, cy, uy, cx);
  const Vec toB = lengthPlus(dot(ux, uy, uz, bx, by, bz), dot(ubx, uby, ubz, ubx, uby, ubz), b);
  const Vec toC = lengthPlus(dot(ux, uy, uz, cx, cy, cz), dot(ucx, ucy, ucz, ucx, ucy, ucz), c);
  volume = dot(ux, uy, uz, crossed(uby, ucz, ubz, ucy), crossed(ubz, ucx, ubx, ucz),
    crossed(ubx, ucy, uby, ucx));
  sum = hn::MulAdd(toB, toC, dot(ubx, uby, ubz, ucx, ucy, ucz));
}

/// Multiplies the factors of triangles that are all thin, or all not.
template <bool Watching, bool Thin>
HWY_INLINE void multiplyAlike(const KernelTriangle* HWY_RESTRICT triangles, std::size_t count,
  const SampleBlock& samples, AngleProducts& products)
{
  const Tag d;
  const Vec zero = hn::Zero(d), one = hn::Set(d, 1.0);
  const Vec smallestNormal = hn::Set(d, std::numeric_limits<double>::min());
  const Vec small = hn::Set(d, smallSolidAngle);
  for (std::size_t s = 0; s < samples.count; s += hn::Lanes(d))
  {
    const Vec qx = hn::Load(d, samples.x + s);
    const Vec qy = hn::Load(d, samples.y + s);
    const Vec qz = hn::Load(d, samples.z + s);
    Vec re = hn::Load(d, products.re + s);
    Vec im = hn::Load(d, products.im + s);
    Vec turns = hn::Load(d, products.turns + s);
    Vec suspect = zero;
    for (const KernelTriangle* t = triangles; t != triangles + count; ++t)
    {
      const Vec ax = hn::Sub(hn::Set(d, t->a[0]), qx);
      const Vec ay = hn::Sub(hn::Set(d, t->a[1]), qy);
      const Vec az = hn::Sub(hn::Set(d, t->a[2]), qz);
      const Vec bx = hn::Sub(hn::Set(d, t->b[0]), qx);
      const Vec by = hn::Sub(hn::Set(d, t->b[1]), qy);
      const Vec bz = hn::Sub(hn::Set(d, t->b[2]), qz);
      const Vec cx = hn::Sub(hn::Set(d, t->c[0]), qx);
      const Vec cy = hn::Sub(hn::Set(d, t->c[1]), qy);
      const Vec cz = hn::Sub(hn::Set(d, t->c[2]), qz);
      const Vec a = hn::Sqrt(dot(ax, ay, az, ax, ay, az));
      const Vec b = hn::Sqrt(dot(bx, by, bz, bx, by, bz));
      const Vec c = hn::Sqrt(dot(cx, cy, cz, cx, cy, cz));
      const Vec height = dot(
        ax, ay, az, hn::Set(d, t->normal[0]), hn::Set(d, t->normal[1]), hn::Set(d, t->normal[2]));
      // A height below the normal numbers is none: the product of two would be 0, and has no
      // argument. It is +0 then, not −0: by a factor of 1 − 0i, a product at the branch cut would
      // change the sign of its imaginary part and so lose a turn. A sample at b or c has no height,
      // either, though rounding may give it one: the length is 0 there. Lengths are 0 or far above
      // the smallest normal number, as they are roots.
      const Vec toBOrC = hn::Min(b, c);
      auto isInPlane = hn::Le(hn::Min(hn::Abs(height), toBOrC), smallestNormal);
      Vec num = hn::IfThenZeroElse(isInPlane, height);
      // The denominator is symmetric in b and c to the bit, so that the sum is odd under their
      // exchange.
      const Vec bc = hn::MulAdd(b, c, dot(bx, by, bz, cx, cy, cz));
      Vec den = hn::MulAdd(a, bc,
        hn::Add(hn::Mul(c, dot(ax, ay, az, bx, by, bz)), hn::Mul(b, dot(ax, ay, az, cx, cy, cz))));
      if (Watching)
      {
        const Vec bound = hn::Mul(hn::Mul(a, b), hn::Mul(c, hn::Set(d, suspectAngle)));
        const auto isOn = hn::And(hn::Le(den, bound), hn::Le(hn::Abs(num), bound));
        const Vec nearest = hn::Min(a, toBOrC), sides = hn::Add(a, hn::Add(b, c));
        const auto isAtVertex = hn::Le(nearest, hn::Mul(sides, hn::Set(d, suspectAngle)));
        suspect = hn::IfThenElse(hn::Or(isOn, isAtVertex), one, suspect);
      }
      if (Thin)
      {
        const auto isSmall =
          hn::Le(hn::Max(hn::Abs(num), hn::Abs(den)), hn::Mul(hn::Mul(a, b), hn::Mul(c, small)));
        if (!hn::AllFalse(d, isSmall))
        {
          Vec volume, sum;
          formWithoutCancelling(ax, ay, az, a, bx, by, bz, b, cx, cy, cz, c, volume, sum);
          isInPlane = hn::Or(isInPlane, hn::And(isSmall, hn::Le(hn::Abs(volume), smallestNormal)));
          num = hn::IfThenZeroElse(isInPlane, hn::IfThenElse(isSmall, volume, num));
          den = hn::IfThenElse(isSmall, sum, den);
        }
      }
      // A sample in the plane of the triangle gets a factor of 1, whatever the denominator's sign.
      den = hn::IfThenElse(isInPlane, one, den);

      const Vec newRe = hn::Sub(hn::Mul(re, den), hn::Mul(im, num));
      const Vec newIm = hn::MulAdd(re, num, hn::Mul(im, den));
      // The argument crossed the branch cut iff both angles had one sign and their sum has the
      // other. Only the sign bit of `signs` means anything: copied onto 1 it can be compared,
      // whatever number the processor takes the other bits for.
      const Vec signs = hn::AndNot(hn::Xor(im, num), hn::Xor(im, newIm));
      const auto hasCrossed = hn::Lt(hn::CopySign(one, signs), zero);
      const Vec step = hn::IfThenZeroElse(isInPlane, hn::CopySign(one, num));
      turns = hn::Add(turns, hn::IfThenElseZero(hasCrossed, step));

      const Vec scale = inverseMagnitude(d, hn::Max(hn::Abs(newRe), hn::Abs(newIm)));
      re = hn::Mul(newRe, scale);
      im = hn::Mul(newIm, scale);
    }
    hn::Store(re, d, products.re + s);
    hn::Store(im, d, products.im + s);
    hn::Store(turns, d, products.turns + s);
    if (Watching)
    {
      hn::Store(hn::Max(suspect, hn::Load(d, products.suspect + s)), d, products.suspect + s);
    }
  }
}

template <bool Watching>
HWY_INLINE void multiply(const KernelTriangle* triangles, std::size_t count,
  const SampleBlock& samples, AngleProducts& products)
{
  for (const KernelTriangle *first = triangles, *last; first != triangles + count; first = last)
  {
    last = std::find_if(first, triangles + count,
      [first](const KernelTriangle& t) { return t.isThin != first->isThin; });
    const auto alike = static_cast<std::size_t>(last - first);
    if (first->isThin)
    {
      multiplyAlike<Watching, true>(first, alike, samples, products);
    }
    else
    {
      multiplyAlike<Watching, false>(first, alike, samples, products);
    }
  }
}

void multiplyAnglesLoop(const KernelTriangle* triangles, std::size_t count,
  const SampleBlock& samples, AngleProducts& products)
{
  multiply<false>(triangles, count, samples, products);
}

void multiplyAnglesWatchingLoop(const KernelTriangle* triangles, std::size_t count,
  const SampleBlock& samples, AngleProducts& products)
{
  multiply<true>(triangles, count, samples, products);
}

void sumAnglesLoop(const AngleProducts& products, std::size_t count, double* HWY_RESTRICT values)
{
  const Tag d;
  const Vec half = hn::Set(d, 0.5), quarter = hn::Set(d, 0.25);
  const Vec perTurn = hn::Set(d, 0.15915494309189533577); // 1 / 2π
  alignas(64) double room[hn::MaxLanes(Tag())];
  for (std::size_t s = 0; s < count; s += hn::Lanes(d))
  {
    // The angle to the nearer axis gives atan2(im, re) in turns.
    const Vec re = hn::Load(d, products.re + s), im = hn::Load(d, products.im + s);
    const Vec x = hn::Abs(re), y = hn::Abs(im);
    const Vec angle = hn::Mul(perTurn, hn::Atan(d, hn::Div(hn::Min(x, y), hn::Max(x, y))));
    const Vec first = hn::IfThenElse(hn::Gt(y, x), hn::Sub(quarter, angle), angle);
    const Vec upper = hn::IfThenElse(hn::Lt(re, hn::Zero(d)), hn::Sub(half, first), first);
    hn::Store(hn::Add(hn::Load(d, products.turns + s), hn::CopySign(upper, im)), d, room);
    std::copy_n(room, std::min(hn::Lanes(d), count - s), values + s);
  }
}

void addDipolesLoop(const KernelDipole* HWY_RESTRICT dipoles, std::size_t count,
  const SampleBlock& samples, KernelSums& sums)
{
  const Tag d;
  const Vec zero = hn::Zero(d);
  for (std::size_t s = 0; s < samples.count; s += hn::Lanes(d))
  {
    const Vec qx = hn::Load(d, samples.x + s);
    const Vec qy = hn::Load(d, samples.y + s);
    const Vec qz = hn::Load(d, samples.z + s);
    Vec sum = hn::Load(d, sums.sum + s);
    for (const KernelDipole* p = dipoles; p != dipoles + count; ++p)
    {
      const Vec x = hn::Sub(hn::Set(d, p->position[0]), qx);
      const Vec y = hn::Sub(hn::Set(d, p->position[1]), qy);
      const Vec z = hn::Sub(hn::Set(d, p->position[2]), qz);
      const Vec r2 = dot(x, y, z, x, y, z);
      const Vec cube = hn::Mul(r2, hn::Sqrt(r2));
      const Vec flux =
        dot(x, y, z, hn::Set(d, p->moment[0]), hn::Set(d, p->moment[1]), hn::Set(d, p->moment[2]));
      // The share is 0 at the point itself, and where the cube of the distance underflows.
      sum = hn::Add(sum, hn::IfThenElseZero(hn::Gt(cube, zero), hn::Div(flux, cube)));
    }
    hn::Store(sum, d, sums.sum + s);
  }
}

void addDipolesInSingleLoop(const KernelDipole* HWY_RESTRICT dipoles,
  const std::array<float, 3>* HWY_RESTRICT moments, std::size_t count, const SampleBlock& samples,
  KernelSums& sums)
{
  addInSingle(dipoles, moments, count, samples, sums,
    [](std::size_t, SingleVec flux, SingleVec, SingleVec inverse) HWY_ATTR
    {
      // The factors come one by one: their cube alone would leave the range near the point.
      return hn::Mul(hn::Mul(hn::Mul(flux, inverse), inverse), inverse);
    });
}

const char* instructionSetName()
{
  return hwy::TargetName(HWY_TARGET);
}

} // namespace HWY_NAMESPACE
} // namespace winding
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace winding
{

HWY_EXPORT(multiplyAnglesLoop);
HWY_EXPORT(multiplyAnglesWatchingLoop);
HWY_EXPORT(sumAnglesLoop);
HWY_EXPORT(addDipolesLoop);
HWY_EXPORT(addDipolesInSingleLoop);
HWY_EXPORT(instructionSetName);

void multiplyAngles(const KernelTriangle* triangles, std::size_t count, const SampleBlock& samples,
  AngleProducts& products)
{
  HWY_DYNAMIC_DISPATCH(multiplyAnglesLoop)(triangles, count, samples, products);
}

void multiplyAnglesWatching(const KernelTriangle* triangles, std::size_t count,
  const SampleBlock& samples, AngleProducts& products)
{
  HWY_DYNAMIC_DISPATCH(multiplyAnglesWatchingLoop)(triangles, count, samples, products);
}

void sumAngles(const AngleProducts& products, std::size_t count, double* values)
{
  HWY_DYNAMIC_DISPATCH(sumAnglesLoop)(products, count, values);
}

void addDipoles(
  const KernelDipole* dipoles, std::size_t count, const SampleBlock& samples, KernelSums& sums)
{
  HWY_DYNAMIC_DISPATCH(addDipolesLoop)(dipoles, count, samples, sums);
}

void addDipolesInSingle(const KernelDipole* dipoles, const std::array<float, 3>* moments,
  std::size_t count, const SampleBlock& samples, KernelSums& sums)
{
  HWY_DYNAMIC_DISPATCH(addDipolesInSingleLoop)(dipoles, moments, count, samples, sums);
}

const char* kernelInstructionSet()
{
  return HWY_DYNAMIC_DISPATCH(instructionSetName)();
}

} // namespace winding
#endif
