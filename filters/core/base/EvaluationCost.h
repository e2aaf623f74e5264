#pragma once

#include <cstddef>

/**
 * @file
 * The measure in which each method tells what it is expected to take (costOfDirectSum(),
 * costOfRows(), costOfFarField(), …). The automatic choice is made by it, and users are told it.
 * The figures are those of one core of a processor with AVX-512 of 2025; others take up to three
 * times as long, but much the same in proportion.
 */
namespace winding
{

struct EvaluationCost
{
  double seconds = 0;    ///< on one thread, from the input to the last value
  std::size_t bytes = 0; ///< beside input and output

  EvaluationCost& operator+=(const EvaluationCost& other)
  {
    seconds += other.seconds;
    bytes += other.bytes;
    return *this;
  }
};

enum class Primitive
{
  triangle,
  point
};

/// Every method keeps coordinates and ids, and welds them.
constexpr std::size_t bytesPerPrimitive = 80;

/// Every method writes its values to memory that the program has not touched yet.
constexpr double secondsPerValue = 1e-9;

} // namespace winding
