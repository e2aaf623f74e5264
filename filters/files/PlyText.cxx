// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/PlyBody.h"

#include "base/Progress.h"
#include "files/ContentLines.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace winding
{

namespace
{

/// Thrown where faces do not have as many corners as the first one.
struct NotUniform
{
};

const char* const missing = "a number is missing; it is truncated or damaged; give another file";

/// The next number of the present line.
double takeNumber(LineScanner& words)
{
  double value = 0;
  if (!words.tryNumber(value))
  {
    words.refuse(words.wordsLeft() == 0
                   ? missing
                   : "holds something that is no number; it is damaged; give another file");
  }
  return value;
}

/// The next number of the present line as the length of a list.
double takeLength(LineScanner& words)
{
  const double value = takeNumber(words);
  if (!(value >= 0) || value != std::floor(value))
  {
    words.refuse(badPlyLength(value) + "; give another file");
  }
  return value;
}

/// The next number of the present line as the number of corners behind it. More of them than are
/// usual must be there, so that no memory is taken for what is not.
std::size_t takeCorners(LineScanner& words)
{
  constexpr double usual = 255;
  const double value = takeLength(words);
  if (value > usual && value > static_cast<double>(words.wordsLeft()))
  {
    words.refuse(missing);
  }
  return static_cast<std::size_t>(value);
}

void passOver(LineScanner& words, const PlyProperty& property)
{
  const double count = property.lengthType ? takeLength(words) : 1;
  for (double i = 0; i < count; ++i)
  {
    takeNumber(words);
  }
}

/// Where the numbers of a property of all items go: nowhere, or into every n-th place of an
/// array.
class Column
{
public:
  Column() = default;
  Column(double* first, std::size_t step)
    : doubles_(first)
    , step_(step)
  {
  }
  Column(float* first, std::size_t step)
    : floats_(first)
    , step_(step)
  {
  }
  Column(std::uint8_t* first, std::size_t step)
    : bytes_(first)
    , step_(step)
  {
  }

  bool isWanted() const { return step_ > 0; }

  /// Numbers that are no bytes become the nearest ones.
  void set(std::size_t item, double value) const
  {
    if (doubles_)
    {
      doubles_[step_ * item] = value;
    }
    else if (floats_)
    {
      floats_[step_ * item] = static_cast<float>(value);
    }
    else
    {
      bytes_[step_ * item] = static_cast<std::uint8_t>(value > 0 ? std::min(value, 255.0) : 0);
    }
  }

private:
  double* doubles_ = nullptr;
  float* floats_ = nullptr;
  std::uint8_t* bytes_ = nullptr;
  std::size_t step_ = 0;
};

/// Makes columns of some properties, one for each of the element, that lead into new arrays.
class Columns
{
public:
  Columns(const PlyElement& element, std::size_t count)
    : element_(element)
    , count_(count)
    , columns_(element.properties.size())
  {
  }

  const Column& operator[](std::size_t property) const { return columns_[property]; }

  template <class Number>
  void aim(const std::vector<const PlyProperty*>& parts, PlainArray<Number>& numbers)
  {
    numbers = PlainArray<Number>(parts.size() * count_);
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      columns_[static_cast<std::size_t>(parts[i] - element_.properties.data())] =
        Column(numbers.data() + i, parts.size());
    }
  }

  /// Leads colours into `colors` where they are bytes, else into `shares`. Returns the number of
  /// their components.
  int aimColors(PlainArray<std::uint8_t>& colors, PlainArray<float>& shares)
  {
    const std::vector<const PlyProperty*> color = element_.color();
    if (areBytes(color))
    {
      this->aim(color, colors);
    }
    else
    {
      this->aim(color, shares);
    }
    return static_cast<int>(color.size());
  }

  /// Leads all other single numbers into arrays with their names.
  void aimOthers(std::vector<OtherNumbers>& numbers)
  {
    numbers = element_.namedOthers();
    const std::vector<const PlyProperty*> others = element_.others();
    for (std::size_t i = 0; i < others.size(); ++i)
    {
      this->aim({others[i]}, numbers[i].numbers);
    }
  }

  /// Reads the property of an item, or passes over it.
  void read(std::size_t property, std::size_t item, LineScanner& words) const
  {
    if (columns_[property].isWanted())
    {
      columns_[property].set(item, takeNumber(words));
    }
    else
    {
      passOver(words, element_.properties[property]);
    }
  }

private:
  const PlyElement& element_;
  std::size_t count_;
  std::vector<Column> columns_;
};

/// Reads the elements one behind the other.
class PlyTextParser
{
public:
  PlyTextParser(
    const InputFile& file, const PlyHeader& header, const ColumnWishes& wishes, Executor& executor)
    : file_(file)
    , header_(header)
    , wishes_(wishes)
    , executor_(executor)
    , progress_(executor)
    , lines_(this->lines())
  {
  }

  MeshArrays run()
  {
    std::size_t first = header_.lines;
    for (const PlyElement& element : header_.elements)
    {
      const std::size_t last = first + static_cast<std::size_t>(element.count);
      progress_.set(this->shareAt(first), this->shareAt(last));
      // The lines that are there may be at fault, too, and come first.
      const std::size_t there = std::min(last, lines_.count());
      this->readElement(element, first, there);
      if (there < last)
      {
        file_.refuseLine(file_.size() - 1, missing);
      }
      first = last;
    }
    return std::move(mesh_);
  }

private:
  /// The shortest corner is "0 ".
  static constexpr std::size_t bytesPerCorner = 2;

  /// Counting the lines takes the first tenth of the time.
  static constexpr double counting = 0.1;

  ContentLines lines()
  {
    progress_.set(0, counting);
    return ContentLines(file_, executor_);
  }

  double shareAt(std::size_t line) const
  {
    const double part =
      static_cast<double>(std::min(line, lines_.count())) / static_cast<double>(lines_.count());
    return counting + (1 - counting) * part;
  }

  void readElement(const PlyElement& element, std::size_t first, std::size_t last)
  {
    if (element.role == PlyRole::vertices)
    {
      this->readVertices(element, first, last);
    }
    else if (element.hasFaces())
    {
      this->readFaces(element, first, last);
    }
    else
    {
      lines_.visit(
        first, last,
        [&element](std::size_t, ContentLines::Part& part)
        {
          while (part.nextLine())
          {
            for (const PlyProperty& property : element.properties)
            {
              passOver(part.words(), property);
            }
          }
        },
        executor_);
    }
  }

  void readVertices(const PlyElement& vertex, std::size_t first, std::size_t last)
  {
    if (first == last)
    {
      return;
    }
    Columns columns(vertex, last - first);
    PlainArray<float> shares;
    columns.aim(vertex.findNumbers(plyPosition), mesh_.points.doubles);
    columns.aim(vertex.findNumbers(plyNormal), mesh_.normals.doubles);
    columns.aim(vertex.textureCoordinates(), mesh_.textureCoordinates);
    mesh_.colorComponents = columns.aimColors(mesh_.colors, shares);
    if (wishes_.others)
    {
      columns.aimOthers(mesh_.others);
    }
    lines_.visit(
      first, last,
      [&](std::size_t, ContentLines::Part& part)
      {
        while (part.nextLine())
        {
          for (std::size_t i = 0; i < vertex.properties.size(); ++i)
          {
            columns.read(i, part.number() - first, part.words());
          }
        }
      },
      executor_);
    if (!shares.empty())
    {
      mesh_.colors = bytesOfColors(shares, isInteger(vertex.color()[0]->type));
    }
  }

  void readFaces(const PlyElement& face, std::size_t first, std::size_t last)
  {
    if (first == last)
    {
      return;
    }
    CellArrays cells;
    cells.offsets = PlainArray<std::int64_t>(last - first + 1);
    cells.offsets[0] = 0;
    Columns columns(face, last - first);
    PlainArray<float> shares;
    if (wishes_.others && header_.areAllPolygons(face))
    {
      mesh_.faceColorComponents = columns.aimColors(mesh_.faceColors, shares);
      columns.aimOthers(mesh_.faceNumbers);
    }
    try
    {
      this->readUniformFaces(face, first, last, columns, cells);
    }
    catch (const NotUniform&)
    {
      this->readAnyFaces(face, first, last, columns, cells);
    }
    if (!shares.empty())
    {
      mesh_.faceColors = bytesOfColors(shares, isInteger(face.color()[0]->type));
    }
    append(
      mesh_.polygons, face.role == PlyRole::strips ? trianglesOfStrips(cells) : std::move(cells));
  }

  /// Reads faces of as many corners as the first one has. Throws NotUniform if others have others.
  void readUniformFaces(const PlyElement& face, std::size_t first, std::size_t last,
    const Columns& columns, CellArrays& cells)
  {
    std::size_t length = 0;
    lines_.visit(
      first, first + 1,
      [&](std::size_t, ContentLines::Part& part)
      {
        part.nextLine();
        length = this->lengthOf(part.words(), face);
      },
      executor_);
    if (length > file_.size() / bytesPerCorner / (last - first))
    {
      throw NotUniform();
    }
    cells.connectivity = PlainArray<std::int64_t>(length * (last - first));
    lines_.visit(
      first, last,
      [&](std::size_t, ContentLines::Part& part)
      {
        while (part.nextLine())
        {
          const std::size_t entry = length * (part.number() - first);
          this->readFace(part.words(), face, columns, part.number() - first,
            [&](std::size_t corners)
            {
              if (corners != length)
              {
                throw NotUniform();
              }
              return cells.connectivity.data() + entry;
            });
          cells.offsets[part.number() - first + 1] = static_cast<std::int64_t>(entry + length);
        }
      },
      executor_);
  }

  void readAnyFaces(const PlyElement& face, std::size_t first, std::size_t last,
    const Columns& columns, CellArrays& cells)
  {
    const std::vector<std::size_t> starts = this->countCorners(face, first, last);
    cells.connectivity = PlainArray<std::int64_t>(starts.back());
    lines_.visit(
      first, last,
      [&](std::size_t block, ContentLines::Part& part)
      {
        std::size_t entry = starts[block];
        while (part.nextLine())
        {
          this->readFace(part.words(), face, columns, part.number() - first,
            [&](std::size_t corners)
            {
              // The file may have changed since its corners were counted.
              if (corners > starts[block + 1] - entry)
              {
                file_.refuseChanged();
              }
              entry += corners;
              return cells.connectivity.data() + (entry - corners);
            });
          cells.offsets[part.number() - first + 1] = static_cast<std::int64_t>(entry);
        }
        if (entry != starts[block + 1])
        {
          file_.refuseChanged();
        }
      },
      executor_);
  }

  /// The corners of the faces before each block of lines; last, of all.
  std::vector<std::size_t> countCorners(
    const PlyElement& face, std::size_t first, std::size_t last) const
  {
    std::vector<std::size_t> starts(lines_.blocks() + 1);
    lines_.visit(
      first, last,
      [&](std::size_t block, ContentLines::Part& part)
      {
        while (part.nextLine())
        {
          starts[block + 1] += this->lengthOf(part.words(), face);
        }
      },
      executor_);
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    return starts;
  }

  /// The number of corners of the face on the present line, which must hold them.
  std::size_t lengthOf(LineScanner& words, const PlyElement& face) const
  {
    const PlyProperty* const corners = face.corners();
    for (const PlyProperty* property = face.properties.data(); property != corners; ++property)
    {
      passOver(words, *property);
    }
    return takeCorners(words);
  }

  /// Reads the present line. place(corners) gives the array for the ids of its corners.
  template <class Place>
  void readFace(LineScanner& words, const PlyElement& face, const Columns& columns,
    std::size_t item, const Place& place) const
  {
    const std::int64_t vertices = header_.vertices().count;
    const PlyProperty* const list = face.corners();
    for (std::size_t property = 0; property < face.properties.size(); ++property)
    {
      if (&face.properties[property] != list)
      {
        columns.read(property, item, words);
        continue;
      }
      const auto corners = takeCorners(words);
      std::int64_t* const ids = place(corners);
      for (std::size_t i = 0; i < corners; ++i)
      {
        const double id = takeNumber(words);
        if (!isPlyCorner(id, vertices, face.role))
        {
          words.refuse(badPlyCorner(id, vertices) + "; give another file");
        }
        ids[i] = static_cast<std::int64_t>(id);
      }
    }
  }

  const InputFile& file_;
  const PlyHeader& header_;
  const ColumnWishes& wishes_;
  Executor& executor_;
  Progress progress_;
  ContentLines lines_;
  MeshArrays mesh_;
};

} // namespace

MeshArrays readPlyText(
  const InputFile& file, const PlyHeader& header, const ColumnWishes& wishes, Executor& executor)
{
  return PlyTextParser(file, header, wishes, executor).run();
}

} // namespace winding
