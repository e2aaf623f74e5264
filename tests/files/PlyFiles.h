// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/Parsing.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

/**
 * @file
 * Files of PLY as tests make them, in each of its formats.
 */
namespace plyfiles
{

using winding::MeshArrays;

constexpr const char* formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};

/// Writes numbers as a format has them.
class Body
{
public:
  explicit Body(std::string format)
    : format_(std::move(format))
  {
  }

  bool isText() const { return format_ == "ascii"; }

  template <class Number> Body& add(double value)
  {
    if (this->isText())
    {
      char text[40];
      bytes_.append(
        text, static_cast<std::size_t>(std::snprintf(text, sizeof text, "%.17g ", value)));
      return *this;
    }
    const auto number = static_cast<Number>(value);
    char bytes[sizeof number];
    std::memcpy(bytes, &number, sizeof number);
    if (format_ == "binary_big_endian")
    {
      std::reverse(bytes, bytes + sizeof bytes);
    }
    bytes_.append(bytes, sizeof bytes);
    return *this;
  }

  /// By the name of the type in PLY.
  Body& add(const std::string& type, double value)
  {
    return type == "char" || type == "int8"       ? this->add<std::int8_t>(value)
           : type == "uchar" || type == "uint8"   ? this->add<std::uint8_t>(value)
           : type == "short" || type == "int16"   ? this->add<std::int16_t>(value)
           : type == "ushort" || type == "uint16" ? this->add<std::uint16_t>(value)
           : type == "int" || type == "int32"     ? this->add<std::int32_t>(value)
           : type == "uint" || type == "uint32"   ? this->add<std::uint32_t>(value)
           : type == "float" || type == "float32" ? this->add<float>(value)
                                                  : this->add<double>(value);
  }

  /// A list behind its length.
  Body& addList(const std::string& lengthType, const std::string& type, const Ids& values)
  {
    this->add(lengthType, static_cast<double>(values.size()));
    for (const std::int64_t value : values)
    {
      this->add(type, static_cast<double>(value));
    }
    return *this;
  }

  Body& endItem()
  {
    bytes_ += this->isText() ? "\n" : "";
    return *this;
  }

  const std::string& bytes() const { return bytes_; }

private:
  std::string format_, bytes_;
};

inline std::string head(const std::string& format, const std::string& elements)
{
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
}

inline std::string vertexHead(std::size_t count, const std::string& type = "float")
{
  const std::string property = "property " + type + " ";
  return "element vertex " + std::to_string(count) + "\n" + property + "x\n" + property + "y\n" +
         property + "z\n";
}

inline std::string faceHead(
  std::size_t count, const std::string& lengthType = "uchar", const std::string& type = "int")
{
  return "element face " + std::to_string(count) + "\nproperty list " + lengthType + " " + type +
         " vertex_indices\n";
}

/// A file of vertices (i, 2 i, 3 i) and of some faces.
inline std::string meshFile(
  const std::string& format, std::size_t vertices, const std::vector<Ids>& faces)
{
  Body body(format);
  for (std::size_t i = 0; i < vertices; ++i)
  {
    for (const double factor : {1.0, 2.0, 3.0})
    {
      body.add<float>(factor * static_cast<double>(i));
    }
    body.endItem();
  }
  for (const Ids& face : faces)
  {
    body.addList("uchar", "int", face).endItem();
  }
  return head(format, vertexHead(vertices) + faceHead(faces.size())) + body.bytes();
}

inline std::vector<double> pointsOf(const MeshArrays& mesh)
{
  return mesh.points.doubles.empty()
           ? std::vector<double>(mesh.points.floats.begin(), mesh.points.floats.end())
           : vectorOf(mesh.points.doubles);
}

} // namespace plyfiles
