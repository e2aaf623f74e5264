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

} // namespace winding
