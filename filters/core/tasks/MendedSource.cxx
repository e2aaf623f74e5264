// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/MendedSource.h"

#include "base/Progress.h"
#include "diagnosis/Diagnosis.h"
#include "diagnosis/GridAdvice.h"
#include "diagnosis/MendNotes.h"

#include <algorithm>

namespace winding
{

MendedSource::MendedSource(const Field& field, const Grid& grid, const Mending& mending, Run& run)
  : field_(&field)
  , grid_(grid)
  , mending_(mending)
  , run_(run)
{
  const InsideTest standard;
  mending_.isWished = mending.isWished && field.info().primitives > 0 &&
                      mending.isInside.rule == standard.rule &&
                      mending.isInside.threshold == standard.threshold;
  if (!mending_.isWished)
  {
    return;
  }
  if (const auto fault = field.diagnosis().faultToTurn(run.executor))
  {
    this->turn(*fault);
  }
  if (field_->diagnosis().isSheet(run.executor))
  {
    this->thicken();
  }
}

bool MendedSource::decide(const SideCounts& sides)
{
  if (!mending_.isWished || plate_ > 0)
  {
    return false;
  }
  const Facing facing = field_->diagnosis().facing(sides, mending_.isInside, run_.executor);
  const bool mayTurn = facing.looksInward || facing.contradicts;
  if (mayTurn && !field_->info().isOriented && this->turn(*facing.warning))
  {
    return true;
  }
  const FieldInfo& info = field_->info();
  const bool isOpen = info.isSurface && info.netBoundaryEdges > 0;
  const bool isEmpty =
    isOpen && sides.inside == 0 && sides.negative == 0 && hasWhole(grid_, info.bounds);
  if (isOpen && (facing.warning || isEmpty) && !haveTriedParts_)
  {
    haveTriedParts_ = true;
    BriefExecutor quiet(run_.executor);
    const Field& oriented = info.isOriented ? *field_ : field_->turned(quiet);
    const Field& byParts = oriented.turned(quiet);
    if (byParts.info().turnedLooseParts && &byParts != field_)
    {
      this->take(byParts, facing.warning ? *facing.warning : Message("parts cancel"));
      return true;
    }
  }
  if (facing.isOfSheets || isEmpty)
  {
    this->thicken();
  }
  return false;
}

void MendedSource::decideByLayers()
{
  if (!mending_.isWished || plate_ > 0)
  {
    return;
  }
  Extent extent = grid_.wholeExtent();
  const Bounds& bounds = field_->info().bounds;
  for (int axis = 0; axis < 3; ++axis)
  {
    const IndexRange range = indicesBetween(grid_.inGridUnits(bounds.min(), axis),
      grid_.inGridUnits(bounds.max(), axis), extent[2 * axis], extent[2 * axis + 1]);
    extent[2 * axis] = range.first;
    extent[2 * axis + 1] = range.second;
  }
  if (sampleCount(extent) == 0)
  {
    return;
  }
  constexpr int most = 6, perLayer = 10;
  const int height = extent[5] - extent[4] + 1;
  const int layers = std::clamp(height / perLayer, 1, most);
  const auto countSides = [&]
  {
    BriefExecutor quiet(run_.executor);
    SideTally sides;
    FieldOutput output;
    output.isInside = mending_.isInside;
    output.sides = &sides;
    Extent layer = extent;
    for (int i = 0; i < layers; ++i)
    {
      layer[4] = layer[5] = extent[4] + (2 * i + 1) * height / (2 * layers);
      field_->evaluate(grid_, layer, output, quiet);
    }
    SideCounts counts = sides.counts(sampleCount(layer) * static_cast<std::size_t>(layers));
    // Small parts may lie between the layers.
    counts.inside = std::max<std::size_t>(counts.inside, counts.negative == 0 ? 1 : 0);
    return counts;
  };
  while (this->decide(countSides()))
  {
  }
}

/// Turns the source because of a fault. Returns whether that changed it.
bool MendedSource::turn(const Message& fault)
{
  BriefExecutor quiet(run_.executor);
  const Field& turned = field_->turned(quiet);
  const bool isOther = &turned != field_;
  if (isOther)
  {
    this->take(turned, fault);
  }
  return isOther;
}

/// Goes on with a source that was turned, and says so.
void MendedSource::take(const Field& turned, const Message& fault)
{
  const FieldInfo& info = turned.info();
  const bool areNew = info.normalsAreEstimated && !field_->info().normalsAreEstimated;
  run_.warn(mendedNote(info.turnedLooseParts ? "loose parts were turned"
                       : info.isSurface      ? "faces were turned"
                       : areNew              ? "normals were estimated anew"
                                             : "normals were turned",
    fault));
  field_ = &turned;
}

void MendedSource::thicken()
{
  if (mending_.mayThicken && field_->info().isSurface)
  {
    constexpr double voxels = 3;
    const bool isGiven = mending_.thickness > 0;
    plate_ = isGiven ? mending_.thickness : voxels * grid_.spacing.maxCoeff();
    run_.warn(plateNote(field_->info().openings, plate_, isGiven));
  }
}

} // namespace winding
