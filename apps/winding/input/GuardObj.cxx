#include "input/FileGuards.h"

#include "files/FileAccess.h"
#include "files/TextScanning.h"
#include "program/Failure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace
{

// The kinds of items that faces refer to, in the order in which their corners do.
constexpr std::string_view keywords[3] = {"v", "vt", "vn"};
constexpr const char* names[3] = {"vertex", "texture coordinate", "normal"};
constexpr int leastNumbers[3] = {3, 1, 3};

class ObjGuard
{
public:
  explicit ObjGuard(const std::string& fileName)
    : fileName_(fileName)
    , text_(contentsOf(fileName))
  {
  }

  void run()
  {
    this->eachLine([this](std::string_view line) { this->countItem(line); });
    if (counts_[0] == 0)
    {
      throw Failure(
        REFUSED, fileName_, "is not OBJ: it has no line with a vertex; give another file");
    }
    this->eachLine([this](std::string_view line) { this->checkFace(line); });
  }

private:
  template <class Visitor> void eachLine(const Visitor& visit)
  {
    line_ = 0;
    for (std::size_t start = 0; start < text_.size();)
    {
      ++line_;
      visit(takeLine(text_, start));
    }
  }

  [[noreturn]] void refuse(const std::string& message) const
  {
    throw Failure(REFUSED, fileName_, "line " + std::to_string(line_) + ": " + message);
  }

  void countItem(std::string_view line)
  {
    const std::string_view keyword = takeWord(line);
    const auto found = std::find(std::begin(keywords), std::end(keywords), keyword);
    if (found == std::end(keywords))
    {
      return;
    }
    const auto kind = static_cast<std::size_t>(found - std::begin(keywords));
    ++counts_[kind];
    double value;
    for (int i = 0; i < leastNumbers[kind]; ++i)
    {
      if (!parseNumber(takeWord(line), value))
      {
        this->refuse(
          std::string("a ") + names[kind] + " without its numbers; it is truncated or damaged");
      }
      // VTK's reader would take NaN for 0.
      if (kind == 0 && !std::isfinite(value))
      {
        this->refuse("a vertex that is not a number; remove it and its faces");
      }
    }
  }

  void checkFace(std::string_view line)
  {
    if (takeWord(line) != "f")
    {
      return;
    }
    int corners = 0;
    for (std::string_view word = takeWord(line); !word.empty() && word[0] != '#';
         word = takeWord(line))
    {
      if (word == "\\")
      {
        return; // the face goes on in the next line
      }
      this->checkCorner(word);
      ++corners;
    }
    if (corners < 3)
    {
      this->refuse("a face with " + std::to_string(corners) +
                   " corners, which needs three; it is truncated or damaged");
    }
  }

  /// A corner is v, v/vt, v//vn or v/vt/vn; negative numbers count from the last item.
  void checkCorner(std::string_view word) const
  {
    for (std::size_t kind = 0; kind < 3; ++kind)
    {
      const std::size_t slash = std::min(word.find('/'), word.size());
      const std::string_view part = word.substr(0, slash);
      long long index = 0;
      if (kind == 0 || !part.empty())
      {
        if (!parseInteger(part, index) || index == 0 || std::abs(index) > counts_[kind])
        {
          this->refuse(std::string(names[kind]) + " " + std::string(part.substr(0, 20)) +
                       " does not exist; there are " + std::to_string(counts_[kind]) +
                       ", counted from 1");
        }
      }
      word.remove_prefix(std::min(slash + 1, word.size()));
      if (word.empty())
      {
        return;
      }
    }
  }

  std::string fileName_;
  std::string text_;
  std::array<long long, 3> counts_ = {};
  std::size_t line_ = 0;
};

} // namespace

void guardObj(const std::string& fileName)
{
  ObjGuard(fileName).run();
}
