// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/Views.h"
#include "field/Field.h"
#include "private/probe/ClippedPart.h"
#include "private/probe/CutDistances.h"
#include "private/probe/ProbeQueries.h"
#include "private/probe/ProbeWords.h"
#include "support/Serial.h"
#include "vtk/ErrorLog.h"
#include "vtk/ProgressLog.h"
#include "vtk/SphereCloud.h"

#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkImplicitWindingNumber.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkSphereSource.h"
#include "vtkStructuredGrid.h"
#include "vtkTetra.h"
#include "vtkTriangle.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWindingNumberClip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace
{

using shapes::serial;

const double pi = std::acos(-1.0);

/// The volume of the cells of three dimensions.
double volumeOf(vtkDataSet* data)
{
  vtkNew<vtkDataSetTriangleFilter> simplices;
  simplices->SetInputData(data);
  simplices->TetrahedraOnlyOn();
  simplices->Update();
  vtkUnstructuredGrid* tetrahedra = simplices->GetOutput();
  vtkNew<vtkIdList> ids;
  double volume = 0;
  for (vtkIdType cell = 0; cell < tetrahedra->GetNumberOfCells(); ++cell)
  {
    tetrahedra->GetCellPoints(cell, ids);
    double corners[4][3];
    for (int i = 0; i < 4; ++i)
    {
      tetrahedra->GetPoint(ids->GetId(i), corners[i]);
    }
    volume += std::abs(vtkTetra::ComputeVolume(corners[0], corners[1], corners[2], corners[3]));
  }
  return volume;
}

/// The area of triangles and quads.
double areaOf(vtkDataSet* data)
{
  vtkNew<vtkIdList> ids;
  double area = 0;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    data->GetCellPoints(cell, ids);
    double corners[3][3];
    data->GetPoint(ids->GetId(0), corners[0]);
    for (vtkIdType i = 2; i < ids->GetNumberOfIds(); ++i)
    {
      data->GetPoint(ids->GetId(i - 1), corners[1]);
      data->GetPoint(ids->GetId(i), corners[2]);
      area += vtkTriangle::TriangleArea(corners[0], corners[1], corners[2]);
    }
  }
  return area;
}

/// Points in the cube from −half to half along each axis.
vtkSmartPointer<vtkImageData> imageOf(int points, double half)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const double step = 2 * half / (points - 1);
  image->SetDimensions(points, points, points);
  image->SetSpacing(step, step, step);
  image->SetOrigin(-half, -half, -half);
  return image;
}

/// The unit ball, of hexahedra: a cube whose layers became spheres.
vtkSmartPointer<vtkStructuredGrid> ballOf(int pointsPerAxis)
{
  const vtkSmartPointer<vtkImageData> cube = imageOf(pointsPerAxis, 1);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < cube->GetNumberOfPoints(); ++i)
  {
    double x[3];
    cube->GetPoint(i, x);
    const double length = vtkMath::Norm(x);
    const double layer = std::max({std::abs(x[0]), std::abs(x[1]), std::abs(x[2])});
    vtkMath::MultiplyScalar(x, length > 0 ? layer / length : 0);
    points->InsertNextPoint(x);
  }
  auto ball = vtkSmartPointer<vtkStructuredGrid>::New();
  ball->SetDimensions(pointsPerAxis, pointsPerAxis, pointsPerAxis);
  ball->SetPoints(points);
  return ball;
}

vtkSmartPointer<vtkUnstructuredGrid> tetrahedraOf(vtkDataSet* data)
{
  vtkNew<vtkDataSetTriangleFilter> simplices;
  simplices->SetInputData(data);
  simplices->Update();
  return simplices->GetOutput();
}

class Clip : public testing::Test
{
protected:
  Clip()
  {
    sphere->SetRadius(1);
    sphere->SetThetaResolution(128);
    sphere->SetPhiResolution(128);
    sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    clip->SetSourceConnection(sphere->GetOutputPort());
  }

  vtkUnstructuredGrid* clipped(vtkDataObject* input)
  {
    clip->SetInputData(input);
    clip->Update();
    return vtkUnstructuredGrid::SafeDownCast(clip->GetOutputDataObject(0));
  }

  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkWindingNumberClip> clip;
};

TEST_F(Clip, BoxesInImagesHaveTheirVolume)
{
  vtkNew<vtkCubeSource> box;
  box->SetXLength(1.03);
  box->SetYLength(0.77);
  box->SetZLength(1.21);
  clip->SetSourceConnection(box->GetOutputPort());
  // Faces are met exactly; along edges a share of a voxel's face is cut off.
  const double exact = 1.03 * 0.77 * 1.21;
  EXPECT_NEAR(volumeOf(clipped(imageOf(21, 1))), exact, 0.03 * exact);
  EXPECT_NEAR(volumeOf(clipped(imageOf(41, 1))), exact, 0.0075 * exact);
}

TEST_F(Clip, BallsAreCutByAnOverlappingSphere)
{
  sphere->SetCenter(0.9, 0.1, 0.05);
  const double distance = std::sqrt(0.81 + 0.01 + 0.0025);
  const double lens = pi / 12 * (4 + distance) * (2 - distance) * (2 - distance);
  const vtkSmartPointer<vtkStructuredGrid> hexahedra = ballOf(33);
  EXPECT_NEAR(volumeOf(clipped(hexahedra)), lens, 0.01 * lens);
  EXPECT_NEAR(volumeOf(clipped(tetrahedraOf(hexahedra))), lens, 0.01 * lens);
}

TEST_F(Clip, InsideAndOutsideFitTogether)
{
  sphere->SetCenter(0.3, 0.2, 0.1);
  for (const bool isOpen : {false, true})
  {
    sphere->SetStartTheta(isOpen ? 100 : 0);
    // Pieces of tetrahedra have plane faces; pieces of voxels are split for their volume.
    const std::pair<vtkSmartPointer<vtkDataSet>, double> inputs[] = {
      {tetrahedraOf(ballOf(9)), 1e-9}, {imageOf(14, 1), 1e-4}};
    for (const auto& [input, tolerance] : inputs)
    {
      clip->InsideOutOff();
      const double inside = volumeOf(clipped(input));
      clip->InsideOutOn();
      const double outside = volumeOf(clipped(input)), whole = volumeOf(input);
      EXPECT_GT(inside, 0.2 * whole);
      EXPECT_GT(outside, 0.2 * whole);
      EXPECT_NEAR(inside + outside, whole, tolerance * whole);
    }
  }
}

/// The mean distance, in voxels, of the places where edges of an image are cut from the places
/// where the winding number is the threshold or jumps over it.
double meanError(vtkUnstructuredGrid* part, vtkImageData* image, vtkPolyData* source)
{
  vtkNew<vtkImplicitWindingNumber> function;
  function->SetInput(source);
  function->GetField()->SetTolerance(1e-5);
  const double step = image->GetSpacing()[0];
  double sum = 0;
  int count = 0;
  for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
  {
    double at[3], steps[3];
    part->GetPoint(i, at);
    int axis = -1, axesOff = 0;
    for (int j = 0; j < 3; ++j)
    {
      steps[j] = (at[j] - image->GetOrigin()[j]) / step;
      const bool isOff = std::abs(steps[j] - std::round(steps[j])) > 1e-6;
      axis = isOff ? j : axis;
      axesOff += isOff;
    }
    // A point on an edge is neither a corner nor on the diagonal of a face or of a voxel.
    if (axesOff != 1)
    {
      continue;
    }
    double low = image->GetOrigin()[axis] + step * std::floor(steps[axis]), high = low + step;
    const auto isInsideAt = [&](double place)
    {
      double x[3] = {at[0], at[1], at[2]};
      x[axis] = place;
      return function->FunctionValue(x) <= 0;
    };
    const bool lowIsInside = isInsideAt(low);
    for (int halving = 0; halving < 12; ++halving)
    {
      const double middle = 0.5 * (low + high);
      (isInsideAt(middle) == lowIsInside ? low : high) = middle;
    }
    sum += std::abs(0.5 * (low + high) - at[axis]) / step;
    ++count;
  }
  EXPECT_GT(count, 100);
  return sum / count;
}

TEST_F(Clip, CutsMeetTheSource)
{
  const vtkSmartPointer<vtkImageData> image = imageOf(22, 1.3);
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(64);
  sphere->Update();
  EXPECT_LT(meanError(clipped(image), image, sphere->GetOutput()), 0.02);
  sphere->SetStartTheta(80);
  sphere->Update();
  EXPECT_LT(meanError(clipped(image), image, sphere->GetOutput()), 0.03);
  clip->SetSourceData(sphereCloud(3000, 1));
  EXPECT_LT(meanError(clipped(image), image, sphereCloud(3000, 1)), 0.05);
}

TEST_F(Clip, CloudsHaveTheVolumeOfTheirShape)
{
  clip->SetSourceData(sphereCloud(3000, 1));
  EXPECT_NEAR(volumeOf(clipped(imageOf(30, 1.3))), 4 * pi / 3, 0.01 * 4 * pi / 3);
}

TEST_F(Clip, ThresholdsAndRulesSayWhatIsInside)
{
  vtkNew<vtkReverseSense> inward;
  inward->SetInputConnection(sphere->GetOutputPort());
  clip->SetSourceConnection(inward->GetOutputPort());
  const vtkSmartPointer<vtkImageData> image = imageOf(20, 1.3);
  ErrorLog log(clip);
  EXPECT_EQ(clipped(image)->GetNumberOfCells(), 0);
  EXPECT_TRUE(clip->GetSourceIsInsideOut());
  EXPECT_NE(log.warnings().find("faces look inward"), std::string::npos);
  EXPECT_EQ(log.warnings().find("look whether"), std::string::npos) << "one warning is enough";
  clip->SetInsideRule(vtkWindingNumberAlgorithm::ABSOLUTE);
  EXPECT_NEAR(volumeOf(clipped(image)), 4 * pi / 3, 0.02 * 4 * pi / 3);
  clip->SetInsideRule(vtkWindingNumberAlgorithm::ODD);
  EXPECT_NEAR(volumeOf(clipped(image)), 4 * pi / 3, 0.02 * 4 * pi / 3);
  clip->SetInsideRule(vtkWindingNumberAlgorithm::SIGNED);
  clip->SetWindingThreshold(-0.5);
  EXPECT_NEAR(volumeOf(clipped(image)), 2.6 * 2.6 * 2.6 - 4 * pi / 3, 0.01 * 2.6 * 2.6 * 2.6);
}

TEST_F(Clip, EveryMethodGivesTheSameCut)
{
  const vtkSmartPointer<vtkImageData> image = imageOf(16, 1.3);
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  const double volume = volumeOf(clipped(image));
  for (const auto method :
    {vtkWindingNumberAlgorithm::ROWS, vtkWindingNumberAlgorithm::HIERARCHICAL,
      vtkWindingNumberAlgorithm::DIRECT, vtkWindingNumberAlgorithm::PARITY})
  {
    clip->SetMethod(method);
    EXPECT_NEAR(volumeOf(clipped(image)), volume, 1e-6) << method;
    EXPECT_NE(clip->GetOutput()->GetFieldData()->GetAbstractArray("WindingNumberMethod"), nullptr);
  }
}

TEST_F(Clip, ArraysAreKeptAndInterpolated)
{
  const vtkSmartPointer<vtkImageData> image = imageOf(12, 1.3);
  vtkNew<vtkDoubleArray> x, own, cells;
  x->SetName("x");
  own->SetName("WindingNumber"); // the name of an array that other filters add
  cells->SetName("cell");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    x->InsertNextValue(image->GetPoint(i)[0]);
    own->InsertNextValue(7);
  }
  for (vtkIdType i = 0; i < image->GetNumberOfCells(); ++i)
  {
    cells->InsertNextValue(static_cast<double>(i));
  }
  image->GetPointData()->SetScalars(x);
  image->GetPointData()->AddArray(own);
  image->GetCellData()->AddArray(cells);
  vtkUnstructuredGrid* part = clipped(image);
  ASSERT_EQ(part->GetPointData()->GetNumberOfArrays(), 2);
  ASSERT_EQ(part->GetCellData()->GetNumberOfArrays(), 1);
  EXPECT_STREQ(part->GetPointData()->GetScalars()->GetName(), "x");
  for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(part->GetPointData()->GetArray("x")->GetTuple1(i), part->GetPoint(i)[0], 1e-12);
    EXPECT_EQ(part->GetPointData()->GetArray("WindingNumber")->GetTuple1(i), 7);
  }
  double center[3];
  for (vtkIdType i = 0; i < part->GetNumberOfCells(); ++i)
  {
    double box[6], of[6];
    part->GetCellBounds(i, box);
    image->GetCellBounds(
      static_cast<vtkIdType>(part->GetCellData()->GetArray("cell")->GetTuple1(i)), of);
    for (int axis = 0; axis < 3; ++axis)
    {
      center[axis] = 0.5 * (box[2 * axis] + box[2 * axis + 1]);
      EXPECT_GE(center[axis], of[2 * axis]);
      EXPECT_LE(center[axis], of[2 * axis + 1]);
    }
  }
}

TEST_F(Clip, PolyDataBecomesAnUnstructuredGrid)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-2, -2, 0.6);
  plane->SetPoint1(2, -2, 0.6);
  plane->SetPoint2(-2, 2, 0.6);
  plane->SetResolution(60, 60);
  plane->Update();
  vtkUnstructuredGrid* part = clipped(plane->GetOutput());
  ASSERT_NE(part, nullptr);
  EXPECT_EQ(part->GetPoints()->GetDataType(), VTK_FLOAT) << "the precision of the input";
  EXPECT_NEAR(areaOf(part), pi * 0.64, 0.005 * pi);
}

TEST_F(Clip, PointsWithoutCellsStayPoints)
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 10; ++i)
  {
    points->InsertNextPoint(0.25 * i, 0, 0.1);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  vtkUnstructuredGrid* part = clipped(data);
  ASSERT_NE(part, nullptr);
  EXPECT_EQ(part->GetNumberOfPoints(), 4);
  EXPECT_EQ(part->GetNumberOfCells(), 4);
  data->AllocateExact(1, 10);
  vtkIdType ids[10] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  data->InsertNextCell(VTK_POLY_VERTEX, 10, ids);
  part = clipped(data);
  EXPECT_EQ(part->GetNumberOfPoints(), 4);
}

TEST_F(Clip, CellsOfPointsThatAreNowhereAreLeftOut)
{
  const vtkSmartPointer<vtkUnstructuredGrid> ball = tetrahedraOf(ballOf(9));
  const vtkIdType nowhere = ball->GetNumberOfPoints() / 2;
  ball->GetPoints()->SetPoint(nowhere, std::numeric_limits<double>::quiet_NaN(), 0, 0);
  vtkNew<vtkIdList> cells;
  ball->GetPointCells(nowhere, cells);
  sphere->SetRadius(3);
  EXPECT_EQ(clipped(ball)->GetNumberOfCells(), ball->GetNumberOfCells() - cells->GetNumberOfIds());
  clip->InsideOutOn();
  EXPECT_EQ(clipped(ball)->GetNumberOfCells(), 0);
}

TEST_F(Clip, BlocksAreCutOneByOne)
{
  const vtkSmartPointer<vtkImageData> image = imageOf(20, 1.3);
  const vtkSmartPointer<vtkStructuredGrid> ball = ballOf(9);
  sphere->SetCenter(0.4, 0, 0);
  const double volumes[2] = {volumeOf(clipped(image)), volumeOf(clipped(ball))};
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, image);
  blocks->SetBlock(2, ball);
  clip->SetInputData(blocks);
  clip->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(clip->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  ASSERT_EQ(output->GetNumberOfBlocks(), 3u);
  EXPECT_EQ(output->GetBlock(1), nullptr);
  for (unsigned int block : {0u, 2u})
  {
    auto* part = vtkUnstructuredGrid::SafeDownCast(output->GetBlock(block));
    ASSERT_NE(part, nullptr);
    EXPECT_NEAR(volumeOf(part), volumes[block / 2], 1e-4);
  }
}

TEST_F(Clip, EmptyResultsAreAnnounced)
{
  sphere->SetCenter(9, 0, 0);
  const vtkSmartPointer<vtkImageData> image = imageOf(5, 1);
  {
    ErrorLog log(clip);
    EXPECT_EQ(clipped(image)->GetNumberOfCells(), 0);
    EXPECT_NE(log.warnings().find("no point is inside, so the result is empty"), std::string::npos)
      << log.warnings();
    EXPECT_EQ(clip->GetStatus(), vtkWindingNumberAlgorithm::DONE);
  }
  clip->InsideOutOn();
  ErrorLog log(clip);
  EXPECT_EQ(clipped(image)->GetNumberOfCells(), image->GetNumberOfCells());
  EXPECT_EQ(log.warnings(), "");
  vtkNew<vtkUnstructuredGrid> nothing;
  EXPECT_EQ(clipped(nothing)->GetNumberOfCells(), 0);
  EXPECT_EQ(log.warnings(), "") << "of nothing nothing can be inside";
  clip->SetInputData(image);
  clip->RemoveAllInputConnections(1);
  clip->Update();
  EXPECT_NE(log.errors().find("there is no source"), std::string::npos) << log.errors();
  EXPECT_EQ(clip->GetStatus(), vtkWindingNumberAlgorithm::REFUSED);
}

TEST_F(Clip, PartsThatDoNotFitAreRefusedBeforeTheyAreCut)
{
  const auto noneFree = []()
  {
    return winding::HostMemory{1e9, 1e9};
  };
  const vtkSmartPointer<vtkImageData> image = imageOf(101, 1);
  std::vector<double> numbers(101 * 101 * 101, -1);
  EXPECT_EQ(winding::clippedPart(image, numbers.data(), noneFree)->GetNumberOfCells(), 0);
  std::fill(numbers.begin(), numbers.end(), 1);
  try
  {
    winding::clippedPart(image, numbers.data(), noneFree);
    FAIL();
  }
  catch (const winding::OutOfMemory& refusal)
  {
    EXPECT_NE(std::string(refusal.what()).find("clip a part of the data set"), std::string::npos);
  }
  // Every cell is cut: of neighbouring points one is kept. Cells that are cut count as whole ones.
  for (std::size_t i = 1; i < numbers.size(); i += 2)
  {
    numbers[i] = -1;
  }
  EXPECT_THROW(winding::clippedPart(image, numbers.data(), noneFree), winding::OutOfMemory);
}

TEST_F(Clip, NumbersTellTheSideOfPointsOnTheSourceToo)
{
  // Points of the image lie on the vertices, edges and faces of a tetrahedron, at distance 0.
  const double corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::int32_t ids[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  const auto field = winding::Field::build(
    std::vector<winding::TrianglesView>{{winding::VectorsView(corners, 4), {ids, 4}}}, {}, serial);
  const vtkSmartPointer<vtkImageData> image = imageOf(7, 1.5);
  const winding::ProbeQueries queries(image, false, true, winding::wordsOfClip);
  std::vector<unsigned char> kept;
  std::size_t onFaces = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* x = image->GetPoint(i);
    kept.push_back(*std::min_element(x, x + 3) >= 0 && x[0] + x[1] + x[2] <= 1);
    onFaces += kept.back();
  }
  ASSERT_EQ(onFaces, 10u);
  const std::vector<double> numbers =
    winding::cutDistances(*field, queries, kept.data(), winding::InsideTest(), serial);
  ASSERT_EQ(numbers.size(), kept.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    EXPECT_NE(numbers[i], 0) << i;
    EXPECT_EQ(numbers[i] > 0, kept[i] != 0) << i;
    EXPECT_TRUE(!kept[i] || numbers[i] < 1e-12) << i;
  }
}

TEST_F(Clip, ProgressRisesAndWorkCanBeAborted)
{
  sphere->SetStartTheta(50);
  const vtkSmartPointer<vtkImageData> image = imageOf(40, 1.3);
  for (const double share : {0.3, 0.7})
  {
    clip->Modified();
    clip->SetInputData(image);
    ProgressLog log(clip, share);
    clip->Update();
    EXPECT_EQ(clip->GetStatus(), vtkWindingNumberAlgorithm::ABORTED) << share;
    EXPECT_EQ(clip->GetOutput()->GetNumberOfCells(), 0);
  }
  clip->Modified();
  ProgressLog log(clip);
  EXPECT_GT(clipped(image)->GetNumberOfCells(), 0);
  EXPECT_TRUE(log.isRising());
  EXPECT_EQ(log.last(), 1);
}

TEST_F(Clip, ProgressIsThatOfTheExecution)
{
  // After the first of two blocks nine tenths are done, in every execution anew.
  const vtkSmartPointer<vtkImageData> image = imageOf(20, 1.3);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, image);
  blocks->SetBlock(1, image);
  clip->SetInputData(blocks);
  clip->Update();
  EXPECT_EQ(clip->GetStatus(), vtkWindingNumberAlgorithm::DONE);
  clip->Modified();
  ProgressLog log(clip, 0.85);
  clip->Update();
  EXPECT_EQ(clip->GetStatus(), vtkWindingNumberAlgorithm::ABORTED);
  EXPECT_NEAR(log.abortedAt(), 0.9, 1e-6);
}

} // namespace
