// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/ImagePlace.h"

#include <cstddef>
#include <string>

/// The number of bytes in which niftiImage() finds all that it needs.
constexpr std::size_t bytesOfNiftiHeader = 540;

/**
 * Reads the header of a NIfTI-1 or NIfTI-2 file, of either order of bytes. The sform counts if its
 * code is not 0, the qform otherwise; where both codes are 0, axes are straight and begin at 0, as
 * the standard's method 1 has it. Throws HeaderFault.
 */
ImagePlace niftiImage(const std::string& head);
