// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/WriteOutput.h"

#include "files/Formats.h"
#include "files/SinglePrecision.h"
#include "output/MeshFile.h"
#include "output/OutputFile.h"
#include "output/XmlNames.h"
#include "program/Failure.h"
#include "program/Interrupt.h"
#include "program/Messages.h"
#include "program/Progress.h"

#include "vtkAppendFilter.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSTLWriter.h"
#include "vtkTriangleFilter.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLDataSetWriter.h"
#include "vtkXMLImageDataWriter.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <array>

namespace
{

/// Cells of one kind, in the order in which vtkPolyData counts them, and their fewest points.
struct Kind
{
  vtkCellArray* cells;
  vtkIdType fewest;
};

std::array<Kind, 4> kindsOf(vtkPolyData* data)
{
  return {Kind{data->GetVerts(), 1}, Kind{data->GetLines(), 2}, Kind{data->GetPolys(), 3},
    Kind{data->GetStrips(), 3}};
}

vtkIdType countSmall(vtkPolyData* data)
{
  vtkIdType count = 0;
  for (const Kind& kind : kindsOf(data))
  {
    for (vtkIdType i = 0; i < kind.cells->GetNumberOfCells(); ++i)
    {
      count += kind.cells->GetCellSize(i) < kind.fewest;
    }
  }
  return count;
}

/// Returns polydata without the cells that have too few points for their kind: lines of one point,
/// say, which are a common way to give a point, and polygons of two. VTK's writers follow a null
/// pointer where there are any. Points and all other cells stay, with their data; the polydata
/// itself is returned if all cells have points enough. `dropped` becomes the number of cells left
/// out.
vtkSmartPointer<vtkPolyData> withoutSmallCells(vtkPolyData* data, vtkIdType& dropped)
{
  dropped = countSmall(data);
  if (dropped == 0)
  {
    return data;
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(data->GetPoints());
  result->GetPointData()->ShallowCopy(data->GetPointData());
  result->GetFieldData()->ShallowCopy(data->GetFieldData());
  result->GetCellData()->CopyAllOn();
  result->GetCellData()->CopyAllocate(data->GetCellData());
  vtkIdType from = 0, to = 0;
  std::array<vtkNew<vtkCellArray>, 4> kept;
  for (std::size_t kind = 0; kind < kept.size(); ++kind)
  {
    const auto [cells, fewest] = kindsOf(data)[kind];
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i, ++from)
    {
      vtkIdType size;
      const vtkIdType* ids;
      cells->GetCellAtId(i, size, ids);
      if (size >= fewest)
      {
        kept[kind]->InsertNextCell(size, ids);
        result->GetCellData()->CopyData(data->GetCellData(), from, to++);
      }
    }
  }
  result->SetVerts(kept[0]);
  result->SetLines(kept[1]);
  result->SetPolys(kept[2]);
  result->SetStrips(kept[3]);
  return result;
}

/// Writes the input of a writer to a file.
template <class Writer>
void run(Writer* writer, OutputFile& file, Messages& messages,
  const std::function<void()>& check = interrupt::check)
{
  const Progress progress(writer, Phase::writing, messages.isQuiet());
  writer->SetFileName(file.temporaryName().c_str());
  writer->Write();
  check();
  if (writer->GetErrorCode() != vtkErrorCode::NoError)
  {
    file.refuseWriting(); // errors of VTK are consequences of this one
  }
  messages.throwIfError(file.name());
  file.checkIsWhole();
}

/// Chooses raw bytes behind the XML, lightly packed: small and quick, and every VTK reads them.
void configureXml(vtkXMLWriter* writer)
{
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetHeaderTypeToUInt64();
  writer->SetCompressorTypeToLZ4();
}

/// Writes data with arrays of any names.
template <class Writer> void writeXml(vtkDataSet* data, OutputFile& file, Messages& messages)
{
  prepareNamesForXml(data);
  vtkNew<Writer> writer;
  configureXml(writer);
  writer->SetInputData(data);
  run(writer.Get(), file, messages);
}

/// Throws Failure where single precision cannot hold the points, and warns where it moves them.
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
    throw Failure(EXIT_REFUSED, file.name(),
      "the format keeps single precision, in which points so far from the origin fall together; "
      "give it the suffix .vtp");
  case SinglePrecision::isExceeded:
    throw Failure(EXIT_REFUSED, file.name(),
      "the format keeps single precision, which coordinates of this size are beyond; give it the "
      "suffix .vtp");
  }
}

void writeStl(vtkPolyData* surface, OutputFile& file, Messages& messages)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  vtkNew<vtkSTLWriter> writer;
  writer->SetInputConnection(triangles->GetOutputPort());
  writer->SetFileTypeToBinary();
  run(writer.Get(), file, messages);
}

/// Polydata that VTK's writers can take; a warning says what it lacks.
vtkSmartPointer<vtkPolyData> writable(
  vtkPolyData* surface, const OutputFile& file, Messages& messages)
{
  vtkIdType dropped = 0;
  auto result = withoutSmallCells(surface, dropped);
  if (dropped > 0)
  {
    messages.warn(file.name() + ": is written without " + std::to_string(dropped) +
                  (dropped == 1 ? " cell that has" : " cells that have") +
                  " too few points for their kind, such as lines of one point");
  }
  return result;
}

vtkSmartPointer<vtkUnstructuredGrid> asUnstructuredGrid(vtkDataSet* points)
{
  auto* pointSet = vtkPointSet::SafeDownCast(points);
  if (!pointSet || points->GetNumberOfCells() > 0)
  {
    vtkNew<vtkAppendFilter> append; // takes any data set
    append->SetInputData(points);
    append->Update();
    return append->GetOutput();
  }
  // Without cells, the filter's result has no array of them, which the writer would follow.
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(pointSet->GetPoints());
  grid->Allocate(0);
  grid->GetPointData()->ShallowCopy(points->GetPointData());
  grid->GetFieldData()->ShallowCopy(points->GetFieldData());
  return grid;
}

} // namespace

void writeImage(vtkAlgorithmOutput* image, int pieces, OutputFile& file, Messages& messages,
  const std::function<void()>& check)
{
  vtkNew<vtkXMLImageDataWriter> writer;
  configureXml(writer);
  writer->SetInputConnection(image);
  writer->SetNumberOfPieces(pieces);
  run(writer.Get(), file, messages, check);
}

void writeImage(vtkImageData* image, OutputFile& file, Messages& messages)
{
  vtkNew<vtkXMLImageDataWriter> writer;
  configureXml(writer);
  writer->SetInputData(image);
  run(writer.Get(), file, messages);
}

void writeSurface(vtkPolyData* given, OutputFile& file, Messages& messages)
{
  const auto surface = writable(given, file, messages);
  const std::string suffix = suffixOf(file.name());
  if (suffix == ".stl" || suffix == ".ply")
  {
    checkSinglePrecision(surface, file, messages);
  }
  if (suffix == ".stl")
  {
    writeStl(surface, file, messages);
  }
  else if (suffix == ".ply")
  {
    writePlyMesh(surface, file);
  }
  else if (suffix == ".obj")
  {
    writeObjMesh(surface, file);
  }
  else
  {
    writeXml<vtkXMLPolyDataWriter>(surface, file, messages);
  }
}

void writePoints(vtkDataSet* points, OutputFile& file, Messages& messages)
{
  vtkPolyData* surface = vtkPolyData::SafeDownCast(points);
  const std::string suffix = suffixOf(file.name());
  const bool fits = suffix == ".vti"   ? points->IsA("vtkImageData") != 0
                    : suffix == ".vtr" ? points->IsA("vtkRectilinearGrid") != 0
                    : suffix == ".vts" ? points->IsA("vtkStructuredGrid") != 0
                                       : suffix == ".vtu" || surface;
  if (!fits)
  {
    throw Failure(
      EXIT_REFUSED, file.name(), "cannot hold the cells of the queries; give it the suffix .vtu");
  }
  if (suffix == ".vti" || suffix == ".vtr" || suffix == ".vts")
  {
    writeXml<vtkXMLDataSetWriter>(points, file, messages);
  }
  else if (suffix == ".vtu")
  {
    const auto grid =
      surface ? asUnstructuredGrid(writable(surface, file, messages)) : asUnstructuredGrid(points);
    writeXml<vtkXMLUnstructuredGridWriter>(grid, file, messages);
  }
  else
  {
    writeSurface(surface, file, messages);
  }
}
