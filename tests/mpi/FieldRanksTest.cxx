// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/OnRanks.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkWindingNumberField.h"

#include <gtest/gtest.h>

/**
 * @file
 * Fields of sources that are dealt out to the ranks of a parallel program.
 */

using namespace onranks;

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
        EXPECT_EQ(vtkWindingNumberAlgorithm::GetRanksOnHost(), ranks());
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
    vtkNew<vtkDoubleArray> areas; // other than the areas of the points' cells
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

TEST(FieldOnRanks, OfEqualPointsWithOtherAreasOrNormalsIsOfNoCopies)
{
  for (const bool differInAreas : {false, true})
  {
    SCOPED_TRACE(differInAreas);
    const auto part = pointsOf(shapes::icosphere(2), whole, 0, 1);
    vtkNew<vtkDoubleArray> areas;
    areas->SetName("Area");
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      areas->InsertNextValue(differInAreas ? 0.01 * (rank() + 1) : 0.01);
      const double* const normal = part->GetPointData()->GetNormals()->GetTuple3(i);
      const double factor = differInAreas ? 1 : rank() % 2 == 0 ? 1 : -1;
      const double own[3] = {factor * normal[0], factor * normal[1], factor * normal[2]};
      part->GetPointData()->GetNormals()->SetTuple(i, own);
    }
    part->GetPointData()->AddArray(areas);
    const auto field = filterOf<vtkWindingNumberField>(part, false);
    field->SetPointAreaMethod(vtkWindingNumberField::ARRAY);
    field->SetUseInputBounds(false);
    field->SetSamplingBounds(-0.1, 0.1, -0.1, 0.1, -0.1, 0.1);
    field->SetSamplingDimensions(2, 2, 2 * ranks());
    updatePiece(field);
    // The parts add up. A sphere of area 4 pi has w = 1 inside, and that of its points is 162.
    const double ofArea = 0.01 * 162 / (4 * vtkMath::Pi());
    const double sum = differInAreas ? 0.5 * ranks() * (ranks() + 1) : ranks() % 2;
    vtkDataArray* const values = field->GetOutput()->GetPointData()->GetArray("WindingNumber");
    ASSERT_NE(values, nullptr);
    EXPECT_NEAR(values->GetTuple1(0), sum * ofArea, 1e-2);
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
  EXPECT_EQ(log.errors().find("the source is not replicated") == std::string::npos, ranks() == 1)
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
