#pragma once

#include "base/EvaluationCost.h"
#include "field/Field.h"

namespace winding
{

/// The seconds, on one thread, that the level surface of a field on a grid of so many samples is
/// expected to take in addition to the field itself (LevelEdges.h, EdgeCrossings.h, LevelRoots.h).
/// They are less than 0 where the field of a closed surface is spared the writing of its values.
double secondsOfLevelSurface(const Field& field, std::size_t samples);

} // namespace winding
