// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/HyperTreeWriter.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkHyperTree.h"
#include "vtkHyperTreeGrid.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkTypeInt64Array.h"
#include "vtkTypeUInt32Array.h"

namespace
{

/// The trees as a file of version 2 describes them: which vertices have children, the vertices of
/// each tree's last level left out, and how many vertices there are in each level of each tree.
struct Topology
{
  vtkNew<vtkBitArray> parents;
  vtkNew<vtkTypeInt64Array> verticesOfLevels;
  vtkNew<vtkTypeInt64Array> trees;
  vtkNew<vtkTypeUInt32Array> levels; ///< of each tree

  explicit Topology(vtkHyperTreeGrid* grid)
  {
    vtkHyperTreeGrid::vtkHyperTreeGridIterator iterator;
    grid->InitializeTreeIterator(iterator);
    vtkIdType index;
    while (vtkHyperTree* tree = iterator.GetNextTree(index))
    {
      trees->InsertNextValue(index);
      levels->InsertNextValue(tree->GetNumberOfLevels());
      this->add(tree, grid->GetNumberOfChildren());
    }
  }

  void add(vtkHyperTree* tree, vtkIdType childrenOfParent)
  {
    vtkIdType vertex = 0, count = 1;
    for (unsigned int level = 0; level < tree->GetNumberOfLevels(); ++level)
    {
      verticesOfLevels->InsertNextValue(count);
      const bool isLast = level + 1 == tree->GetNumberOfLevels();
      vtkIdType children = 0;
      for (vtkIdType end = vertex + count; !isLast && vertex < end; ++vertex)
      {
        const bool isParent = !tree->IsLeaf(vertex);
        parents->InsertNextValue(isParent);
        children += isParent ? childrenOfParent : 0;
      }
      count = children;
    }
  }
};

} // namespace

vtkStandardNewMacro(HyperTreeWriter);

HyperTreeWriter::HyperTreeWriter()
{
  this->SetDataModeToBinary();
}

int HyperTreeWriter::WriteData()
{
  vtkIndent indent = vtkIndent().GetNextIndent();
  if (!this->StartFile() || !this->StartPrimaryElement(indent) ||
      !this->WriteGrid(indent.GetNextIndent()))
  {
    return 0;
  }
  this->writeTrees(indent.GetNextIndent());
  this->WriteFieldData(indent.GetNextIndent());
  return this->FinishPrimaryElement(indent) && this->EndFile();
}

void HyperTreeWriter::writeTrees(vtkIndent indent)
{
  vtkHyperTreeGrid* const grid = this->GetInput();
  std::ostream& os = *this->Stream;
  vtkIndent within = indent.GetNextIndent();
  const auto write = [&](vtkAbstractArray* array, const char* name)
  {
    if (this->ErrorCode == vtkErrorCode::NoError)
    {
      this->WriteArrayInline(array, within, name, 1); // together with its number of tuples
    }
  };
  os << indent << "<Trees>\n";
  {
    const Topology topology(grid);
    write(topology.parents, "Descriptors");
    write(topology.verticesOfLevels, "NumberOfVerticesPerDepth");
    write(topology.trees, "TreeIds");
    write(topology.levels, "DepthPerTree");
  }
  if (grid->GetMask())
  {
    write(grid->GetMask(), "Mask");
  }
  os << indent << "</Trees>\n" << indent << "<CellData>\n";
  vtkCellData* const data = grid->GetCellData();
  float range[2];
  this->GetProgressRange(range);
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    this->SetProgressRange(range, i, data->GetNumberOfArrays());
    write(data->GetAbstractArray(i), data->GetAbstractArray(i)->GetName());
  }
  os << indent << "</CellData>\n";
}
