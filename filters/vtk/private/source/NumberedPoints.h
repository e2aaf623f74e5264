// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Concatenation.h"
#include "base/Views.h"
#include "private/source/InputViews.h"
#include "source/PointCloud.h"

#include "vtkType.h"
#include "vtkWindingABINamespace.h"

#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPointSet;
VTK_ABI_NAMESPACE_END

namespace winding
{

/**
 * The points of some data sets under one range of numbers. While it lives, the data sets have these
 * numbers as point data. Point data comes along when VTK makes outer surfaces or leaves out ghosts,
 * and so says where a point comes from.
 */
class NumberedPoints
{
public:
  explicit NumberedPoints(const std::vector<vtkPointSet*>& pointSets);
  ~NumberedPoints();
  NumberedPoints(const NumberedPoints&) = delete;
  void operator=(const NumberedPoints&) = delete;

  std::size_t size() const { return points_.size(); }
  std::size_t start(std::size_t pointSet) const { return points_.start(pointSet); }

  /// The numbers of the points of a data set that was made from these.
  static const vtkIdType* numbersOf(vtkPointSet* made);

  /// Whether a point is the one with a number: surfaces of curved cells have points of their own,
  /// with point data that is interpolated.
  bool isPoint(vtkIdType number, const Eigen::Vector3d& position) const;

private:
  std::vector<vtkPointSet*> pointSets_;
  Concatenation points_;
};

/// Findings about the points of a cloud, by the numbers of the points that these come from.
struct NumberedFindings
{
  std::vector<double> areas;            ///< 0 for points that none was found for
  std::vector<Eigen::Vector3d> normals; ///< 0 for these; empty where none were estimated
  std::size_t lost = 0;                 ///< points of the cloud that are none of these
};

/// Brings the areas of a cloud, and its normals if they were estimated, to the points that they
/// come from. `views` are the input's on this rank, whose points begin in the cloud with `first`.
NumberedFindings findingsByNumber(const NumberedPoints& points, const InputViews& input,
  const std::vector<OrientedPointsView>& views, const PointCloud& cloud, std::size_t first,
  bool withNormals);

} // namespace winding
