// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Images.h"

#include "apps/RunProgram.h"

#include "vtk_zlib.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>

namespace
{

using Vector = std::array<double, 3>;

// A quaternion of (1, 2, 3, 4) / √30, the third axis mirrored.
constexpr double steps[3] = {0.25, 0.3, 0.35};
constexpr std::array<int, 3> dimensions = {7, 8, 9};

/// The direction of an axis: columns of the matrix of the quaternion.
Vector direction(std::size_t axis)
{
  constexpr double a = 1, b = 2, c = 3, d = 4, square = 30;
  const Vector columns[3] = {
    {a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
    {2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b)},
    {-2 * (b * d + a * c), -2 * (c * d - a * b), -(a * a + d * d - b * b - c * c)}};
  return {columns[axis][0] / square, columns[axis][1] / square, columns[axis][2] / square};
}

Vector step(std::size_t axis)
{
  const Vector along = direction(axis);
  return {along[0] * steps[axis], along[1] * steps[axis], along[2] * steps[axis]};
}

std::string words(const Vector& vector, const char* between)
{
  std::ostringstream text;
  text.precision(17);
  text << vector[0] << between << vector[1] << between << vector[2];
  return text.str();
}

/// Puts a number into a header, from its last byte on if `isSwapped`.
template <class Number> void put(std::string& header, std::size_t at, Number number, bool isSwapped)
{
  auto* const bytes = reinterpret_cast<char*>(&number);
  if (isSwapped)
  {
    std::reverse(bytes, bytes + sizeof number);
  }
  header.replace(at, sizeof number, bytes, sizeof number);
}

std::string asNifti2()
{
  std::string header(544, '\0');
  put<std::int32_t>(header, 0, 540, false);
  header.replace(4, 8, "n+2\0\r\n\x1a\n", 8);
  put<std::int64_t>(header, 16, 3, false);
  put<std::int32_t>(header, 348, 1, false);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    put<std::int64_t>(header, 24 + 8 * axis, dimensions[axis], false);
    put<double>(header, 112 + 8 * axis, steps[axis], false);
    for (std::size_t row = 0; row < 3; ++row)
    {
      put<double>(header, 400 + 32 * row + 8 * axis, step(axis)[row], false);
    }
    put<double>(header, 424 + 32 * axis, voxelOfHead({0, 0, 0})[axis], false);
  }
  return header;
}

std::string grid(const std::string& type, const std::string& inside)
{
  return "<VTKFile type=\"" + type + "\" version=\"1.0\"><" + type +
         " WholeExtent=\"0 1 0 1 0 1\"><Piece Extent=\"0 1 0 1 0 1\">" + inside + "</Piece></" +
         type + "></VTKFile>\n";
}

std::string doubles(const std::string& values, int components)
{
  return "<DataArray type=\"Float64\" Name=\"a\" NumberOfComponents=\"" +
         std::to_string(components) + "\" format=\"ascii\">" + values + "</DataArray>";
}

} // namespace

std::array<double, 3> voxelOfHead(const std::array<int, 3>& index)
{
  Vector place = {};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (std::size_t row = 0; row < 3; ++row)
    {
      place[row] += (index[axis] - (dimensions[axis] - 1) / 2.0) * step(axis)[row];
    }
  }
  return place;
}

std::string asMetaImage()
{
  return "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
         "CompressedData = False\nTransformMatrix = " +
         words(direction(0), " ") + ' ' + words(direction(1), " ") + ' ' +
         words(direction(2), " ") + "\nOffset = " + words(voxelOfHead({0, 0, 0}), " ") +
         "\nCenterOfRotation = 0 0 0\nAnatomicalOrientation = RAI\nElementSpacing = 0.25 0.3 "
         "0.35\nDimSize = 7 8 9\nElementType = MET_SHORT\nElementDataFile = LOCAL\n";
}

std::string asNrrd(
  const std::string& space, const std::string& sizes, const std::string& firstDirections)
{
  const auto axes = std::count(sizes.begin(), sizes.end(), ' ') + 1;
  std::string text = "NRRD0005\n# made by hand\ntype: short\ndimension: " + std::to_string(axes);
  text += space.empty() ? "\nspace dimension: 3" : "\nspace: " + space;
  text += "\nsizes: " + sizes + "\nspace directions: " + firstDirections;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    text += "(" + words(step(axis), ",") + ") ";
  }
  return text + "\nkinds: domain domain domain\nendian: little\nencoding: raw\nspace origin: (" +
         words(voxelOfHead({0, 0, 0}), ",") + ")\n\n";
}

std::string asNifti(NiftiKind kind)
{
  if (kind == NiftiKind::wide)
  {
    return asNifti2();
  }
  const bool isSwapped = kind == NiftiKind::bigEndian;
  std::string header(352, '\0');
  put<std::int32_t>(header, 0, 348, isSwapped);
  header.replace(344, 4, "n+1\0", 4);
  put<std::int16_t>(header, 40, 3, isSwapped);
  put<std::int16_t>(header, 252, 1, isSwapped);
  put<std::int16_t>(header, 254, kind == NiftiKind::qform ? 0 : 1, isSwapped);
  put<float>(header, 76, -1, isSwapped); // the third axis is mirrored
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    put<std::int16_t>(
      header, 42 + 2 * axis, static_cast<std::int16_t>(dimensions[axis]), isSwapped);
    put<float>(header, 80 + 4 * axis, static_cast<float>(steps[axis]), isSwapped);
    const auto start = static_cast<float>(voxelOfHead({0, 0, 0})[axis]);
    put<float>(header, 268 + 4 * axis, start, isSwapped);
    put<float>(header, 256 + 4 * axis, static_cast<float>((axis + 2) / std::sqrt(30)), isSwapped);
    put<float>(header, 292 + 16 * axis, start, isSwapped);
    for (std::size_t row = 0; row < 3; ++row)
    {
      put<float>(header, 280 + 16 * row + 4 * axis, static_cast<float>(step(axis)[row]), isSwapped);
    }
  }
  return header;
}

std::string packedByGzip(const std::string& contents)
{
  std::string packed(contents.size() + 1000, '\0');
  z_stream stream = {};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(contents.data()));
  stream.avail_in = static_cast<uInt>(contents.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  constexpr int asGzip = 16;
  deflateInit2(&stream, 1, Z_DEFLATED, asGzip + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  deflate(&stream, Z_FINISH);
  packed.resize(packed.size() - stream.avail_out);
  deflateEnd(&stream);
  return packed;
}

std::string unpackedAny(const std::string& packed, std::size_t most)
{
  std::string result(most, '\0');
  z_stream stream = {};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  constexpr int asAny = 32;
  inflateInit2(&stream, asAny + MAX_WBITS);
  inflate(&stream, Z_FINISH);
  result.resize(result.size() - stream.avail_out);
  inflateEnd(&stream);
  return result;
}

std::string asCurvedGrid()
{
  return grid("StructuredGrid",
    "<Points>" + doubles("0 0 0 2 0 0 0 2 0 3 3 0 0 0 2 2 0 2 0 2 2 3 3 3", 3) + "</Points>");
}

std::string asRectilinearGrid()
{
  return grid("RectilinearGrid",
    "<Coordinates>" + doubles("0 2", 1) + doubles("0 3", 1) + doubles("0 4", 1) + "</Coordinates>");
}

std::string voxelsOf(const std::string& fileName, std::size_t bytes)
{
  const std::string contents = contentsOf(fileName);
  const auto endsWith = [&fileName](const std::string& end)
  {
    return fileName.size() > end.size() &&
           fileName.compare(fileName.size() - end.size(), end.size(), end) == 0;
  };
  if (endsWith(".mha"))
  {
    const std::string last = "ElementDataFile = LOCAL\n";
    const std::string packed = contents.substr(contents.find(last) + last.size());
    const std::string size = "CompressedDataSize = " + std::to_string(packed.size()) + " ";
    EXPECT_NE(contents.find(size), std::string::npos) << contents.substr(0, 300);
    return unpackedAny(packed, bytes);
  }
  if (endsWith(".nrrd"))
  {
    return unpackedAny(contents.substr(contents.find("\n\n") + 2), bytes);
  }
  constexpr std::size_t header = 352;
  return (endsWith(".gz") ? unpackedAny(contents, header + bytes) : contents).substr(header);
}
