#include "vtkWindingNumberAlgorithm.h"

#include "base/Bounds.h"
#include "base/Executor.h"
#include "private/FreeMemory.h"
#include "private/InsideOutAdvice.h"
#include "private/ResultArrays.h"
#include "private/SmpExecutor.h"
#include "private/SourceField.h"
#include "private/SourceParts.h"
#include "private/SourceProperties.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <chrono>
#include <cmath>
#include <limits>
#include <new>
#include <string>

namespace
{

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

int kindOf(vtkDataObject* source)
{
  switch (winding::kindOf(source))
  {
  case winding::SourceKind::mesh:
    return vtkWindingNumberAlgorithm::MESH_SOURCE;
  case winding::SourceKind::cloud:
    return vtkWindingNumberAlgorithm::CLOUD_SOURCE;
  default:
    return vtkWindingNumberAlgorithm::NO_SOURCE;
  }
}

} // namespace

vtkWindingNumberAlgorithm::vtkWindingNumberAlgorithm()
  : Source(std::make_unique<winding::SourceField>())
{
  this->SetAreaArray("Area");
  this->SetResultArrayName("WindingNumber");
}

vtkWindingNumberAlgorithm::~vtkWindingNumberAlgorithm()
{
  this->SetNormalsArray(nullptr);
  this->SetAreaArray(nullptr);
  this->SetResultArrayName(nullptr);
}

vtkTypeBool vtkWindingNumberAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  void (vtkWindingNumberAlgorithm::*answer)(vtkInformationVector**, vtkInformationVector*) =
    nullptr;
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    answer = &vtkWindingNumberAlgorithm::GiveDataObject;
  }
  else if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    answer = &vtkWindingNumberAlgorithm::GiveInformation;
  }
  else if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
  {
    answer = &vtkWindingNumberAlgorithm::AskForUpdate;
  }
  else if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    answer = &vtkWindingNumberAlgorithm::GiveData;
  }
  else
  {
    return this->Superclass::ProcessRequest(request, inputs, outputs);
  }

  this->Status = DONE;
  try
  {
    (this->*answer)(inputs, outputs);
    return 1;
  }
  catch (const winding::OutOfMemory& refusal)
  {
    this->Status = OUT_OF_MEMORY;
    vtkErrorMacro(<< refusal.what());
  }
  catch (const winding::Refusal& refusal)
  {
    this->Status = REFUSED;
    vtkErrorMacro(<< refusal.what());
  }
  catch (const std::bad_alloc&)
  {
    this->Status = OUT_OF_MEMORY;
    vtkErrorMacro(<< "there is not enough memory for this source and grid; choose larger voxels or "
                     "write the result in pieces");
  }
  // The pipeline would add an extent that failed to the next one that is asked for.
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    outputs->GetInformationObject(port)->Remove(
      vtkStreamingDemandDrivenPipeline::COMBINED_UPDATE_EXTENT());
  }
  return 0;
}

void vtkWindingNumberAlgorithm::GiveDataObject(vtkInformationVector**, vtkInformationVector*) {}

void vtkWindingNumberAlgorithm::FillSourcePortInformation(vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
}

winding::SourceOptions vtkWindingNumberAlgorithm::GetSourceOptions()
{
  return winding::sourceOptions(*this, !this->EvaluatesGrid());
}

const winding::Field* vtkWindingNumberAlgorithm::PrepareField(vtkDataObject* source,
  vtkIdType samples,
  const std::function<bool(const winding::Field&, winding::Executor&)>& prepareSamples)
{
  if (!std::isfinite(this->WindingThreshold))
  {
    throw winding::Refusal("the winding threshold is " + std::to_string(this->WindingThreshold) +
                           "; it must be a finite number");
  }
  this->SourceIsInsideOut = false;
  this->LookAtSource(source);
  Clock::time_point start = Clock::now();
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  const winding::Field* field = this->Source->prepare(source, this->GetSourceOptions(), executor);
  // Looking whether the source is the last one is not preparing.
  start = this->Source->wasBuilt() ? start : Clock::now();
  const bool isPrepared = field && prepareSamples(*field, executor) &&
                          (!this->WantsDistances() || field->prepareDistances(executor));
  this->PrepareSeconds = executor.hasRun() ? secondsSince(start) : 0;
  if (!isPrepared)
  {
    this->Status = ABORTED;
    return nullptr;
  }
  winding::EvaluationCost cost = field->expectedCost(static_cast<std::size_t>(samples));
  if (this->WantsDistances())
  {
    cost += field->expectedCostOfDistances(static_cast<std::size_t>(samples));
  }
  this->ExpectedSeconds = cost.seconds / executor.threads();
  this->ExpectedMemory =
    static_cast<vtkIdType>(static_cast<double>(cost.bytes) + this->GetResultBytes(samples));
  const winding::FieldInfo& info = field->info();
  if (!info.warning.empty())
  {
    vtkWarningMacro(<< info.warning);
  }
  if (info.primitives == 0)
  {
    vtkWarningMacro(<< "the source has no triangles and no points to sum over; its field is 0");
  }
  return field;
}

bool vtkWindingNumberAlgorithm::WantsDistances() const
{
  return this->GenerateSignedDistance != 0;
}

double vtkWindingNumberAlgorithm::GetDistanceLimit() const
{
  return std::numeric_limits<double>::infinity();
}

winding::ResultOptions vtkWindingNumberAlgorithm::GetResultOptions() const
{
  winding::ResultOptions options;
  options.withValues = this->GenerateWindingNumber != 0;
  options.withInside = this->GenerateInside != 0;
  options.withDistances = this->WantsDistances();
  options.scalarType = this->OutputScalarType;
  options.name = winding::textOf(this->ResultArrayName);
  return options;
}

double vtkWindingNumberAlgorithm::GetResultBytes(vtkIdType samples) const
{
  return static_cast<double>(winding::bytesPerSample(this->GetResultOptions())) *
         static_cast<double>(samples);
}

void vtkWindingNumberAlgorithm::LookAtSource(vtkDataObject* source)
{
  this->SourceKind = kindOf(source);
}

bool vtkWindingNumberAlgorithm::GetSourceBounds(vtkDataObject* source, double bounds[6])
{
  winding::InputOptions options = this->GetSourceOptions().input;
  // Bounds need no normals. What a user interface asks for before anything is executed must not fail,
  // or nobody could be asked there whether to estimate them.
  options.estimateNormals = true;
  const winding::Bounds& found = this->Source->bounds(source, options);
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = found.min()[axis];
    bounds[2 * axis + 1] = found.max()[axis];
  }
  return !found.isEmpty();
}

winding::ResultArrays vtkWindingNumberAlgorithm::MakeResults(vtkIdType samples) const
{
  return {samples, this->GetResultOptions()};
}

winding::InsideRule vtkWindingNumberAlgorithm::GetCoreInsideRule() const
{
  switch (this->InsideRule)
  {
  case ABSOLUTE:
    return winding::InsideRule::absoluteThreshold;
  case ODD:
    return winding::InsideRule::odd;
  default:
    return winding::InsideRule::signedThreshold;
  }
}

winding::FieldOutput vtkWindingNumberAlgorithm::OutputTo(const winding::ResultArrays& results) const
{
  winding::FieldOutput output = results.output(this->GetCoreInsideRule(), this->WindingThreshold);
  output.distanceLimit = this->GetDistanceLimit();
  return output;
}

void vtkWindingNumberAlgorithm::AddResults(
  const winding::ResultArrays& results, vtkDataSet* output, vtkDataSetAttributes* attributes) const
{
  results.addTo(attributes);
  this->DescribeMethod(output);
}

void vtkWindingNumberAlgorithm::DescribeMethod(vtkDataObject* output) const
{
  const auto note = [output](const char* name, const char* text)
  {
    vtkNew<vtkStringArray> array;
    array->SetName(name);
    array->InsertNextValue(text);
    output->GetFieldData()->AddArray(array);
  };
  note("WindingNumberMethod", this->GetMethodUsed());
  note("WindingNumberMethodReason", this->GetMethodReason());
}

bool vtkWindingNumberAlgorithm::Evaluate(
  const std::function<bool(winding::SmpExecutor&)>& evaluation)
{
  const Clock::time_point start = Clock::now();
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  bool complete = false;
  try
  {
    complete = evaluation(executor);
  }
  catch (const winding::Interrupted&)
  {
    // It is not complete.
  }
  this->EvaluateSeconds = secondsSince(start);
  this->Status = complete ? DONE : ABORTED;
  return complete;
}

void vtkWindingNumberAlgorithm::LookForInsideOut(const std::function<bool()>& isInsideOut)
{
  this->SourceIsInsideOut = this->InsideRule == SIGNED && isInsideOut();
  if (this->SourceIsInsideOut)
  {
    vtkWarningMacro(<< winding::insideOutAdvice(this->GetSourceIsSurface() ? "faces" : "normals"));
  }
}

const winding::FieldInfo& vtkWindingNumberAlgorithm::GetSourceInfo() const
{
  return this->Source->info();
}

const char* vtkWindingNumberAlgorithm::GetMethodUsed() const
{
  return winding::nameOf(this->GetSourceInfo().method);
}

const char* vtkWindingNumberAlgorithm::GetMethodReason() const
{
  return this->GetSourceInfo().why.c_str();
}

bool vtkWindingNumberAlgorithm::GetSourceIsSurface() const
{
  return this->GetSourceInfo().isSurface;
}

vtkIdType vtkWindingNumberAlgorithm::GetNumberOfPrimitives() const
{
  return static_cast<vtkIdType>(this->GetSourceInfo().primitives);
}

vtkIdType vtkWindingNumberAlgorithm::GetNumberOfDroppedPrimitives() const
{
  return static_cast<vtkIdType>(this->GetSourceInfo().dropped);
}

vtkIdType vtkWindingNumberAlgorithm::GetNumberOfWeldedVertices() const
{
  return static_cast<vtkIdType>(this->GetSourceInfo().weldedVertices);
}

vtkIdType vtkWindingNumberAlgorithm::GetNumberOfBoundaryEdges() const
{
  return static_cast<vtkIdType>(this->GetSourceInfo().boundaryEdges);
}

vtkIdType vtkWindingNumberAlgorithm::GetNumberOfNetBoundaryEdges() const
{
  return static_cast<vtkIdType>(this->GetSourceInfo().netBoundaryEdges);
}

double vtkWindingNumberAlgorithm::GetMeanPointArea() const
{
  return this->GetSourceInfo().pointArea;
}

bool vtkWindingNumberAlgorithm::GetNormalsWereEstimated() const
{
  return this->GetSourceInfo().normalsAreEstimated;
}

double vtkWindingNumberAlgorithm::GetClearShare() const
{
  return this->GetSourceInfo().orientation.outward;
}

vtkIdType vtkWindingNumberAlgorithm::GetNumberOfCapTriangles() const
{
  return static_cast<vtkIdType>(this->GetSourceInfo().capTriangles);
}

void vtkWindingNumberAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  winding::printSourceProperties(*this, os, indent);
  os << indent << "WindingThreshold: " << this->WindingThreshold << "\n";
  os << indent << "InsideRule: " << this->InsideRule << "\n";
  os << indent << "GenerateWindingNumber: " << this->GenerateWindingNumber << "\n";
  os << indent << "GenerateInside: " << this->GenerateInside << "\n";
  os << indent << "GenerateSignedDistance: " << this->GenerateSignedDistance << "\n";
  os << indent << "ResultArrayName: " << winding::textOf(this->ResultArrayName) << "\n";
  os << indent << "OutputScalarType: " << this->OutputScalarType << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "SourceKind: " << this->SourceKind << "\n";
  os << indent << "Status: " << this->Status << "\n";
  os << indent << "SourceIsInsideOut: " << this->SourceIsInsideOut << "\n";
  os << indent << "MethodUsed: " << this->GetMethodUsed() << "\n";
  os << indent << "MethodReason: " << this->GetMethodReason() << "\n";
  os << indent << "MeanPointArea: " << this->GetMeanPointArea() << "\n";
  os << indent << "ClearShare: " << this->GetClearShare() << "\n";
  os << indent << "PrepareSeconds: " << this->PrepareSeconds << "\n";
  os << indent << "EvaluateSeconds: " << this->EvaluateSeconds << "\n";
  os << indent << "ExpectedSeconds: " << this->ExpectedSeconds << "\n";
  os << indent << "ExpectedMemory: " << this->ExpectedMemory << "\n";
}
