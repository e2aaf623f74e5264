#include "filters/ErrorLog.h"
#include "mpi/Deals.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkHyperTreeGrid.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointAreas.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkSurfaceReport.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberHyperTree.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberSurface.h"

#include <gtest/gtest.h>

#include <cstring>

/**
 * @file
 * Filters whose source is dealt out to the ranks of a parallel program have the results of one rank
 * that has the whole source, to the bit.
 */

namespace
{

using shapes::Mesh;

const Deal whole = {"whole", [](std::size_t, std::size_t, int)
  {
    return 0;
  }};

vtkMultiProcessController* world()
{
  return vtkMultiProcessController::GetGlobalController();
}

int rank()
{
  return world()->GetLocalProcessId();
}

int ranks()
{
  return world()->GetNumberOfProcesses();
}

/// The filter of this rank's part, or of the whole without the others.
template <class Filter> vtkSmartPointer<Filter> filterOf(vtkPolyData* source, bool isAlone)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(source);
  if (isAlone)
  {
    filter->SetController(nullptr);
  }
  return filter;
}

void expectSame(vtkDataArray* found, vtkDataArray* expected)
{
  ASSERT_NE(found, nullptr);
  ASSERT_NE(expected, nullptr);
  ASSERT_EQ(found->GetNumberOfValues(), expected->GetNumberOfValues());
  EXPECT_EQ(std::memcmp(found->GetVoidPointer(0), expected->GetVoidPointer(0),
              static_cast<std::size_t>(found->GetNumberOfValues()) *
                static_cast<std::size_t>(found->GetDataTypeSize())),
    0)
    << found->GetName();
}

Mesh openSphere()
{
  const Mesh sphere = shapes::icosphere(3);
  return sphere.part(100, sphere.triangles.size());
}

/// A closed and an open surface, a soup, and another one for the far field.
std::vector<std::pair<std::string, Mesh>> meshes()
{
  return {{"closed", shapes::icosphere(3)}, {"open", openSphere()},
    {"soup", shapes::triangleSoup(300, 811)}, {"torus", shapes::torus(30, 20)}};
}

/// The piece of a filter's output that is this rank's.
void updatePiece(vtkAlgorithm* filter)
{
  filter->UpdatePiece(rank(), ranks(), 0);
}

/// Expects that ranks refuse because a filter's properties differ between them; one alone has no
/// others that they could differ from.
void expectDifferentProperties(vtkAlgorithm* filter)
{
  const ErrorLog log(filter);
  updatePiece(filter);
  EXPECT_EQ(log.errors().find("set the same properties") == std::string::npos, ranks() == 1)
    << log.errors();
}

} // namespace

TEST(FieldOnRanks, HasTheBitsOfOneRank)
{
  for (const auto& [name, mesh] : meshes())
  {
    for (const Deal& deal : deals())
    {
      for (const int method :
        {vtkWindingNumberField::AUTOMATIC, vtkWindingNumberField::HIERARCHICAL})
      {
        SCOPED_TRACE(name + ", " + deal.name + ", method " + std::to_string(method));
        const auto set = [method](vtkWindingNumberField* field)
        {
          field->SetResolution(17);
          field->SetMethod(method);
          field->SetGenerateInside(true);
          field->SetGenerateSignedDistance(true);
        };
        const auto expected = filterOf<vtkWindingNumberField>(partOf(mesh, whole, 0, 1), true);
        set(expected);
        const auto found =
          filterOf<vtkWindingNumberField>(partOf(mesh, deal, rank(), ranks()), false);
        set(found);
        updatePiece(found);
        int extent[6];
        found->GetOutput()->GetExtent(extent);
        expected->UpdateExtent(extent);
        for (const char* array : {"WindingNumber", "Inside", "SignedDistance"})
        {
          expectSame(found->GetOutput()->GetPointData()->GetArray(array),
            expected->GetOutput()->GetPointData()->GetArray(array));
        }
        EXPECT_EQ(found->GetNumberOfPrimitives(), static_cast<vtkIdType>(mesh.triangles.size()));
      }
    }
  }
}

TEST(FieldOnRanks, OfACloudHasTheBitsOfOneRank)
{
  const Mesh mesh = shapes::icosphere(3);
  for (const Deal& deal : deals())
  {
    SCOPED_TRACE(deal.name);
    const auto expected = filterOf<vtkWindingNumberField>(pointsOf(mesh, whole, 0, 1), true);
    const auto found =
      filterOf<vtkWindingNumberField>(pointsOf(mesh, deal, rank(), ranks()), false);
    expected->SetResolution(15);
    found->SetResolution(15);
    updatePiece(found);
    expected->UpdateExtent(found->GetOutput()->GetExtent());
    expectSame(found->GetOutput()->GetPointData()->GetArray("WindingNumber"),
      expected->GetOutput()->GetPointData()->GetArray("WindingNumber"));
  }
}

TEST(FieldOnRanks, OfACloudTakesTheAreasThatAreGiven)
{
  const Mesh mesh = shapes::icosphere(3);
  const auto withAreas = [](const vtkSmartPointer<vtkPolyData>& part)
  {
    vtkNew<vtkDoubleArray> areas; // other than those of the points' cells
    areas->SetName("Area");
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      areas->InsertNextValue(0.01 * (2 + part->GetPoint(i)[0]));
    }
    part->GetPointData()->AddArray(areas);
    return part;
  };
  for (const Deal& deal : deals())
  {
    SCOPED_TRACE(deal.name);
    const auto expected =
      filterOf<vtkWindingNumberField>(withAreas(pointsOf(mesh, whole, 0, 1)), true);
    const auto found =
      filterOf<vtkWindingNumberField>(withAreas(pointsOf(mesh, deal, rank(), ranks())), false);
    for (const auto& field : {expected, found})
    {
      field->SetPointAreaMethod(vtkWindingNumberField::ARRAY);
      field->SetResolution(15);
    }
    updatePiece(found);
    expected->UpdateExtent(found->GetOutput()->GetExtent());
    EXPECT_NEAR(expected->GetMeanPointArea(), 0.02, 1e-3);
    expectSame(found->GetOutput()->GetPointData()->GetArray("WindingNumber"),
      expected->GetOutput()->GetPointData()->GetArray("WindingNumber"));
  }
}

TEST(FieldOnRanks, LeavesOutWhatRefersToNoPoint)
{
  // Each rank has two blocks. A bad triangle of the first refers to a point that only both blocks
  // together have.
  const Mesh mesh = shapes::icosphere(2);
  const auto sourceOf = [&mesh](const Deal& deal, int rank, int ranks)
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    for (unsigned int block = 0; block < 2; ++block)
    {
      const auto half = partOf(mesh.part(block * 160, 160 + block * 160), deal, rank, ranks);
      if (block == 0)
      {
        half->GetPolys()->InsertNextCell({0, 1, half->GetNumberOfPoints()});
      }
      blocks->SetBlock(block, half);
    }
    return vtkSmartPointer<vtkMultiBlockDataSet>(blocks);
  };
  vtkNew<vtkWindingNumberField> expected, found;
  expected->SetController(nullptr);
  expected->SetInputDataObject(partOf(mesh, whole, 0, 1));
  found->SetInputDataObject(sourceOf(deals()[0], rank(), ranks()));
  for (vtkWindingNumberField* field : {expected.Get(), found.Get()})
  {
    field->SetResolution(9);
  }
  updatePiece(found);
  expected->UpdateExtent(found->GetOutput()->GetExtent());
  EXPECT_EQ(found->GetNumberOfDroppedPrimitives(), ranks());
  expectSame(found->GetOutput()->GetPointData()->GetArray("WindingNumber"),
    expected->GetOutput()->GetPointData()->GetArray("WindingNumber"));
}

TEST(FieldOnRanks, AsksForItsPartOfASourceUnlessThatIsReplicated)
{
  struct Case
  {
    int distribution, piece, pieces;
  };
  for (const Case& c : {Case{vtkWindingNumberField::DISTRIBUTION_AUTOMATIC, rank(), ranks()},
         Case{vtkWindingNumberField::DISTRIBUTED, rank(), ranks()},
         Case{vtkWindingNumberField::REPLICATED, 0, 1}})
  {
    vtkNew<vtkSphereSource> sphere; // makes the piece that it is asked for
    vtkNew<vtkWindingNumberField> field;
    field->SetInputConnection(sphere->GetOutputPort());
    field->SetResolution(6);
    field->SetSourceDistribution(c.distribution);
    updatePiece(field);
    vtkInformation* const made = sphere->GetOutput()->GetInformation();
    EXPECT_EQ(made->Get(vtkDataObject::DATA_PIECE_NUMBER()), c.piece) << c.distribution;
    EXPECT_EQ(made->Get(vtkDataObject::DATA_NUMBER_OF_PIECES()), c.pieces) << c.distribution;
    EXPECT_EQ(field->GetNumberOfPrimitives(), 96) << "the whole, and once";
  }
}

TEST(FieldOnRanks, OfCopiesIsThatOfOne)
{
  const auto copy = partOf(shapes::icosphere(2), whole, 0, 1);
  for (const int distribution : {vtkWindingNumberField::DISTRIBUTION_AUTOMATIC,
         vtkWindingNumberField::REPLICATED, vtkWindingNumberField::DISTRIBUTED})
  {
    SCOPED_TRACE(distribution);
    const auto field = filterOf<vtkWindingNumberField>(copy, false);
    field->SetResolution(9);
    field->SetSourceDistribution(distribution);
    updatePiece(field);
    const double times = distribution == vtkWindingNumberField::DISTRIBUTED ? ranks() : 1;
    EXPECT_EQ(field->GetOutput()->GetPointData()->GetArray("WindingNumber")->GetRange()[1], times);
  }
}

TEST(FieldOnRanks, FollowsTheDistributionThatIsSetLater)
{
  const auto field =
    filterOf<vtkWindingNumberField>(partOf(shapes::icosphere(2), whole, 0, 1), false);
  field->SetResolution(9);
  for (const int distribution :
    {vtkWindingNumberField::DISTRIBUTED, vtkWindingNumberField::DISTRIBUTION_AUTOMATIC,
      vtkWindingNumberField::DISTRIBUTED, vtkWindingNumberField::REPLICATED})
  {
    field->SetSourceDistribution(distribution);
    updatePiece(field);
    const double times = distribution == vtkWindingNumberField::DISTRIBUTED ? ranks() : 1;
    EXPECT_EQ(field->GetOutput()->GetPointData()->GetArray("WindingNumber")->GetRange()[1], times);
  }
}

TEST(FieldOnRanks, WithOtherThresholdsIsRefusedOnAll)
{
  const auto part = partOf(shapes::icosphere(2), deals()[1], rank(), ranks());
  const auto field = filterOf<vtkWindingNumberField>(part, false);
  field->SetResolution(8);
  field->SetWindingThreshold(rank() == 0 ? 0.5 : 0.25);
  const ErrorLog log(field);
  updatePiece(field);
  EXPECT_EQ(log.errors().empty(), ranks() == 1) << log.errors();
}

TEST(FieldOnRanks, IsKeptUntilAPartChanges)
{
  const Mesh mesh = openSphere();
  const auto part = partOf(mesh, deals()[0], rank(), ranks());
  const auto field = filterOf<vtkWindingNumberField>(part, false);
  field->SetResolution(9);
  updatePiece(field);
  field->SetResolution(10);
  updatePiece(field);
  EXPECT_EQ(field->GetNumberOfPrimitives(), static_cast<vtkIdType>(mesh.triangles.size()));
  if (rank() == ranks() - 1)
  {
    part->Initialize();
  }
  // Only one part has changed, but all ranks execute together.
  field->Modified();
  updatePiece(field);
  const std::size_t left = mesh.triangles.size() - mesh.triangles.size() / ranks();
  EXPECT_NEAR(field->GetNumberOfPrimitives(), static_cast<double>(left), 1);
}

TEST(FieldOnRanks, ExpectsTheShareOfARank)
{
  const auto expectedOf = [](bool isAlone)
  {
    const Mesh mesh = shapes::icosphere(2);
    const auto part =
      isAlone ? partOf(mesh, whole, 0, 1) : partOf(mesh, deals()[0], rank(), ranks());
    const auto field = filterOf<vtkWindingNumberField>(part, isAlone);
    field->SetResolution(60);
    updatePiece(field);
    return static_cast<double>(field->GetExpectedMemory());
  };
  EXPECT_NEAR(expectedOf(true) / expectedOf(false), ranks(), 0.1 * ranks());
}

TEST(FieldOnRanks, WithBadDataOnOneRankIsRefusedOnAll)
{
  const auto part = partOf(shapes::icosphere(2), deals()[1], rank(), ranks());
  if (rank() == ranks() - 1)
  {
    part->GetPoints()->SetPoint(0, 1e200, 0, 0);
  }
  const auto field = filterOf<vtkWindingNumberField>(part, false);
  const ErrorLog log(field);
  updatePiece(field);
  EXPECT_NE(log.errors().find("1e+200"), std::string::npos) << log.errors();
  EXPECT_EQ(log.errors().find("(rank ") == std::string::npos, ranks() == 1);
}

TEST(FieldOnRanks, WithOtherPropertiesIsRefusedOnAll)
{
  const auto part = partOf(shapes::icosphere(2), deals()[1], rank(), ranks());
  const auto field = filterOf<vtkWindingNumberField>(part, false);
  field->SetResolution(8);
  field->SetTolerance(rank() == 0 ? 1e-3 : 1e-4);
  const ErrorLog log(field);
  updatePiece(field);
  EXPECT_EQ(log.errors().empty(), ranks() == 1) << log.errors();
  field->SetTolerance(rank() == ranks() - 1 ? -1 : 1e-3);
  field->Modified();
  updatePiece(field);
  EXPECT_NE(log.errors().find("Tolerance"), std::string::npos) << log.errors();
  field->SetTolerance(1e-3);
  field->Modified();
  updatePiece(field);
  EXPECT_GT(field->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(FieldOnRanks, WithPropertiesOfItsOwnThatDifferIsRefusedOnAll)
{
  using Set = void (*)(vtkWindingNumberField*, bool);
  const Set sets[] = {
    [](vtkWindingNumberField* field, bool is) { field->SetUseInputBounds(is); },
    [](vtkWindingNumberField* field, bool is) { field->SetResolution(is ? 8 : 9); },
    [](vtkWindingNumberField* field, bool is) { field->SetOutputAssociation(is); },
    [](vtkWindingNumberField* field, bool is) { field->SetCoverage(is); },
    [](vtkWindingNumberField* field, bool is) { field->SetDistanceBand(is ? 3 : 0); },
    [](vtkWindingNumberField* field, bool is) { field->SetResultArrayName(is ? "w" : "v"); },
    [](vtkWindingNumberField* field, bool is) { field->SetPadding(is ? 0.1 : 0.2); },
  };
  for (const Set& set : sets)
  {
    SCOPED_TRACE(&set - sets);
    const auto part = partOf(shapes::icosphere(2), deals()[1], rank(), ranks());
    const auto field = filterOf<vtkWindingNumberField>(part, false);
    field->SetSamplingBounds(-1, 1, -1, 1, -1, 1);
    set(field, rank() == 0);
    const ErrorLog log(field);
    updatePiece(field);
    EXPECT_EQ(
      log.errors().find("set the same properties on all ranks") == std::string::npos, ranks() == 1)
      << log.errors();
    // The same line on every rank, and once.
    EXPECT_EQ(log.errors().find("look at the error before"), std::string::npos) << log.errors();
  }
}

TEST(FieldOnRanks, OfPartsThatShouldBeCopiesIsRefusedOnAll)
{
  const auto field = filterOf<vtkWindingNumberField>(
    partOf(shapes::icosphere(2), deals()[1], rank(), ranks()), false);
  field->SetResolution(8);
  field->SetSourceDistribution(vtkWindingNumberField::REPLICATED);
  const ErrorLog log(field);
  updatePiece(field);
  EXPECT_EQ(log.errors().find("the source is no replicated one") == std::string::npos, ranks() == 1)
    << log.errors();
}

TEST(FieldOnRanks, OfSurfacesAndCloudsIsRefused)
{
  const Mesh mesh = shapes::icosphere(2);
  const auto part = rank() == 0 ? partOf(mesh, whole, 0, 1) : pointsOf(mesh, whole, 0, 1);
  const auto field = filterOf<vtkWindingNumberField>(part, false);
  const ErrorLog log(field);
  updatePiece(field);
  EXPECT_EQ(log.errors().find("extract the parts of one kind") == std::string::npos, ranks() == 1);
}

TEST(ProbeOnRanks, AnswersTheQueriesOfEachRank)
{
  vtkNew<vtkPoints> points;
  shapes::Random random(812 + static_cast<unsigned>(rank()));
  for (int i = 0; i < 500; ++i)
  {
    points->InsertNextPoint(random.point(-1.2, 1.2).data());
  }
  vtkNew<vtkPolyData> queries;
  queries->SetPoints(points);
  for (const auto& [name, mesh] : meshes())
  {
    SCOPED_TRACE(name);
    const auto probeOf = [&](vtkPolyData* source, bool isAlone)
    {
      auto probe = filterOf<vtkWindingNumberProbe>(queries, isAlone);
      probe->SetSourceData(source);
      probe->SetMethod(vtkWindingNumberProbe::DIRECT);
      probe->SetGenerateSignedDistance(true);
      updatePiece(probe);
      return probe;
    };
    const auto expected = probeOf(partOf(mesh, whole, 0, 1), true);
    const auto found = probeOf(partOf(mesh, deals()[0], rank(), ranks()), false);
    for (const char* array : {"WindingNumber", "SignedDistance"})
    {
      expectSame(found->GetOutput()->GetPointData()->GetArray(array),
        expected->GetOutput()->GetPointData()->GetArray(array));
    }
  }
}

TEST(ProbeOnRanks, WithOtherPropertiesIsRefusedOnAll)
{
  const auto part = partOf(shapes::icosphere(2), deals()[0], rank(), ranks());
  const auto probe = filterOf<vtkWindingNumberProbe>(pointsOf(openSphere(), whole, 0, 1), false);
  probe->SetSourceData(part);
  probe->SetInsideOut(rank() == 0);
  expectDifferentProperties(probe);
}

TEST(SurfaceOnRanks, WithOtherPropertiesIsRefusedOnAll)
{
  const auto part = partOf(shapes::icosphere(2), deals()[0], rank(), ranks());
  const auto surface = filterOf<vtkWindingNumberSurface>(part, false);
  surface->SetResolution(8);
  surface->SetCloseBorder(rank() == 0);
  expectDifferentProperties(surface);
}

TEST(SurfaceOnRanks, IsThatOfOneRankOnTheFirst)
{
  for (const int features : {vtkWindingNumberSurface::SMOOTH, vtkWindingNumberSurface::SHARP})
  {
    for (const auto& [name, mesh] : meshes())
    {
      SCOPED_TRACE(name);
      const auto surfaceOf = [features](vtkPolyData* source, bool isAlone)
      {
        auto surface = filterOf<vtkWindingNumberSurface>(source, isAlone);
        surface->SetResolution(17);
        surface->SetFeatures(features);
        return surface;
      };
      const auto expected = surfaceOf(partOf(mesh, whole, 0, 1), true);
      expected->Update();
      const auto found = surfaceOf(partOf(mesh, deals()[0], rank(), ranks()), false);
      updatePiece(found);
      if (rank() > 0)
      {
        EXPECT_EQ(found->GetOutput()->GetNumberOfCells(), 0);
        continue;
      }
      ASSERT_GT(expected->GetOutput()->GetNumberOfCells(), 0);
      expectSame(
        found->GetOutput()->GetPoints()->GetData(), expected->GetOutput()->GetPoints()->GetData());
      expectSame(found->GetOutput()->GetPolys()->GetConnectivityArray(),
        expected->GetOutput()->GetPolys()->GetConnectivityArray());
    }
  }
}

TEST(HyperTreeOnRanks, IsThatOfOneRankOnTheFirst)
{
  for (const auto& [name, mesh] : meshes())
  {
    SCOPED_TRACE(name);
    const auto treesOf = [](vtkPolyData* source, bool isAlone)
    {
      auto trees = filterOf<vtkWindingNumberHyperTree>(source, isAlone);
      trees->SetResolution(20);
      trees->GenerateWindingNumberOff();
      trees->GenerateInsideOn();
      return trees;
    };
    const auto expected = treesOf(partOf(mesh, whole, 0, 1), true);
    expected->Update();
    const auto found = treesOf(partOf(mesh, deals()[0], rank(), ranks()), false);
    updatePiece(found);
    if (rank() > 0)
    {
      EXPECT_EQ(found->GetOutput()->GetNumberOfNonEmptyTrees(), 0);
      continue;
    }
    ASSERT_GT(expected->GetOutput()->GetNumberOfNonEmptyTrees(), 0);
    expectSame(found->GetOutput()->GetCellData()->GetArray("Inside"),
      expected->GetOutput()->GetCellData()->GetArray("Inside"));
  }
}

TEST(ReportOnRanks, CountsTheWholeOnEachRank)
{
  for (const auto& [name, mesh] : meshes())
  {
    SCOPED_TRACE(name);
    const auto expected = filterOf<vtkSurfaceReport>(partOf(mesh, whole, 0, 1), true);
    expected->Update();
    const auto found = filterOf<vtkSurfaceReport>(partOf(mesh, deals()[1], rank(), ranks()), false);
    updatePiece(found);
    EXPECT_EQ(found->GetNumberOfTriangles(), static_cast<vtkIdType>(mesh.triangles.size()));
    EXPECT_EQ(found->GetNumberOfBoundaryEdges(), expected->GetNumberOfBoundaryEdges());
    EXPECT_EQ(found->GetNumberOfComponents(), expected->GetNumberOfComponents());
    EXPECT_NEAR(found->GetArea(), expected->GetArea(), 1e-12 * expected->GetArea());
    EXPECT_EQ(found->GetFaults()->GetNumberOfBlocks() > 0,
      rank() == 0 && expected->GetFaults()->GetNumberOfBlocks() > 0);
  }
}

TEST(HyperTreeOnRanks, WithOtherPropertiesIsRefusedOnAll)
{
  const auto part = partOf(shapes::icosphere(2), deals()[0], rank(), ranks());
  const auto trees = filterOf<vtkWindingNumberHyperTree>(part, false);
  trees->SetResolution(8);
  trees->SetMergeTolerance(rank() == 0 ? 0 : 0.01);
  expectDifferentProperties(trees);
}

TEST(ReportOnRanks, WithOtherPropertiesIsRefusedOnAll)
{
  const auto report =
    filterOf<vtkSurfaceReport>(partOf(shapes::icosphere(1), deals()[0], rank(), ranks()), false);
  report->SetFaultThickness(rank() == 0 ? 0.01 : 0.02);
  expectDifferentProperties(report);
}

TEST(ReportOnRanks, RefusesToTurnFacesThatOthersHave)
{
  const auto report =
    filterOf<vtkSurfaceReport>(partOf(shapes::icosphere(1), deals()[0], rank(), ranks()), false);
  report->SetFixOrientation(true);
  const ErrorLog log(report);
  updatePiece(report);
  EXPECT_EQ(log.errors().empty(), ranks() == 1) << log.errors();
}

TEST(AreasOnRanks, NormalsOfOwnPointsAreThoseOfOneRank)
{
  const Mesh mesh = shapes::icosphere(3);
  const auto areasOf = [&mesh](const Deal& deal, int of, int ranks, bool alone)
  {
    const vtkSmartPointer<vtkPolyData> points = pointsOf(mesh, deal, of, ranks);
    points->GetPointData()->Initialize();
    auto areas = filterOf<vtkPointAreas>(points, alone);
    areas->EstimateNormalsOn();
    return areas;
  };
  const auto expected = areasOf(whole, 0, 1, true);
  expected->Update();
  vtkDataArray* all =
    vtkPolyData::SafeDownCast(expected->GetOutputDataObject(0))->GetPointData()->GetNormals();
  for (const Deal& deal : deals())
  {
    SCOPED_TRACE(deal.name);
    const auto found = areasOf(deal, rank(), ranks(), false);
    updatePiece(found);
    EXPECT_STREQ(found->GetNormalEstimationUsed(), "spanning tree");
    vtkDataArray* own =
      vtkPolyData::SafeDownCast(found->GetOutputDataObject(0))->GetPointData()->GetNormals();
    ASSERT_NE(own, nullptr);
    vtkIdType next = 0;
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      if (deal.rankOf(i, mesh.points.size(), ranks()) == rank())
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          ASSERT_EQ(
            own->GetComponent(next, axis), all->GetComponent(static_cast<vtkIdType>(i), axis));
        }
        ++next;
      }
    }
    EXPECT_EQ(next, own->GetNumberOfTuples());
  }
}

TEST(AreasOnRanks, OfOwnPointsAreThoseOfOneRank)
{
  const Mesh mesh = shapes::icosphere(3);
  const auto expected = filterOf<vtkPointAreas>(pointsOf(mesh, whole, 0, 1), true);
  expected->Update();
  const auto* all = vtkDoubleArray::SafeDownCast(
    vtkPolyData::SafeDownCast(expected->GetOutputDataObject(0))->GetPointData()->GetArray("Area"));
  for (const Deal& deal : deals())
  {
    SCOPED_TRACE(deal.name);
    const auto found = filterOf<vtkPointAreas>(pointsOf(mesh, deal, rank(), ranks()), false);
    updatePiece(found);
    auto* own = vtkDoubleArray::SafeDownCast(
      vtkPolyData::SafeDownCast(found->GetOutputDataObject(0))->GetPointData()->GetArray("Area"));
    ASSERT_NE(own, nullptr);
    vtkIdType next = 0;
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      if (deal.rankOf(i, mesh.points.size(), ranks()) == rank())
      {
        ASSERT_EQ(own->GetValue(next++), all->GetValue(static_cast<vtkIdType>(i))) << i;
      }
    }
    EXPECT_EQ(next, own->GetNumberOfTuples());
  }
}
