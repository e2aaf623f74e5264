#pragma once

#include "files/ImageSpace.h"

#include <array>
#include <stdexcept>
#include <string>

/// Thrown for a header that places no image, with the reason.
class HeaderFault : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Where voxels lie, as headers say it.
struct ImagePlace
{
  std::array<int, 3> dimensions = {};
  std::array<double, 3> origin = {};               ///< the centre of the first voxel
  std::array<std::array<double, 3>, 3> steps = {}; ///< from a voxel to the next, along each index
  ImageSpace space = ImageSpace::unnamed;
  LengthUnit unit = LengthUnit::unknown;
};

/// The number of bytes in which niftiImage() finds all that it needs.
constexpr std::size_t bytesOfNiftiHeader = 540;

/**
 * Reads the header of a NIfTI-1 or NIfTI-2 file, of either order of bytes. The sform counts if its
 * code is not 0, the qform otherwise; where both codes are 0, axes are straight and begin at 0, as
 * the standard's method 1 has it. Throws HeaderFault.
 */
ImagePlace niftiImage(const std::string& head);
