// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/output/TreeGrid.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkHyperTree.h"
#include "vtkHyperTreeGrid.h"
#include "vtkNew.h"

#include <algorithm>

namespace winding
{

namespace
{

/// The planes between the bricks along an axis.
vtkSmartPointer<vtkDoubleArray> planes(const Grid& grid, const Bricks& bricks, int axis)
{
  auto coordinates = vtkSmartPointer<vtkDoubleArray>::New();
  for (int i = 0; i <= bricks.counts[axis]; ++i)
  {
    coordinates->InsertNextValue(
      grid.corner()[axis] + static_cast<double>(i) * bricks.side() * grid.spacing[axis]);
  }
  return coordinates;
}

/// Appends numbers to an array, whose memory grows in place where the system can do that.
template <class Array, class Numbers>
void append(Array* array, vtkIdType at, const Numbers& numbers)
{
  using Number = typename Array::ValueType;
  Number* const to = array->WritePointer(at, static_cast<vtkIdType>(numbers.size()));
  std::transform(
    numbers.begin(), numbers.end(), to, [](auto number) { return static_cast<Number>(number); });
}

} // namespace

TreeGrid::TreeGrid(const Grid& grid, const Bricks& bricks, const ResultOptions& options,
  bool masksOutside, vtkHyperTreeGrid* output)
  : bricks_(bricks)
  , masksOutside_(masksOutside)
  , output_(output)
  , results_(0, options)
  , mask_(vtkSmartPointer<vtkBitArray>::New())
{
  output->Initialize();
  output->SetBranchFactor(2);
  const Eigen::Vector3i points = bricks.counts + Eigen::Vector3i::Ones();
  output->SetDimensions(points.data());
  output->SetXCoordinates(planes(grid, bricks, 0));
  output->SetYCoordinates(planes(grid, bricks, 1));
  output->SetZCoordinates(planes(grid, bricks, 2));
}

void TreeGrid::add(const VoxelTree& tree)
{
  vtkNew<vtkBitArray> parents;
  parents->SetNumberOfValues(static_cast<vtkIdType>(tree.isParent.size()));
  for (std::size_t i = 0; i < tree.isParent.size(); ++i)
  {
    parents->SetValue(static_cast<vtkIdType>(i), tree.isParent[i]);
  }
  // Bricks are numbered as the roots of VTK are.
  vtkHyperTree* const made = output_->GetTree(trees_, true);
  made->SetGlobalIndexStart(size_);
  made->BuildFromBreadthFirstOrderDescriptor(parents, parents->GetNumberOfValues());
  this->addMask(tree);
  if (auto* floats = vtkFloatArray::SafeDownCast(results_.values()))
  {
    append(floats, size_, tree.values);
  }
  else if (auto* doubles = vtkDoubleArray::SafeDownCast(results_.values()))
  {
    append(doubles, size_, tree.values);
  }
  if (results_.inside())
  {
    append(results_.inside(), size_, tree.inside);
  }
  if (results_.coverage())
  {
    append(results_.coverage(), size_, tree.coverage);
  }
  ++trees_;
  size_ += static_cast<vtkIdType>(tree.size());
}

/// A parent is masked where all of its children are.
void TreeGrid::addMask(const VoxelTree& tree)
{
  const auto size = static_cast<vtkIdType>(tree.size());
  mask_->InsertValue(size_ + size - 1, 0);
  std::size_t end = tree.size(); // the children that no parent has taken yet end here
  for (std::size_t vertex = tree.size(); vertex-- > 0;)
  {
    bool isMasked = false;
    if (vertex < tree.isParent.size() && tree.isParent[vertex])
    {
      isMasked = true;
      for (std::size_t child = end - 8; child < end; ++child)
      {
        isMasked = isMasked && mask_->GetValue(size_ + static_cast<vtkIdType>(child)) != 0;
      }
      end -= 8;
    }
    else
    {
      isMasked = tree.isBeyond[vertex] || (masksOutside_ && !tree.inside[vertex]);
      leaves_ += !isMasked;
    }
    mask_->SetValue(size_ + static_cast<vtkIdType>(vertex), isMasked);
    hasMask_ = hasMask_ || isMasked;
  }
}

void TreeGrid::finish()
{
  for (vtkDataArray* array : {results_.values(), static_cast<vtkDataArray*>(results_.inside()),
         static_cast<vtkDataArray*>(results_.coverage())})
  {
    if (array)
    {
      array->Squeeze();
    }
  }
  results_.addTo(output_->GetCellData());
  output_->SetMask(hasMask_ ? mask_.Get() : nullptr);
}

double TreeGrid::valueAt(const Eigen::Vector3i& voxel) const
{
  return results_.values()->GetComponent(this->leafOf(voxel), 0);
}

bool TreeGrid::isInside(const Eigen::Vector3i& voxel, InsideRule rule, double threshold) const
{
  return results_.isInside(static_cast<std::size_t>(this->leafOf(voxel)), rule, threshold);
}

/// Returns the global index of the leaf that holds a voxel.
vtkIdType TreeGrid::leafOf(const Eigen::Vector3i& voxel) const
{
  const Eigen::Vector3i brick = voxel / bricks_.side();
  vtkHyperTree* const tree =
    output_->GetTree(static_cast<vtkIdType>(sampleNumber(bricks_.whole(), brick)));
  const Eigen::Vector3i inBrick = voxel - brick * bricks_.side();
  vtkIdType vertex = 0;
  for (int level = bricks_.depth; !tree->IsLeaf(vertex);)
  {
    --level;
    const Eigen::Vector3i half = (inBrick / (1 << level)).unaryExpr([](int i) { return i & 1; });
    vertex = tree->GetElderChildIndex(static_cast<unsigned int>(vertex)) + half[0] +
             2 * (half[1] + 2 * half[2]);
  }
  return tree->GetGlobalIndexFromLocal(vertex);
}

} // namespace winding
