// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace winding
{

/**
 * Counts of all that a far field did, to explain the time that it took (FarFieldTraversal.h). They
 * depend on the sources, the samples and the extent, and not on the executor.
 */
struct FarFieldWork
{
  std::uint64_t cells = 0;              ///< cells of samples, of all sizes
  std::uint64_t nodeTests = 0;          ///< tests of a node by classifyNodes()
  std::uint64_t translations = 0;       ///< nodes that act through a cell's local expansion
  std::uint64_t translationBatches = 0; ///< calls of translateMoments() for these nodes
  std::uint64_t receivers = 0;          ///< cells whose local expansion these nodes act through
  std::uint64_t shifts = 0;             ///< local expansions handed to children
  std::uint64_t leaves = 0;       ///< cells that were not cut: their expansions became polynomials
  std::uint64_t nearLeaves = 0;   ///< leaves with sources nearby
  std::uint64_t nearTests = 0;    ///< nodes looked at for leaves with sources nearby
  std::uint64_t rows = 0;         ///< rows of large leaves without sources nearby
  std::uint64_t rowSamples = 0;   ///< samples in these rows
  std::uint64_t blockSamples = 0; ///< samples of small leaves without sources nearby
  std::uint64_t nearSamples = 0;  ///< samples of leaves with sources nearby
  std::uint64_t exactSamples = 0; ///< samples of leaves for which items were summed one by one
  std::uint64_t momentValues = 0; ///< nodes × samples, for nodes that act through their moments
  std::uint64_t exactPairs = 0;   ///< items × samples, for items that were summed one by one
  std::uint64_t exactLanes = 0;   ///< exactPairs with samples rounded up to whole vectors

  /// The number of samples that were evaluated.
  std::uint64_t samples() const { return rowSamples + blockSamples + nearSamples; }

  FarFieldWork& operator+=(const FarFieldWork& other);
  bool operator==(const FarFieldWork& other) const;
};

/// All counts, each once, for what is done to each of them.
inline constexpr std::uint64_t FarFieldWork::*farFieldCounts[] = {&FarFieldWork::cells,
  &FarFieldWork::nodeTests, &FarFieldWork::translations, &FarFieldWork::translationBatches,
  &FarFieldWork::receivers, &FarFieldWork::shifts, &FarFieldWork::leaves, &FarFieldWork::nearLeaves,
  &FarFieldWork::nearTests, &FarFieldWork::rows, &FarFieldWork::rowSamples,
  &FarFieldWork::blockSamples, &FarFieldWork::nearSamples, &FarFieldWork::exactSamples,
  &FarFieldWork::momentValues, &FarFieldWork::exactPairs, &FarFieldWork::exactLanes};

inline FarFieldWork& FarFieldWork::operator+=(const FarFieldWork& other)
{
  for (const auto count : farFieldCounts)
  {
    this->*count += other.*count;
  }
  return *this;
}

inline bool FarFieldWork::operator==(const FarFieldWork& other) const
{
  return std::all_of(std::begin(farFieldCounts), std::end(farFieldCounts),
    [&](const auto count) { return this->*count == other.*count; });
}

static_assert(sizeof(FarFieldWork) == sizeof(std::uint64_t) * std::size(farFieldCounts));

} // namespace winding
