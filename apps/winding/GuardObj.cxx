#include "FileGuards.h"

#include "Failure.h"
#include "FileAccess.h"

#include <array>
#include <cmath>

namespace
{

constexpr const char* names[3] = {"vertex", "texture coordinate", "normal"};

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
    const int kind = keyword == "v" ? 0 : keyword == "vt" ? 1 : keyword == "vn" ? 2 : -1;
    if (kind < 0)
    {
      return;
    }
    ++counts_[static_cast<std::size_t>(kind)];
    double value;
    for (int axis = 0; axis < (kind == 1 ? 1 : 3); ++axis)
    {
      if (!parseNumber(takeWord(line), value))
      {
        this->refuse(
          std::string("a ") + names[kind] + " without its numbers; it is truncated or damaged");
      }
      // VTK's reader would take it for 0.
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
        return; // goes on in the next line
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

  /// v, v/vt, v//vn or v/vt/vn; negative ones count from the last.
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
