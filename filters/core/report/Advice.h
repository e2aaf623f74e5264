#pragma once

#include "report/CloudReport.h"
#include "report/SurfaceReport.h"
#include "source/Surface.h"

#include <string>

/**
 * @file
 * What a report means for winding numbers, and what could be done: one line, what matters most first.
 * Options are named as the filters and the program have them.
 */
namespace winding
{

std::string adviceOn(const Surface& surface, const SurfaceReport& report);

std::string adviceOn(const CloudReport& report);

} // namespace winding
