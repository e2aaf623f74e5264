#include "vtkWindingNumberSurface.h"

#include "base/Executor.h"
#include "field/InsideOut.h"
#include "level/GridContour.h"
#include "level/LevelMemory.h"
#include "level/LevelRoots.h"
#include "level/SharpContour.h"
#include "messages/Options.h"
#include "messages/PropertyChecks.h"
#include "private/output/HandedArrays.h"
#include "private/output/ResultArrays.h"
#include "private/output/SurfaceFidelity.h"
#include "private/pipeline/FreeMemory.h"
#include "private/pipeline/Ranks.h"
#include "private/pipeline/SmpExecutor.h"
#include "private/source/ContentHash.h"
#include "private/source/SourceProperties.h"
#include "report/GridAdvice.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <string>

namespace
{

/// About what rounds take compared with the grid: much where there is something to search for.
constexpr double progressOfGrid = 0.5;

/// Makes points of single or double precision, and has `write` write their coordinates: it is
/// called with a pointer to float or to double.
template <class Write>
vtkSmartPointer<vtkPoints> pointsOf(std::size_t count, bool areDoubles, const Write& write)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  const auto fill = [&](auto* coordinates)
  {
    coordinates->SetName("Points");
    coordinates->SetNumberOfComponents(3);
    coordinates->SetNumberOfTuples(static_cast<vtkIdType>(count));
    write(coordinates->GetPointer(0));
    points->SetData(coordinates);
  };
  if (areDoubles)
  {
    fill(vtkSmartPointer<vtkDoubleArray>::New().Get());
  }
  else
  {
    fill(vtkSmartPointer<vtkFloatArray>::New().Get());
  }
  return points;
}

/// Makes an array of 64-bit ids.
vtkSmartPointer<vtkTypeInt64Array> idsOf(std::size_t count)
{
  auto ids = vtkSmartPointer<vtkTypeInt64Array>::New();
  ids->SetNumberOfValues(static_cast<vtkIdType>(count));
  return ids;
}

std::int64_t* pointerTo(vtkTypeInt64Array* ids)
{
  return static_cast<std::int64_t*>(ids->GetVoidPointer(0));
}

/// Makes an array of `count` normals.
vtkSmartPointer<vtkFloatArray> normalsOf(std::size_t count)
{
  auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(static_cast<vtkIdType>(count));
  return normals;
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

int vtkWindingNumberSurface::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->LookAtSource(vtkDataObject::GetData(inputs[0]));
  this->FindBoundsOverAllTimes(outputs->GetInformationObject(0));
  return 1;
}

void vtkWindingNumberSurface::CheckProperties()
{
  this->Superclass::CheckProperties();
  winding::checkProperty(winding::Parameter::features, this->Features);
  winding::checkProperty(winding::Parameter::outputPointsPrecision, this->OutputPointsPrecision);
  winding::checkProperty(winding::Parameter::fidelitySamples, this->FidelitySamples);
}

const char* vtkWindingNumberSurface::GetFidelityInWords() const
{
  return this->FidelityInWords.c_str();
}

void vtkWindingNumberSurface::HashProperties(winding::ContentHash& hash)
{
  this->Superclass::HashProperties(hash);
  hash.addValue(this->Features);
  hash.addValue(this->GenerateTriangles);
  hash.addValue(this->CloseBorder);
  hash.addValue(this->GenerateNormals);
  hash.addValue(this->OutputPointsPrecision);
  hash.addValue(this->FidelitySamples);
  hash.addValue(this->GenerateDistanceToInput);
}

double vtkWindingNumberSurface::GetResultBytes(vtkIdType) const
{
  const bool hasSlabs =
    this->GetNumberOfCapTriangles() > 0 ||
    this->GetMethodUsed() != std::string(winding::nameOf(winding::Method::rows));
  return winding::LevelEdges::bytesOfRows(this->GetSampling()) +
         (hasSlabs ? winding::LevelEdges::bytesOfSlab(this->GetSampling()) : 0);
}

bool vtkWindingNumberSurface::NeedsDoublePoints() const
{
  if (this->OutputPointsPrecision != DEFAULT_PRECISION)
  {
    return this->OutputPointsPrecision == DOUBLE_PRECISION;
  }
  return winding::needsDoublePoints(this->GetSampling());
}

int vtkWindingNumberSurface::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  vtkPolyData* output = vtkPolyData::GetData(outInfo);
  const bool isPiece = outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0;
  if (isPiece && this->GetRanks().isAlone())
  {
    return 1;
  }
  this->FidelityInWords.clear();
  this->AgreeOnProperties();
  vtkDataObject* source = vtkDataObject::GetData(inputs[0]);
  this->LayOutGrid(source);
  if (!this->CloseBorder)
  {
    winding::refuseFlatGrid(this->GetSampling());
  }
  this->CheckVerification(true);
  const winding::Field& field = this->PrepareGridField(source);
  if (this->IsHelper())
  {
    return 1;
  }
  this->MakeSurface(field, output);
  this->DescribeMethod(output);
  this->CompareWithSource(field, output);
  this->VerifyWholeGrid(field);
  return 1;
}

/// Returns the memory of the surface, and refuses one that does not fit. Where the source's area
/// promises too many vertices, as it does for triangles one behind the other, a coarse grid says
/// more.
std::size_t vtkWindingNumberSurface::GetAdditionalBytes(const winding::Field& field, vtkIdType)
{
  const winding::Grid& grid = this->GetSampling();
  const double bytesOfGrid = this->GetResultBytes(0);
  double edges = winding::levelEdgesByArea(field, grid);
  std::size_t bytes = winding::bytesOfLevelSurface(field, edges);
  if (!winding::isMemoryFree(bytesOfGrid + static_cast<double>(bytes)))
  {
    winding::SmpExecutor executor(this, this->NumberOfThreads);
    executor.setShare(0, 0);
    edges = std::min(
      edges, winding::levelEdgesByCoarseGrid(field, grid, winding::coreInsideRule(this->InsideRule),
               this->WindingThreshold, this->CloseBorder != 0, executor));
    bytes = winding::bytesOfLevelSurface(field, edges);
  }
  winding::refuseBeyondFreeMemory(
    bytesOfGrid + static_cast<double>(bytes), "the surface", {winding::largerVoxels()});
  if (this->FidelitySamples > 0)
  {
    // The surface has about two triangles for each edge of the grid that it crosses.
    winding::refuseFidelityBeyondFreeMemory(
      field, 2 * edges, static_cast<std::size_t>(this->FidelitySamples));
  }
  if (this->GenerateDistanceToInput)
  {
    // A vertex has its place and its distance, in double.
    constexpr std::size_t perVertex = 4 * sizeof(double);
    const auto vertices = static_cast<std::size_t>(edges);
    bytes += field.expectedBytesOfDistances(vertices) + perVertex * vertices;
  }
  return bytes;
}

void vtkWindingNumberSurface::MakeSurface(const winding::Field& field, vtkPolyData* output)
{
  const winding::Grid& grid = this->GetSampling();
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  this->Evaluate(field, static_cast<vtkIdType>(winding::sampleCount(grid.wholeExtent())), executor,
    [&]
    {
      winding::LevelEdges edges(field, grid, winding::coreInsideRule(this->InsideRule),
        this->WindingThreshold, this->CloseBorder != 0);
      this->FindEdges(edges, field, executor);
      if (this->Features == SHARP)
      {
        this->MakeSharp(field, edges, executor, output);
      }
      else
      {
        this->MakeSmooth(field, edges, executor, output);
      }
      this->UpdateProgress(1);
    });
}

void vtkWindingNumberSurface::FindEdges(
  winding::LevelEdges& edges, const winding::Field& field, winding::SmpExecutor& executor)
{
  while (!edges.isDone())
  {
    executor.setShare(progressOfGrid * edges.progress(), progressOfGrid * edges.nextProgress());
    edges.advance(executor);
  }
  // The edges are counted now, however many the source's area promised.
  winding::refuseBeyondFreeMemory(
    static_cast<double>(winding::bytesOfLevelSurface(field, static_cast<double>(edges.size()))),
    "the surface", {winding::largerVoxels()});
  this->TellSides(field, edges.sides(), executor);
  const bool isAllInside = edges.size() == 0 && edges.beginsInside(0, 0);
  if (isAllInside)
  {
    vtkWarningMacro(<< winding::lineOf(winding::allInsideAdvice()));
  }
  this->WarnOfGrid(field, edges.size() == 0 && !isAllInside,
    [&edges](int i, int j, int k) {
      return edges.isSampleInside({i, j, k});
    });
}

void vtkWindingNumberSurface::FindRoots(
  winding::LevelRoots& roots, winding::SmpExecutor& executor) const
{
  for (double progress = progressOfGrid; !roots.isDone();)
  {
    const double next = progress + (1 - progress) / 8;
    executor.setShare(progress, next);
    progress = next;
    roots.advance(executor);
  }
}

void vtkWindingNumberSurface::MakeSmooth(const winding::Field& field,
  const winding::LevelEdges& edges, winding::SmpExecutor& executor, vtkPolyData* output)
{
  const winding::Grid& grid = this->GetSampling();
  winding::GridContour contour(grid, edges, executor);
  const auto ids = idsOf(3 * contour.triangles());
  contour.takeTriangles(pointerTo(ids), executor);
  const auto triangles = winding::cellsOf(ids, 3);
  winding::LevelRoots roots(field, grid, edges, winding::coreInsideRule(this->InsideRule),
    this->WindingThreshold, this->Tolerance, executor);
  this->FindRoots(roots, executor);
  const auto normals = normalsOf(this->GenerateNormals ? contour.vertices() : 0);
  const auto points = pointsOf(contour.vertices(), this->NeedsDoublePoints(),
    [&](auto* coordinates)
    {
      contour.place(roots.fractions(), coordinates, executor);
      if (this->GenerateNormals)
      {
        contour.writeNormals(
          pointerTo(ids), coordinates, roots.normals(), normals->GetPointer(0), executor);
      }
    });
  output->SetPoints(points);
  output->SetPolys(triangles);
  if (this->GenerateNormals)
  {
    output->GetPointData()->SetNormals(normals);
  }
}

void vtkWindingNumberSurface::MakeSharp(const winding::Field& field,
  const winding::LevelEdges& edges, winding::SmpExecutor& executor, vtkPolyData* output)
{
  const winding::Grid& grid = this->GetSampling();
  winding::LevelRoots roots(field, grid, edges, winding::coreInsideRule(this->InsideRule),
    this->WindingThreshold, this->Tolerance, executor);
  this->FindRoots(roots, executor);
  const winding::SharpContour contour(
    field, grid, edges, roots, this->GenerateTriangles != 0, executor);
  output->SetPoints(pointsOf(contour.vertices(), this->NeedsDoublePoints(),
    [&](auto* coordinates) { contour.place(coordinates, executor); }));
  const auto ids = idsOf(contour.corners()), offsets = idsOf(contour.polygons() + 1);
  contour.writePolygons(pointerTo(offsets), pointerTo(ids), executor);
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, ids);
  output->SetPolys(polygons);
  if (this->GenerateNormals)
  {
    const auto normals = normalsOf(contour.polygons());
    contour.writeNormals(normals->GetPointer(0), executor);
    output->GetCellData()->SetNormals(normals);
  }
}

void vtkWindingNumberSurface::CompareWithSource(const winding::Field& field, vtkPolyData* output)
{
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  executor.setShare(1, 1);
  if (this->GenerateDistanceToInput)
  {
    winding::addDistances(field, output, executor);
  }
  if (this->FidelitySamples > 0)
  {
    this->FidelityInWords =
      winding::inWords(winding::addFidelity(field, this->GetSampling().spacing.maxCoeff(),
        static_cast<std::size_t>(this->FidelitySamples), output, executor));
  }
}

/// Nothing else needs all of its values.
void vtkWindingNumberSurface::VerifyWholeGrid(const winding::Field& field)
{
  const winding::Grid& grid = this->GetSampling();
  const winding::Extent extent = grid.wholeExtent();
  winding::ResultOptions options;
  const vtkIdType samples = this->VerifySamples > 0 ? winding::sampleCount(extent) : 0;
  const winding::ResultArrays values(samples, options);
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  if (samples > 0)
  {
    field.evaluate(grid, extent,
      values.output(winding::coreInsideRule(this->InsideRule), this->WindingThreshold), executor);
  }
  this->Verify(field, extent, values.values());
}

void vtkWindingNumberSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Features: " << this->Features << "\n";
  os << indent << "GenerateTriangles: " << this->GenerateTriangles << "\n";
  os << indent << "CloseBorder: " << this->CloseBorder << "\n";
  os << indent << "GenerateNormals: " << this->GenerateNormals << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "GenerateDistanceToInput: " << this->GenerateDistanceToInput << "\n";
  os << indent << "FidelitySamples: " << this->FidelitySamples << "\n";
  os << indent << "FidelityInWords: " << this->FidelityInWords << "\n";
}
