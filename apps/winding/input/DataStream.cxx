// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/DataStream.h"

#include "vtkBitArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiPieceDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#include <array>
#include <cstdint>
#include <new>
#include <vector>

namespace
{

/// The number of bytes that the values of an array take in memory.
std::size_t bytesOf(vtkAbstractArray* array)
{
  const auto values = static_cast<std::size_t>(array->GetNumberOfValues());
  return vtkBitArray::SafeDownCast(array)
           ? (values + 7) / 8
           : values * static_cast<std::size_t>(array->GetDataTypeSize());
}

/// Whether an array is of numbers or of strings. Variants, for example, do not travel.
bool canTravel(vtkAbstractArray* array)
{
  return array && (vtkDataArray::SafeDownCast(array) || vtkStringArray::SafeDownCast(array));
}

void sendArray(vtkAbstractArray* array, ByteSink& sink)
{
  sink.put(canTravel(array));
  if (!canTravel(array))
  {
    return;
  }
  sink.put(array->GetDataType());
  sink.put(array->GetNumberOfComponents());
  sink.put(array->GetNumberOfTuples());
  sink.put(array->GetName() != nullptr);
  sink.put(std::string(array->GetName() ? array->GetName() : ""));
  sink.put(array->HasAComponentName());
  for (int i = 0; array->HasAComponentName() && i < array->GetNumberOfComponents(); ++i)
  {
    const char* name = array->GetComponentName(i);
    sink.put(std::string(name ? name : ""));
  }
  if (auto* strings = vtkStringArray::SafeDownCast(array))
  {
    for (vtkIdType i = 0; i < strings->GetNumberOfValues(); ++i)
    {
      sink.put(std::string(strings->GetValue(i)));
    }
  }
  else if (array->GetNumberOfValues() > 0)
  {
    sink.put(array->GetVoidPointer(0), bytesOf(array));
  }
}

/// Null if none was sent.
vtkSmartPointer<vtkAbstractArray> receiveArray(ByteSource& source)
{
  if (!source.take<bool>())
  {
    return nullptr;
  }
  const auto type = source.take<int>();
  vtkSmartPointer<vtkAbstractArray> array;
  array.TakeReference(vtkAbstractArray::CreateArray(type));
  array->SetNumberOfComponents(source.take<int>());
  const auto tuples = source.take<vtkIdType>();
  if (tuples > 0 && !array->Resize(tuples))
  {
    throw std::bad_alloc();
  }
  array->SetNumberOfTuples(tuples);
  const auto hasName = source.take<bool>();
  const std::string name = source.takeText();
  array->SetName(hasName ? name.c_str() : nullptr);
  const auto hasComponentNames = source.take<bool>();
  for (int i = 0; hasComponentNames && i < array->GetNumberOfComponents(); ++i)
  {
    array->SetComponentName(i, source.takeText().c_str());
  }
  if (auto* strings = vtkStringArray::SafeDownCast(array))
  {
    for (vtkIdType i = 0; i < strings->GetNumberOfValues(); ++i)
    {
      strings->SetValue(i, source.takeText());
    }
  }
  else if (array->GetNumberOfValues() > 0)
  {
    source.take(array->GetVoidPointer(0), bytesOf(array));
  }
  return array;
}

vtkSmartPointer<vtkDataArray> receiveNumbers(ByteSource& source)
{
  return vtkDataArray::SafeDownCast(receiveArray(source));
}

void sendFields(vtkFieldData* fields, ByteSink& sink)
{
  sink.put(fields->GetNumberOfArrays());
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
  {
    sendArray(fields->GetAbstractArray(i), sink);
  }
}

void receiveFields(ByteSource& source, vtkFieldData* fields)
{
  const auto count = source.take<int>();
  for (int i = 0; i < count; ++i)
  {
    if (const auto array = receiveArray(source))
    {
      fields->AddArray(array);
    }
  }
}

void sendAttributes(vtkDataSetAttributes* attributes, ByteSink& sink)
{
  sendFields(attributes, sink);
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    vtkAbstractArray* active = attributes->GetAbstractAttribute(type);
    sink.put(std::string(active && active->GetName() ? active->GetName() : ""));
  }
}

void receiveAttributes(ByteSource& source, vtkDataSetAttributes* attributes)
{
  receiveFields(source, attributes);
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    const std::string active = source.takeText();
    if (!active.empty())
    {
      attributes->SetActiveAttribute(active.c_str(), type);
    }
  }
}

void sendCells(vtkCellArray* cells, ByteSink& sink)
{
  const bool isThere = cells && cells->GetOffsetsArray() && cells->GetConnectivityArray();
  sink.put(isThere);
  if (isThere)
  {
    sendArray(cells->GetOffsetsArray(), sink);
    sendArray(cells->GetConnectivityArray(), sink);
  }
}

/// Null if none were sent.
vtkSmartPointer<vtkCellArray> receiveCells(ByteSource& source)
{
  if (!source.take<bool>())
  {
    return nullptr;
  }
  const auto offsets = receiveNumbers(source);
  const auto connectivity = receiveNumbers(source);
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

void sendGrid(vtkUnstructuredGrid* grid, ByteSink& sink)
{
  sendCells(grid->GetCells(), sink);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  sendArray(grid->GetCellTypes(), sink);
#else
  sendArray(grid->GetCellTypesArray(), sink);
#endif
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  sendCells(grid->GetPolyhedronFaceLocations(), sink);
  sendCells(grid->GetPolyhedronFaces(), sink);
#else
  sendArray(grid->GetFaceLocations(), sink);
  sendArray(grid->GetFaces(), sink);
#endif
}

vtkSmartPointer<vtkPointSet> receiveGrid(ByteSource& source)
{
  const auto cells = receiveCells(source);
  const auto types = receiveNumbers(source);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  const auto locations = receiveCells(source);
  const auto faces = receiveCells(source);
#else
  const auto locationNumbers = receiveNumbers(source), faceNumbers = receiveNumbers(source);
  auto* locations = vtkIdTypeArray::SafeDownCast(locationNumbers);
  auto* faces = vtkIdTypeArray::SafeDownCast(faceNumbers);
#endif
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  if (cells && types)
  {
    auto* typeBytes = vtkUnsignedCharArray::SafeDownCast(types);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
    grid->SetPolyhedralCells(typeBytes, cells, locations, faces);
#else
    grid->SetCells(typeBytes, cells, locations, faces);
#endif
  }
  return grid;
}

void sendPolyData(vtkPolyData* polyData, ByteSink& sink)
{
  for (vtkCellArray* cells :
    {polyData->GetVerts(), polyData->GetLines(), polyData->GetPolys(), polyData->GetStrips()})
  {
    sendCells(cells, sink);
  }
}

vtkSmartPointer<vtkPointSet> receivePolyData(ByteSource& source)
{
  auto polyData = vtkSmartPointer<vtkPolyData>::New();
  polyData->SetVerts(receiveCells(source));
  polyData->SetLines(receiveCells(source));
  polyData->SetPolys(receiveCells(source));
  polyData->SetStrips(receiveCells(source));
  return polyData;
}

void sendExtent(int* extent, ByteSink& sink)
{
  sink.put(std::array<int, 6>{extent[0], extent[1], extent[2], extent[3], extent[4], extent[5]});
}

vtkSmartPointer<vtkPointSet> receiveStructure(ByteSource& source)
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetExtent(source.take<std::array<int, 6>>().data());
  return grid;
}

void sendImage(vtkImageData* image, ByteSink& sink)
{
  sendExtent(image->GetExtent(), sink);
  sink.put(image->GetOrigin(), 3 * sizeof(double));
  sink.put(image->GetSpacing(), 3 * sizeof(double));
  sink.put(image->GetDirectionMatrix()->GetData(), 9 * sizeof(double));
}

vtkSmartPointer<vtkDataSet> receiveImage(ByteSource& source)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(source.take<std::array<int, 6>>().data());
  image->SetOrigin(source.take<std::array<double, 3>>().data());
  image->SetSpacing(source.take<std::array<double, 3>>().data());
  image->SetDirectionMatrix(source.take<std::array<double, 9>>().data());
  return image;
}

void sendAxes(vtkRectilinearGrid* grid, ByteSink& sink)
{
  sendExtent(grid->GetExtent(), sink);
  for (vtkDataArray* axis :
    {grid->GetXCoordinates(), grid->GetYCoordinates(), grid->GetZCoordinates()})
  {
    sendArray(axis, sink);
  }
}

vtkSmartPointer<vtkDataSet> receiveAxes(ByteSource& source)
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetExtent(source.take<std::array<int, 6>>().data());
  grid->SetXCoordinates(receiveNumbers(source));
  grid->SetYCoordinates(receiveNumbers(source));
  grid->SetZCoordinates(receiveNumbers(source));
  return grid;
}

/// Receives a data set of any type, as yet without points that are no matter of its type.
vtkSmartPointer<vtkDataSet> receiveCellsOf(int type, ByteSource& source)
{
  switch (type)
  {
  case VTK_POLY_DATA:
    return receivePolyData(source);
  case VTK_UNSTRUCTURED_GRID:
    return receiveGrid(source);
  case VTK_STRUCTURED_GRID:
    return receiveStructure(source);
  case VTK_RECTILINEAR_GRID:
    return receiveAxes(source);
  default:
    return receiveImage(source);
  }
}

void sendDataSet(vtkDataSet* data, ByteSink& sink)
{
  if (auto* polyData = vtkPolyData::SafeDownCast(data))
  {
    sendPolyData(polyData, sink);
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    sendGrid(grid, sink);
  }
  else if (auto* structure = vtkStructuredGrid::SafeDownCast(data))
  {
    sendExtent(structure->GetExtent(), sink);
  }
  else if (auto* axes = vtkRectilinearGrid::SafeDownCast(data))
  {
    sendAxes(axes, sink);
  }
  else
  {
    sendImage(vtkImageData::SafeDownCast(data), sink);
  }
  auto* points = vtkPointSet::SafeDownCast(data);
  sendArray(points && points->GetPoints() ? points->GetPoints()->GetData() : nullptr, sink);
  sendAttributes(data->GetPointData(), sink);
  sendAttributes(data->GetCellData(), sink);
  sendFields(data->GetFieldData(), sink);
}

vtkSmartPointer<vtkDataSet> receiveDataSet(int type, ByteSource& source)
{
  const vtkSmartPointer<vtkDataSet> data = receiveCellsOf(type, source);
  if (const auto coordinates = receiveNumbers(source))
  {
    vtkNew<vtkPoints> points;
    points->SetData(coordinates);
    vtkPointSet::SafeDownCast(data)->SetPoints(points);
  }
  receiveAttributes(source, data->GetPointData());
  receiveAttributes(source, data->GetCellData());
  receiveFields(source, data->GetFieldData());
  return data;
}

/// The type of a block that holds nothing.
constexpr int nothing = -1;

vtkDataObject* partOf(vtkMultiBlockDataSet* blocks, unsigned int number)
{
  return blocks->GetBlock(number);
}

vtkDataObject* partOf(vtkMultiPieceDataSet* pieces, unsigned int number)
{
  return pieces->GetPieceAsDataObject(number);
}

void setPart(vtkMultiBlockDataSet* blocks, unsigned int number, vtkDataObject* part)
{
  blocks->SetBlock(number, part);
}

void setPart(vtkMultiPieceDataSet* pieces, unsigned int number, vtkDataObject* part)
{
  pieces->SetPiece(number, part);
}

template <class Composite> void sendBlocks(Composite* blocks, unsigned int count, ByteSink& sink)
{
  sink.put(count);
  for (unsigned int i = 0; i < count; ++i)
  {
    vtkInformation* about = blocks->HasMetaData(i) ? blocks->GetMetaData(i) : nullptr;
    const char* name = about ? about->Get(vtkCompositeDataSet::NAME()) : nullptr;
    sink.put(std::string(name ? name : ""));
    sendData(partOf(blocks, i), sink);
  }
}

template <class Composite> vtkSmartPointer<Composite> receiveBlocks(ByteSource& source)
{
  auto blocks = vtkSmartPointer<Composite>::New();
  const auto count = source.take<unsigned int>();
  for (unsigned int i = 0; i < count; ++i)
  {
    const std::string name = source.takeText();
    setPart(blocks, i, receiveData(source));
    if (!name.empty())
    {
      blocks->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), name.c_str());
    }
  }
  return blocks;
}

} // namespace

void ByteSink::put(const std::string& text)
{
  this->put(text.size());
  this->put(text.data(), text.size());
}

std::string ByteSource::takeText()
{
  std::string text(this->take<std::size_t>(), '\0');
  this->take(text.data(), text.size());
  return text;
}

void sendData(vtkDataObject* data, ByteSink& sink)
{
  sink.put(data ? data->GetDataObjectType() : nothing);
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    sendBlocks(blocks, blocks->GetNumberOfBlocks(), sink);
  }
  else if (auto* pieces = vtkMultiPieceDataSet::SafeDownCast(data))
  {
    sendBlocks(pieces, pieces->GetNumberOfPieces(), sink);
  }
  else if (data)
  {
    sendDataSet(vtkDataSet::SafeDownCast(data), sink);
  }
}

vtkSmartPointer<vtkDataObject> receiveData(ByteSource& source)
{
  const auto type = source.take<int>();
  if (type == nothing)
  {
    return nullptr;
  }
  if (type == VTK_MULTIBLOCK_DATA_SET)
  {
    return receiveBlocks<vtkMultiBlockDataSet>(source);
  }
  if (type == VTK_MULTIPIECE_DATA_SET)
  {
    return receiveBlocks<vtkMultiPieceDataSet>(source);
  }
  return receiveDataSet(type, source);
}
