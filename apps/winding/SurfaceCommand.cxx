#include "Commands.h"
#include "FieldRun.h"
#include "Messages.h"
#include "Options.h"
#include "OutputFile.h"
#include "SurfaceReportOutput.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkWindingNumberSurface.h"

void runSurface(const Options& given, Messages& messages)
{
  Options options = given;
  options.cells = false; // a level set is drawn between samples that are points
  OutputFile output(options.output);
  vtkNew<vtkWindingNumberSurface> filter;
  filter->SetOutputPointsPrecision(
    options.asDouble ? vtkAlgorithm::DOUBLE_PRECISION : vtkAlgorithm::DEFAULT_PRECISION);
  filter->SetCloseBorder(options.closeBorder);
  FieldRun run(*filter, options, messages);
  run.update();
  vtkPolyData* surface = filter->GetOutput();
  if (surface->GetNumberOfCells() == 0)
  {
    messages.warn(
      options.input + ": all samples are on one side of the threshold, so the surface is empty");
  }
  run.write(surface, output);
  printSurfaceReport(run, surface, options);
}
