// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/OnRanks.h"
#include "vtk/MovingSphere.h"

#include "vtkAlgorithmOutput.h"
#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkWindingNumberBoolean.h"
#include "vtkWindingNumberNormals.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberReport.h"
#include "vtkWindingNumberSurface.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

/**
 * @file
 * Probes, surfaces, reports and areas of sources that are dealt out to the ranks of a parallel
 * program.
 */

using namespace onranks;

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

/// Parts that move apart: each rank knows the times of its own.
TEST(SurfaceOnRanks, LiesOverAllTimesOfAllParts)
{
  const auto boundsOf = [](vtkAlgorithmOutput* source, bool isAlone)
  {
    vtkNew<vtkWindingNumberSurface> filter;
    filter->SetInputConnection(source);
    filter->SetResolution(20);
    filter->BoundsOverAllTimesOn();
    if (isAlone)
    {
      filter->SetController(nullptr);
    }
    filter->UpdateTimeStep(2, rank(), ranks());
    std::array<double, 6> bounds;
    filter->GetOutput()->GetBounds(bounds.data());
    return bounds;
  };
  vtkNew<vtkAppendPolyData> all;
  std::vector<vtkSmartPointer<MovingSphere>> parts;
  for (int of = 0; of < ranks(); ++of)
  {
    parts.push_back(vtkSmartPointer<MovingSphere>::New());
    parts.back()->SetStep(2.0 * of);
    all->AddInputConnection(parts.back()->GetOutputPort());
  }
  const auto found = boundsOf(parts[static_cast<std::size_t>(rank())]->GetOutputPort(), false);
  const auto expected = boundsOf(all->GetOutputPort(), true);
  if (rank() == 0)
  {
    EXPECT_GT(expected[1], 4 * (ranks() - 1));
    EXPECT_EQ(found, expected);
  }
}

TEST(BooleanOnRanks, IsThatOfOneRankOnTheFirst)
{
  const shapes::Mesh tool = shapes::cube({0.1, 0.2, -0.3}, {1.5, 1.4, 1.3});
  for (const auto& [name, mesh] : meshes())
  {
    SCOPED_TRACE(name);
    const auto booleanOf = [&tool](const shapes::Mesh& first, bool isAlone)
    {
      const auto partOfThis = [isAlone](const shapes::Mesh& all)
      {
        return isAlone ? partOf(all, whole, 0, 1) : partOf(all, deals()[0], rank(), ranks());
      };
      auto boolean = filterOf<vtkWindingNumberBoolean>(partOfThis(first), isAlone);
      boolean->SetInputDataObject(1, partOfThis(tool));
      boolean->SetResolution(17);
      boolean->SetOperationToDifference();
      boolean->GenerateImageOn();
      return boolean;
    };
    const auto expected = booleanOf(mesh, true);
    expected->Update();
    const auto found = booleanOf(mesh, false);
    updatePiece(found);
    if (rank() > 0)
    {
      EXPECT_EQ(found->GetOutput()->GetNumberOfCells(), 0);
      EXPECT_EQ(found->GetImage()->GetNumberOfPoints(), 0);
      continue;
    }
    expectSame(found->GetImage()->GetPointData()->GetArray("Inside"),
      expected->GetImage()->GetPointData()->GetArray("Inside"));
    ASSERT_GT(expected->GetOutput()->GetNumberOfCells(), 0);
    expectSame(
      found->GetOutput()->GetPoints()->GetData(), expected->GetOutput()->GetPoints()->GetData());
    expectSame(found->GetOutput()->GetPolys()->GetConnectivityArray(),
      expected->GetOutput()->GetPolys()->GetConnectivityArray());
  }
}

/// Cells of other ranks have no numbers here, so the whole source is needed, on all ranks.
TEST(SurfaceOnRanks, TakesAttributesFromAWholeSourceOnly)
{
  const shapes::Mesh mesh = shapes::icosphere(2);
  const auto surfaceOf = [](vtkPolyData* source, bool isAlone)
  {
    auto surface = filterOf<vtkWindingNumberSurface>(source, isAlone);
    surface->SetResolution(9);
    surface->GenerateNearestCellsOn();
    return surface;
  };
  const auto expected = surfaceOf(partOf(mesh, whole, 0, 1), true);
  expected->Update();
  const auto copies = surfaceOf(partOf(mesh, whole, 0, 1), false);
  copies->SetSourceDistribution(vtkWindingNumberSurface::REPLICATED);
  updatePiece(copies);
  if (rank() == 0)
  {
    expectSame(copies->GetOutput()->GetCellData()->GetArray("NearestCell"),
      expected->GetOutput()->GetCellData()->GetArray("NearestCell"));
  }
  const auto parts = surfaceOf(partOf(mesh, deals()[0], rank(), ranks()), false);
  const ErrorLog log(parts);
  updatePiece(parts);
  EXPECT_EQ(log.errors().find("cells of other ranks") == std::string::npos, ranks() == 1)
    << log.errors();
}

/// The fractions of each rank's own cells are the same as on one rank.
TEST(ProbeOnRanks, GivesFractionsOfTheWholeSource)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(0, 5, 0, 6, rank(), rank() + 3);
  image->SetOrigin(-1, -1.1, -1);
  image->SetSpacing(0.37, 0.33, 0.41);
  for (const auto& [name, mesh] : meshes())
  {
    SCOPED_TRACE(name);
    const auto probeOf = [&](vtkPolyData* source, bool isAlone)
    {
      auto probe = filterOf<vtkWindingNumberProbe>(image, isAlone);
      probe->SetSourceData(source);
      probe->SetMethod(vtkWindingNumberProbe::DIRECT);
      probe->GenerateFractionOn();
      probe->Update();
      return probe;
    };
    const auto expected = probeOf(partOf(mesh, whole, 0, 1), true);
    const auto found = probeOf(partOf(mesh, deals()[0], rank(), ranks()), false);
    expectSame(found->GetOutput()->GetCellData()->GetArray("Fraction"),
      expected->GetOutput()->GetCellData()->GetArray("Fraction"));
  }
}

TEST(ReportOnRanks, CountsTheWholeOnEachRank)
{
  for (const auto& [name, mesh] : meshes())
  {
    SCOPED_TRACE(name);
    const auto expected = filterOf<vtkWindingNumberReport>(partOf(mesh, whole, 0, 1), true);
    expected->Update();
    const auto found =
      filterOf<vtkWindingNumberReport>(partOf(mesh, deals()[1], rank(), ranks()), false);
    updatePiece(found);
    EXPECT_EQ(found->GetNumberOfTriangles(), static_cast<vtkIdType>(mesh.triangles.size()));
    EXPECT_EQ(found->GetNumberOfBoundaryEdges(), expected->GetNumberOfBoundaryEdges());
    EXPECT_EQ(found->GetNumberOfComponents(), expected->GetNumberOfComponents());
    EXPECT_NEAR(found->GetArea(), expected->GetArea(), 1e-12 * expected->GetArea());
    EXPECT_EQ(found->GetFaults()->GetNumberOfBlocks() > 0,
      rank() == 0 && expected->GetFaults()->GetNumberOfBlocks() > 0);
  }
}

TEST(ReportOnRanks, WithOtherPropertiesIsRefusedOnAll)
{
  const auto report = filterOf<vtkWindingNumberReport>(
    partOf(shapes::icosphere(1), deals()[0], rank(), ranks()), false);
  report->SetFaultThickness(rank() == 0 ? 0.01 : 0.02);
  expectDifferentProperties(report);
}

TEST(ReportOnRanks, RefusesToTurnFacesThatOthersHave)
{
  const auto report = filterOf<vtkWindingNumberReport>(
    partOf(shapes::icosphere(1), deals()[0], rank(), ranks()), false);
  report->SetFixOrientation(true);
  const ErrorLog log(report);
  updatePiece(report);
  EXPECT_EQ(log.errors().empty(), ranks() == 1) << log.errors();
}

TEST(ProbeOnRanks, TurnsTheFacesOfAllTogether)
{
  const Mesh outward = shapes::icosphere(3);
  Mesh turned = outward;
  for (std::size_t i = 0; i < turned.triangles.size(); i += 3)
  {
    std::swap(turned.triangles[i][1], turned.triangles[i][2]);
  }
  vtkNew<vtkPoints> points;
  shapes::Random random(813 + static_cast<unsigned>(rank()));
  for (int i = 0; i < 200; ++i)
  {
    points->InsertNextPoint(random.point(-1.2, 1.2).data());
  }
  vtkNew<vtkPolyData> queries;
  queries->SetPoints(points);
  const auto probeOf = [&](vtkPolyData* source, bool isAlone)
  {
    auto probe = filterOf<vtkWindingNumberProbe>(queries, isAlone);
    probe->SetSourceData(source);
    probe->SetMethod(vtkWindingNumberProbe::DIRECT);
    probe->OrientFacesOn();
    updatePiece(probe);
    return probe;
  };
  const auto expected = probeOf(partOf(outward, whole, 0, 1), true);
  for (const Deal& deal : deals())
  {
    SCOPED_TRACE(deal.name);
    const auto found = probeOf(partOf(turned, deal, rank(), ranks()), false);
    expectSame(found->GetOutput()->GetPointData()->GetArray("WindingNumber"),
      expected->GetOutput()->GetPointData()->GetArray("WindingNumber"));
  }
}

TEST(AreasOnRanks, NormalsOfOwnPointsAreThoseOfOneRank)
{
  const Mesh mesh = shapes::icosphere(3);
  const auto areasOf = [&mesh](const Deal& deal, int of, int ranks, bool alone)
  {
    const vtkSmartPointer<vtkPolyData> points = pointsOf(mesh, deal, of, ranks);
    points->GetPointData()->Initialize();
    auto areas = filterOf<vtkWindingNumberNormals>(points, alone);
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
  const auto expected = filterOf<vtkWindingNumberNormals>(pointsOf(mesh, whole, 0, 1), true);
  expected->Update();
  const auto* all = vtkDoubleArray::SafeDownCast(
    vtkPolyData::SafeDownCast(expected->GetOutputDataObject(0))->GetPointData()->GetArray("Area"));
  for (const Deal& deal : deals())
  {
    SCOPED_TRACE(deal.name);
    const auto found =
      filterOf<vtkWindingNumberNormals>(pointsOf(mesh, deal, rank(), ranks()), false);
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
