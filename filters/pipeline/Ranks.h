// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkWindingABINamespace.h"

#include <cstddef>
#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiProcessController;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// A number that ranks give each other: a count, flags or a hash.
using RankNumber = unsigned long long;

/// Whether all ranks have given the same number.
bool areEqual(const std::vector<RankNumber>& numbers);

/// Numbers of all ranks, rank by rank.
template <class T> struct OfRanks
{
  std::vector<T> numbers;
  std::vector<std::size_t> starts; ///< place of each rank's first number, and the end

  const T* begin(int rank) const { return numbers.data() + starts[static_cast<std::size_t>(rank)]; }
  std::size_t count(int rank) const
  {
    return starts[static_cast<std::size_t>(rank) + 1] - starts[static_cast<std::size_t>(rank)];
  }
};

/**
 * The processes of a parallel program, through VTK's controller for them. All functions but those
 * that only return something are collective: all ranks call them, in the same order. A process
 * without a controller, or alone in it, is a single rank, for which they cost nothing.
 *
 * A failure of one rank must not leave the others waiting, so failures travel with allGather():
 * work that throws on any rank makes it throw on all, with the line of the first rank that failed,
 * a Refusal, OutOfMemory or Interrupted. Calls may be nested. A rank that fails anywhere within an
 * outer one joins the others at the next inner one that they come to.
 */
class Ranks
{
public:
  /// `controller` may be null. `mostNumbers` is the largest number of numbers that one message of
  /// gather() may have in sum: MPI counts them by ints, and several messages need a buffer of that
  /// size.
  explicit Ranks(
    vtkMultiProcessController* controller, std::size_t mostNumbers = std::size_t{1} << 22);

  int rank() const;
  int count() const;
  bool isAlone() const { return this->count() == 1; }

  using Number = RankNumber;

  /// Does work on every rank, and returns what it returned on each of them.
  std::vector<Number> allGather(const std::function<Number()>& work);

  /// Waits for all ranks, and reports to HostShare.h how many of them are on this machine.
  void barrier();

  /// Does work on every rank.
  void agree(const std::function<void()>& work);

  /// Does work on every rank, and returns whether it returned true on all.
  bool allOf(const std::function<bool()>& work);

  /// Does work on every rank, which returns a hash of its properties. Throws a Refusal on all ranks
  /// unless all have the same.
  void requireSame(const std::function<Number()>& hashOfProperties);

  /// Returns all numbers of all ranks. With `onlyOnFirst` the other ranks get no numbers but their
  /// counts. T is double, int or vtkIdType.
  template <class T> OfRanks<T> gather(const std::vector<T>& own, bool onlyOnFirst);

private:
  vtkMultiProcessController* controller_;
  std::size_t mostNumbers_;
  bool hasFailed_ = false; ///< all ranks know of a failure, and wait no more
};

} // namespace winding
