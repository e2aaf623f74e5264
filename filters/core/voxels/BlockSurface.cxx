// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/BlockSurface.h"

#include "base/Executor.h"
#include "base/Progress.h"

#include <algorithm>
#include <utility>

namespace winding
{

template <class Label> Label VoxelSides<Label>::label(int i, int j, int k) const
{
  const std::array<int, 3>& n = dimensions;
  const bool isThere = i >= 0 && j >= 0 && k >= 0 && i < n[0] && j < n[1] && k < n[2];
  return isThere ? labels[static_cast<std::size_t>(this->number(i, j, k))] : Label(0);
}

template <class Label>
BlockSurface<Label>::BlockSurface(
  const VoxelSides<Label>& sides, bool isMirrored, std::size_t faces)
  : sides_(sides)
  , isMirrored_(isMirrored)
{
  const std::array<int, 3>& n = sides.dimensions;
  const std::size_t corners =
    (static_cast<std::size_t>(n[0]) + 1) * (static_cast<std::size_t>(n[1]) + 1);
  lower_.assign(corners, -1);
  upper_.assign(corners, -1);
  voxels_.reserve(faces);
  seenLabels_.reserve(faces);
}

template <class Label> std::size_t BlockSurface<Label>::countFaces(const VoxelSides<Label>& sides)
{
  const std::array<int, 3>& n = sides.dimensions;
  const std::vector<Label> outside(static_cast<std::size_t>(n[0]), 0);
  const auto row = [&](int j, int k)
  {
    const bool isThere = j >= 0 && k >= 0 && j < n[1] && k < n[2];
    return isThere ? sides.labels.data() + sides.number(0, j, k) : outside.data();
  };
  const auto countChanges = [](const Label* a, const Label* b, int count)
  {
    std::size_t changes = 0;
    for (int i = 0; i < count; ++i)
    {
      changes += a[i] != b[i];
    }
    return changes;
  };
  std::size_t faces = 0;
  for (int k = 0; k <= n[2]; ++k)
  {
    for (int j = 0; j <= n[1]; ++j)
    {
      const Label* here = row(j, k);
      faces += static_cast<std::size_t>(here[0] != 0) +
               static_cast<std::size_t>(here[n[0] - 1] != 0) +
               countChanges(here, here + 1, n[0] - 1);
      faces += countChanges(here, row(j - 1, k), n[0]) + countChanges(here, row(j, k - 1), n[0]);
    }
  }
  return faces;
}

template <class Label> double BlockSurface<Label>::bytesOf(std::size_t faces)
{
  // A face has four ids of corners, its place in the list of cells, its voxel and a label. There
  // are about as many corners as faces.
  constexpr double perFace = 6 * sizeof(std::int64_t) + 3 * sizeof(double) + sizeof(Label);
  return perFace * static_cast<double>(faces);
}

template <class Label>
void BlockSurface<Label>::build(std::int64_t* quads, const AddCorner& addCorner, Executor& executor)
{
  const std::array<int, 3>& n = sides_.dimensions;
  quads_ = quads;
  addCorner_ = &addCorner;
  Progress progress(executor);
  for (int k = 0; k <= n[2]; ++k)
  {
    // Layer k has the faces across z at its bottom, and the upright faces of its voxels.
    const auto addLayer = [&](std::size_t)
    {
      for (int j = 0; j <= n[1]; ++j)
      {
        for (int i = 0; i <= n[0]; ++i)
        {
          this->addFacesOf(i, j, k);
        }
      }
    };
    progress.set(k / (n[2] + 1.0), (k + 1) / (n[2] + 1.0));
    executor.run(1, addLayer);
    lower_.swap(upper_);
    upper_.assign(upper_.size(), -1);
  }
}

/// Adds the three faces on the low sides of voxel (i, j, k).
template <class Label> void BlockSurface<Label>::addFacesOf(int i, int j, int k)
{
  const Label here = sides_.label(i, j, k);
  const Label left = sides_.label(i - 1, j, k);
  const Label front = sides_.label(i, j - 1, k);
  const Label below = sides_.label(i, j, k - 1);
  const std::int64_t voxel = sides_.number(i, j, k);
  if (here != left)
  {
    const bool looksUp = this->addSides(left, here, sides_.number(i - 1, j, k), voxel);
    this->addQuad(looksUp, {this->corner(i, j, k, 0), this->corner(i, j + 1, k, 0),
                             this->corner(i, j + 1, k, 1), this->corner(i, j, k, 1)});
  }
  if (here != front)
  {
    const bool looksUp = this->addSides(front, here, sides_.number(i, j - 1, k), voxel);
    this->addQuad(looksUp, {this->corner(i, j, k, 0), this->corner(i, j, k, 1),
                             this->corner(i + 1, j, k, 1), this->corner(i + 1, j, k, 0)});
  }
  if (here != below)
  {
    const bool looksUp = this->addSides(below, here, sides_.number(i, j, k - 1), voxel);
    this->addQuad(looksUp, {this->corner(i, j, k, 0), this->corner(i + 1, j, k, 0),
                             this->corner(i + 1, j + 1, k, 0), this->corner(i, j + 1, k, 0)});
  }
}

/// Adds the voxel that a quad looks away from and the label that it looks to. Returns whether it
/// looks to the high side.
template <class Label>
bool BlockSurface<Label>::addSides(
  Label low, Label high, std::int64_t lowVoxel, std::int64_t highVoxel)
{
  const bool looksUp = low != 0 && (high == 0 || low < high);
  voxels_.push_back(looksUp ? lowVoxel : highVoxel);
  seenLabels_.push_back(looksUp ? high : low);
  return looksUp;
}

/// Adds a quad whose corners run counter-clockwise seen from the high side.
template <class Label>
void BlockSurface<Label>::addQuad(bool looksUp, std::array<std::int64_t, 4> corners)
{
  if (looksUp == isMirrored_)
  {
    std::swap(corners[1], corners[3]);
  }
  quads_ = std::copy(corners.begin(), corners.end(), quads_);
}

/// The id of the corner (i, j, k + up), which is made when it is first asked for.
template <class Label> std::int64_t BlockSurface<Label>::corner(int i, int j, int k, int up)
{
  std::vector<std::int64_t>& layer = up ? upper_ : lower_;
  const std::size_t width = static_cast<std::size_t>(sides_.dimensions[0]) + 1;
  std::int64_t& known = layer[static_cast<std::size_t>(j) * width + static_cast<std::size_t>(i)];
  if (known < 0)
  {
    (*addCorner_)(i, j, k + up);
    known = corners_++;
  }
  return known;
}

template struct VoxelSides<unsigned char>;
template struct VoxelSides<unsigned short>;
template class BlockSurface<unsigned char>;
template class BlockSurface<unsigned short>;

} // namespace winding
