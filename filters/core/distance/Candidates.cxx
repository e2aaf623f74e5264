// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "distance/Candidates.h"

// Highway compiles the rest of this file once for every instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "distance/Candidates.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace winding
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// Writes the places of the rows whose items pass a test, and returns how many there are. Rows may
/// be read by a vector beyond their count.
template <int corners>
HWY_INLINE std::size_t find(const double* HWY_RESTRICT rows, std::size_t stride, std::size_t count,
  const CandidateTest& test, std::uint32_t* HWY_RESTRICT places)
{
  using D = hn::CappedTag<double, 8>;
  const D d;
  const auto slack = hn::Set(d, test.slack);
  std::size_t found = 0;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d))
  {
    auto least = hn::Set(d, std::numeric_limits<double>::infinity());
    for (int corner = 0; corner < corners; ++corner)
    {
      auto f = hn::Zero(d);
      for (int axis = 0; axis < 3; ++axis)
      {
        const auto v = hn::LoadU(d, rows + (3 * corner + axis) * stride + i);
        const auto apart = hn::Sub(v, hn::Set(d, test.nearest[axis]));
        f = hn::MulAdd(apart, hn::Add(apart, hn::Set(d, test.gradient[axis])), f);
        f = hn::NegMulAdd(hn::Abs(apart), hn::Set(d, test.size[axis]), f);
      }
      least = hn::Min(least, f);
    }
    const auto limit = hn::Add(hn::LoadU(d, rows + 3 * corners * stride + i), slack);
    const auto passes = hn::And(hn::FirstN(d, count - i), hn::Le(least, limit));
    // Highway's Compress() copies a table at each call, if GCC 12 compiles it.
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, passes, bytes);
    for (std::uint32_t bits = bytes[0]; bits != 0; bits &= bits - 1)
    {
      places[found++] = static_cast<std::uint32_t>(i + hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
    }
  }
  return found;
}

std::size_t findTriangles(const double* rows, std::size_t stride, std::size_t count,
  const CandidateTest& test, std::uint32_t* places)
{
  return find<3>(rows, stride, count, test, places);
}

std::size_t findPoints(const double* rows, std::size_t stride, std::size_t count,
  const CandidateTest& test, std::uint32_t* places)
{
  return find<1>(rows, stride, count, test, places);
}

} // namespace HWY_NAMESPACE
} // namespace winding
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace winding
{

HWY_EXPORT(findTriangles);
HWY_EXPORT(findPoints);

namespace
{

/// Items that may be read and written behind the last one.
constexpr std::size_t padding = 64;

/// More than 1/3 by what rounding makes of squares that are about as large as a squared radius.
constexpr double aboveAThird = 1.0 / 3 + 0x1p-40;

std::size_t countOf(const std::vector<NearItems>& runs)
{
  std::size_t count = 0;
  for (const NearItems& run : runs)
  {
    count += run.last - run.first;
  }
  return count;
}

} // namespace

void Candidates::makeRoomFor(std::size_t count)
{
  if (count + padding > stride_)
  {
    // Strides that are multiples of a page's size would let all rows meet in one set of the cache.
    stride_ = (2 * count + padding) / 64 * 64 + 8 + padding;
    rows_.resize((3 * corners_ + 1) * stride_);
    numbers_.resize(stride_);
  }
}

void Candidates::assign(const NearTriangle* triangles, const std::vector<NearItems>& runs)
{
  this->makeRoomFor(countOf(runs));
  size_ = 0;
  for (const NearItems& run : runs)
  {
    for (std::uint32_t item = run.first; item != run.last; ++item, ++size_)
    {
      const NearTriangle& t = triangles[item];
      double sides[3] = {0, 0, 0};
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        this->row(axis)[size_] = t.a[axis];
        this->row(3 + axis)[size_] = t.a[axis] + t.ab[axis];
        this->row(6 + axis)[size_] = t.a[axis] + t.ac[axis];
        const double bc = t.ac[axis] - t.ab[axis];
        sides[0] += t.ab[axis] * t.ab[axis];
        sides[1] += t.ac[axis] * t.ac[axis];
        sides[2] += bc * bc;
      }
      this->row(9)[size_] = aboveAThird * std::max({sides[0], sides[1], sides[2]});
      numbers_[size_] = item;
    }
  }
}

void Candidates::assign(const NearPoint* points, const std::vector<NearItems>& runs)
{
  this->makeRoomFor(countOf(runs));
  size_ = 0;
  for (const NearItems& run : runs)
  {
    for (std::uint32_t item = run.first; item != run.last; ++item, ++size_)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        this->row(axis)[size_] = points[item].position[axis];
      }
      this->row(3)[size_] = 0;
      numbers_[size_] = item;
    }
  }
}

void Candidates::find(const CandidateTest& test, std::vector<std::uint32_t>& places) const
{
  places.resize(size_);
  places.resize(
    corners_ == 3
      ? HWY_DYNAMIC_DISPATCH(findTriangles)(rows_.data(), stride_, size_, test, places.data())
      : HWY_DYNAMIC_DISPATCH(findPoints)(rows_.data(), stride_, size_, test, places.data()));
}

void Candidates::assign(const Candidates& others, const std::vector<std::uint32_t>& places)
{
  this->makeRoomFor(places.size());
  size_ = places.size();
  for (std::size_t i = 0; i < 3 * corners_ + 1; ++i)
  {
    const double* const from = others.row(i);
    std::transform(places.begin(), places.end(), this->row(i),
      [from](std::uint32_t place) { return from[place]; });
  }
  std::transform(places.begin(), places.end(), numbers_.begin(),
    [&others](std::uint32_t place) { return others.numbers_[place]; });
}

} // namespace winding
#endif
