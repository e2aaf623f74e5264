#include "SurfaceReportOutput.h"

#include "FieldRun.h"
#include "Options.h"

#include "vtkPolyData.h"

void printSurfaceReport(FieldRun& run, vtkPolyData* surface, const Options& options)
{
  Json report = run.report();
  report["output"] = {{"file", options.output}, {"points", surface->GetNumberOfPoints()},
    {"cells", surface->GetNumberOfCells()}};
  if (options.json)
  {
    print(report);
  }
  else if (!options.quiet)
  {
    print(run.summary(report) + ": " + std::to_string(surface->GetNumberOfPoints()) + " points, " +
          std::to_string(surface->GetNumberOfCells()) + " faces");
  }
}
