// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/SolidShape.h"
#include "base/UninitializedVector.h"
#include "distance/DistanceTree.h"
#include "field/Field.h"
#include "winding.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

/// The handle of a field.
struct winding_field
{
  std::shared_ptr<const winding::Field> field;
};

/// The handle of a mesh. Arrays that it does not have are empty.
struct winding_mesh
{
  winding::UninitializedVector<float> floatPoints; ///< three each; either these or doubles
  winding::UninitializedVector<double> doublePoints;
  winding::UninitializedVector<std::int64_t> offsets, corners;
  winding::UninitializedVector<float> pointNormals, polygonNormals;
  winding::UninitializedVector<double> doublePointNormals, pointAreas;
  winding::UninitializedVector<std::uint16_t> labels;
  winding::UninitializedVector<std::int64_t> numbers; ///< of polygons
  winding::UninitializedVector<std::int32_t> operands;
  winding::UninitializedVector<double> slitWidths; ///< of polygons
  winding::UninitializedVector<std::int64_t> lineOffsets, lineCorners;
  winding::UninitializedVector<std::int64_t> vertexOffsets, vertexCorners;
  winding::UninitializedVector<std::uint8_t> colors;
  int colorComponents = 0;
  winding::UninitializedVector<float> textureCoordinates;
  std::int64_t filledCavities = 0, parts = 0;
  std::uint8_t isClosed = 0;
  double volume = std::numeric_limits<double>::quiet_NaN();
  double inputVolume = std::numeric_limits<double>::quiet_NaN();
  std::string solidInWords;
  winding::UninitializedVector<std::uint8_t> inside; ///< of samples

  ///@{
  /// The distances that a surface was made to have: from a tree of its own, or from the source.
  int distancesFrom = WINDING_DISTANCES_FROM_NOTHING;
  winding::DistanceBand distances;
  std::shared_ptr<const winding::DistanceTree> distanceTree;
  ///@}

  /// A column of a table: numbers, or texts.
  struct Column
  {
    std::string name;
    std::vector<double> numbers;
    std::vector<std::string> texts;
    std::vector<const char*> pointers; ///< to the texts, once they stay where they are
  };
  std::vector<Column> columns;

  /// Regions of one kind.
  struct Regions
  {
    const char* kind;
    std::vector<std::string> names;
    std::vector<const char*> pointers; ///< to the names, once they stay where they are
    winding::UninitializedVector<std::int32_t> ofPolygon;
  };
  std::vector<Regions> regions;
};

namespace winding::c
{

/// Returns the numbers, or null where there are none.
template <class Number> const Number* pointerTo(const UninitializedVector<Number>& numbers)
{
  return numbers.empty() ? nullptr : numbers.data();
}

/// Makes a handle, and gives it to a caller once `fillIn` has filled it.
template <class Handle, class FillIn> void giveHandle(Handle*& to, const FillIn& fillIn)
{
  auto handle = std::make_unique<Handle>();
  fillIn(*handle);
  to = handle.release();
}

} // namespace winding::c
