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
#include "output/PiecesFile.h"
#include "program/ParallelRun.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkWindingNumberField.h"

namespace
{

void writePieces(vtkWindingNumberField& field, const Options& options, Messages& messages)
{
  const PiecesFile output(options.output, filesToKeep(options));
  FieldRun run(field, options, messages);
  writeFieldPieces(run, output);
  run.printReport();
}

void writeOneFile(vtkWindingNumberField& field, const Options& options, Messages& messages)
{
  const auto output = openOnFirstRank(options);
  FieldRun run(field, options, messages);
  if (!parallel::isAlone())
  {
    const vtkSmartPointer<vtkImageData> whole = gatherImage(run);
    writeResult(run, whole, output.get());
  }
  else
  {
    if (options.pieces == 1)
    {
      run.update();
    }
    writeField(run, *output);
  }
  run.printReport();
}

} // namespace

void runField(const Options& options, Messages& messages)
{
  vtkNew<vtkWindingNumberField> field;
  applyField(options, field);
  if (suffixOf(options.output) == ".pvti")
  {
    writePieces(*field, options, messages);
    return;
  }
  writeOneFile(*field, options, messages);
}
