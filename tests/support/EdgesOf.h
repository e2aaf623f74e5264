// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "source/Surface.h"
#include "support/Serial.h"
#include "surface/SurfaceEdges.h"

namespace shapes
{

inline winding::SurfaceEdges edgesOf(const winding::Surface& surface)
{
  return winding::edgesOf(surface, serial);
}

} // namespace shapes
