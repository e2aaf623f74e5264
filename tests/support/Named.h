// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Message.h"

#include <algorithm>

/// Whether a message is about a parameter, or names it as a remedy.
inline bool isNamed(const winding::Message& message, winding::Parameter parameter)
{
  const auto isIt = [parameter](const winding::Setting& setting)
  {
    return setting.parameter == parameter;
  };
  return message.subject == parameter ||
         std::any_of(message.remedies.begin(), message.remedies.end(),
           [&isIt](const winding::Remedy& remedy)
           { return std::any_of(remedy.settings.begin(), remedy.settings.end(), isIt); });
}
