// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/MeshFile.h"

#include "files/Text.h"
#include "output/OutputFile.h"
#include "program/Interrupt.h"
#include "program/Print.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{

bool areColors(vtkDataArray* array)
{
  return array && array->GetDataType() == VTK_UNSIGNED_CHAR &&
         (array->GetNumberOfComponents() == 3 || array->GetNumberOfComponents() == 4);
}

/// Returns the colours of points or cells: the active scalars if they are some, else the first
/// array of some; null without.
vtkDataArray* colorsOf(vtkDataSetAttributes* attributes)
{
  if (areColors(attributes->GetScalars()))
  {
    return attributes->GetScalars();
  }
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    if (areColors(attributes->GetArray(i)))
    {
      return attributes->GetArray(i);
    }
  }
  return nullptr;
}

/// Whether colours have an alpha that is not full everywhere.
bool isTransparent(vtkDataArray* array)
{
  constexpr int alpha = 3;
  constexpr double full = 255;
  return areColors(array) && array->GetNumberOfComponents() > alpha &&
         array->GetNumberOfTuples() > 0 && array->GetRange(alpha)[0] < full;
}

vtkDataArray* textureOf(vtkPolyData* mesh)
{
  vtkDataArray* const coordinates = mesh->GetPointData()->GetTCoords();
  return coordinates && coordinates->GetNumberOfComponents() == 2 ? coordinates : nullptr;
}

/// Regions of the faces, as .obj has them.
struct Regions
{
  const char* kind;
  const char* statement;
};

constexpr Regions regionsOfObj[] = {{"Object", "o"}, {"Group", "g"}, {"Material", "usemtl"}};

vtkDataArray* idsOf(vtkPolyData* mesh, const Regions& regions)
{
  return mesh->GetCellData()->GetArray((std::string(regions.kind) + "Ids").c_str());
}

/// Returns the names of regions: "GroupNames" for "GroupIds". Null without.
vtkStringArray* namesOf(vtkPolyData* mesh, const char* ids)
{
  const std::string name = ids ? ids : "", ending = "Ids";
  const std::size_t size = name.size() - std::min(name.size(), ending.size());
  return name.substr(size) == ending
           ? vtkStringArray::SafeDownCast(
               mesh->GetFieldData()->GetAbstractArray((name.substr(0, size) + "Names").c_str()))
           : nullptr;
}

/// Writes items in parts, and looks for interruptions now and then.
template <class Append> void writeEach(vtkIdType count, std::ofstream& stream, const Append& append)
{
  constexpr vtkIdType itemsAtOnce = 16384;
  std::string bytes;
  for (vtkIdType i = 0; i < count; ++i)
  {
    append(i, bytes);
    if ((i + 1) % itemsAtOnce == 0 || i + 1 == count)
    {
      stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
      bytes.clear();
      interrupt::check();
    }
  }
}

void close(std::ofstream& stream, const OutputFile& file)
{
  stream.close();
  if (!stream)
  {
    file.refuseWriting();
  }
}

template <class Number> void append(std::string& bytes, Number number)
{
  char own[sizeof number];
  std::memcpy(own, &number, sizeof number);
  bytes.append(own, sizeof number);
}

/// Returns a mesh with triangles in place of its strips.
vtkSmartPointer<vtkPolyData> withoutStrips(vtkPolyData* mesh)
{
  if (mesh->GetNumberOfStrips() == 0)
  {
    return mesh;
  }
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mesh);
  triangles->Update();
  return triangles->GetOutput();
}

/// The types of numbers in PLY that are written.
enum class PlyType
{
  byte,
  integer,
  single,
  real
};

/// A property of vertices or faces in PLY.
struct Property
{
  std::string name;
  vtkDataArray* array;
  int component;
  PlyType type;

  void append(vtkIdType item, std::string& bytes) const
  {
    const double value = array->GetComponent(item, component);
    switch (type)
    {
    case PlyType::byte:
      ::append(bytes, static_cast<std::uint8_t>(value));
      break;
    case PlyType::integer:
      ::append(bytes, static_cast<std::int32_t>(value));
      break;
    case PlyType::single:
      ::append(bytes, static_cast<float>(value));
      break;
    case PlyType::real:
      ::append(bytes, value);
      break;
    }
  }
};

/// Returns the type that holds all values of an array of single numbers.
PlyType typeFor(vtkDataArray* array)
{
  const int type = array->GetDataType();
  if (type == VTK_FLOAT)
  {
    return PlyType::single;
  }
  if (type == VTK_DOUBLE)
  {
    return PlyType::real;
  }
  if (type == VTK_UNSIGNED_CHAR)
  {
    return PlyType::byte;
  }
  const double* const range = array->GetRange();
  using Limits = std::numeric_limits<std::int32_t>;
  return range[0] >= Limits::min() && range[1] <= Limits::max() ? PlyType::integer : PlyType::real;
}

/// Collects the properties of vertices or of faces, whose names differ.
class Properties
{
public:
  explicit Properties(std::set<std::string> taken)
    : taken_(std::move(taken))
  {
  }

  void add(vtkDataArray* array, const std::vector<const char*>& names, PlyType type)
  {
    for (std::size_t i = 0; array && i < names.size(); ++i)
    {
      all_.push_back({this->nameFor(names[i]), array, static_cast<int>(i), type});
    }
  }

  /// Adds normals, colours and texture coordinates, and all other single numbers.
  void addAll(vtkDataSetAttributes* attributes, vtkDataArray* normals, vtkDataArray* texture)
  {
    this->add(normals, {"nx", "ny", "nz"}, PlyType::single);
    vtkDataArray* const colors = colorsOf(attributes);
    std::vector<const char*> names = {"red", "green", "blue", "alpha"};
    names.resize(static_cast<std::size_t>(colors ? colors->GetNumberOfComponents() : 0));
    this->add(colors, names, PlyType::byte);
    this->add(texture, {"texture_u", "texture_v"}, PlyType::single);
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* const array = attributes->GetArray(i);
      if (array && array->GetNumberOfComponents() == 1 && array->GetName())
      {
        this->add(array, {array->GetName()}, typeFor(array));
      }
    }
  }

  const std::vector<Property>& all() const { return all_; }

  void writeHeader(std::ostream& stream) const
  {
    constexpr const char* types[] = {"uchar", "int", "float", "double"};
    for (const Property& property : all_)
    {
      stream << "property " << types[static_cast<int>(property.type)] << ' ' << property.name
             << '\n';
    }
  }

private:
  /// Returns a name of letters that headers have, which no property has yet.
  std::string nameFor(std::string name)
  {
    std::replace_if(
      name.begin(), name.end(), [](char c) { return c <= ' ' || c > '~'; }, '_');
    while (name.empty() || !taken_.insert(name).second)
    {
      name += "_input";
    }
    return name;
  }

  std::set<std::string> taken_;
  std::vector<Property> all_;
};

/// The colours of vertices in .obj, as " 0.502", for each byte.
std::vector<std::string> sharesOfBytes()
{
  constexpr int bytes = 256;
  std::vector<std::string> shares;
  for (int byte = 0; byte < bytes; ++byte)
  {
    shares.push_back(' ' + shown(byte / (bytes - 1.0), 4));
  }
  return shares;
}

void appendTuple(std::string& text, vtkDataArray* array, vtkIdType tuple)
{
  for (int component = 0; component < array->GetNumberOfComponents(); ++component)
  {
    text += ' ';
    appendExact(text, array->GetComponent(tuple, component));
  }
}

/// Makes the statements of cells, whose corners have numbers from 1 on.
class ObjCells
{
public:
  ObjCells(vtkPolyData* mesh, bool hasTexture, bool hasNormals)
    : hasTexture_(hasTexture)
    , hasNormals_(hasNormals)
  {
    for (const Regions& regions : regionsOfObj)
    {
      vtkDataArray* const ids = idsOf(mesh, regions);
      if (ids && ids->GetNumberOfComponents() == 1)
      {
        divisions_.push_back({regions.statement, ids, namesOf(mesh, ids->GetName()), std::nan("")});
      }
    }
  }

  /// Appends a face, behind the statements of the regions that it begins.
  void appendFace(vtkIdType cell, vtkIdType size, const vtkIdType* ids, std::string& text)
  {
    for (Division& division : divisions_)
    {
      const double region = division.ids->GetComponent(cell, 0);
      if (region != division.last)
      {
        division.last = region;
        const auto number = static_cast<vtkIdType>(region);
        const bool isNamed =
          division.names && number >= 0 && number < division.names->GetNumberOfValues();
        text += std::string(division.statement) + ' ' +
                (isNamed ? std::string(division.names->GetValue(number)) : exact(region)) + '\n';
      }
    }
    this->appendCell('f', size, ids, text);
  }

  void appendCell(char statement, vtkIdType size, const vtkIdType* ids, std::string& text) const
  {
    text += statement;
    for (vtkIdType i = 0; i < size; ++i)
    {
      const std::string number = std::to_string(ids[i] + 1);
      text += ' ' + number;
      if (statement == 'f' && (hasTexture_ || hasNormals_))
      {
        text += '/' + (hasTexture_ ? number : "") + (hasNormals_ ? '/' + number : "");
      }
    }
    text += '\n';
  }

private:
  /// A division of the faces into regions.
  struct Division
  {
    const char* statement;
    vtkDataArray* ids;
    vtkStringArray* names; ///< may be null
    double last;           ///< region of the face before
  };

  bool hasTexture_, hasNormals_;
  std::vector<Division> divisions_;
};

} // namespace

std::vector<std::string> arraysLostIn(const std::string& suffix, vtkPolyData* mesh)
{
  std::vector<std::string> lost;
  const auto note = [&](const std::string& what)
  {
    if (std::find(lost.begin(), lost.end(), what) == lost.end())
    {
      lost.push_back(what);
    }
  };
  const bool isPly = suffix == ".ply", isObj = suffix == ".obj";
  for (vtkDataSetAttributes* attributes : {static_cast<vtkDataSetAttributes*>(mesh->GetPointData()),
         static_cast<vtkDataSetAttributes*>(mesh->GetCellData())})
  {
    const bool ofPoints = attributes == mesh->GetPointData();
    for (int i = 0; i < attributes->GetNumberOfArrays() && suffix != ".vtp"; ++i)
    {
      vtkAbstractArray* const array = attributes->GetAbstractArray(i);
      vtkDataArray* const numbers = vtkDataArray::SafeDownCast(array);
      bool isKept = array == attributes->GetNormals();
      isKept |= (isPly || (isObj && ofPoints)) && numbers && numbers == colorsOf(attributes);
      isKept |= (isPly || isObj) && ofPoints && numbers && numbers == textureOf(mesh);
      isKept |= isPly && numbers && numbers->GetNumberOfComponents() == 1;
      for (const Regions& regions : regionsOfObj)
      {
        isKept |= isObj && !ofPoints && numbers && numbers == idsOf(mesh, regions);
      }
      if (!isKept && array->GetName())
      {
        note(array->GetName());
      }
      else if (isObj && ofPoints && isTransparent(numbers) && array->GetName())
      {
        note("alpha of " + std::string(array->GetName()));
      }
      else if (isPly && namesOf(mesh, array->GetName()))
      {
        note(namesOf(mesh, array->GetName())->GetName());
      }
    }
  }
  return lost;
}

void writePlyMesh(vtkPolyData* given, OutputFile& file)
{
  const vtkSmartPointer<vtkPolyData> mesh = withoutStrips(given);
  Properties ofVertices({"x", "y", "z"}), ofFaces({"vertex_indices"});
  ofVertices.addAll(mesh->GetPointData(), mesh->GetPointData()->GetNormals(), textureOf(mesh));
  ofFaces.addAll(mesh->GetCellData(), nullptr, nullptr);
  const std::uint16_t one = 1;
  unsigned char firstByte;
  std::memcpy(&firstByte, &one, 1);
  vtkCellArray* const faces = mesh->GetPolys();
  constexpr vtkIdType mostInByte = 255;
  const bool areLarge = faces->GetMaxCellSize() > mostInByte;
  std::ofstream stream(file.temporaryName(), std::ios::binary);
  stream << "ply\nformat binary_" << (firstByte == 1 ? "little" : "big")
         << "_endian 1.0\nelement vertex " << mesh->GetNumberOfPoints() << '\n';
  for (const char* name : {"x", "y", "z"})
  {
    stream << "property float " << name << '\n';
  }
  ofVertices.writeHeader(stream);
  stream << "element face " << faces->GetNumberOfCells() << "\nproperty list "
         << (areLarge ? "int" : "uchar") << " int vertex_indices\n";
  ofFaces.writeHeader(stream);
  stream << "end_header\n";
  writeEach(mesh->GetNumberOfPoints(), stream,
    [&](vtkIdType point, std::string& bytes)
    {
      double position[3];
      mesh->GetPoint(point, position);
      for (const double coordinate : position)
      {
        append(bytes, static_cast<float>(coordinate));
      }
      for (const Property& property : ofVertices.all())
      {
        property.append(point, bytes);
      }
    });
  const vtkIdType firstFace = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  writeEach(faces->GetNumberOfCells(), stream,
    [&](vtkIdType face, std::string& bytes)
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      faces->GetCellAtId(face, size, ids);
      if (areLarge)
      {
        append(bytes, static_cast<std::int32_t>(size));
      }
      else
      {
        append(bytes, static_cast<std::uint8_t>(size));
      }
      for (vtkIdType i = 0; i < size; ++i)
      {
        append(bytes, static_cast<std::int32_t>(ids[i]));
      }
      for (const Property& property : ofFaces.all())
      {
        property.append(firstFace + face, bytes);
      }
    });
  close(stream, file);
}

void writeObjMesh(vtkPolyData* given, OutputFile& file)
{
  const vtkSmartPointer<vtkPolyData> mesh = withoutStrips(given);
  vtkDataArray* const colors = colorsOf(mesh->GetPointData());
  vtkDataArray* const normals = mesh->GetPointData()->GetNormals();
  vtkDataArray* const texture = textureOf(mesh);
  const std::vector<std::string> shares = sharesOfBytes();
  std::ofstream stream(file.temporaryName(), std::ios::binary);
  if (mesh->GetNumberOfPoints() == 0)
  {
    stream << "# no points\n"; // a file without bytes counts as one of a full disk
  }
  writeEach(mesh->GetNumberOfPoints(), stream,
    [&](vtkIdType point, std::string& text)
    {
      double position[3];
      mesh->GetPoint(point, position);
      text += "v " + exact(position, ' ');
      for (int component = 0; colors && component < 3; ++component)
      {
        text += shares[static_cast<std::size_t>(colors->GetComponent(point, component))];
      }
      text += '\n';
    });
  for (const auto& [statement, array] :
    {std::pair<const char*, vtkDataArray*>{"vt", texture}, {"vn", normals}})
  {
    writeEach(array ? array->GetNumberOfTuples() : 0, stream,
      [&, keyword = statement, numbers = array](vtkIdType point, std::string& text)
      {
        text += keyword;
        appendTuple(text, numbers, point);
        text += '\n';
      });
  }
  ObjCells cells(mesh, texture != nullptr, normals != nullptr);
  const vtkIdType firstFace = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  const std::pair<char, vtkCellArray*> kinds[] = {
    {'p', mesh->GetVerts()}, {'l', mesh->GetLines()}, {'f', mesh->GetPolys()}};
  for (const auto& [statement, ofKind] : kinds)
  {
    writeEach(ofKind->GetNumberOfCells(), stream,
      [&, kind = statement, array = ofKind](vtkIdType cell, std::string& text)
      {
        vtkIdType size = 0;
        const vtkIdType* ids = nullptr;
        array->GetCellAtId(cell, size, ids);
        if (kind == 'f')
        {
          cells.appendFace(firstFace + cell, size, ids, text);
        }
        else
        {
          cells.appendCell(kind, size, ids, text);
        }
      });
  }
  close(stream, file);
}
