// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/NamedBlocks.h"

#include "base/Refusal.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiPieceDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

namespace winding
{

vtkSmartPointer<vtkDataObject> asBlock(vtkDataObject* data)
{
  if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
    {
      blocks->SetBlock(i, asBlock(collection->GetPartitionedDataSet(i)));
      if (collection->HasMetaData(i))
      {
        blocks->GetMetaData(i)->Copy(collection->GetMetaData(i));
      }
    }
    return blocks;
  }
  auto* partitioned = vtkPartitionedDataSet::SafeDownCast(data);
  if (partitioned && !vtkMultiPieceDataSet::SafeDownCast(data))
  {
    auto pieces = vtkSmartPointer<vtkMultiPieceDataSet>::New();
    pieces->SetNumberOfPieces(partitioned->GetNumberOfPartitions());
    for (unsigned int i = 0; i < partitioned->GetNumberOfPartitions(); ++i)
    {
      pieces->SetPiece(i, partitioned->GetPartition(i));
    }
    return pieces;
  }
  return data;
}

vtkSmartPointer<vtkMultiBlockDataSet> namedBlocksOf(
  const std::vector<std::pair<vtkSmartPointer<vtkDataObject>, std::string>>& sources)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    const auto block = static_cast<unsigned int>(i);
    const vtkSmartPointer<vtkDataObject> data = asBlock(sources[i].first);
    const std::string name =
      sources[i].second.empty() ? "Input " + std::to_string(i + 1) : sources[i].second;
    if (data && !vtkDataSet::SafeDownCast(data) && !vtkCompositeDataSet::SafeDownCast(data))
    {
      throw Refusal(
        "give surfaces, points or blocks of them: '" + name + "' is a " + data->GetClassName());
    }
    blocks->SetBlock(block, data);
    blocks->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), name.c_str());
  }
  return blocks;
}

} // namespace winding
