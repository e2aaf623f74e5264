// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Message.h"

namespace winding
{

/// Returns what to say of the side of sheets where there are none.
inline Message noOpenPart()
{
  return {Parameter::sheetSide, "has no use: no part is open"};
}

/// Returns what to do where a sheet does not look to its side.
inline Message alongSheet()
{
  Message message(Parameter::sheetSide, "lies along the sheet");
  message.remedies = {{"choose a side that it faces", {}}};
  return message;
}

} // namespace winding
