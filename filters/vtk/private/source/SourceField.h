// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/Executor.h"
#include "field/Field.h"
#include "private/source/ImageFrame.h"
#include "private/source/InputViews.h"

#include "vtkWindingABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// Everything that a field depends on apart from the source itself.
struct SourceOptions
{
  InputOptions input;
  FieldOptions field;
  ImageFrame frame; ///< the coordinates of the field; each rank may have its own
  SourceDistribution distribution = SourceDistribution::automatic;
};

/// Whether normals may be estimated by more than a spanning tree, which takes more memory.
inline bool mayFindConsistentNormals(const FieldOptions& options)
{
  return (options.estimateNormals || options.mendsSource) && options.toward.empty() &&
         options.normalEstimation != NormalEstimation::spanningTree;
}

/// A hash of options, by which ranks find out whether theirs are the same. The frame is left out.
Ranks::Number hashOf(const SourceOptions& options);

/**
 * The field of a filter's source, kept for as long as the source and the options that it depends on
 * stay the same.
 */
class SourceField
{
public:
  /// Builds the field, or keeps the last one. Where the first rank alone needs the field, the
  /// others get an empty one. Collective. Throws Refusal and Interrupted, after which the next call
  /// builds.
  const Field& prepare(vtkDataObject* source, const SourceOptions& options, Executor& executor,
    Ranks& ranks, bool onlyOnFirst);

  /// The bounds of the usable primitives of the source, on all ranks, found without building
  /// a field, and kept for as long as the source stays the same. The executor must not interrupt.
  /// Collective. Throws Refusal.
  Bounds bounds(
    vtkDataObject* source, const SourceOptions& options, Executor& executor, Ranks& ranks);

  /// Information on the last field; before the first, on an empty one.
  const FieldInfo& info() const { return info_; }

  /// Whether the last prepare() had to build.
  bool wasBuilt() const { return wasBuilt_; }

private:
  /// Remembers a source, and finds out whether the next one is the same.
  class Memory
  {
  public:
    bool isSame(const InputViews& views, const InputOptions& options);

  private:
    InputViews::Identity identity_;
    InputOptions options_; ///< choices that the fingerprint depends on
    std::uint64_t fingerprint_ = 0;
  };

  Memory source_;
  FieldOptions options_;
  ImageFrame frame_;
  SourceDistribution distribution_ = SourceDistribution::automatic;
  int ranks_ = 0;
  std::shared_ptr<const Field> field_;
  FieldInfo info_; ///< the field's, with notes on the cells of the source
  bool wasBuilt_ = false;

  Memory boundedSource_;
  int boundedRanks_ = 0;
  Bounds bounds_;
};

} // namespace winding
