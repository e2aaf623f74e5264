#include "Commands.h"
#include "FieldRun.h"
#include "FilterSettings.h"
#include "Messages.h"
#include "Options.h"
#include "OutputFile.h"

#include "vtkNew.h"
#include "vtkWindingNumberField.h"

void runField(const Options& options, Messages& messages)
{
  OutputFile output(options.output);
  vtkNew<vtkWindingNumberField> field;
  applyImage(options, field);
  FieldRun run(*field, options, messages);
  if (options.pieces == 1)
  {
    run.update();
  }
  run.write(output);
  const Json report = run.report();
  if (options.json)
  {
    print(report);
  }
  else if (!options.quiet)
  {
    print(run.summary(report));
  }
}
