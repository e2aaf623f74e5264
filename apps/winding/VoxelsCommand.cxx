#include "Commands.h"
#include "FieldRun.h"
#include "FilterSettings.h"
#include "Interrupt.h"
#include "Messages.h"
#include "Options.h"
#include "OutputFile.h"
#include "Progress.h"
#include "SurfaceReportOutput.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberVoxels.h"

void runVoxels(const Options& given, Messages& messages)
{
  Options options = given;
  // "Inside" says all and takes a quarter of the memory; but it is what floats make it, and only
  // values can be verified.
  options.insideOnly = !options.asDouble && options.verify == 0;
  const bool byInside = options.insideOnly || options.coverage != vtkWindingNumberField::CENTER;
  OutputFile output(options.output);
  vtkNew<vtkWindingNumberField> field;
  applyImage(options, field);
  FieldRun run(*field, options, messages);
  run.update();
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputData(field->GetOutput());
  voxels->SetInputArrayToProcess(0, 0, 0,
    options.cells ? vtkDataObject::FIELD_ASSOCIATION_CELLS
                  : vtkDataObject::FIELD_ASSOCIATION_POINTS,
    byInside ? "Inside" : options.array.c_str());
  voxels->SetWindingThreshold(byInside ? 0.5 : options.threshold);
  voxels->SetInsideRule(
    byInside ? static_cast<int>(vtkWindingNumberAlgorithm::SIGNED) : options.rule);
  {
    const Progress progress(voxels, "voxels", options.quiet);
    voxels->Update();
  }
  interrupt::check();
  messages.throwIfError(options.input);
  vtkPolyData* surface = voxels->GetOutput();
  if (surface->GetNumberOfCells() == 0)
  {
    const bool byCenter = options.coverage == vtkWindingNumberField::CENTER;
    messages.warn(options.input + ": no voxel is inside, so the surface is empty" +
                  (byCenter ? "; --coverage any takes parts thinner than a voxel, too" : ""));
  }
  run.write(surface, output);
  printSurfaceReport(run, surface, options);
}
