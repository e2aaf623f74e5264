// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/PlyHeader.h"

#include "base/Digits.h"
#include "files/ColumnNames.h"
#include "files/Words.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <string_view>

namespace winding
{

namespace
{

/// A number type by its two names.
struct TypeName
{
  const char* name;
  const char* otherName;
  PlyNumber type;
};

constexpr TypeName typeNames[] = {{"char", "int8", PlyNumber::int8},
  {"uchar", "uint8", PlyNumber::uint8}, {"short", "int16", PlyNumber::int16},
  {"ushort", "uint16", PlyNumber::uint16}, {"int", "int32", PlyNumber::int32},
  {"uint", "uint32", PlyNumber::uint32}, {"float", "float32", PlyNumber::float32},
  {"double", "float64", PlyNumber::float64}};

template <class Named>
const Named* findByName(const std::vector<Named>& candidates, const std::string& name)
{
  const auto found = std::find_if(candidates.begin(), candidates.end(),
    [&name](const Named& candidate) { return candidate.name == name; });
  return found == candidates.end() ? nullptr : &*found;
}

/// Whether programs call faces by a name. Cells of a mesh with volume have others.
bool isNameOfFaces(const std::string& name)
{
  const char* const names[] = {"face", "faces", "polygon", "polygons", "facet", "facets",
    "triangle", "triangles", "tri", "quad", "quads"};
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

PlyRole roleOf(const PlyElement& element)
{
  const std::string name = inSmallLetters(element.name);
  if (element.count == 0 || !element.corners())
  {
    return PlyRole::other;
  }
  return isNameOfFaces(name)                       ? PlyRole::faces
         : name.find("strip") != std::string::npos ? PlyRole::strips
                                                   : PlyRole::other;
}

/// Whether an element that is not read has positions, or numbers of vertices.
bool hasGeometry(const PlyElement& element)
{
  return !element.findNumbers(plyPosition).empty() ||
         std::any_of(element.properties.begin(), element.properties.end(),
           [](const PlyProperty& property)
           {
             return property.name.rfind("vertex", 0) == 0 ||
                    (property.lengthType && isInteger(property.type));
           });
}

/// Takes lines off the beginning of a file.
class FirstBytes
{
public:
  explicit FirstBytes(const InputFile& file)
    : file_(file)
  {
    char first[5] = {}; // "ply", and how its line ends
    file.read(0, first, std::min(sizeof first, file.size()));
    endsAtCr_ = first[3] == '\r' && first[4] != '\n';
  }

  /// The next line, without its end. False at the end of the file.
  bool takeLine(std::string& line)
  {
    std::size_t end = text_.find('\n', next_);
    while (end == std::string::npos && read_ < file_.size())
    {
      this->readMore();
      end = text_.find('\n', next_);
    }
    end = std::min(end, text_.size());
    line = text_.substr(next_, end - next_);
    if (!line.empty() && line.back() == '\r')
    {
      line.pop_back();
      end -= endsAtCr_ ? 1 : 0; // LF is the first byte of the data
    }
    const bool isThere = next_ < text_.size();
    next_ = std::min(end + 1, text_.size());
    return isThere;
  }

  /// The place of the next line in the file.
  std::size_t offset() const { return read_ - text_.size() + next_; }

private:
  void readMore()
  {
    text_.erase(0, next_);
    next_ = 0;
    const std::size_t kept = text_.size();
    const std::size_t more = std::min(std::max(bytesAtOnce, kept), file_.size() - read_);
    text_.resize(kept + more);
    file_.readText(read_, &text_[kept], more);
    read_ += more;
  }

  static constexpr std::size_t bytesAtOnce = 1 << 12;

  const InputFile& file_;
  std::string text_;
  bool endsAtCr_;        ///< whether lines of the header end at CR alone
  std::size_t next_ = 0; ///< the next line in the text
  std::size_t read_ = 0; ///< bytes of the file that were read
};

/// Reads the lines of a header one after the other.
class HeaderParser
{
public:
  explicit HeaderParser(const InputFile& file)
    : file_(file)
    , lines_(file)
  {
  }

  PlyHeader run()
  {
    while (!isComplete_)
    {
      if (!lines_.takeLine(line_))
      {
        refusePly(file_, "the header has no end; it is truncated");
      }
      ++header_.lines;
      at_ = line_.data();
      this->readLine();
    }
    header_.bytes = lines_.offset();
    this->check();
    return std::move(header_);
  }

private:
  std::string_view word() { return takeWord(at_, line_.data() + line_.size()); }

  [[noreturn]] void refuseLine(const std::string& message) const
  {
    refusePly(file_, "line " + std::to_string(header_.lines) + ": " + message);
  }

  void readLine()
  {
    const std::string_view keyword = this->word();
    if (header_.lines == 1 && keyword != "ply")
    {
      file_.refuse("is not ply: it does not begin like PLY; give the file a suffix that fits, or "
                   "another file");
    }
    isComplete_ = keyword == "end_header";
    if (keyword == "format")
    {
      this->readFormat();
    }
    else if (keyword == "element")
    {
      this->readElement();
    }
    else if (keyword == "property" && !header_.elements.empty())
    {
      this->readProperty();
    }
    else if (keyword != "ply" && keyword != "comment" && keyword != "obj_info" && !isComplete_)
    {
      this->refuseLine("the header has a line that PLY does not know");
    }
  }

  void readFormat()
  {
    const std::string_view name = this->word();
    if (name != "ascii" && name != "binary_little_endian" && name != "binary_big_endian")
    {
      this->refuseLine("the header names no format that PLY has");
    }
    header_.encoding = name == "ascii"                  ? PlyEncoding::text
                       : name == "binary_little_endian" ? PlyEncoding::littleEndian
                                                        : PlyEncoding::bigEndian;
    hasFormat_ = this->word() == "1.0";
  }

  void readElement()
  {
    PlyElement element;
    element.name = this->word();
    if (!parseInteger(this->word(), element.count) || element.count < 0)
    {
      this->refuseLine("the count of " + element.name + " is no number of items");
    }
    header_.elements.push_back(std::move(element));
  }

  void readProperty()
  {
    PlyProperty property;
    std::string_view type = this->word();
    if (type == "list")
    {
      property.lengthType = this->typeOf(this->word());
      type = this->word();
    }
    property.type = this->typeOf(type);
    property.name = this->word();
    if (property.name.rfind("normal_", 0) == 0 && property.name.size() == 8)
    {
      property.name = std::string("n") + property.name.back(); // as PCL writes nx, ny and nz
    }
    if (property.name.empty())
    {
      this->refuseLine("a property has no name");
    }
    header_.elements.back().properties.push_back(std::move(property));
  }

  PlyNumber typeOf(std::string_view name) const
  {
    for (const TypeName& candidate : typeNames)
    {
      if (name == candidate.name || name == candidate.otherName)
      {
        return candidate.type;
      }
    }
    this->refuseLine("a property has the unknown type " + shown(name));
  }

  void check()
  {
    if (!hasFormat_)
    {
      refusePly(file_, "the header has no format line of version 1.0");
    }
    const PlyElement* const vertex = findByName(header_.elements, "vertex");
    if (!vertex || vertex->findNumbers(plyPosition).empty())
    {
      refusePly(file_, "the header has no vertices with x, y and z");
    }
    for (PlyElement& element : header_.elements)
    {
      if (element.properties.empty() && element.count > 0)
      {
        refusePly(file_, "the header has an element " + element.name + " without properties");
      }
      element.role = &element == vertex ? PlyRole::vertices : roleOf(element);
      if (element.role != PlyRole::other || element.count == 0)
      {
        continue;
      }
      if (isNameOfFaces(inSmallLetters(element.name)))
      {
        file_.refuse("has faces without vertex_indices; give the list of their vertices this name");
      }
      if (hasGeometry(element))
      {
        header_.notes.push_back({"the element " + shown(element.name) + " is not read",
          {{"save faces, if it has the surface", {}}},
          std::to_string(element.count) + " items are passed over"});
      }
    }
    for (const PlyElement& element : header_.elements)
    {
      if (element.count > 0 && static_cast<std::uint64_t>(element.count) > file_.size())
      {
        refusePly(file_, "promises " + std::to_string(element.count) + " items of " + element.name +
                           ", more than it can hold; it is truncated or damaged");
      }
    }
  }

  const InputFile& file_;
  FirstBytes lines_;
  std::string line_;
  const char* at_ = nullptr; ///< the unread rest of the line
  PlyHeader header_;
  bool hasFormat_ = false;
  bool isComplete_ = false;
};

} // namespace

const PlyProperty* PlyElement::find(const std::string& property) const
{
  return findByName(properties, property);
}

std::vector<const PlyProperty*> PlyElement::findNumbers(const std::vector<const char*>& names) const
{
  std::vector<const PlyProperty*> found;
  for (const char* const part : names)
  {
    found.push_back(this->find(part));
    if (!found.back() || found.back()->lengthType)
    {
      return {};
    }
  }
  return found;
}

std::vector<const PlyProperty*> PlyElement::color() const
{
  const std::vector<const char*> names[] = {{"red", "green", "blue", "alpha"},
    {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"}, {"r", "g", "b", "a"}};
  for (std::vector<const char*> parts : names)
  {
    std::vector<const PlyProperty*> found;
    for (; found.empty() && parts.size() >= 3; parts.pop_back())
    {
      found = this->findNumbers(parts);
      const bool areLike = std::all_of(found.begin(), found.end(),
        [&found](const PlyProperty* part)
        { return isInteger(part->type) == isInteger(found[0]->type); });
      found = areLike ? found : std::vector<const PlyProperty*>();
    }
    if (!found.empty())
    {
      return found;
    }
  }
  return {};
}

std::vector<const PlyProperty*> PlyElement::textureCoordinates() const
{
  const std::vector<const char*> names[] = {
    {"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}};
  for (const std::vector<const char*>& pair : names)
  {
    const std::vector<const PlyProperty*> found = this->findNumbers(pair);
    // Others only share their names.
    if (!found.empty() && isInteger(found[0]->type) == isInteger(found[1]->type))
    {
      return found;
    }
  }
  return {};
}

std::vector<const PlyProperty*> PlyElement::others() const
{
  std::set<const PlyProperty*> used;
  for (const auto& known : {this->findNumbers(plyPosition), this->findNumbers(plyNormal),
         this->color(), this->textureCoordinates()})
  {
    used.insert(known.begin(), known.end());
  }
  std::vector<const PlyProperty*> found;
  for (const PlyProperty& property : properties)
  {
    if (!property.lengthType && used.count(&property) == 0)
    {
      found.push_back(&property);
    }
  }
  return found;
}

std::vector<OtherNumbers> PlyElement::namedOthers() const
{
  const std::vector<const PlyProperty*> found = this->others();
  std::vector<std::string> names;
  for (const PlyProperty* const property : found)
  {
    names.push_back(property->name);
  }
  std::vector<std::size_t> numbers(names.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t(0));
  std::vector<OtherNumbers> arrays;
  for (const std::string& own :
    namesOfArrays(numbers, names, {"Normals", "RGB", "RGBA", "TCoords"}))
  {
    arrays.push_back({own, {}, isInteger(found[arrays.size()]->type)});
  }
  return arrays;
}

const PlyProperty* PlyElement::corners() const
{
  for (const char* const usual : {"vertex_indices", "vertex_index"})
  {
    const PlyProperty* const list = this->find(usual);
    if (list && list->lengthType)
    {
      return list;
    }
  }
  const auto isList = [](const PlyProperty& property)
  {
    return property.lengthType && isInteger(property.type);
  };
  const auto list = std::find_if(properties.begin(), properties.end(), isList);
  return std::count_if(properties.begin(), properties.end(), isList) == 1 ? &*list : nullptr;
}

bool areBytes(const std::vector<const PlyProperty*>& color)
{
  return !color.empty() &&
         std::all_of(color.begin(), color.end(),
           [](const PlyProperty* part) { return part->type == PlyNumber::uint8; });
}

const PlyElement& PlyHeader::vertices() const
{
  return *findByName(elements, "vertex");
}

bool PlyHeader::areAllPolygons(const PlyElement& element) const
{
  return element.role == PlyRole::faces &&
         std::count_if(elements.begin(), elements.end(),
           [](const PlyElement& other) { return other.hasFaces(); }) == 1;
}

PlyHeader readPlyHeader(const InputFile& file)
{
  return HeaderParser(file).run();
}

void refusePly(const InputFile& file, const std::string& message)
{
  file.refuse(message + "; give another file");
}

std::string badPlyLength(double length)
{
  return "a list of " + inDigits(length, 15) + " numbers; it is damaged";
}

bool isPlyCorner(double id, std::int64_t vertices, PlyRole role)
{
  return (id >= 0 && id < static_cast<double>(vertices)) ||
         (role == PlyRole::strips && endsStrip(id));
}

std::string badPlyCorner(double id, std::int64_t vertices)
{
  return "vertex " + inDigits(id, 15) + " does not exist; there are " + std::to_string(vertices) +
         ", counted from 0";
}

} // namespace winding
