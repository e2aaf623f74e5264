// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/InputFile.h"
#include "files/MeshArrays.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace winding
{

/// The number types of PLY.
enum class PlyNumber
{
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  float32,
  float64
};

/// The bytes that a number takes in binary files.
constexpr std::size_t bytesOf(PlyNumber type)
{
  constexpr std::size_t bytes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return bytes[static_cast<std::size_t>(type)];
}

/// Whether numbers of a type are whole.
constexpr bool isInteger(PlyNumber type)
{
  return type != PlyNumber::float32 && type != PlyNumber::float64;
}

/// A property of the items of an element: one number, or a list of them behind its length.
struct PlyProperty
{
  std::string name;
  PlyNumber type = PlyNumber::float32;
  std::optional<PlyNumber> lengthType; ///< type of a list's length; none for single numbers
};

/// The meaning of the items of an element.
enum class PlyRole
{
  vertices,
  faces,
  strips, ///< of triangles
  other   ///< not read
};

/// A number of items with the same properties.
struct PlyElement
{
  std::string name;
  std::int64_t count = 0;
  PlyRole role = PlyRole::other;
  std::vector<PlyProperty> properties;

  /// The first property of this name; null if there is none.
  const PlyProperty* find(const std::string& property) const;

  /// The single numbers of these names; none where any is missing.
  std::vector<const PlyProperty*> findNumbers(const std::vector<const char*>& names) const;

  /// The colour of a vertex or face by any of its usual names: red, green, blue and, where there is
  /// one, alpha, all of integers or all of real numbers; none where they are others.
  std::vector<const PlyProperty*> color() const;

  /// The two texture coordinates of a vertex, by any of their usual names, both whole numbers or
  /// neither; none where there are none.
  std::vector<const PlyProperty*> textureCoordinates() const;

  /// All other single numbers of a vertex or face.
  std::vector<const PlyProperty*> others() const;

  /// The names of these numbers, all different, without the numbers.
  std::vector<OtherNumbers> namedOthers() const;

  /// The list of the vertices of a face or strip: vertex_indices or vertex_index, else the only
  /// list of integers; null if there is none.
  const PlyProperty* corners() const;

  bool hasFaces() const { return role == PlyRole::faces || role == PlyRole::strips; }
};

enum class PlyEncoding
{
  text,
  littleEndian,
  bigEndian
};

inline const std::vector<const char*> plyPosition = {"x", "y", "z"};
inline const std::vector<const char*> plyNormal = {"nx", "ny", "nz"};

/// Whether there are colours, and their numbers are bytes.
bool areBytes(const std::vector<const PlyProperty*>& color);

/// The header of a file: what follows behind it.
struct PlyHeader
{
  PlyEncoding encoding = PlyEncoding::text;
  std::vector<Message> notes;       ///< on elements with geometry that are not read
  std::vector<PlyElement> elements; ///< in the order of the file
  std::size_t bytes = 0;            ///< length of the header
  std::size_t lines = 0;            ///< lines of the header

  /// The element of the vertices, which every header has.
  const PlyElement& vertices() const;

  /// Whether all polygons are the items of an element, which then have its numbers.
  bool areAllPolygons(const PlyElement& element) const;
};

/// Reads the header. Throws FileRefusal where the file is not PLY of version 1.0, promises more
/// items of an element than it has bytes, has items without properties, vertices without x, y and
/// z, or faces without corners.
PlyHeader readPlyHeader(const InputFile& file);

/// Throws a FileRefusal about the file, with what to do about it.
[[noreturn]] void refusePly(const InputFile& file, const std::string& message);

/// Why a list of `length` numbers is refused, where that is no whole number from 0 on.
std::string badPlyLength(double length);

/// Whether a number names one of `vertices` vertices as the corner of a face or strip, or ends the
/// latter.
bool isPlyCorner(double id, std::int64_t vertices, PlyRole role);

/// Why a corner at a vertex of this number is refused, where there are `vertices` vertices.
std::string badPlyCorner(double id, std::int64_t vertices);

} // namespace winding
