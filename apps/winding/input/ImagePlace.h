// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/ImageSpace.h"

#include <array>
#include <optional>
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
  std::string spaceUnits;          ///< as in PlacedImage
  std::optional<NiftiForms> forms; ///< as in PlacedImage
};
