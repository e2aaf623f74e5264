// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

/// Makes an image around the unit sphere's half, whose samples do not begin at 0 and are as far
/// apart as the axes say.
inline vtkSmartPointer<vtkImageData> imageAround()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(3, 30, 0, 24, 5, 25);
  image->SetSpacing(0.04, 0.05, 0.06);
  image->SetOrigin(-0.66, -0.6, -0.9);
  return image;
}

/// Makes an image whose axes are the columns of a matrix, with its middle at the origin.
inline vtkSmartPointer<vtkImageData> imageAlong(
  const double (&directions)[9], const double (&spacing)[3] = {0.04, 0.05, 0.06})
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(3, 30, -2, 22, 5, 25);
  image->SetSpacing(spacing);
  image->SetDirectionMatrix(const_cast<double*>(directions));
  double middle[3];
  image->TransformContinuousIndexToPhysicalPoint(16.3, 10.2, 14.9, middle);
  image->SetOrigin(-middle[0], -middle[1], -middle[2]);
  return image;
}

/// Makes the points of an image, or the centres of its cells, without the image.
inline vtkSmartPointer<vtkPolyData> pointsOf(vtkImageData* image, bool atCells = false)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const vtkIdType count = atCells ? image->GetNumberOfCells() : image->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    double bounds[6];
    if (atCells)
    {
      image->GetCellBounds(i, bounds); // of a box along other axes, its middle is the cell's
      points->InsertNextPoint(
        (bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2, (bounds[4] + bounds[5]) / 2);
      continue;
    }
    points->InsertNextPoint(image->GetPoint(i));
  }
  auto scattered = vtkSmartPointer<vtkPolyData>::New();
  scattered->SetPoints(points);
  return scattered;
}

inline double largestDifference(vtkDataArray* a, vtkDataArray* b)
{
  EXPECT_EQ(a->GetNumberOfTuples(), b->GetNumberOfTuples());
  double largest = 0;
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    largest = std::max(largest, std::abs(a->GetTuple1(i) - b->GetTuple1(i)));
  }
  return largest;
}

/// A direction that no axis of space has, as the oblique scans of a head have it.
constexpr double oblique[9] = {0.8, -0.6, 0, 0.36, 0.48, -0.8, 0.48, 0.64, 0.6};
constexpr double mirrored[9] = {0.8, 0.6, 0, 0.36, -0.48, -0.8, 0.48, -0.64, 0.6};
