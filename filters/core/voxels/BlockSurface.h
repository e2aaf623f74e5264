// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace winding
{

class Executor;

/// The voxels of a grid, each of which has a label, 0 outside: unsigned char where they are only
/// inside (1) or not, unsigned short where they are of several solids.
template <class Label> struct VoxelSides
{
  std::vector<Label> labels; ///< along x first
  std::array<int, 3> dimensions;

  std::int64_t number(int i, int j, int k) const
  {
    return (static_cast<std::int64_t>(k) * dimensions[1] + j) * dimensions[0] + i;
  }

  /// Returns the label of voxel (i, j, k), 0 if it is not there.
  Label label(int i, int j, int k) const;
};

/**
 * The faces between voxels of different labels, as quads. A face at the outside looks there, and
 * one between two solids looks away from the smaller label. A voxel at the border of the grid has
 * nothing but outside beyond that border, so that the surface of each label is closed.
 */
template <class Label> class BlockSurface
{
public:
  /// Takes a corner (i, j, k) of voxels: voxel (i, j, k) begins there. Corners come in the order of
  /// their ids, 0 first.
  using AddCorner = std::function<void(int i, int j, int k)>;

  /// Keeps a reference to the sides. `isMirrored` says whether the axes of the grid make a left
  /// hand, which turns all quads round. `faces` is the number of quads, as countFaces() gives it.
  BlockSurface(const VoxelSides<Label>& sides, bool isMirrored, std::size_t faces);

  /// Returns the number of quads that build() makes.
  static std::size_t countFaces(const VoxelSides<Label>& sides);

  /// Returns the memory of `faces` quads in bytes, with their corners, voxels and labels.
  static double bytesOf(std::size_t faces);

  /// Writes four ids for each quad to `quads`, and hands on the corners. Throws Interrupted.
  void build(std::int64_t* quads, const AddCorner& addCorner, Executor& executor);

  /// Returns the voxel that each quad looks away from, which is not outside.
  const std::vector<std::int64_t>& voxels() const { return voxels_; }

  /// Returns the label that each quad looks to.
  const std::vector<Label>& seenLabels() const { return seenLabels_; }

private:
  void addFacesOf(int i, int j, int k);
  bool addSides(Label low, Label high, std::int64_t lowVoxel, std::int64_t highVoxel);
  void addQuad(bool looksUp, std::array<std::int64_t, 4> corners);
  std::int64_t corner(int i, int j, int k, int up);

  const VoxelSides<Label>& sides_;
  bool isMirrored_;
  std::int64_t* quads_ = nullptr; ///< where the next one goes
  const AddCorner* addCorner_ = nullptr;
  std::int64_t corners_ = 0;
  std::vector<std::int64_t> lower_, upper_; ///< ids of the corners in two layers; −1 for none yet
  std::vector<std::int64_t> voxels_;
  std::vector<Label> seenLabels_;
};

} // namespace winding
