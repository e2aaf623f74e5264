#include "GradientKernels.h"

#include "DirectSumKernels.h"

// Highway compiles the rest of this file once for every instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "GradientKernels.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// After highway.h, of which it wants to know the instruction set.
#include "KernelVectors-inl.h"

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
  // a×b = a×(b−a) = b×(b−a): the shorter one loses fewer digits.
  const auto isNearA = hn::Le(aa, bb);
  const Vectors shorter = {hn::IfThenElse(isNearA, a.x, b.x), hn::IfThenElse(isNearA, a.y, b.y),
    hn::IfThenElse(isNearA, a.z, b.z)};
  const Vectors c = cross(shorter, broadcast(edge.along));
  const Vec la = hn::Sqrt(aa), lb = hn::Sqrt(bb), product = hn::Mul(la, lb);
  // Beside the edge |a||b| + a·b would cancel; it is |a×b|² / (|a||b| − a·b).
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
  // 3 m·r / r²
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

void addMomentGradientsLoop(const MomentDerivatives& derivatives, float inverseRadius,
  const float* HWY_RESTRICT x, const float* HWY_RESTRICT y, const float* HWY_RESTRICT z,
  std::size_t count, FloatGradientSums& sums)
{
  // At most 16 lanes, for that is how arrays are padded.
  const hn::CappedTag<float, 16> d;
  using Floats = hn::Vec<decltype(d)>;
  const auto set = [&d](float value) HWY_ATTR
  {
    return hn::Set(d, value);
  };
  for (std::size_t s = 0; s < count; s += hn::Lanes(d))
  {
    // T_n^m one order m after the other, as addMomentValues() has them.
    const Floats px = hn::Load(d, x + s), py = hn::Load(d, y + s), pz = hn::Load(d, z + s);
    const Floats squared = hn::MulAdd(px, px, hn::MulAdd(py, py, hn::Mul(pz, pz)));
    const Floats inverse = hn::Div(set(1), squared);
    const Floats ix = hn::Mul(px, inverse), iy = hn::Mul(py, inverse), iz = hn::Mul(pz, inverse);
    // Orders m and −m together: twice the real part.
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

HWY_EXPORT(addEdgeGradientsLoop);
HWY_EXPORT(addDipoleGradientsLoop);
HWY_EXPORT(addMomentGradientsLoop);

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
    // M^{−1} = −conj M^1.
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
