// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

/**
 * Throws Failure where the first bytes of a file say that it is not what its suffix says. VTK's
 * readers believe the suffix, and some of them give an empty surface for anything.
 */
void checkContentFits(const std::string& fileName);
