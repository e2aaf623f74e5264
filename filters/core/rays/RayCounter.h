#pragma once

#include "rays/RayColumns.h"
#include "rays/RayTriangle.h"
#include "source/Surface.h"

#include <cstdint>
#include <vector>

namespace winding
{

using TriangleIds = std::vector<std::uint32_t>;

/// Rays sorted by columns: starts[c] … starts[c + 1] − 1 are the rays of column c.
struct RaysInColumns
{
  Columns columns;
  std::vector<Ray*> starts;

  std::size_t size(std::size_t column) const
  {
    return static_cast<std::size_t>(starts[column + 1] - starts[column]);
  }
};

/// Finds the crossings of rays with the triangles of a surface, on one thread.
class RayCounter
{
public:
  /// Keeps a reference. `scale` makes the surface's coordinates those of the rays.
  RayCounter(const Surface& surface, double scale)
    : surface_(surface)
    , scale_(scale)
  {
  }

  TriangleBox box(std::uint32_t id) const
  {
    const Triangle& ids = surface_.triangles[id];
    return {
      surface_.vertices[ids[0]], surface_.vertices[ids[1]], surface_.vertices[ids[2]], scale_};
  }

  Footprint footprint(std::uint32_t id, const Columns& columns, const ColumnRange& range) const
  {
    const Triangle& ids = surface_.triangles[id];
    return {columns, range, surface_.vertices[ids[0]] * scale_, surface_.vertices[ids[1]] * scale_,
      surface_.vertices[ids[2]] * scale_};
  }

  /// Sorts rays by the columns of a grid over them.
  static RaysInColumns sort(Ray* first, Ray* last, const Columns& columns);

  /// The most steps that count() takes before it gives up: steps of some 10 ns, 20 ms in all.
  static constexpr std::ptrdiff_t mostSteps = 1 << 21;

  /**
   * Adds the crossings of all rays with all triangles; puts the rays into another order. Returns
   * false, with some crossings added and others not, if there is too much to do. Rays on one line
   * are never too much: they are sorted along it, so that each triangle takes a search only.
   */
  bool count(Ray* first, Ray* last, const TriangleIds& triangles) const
  {
    std::ptrdiff_t steps = mostSteps;
    return this->count(first, last, triangles, steps);
  }

  /// Does what count() does, without giving up.
  void countAll(Ray* first, Ray* last, const TriangleIds& triangles) const
  {
    std::ptrdiff_t steps = std::numeric_limits<std::ptrdiff_t>::max();
    this->count(first, last, triangles, steps);
  }

private:
  bool count(Ray* first, Ray* last, const TriangleIds& triangles, std::ptrdiff_t& steps) const;
  void countOnLine(Ray* first, Ray* last, const TriangleIds& triangles, const RayBox& box) const;

  RayTriangle triangle(std::uint32_t id) const
  {
    const Triangle& ids = surface_.triangles[id];
    return {surface_.vertices[ids[0]] * scale_, surface_.vertices[ids[1]] * scale_,
      surface_.vertices[ids[2]] * scale_};
  }

  const Surface& surface_;
  double scale_;
};

} // namespace winding
