// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sums/RegularizedKernels.h"

// Highway compiles the rest of this file once for every instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sums/RegularizedKernels.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// These headers stand after highway.h, which sets the instruction set.
#include "sums/KernelVectors-inl.h"
#include "sums/SingleKernels-inl.h"
#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace winding
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// The value of a polynomial at x; the coefficient of the highest power comes first.
template <class Scalar, std::size_t N, class V>
HWY_INLINE V polynomial(const Scalar (&coefficients)[N], V x)
{
  const hn::DFromV<V> d;
  V sum = hn::Set(d, coefficients[0]);
  for (std::size_t i = 1; i < N; ++i)
  {
    sum = hn::MulAdd(sum, x, hn::Set(d, coefficients[i]));
  }
  return sum;
}

/// The t that parts two formulas for S. Below it S is t³ times a polynomial, so that it has all
/// digits however small it is; above it S is 1 − exp(−t²) times a polynomial, where less than a bit
/// cancels.
constexpr double smallUntil = 1.5;

/**
 * G(u) = S(t) / t³, u = t², as a minimax polynomial of degree 13 in u − 1.125 for u in [0, 2.25],
 * fitted to 50 digits. As it stands here, in double, its relative error is within 5.0e-16.
 */
HWY_INLINE Vec shareOverCube(Vec squared)
{
  constexpr double coefficients[] = {-4.3690172675815243e-12, 6.267310935702977e-11,
    -8.0069500373364864e-10, 9.6375339268846093e-09, -1.064717071545603e-07, 1.0698568895230421e-06,
    -9.6839336922906708e-06, 7.8007218208084333e-05, -0.00055066272822204782, 0.00333841325048571,
    -0.016906231054538014, 0.068635448618743974, -0.20830433604220713, 0.40044897250720146};
  const Tag d;
  // Lanes beyond smallUntil do not use the result, so they may be clamped.
  const Vec clamped = hn::Min(squared, hn::Set(d, smallUntil * smallUntil));
  return polynomial(coefficients, hn::Sub(clamped, hn::Set(d, 1.125)));
}

/**
 * exp(t²) erfc(t) + 2t/√π as a polynomial of degree 15 in t − 1.5 for t in [1.5, 6.3], fitted to 50
 * digits such that the largest error times exp(−t²), which is the error of S, is least. In double
 * this error is 2.3e-16.
 */
HWY_INLINE Vec restOverGaussian(Vec t)
{
  constexpr double coefficients[] = {-8.6895965613247279e-10, 1.8230109165892472e-08,
    -1.8069534000216767e-07, 1.1488590609920527e-06, -5.4139840533207102e-06,
    2.0859572405128055e-05, -7.0739796324695883e-05, 0.00022195945761903317,
    -0.00066124411911392734, 0.0018858897743406996, -0.0051458981766925541, 0.013377331723644447,
    -0.032930904453848026, 0.076151039815911467, 0.96475624936366211, 2.0141541670975842};
  return polynomial(coefficients, hn::Sub(t, hn::Set(Tag(), smallUntil)));
}

/// exp(−t²) for t up to pureFrom.
HWY_INLINE Vec gaussian(Vec t)
{
  return hn::Exp(Tag(), hn::Neg(hn::Mul(t, t)));
}

/// S(t) for t from smallUntil to pureFrom, given exp(−t²).
HWY_INLINE Vec largeShare(Vec t, Vec gaussian)
{
  return hn::NegMulAdd(gaussian, restOverGaussian(t), hn::Set(Tag(), 1.0));
}

HWY_INLINE Vec shareAt(Vec t)
{
  const Tag d;
  const Vec one = hn::Set(d, 1.0), end = hn::Set(d, pureFrom);
  const auto isPure = hn::Ge(t, end);
  if (hn::AllTrue(d, isPure))
  {
    return one;
  }
  const Vec within = hn::Min(t, end);
  const Vec large = hn::IfThenElse(isPure, one, largeShare(within, gaussian(within)));
  const auto isSmall = hn::Lt(t, hn::Set(d, smallUntil));
  if (hn::AllFalse(d, isSmall))
  {
    return large;
  }
  const Vec squared = hn::Mul(within, within);
  const Vec small = hn::Mul(shareOverCube(squared), hn::Mul(squared, within));
  return hn::IfThenElse(isSmall, small, large);
}

void addRegularizedDipolesLoop(const KernelDipole* HWY_RESTRICT dipoles,
  const double* HWY_RESTRICT inverseLengths, std::size_t count, const SampleBlock& samples,
  KernelSums& sums)
{
  const Tag d;
  const Vec zero = hn::Zero(d);
  for (std::size_t s = 0; s < samples.count; s += hn::Lanes(d))
  {
    const Vectors q = {
      hn::Load(d, samples.x + s), hn::Load(d, samples.y + s), hn::Load(d, samples.z + s)};
    Vec sum = hn::Load(d, sums.sum + s);
    for (std::size_t i = 0; i < count; ++i)
    {
      // The operations are addDipoles()'s, so that pure dipoles get the same bits.
      const Vectors r = broadcast(dipoles[i].position) - q;
      const Vec squared = dot(r, r), length = hn::Sqrt(squared);
      const Vec cube = hn::Mul(squared, length);
      const Vec flux = hn::Mul(dot(r, broadcast(dipoles[i].moment)),
        shareAt(hn::Mul(length, hn::Set(d, inverseLengths[i]))));
      sum = hn::Add(sum, hn::IfThenElseZero(hn::Gt(cube, zero), hn::Div(flux, cube)));
    }
    hn::Store(sum, d, sums.sum + s);
  }
}

/// The t from which on 1 − S(t) is less than a unit in the last place of numbers below 1 in single
/// precision, 6.0e-8.
constexpr float singlePureFrom = 4.3f;

/// S(t) in single precision. The polynomials are shareOverCube()'s and restOverGaussian()'s
/// with degrees 7 and 6, fitted in the same way up to t = 4.3; errors are within 5.2e-8 of G,
/// relatively, and 2.3e-9 of S.
HWY_INLINE SingleVec singleShareAt(SingleVec t)
{
  constexpr float ofSmall[] = {-9.66706466e-06f, 8.07036122e-05f, -0.000551081088f, 0.00333632948f,
    -0.0169058908f, 0.0686359555f, -0.20830439f, 0.400448948f};
  constexpr float ofRest[] = {0.000511455233f, -0.00350318197f, 0.012315671f, -0.0325800106f,
    0.0760981217f, 0.964759052f, 2.0141542f};
  const SingleTag d;
  const SingleVec one = hn::Set(d, 1.0f), end = hn::Set(d, singlePureFrom);
  const SingleVec border = hn::Set(d, static_cast<float>(smallUntil));
  const auto isPure = hn::Ge(t, end);
  if (hn::AllTrue(d, isPure))
  {
    return one;
  }
  const SingleVec within = hn::Min(t, end), squared = hn::Mul(within, within);
  const SingleVec rest =
    hn::Mul(hn::Exp(d, hn::Neg(squared)), polynomial(ofRest, hn::Sub(within, border)));
  const SingleVec large = hn::IfThenElse(isPure, one, hn::Sub(one, rest));
  const auto isSmall = hn::Lt(t, border);
  if (hn::AllFalse(d, isSmall))
  {
    return large;
  }
  const SingleVec small = hn::Mul(hn::Mul(squared, within),
    polynomial(ofSmall, hn::Sub(hn::Min(squared, hn::Set(d, 2.25f)), hn::Set(d, 1.125f))));
  return hn::IfThenElse(isSmall, small, large);
}

void addRegularizedDipolesInSingleLoop(const KernelDipole* HWY_RESTRICT dipoles,
  const std::array<float, 3>* HWY_RESTRICT moments, const double* HWY_RESTRICT inverseLengths,
  std::size_t count, const SampleBlock& samples, KernelSums& sums)
{
  addInSingle(dipoles, moments, count, samples, sums,
    [inverseLengths](std::size_t i, SingleVec flux, SingleVec squared, SingleVec inverse) HWY_ATTR
    {
      const SingleTag d;
      // The limit keeps the inverse length times the largest distance, and times the least one that
      // is not 0, in the range of single precision.
      const float inverseLength = static_cast<float>(std::min(inverseLengths[i], 1e25));
      const SingleVec t = hn::Mul(hn::Mul(squared, inverse), hn::Set(d, inverseLength));
      // S is the last factor: times the small ones before, it would leave the range next to the
      // point.
      const SingleVec pure = hn::Mul(hn::Mul(hn::Mul(flux, inverse), inverse), inverse);
      return hn::Mul(pure, singleShareAt(t));
    });
}

/// The factors of the gradient, factor · (slope (m·r) r · inverseSquare − share m), for a dipole m
/// at offset r; inverseSquare is 1/r².
struct GradientFactors
{
  Vec factor, share, slope, inverseSquare;
};

HWY_INLINE GradientFactors gradientFactors(Vec squared, Vec length, Vec inverseOfSpread)
{
  const Tag d;
  const Vec one = hn::Set(d, 1.0), three = hn::Set(d, 3.0), end = hn::Set(d, pureFrom);
  const Vec inverseCube = hn::Div(one, hn::Mul(squared, length));
  GradientFactors factors = {inverseCube, one, three, hn::Mul(length, inverseCube)};
  const Vec t = hn::Mul(length, inverseOfSpread);
  const auto isPure = hn::Ge(t, end);
  if (hn::AllTrue(d, isPure))
  {
    return factors;
  }
  const Vec within = hn::Min(t, end), square = hn::Mul(within, within);
  const Vec bell = gaussian(within);
  // The derivative is taken as S' / t² = 4/√π exp(−t²).
  const Vec derivative = hn::Mul(hn::Set(d, 2.2567583341910251478), bell);
  const Vec share = largeShare(within, bell);
  const Vec slope = hn::NegMulAdd(derivative, hn::Mul(square, within), hn::Mul(three, share));
  factors.share = hn::IfThenElse(isPure, one, share);
  factors.slope = hn::IfThenElse(isPure, three, slope);
  const auto isSmall = hn::Lt(t, hn::Set(d, smallUntil));
  if (hn::AllFalse(d, isSmall))
  {
    return factors;
  }
  // Share and slope are divided by t³ for small t, and the common factor is multiplied by it. The
  // slope's two terms cancel like t², but its part of the whole is smaller by as much; at the point
  // itself the slope is multiplied by 0, so it may have any finite value.
  const Vec small = shareOverCube(square);
  const Vec smallSlope = hn::MulSub(three, small, derivative);
  const Vec atLeast = hn::Set(d, 1e-290);
  const Vec cube = hn::Mul(hn::Mul(inverseOfSpread, inverseOfSpread), inverseOfSpread);
  factors.factor = hn::IfThenElse(isSmall, cube, factors.factor);
  factors.share = hn::IfThenElse(isSmall, small, factors.share);
  factors.slope = hn::IfThenElse(isSmall, smallSlope, factors.slope);
  factors.inverseSquare =
    hn::IfThenElse(isSmall, hn::Div(one, hn::Max(squared, atLeast)), factors.inverseSquare);
  return factors;
}

void addRegularizedDipoleGradientsLoop(const KernelDipole* HWY_RESTRICT dipoles,
  const double* HWY_RESTRICT inverseLengths, std::size_t count, const SampleBlock& samples,
  GradientSums& sums)
{
  const Tag d;
  for (std::size_t s = 0; s < samples.count; s += hn::Lanes(d))
  {
    const Vectors q = {
      hn::Load(d, samples.x + s), hn::Load(d, samples.y + s), hn::Load(d, samples.z + s)};
    Vectors sum = {hn::Load(d, sums.x + s), hn::Load(d, sums.y + s), hn::Load(d, sums.z + s)};
    for (std::size_t i = 0; i < count; ++i)
    {
      // The operations are addDipoleGradients()'s, so that pure dipoles get the same bits.
      const Vectors r = broadcast(dipoles[i].position) - q, m = broadcast(dipoles[i].moment);
      const Vec squared = dot(r, r), length = hn::Sqrt(squared);
      const GradientFactors of = gradientFactors(squared, length, hn::Set(d, inverseLengths[i]));
      const Vec flux = hn::Mul(hn::Mul(of.slope, dot(m, r)), of.inverseSquare);
      add({hn::Mul(of.factor, hn::MulSub(flux, r.x, hn::Mul(of.share, m.x))),
            hn::Mul(of.factor, hn::MulSub(flux, r.y, hn::Mul(of.share, m.y))),
            hn::Mul(of.factor, hn::MulSub(flux, r.z, hn::Mul(of.share, m.z)))},
        sum);
    }
    hn::Store(sum.x, d, sums.x + s);
    hn::Store(sum.y, d, sums.y + s);
    hn::Store(sum.z, d, sums.z + s);
  }
}

} // namespace HWY_NAMESPACE
} // namespace winding
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace winding
{

HWY_EXPORT(addRegularizedDipolesLoop);
HWY_EXPORT(addRegularizedDipolesInSingleLoop);
HWY_EXPORT(addRegularizedDipoleGradientsLoop);

void addRegularizedDipoles(const KernelDipole* dipoles, const double* inverseLengths,
  std::size_t count, const SampleBlock& samples, KernelSums& sums)
{
  HWY_DYNAMIC_DISPATCH(addRegularizedDipolesLoop)(dipoles, inverseLengths, count, samples, sums);
}

void addRegularizedDipolesInSingle(const KernelDipole* dipoles, const std::array<float, 3>* moments,
  const double* inverseLengths, std::size_t count, const SampleBlock& samples, KernelSums& sums)
{
  HWY_DYNAMIC_DISPATCH(addRegularizedDipolesInSingleLoop)
  (dipoles, moments, inverseLengths, count, samples, sums);
}

void addRegularizedDipoleGradients(const KernelDipole* dipoles, const double* inverseLengths,
  std::size_t count, const SampleBlock& samples, GradientSums& sums)
{
  HWY_DYNAMIC_DISPATCH(addRegularizedDipoleGradientsLoop)
  (dipoles, inverseLengths, count, samples, sums);
}

} // namespace winding
#endif
