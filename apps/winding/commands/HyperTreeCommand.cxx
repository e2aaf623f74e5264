// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Commands.h"

#include "commands/CommandFiles.h"
#include "commands/FieldRun.h"
#include "commands/FilterSettings.h"
#include "commands/WriteField.h"
#include "options/Options.h"
#include "output/OutputFile.h"

#include "vtkHyperTreeGrid.h"
#include "vtkNew.h"
#include "vtkWindingNumberHyperTree.h"

void runHyperTree(const Options& given, bool masksOutside, Messages& messages)
{
  Options options = given;
  options.cells = true; // as the report says
  const auto output = openOnFirstRank(options);
  vtkNew<vtkWindingNumberHyperTree> field;
  applyTrees(options, field);
  field->SetMaskOutside(masksOutside);
  FieldRun run(*field, options, messages);
  run.update();
  writeResult(run, field->GetOutput(), field->GetNumberOfLeaves(), output.get());
  run.printReport();
}
