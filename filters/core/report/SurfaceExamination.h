// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/Views.h"
#include "report/SurfaceReport.h"

#include <memory>
#include <optional>
#include <vector>

namespace winding
{

class Field;

/// The surface that triangles make, with its field, and all figures that reports of it have.
struct SurfaceExamination
{
  std::shared_ptr<const Field> field; ///< whose surface the rest is about
  SurfaceEdges edges;
  SurfaceReport report; ///< with openings
  VertexCounts vertices;
  std::optional<double> fractionalShare; ///< by SampleShares.h
};

/// Examines the surface that `triangles` make. `points` are all points that it was made from, of
/// triangles or not. Throws Refusal as Field::build() does, and Interrupted.
SurfaceExamination examineSurface(const std::vector<TrianglesView>& triangles,
  const std::vector<VectorsView>& points, Executor& executor);

} // namespace winding
