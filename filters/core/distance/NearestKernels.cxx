// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "distance/NearestKernels.h"

#include <Eigen/Geometry>

#include <limits>

// Highway compiles the rest of this file once for every instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "distance/NearestKernels.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace winding
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// Three-dimensional vectors, one per lane of D.
template <class D> struct Offsets
{
  hn::Vec<D> x, y, z;
};

template <class D> HWY_INLINE Offsets<D> broadcast(D d, const double* from)
{
  return {hn::Set(d, from[0]), hn::Set(d, from[1]), hn::Set(d, from[2])};
}

template <class D> HWY_INLINE Offsets<D> difference(D, const Offsets<D>& a, const Offsets<D>& b)
{
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

template <class D> HWY_INLINE hn::Vec<D> product(D, const Offsets<D>& a, const Offsets<D>& b)
{
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

/// Returns from − factor·along.
template <class D>
HWY_INLINE Offsets<D> stepBack(
  D, const Offsets<D>& from, hn::Vec<D> factor, const Offsets<D>& along)
{
  return {hn::NegMulAdd(factor, along.x, from.x), hn::NegMulAdd(factor, along.y, from.y),
    hn::NegMulAdd(factor, along.z, from.z)};
}

/// Offsets of samples from the nearest points found, and their squares.
template <class D> struct NearestOffsets
{
  hn::Vec<D> squared;
  Offsets<D> offset;

  template <class Mask> HWY_INLINE void take(D d, const Offsets<D>& other, Mask allowed)
  {
    const hn::Vec<D> square = product(d, other, other);
    const auto isNearer = hn::And(allowed, hn::Lt(square, squared));
    squared = hn::IfThenElse(isNearer, square, squared);
    offset.x = hn::IfThenElse(isNearer, other.x, offset.x);
    offset.y = hn::IfThenElse(isNearer, other.y, offset.y);
    offset.z = hn::IfThenElse(isNearer, other.z, offset.z);
  }

  HWY_INLINE void take(D d, const Offsets<D>& other)
  {
    this->take(d, other, hn::Eq(hn::Zero(d), hn::Zero(d)));
  }
};

/// The offset from the nearest point of a side, given the offset from the side's beginning.
template <class D>
HWY_INLINE Offsets<D> fromSide(
  D d, const Offsets<D>& fromBegin, const Offsets<D>& along, double inverse)
{
  const hn::Vec<D> place = hn::Mul(product(d, fromBegin, along), hn::Set(d, inverse));
  const hn::Vec<D> inside = hn::Min(hn::Max(place, hn::Zero(d)), hn::Set(d, 1.0));
  return stepBack(d, fromBegin, inside, along);
}

template <class D>
HWY_INLINE void takeNearer(
  D d, const NearTriangle& triangle, const Offsets<D>& sample, NearestOffsets<D>& nearest)
{
  const Offsets<D> ab = broadcast(d, triangle.ab), ac = broadcast(d, triangle.ac);
  const Offsets<D> ap = difference(d, sample, broadcast(d, triangle.a));
  nearest.take(d, fromSide(d, ap, ab, triangle.inverseAB));
  nearest.take(d, fromSide(d, ap, ac, triangle.inverseAC));
  nearest.take(d, fromSide(d, difference(d, ap, ab), difference(d, ac, ab), triangle.inverseBC));
  const Offsets<D> planeB = broadcast(d, triangle.v), planeC = broadcast(d, triangle.w);
  const hn::Vec<D> v = product(d, ap, planeB), w = product(d, ap, planeC);
  Offsets<D> fromPlane = stepBack(d, stepBack(d, ap, v, ab), w, ac);
  // The weights of a thin triangle are inexact, by as many digits as it is thin. The rest that they
  // leave in the offset is small enough to be found by the same weights and removed.
  const hn::Vec<D> restV = product(d, fromPlane, planeB), restW = product(d, fromPlane, planeC);
  fromPlane = stepBack(d, stepBack(d, fromPlane, restV, ab), restW, ac);
  // A triangle as thin as rounding has weights that are not even nearly right, so that the rest is
  // no small one. Its sides are as near as its inside.
  const hn::Vec<D> allV = hn::Add(v, restV), allW = hn::Add(w, restW);
  const hn::Vec<D> most = hn::Set(d, 0x1p-10);
  const auto isSmall = hn::And(hn::Le(hn::Abs(restV), most), hn::Le(hn::Abs(restW), most));
  const auto isInside =
    hn::And(isSmall, hn::And(hn::And(hn::Ge(allV, hn::Zero(d)), hn::Ge(allW, hn::Zero(d))),
                       hn::Le(hn::Add(allV, allW), hn::Set(d, 1.0))));
  nearest.take(d, fromPlane, isInside);
}

template <class D>
HWY_INLINE void takeNearer(
  D d, const NearPoint& point, const Offsets<D>& sample, NearestOffsets<D>& nearest)
{
  nearest.take(d, difference(d, sample, broadcast(d, point.position)));
}

template <class Item>
HWY_INLINE void lower(const Item* HWY_RESTRICT items, const std::uint32_t* HWY_RESTRICT numbers,
  std::size_t count, const SampleBlock& samples, double* HWY_RESTRICT squared)
{
  using D = hn::CappedTag<double, samplesAtOnce>;
  const D d;
  for (std::size_t s = 0; s < samples.count; s += hn::Lanes(d))
  {
    const Offsets<D> sample = {
      hn::Load(d, samples.x + s), hn::Load(d, samples.y + s), hn::Load(d, samples.z + s)};
    NearestOffsets<D> nearest = {hn::Load(d, squared + s), sample};
    for (std::size_t i = 0; i < count; ++i)
    {
      takeNearer(d, items[numbers[i]], sample, nearest);
    }
    hn::Store(nearest.squared, d, squared + s);
  }
}

template <class Item>
HWY_INLINE void lowerNamesOf(const Item* HWY_RESTRICT items,
  const std::uint32_t* HWY_RESTRICT numbers, std::size_t count,
  const std::uint32_t* HWY_RESTRICT names, const SampleBlock& samples,
  const double* HWY_RESTRICT limits, double* HWY_RESTRICT least)
{
  using D = hn::CappedTag<double, samplesAtOnce>;
  const D d;
  for (std::size_t s = 0; s < samples.count; s += hn::Lanes(d))
  {
    const Offsets<D> sample = {
      hn::Load(d, samples.x + s), hn::Load(d, samples.y + s), hn::Load(d, samples.z + s)};
    const auto limit = hn::Load(d, limits + s);
    auto lowest = hn::Load(d, least + s);
    for (std::size_t i = 0; i < count; ++i)
    {
      NearestOffsets<D> nearest = {limit, sample};
      takeNearer(d, items[numbers[i]], sample, nearest);
      const auto name = hn::Set(d, static_cast<double>(names[numbers[i]]));
      lowest = hn::IfThenElse(hn::Lt(nearest.squared, limit), hn::Min(lowest, name), lowest);
    }
    hn::Store(lowest, d, least + s);
  }
}

void lowerNamesOfTriangles(const NearTriangle* triangles, const std::uint32_t* numbers,
  std::size_t count, const std::uint32_t* names, const SampleBlock& samples,
  const double* squaredLimits, double* least)
{
  lowerNamesOf(triangles, numbers, count, names, samples, squaredLimits, least);
}

void lowerNamesOfPoints(const NearPoint* points, const std::uint32_t* numbers, std::size_t count,
  const std::uint32_t* names, const SampleBlock& samples, const double* squaredLimits,
  double* least)
{
  lowerNamesOf(points, numbers, count, names, samples, squaredLimits, least);
}

bool isTriangleNearer(
  const NearTriangle& triangle, const SampleBlock& samples, const double* squaredLimits)
{
  using D = hn::CappedTag<double, samplesAtOnce>;
  const D d;
  for (std::size_t s = 0; s < samplesAtOnce; s += hn::Lanes(d))
  {
    const Offsets<D> sample = {
      hn::Load(d, samples.x + s), hn::Load(d, samples.y + s), hn::Load(d, samples.z + s)};
    const Offsets<D> offset = difference(d, sample, broadcast(d, triangle.a));
    NearestOffsets<D> nearest = {product(d, offset, offset), offset};
    takeNearer(d, triangle, sample, nearest);
    if (!hn::AllFalse(d, hn::Le(nearest.squared, hn::Load(d, squaredLimits + s))))
    {
      return true;
    }
  }
  return false;
}

template <class Item>
HWY_INLINE void find(
  const Item* HWY_RESTRICT items, const NearItems& run, const double* at, Nearest& nearest)
{
  using D = hn::CappedTag<double, 1>;
  const D d;
  const Offsets<D> sample = broadcast(d, at);
  NearestOffsets<D> best = {hn::Set(d, nearest.squared), broadcast(d, nearest.offset)};
  for (std::uint32_t i = run.first; i != run.last; ++i)
  {
    takeNearer(d, items[i], sample, best);
    const double squared = hn::GetLane(best.squared);
    nearest.item = squared < nearest.squared ? i : nearest.item;
    nearest.squared = squared;
  }
  nearest.offset[0] = hn::GetLane(best.offset.x);
  nearest.offset[1] = hn::GetLane(best.offset.y);
  nearest.offset[2] = hn::GetLane(best.offset.z);
}

template <class Item>
HWY_INLINE void findOfEach(const Item* HWY_RESTRICT items,
  const std::uint32_t* HWY_RESTRICT numbers, std::size_t count, const SampleBlock& samples,
  Nearest* HWY_RESTRICT nearest)
{
  using D = hn::CappedTag<double, samplesAtOnce>;
  const D d;
  for (std::size_t s = 0; s < samples.count; s += hn::Lanes(d))
  {
    const Offsets<D> sample = {
      hn::Load(d, samples.x + s), hn::Load(d, samples.y + s), hn::Load(d, samples.z + s)};
    NearestOffsets<D> best = {hn::Set(d, std::numeric_limits<double>::infinity()), sample};
    auto place = hn::Zero(d);
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto before = best.squared;
      takeNearer(d, items[numbers[i]], sample, best);
      const auto here = hn::Set(d, static_cast<double>(i));
      place = hn::IfThenElse(hn::Lt(best.squared, before), here, place);
    }
    alignas(64) double lanes[5][samplesAtOnce];
    hn::Store(best.squared, d, lanes[0]);
    hn::Store(best.offset.x, d, lanes[1]);
    hn::Store(best.offset.y, d, lanes[2]);
    hn::Store(best.offset.z, d, lanes[3]);
    hn::Store(place, d, lanes[4]);
    for (std::size_t lane = 0; lane < hn::Lanes(d) && s + lane < samples.count; ++lane)
    {
      nearest[s + lane] = {lanes[0][lane], {lanes[1][lane], lanes[2][lane], lanes[3][lane]},
        numbers[static_cast<std::size_t>(lanes[4][lane])]};
    }
  }
}

void lowerByTriangles(const NearTriangle* triangles, const std::uint32_t* numbers,
  std::size_t count, const SampleBlock& samples, double* squared)
{
  lower(triangles, numbers, count, samples, squared);
}

void lowerByPoints(const NearPoint* points, const std::uint32_t* numbers, std::size_t count,
  const SampleBlock& samples, double* squared)
{
  lower(points, numbers, count, samples, squared);
}

void findOfEachAmongTriangles(const NearTriangle* triangles, const std::uint32_t* numbers,
  std::size_t count, const SampleBlock& samples, Nearest* nearest)
{
  findOfEach(triangles, numbers, count, samples, nearest);
}

void findOfEachAmongPoints(const NearPoint* points, const std::uint32_t* numbers, std::size_t count,
  const SampleBlock& samples, Nearest* nearest)
{
  findOfEach(points, numbers, count, samples, nearest);
}

void findAmongTriangles(
  const NearTriangle* triangles, const NearItems& run, const double* sample, Nearest& nearest)
{
  find(triangles, run, sample, nearest);
}

void findAmongPoints(
  const NearPoint* points, const NearItems& run, const double* sample, Nearest& nearest)
{
  find(points, run, sample, nearest);
}

} // namespace HWY_NAMESPACE
} // namespace winding
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace winding
{

HWY_EXPORT(lowerByTriangles);
HWY_EXPORT(lowerByPoints);
HWY_EXPORT(lowerNamesOfTriangles);
HWY_EXPORT(lowerNamesOfPoints);
HWY_EXPORT(isTriangleNearer);
HWY_EXPORT(findOfEachAmongTriangles);
HWY_EXPORT(findOfEachAmongPoints);
HWY_EXPORT(findAmongTriangles);
HWY_EXPORT(findAmongPoints);

namespace
{

/// 1/x, or 0 where x is too small for that.
double inverseOf(double x)
{
  return x >= std::numeric_limits<double>::min() ? 1 / x : 0;
}

void store(const Eigen::Vector3d& from, double (&to)[3])
{
  Eigen::Vector3d::Map(to) = from;
}

} // namespace

NearTriangle nearTriangle(
  const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const Eigen::Vector3d ab = b - a, ac = c - a;
  const Eigen::Vector3d normal = ab.cross(ac);
  const double inverse = inverseOf(normal.squaredNorm());
  NearTriangle triangle;
  store(a, triangle.a);
  store(ab, triangle.ab);
  store(ac, triangle.ac);
  store(ac.cross(normal) * inverse, triangle.v);
  store(normal.cross(ab) * inverse, triangle.w);
  triangle.inverseAB = inverseOf(ab.squaredNorm());
  triangle.inverseAC = inverseOf(ac.squaredNorm());
  triangle.inverseBC = inverseOf((ac - ab).squaredNorm());
  return triangle;
}

void lowerSquaredDistances(const NearTriangle* triangles, const std::uint32_t* numbers,
  std::size_t count, const SampleBlock& samples, double* squared)
{
  HWY_DYNAMIC_DISPATCH(lowerByTriangles)(triangles, numbers, count, samples, squared);
}

void lowerSquaredDistances(const NearPoint* points, const std::uint32_t* numbers, std::size_t count,
  const SampleBlock& samples, double* squared)
{
  HWY_DYNAMIC_DISPATCH(lowerByPoints)(points, numbers, count, samples, squared);
}

void lowerNames(const NearTriangle* triangles, const std::uint32_t* numbers, std::size_t count,
  const std::uint32_t* names, const SampleBlock& samples, const double* squaredLimits,
  double* least)
{
  HWY_DYNAMIC_DISPATCH(lowerNamesOfTriangles)
  (triangles, numbers, count, names, samples, squaredLimits, least);
}

void lowerNames(const NearPoint* points, const std::uint32_t* numbers, std::size_t count,
  const std::uint32_t* names, const SampleBlock& samples, const double* squaredLimits,
  double* least)
{
  HWY_DYNAMIC_DISPATCH(lowerNamesOfPoints)
  (points, numbers, count, names, samples, squaredLimits, least);
}

bool isNearer(const NearTriangle& triangle, const SampleBlock& samples, const double* squaredLimits)
{
  return HWY_DYNAMIC_DISPATCH(isTriangleNearer)(triangle, samples, squaredLimits);
}

void findNearestOfEach(const NearTriangle* triangles, const std::uint32_t* numbers,
  std::size_t count, const SampleBlock& samples, Nearest* nearest)
{
  HWY_DYNAMIC_DISPATCH(findOfEachAmongTriangles)(triangles, numbers, count, samples, nearest);
}

void findNearestOfEach(const NearPoint* points, const std::uint32_t* numbers, std::size_t count,
  const SampleBlock& samples, Nearest* nearest)
{
  HWY_DYNAMIC_DISPATCH(findOfEachAmongPoints)(points, numbers, count, samples, nearest);
}

void findNearest(
  const NearTriangle* triangles, const NearItems& run, const double* sample, Nearest& nearest)
{
  HWY_DYNAMIC_DISPATCH(findAmongTriangles)(triangles, run, sample, nearest);
}

void findNearest(
  const NearPoint* points, const NearItems& run, const double* sample, Nearest& nearest)
{
  HWY_DYNAMIC_DISPATCH(findAmongPoints)(points, run, sample, nearest);
}

} // namespace winding
#endif
