#include "CappedSurface.h"

#include "Cap.h"

#include <algorithm>

namespace winding
{

CappedSurface::CappedSurface(const Surface& surface, const BoundaryChain& chain)
  : rows_(surface.vertices, surface.triangles, cap_)
  , capRows_(surface.vertices, cap_)
  , fanRows_(fanVertices_, fan_)
  , surfaceSum_(surface.vertices, surface.triangles, surface.bounds)
  , capSum_(surface.vertices, cap_, surface.bounds)
  , fanSum_(fanVertices_, fan_, surface.bounds)
{
  if (!chain.edges.empty())
  {
    const std::vector<BoundaryLoop> loops = boundaryLoops(chain, surface.vertices.size());
    cap_ = capOf(loops);
    fanVertices_ = surface.vertices;
    fan_ = fanOf(loops, fanVertices_);
  }
}

bool CappedSurface::evaluate(
  const Grid& grid, const Extent& extent, const FieldOutput& output, Executor& executor) const
{
  // Enough work to be worth a block, and little enough to answer an interrupt within a moment.
  const std::size_t samplesPerBlock = std::min<std::size_t>(65536, 50'000'000 / (cap_.size() + 1));
  return rows_.evaluate(
    grid, extent, samplesPerBlock,
    [&](int j, int k, const std::vector<RowRun>& runs)
    { this->evaluateRow(grid, extent, j, k, runs, output); },
    executor);
}

void CappedSurface::evaluateRow(const Grid& grid, const Extent& extent, int j, int k,
  const std::vector<RowRun>& runs, const FieldOutput& output) const
{
  const auto width = static_cast<std::size_t>(extent[1] - extent[0] + 1);
  const auto height = static_cast<std::size_t>(extent[3] - extent[2] + 1);
  const std::size_t row =
    (static_cast<std::size_t>(k - extent[4]) * height + static_cast<std::size_t>(j - extent[2])) *
    width;
  for (const RowRun& run : runs)
  {
    const std::size_t first = row + static_cast<std::size_t>(run.begin - extent[0]);
    const auto count = static_cast<std::size_t>(run.end - run.begin);
    if (cap_.empty())
    {
      output.fill(run.value, first, count);
      continue;
    }
    for (std::size_t done = 0; done < count; done += SampleBlock::capacity)
    {
      SampleBlock block;
      block.count = std::min(SampleBlock::capacity, count - done);
      for (std::size_t n = 0; n < block.count; ++n)
      {
        block.set(n, grid.sample(run.begin + static_cast<int>(done + n), j, k));
      }
      double values[SampleBlock::capacity];
      bool isSuspect[SampleBlock::capacity];
      const bool any = capSum_.evaluateWatching(block, values, isSuspect);
      for (std::size_t n = 0; n < block.count; ++n)
      {
        values[n] = run.value - values[n];
        if (any && isSuspect[n])
        {
          values[n] =
            this->resolveOnCap(grid, run.begin + static_cast<int>(done + n), j, k, run.value);
        }
      }
      output.write(values, first + done, block.count);
    }
  }
}

/// The value of a sample on the cap: χ of the surface and the other cap, minus that cap's sum.
double CappedSurface::resolveOnCap(const Grid& grid, int i, int j, int k, int rowValue) const
{
  SampleBlock block;
  block.count = 1;
  block.set(0, grid.sample(i, j, k));
  double value;
  bool isSuspect;
  if (fanSum_.evaluateWatching(block, &value, &isSuspect))
  {
    // On both caps, so most likely on the rim: the definition itself.
    surfaceSum_.evaluate(block, &value);
    return value;
  }
  return rowValue - capRows_.valueAt(grid, i, j, k) + fanRows_.valueAt(grid, i, j, k) - value;
}

} // namespace winding
