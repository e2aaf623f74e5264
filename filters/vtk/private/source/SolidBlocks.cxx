// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/SolidBlocks.h"

#include "base/Refusal.h"
#include "private/source/SourceParts.h"
#include "tasks/Sentences.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <utility>

namespace winding
{

namespace
{

std::string nameOf(vtkInformation* about, std::size_t number)
{
  const char* name =
    about && about->Has(vtkCompositeDataSet::NAME()) ? about->Get(vtkCompositeDataSet::NAME()) : "";
  return name && *name ? name : "Block " + std::to_string(number);
}

class Collector
{
public:
  void add(vtkDataObject* block, vtkInformation* about)
  {
    if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(block))
    {
      this->addBlocks(blocks);
      return;
    }
    blocks_.push_back({nameOf(about, blocks_.size() + 1), block ? block : nothing_.Get()});
  }

  void addBlocks(vtkMultiBlockDataSet* blocks)
  {
    for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
    {
      this->add(blocks->GetBlock(i), blocks->HasMetaData(i) ? blocks->GetMetaData(i) : nullptr);
    }
  }

  void addCollection(vtkPartitionedDataSetCollection* parts)
  {
    for (unsigned int i = 0; i < parts->GetNumberOfPartitionedDataSets(); ++i)
    {
      this->add(
        parts->GetPartitionedDataSet(i), parts->HasMetaData(i) ? parts->GetMetaData(i) : nullptr);
    }
  }

  std::vector<SolidBlock> take() { return std::move(blocks_); }

private:
  std::vector<SolidBlock> blocks_;
  vtkNew<vtkPolyData> nothing_;
};

/// Finds what there is to a block, in all of its pieces.
class BlockKind
{
public:
  void add(vtkDataObject* block, const std::string& name)
  {
    if (auto* composite = vtkCompositeDataSet::SafeDownCast(block))
    {
      const auto pieces = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
      for (pieces->InitTraversal(); !pieces->IsDoneWithTraversal(); pieces->GoToNextItem())
      {
        this->add(pieces->GetCurrentDataObject(), name);
      }
      return;
    }
    auto* points = vtkPointSet::SafeDownCast(block);
    if (!points)
    {
      throw Refusal(messageOf(
        Sentence::noSurfaceOrPoints, {name, block ? block->GetClassName() : "block of no data"}));
    }
    hasPoints_ |= points->GetNumberOfPoints() > 0;
    hasFaces_ |= hasFaces(points);
  }

  bool hasSurface() const { return hasFaces_; }
  bool isBare() const { return hasPoints_ && !hasFaces_; }

private:
  bool hasPoints_ = false;
  bool hasFaces_ = false;
};

} // namespace

void checkSolids(vtkDataObject* input, bool asPoints)
{
  if (!vtkCompositeDataSet::SafeDownCast(input))
  {
    BlockKind().add(input, "the input");
    return;
  }
  std::string bare;
  bool isAnySurface = false;
  for (const SolidBlock& block : solidBlocksOf(input))
  {
    const std::string name = "block '" + block.name + "'";
    BlockKind kind;
    kind.add(block.source, name);
    isAnySurface |= kind.hasSurface();
    bare = bare.empty() && kind.isBare() ? name : bare;
  }
  if (isAnySurface && !bare.empty() && !asPoints)
  {
    throw Refusal(messageOf(Sentence::bareBlock, {bare}));
  }
}

std::vector<SolidBlock> solidBlocksOf(vtkDataObject* composite)
{
  Collector collector;
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(composite))
  {
    collector.addBlocks(blocks);
  }
  else if (auto* parts = vtkPartitionedDataSetCollection::SafeDownCast(composite))
  {
    collector.addCollection(parts);
  }
  else
  {
    collector.add(composite, nullptr);
  }
  return collector.take();
}

} // namespace winding
