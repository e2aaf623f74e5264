// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/CommandFiles.h"
#include "commands/Commands.h"
#include "commands/FieldRun.h"
#include "commands/FilterSettings.h"
#include "commands/WriteField.h"
#include "files/Formats.h"
#include "options/Options.h"
#include "output/OutputFile.h"
#include "program/Interrupt.h"
#include "program/Messages.h"
#include "program/Progress.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberVoxels.h"

void runVoxels(const Options& given, Messages& messages)
{
  Options options = given;
  // The array "Inside" says all that is needed and takes a quarter of the memory of winding
  // numbers; but alone it is made from floats, and only winding numbers can be verified.
  options.inside = true;
  options.insideOnly = !options.asDouble && options.verify == 0;
  options.resolution = options.resolution.value_or(0);
  OutputFile output(options.output, filesToKeep(options));
  vtkNew<vtkWindingNumberField> field;
  applyField(options, field);
  field->MendSourceOn();
  field->GenerateNearestCellsOff(); // faces have them, not voxels
  FieldRun run(*field, options, messages);
  run.update();
  if (isMedical(suffixOf(options.output)))
  {
    writeResult(run, field->GetOutput(), &output);
    run.printReport();
    return;
  }
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetNamesInMessages(vtkWindingNumberAlgorithm::PROGRAM_NAMES);
  voxels->SetInputData(field->GetOutput());
  voxels->SetInputArrayToProcess(0, 0, 0,
    options.cells ? vtkDataObject::FIELD_ASSOCIATION_CELLS
                  : vtkDataObject::FIELD_ASSOCIATION_POINTS,
    "Inside");
  voxels->SetWindingThreshold(0.5);
  voxels->SetInsideRule(vtkWindingNumberAlgorithm::SIGNED);
  voxels->SetSourceData(field->GetInputDataObject(0, 0));
  voxels->SetTransferAttributes(options.transferAttributes);
  voxels->SetGenerateNearestCells(options.nearestCells);
  voxels->SetMirror(options.mirror.c_str());
  {
    const Progress progress(voxels, Phase::evaluating, messages.isQuiet());
    voxels->Update();
  }
  interrupt::check();
  messages.throwIfError(options.input);
  vtkPolyData* surface = voxels->GetOutput();
  writeResult(run, surface, &output);
  run.printReport();
}
