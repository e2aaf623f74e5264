// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/SourceField.h"

#include "base/Refusal.h"
#include "diagnosis/Diagnosis.h"
#include "private/source/ContentHash.h"
#include "private/source/FramedViews.h"
#include "private/source/SourceMemory.h"
#include "source/Sanitize.h"
#include "surface/FlatBase.h"
#include "surface/Mirror.h"

#include <optional>
#include <string>
#include <vector>

namespace winding
{

bool SourceField::Memory::isSame(const InputViews& views, const InputOptions& options)
{
  const bool sameOptions = options == options_;
  if (sameOptions && views.identity() == identity_)
  {
    return true;
  }
  const std::uint64_t fingerprint = views.fingerprint();
  const bool same = sameOptions && !identity_.empty() && fingerprint == fingerprint_;
  identity_ = views.identity();
  options_ = options;
  fingerprint_ = fingerprint;
  return same;
}

const Field& SourceField::prepare(vtkDataObject* source, const SourceOptions& options,
  Executor& executor, Ranks& ranks, bool onlyOnFirst)
{
  std::optional<InputViews> views;
  Memory memory = source_;
  const bool isKept = ranks.allOf(
    [&]
    {
      views.emplace(source, options.input, &executor);
      if (!options.input.asPoints && views->hasOnlyLines())
      {
        throw Refusal(onlyLines()); // even if normals are to be estimated
      }
      const bool isSameSource = memory.isSame(*views, options.input);
      return field_ && isSameSource && options_ == options.field && frame_ == options.frame &&
             distribution_ == options.distribution && ranks_ == ranks.count();
    });
  source_ = memory; // not before: where a rank refuses its part, the field is still of the last one
  frame_ = options.frame;
  distribution_ = options.distribution;
  ranks_ = ranks.count();
  wasBuilt_ = !isKept;
  if (wasBuilt_)
  {
    info_ = FieldInfo();
    field_ = nullptr; // the old and the new one need not fit into memory together
    views->compare(ranks, options.distribution);
    BytesOfWork bytes = withNormals(bytesOfField, mayFindConsistentNormals(options.field));
    if (!frame_.isStraight())
    {
      bytes = withFramedViews(bytes);
    }
    bytes = withImages(bytes, Mirror(options.field.mirror).copies());
    refuseHugeSource(*views, bytes, "the field", ranks, onlyOnFirst);
    views->gather(ranks, onlyOnFirst);
    if (onlyOnFirst && ranks.rank() > 0)
    {
      field_ = Field::build(std::vector<TrianglesView>(), options.field, executor);
    }
    else
    {
      FramedViews framed(frame_);
      FieldOptions field = frame_.isStraight()
                             ? options.field
                             : optionsAlong(options.field, frame_.inverseAxes, frame_.origin);
      if (views->isSurface() || views->isEmpty())
      {
        field_ = Field::build(framed.of(views->triangles()), field, executor);
      }
      else
      {
        const std::vector<OrientedPointsView> points = framed.of(views->orientedPoints());
        field.lookAtViewpoints = views->lookAtViewpoints();
        field_ = Field::build(points, field, executor);
      }
    }
    options_ = options.field;
    info_ = field_->info();
    for (const std::vector<Message>& notes :
      {field_->diagnosis().ofSource(executor), notesOn(views->cellCounts())})
    {
      info_.warnings.insert(info_.warnings.end(), notes.begin(), notes.end());
    }
  }
  return *field_;
}

Bounds SourceField::bounds(
  vtkDataObject* source, const SourceOptions& options, Executor& executor, Ranks& ranks)
{
  std::optional<InputViews> views;
  Memory memory = boundedSource_;
  const bool isKept = ranks.allOf(
    [&]
    {
      views.emplace(source, options.input);
      const bool isSameSource = memory.isSame(*views, options.input);
      return isSameSource && boundedRanks_ == ranks.count();
    });
  if (!isKept)
  {
    std::vector<double> corners;
    ranks.agree(
      [&]
      {
        const Bounds own = views->isSurface() ? boundsOf(views->triangles(), executor)
                                              : boundsOf(views->orientedPoints(), executor);
        if (!own.isEmpty())
        {
          corners.insert(corners.end(), own.min().data(), own.min().data() + 3);
          corners.insert(corners.end(), own.max().data(), own.max().data() + 3);
        }
      });
    bounds_ = Bounds();
    const OfRanks<double> ofAll = ranks.gather(corners, false);
    for (std::size_t n = 0; n < ofAll.numbers.size(); n += 3)
    {
      bounds_.extend(Eigen::Vector3d(ofAll.numbers.data() + n));
    }
  }
  boundedSource_ = memory; // not before: a source that is refused must be refused again
  boundedRanks_ = ranks.count();
  const Bounds mirrored = Mirror(options.field.mirror).completed(bounds_);
  return FlatBase(options.field.flatBase).completed(mirrored);
}

Ranks::Number hashOf(const SourceOptions& options)
{
  ContentHash hash;
  hash.addValue(options.distribution);
  hash.addValue(options.input.asPoints);
  hash.addValue(options.input.takesFaces);
  hash.addValue(options.input.estimateNormals);
  hash.addValue(options.input.areas);
  hash.addText(options.input.normalsArray);
  hash.addText(options.input.areaArray);
  hash.addValue(options.field.estimateNormals);
  hash.addValue(options.field.orientFaces);
  hash.addValue(options.field.ignoreOpenParts);
  hash.addValue(options.field.method);
  hash.addValue(options.field.tolerance);
  hash.addValue(options.field.normalEstimation);
  hash.addText(options.field.toward);
  hash.addText(options.field.mirror);
  hash.addText(options.field.flatBase);
  hash.addText(options.field.sheetSide);
  hash.addValue(options.input.weldTolerance);
  hash.addValue(options.field.pointAreaMethod);
  hash.addValue(options.field.pointArea);
  hash.addValue(options.field.neighbors);
  hash.addValue(options.field.regularization);
  return hash.value();
}

} // namespace winding
