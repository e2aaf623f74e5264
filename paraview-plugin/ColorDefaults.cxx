// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorDefaults.h"

#include "vtkSMSettings.h"

namespace winding
{

void setColorDefaults()
{
  constexpr const char* name = ".array_lookup_tables.WindingNumber.PVLookupTable";
  // ParaView's own defaults have priority 0, settings of the site and of the user 1 and more.
  constexpr double priority = 0.5;
  // The mode −1 is never, the colour space 3 diverging; the colours are Cool to Warm.
  constexpr const char* colors =
#include "ColorDefaults.inc"
    ;
  vtkSMSettings* const settings = vtkSMSettings::GetInstance();
  if (!settings->HasSetting(name))
  {
    settings->AddCollectionFromString(colors, priority);
  }
}

} // namespace winding
