// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

/// The centre of a voxel of the images below: 7, 8 and 9 voxels around the origin along axes that
/// no axis of space is, of which one is mirrored.
std::array<double, 3> voxelOfHead(const std::array<int, 3>& index);

/// Makes a file of that image as ITK writes it, .mha. There are no voxels in the file.
std::string asMetaImage();

/// Makes the same as .nrrd. More axes may come before those of space, with their sizes.
std::string asNrrd(const std::string& space, const std::string& sizes = "7 8 9",
  const std::string& firstDirections = "");

/// The ways in which NIfTI files say where voxels lie.
enum class NiftiKind
{
  sform,
  qform,
  bigEndian, ///< the sform in the other order of bytes
  wide       ///< NIfTI-2
};

/// Makes the same as .nii.
std::string asNifti(NiftiKind kind);

std::string packedByGzip(const std::string& contents);

/// Unpacks what gzip or zlib has packed, `most` bytes at most.
std::string unpackedAny(const std::string& packed, std::size_t most);

///@{
/// Makes grids of eight points, of which the first is the origin and all others are 2 and more
/// away: .vts and .vtr.
std::string asCurvedGrid();
std::string asRectilinearGrid();
///@}

/// Returns the bytes of the voxels in a medical image that the program has written.
std::string voxelsOf(const std::string& fileName, std::size_t bytes);
