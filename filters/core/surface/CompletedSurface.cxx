// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/CompletedSurface.h"

#include "source/Sanitize.h"

namespace winding
{

TrianglesView CompletedSurface::view() const
{
  const VectorsView points(
    surface.vertices.empty() ? nullptr : surface.vertices.front().data(), surface.vertices.size());
  const TriangleIdsView triangles(
    surface.triangles.empty() ? nullptr : surface.triangles.front().data(),
    surface.triangles.size());
  return {points, triangles, parts.empty() ? nullptr : parts.data()};
}

CompletedSurface completedSurface(const std::vector<TrianglesView>& views, const Mirror& mirror,
  const FlatBase& base, Executor& executor)
{
  CompletedSurface result{sanitize(views, executor), polygonPartsOf(views), {}};
  if (mirror.cuts(result.surface.vertices, result.surface.bounds))
  {
    result.notes.push_back(cutByMirror());
  }
  mirror.addTo(result.surface, result.parts);
  if (!base.isNone())
  {
    const std::vector<Message> notes = notesOn(base.addTo(result.surface, executor));
    result.notes.insert(result.notes.end(), notes.begin(), notes.end());
  }
  result.parts.resize(result.parts.empty() ? 0 : result.surface.triangles.size(), 0);
  return result;
}

} // namespace winding
