// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

/// A file that another one names as its part.
struct Piece
{
  std::string file;
  bool isRequired; ///< whether VTK's readers need it, though they pass over some in silence
};

/**
 * Returns the files that `fileName` names, and the files that these name: blocks and pieces of
 * VTK's indices, buffers and images of glTF, voxels of .mhd and .nhdr. Each is there once, whether
 * it exists or not, and however its folder is spelled. Files that cannot be read or parsed name
 * nothing here: their readers refuse them. Throws Failure for more than a million parts, and for
 * parts that lie deeper than 100 levels.
 */
std::vector<Piece> piecesOf(const std::string& fileName);

/// Throws Failure where one of `pieces` of `fileName` is required and not there, or is a pipe, for
/// which readers would wait.
void checkPieces(const std::string& fileName, const std::vector<Piece>& pieces);
