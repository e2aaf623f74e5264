// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/Ranks.h"
#include "private/source/OuterSurface.h"
#include "private/source/RegionCells.h"
#include "voxels/LabelMerge.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWindingABINamespace.h"

#include <cstddef>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkFieldData;
class vtkPointSet;
VTK_ABI_NAMESPACE_END

namespace winding
{

class Executor;

/// The choices that decide what the solids of an input are.
struct SolidOptions
{
  std::string regionArray;       ///< of the cells of a single data set; empty for its connectivity
  int labelOffset = 0;           ///< added to a region to give its label
  bool ignoresOpenParts = false; ///< whether open parts inside of closed ones are no solids
  bool takesFaces = false;       ///< of a mesh that has cells with volume, too (OuterSurface.h)
  double weldTolerance = 0;      ///< up to which points are made one to find what is connected
  bool asPoints = false;         ///< whether meshes are taken as the clouds of their points
};

/**
 * The solids of an input, each a source of its own, with a label from 1 to 65535 and a name.
 *
 * - Of a vtkMultiBlockDataSet every leaf is a solid, also within blocks of blocks, and those that
 *   are not there count, so that labels stay the same over time; the pieces of a multi-piece are
 *   one solid. Of a vtkPartitionedDataSetCollection every partitioned data set is one; any other
 *   composite is one solid. Labels are their numbers, from 1 on.
 * - Of a single data set every region is a solid: the cells with one value of the array
 *   (CellRegions.h). The label of an integer is the value and the offset. Where these are not all
 *   labels and the offset is 0, and for texts, labels are 1, 2, … in the order of the values.
 *   Regions of polydata are of polygons and strips; regions of other data sets have their own outer
 *   surfaces.
 * - Without an array the solids of a single data set are its parts by connectivity
 *   (SolidParts.h), with the labels 1, 2, …. Parts that their file names alike are one
 *   (namesOfParts()), and then come in the order of the names.
 *
 * Names are the blocks' or the file's, "Block n" or "Part n" where there is none, the texts of
 * regions, or the array's and the region. A name that occurs again gets a number.
 *
 * The ranks of a parallel program have parts of all solids: as many blocks each, or any part of the
 * cells with their regions. Parts by connectivity belong to a surface that one rank has, or all
 * have as a whole. Throws Refusal.
 */
class Solids
{
public:
  /// Keeps a reference to the input. Collective. Throws Interrupted.
  Solids(vtkDataObject* input, const SolidOptions& options, Ranks& ranks, Executor& executor);

  std::size_t size() const { return labels_.size(); }
  unsigned short label(std::size_t solid) const { return labels_[solid]; }
  const std::string& name(std::size_t solid) const { return names_[solid]; }

  /// The number of names that had to be changed.
  std::size_t repeatedNames() const { return repeatedNames_; }

  /// Whether labels are 1, 2, … for regions that could be none.
  bool areNumbered() const { return areNumbered_; }

  /// Whether labels are the numbers of regions, to which the offset is added.
  bool areOffset() const { return areOffset_; }

  /// The array of a file's names that are not used, for they divide parts; empty for none.
  const std::string& dividingNames() const { return dividingNames_; }

  /// Counts of the cells of a single data set; blocks are looked at as sources.
  const CellCounts& cellCounts() const { return counts_; }

  /// Whether a solid by connectivity is an open part inside of closed ones (OpenParts.h).
  bool isOpenPart(std::size_t solid) const
  {
    return solid < parts_.isOpenPart.size() && parts_.isOpenPart[solid];
  }

  /// The solid as a source. A region's is made for each call.
  vtkSmartPointer<vtkDataObject> source(std::size_t solid) const;

private:
  void addBlocks(vtkDataObject* composite, Ranks& ranks);
  void addRegions(
    vtkPointSet* data, vtkFieldData* fields, const SolidOptions& options, Ranks& ranks);
  void addParts(vtkPointSet* data, vtkFieldData* fields, const SolidOptions& options, Ranks& ranks,
    Executor& executor);
  std::vector<std::string> nameParts(vtkFieldData* fields);
  void findParts(vtkPointSet* data, const SolidOptions& options, Executor& executor);
  void makeNamesUnique();

  std::vector<unsigned short> labels_;
  std::vector<std::string> names_;
  std::size_t repeatedNames_ = 0;
  bool areNumbered_ = false, areOffset_ = false;
  std::string dividingNames_;
  CellCounts counts_;
  bool asPoints_ = false;

  std::vector<vtkSmartPointer<vtkDataObject>> blocks_; ///< none for regions
  vtkSmartPointer<vtkPointSet> data_;                  ///< cells that regions are of
  SolidCells parts_;                                   ///< of data_, by solid
  mutable std::vector<vtkIdType> newIds_;              ///< −1 for each point of data_
};

} // namespace winding
