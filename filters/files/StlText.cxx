// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/StlText.h"

#include "base/Progress.h"
#include "files/LineBlocks.h"
#include "files/LineScanner.h"
#include "files/NamedRegions.h"
#include "files/OrderedBlocks.h"
#include "files/Utf8.h"
#include "files/Words.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace winding
{

namespace
{

/// The place in a file, by the line that may stand next.
enum State : unsigned char
{
  outside, ///< a solid, or the end of the file
  inSolid, ///< a facet, or the end of the solid
  inFacet, ///< the loop of its vertices
  before1, ///< the first vertex
  before2,
  before3,
  afterVertices, ///< the end of the loop
  afterLoop,     ///< the end of the facet
  faulty,        ///< nothing: a line stands where it must not
  states
};

/// A word with which lines begin, and the states before and after that line.
struct Keyword
{
  std::string_view word;
  std::array<State, states> next; ///< for each state before
};

constexpr State no = faulty;
constexpr Keyword keywords[] = {
  {"vertex", {no, no, no, before2, before3, afterVertices, no, no, no}},
  {"facet", {no, inFacet, no, no, no, no, no, no, no}},
  {"outer", {no, no, before1, no, no, no, no, no, no}},
  {"endloop", {no, no, no, no, no, no, afterLoop, no, no}},
  {"endfacet", {no, no, no, no, no, no, no, inSolid, no}},
  {"solid", {inSolid, inSolid, no, no, no, no, no, no, no}}, // some leave endsolid out
  {"endsolid", {no, outside, no, no, no, no, no, no, no}},
  {"color", {no, inSolid, no, no, no, no, no, no, no}},
  {"", {no, no, no, no, no, no, no, no, no}}, // any other
};
/// A line that changes nothing.
constexpr Keyword comment = {
  "#", {outside, inSolid, inFacet, before1, before2, before3, afterVertices, afterLoop, faulty}};
constexpr const Keyword& vertexKeyword = keywords[0];
constexpr const Keyword& endFacetKeyword = keywords[4];
constexpr const Keyword& solidKeyword = keywords[5];
constexpr const Keyword& endSolidKeyword = keywords[6];

/// The words that must stand next, for each state.
constexpr const char* expected[states] = {
  "solid", "facet", "outer loop", "vertex", "vertex", "vertex", "endloop", "endfacet", ""};

/// Whether a word is another that is in small letters, in letters of any size.
bool isWord(std::string_view word, std::string_view small)
{
  return word.size() == small.size() &&
         std::equal(word.begin(), word.end(), small.begin(),
           [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b); });
}

const Keyword& keywordOf(std::string_view word)
{
  if (!word.empty() && word[0] == '#')
  {
    return comment;
  }
  const Keyword* keyword = keywords;
  while (!keyword->word.empty() && !isWord(word, keyword->word))
  {
    ++keyword;
  }
  return *keyword;
}

/// The sum of the lines in some part of a file.
struct Lines
{
  std::size_t vertices = 0;
  std::size_t facets = 0;
  std::vector<RegionStart> solids; ///< that begin; facets are counted from the first of this part
  const Keyword* last = nullptr;   ///< keyword of the last line; null where there is none
  std::array<State, states> after; ///< the state at the end, for each one at the beginning
};

class StlTextParser
{
public:
  StlTextParser(const InputFile& file, Executor& executor)
    : file_(file)
    , blocks_(file)
    , lines_(blocks_.count())
    , executor_(executor)
  {
  }

  void run(MeshArrays& mesh)
  {
    Progress progress(executor_);
    progress.set(0, 0.3); // the first look takes three tenths of the time
    runOrderedBlocks(
      blocks_.count(), [this](std::size_t block) { this->look(block); }, executor_);
    progress.set(0.3, 1);
    this->readVertices();
    this->checkEnd();
    this->checkOrder();
    this->addSolids(mesh);
    mesh.points.doubles = std::move(numbers_);
  }

private:
  void look(std::size_t block)
  {
    Lines& lines = lines_[block];
    for (unsigned char state = 0; state < states; ++state)
    {
      lines.after[state] = static_cast<State>(state);
    }
    const TextBlock text = blocks_.read(block);
    for (LineScanner scanner(file_, text); scanner.nextLine();)
    {
      const Keyword& keyword = keywordOf(scanner.word());
      lines.vertices += &keyword == &vertexKeyword ? 1 : 0;
      lines.facets += &keyword == &endFacetKeyword ? 1 : 0;
      if (&keyword == &solidKeyword)
      {
        lines.solids.push_back({lines.facets, inUtf8(regionName(scanner.rest()))});
      }
      lines.last = &keyword == &comment ? lines.last : &keyword;
      for (State& state : lines.after)
      {
        state = keyword.next[state];
      }
    }
  }

  void readVertices()
  {
    std::vector<std::size_t> starts(lines_.size() + 1);
    for (std::size_t block = 0; block < lines_.size(); ++block)
    {
      starts[block + 1] = starts[block] + lines_[block].vertices;
    }
    numbers_ = PlainArray<double>(3 * starts.back());
    runOrderedBlocks(
      blocks_.count(),
      [&](std::size_t block)
      {
        std::size_t vertex = starts[block];
        const TextBlock text = blocks_.read(block);
        for (LineScanner scanner(file_, text); scanner.nextLine();)
        {
          if (isWord(scanner.word(), vertexKeyword.word))
          {
            this->requireSame(vertex < starts[block + 1]);
            this->readVertex(scanner, numbers_.data() + 3 * vertex++);
          }
        }
        this->requireSame(vertex == starts[block + 1]);
      },
      executor_);
  }

  /// The file may have changed since the first look at it.
  void requireSame(bool isSame) const
  {
    if (!isSame)
    {
      file_.refuseChanged();
    }
  }

  static void readVertex(LineScanner& scanner, double* numbers)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (!scanner.tryNumber(numbers[axis]))
      {
        scanner.refuse("a vertex needs three numbers; it is truncated or damaged");
      }
    }
  }

  void checkEnd() const
  {
    std::size_t facets = 0;
    const Keyword* last = nullptr;
    for (const Lines& lines : lines_)
    {
      facets += lines.facets;
      last = lines.last ? lines.last : last;
    }
    if (numbers_.size() != 9 * facets || last != &endSolidKeyword)
    {
      file_.refuse("ends at line " + std::to_string(file_.lineOf(file_.size() - 1)) + " with " +
                     std::to_string(facets) +
                     " facets and without endsolid; it is truncated, or not STL",
        FileFault::ends);
    }
  }

  void checkOrder() const
  {
    State state = outside;
    for (std::size_t block = 0; block < lines_.size(); ++block)
    {
      const State next = lines_[block].after[state];
      if (next == faulty)
      {
        this->refuseOrder(block, state);
      }
      state = next;
    }
  }

  void addSolids(MeshArrays& mesh)
  {
    std::vector<RegionStart> solids;
    std::size_t facets = 0;
    for (Lines& lines : lines_)
    {
      append(solids, lines.solids, facets);
      facets += lines.facets;
    }
    addRegions("Solid", solids, EqualNames::otherRegions, facets, mesh.regions);
  }

  /// Refuses the line of a block that stands where it must not. `state` is that at the beginning.
  [[noreturn]] void refuseOrder(std::size_t block, State state) const
  {
    const TextBlock text = blocks_.read(block);
    for (LineScanner scanner(file_, text); scanner.nextLine();)
    {
      const std::string_view word = scanner.word();
      const State next = keywordOf(word).next[state];
      if (next == faulty)
      {
        scanner.refuse(shown(word) + " stands where " + expected[state] + " should; correct it");
      }
      state = next;
    }
    file_.refuseChanged();
  }

  const InputFile& file_;
  LineBlocks blocks_;
  std::vector<Lines> lines_; ///< one for each block
  Executor& executor_;
  PlainArray<double> numbers_;
};

} // namespace

void readStlText(const InputFile& file, MeshArrays& mesh, Executor& executor)
{
  StlTextParser(file, executor).run(mesh);
}

} // namespace winding
