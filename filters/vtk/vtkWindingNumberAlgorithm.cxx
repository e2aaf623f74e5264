// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindingNumberAlgorithm.h"

#include "base/Bounds.h"
#include "base/Refusal.h"
#include "base/Stopwatch.h"
#include "diagnosis/Diagnosis.h"
#include "messages/Options.h"
#include "messages/PropertyChecks.h"
#include "pipeline/ErrorReports.h"
#include "pipeline/FreeMemory.h"
#include "pipeline/HostShare.h"
#include "pipeline/Ranks.h"
#include "pipeline/SmpExecutor.h"
#include "private/source/ContentHash.h"
#include "private/source/SourceField.h"
#include "private/source/SourceParts.h"
#include "private/source/SourceProperties.h"
#include "private/source/SourceUnits.h"
#include "report/ExpectedTimeAdvice.h"
#include "report/InputUnits.h"
#include "source/Grid.h"
#include "tasks/ResultNotes.h"

#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace
{

int kindOf(vtkDataObject* source)
{
  switch (winding::kindOf(source))
  {
  case winding::SourceKind::mesh:
    return vtkWindingNumberAlgorithm::MESH_SOURCE;
  case winding::SourceKind::cloud:
    return vtkWindingNumberAlgorithm::CLOUD_SOURCE;
  case winding::SourceKind::nothing:
    break;
  }
  return vtkWindingNumberAlgorithm::NO_SOURCE;
}

/// The share of progress that estimated normals take. They may take longer than all else, or,
/// for many samples, little.
constexpr double progressOfNormals = 0.5;

/// Keeps the shift and scale of a filter's progress, which an execution may change, as it was.
class KeptProgress
{
public:
  explicit KeptProgress(vtkAlgorithm* filter)
    : filter_(filter)
    , shift_(filter->GetProgressShift())
    , scale_(filter->GetProgressScale())
  {
  }
  ~KeptProgress() { filter_->SetProgressShiftScale(shift_, scale_); }
  KeptProgress(const KeptProgress&) = delete;
  KeptProgress& operator=(const KeptProgress&) = delete;

private:
  vtkAlgorithm* filter_;
  double shift_, scale_;
};

// The choices of properties become choices of helpers and of the core by their numbers.
using winding::isNumber;
using Filter = vtkWindingNumberAlgorithm;
static_assert(isNumber(winding::Outcome::done, Filter::DONE));
static_assert(isNumber(winding::Outcome::refused, Filter::REFUSED));
static_assert(isNumber(winding::Outcome::outOfMemory, Filter::OUT_OF_MEMORY));
static_assert(isNumber(winding::Outcome::interrupted, Filter::ABORTED));
static_assert(isNumber(winding::Method::automatic, Filter::AUTOMATIC));
static_assert(isNumber(winding::Method::rows, Filter::ROWS));
static_assert(isNumber(winding::Method::hierarchical, Filter::HIERARCHICAL));
static_assert(isNumber(winding::Method::direct, Filter::DIRECT));
static_assert(isNumber(winding::Method::parity, Filter::PARITY));
static_assert(isNumber(winding::InsideRule::signedThreshold, Filter::SIGNED));
static_assert(isNumber(winding::InsideRule::absoluteThreshold, Filter::ABSOLUTE));
static_assert(isNumber(winding::InsideRule::odd, Filter::ODD));
static_assert(isNumber(winding::PointAreasFrom::voronoi, Filter::VORONOI));
static_assert(isNumber(winding::PointAreasFrom::mesh, Filter::MESH));
static_assert(isNumber(winding::PointAreasFrom::constant, Filter::CONSTANT));
static_assert(isNumber(winding::PointAreasFrom::array, Filter::ARRAY));
static_assert(isNumber(winding::NormalEstimation::automatic, Filter::ESTIMATION_AUTOMATIC));
static_assert(isNumber(winding::NormalEstimation::spanningTree, Filter::SPANNING_TREE));
static_assert(isNumber(winding::NormalEstimation::consistent, Filter::WINDING_CONSISTENT));
static_assert(isNumber(winding::SourceDistribution::automatic, Filter::DISTRIBUTION_AUTOMATIC));
static_assert(isNumber(winding::SourceDistribution::distributed, Filter::DISTRIBUTED));
static_assert(isNumber(winding::SourceDistribution::replicated, Filter::REPLICATED));

} // namespace

vtkWindingNumberAlgorithm::vtkWindingNumberAlgorithm()
  : Frame(std::make_unique<winding::ImageFrame>())
  , Controller(vtkMultiProcessController::GetGlobalController())
  , Ranks(std::make_unique<winding::Ranks>(nullptr))
{
  this->ChooseSource(0, "");
  this->SetAreaArray("Area");
}

vtkWindingNumberAlgorithm::~vtkWindingNumberAlgorithm()
{
  this->SetNormalsArray(nullptr);
  this->SetToward(nullptr);
  this->SetMirror(nullptr);
  this->SetFlatBase(nullptr);
  this->SetSheetSide(nullptr);
  this->SetAreaArray(nullptr);
}

void vtkWindingNumberAlgorithm::SetController(vtkMultiProcessController* controller)
{
  if (controller != this->Controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkWindingNumberAlgorithm::GetController() const
{
  return this->Controller;
}

std::string vtkWindingNumberAlgorithm::GetUnitAdvice(vtkMultiBlockDataSet* inputs)
{
  std::vector<winding::NamedBounds> compared;
  for (unsigned int i = 0; inputs && i < inputs->GetNumberOfBlocks(); ++i)
  {
    const char* name =
      inputs->HasMetaData(i) ? inputs->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()) : nullptr;
    compared.push_back(
      {name ? name : std::to_string(i + 1), winding::pointBoundsOf(inputs->GetBlock(i))});
  }
  const auto advice = winding::unitAdvice(compared);
  return advice ? winding::lineOf(*advice) : "";
}

bool vtkWindingNumberAlgorithm::IsHelper() const
{
  return this->WorksOnFirstRank() && this->Ranks->rank() > 0;
}

void vtkWindingNumberAlgorithm::RequestSource(vtkInformation* source) const
{
  winding::requestPart(source, winding::Ranks(this->Controller),
    winding::sourceDistribution(this->SourceDistribution));
}

vtkTypeBool vtkWindingNumberAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  int (vtkWindingNumberAlgorithm::*answer)(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) = nullptr;
  bool isTogether = false;
  const bool wantsData = request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()) != 0;
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    answer = &vtkWindingNumberAlgorithm::RequestDataObject;
  }
  else if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    answer = &vtkWindingNumberAlgorithm::RequestInformation;
    isTogether = this->InformationNeedsSource();
  }
  else if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
  {
    answer = &vtkWindingNumberAlgorithm::RequestUpdateExtent;
  }
  else if (wantsData)
  {
    answer = &vtkWindingNumberAlgorithm::RequestData;
    isTogether = true;
  }
  else
  {
    return this->Superclass::ProcessRequest(request, inputs, outputs);
  }

  const bool isAboutInformation = answer == &vtkWindingNumberAlgorithm::RequestInformation;
  if (wantsData && this->InformationStatus != DONE)
  {
    answer = &vtkWindingNumberAlgorithm::RepeatRefusal;
  }
  const KeptProgress kept(this);
  int isAnswered = 1;
  const winding::Outcome outcome = winding::reportErrors(
    this, this->NamesInMessages,
    {"not enough memory for this source and grid", {winding::largerVoxels(), winding::inPieces()}},
    [&]()
    {
      *this->Ranks = winding::Ranks(isTogether ? this->Controller.Get() : nullptr);
      this->Ranks->barrier();
      this->Ranks->agree([&] { isAnswered = (this->*answer)(request, inputs, outputs); });
    },
    [&]() { return this->IsNewError(); });
  this->Status = static_cast<int>(outcome);
  if (isAboutInformation)
  {
    this->InformationStatus = this->Status;
  }
  else if (wantsData && this->InformationStatus != DONE)
  {
    this->Status = this->InformationStatus;
  }
  this->ErrorCode = winding::errorCodeOf(static_cast<winding::Outcome>(this->Status));
  if (this->Status == DONE && wantsData)
  {
    this->TimeOfLastError = 0;
  }
  else if (this->Status == DONE)
  {
    this->Status = NOT_RUN; // until there is data, which a filter upstream may fail to give
  }
  else
  {
    if (wantsData)
    {
      for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
      {
        vtkDataObject::GetData(outputs, port)->Initialize();
      }
    }
    // The pipeline would add an extent that failed to the next one that is asked for.
    outputs->GetInformationObject(0)->Remove(
      vtkStreamingDemandDrivenPipeline::COMBINED_UPDATE_EXTENT());
  }
  return isAnswered;
}

/// The answer to requests for data where that for information was refused: the same once more, for
/// other ranks to hear of, which is not reported again.
int vtkWindingNumberAlgorithm::RepeatRefusal(
  vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  if (this->InformationStatus == ABORTED)
  {
    throw winding::Interrupted();
  }
  throw winding::Refusal("look at the error before this one first: there is no grid");
}

bool vtkWindingNumberAlgorithm::IsNewError()
{
  // The time of the pipeline, and not the input's: sources run again for another piece.
  auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(this->GetExecutive());
  const vtkMTimeType time = pipeline ? pipeline->GetPipelineMTime() : this->GetMTime();
  return std::exchange(this->TimeOfLastError, time) != time;
}

int vtkWindingNumberAlgorithm::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1;
}

void vtkWindingNumberAlgorithm::CheckProperties()
{
  winding::checkSourceProperties(*this);
  winding::checkProperty(winding::Parameter::windingThreshold, this->WindingThreshold);
  winding::coreInsideRule(this->InsideRule);
  winding::checkProperty(winding::Parameter::numberOfThreads, this->NumberOfThreads);
  winding::checkProperty(winding::Parameter::longestExpectedTime, this->LongestExpectedTime);
  winding::sourceDistribution(this->SourceDistribution);
}

void vtkWindingNumberAlgorithm::HashProperties(winding::ContentHash& hash)
{
  hash.addValue(winding::hashOf(this->GetSourceOptions()));
  hash.addValue(this->WindingThreshold);
  hash.addValue(this->InsideRule);
}

void vtkWindingNumberAlgorithm::AgreeOnProperties()
{
  this->Ranks->requireSame(
    [this]
    {
      this->CheckProperties();
      winding::ContentHash hash;
      this->HashProperties(hash);
      return hash.value();
    });
}

void vtkWindingNumberAlgorithm::FillSourcePortInformation(vtkInformation* info)
{
  // Images and the like are refused by InputViews, in words that say what to do.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
}

winding::SourceOptions vtkWindingNumberAlgorithm::GetSourceOptions()
{
  winding::SourceOptions options = winding::sourceOptions(*this, !this->EvaluatesGrid());
  options.field.isOneOfSeveral = this->HasSeveralSources();
  options.field.mendsSource = this->MendsSource();
  options.input.estimateNormals |= this->MendsSource();
  options.frame = *this->Frame;
  options.distribution = winding::sourceDistribution(this->SourceDistribution);
  return options;
}

template <class Samples>
const winding::Field& vtkWindingNumberAlgorithm::PrepareField(
  vtkDataObject* source, const Samples& samples, std::size_t ownSamples)
{
  this->SourceIsInsideOut = false;
  this->PrepareSeconds = 0;
  this->InspectSource(source);
  this->SetProgressText("Preparing");
  winding::Clock::time_point start = winding::Clock::now();
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  executor.setShare(0, progressOfNormals);
  const winding::Field& field = this->FieldOf(source, executor);
  if (this->IsHelper())
  {
    return field;
  }
  if (this->Source->wasBuilt() && field.info().normalsAreEstimated)
  {
    // Progress goes on from there with all that follows, and ends where it would have ended.
    const double shift = this->GetProgressShift(), scale = this->GetProgressScale();
    this->SetProgressShiftScale(shift + scale * progressOfNormals, scale * (1 - progressOfNormals));
  }
  // Looking whether the source is the last one is not preparing.
  start = this->Source->wasBuilt() ? start : winding::Clock::now();
  this->SamplesOfResult = ownSamples;
  this->ExpectMemory(field, static_cast<vtkIdType>(ownSamples));
  field.prepare(samples, executor);
  if (this->WantsDistances())
  {
    field.prepareDistances(executor);
  }
  this->PrepareSeconds = executor.hasRun() ? winding::secondsSince(start) : 0;
  this->SetProgressText("Evaluating");
  this->WarnOfFaults(field);
  return field;
}

template const winding::Field& vtkWindingNumberAlgorithm::PrepareField(
  vtkDataObject*, const winding::Grid&, std::size_t);
template const winding::Field& vtkWindingNumberAlgorithm::PrepareField(
  vtkDataObject*, const winding::VectorsView&, std::size_t);

const winding::Field& vtkWindingNumberAlgorithm::FieldOf(
  vtkDataObject* source, winding::Executor& executor)
{
  return this->Source->prepare(
    source, this->GetSourceOptions(), executor, *this->Ranks, this->WorksOnFirstRank());
}

void vtkWindingNumberAlgorithm::ChooseSource(std::size_t number, const std::string& name)
{
  while (this->Sources.size() <= number)
  {
    this->Sources.push_back(std::make_unique<winding::SourceField>());
  }
  this->Source = this->Sources[number].get();
  this->SourceName = name;
}

std::string vtkWindingNumberAlgorithm::GetSourcePrefix() const
{
  return this->SourceName.empty() ? "" : "'" + this->SourceName + "': ";
}

winding::Run vtkWindingNumberAlgorithm::MakeRun(winding::Executor& executor)
{
  return {executor,
    [this](const winding::Message& message)
    { vtkWarningMacro(<< this->GetSourcePrefix() << winding::lineOf(message)); },
    []
    {
      return winding::freeBytes();
    }};
}

winding::InsideTest vtkWindingNumberAlgorithm::GetInsideTest() const
{
  return {winding::coreInsideRule(this->InsideRule), this->WindingThreshold};
}

void vtkWindingNumberAlgorithm::WarnOfFaults(const winding::Field& field)
{
  const winding::FieldInfo& info = this->Source->info();
  if (!info.warnings.empty())
  {
    vtkWarningMacro(<< this->GetSourcePrefix() << winding::lineOf(info.warnings));
  }
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  winding::Run run = this->MakeRun(executor);
  if (this->WarnsOfOpenSide() && !this->MendsSource())
  {
    winding::warnOfOpenSide(field, {this->WindingThreshold, this->TakesTouchedVoxels()}, run);
  }
  if (info.primitives == 0)
  {
    run.warn(winding::emptySourceAdvice(this->WeldTolerance > 0));
  }
}

void vtkWindingNumberAlgorithm::ExpectMemory(const winding::Field& field, vtkIdType samples)
{
  const auto count = static_cast<std::size_t>(samples);
  std::size_t bytes = field.expectedBytes(count) + this->GetAdditionalBytes(field, samples);
  if (this->WantsDistances())
  {
    bytes += field.expectedBytesOfDistances(count);
  }
  this->ExpectedMemory =
    static_cast<vtkIdType>(static_cast<double>(bytes) + this->GetResultBytes(samples));
}

std::size_t vtkWindingNumberAlgorithm::GetAdditionalBytes(const winding::Field&, vtkIdType)
{
  return 0;
}

void vtkWindingNumberAlgorithm::Evaluate(const winding::Field& field, vtkIdType samples,
  winding::SmpExecutor& executor, const std::function<void()>& work)
{
  const double before = this->EarlierSeconds + this->PrepareSeconds;
  const double pieces =
    samples > 0 ? static_cast<double>(this->SamplesOfResult) / static_cast<double>(samples) : 0;
  const double limit = this->LongestExpectedTime;
  this->LongTimeIsAnnounced = this->LongTimeIsAnnounced && this->EarlierSeconds > 0;
  this->ExpectedSeconds = this->LongestOfRanks(before);
  if (limit > 0 && this->ExpectedSeconds > limit)
  {
    this->CheckExpectedTime(field);
  }
  double nextLook = limit > 0 ? std::min(limit, 1.0) : 1;
  int looks = 0;
  // Returns whether any rank is at work. Those that are done, and expect 0, look with the others.
  const auto look = [&](double expected)
  {
    ++looks;
    const double seconds = this->LongestOfRanks(expected);
    if (seconds > 0)
    {
      this->ExpectedSeconds = seconds;
      this->CheckExpectedTime(field);
    }
    return seconds > 0;
  };
  constexpr double least = 1e-6; // 0 stands for a rank that is done
  const auto lookAtWork = [&](double elapsed, double expected)
  {
    if (elapsed >= nextLook)
    {
      nextLook = 2 * elapsed;
      look(std::max(before + expected * pieces * this->RunsLeft, least));
    }
  };
  {
    const winding::Stopwatch stopwatch(this->EvaluateSeconds);
    executor.runByClock(work, lookAtWork);
  }
  while (look(0))
  {
  }
  this->TakenSeconds = before + this->EvaluateSeconds * pieces;
  if (looks == 1)
  {
    this->ExpectedSeconds = this->TakenSeconds;
  }
}

/// Returns the largest of the seconds that ranks which evaluate together give.
double vtkWindingNumberAlgorithm::LongestOfRanks(double seconds)
{
  if (this->WorksOnFirstRank())
  {
    return seconds;
  }
  constexpr double perSecond = 1e6, most = 1e18; // ranks gather integers, 0 for no seconds only
  const auto number =
    static_cast<winding::Ranks::Number>(std::ceil(std::min(seconds * perSecond, most)));
  const auto numbers = this->Ranks->allGather([number] { return number; });
  return static_cast<double>(*std::max_element(numbers.begin(), numbers.end())) / perSecond;
}

/// Refuses what is expected to take longer than LongestExpectedTime. Warns once of more than a
/// minute.
void vtkWindingNumberAlgorithm::CheckExpectedTime(const winding::Field& field)
{
  const auto advice = winding::expectedTimeAdvice(
    field.info(), {this->ExpectedSeconds, this->LongestExpectedTime, this->SamplesOfResult});
  if (advice && !this->LongTimeIsAnnounced)
  {
    this->LongTimeIsAnnounced = true;
    vtkWarningMacro(<< this->GetSourcePrefix() << winding::lineOf(*advice));
  }
}

double vtkWindingNumberAlgorithm::GetDistanceLimit() const
{
  return std::numeric_limits<double>::infinity();
}

void vtkWindingNumberAlgorithm::InspectSource(vtkDataObject* source)
{
  this->SourceKind = kindOf(source);
}

bool vtkWindingNumberAlgorithm::GetSourceBounds(vtkDataObject* source, double bounds[6])
{
  winding::SourceOptions options = this->GetSourceOptions();
  // Bounds need no normals. What a user interface asks for before anything is executed must not
  // fail, or nobody could be asked there whether to estimate them.
  options.input.estimateNormals = true;
  // Nothing is to interrupt what happens before anything is executed.
  winding::SmpExecutor executor(nullptr, this->NumberOfThreads);
  const winding::Bounds found = this->Source->bounds(source, options, executor, *this->Ranks);
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = found.min()[axis];
    bounds[2 * axis + 1] = found.max()[axis];
  }
  return !found.isEmpty();
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
  if (this->GetNormalsWereEstimated())
  {
    note("WindingNumberNormalEstimation", this->GetNormalEstimationUsed());
    vtkNew<vtkDoubleArray> share;
    share->SetName("WindingNumberClearShare");
    share->InsertNextValue(this->GetClearShare());
    output->GetFieldData()->AddArray(share);
  }
}

const char* vtkWindingNumberAlgorithm::GetExpectedMemoryInWords()
{
  this->ExpectedMemoryInWords = winding::memoryInWords(static_cast<double>(this->ExpectedMemory));
  return this->ExpectedMemoryInWords.c_str();
}

int vtkWindingNumberAlgorithm::GetRanksOnHost()
{
  return winding::ranksOnHost();
}

const winding::FieldInfo& vtkWindingNumberAlgorithm::GetSourceInfo() const
{
  return this->Source->info();
}

const char* vtkWindingNumberAlgorithm::GetMethodUsed() const
{
  const winding::FieldInfo& info = this->GetSourceInfo();
  return info.why.empty() ? "" : winding::nameOf(info.method);
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

const char* vtkWindingNumberAlgorithm::GetNormalEstimationUsed() const
{
  const winding::FieldInfo& info = this->GetSourceInfo();
  return info.normalsAreEstimated ? winding::nameOf(info.normalEstimation) : "";
}

double vtkWindingNumberAlgorithm::GetClearShare() const
{
  return this->GetSourceInfo().orientation.outward;
}

vtkIdType vtkWindingNumberAlgorithm::GetNumberOfCapTriangles() const
{
  return static_cast<vtkIdType>(this->GetSourceInfo().capTriangles);
}

const char* vtkWindingNumberAlgorithm::GetMethodAsString() const
{
  return winding::nameOfChoice(winding::Parameter::method, this->Method);
}

const char* vtkWindingNumberAlgorithm::GetSourceDistributionAsString() const
{
  return winding::nameOfChoice(winding::Parameter::sourceDistribution, this->SourceDistribution);
}

const char* vtkWindingNumberAlgorithm::GetNormalEstimationAsString() const
{
  return winding::nameOfChoice(winding::Parameter::normalEstimation, this->NormalEstimation);
}

const char* vtkWindingNumberAlgorithm::GetPointAreaMethodAsString() const
{
  return winding::nameOfChoice(winding::Parameter::pointAreaMethod, this->PointAreaMethod);
}

const char* vtkWindingNumberAlgorithm::GetInsideRuleAsString() const
{
  return winding::nameOfChoice(winding::Parameter::insideRule, this->InsideRule);
}

void vtkWindingNumberAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NamesInMessages: " << this->NamesInMessages << "\n";
  winding::printSourceProperties(*this, os, indent);
  os << indent << "WindingThreshold: " << this->WindingThreshold << "\n";
  os << indent << "InsideRule: " << this->InsideRule << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "LongestExpectedTime: " << this->LongestExpectedTime << "\n";
  os << indent << "Controller: " << this->Controller.Get() << "\n";
  os << indent << "SourceDistribution: " << this->SourceDistribution << "\n";
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
