// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/Views.h"
#include "source/Surface.h"
#include "surface/FlatBase.h"
#include "surface/Mirror.h"

#include <vector>

namespace winding
{

/// A surface with its mirror images and its base, as a field with these options has it.
struct CompletedSurface
{
  Surface surface;
  PolygonParts parts;
  std::vector<Message> notes; ///< on what the mirror and the base did

  /// A view of it, which is valid as long as this object stays where it is.
  TrianglesView view() const;
};

/// Completes the surface that views make. Throws Refusal as sanitize() does, and Interrupted.
CompletedSurface completedSurface(const std::vector<TrianglesView>& views, const Mirror& mirror,
  const FlatBase& base, Executor& executor);

} // namespace winding
