// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/CoverageFractions.h"

#include "base/Refusal.h"
#include "rays/RowCrossings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace winding
{

namespace
{

/// The largest memory for the samples of a part, unless one row of voxels takes more.
constexpr std::size_t mostBytes = std::size_t{64} << 20;

int parts(int count, int perPart)
{
  return (count + perPart - 1) / perPart;
}

/// Counts the samples that are inside each voxel of some rows, run by run.
class SampleCounts
{
public:
  SampleCounts(int voxelsPerRow, int rows, int samplesPerAxis)
    : stride_(static_cast<std::size_t>(voxelsPerRow) + 1)
    , perAxis_(samplesPerAxis)
    , own_(stride_ * static_cast<std::size_t>(rows), 0)
    , steps_(own_.size(), 0)
  {
  }

  /// Adds samples begin … end − 1 of a row, which are inside. They are numbered from the row's
  /// first.
  void add(int row, int begin, int end)
  {
    int* const own = &own_[static_cast<std::size_t>(row) * stride_];
    int* const steps = &steps_[static_cast<std::size_t>(row) * stride_];
    const int first = begin / perAxis_, last = end / perAxis_;
    // The run counts as whole voxels from `first` up to `last`, this one excluded; `own` corrects
    // both ends.
    steps[first] += perAxis_;
    steps[last] -= perAxis_;
    own[first] -= begin - first * perAxis_;
    own[last] += end - last * perAxis_;
  }

  /// Calls use(voxel, count) along a row.
  template <class Use> void forEach(int row, const Use& use) const
  {
    const std::size_t start = static_cast<std::size_t>(row) * stride_;
    int whole = 0;
    for (std::size_t i = 0; i + 1 < stride_; ++i)
    {
      whole += steps_[start + i];
      use(i, whole + own_[start + i]);
    }
  }

private:
  std::size_t stride_; ///< voxels of a row, and one more at which runs may end
  int perAxis_;
  std::vector<int> own_;   ///< correction of each voxel's count where runs begin or end in it
  std::vector<int> steps_; ///< change of the count of whole voxels at each voxel
};

/// Sets the bits of samples begin … end − 1 of a row of samples, numbered from its first one. The
/// row is the one with this number in each voxel, and `first` is the row's first voxel.
void setBits(
  const SampleBits& bits, std::size_t first, int row, int begin, int end, int samplesPerAxis)
{
  const auto upTo = [](int count)
  {
    return (std::uint64_t{1} << count) - 1;
  };
  for (int voxel = begin / samplesPerAxis; voxel * samplesPerAxis < end; ++voxel)
  {
    const int start = voxel * samplesPerAxis;
    bits.set(first + static_cast<std::size_t>(voxel), row,
      upTo(std::min(end - start, samplesPerAxis)) & ~upTo(std::max(begin - start, 0)));
  }
}

} // namespace

CoverageFractions::CoverageFractions(const Field& field, const Grid& grid, const Extent& extent,
  int samplesPerAxis, const InsideTest& isInside, float* fractions, std::uint64_t* united)
  : field_(field)
  , extent_(extent)
  , perAxis_(samplesPerAxis)
  , isInside_(isInside)
  , fractions_(fractions)
  , united_(united, samplesPerAxis)
{
  if (grid.dimensions.maxCoeff() > std::numeric_limits<int>::max() / perAxis_)
  {
    throw Refusal(Message("too many voxels for samples in each of them", {largerVoxels()},
      "a side has " + std::to_string(grid.dimensions.maxCoeff())));
  }
  samples_.dimensions = perAxis_ * grid.dimensions;
  samples_.spacing = grid.spacing / perAxis_;
  samples_.firstSample = grid.firstSample - 0.5 * (grid.spacing - samples_.spacing);
  if (sampleCount(extent) == 0)
  {
    partsAlongZ_ = 0;
    return;
  }
  rowsPerPart_ = extent[3] - extent[2] + 1;
  layersPerPart_ = extent[5] - extent[4] + 1;
  if (field.integerRows())
  {
    return;
  }
  const double bytesPerRow = static_cast<double>(perAxis_) * perAxis_ * perAxis_ *
                             (static_cast<double>(extent[1]) - extent[0] + 1);
  const auto atMost = [](double count, int limit)
  {
    return static_cast<int>(std::clamp<double>(count, 1, limit));
  };
  layersPerPart_ =
    atMost(static_cast<double>(mostBytes) / (bytesPerRow * rowsPerPart_), layersPerPart_);
  rowsPerPart_ =
    atMost(static_cast<double>(mostBytes) / (bytesPerRow * layersPerPart_), rowsPerPart_);
  partsAlongY_ = winding::parts(extent[3] - extent[2] + 1, rowsPerPart_);
  partsAlongZ_ = winding::parts(extent[5] - extent[4] + 1, layersPerPart_);
}

Extent CoverageFractions::extentOf(int part) const
{
  const int j = extent_[2] + part % partsAlongY_ * rowsPerPart_;
  const int k = extent_[4] + part / partsAlongY_ * layersPerPart_;
  return {extent_[0], extent_[1], j, std::min(j + rowsPerPart_ - 1, extent_[3]), k,
    std::min(k + layersPerPart_ - 1, extent_[5])};
}

Extent CoverageFractions::samplesOf(const Extent& voxels) const
{
  Extent samples;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    samples[2 * axis] = voxels[2 * axis] * perAxis_;
    samples[2 * axis + 1] = (voxels[2 * axis + 1] + 1) * perAxis_ - 1;
  }
  return samples;
}

std::size_t bytesOfFractions(const Field& field, std::size_t voxels, int samplesPerAxis)
{
  if (field.integerRows())
  {
    return 0; // no memory is taken beyond what the field took before
  }
  return std::min(
    voxels * static_cast<std::size_t>(samplesPerAxis * samplesPerAxis * samplesPerAxis), mostBytes);
}

float CoverageFractions::share(int samples) const
{
  return static_cast<float>(samples) / static_cast<float>(perAxis_ * perAxis_ * perAxis_);
}

void CoverageFractions::evaluate(int part, Executor& executor) const
{
  if (const RowCrossings* rows = field_.integerRows())
  {
    this->addUpRows(*rows, executor);
    return;
  }
  this->addUpSamples(this->extentOf(part), executor);
}

/// Sets the bits of a row of `width` samples, 0 or 1 each, in voxels from `first` on, if there are
/// bits.
void CoverageFractions::unite(
  const unsigned char* inside, std::size_t first, int row, std::size_t width) const
{
  if (!united_)
  {
    return;
  }
  for (std::size_t voxel = first; width > 0; ++voxel, width -= static_cast<std::size_t>(perAxis_))
  {
    std::uint64_t mask = 0;
    for (int n = 0; n < perAxis_; ++n)
    {
      mask |= std::uint64_t{*inside++} << n;
    }
    united_.set(voxel, row, mask);
  }
}

void CoverageFractions::addUpRows(const RowCrossings& rows, Executor& executor) const
{
  const Extent samples = this->samplesOf(extent_);
  const int width = extent_[1] - extent_[0] + 1, height = extent_[3] - extent_[2] + 1;
  // Some rows of voxels make a band, which is enough work to be worth a block.
  constexpr std::int64_t samplesPerBlock = 1 << 19;
  const std::int64_t samplesPerVoxel = perAxis_ * perAxis_ * perAxis_;
  const int rowsPerBand = static_cast<int>(
    std::clamp<std::int64_t>(samplesPerBlock / (width * samplesPerVoxel), 1, height));
  const RowBands bands = {samples[2], rowsPerBand * perAxis_};
  const std::unique_ptr<const RowCrossings::OnGrid> onGrid =
    rows.on(samples_, samples, bands, executor);
  const auto bandCount = bands.countIn(samples);
  const auto layers = static_cast<std::size_t>(extent_[5] - extent_[4] + 1);
  executor.run(layers * bandCount,
    [&](std::size_t block)
    {
      const int k = extent_[4] + static_cast<int>(block / bandCount);
      const std::size_t band = block % bandCount;
      const int firstSampleRow = bands.firstRowOf(band);
      const int firstRow = firstSampleRow / perAxis_;
      const int rowCount = std::min(rowsPerBand, extent_[3] - firstRow + 1);
      SampleCounts counts(width, rowCount, perAxis_);
      const auto add = [&](int j, int sampleK, const std::vector<RowRun>& runs)
      {
        const int row = (j - firstSampleRow) / perAxis_;
        const int rowInVoxel = sampleK % perAxis_ * perAxis_ + j % perAxis_;
        const std::size_t first = sampleNumber(extent_, extent_[0], firstRow + row, k);
        for (const RowRun& run : runs)
        {
          if (isInside_(run.value))
          {
            const int begin = run.begin - samples[0], end = run.end - samples[0];
            if (united_)
            {
              setBits(united_, first, rowInVoxel, begin, end, perAxis_);
            }
            else
            {
              counts.add(row, begin, end);
            }
          }
        }
      };
      for (int layer = 0; layer < perAxis_; ++layer)
      {
        onGrid->evaluate(k * perAxis_ + layer, band, add);
      }
      for (int row = 0; row < rowCount; ++row)
      {
        const std::size_t first = sampleNumber(extent_, extent_[0], firstRow + row, k);
        counts.forEach(row, [&](std::size_t i, int count)
          { fractions_[first + i] = this->share(united_ ? united_.count(first + i) : count); });
      }
    });
}

void CoverageFractions::addUpSamples(const Extent& voxels, Executor& executor) const
{
  const Extent samples = this->samplesOf(voxels);
  std::vector<unsigned char> inside(sampleCount(samples));
  FieldOutput output;
  output.inside = inside.data();
  output.isInside = isInside_;
  field_.evaluate(samples_, samples, output, executor);
  const auto width = static_cast<std::size_t>(samples[1] - samples[0] + 1);
  runBlocks(
    static_cast<std::size_t>(voxels[5] - voxels[4] + 1), 1,
    [&](std::size_t layer, std::size_t, std::size_t)
    {
      const int k = voxels[4] + static_cast<int>(layer);
      std::vector<unsigned char> columns(width);
      for (int j = voxels[2]; j <= voxels[3]; ++j)
      {
        const std::size_t first = sampleNumber(extent_, voxels[0], j, k);
        std::fill(columns.begin(), columns.end(), static_cast<unsigned char>(0));
        for (int row = 0; row < perAxis_ * perAxis_; ++row)
        {
          const int sampleJ = j * perAxis_ + row % perAxis_;
          const int sampleK = k * perAxis_ + row / perAxis_;
          const unsigned char* const from =
            &inside[sampleNumber(samples, samples[0], sampleJ, sampleK)];
          for (std::size_t i = 0; i < width; ++i)
          {
            columns[i] = static_cast<unsigned char>(columns[i] + from[i]);
          }
          this->unite(from, first, row, width);
        }
        const unsigned char* column = columns.data();
        for (std::size_t voxel = first; column != columns.data() + width; ++voxel)
        {
          int count = 0;
          for (int n = 0; n < perAxis_; ++n)
          {
            count += *column++;
          }
          fractions_[voxel] = this->share(united_ ? united_.count(voxel) : count);
        }
      }
    },
    executor);
}

} // namespace winding
