// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindingNumberSurfaceAlgorithm.h"

#include "base/Executor.h"
#include "diagnosis/GridAdvice.h"
#include "field/Field.h"
#include "level/CombinedRoots.h"
#include "level/GridContour.h"
#include "level/LevelMemory.h"
#include "level/LevelRoots.h"
#include "level/SharpContour.h"
#include "messages/Options.h"
#include "messages/PropertyChecks.h"
#include "pipeline/FreeMemory.h"
#include "pipeline/Ranks.h"
#include "pipeline/SmpExecutor.h"
#include "private/output/EqualCells.h"
#include "private/output/NearestAttributes.h"
#include "private/output/ResultArrays.h"
#include "private/source/ContentHash.h"
#include "private/source/SourceProperties.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <string>

using Pipeline = vtkStreamingDemandDrivenPipeline;

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

/// Makes the array of the operands that `count` polygons come from; operandOf(n) is the one of the
/// n-th.
template <class OperandOf>
vtkSmartPointer<vtkIntArray> operandsOf(std::size_t count, const OperandOf& operandOf)
{
  auto operands = vtkSmartPointer<vtkIntArray>::New();
  operands->SetName("Operand");
  operands->SetNumberOfValues(static_cast<vtkIdType>(count));
  for (std::size_t n = 0; n < count; ++n)
  {
    operands->SetValue(static_cast<vtkIdType>(n), static_cast<int>(operandOf(n)));
  }
  return operands;
}

} // namespace

vtkWindingNumberSurfaceAlgorithm::vtkWindingNumberSurfaceAlgorithm()
{
  this->SetNumberOfOutputPorts(2);
}

vtkPolyData* vtkWindingNumberSurfaceAlgorithm::GetOutput()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
}

vtkImageData* vtkWindingNumberSurfaceAlgorithm::GetImage()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(1));
}

int vtkWindingNumberSurfaceAlgorithm::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

vtkInformation* vtkWindingNumberSurfaceAlgorithm::GetRequestedOutput(
  vtkInformation* request, vtkInformationVector* outputs)
{
  return outputs->GetInformationObject(std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT())));
}

int vtkWindingNumberSurfaceAlgorithm::RequestInformation(
  vtkInformation* request, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* outInfo = GetRequestedOutput(request, outputs);
  vtkInformation* ofImage = outputs->GetInformationObject(1);
  winding::Extent extent = {0, -1, 0, -1, 0, -1};
  ofImage->Set(Pipeline::WHOLE_EXTENT(), extent.data(), 6);
  this->LookAtSource(this->GetSource());
  this->GetRanks().requireSame(
    [this]() -> winding::Ranks::Number { return this->GenerateImage != 0; });
  this->FindBoundsOverAllTimes(outInfo);
  if (!this->GenerateImage)
  {
    return 1;
  }
  this->AgreeOnProperties();
  if (this->UseInputBounds)
  {
    this->UpdateSource(outInfo);
  }
  this->LayOutGrid(this->GetSource());
  const winding::Grid& grid = this->GetSampling();
  extent = grid.wholeExtent();
  ofImage->Set(Pipeline::WHOLE_EXTENT(), extent.data(), 6);
  ofImage->Set(vtkDataObject::ORIGIN(), grid.firstSample.data(), 3);
  ofImage->Set(vtkDataObject::SPACING(), grid.spacing.data(), 3);
  vtkDataObject::SetPointDataActiveScalarInfo(ofImage, VTK_UNSIGNED_CHAR, 1);
  return 1;
}

void vtkWindingNumberSurfaceAlgorithm::LayGridOver(vtkDataObject* source)
{
  this->GetImage()->Initialize();
  if (this->GenerateImage)
  {
    this->MoveGrid(source);
  }
  else
  {
    this->LayOutGrid(source);
  }
}

void vtkWindingNumberSurfaceAlgorithm::CheckProperties()
{
  this->Superclass::CheckProperties();
  winding::checkProperty(winding::Parameter::features, this->Features);
  winding::checkProperty(winding::Parameter::outputPointsPrecision, this->OutputPointsPrecision);
  if (this->TransferAttributes || this->GenerateNearestCells)
  {
    winding::refuseNearestOfOtherRanks(
      this->GetRanks(), winding::sourceDistribution(this->SourceDistribution));
  }
}

void vtkWindingNumberSurfaceAlgorithm::HashProperties(winding::ContentHash& hash)
{
  this->Superclass::HashProperties(hash);
  hash.addValue(this->Features);
  hash.addValue(this->GenerateTriangles);
  hash.addValue(this->CloseBorder);
  hash.addValue(this->GenerateNormals);
  hash.addValue(this->OutputPointsPrecision);
  hash.addValue(this->TransferAttributes);
  hash.addValue(this->GenerateNearestCells);
  hash.addValue(this->GenerateImage);
}

double vtkWindingNumberSurfaceAlgorithm::GetResultBytes(vtkIdType) const
{
  const std::size_t bytesOfImage =
    this->GenerateImage ? winding::sampleCount(this->GetSampling().wholeExtent()) : 0;
  const bool hasSlabs =
    this->GetNumberOfCapTriangles() > 0 ||
    this->GetMethodUsed() != std::string(winding::nameOf(winding::Method::rows));
  return static_cast<double>(bytesOfImage) + winding::LevelEdges::bytesOfRows(this->GetSampling()) +
         (hasSlabs ? winding::LevelEdges::bytesOfSlab(this->GetSampling()) : 0);
}

bool vtkWindingNumberSurfaceAlgorithm::NeedsDoublePoints() const
{
  if (this->OutputPointsPrecision != DEFAULT_PRECISION)
  {
    return this->OutputPointsPrecision == DOUBLE_PRECISION;
  }
  return winding::needsDoublePoints(this->GetSampling());
}

bool vtkWindingNumberSurfaceAlgorithm::IsLaterPiece(vtkInformation* output) const
{
  return output->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0 && this->GetRanks().isAlone();
}

/// Where the source's area promises too many vertices, as it does for triangles one behind the
/// other, a coarse grid says more.
double vtkWindingNumberSurfaceAlgorithm::GetBytesOfSurface(
  const winding::Field& field, double& edges)
{
  const winding::Grid& grid = this->GetSampling();
  const double bytesOfGrid = this->GetResultBytes(0);
  edges = winding::levelEdgesByArea(field, grid);
  auto bytes = static_cast<double>(winding::bytesOfLevelSurface(field, edges));
  if (!winding::isMemoryFree(bytesOfGrid + bytes))
  {
    winding::SmpExecutor executor(this, this->NumberOfThreads);
    executor.setShare(0, 0);
    edges = std::min(
      edges, winding::levelEdgesByCoarseGrid(field, grid, winding::coreInsideRule(this->InsideRule),
               this->WindingThreshold, this->CloseBorder != 0, executor));
    bytes = static_cast<double>(winding::bytesOfLevelSurface(field, edges));
  }
  winding::refuseBeyondFreeMemory(bytesOfGrid + bytes, "the surface", {winding::largerVoxels()});
  return bytes;
}

void vtkWindingNumberSurfaceAlgorithm::FindEdges(
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
}

bool vtkWindingNumberSurfaceAlgorithm::TellAllInside(const winding::LevelEdges& edges)
{
  const bool isAllInside = edges.areAllInside();
  if (isAllInside && !this->GenerateImage)
  {
    vtkWarningMacro(<< this->GetSourcePrefix() << winding::lineOf(winding::allInsideAdvice()));
  }
  return isAllInside;
}

void vtkWindingNumberSurfaceAlgorithm::TellOpen(const winding::LevelEdges& edges)
{
  if (!this->CloseBorder && !this->GenerateImage && edges.size() > 0 && edges.reachesBorder())
  {
    vtkWarningMacro(<< this->GetSourcePrefix() << winding::lineOf(winding::openResultAdvice()));
  }
}

winding::EdgeRoots vtkWindingNumberSurfaceAlgorithm::FindRoots(const winding::Field& field,
  const winding::LevelEdges& edges, winding::SmpExecutor& executor) const
{
  winding::LevelRoots roots(field, this->GetSampling(), edges,
    winding::coreInsideRule(this->InsideRule), this->WindingThreshold, this->Tolerance, executor);
  for (double progress = progressOfGrid; !roots.isDone();)
  {
    const double next = progress + (1 - progress) / 8;
    executor.setShare(progress, next);
    progress = next;
    roots.advance(executor);
  }
  if (this->Features == SHARP)
  {
    roots.addGradients(executor);
  }
  return roots.take();
}

void vtkWindingNumberSurfaceAlgorithm::MakePolyData(const winding::LevelEdges& edges,
  const std::function<const winding::EdgeRoots&()>& findRoots,
  const std::vector<std::uint32_t>* operands, winding::SmpExecutor& executor,
  vtkPolyData* output) const
{
  const winding::Grid& grid = this->GetSampling();
  if (this->Features != SMOOTH)
  {
    const winding::EdgeRoots* const roots = this->Features == SHARP ? &findRoots() : nullptr;
    const winding::SharpContour contour(grid, edges, roots, this->GenerateTriangles != 0, executor);
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
    if (operands)
    {
      std::vector<std::uint32_t> edgeOf(contour.polygons());
      contour.writeEdges(edgeOf.data(), executor);
      output->GetCellData()->AddArray(
        operandsOf(edgeOf.size(), [&](std::size_t n) { return (*operands)[edgeOf[n]]; }));
    }
    return;
  }
  winding::GridContour contour(grid, edges, executor);
  const auto ids = idsOf(3 * contour.triangles());
  contour.takeTriangles(pointerTo(ids), executor);
  const auto triangles = winding::cellsOf(ids, 3);
  const winding::EdgeRoots& roots = findRoots();
  const auto normals = normalsOf(this->GenerateNormals ? contour.vertices() : 0);
  const auto points = pointsOf(contour.vertices(), this->NeedsDoublePoints(),
    [&](auto* coordinates)
    {
      contour.place(roots, coordinates, executor);
      if (this->GenerateNormals)
      {
        contour.writeNormals(
          pointerTo(ids), coordinates, roots.normals, normals->GetPointer(0), executor);
      }
    });
  output->SetPoints(points);
  output->SetPolys(triangles);
  if (this->GenerateNormals)
  {
    output->GetPointData()->SetNormals(normals);
  }
  if (operands)
  {
    const std::int64_t* corners = pointerTo(ids);
    output->GetCellData()->AddArray(operandsOf(contour.triangles(),
      [&](std::size_t n) { return winding::operandOf(corners + 3 * n, *operands); }));
  }
}

void vtkWindingNumberSurfaceAlgorithm::MakeImage(
  const winding::LevelEdges& edges, winding::SmpExecutor& executor)
{
  if (!this->GenerateImage)
  {
    return;
  }
  const winding::Grid& grid = this->GetSampling();
  winding::Extent extent = grid.wholeExtent();
  vtkImageData* const image = this->GetImage();
  image->SetExtent(extent.data());
  image->SetOrigin(grid.firstSample.data());
  image->SetSpacing(grid.spacing.data());
  const auto inside = winding::makeResultArray(
    VTK_UNSIGNED_CHAR, "Inside", static_cast<vtkIdType>(winding::sampleCount(extent)));
  edges.writeInside(static_cast<unsigned char*>(inside->GetVoidPointer(0)), executor);
  image->GetPointData()->SetScalars(inside);
}

std::size_t vtkWindingNumberSurfaceAlgorithm::GetBytesOfNearest(const winding::Field& field) const
{
  const winding::FieldInfo& info = field.info();
  return this->TransferAttributes || this->GenerateNearestCells
           ? winding::NearestAttributes::bytesFor(info.isSurface, info.inputPrimitives)
           : 0;
}

void vtkWindingNumberSurfaceAlgorithm::AddNearest(vtkDataObject* source, vtkPolyData* output)
{
  if (!this->TransferAttributes && !this->GenerateNearestCells)
  {
    return;
  }
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  executor.setShare(1, 1);
  const winding::NearestAttributes nearest(source, this->GetSourceOptions(),
    {this->GenerateNearestCells != 0, this->TransferAttributes != 0}, executor);
  nearest.addTo(output, executor);
  if (const auto note = nearest.note())
  {
    vtkWarningMacro(<< winding::lineOf(*note));
  }
}

const char* vtkWindingNumberSurfaceAlgorithm::GetFeaturesAsString() const
{
  return winding::nameOfChoice(winding::Parameter::features, this->Features);
}

void vtkWindingNumberSurfaceAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Features: " << this->Features << "\n";
  os << indent << "GenerateTriangles: " << this->GenerateTriangles << "\n";
  os << indent << "CloseBorder: " << this->CloseBorder << "\n";
  os << indent << "GenerateNormals: " << this->GenerateNormals << "\n";
  os << indent << "TransferAttributes: " << this->TransferAttributes << "\n";
  os << indent << "GenerateNearestCells: " << this->GenerateNearestCells << "\n";
  os << indent << "GenerateImage: " << this->GenerateImage << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
