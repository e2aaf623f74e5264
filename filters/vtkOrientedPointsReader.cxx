#include "vtkOrientedPointsReader.h"

#include "private/ErrorReports.h"
#include "private/TextScanner.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <numeric>

vtkStandardNewMacro(vtkOrientedPointsReader);

namespace
{

/// The arrangement of the points in the file.
struct Layout
{
  vtkIdType points = 0;
  std::size_t numbersPerLine = 3;
  bool normalsFollow = false; ///< in lines of their own, after all positions

  bool hasNormals() const { return normalsFollow || numbersPerLine == 6; }
};

/// Leaves the scanner on the first line of points.
Layout findLayout(TextScanner& scanner)
{
  if (!scanner.nextLine())
  {
    scanner.refuseEnd("it holds no points");
  }
  const bool hasCount = scanner.wordsLeft() == 1;
  const std::int64_t promised = hasCount ? scanner.count("the number of points", 6) : 0;
  Layout layout;
  if (hasCount && !scanner.nextLine())
  {
    if (promised == 0)
    {
      return layout;
    }
    scanner.refuseEnd("it promises " + std::to_string(promised) + " points but has none");
  }
  layout.numbersPerLine = scanner.wordsLeft();
  if (layout.numbersPerLine != 3 && layout.numbersPerLine != 6)
  {
    scanner.refuse("holds " + std::to_string(layout.numbersPerLine) +
                   " words; a point is x y z or x y z nx ny nz");
  }
  const auto lines = static_cast<std::int64_t>(scanner.linesLeft() + 1);
  layout.points = hasCount ? promised : lines;
  layout.normalsFollow = hasCount && layout.numbersPerLine == 3 && lines == 2 * promised;
  if (!layout.normalsFollow && lines != layout.points)
  {
    scanner.refuse("the file promises " + std::to_string(promised) + " points, but " +
                   std::to_string(lines) + " lines follow; it is truncated or damaged");
  }
  return layout;
}

vtkNew<vtkDoubleArray> makeVectors(vtkIdType count)
{
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(count);
  return vectors;
}

/// Reads from the present line on, and leaves the scanner behind the last line read.
void readLines(TextScanner& scanner, const Layout& layout, double* first, double* second)
{
  for (vtkIdType i = 0; i < layout.points; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      *first++ = scanner.number("a number");
    }
    for (int axis = 0; second && axis < 3; ++axis)
    {
      *second++ = scanner.number("a component of the normal");
    }
    if (!scanner.word().empty())
    {
      scanner.refuse("holds more than the " + std::to_string(layout.numbersPerLine) +
                     " numbers of the lines before");
    }
    scanner.nextLine();
  }
}

vtkNew<vtkCellArray> oneCellOfAll(vtkIdType points)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetNumberOfTuples(points);
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + points, vtkIdType(0));
  vtkNew<vtkCellArray> cells;
  if (points > 0)
  {
    cells->InsertNextCell(points, ids->GetPointer(0));
  }
  return cells;
}

void readPoints(TextScanner& scanner, vtkPolyData* output)
{
  const Layout layout = findLayout(scanner);
  const vtkNew<vtkDoubleArray> positions = makeVectors(layout.points);
  const vtkNew<vtkDoubleArray> normals = makeVectors(layout.hasNormals() ? layout.points : 0);
  const bool sameLine = layout.numbersPerLine == 6;
  readLines(scanner, layout, positions->GetPointer(0), sameLine ? normals->GetPointer(0) : nullptr);
  if (layout.normalsFollow)
  {
    readLines(scanner, layout, normals->GetPointer(0), nullptr);
  }
  vtkNew<vtkPoints> points;
  points->SetData(positions);
  output->SetPoints(points);
  output->SetVerts(oneCellOfAll(layout.points));
  if (layout.hasNormals())
  {
    normals->SetName("Normals");
    output->GetPointData()->SetNormals(normals);
  }
}

} // namespace

vtkOrientedPointsReader::vtkOrientedPointsReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkOrientedPointsReader::~vtkOrientedPointsReader()
{
  this->SetFileName(nullptr);
}

int vtkOrientedPointsReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const auto read = [this, output]()
  {
    TextScanner scanner(this->FileName, this->ErrorCode);
    readPoints(scanner, output);
  };
  const std::string withoutMemory = std::string(this->FileName ? this->FileName : "") +
                                    ": there is not enough memory for what it holds";
  if (winding::reportErrors(this, withoutMemory, read) == winding::Outcome::done)
  {
    return 1;
  }
  output->Initialize();
  return 0;
}

void vtkOrientedPointsReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
