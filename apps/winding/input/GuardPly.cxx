#include "input/FileGuards.h"

#include "files/FileAccess.h"
#include "files/TextScanning.h"
#include "program/Failure.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

namespace
{

/// A number type of PLY, by its two names.
struct NumberType
{
  const char* name;
  const char* otherName;
  std::size_t bytes;
  char kind; ///< i, u or f
};

constexpr NumberType numberTypes[] = {{"char", "int8", 1, 'i'}, {"uchar", "uint8", 1, 'u'},
  {"short", "int16", 2, 'i'}, {"ushort", "uint16", 2, 'u'}, {"int", "int32", 4, 'i'},
  {"uint", "uint32", 4, 'u'}, {"float", "float32", 4, 'f'}, {"double", "float64", 8, 'f'}};

struct Property
{
  std::string name;
  const NumberType* type = nullptr;
  const NumberType* countType = nullptr; ///< type of a list's length; null for single numbers
};

struct Element
{
  std::string name;
  long long count = 0;
  std::vector<Property> properties;

  const Property* find(const std::string& property) const
  {
    for (const Property& candidate : properties)
    {
      if (candidate.name == property)
      {
        return &candidate;
      }
    }
    return nullptr;
  }
};

enum class Encoding
{
  text,
  littleEndian,
  bigEndian
};

struct Header
{
  bool hasFormat = false;
  Encoding encoding = Encoding::text;
  std::vector<Element> elements;
  std::size_t bytes = 0;
  std::size_t lines = 0;

  const Element* find(const std::string& element) const
  {
    for (const Element& candidate : elements)
    {
      if (candidate.name == element)
      {
        return &candidate;
      }
    }
    return nullptr;
  }
};

/// A Fault is thrown where the file is found wanting; it becomes a Failure with the file's name.
struct Fault
{
  std::string message;
};

const NumberType* numberType(std::string_view name)
{
  for (const NumberType& type : numberTypes)
  {
    if (name == type.name || name == type.otherName)
    {
      return &type;
    }
  }
  throw Fault{"a property has the unknown type \"" + std::string(name.substr(0, 20)) + "\""};
}

Property readProperty(std::string_view line)
{
  Property property;
  std::string_view type = takeWord(line);
  if (type == "list")
  {
    property.countType = numberType(takeWord(line));
    type = takeWord(line);
  }
  property.type = numberType(type);
  property.name = takeWord(line);
  if (property.name.empty())
  {
    throw Fault{"a property has no name"};
  }
  return property;
}

Encoding readEncoding(std::string_view name)
{
  if (name == "ascii")
  {
    return Encoding::text;
  }
  if (name != "binary_little_endian" && name != "binary_big_endian")
  {
    throw Fault{"the header names no format that PLY has"};
  }
  return name == "binary_little_endian" ? Encoding::littleEndian : Encoding::bigEndian;
}

Element readElement(std::string_view line)
{
  Element element;
  element.name = takeWord(line);
  if (!parseInteger(takeWord(line), element.count) || element.count < 0)
  {
    throw Fault{"the count of " + element.name + " is no number of items"};
  }
  return element;
}

/// Reads a line into the header. True if it was the last one.
bool readHeaderLine(std::string_view line, Header& header)
{
  const std::string_view keyword = takeWord(line);
  if (keyword == "format")
  {
    header.encoding = readEncoding(takeWord(line));
    header.hasFormat = takeWord(line) == "1.0";
  }
  else if (keyword == "element")
  {
    header.elements.push_back(readElement(line));
  }
  else if (keyword == "property" && !header.elements.empty())
  {
    header.elements.back().properties.push_back(readProperty(line));
  }
  else if (keyword != "ply" && keyword != "comment" && keyword != "obj_info" &&
           keyword != "end_header")
  {
    throw Fault{"the header has a line that PLY does not know"};
  }
  return keyword == "end_header";
}

Header readHeader(const std::string& text)
{
  Header header;
  bool complete = false;
  while (!complete)
  {
    if (header.bytes >= text.size())
    {
      throw Fault{"the header has no end; it is truncated"};
    }
    const std::string_view line = takeLine(text, header.bytes);
    ++header.lines;
    try
    {
      complete = readHeaderLine(line, header);
    }
    catch (const Fault& fault)
    {
      throw Fault{"line " + std::to_string(header.lines) + ": " + fault.message};
    }
  }
  return header;
}

/// Reads the numbers behind the header, one after the other.
class Body
{
public:
  Body(const std::string& text, const Header& header)
    : text_(text)
    , encoding_(header.encoding)
    , next_(std::min(header.bytes, text.size()))
    , lineNumber_(header.lines)
  {
  }

  /// Moves on to the next item; in text, each item of an element stands on a line of its own.
  void startItem()
  {
    line_ = {};
    while (encoding_ == Encoding::text && next_ < text_.size())
    {
      line_ = takeLine(text_, next_);
      ++lineNumber_;
      std::string_view rest = line_;
      if (!takeWord(rest).empty())
      {
        return;
      }
    }
  }

  double number(const NumberType& type)
  {
    return encoding_ == Encoding::text ? this->textNumber() : this->binaryNumber(type);
  }

  /// Passes over items of a fixed size, in binary files. False where there are not as many.
  bool skip(long long items, std::size_t bytesPerItem)
  {
    if (bytesPerItem > 0 && static_cast<std::size_t>(items) > (text_.size() - next_) / bytesPerItem)
    {
      return false;
    }
    next_ += static_cast<std::size_t>(items) * bytesPerItem;
    return true;
  }

  std::string where() const
  {
    return encoding_ == Encoding::text ? "line " + std::to_string(lineNumber_) + ": "
                                       : std::string();
  }

private:
  double textNumber()
  {
    double value = 0;
    const std::string_view word = takeWord(line_);
    if (word.empty())
    {
      throw Fault{this->where() + "a number is missing; it is truncated or damaged"};
    }
    if (!parseNumber(word, value))
    {
      throw Fault{this->where() + "holds something that is no number; it is damaged"};
    }
    return value;
  }

  double binaryNumber(const NumberType& type)
  {
    if (type.bytes > text_.size() - next_)
    {
      throw Fault{"ends before its last item; it is truncated"};
    }
    unsigned char bytes[8] = {};
    for (std::size_t i = 0; i < type.bytes; ++i)
    {
      const std::size_t from = encoding_ == Encoding::bigEndian ? type.bytes - 1 - i : i;
      bytes[i] = static_cast<unsigned char>(text_[next_ + from]);
    }
    next_ += type.bytes;
    return type.kind == 'f' ? real(bytes, type.bytes) : integer(bytes, type);
  }

  static double real(const unsigned char* bytes, std::size_t size)
  {
    float single;
    double value;
    std::memcpy(&single, bytes, sizeof single);
    std::memcpy(&value, bytes, sizeof value);
    return size == sizeof single ? static_cast<double>(single) : value;
  }

  static double integer(const unsigned char* bytes, const NumberType& type)
  {
    std::int64_t value = 0;
    for (std::size_t i = 0; i < type.bytes; ++i)
    {
      value |= static_cast<std::int64_t>(bytes[i]) << (8 * i);
    }
    const std::int64_t range = std::int64_t(1) << (8 * type.bytes);
    return static_cast<double>(type.kind == 'i' && value >= range / 2 ? value - range : value);
  }

  const std::string& text_;
  Encoding encoding_;
  std::size_t next_;
  std::size_t lineNumber_;
  std::string_view line_;
};

const Property* cornersOf(const Element& face)
{
  const Property* corners = face.find("vertex_indices");
  return corners ? corners : face.find("vertex_index");
}

void checkHeader(const Header& header)
{
  if (!header.hasFormat)
  {
    throw Fault{"the header has no format line of version 1.0"};
  }
  const Element* vertex = header.find("vertex");
  const auto hasNumber = [vertex](const char* name)
  {
    const Property* property = vertex->find(name);
    return property && !property->countType;
  };
  if (!vertex || !hasNumber("x") || !hasNumber("y") || !hasNumber("z"))
  {
    throw Fault{"the header has no vertices with x, y and z"};
  }
  for (const Element& element : header.elements)
  {
    if (element.properties.empty() && element.count > 0)
    {
      throw Fault{"the header has an element " + element.name + " without properties"};
    }
  }
  const Element* face = header.find("face");
  if (face && (!cornersOf(*face) || !cornersOf(*face)->countType))
  {
    throw Fault{"the header has faces without vertex_indices"};
  }
}

void walkItem(Body& body, const Element& element, const Property* corners, long long vertices)
{
  body.startItem();
  for (const Property& property : element.properties)
  {
    const double count = property.countType ? body.number(*property.countType) : 1;
    // VTK's reader keeps the number of corners in one byte.
    if (!(count >= 0) || count != std::floor(count) || (&property == corners && count > 255))
    {
      throw Fault{body.where() + "a list of " + std::to_string(count) +
                  " numbers, of 255 at most; it is damaged"};
    }
    for (double i = 0; i < count; ++i)
    {
      const double value = body.number(*property.type);
      if (&property == corners && !(value >= 0 && value < static_cast<double>(vertices)))
      {
        char id[40]; // the number may be any, as files of floating-point ids have them
        std::snprintf(id, sizeof id, "%.15g", value);
        throw Fault{body.where() + "vertex " + id + " does not exist; there are " +
                    std::to_string(vertices) + ", counted from 0"};
      }
    }
  }
}

/// How many bytes an item takes; 0 where it has lists, whose lengths vary.
std::size_t fixedBytes(const Element& element)
{
  std::size_t bytes = 0;
  for (const Property& property : element.properties)
  {
    if (property.countType)
    {
      return 0;
    }
    bytes += property.type->bytes;
  }
  return bytes;
}

void walk(const std::string& text)
{
  const Header header = readHeader(text);
  checkHeader(header);
  const long long vertices = header.find("vertex")->count;
  Body body(text, header);
  for (const Element& element : header.elements)
  {
    const std::size_t bytes = fixedBytes(element);
    if (element.count > 0 && static_cast<std::size_t>(element.count) > text.size())
    {
      throw Fault{"promises " + std::to_string(element.count) + " items of " + element.name +
                  ", more than it can hold; it is truncated or damaged"};
    }
    if (header.encoding != Encoding::text && bytes > 0)
    {
      if (!body.skip(element.count, bytes))
      {
        throw Fault{"ends before the last of the " + std::to_string(element.count) + " items of " +
                    element.name + " that it promises; it is truncated"};
      }
      continue;
    }
    const Property* corners = element.name == "face" ? cornersOf(element) : nullptr;
    for (long long i = 0; i < element.count; ++i)
    {
      walkItem(body, element, corners, vertices);
    }
  }
}

} // namespace

void guardPly(const std::string& fileName)
{
  const std::string text = contentsOf(fileName);
  try
  {
    walk(text);
  }
  catch (const Fault& fault)
  {
    throw Failure(REFUSED, fileName, fault.message + "; give another file");
  }
}
