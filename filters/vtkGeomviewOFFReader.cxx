#include "vtkGeomviewOFFReader.h"

#include "private/ErrorReports.h"
#include "private/TextScanner.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <numeric>
#include <vector>

vtkStandardNewMacro(vtkGeomviewOFFReader);

namespace
{

/// The shortest vertex is "0 0 0\n", the shortest face "1 0\n".
constexpr std::size_t bytesPerVertex = 6;
constexpr std::size_t bytesPerFace = 4;

struct Header
{
  bool hasNormals = false;
  std::int64_t vertices = 0;
  std::int64_t faces = 0;
};

bool takePrefix(std::string_view& word, std::string_view prefix)
{
  const bool there = word.substr(0, prefix.size()) == prefix;
  word.remove_prefix(there ? prefix.size() : 0);
  return there;
}

Header readHeader(TextScanner& scanner)
{
  Header header;
  std::string_view keyword = scanner.nextLine() ? scanner.word() : std::string_view();
  takePrefix(keyword, "ST");
  takePrefix(keyword, "C");
  header.hasNormals = takePrefix(keyword, "N");
  if (keyword == "4OFF" || keyword == "nOFF" || keyword == "4nOFF")
  {
    scanner.refuse("vertices of other than three dimensions cannot be read");
  }
  if (keyword != "OFF")
  {
    scanner.refuse("is not an OFF file: the keyword OFF is missing");
  }
  if (scanner.wordsLeft() == 0 && !scanner.nextLine())
  {
    scanner.refuseEnd("the numbers of vertices and faces are missing");
  }
  if (scanner.wordsLeft() == 1)
  {
    scanner.refuse("binary OFF cannot be read; convert it to text");
  }
  header.vertices = scanner.count("the number of vertices", bytesPerVertex);
  header.faces = scanner.count("the number of faces", bytesPerFace);
  return header;
}

/// `read` of the `promised` items of a kind are there when the file ends.
[[noreturn]] void refuseTruncated(
  const TextScanner& scanner, const char* kind, std::int64_t read, std::int64_t promised)
{
  scanner.refuseEnd("it promises " + std::to_string(promised) + " " + kind + " but has " +
                    std::to_string(read) + "; it is truncated");
}

void readVertices(TextScanner& scanner, const Header& header, vtkPolyData* output)
{
  vtkNew<vtkDoubleArray> positions;
  positions->SetNumberOfComponents(3);
  positions->SetNumberOfTuples(header.vertices);
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(header.hasNormals ? header.vertices : 0);
  for (std::int64_t i = 0; i < header.vertices; ++i)
  {
    if (!scanner.nextLine())
    {
      refuseTruncated(scanner, "vertices", i, header.vertices);
    }
    for (vtkIdType axis = 0; axis < 3; ++axis)
    {
      positions->SetValue(3 * i + axis, scanner.number("a coordinate"));
    }
    for (vtkIdType axis = 0; header.hasNormals && axis < 3; ++axis)
    {
      normals->SetValue(3 * i + axis, scanner.number("a component of the normal"));
    }
  }
  vtkNew<vtkPoints> points;
  points->SetData(positions);
  output->SetPoints(points);
  if (header.hasNormals)
  {
    output->GetPointData()->SetNormals(normals);
  }
}

void readFace(TextScanner& scanner, std::int64_t vertices, std::vector<vtkIdType>& corners)
{
  // A corner takes at least two bytes, and all stand on this line.
  const std::int64_t size = scanner.integer("the number of corners");
  if (size < 1 || static_cast<std::uint64_t>(size) > scanner.wordsLeft())
  {
    scanner.refuse("the face has " + std::to_string(size) + " corners, but " +
                   std::to_string(scanner.wordsLeft()) + " numbers follow");
  }
  corners.resize(static_cast<std::size_t>(size));
  for (vtkIdType& corner : corners)
  {
    corner = scanner.integer("the index of a vertex");
    if (corner < 0 || corner >= vertices)
    {
      scanner.refuse("vertex " + std::to_string(corner) + " does not exist; there are " +
                     std::to_string(vertices) + ", counted from 0");
    }
  }
}

void readFaces(TextScanner& scanner, const Header& header, vtkPolyData* output)
{
  vtkNew<vtkCellArray> bySize[3];
  std::vector<vtkIdType> corners;
  for (std::int64_t i = 0; i < header.faces; ++i)
  {
    if (!scanner.nextLine())
    {
      refuseTruncated(scanner, "faces", i, header.faces);
    }
    readFace(scanner, header.vertices, corners);
    const std::size_t kind = std::min<std::size_t>(corners.size(), 3) - 1;
    bySize[kind]->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
  }
  if (header.faces == 0 && header.vertices > 0)
  {
    corners.resize(static_cast<std::size_t>(header.vertices));
    std::iota(corners.begin(), corners.end(), vtkIdType(0));
    bySize[0]->InsertNextCell(header.vertices, corners.data());
  }
  output->SetVerts(bySize[0]);
  output->SetLines(bySize[1]);
  output->SetPolys(bySize[2]);
}

} // namespace

vtkGeomviewOFFReader::vtkGeomviewOFFReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkGeomviewOFFReader::~vtkGeomviewOFFReader()
{
  this->SetFileName(nullptr);
}

int vtkGeomviewOFFReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const auto read = [this, output]()
  {
    TextScanner scanner(this->FileName, this->ErrorCode);
    const Header header = readHeader(scanner);
    readVertices(scanner, header, output);
    this->UpdateProgress(scanner.fractionRead());
    readFaces(scanner, header, output);
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

void vtkGeomviewOFFReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
