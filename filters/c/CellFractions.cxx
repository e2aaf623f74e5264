// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/CellFractions.h"
#include "Border.h"
#include "Evaluation.h"
#include "Handles.h"

#include <algorithm>
#include <iterator>

using namespace winding::c;

namespace
{

constexpr int polyhedron = 42;
constexpr int firstLinear = 10, lastLinear = 16;

/// VTK's types of cells of fewer than three dimensions, and the empty cell.
constexpr std::uint8_t flatTypes[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 21, 22, 23, 28, 30, 34, 35, 36,
  51, 52, 53, 54, 60, 61, 62, 63, 68, 69, 70, 75, 76, 77};

bool isKnown(std::uint8_t type)
{
  return (type >= firstLinear && type <= lastLinear) || type == polyhedron ||
         std::find(std::begin(flatTypes), std::end(flatTypes), type) != std::end(flatTypes);
}

/// The cells of a caller, which are right once they are made.
class CallersCells final : public winding::CellShapes
{
public:
  /// Keeps references. Throws Misuse for arrays that do not fit together, and Refusal for ids of
  /// points that there are not, and for cells with too few points.
  CallersCells(const winding_array& points, const winding_cells& cells)
    : points_(vectorsOf(points, "points"))
    , types_(static_cast<const std::uint8_t*>(cells.types.data))
    , corners_(cells.corners, 1, "cells.corners")
    , offsets_(cells.offsets, 1, "cells.offsets")
    , count_(static_cast<std::size_t>(std::max<std::int64_t>(cells.types.rows, 0)))
  {
    const bool areTypes =
      cells.types.rows == 0 || (cells.types.data && cells.types.type == WINDING_UINT8 &&
                                 cells.types.rows > 0 && cells.types.stride <= 1);
    if (!areTypes || cells.types.stride < 0)
    {
      throw Misuse("cells.types has no rows of one WINDING_UINT8");
    }
    if (count_ > 0 && offsets_.rows() != count_ + 1)
    {
      throw Misuse("cells.offsets has not one row more than cells.types");
    }
    for (std::size_t cell = 0; cell < count_; ++cell)
    {
      this->check(cell);
    }
  }

  std::size_t size() const override { return count_; }

  void get(std::size_t cell, winding::CellShape& shape) const override
  {
    const auto first = static_cast<std::size_t>(offsets_(cell, 0));
    const auto last = static_cast<std::size_t>(offsets_(cell + 1, 0));
    if (types_[cell] != polyhedron)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        shape.points.push_back(points_[this->id(i)]);
      }
      shape.addLinearFaces(types_[cell]);
      return;
    }
    // Corners of faces that are one point are one corner, so that its mean is the middle.
    std::vector<std::size_t> own;
    std::vector<int> face;
    for (std::size_t at = first + 1; at < last;)
    {
      const std::size_t end = at + 1 + this->id(at);
      face.clear();
      for (++at; at < end; ++at)
      {
        const auto found = std::find(own.begin(), own.end(), this->id(at));
        face.push_back(static_cast<int>(found - own.begin()));
        if (found == own.end())
        {
          own.push_back(this->id(at));
          shape.points.push_back(points_[own.back()]);
        }
      }
      shape.addFace(face.data(), static_cast<int>(face.size()));
    }
  }

private:
  std::size_t id(std::size_t place) const { return static_cast<std::size_t>(corners_(place, 0)); }

  [[noreturn]] static void refuse(
    std::size_t cell, const std::string& why, const char* remedy = "mend the mesh")
  {
    throw winding::Refusal(
      winding::Message("cell " + std::to_string(cell) + " " + why, {{remedy, {}}}));
  }

  void checkIds(std::size_t cell, std::size_t first, std::size_t last) const
  {
    for (std::size_t i = first; i < last; ++i)
    {
      if (corners_(i, 0) < 0 || this->id(i) >= points_.size())
      {
        refuse(cell, "refers to point " + std::to_string(corners_(i, 0)) + " of " +
                       std::to_string(points_.size()));
      }
    }
  }

  void check(std::size_t cell) const
  {
    const std::int64_t begin = offsets_(cell, 0), end = offsets_(cell + 1, 0);
    if (begin < 0 || end < begin || static_cast<std::size_t>(end) > corners_.rows())
    {
      throw Misuse("cells.offsets do not ascend from 0 to the rows of cells.corners");
    }
    if (!isKnown(types_[cell]))
    {
      refuse(cell, "has type " + std::to_string(types_[cell]) + ", which has no fraction",
        "give straight cells, of types 10 to 16 and 42");
    }
    const auto first = static_cast<std::size_t>(begin), last = static_cast<std::size_t>(end);
    if (types_[cell] != polyhedron)
    {
      this->checkIds(cell, first, last);
      winding::CellShape shape;
      shape.points.resize(last - first);
      if (types_[cell] >= firstLinear && types_[cell] <= lastLinear &&
          !shape.addLinearFaces(types_[cell]))
      {
        refuse(cell, "has " + std::to_string(last - first) + " points, which are too few");
      }
      return;
    }
    std::int64_t faces = first < last ? corners_(first, 0) : 0;
    std::size_t at = first + 1;
    for (; faces > 0 && at < last; --faces)
    {
      const std::int64_t size = corners_(at, 0);
      if (size < 0 || static_cast<std::size_t>(size) > last - at - 1)
      {
        refuse(cell, "is a polyhedron with a face that does not end");
      }
      this->checkIds(cell, at + 1, at + 1 + static_cast<std::size_t>(size));
      at += 1 + static_cast<std::size_t>(size);
    }
    if (faces != 0 || (first < last && at != last))
    {
      refuse(cell, "is a polyhedron with another number of faces than it says");
    }
  }

  winding::VectorsView points_;
  const std::uint8_t* types_;
  Ids corners_, offsets_;
  std::size_t count_;
};

} // namespace

winding_status winding_cell_fractions(const winding_field* field, winding_array points,
  const winding_cells* cells, const winding_rule* rule, float* fractions, const winding_run* run,
  winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      const winding_field& handle = required(field, "field");
      const winding::InsideTest isInside = insideTestOf(rule);
      const CallersCells given(points, required(cells, "cells"));
      float* const to = given.size() > 0 ? &required(fractions, "fractions") : fractions;
      Call call(run);
      winding::CellsWithoutFraction counts;
      evaluateInTime(*handle.field, given.size(), call,
        [&] {
          counts = winding::evaluateFractions(*handle.field, given, isInside, to, call.executor);
        });
      call.warn(winding::warningsOf(counts, given.size()));
    });
}
