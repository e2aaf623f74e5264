// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "source/Surface.h"
#include "surface/BoundaryLoops.h"

#include <cstdint>
#include <vector>

namespace winding
{

/// Distinct loops, by ascending multiplicity.
struct RepeatedLoops
{
  /// Takes loops as boundaryLoops() makes them: those that run along the same edges come one after
  /// the other.
  explicit RepeatedLoops(BoundaryLoops all);

  /// Returns the multiplicities of triangles; each loop has trianglesOf(loop) of them.
  template <class TrianglesOf> Multiplicities multiplicities(const TrianglesOf& trianglesOf) const
  {
    Multiplicities result;
    for (std::size_t i = 0; i < counts.size(); ++i)
    {
      result.insert(result.end(), trianglesOf(loops[i]), counts[i]);
    }
    return result;
  }

  BoundaryLoops loops;
  std::vector<std::int32_t> counts; ///< by loop; empty where each was there once
};

} // namespace winding
