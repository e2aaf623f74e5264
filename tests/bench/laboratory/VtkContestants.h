// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "source/Grid.h"

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

#include <functional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/**
 * @file
 * Questions about samples around a surface that both a filter of this project and one of VTK
 * answer.
 */

/// A filter, set up as its users would.
struct Contestant
{
  std::string name;
  /// Makes the filter and runs it on a surface that it has not seen before. This is timed.
  std::function<vtkSmartPointer<vtkDataObject>(vtkPolyData* surface)> run;
  /// The answer at each sample, from the output of run().
  std::function<std::vector<double>(vtkDataObject* output)> answers;
};

/// A question, and the filters that answer it. The first of them is of this project.
struct Contest
{
  std::string question;
  std::string samples; ///< describes the samples in the table
  std::size_t count;
  std::function<Eigen::Vector3d(std::size_t number)> sample;
  /// Whether an answer is wrong where the winding number is w.
  std::function<bool(double answer, double w)> isWrong;
  std::vector<Contestant> contestants;
};

/// So many random points in the bounds and a margin of a twentieth, the same in every run.
vtkSmartPointer<vtkPolyData> randomPoints(const winding::Bounds& bounds, std::size_t count);

/// Asks which points are inside, at random points in the bounds and a margin of a twentieth.
Contest insideContest(const winding::Bounds& bounds, std::size_t points);

/// Asks the question of insideContest(); an answer holds the points that are inside alone.
Contest extractionContest(const winding::Bounds& bounds, std::size_t points);

/// Asks how far from the surface points are, and on which side. Wrong is an answer of the wrong
/// sign.
Contest distanceContest(const winding::Bounds& bounds, std::size_t points);

/// Asks which voxels of a grid are inside.
Contest voxelContest(const winding::Bounds& bounds, int resolution);
