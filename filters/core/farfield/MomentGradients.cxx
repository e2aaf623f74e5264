// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/MomentGradients.h"

// Highway compiles the rest of this file once for every instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "farfield/MomentGradients.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace winding
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

void addMomentGradientsLoop(const MomentDerivatives& derivatives, float inverseRadius,
  const float* HWY_RESTRICT x, const float* HWY_RESTRICT y, const float* HWY_RESTRICT z,
  std::size_t count, FloatGradientSums& sums)
{
  // Vectors have at most 16 lanes, for that is how arrays are padded.
  const hn::CappedTag<float, 16> d;
  using Floats = hn::Vec<decltype(d)>;
  const auto set = [&d](float value) HWY_ATTR
  {
    return hn::Set(d, value);
  };
  for (std::size_t s = 0; s < count; s += hn::Lanes(d))
  {
    // The harmonics T_n^m come one order m after the other, as in addMomentValues().
    const Floats px = hn::Load(d, x + s), py = hn::Load(d, y + s), pz = hn::Load(d, z + s);
    const Floats squared = hn::MulAdd(px, px, hn::MulAdd(py, py, hn::Mul(pz, pz)));
    const Floats inverse = hn::Div(set(1), squared);
    const Floats ix = hn::Mul(px, inverse), iy = hn::Mul(py, inverse), iz = hn::Mul(pz, inverse);
    // Orders m and −m together give twice the real part.
    Floats diagonalRe = hn::Mul(set(2), hn::Sqrt(inverse)), diagonalIm = hn::Zero(d);
    Floats sumX = hn::Zero(d), sumY = hn::Zero(d), sumZ = hn::Zero(d);
    const auto add = [&](int place, Floats harmonic) HWY_ATTR
    {
      sumX = hn::MulAdd(set(derivatives.x[place]), harmonic, sumX);
      sumY = hn::MulAdd(set(derivatives.y[place]), harmonic, sumY);
      sumZ = hn::MulAdd(set(derivatives.z[place]), harmonic, sumZ);
    };
    for (int m = 0; m <= derivatives.order; ++m)
    {
      if (m > 0)
      {
        const Floats odd = set(static_cast<float>(2 * m - 1));
        const Floats ox = hn::Mul(odd, ix), oy = hn::Mul(odd, iy);
        const Floats before = diagonalRe;
        diagonalRe = hn::Sub(hn::Mul(ox, before), hn::Mul(oy, diagonalIm));
        diagonalIm = hn::MulAdd(ox, diagonalIm, hn::Mul(oy, before));
      }
      Floats re1 = m > 0 ? diagonalRe : hn::Sqrt(inverse), im1 = diagonalIm;
      Floats re2 = hn::Zero(d), im2 = hn::Zero(d);
      for (int n = m; n <= derivatives.order; ++n)
      {
        if (n > m)
        {
          const Floats oddZ = hn::Mul(set(static_cast<float>(2 * n - 1)), iz);
          const Floats square =
            hn::Mul(set(static_cast<float>((n - 1) * (n - 1) - m * m)), inverse);
          const Floats newRe = hn::Sub(hn::Mul(oddZ, re1), hn::Mul(square, re2));
          const Floats newIm = hn::Sub(hn::Mul(oddZ, im1), hn::Mul(square, im2));
          re2 = re1;
          im2 = im1;
          re1 = newRe;
          im1 = newIm;
        }
        add(realPlace(n, m), re1);
        if (m > 0)
        {
          add(imaginaryPlace(n, m), im1);
        }
      }
    }
    const Floats factor = set(inverseRadius * inverseRadius);
    hn::Store(hn::MulAdd(factor, sumX, hn::Load(d, sums.x + s)), d, sums.x + s);
    hn::Store(hn::MulAdd(factor, sumY, hn::Load(d, sums.y + s)), d, sums.y + s);
    hn::Store(hn::MulAdd(factor, sumZ, hn::Load(d, sums.z + s)), d, sums.z + s);
  }
}

} // namespace HWY_NAMESPACE
} // namespace winding
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace winding
{

HWY_EXPORT(addMomentGradientsLoop);

MomentDerivatives::MomentDerivatives(int momentOrder, const float* moments)
  : order(momentOrder + 1)
{
  x[0] = y[0] = z[0] = 0;
  for (int n = 0; n < order; ++n)
  {
    const auto re = [&](int m)
    {
      return m <= n ? moments[realPlace(n, m)] : 0;
    };
    const auto im = [&](int m)
    {
      return 0 < m && m <= n ? moments[imaginaryPlace(n, m)] : 0;
    };
    // The formulas for m = 0 use M^{−1} = −conj M^1.
    x[realPlace(n + 1, 0)] = re(1);
    y[realPlace(n + 1, 0)] = im(1);
    z[realPlace(n + 1, 0)] = -re(0);
    for (int m = 1; m <= n + 1; ++m)
    {
      x[realPlace(n + 1, m)] = 0.5f * (re(m + 1) - re(m - 1));
      x[imaginaryPlace(n + 1, m)] = 0.5f * (im(m + 1) - im(m - 1));
      y[realPlace(n + 1, m)] = 0.5f * (im(m + 1) + im(m - 1));
      y[imaginaryPlace(n + 1, m)] = -0.5f * (re(m + 1) + re(m - 1));
      z[realPlace(n + 1, m)] = -re(m);
      z[imaginaryPlace(n + 1, m)] = -im(m);
    }
  }
}

void addMomentGradients(const MomentDerivatives& derivatives, float inverseRadius, const float* x,
  const float* y, const float* z, std::size_t count, FloatGradientSums& sums)
{
  HWY_DYNAMIC_DISPATCH(addMomentGradientsLoop)(derivatives, inverseRadius, x, y, z, count, sums);
}

} // namespace winding
#endif
