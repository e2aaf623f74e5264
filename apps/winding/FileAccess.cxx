#include "FileAccess.h"

#include "Failure.h"
#include "Options.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

namespace
{

struct Kind
{
  const char* name;
  const char* suffix; ///< a suffix that says so
};

constexpr Kind xmlKind = {"VTK XML", ".vtp or .vtu"};
constexpr Kind legacyKind = {"legacy VTK", ".vtk"};
constexpr Kind plyKind = {"PLY", ".ply"};
constexpr Kind offKind = {"OFF", ".off"};

bool startsWith(std::string_view text, std::string_view start)
{
  return text.substr(0, start.size()) == start;
}

bool isOff(std::string_view text)
{
  while (!text.empty() && text[0] == '#')
  {
    std::size_t start = 0;
    takeLine(text, start);
    text.remove_prefix(std::min(start, text.size()));
  }
  const std::string_view word = takeWord(text);
  return word.size() >= 3 && word.size() <= 8 && word.substr(word.size() - 3) == "OFF" &&
         std::all_of(word.begin(), word.end(),
           [](char c) { return (c >= 'A' && c <= 'Z') || c == '4' || c == 'n'; });
}

/// The kind that the first bytes announce, of those that announce themselves.
const Kind* announcedKind(std::string_view head)
{
  if (startsWith(head, "ply\n") || startsWith(head, "ply\r"))
  {
    return &plyKind;
  }
  if (startsWith(head, "# vtk DataFile"))
  {
    return &legacyKind;
  }
  if (startsWith(head, "<?xml") || startsWith(head, "<VTKFile"))
  {
    return &xmlKind;
  }
  return isOff(head) ? &offKind : nullptr;
}

const char* compressedKind(std::string_view head)
{
  if (startsWith(head, "\x1f\x8b"))
  {
    return "gzip";
  }
  if (startsWith(head, "PK\x03\x04"))
  {
    return "zip";
  }
  return startsWith(head, "BZh") ? "bzip2"
         : startsWith(head, "\xFD"
                            "7zXZ")
           ? "xz"
           : nullptr;
}

/// The kind that a suffix promises; null for those without an announcement of their own.
const Kind* promisedKind(const std::string& suffix)
{
  const std::pair<const char*, const Kind*> kinds[] = {{".ply", &plyKind}, {".vtk", &legacyKind},
    {".vtp", &xmlKind}, {".vtu", &xmlKind}, {".off", &offKind}};
  for (const auto& [name, kind] : kinds)
  {
    if (suffix == name)
    {
      return kind;
    }
  }
  return nullptr;
}

std::string read(const std::string& fileName, std::size_t most)
{
  std::error_code error;
  if (!std::filesystem::exists(fileName, error))
  {
    throw Failure(REFUSED, fileName, "no such file; check its name and folder");
  }
  if (std::filesystem::is_directory(fileName, error))
  {
    throw Failure(REFUSED, fileName, "is a folder; give a file");
  }
  std::ifstream file(fileName, std::ios::binary);
  if (!file)
  {
    throw Failure(REFUSED, fileName,
      std::string("cannot be opened: ") + std::strerror(errno) + "; check its permissions");
  }
  const std::uintmax_t size = std::filesystem::file_size(fileName, error);
  if (error)
  {
    throw Failure(REFUSED, fileName, "is not a regular file; give one");
  }
  std::string text(std::min<std::uintmax_t>(size, most), '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (text.empty() || !file)
  {
    throw Failure(REFUSED, fileName,
      text.empty() ? "is empty; give another file" : "cannot be read to its end");
  }
  return text;
}

} // namespace

std::string contentsOf(const std::string& fileName)
{
  return read(fileName, SIZE_MAX);
}

std::string beginningOf(const std::string& fileName, std::size_t bytes)
{
  return read(fileName, bytes);
}

void checkContentFits(const std::string& fileName)
{
  const std::string suffix = suffixOf(fileName);
  const std::string name = suffix.size() > 1 ? suffix.substr(1) : suffix;
  const std::string head = beginningOf(fileName, 1024);
  if (const char* compressed = compressedKind(head))
  {
    throw Failure(REFUSED, fileName,
      "is not " + name + " but compressed with " + compressed + "; unpack it first");
  }
  const Kind* promised = promisedKind(suffix);
  const Kind* announced = announcedKind(head);
  if (announced && announced != promised)
  {
    throw Failure(REFUSED, fileName,
      "is not " + name + ": it begins like " + announced->name + "; give it the suffix " +
        announced->suffix);
  }
  if (promised && announced != promised)
  {
    throw Failure(REFUSED, fileName,
      "is not " + name + ": it does not begin like " + promised->name +
        "; give the file a suffix that fits, or another file");
  }
  if (!promised && suffix != ".stl" && head.find('\0') != std::string::npos)
  {
    throw Failure(REFUSED, fileName, "is not " + name + ": it is not text; give another file");
  }
}

std::string_view takeLine(std::string_view text, std::size_t& start)
{
  const std::size_t end = std::min(text.find('\n', start), text.size());
  std::string_view line = text.substr(start, end - start);
  start = end + 1;
  if (!line.empty() && line.back() == '\r')
  {
    line.remove_suffix(1);
  }
  return line;
}

std::string_view takeWord(std::string_view& text)
{
  const auto isSpace = [](char c)
  {
    return c == ' ' || (c >= '\t' && c <= '\r');
  };
  const auto first = std::find_if_not(text.begin(), text.end(), isSpace);
  const auto last = std::find_if(first, text.end(), isSpace);
  const std::string_view word = text.substr(
    static_cast<std::size_t>(first - text.begin()), static_cast<std::size_t>(last - first));
  text.remove_prefix(static_cast<std::size_t>(last - text.begin()));
  return word;
}

namespace
{

template <class Number> bool parse(std::string_view word, Number& value)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
  {
    word.remove_prefix(1); // from_chars knows no plus sign
  }
  const char* end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

} // namespace

bool parseInteger(std::string_view word, long long& value)
{
  return parse(word, value);
}

bool parseNumber(std::string_view word, double& value)
{
  if (parse(word, value))
  {
    return true;
  }
  // Also what overflows or underflows, which from_chars leaves alone.
  const std::string text(word);
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);
  return !text.empty() && end == text.c_str() + text.size();
}
