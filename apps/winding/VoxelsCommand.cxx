#include "Commands.h"
#include "FieldRun.h"
#include "Interrupt.h"
#include "Messages.h"
#include "Options.h"
#include "OutputFile.h"
#include "Progress.h"
#include "SurfaceReportOutput.h"
#include "WriteOutput.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkWindingNumberVoxels.h"

void runVoxels(const Options& options, Messages& messages)
{
  OutputFile output(options.output);
  FieldRun run(options, messages);
  vtkImageData* field = run.update();
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputData(field);
  voxels->SetInputArrayToProcess(0, 0, 0,
    options.cells ? vtkDataObject::FIELD_ASSOCIATION_CELLS
                  : vtkDataObject::FIELD_ASSOCIATION_POINTS,
    options.array.c_str());
  voxels->SetWindingThreshold(options.threshold);
  voxels->SetInsideRule(options.rule);
  {
    const Progress progress(voxels, "voxels", options.quiet);
    voxels->Update();
  }
  interrupt::check();
  messages.throwIfError(options.input);
  vtkPolyData* surface = voxels->GetOutput();
  if (surface->GetNumberOfCells() == 0)
  {
    messages.warn(options.input + ": no voxel is inside, so the surface is empty");
  }
  writeSurface(surface, output, options, messages);
  printSurfaceReport(run, surface, options);
}
