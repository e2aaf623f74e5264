// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/Directions.h"
#include "base/Executor.h"
#include "base/Views.h"
#include "cloud/Viewpoints.h"
#include "diagnosis/MendNotes.h"
#include "field/CloudField.h"
#include "field/SurfaceField.h"
#include "surface/FlatBase.h"
#include "surface/Mirror.h"
#include "surface/SheetSide.h"

namespace winding
{

FieldOptions optionsAlong(
  const FieldOptions& options, const Eigen::Matrix3d& inverseAxes, const Eigen::Vector3d& origin)
{
  const Eigen::Vector3d side = sheetSideIn(options.sheetSide);
  FieldOptions result = options;
  result.toward = Viewpoints(options.toward).textAlong(inverseAxes, origin);
  result.mirror = textAlong(Mirror(options.mirror).planes(), inverseAxes, origin);
  result.flatBase = FlatBase(options.flatBase).along(inverseAxes, origin);
  result.sheetSide = side.isZero() ? "" : "direction " + textOf(inverseAxes * side);
  return result;
}

std::shared_ptr<const Field> Field::build(
  const std::vector<TrianglesView>& views, const FieldOptions& options, Executor& executor)
{
  auto field = std::make_shared<SurfaceField>(views, options, executor);
  const auto fault = options.mendsSource ? field->diagnosis().faultToTurn(executor) : std::nullopt;
  if (fault)
  {
    FieldOptions turned = options;
    turned.orientFaces = true;
    field.reset(); // both need not fit into memory together
    field = std::make_shared<SurfaceField>(views, turned, executor);
    field->addNote(mendedNote("faces were turned", *fault));
  }
  return field;
}

std::shared_ptr<const Field> Field::build(
  const std::vector<OrientedPointsView>& views, const FieldOptions& options, Executor& executor)
{
  return std::make_shared<CloudField>(views, options, executor);
}

} // namespace winding
