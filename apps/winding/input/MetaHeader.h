// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/HeaderFields.h"
#include "input/ImagePlace.h"

#include <string>

/// Reads the header of a MetaImage (.mha, .mhd), whose lengths are mm and whose space is LPS, as in
/// ITK. Throws HeaderFault.
ImagePlace metaImage(const std::string& head);

/// Reads the fields of a MetaImage from `start` on, up to ElementDataFile, and moves `start` behind
/// it. Values follow = or a colon.
HeaderFields metaFields(const std::string& head, std::size_t& start);
