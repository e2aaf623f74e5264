// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>

/// The ways in which medical files lay axes into a patient: to the left or right, to the back
/// (posterior) or front (anterior), and to the head (superior).
enum class ImageSpace
{
  unnamed, ///< of .vti files, which do not say
  lps,     ///< left, posterior, superior: DICOM, ITK
  ras,     ///< right, anterior, superior: NIfTI
  las      ///< left, anterior, superior
};

/// The name of a space as .nrrd files have it: "left-posterior-superior", say.
std::string nameOf(ImageSpace space);

/// Returns the space of a name in a .nrrd file, or of the name's first letters, with or without
/// time as a fourth axis; nothing for names that the format does not have. Its spaces without a
/// patient, scanner-xyz for one, count as LPS, as in ITK.
std::optional<ImageSpace> spaceOf(const std::string& name);

/// Returns for each axis of space whether it looks the same way in two spaces: 1, or −1 if it
/// looks the other way. An unnamed space is any other.
std::array<double, 3> signsBetween(ImageSpace from, ImageSpace to);

/// The unit of coordinates, by its number in NIfTI.
enum class LengthUnit
{
  unknown = 0,
  metre = 1,
  millimetre = 2,
  micrometre = 3
};

/// Returns a length of 1 in millimetres; 1 for an unknown unit.
double inMillimetres(LengthUnit unit);

/// The two transforms in the header of a NIfTI image: what they are relative to, by the format's
/// codes, 0 for none, and the numbers of the qform where the image has both.
struct NiftiForms
{
  int qform = 1, sform = 1;
  std::array<double, 3> quaternion = {}, offset = {};
  std::array<double, 4> steps = {}; ///< the sign of the third axis first
};

/// The place of an image: extent, origin, spacing and directions, in the coordinates of its file.
struct PlacedImage
{
  vtkSmartPointer<vtkImageData> image;
  ImageSpace space = ImageSpace::unnamed;
  LengthUnit unit = LengthUnit::unknown;
  std::string spaceUnits;          ///< of the axes of a .nrrd image, as it has them
  std::optional<NiftiForms> forms; ///< of a NIfTI image
};

/// Whether a suffix is a medical image's: .mha .nrrd .nii .nii.gz, or .mhd or .nhdr, which are
/// headers of images in other files and are read only.
bool isMedical(const std::string& suffix);

/// Whether a suffix says that a file is one image: .vti, or a medical image's.
bool isImage(const std::string& suffix);
