// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/MultipoleKernels.h"

#include "farfield/Expansions.h"

// Highway compiles the rest of this file once for every instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "farfield/MultipoleKernels.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <utility>

HWY_BEFORE_NAMESPACE();
namespace winding
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

// Vectors have at most 16 lanes, for that is how arrays are padded.
using Tag = hn::CappedTag<float, 16>;
using Vec = hn::Vec<Tag>;

constexpr std::size_t laneRoom = 16;

/// Calls call(std::integral_constant<int, P>) with P = order.
template <class Call> HWY_INLINE void withOrder(int order, const Call& call)
{
  switch (order)
  {
  case 3:
    call(std::integral_constant<int, 3>());
    break;
  case 5:
    call(std::integral_constant<int, 5>());
    break;
  case 7:
    call(std::integral_constant<int, 7>());
    break;
  case 9:
    call(std::integral_constant<int, 9>());
    break;
  }
}

// ---------------------------------------------------------------------- moments of dipoles

template <int P> void addMomentsOf(const DipoleBatch& dipoles, float* HWY_RESTRICT moments)
{
  const Tag d;
  const std::size_t lanes = hn::Lanes(d);
  // The regular harmonics to degree P − 1, real and imaginary part in turn.
  alignas(64) float harmonics[2 * P * (P + 1) / 2 * laneRoom];
  const auto y = [&](int n, int m)
  {
    return harmonics + static_cast<std::size_t>(n * (n + 1) + 2 * m) * laneRoom;
  };
  const auto re = [&](int n, int m)
  {
    return hn::Load(d, y(n, m));
  };
  const auto im = [&](int n, int m)
  {
    return hn::Load(d, y(n, m) + laneRoom);
  };
  const auto add = [&](int place, Vec value)
  {
    moments[place] += hn::GetLane(hn::SumOfLanes(d, value));
  };

  for (std::size_t s = 0; s < dipoles.count; s += lanes)
  {
    const Vec px = hn::Load(d, dipoles.x + s), py = hn::Load(d, dipoles.y + s),
              pz = hn::Load(d, dipoles.z + s);
    const Vec nx = hn::Load(d, dipoles.nx + s), ny = hn::Load(d, dipoles.ny + s),
              nz = hn::Load(d, dipoles.nz + s);
    const Vec r2 = hn::MulAdd(px, px, hn::MulAdd(py, py, hn::Mul(pz, pz)));
    hn::Store(hn::Set(d, 1.0f), d, y(0, 0));
    hn::Store(hn::Zero(d), d, y(0, 0) + laneRoom);
    for (int n = 1; n < P; ++n)
    {
      const Vec half = hn::Set(d, 0.5f / static_cast<float>(n));
      const Vec ar = re(n - 1, n - 1), ai = im(n - 1, n - 1);
      hn::Store(hn::Mul(half, hn::Sub(hn::Mul(px, ar), hn::Mul(py, ai))), d, y(n, n));
      hn::Store(hn::Mul(half, hn::Add(hn::Mul(px, ai), hn::Mul(py, ar))), d, y(n, n) + laneRoom);
      for (int m = 0; m < n; ++m)
      {
        const float divisor = static_cast<float>(n * n - m * m);
        const Vec oddZ = hn::Mul(hn::Set(d, static_cast<float>(2 * n - 1) / divisor), pz);
        Vec vr = hn::Mul(oddZ, re(n - 1, m)), vi = hn::Mul(oddZ, im(n - 1, m));
        if (m <= n - 2)
        {
          const Vec square = hn::Mul(hn::Set(d, 1 / divisor), r2);
          vr = hn::NegMulAdd(square, re(n - 2, m), vr);
          vi = hn::NegMulAdd(square, im(n - 2, m), vi);
        }
        hn::Store(vr, d, y(n, m));
        hn::Store(vi, d, y(n, m) + laneRoom);
      }
    }
    const Vec half = hn::Set(d, 0.5f);
    const Vec hx = hn::Mul(half, nx), hy = hn::Mul(half, ny);
    for (int k = 1; k <= P; ++k)
    {
      // M_k^0 = −[n_z Y_{k−1}^0 − Re((n_x − i n_y) Y_{k−1}^1)]
      Vec slope = hn::Mul(nz, re(k - 1, 0));
      if (k >= 2)
      {
        slope = hn::NegMulAdd(nx, re(k - 1, 1), hn::NegMulAdd(ny, im(k - 1, 1), slope));
      }
      add(realPlace(k, 0), hn::Neg(slope));
      for (int m = 1; m <= k; ++m)
      {
        // Two neighbours contribute, m − 1 and, where it exists, m + 1.
        const Vec lr = re(k - 1, m - 1), li = im(k - 1, m - 1);
        Vec sr = hn::Sub(hn::Mul(hx, lr), hn::Mul(hy, li));
        Vec si = hn::MulAdd(hx, li, hn::Mul(hy, lr));
        if (m <= k - 1)
        {
          sr = hn::MulAdd(nz, re(k - 1, m), sr);
          si = hn::MulAdd(nz, im(k - 1, m), si);
        }
        if (m + 1 <= k - 1)
        {
          const Vec ur = re(k - 1, m + 1), ui = im(k - 1, m + 1);
          sr = hn::NegMulAdd(hx, ur, hn::NegMulAdd(hy, ui, sr));
          si = hn::NegMulAdd(hx, ui, hn::MulAdd(hy, ur, si));
        }
        add(realPlace(k, m), hn::Neg(sr));
        add(imaginaryPlace(k, m), hn::Neg(si));
      }
    }
  }
}

void addMomentsLoop(int order, const DipoleBatch& dipoles, float* moments)
{
  withOrder(order, [&](auto p) { addMomentsOf<decltype(p)::value>(dipoles, moments); });
}

// ---------------------------------------------------------------- moments to local expansions

/// The irregular harmonics T_j^m, j ≤ 2P, of unit vectors, one per lane. They are ordered by m,
/// then j, so that what a row of the translation needs lies together.
template <int P> struct UnitHarmonics
{
  static constexpr int top = 2 * P;
  static constexpr int place(int j, int m) { return m * (top + 1) - m * (m - 1) / 2 + (j - m); }
  static constexpr int count = place(top, top) + 1;

  alignas(64) float re[static_cast<std::size_t>(count) * laneRoom];
  alignas(64) float im[static_cast<std::size_t>(count) * laneRoom];

  float* realAt(int j, int m) { return re + static_cast<std::size_t>(place(j, m)) * laneRoom; }
  float* imaginaryAt(int j, int m) { return im + static_cast<std::size_t>(place(j, m)) * laneRoom; }

  HWY_INLINE void fill(Vec x, Vec y, Vec z)
  {
    const Tag d;
    Vec diagonalRe = hn::Set(d, 1.0f), diagonalIm = hn::Zero(d);
    for (int m = 0; m <= top; ++m)
    {
      if (m > 0)
      {
        const Vec odd = hn::Set(d, static_cast<float>(2 * m - 1));
        const Vec ox = hn::Mul(odd, x), oy = hn::Mul(odd, y);
        const Vec before = diagonalRe;
        diagonalRe = hn::Sub(hn::Mul(ox, before), hn::Mul(oy, diagonalIm));
        diagonalIm = hn::MulAdd(ox, diagonalIm, hn::Mul(oy, before));
      }
      Vec re1 = diagonalRe, im1 = diagonalIm, re2 = hn::Zero(d), im2 = hn::Zero(d);
      hn::Store(re1, d, realAt(m, m));
      hn::Store(im1, d, imaginaryAt(m, m));
      for (int n = m + 1; n <= top; ++n)
      {
        const Vec oddZ = hn::Mul(hn::Set(d, static_cast<float>(2 * n - 1)), z);
        const Vec square = hn::Set(d, static_cast<float>((n - 1) * (n - 1) - m * m));
        const Vec newRe = hn::Sub(hn::Mul(oddZ, re1), hn::Mul(square, re2));
        const Vec newIm = hn::Sub(hn::Mul(oddZ, im1), hn::Mul(square, im2));
        re2 = re1;
        im2 = im1;
        re1 = newRe;
        im1 = newIm;
        hn::Store(re1, d, realAt(n, m));
        hn::Store(im1, d, imaginaryAt(n, m));
      }
    }
  }
};

/**
 * The factors S = T_j^{m+l} + s T_j^{m−l} and D = T_j^{m+l} − s T_j^{m−l}, s = (−1)^l, by which
 * orders l and −l of the moments are multiplied, for 1 ≤ m ≤ l ≤ P. Under exchange of m and l the
 * real parts stay and the imaginary parts of S and D change places, so that m ≤ l is enough.
 */
template <int P> struct SumsAndDifferences
{
  static constexpr int pairs = P * (P + 1) / 2;
  static constexpr int degrees = 2 * P + 1;
  static constexpr int pair(int m, int l) { return (l - 1) * l / 2 + (m - 1); }

  /// The parts Sr, Dr, Si, Di for every (pair, j), in this order.
  alignas(64) float values[static_cast<std::size_t>(pairs * degrees) * 4 * laneRoom];

  float* at(int m, int l, int j)
  {
    return values + static_cast<std::size_t>(pair(m, l) * degrees + j) * 4 * laneRoom;
  }

  HWY_INLINE void fill(UnitHarmonics<P>& t)
  {
    const Tag d;
    for (int l = 1; l <= P; ++l)
    {
      for (int m = 1; m <= l; ++m)
      {
        // T^{m−l} = (−1)^{l−m} conj T^{l−m}, so that s T^{m−l} = (−1)^m conj T^{l−m}.
        const Vec sign = hn::Set(d, m % 2 ? -1.0f : 1.0f);
        for (int j = m + l; j <= 2 * P; ++j)
        {
          const Vec upRe = hn::Load(d, t.realAt(j, m + l)),
                    upIm = hn::Load(d, t.imaginaryAt(j, m + l));
          const Vec downRe = hn::Mul(sign, hn::Load(d, t.realAt(j, l - m)));
          const Vec downIm = hn::Mul(sign, hn::Load(d, t.imaginaryAt(j, l - m)));
          float* to = at(m, l, j);
          hn::Store(hn::Add(upRe, downRe), d, to);
          hn::Store(hn::Sub(upRe, downRe), d, to + laneRoom);
          hn::Store(hn::Sub(upIm, downIm), d, to + 2 * laneRoom);
          hn::Store(hn::Add(upIm, downIm), d, to + 3 * laneRoom);
        }
      }
    }
  }
};

/// Adds the coefficients (n, m), n = m … P, of one order m, computed from all moments, to sums.
template <int P, int m>
HWY_INLINE void translateOrder(const float* HWY_RESTRICT moments, UnitHarmonics<P>& t,
  SumsAndDifferences<P>& sd, const float* HWY_RESTRICT rowScale, float* HWY_RESTRICT sums)
{
  const Tag d;
  constexpr int rows = P + 1 - m;
  Vec re[rows], im[rows];
  for (int n = 0; n < rows; ++n)
  {
    re[n] = im[n] = hn::Zero(d);
  }
  const auto moment = [&](int place)
  {
    return hn::Load(d, moments + static_cast<std::size_t>(place) * laneRoom);
  };
  for (int k = 1; k <= P; ++k)
  {
    const Vec axial = moment(realPlace(k, 0));
    const float* tr = t.realAt(m + k, m);
    const float* ti = t.imaginaryAt(m + k, m);
    HWY_UNROLL(10)
    for (int n = 0; n < rows; ++n)
    {
      re[n] = hn::MulAdd(axial, hn::Load(d, tr + static_cast<std::size_t>(n) * laneRoom), re[n]);
      if (m > 0)
      {
        im[n] = hn::MulAdd(axial, hn::Load(d, ti + static_cast<std::size_t>(n) * laneRoom), im[n]);
      }
    }
    for (int l = 1; l <= k; ++l)
    {
      const Vec mr = moment(realPlace(k, l)), mi = moment(imaginaryPlace(k, l));
      if (m == 0)
      {
        const Vec mr2 = hn::Add(mr, mr), mi2 = hn::Add(mi, mi);
        // T_j^l exists for j ≥ l only, and here j ≥ k ≥ l.
        tr = t.realAt(k, l);
        ti = t.imaginaryAt(k, l);
        HWY_UNROLL(10)
        for (int n = 0; n < rows; ++n)
        {
          const std::size_t at = static_cast<std::size_t>(n) * laneRoom;
          re[n] = hn::MulAdd(mr2, hn::Load(d, tr + at), re[n]);
          re[n] = hn::MulAdd(mi2, hn::Load(d, ti + at), re[n]);
        }
        continue;
      }
      const float* s = l >= m ? sd.at(m, l, m + k) : sd.at(l, m, m + k);
      // The imaginary parts of S and D change places where m and l are exchanged.
      const std::size_t si = (l >= m ? 2 : 3) * laneRoom, di = (l >= m ? 3 : 2) * laneRoom;
      HWY_UNROLL(10)
      for (int n = 0; n < rows; ++n)
      {
        const float* at = s + static_cast<std::size_t>(n) * 4 * laneRoom;
        re[n] = hn::MulAdd(mr, hn::Load(d, at), re[n]);
        re[n] = hn::MulAdd(mi, hn::Load(d, at + di), re[n]);
        im[n] = hn::MulAdd(mr, hn::Load(d, at + si), im[n]);
        im[n] = hn::NegMulAdd(mi, hn::Load(d, at + laneRoom), im[n]);
      }
    }
  }
  for (int n = 0; n < rows; ++n)
  {
    const Vec scale = hn::Load(d, rowScale + static_cast<std::size_t>(n + m) * laneRoom);
    float* to = sums + static_cast<std::size_t>(realPlace(n + m, m)) * laneRoom;
    hn::Store(hn::MulAdd(scale, re[n], hn::Load(d, to)), d, to);
    if (m > 0)
    {
      to = sums + static_cast<std::size_t>(imaginaryPlace(n + m, m)) * laneRoom;
      hn::Store(hn::MulAdd(scale, im[n], hn::Load(d, to)), d, to);
    }
  }
}

template <int P, int... m>
HWY_INLINE void translateOrders(std::integer_sequence<int, m...>, const float* moments,
  UnitHarmonics<P>& t, SumsAndDifferences<P>& sd, const float* rowScale, float* sums)
{
  (translateOrder<P, m>(moments, t, sd, rowScale, sums), ...);
}

#if HWY_TARGET == HWY_SCALAR
HWY_INLINE void loadColumns(const float* const* rows, Vec (&columns)[4])
{
  for (int i = 0; i < 4; ++i)
  {
    columns[i] = hn::Load(Tag(), rows[0] + i);
  }
}
#else
/// A vector whose blocks of four lanes are the four numbers at each of rows[0], rows[4], rows[8] ….
template <class D> HWY_INLINE hn::Vec<D> loadBlocks(D d, const float* const* rows)
{
  if constexpr (hn::MaxLanes(D()) <= 4)
  {
    return hn::LoadU(d, rows[0]);
  }
  else
  {
    const hn::Half<D> half;
    return hn::Combine(d, loadBlocks(half, rows + hn::MaxLanes(half)), loadBlocks(half, rows));
  }
}

/**
 * Turns four consecutive numbers of as many rows as there are lanes into four vectors of lanes. A
 * gather of the same takes several times as long.
 */
HWY_INLINE void loadColumns(const float* const* rows, Vec (&columns)[4])
{
  const Tag d;
  const hn::RepartitionToWide<Tag> pairs;
  const Vec a = loadBlocks(d, rows), b = loadBlocks(d, rows + 1), c = loadBlocks(d, rows + 2),
            e = loadBlocks(d, rows + 3);
  const auto abLow = hn::BitCast(pairs, hn::InterleaveLower(d, a, b));
  const auto ceLow = hn::BitCast(pairs, hn::InterleaveLower(d, c, e));
  const auto abHigh = hn::BitCast(pairs, hn::InterleaveUpper(d, a, b));
  const auto ceHigh = hn::BitCast(pairs, hn::InterleaveUpper(d, c, e));
  columns[0] = hn::BitCast(d, hn::InterleaveLower(pairs, abLow, ceLow));
  columns[1] = hn::BitCast(d, hn::InterleaveUpper(pairs, abLow, ceLow));
  columns[2] = hn::BitCast(d, hn::InterleaveLower(pairs, abHigh, ceHigh));
  columns[3] = hn::BitCast(d, hn::InterleaveUpper(pairs, abHigh, ceHigh));
}
#endif

template <int P>
void translate(const float* HWY_RESTRICT moments, NodeBatch& batch, float side, LocalSums& sums)
{
  const Tag d;
  const std::size_t lanes = hn::Lanes(d);
  // Unused lanes hold the first node again, whose moments count 0 times there. At a distance of
  // their own, powers of the side over it might leave the range, and 0 times those is no number.
  const std::size_t used = (batch.count + lanes - 1) / lanes * lanes;
  for (std::size_t i = batch.count; i < used; ++i)
  {
    batch.node[i] = batch.node[0];
    batch.dx[i] = batch.dx[0];
    batch.dy[i] = batch.dy[0];
    batch.dz[i] = batch.dz[0];
    batch.radius[i] = batch.radius[0];
  }
  UnitHarmonics<P> t;
  SumsAndDifferences<P> sd;
  alignas(64) float scaled[coefficientCount(P) * laneRoom];
  alignas(64) float rowScale[(P + 1) * laneRoom];
  for (std::size_t s = 0; s < used; s += lanes)
  {
    const Vec x = hn::Load(d, batch.dx + s), y = hn::Load(d, batch.dy + s),
              z = hn::Load(d, batch.dz + s);
    const Vec inverse =
      hn::Div(hn::Set(d, 1.0f), hn::Sqrt(hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)))));
    t.fill(hn::Mul(x, inverse), hn::Mul(y, inverse), hn::Mul(z, inverse));
    sd.fill(t);

    // The nodes' moments are scaled by (r/d)^k / d, with 0 for unused lanes.
    const float* rows[laneRoom];
    for (std::size_t i = 0; i < lanes; ++i)
    {
      rows[i] = moments + static_cast<std::size_t>(batch.node[s + i]) * paddedCoefficients(P);
    }
    const Vec ratio = hn::Mul(hn::Load(d, batch.radius + s), inverse);
    Vec power = hn::IfThenElseZero(
      hn::Lt(hn::Iota(d, static_cast<float>(s)), hn::Set(d, static_cast<float>(batch.count))),
      inverse);
    int k = 0;
    for (int first = 0; first < coefficientCount(P); first += 4)
    {
      Vec columns[4];
      loadColumns(rows, columns);
      for (int place = first; place < first + 4; ++place)
      {
        if (place == (k + 1) * (k + 1))
        {
          ++k;
          power = hn::Mul(power, ratio);
        }
        hn::Store(hn::Mul(power, columns[place - first]), d,
          scaled + static_cast<std::size_t>(place) * laneRoom);
      }
      for (std::size_t i = 0; i < lanes; ++i)
      {
        rows[i] += 4;
      }
    }
    const Vec step = hn::Mul(hn::Set(d, -side), inverse);
    Vec scale = hn::Set(d, 1.0f);
    for (int n = 0; n <= P; ++n, scale = hn::Mul(scale, step))
    {
      hn::Store(scale, d, rowScale + static_cast<std::size_t>(n) * laneRoom);
    }
    translateOrders<P>(
      std::make_integer_sequence<int, P + 1>(), scaled, t, sd, rowScale, sums.lanes);
  }
}

void translateMomentsLoop(
  int order, const float* moments, NodeBatch& batch, float side, LocalSums& sums)
{
  withOrder(order, [&](auto p) { translate<decltype(p)::value>(moments, batch, side, sums); });
}

void addLanesLoop(int order, const LocalSums& sums, float* local)
{
  const Tag d;
  for (int i = 0; i < coefficientCount(order); ++i)
  {
    const Vec lanes = hn::Load(d, sums.lanes + static_cast<std::size_t>(i) * laneRoom);
    local[i] += hn::GetLane(hn::SumOfLanes(d, lanes));
  }
}

void multiplyMatrixLoop(const float* HWY_RESTRICT matrix, std::size_t rows, std::size_t columns,
  const float* HWY_RESTRICT from, float* HWY_RESTRICT to)
{
  const Tag d;
  for (std::size_t row = 0; row < rows; row += hn::Lanes(d))
  {
    Vec even = hn::Zero(d), odd = hn::Zero(d);
    std::size_t column = 0;
    for (; column + 1 < columns; column += 2)
    {
      even = hn::MulAdd(hn::Set(d, from[column]), hn::LoadU(d, matrix + column * rows + row), even);
      odd = hn::MulAdd(
        hn::Set(d, from[column + 1]), hn::LoadU(d, matrix + (column + 1) * rows + row), odd);
    }
    if (column < columns)
    {
      even = hn::MulAdd(hn::Set(d, from[column]), hn::LoadU(d, matrix + column * rows + row), even);
    }
    hn::StoreU(hn::Add(even, odd), d, to + row);
  }
}

// --------------------------------------------------------------------------- values at samples

/// The offsets of a vector of samples along one axis, in single precision and in units of the
/// radius. They are cut off where their powers would leave the range; all values have long been 0
/// there.
HWY_INLINE Vec offsetsFrom(const double* HWY_RESTRICT samples, double center, double inverseRadius)
{
  const Tag d;
  const hn::Half<Tag> half;
  const hn::Rebind<double, hn::Half<Tag>> wide;
  const auto convert = [&](const double* from)
  {
    const auto farthest = hn::Set(wide, farthestOffset);
    const auto offset =
      hn::Mul(hn::Sub(hn::Load(wide, from), hn::Set(wide, center)), hn::Set(wide, inverseRadius));
    return hn::DemoteTo(half, hn::Min(hn::Max(offset, hn::Neg(farthest)), farthest));
  };
#if HWY_TARGET == HWY_SCALAR
  (void)d;
  return convert(samples);
#else
  return hn::Combine(d, convert(samples + hn::Lanes(wide)), convert(samples));
#endif
}

template <int P>
void addMomentValuesOf(const float* HWY_RESTRICT moments, const double (&center)[3], double radius,
  const SampleBlock& samples, float* HWY_RESTRICT values)
{
  const Tag d;
  const double inverseRadius = 1 / radius;
  for (std::size_t s = 0; s < samples.count; s += hn::Lanes(d))
  {
    const Vec px = offsetsFrom(samples.x + s, center[0], inverseRadius),
              py = offsetsFrom(samples.y + s, center[1], inverseRadius),
              pz = offsetsFrom(samples.z + s, center[2], inverseRadius);
    const Vec squared = hn::MulAdd(px, px, hn::MulAdd(py, py, hn::Mul(pz, pz)));
    const Vec inverse = hn::Div(hn::Set(d, 1.0f), squared);
    const Vec ix = hn::Mul(px, inverse), iy = hn::Mul(py, inverse), iz = hn::Mul(pz, inverse);
    Vec diagonalRe = hn::Sqrt(inverse), diagonalIm = hn::Zero(d);
    Vec axial = hn::Zero(d), rest = hn::Zero(d);
    for (int m = 0; m <= P; ++m)
    {
      if (m > 0)
      {
        const Vec odd = hn::Set(d, static_cast<float>(2 * m - 1));
        const Vec ox = hn::Mul(odd, ix), oy = hn::Mul(odd, iy);
        const Vec before = diagonalRe;
        diagonalRe = hn::Sub(hn::Mul(ox, before), hn::Mul(oy, diagonalIm));
        diagonalIm = hn::MulAdd(ox, diagonalIm, hn::Mul(oy, before));
      }
      Vec re1 = diagonalRe, im1 = diagonalIm, re2 = hn::Zero(d), im2 = hn::Zero(d);
      for (int n = m; n <= P; ++n)
      {
        if (n > m)
        {
          const Vec oddZ = hn::Mul(hn::Set(d, static_cast<float>(2 * n - 1)), iz);
          const Vec square =
            hn::Mul(hn::Set(d, static_cast<float>((n - 1) * (n - 1) - m * m)), inverse);
          const Vec newRe = hn::Sub(hn::Mul(oddZ, re1), hn::Mul(square, re2));
          const Vec newIm = hn::Sub(hn::Mul(oddZ, im1), hn::Mul(square, im2));
          re2 = re1;
          im2 = im1;
          re1 = newRe;
          im1 = newIm;
        }
        if (m == 0)
        {
          axial = hn::MulAdd(hn::Set(d, moments[realPlace(n, 0)]), re1, axial);
        }
        else
        {
          rest = hn::MulAdd(hn::Set(d, moments[realPlace(n, m)]), re1, rest);
          rest = hn::MulAdd(hn::Set(d, moments[imaginaryPlace(n, m)]), im1, rest);
        }
      }
    }
    const Vec sum = hn::MulAdd(hn::Set(d, 2.0f), rest, axial);
    hn::Store(
      hn::MulAdd(hn::Set(d, static_cast<float>(inverseRadius)), sum, hn::Load(d, values + s)), d,
      values + s);
  }
}

void addMomentValuesLoop(int order, const float* moments, const double (&center)[3], double radius,
  const SampleBlock& samples, float* values)
{
  withOrder(order, [&](auto p)
    { addMomentValuesOf<decltype(p)::value>(moments, center, radius, samples, values); });
}

template <int P>
void evaluatePolynomialOf(const float* HWY_RESTRICT coefficients, const float* HWY_RESTRICT x,
  const float* HWY_RESTRICT y, const float* HWY_RESTRICT z, std::size_t count,
  float* HWY_RESTRICT values)
{
  const Tag d;
  for (std::size_t s = 0; s < count; s += hn::Lanes(d))
  {
    const Vec px = hn::Load(d, x + s), py = hn::Load(d, y + s), pz = hn::Load(d, z + s);
    const float* c = coefficients;
    Vec inX = hn::Zero(d);
    for (int i = P; i >= 0; --i)
    {
      Vec inY = hn::Zero(d);
      for (int j = P - i; j >= 0; --j)
      {
        Vec inZ = hn::Set(d, *c++);
        for (int k = P - i - j; k > 0; --k)
        {
          inZ = hn::MulAdd(inZ, pz, hn::Set(d, *c++));
        }
        inY = hn::MulAdd(inY, py, inZ);
      }
      inX = hn::MulAdd(inX, px, inY);
    }
    hn::Store(inX, d, values + s);
  }
}

void evaluatePolynomialLoop(int order, const float* coefficients, const float* x, const float* y,
  const float* z, std::size_t count, float* values)
{
  withOrder(order, [&](auto p)
    { evaluatePolynomialOf<decltype(p)::value>(coefficients, x, y, z, count, values); });
}

void evaluateRowLoop(int order, const float* HWY_RESTRICT coefficients, const float* HWY_RESTRICT x,
  std::size_t count, float* HWY_RESTRICT values)
{
  const Tag d;
  for (std::size_t s = 0; s < count; s += hn::Lanes(d))
  {
    const Vec px = hn::Load(d, x + s);
    Vec sum = hn::Set(d, coefficients[0]);
    for (int i = 1; i <= order; ++i)
    {
      sum = hn::MulAdd(sum, px, hn::Set(d, coefficients[i]));
    }
    hn::Store(sum, d, values + s);
  }
}

} // namespace HWY_NAMESPACE
} // namespace winding
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace winding
{

HWY_EXPORT(addMomentsLoop);
HWY_EXPORT(translateMomentsLoop);
HWY_EXPORT(addLanesLoop);
HWY_EXPORT(multiplyMatrixLoop);
HWY_EXPORT(addMomentValuesLoop);
HWY_EXPORT(evaluatePolynomialLoop);
HWY_EXPORT(evaluateRowLoop);

void addMoments(int order, const DipoleBatch& dipoles, float* moments)
{
  HWY_DYNAMIC_DISPATCH(addMomentsLoop)(order, dipoles, moments);
}

void translateMoments(
  int order, const float* moments, NodeBatch& batch, float side, LocalSums& sums)
{
  HWY_DYNAMIC_DISPATCH(translateMomentsLoop)(order, moments, batch, side, sums);
}

void addLanes(int order, const LocalSums& sums, float* local)
{
  HWY_DYNAMIC_DISPATCH(addLanesLoop)(order, sums, local);
}

void multiplyMatrix(
  const float* matrix, std::size_t rows, std::size_t columns, const float* from, float* to)
{
  HWY_DYNAMIC_DISPATCH(multiplyMatrixLoop)(matrix, rows, columns, from, to);
}

void addMomentValues(int order, const float* moments, const double (&center)[3], double radius,
  const SampleBlock& samples, float* values)
{
  HWY_DYNAMIC_DISPATCH(addMomentValuesLoop)(order, moments, center, radius, samples, values);
}

void evaluatePolynomial(int order, const float* coefficients, const float* x, const float* y,
  const float* z, std::size_t count, float* values)
{
  HWY_DYNAMIC_DISPATCH(evaluatePolynomialLoop)(order, coefficients, x, y, z, count, values);
}

void evaluateRow(
  int order, const float* coefficients, const float* x, std::size_t count, float* values)
{
  HWY_DYNAMIC_DISPATCH(evaluateRowLoop)(order, coefficients, x, count, values);
}

} // namespace winding
#endif
