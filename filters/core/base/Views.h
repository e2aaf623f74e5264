// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>

/**
 * @file
 * Views are the form in which arrays cross the border into the core. A view owns nothing and copies
 * nothing; it is a pointer, a count and a stride, over float or double (or 32 or 64 bit ids), and
 * the memory must outlive it. Everything that the core computes, it computes in double.
 */
namespace winding
{

namespace detail
{
/// A strided run of numbers of one of two types; exactly one pointer is set unless it is empty.
template <class A, class B, class Value> class StridedView
{
public:
  StridedView() = default;
  StridedView(const A* data, std::size_t count, std::size_t stride)
    : a_(data)
    , count_(count)
    , stride_(stride)
  {
  }
  StridedView(const B* data, std::size_t count, std::size_t stride)
    : b_(data)
    , count_(count)
    , stride_(stride)
  {
  }

  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }

  /// Where an item stands in memory.
  const void* address(std::size_t item) const
  {
    return a_ ? static_cast<const void*>(a_ + item * stride_) : b_ + item * stride_;
  }

protected:
  Value at(std::size_t item, std::size_t component) const
  {
    const std::size_t offset = item * stride_ + component;
    return a_ ? static_cast<Value>(a_[offset]) : static_cast<Value>(b_[offset]);
  }

private:
  const A* a_ = nullptr;
  const B* b_ = nullptr;
  std::size_t count_ = 0;
  std::size_t stride_ = 0;
};
} // namespace detail

/// Positions or normals, #V by 3. The stride counts numbers and is at least 3.
class VectorsView : public detail::StridedView<float, double, double>
{
public:
  VectorsView() = default;
  template <class T>
  VectorsView(const T* data, std::size_t count, std::size_t stride = 3)
    : StridedView(data, count, stride)
  {
  }
  Eigen::Vector3d operator[](std::size_t i) const { return {at(i, 0), at(i, 1), at(i, 2)}; }
};

/// Areas, #V by 1. The stride counts numbers and is at least 1.
class ScalarsView : public detail::StridedView<float, double, double>
{
public:
  ScalarsView() = default;
  template <class T>
  ScalarsView(const T* data, std::size_t count, std::size_t stride = 1)
    : StridedView(data, count, stride)
  {
  }
  double operator[](std::size_t i) const { return at(i, 0); }
};

/// Point ids of triangles, #F by 3, packed.
class TriangleIdsView : public detail::StridedView<std::int32_t, std::int64_t, std::int64_t>
{
public:
  TriangleIdsView() = default;
  template <class T>
  TriangleIdsView(const T* data, std::size_t count)
    : StridedView(data, count, 3)
  {
  }
  std::int64_t operator()(std::size_t triangle, std::size_t corner) const
  {
    return at(triangle, corner);
  }
};

/// Triangles over shared points. Ids may be anything; see Sanitize.h for what happens to bad ones.
struct TrianglesView
{
  VectorsView points;
  TriangleIdsView triangles;
  /// By triangle, whether it belongs to the polygon of the triangle before it; null where each is a
  /// polygon of its own. Sums do not need it.
  const char* isContinued = nullptr;
};

/// Points with normals and areas: as many of each as there are points, or none.
struct OrientedPointsView
{
  VectorsView positions;
  VectorsView normals;
  ScalarsView areas;
};

} // namespace winding
