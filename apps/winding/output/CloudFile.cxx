// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/CloudFile.h"

#include "files/Formats.h"
#include "files/Text.h"
#include "output/OutputFile.h"
#include "output/WriteOutput.h"
#include "program/Interrupt.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace
{

/// Calls write(tuple) for all tuples of an array, and looks for interruptions now and then.
template <class Write> void forEachTuple(vtkDataArray* array, const Write& write)
{
  constexpr vtkIdType tuplesPerLook = 65536;
  double tuple[3];
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    array->GetTuple(i, tuple);
    write(i, tuple);
    if (i % tuplesPerLook == 0)
    {
      interrupt::check();
    }
  }
}

/// Positions and normals, line by line.
void writeLines(vtkDataArray* positions, vtkDataArray* normals, std::ofstream& stream)
{
  forEachTuple(positions,
    [&](vtkIdType point, const double position[3])
    {
      double normal[3];
      normals->GetTuple(point, normal);
      stream << exact(position, ' ') << ' ' << exact(normal, ' ') << '\n';
    });
}

/// The number of points, all positions, then all normals.
void writeParts(vtkDataArray* positions, vtkDataArray* normals, std::ofstream& stream)
{
  stream << positions->GetNumberOfTuples() << '\n';
  for (vtkDataArray* part : {positions, normals})
  {
    forEachTuple(
      part, [&stream](vtkIdType, const double vector[3]) { stream << exact(vector, ' ') << '\n'; });
  }
}

/// A column that the points came with, one component of an array.
struct Column
{
  std::string name;
  vtkAbstractArray* array;
  int component;

  vtkDataArray* numbers() const { return vtkDataArray::SafeDownCast(array); }
};

/// Returns the columns of all arrays but normals and areas. Their names differ from `taken`, which
/// are in small letters, and from each other.
std::vector<Column> otherColumns(vtkPolyData* cloud, std::set<std::string> taken)
{
  const char* const colors[] = {"red", "green", "blue", "alpha"};
  const char* const texture[] = {"s", "t"};
  vtkPointData* const arrays = cloud->GetPointData();
  std::vector<Column> columns;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = arrays->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    const int components = array->GetNumberOfComponents();
    if (array == arrays->GetNormals() || name == "Area")
    {
      continue;
    }
    const bool areColors =
      array->GetDataType() == VTK_UNSIGNED_CHAR && (components == 3 || components == 4);
    for (int component = 0; component < components; ++component)
    {
      std::string own = areColors                                          ? colors[component]
                        : array == arrays->GetTCoords() && components == 2 ? texture[component]
                        : components == 1                                  ? name
                                          : name + ":" + std::to_string(component);
      while (own.empty() || !taken.insert(inSmallLetters(own)).second)
      {
        own += "_input";
      }
      columns.push_back({own, array, component});
    }
  }
  return columns;
}

std::string fieldOf(const Column& column, vtkIdType point, char separator)
{
  if (vtkDataArray* const numbers = column.numbers())
  {
    return exact(numbers->GetComponent(point, column.component));
  }
  const vtkIdType place = point * column.array->GetNumberOfComponents() + column.component;
  return asField(column.array->GetVariantValue(place).ToString(), separator);
}

void writeTable(vtkPolyData* cloud, char separator, std::ofstream& stream)
{
  vtkDataArray* const normals = cloud->GetPointData()->GetNormals();
  vtkDataArray* const areas = cloud->GetPointData()->GetArray("Area");
  const std::vector<Column> columns =
    otherColumns(cloud, {"x", "y", "z", "nx", "ny", "nz", "area"});
  for (const char* name : {"x", "y", "z", "nx", "ny"})
  {
    stream << name << separator;
  }
  stream << "nz";
  if (areas)
  {
    stream << separator << "area";
  }
  for (const Column& column : columns)
  {
    stream << separator << asField(column.name, separator);
  }
  stream << '\n';
  forEachTuple(cloud->GetPoints()->GetData(),
    [&](vtkIdType point, const double position[3])
    {
      double normal[3];
      normals->GetTuple(point, normal);
      stream << exact(position, separator) << separator << exact(normal, separator);
      if (areas)
      {
        stream << separator << exact(areas->GetTuple1(point));
      }
      for (const Column& column : columns)
      {
        stream << separator << fieldOf(column, point, separator);
      }
      stream << '\n';
    });
}

bool isFloat(vtkDataArray* array)
{
  return array->GetDataType() == VTK_FLOAT;
}

template <class Number> void append(std::string& bytes, Number number)
{
  char own[sizeof number];
  std::memcpy(own, &number, sizeof number);
  bytes.append(own, sizeof number);
}

void append(std::string& bytes, const double vector[3], bool asFloat)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (asFloat)
    {
      append(bytes, static_cast<float>(vector[axis]));
    }
    else
    {
      append(bytes, vector[axis]);
    }
  }
}

/// A property of points in PLY.
struct Property
{
  Column column;
  bool isByte;
};

/// Whether all values are whole numbers that a byte holds.
bool fitBytes(const Column& column)
{
  bool fit = true;
  vtkDataArray* const numbers = column.numbers();
  for (vtkIdType i = 0; i < numbers->GetNumberOfTuples() && fit; ++i)
  {
    const double value = numbers->GetComponent(i, column.component);
    fit = value >= 0 && value <= 255 && value == std::floor(value);
  }
  return fit;
}

/// Returns the name of PLY for a colour called red, r and so on; empty for other names.
std::string colorOf(const std::string& name)
{
  const std::map<std::string, std::string> colors = {{"r", "red"}, {"g", "green"}, {"b", "blue"},
    {"red", "red"}, {"green", "green"}, {"blue", "blue"}, {"alpha", "alpha"}};
  const auto found = colors.find(inSmallLetters(name));
  return found == colors.end() ? "" : found->second;
}

/// Returns whether columns are a colour of bytes: red, green and blue, once each, and alpha or not.
bool areColorOfBytes(const std::vector<Column>& columns)
{
  std::multiset<std::string> colors;
  for (const Column& column : columns)
  {
    const std::string color = column.numbers() ? colorOf(column.name) : "";
    if (!color.empty() && !fitBytes(column))
    {
      return false;
    }
    colors.insert(color);
  }
  return colors.count("red") == 1 && colors.count("green") == 1 && colors.count("blue") == 1 &&
         colors.count("alpha") <= 1;
}

/// Returns the properties that points came with, by names that differ.
std::vector<Property> otherProperties(vtkPolyData* cloud)
{
  std::set<std::string> taken = {"x", "y", "z", "nx", "ny", "nz"};
  const std::vector<Column> columns = otherColumns(cloud, taken);
  const bool haveColor = areColorOfBytes(columns);
  std::vector<Property> properties;
  for (Column column : columns)
  {
    if (!column.numbers())
    {
      continue; // PLY has no texts
    }
    const std::string color = haveColor ? colorOf(column.name) : "";
    column.name = color.empty() ? column.name : color;
    std::replace_if(
      column.name.begin(), column.name.end(), [](char c) { return c <= ' ' || c > '~'; }, '_');
    while (!taken.insert(column.name).second)
    {
      column.name += "_input";
    }
    properties.push_back(
      {column, !color.empty() || column.numbers()->GetDataType() == VTK_UNSIGNED_CHAR});
  }
  return properties;
}

void writePly(vtkPolyData* cloud, std::ofstream& stream)
{
  vtkDataArray* const positions = cloud->GetPoints()->GetData();
  vtkDataArray* const normals = cloud->GetPointData()->GetNormals();
  const std::vector<Property> properties = otherProperties(cloud);
  const std::uint16_t one = 1;
  unsigned char firstByte;
  std::memcpy(&firstByte, &one, 1);
  stream << "ply\nformat binary_" << (firstByte == 1 ? "little" : "big")
         << "_endian 1.0\nelement vertex " << positions->GetNumberOfTuples() << '\n';
  for (const char* name : {"x", "y", "z"})
  {
    stream << "property " << (isFloat(positions) ? "float " : "double ") << name << '\n';
  }
  for (const char* name : {"nx", "ny", "nz"})
  {
    stream << "property " << (isFloat(normals) ? "float " : "double ") << name << '\n';
  }
  for (const Property& property : properties)
  {
    stream << "property " << (property.isByte ? "uchar " : "double ") << property.column.name
           << '\n';
  }
  stream << "end_header\n";
  std::string bytes;
  forEachTuple(positions,
    [&](vtkIdType point, const double position[3])
    {
      double normal[3];
      normals->GetTuple(point, normal);
      bytes.clear();
      append(bytes, position, isFloat(positions));
      append(bytes, normal, isFloat(normals));
      for (const Property& property : properties)
      {
        const double value =
          property.column.numbers()->GetComponent(point, property.column.component);
        if (property.isByte)
        {
          append(bytes, static_cast<unsigned char>(value));
        }
        else
        {
          append(bytes, value);
        }
      }
      stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    });
}

} // namespace

void writeCloud(vtkPolyData* cloud, OutputFile& file, Messages& messages)
{
  const std::string suffix = suffixOf(file.name());
  if (suffix == ".vtp" || suffix == ".vtu")
  {
    writePoints(cloud, file, messages);
    return;
  }
  vtkDataArray* const positions = cloud->GetPoints()->GetData();
  vtkDataArray* const normals = cloud->GetPointData()->GetNormals();
  std::ofstream stream(file.temporaryName(), std::ios::binary);
  if (suffix == ".ply")
  {
    writePly(cloud, stream);
  }
  else if (suffix == ".xyz")
  {
    writeLines(positions, normals, stream);
  }
  else if (suffix == ".pwn")
  {
    writeParts(positions, normals, stream);
  }
  else
  {
    writeTable(cloud, separatorOf(file.name()), stream);
  }
  stream.close();
  if (!stream)
  {
    file.refuseWriting();
  }
}
