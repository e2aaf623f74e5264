// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/CommandFiles.h"
#include "commands/Commands.h"
#include "commands/FieldRun.h"
#include "commands/WriteField.h"
#include "files/Formats.h"
#include "options/Options.h"
#include "output/OutputFile.h"
#include "program/Failure.h"
#include "program/Messages.h"
#include "program/ParallelRun.h"

#include "vtkCell.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkWindingNumberBoolean.h"
#include "vtkWindingNumberSurface.h"

#include <string>

namespace
{

bool hasFaces(vtkPointSet* data)
{
  if (auto* const mesh = vtkPolyData::SafeDownCast(data))
  {
    return mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() > 0;
  }
  return data->GetNumberOfCells() > 0 && data->GetCell(0)->GetCellDimension() > 1;
}

/// Throws Failure where meshes and clouds are to have nearest cells, before anything is computed.
void checkNearestOfKinds(vtkDataObject* source, const Options& options)
{
  auto* const inputs = vtkCompositeDataSet::SafeDownCast(source);
  const bool areAsked = options.transferAttributes || options.nearestCells;
  if (!inputs || options.asPoints || !areAsked)
  {
    return;
  }
  bool areMeshes = false, areClouds = false;
  auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(inputs->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    auto* const leaf = vtkPointSet::SafeDownCast(iterator->GetCurrentDataObject());
    if (leaf && leaf->GetNumberOfPoints() > 0)
    {
      (hasFaces(leaf) ? areMeshes : areClouds) = true;
    }
  }
  const std::string option =
    options.transferAttributes ? "--transfer-attributes" : "--nearest-cells";
  if (areMeshes && areClouds)
  {
    throw Failure(EXIT_REFUSED,
      option + " is for surfaces or for clouds, not for both at once; take inputs of one kind, or "
               "leave it out");
  }
}

/// Makes and writes the surface of a filter that has all options of its own, or the image of what
/// is inside.
void writeSurface(
  vtkWindingNumberSurfaceAlgorithm& filter, const Options& given, Messages& messages)
{
  Options options = given;
  options.cells = false; // filters draw surfaces between samples that are points
  const auto output = openOnFirstRank(options);
  filter.SetOutputPointsPrecision(
    options.asDouble ? vtkAlgorithm::DOUBLE_PRECISION : vtkAlgorithm::DEFAULT_PRECISION);
  filter.SetFeatures(options.features);
  // The format has triangles only.
  filter.SetGenerateTriangles(options.triangles || suffixOf(options.output) == ".stl");
  filter.SetCloseBorder(options.closeBorder);
  filter.SetTransferAttributes(options.transferAttributes);
  filter.SetGenerateNearestCells(options.nearestCells);
  const bool asImage = isImage(suffixOf(options.output));
  filter.SetGenerateImage(asImage);
  FieldRun run(filter, options, messages);
  if (options.command == "boolean")
  {
    parallel::agree([&] { checkNearestOfKinds(filter.GetInputDataObject(0, 0), options); });
  }
  run.update();
  if (asImage)
  {
    writeResult(run, filter.GetImage(), output.get());
  }
  else
  {
    writeResult(run, filter.GetOutput(), output.get());
  }
  run.printReport();
}

} // namespace

void runSurface(const Options& options, Messages& messages)
{
  vtkNew<vtkWindingNumberSurface> filter;
  filter->SetFillCavities(options.fillCavities);
  filter->SetGapWidth(options.gapWidth);
  filter->SetOffset(options.offset);
  filter->SetShell(options.shell);
  filter->SetShellSide(options.shellSide);
  filter->SetGenerateDistanceToInput(options.distance);
  filter->SetFidelitySamples(options.fidelity);
  writeSurface(*filter, options, messages);
}

void runBoolean(const Options& options, Messages& messages)
{
  vtkNew<vtkWindingNumberBoolean> filter;
  filter->SetOperation(options.operation);
  for (std::size_t i = 0; i < options.thresholds.size(); ++i)
  {
    filter->SetOperandThreshold(static_cast<int>(i), options.thresholds[i]);
  }
  for (std::size_t i = 0; i < options.rules.size(); ++i)
  {
    filter->SetOperandInsideRule(static_cast<int>(i), options.rules[i]);
  }
  writeSurface(*filter, options, messages);
}
