// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/ImageSpace.h"

#include <string>
#include <vector>

/**
 * Reads where the voxels of a medical image lie, .mha .mhd .nrrd .nhdr .nii .nii.gz, from its
 * header; the voxels themselves are neither read nor looked for. An image of two axes is a slice,
 * and of more than three axes the ones of space count. Voxel centres are the points of the result,
 * which has no arrays. Coordinates stay as they are in the file: its space is RAS in NIfTI, LPS in
 * .mha, and named by .nrrd, or else LPS. Of NIfTI's two transforms the sform counts, if there is
 * one, and the qform otherwise. Axes need not be at right angles. Lengths are mm in .mha and
 * .nrrd, as in ITK.
 *
 * Throws Failure for files that cannot be opened, and in one line for headers that place no image.
 */
PlacedImage readImageHeader(const std::string& fileName);

/// The same for the first bytes of a file, unpacked, of that suffix. Failures name `fileName`.
PlacedImage placedImage(
  const std::string& head, const std::string& suffix, const std::string& fileName);

/// Returns the names of the files with the voxels of an image, .mha .mhd .nrrd .nhdr, as its header
/// has them; nothing where they lie behind it, or where it cannot be read.
std::vector<std::string> voxelFilesOf(const std::string& fileName);
