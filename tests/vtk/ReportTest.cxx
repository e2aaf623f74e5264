// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"
#include "vtk/ProgressLog.h"
#include "vtk/Spheres.h"

#include "vtkAppendFilter.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWindingNumberReport.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace
{

/// A closed sphere of triangles, with normals and a field-data array of its own.
vtkSmartPointer<vtkPolyData> sphere(double radius = 0.5)
{
  const auto result = sphereOf(20, 20, radius);
  vtkNew<vtkIntArray> own;
  own->SetName("Own");
  own->InsertNextValue(7);
  result->GetFieldData()->AddArray(own);
  return result;
}

/// The points of the sphere alone.
vtkSmartPointer<vtkPolyData> cloud(bool withNormals = true)
{
  auto points = sphere();
  points->SetPolys(vtkSmartPointer<vtkCellArray>::New());
  if (!withNormals)
  {
    points->GetPointData()->SetNormals(nullptr);
  }
  return points;
}

/// The points of the sphere as an unstructured grid without cells.
vtkSmartPointer<vtkUnstructuredGrid> gridCloud()
{
  auto points = cloud();
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points->GetPoints());
  grid->GetPointData()->ShallowCopy(points->GetPointData());
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> hexahedra()
{
  vtkNew<vtkImageData> box;
  box->SetDimensions(3, 3, 3);
  vtkNew<vtkAppendFilter> cells; // makes an unstructured grid
  cells->SetInputData(box);
  cells->Update();
  return cells->GetOutput();
}

class Report : public testing::Test
{
protected:
  vtkPolyData* reportOn(vtkDataObject* source)
  {
    filter->SetInputDataObject(source);
    filter->Update();
    return filter->GetOutput();
  }

  double number(const char* name)
  {
    vtkDataArray* array = filter->GetOutput()->GetFieldData()->GetArray(name);
    return array && array->GetNumberOfValues() == 1 ? array->GetTuple1(0)
                                                    : std::numeric_limits<double>::quiet_NaN();
  }

  std::string text(const char* name)
  {
    vtkAbstractArray* array = filter->GetOutput()->GetFieldData()->GetAbstractArray(name);
    return array && array->GetNumberOfValues() == 1 ? array->GetVariantValue(0).ToString() : "";
  }

  std::vector<std::string> names()
  {
    std::vector<std::string> result;
    for (int i = 0; i < filter->GetReport()->GetNumberOfArrays(); ++i)
    {
      result.emplace_back(filter->GetReport()->GetArrayName(i));
    }
    return result;
  }

  void expectRefused(vtkDataObject* source, const std::string& part)
  {
    ErrorLog log(filter);
    this->reportOn(source);
    EXPECT_NE(log.errors().find(part), std::string::npos) << log.errors();
    EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
    EXPECT_TRUE(this->names().empty());
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(filter->GetFaults()->GetNumberOfBlocks(), 0u);
    EXPECT_EQ(std::string(filter->GetAdvice()), "");
  }

  vtkNew<vtkWindingNumberReport> filter;
};

TEST_F(Report, OfAClosedSurfacePassesItThroughWithItsCounts)
{
  auto source = sphere();
  vtkPolyData* output = this->reportOn(source);
  EXPECT_EQ(output->GetPoints(), source->GetPoints());
  EXPECT_EQ(output->GetNumberOfPolys(), source->GetNumberOfPolys());
  EXPECT_EQ(output->GetPointData()->GetNormals(), source->GetPointData()->GetNormals());
  EXPECT_EQ(this->number("Own"), 7);
  EXPECT_FALSE(source->GetFieldData()->HasArray("advice")) << "the source stays as it is";

  EXPECT_EQ(this->names(),
    (std::vector<std::string>{"kind", "triangles", "vertices", "vertices_merged", "closed",
      "boundary_edges", "boundary_loops", "widest_slit", "nonmanifold_edges", "inconsistent_edges",
      "net_boundary_edges", "components_vertex", "components_edge", "closed_components",
      "inverted_components", "nested_solids", "one_sided_components", "open_parts_inside",
      "duplicate_faces", "degenerate", "zero_area", "unreferenced_vertices", "euler", "volume",
      "area", "fractional_share", "turned_cells", "left_out_cells", "bbox", "non_finite",
      "invalid_ids", "advice"}));
  for (const std::string& name : this->names())
  {
    EXPECT_TRUE(output->GetFieldData()->HasArray(name.c_str())) << name;
  }
  EXPECT_EQ(this->text("kind"), "surface");
  EXPECT_EQ(this->text("advice"), filter->GetAdvice());
  EXPECT_EQ(std::string(filter->GetAdvice()),
    "nothing to mend; closed: every winding number is an integer");
  EXPECT_EQ(this->number("closed"), 1);
  EXPECT_EQ(this->number("triangles"), source->GetNumberOfPolys());
  EXPECT_EQ(this->number("vertices"), source->GetNumberOfPoints());
  EXPECT_EQ(this->number("euler"), 2);
  EXPECT_TRUE(std::isnan(this->number("widest_slit"))) << "there is no boundary";
  EXPECT_EQ(filter->GetWidestSlit(), 0);
  vtkDataArray* box = output->GetFieldData()->GetArray("bbox");
  ASSERT_EQ(box->GetNumberOfComponents(), 6);
  ASSERT_EQ(box->GetNumberOfTuples(), 1);
  const double* bounds = source->GetBounds();
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(box->GetComponent(0, axis), bounds[2 * axis]);
    EXPECT_EQ(box->GetComponent(0, axis + 3), bounds[2 * axis + 1]);
  }
}

TEST_F(Report, HasGettersForASurface)
{
  auto source = sphere();
  EXPECT_EQ(filter->GetNumberOfTriangles(), 0) << "nothing before it has run";
  EXPECT_FALSE(filter->GetSourceIsSurface());
  // The surface has one triangle less, one turned round, one twice, and one with a point that does
  // not exist.
  vtkNew<vtkCellArray> polys;
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType cell = 1; cell < source->GetNumberOfPolys(); ++cell)
  {
    source->GetPolys()->GetCellAtId(cell, size, ids);
    const vtkIdType turned[3] = {ids[0], ids[2], ids[1]};
    polys->InsertNextCell(size, cell == 100 ? turned : ids);
  }
  source->GetPolys()->GetCellAtId(300, size, ids);
  polys->InsertNextCell(size, ids);
  const vtkIdType beyond[3] = {0, 1, 99999};
  polys->InsertNextCell(3, beyond);
  source->SetPolys(polys);
  this->reportOn(source);
  EXPECT_TRUE(filter->GetSourceIsSurface());
  EXPECT_FALSE(filter->GetClosed());
  EXPECT_EQ(filter->GetNumberOfTriangles(), polys->GetNumberOfCells());
  EXPECT_EQ(filter->GetNumberOfBoundaryEdges(), 3);
  EXPECT_EQ(filter->GetNumberOfBoundaryLoops(), 1);
  EXPECT_GT(filter->GetWidestSlit(), 0.01);
  EXPECT_LT(filter->GetWidestSlit(), 0.1);
  EXPECT_EQ(filter->GetWidestSlit(), this->number("widest_slit"));
  EXPECT_EQ(filter->GetNumberOfNonManifoldEdges(), 3);
  EXPECT_EQ(filter->GetNumberOfInconsistentEdges(), 3);
  EXPECT_EQ(filter->GetNumberOfComponents(), 1);
  EXPECT_EQ(filter->GetNumberOfDuplicateFaces(), 1);
  EXPECT_EQ(filter->GetNumberOfClosedComponents(), 0);
  EXPECT_EQ(filter->GetNumberOfInvertedComponents(), 0);
  EXPECT_EQ(filter->GetNumberOfNestedSolids(), 0);
  EXPECT_EQ(filter->GetNumberOfOneSidedComponents(), 0);
  EXPECT_EQ(filter->GetNumberOfFlippedTriangles(), 0);
  EXPECT_EQ(filter->GetNumberOfFlippedComponents(), 0);
  EXPECT_GT(filter->GetFractionalShare(), 0);
  EXPECT_LT(filter->GetFractionalShare(), 0.01);
  EXPECT_EQ(filter->GetNumberOfNonFinite(), 0);
  EXPECT_NEAR(filter->GetArea(), 3.14, 0.1);
  EXPECT_NEAR(filter->GetVolume(), 0.52, 0.05);
  EXPECT_EQ(this->number("invalid_ids"), 1);
  EXPECT_EQ(filter->GetNumberOfPoints(), 0) << "of a cloud";
}

TEST_F(Report, OfACloud)
{
  auto source = cloud();
  vtkPolyData* output = this->reportOn(source);
  EXPECT_EQ(output->GetPoints(), source->GetPoints());
  EXPECT_EQ(
    this->names(), (std::vector<std::string>{"kind", "points", "duplicates", "normals",
                     "zero_normals", "non_unit_normals", "non_finite", "spacing_min",
                     "spacing_median", "spacing_mean", "spacing_max", "opposite_neighbors",
                     "w_behind", "w_before", "outward_share", "inward_share", "bbox", "advice"}));
  EXPECT_EQ(this->text("kind"), "points");
  EXPECT_FALSE(filter->GetSourceIsSurface());
  EXPECT_TRUE(filter->GetHasNormals());
  EXPECT_EQ(filter->GetNumberOfPoints(), source->GetNumberOfPoints());
  EXPECT_EQ(filter->GetNumberOfDuplicatePoints(), 0);
  EXPECT_EQ(filter->GetNumberOfZeroNormals(), 0);
  EXPECT_EQ(filter->GetOppositeNeighbors(), 0);
  EXPECT_GT(filter->GetOutwardShare(), 0.9);
  EXPECT_EQ(filter->GetInwardShare(), 0);
  EXPECT_NEAR(this->number("w_behind"), 1, 0.05);
  EXPECT_NEAR(this->number("w_before"), 0, 0.05);
  EXPECT_GT(filter->GetMedianSpacing(), 0.01);
  EXPECT_LT(filter->GetMedianSpacing(), 0.2);
  EXPECT_LE(this->number("spacing_min"), this->number("spacing_median"));
  EXPECT_LE(this->number("spacing_median"), this->number("spacing_max"));
}

TEST_F(Report, OfPointsWithoutNormalsIsNoError)
{
  ErrorLog log(filter);
  this->reportOn(cloud(false));
  EXPECT_EQ(log.errors(), "");
  EXPECT_FALSE(filter->GetHasNormals());
  EXPECT_EQ(filter->GetReport()->GetArray("w_behind")->GetNumberOfTuples(), 0);
  EXPECT_EQ(filter->GetOutwardShare(), 0);
  EXPECT_NE(std::string(filter->GetAdvice()).find("EstimateNormals"), std::string::npos);
}

TEST_F(Report, SaysThatLinesBoundNothing)
{
  vtkNew<vtkCellArray> line;
  line->InsertNextCell({0, 1, 2});
  auto lines = sphere();
  lines->GetPointData()->SetNormals(nullptr);
  lines->SetLines(line);
  this->reportOn(lines);
  EXPECT_NE(text("advice").find("lines and single points bound nothing"), std::string::npos)
    << text("advice");
  EXPECT_NE(text("advice").find("1 are left out"), std::string::npos);
  lines->SetPolys(vtkSmartPointer<vtkCellArray>::New());
  this->reportOn(lines);
  EXPECT_EQ(text("advice").rfind("the input has only lines, which bound nothing", 0), 0u)
    << text("advice");
}

TEST_F(Report, KeepsLinesNextToASurface)
{
  vtkNew<vtkCellArray> line;
  line->InsertNextCell({0, 1, 2});
  const auto lines = cloud(false);
  lines->SetLines(line);
  vtkNew<vtkAppendFilter> asGrid;
  asGrid->SetInputData(lines);
  asGrid->Update();
  for (vtkDataSet* data :
    {static_cast<vtkDataSet*>(lines), static_cast<vtkDataSet*>(asGrid->GetOutput())})
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, sphere());
    blocks->SetBlock(1, data);
    for (const bool fixes : {false, true})
    {
      filter->SetFixOrientation(fixes);
      ErrorLog log(filter);
      vtkPolyData* output = this->reportOn(blocks);
      EXPECT_EQ(log.errors(), "");
      EXPECT_EQ(output->GetNumberOfLines(), 1);
      EXPECT_EQ(output->GetNumberOfVerts(), 0);
      EXPECT_EQ(output->GetNumberOfPolys(), sphere()->GetNumberOfPolys());
      EXPECT_NE(text("advice").find("1 are left out"), std::string::npos) << text("advice");
    }
  }
}

TEST_F(Report, TakesTheNormalsArrayThatIsNamed)
{
  auto source = cloud();
  vtkNew<vtkFloatArray> zero;
  zero->SetName("zero");
  zero->SetNumberOfComponents(3);
  zero->SetNumberOfTuples(source->GetNumberOfPoints());
  zero->Fill(0);
  source->GetPointData()->AddArray(zero);
  filter->SetNormalsArray("zero");
  this->reportOn(source);
  EXPECT_EQ(filter->GetNumberOfZeroNormals(), source->GetNumberOfPoints());
  filter->SetNormalsArray("none");
  expectRefused(source, "there is no point array 'none'");
}

TEST_F(Report, OfAVolumeMeshPassesItsOuterSurfaceThrough)
{
  vtkPolyData* output = this->reportOn(hexahedra());
  EXPECT_EQ(output->GetNumberOfPolys(), 24);
  EXPECT_EQ(filter->GetNumberOfTriangles(), 48);
  EXPECT_TRUE(filter->GetClosed());
  EXPECT_DOUBLE_EQ(filter->GetVolume(), 8);
  EXPECT_EQ(this->number("vertices"), 26) << "and not the one inside";
  EXPECT_EQ(this->number("unreferenced_vertices"), 0);
}

TEST_F(Report, OfAGridOfPointsPassesVerticesThrough)
{
  auto source = gridCloud();
  vtkPolyData* output = this->reportOn(source);
  EXPECT_EQ(output->GetNumberOfPoints(), source->GetNumberOfPoints());
  EXPECT_EQ(output->GetNumberOfVerts(), source->GetNumberOfPoints());
  EXPECT_EQ(output->GetPointData()->GetNormals(), source->GetPointData()->GetNormals());
  EXPECT_EQ(filter->GetNumberOfPoints(), source->GetNumberOfPoints());
  EXPECT_TRUE(filter->GetHasNormals());
}

TEST_F(Report, OfACompositeAppendsItsLeaves)
{
  vtkNew<vtkMultiBlockDataSet> nested, blocks;
  nested->SetBlock(0, hexahedra());
  blocks->SetBlock(0, sphere());
  blocks->SetBlock(1, nested);
  blocks->SetBlock(2, nullptr);
  vtkPolyData* output = this->reportOn(blocks);
  const vtkIdType triangles = sphere()->GetNumberOfPolys();
  EXPECT_EQ(output->GetNumberOfPolys(), triangles + 24);
  EXPECT_EQ(filter->GetNumberOfTriangles(), triangles + 48);
  EXPECT_EQ(filter->GetNumberOfComponents(), 2);
  EXPECT_TRUE(filter->GetClosed());

  vtkNew<vtkMultiBlockDataSet> clouds;
  clouds->SetBlock(0, cloud());
  clouds->SetBlock(1, gridCloud());
  output = this->reportOn(clouds);
  EXPECT_EQ(output->GetNumberOfPoints(), 2 * cloud()->GetNumberOfPoints());
  EXPECT_EQ(filter->GetNumberOfDuplicatePoints(), cloud()->GetNumberOfPoints());
}

TEST_F(Report, LeavesGhostsUncounted)
{
  auto ghost = sphere();
  vtkNew<vtkUnsignedCharArray> flags;
  flags->SetName(vtkDataSetAttributes::GhostArrayName());
  flags->SetNumberOfTuples(ghost->GetNumberOfCells());
  flags->Fill(vtkDataSetAttributes::DUPLICATECELL);
  ghost->GetCellData()->AddArray(flags);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, sphere());
  blocks->SetBlock(1, ghost);
  this->reportOn(blocks);
  EXPECT_EQ(filter->GetNumberOfTriangles(), sphere()->GetNumberOfPolys());
  EXPECT_EQ(filter->GetNumberOfDuplicateFaces(), 0);
}

TEST_F(Report, OfNothingSaysSo)
{
  ErrorLog log(filter);
  this->reportOn(vtkSmartPointer<vtkPolyData>::New());
  EXPECT_NE(std::string(filter->GetAdvice()).find("nothing to evaluate"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("bbox")->GetNumberOfTuples(), 0);
  this->reportOn(vtkSmartPointer<vtkMultiBlockDataSet>::New());
  EXPECT_NE(std::string(filter->GetAdvice()).find("nothing to evaluate"), std::string::npos);
  this->reportOn(vtkSmartPointer<vtkUnstructuredGrid>::New());
  EXPECT_NE(std::string(filter->GetAdvice()).find("nothing to evaluate"), std::string::npos);
  EXPECT_EQ(log.errors(), "");
}

TEST_F(Report, RefusesWhatIsNoSource)
{
  vtkNew<vtkMultiBlockDataSet> mixed, image;
  mixed->SetBlock(0, sphere());
  mixed->SetBlock(1, cloud());
  expectRefused(mixed, "mixes surfaces and point clouds");
  image->SetBlock(0, vtkSmartPointer<vtkImageData>::New());
  expectRefused(image, "is a vtkImageData");

  auto bad = sphere();
  vtkNew<vtkCellArray> beyond;
  const vtkIdType ids[3] = {0, 1, 99999};
  beyond->InsertNextCell(3, ids);
  bad->SetPolys(beyond);
  expectRefused(bad, "all 1 triangles are unusable");
  this->reportOn(sphere());
  EXPECT_TRUE(filter->GetClosed()) << "and works again";
}

TEST_F(Report, AbortedIsEmptyAndTheNextUpdateStartsAfresh)
{
  auto stopper = std::make_unique<ProgressLog>(filter, 0);
  ErrorLog log(filter);
  auto source = cloud();
  EXPECT_EQ(this->reportOn(source)->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetFaults()->GetNumberOfBlocks(), 0u);
  EXPECT_TRUE(this->names().empty());
  EXPECT_EQ(log.errors(), "");

  stopper.reset();
  filter->Modified();
  EXPECT_EQ(this->reportOn(source)->GetNumberOfPoints(), source->GetNumberOfPoints());
}

TEST_F(Report, AdviceComesInLinesToo)
{
  vtkNew<vtkSphereSource> half;
  half->SetEndPhi(90);
  half->Update();
  this->reportOn(half->GetOutput());
  std::istringstream lines(filter->GetAdviceInLines());
  std::string whole;
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count)
  {
    EXPECT_LE(line.size(), 44u) << line;
    whole += (whole.empty() ? "" : " ") + line;
  }
  EXPECT_EQ(whole, filter->GetAdvice());
  EXPECT_GT(count, 1);
}

} // namespace
