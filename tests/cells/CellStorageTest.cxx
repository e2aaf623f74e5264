// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkImplicitWindingNumber.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt16Array.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberNormals.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberReport.h"
#include "vtkWindingNumberSurface.h"
#include "vtkWindingNumberVoxels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{

/// Everything that VTK has to say, of which there should be nothing.
class Listener : public vtkOutputWindow
{
public:
  static Listener* New();
  vtkTypeMacro(Listener, vtkOutputWindow);

  void DisplayText(const char* text) override { said += text; }

  std::string said;

protected:
  Listener() = default;
};

vtkStandardNewMacro(Listener);

/// How a vtkCellArray may hold its cells.
enum class Storage
{
  offsets64,
  offsets32,
  fixedSize64,
  fixedSize32,
  generic ///< arrays of other types; since VTK 9.6
};

/// The first one is what the others are compared with.
const std::vector<std::pair<Storage, std::string>> storages = {
  {Storage::offsets64, "offsets of 64 bit"}, {Storage::offsets32, "offsets of 32 bit"},
  {Storage::fixedSize64, "fixed size, 64 bit"}, {Storage::fixedSize32, "fixed size, 32 bit"},
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  {Storage::generic, "generic"}
#endif
};

/// Cells of one size, by their corners one after the other.
struct Cells
{
  vtkIdType size = 0;
  std::vector<vtkIdType> corners;
};

template <class Array> vtkSmartPointer<Array> arrayOf(const std::vector<vtkIdType>& values)
{
  auto array = vtkSmartPointer<Array>::New();
  for (const vtkIdType value : values)
  {
    array->InsertNextValue(static_cast<typename Array::ValueType>(value));
  }
  return array;
}

std::vector<vtkIdType> offsetsOf(const Cells& cells)
{
  std::vector<vtkIdType> offsets;
  for (std::size_t i = 0; i <= cells.corners.size() / static_cast<std::size_t>(cells.size); ++i)
  {
    offsets.push_back(static_cast<vtkIdType>(i) * cells.size);
  }
  return offsets;
}

vtkSmartPointer<vtkCellArray> stored(const Cells& cells, Storage storage)
{
  auto array = vtkSmartPointer<vtkCellArray>::New();
  switch (storage)
  {
  case Storage::offsets64:
    array->SetData(arrayOf<vtkTypeInt64Array>(offsetsOf(cells)).Get(),
      arrayOf<vtkTypeInt64Array>(cells.corners).Get());
    break;
  case Storage::offsets32:
    array->SetData(arrayOf<vtkTypeInt32Array>(offsetsOf(cells)).Get(),
      arrayOf<vtkTypeInt32Array>(cells.corners).Get());
    break;
  case Storage::fixedSize64:
    array->SetData(cells.size, arrayOf<vtkTypeInt64Array>(cells.corners));
    break;
  case Storage::fixedSize32:
    array->SetData(cells.size, arrayOf<vtkTypeInt32Array>(cells.corners));
    break;
  case Storage::generic:
    array->SetData(static_cast<vtkDataArray*>(arrayOf<vtkTypeInt16Array>(offsetsOf(cells))),
      static_cast<vtkDataArray*>(arrayOf<vtkTypeInt16Array>(cells.corners)));
    break;
  }
  return array;
}

/// A torus about the z axis: rings of points around it, and points around each.
constexpr int rings = 24;
constexpr int pointsPerRing = 12;
constexpr double radius = 1;
constexpr double tubeRadius = 0.4;
constexpr double pi = 3.14159265358979323846;

/// The kinds of cells that the torus is made of, all of one kind.
enum class Kind
{
  triangles,
  quads,
  hexagons, ///< quads, with the middles of two sides as corners
  strips,
  wedges ///< a solid torus, whose outer surface is that of the quads
};

vtkIdType idAt(int ring, int place)
{
  return (ring % rings) * pointsPerRing + place % pointsPerRing;
}

/// The middle of the side from (ring, place) to the next ring, which hexagons have.
vtkIdType idOfMiddle(int ring, int place)
{
  return rings * pointsPerRing + idAt(ring, place);
}

/// The centre of a ring, which wedges have.
vtkIdType idOfCenter(int ring)
{
  return rings * pointsPerRing + ring % rings;
}

vtkSmartPointer<vtkPoints> pointsOfTorus(Kind kind)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  const auto insert = [&points](double ring, double fromAxis, double height)
  {
    const double along = 2 * pi * ring / rings;
    points->InsertNextPoint(fromAxis * std::cos(along), fromAxis * std::sin(along), height);
  };
  const auto insertRings = [&insert](double shift, double shrink)
  {
    for (int ring = 0; ring < rings; ++ring)
    {
      for (int place = 0; place < pointsPerRing; ++place)
      {
        const double around = 2 * pi * place / pointsPerRing;
        insert(ring + shift, shrink * (radius + tubeRadius * std::cos(around)),
          tubeRadius * std::sin(around));
      }
    }
  };
  insertRings(0, 1);
  if (kind == Kind::hexagons)
  {
    insertRings(0.5, std::cos(pi / rings));
  }
  for (int ring = 0; ring < rings && kind == Kind::wedges; ++ring)
  {
    insert(ring, radius, 0);
  }
  return points;
}

/// The cells between (ring, place) and the next ring and place, counter-clockwise seen from
/// outside.
std::vector<vtkIdType> cornersAt(Kind kind, int ring, int place)
{
  const vtkIdType a = idAt(ring, place), b = idAt(ring + 1, place);
  const vtkIdType c = idAt(ring + 1, place + 1), d = idAt(ring, place + 1);
  switch (kind)
  {
  case Kind::triangles:
    return {a, b, c, a, c, d};
  case Kind::hexagons:
    return {a, idOfMiddle(ring, place), b, c, idOfMiddle(ring, place + 1), d};
  case Kind::wedges:
    return {idOfCenter(ring), a, d, idOfCenter(ring + 1), b, c};
  default:
    return {a, b, c, d};
  }
}

Cells cellsOfTorus(Kind kind)
{
  Cells cells;
  for (int ring = 0; ring < rings; ++ring)
  {
    for (int place = 0; place < pointsPerRing && kind != Kind::strips; ++place)
    {
      const std::vector<vtkIdType> corners = cornersAt(kind, ring, place);
      cells.size = static_cast<vtkIdType>(kind == Kind::triangles ? 3 : corners.size());
      cells.corners.insert(cells.corners.end(), corners.begin(), corners.end());
    }
    for (int place = 0; place <= pointsPerRing && kind == Kind::strips; ++place)
    {
      cells.size = 2 * (pointsPerRing + 1);
      cells.corners.push_back(idAt(ring, place));
      cells.corners.push_back(idAt(ring + 1, place));
    }
  }
  return cells;
}

/// The torus, or what these cells make of its points.
vtkSmartPointer<vtkPointSet> meshOf(Kind kind, const Cells& cells, Storage storage)
{
  const vtkSmartPointer<vtkCellArray> array = stored(cells, storage);
  if (kind == Kind::wedges)
  {
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    grid->SetPoints(pointsOfTorus(kind));
    grid->SetCells(VTK_WEDGE, array);
    return grid;
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(pointsOfTorus(kind));
  kind == Kind::strips ? surface->SetStrips(array) : surface->SetPolys(array);
  return surface;
}

vtkSmartPointer<vtkPointSet> torus(Kind kind, Storage storage)
{
  return meshOf(kind, cellsOfTorus(kind), storage);
}

using Numbers = std::vector<double>;

void append(vtkFieldData* data, Numbers& numbers)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* array = data->GetArray(i))
    {
      numbers.push_back(static_cast<double>(array->GetNumberOfTuples()));
      for (vtkIdType tuple = 0; tuple < array->GetNumberOfTuples(); ++tuple)
      {
        for (int component = 0; component < array->GetNumberOfComponents(); ++component)
        {
          numbers.push_back(array->GetComponent(tuple, component));
        }
      }
    }
  }
}

/// All points, cells and arrays of a data set, and of those in a composite one.
Numbers numbersOf(vtkDataObject* data)
{
  Numbers numbers;
  append(data->GetFieldData(), numbers);
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      const Numbers more = numbersOf(iterator->GetCurrentDataObject());
      numbers.insert(numbers.end(), more.begin(), more.end());
    }
  }
  if (auto* set = vtkDataSet::SafeDownCast(data))
  {
    append(set->GetPointData(), numbers);
    append(set->GetCellData(), numbers);
    for (vtkIdType i = 0; i < set->GetNumberOfPoints(); ++i)
    {
      numbers.insert(numbers.end(), set->GetPoint(i), set->GetPoint(i) + 3);
    }
    vtkNew<vtkIdList> ids;
    for (vtkIdType i = 0; i < set->GetNumberOfCells(); ++i)
    {
      set->GetCellPoints(i, ids);
      numbers.push_back(static_cast<double>(ids->GetNumberOfIds()));
      numbers.insert(numbers.end(), ids->begin(), ids->end());
    }
  }
  return numbers;
}

Numbers outputsOf(vtkAlgorithm* filter)
{
  filter->Update();
  Numbers numbers;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    const Numbers more = numbersOf(filter->GetOutputDataObject(port));
    numbers.insert(numbers.end(), more.begin(), more.end());
  }
  return numbers;
}

/// Points in and around the torus, some of them in its hole.
vtkSmartPointer<vtkPolyData> queries()
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 50; ++i)
  {
    points->InsertNextPoint(0.035 * i, 0.1, 0.05);
  }
  result->SetPoints(points);
  return result;
}

class CellStorage : public testing::TestWithParam<Kind>
{
protected:
  CellStorage() { vtkOutputWindow::SetInstance(listener); }
  ~CellStorage() override
  {
    vtkOutputWindow::SetInstance(nullptr);
    EXPECT_EQ(listener->said, "");
  }

  /// The results that `result` makes of the torus have the same bits for all storages; there is
  /// something to compare.
  template <class Result> void expectTheSame(const Result& result)
  {
    const Numbers expected = result(torus(GetParam(), storages.front().first));
    EXPECT_GT(expected.size(), 40u);
    for (const auto& [storage, name] : storages)
    {
      EXPECT_EQ(result(torus(GetParam(), storage)), expected) << name;
    }
  }

  vtkNew<Listener> listener;
};

/// The share of the samples that are inside, in units of volume.
double volumeInside(vtkWindingNumberField* field)
{
  vtkImageData* image = field->GetOutput();
  vtkDataArray* inside = image->GetPointData()->GetArray("Inside");
  double count = 0;
  for (vtkIdType i = 0; i < inside->GetNumberOfTuples(); ++i)
  {
    count += inside->GetTuple1(i);
  }
  return count * std::pow(image->GetSpacing()[0], 3);
}

TEST_P(CellStorage, MakesNoDifferenceToTheField)
{
  this->expectTheSame(
    [](vtkPointSet* source)
    {
      vtkNew<vtkWindingNumberField> field;
      field->SetInputData(source);
      field->SetResolution(48);
      field->GenerateInsideOn();
      field->GenerateSignedDistanceOn();
      field->SetCoverage(vtkWindingNumberField::FRACTION);
      Numbers numbers = outputsOf(field);
      EXPECT_EQ(field->GetNumberOfBoundaryEdges(), 0);
      EXPECT_NEAR(volumeInside(field), 2 * pi * pi * radius * tubeRadius * tubeRadius, 0.25);
      return numbers;
    });
}

TEST_P(CellStorage, MakesNoDifferenceToSums)
{
  this->expectTheSame(
    [](vtkPointSet* source)
    {
      vtkNew<vtkWindingNumberField> field;
      field->SetInputData(source);
      field->SetResolution(14);
      field->SetMethod(vtkWindingNumberField::DIRECT);
      field->SetOutputScalarTypeToDouble();
      return outputsOf(field);
    });
}

TEST_P(CellStorage, MakesNoDifferenceToTheSurface)
{
  this->expectTheSame(
    [](vtkPointSet* source)
    {
      vtkNew<vtkWindingNumberSurface> surface;
      surface->SetInputData(source);
      surface->SetResolution(32);
      vtkNew<vtkWindingNumberReport> report;
      report->SetInputConnection(surface->GetOutputPort());
      report->Update();
      EXPECT_TRUE(report->GetClosed());
      EXPECT_NEAR(report->GetVolume(), 2 * pi * pi * radius * tubeRadius * tubeRadius, 0.25);
      return outputsOf(surface);
    });
}

TEST_P(CellStorage, MakesNoDifferenceToVoxels)
{
  this->expectTheSame(
    [](vtkPointSet* source)
    {
      vtkNew<vtkWindingNumberField> field;
      field->SetInputData(source);
      field->SetResolution(16);
      vtkNew<vtkWindingNumberVoxels> voxels;
      voxels->SetInputConnection(field->GetOutputPort());
      vtkNew<vtkWindingNumberReport> report; // of quads that VTK itself puts into storage
      report->SetInputConnection(voxels->GetOutputPort());
      report->Update();
      EXPECT_TRUE(report->GetClosed());
      return outputsOf(voxels);
    });
}

TEST_P(CellStorage, MakesNoDifferenceToTheProbe)
{
  this->expectTheSame(
    [](vtkPointSet* source)
    {
      vtkNew<vtkWindingNumberProbe> probe;
      probe->SetInputData(queries());
      probe->SetSourceData(source);
      probe->GenerateSignedDistanceOn();
      return outputsOf(probe);
    });
}

TEST_P(CellStorage, MakesNoDifferenceToWhatIsExtracted)
{
  this->expectTheSame(
    [](vtkPointSet* probed)
    {
      // Larger, and shifted so that it holds one side of what is probed.
      const vtkSmartPointer<vtkPointSet> source = torus(Kind::quads, Storage::offsets64);
      for (vtkIdType i = 0; i < source->GetNumberOfPoints(); ++i)
      {
        double point[3];
        source->GetPoint(i, point);
        source->GetPoints()->SetPoint(i, 1.5 * point[0] + 0.5, 1.5 * point[1], 1.5 * point[2]);
      }
      vtkNew<vtkWindingNumberProbe> probe;
      probe->SetInputData(probed);
      probe->SetSourceData(source);
      probe->ExtractInsideOn();
      return outputsOf(probe);
    });
}

TEST_P(CellStorage, MakesNoDifferenceToTheImplicitFunction)
{
  this->expectTheSame(
    [](vtkPointSet* source)
    {
      vtkNew<vtkImplicitWindingNumber> function;
      function->SetInput(source);
      Numbers numbers;
      const vtkSmartPointer<vtkPolyData> places = queries();
      for (vtkIdType i = 0; i < places->GetNumberOfPoints(); ++i)
      {
        double place[3], gradient[3];
        places->GetPoint(i, place);
        numbers.push_back(function->FunctionValue(place));
        function->FunctionGradient(place, gradient);
        numbers.insert(numbers.end(), gradient, gradient + 3);
      }
      return numbers;
    });
}

TEST_P(CellStorage, MakesNoDifferenceToAreasAndClouds)
{
  this->expectTheSame(
    [](vtkPointSet* source)
    {
      vtkNew<vtkWindingNumberNormals> areas;
      areas->SetInputData(source);
      areas->SetPointAreaMethod(vtkWindingNumberNormals::MESH);
      Numbers numbers = outputsOf(areas);
      EXPECT_NEAR(areas->GetTotalArea(), 4 * pi * pi * radius * tubeRadius, 0.7);
      vtkNew<vtkWindingNumberField> field;
      field->SetInputData(source);
      field->SetSourceAsPoints(true);
      field->SetResolution(14);
      const Numbers ofCloud = outputsOf(field);
      numbers.insert(numbers.end(), ofCloud.begin(), ofCloud.end());
      return numbers;
    });
}

/// Turns the first few cells of a surface round, which leaves the others to say how they should be.
void turnSome(Kind kind, Cells& cells)
{
  const auto end = cells.corners.begin() + 5 * cells.size;
  for (auto cell = cells.corners.begin(); cell < end; cell += cells.size)
  {
    if (kind == Kind::strips)
    {
      for (vtkIdType i = 0; i < cells.size; i += 2)
      {
        std::swap(cell[i], cell[i + 1]);
      }
    }
    else
    {
      std::reverse(cell, cell + cells.size);
    }
  }
}

TEST_P(CellStorage, MakesNoDifferenceToTheReport)
{
  Cells cells = cellsOfTorus(GetParam());
  const bool isSurface = GetParam() != Kind::wedges;
  if (isSurface)
  {
    turnSome(GetParam(), cells);
  }
  const auto reportOn = [&](Storage storage)
  {
    vtkNew<vtkWindingNumberReport> report;
    report->SetInputData(meshOf(GetParam(), cells, storage));
    report->FixOrientationOn();
    Numbers numbers = outputsOf(report);
    EXPECT_TRUE(report->GetClosed());
    EXPECT_EQ(report->GetNumberOfFlippedTriangles() > 0, isSurface);
    return numbers;
  };
  const Numbers expected = reportOn(storages.front().first);
  for (const auto& [storage, name] : storages)
  {
    EXPECT_EQ(reportOn(storage), expected) << name;
  }
}

TEST_P(CellStorage, IsNoHindranceToKnowingASourceAgain)
{
  const Cells cells = cellsOfTorus(GetParam());
  Cells half = cells;
  half.corners.resize(static_cast<std::size_t>(cells.size) *
                      (cells.corners.size() / static_cast<std::size_t>(2 * cells.size)));
  for (const auto& [storage, name] : storages)
  {
    SCOPED_TRACE(name);
    vtkNew<vtkWindingNumberField> field;
    field->SetResolution(16);
    const auto fieldOf = [&, &storage = storage](const Cells& some)
    {
      field->SetInputData(meshOf(GetParam(), some, storage));
      return outputsOf(field);
    };
    const Numbers whole = fieldOf(cells);
    EXPECT_EQ(field->GetNumberOfBoundaryEdges(), 0);
    EXPECT_EQ(fieldOf(cells), whole);
    if (GetParam() != Kind::wedges)
    {
      EXPECT_EQ(field->GetPrepareSeconds(), 0) << "another object, but no other content";
    }
    EXPECT_NE(fieldOf(half), whole);
  }
}

std::string nameOf(const testing::TestParamInfo<Kind>& info)
{
  const char* const names[] = {"triangles", "quads", "hexagons", "strips", "wedges"};
  return names[static_cast<int>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(OfAllKinds, CellStorage,
  testing::Values(Kind::triangles, Kind::quads, Kind::hexagons, Kind::strips, Kind::wedges),
  nameOf);

} // namespace
