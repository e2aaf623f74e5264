#include "input/FileGuards.h"

#include "files/FileAccess.h"
#include "files/TextScanning.h"
#include "program/Failure.h"

#include <algorithm>

namespace
{

/// The compressors that VTK has pack at most so many cells or points into a byte.
constexpr std::size_t itemsPerByte = 1000;

} // namespace

// The reader allocates what the counts say before it looks for the data. It checks all else itself.
void guardXmlVtk(const std::string& fileName)
{
  const std::string data = contentsOf(fileName);
  const std::string_view text = std::string_view(data).substr(0, data.find("<AppendedData"));
  const std::string_view start = "NumberOf";
  for (std::size_t at = text.find(start); at < text.size(); at = text.find(start, at + 1))
  {
    const std::size_t open = text.find('"', at);
    const std::size_t close = open < text.size() ? text.find('"', open + 1) : open;
    if (close >= text.size())
    {
      return;
    }
    std::string_view word = text.substr(open + 1, close - open - 1);
    const std::string_view digits = takeWord(word);
    long long count = 0;
    const bool isCount = parseInteger(digits, count) && count >= 0;
    if (!isCount || static_cast<std::size_t>(count) / itemsPerByte > data.size())
    {
      const std::size_t equals = std::min(text.find('=', at), open);
      throw Failure(REFUSED, fileName,
        std::string(text.substr(at, std::min<std::size_t>(equals - at, 30))) + " is " +
          std::string(digits.substr(0, 30)) + ", which the file cannot hold; it is damaged");
    }
  }
}
