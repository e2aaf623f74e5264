// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Message.h"
#include "report/CloudReport.h"
#include "report/SurfaceReport.h"
#include "source/Surface.h"

#include <vector>

/**
 * @file
 * Advice says what a report means for winding numbers and what could be done; the most important
 * comes first.
 */
namespace winding
{

std::vector<Message> adviceOn(const Surface& surface, const SurfaceReport& report);

std::vector<Message> adviceOn(const CloudReport& report);

} // namespace winding
