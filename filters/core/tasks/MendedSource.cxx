// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/MendedSource.h"

#include "diagnosis/Diagnosis.h"
#include "diagnosis/GridAdvice.h"
#include "diagnosis/MendNotes.h"

#include <algorithm>

namespace winding
{

namespace
{

/// Runs work that shows no progress: it cannot be foreseen.
class QuietExecutor final : public Executor
{
public:
  explicit QuietExecutor(Executor& executor)
    : executor_(executor)
  {
  }

  void run(std::size_t count, const std::function<void(std::size_t)>& work) override
  {
    executor_.runBriefly(count, work);
  }

private:
  Executor& executor_;
};

} // namespace

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
  if (facing.looksInward && !field_->info().isOriented)
  {
    this->turn(*facing.warning);
    return true;
  }
  const FieldInfo& info = field_->info();
  if (facing.warning && info.isSurface && info.netBoundaryEdges > 0 && !haveTriedParts_)
  {
    haveTriedParts_ = true;
    QuietExecutor quiet(run_.executor);
    const Field& oriented = info.isOriented ? *field_ : field_->turned(quiet);
    const Field& byParts = oriented.turned(quiet);
    if (&byParts != &oriented)
    {
      run_.warn(turnedNote("loose parts", *facing.warning));
      field_ = &byParts;
      return true;
    }
  }
  const bool isEmpty = sides.inside == 0 && sides.negative == 0 && info.isSurface &&
                       info.netBoundaryEdges > 0 && hasWhole(grid_, info.bounds);
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
    QuietExecutor quiet(run_.executor);
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

void MendedSource::turn(const Message& fault)
{
  run_.warn(turnedNote(field_->info().isSurface ? "faces" : "normals", fault));
  QuietExecutor quiet(run_.executor);
  field_ = &field_->turned(quiet);
}

void MendedSource::thicken()
{
  if (mending_.mayThicken)
  {
    constexpr double voxels = 3;
    plate_ = voxels * grid_.spacing.maxCoeff();
    run_.warn(plateNote(field_->info().openings, plate_));
  }
}

} // namespace winding
