// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/SurfaceExamination.h"

#include "field/Field.h"
#include "report/SampleShares.h"
#include "source/Sanitize.h"

namespace winding
{

SurfaceExamination examineSurface(const std::vector<TrianglesView>& triangles,
  const std::vector<VectorsView>& points, Executor& executor)
{
  SurfaceExamination found;
  found.field = Field::build(triangles, FieldOptions(), executor);
  const Surface& surface = *found.field->surface();
  found.edges = edgesOf(surface, executor);
  found.report = reportOn(surface, found.edges, executor, polygonPartsOf(triangles));
  found.report.openings = found.field->info().openings;
  found.vertices = countVertices(points, surface, executor);
  const SampleShares shares = sampleShares(*found.field, executor);
  found.fractionalShare = shares.fractional;
  found.report.shareOnce = shares.once;
  const InsideTest isInside;
  found.report.wallThickness = thicknessOfWalls(*found.field, isInside, executor);
  if (found.report.wallThickness > 0 && found.report.edges.isClosed())
  {
    found.report.hollow = findHollow(*found.field, isInside, executor);
  }
  return found;
}

} // namespace winding
