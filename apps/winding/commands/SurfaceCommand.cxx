#include "commands/CommandFiles.h"
#include "commands/Commands.h"
#include "commands/FieldRun.h"
#include "commands/WriteField.h"
#include "files/Formats.h"
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
  const auto output = openOnFirstRank(options);
  vtkNew<vtkWindingNumberSurface> filter;
  filter->SetOutputPointsPrecision(
    options.asDouble ? vtkAlgorithm::DOUBLE_PRECISION : vtkAlgorithm::DEFAULT_PRECISION);
  filter->SetFeatures(options.features);
  // The format has triangles only.
  filter->SetGenerateTriangles(options.triangles || suffixOf(options.output) == ".stl");
  filter->SetGenerateDistanceToInput(options.distance);
  filter->SetFidelitySamples(options.fidelity);
  filter->SetCloseBorder(options.closeBorder);
  FieldRun run(*filter, options, messages);
  run.update();
  writeResult(run, filter->GetOutput(), output.get());
  run.printReport();
}
