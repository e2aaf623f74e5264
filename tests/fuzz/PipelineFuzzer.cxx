// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause

// A fuzzer of the filters by data that a pipeline may bring: polydata and grids whose offsets, ids,
// types, faces and arrays are wrong now and then. A filter gives a result or an error.

#include "Choices.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWindingNumberClip.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberLabels.h"
#include "vtkWindingNumberNormals.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberReport.h"
#include "vtkWindingNumberSurface.h"
#include "vtkWindingNumberVoxels.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <type_traits>

namespace
{

using fuzz::Choices;

/// Mostly a number in 0 … count − 1, now and then one far off.
long long oddNumber(Choices& choices, long long count, int rarity)
{
  const long long odd[] = {-1, count, count + 1, std::numeric_limits<int>::max(),
    std::numeric_limits<int>::min(), std::numeric_limits<long long>::max(),
    std::numeric_limits<long long>::min()};
  return choices.oneIn(rarity) || count == 0 ? choices.oneOf(odd)
                                             : choices.below(static_cast<int>(count));
}

double oddCoordinate(Choices& choices, int rarity)
{
  const double odd[] = {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e300, -1e300, 1e-300, 1e120};
  return choices.oneIn(rarity) ? choices.oneOf(odd) : choices.between(-1, 1);
}

vtkSmartPointer<vtkDataArray> oddArray(Choices& choices, int tuples, int components, int rarity)
{
  const int types[] = {VTK_DOUBLE, VTK_DOUBLE, VTK_FLOAT, VTK_INT};
  auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(choices.oneOf(types)));
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    for (int component = 0; component < components; ++component)
    {
      array->SetComponent(i, component, oddCoordinate(choices, rarity));
    }
  }
  return array;
}

/// Cells whose offsets ascend and whose ids exist, mostly.
vtkSmartPointer<vtkCellArray> oddCells(Choices& choices, int points, int cells, int rarity)
{
  vtkNew<vtkTypeInt64Array> offsets, connectivity;
  long long end = 0;
  offsets->InsertNextValue(choices.oneIn(rarity) ? choices.below(3) : 0);
  for (int i = 0; i < cells; ++i)
  {
    const int size = choices.oneIn(5) ? choices.below(9) : 3;
    for (int corner = 0; corner < size; ++corner)
    {
      connectivity->InsertNextValue(oddNumber(choices, points, rarity));
    }
    end += size;
    offsets->InsertNextValue(choices.oneIn(rarity) ? oddNumber(choices, end + 1, 2) : end);
  }
  auto array = vtkSmartPointer<vtkCellArray>::New();
  array->SetData(offsets, connectivity);
  if (choices.oneIn(3) && rarity > 1000)
  {
    array->ConvertTo32BitStorage();
  }
  return array;
}

void addArrays(Choices& choices, vtkDataSetAttributes* attributes, int tuples, int rarity)
{
  for (const char* name : {"Normals", "Area", "vtkGhostType", "other"})
  {
    if (choices.oneIn(3))
    {
      const int components = choices.oneIn(8) ? 1 + choices.below(4) : *name == 'N' ? 3 : 1;
      const int count = choices.oneIn(8) ? choices.below(9) : tuples;
      const auto array =
        *name == 'v' && choices.oneIn(2)
          ? vtkSmartPointer<vtkDataArray>(vtkSmartPointer<vtkUnsignedCharArray>::New())
          : oddArray(choices, count, components, rarity);
      array->SetName(name);
      attributes->AddArray(array);
      if (*name == 'N' && choices.oneIn(2))
      {
        attributes->SetActiveNormals(name);
      }
    }
  }
}

vtkSmartPointer<vtkPointSet> oddPolyData(Choices& choices, int points, int rarity)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPolys(oddCells(choices, points, choices.below(12), rarity));
  if (choices.oneIn(4))
  {
    data->SetStrips(oddCells(choices, points, choices.below(4), rarity));
  }
  if (choices.oneIn(4))
  {
    data->SetVerts(oddCells(choices, points, choices.below(4), rarity));
    data->SetLines(oddCells(choices, points, choices.below(4), rarity));
  }
  return data;
}

vtkSmartPointer<vtkPointSet> oddGrid(Choices& choices, int points, int rarity)
{
  const int usual[] = {5, 7, 9, 10, 12, 13, 14, 3, 1, 42};
  const int cells = choices.below(6);
  const auto array = oddCells(choices, points, cells, rarity);
  vtkNew<vtkUnsignedCharArray> types;
  vtkNew<vtkIdTypeArray> locations, faces;
  for (int i = 0; i < cells; ++i)
  {
    const int type = choices.oneIn(6) ? choices.below(85) : choices.oneOf(usual);
    types->InsertNextValue(static_cast<unsigned char>(type));
    locations->InsertNextValue(type == 42 ? faces->GetNumberOfValues() : -1);
    if (type == 42)
    {
      const int count = choices.below(5);
      faces->InsertNextValue(choices.oneIn(rarity) ? oddNumber(choices, 9, 2) : count);
      for (int face = 0; face < count; ++face)
      {
        const int size = choices.below(5);
        faces->InsertNextValue(choices.oneIn(rarity) ? oddNumber(choices, 9, 2) : size);
        for (int corner = 0; corner < size; ++corner)
        {
          faces->InsertNextValue(oddNumber(choices, points, rarity));
        }
      }
    }
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const bool hasFaces = faces->GetNumberOfValues() > 0 && !choices.oneIn(rarity);
  grid->SetCells(
    types, array, hasFaces ? locations.Get() : nullptr, hasFaces ? faces.Get() : nullptr);
  return grid;
}

vtkSmartPointer<vtkPointSet> oddData(Choices& choices)
{
  const int rarity = choices.oneIn(3) ? 10000 : 5 + choices.below(100);
  const int points = choices.below(16);
  const auto data =
    choices.oneIn(2) ? oddPolyData(choices, points, rarity) : oddGrid(choices, points, rarity);
  if (!choices.oneIn(20))
  {
    vtkNew<vtkPoints> coordinates;
    coordinates->SetData(oddArray(choices, points, 3, rarity));
    data->SetPoints(coordinates);
  }
  addArrays(choices, data->GetPointData(), points, rarity);
  addArrays(choices, data->GetCellData(), choices.below(12), rarity);
  return data;
}

void checkNumber(double w)
{
  if (!std::isfinite(w))
  {
    std::fprintf(stderr, "a winding number of %g\n", w);
    std::abort();
  }
}

void checkNumbers(vtkDataSet* output)
{
  vtkDataArray* const values = output->GetPointData()->GetArray("WindingNumber");
  for (vtkIdType i = 0; values && i < values->GetNumberOfTuples(); ++i)
  {
    double place[3];
    output->GetPoint(i, place);
    if (std::isfinite(place[0]) && std::isfinite(place[1]) && std::isfinite(place[2]))
    {
      checkNumber(values->GetComponent(i, 0));
    }
  }
}

template <class Filter> void setUp(Choices& choices, Filter* filter)
{
  filter->SetMethod(choices.below(5));
  filter->SetEstimateNormals(choices.oneIn(3));
  filter->SetNormalEstimation(choices.below(3));
  filter->SetRegularization(choices.oneIn(4) ? 1 : 0);
  filter->SetNumberOfThreads(1);
}

void sampleField(Choices& choices, vtkPointSet* data)
{
  vtkNew<vtkWindingNumberField> filter;
  setUp(choices, filter.Get());
  filter->SetResolution(1 + choices.below(5));
  filter->SetInputData(data);
  filter->Update();
  checkNumbers(vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0)));
}

void findAreas(Choices& choices, vtkPointSet* data)
{
  vtkNew<vtkWindingNumberNormals> areas;
  areas->SetPointAreaMethod(choices.below(3));
  areas->SetEstimateNormals(choices.oneIn(2));
  areas->SetNormalEstimation(choices.below(3));
  areas->SetNumberOfThreads(1);
  areas->SetInputData(data);
  areas->Update();
  checkNumber(areas->GetTotalArea());
  auto* output = vtkPointSet::SafeDownCast(areas->GetOutputDataObject(0));
  vtkDataArray* const normals = output->GetPointData()->GetArray("Normals");
  for (vtkIdType i = 0; areas->GetNormalEstimationUsed()[0] && i < normals->GetNumberOfTuples();
       ++i)
  {
    checkNumber(normals->GetComponent(i, 0));
  }
}

void drawSurface(Choices& choices, vtkPointSet* data)
{
  vtkNew<vtkWindingNumberSurface> filter;
  setUp(choices, filter.Get());
  filter->SetResolution(1 + choices.below(5));
  filter->SetFeatures(choices.below(2));
  filter->SetGenerateTriangles(choices.oneIn(2));
  filter->SetCloseBorder(choices.oneIn(2));
  filter->SetFillCavities(choices.oneIn(4));
  filter->SetGapWidth(choices.oneIn(2) ? 0 : choices.between(0, 0.5));
  filter->SetOffset(choices.oneIn(3) ? choices.between(-1, 1) : 0);
  filter->SetShell(choices.oneIn(3) ? choices.between(0, 1) : 0);
  filter->SetShellSide(choices.below(3));
  filter->SetFidelitySamples(choices.oneIn(3) ? choices.below(30) : 0);
  filter->SetGenerateDistanceToInput(filter->GetFidelitySamples() % 2);
  filter->SetInputData(data);
  filter->Update();
  vtkPolyData* const surface = filter->GetOutput();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double place[3];
    surface->GetPoint(i, place);
    if (!std::isfinite(place[0]) || !std::isfinite(place[1]) || !std::isfinite(place[2]))
    {
      std::fprintf(stderr, "a vertex is not finite\n");
      std::abort();
    }
  }
}

/// Several odd data sets as blocks, some of them empty or in parts; or one as it is.
vtkSmartPointer<vtkDataObject> oddSolids(Choices& choices, vtkPointSet* data)
{
  if (choices.oneIn(3))
  {
    return data;
  }
  const auto count = static_cast<unsigned int>(choices.below(4));
  if (choices.oneIn(3))
  {
    auto parts = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
    for (unsigned int i = 0; i < count; ++i)
    {
      vtkNew<vtkPartitionedDataSet> solid;
      solid->SetPartition(0, data);
      if (choices.oneIn(2))
      {
        solid->SetPartition(1, oddData(choices));
      }
      parts->SetPartitionedDataSet(i, solid);
    }
    return parts;
  }
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (unsigned int i = 0; i < count; ++i)
  {
    const vtkSmartPointer<vtkPointSet> block =
      choices.oneIn(2) ? oddData(choices) : vtkSmartPointer<vtkPointSet>(data);
    blocks->SetBlock(i, choices.oneIn(4) ? nullptr : block.Get());
  }
  return blocks;
}

void labelSolids(Choices& choices, vtkPointSet* data)
{
  vtkNew<vtkWindingNumberLabels> filter;
  setUp(choices, filter.Get());
  filter->SetResolution(1 + choices.below(5));
  filter->SetOverlapRule(choices.below(4));
  filter->SetCoverage(choices.below(3));
  filter->SetCoverageArrays(choices.below(2));
  filter->SetGenerateSolidCount(choices.oneIn(2));
  filter->SetRegionArray(choices.oneIn(3) ? "other" : nullptr);
  filter->SetLabelOffset(choices.below(5));
  filter->SetVerifySamples(choices.oneIn(4) ? 10 : 0);
  const auto solids = oddSolids(choices, data);
  filter->SetInputDataObject(solids);
  filter->Update();
  auto* const labels =
    vtkUnsignedShortArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetArray("Label"));
  const bool isOfBlocks = vtkPointSet::SafeDownCast(solids) == nullptr;
  for (vtkIdType i = 0; labels && isOfBlocks && i < labels->GetNumberOfValues(); ++i)
  {
    if (labels->GetValue(i) > filter->GetNumberOfSolids())
    {
      std::fprintf(stderr, "a label that no solid has\n");
      std::abort();
    }
  }
}

void fillVoxels(Choices& choices, vtkPointSet* data)
{
  vtkNew<vtkWindingNumberField> field;
  setUp(choices, field.Get());
  field->SetResolution(1 + choices.below(5));
  field->SetCoverage(choices.below(3));
  field->GenerateInsideOn();
  field->SetInputData(data);
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputConnection(field->GetOutputPort());
  voxels->Update();
}

/// Runs the probe or the clip on queries that are odd, too.
template <class Filter> void probe(Choices& choices, vtkPointSet* data)
{
  vtkNew<Filter> filter;
  setUp(choices, filter.Get());
  const auto queries = oddData(choices);
  filter->SetInputData(choices.oneIn(2) ? queries.Get() : data);
  filter->SetSourceData(data);
  if constexpr (std::is_same_v<Filter, vtkWindingNumberProbe>)
  {
    filter->SetExtractInside(choices.oneIn(3));
    filter->SetGenerateFraction(choices.oneIn(2));
  }
  filter->Update();
  checkNumbers(vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0)));
}

template <class Filter> void run(vtkPointSet* data)
{
  vtkNew<Filter> filter;
  filter->SetInputData(data);
  filter->Update();
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  vtkOutputWindow::GetInstance()->SetDisplayModeToNever();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  Choices choices(bytes, size);
  const vtkSmartPointer<vtkPointSet> data = oddData(choices);
  switch (choices.below(9)) // 5 is free; the others are what kept cases chose
  {
  case 0:
    sampleField(choices, data);
    break;
  case 1:
    drawSurface(choices, data);
    break;
  case 2:
    fillVoxels(choices, data);
    break;
  case 3:
    run<vtkWindingNumberReport>(data);
    break;
  case 4:
    findAreas(choices, data);
    break;
  case 6:
    probe<vtkWindingNumberClip>(choices, data);
    break;
  case 7:
    labelSolids(choices, data);
    break;
  default:
    probe<vtkWindingNumberProbe>(choices, data);
  }
  return 0;
}
