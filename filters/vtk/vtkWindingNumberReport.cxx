// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindingNumberReport.h"

#include "base/Refusal.h"
#include "messages/Options.h"
#include "messages/PropertyChecks.h"
#include "pipeline/ErrorReports.h"
#include "pipeline/Ranks.h"
#include "pipeline/SmpExecutor.h"
#include "private/output/FaultBlocks.h"
#include "private/output/SourceReport.h"
#include "private/source/ContentHash.h"
#include "private/source/InputViews.h"
#include "private/source/OuterSurface.h"
#include "private/source/PointOrientation.h"
#include "private/source/PolygonOrientation.h"
#include "private/source/SourceField.h"
#include "private/source/SourceMemory.h"
#include "private/source/SourceParts.h"
#include "private/source/SourceProperties.h"
#include "tasks/Sentences.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkWindingNumberReport);

vtkWindingNumberReport::vtkWindingNumberReport()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
  this->SetNumberOfOutputPorts(2);
}

vtkWindingNumberReport::~vtkWindingNumberReport()
{
  this->SetNormalsArray(nullptr);
  this->SetMirror(nullptr);
  this->SetFlatBase(nullptr);
}

void vtkWindingNumberReport::SetController(vtkMultiProcessController* controller)
{
  if (controller != this->Controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkWindingNumberReport::GetController() const
{
  return this->Controller;
}

int vtkWindingNumberReport::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet"); // some of them are refused
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkWindingNumberReport::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkMultiBlockDataSet");
  return 1;
}

int vtkWindingNumberReport::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  winding::requestPart(inputs[0]->GetInformationObject(0), winding::Ranks(this->Controller),
    static_cast<winding::SourceDistribution>(this->SourceDistribution));
  return 1;
}

int vtkWindingNumberReport::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Report->Initialize();
  this->Advice.clear();
  const int asked = std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
  winding::Ranks ranks(this->Controller);
  if (ranks.isAlone() && outputs->GetInformationObject(asked)->Get(
                           vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  const winding::Outcome outcome = winding::reportErrors(this, this->NamesInMessages,
    {"not enough memory for a report", {{"look at a part of the source", {}}}},
    [&]()
    {
      ranks.barrier();
      ranks.agree([&] { this->MakeReport(vtkDataObject::GetData(inputs[0]), output, ranks); });
    });
  this->ErrorCode = winding::errorCodeOf(outcome);
  if (outcome != winding::Outcome::done)
  {
    output->Initialize();
    return 1;
  }
  for (int i = 0; i < this->Report->GetNumberOfArrays(); ++i)
  {
    output->GetFieldData()->AddArray(this->Report->GetAbstractArray(i));
  }
  return 1;
}

void vtkWindingNumberReport::MakeReport(
  vtkDataObject* source, vtkPolyData* output, winding::Ranks& ranks)
{
  winding::checkProperty(winding::Parameter::faultThickness, this->FaultThickness);
  winding::checkProperty(winding::Parameter::weldTolerance, this->WeldTolerance);
  winding::InputOptions options;
  options.estimateNormals = true; // points without any are no error: the report says so
  options.normalsArray = winding::textOf(this->NormalsArray);
  options.takesFaces = this->UseSurfaceCells;
  options.weldTolerance = this->WeldTolerance;
  winding::FieldOptions completion;
  completion.mirror = winding::textOf(this->Mirror);
  completion.flatBase = winding::textOf(this->FlatBase);
  completion.weldTolerance = this->WeldTolerance;
  winding::Mirror{completion.mirror};
  winding::FlatBase{completion.flatBase};
  winding::SmpExecutor executor(this, 0);
  auto views = std::make_unique<winding::InputViews>(source, options, &executor);
  if (this->FixOrientation && !ranks.isAlone())
  {
    throw winding::Refusal(winding::messageOf(winding::Sentence::facesOfOtherRanks));
  }
  winding::SourceOptions properties;
  properties.input = options;
  properties.field = completion;
  properties.distribution = winding::sourceDistribution(this->SourceDistribution);
  ranks.requireSame(
    [&]
    {
      winding::ContentHash hash;
      hash.addValue(winding::hashOf(properties));
      hash.addValue(this->FaultThickness);
      return hash.value();
    });
  views->compare(ranks, properties.distribution);
  winding::refuseHugeSource(*views,
    winding::withNormals(winding::bytesOfReport, this->FixOrientation != 0), "the report", ranks);
  views->gather(ranks);
  winding::CellCounts counts;
  std::vector<vtkSmartPointer<vtkPolyData>> leaves =
    winding::leavesAsPolyData(source, options.takesFaces, counts);
  const bool fixes = this->FixOrientation && views->isSurface();
  winding::OrientedPolygons fix;
  if (fixes)
  {
    fix = winding::orientPolygons(leaves, this->WeldTolerance, executor);
    leaves = fix.leaves;
    views = std::make_unique<winding::InputViews>(winding::asBlocks(leaves), options);
  }
  std::optional<std::size_t> turnedNormals;
  if (this->FixOrientation && !views->isSurface())
  {
    const winding::OrientedPointSets turned =
      winding::orientNormals(leaves, options.normalsArray, executor);
    turnedNormals = turned.points;
    leaves = turned.leaves;
    views = std::make_unique<winding::InputViews>(winding::asBlocks(leaves), options);
  }
  const bool isComposite = source->IsA("vtkCompositeDataSet") != 0;
  const vtkSmartPointer<vtkPolyData> surface =
    isComposite ? winding::appended(leaves) : leaves.front();
  const bool isDouble = surface->GetPoints() && surface->GetPoints()->GetDataType() == VTK_DOUBLE;
  const winding::FaultShape shape = {isDouble ? VTK_DOUBLE : VTK_FLOAT, this->FaultThickness};
  const winding::SourceReport report =
    winding::reportOn(*views, completion, shape, counts, fixes ? &fix : nullptr, executor);
  this->Report->ShallowCopy(report.arrays);
  this->Advice = report.advice;
  if (turnedNormals)
  {
    vtkNew<vtkIdTypeArray> array;
    array->SetName("flipped_normals");
    array->InsertNextValue(static_cast<vtkIdType>(*turnedNormals));
    this->Report->AddArray(array);
  }
  const vtkIdType oneSided = fixes ? this->GetNumberOfOneSidedComponents() : 0;
  if (oneSided > 0)
  {
    vtkWarningMacro(<< oneSided << (oneSided == 1 ? " part has" : " parts have")
                    << " one side only, and stay as they are");
  }
  if (ranks.rank() == 0)
  {
    this->GetFaults()->ShallowCopy(report.faults);
  }
  output->ShallowCopy(surface);
}

vtkMultiBlockDataSet* vtkWindingNumberReport::GetFaults()
{
  return vtkMultiBlockDataSet::SafeDownCast(this->GetOutputDataObject(1));
}

vtkFieldData* vtkWindingNumberReport::GetReport()
{
  return this->Report;
}

double vtkWindingNumberReport::GetNumber(const char* name)
{
  vtkDataArray* array = this->Report->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : 0;
}

vtkIdType vtkWindingNumberReport::GetCount(const char* name)
{
  return static_cast<vtkIdType>(this->GetNumber(name)); // a double holds what fits into memory
}

const char* vtkWindingNumberReport::GetAdvice()
{
  auto* advice = vtkStringArray::SafeDownCast(this->Report->GetAbstractArray("advice"));
  return advice ? advice->GetValue(0).c_str() : "";
}

const char* vtkWindingNumberReport::GetAdvice(int number)
{
  const auto i = static_cast<std::size_t>(number);
  return i < this->Advice.size() ? this->Advice[i].c_str() : "";
}

const char* vtkWindingNumberReport::GetAdviceInLines()
{
  constexpr std::size_t longest = 44;
  this->AdviceInLines.clear();
  for (const std::string& advice : this->Advice)
  {
    std::istringstream words(advice + (&advice == &this->Advice.back() ? "" : ";"));
    std::size_t length = longest;
    for (std::string word; words >> word; length += word.size())
    {
      const bool fits = length + 1 + word.size() <= longest;
      this->AdviceInLines += this->AdviceInLines.empty() ? "" : fits ? " " : "\n";
      length = fits ? length + 1 : 0;
      this->AdviceInLines += word;
    }
  }
  return this->AdviceInLines.c_str();
}

bool vtkWindingNumberReport::GetSourceIsSurface()
{
  return this->Report->HasArray("triangles");
}

bool vtkWindingNumberReport::GetClosed()
{
  return this->GetNumber("closed") != 0;
}

vtkIdType vtkWindingNumberReport::GetNumberOfTriangles()
{
  return this->GetCount("triangles");
}

vtkIdType vtkWindingNumberReport::GetNumberOfBoundaryEdges()
{
  return this->GetCount("boundary_edges");
}

vtkIdType vtkWindingNumberReport::GetNumberOfBoundaryLoops()
{
  return this->GetCount("boundary_loops");
}

double vtkWindingNumberReport::GetWidestSlit()
{
  return this->GetNumber("widest_slit");
}

vtkIdType vtkWindingNumberReport::GetNumberOfNonManifoldEdges()
{
  return this->GetCount("nonmanifold_edges");
}

vtkIdType vtkWindingNumberReport::GetNumberOfInconsistentEdges()
{
  return this->GetCount("inconsistent_edges");
}

vtkIdType vtkWindingNumberReport::GetNumberOfComponents()
{
  return this->GetCount("components_edge");
}

vtkIdType vtkWindingNumberReport::GetNumberOfClosedComponents()
{
  return this->GetCount("closed_components");
}

vtkIdType vtkWindingNumberReport::GetNumberOfInvertedComponents()
{
  return this->GetCount("inverted_components");
}

vtkIdType vtkWindingNumberReport::GetNumberOfNestedSolids()
{
  return this->GetCount("nested_solids");
}

vtkIdType vtkWindingNumberReport::GetNumberOfOneSidedComponents()
{
  return this->GetCount("one_sided_components");
}

vtkIdType vtkWindingNumberReport::GetNumberOfFlippedTriangles()
{
  return this->GetCount("flipped_triangles");
}

vtkIdType vtkWindingNumberReport::GetNumberOfFlippedComponents()
{
  return this->GetCount("flipped_components");
}

double vtkWindingNumberReport::GetFractionalShare()
{
  return this->GetNumber("fractional_share");
}

vtkIdType vtkWindingNumberReport::GetNumberOfDuplicateFaces()
{
  return this->GetCount("duplicate_faces");
}

double vtkWindingNumberReport::GetVolume()
{
  return this->GetNumber("volume");
}

double vtkWindingNumberReport::GetArea()
{
  return this->GetNumber("area");
}

vtkIdType vtkWindingNumberReport::GetNumberOfPoints()
{
  return this->GetCount("points");
}

vtkIdType vtkWindingNumberReport::GetNumberOfDuplicatePoints()
{
  return this->GetCount("duplicates");
}

vtkIdType vtkWindingNumberReport::GetNumberOfZeroNormals()
{
  return this->GetCount("zero_normals");
}

bool vtkWindingNumberReport::GetHasNormals()
{
  return this->GetNumber("normals") != 0;
}

double vtkWindingNumberReport::GetMedianSpacing()
{
  return this->GetNumber("spacing_median");
}

double vtkWindingNumberReport::GetOppositeNeighbors()
{
  return this->GetNumber("opposite_neighbors");
}

double vtkWindingNumberReport::GetOutwardShare()
{
  return this->GetNumber("outward_share");
}

double vtkWindingNumberReport::GetInwardShare()
{
  return this->GetNumber("inward_share");
}

vtkIdType vtkWindingNumberReport::GetNumberOfNonFinite()
{
  return this->GetCount("non_finite");
}

const char* vtkWindingNumberReport::GetSourceDistributionAsString() const
{
  return winding::nameOfChoice(winding::Parameter::sourceDistribution, this->SourceDistribution);
}

void vtkWindingNumberReport::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NamesInMessages: " << this->NamesInMessages << "\n";
  os << indent << "NormalsArray: " << winding::textOf(this->NormalsArray) << "\n";
  os << indent << "UseSurfaceCells: " << this->UseSurfaceCells << "\n";
  os << indent << "Mirror: " << winding::textOf(this->Mirror) << "\n";
  os << indent << "FlatBase: " << winding::textOf(this->FlatBase) << "\n";
  os << indent << "WeldTolerance: " << this->WeldTolerance << "\n";
  os << indent << "FixOrientation: " << this->FixOrientation << "\n";
  os << indent << "FaultThickness: " << this->FaultThickness << "\n";
  os << indent << "Controller: " << this->Controller.Get() << "\n";
  os << indent << "SourceDistribution: " << this->SourceDistribution << "\n";
  os << indent << "Advice: " << this->GetAdvice() << "\n";
  os << indent << "FractionalShare: " << this->GetFractionalShare() << "\n";
}
