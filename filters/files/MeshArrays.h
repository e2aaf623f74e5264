// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Message.h"
#include "files/NamedRegions.h"
#include "files/PlainArray.h"

#include <cstdint>
#include <string>
#include <vector>

namespace winding
{

/// Cells of any size, by the ids of their points from 0 on: cell i has the ids from
/// connectivity[offsets[i]] up to, without, connectivity[offsets[i + 1]].
struct CellArrays
{
  PlainArray<std::int64_t> offsets; ///< one more than there are cells; empty if there are none
  PlainArray<std::int64_t> connectivity;

  std::size_t count() const { return offsets.empty() ? 0 : offsets.size() - 1; }
};

/// One cell of all points, so that they can be seen; none where there are no points.
CellArrays oneCellOf(std::size_t points);

/// Appends cells to others.
void append(CellArrays& cells, CellArrays more);

/// Whether an id ends a strip of triangles, after which another one begins: -1, also without sign.
inline bool endsStrip(double id)
{
  return id == -1 || id == 4294967295.0;
}

/// Returns the triangles of strips, which have the sense of the first one of their strip. Triangles
/// with equal corners, by which strips are connected, are left out.
CellArrays trianglesOfStrips(const CellArrays& strips);

/// Vectors of three components each, one after the other. Only one of the arrays is filled: doubles
/// for what needs their digits, floats for files that hold floats.
struct VectorArrays
{
  PlainArray<double> doubles;
  PlainArray<float> floats;

  std::size_t count() const { return (doubles.size() + floats.size()) / 3; }
};

/// Numbers of points or polygons that mean nothing here, as an intensity.
struct OtherNumbers
{
  std::string name;
  PlainArray<double> numbers; ///< one for each point or polygon
  bool areIntegers = false;   ///< whether the file has no others, as for labels
};

/// Returns the number of full intensity in colours whose largest number is `largest`: 1, 255 or
/// 65535. `areIntegers` says that the type of the numbers holds no fractions.
double intensityOf(double largest, bool areIntegers = false);

/// Returns bytes for colours of any numbers, by intensityOf(). Negative integers count as signed
/// bytes. Other numbers out of range become the nearest byte, and NaN 0.
PlainArray<std::uint8_t> bytesOfColors(const PlainArray<float>& colors, bool areIntegers = false);

/// The content of a file of a mesh or of points, in arrays that can be given away without a copy.
struct MeshArrays
{
  VectorArrays points;
  VectorArrays normals; ///< one for each point, as they are in the file; empty if there are none
  PlainArray<double> areas;             ///< one for each point; empty if there are none
  PlainArray<double> viewpoints;        ///< three for each point; empty if there are none
  PlainArray<std::uint8_t> colors;      ///< colorComponents for each point; empty if there are none
  int colorComponents = 0;              ///< 3, red, green and blue, or 4, and opacity
  PlainArray<float> textureCoordinates; ///< two for each point; empty if there are none
  std::vector<OtherNumbers> others;     ///< in the order of the file, if they are wanted
  PlainArray<std::uint8_t> faceColors;  ///< faceColorComponents for each polygon, if wanted
  int faceColorComponents = 0;          ///< 3 or 4
  std::vector<OtherNumbers> faceNumbers; ///< of the polygons, as `others`
  CellArrays vertices;                   ///< cells of single points or of many
  CellArrays lines;
  CellArrays polygons;
  std::vector<NamedRegions>
    regions;                  ///< of the polygons, for each kind that there is more than one of
  std::vector<Message> notes; ///< on what the file holds and the arrays do not
};

} // namespace winding
