// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkWindingABINamespace.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

class Messages;
VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

/**
 * A .pvti file: an index of pieces, which are .vti files in a folder next to it that has its name
 * without the suffix. All ranks write pieces (ParallelRun.h). They take their names when all are
 * complete, the index last; an index of an earlier run goes before that, so that none ever stands
 * among pieces of another run. Functions are collective.
 */
class PiecesFile
{
public:
  /// Throws Failure, before any work, where files of these names cannot be written, or would
  /// replace one of `inputs`.
  PiecesFile(const std::string& name, const std::vector<std::string>& inputs);

  const std::string& name() const { return name_; }

  using Extent = std::array<int, 6>;

  /// Makes the image of a piece, and is called by all ranks as often; null where a rank has nothing
  /// to write.
  using MakePiece = std::function<vtkImageData*(std::size_t round)>;

  /// Writes an image of the whole extent in pieces. In each of `rounds` this rank makes and writes
  /// the piece that has the number firstPiece + round. `pieces` are the extents of the pieces of
  /// all ranks. Throws Failure when that fails or the program is interrupted.
  void write(const Extent& whole, const std::vector<Extent>& pieces, std::size_t firstPiece,
    std::size_t rounds, const MakePiece& makePiece, Messages& messages) const;

private:
  std::string pieceName(std::size_t number) const;
  std::string index(
    const Extent& whole, const std::vector<Extent>& pieces, vtkImageData* image) const;
  void removeLaterPieces(std::size_t count) const;

  std::string name_;
  std::string folder_;
  std::vector<std::string> inputs_;
};
