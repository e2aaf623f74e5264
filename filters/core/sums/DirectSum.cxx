// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sums/DirectSum.h"

#include "base/Pi.h"
#include "source/UnitScale.h"
#include "sums/DirectSumKernels.h"
#include "sums/GradientKernels.h"
#include "sums/MultipleAngles.h"
#include "sums/RegularizedKernels.h"

#include <algorithm>
#include <cmath>

namespace winding
{

TriangleSum::TriangleSum(
  const std::vector<Eigen::Vector3d>& vertices, const ChainView& triangles, const Bounds& bounds)
  : vertices_(vertices)
  , triangles_(triangles)
  , scale_(unitScale(bounds))
{
}

/// Multiplies the factors of triangles first … last − 1, each once.
void TriangleSum::multiply(const TriangleList& triangles, std::size_t first, std::size_t last,
  const SampleBlock& scaled, AngleProducts& products, bool watching) const
{
  // Packing is repeated for every block: next to a block's worth of sums it costs nothing, and the
  // packed triangles stay in the first-level cache instead of taking 104 bytes each of memory.
  KernelTriangle chunk[kernelChunk];
  for (; first < last; first += kernelChunk)
  {
    const std::size_t count = std::min(kernelChunk, last - first);
    for (std::size_t i = 0; i < count; ++i)
    {
      const Triangle& triangle = triangles[first + i];
      chunk[i] = kernelTriangle(vertices_[triangle[0]] * scale_, vertices_[triangle[1]] * scale_,
        vertices_[triangle[2]] * scale_);
    }
    const auto multiplyChunk = watching ? multiplyAnglesWatching : multiplyAngles;
    multiplyChunk(chunk, count, scaled, products);
  }
}

/// Sums all triangles, run by run of equal multiplicity. isSuspect may be null.
void TriangleSum::sum(const SampleBlock& block, double* values, bool* isSuspect) const
{
  const OrderedTriangles& ordered =
    ordered_.get([this] { return inCoordinateOrder(vertices_, triangles_); });
  SampleBlock scaled;
  scaleSamples(block, scale_, scaled);
  MultipleAngles sums(scaled.count, values, isSuspect);
  ChainView(ordered.triangles, ordered.multiplicities)
    .forEachRun(
      [&](std::size_t first, std::size_t last, std::int32_t multiplicity)
      {
        AngleProducts products(scaled.count);
        this->multiply(ordered.triangles, first, last, scaled, products, isSuspect != nullptr);
        sums.add(products, multiplicity);
      });
}

void TriangleSum::evaluate(const SampleBlock& block, double* values) const
{
  this->sum(block, values, nullptr);
}

bool TriangleSum::evaluateWatching(const SampleBlock& block, double* values, bool* isSuspect) const
{
  this->sum(block, values, isSuspect);
  return std::any_of(isSuspect, isSuspect + block.count, [](bool is) { return is; });
}

DipoleSum::DipoleSum(const PointCloud& cloud, const std::vector<double>& areas)
  : cloud_(cloud)
  , areas_(areas)
  , scale_(unitScale(cloud.bounds))
{
}

/// Calls addChunk(dipoles, inverse lengths, count) for all points in turn, in scaled coordinates;
/// the pointer to the lengths is null for pure dipoles.
template <class AddChunk> void DipoleSum::forEachChunk(const AddChunk& addChunk) const
{
  const std::vector<std::uint32_t>& order = order_.get(
    [this]
    {
      SerialExecutor serial;
      return coordinateOrder(cloud_, areas_, serial);
    });
  KernelDipole chunk[kernelChunk];
  double inverseLengths[kernelChunk];
  const std::vector<double>& lengths = cloud_.regularizationLengths;
  const std::size_t total = cloud_.positions.size();
  for (std::size_t first = 0; first < total; first += kernelChunk)
  {
    const std::size_t count = std::min(kernelChunk, total - first);
    for (std::size_t i = 0; i < count; ++i)
    {
      // The two factors of scale come one after the other: their product alone may leave the range.
      const std::uint32_t point = order[first + i];
      const double weight = areas_[point] * scale_ * scale_ / (4 * pi);
      chunk[i] = kernelDipole(cloud_.positions[point] * scale_, cloud_.normals[point] * weight);
      inverseLengths[i] = lengths.empty() ? 0 : inverseOfLength(lengths[point] * scale_);
    }
    addChunk(chunk, lengths.empty() ? nullptr : inverseLengths, count);
  }
}

void DipoleSum::evaluate(const SampleBlock& block, double* values) const
{
  SampleBlock scaled;
  scaleSamples(block, scale_, scaled);
  KernelSums sums;
  this->forEachChunk(
    [&](const KernelDipole* dipoles, const double* inverseLengths, std::size_t count)
    {
      if (inverseLengths)
      {
        addRegularizedDipoles(dipoles, inverseLengths, count, scaled, sums);
      }
      else
      {
        addDipoles(dipoles, count, scaled, sums);
      }
    });
  std::copy_n(sums.sum, scaled.count, values);
}

void DipoleSum::evaluateGradients(const SampleBlock& block, double* gradients) const
{
  SampleBlock scaled;
  scaleSamples(block, scale_, scaled);
  GradientSums sums;
  this->forEachChunk(
    [&](const KernelDipole* dipoles, const double* inverseLengths, std::size_t count)
    {
      if (inverseLengths)
      {
        addRegularizedDipoleGradients(dipoles, inverseLengths, count, scaled, sums);
      }
      else
      {
        addDipoleGradients(dipoles, count, scaled, sums);
      }
    });
  storeGradients(sums, scaled.count, scale_, gradients);
}

} // namespace winding
