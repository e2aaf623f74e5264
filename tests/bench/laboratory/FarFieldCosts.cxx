// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "laboratory/FarFieldCosts.h"

#include "laboratory/Timing.h"
#include "program/Interrupt.h"

#include "base/Bounds.h"
#include "base/FlushToZero.h"
#include "farfield/Expansions.h"
#include "farfield/GridCells.h"
#include "farfield/NodeAcceptance.h"

#include <random>

namespace
{

using winding::SampleBlock;

/// Numbers between two limits, the same in every run.
class Random
{
public:
  float operator()(double low, double high)
  {
    return static_cast<float>(std::uniform_real_distribution<double>(low, high)(engine_));
  }

private:
  std::mt19937_64 engine_{20260101};
};

/// So many nodes fit into the second-level cache, where an evaluation finds most of them.
constexpr std::size_t nodeCount = 1024;

double costOfNodeTest(Random& random)
{
  winding::NodeCriteria nodes;
  nodes.resize(nodeCount);
  std::vector<std::int32_t> candidates(nodeCount);
  for (std::size_t i = 0; i < nodeCount; ++i)
  {
    nodes.x[i] = random(-1, 1);
    nodes.y[i] = random(-1, 1);
    nodes.z[i] = random(-1, 1);
    nodes.radius[i] = nodes.splitRadius[i] = random(0.01, 0.2);
    candidates[i] = static_cast<std::int32_t>(i);
  }
  const winding::CellCriteria cell = {0.5f, 0.5f, 0.5f, 0.1f, 0.1f, 1.7f, 2.3f, 0.1f};
  std::vector<std::int32_t> room(3 * (nodeCount + winding::nodeListSlack));
  const std::size_t length = nodeCount + winding::nodeListSlack;
  const auto classify = [&]
  {
    winding::NodeLists lists{&room[0], &room[length], &room[2 * length]};
    winding::classifyNodes(nodes, cell, candidates.data(), nodeCount, lists);
  };
  return secondsOfOne(classify) / nodeCount;
}

void measureTranslations(int order, Random& random, FarFieldCosts& costs)
{
  std::vector<float> moments(nodeCount * winding::paddedCoefficients(order));
  for (float& moment : moments)
  {
    moment = random(-1, 1);
  }
  winding::NodeBatch batch;
  for (std::size_t i = 0; i < winding::NodeBatch::capacity; ++i)
  {
    batch.dx[i] = random(2, 3);
    batch.dy[i] = random(-3, 3);
    batch.dz[i] = random(-3, 3);
    batch.radius[i] = random(0.5, 1);
  }
  winding::LocalSums sums = {};
  std::size_t next = 0;
  const auto secondsOfBatch = [&](std::size_t count)
  {
    const auto translate = [&]
    {
      batch.count = count;
      for (std::size_t i = 0; i < count; ++i)
      {
        batch.node[i] = static_cast<std::int32_t>(next++ % nodeCount);
      }
      winding::translateMoments(order, moments.data(), batch, 1, sums);
    };
    return secondsOfOne(translate);
  };
  constexpr std::size_t full = winding::NodeBatch::capacity;
  costs.firstNode = secondsOfBatch(1);
  costs.nextNode = std::max(0.0, (secondsOfBatch(full) - costs.firstNode) / (full - 1));
  std::vector<float> local(winding::paddedCoefficients(order));
  const auto clearAndAdd = [&]
  {
    std::fill_n(sums.lanes, winding::coefficientCount(order) * 16, 0.0f);
    winding::addLanes(order, sums, local.data());
  };
  costs.receiver = secondsOfOne(clearAndAdd);
}

void measureMatrices(int order, Random& random, FarFieldCosts& costs)
{
  const auto columns = static_cast<std::size_t>(winding::coefficientCount(order));
  const auto secondsOfProduct = [&](std::size_t rows)
  {
    const std::vector<float> matrix(rows * columns, 0.5f);
    std::vector<float> from(columns), to(rows);
    std::generate(from.begin(), from.end(), [&random] { return random(-1, 1); });
    const auto multiply = [&]
    {
      winding::multiplyMatrix(matrix.data(), rows, columns, from.data(), to.data());
    };
    return secondsOfOne(multiply);
  };
  costs.shift = secondsOfProduct(winding::paddedCoefficients(order));
  costs.polynomial = secondsOfProduct(winding::polynomialRows(order));
}

/// Takes rows of values and does nothing with them.
class NoSink final : public winding::RowSink
{
public:
  void row(int, int, int, std::size_t, const float*, const bool*) const override {}
};

/// Seconds to store a polynomial in a cell of n³ samples.
double secondsToStore(
  const winding::GridCells& cells, int order, const std::vector<float>& polynomial, int n)
{
  winding::TargetCell cell = cells.root();
  while (cells.sizeOf(cell.level, 0) > n)
  {
    winding::TargetCells::Child children[8];
    cells.childrenOf(cell, children);
    cell = children[0].cell;
  }
  return secondsOfOne([&] { cells.storePolynomial(cell, order, polynomial.data()); });
}

void measureSamples(int order, Random& random, FarFieldCosts& costs)
{
  std::vector<float> coefficients(static_cast<std::size_t>(winding::monomialCount(order)));
  std::generate(coefficients.begin(), coefficients.end(), [&random] { return random(-1, 1); });
  constexpr std::size_t count = SampleBlock::capacity;
  alignas(64) float x[count];
  alignas(64) float y[count];
  alignas(64) float z[count];
  alignas(64) float values[count];
  for (std::size_t i = 0; i < count; ++i)
  {
    x[i] = random(-0.5, 0.5);
    y[i] = random(-0.5, 0.5);
    z[i] = random(-0.5, 0.5);
  }
  const auto polynomialValues = [&]
  {
    winding::evaluatePolynomial(order, coefficients.data(), x, y, z, count, values);
  };
  costs.polynomialValue = secondsOfOne(polynomialValues) / count;

  std::vector<float> moments(winding::paddedCoefficients(order));
  std::generate(moments.begin(), moments.end(), [&random] { return random(-1, 1); });
  SampleBlock samples;
  samples.count = count;
  for (std::size_t i = 0; i < count; ++i)
  {
    samples.set(i, Eigen::Vector3d(x[i] + 3, y[i], z[i]));
  }
  const double center[3] = {};
  std::fill_n(values, count, 0.0f);
  const auto momentValues = [&]
  {
    winding::addMomentValues(order, moments.data(), center, 1, samples, values);
  };
  costs.momentValue = secondsOfOne(momentValues) / count;

  winding::Grid grid;
  grid.dimensions = {64, 64, 64};
  winding::GridCells cells(grid, grid.wholeExtent(), 1.0 / 64, order);
  const NoSink sink;
  cells.setSink(sink);
  costs.blockSample = secondsToStore(cells, order, coefficients, 8) / (8 * 8 * 8);
  // Rows of two lengths give two equations for the costs of rows and of samples in them.
  const double small = secondsToStore(cells, order, coefficients, 16) / (16 * 16);
  const double large = secondsToStore(cells, order, coefficients, 64) / (64 * 64);
  costs.rowSample = std::max(0.0, (large - small) / (64 - 16));
  costs.row = std::max(0.0, small - 16 * costs.rowSample);
}

double costOfDipole(int order, Random& random)
{
  winding::DipoleBatch batch;
  batch.count = winding::DipoleBatch::capacity;
  for (std::size_t i = 0; i < batch.count; ++i)
  {
    for (float* values : {batch.x, batch.y, batch.z, batch.nx, batch.ny, batch.nz})
    {
      values[i] = random(-0.5, 0.5);
    }
  }
  std::vector<float> moments(winding::paddedCoefficients(order));
  return secondsOfOne([&] { winding::addMoments(order, batch, moments.data()); }) /
         static_cast<double>(batch.count);
}

} // namespace

FarFieldCosts measureFarFieldCosts(int order)
{
  const winding::FlushToZero flush; // an evaluation has it, too
  Random random;
  FarFieldCosts costs = {};
  costs.nodeTest = costOfNodeTest(random);
  measureTranslations(order, random, costs);
  measureMatrices(order, random, costs);
  measureSamples(order, random, costs);
  costs.dipole = costOfDipole(order, random);
  interrupt::check();
  return costs;
}

ExactCosts measureExactCosts(const winding::FarFieldSources& sources, bool watching)
{
  winding::SerialExecutor serial;
  const std::vector<Eigen::Vector3d> centers = sources.centers(serial);
  winding::Bounds bounds;
  for (const Eigen::Vector3d& center : centers)
  {
    bounds.extend(center);
  }
  SampleBlock block;
  block.count = SampleBlock::capacity;
  Random random;
  for (std::size_t i = 0; i < block.count; ++i)
  {
    const Eigen::Vector3d place{random(0, 1), random(0, 1), random(0, 1)};
    block.set(i, bounds.min() + place.cwiseProduct(bounds.sizes()));
  }
  double values[SampleBlock::capacity];
  bool isSuspect[SampleBlock::capacity];
  const auto secondsOfSum = [&](const std::vector<winding::ItemRange>& items)
  {
    return secondsOfOne([&] { sources.sum(items, block, values, watching ? isSuspect : nullptr); });
  };
  const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(centers.size(), 100));
  const double none = secondsOfSum({{0, 0}});
  const double some = secondsOfSum({{0, count}});
  interrupt::check();
  const auto samples = static_cast<double>(block.count);
  return {none / samples, std::max(0.0, some - none) / (samples * count)};
}
