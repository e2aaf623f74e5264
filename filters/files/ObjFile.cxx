// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/ObjFile.h"

#include "base/Progress.h"
#include "files/LineBlocks.h"
#include "files/OrderedBlocks.h"
#include "files/Utf8.h"
#include "files/Words.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace winding
{

namespace
{

constexpr const char* itemNames[3] = {"vertex", "texture coordinate", "normal"};
constexpr int leastNumbers[3] = {3, 1, 3};
constexpr const char* cellNames[3] = {"point", "line", "face"};
constexpr std::int64_t leastCorners[3] = {1, 2, 3};
constexpr const char* regionKinds[3] = {"Object", "Group", "Material"};
constexpr float noColor = std::numeric_limits<float>::quiet_NaN(); ///< of a vertex without one

/// The numbers of items of each kind, in the order of itemNames, and of cells and their corners, in
/// the order of cellNames, in some part of a file.
struct Counts
{
  std::int64_t items[3] = {};
  std::int64_t cells[3] = {};
  std::int64_t corners[3] = {};
  std::int64_t freeForms = 0; ///< curves and surfaces

  void add(const Counts& other)
  {
    for (int kind = 0; kind < 3; ++kind)
    {
      items[kind] += other.items[kind];
      cells[kind] += other.cells[kind];
      corners[kind] += other.corners[kind];
    }
    freeForms += other.freeForms;
  }
};

/// The statements by which regions of each kind of regionKinds begin in a part of a file. Polygons
/// are counted from its first one.
using RegionStarts = std::array<std::vector<RegionStart>, 3>;

/// The statements that are read or counted.
enum class Statement
{
  other,
  item,
  cell,
  region,
  freeForm
};

bool isFreeForm(std::string_view keyword)
{
  const char* const names[] = {"curv", "curv2", "surf", "bzp", "bsp", "cdc", "cdp", "res"};
  return std::find(std::begin(names), std::end(names), keyword) != std::end(names);
}

/// The lines of a text, and their statements.
class ObjLines
{
public:
  explicit ObjLines(std::string_view text)
    : next_(text.data())
    , last_(text.data() + text.size())
  {
  }

  /// Goes to the next line; false at the end of the text.
  bool nextLine()
  {
    if (next_ == last_)
    {
      return false;
    }
    line_ = at_ = next_;
    end_ =
      static_cast<const char*>(std::memchr(next_, '\n', static_cast<std::size_t>(last_ - next_)));
    next_ = end_ + 1;
    end_ -= end_ > at_ && end_[-1] == '\r' ? 1 : 0;
    return true;
  }

  /// Takes the keyword off the line. `kind` is its place in itemNames, cellNames or regionKinds.
  Statement takeStatement(int& kind)
  {
    const std::string_view keyword = takeWord(at_, end_);
    if (keyword == "o" || keyword == "g" || keyword == "usemtl")
    {
      kind = keyword == "o" ? 0 : keyword == "g" ? 1 : 2;
      return Statement::region;
    }
    if (keyword.empty() || keyword.size() > 2)
    {
      return isFreeForm(keyword) ? Statement::freeForm : Statement::other;
    }
    const char first = keyword[0], second = keyword.size() > 1 ? keyword[1] : '\0';
    if (first == 'v')
    {
      kind = second == 't' ? 1 : second == 'n' ? 2 : 0;
      return kind > 0 || second == '\0' ? Statement::item : Statement::other;
    }
    kind = first == 'f' ? 2 : first == 'l' ? 1 : 0;
    const bool isWhole = second == '\0' || keyword == "fo"; // the older name of f
    return isWhole && (kind > 0 || first == 'p') ? Statement::cell : Statement::other;
  }

  bool takeNumber(double& value) { return winding::takeNumber(at_, end_, value); }

  /// The next corner of a cell; empty at the end of the cell.
  std::string_view takeCorner()
  {
    const std::string_view word = takeWord(at_, end_);
    return word.empty() || word[0] == '#' ? std::string_view() : word;
  }

  /// The text that is left of the line.
  std::string_view rest() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }

  /// The beginning of the line.
  const char* line() const { return line_; }

private:
  const char* line_ = nullptr;
  const char* at_ = nullptr; ///< the unread rest of the line
  const char* end_ = nullptr;
  const char* next_; ///< the beginning of the next line
  const char* last_; ///< the end of the text
};

/// Counts what is in a part of a file, and notes where regions begin.
Counts countsOf(std::string_view text, RegionStarts& regions)
{
  Counts counts;
  int kind = 0;
  for (ObjLines lines(text); lines.nextLine();)
  {
    const Statement statement = lines.takeStatement(kind);
    counts.items[kind] += statement == Statement::item ? 1 : 0;
    counts.freeForms += statement == Statement::freeForm ? 1 : 0;
    if (statement == Statement::region)
    {
      std::vector<RegionStart>& ofKind = regions[static_cast<std::size_t>(kind)];
      std::string name = inUtf8(regionName(lines.rest()));
      if (ofKind.empty() || ofKind.back().name != name) // some programs repeat it for each face
      {
        ofKind.push_back({static_cast<std::size_t>(counts.cells[2]), std::move(name)});
      }
    }
    if (statement == Statement::cell)
    {
      ++counts.cells[kind];
      while (!lines.takeCorner().empty())
      {
        ++counts.corners[kind];
      }
    }
  }
  return counts;
}

/// Reads blocks into the places that the counts of the blocks before give them.
class ObjParser
{
public:
  ObjParser(const InputFile& file, bool wantsTexture, Executor& executor)
    : file_(file)
    , wantsTexture_(wantsTexture)
    , blocks_(file, 0, LineBlocks::usualBytes, LineBlocks::Backslash::joinsLines)
    , starts_(blocks_.count() + 1)
    , regions_(blocks_.count())
    , executor_(executor)
  {
  }

  MeshArrays run()
  {
    Progress progress(executor_);
    progress.set(0, 0.3); // counting takes three tenths of the time
    this->count();
    hasColors_ = this->beginsWithColor();
    progress.set(0.3, 1);
    this->parseAll();
    if (!hasColors_ && seesColors_)
    {
      hasColors_ = true;
      this->parseAll();
    }
    if (!normalsFit_)
    {
      mesh_.normals = {};
    }
    if (hasColors_)
    {
      mesh_.colors = bytesOfColors(colors_);
      mesh_.colorComponents = 3;
      for (std::size_t i = 0; i < colors_.size() && lacksColors_; ++i)
      {
        mesh_.colors[i] = std::isnan(colors_[i]) ? 255 : mesh_.colors[i];
      }
    }
    this->assignTexture();
    this->addRegionsOfAllKinds();
    this->addNotes();
    return std::move(mesh_);
  }

private:
  void count()
  {
    runOrderedBlocks(
      blocks_.count(),
      [this](std::size_t block)
      {
        const TextBlock text = blocks_.read(block);
        starts_[block + 1] = countsOf(text.text(), regions_[block]);
      },
      executor_);
    for (std::size_t block = 0; block < blocks_.count(); ++block)
    {
      starts_[block + 1].add(starts_[block]);
    }
    if (starts_.back().items[0] == 0)
    {
      file_.refuse("is not OBJ: it has no line with a vertex; give another file");
    }
  }

  void addRegionsOfAllKinds()
  {
    for (std::size_t kind = 0; kind < std::size(regionKinds); ++kind)
    {
      std::vector<RegionStart> ofFile;
      for (std::size_t block = 0; block < regions_.size(); ++block)
      {
        append(ofFile, regions_[block][kind], static_cast<std::size_t>(starts_[block].cells[2]));
      }
      addRegions(
        regionKinds[kind], ofFile, EqualNames::sameRegion, mesh_.polygons.count(), mesh_.regions);
    }
  }

  /// Returns whether the first vertex has a colour behind its position.
  bool beginsWithColor() const
  {
    std::size_t block = 0;
    while (starts_[block + 1].items[0] == 0)
    {
      ++block;
    }
    const TextBlock text = blocks_.read(block);
    int kind = 0;
    for (ObjLines lines(text.text()); lines.nextLine();)
    {
      if (lines.takeStatement(kind) == Statement::item && kind == 0)
      {
        double position[3], color[3];
        return takeThree(lines, position) && takeThree(lines, color);
      }
    }
    return false;
  }

  /// Gives vertices the texture coordinates of their corners, and appends a copy of a vertex for
  /// each further one.
  void assignTexture()
  {
    if (cornerTexture_.empty())
    {
      return;
    }
    constexpr std::int64_t none = -1;
    struct Copy
    {
      std::int64_t vertex, texture, next;
    };
    const auto vertices = static_cast<std::int64_t>(mesh_.points.count());
    std::vector<std::int64_t> textures(static_cast<std::size_t>(vertices), none);
    std::vector<std::int64_t> firstCopies(textures);
    std::vector<Copy> copies;
    for (std::size_t i = 0; i < cornerTexture_.size(); ++i)
    {
      std::int64_t& corner = mesh_.polygons.connectivity[i];
      const auto vertex = static_cast<std::size_t>(corner);
      const std::int64_t texture = cornerTexture_[i];
      textures[vertex] = textures[vertex] == none ? texture : textures[vertex];
      if (texture == none || texture == textures[vertex])
      {
        continue;
      }
      std::int64_t copy = firstCopies[vertex];
      while (copy != none && copies[static_cast<std::size_t>(copy)].texture != texture)
      {
        copy = copies[static_cast<std::size_t>(copy)].next;
      }
      if (copy == none)
      {
        copy = static_cast<std::int64_t>(copies.size());
        copies.push_back({corner, texture, firstCopies[vertex]});
        firstCopies[vertex] = copy;
      }
      corner = vertices + copy;
    }
    const auto append = [&copies](auto& numbers, std::size_t components)
    {
      const std::size_t before = numbers.size();
      if (before == 0 || copies.empty())
      {
        return;
      }
      numbers.resize(before + components * copies.size());
      for (std::size_t i = 0; i < copies.size(); ++i)
      {
        std::copy_n(numbers.data() + components * static_cast<std::size_t>(copies[i].vertex),
          components, numbers.data() + before + components * i);
      }
    };
    append(mesh_.points.doubles, 3);
    append(mesh_.normals.doubles, 3);
    append(mesh_.colors, 3);
    mesh_.textureCoordinates = PlainArray<float>(2 * mesh_.points.count());
    for (std::size_t i = 0; i < mesh_.points.count(); ++i)
    {
      const std::int64_t texture =
        i < textures.size() ? textures[i] : copies[i - textures.size()].texture;
      for (std::size_t axis = 0; axis < 2; ++axis)
      {
        mesh_.textureCoordinates[2 * i + axis] =
          texture == none ? 0 : texture_[2 * static_cast<std::size_t>(texture) + axis];
      }
    }
  }

  void addNotes()
  {
    const Counts& all = starts_.back();
    if (lacksColors_)
    {
      mesh_.notes.push_back(
        {"some vertices have no colors", {{"export one for each vertex", {}}}, "they are white"});
    }
    if (all.freeForms > 0)
    {
      mesh_.notes.push_back({"free-form curves and surfaces are not read",
        {{"export them as polygons", {}}}, "there are " + std::to_string(all.freeForms)});
    }
    if (all.items[2] > 0 && !normalsFit_ && all.cells[2] == 0)
    {
      mesh_.notes.push_back(
        {"normals that fit no vertices are not read", {{"export one for each vertex", {}}},
          std::to_string(all.items[2]) + " normals for " + std::to_string(all.items[0]) +
            " vertices"});
    }
  }

  CellArrays& cells(int kind)
  {
    return kind == 2 ? mesh_.polygons : kind == 1 ? mesh_.lines : mesh_.vertices;
  }

  void allocate()
  {
    const Counts& all = starts_.back();
    mesh_.points.doubles = PlainArray<double>(3 * static_cast<std::size_t>(all.items[0]));
    normalsFit_ = all.items[2] == all.items[0];
    if (normalsFit_)
    {
      mesh_.normals.doubles = PlainArray<double>(mesh_.points.doubles.size());
    }
    colors_ = PlainArray<float>(hasColors_ ? mesh_.points.doubles.size() : 0);
    const bool hasTexture = wantsTexture_ && all.items[1] > 0;
    texture_ = PlainArray<float>(hasTexture ? 2 * static_cast<std::size_t>(all.items[1]) : 0);
    cornerTexture_ =
      PlainArray<std::int64_t>(hasTexture ? static_cast<std::size_t>(all.corners[2]) : 0);
    for (int kind = 0; kind < 3; ++kind)
    {
      if (all.cells[kind] > 0)
      {
        CellArrays& into = this->cells(kind);
        into.offsets = PlainArray<std::int64_t>(static_cast<std::size_t>(all.cells[kind]) + 1);
        into.offsets[0] = 0;
        into.connectivity = PlainArray<std::int64_t>(static_cast<std::size_t>(all.corners[kind]));
      }
    }
  }

  void parseAll()
  {
    this->allocate();
    runOrderedBlocks(
      blocks_.count(), [this](std::size_t block) { this->parse(block); }, executor_);
  }

  void parse(std::size_t block)
  {
    const TextBlock text = blocks_.read(block);
    const Counts& limit = starts_[block + 1];
    Counts at = starts_[block];
    int kind = 0;
    for (ObjLines lines(text.text()); lines.nextLine();)
    {
      const Statement statement = lines.takeStatement(kind);
      if (statement == Statement::item)
      {
        this->requirePlace(at.items[kind], limit.items[kind]);
        this->parseItem(lines, text, kind, at);
      }
      else if (statement == Statement::cell)
      {
        this->requirePlace(at.cells[kind], limit.cells[kind]);
        this->parseCell(lines, text, kind, at, limit.corners[kind]);
      }
    }
    for (kind = 0; kind < 3; ++kind)
    {
      if (at.items[kind] < limit.items[kind] || at.cells[kind] < limit.cells[kind])
      {
        file_.refuseChanged();
      }
    }
  }

  /// The file may have changed since its items were counted, and an item must not go where there is
  /// no place for it.
  void requirePlace(std::int64_t at, std::int64_t limit) const
  {
    if (at >= limit)
    {
      file_.refuseChanged();
    }
  }

  [[noreturn]] void refuse(
    const ObjLines& lines, const TextBlock& text, const std::string& message) const
  {
    file_.refuseLine(text.offsetOf(lines.line()), message);
  }

  void parseItem(ObjLines& lines, const TextBlock& text, int kind, Counts& at)
  {
    double values[3] = {0, 0, 0};
    for (int i = 0; i < leastNumbers[kind]; ++i)
    {
      if (!lines.takeNumber(values[i]))
      {
        this->refuse(lines, text,
          std::string("a ") + itemNames[kind] + " without its numbers; it is truncated or damaged");
      }
    }
    double* const into = kind == 0   ? mesh_.points.doubles.data()
                         : kind == 2 ? mesh_.normals.doubles.data()
                                     : nullptr;
    if (into)
    {
      std::memcpy(into + 3 * at.items[kind], values, sizeof values);
    }
    if (kind == 0 && hasColors_)
    {
      this->parseColor(lines, static_cast<std::size_t>(at.items[kind]));
    }
    else if (kind == 0 && !lines.rest().empty() && takeThree(lines, values))
    {
      seesColors_ = true;
    }
    if (kind == 1 && !texture_.empty())
    {
      lines.takeNumber(values[1]); // 0 where there is none
      std::copy_n(values, 2, texture_.data() + 2 * at.items[kind]);
    }
    ++at.items[kind];
  }

  /// Takes a position or a colour off a line. Returns whether it is there.
  static bool takeThree(ObjLines& lines, double (&values)[3])
  {
    return lines.takeNumber(values[0]) && lines.takeNumber(values[1]) &&
           lines.takeNumber(values[2]);
  }

  void parseColor(ObjLines& lines, std::size_t vertex)
  {
    double color[3];
    const bool isThere = takeThree(lines, color);
    lacksColors_ = lacksColors_ || !isThere;
    std::transform(color, color + 3, colors_.data() + 3 * vertex,
      [isThere](double value) { return isThere ? static_cast<float>(value) : noColor; });
  }

  void parseCell(
    ObjLines& lines, const TextBlock& text, int kind, Counts& at, std::int64_t cornerLimit)
  {
    CellArrays& into = this->cells(kind);
    const std::int64_t first = at.corners[kind];
    for (std::string_view word = lines.takeCorner(); !word.empty(); word = lines.takeCorner())
    {
      this->requirePlace(at.corners[kind], cornerLimit);
      const auto corner = static_cast<std::size_t>(at.corners[kind]++);
      if (kind == 2 && !cornerTexture_.empty())
      {
        cornerTexture_[corner] = this->textureOf(word, at);
      }
      into.connectivity[corner] = this->parseCorner(lines, text, word, at);
    }
    const std::int64_t corners = at.corners[kind] - first;
    if (corners < leastCorners[kind])
    {
      this->refuse(lines, text,
        std::string("a ") + cellNames[kind] + " with " + std::to_string(corners) +
          " corners, which needs " +
          (kind == 2    ? "three"
            : kind == 1 ? "two"
                        : "one") +
          "; it is truncated or damaged");
    }
    into.offsets[static_cast<std::size_t>(++at.cells[kind])] = at.corners[kind];
  }

  /// The vertex of a corner, from 0 on. A corner is v, v/vt, v//vn or v/vt/vn.
  std::int64_t parseCorner(
    const ObjLines& lines, const TextBlock& text, std::string_view word, const Counts& at)
  {
    const std::string_view parts[] = {takePart(word), takePart(word), takePart(word)};
    std::int64_t vertex = 0, normal = 0;
    if (!this->findItem(parts[0], 0, at, vertex))
    {
      this->refuse(lines, text,
        std::string(itemNames[0]) + " " + std::string(parts[0].substr(0, 20)) +
          " does not exist; there are " + std::to_string(starts_.back().items[0]) +
          ", counted from 1");
    }
    // Normals are used only where each vertex has its own.
    if (!parts[2].empty() && normalsFit_ &&
        (!this->findItem(parts[2], 2, at, normal) || normal != vertex))
    {
      normalsFit_ = false;
    }
    return vertex;
  }

  /// Returns the texture coordinates of a corner, from 0 on, or -1 where there are none.
  std::int64_t textureOf(std::string_view word, const Counts& at) const
  {
    takePart(word);
    std::int64_t texture = 0;
    return this->findItem(takePart(word), 1, at, texture) ? texture : -1;
  }

  /// Takes the text up to the next slash off a word, and the slash.
  static std::string_view takePart(std::string_view& word)
  {
    const std::size_t slash = std::min(word.find('/'), word.size());
    const std::string_view part = word.substr(0, slash);
    word.remove_prefix(std::min(slash + 1, word.size()));
    return part;
  }

  /// Finds the item of a kind that a part of a corner names, from 0 on. Returns whether it exists.
  bool findItem(std::string_view part, int kind, const Counts& at, std::int64_t& item) const
  {
    const std::int64_t all = starts_.back().items[kind], before = at.items[kind];
    std::int64_t index = 0;
    if (!parseInteger(part, index) || index == 0 || index > all || index < -before)
    {
      return false;
    }
    item = index > 0 ? index - 1 : before + index;
    return true;
  }

  const InputFile& file_;
  bool wantsTexture_;
  LineBlocks blocks_;
  std::vector<Counts> starts_;        ///< what is in the file before each block; the last is all
  std::vector<RegionStarts> regions_; ///< of each block
  Executor& executor_;
  MeshArrays mesh_;
  bool hasColors_ = false;
  PlainArray<float> colors_;               ///< three for each vertex
  PlainArray<float> texture_;              ///< two for each vt
  PlainArray<std::int64_t> cornerTexture_; ///< of the corners of polygons
  std::atomic<bool> normalsFit_{false};
  std::atomic<bool> lacksColors_{false};
  std::atomic<bool> seesColors_{false}; ///< which are not read yet
};

} // namespace

MeshArrays readObj(const InputFile& file, Executor& executor)
{
  return ObjParser(file, false, executor).run();
}

MeshArrays readObjColumns(const InputFile& file, const ColumnWishes& wishes, Executor& executor)
{
  return ObjParser(file, wishes.others, executor).run();
}

} // namespace winding
