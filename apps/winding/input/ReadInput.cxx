#include "input/ReadInput.h"

#include "files/FileAccess.h"
#include "files/SinglePrecision.h"
#include "files/Suffix.h"
#include "input/ContentCheck.h"
#include "input/FileGuards.h"
#include "input/MemoryBudget.h"
#include "input/Table.h"
#include "program/Failure.h"
#include "program/Interrupt.h"
#include "program/Messages.h"
#include "program/Progress.h"

#include "vtkCellArray.h"
#include "vtkCellTypes.h"
#include "vtkDataSetReader.h"
#include "vtkErrorCode.h"
#include "vtkGenericCell.h"
#include "vtkGeomviewOFFReader.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkOrientedPointsReader.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <new>
#include <stdexcept>

namespace
{

/// Makes a reader of a class for a file.
template <class Reader> vtkSmartPointer<vtkAlgorithm> plain(const std::string& fileName)
{
  const auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(fileName.c_str());
  return reader;
}

vtkSmartPointer<vtkAlgorithm> stl(const std::string& fileName)
{
  guardStl(fileName);
  const auto reader = vtkSmartPointer<vtkSTLReader>::New();
  reader->SetFileName(fileName.c_str());
  reader->MergingOff(); // the filters weld, and count what they weld
  return reader;
}

vtkSmartPointer<vtkAlgorithm> ply(const std::string& fileName)
{
  guardPly(fileName);
  const auto reader = vtkSmartPointer<vtkPLYReader>::New();
  reader->SetFileName(fileName.c_str());
  std::string text = contentsOf(fileName);
  const bool isText =
    text.substr(0, text.find("end_header")).find("format ascii") != std::string::npos;
  if (isText && text.back() != '\n')
  {
    // VTK ends the program where the last line has no end.
    reader->ReadFromInputStringOn();
    reader->SetInputString(text + "\n");
  }
  return reader;
}

vtkSmartPointer<vtkAlgorithm> obj(const std::string& fileName)
{
  guardObj(fileName);
  return plain<vtkOBJReader>(fileName);
}

template <class Reader> vtkSmartPointer<vtkAlgorithm> xmlVtk(const std::string& fileName)
{
  guardXmlVtk(fileName);
  return plain<Reader>(fileName);
}

vtkSmartPointer<vtkAlgorithm> legacyVtk(const std::string& fileName)
{
  guardLegacyVtk(fileName);
  const auto reader = vtkSmartPointer<vtkDataSetReader>::New();
  reader->SetFileName(fileName.c_str());
  // By default the reader takes the first array of each kind only.
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllFieldsOn();
  return reader;
}

using MakeReader = vtkSmartPointer<vtkAlgorithm> (*)(const std::string& fileName);

/// The function that makes a reader for a file, by its suffix. Throws Failure for a suffix without
/// one.
MakeReader readerFor(const std::string& fileName)
{
  const std::pair<const char*, MakeReader> readers[] = {
    {".vtp", xmlVtk<vtkXMLPolyDataReader>},
    {".vtu", xmlVtk<vtkXMLUnstructuredGridReader>},
    {".vtk", legacyVtk},
    {".ply", ply},
    {".stl", stl},
    {".obj", obj},
    {".off", plain<vtkGeomviewOFFReader>},
    {".xyz", plain<vtkOrientedPointsReader>},
    {".pwn", plain<vtkOrientedPointsReader>},
  };
  const std::string suffix = suffixOf(fileName);
  for (const auto& [name, maker] : readers)
  {
    if (suffix == name)
    {
      return maker;
    }
  }
  throw Failure(REFUSED, fileName,
    "has a suffix that is not known; give one of .vtp .vtk .vtu .ply .stl .obj .off .xyz .pwn "
    ".csv");
}

[[noreturn]] void refuseCells(const std::string& fileName)
{
  throw Failure(REFUSED, fileName, "has cells that contradict each other; it is damaged");
}

/// Throws Failure for offsets that lead out of their array, since filters would follow them.
void checkOffsets(const std::string& fileName, vtkCellArray* cells)
{
  if (cells && !cells->IsValid())
  {
    refuseCells(fileName);
  }
}

/// Throws Failure for ids of points that do not exist and for cells without all of their corners:
/// the surface filter that a grid goes through believes them.
void checkGrid(const std::string& fileName, vtkUnstructuredGrid* grid)
{
  vtkCellArray* cells = grid->GetCells();
  const vtkIdType points = grid->GetNumberOfPoints();
  vtkUnsignedCharArray* types = grid->GetCellTypesArray();
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return;
  }
  if (!types || types->GetNumberOfTuples() != cells->GetNumberOfCells())
  {
    refuseCells(fileName);
  }
  vtkNew<vtkGenericCell> cell;
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    cells->GetCellAtId(i, size, ids);
    const int type = types->GetValue(i);
    if (!vtkCellTypes::GetClassNameFromTypeId(type) || vtkCellTypes::IsLinear(type) == 0)
    {
      // Cells of higher order, and of unknown types, may have any number of points.
      cell->SetCellType(VTK_EMPTY_CELL);
    }
    else if (cell->GetCellType() != type)
    {
      cell->SetCellType(type);
    }
    const bool idsExist =
      std::all_of(ids, ids + size, [points](vtkIdType id) { return id >= 0 && id < points; });
    if (!idsExist || size < cell->GetNumberOfPoints())
    {
      refuseCells(fileName);
    }
  }
}

void checkCells(const std::string& fileName, vtkPointSet* data)
{
  if (auto* polyData = vtkPolyData::SafeDownCast(data))
  {
    checkOffsets(fileName, polyData->GetVerts());
    checkOffsets(fileName, polyData->GetLines());
    checkOffsets(fileName, polyData->GetPolys());
    checkOffsets(fileName, polyData->GetStrips());
  }
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    checkOffsets(fileName, grid->GetCells());
    checkGrid(fileName, grid);
  }
}

vtkSmartPointer<vtkPointSet> readWith(
  vtkAlgorithm* reader, const std::string& fileName, Messages& messages)
{
  const Progress progress(reader, "read", messages.isQuiet());
  reader->Update();
  interrupt::check();
  messages.throwIfError(fileName);
  if (reader->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw Failure(REFUSED, fileName,
      std::string("cannot be read: ") +
        vtkErrorCode::GetStringFromErrorCode(reader->GetErrorCode()));
  }
  vtkDataObject* output = reader->GetOutputDataObject(0);
  vtkSmartPointer<vtkPointSet> data = vtkPointSet::SafeDownCast(output);
  if (!data)
  {
    throw Failure(REFUSED, fileName,
      std::string("holds ") + (output ? output->GetClassName() : "nothing") +
        "; a surface, an unstructured grid or points are needed");
  }
  checkCells(fileName, data);
  return data;
}

/// Warns where single precision, which VTK's readers of OBJ, PLY and STL keep, moves vertices
/// because they lie far from the origin.
void warnOfLostDigits(vtkPointSet* data, const std::string& fileName, Messages& messages)
{
  if (data->GetNumberOfPoints() == 0 || data->GetPoints()->GetDataType() != VTK_FLOAT)
  {
    return;
  }
  const SinglePrecision precision = singlePrecisionOf(data);
  if (precision == SinglePrecision::movesPoints || precision == SinglePrecision::collapsesPoints)
  {
    messages.warn(
      fileName + ": its coordinates are kept in single precision, and so far from the " +
      "origin that vertices move by more than a ten-thousandth of its size; move it to " +
      "the origin, or use .vtp or .off with double precision");
  }
}

vtkSmartPointer<vtkPointSet> read(const std::string& fileName, Messages& messages)
{
  if (isTable(fileName))
  {
    checkContentFits(fileName);
    return cloudFrom(Table(fileName));
  }
  const MakeReader makeReader = readerFor(fileName);
  checkContentFits(fileName);
  const auto data = readWith(makeReader(fileName), fileName, messages);
  warnOfLostDigits(data, fileName, messages);
  return data;
}

} // namespace

vtkSmartPointer<vtkPointSet> readInput(const std::string& fileName, Messages& messages)
{
  messages.setSubject(fileName);
  std::error_code error;
  const std::uintmax_t found = std::filesystem::file_size(fileName, error);
  const std::uintmax_t size = error ? 0 : found;
  try
  {
    const MemoryBudget budget(size);
    return read(fileName, messages);
  }
  catch (const std::length_error&)
  {
    throw Failure(REFUSED, fileName, "its counts ask for more than there can be; it is damaged");
  }
  catch (const std::bad_alloc&)
  {
    // A small file that asks for all memory is not to be believed.
    if (!error && size < (std::uintmax_t(1) << 28))
    {
      throw Failure(
        REFUSED, fileName, "its counts ask for more memory than there is; it is damaged");
    }
    throw Failure(NO_MEMORY, fileName, "does not fit into memory; use a smaller one");
  }
}
