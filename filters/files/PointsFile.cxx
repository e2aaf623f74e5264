// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/PointsFile.h"

#include "base/Progress.h"
#include "files/ColumnNames.h"
#include "files/ContentLines.h"
#include "files/Words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace winding
{

namespace
{

/// The shortest point is "0 0 0\n".
constexpr std::size_t bytesPerPoint = 6;

/// The arrangement of the points in the file.
struct Layout
{
  std::size_t points = 0;
  std::size_t firstLine = 0; ///< the number of the line of the first point
  std::size_t numbersPerLine = 3;
  std::array<std::size_t, 3> position = {0, 1, 2};
  std::array<std::size_t, 3> normal = {3, 4, 5};
  std::optional<std::size_t> area;
  std::array<std::size_t, 3> viewpoint = {};
  std::vector<std::string> names; ///< of all columns; none where they have none
  bool hasNormals = false;
  bool hasViewpoints = false;
  bool hasNames = false;
  bool normalsFollow = false; ///< in lines of their own, after all positions
};

/// Whether commas are decimal points in a line of numbers: there are three words with one at most,
/// and none at their ends.
bool hasDecimalCommas(std::string_view line)
{
  const char* at = line.data();
  const char* const end = at + line.size();
  std::size_t words = 0;
  for (std::string_view word = takeWord(at, end); !word.empty(); word = takeWord(at, end))
  {
    if (std::count(word.begin(), word.end(), ',') > 1 || word.front() == ',' || word.back() == ',')
    {
      return false;
    }
    ++words;
  }
  return words >= 3;
}

/// Returns what stands for commas and semicolons, by the first line of numbers that has any.
Letters lettersOf(const InputFile& file)
{
  constexpr std::size_t looked = 1 << 16;
  const std::size_t start = file.textStart();
  std::string text(std::min(looked, file.size() - start), ' ');
  file.readText(start, text.data(), text.size());
  std::size_t next = 0;
  while (next < text.size())
  {
    const std::size_t end = std::min(text.find('\n', next), text.size());
    const std::string_view line =
      std::string_view(text).substr(next, std::min(text.find('#', next), end) - next);
    next = end + 1;
    if (line.find(';') != std::string_view::npos)
    {
      return {'.', ' '};
    }
    const std::size_t comma = line.find(',');
    if (comma != std::string_view::npos && line.find_first_of("0123456789") < comma)
    {
      return {hasDecimalCommas(line) ? '.' : ' ', ';'};
    }
  }
  return {' ', ';'};
}

/// The words of a line of names, without the slashes that CloudCompare writes before them. None
/// where the line begins with a number.
std::vector<std::string> namesIn(LineScanner words)
{
  std::vector<std::string> names;
  double value = 0;
  if (words.tryNumber(value))
  {
    return names;
  }
  for (std::string_view word = words.word(); !word.empty(); word = words.word())
  {
    word.remove_prefix(names.empty() && word.substr(0, 2) == "//" ? 2 : 0);
    if (!word.empty())
    {
      names.emplace_back(word);
    }
  }
  return names;
}

/// The words of the last of the comments before the first line, which may be names.
std::vector<std::string> wordsOfComment(const InputFile& file)
{
  constexpr std::size_t looked = 4096;
  const std::size_t start = file.textStart();
  std::string text(std::min(looked, file.size() - start), ' ');
  file.readText(start, text.data(), text.size());
  std::istringstream lines(text);
  std::string line, comment;
  while (std::getline(lines, line) && !line.empty() && line.front() == '#')
  {
    comment = line.substr(1);
  }
  std::replace(comment.begin(), comment.end(), ',', ' ');
  std::istringstream words(comment);
  return {std::istream_iterator<std::string>(words), std::istream_iterator<std::string>()};
}

/// Takes columns by their names. Returns whether all are there.
bool takeColumns(ColumnMeaning meaning, const std::vector<std::string>& names,
  const ColumnChoice& choice, std::array<std::size_t, 3>& columns)
{
  const std::vector<std::size_t> found = columnsOf(meaning, names, choice);
  std::copy(found.begin(), found.end(), columns.begin());
  return !found.empty();
}

Layout findLayout(const InputFile& file, const ContentLines& lines, const ColumnChoice& choice)
{
  FirstLines first(lines);
  if (!first.nextLine())
  {
    file.refuseEnd("it holds no points");
  }
  Layout layout;
  std::vector<std::string> names = namesIn(first.words());
  const bool isComment = first.words().rest().substr(0, 2) == "//";
  layout.hasNames = takeColumns(ColumnMeaning::positions, names, choice, layout.position);
  if ((layout.hasNames || isComment) && !first.nextLine())
  {
    file.refuseEnd("it holds no points");
  }
  layout.firstLine = layout.hasNames || isComment ? 1 : 0;
  const bool hasCount = first.words().wordsLeft() == 1;
  const auto promised = static_cast<std::size_t>(
    hasCount ? first.words().count("the number of points", bytesPerPoint) : 0);
  layout.firstLine += hasCount ? 1 : 0;
  if (hasCount && !first.nextLine())
  {
    if (promised == 0)
    {
      return layout;
    }
    file.refuseEnd("it promises " + std::to_string(promised) + " points but has none");
  }
  layout.numbersPerLine = first.words().wordsLeft();
  if (!layout.hasNames)
  {
    const std::vector<std::string> words = wordsOfComment(file);
    layout.hasNames = words.size() == layout.numbersPerLine &&
                      takeColumns(ColumnMeaning::positions, words, choice, layout.position);
    names = layout.hasNames ? words : names;
  }
  if (!layout.hasNames && !choice.empty())
  {
    names = names.empty() ? numberedColumns(layout.numbersPerLine) : names;
    choice.check(file, names);
    layout.hasNames = takeColumns(ColumnMeaning::positions, names, choice, layout.position);
  }
  if (layout.hasNames)
  {
    choice.check(file, names);
    layout.hasNormals = takeColumns(ColumnMeaning::normals, names, choice, layout.normal);
    layout.hasViewpoints = takeColumns(ColumnMeaning::viewpoints, names, choice, layout.viewpoint);
    const std::vector<std::size_t> areas = columnsOf(ColumnMeaning::areas, names, choice);
    layout.area = areas.empty() ? std::nullopt : std::optional<std::size_t>(areas[0]);
    if (layout.numbersPerLine != names.size())
    {
      first.words().refuse("holds " + std::to_string(layout.numbersPerLine) +
                           " words, but the first line has " + std::to_string(names.size()) +
                           " names; write one for each column");
    }
    layout.names = std::move(names);
  }
  else if (layout.numbersPerLine != 3 && layout.numbersPerLine != 6)
  {
    first.words().refuse("holds " + std::to_string(layout.numbersPerLine) +
                         " words; a point is x y z or x y z nx ny nz; where there are others, name "
                         "all in a line before, as in x y z r g b nx ny nz");
  }
  const std::size_t found = lines.count() - layout.firstLine;
  layout.points = hasCount ? promised : found;
  layout.normalsFollow = hasCount && layout.numbersPerLine == 3 && found == 2 * promised;
  layout.hasNormals |= layout.normalsFollow || (!layout.hasNames && layout.numbersPerLine == 6);
  if (!layout.normalsFollow && found != layout.points)
  {
    first.words().refuse("the file promises " + std::to_string(promised) + " points, but " +
                         std::to_string(found) + " lines follow; it is truncated or damaged");
  }
  return layout;
}

void copyVector(
  const std::vector<double>& numbers, const std::array<std::size_t, 3>& columns, double* into)
{
  std::transform(columns.begin(), columns.end(), into,
    [&numbers](std::size_t column) { return numbers[column]; });
}

/// A column that is read as it is.
struct OtherColumn
{
  std::size_t column;
  double* numbers; ///< one for each point
};

/// Makes room for the columns that have no meaning, and appends them to `others`.
std::vector<OtherColumn> addOthers(const Layout& layout, std::vector<OtherNumbers>& others)
{
  std::set<std::size_t> used(layout.position.begin(), layout.position.end());
  std::set<std::string> taken;
  if (layout.hasNormals)
  {
    used.insert(layout.normal.begin(), layout.normal.end());
    taken.insert("Normals");
  }
  if (layout.area)
  {
    used.insert(*layout.area);
    taken.insert("Area");
  }
  if (layout.hasViewpoints)
  {
    used.insert(layout.viewpoint.begin(), layout.viewpoint.end());
    taken.insert("Viewpoints");
  }
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < layout.names.size(); ++i)
  {
    if (used.count(i) == 0)
    {
      columns.push_back(i);
    }
  }
  std::vector<OtherColumn> targets;
  for (const std::string& name : namesOfArrays(columns, layout.names, taken))
  {
    OtherNumbers& other = others.emplace_back();
    other.name = name;
    other.numbers = PlainArray<double>(layout.points);
    targets.push_back({columns[targets.size()], other.numbers.data()});
  }
  return targets;
}

/// Reads the lines of a part into positions, normals, areas, viewpoints and other columns.
void readPart(ContentLines::Part& part, const Layout& layout,
  const std::vector<OtherColumn>& others, MeshArrays& mesh)
{
  std::vector<double> numbers(layout.numbersPerLine);
  while (part.nextLine())
  {
    LineScanner& words = part.words();
    for (double& number : numbers)
    {
      number = words.number("a number");
    }
    if (!words.word().empty())
    {
      words.refuse("holds more than the " + std::to_string(layout.numbersPerLine) +
                   " numbers of the lines before");
    }
    const std::size_t line = part.number() - layout.firstLine;
    if (line >= layout.points)
    {
      copyVector(numbers, layout.position, &mesh.normals.doubles[3 * (line - layout.points)]);
      continue;
    }
    copyVector(numbers, layout.position, &mesh.points.doubles[3 * line]);
    if (layout.hasNormals && !layout.normalsFollow)
    {
      copyVector(numbers, layout.normal, &mesh.normals.doubles[3 * line]);
    }
    if (layout.area)
    {
      mesh.areas[line] = numbers[*layout.area];
    }
    if (layout.hasViewpoints)
    {
      copyVector(numbers, layout.viewpoint, &mesh.viewpoints[3 * line]);
    }
    for (const OtherColumn& other : others)
    {
      other.numbers[line] = numbers[other.column];
    }
  }
}

/// The number that stands for full intensity if vectors are colours; none if they are normals.
/// Colours may be means of others. Of a few vectors, fractions beyond 1 are taken for normals.
std::optional<double> intensityOfVectors(const PlainArray<double>& vectors)
{
  constexpr double most = 65535, tolerance = 0.01;
  constexpr std::size_t few = 16;
  bool areWhole = true;
  double largest = 0;
  std::size_t finite = 0, units = 0;
  for (const double* at = vectors.begin(); at < vectors.end(); at += 3)
  {
    const double length = std::hypot(at[0], at[1], at[2]);
    if (!std::isfinite(length))
    {
      continue;
    }
    for (int i = 0; i < 3; ++i)
    {
      areWhole = areWhole && at[i] == std::floor(at[i]);
      largest = std::max(largest, at[i]);
      if (at[i] < 0 || at[i] > most)
      {
        return {};
      }
    }
    ++finite;
    units += std::abs(length - 1) < tolerance ? 1 : 0;
  }
  const bool areOdd = !areWhole && largest > 1 && finite < few;
  if (largest == 0 || areOdd || 2 * units >= finite)
  {
    return {};
  }
  return intensityOf(largest);
}

/// Makes colours of normals that are some.
void tellColors(MeshArrays& mesh)
{
  PlainArray<double>& vectors = mesh.normals.doubles;
  const std::optional<double> intensity = intensityOfVectors(vectors);
  if (!intensity)
  {
    return;
  }
  mesh.colors = PlainArray<std::uint8_t>(vectors.size());
  mesh.colorComponents = 3;
  std::transform(vectors.begin(), vectors.end(), mesh.colors.begin(),
    [&intensity](double value)
    {
      return static_cast<std::uint8_t>(
        std::isfinite(value) ? std::lround(255 * value / *intensity) : 0);
    });
  mesh.normals = {};
  mesh.notes.push_back({"columns 4 to 6 are taken for colours",
    {{"estimate normals", {{Parameter::estimateNormals, 1}}},
      {"if they are normals, name them x y z nx ny nz in a line before", {}}},
    "the points have no normals"});
}

} // namespace

MeshArrays readPoints(const InputFile& file, Executor& executor)
{
  return readPointColumns(file, {}, executor);
}

MeshArrays readPointColumns(const InputFile& file, const ColumnWishes& wishes, Executor& executor)
{
  Progress progress(executor);
  progress.set(0, 0.2); // counting takes a fifth of the time
  const ContentLines lines(file, executor, lettersOf(file));
  const Layout layout = findLayout(file, lines, wishes.chosen);
  MeshArrays mesh;
  mesh.points.doubles = PlainArray<double>(3 * layout.points);
  mesh.normals.doubles = PlainArray<double>(layout.hasNormals ? 3 * layout.points : 0);
  mesh.areas = PlainArray<double>(layout.area ? layout.points : 0);
  mesh.viewpoints = PlainArray<double>(layout.hasViewpoints ? 3 * layout.points : 0);
  const std::vector<OtherColumn> targets =
    wishes.others ? addOthers(layout, mesh.others) : std::vector<OtherColumn>();
  progress.set(0.2, 1);
  lines.visit(
    layout.firstLine, lines.count(),
    [&](std::size_t, ContentLines::Part& part) { readPart(part, layout, targets, mesh); },
    executor);
  if (!layout.hasNames && !layout.normalsFollow)
  {
    tellColors(mesh);
  }
  mesh.vertices = oneCellOf(layout.points);
  return mesh;
}

} // namespace winding
