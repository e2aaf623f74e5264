// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxels/CellShape.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWindingABINamespace.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace winding
{

class ProbeQueries;
struct ImageFrame;

/// The cells of all data sets of some queries, one list after the other, in the coordinates that
/// the queries have. Linear cells and polyhedra are what they are, convex sets of points the
/// tetrahedra that VTK makes of them, and cells with curved faces straight between their corners.
class ProbeCells final : public CellShapes
{
public:
  /// Keeps references, which must outlive this.
  explicit ProbeCells(const ProbeQueries& queries);

  std::size_t size() const override { return starts_.back(); }
  void get(std::size_t cell, CellShape& shape) const override;

private:
  const ImageFrame& frame_;
  std::vector<vtkSmartPointer<vtkDataSet>> data_; ///< of the leaves
  std::vector<std::size_t> starts_ = {0};         ///< by leaf, its first cell; and the end
};

} // namespace winding
