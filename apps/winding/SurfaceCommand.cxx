#include "Commands.h"
#include "Failure.h"
#include "FieldRun.h"
#include "Interrupt.h"
#include "Messages.h"
#include "Options.h"
#include "OutputFile.h"
#include "SurfaceReportOutput.h"

#include "vtkDataArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>

namespace
{

/// The level of |w| bounds what is inside for either orientation.
void takeAbsolute(vtkDataArray* values)
{
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetTuple1(i, std::abs(values->GetTuple1(i)));
  }
  values->Modified();
}

void checkDimensions(vtkImageData* field, const std::string& fileName)
{
  const int* dimensions = field->GetDimensions();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (dimensions[axis] < 2)
    {
      throw Failure(REFUSED, fileName,
        std::string("the grid has one voxel along ") + "xyz"[axis] +
          "; a surface needs two or more, so choose a finer grid or more padding");
    }
  }
}

} // namespace

void runSurface(const Options& given, Messages& messages)
{
  Options options = given;
  options.cells = false; // a level set is drawn between samples that are points
  OutputFile output(options.output);
  FieldRun run(options, messages);
  vtkImageData* field = run.update();
  checkDimensions(field, options.input);
  if (options.rule == vtkWindingNumberAlgorithm::ABSOLUTE)
  {
    takeAbsolute(field->GetPointData()->GetArray(options.array.c_str()));
  }
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(field);
  contour->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, options.array.c_str());
  contour->SetValue(0, options.threshold);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  interrupt::check();
  messages.throwIfError(options.input);
  vtkPolyData* surface = contour->GetOutput();
  if (surface->GetNumberOfCells() == 0)
  {
    messages.warn(
      options.input + ": the field does not reach the threshold, so the surface is empty");
  }
  run.write(surface, output);
  printSurfaceReport(run, surface, options);
}
