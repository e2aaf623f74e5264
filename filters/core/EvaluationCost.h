#pragma once

#include <cstddef>

/**
 * @file
 * What methods cost, roughly: by it the automatic choice is made, and users are told what to expect.
 * The figures are those of one core of a processor with AVX-512 of 2025; others take up to three times
 * as long, but much the same in proportion.
 */
namespace winding
{

struct EvaluationCost
{
  double seconds = 0;    ///< on one thread, from the input to the last value
  std::size_t bytes = 0; ///< beside input and output

  EvaluationCost& operator+=(const EvaluationCost& other);
};

enum class Primitive
{
  triangle,
  point
};

/// Welding, boundary, crossings and filling of runs.
EvaluationCost costOfRows(std::size_t triangles, std::size_t samples);

/// How triangles lie across rays along x, in the box of all of them.
struct RaysThroughTriangles
{
  double layers = 2; ///< triangles on a line along x, on average
  double widths = 0; ///< of all triangles, each in widths of the box
};

/// Welding, boundary, and the crossings ahead of scattered samples; for samples that are spread over
/// the box of the triangles. It does not know where samples lie: lines along x take less, and samples
/// at a place where more triangles overlap than elsewhere take more.
EvaluationCost costOfCrossings(
  std::size_t triangles, std::size_t samples, const RaysThroughTriangles& rays = {});

/// A sum over all primitives at each sample.
EvaluationCost costOfDirectSum(Primitive kind, std::size_t primitives, std::size_t samples);

/// A tree and its moments, and expansions for the samples.
EvaluationCost costOfFarField(
  Primitive kind, std::size_t primitives, std::size_t samples, int order);

/// A tree of boxes, and the nearest primitive of each sample.
EvaluationCost costOfDistances(Primitive kind, std::size_t primitives, std::size_t samples);

/// Whether the direct sum is expected to be faster than a far field on grids of usual sizes.
bool isCheaperDirectly(Primitive kind, std::size_t primitives, int order);

/// The same for so many scattered samples, which have to pay for the tree.
bool isCheaperDirectly(Primitive kind, std::size_t primitives, std::size_t samples, int order);

} // namespace winding
