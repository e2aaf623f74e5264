#include "files/PointsFile.h"

#include "base/Progress.h"
#include "files/ContentLines.h"

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
  bool normalsFollow = false; ///< in lines of their own, after all positions

  bool hasNormals() const { return normalsFollow || numbersPerLine == 6; }
};

Layout findLayout(const InputFile& file, const ContentLines& lines)
{
  FirstLines first(lines);
  if (!first.nextLine())
  {
    file.refuseEnd("it holds no points");
  }
  Layout layout;
  const bool hasCount = first.words().wordsLeft() == 1;
  const auto promised = static_cast<std::size_t>(
    hasCount ? first.words().count("the number of points", bytesPerPoint) : 0);
  layout.firstLine = hasCount ? 1 : 0;
  if (hasCount && !first.nextLine())
  {
    if (promised == 0)
    {
      return layout;
    }
    file.refuseEnd("it promises " + std::to_string(promised) + " points but has none");
  }
  layout.numbersPerLine = first.words().wordsLeft();
  if (layout.numbersPerLine != 3 && layout.numbersPerLine != 6)
  {
    first.words().refuse("holds " + std::to_string(layout.numbersPerLine) +
                         " words; a point is x y z or x y z nx ny nz");
  }
  const std::size_t found = lines.count() - layout.firstLine;
  layout.points = hasCount ? promised : found;
  layout.normalsFollow = hasCount && layout.numbersPerLine == 3 && found == 2 * promised;
  if (!layout.normalsFollow && found != layout.points)
  {
    first.words().refuse("the file promises " + std::to_string(promised) + " points, but " +
                         std::to_string(found) + " lines follow; it is truncated or damaged");
  }
  return layout;
}

void readVector(LineScanner& words, const char* what, double* into)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    into[axis] = words.number(what);
  }
}

/// Reads the lines of a part into positions and normals.
void readPart(ContentLines::Part& part, const Layout& layout, MeshArrays& mesh)
{
  while (part.nextLine())
  {
    LineScanner& words = part.words();
    const std::size_t line = part.number() - layout.firstLine;
    const bool isNormal = line >= layout.points;
    readVector(words, "a number",
      isNormal ? &mesh.normals.doubles[3 * (line - layout.points)]
               : &mesh.points.doubles[3 * line]);
    if (layout.numbersPerLine == 6)
    {
      readVector(words, "a component of the normal", &mesh.normals.doubles[3 * line]);
    }
    if (!words.word().empty())
    {
      words.refuse("holds more than the " + std::to_string(layout.numbersPerLine) +
                   " numbers of the lines before");
    }
  }
}

} // namespace

MeshArrays readPoints(const InputFile& file, Executor& executor)
{
  Progress progress(executor);
  progress.set(0, 0.2); // counting takes a fifth of the time
  const ContentLines lines(file, executor);
  const Layout layout = findLayout(file, lines);
  MeshArrays mesh;
  mesh.points.doubles = PlainArray<double>(3 * layout.points);
  mesh.normals.doubles = PlainArray<double>(layout.hasNormals() ? 3 * layout.points : 0);
  progress.set(0.2, 1);
  lines.visit(
    layout.firstLine, lines.count(),
    [&](std::size_t, ContentLines::Part& part) { readPart(part, layout, mesh); }, executor);
  mesh.vertices = oneCellOf(layout.points);
  return mesh;
}

} // namespace winding
