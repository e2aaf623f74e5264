#include "input/FileGuards.h"

#include "files/FileAccess.h"
#include "files/TextScanning.h"
#include "program/Failure.h"

#include <algorithm>
#include <cctype>
#include <cstdint>

namespace
{

std::string lowerCase(std::string_view word)
{
  std::string lower(word);
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

bool isOneOf(const std::string& word, std::initializer_list<const char*> known)
{
  return std::find(known.begin(), known.end(), word) != known.end();
}

constexpr std::string_view versionStart = "# vtk DataFile Version ";

std::size_t bytesOf(const std::string& type)
{
  if (isOneOf(type, {"char", "unsigned_char", "signed_char"}))
  {
    return 1;
  }
  if (isOneOf(type, {"short", "unsigned_short"}))
  {
    return 2;
  }
  return isOneOf(type, {"int", "unsigned_int", "float"}) ? 4 : 8;
}

/**
 * Walks through points and cells, where VTK's reader goes on reading a closed file if counts are
 * wrong. The reader checks the arrays behind them well enough.
 */
class LegacyVtkGuard
{
public:
  explicit LegacyVtkGuard(const std::string& fileName)
    : fileName_(fileName)
    , text_(contentsOf(fileName))
  {
  }

  void run()
  {
    this->readHeader();
    for (std::string keyword = this->keyword(); !keyword.empty(); keyword = this->keyword())
    {
      if (keyword == "points")
      {
        const std::size_t count = this->count();
        const std::size_t bytes = bytesOf(this->keyword());
        this->skip(count, 3, bytes);
      }
      else if (isOneOf(keyword, {"vertices", "lines", "polygons", "triangle_strips", "cells"}))
      {
        this->walkCells();
      }
      else if (keyword == "cell_types")
      {
        this->skip(this->count(), 1, 4);
      }
      else if (keyword == "dimensions")
      {
        this->skipWords(3);
      }
      else if (keyword == "metadata")
      {
        this->skipMetadata();
      }
      else
      {
        return;
      }
    }
  }

private:
  [[noreturn]] void refuse(const std::string& message) const
  {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<long>(next_), '\n');
    throw Failure(REFUSED, fileName_,
      (binary_ ? std::string() : "line " + std::to_string(line) + ": ") + message +
        "; it is truncated or damaged");
  }

  void readHeader()
  {
    std::string_view version = takeLine(text_, next_);
    const bool isMarked = version.substr(0, versionStart.size()) == versionStart;
    version.remove_prefix(std::min(version.size(), versionStart.size()));
    const std::size_t dot = std::min(version.find('.'), version.size());
    long long major = 0, minor = 0;
    if (!isMarked || !parseInteger(version.substr(0, dot), major) ||
        !parseInteger(version.substr(std::min(dot + 1, version.size())), minor))
    {
      this->refuse("the version of the format is missing");
    }
    newCells_ = major >= 5;
    if (next_ < text_.size())
    {
      takeLine(text_, next_); // the title
    }
    const std::string encoding = this->keyword();
    const std::string dataset = this->keyword();
    const std::string type = this->keyword();
    if (!isOneOf(encoding, {"ascii", "binary"}) || dataset != "dataset")
    {
      this->refuse("the lines ASCII or BINARY and DATASET are missing");
    }
    binary_ = encoding == "binary";
    if (!isOneOf(type, {"polydata", "unstructured_grid", "structured_grid"}))
    {
      throw Failure(REFUSED, fileName_,
        "holds a dataset of type " + type.substr(0, 30) +
          "; a surface, an unstructured grid or points are needed");
    }
  }

  std::string_view word()
  {
    std::string_view rest = std::string_view(text_).substr(std::min(next_, text_.size()));
    const std::string_view found = takeWord(rest);
    next_ = text_.size() - rest.size();
    return found;
  }

  std::string keyword() { return lowerCase(this->word()); }

  std::size_t count()
  {
    long long value = 0;
    if (!parseInteger(this->word(), value) || value < 0)
    {
      this->refuse("a count is missing");
    }
    // Every item takes a byte or more.
    if (static_cast<std::size_t>(value) > text_.size() - next_)
    {
      this->refuse("promises " + std::to_string(value) + " items, more than the file can hold");
    }
    return static_cast<std::size_t>(value);
  }

  void skipWords(std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      if (this->word().empty())
      {
        this->refuse("ends within a list of numbers");
      }
    }
  }

  /// Passes over items of some numbers each; a number has `bytes` bytes where it is binary.
  void skip(std::size_t items, std::size_t numbersPerItem, std::size_t bytes)
  {
    if (!binary_)
    {
      this->skipWords(items * numbersPerItem);
      return;
    }
    this->startBinary();
    if (items > (text_.size() - next_) / (numbersPerItem * bytes))
    {
      this->refuse("ends within a list of numbers");
    }
    next_ += items * numbersPerItem * bytes;
  }

  /// Passes over the end of the line, behind which binary numbers begin.
  void startBinary()
  {
    if (next_ < text_.size())
    {
      takeLine(text_, next_);
    }
    next_ = std::min(next_, text_.size());
  }

  void walkCells()
  {
    const std::size_t cells = this->count();
    const std::size_t numbers = this->count();
    if (!newCells_)
    {
      this->walkOldCells(cells, numbers);
      return;
    }
    for (const auto& [name, count] : {std::pair("offsets", cells), {"connectivity", numbers}})
    {
      if (this->keyword() != name)
      {
        this->refuse(std::string("cells without ") + name);
      }
      const std::string type = this->keyword();
      this->skip(count, 1, type == "vtktypeint64" ? 8 : bytesOf(type));
    }
  }

  /// Before version 5, each cell is its size and as many ids.
  void walkOldCells(std::size_t cells, std::size_t numbers)
  {
    if (binary_)
    {
      this->startBinary();
    }
    std::size_t used = 0, walked = 0;
    for (; used < numbers; ++walked)
    {
      const long long size = this->integer();
      ++used;
      if (size < 0 || static_cast<std::size_t>(size) > numbers - used)
      {
        this->refuse(
          "a cell of " + std::to_string(size) + " points reaches over the end of its list");
      }
      for (long long i = 0; i < size; ++i, ++used)
      {
        this->integer();
      }
    }
    if (walked != cells)
    {
      this->refuse(
        "promises " + std::to_string(cells) + " cells but lists " + std::to_string(walked));
    }
  }

  long long integer()
  {
    long long value = 0;
    if (binary_)
    {
      if (text_.size() - next_ < 4)
      {
        this->refuse("ends within its cells");
      }
      std::uint32_t bits = 0;
      for (int i = 0; i < 4; ++i)
      {
        bits = bits << 8 | static_cast<unsigned char>(text_[next_++]);
      }
      value = static_cast<std::int32_t>(bits);
    }
    else if (!parseInteger(this->word(), value) || value != static_cast<std::int32_t>(value))
    {
      this->refuse("a cell has something that is no id, or nothing");
    }
    return value;
  }

  /// Passes over a block of metadata, which ends with an empty line.
  void skipMetadata()
  {
    takeLine(text_, next_);
    while (next_ < text_.size() && !takeLine(text_, next_).empty())
    {
    }
    next_ = std::min(next_, text_.size());
  }

  std::string fileName_;
  std::string text_;
  std::size_t next_ = 0;
  bool binary_ = false;
  bool newCells_ = false; ///< whether offsets and connectivity lie apart, from version 5 on
};

} // namespace

void guardLegacyVtk(const std::string& fileName)
{
  LegacyVtkGuard(fileName).run();
}
