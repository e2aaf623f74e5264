// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "messages/Options.h"

#include <string>

/// Returns what users of C++ do to make a setting, as messages say it.
inline std::string howTo(const winding::Setting& setting)
{
  return winding::howTo(setting, winding::FrontEnd::cxx);
}
