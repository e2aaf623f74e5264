#include "input/ReadInput.h"

#include "files/SinglePrecision.h"
#include "files/Suffix.h"
#include "input/ContentCheck.h"
#include "input/ReaderProcess.h"
#include "input/RunReader.h"
#include "input/VtkReaders.h"
#include "program/Failure.h"
#include "program/Messages.h"

#include "vtkGeomviewOFFReader.h"
#include "vtkNew.h"
#include "vtkOrientedPointsReader.h"
#include "vtkPointTableReader.h"
#include "vtkPolyData.h"
#include "vtkSurfaceMeshReader.h"

namespace
{

/// Reads a file with a reader of the module, which believes nothing that the file does not hold.
template <class Reader>
vtkSmartPointer<vtkPointSet> readBy(Reader* reader, const std::string& fileName, Messages& messages)
{
  reader->SetFileName(fileName.c_str());
  runReader(reader, fileName, messages);
  return reader->GetOutput();
}

/// Warns where coordinates are in single precision, and lie so far from the origin that rounding
/// to it has moved them.
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
  const std::string suffix = suffixOf(fileName);
  const VtkFormat* const format = vtkFormatOf(suffix);
  const bool isMesh = suffix == ".obj" || suffix == ".ply" || suffix == ".stl";
  const bool isOfModule = isMesh || suffix == ".off" || suffix == ".xyz" || suffix == ".pwn";
  if (!format && !isTable(fileName) && !isOfModule)
  {
    throw Failure(EXIT_REFUSED, fileName,
      "has a suffix that is not known; give one of .vtp .vtk .vtu .ply .stl .obj .off .xyz .pwn "
      ".csv");
  }
  checkContentFits(fileName);
  if (format)
  {
    return readInProcess(fileName, *format, messages);
  }
  if (isTable(fileName))
  {
    vtkNew<vtkPointTableReader> reader;
    reader->ReadAllColumnsOff();
    return readBy(reader.Get(), fileName, messages);
  }
  if (isMesh)
  {
    return readBy(vtkNew<vtkSurfaceMeshReader>().Get(), fileName, messages);
  }
  return suffix == ".off" ? readBy(vtkNew<vtkGeomviewOFFReader>().Get(), fileName, messages)
                          : readBy(vtkNew<vtkOrientedPointsReader>().Get(), fileName, messages);
}

} // namespace

vtkSmartPointer<vtkPointSet> readInput(const std::string& fileName, Messages& messages)
{
  messages.setSubject(fileName);
  auto data = read(fileName, messages);
  warnOfLostDigits(data, fileName, messages);
  return data;
}
