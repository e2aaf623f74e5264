// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/PlyBody.h"

#include "base/Progress.h"
#include "files/PlyItems.h"
#include "files/PlyNumbers.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace winding
{

namespace
{

/// Whether single precision holds all numbers of a type.
bool fitsFloat(const PlyProperty* property)
{
  return property->type != PlyNumber::float64 && property->type != PlyNumber::int32 &&
         property->type != PlyNumber::uint32;
}

/// Copies the properties of some items to their places in an array that has the same components.
template <class Number>
void copyParts(
  const std::vector<const PlyProperty*>& parts, const PlyItems& items, PlainArray<Number>& into)
{
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const PlyProperty& part = *parts[i];
    const PlyColumn column = {items.at + items.layout.place(part).offset, items.layout.bytes(),
      items.count, part.type, items.layout.encoding()};
    copyColumn(column, into.data() + parts.size() * items.item + i, parts.size());
  }
}

/// The numbers of vertices or faces that have no meaning here but colours.
class OtherParts
{
public:
  OtherParts(const PlyElement& element, bool withNumbers)
    : color_(element.color())
    , areBytes_(areBytes(color_))
  {
    if (withNumbers)
    {
      others_ = element.others();
    }
  }

  int colorComponents() const { return static_cast<int>(color_.size()); }

  /// Makes arrays for `count` items, which are not set yet.
  void allocate(
    std::size_t count, PlainArray<std::uint8_t>& colors, std::vector<OtherNumbers>& numbers)
  {
    colors = PlainArray<std::uint8_t>(areBytes_ ? color_.size() * count : 0);
    shares_ = PlainArray<float>(areBytes_ ? 0 : color_.size() * count);
    for (OtherNumbers& other : numbers)
    {
      other.numbers = PlainArray<double>(count);
    }
  }

  void copy(
    const PlyItems& items, PlainArray<std::uint8_t>& colors, std::vector<OtherNumbers>& numbers)
  {
    if (areBytes_)
    {
      copyParts(color_, items, colors);
    }
    else
    {
      copyParts(color_, items, shares_);
    }
    for (std::size_t i = 0; i < others_.size(); ++i)
    {
      copyParts({others_[i]}, items, numbers[i].numbers);
    }
  }

  /// Makes bytes of colours that are other numbers, once all are copied.
  void finish(PlainArray<std::uint8_t>& colors) const
  {
    if (!shares_.empty())
    {
      colors = bytesOfColors(shares_, isInteger(color_[0]->type));
    }
  }

private:
  std::vector<const PlyProperty*> color_, others_;
  bool areBytes_;
  PlainArray<float> shares_; ///< colours that are no bytes
};

/// Three properties of vertices that make a vector.
class Vector
{
public:
  /// The vertices need not have it.
  Vector(const PlyElement& vertex, const std::vector<const char*>& names)
    : parts_(vertex.findNumbers(names))
    , areFloats_(std::all_of(parts_.begin(), parts_.end(), fitsFloat))
  {
  }

  /// Arrays that are not set yet.
  VectorArrays arrays(std::size_t count) const
  {
    VectorArrays made;
    if (areFloats_)
    {
      made.floats = PlainArray<float>(parts_.size() * count);
    }
    else
    {
      made.doubles = PlainArray<double>(parts_.size() * count);
    }
    return made;
  }

  void copy(const PlyItems& items, VectorArrays& into) const
  {
    if (areFloats_)
    {
      copyParts(parts_, items, into.floats);
    }
    else
    {
      copyParts(parts_, items, into.doubles);
    }
  }

private:
  std::vector<const PlyProperty*> parts_;
  bool areFloats_;
};

/// Reads the elements one behind the other.
class PlyBinaryParser
{
public:
  PlyBinaryParser(
    const InputFile& file, const PlyHeader& header, const ColumnWishes& wishes, Executor& executor)
    : file_(file)
    , header_(header)
    , wishes_(wishes)
    , executor_(executor)
  {
  }

  MeshArrays run()
  {
    Progress progress(executor_);
    std::size_t start = header_.bytes;
    for (const PlyElement& element : header_.elements)
    {
      const PlyProperty* const list = element.hasFaces() ? element.corners() : nullptr;
      PlyElementReader reader(file_, header_.encoding, element, list, start);
      reader.findEnd();
      progress.set(this->shareAt(start), this->shareAt(reader.end()));
      if (element.role == PlyRole::vertices)
      {
        this->readVertices(reader, element);
      }
      else if (element.hasFaces())
      {
        this->readFaces(reader, element);
      }
      else if (start < reader.end())
      {
        reader.passOver(executor_);
      }
      start = reader.end();
    }
    return std::move(mesh_);
  }

private:
  double shareAt(std::size_t offset) const
  {
    return static_cast<double>(offset) / static_cast<double>(file_.size());
  }

  void readVertices(PlyElementReader& reader, const PlyElement& vertex)
  {
    const Vector position(vertex, plyPosition), normal(vertex, plyNormal);
    OtherParts others(vertex, wishes_.others);
    const std::vector<const PlyProperty*> texture = vertex.textureCoordinates();
    const auto count = static_cast<std::size_t>(vertex.count);
    mesh_.colorComponents = others.colorComponents();
    if (wishes_.others)
    {
      mesh_.others = vertex.namedOthers();
    }
    do
    {
      mesh_.points = position.arrays(count);
      mesh_.normals = normal.arrays(count);
      mesh_.textureCoordinates = PlainArray<float>(texture.size() * count);
      others.allocate(count, mesh_.colors, mesh_.others);
    } while (!reader.read(
      [&](const PlyItems& items)
      {
        position.copy(items, mesh_.points);
        normal.copy(items, mesh_.normals);
        copyParts(texture, items, mesh_.textureCoordinates);
        others.copy(items, mesh_.colors, mesh_.others);
      },
      executor_));
    others.finish(mesh_.colors);
  }

  void readFaces(PlyElementReader& reader, const PlyElement& face)
  {
    CellArrays cells;
    const PlyProperty& corners = *face.corners();
    const bool areWanted = wishes_.others && header_.areAllPolygons(face);
    OtherParts others(face, areWanted);
    if (areWanted)
    {
      mesh_.faceNumbers = face.namedOthers();
      mesh_.faceColorComponents = others.colorComponents();
    }
    do
    {
      if (areWanted)
      {
        others.allocate(static_cast<std::size_t>(face.count), mesh_.faceColors, mesh_.faceNumbers);
      }
      cells.offsets = PlainArray<std::int64_t>(static_cast<std::size_t>(face.count) + 1);
      cells.offsets[0] = 0;
      cells.connectivity = PlainArray<std::int64_t>(reader.entries());
    } while (!reader.read(
      [&](const PlyItems& items)
      {
        this->copyFaces(items, corners, cells);
        if (areWanted)
        {
          others.copy(items, mesh_.faceColors, mesh_.faceNumbers);
        }
      },
      executor_));
    if (areWanted)
    {
      others.finish(mesh_.faceColors);
    }
    append(
      mesh_.polygons, face.role == PlyRole::strips ? trianglesOfStrips(cells) : std::move(cells));
  }

  void copyFaces(const PlyItems& items, const PlyProperty& corners, CellArrays& cells) const
  {
    const std::int64_t vertices = header_.vertices().count;
    const auto [offset, length] = items.layout.place(corners);
    const std::size_t step = bytesOf(corners.type);
    std::int64_t* const ids = cells.connectivity.data() + items.entry;
    bool allExist = true;
    if (items.count > 1)
    {
      for (std::size_t i = 0; i < length; ++i)
      {
        const PlyColumn column = {items.at + offset + i * step, items.layout.bytes(), items.count,
          corners.type, header_.encoding};
        allExist &= copyIds(column, ids + i, length, vertices);
      }
    }
    else
    {
      const PlyColumn list = {items.at + offset, step, length, corners.type, header_.encoding};
      allExist = copyIds(list, ids, 1, vertices);
    }
    if (!allExist)
    {
      this->refuseBadCorners(items, corners);
    }
    for (std::size_t i = 0; i < items.count; ++i)
    {
      cells.offsets[items.item + i + 1] = static_cast<std::int64_t>(items.entry + (i + 1) * length);
    }
  }

  /// Refuses the first corner of the items that does not exist, if there is one.
  void refuseBadCorners(const PlyItems& items, const PlyProperty& corners) const
  {
    const std::int64_t vertices = header_.vertices().count;
    const auto [offset, length] = items.layout.place(corners);
    for (std::size_t i = 0; i < items.count; ++i)
    {
      const char* at = items.at + i * items.layout.bytes() + offset;
      for (std::size_t corner = 0; corner < length; ++corner, at += bytesOf(corners.type))
      {
        const double id = plyNumberAt(corners.type, header_.encoding, at);
        if (!isPlyCorner(id, vertices, items.layout.element().role))
        {
          refusePly(file_, badPlyCorner(id, vertices));
        }
      }
    }
  }

  const InputFile& file_;
  const PlyHeader& header_;
  const ColumnWishes& wishes_;
  Executor& executor_;
  MeshArrays mesh_;
};

} // namespace

MeshArrays readPlyBinary(
  const InputFile& file, const PlyHeader& header, const ColumnWishes& wishes, Executor& executor)
{
  return PlyBinaryParser(file, header, wishes, executor).run();
}

} // namespace winding
