// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/ImageSpace.h"

#include <string>

class Messages;
class OutputFile;

/**
 * Writes the active scalars of an image, at its points, as a medical image: .mha .nrrd .nii .nii.gz
 * by the suffix of the file, packed unless that is .nii. Numbers keep their type: unsigned char,
 * unsigned short, float or double.
 *
 * Coordinates are in `placed.space`, and go into the format's own space: LPS in .mha, RAS in NIfTI.
 * So voxels stay where they are in the patient. A .nrrd names the space. Where the space is
 * unnamed, coordinates go out as they are, and count as LPS in .mha and .nrrd, and as RAS in NIfTI.
 * NIfTI keeps them in single precision (checkMedicalImage()), and `placed.unit` with them. In .mha
 * and .nrrd metres and micrometres become mm, the unit of ITK. The units of a .nrrd image stay in
 * .nrrd, and the codes and the qform of a NIfTI image in NIfTI.
 *
 * Names of labels (the field data LabelNames and LabelValues) go into .nrrd and .mha by the keys
 * that Slicer has for segments. NIfTI has no place for them.
 *
 * Leaves commit() to the caller. Throws Failure when the file cannot be written whole, when the
 * program is interrupted, and for images that a format cannot hold.
 */
void writeMedicalImage(const PlacedImage& placed, OutputFile& file);

/// Checks whether a medical image of that name can hold the place of an image, before there are
/// values. Throws Failure where NIfTI cannot count the voxels, and where its single precision moves
/// voxels by half of their side or more. Warns where they move by more than 1 %, and where its
/// qform, which has right angles, moves them by more than 10 %.
void checkMedicalImage(const PlacedImage& placed, const std::string& fileName, Messages& messages);
