// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/ImagePlace.h"

#include <string>

/// Reads the header of a MetaImage (.mha, .mhd), whose lengths are mm and whose space is LPS, as in
/// ITK. Throws HeaderFault.
ImagePlace metaImage(const std::string& head);
