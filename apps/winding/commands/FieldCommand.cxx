#include "commands/Commands.h"
#include "commands/FieldRun.h"
#include "commands/FilesToKeep.h"
#include "commands/FilterSettings.h"
#include "commands/HyperTreeRun.h"
#include "files/Suffix.h"
#include "options/Options.h"
#include "output/OutputFile.h"

#include "vtkNew.h"
#include "vtkWindingNumberField.h"

void runField(const Options& options, Messages& messages)
{
  if (suffixOf(options.output) == ".htg")
  {
    runHyperTree(options, false, messages);
    return;
  }
  OutputFile output(options.output, filesToKeep(options));
  vtkNew<vtkWindingNumberField> field;
  applyImage(options, field);
  FieldRun run(*field, options, messages);
  if (options.pieces == 1)
  {
    run.update();
  }
  run.write(output);
  run.print();
}
