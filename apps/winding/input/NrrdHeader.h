// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/ImagePlace.h"

#include <string>

/// Reads the header of a NRRD (.nrrd, .nhdr), whose lengths are mm. Its space is the one that it
/// names, or else LPS, as in ITK. Throws HeaderFault.
ImagePlace nrrdImage(const std::string& head);
