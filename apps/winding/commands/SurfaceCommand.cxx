#include "commands/Commands.h"
#include "commands/FieldRun.h"
#include "commands/FilesToKeep.h"
#include "options/Options.h"
#include "output/OutputFile.h"
#include "program/Messages.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkWindingNumberSurface.h"

void runSurface(const Options& given, Messages& messages)
{
  Options options = given;
  options.cells = false; // the filter draws its surface between samples that are points
  OutputFile output(options.output, filesToKeep(options));
  vtkNew<vtkWindingNumberSurface> filter;
  filter->SetOutputPointsPrecision(
    options.asDouble ? vtkAlgorithm::DOUBLE_PRECISION : vtkAlgorithm::DEFAULT_PRECISION);
  filter->SetCloseBorder(options.closeBorder);
  FieldRun run(*filter, options, messages);
  run.update();
  run.write(filter->GetOutput(), output);
  run.print();
}
