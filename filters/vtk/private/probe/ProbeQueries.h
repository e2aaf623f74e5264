// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Views.h"
#include "private/source/ImageGrid.h"

#include "vtkType.h"
#include "vtkWindingABINamespace.h"

#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkDataSet;
class vtkDataSetAttributes;
VTK_ABI_NAMESPACE_END

namespace winding
{

struct ProbeWords;

/// A data set, and its part of all samples.
struct ProbeLeaf
{
  vtkDataSet* data;
  vtkIdType first, count;
  vtkIdType firstCell; ///< among the cells of all data sets
};

/**
 * The points or the cells of a data set, or of all data sets in a composite one, as one list of
 * samples, so that many small data sets cost no more than one large one. The samples of an image
 * are the samples of a grid, in the coordinates of the image, which take a tenth of the time, and
 * need no list.
 */
class ProbeQueries
{
public:
  /// Cells have their samples at their parametric centres; the sample of an empty cell is NaN. The
  /// object keeps the data. Throws Refusal for data sets that contradict themselves (CellChecks.h).
  /// areCellsUsed: whether anything is done with cells, as there is for a part that is extracted.
  ProbeQueries(vtkDataObject* queries, bool atCells, bool areCellsUsed, const ProbeWords& words);

  vtkIdType size() const { return size_; }
  const std::vector<ProbeLeaf>& leaves() const { return leaves_; }

  /// The grid that the samples are of; nothing where they are scattered.
  const std::optional<Grid>& grid() const { return grid_; }

  /// The coordinates that the grid and all positions have.
  const ImageFrame& frame() const { return frame_; }

  /// Scattered samples; empty where they form a grid. They are valid as long as this object
  /// lives and the data stays as it is.
  VectorsView samples() const { return samples_; }

  Eigen::Vector3d position(std::size_t sample) const
  {
    return grid_ ? grid_->sample(sample) : samples_[sample];
  }

  /// Gives a leaf's part of arrays that have an entry for every sample, and their active scalars,
  /// to attributes.
  void addPart(
    const ProbeLeaf& leaf, vtkDataSetAttributes* ofAll, vtkDataSetAttributes* attributes) const;

private:
  ProbeQueries(const ProbeQueries&) = delete;
  void operator=(const ProbeQueries&) = delete;

  vtkIdType size_ = 0;
  std::vector<ProbeLeaf> leaves_;
  std::optional<Grid> grid_;
  ImageFrame frame_;              ///< the space's, if samples are scattered
  std::vector<double> positions_; ///< empty if samples_ are the data's own
  VectorsView samples_;
};

} // namespace winding
