// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level/LevelRoots.h"
#include "support/FieldDistances.h"
#include "support/RowValues.h"

#include <memory>

namespace shapes
{

/// The solid of a mesh on a grid: its field, the edges that its surface crosses, and their roots.
struct SolidOnGrid
{
  SolidOnGrid(
    const Mesh& mesh, const winding::Grid& grid, bool withBorder, winding::Executor& executor)
    : field(fieldOf(mesh))
    , edges(*field, grid, winding::InsideTest(), withBorder)
    , roots(0)
  {
    while (!edges.isDone())
    {
      edges.advance(executor);
    }
    winding::LevelRoots found(*field, grid, edges, winding::InsideTest(), 1e-3, executor);
    while (!found.isDone())
    {
      found.advance(executor);
    }
    found.addGradients(executor);
    roots = found.take();
  }

  std::shared_ptr<const winding::Field> field;
  winding::LevelEdges edges;
  winding::EdgeRoots roots;
};

} // namespace shapes
