#pragma once

#include "report/CloudReport.h"
#include "report/SurfaceReport.h"
#include "source/Surface.h"

#include <string>

/**
 * @file
 * Advice says in one line what a report means for winding numbers and what could be done; the most
 * important comes first. Options are named as the filters and the program have them.
 */
namespace winding
{

std::string adviceOn(const Surface& surface, const SurfaceReport& report);

std::string adviceOn(const CloudReport& report);

} // namespace winding
