// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Choices.h"
#include "field/Field.h"

#include <functional>
#include <sstream>
#include <string>
#include <vector>

/**
 * @file
 * Evaluations of fields for comparison, and the first difference between two.
 */
namespace fuzz
{

/// Runs the blocks one after the other, the last one first.
class BackwardExecutor final : public winding::Executor
{
public:
  void run(std::size_t count, const std::function<void(std::size_t)>& work) override
  {
    for (std::size_t block = count; block > 0; --block)
    {
      work(block - 1);
    }
  }
};

/// All that a field gives at some samples.
struct FieldValues
{
  std::vector<double> values;
  std::vector<double> distances; ///< distances without signs; empty unless they were asked for
  std::vector<unsigned char> inside;
  std::string failure; ///< message on what the field's outputs contradict each other in
};

FieldValues valuesOf(const winding::Field& field, const winding::Grid& grid,
  const winding::Extent& extent, bool withDistances, winding::Executor& executor);
FieldValues valuesOf(const winding::Field& field, const std::vector<shapes::Point>& samples,
  bool withDistances, winding::Executor& executor);

std::vector<shapes::Point> samplesOf(const winding::Grid& grid);

/// The samples of an extent, by their numbers in the whole grid.
std::vector<std::size_t> numbersIn(const winding::Grid& grid, const winding::Extent& extent);

winding::VectorsView viewOf(const std::vector<shapes::Point>& samples);

/// The first sample at which two lists differ by more than mayDiffer(sample) allows, in words;
/// empty where there is none.
std::string compare(const std::string& what, const std::vector<shapes::Point>& samples,
  const std::vector<double>& values, const std::vector<double>& expected,
  const std::function<double(std::size_t)>& mayDiffer);

/// Whether pieces, other orders of blocks and other sets of samples give the bits of the whole.
std::string checkBits(Choices& choices, const winding::Field& field, const winding::Grid& grid,
  const FieldValues& onGrid, const std::vector<shapes::Point>& samples,
  const FieldValues& atSamples);

/// Whether the field of the same set of primitives, written in another way, gives the same bits.
std::string checkShuffled(const winding::Field& shuffled, const winding::Grid& grid,
  const FieldValues& onGrid, const std::vector<shapes::Point>& samples,
  const FieldValues& atSamples);

/// Whether gradients are finite, and NaN at samples that are not finite.
std::string checkGradients(const winding::Field& field, const std::vector<shapes::Point>& samples);

/// Whether the field of the samples is NaN where these are not finite, and so is the value at them
/// alone.
std::string checkNonFinite(const winding::Field& field);

} // namespace fuzz
