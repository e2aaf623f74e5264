// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Views.h"
#include "mesh/CellCounts.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/**
 * @file
 * The outer surface of a mesh, its skin, as VTK's vtkDataSetSurfaceFilter extracts it. The rest is
 * done here: polygons look outward, seams go, and curved faces are divided as far as they need.
 */
namespace winding
{

/// Ids, #N by 1. The stride counts numbers and is at least 1.
class IdsView : public detail::StridedView<std::int32_t, std::int64_t, std::int64_t>
{
public:
  IdsView() = default;
  template <class T>
  IdsView(const T* data, std::size_t count, std::size_t stride = 1)
    : StridedView(data, count, stride)
  {
  }
  std::int64_t operator[](std::size_t i) const { return at(i, 0); }
};

/// Cells over shared points, which were checked (CellChecks.h).
struct MeshView
{
  VectorsView points;
  const std::uint8_t* types = nullptr; ///< VTK's; as many as cells
  /// The ids of all cells in VTK's order. A polyhedron has the number of its faces, then the number
  /// of points and their ids for each.
  IdsView corners;
  IdsView offsets; ///< by cell, where its ids begin; and where the last one ends

  std::size_t cells() const { return offsets.empty() ? 0 : offsets.size() - 1; }
};

/// Polygons that are faces of a mesh's cells.
struct SkinView
{
  VectorsView points; ///< not the mesh's
  IdsView corners;    ///< ids of its points, polygon after polygon
  IdsView offsets;    ///< by polygon, where its corners begin; and where the last one ends
  IdsView owners;     ///< by polygon, its cell
  /// By point, the mesh's point that it is. New points on curved faces may have any number. Empty
  /// where they are not known: then straight cells are taken as convex.
  IdsView origins;

  std::size_t polygons() const { return owners.size(); }
};

/// The polygons of a skin that bound the mesh, each turned away from its own cell.
struct OutwardPolygons
{
  std::vector<std::int64_t> corners;  ///< polygon after polygon; a turned one keeps its first
  std::vector<std::int64_t> offsets;  ///< by polygon, where its corners begin; and the end
  std::vector<std::int64_t> polygons; ///< their numbers in the skin, which ascend
};

/**
 * Turns the polygons of cells with volume outward, and leaves seams out.
 *
 * - A polygon looks outward where the faces of its cell, agreeing with each other, enclose a volume
 *   of more than 0. So any order of nodes will do, and cells need not be convex. The faces of a
 *   polyhedron are first oriented like each other.
 * - Seams are polygons with corners at the same places in opposite senses. They lie between cells
 *   that touch but share no points, as between the pieces of a file. Distances, counts and labels
 *   would take them for walls.
 *
 * Counts the cells that are turned.
 */
OutwardPolygons outwardPolygons(const MeshView& mesh, const SkinView& skin, CellCounts& counts);

/**
 * Returns how often to halve the edges of curved faces, at most 5 times: until they are within a
 * thousandth of `diagonal`, the mesh's, of their shape. `once` and `twice` are the skins with edges
 * halved once and twice, over `cells` cells. Counts the cells that stay too far from their shape.
 *
 * A chord of length h whose arc rises s above it is shorter by 8/3 (s/h)² of its length. Halving
 * leaves a quarter of s.
 */
int halvingsOf(const SkinView& once, const SkinView& twice, std::size_t cells, double diagonal,
  CellCounts& counts);

} // namespace winding
