// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/RealMeshes.h"
#include "vtk/ErrorLog.h"
#include "vtk/PointProbe.h"
#include "vtk/ReadMesh.h"
#include "vtk/SphereCloud.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkImplicitWindingNumber.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberReport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace
{

using Polygon = std::vector<vtkIdType>;

std::vector<Polygon> polygonsOf(vtkCellArray* cells)
{
  std::vector<Polygon> result;
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    cells->GetCellAtId(i, size, ids);
    result.emplace_back(ids, ids + size);
  }
  return result;
}

Polygon reversed(Polygon polygon)
{
  std::reverse(polygon.begin() + 1, polygon.end());
  return polygon;
}

/// A copy of a surface with other polygons.
vtkSmartPointer<vtkPolyData> withPolygons(
  vtkPolyData* surface, const std::vector<Polygon>& polygons)
{
  vtkNew<vtkCellArray> cells;
  for (const Polygon& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(surface);
  result->DeleteCells();
  result->SetPolys(cells);
  return result;
}

/// A copy of a surface with some polygons turned round, chosen by the seed.
vtkSmartPointer<vtkPolyData> shuffled(vtkPolyData* surface, unsigned seed)
{
  std::mt19937 engine(seed);
  std::vector<Polygon> polygons = polygonsOf(surface->GetPolys());
  for (Polygon& polygon : polygons)
  {
    if (engine() % 2 == 1)
    {
      polygon = reversed(polygon);
    }
  }
  return withPolygons(surface, polygons);
}

vtkSmartPointer<vtkPolyData> sphere(double x = 0, double radius = 0.5)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(x, 0, 0);
  source->SetRadius(radius);
  source->SetThetaResolution(24);
  source->SetPhiResolution(16);
  source->LatLongTessellationOn(); // quadrilaterals, too
  source->Update();
  vtkSmartPointer<vtkPolyData> result = source->GetOutput();
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName("Number");
  for (vtkIdType i = 0; i < result->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(i);
  }
  result->GetCellData()->AddArray(numbers);
  return result;
}

vtkSmartPointer<vtkPolyData> inverted(vtkPolyData* surface)
{
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputData(surface);
  reverse->Update();
  return reverse->GetOutput();
}

/// Rotates polygons to start from their lowest point: polygons turned round by others than the
/// filter may start elsewhere.
std::vector<Polygon> fromTheirLowestPoint(std::vector<Polygon> polygons)
{
  for (Polygon& polygon : polygons)
  {
    std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  }
  return polygons;
}

class FixOrientation : public PointProbe
{
protected:
  FixOrientation() { filter->FixOrientationOn(); }

  vtkPolyData* fixed(vtkDataObject* source)
  {
    filter->SetInputDataObject(source);
    filter->Update();
    return filter->GetOutput();
  }

  vtkNew<vtkWindingNumberReport> filter;
};

TEST_F(FixOrientation, IsOffUnlessAskedFor)
{
  EXPECT_FALSE(vtkSmartPointer<vtkWindingNumberReport>::New()->GetFixOrientation());
  filter->FixOrientationOff();
  auto source = shuffled(sphere(), 1);
  ErrorLog log(filter);
  EXPECT_EQ(this->fixed(source)->GetPolys(), source->GetPolys());
  EXPECT_GT(filter->GetNumberOfInconsistentEdges(), 0);
  EXPECT_FALSE(filter->GetReport()->HasArray("flipped_triangles"));
  EXPECT_NE(std::string(filter->GetAdvice()).find("OrientFacesOn()"), std::string::npos);
  EXPECT_EQ(log.warnings(), "");
}

TEST_F(FixOrientation, TurnsPolygonsAndNothingElse)
{
  auto right = sphere();
  auto source = shuffled(right, 2);
  vtkNew<vtkCellArray> lines, vertices;
  lines->InsertNextCell({0, 1, 2});
  vertices->InsertNextCell({3});
  source->SetLines(lines);
  source->SetVerts(vertices);
  const vtkIdType others = 2;
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName("Number");
  for (vtkIdType i = 0; i < source->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(i);
  }
  source->GetCellData()->AddArray(numbers);
  const std::vector<Polygon> before = polygonsOf(source->GetPolys());

  ErrorLog log(filter);
  vtkPolyData* output = this->fixed(source);
  EXPECT_EQ(polygonsOf(output->GetPolys()), polygonsOf(right->GetPolys()));
  EXPECT_EQ(output->GetPoints(), source->GetPoints());
  EXPECT_EQ(output->GetPointData()->GetNormals(), source->GetPointData()->GetNormals());
  EXPECT_EQ(output->GetLines(), source->GetLines());
  EXPECT_EQ(output->GetVerts(), source->GetVerts());
  EXPECT_EQ(output->GetCellData()->GetArray("Number"), numbers.Get());
  EXPECT_EQ(output->GetNumberOfCells(), right->GetNumberOfCells() + others);
  EXPECT_EQ(polygonsOf(source->GetPolys()), before) << "the source stays as it is";

  EXPECT_TRUE(filter->GetClosed());
  EXPECT_EQ(filter->GetNumberOfInconsistentEdges(), 0);
  EXPECT_EQ(filter->GetNumberOfFlippedComponents(), 1);
  vtkIdType flipped = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    flipped += before[i] != polygonsOf(right->GetPolys())[i]
                 ? static_cast<vtkIdType>(before[i].size()) - 2
                 : 0;
  }
  EXPECT_EQ(filter->GetNumberOfFlippedTriangles(), flipped);
  EXPECT_EQ(log.warnings(), "");
}

TEST_F(FixOrientation, LeavesWhatIsRightAlone)
{
  auto source = sphere();
  ErrorLog log(filter);
  EXPECT_EQ(this->fixed(source)->GetPolys(), source->GetPolys());
  EXPECT_EQ(filter->GetNumberOfFlippedTriangles(), 0);
  EXPECT_EQ(log.warnings() + log.errors(), "") << "nothing was turned, so there is nothing to say";
}

TEST_F(FixOrientation, MakesTrianglesOfStripsWhereItTurnsThem)
{
  vtkNew<vtkStripper> stripper;
  vtkNew<vtkSphereSource> triangles;
  triangles->SetThetaResolution(24);
  triangles->SetPhiResolution(16);
  stripper->SetInputConnection(triangles->GetOutputPort());
  stripper->Update();
  auto strips = vtkSmartPointer<vtkPolyData>::New();
  strips->ShallowCopy(stripper->GetOutput());
  ASSERT_GT(strips->GetNumberOfStrips(), 5);
  ErrorLog log(filter);
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName("Number");
  for (vtkIdType i = 0; i < strips->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(i);
  }
  strips->GetCellData()->AddArray(numbers);
  EXPECT_EQ(this->fixed(strips)->GetStrips(), strips->GetStrips());

  // One more point at its start turns every third strip the other way round.
  std::vector<Polygon> cells = polygonsOf(strips->GetStrips());
  vtkNew<vtkCellArray> mixed;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    if (i % 3 == 0)
    {
      cells[i].insert(cells[i].begin(), cells[i].front());
    }
    mixed->InsertNextCell(static_cast<vtkIdType>(cells[i].size()), cells[i].data());
  }
  strips->DeleteCells();
  strips->SetStrips(mixed);
  vtkPolyData* output = this->fixed(strips);
  EXPECT_EQ(output->GetNumberOfStrips(), 0);
  EXPECT_TRUE(filter->GetClosed());
  EXPECT_GT(filter->GetVolume(), 0);
  vtkDataArray* origins = output->GetCellData()->GetArray("Number");
  ASSERT_EQ(origins->GetNumberOfTuples(), output->GetNumberOfCells());
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    const Polygon triangle = polygonsOf(output->GetPolys())[static_cast<std::size_t>(i)];
    const Polygon& strip = cells[static_cast<std::size_t>(origins->GetTuple1(i))];
    EXPECT_EQ(triangle.size(), 3u);
    for (const vtkIdType id : triangle)
    {
      EXPECT_NE(std::find(strip.begin(), strip.end(), id), strip.end());
    }
  }
}

TEST_F(FixOrientation, TrianglesOfStripsKeepTheirDataBesideCellsOfAllKinds)
{
  // A tetrahedron of a strip of two triangles and of two polygons, one of them turned round, stands
  // with a vertex and two lines. Cells of polydata are counted by kinds, strips last.
  vtkNew<vtkPoints> points;
  for (const auto& [x, y, z] : {std::array{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
  {
    points->InsertNextPoint(x, y, z);
  }
  vtkNew<vtkCellArray> vertices, lines, polygons, strips;
  vertices->InsertNextCell({0});
  lines->InsertNextCell({0, 1});
  lines->InsertNextCell({1, 2, 3});
  polygons->InsertNextCell({0, 3, 2});
  polygons->InsertNextCell({1, 3, 2});
  strips->InsertNextCell({2, 1, 0, 3});
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName("Number");
  for (vtkIdType i = 0; i < 6; ++i)
  {
    numbers->InsertNextValue(i);
  }
  vtkNew<vtkPolyData> source;
  source->SetPoints(points);
  source->SetVerts(vertices);
  source->SetLines(lines);
  source->SetPolys(polygons);
  source->SetStrips(strips);
  source->GetCellData()->AddArray(numbers);
  vtkPolyData* output = this->fixed(source);
  EXPECT_TRUE(filter->GetClosed());
  EXPECT_GT(filter->GetVolume(), 0);
  ASSERT_EQ(output->GetNumberOfCells(), 7);
  EXPECT_EQ(output->GetNumberOfStrips(), 0);
  vtkDataArray* origins = output->GetCellData()->GetArray("Number");
  ASSERT_EQ(origins->GetNumberOfTuples(), 7);
  for (vtkIdType i = 0; i < 7; ++i)
  {
    EXPECT_EQ(origins->GetTuple1(i), std::min<vtkIdType>(i, 5)) << i;
  }
}

TEST_F(FixOrientation, KeepsCavitiesAndTurnsSolidsOutward)
{
  // The surface is a shell, a cavity in it and a solid in the cavity, all inside out, and another
  // solid.
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(inverted(sphere(0, 4)));
  append->AddInputData(sphere(0, 3));
  append->AddInputData(inverted(sphere(0, 2)));
  append->AddInputData(sphere(9, 1));
  append->Update();
  vtkPolyData* source = append->GetOutput();
  filter->FixOrientationOff();
  this->fixed(source);
  EXPECT_EQ(filter->GetNumberOfClosedComponents(), 4);
  EXPECT_EQ(filter->GetNumberOfInvertedComponents(), 2);
  EXPECT_EQ(filter->GetNumberOfNestedSolids(), 1);

  ErrorLog log(filter);
  filter->FixOrientationOn();
  vtkPolyData* output = this->fixed(source);
  EXPECT_EQ(filter->GetNumberOfInvertedComponents(), 0);
  EXPECT_EQ(filter->GetNumberOfNestedSolids(), 0);
  EXPECT_EQ(filter->GetNumberOfFlippedComponents(), 3);
  EXPECT_NEAR(this->windingNumber(output, 3.4), 1, 1e-3);
  EXPECT_NEAR(this->windingNumber(output, 2.4), 0, 1e-3);
  EXPECT_NEAR(this->windingNumber(output, 0), 1, 1e-3);
  EXPECT_NEAR(this->windingNumber(output, 9), 1, 1e-3);
}

TEST_F(FixOrientation, SaysWhatHasNoOrientation)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  constexpr int quads = 12;
  for (int i = 0; i < quads; ++i)
  {
    const double turn = vtkMath::Pi() * i / quads;
    for (const double side : {-0.3, 0.3})
    {
      const double r = 1 + side * std::cos(turn);
      points->InsertNextPoint(
        r * std::cos(2 * turn), r * std::sin(2 * turn), side * std::sin(turn));
    }
    const vtkIdType a = 2 * i, b = 2 * i + 1;
    const bool isLast = i == quads - 1;
    cells->InsertNextCell({a, b, isLast ? vtkIdType(0) : a + 3, isLast ? vtkIdType(1) : a + 2});
  }
  auto strip = vtkSmartPointer<vtkPolyData>::New();
  strip->SetPoints(points);
  strip->SetPolys(cells);
  ErrorLog log(filter);
  EXPECT_EQ(this->fixed(strip)->GetPolys(), cells.Get());
  EXPECT_EQ(filter->GetNumberOfOneSidedComponents(), 1);
  EXPECT_EQ(filter->GetNumberOfFlippedTriangles(), 0);
  EXPECT_NE(log.warnings().find("1 part has one side only"), std::string::npos) << log.warnings();
}

TEST_F(FixOrientation, OrientsTheLeavesOfACompositeTogether)
{
  ErrorLog log(filter);
  // The blocks are two halves of a sphere, closed only together, each with points of its own.
  auto whole = sphere();
  const std::vector<Polygon> polygons = polygonsOf(whole->GetPolys());
  std::vector<Polygon> halves[2];
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    halves[i % 3 == 0].push_back(i % 3 == 0 ? reversed(polygons[i]) : polygons[i]);
  }
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, withPolygons(whole, halves[0]));
  blocks->SetBlock(2, withPolygons(whole, halves[1]));
  vtkPolyData* output = this->fixed(blocks);
  EXPECT_TRUE(filter->GetClosed());
  EXPECT_EQ(output->GetNumberOfPolys(), whole->GetNumberOfPolys());
  EXPECT_NEAR(this->windingNumber(output), 1, 1e-3);
}

TEST_F(FixOrientation, KeepsOneOfDoubledPolygonsWithItsData)
{
  const auto ball = sphere();
  std::vector<Polygon> polygons = polygonsOf(ball->GetPolys());
  const std::size_t count = polygons.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    // Reversed as a whole a quadrilateral is cut along its other diagonal.
    Polygon back = polygons[i];
    std::reverse(back.begin(), back.end());
    polygons.push_back(back);
  }
  polygons.push_back(polygons.front());
  const auto doubled = withPolygons(ball, polygons);
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName("Number");
  for (vtkIdType i = 0; i < doubled->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(i);
  }
  doubled->GetCellData()->AddArray(numbers);

  vtkPolyData* result = this->fixed(doubled);
  EXPECT_EQ(polygonsOf(result->GetPolys()), polygonsOf(ball->GetPolys()));
  vtkDataArray* kept = result->GetCellData()->GetArray("Number");
  ASSERT_EQ(kept->GetNumberOfTuples(), static_cast<vtkIdType>(count));
  EXPECT_EQ(kept->GetComponent(static_cast<vtkIdType>(count) - 1, 0), count - 1.0);
  EXPECT_EQ(filter->GetReport()->GetArray("left_out_faces")->GetComponent(0, 0), count + 1.0);
}

TEST_F(FixOrientation, IsWhatOtherFiltersDoByThemselves)
{
  const auto ball = sphere();
  std::vector<Polygon> twoSided = polygonsOf(ball->GetPolys());
  for (Polygon back : polygonsOf(ball->GetPolys()))
  {
    std::reverse(back.begin(), back.end());
    twoSided.push_back(back);
  }
  const std::pair<vtkSmartPointer<vtkPolyData>, vtkSmartPointer<vtkPolyData>> cases[] = {
    {shuffled(ball, 5), ball}, {inverted(ball), ball}, {withPolygons(ball, twoSided), ball}};
  for (const auto& [source, expected] : cases)
  {
    vtkNew<vtkWindingNumberField> field, right;
    for (const auto& [algorithm, input] : {std::pair(field.Get(), source), {right.Get(), expected}})
    {
      algorithm->SetInputData(input);
      algorithm->SetResolution(16);
    }
    field->OrientFacesOn();
    const ErrorLog log(field);
    field->Update();
    right->Update();
    EXPECT_EQ(log.warnings(), "");
    vtkDataArray* found = field->GetOutput()->GetPointData()->GetScalars();
    vtkDataArray* wanted = right->GetOutput()->GetPointData()->GetScalars();
    ASSERT_EQ(found->GetNumberOfTuples(), wanted->GetNumberOfTuples());
    for (vtkIdType i = 0; i < found->GetNumberOfTuples(); ++i)
    {
      ASSERT_EQ(found->GetComponent(i, 0), wanted->GetComponent(i, 0)) << i;
    }

    vtkNew<vtkImplicitWindingNumber> function;
    function->SetInput(source);
    EXPECT_GT(function->EvaluateFunction(0.1, 0, 0), 0);
    function->GetField()->OrientFacesOn();
    EXPECT_NEAR(function->EvaluateFunction(0.1, 0, 0), -0.5, 1e-12);
  }
}

TEST_F(FixOrientation, LeavesGhostsAlone)
{
  ErrorLog log(filter);
  auto source = shuffled(sphere(), 3);
  vtkNew<vtkUnsignedCharArray> flags;
  flags->SetName(vtkDataSetAttributes::GhostArrayName());
  flags->SetNumberOfTuples(source->GetNumberOfCells());
  flags->Fill(0);
  for (vtkIdType i = 0; i < 40; ++i)
  {
    flags->SetValue(i, vtkDataSetAttributes::DUPLICATECELL);
  }
  source->GetCellData()->AddArray(flags);
  const std::vector<Polygon> before = polygonsOf(source->GetPolys());
  vtkPolyData* output = this->fixed(source);
  const std::vector<Polygon> after = polygonsOf(output->GetPolys());
  EXPECT_TRUE(std::equal(before.begin(), before.begin() + 40, after.begin()));
  EXPECT_EQ(filter->GetNumberOfInconsistentEdges(), 0);
  EXPECT_GT(filter->GetNumberOfFlippedTriangles(), 0);
  EXPECT_EQ(output->GetCellData()->GetArray(flags->GetName()), flags.Get());
}

TEST_F(FixOrientation, TakesCellsThatBoundNothing)
{
  // The cells added are a polygon with two points, one with a point twice, one with a point that
  // does not exist, and one without points.
  auto right = sphere();
  std::vector<Polygon> polygons = polygonsOf(shuffled(right, 4)->GetPolys());
  const std::size_t own = polygons.size();
  polygons.insert(polygons.begin() + 7, {{3, 4}, {5, 5, 6}});
  polygons.push_back({0, 1, 99999});
  polygons.push_back({});
  ErrorLog log(filter);
  vtkPolyData* output = this->fixed(withPolygons(right, polygons));
  EXPECT_EQ(log.errors(), "");
  EXPECT_EQ(static_cast<std::size_t>(output->GetNumberOfPolys()), own + 4);
  EXPECT_TRUE(filter->GetClosed());
  EXPECT_GT(filter->GetVolume(), 0);
  EXPECT_EQ(polygonsOf(output->GetPolys())[8], (Polygon{5, 5, 6}));
}

TEST_F(FixOrientation, OfCloudsLeavesOtherNormalsActive)
{
  const vtkSmartPointer<vtkPolyData> cloud = sphereCloud(2000, 1);
  vtkNew<vtkDoubleArray> inward;
  inward->SetName("Inward");
  inward->SetNumberOfComponents(3);
  for (vtkIdType id = 0; id < cloud->GetNumberOfPoints(); ++id)
  {
    double at[3];
    cloud->GetPoint(id, at);
    inward->InsertNextTuple3(-at[0], -at[1], -at[2]);
  }
  cloud->GetPointData()->AddArray(inward);
  for (const char* const name : {"Normals", "Inward"})
  {
    for (const char* const active : {"Normals", "Inward", ""})
    {
      SCOPED_TRACE(std::string(name) + " turned, active " + active);
      cloud->GetPointData()->SetActiveNormals(*active ? active : nullptr);
      filter->SetNormalsArray(name);
      vtkPointData* const found = this->fixed(cloud)->GetPointData();
      vtkDataArray* const normals = found->GetNormals();
      EXPECT_EQ(std::string(normals ? normals->GetName() : ""), active);
      EXPECT_EQ(found->GetNumberOfArrays(), 2);
      double at[3];
      cloud->GetPoint(7, at);
      EXPECT_GT(vtkMath::Dot(found->GetArray(name)->GetTuple3(7), at), 0.99);
      const char* const other = std::string(name) == "Normals" ? "Inward" : "Normals";
      EXPECT_EQ(found->GetArray(other), cloud->GetPointData()->GetArray(other));
    }
  }
}

TEST_F(FixOrientation, OfCloudsAndOfNothingDoesNothing)
{
  auto points = sphere();
  points->SetPolys(vtkSmartPointer<vtkCellArray>::New());
  points->GetCellData()->Initialize();
  ErrorLog log(filter);
  EXPECT_EQ(this->fixed(points)->GetPoints(), points->GetPoints());
  EXPECT_EQ(filter->GetNumberOfPoints(), points->GetNumberOfPoints());
  this->fixed(vtkSmartPointer<vtkPolyData>::New());
  this->fixed(vtkSmartPointer<vtkMultiBlockDataSet>::New());
  EXPECT_EQ(log.errors() + log.warnings(), "");
}

/// The share of voxels whose winding number is 1 where ray parity, which no orientation changes,
/// says inside, and 0 where it says outside.
double agreementWithParity(vtkPolyData* fixed, vtkPolyData* original)
{
  const auto field = [](vtkPolyData* surface, int method)
  {
    vtkNew<vtkWindingNumberField> filter;
    filter->SetInputDataObject(surface);
    filter->SetResolution(40);
    filter->SetMethod(method);
    filter->Update();
    vtkSmartPointer<vtkDataArray> values =
      filter->GetOutput()->GetPointData()->GetArray("WindingNumber");
    return values;
  };
  const auto w = field(fixed, vtkWindingNumberField::AUTOMATIC);
  const auto parity = field(original, vtkWindingNumberField::PARITY);
  vtkIdType same = 0;
  for (vtkIdType i = 0; i < w->GetNumberOfTuples(); ++i)
  {
    same += w->GetTuple1(i) == parity->GetTuple1(i);
  }
  return static_cast<double>(same) / static_cast<double>(w->GetNumberOfTuples());
}

TEST_F(FixOrientation, MakesTheFieldOfRealMeshesRight)
{
  ErrorLog log(filter);
  for (const char* name : shapes::present({"conrod_flipped.stl"}))
  {
    // A third of this mesh's triangles are flipped.
    auto conrod = readMesh(shapes::realMesh(name));
    vtkPolyData* output = this->fixed(conrod);
    EXPECT_TRUE(filter->GetClosed());
    EXPECT_NEAR(filter->GetVolume(), 29.6, 0.01);
    EXPECT_EQ(agreementWithParity(output, conrod), 1);
    EXPECT_LT(agreementWithParity(conrod, conrod), 0.1); // nearly no w is an integer
  }
  for (const char* name : shapes::present({"bunny_10k.obj", "teapot.obj", "sphere_quads.obj",
         "armadillo_86k.obj", "tray_thin_cad.stl", "self_intersectA.obj", "icosahedron.stl"}))
  {
    SCOPED_TRACE(std::string(name) + ", seed 5");
    auto right = readMesh(shapes::realMesh(name));
    auto found = this->fixed(shuffled(right, 5));
    EXPECT_TRUE(filter->GetClosed());
    EXPECT_TRUE(polygonsOf(found->GetPolys()) == polygonsOf(right->GetPolys()));
  }
  for (const char* name : shapes::present({"maxplanck_open_90k.obj", "aneurysm_open.stl"}))
  {
    SCOPED_TRACE(std::string(name) + ", seed 6");
    auto right = readMesh(shapes::realMesh(name));
    auto found = this->fixed(shuffled(inverted(right), 6));
    EXPECT_TRUE(fromTheirLowestPoint(polygonsOf(found->GetPolys())) ==
                fromTheirLowestPoint(polygonsOf(right->GetPolys())));
  }
}

} // namespace
