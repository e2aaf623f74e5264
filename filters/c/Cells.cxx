// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Border.h"
#include "Evaluation.h"
#include "Handles.h"
#include "mesh/CellChecks.h"
#include "mesh/CellTypes.h"
#include "mesh/MeshSkin.h"
#include "voxels/CellFractions.h"

#include <algorithm>

using namespace winding::c;

namespace
{

/// Returns the types of cells. Throws Misuse for arrays that cannot be types.
std::vector<std::uint8_t> typesOf(const winding_array& types)
{
  const bool areTypes = types.rows == 0 || (types.data && types.type == WINDING_UINT8 &&
                                             types.rows > 0 && types.stride <= 1);
  if (!areTypes || types.stride < 0)
  {
    throw Misuse("cells.types has no rows of one WINDING_UINT8");
  }
  const auto* const data = static_cast<const std::uint8_t*>(types.data);
  return {data, data + types.rows};
}

/// The cells of a caller over `points`.
struct CallersCells : winding::MeshView
{
  /// Keeps references. Throws Misuse for arrays that cannot be cells.
  explicit CallersCells(const winding_cells& cells, const winding::VectorsView& ofPoints = {})
    : allTypes(typesOf(cells.types))
  {
    points = ofPoints;
    types = allTypes.data();
    corners = winding::c::idsOf(cells.corners, "cells.corners");
    offsets = winding::c::idsOf(cells.offsets, "cells.offsets");
  }

  /// Returns whether offsets lead to ids.
  bool areOffsetsValid() const
  {
    bool areValid = true;
    for (std::size_t cell = 0; areValid && cell < this->cells(); ++cell)
    {
      areValid = offsets[cell] >= 0 && offsets[cell + 1] >= offsets[cell] &&
                 offsets[cell + 1] <= static_cast<std::int64_t>(corners.size());
    }
    return areValid;
  }

  /// Throws Misuse for arrays that do not fit together, and Refusal for a cell that contradicts
  /// itself. Other cells than `numbers` may be any; null is all.
  void check(const winding::IdsView* numbers = nullptr) const
  {
    if (this->cells() != allTypes.size())
    {
      throw Misuse("cells.offsets has not one row more than cells.types");
    }
    if (!this->areOffsetsValid())
    {
      throw Misuse("cells.offsets do not ascend from 0 to the rows of cells.corners");
    }
    const winding::CellChecks checks("the mesh", static_cast<std::int64_t>(points.size()));
    for (std::size_t i = 0; i < (numbers ? numbers->size() : this->cells()); ++i)
    {
      const auto cell = numbers ? static_cast<std::size_t>((*numbers)[i]) : i;
      this->checkCell(cell, checks, static_cast<std::int64_t>(cell), nullptr, nullptr);
    }
  }

  /// Refuses a cell that messages give a number. Cells without types may be any. `degrees` are as
  /// for canHavePoints(). `faces` has the faces of polyhedra, whose corners are then their points;
  /// null has them in the corners. A polyhedron without corners is an empty cell.
  void checkCell(std::size_t cell, const winding::CellChecks& checks, std::int64_t number,
    const double* degrees, const CallersCells* faces) const
  {
    const bool isPolyhedron = !allTypes.empty() && allTypes[cell] == winding::polyhedronType;
    if (!allTypes.empty())
    {
      checks.checkType(number, allTypes[cell], offsets[cell + 1] - offsets[cell], degrees);
    }
    for (std::int64_t at = offsets[cell]; (!isPolyhedron || faces) && at < offsets[cell + 1]; ++at)
    {
      const std::int64_t id = corners[static_cast<std::size_t>(at)];
      checks.checkIds(number, &id, &id + 1);
    }
    if (isPolyhedron && (faces || offsets[cell] < offsets[cell + 1]))
    {
      const std::vector<std::int64_t> own = this->idsOf(cell);
      checks.checkPolyhedron(
        number, faces ? faces->idsOf(cell) : own, faces ? own : std::vector<std::int64_t>());
    }
  }

  std::vector<std::int64_t> idsOf(std::size_t cell) const
  {
    std::vector<std::int64_t> ids;
    for (std::int64_t at = offsets[cell]; at < offsets[cell + 1]; ++at)
    {
      ids.push_back(corners[static_cast<std::size_t>(at)]);
    }
    return ids;
  }

  std::vector<std::uint8_t> allTypes;
};

/// Cells as shapes, straight between their corners. They were checked.
class Shapes final : public winding::CellShapes
{
public:
  /// Throws Refusal for convex sets of points, whose faces are not known.
  explicit Shapes(const CallersCells& cells)
    : cells_(cells)
  {
    constexpr std::uint8_t convexPointSet = 41;
    const auto& types = cells.allTypes;
    const auto found = std::find(types.begin(), types.end(), convexPointSet);
    if (found != types.end())
    {
      throw winding::Refusal(winding::Message(
        "cell " + std::to_string(found - types.begin()) + " of the mesh is a set of points",
        {{"give its faces, as a polyhedron", {}}}));
    }
  }

  std::size_t size() const override { return cells_.cells(); }

  void get(std::size_t cell, winding::CellShape& shape) const override
  {
    const std::vector<std::int64_t> ids = cells_.idsOf(cell);
    if (cells_.types[cell] != winding::polyhedronType)
    {
      for (const std::int64_t id : ids)
      {
        shape.points.push_back(cells_.points[static_cast<std::size_t>(id)]);
      }
      shape.addFacesOf(cells_.types[cell]);
      return;
    }
    // Corners of faces that are one point are one corner, so that its mean is the middle.
    std::vector<std::int64_t> own;
    std::vector<int> face;
    for (std::size_t at = 1; at < ids.size();)
    {
      const std::size_t end = at + 1 + static_cast<std::size_t>(ids[at]);
      face.clear();
      for (++at; at < end; ++at)
      {
        const auto found = std::find(own.begin(), own.end(), ids[at]);
        face.push_back(static_cast<int>(found - own.begin()));
        if (found == own.end())
        {
          own.push_back(ids[at]);
          shape.points.push_back(cells_.points[static_cast<std::size_t>(ids[at])]);
        }
      }
      shape.addFace(face.data(), static_cast<int>(face.size()));
    }
  }

private:
  const CallersCells& cells_;
};

/// Returns the skin of a caller over `cells` cells. Throws Misuse for arrays that do not fit.
winding::SkinView skinOf(const winding_skin& skin, std::size_t cells)
{
  winding::SkinView view;
  view.points = vectorsOf(skin.points, "skin.points");
  view.corners = idsOf(skin.polygons.corners, "skin.polygons.corners");
  view.offsets = idsOf(skin.polygons.offsets, "skin.polygons.offsets");
  view.owners = idsOf(skin.owners, "skin.owners");
  view.origins = idsOf(skin.origins, "skin.origins");
  const auto isBelow = [](std::int64_t id, std::size_t count)
  {
    return id >= 0 && static_cast<std::size_t>(id) < count;
  };
  bool isRight = view.polygons() == 0 || view.offsets.size() == view.polygons() + 1;
  isRight = isRight && (view.origins.empty() || view.origins.size() == view.points.size());
  for (std::size_t polygon = 0; isRight && polygon < view.polygons(); ++polygon)
  {
    isRight = isBelow(view.owners[polygon], cells) && view.offsets[polygon] >= 0 &&
              view.offsets[polygon + 1] >= view.offsets[polygon] &&
              static_cast<std::size_t>(view.offsets[polygon + 1]) <= view.corners.size();
  }
  for (std::size_t corner = 0; isRight && corner < view.corners.size(); ++corner)
  {
    isRight = isBelow(view.corners[corner], view.points.size());
  }
  if (!isRight)
  {
    throw Misuse("the arrays of a skin do not fit together, or to the cells");
  }
  return view;
}

winding_cell_counts defaultCounts()
{
  winding_cell_counts counts = {};
  counts.size = sizeof(counts);
  return counts;
}

/// Adds to the counts of a caller what work(counts) counts.
template <class Work> void addCounts(winding_cell_counts* to, const Work& work)
{
  winding_cell_counts given = known(to, defaultCounts());
  winding::CellCounts counts;
  work(counts);
  given.turned += static_cast<std::int64_t>(counts.turned);
  given.left_out += static_cast<std::int64_t>(counts.leftOut);
  given.loose += static_cast<std::int64_t>(counts.loose);
  given.flat += static_cast<std::int64_t>(counts.flat);
  give(given, required(to, "counts"));
}

} // namespace

void winding_cell_counts_init(winding_cell_counts* counts, size_t size)
{
  fill(counts, size, defaultCounts());
}

int32_t winding_cell_dimension(int32_t type, int32_t* is_curved)
{
  if (is_curved)
  {
    *is_curved = winding::isCurved(type) ? 1 : 0;
  }
  return winding::dimensionOf(type);
}

winding_status winding_check_cells(const winding_cells* cells, const winding_cells* faces,
  winding_array degrees, int64_t count, int64_t points, int64_t first, const char* name,
  winding_refusal* refusal)
{
  return guarded(nullptr, refusal,
    [&]
    {
      const CallersCells given(required(cells, "cells"));
      const CallersCells facesOfCells(faces ? *faces : winding_cells{});
      const winding::VectorsView allDegrees = vectorsOf(degrees, "degrees");
      const winding::CellChecks checks(&required(name, "name"), points);
      const auto isLongEnough = [count](const CallersCells& all)
      {
        return static_cast<std::int64_t>(all.cells()) >= count && all.areOffsetsValid();
      };
      checks.checkOffsets(isLongEnough(given) && (!faces || isLongEnough(facesOfCells)));
      if (cells->types.data)
      {
        checks.checkTypes(count, static_cast<std::int64_t>(given.allTypes.size()));
      }
      for (std::int64_t cell = 0; cell < count; ++cell)
      {
        const auto number = static_cast<std::size_t>(cell);
        const bool hasDegrees = number < allDegrees.size();
        const Eigen::Vector3d own =
          hasDegrees ? allDegrees[number] : Eigen::Vector3d::Zero().eval();
        given.checkCell(number, checks, first + cell, hasDegrees ? own.data() : nullptr,
          faces ? &facesOfCells : nullptr);
      }
    });
}

winding_status winding_choose_cells(winding_array types, const uint8_t* ghosts,
  int32_t surface_cells, uint8_t* are_own, winding_cell_counts* counts, winding_refusal* refusal)
{
  return guarded(nullptr, refusal,
    [&]
    {
      const std::vector<std::uint8_t> given = typesOf(types);
      std::uint8_t* const own = given.empty() ? are_own : &required(are_own, "are_own");
      addCounts(counts,
        [&](winding::CellCounts& found)
        {
          countLoose(given, found);
          const std::vector<char> isOwn = ownCellsOf(given, ghosts, surface_cells != 0, found);
          std::copy(isOwn.begin(), isOwn.end(), own);
        });
    });
}

winding_status winding_halvings(const winding_skin* once, const winding_skin* twice, int64_t cells,
  double diagonal, int32_t* halvings, winding_cell_counts* counts, winding_refusal* refusal)
{
  return guarded(nullptr, refusal,
    [&]
    {
      const auto count = static_cast<std::size_t>(std::max<std::int64_t>(cells, 0));
      const winding::SkinView coarse = skinOf(required(once, "once"), count);
      const winding::SkinView fine = skinOf(required(twice, "twice"), count);
      addCounts(counts, [&](winding::CellCounts& found)
        { required(halvings, "halvings") = halvingsOf(coarse, fine, count, diagonal, found); });
    });
}

winding_status winding_outward_polygons(winding_array points, const winding_cells* cells,
  const winding_skin* skin, int64_t* corners, int64_t* offsets, int64_t* polygons, int64_t* kept,
  winding_cell_counts* counts, winding_refusal* refusal)
{
  return guarded(nullptr, refusal,
    [&]
    {
      const CallersCells mesh(required(cells, "cells"), vectorsOf(points, "points"));
      const winding::SkinView view = skinOf(required(skin, "skin"), mesh.cells());
      mesh.check(&view.owners);
      addCounts(counts,
        [&](winding::CellCounts& found)
        {
          const winding::OutwardPolygons outward = outwardPolygons(mesh, view, found);
          if (!outward.polygons.empty())
          {
            std::copy(
              outward.corners.begin(), outward.corners.end(), &required(corners, "corners"));
            std::copy(
              outward.polygons.begin(), outward.polygons.end(), &required(polygons, "polygons"));
          }
          std::copy(outward.offsets.begin(), outward.offsets.end(), &required(offsets, "offsets"));
          required(kept, "kept") = static_cast<std::int64_t>(outward.polygons.size());
        });
    });
}

winding_status winding_warn_of_cells(
  const winding_cell_counts* counts, const winding_run* run, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      const winding_cell_counts given = known(&required(counts, "counts"), defaultCounts());
      winding::CellCounts all;
      all.leftOut = static_cast<std::size_t>(given.left_out);
      all.loose = static_cast<std::size_t>(given.loose);
      all.flat = static_cast<std::size_t>(given.flat);
      Call(run).warn(notesOn(all));
    });
}

winding_status winding_cell_fractions(const winding_field* field, winding_array points,
  const winding_cells* cells, const winding_rule* rule, float* fractions, const winding_run* run,
  winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      const winding_field& handle = required(field, "field");
      const winding::InsideTest inside = insideTestOf(rule);
      const CallersCells given(required(cells, "cells"), vectorsOf(points, "points"));
      given.check();
      const Shapes shapes(given);
      float* const to = shapes.size() > 0 ? &required(fractions, "fractions") : fractions;
      Call call(run);
      winding::CellsWithoutFraction counts;
      evaluateInTime(*handle.field, shapes.size(), call,
        [&]
        { counts = winding::evaluateFractions(*handle.field, shapes, inside, to, call.executor); });
      call.warn(winding::warningsOf(counts, shapes.size()));
    });
}
