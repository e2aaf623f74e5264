// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/PlacesField.h"

#include "base/Progress.h"
#include "farfield/FarField.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace winding
{

namespace
{

/// Returns the places to look at.
std::vector<std::uint32_t> evenlyChosen(std::size_t places)
{
  constexpr std::size_t most = 1536;
  const std::size_t step = std::max<std::size_t>(1, (places + most - 1) / most);
  std::vector<std::uint32_t> chosen;
  for (std::size_t place = step / 2; place < places; place += step)
  {
    chosen.push_back(static_cast<std::uint32_t>(place));
  }
  return chosen;
}

} // namespace

Normals turned(Normals normals, const Turns& turns)
{
  for (std::size_t place = 0; place < normals.size(); ++place)
  {
    normals[place] *= turns[place] ? -1 : 1;
  }
  return normals;
}

PlacesField::PlacesField(const DistinctPoints& places, const std::vector<double>& spacings,
  double spread, std::vector<std::uint32_t> lookedAt, Executor& executor)
  : places_(places)
  , spacings_(spacings)
  , spread_(spread)
  , executor_(executor)
  , lookedAt_(std::move(lookedAt))
{
}

PlacesField::PlacesField(const DistinctPoints& places, const std::vector<double>& spacings,
  double spread, Executor& executor)
  : PlacesField(places, spacings, spread, evenlyChosen(places.size()), executor)
{
}

Eigen::MatrixXd PlacesField::sharesOf(
  const Normals& normals, const Turns& turns, const NormalPatches::Largest& patches) const
{
  std::vector<ItemRange> ranges;
  for (std::size_t patch = 0; patch < patches.count(); ++patch)
  {
    ranges.push_back({static_cast<std::uint32_t>(patches.starts[patch]),
      static_cast<std::uint32_t>(patches.starts[patch + 1])});
  }
  return this->sums(normals, turns, patches.places.data(), ranges);
}

Eigen::VectorXd PlacesField::valuesOf(const Normals& normals, const Turns& turns) const
{
  return this->sums(normals, turns, nullptr, {{0, static_cast<std::uint32_t>(places_.size())}});
}

Eigen::VectorXd PlacesField::sharesOf(
  const Normals& normals, const Turns& turns, const std::vector<std::uint32_t>& some) const
{
  return this->sums(normals, turns, some.data(), {{0, static_cast<std::uint32_t>(some.size())}});
}

Normals PlacesField::gradients(const Normals& normals, const Turns& turns, const Normals& at) const
{
  // Gradients are to decide senses only, which coarse ones do: points are taken for pure dipoles
  // from where they have S = 0.88 of what those give (SolidAngle.h).
  constexpr double wider = 1.5;
  constexpr FarFieldAccuracy coarse = {3, 0.9f, 1e-2f, 1.7f};
  Progress progress(executor_);
  progress.set(0, 0.1);
  std::unique_ptr<FarFieldSources> sources;
  {
    PointCloud all = this->part(normals, turns, nullptr, 0, places_.size());
    for (double& length : all.regularizationLengths)
    {
      length *= wider;
    }
    sources = farFieldSources(all, all.areas, executor_);
  }
  const FarField field(std::move(sources), coarse, executor_);
  Normals gradients(at.size());
  progress.set(0.1, 1);
  field.gradient({at[0].data(), at.size()}, gradients[0].data(), executor_);
  return gradients;
}

PointCloud PlacesField::part(const Normals& normals, const Turns& turns, const std::uint32_t* order,
  std::size_t first, std::size_t last) const
{
  PointCloud part;
  part.positions.reserve(last - first);
  part.normals.reserve(last - first);
  part.areas.reserve(last - first);
  part.regularizationLengths.reserve(last - first);
  for (std::size_t i = first; i < last; ++i)
  {
    const std::size_t place = order ? order[i] : i;
    part.positions.push_back(places_.positions()[place]);
    part.normals.emplace_back((turns[place] ? -1 : 1) * normals[place]);
    part.areas.push_back(spacings_[place] * spacings_[place]);
    part.regularizationLengths.push_back(spread_ * spacings_[place]);
    part.bounds.extend(part.positions.back());
  }
  return part;
}

Eigen::MatrixXd PlacesField::sums(const Normals& normals, const Turns& turns,
  const std::uint32_t* order, const std::vector<ItemRange>& ranges) const
{
  constexpr std::uint32_t placesPerPart = 65536;
  constexpr std::size_t samplesPerBlock = 128;
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(
    static_cast<Eigen::Index>(lookedAt_.size()), static_cast<Eigen::Index>(ranges.size()));
  const std::uint32_t end = ranges.back().end;
  Progress progress(executor_);
  for (std::uint32_t begin = 0; begin < end; begin += std::min(placesPerPart, end - begin))
  {
    const std::uint32_t size = std::min(placesPerPart, end - begin);
    const PointCloud part = this->part(normals, turns, order, begin, begin + size);
    SerialExecutor serial; // a part is little work
    const std::unique_ptr<FarFieldSources> sources = farFieldSources(part, part.areas, serial);
    std::vector<std::uint32_t> inOrder(size);
    std::iota(inOrder.begin(), inOrder.end(), 0);
    sources->arrange(inOrder, true, serial);
    progress.set(static_cast<double>(begin) / end, static_cast<double>(begin + size) / end);
    runBlocks(
      lookedAt_.size(), samplesPerBlock,
      [&](std::size_t, std::size_t first, std::size_t last)
      {
        SampleBlock block;
        block.count = last - first;
        for (std::size_t i = first; i < last; ++i)
        {
          block.set(i - first, sources->scale() * places_.positions()[lookedAt_[i]]);
        }
        double values[SampleBlock::capacity];
        std::vector<ItemRange> range(1);
        for (std::size_t r = 0; r < ranges.size(); ++r)
        {
          const std::uint32_t from = std::max(ranges[r].begin, begin);
          const std::uint32_t to = std::min(ranges[r].end, begin + size);
          if (from >= to)
          {
            continue;
          }
          range[0] = {from - begin, to - begin};
          sources->sum(range, block, values, nullptr);
          for (std::size_t i = first; i < last; ++i)
          {
            sums(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(r)) += values[i - first];
          }
        }
      },
      executor_);
  }
  return sums;
}

} // namespace winding
