#include "WriteOutput.h"

#include "Failure.h"
#include "Interrupt.h"
#include "Messages.h"
#include "Options.h"
#include "OutputFile.h"
#include "Progress.h"
#include "SinglePrecision.h"

#include "vtkAppendFilter.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkOBJWriter.h"
#include "vtkPLYWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSTLWriter.h"
#include "vtkTriangleFilter.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLImageDataWriter.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

namespace
{

/// Writes and commits; the writer's input is set.
template <class Writer>
void run(Writer* writer, OutputFile& file, const Options& options, Messages& messages,
  const std::function<void()>& check = interrupt::check)
{
  const Progress progress(writer, "write", options.quiet);
  writer->SetFileName(file.temporaryName().c_str());
  writer->Write();
  check();
  if (writer->GetErrorCode() != vtkErrorCode::NoError)
  {
    file.refuseWriting(); // the messages are but consequences
  }
  messages.throwIfError(file.name());
  file.commit();
}

/// Raw bytes behind the XML, lightly packed: the smallest and quickest that every VTK reads.
void configureXml(vtkXMLWriter* writer)
{
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetHeaderTypeToUInt64();
  writer->SetCompressorTypeToLZ4();
}

/// Throws Failure where single precision cannot hold the places, and warns where it moves them.
void checkSinglePrecision(vtkPolyData* surface, const OutputFile& file, Messages& messages)
{
  switch (singlePrecisionOf(surface))
  {
  case SinglePrecision::holds:
    return;
  case SinglePrecision::movesPoints:
    messages.warn(file.name() +
                  ": the format keeps single precision, and so far from the origin that vertices "
                  "move by more than a ten-thousandth of the size; .vtp keeps what they are");
    return;
  case SinglePrecision::collapsesPoints:
    throw Failure(REFUSED, file.name(),
      "the format keeps single precision, in which points so far from the origin fall together; "
      "give it the suffix .vtp");
  case SinglePrecision::isExceeded:
    throw Failure(REFUSED, file.name(),
      "the format keeps single precision, which coordinates of this size are beyond; give it the "
      "suffix .vtp");
  }
}

void writeStl(vtkPolyData* surface, OutputFile& file, const Options& options, Messages& messages)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  vtkNew<vtkSTLWriter> writer;
  writer->SetInputConnection(triangles->GetOutputPort());
  writer->SetFileTypeToBinary();
  run(writer.Get(), file, options, messages);
}

vtkSmartPointer<vtkUnstructuredGrid> asUnstructuredGrid(vtkPointSet* points)
{
  if (points->GetNumberOfCells() > 0)
  {
    vtkNew<vtkAppendFilter> append; // takes anything
    append->SetInputData(points);
    append->Update();
    return append->GetOutput();
  }
  // That would have no array of cells at all, which the writer follows all the same.
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points->GetPoints());
  grid->Allocate(0);
  grid->GetPointData()->ShallowCopy(points->GetPointData());
  grid->GetFieldData()->ShallowCopy(points->GetFieldData());
  return grid;
}

} // namespace

void writeImage(vtkAlgorithmOutput* image, OutputFile& file, const Options& options,
  Messages& messages, const std::function<void()>& check)
{
  vtkNew<vtkXMLImageDataWriter> writer;
  configureXml(writer);
  writer->SetInputConnection(image);
  writer->SetNumberOfPieces(options.pieces);
  run(writer.Get(), file, options, messages, check);
}

void writeSurface(
  vtkPolyData* surface, OutputFile& file, const Options& options, Messages& messages)
{
  const std::string suffix = suffixOf(file.name());
  if (suffix == ".stl" || suffix == ".ply")
  {
    checkSinglePrecision(surface, file, messages);
  }
  if (suffix == ".stl")
  {
    writeStl(surface, file, options, messages);
  }
  else if (suffix == ".ply")
  {
    vtkNew<vtkPLYWriter> writer;
    writer->SetInputData(surface);
    run(writer.Get(), file, options, messages);
  }
  else if (suffix == ".obj")
  {
    vtkNew<vtkOBJWriter> writer;
    writer->SetInputData(surface);
    run(writer.Get(), file, options, messages);
  }
  else
  {
    vtkNew<vtkXMLPolyDataWriter> writer;
    configureXml(writer);
    writer->SetInputData(surface);
    run(writer.Get(), file, options, messages);
  }
}

void writePoints(vtkPointSet* points, OutputFile& file, const Options& options, Messages& messages)
{
  if (suffixOf(file.name()) == ".vtu")
  {
    const auto grid = asUnstructuredGrid(points);
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    configureXml(writer);
    writer->SetInputData(grid);
    run(writer.Get(), file, options, messages);
    return;
  }
  vtkPolyData* surface = vtkPolyData::SafeDownCast(points);
  if (!surface)
  {
    throw Failure(
      REFUSED, file.name(), "cannot hold the cells of the queries; give it the suffix .vtu");
  }
  writeSurface(surface, file, options, messages);
}
