// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "field/Field.h"
#include "source/SourceVolume.h"

namespace winding
{

/// Returns the size of the volume that the source of a field encloses (SourceVolume.h); 0 for none.
inline double volumeOf(const Field& field)
{
  return field.cloud()     ? volumeOf(*field.cloud())
         : field.surface() ? volumeOf(*field.surface())
                           : 0;
}

/// The size of a solid, which orders nested ones. Sheets that divide space
/// (SheetSide.h) are larger than all solids that end; of two, the one farther to its side is the
/// smaller.
struct SolidSize
{
  bool isEndless = false;
  double amount = 0; ///< the volume, or minus the height of the sheet along its side

  bool operator<(const SolidSize& other) const
  {
    return isEndless != other.isEndless ? other.isEndless : amount < other.amount;
  }
};

inline SolidSize sizeOf(const Field& field)
{
  const FieldInfo& info = field.info();
  const bool isEndless = info.added != 0;
  return {isEndless, isEndless ? -info.sheetHeight : volumeOf(field)};
}

} // namespace winding
