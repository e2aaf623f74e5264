#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

/**
 * @file
 * The measure in which each method tells what it is expected to take (costOfDirectSum(),
 * costOfRows(), costOfFarField(), …), for users to be told. The choice of a method
 * does not depend on these seconds, but on a rule of its own, isCheaperDirectly().
 *
 * The figures were fitted to runs on two threads of processors with AVX-512: meshes and clouds with
 * 20 to 22 million primitives, on grids and scattered. `winding bench expected` prints them beside
 * the times taken: on the processor that they were fitted to last they lie within a factor of 2 of
 * each other (docs/performance.md), on others of the same years within 3.
 */
namespace winding
{

struct EvaluationCost
{
  double seconds = 0;    ///< on one thread
  std::size_t bytes = 0; ///< in addition to input and output

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

/// A source and the samples that are asked for, as far as the cost of a method depends on them.
struct SampledSource
{
  Primitive kind = Primitive::triangle;
  std::size_t primitives = 0;
  std::size_t samples = 0;
  bool isGrid = true; ///< whether the samples are on a grid, or scattered
  double area = 0;    ///< the area of the source, in squares of the distance between samples
};

/// Every method keeps coordinates and ids, and welds them.
constexpr std::size_t bytesPerPrimitive = 80;

/// Every method writes its values to memory that the program has not touched yet.
constexpr double secondsPerValue = 0.7e-9;

/// The factor by which work on so many primitives, in no order of places, takes longer than on few:
/// they do not fit into the caches. Measured: 1.7 at 1.4 million triangles, 2.3 at 22 million.
inline double slowdownByCacheMisses(std::size_t primitives)
{
  return 1 + 0.5 * std::max(0.0, std::log10(static_cast<double>(primitives) / 5e4));
}

} // namespace winding
