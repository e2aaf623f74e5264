// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/HeaderFields.h"
#include "input/ImagePlace.h"

#include <string>

/// Reads the header of a NRRD (.nrrd, .nhdr), whose lengths are mm. Its space is the one that it
/// names, or else LPS, as in ITK. Throws HeaderFault.
ImagePlace nrrdImage(const std::string& head);

/// Reads the fields of a NRRD from `start` on, by names in small letters without blanks, up to an
/// empty line, and moves `start` behind them. A header that names files with the data may end
/// without one, or with a list of them.
HeaderFields nrrdFields(const std::string& head, std::size_t& start);
