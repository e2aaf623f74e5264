#include "field/InsideOut.h"

#include "cloud/CloudOrientation.h"

namespace winding
{

bool looksInward(const Field& field, const SideCounts& sides, Executor& executor)
{
  if (field.cloud())
  {
    return sides.negative > sides.inside && orientationOf(*field.cloud(), executor).isInward();
  }
  return sides.negative > 0 && 100 * sides.negative >= sides.negative + sides.inside;
}

} // namespace winding
