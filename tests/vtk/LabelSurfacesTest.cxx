// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"
#include "vtk/LabelScenes.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkWindingNumberVoxels.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <utility>

namespace
{

/// An image of random labels up to a number.
vtkSmartPointer<vtkImageData> randomLabels(unsigned seed, int largest)
{
  std::mt19937 random(seed);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(5, 4, 6);
  image->SetSpacing(1, 2, 0.5);
  image->AllocateScalars(VTK_UNSIGNED_SHORT, 1);
  auto* values = static_cast<unsigned short*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    values[i] = static_cast<unsigned short>(random() % static_cast<unsigned>(largest + 1));
  }
  image->GetPointData()->GetScalars()->SetName("Label");
  return image;
}

/// The volume around which the quads of a label wind, each seen from that label; and whether every
/// edge of them is used as often in one direction as in the other.
std::pair<double, bool> solidOf(vtkPolyData* surface, unsigned short label)
{
  const auto both = shortsOf(surface->GetCellData(), "BoundaryLabels");
  const auto* first =
    vtkUnsignedShortArray::SafeDownCast(surface->GetCellData()->GetArray("BoundaryLabels"));
  double volume = 0;
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    const int sense = first->GetTypedComponent(cell, 0) == label   ? 1
                      : first->GetTypedComponent(cell, 1) == label ? -1
                                                                   : 0;
    surface->GetPolys()->GetCellAtId(cell, size, ids);
    double p[4][3];
    for (vtkIdType i = 0; sense != 0 && i < size; ++i)
    {
      const vtkIdType next = ids[(i + 1) % size];
      edges[{std::min(ids[i], next), std::max(ids[i], next)}] += ids[i] < next ? sense : -sense;
      surface->GetPoint(ids[i], p[i]);
    }
    for (int i = 2; sense != 0 && i < 4; ++i)
    {
      volume += sense *
                (p[0][0] * (p[i - 1][1] * p[i][2] - p[i - 1][2] * p[i][1]) +
                  p[0][1] * (p[i - 1][2] * p[i][0] - p[i - 1][0] * p[i][2]) +
                  p[0][2] * (p[i - 1][0] * p[i][1] - p[i - 1][1] * p[i][0])) /
                6;
    }
  }
  bool isClosed = true;
  for (const auto& [edge, uses] : edges)
  {
    isClosed = isClosed && uses == 0;
  }
  return {volume, isClosed};
}

/// The quads of each label enclose its voxels, without gaps; there is one quad, not two, between
/// labels.
TEST(LabelSurfaces, EncloseTheVoxelsOfEachLabel)
{
  for (unsigned seed = 1; seed <= 40; ++seed)
  {
    const int largest = 1 + static_cast<int>(seed % 5);
    const auto image = randomLabels(seed, largest);
    vtkNew<vtkWindingNumberVoxels> voxels;
    voxels->SetInputData(image);
    voxels->ByLabelOn();
    voxels->Update();
    vtkPolyData* surface = voxels->GetOutput();
    const auto labels = shortsOf(image->GetPointData());
    for (unsigned short label = 1; label <= largest; ++label)
    {
      const auto [volume, isClosed] = solidOf(surface, label);
      EXPECT_TRUE(isClosed) << seed;
      EXPECT_NEAR(volume, std::count(labels.begin(), labels.end(), label), 1e-9) << seed;
    }
    std::set<std::set<vtkIdType>> places;
    vtkIdType size;
    const vtkIdType* ids;
    const auto own = shortsOf(surface->GetCellData());
    auto* both =
      vtkUnsignedShortArray::SafeDownCast(surface->GetCellData()->GetArray("BoundaryLabels"));
    for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
    {
      surface->GetPolys()->GetCellAtId(cell, size, ids);
      EXPECT_TRUE(places.insert(std::set<vtkIdType>(ids, ids + size)).second);
      const int from = both->GetTypedComponent(cell, 0), to = both->GetTypedComponent(cell, 1);
      EXPECT_TRUE(from != 0 && (to == 0 || from < to));
      EXPECT_EQ(own[static_cast<std::size_t>(cell)], from);
    }
    EXPECT_STREQ(surface->GetCellData()->GetScalars()->GetName(), "Label");
    EXPECT_STREQ(both->GetComponentName(0), "From");
    EXPECT_STREQ(both->GetComponentName(1), "To");
  }
}

/// The quads of a single label are the quads of the voxels inside.
TEST(LabelSurfaces, OfOneLabelAreThoseOfTheInside)
{
  const auto image = randomLabels(7, 1);
  vtkNew<vtkWindingNumberVoxels> inside, labels;
  for (vtkWindingNumberVoxels* filter : {inside.Get(), labels.Get()})
  {
    filter->SetInputData(image);
    filter->SetByLabel(filter == labels);
    filter->Update();
  }
  vtkPolyData *a = inside->GetOutput(), *b = labels->GetOutput();
  ASSERT_EQ(a->GetNumberOfPolys(), b->GetNumberOfPolys());
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  for (vtkIdType i = 0; i < a->GetNumberOfPolys(); ++i)
  {
    vtkIdType sizes[2];
    const vtkIdType* ids[2];
    a->GetPolys()->GetCellAtId(i, sizes[0], ids[0]);
    b->GetPolys()->GetCellAtId(i, sizes[1], ids[1]);
    ASSERT_TRUE(std::equal(ids[0], ids[0] + 4, ids[1]));
  }
}

/// An array is taken for labels by its name, if it has integers; else if one says so.
TEST(LabelSurfaces, AreThoseOfIntegersCalledLabel)
{
  const auto image = randomLabels(7, 3);
  const auto hasLabels = [&](int byLabel)
  {
    vtkNew<vtkWindingNumberVoxels> voxels;
    voxels->SetInputData(image);
    voxels->SetByLabel(byLabel);
    voxels->Update();
    EXPECT_GT(voxels->GetOutput()->GetNumberOfCells(), 0);
    return voxels->GetOutput()->GetCellData()->GetArray("BoundaryLabels") != nullptr;
  };
  constexpr int automatic = vtkWindingNumberVoxels::LABELS_AUTOMATIC;
  EXPECT_EQ(vtkNew<vtkWindingNumberVoxels>()->GetByLabel(), automatic);
  EXPECT_TRUE(hasLabels(automatic));
  EXPECT_FALSE(hasLabels(vtkWindingNumberVoxels::LABELS_OFF));
  image->GetPointData()->GetScalars()->SetName("Material");
  EXPECT_FALSE(hasLabels(automatic));
  EXPECT_TRUE(hasLabels(vtkWindingNumberVoxels::LABELS_ON));
  vtkNew<vtkFloatArray> values;
  vtkNew<vtkIntArray> withGaps;
  withGaps->DeepCopy(image->GetPointData()->GetScalars());
  withGaps->SetName("Label");
  image->GetPointData()->SetScalars(withGaps);
  for (const auto& [value, areLabels] :
    {std::pair(65535, true), std::pair(65536, false), std::pair(-1, false)})
  {
    withGaps->SetValue(0, value);
    withGaps->Modified();
    EXPECT_EQ(hasLabels(automatic), areLabels) << value;
  }
  vtkNew<vtkDoubleArray> doubles;
  withGaps->SetValue(0, 1);
  for (vtkDataArray* reals :
    {static_cast<vtkDataArray*>(values), static_cast<vtkDataArray*>(doubles)})
  {
    reals->DeepCopy(withGaps);
    reals->SetName("Label");
    image->GetPointData()->SetScalars(reals);
    EXPECT_FALSE(hasLabels(automatic)) << reals->GetClassName();
  }
}

TEST(LabelSurfaces, FollowTheFilterOfLabels)
{
  vtkNew<vtkWindingNumberLabels> labels;
  labels->SetInputData(asAssembly(fiveBalls()));
  labels->SetResolution(24);
  labels->SetOverlapRule(vtkWindingNumberLabels::SMALLEST_VOLUME);
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputConnection(labels->GetOutputPort());
  voxels->Update();
  const double* h = labels->GetOutput()->GetSpacing();
  const auto values = shortsOf(labels->GetOutput()->GetPointData());
  for (unsigned short label = 1; label <= 5; ++label)
  {
    const auto [volume, isClosed] = solidOf(voxels->GetOutput(), label);
    const double count = static_cast<double>(std::count(values.begin(), values.end(), label));
    EXPECT_TRUE(isClosed);
    EXPECT_NEAR(volume, count * h[0] * h[1] * h[2], 1e-9);
    EXPECT_GT(count, 0);
  }
  EXPECT_TRUE(voxels->GetOutput()->GetFieldData()->GetAbstractArray("LabelNames"));
  EXPECT_STREQ(voxels->GetLabelLegend(), labels->GetLabelLegend());
  voxels->ByLabelOff();
  voxels->Update();
  EXPECT_STREQ(voxels->GetLabelLegend(), "");
}

TEST(LabelSurfaces, ValuesThatAreNoLabelsAreRefusedInOneLine)
{
  for (const double value : {-1.0, 65536.0, 0.5, std::numeric_limits<double>::quiet_NaN()})
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(2, 2, 2);
    image->AllocateScalars(VTK_DOUBLE, 1);
    image->GetPointData()->GetScalars()->Fill(value);
    vtkNew<vtkWindingNumberVoxels> voxels;
    voxels->SetInputData(image);
    voxels->ByLabelOn();
    const ErrorLog log(voxels);
    voxels->Update();
    EXPECT_NE(log.errors().find("labels are integers from 0 to 65535"), std::string::npos)
      << log.errors();
    EXPECT_EQ(voxels->GetOutput()->GetNumberOfCells(), 0);
  }
}

} // namespace
