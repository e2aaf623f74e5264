#include "vtkWindingNumberSurface.h"

#include "GridContour.h"
#include "LevelRoots.h"
#include "Refusal.h"
#include "ResultArrays.h"
#include "SmpExecutor.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace
{

/// Arrays of the samples of a grid: whether they are inside, or w.
winding::ResultArrays arraysOf(const winding::Grid& grid, bool ofValues)
{
  winding::ResultOptions options;
  options.withValues = ofValues;
  options.withInside = !ofValues;
  return {static_cast<vtkIdType>(winding::sampleCount(grid.wholeExtent())), options};
}

/// What the samples of an edge say: of w, where there is that, or else of inside.
winding::LevelRoots::Ends endsOf(
  const winding::GridEdge& edge, const winding::Extent& extent, const winding::FieldOutput& samples)
{
  const auto levelAt = [&samples](std::size_t n)
  {
    return samples.values ? winding::levelOf(samples.values[n], samples.rule, samples.threshold)
                          : samples.inside[n] - 0.5;
  };
  const auto& [sample, axis] = edge;
  const std::size_t first = winding::sampleNumber(extent, sample[0], sample[1], sample[2]);
  const std::size_t second = winding::sampleNumber(
    extent, sample[0] + (axis == 0), sample[1] + (axis == 1), sample[2] + (axis == 2));
  return {samples.inside[first] != 0, {levelAt(first), levelAt(second)}};
}

/// Whether the field of a grid is that of a closed surface, found exactly: inside says all of it.
bool isInteger(const winding::FieldInfo& info)
{
  return info.isSurface && info.netBoundaryEdges == 0 && info.method == winding::Method::rows;
}

} // namespace

vtkStandardNewMacro(vtkWindingNumberSurface);

vtkPolyData* vtkWindingNumberSurface::GetOutput()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkWindingNumberSurface::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

void vtkWindingNumberSurface::GiveInformation(vtkInformationVector** inputs, vtkInformationVector*)
{
  this->LookAtSource(vtkDataObject::GetData(inputs[0]));
}

vtkIdType vtkWindingNumberSurface::GetBytesPerSample() const
{
  const bool hasValues = this->GetNumberOfCapTriangles() > 0;
  return 1 + (hasValues ? sizeof(float) : 0) + (this->CloseBorder ? 1 : 0);
}

void vtkWindingNumberSurface::CheckGrid() const
{
  const Eigen::Vector3i& dimensions = this->GetSampling().dimensions;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::string along = std::string(" along ") + "xyz"[axis];
    if (dimensions[axis] < 2 && !this->CloseBorder)
    {
      throw winding::Refusal(
        "the grid has one voxel" + along +
        "; a surface needs two or more, so choose a finer grid or more padding");
    }
  }
}

bool vtkWindingNumberSurface::NeedsDoublePoints() const
{
  if (this->OutputPointsPrecision != DEFAULT_PRECISION)
  {
    return this->OutputPointsPrecision == DOUBLE_PRECISION;
  }
  const winding::Grid& grid = this->GetSampling();
  const double largest =
    (grid.firstSample.cwiseAbs() + grid.dimensions.cast<double>().cwiseProduct(grid.spacing))
      .maxCoeff();
  const double finest = 1e-4 * grid.spacing.minCoeff();
  using Single = std::numeric_limits<float>;
  return largest > Single::max() || finest < Single::min() ||
         finest < 0.5 * Single::epsilon() * largest;
}

void vtkWindingNumberSurface::GiveData(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  vtkPolyData* output = vtkPolyData::GetData(outInfo);
  if (outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return;
  }
  vtkDataObject* source = vtkDataObject::GetData(inputs[0]);
  this->LayOutGrid(source);
  this->CheckGrid();
  this->CheckVerification(true);
  const winding::Grid& grid = this->GetSampling();
  const winding::ResultArrays inside = arraysOf(grid, false);
  const winding::Field* field = this->PrepareGridField(source);
  if (!field)
  {
    return;
  }
  std::optional<winding::ResultArrays> values;
  if (!isInteger(field->info()) || this->VerifySamples > 0)
  {
    values = arraysOf(grid, true);
  }
  winding::FieldOutput samples = this->OutputTo(inside);
  samples.values = values ? this->OutputTo(*values).values : nullptr;

  const auto evaluate = [&](winding::SmpExecutor& executor)
  {
    return this->MakeSurface(*field, samples, inside.inside(), output, executor);
  };
  if (!this->Evaluate(evaluate))
  {
    output->Initialize();
    return;
  }
  this->DescribeMethod(output);
  this->Verify(*field, grid.wholeExtent().data(), values ? values->values() : nullptr);
}

/// False when the executor was interrupted.
bool vtkWindingNumberSurface::MakeSurface(const winding::Field& field,
  const winding::FieldOutput& samples, vtkUnsignedCharArray* inside, vtkPolyData* output,
  winding::SmpExecutor& executor)
try
{
  // About what rounds take beside the grid: much where there is something to search for.
  constexpr double progressOfGrid = 0.5;
  executor.setProgressRange(0, progressOfGrid);
  const winding::Grid& grid = this->GetSampling();
  if (!field.evaluate(grid, grid.wholeExtent(), samples, executor))
  {
    return false;
  }
  const winding::GridContour contour(grid, inside, this->CloseBorder != 0, executor);
  const winding::Extent extent = grid.wholeExtent();
  winding::LevelRoots roots(
    field, grid, contour.edges(),
    [&](const winding::GridEdge& edge) { return endsOf(edge, extent, samples); }, samples.rule,
    samples.threshold, this->Tolerance, executor);
  for (double progress = progressOfGrid; !roots.isDone();)
  {
    const double next = progress + (1 - progress) / 8;
    executor.setProgressRange(progress, next);
    progress = next;
    if (!roots.advance(executor))
    {
      return false;
    }
  }
  const vtkSmartPointer<vtkPoints> points =
    contour.place(roots.fractions(), this->NeedsDoublePoints() ? VTK_DOUBLE : VTK_FLOAT, executor);
  output->SetPoints(points);
  output->SetPolys(contour.triangles());
  if (this->GenerateNormals)
  {
    output->GetPointData()->SetNormals(contour.normalsOf(points, executor));
  }
  this->UpdateProgress(1);
  return true;
}
catch (const winding::Interrupted&)
{
  return false;
}

void vtkWindingNumberSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CloseBorder: " << this->CloseBorder << "\n";
  os << indent << "GenerateNormals: " << this->GenerateNormals << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
