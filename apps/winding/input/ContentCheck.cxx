#include "input/ContentCheck.h"

#include "files/FileAccess.h"
#include "files/Suffix.h"
#include "files/TextScanning.h"
#include "program/Failure.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace
{

/// A kind of file that announces itself in its first bytes.
struct Kind
{
  const char* name;
  const char* suffix; ///< the suffixes that promise this kind
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

/// The kind that the first bytes announce; null if they announce none.
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

/// The name of the packer whose mark the first bytes have; null if there is none.
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
  if (startsWith(head, "BZh") && head.substr(std::min<std::size_t>(4, head.size()), 6) == "1AY&SY")
  {
    return "bzip2";
  }
  return startsWith(head, std::string("\xFD") + "7zXZ") ? "xz" : nullptr;
}

/// The kind that a suffix promises; null for suffixes of kinds that do not announce themselves.
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

} // namespace

void checkContentFits(const std::string& fileName)
{
  const std::string suffix = suffixOf(fileName);
  const std::string name = suffix.size() > 1 ? suffix.substr(1) : suffix;
  const std::string head = beginningOf(fileName, 1024);
  if (const char* compressed = compressedKind(head))
  {
    throw Failure(EXIT_REFUSED, fileName,
      "is not " + name + " but compressed with " + compressed + "; unpack it first");
  }
  const Kind* promised = promisedKind(suffix);
  const Kind* announced = announcedKind(head);
  if (announced == &offKind && isTable(fileName))
  {
    announced = nullptr; // a column may have this name
  }
  if (announced && announced != promised)
  {
    throw Failure(EXIT_REFUSED, fileName,
      "is not " + name + ": it begins like " + announced->name + "; give it the suffix " +
        announced->suffix);
  }
  if (promised && announced != promised)
  {
    throw Failure(EXIT_REFUSED, fileName,
      "is not " + name + ": it does not begin like " + promised->name +
        "; give the file a suffix that fits, or another file");
  }
  if (!promised && suffix != ".stl" && head.find('\0') != std::string::npos)
  {
    throw Failure(EXIT_REFUSED, fileName, "is not " + name + ": it is not text; give another file");
  }
}
