// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindingNumberProbeAlgorithm.h"

#include "base/Executor.h"
#include "base/Refusal.h"
#include "base/Views.h"
#include "diagnosis/Diagnosis.h"
#include "field/Field.h"
#include "messages/Options.h"
#include "pipeline/Ranks.h"
#include "pipeline/SmpExecutor.h"
#include "private/output/ResultArrays.h"
#include "private/probe/ProbeQueries.h"
#include "private/probe/ProbeWords.h"
#include "private/source/ContentHash.h"
#include "private/source/SourceProperties.h"
#include "tasks/ResultNotes.h"
#include "tasks/Sentences.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkDataObjectTree.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <cstring>

namespace
{

/// Samples that are NaN or infinite are nowhere, and stay outside.
void turnInsideOut(const winding::ProbeQueries& queries, unsigned char* inside)
{
  const auto count = static_cast<std::size_t>(queries.size());
  for (std::size_t i = 0; i < count; ++i)
  {
    inside[i] = !inside[i] && (queries.grid() || queries.position(i).allFinite());
  }
}

} // namespace

vtkWindingNumberProbeAlgorithm::vtkWindingNumberProbeAlgorithm()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(1);
}

void vtkWindingNumberProbeAlgorithm::SetSourceConnection(vtkAlgorithmOutput* source)
{
  this->SetInputConnection(1, source);
}

void vtkWindingNumberProbeAlgorithm::SetSourceData(vtkDataObject* source)
{
  this->SetInputDataObject(1, source);
}

vtkDataSet* vtkWindingNumberProbeAlgorithm::GetOutput()
{
  return vtkDataSet::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkWindingNumberProbeAlgorithm::IsInside(vtkIdType queryId)
{
  const bool isThere =
    this->InsideFlags && queryId >= 0 && queryId < this->InsideFlags->GetNumberOfTuples();
  return isThere && this->InsideFlags->GetValue(queryId) != 0;
}

int vtkWindingNumberProbeAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  }
  else
  {
    FillSourcePortInformation(info);
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // so that RequestData() says what is missing
  }
  return 1;
}

int vtkWindingNumberProbeAlgorithm::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

vtkSmartPointer<vtkDataObject> vtkWindingNumberProbeAlgorithm::NewOutput(vtkDataObject* input) const
{
  return vtkSmartPointer<vtkDataObject>::Take(input->NewInstance());
}

int vtkWindingNumberProbeAlgorithm::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* queries = vtkDataObject::GetData(inputs[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputs);
  if (!queries)
  {
    return 1;
  }
  const vtkSmartPointer<vtkDataObject> fresh = this->NewOutput(queries);
  if (!output || std::strcmp(output->GetClassName(), fresh->GetClassName()) != 0)
  {
    outputs->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), fresh);
  }
  return 1;
}

int vtkWindingNumberProbeAlgorithm::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  this->QueriesRefused = false;
  this->InspectSource(vtkDataObject::GetData(inputs[1]));
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  // Without time steps in its information the pipeline would ask a moving source once only.
  for (vtkInformationVector* input : {inputs[1], inputs[0]})
  {
    vtkInformation* info = input->GetInformationObject(0);
    if (info && (info->Has(Pipeline::TIME_STEPS()) || info->Has(Pipeline::TIME_RANGE())))
    {
      outInfo->CopyEntry(info, Pipeline::TIME_STEPS());
      outInfo->CopyEntry(info, Pipeline::TIME_RANGE());
      break;
    }
  }
  return 1;
}

int vtkWindingNumberProbeAlgorithm::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  if (vtkInformation* source = inputs[1]->GetInformationObject(0))
  {
    this->RequestSource(source);
  }
  return 1;
}

void vtkWindingNumberProbeAlgorithm::HashProperties(winding::ContentHash& hash)
{
  this->Superclass::HashProperties(hash);
  winding::addTo(hash, this->GetResultOptions());
  hash.addValue(this->SamplesCells());
  hash.addValue(this->InsideOut);
  hash.addValue(this->KeepsPart());
}

double vtkWindingNumberProbeAlgorithm::GetResultBytes(vtkIdType samples) const
{
  return winding::bytesOf(this->GetResultOptions(), samples);
}

int vtkWindingNumberProbeAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputs);
  this->InsideFlags = nullptr;
  if (this->GetNumberOfInputConnections(1) == 0)
  {
    throw winding::Refusal(winding::messageOf(winding::Sentence::noSource));
  }
  this->AgreeOnProperties();

  winding::ResultOptions options = this->GetResultOptions();
  options.remedies = this->GetWords().remedies;
  if (!options.withInside)
  {
    // Made in any case, for IsInside(), but kept out of the output, where no name counts.
    options.insideName.clear();
    options.withInside = options.withValues || options.withDistances || this->UsesCells();
  }
  this->QueriesRefused = true; // unless the next line comes to its end
  const winding::ProbeQueries queries(
    input, this->SamplesCells(), this->UsesCells(), this->GetWords());
  this->QueriesRefused = false;
  this->QueriesAreGrid = queries.grid().has_value();
  *this->Frame = queries.frame();
  const winding::ResultArrays results(queries.size(), options);
  vtkDataObject* source = vtkDataObject::GetData(inputs[1]);
  const auto count = static_cast<std::size_t>(queries.size());
  const winding::Field& field = queries.grid()
                                  ? this->PrepareField(source, *queries.grid(), count)
                                  : this->PrepareField(source, queries.samples(), count);
  this->WarnOfNotFinite(queries);
  this->EvaluateSamples(field, queries, results);
  this->WarnOfOutside(field, queries, results);
  if (this->InsideOut)
  {
    turnInsideOut(queries, results.inside()->GetPointer(0));
  }
  this->InsideFlags = results.inside();
  this->FinishSamples(field, queries, results.inside()->GetPointer(0));
  if (this->KeepsPart() &&
      this->GetRanks().allOf([&] { return queries.size() == 0 || results.countInside() == 0; }) &&
      queries.size() > 0)
  {
    this->WarnOfEmpty();
  }
  this->WriteOutput(input, queries, results, output);
  return 1;
}

void vtkWindingNumberProbeAlgorithm::EvaluateSamples(const winding::Field& field,
  const winding::ProbeQueries& queries, const winding::ResultArrays& results)
{
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  const double progress = this->GetProgressOfSamples();
  executor.setShare(0, progress);
  winding::FieldOutput output = results.output(this->GetInsideTest());
  winding::SideTally sides;
  output.sides = &sides;
  const std::optional<winding::Grid>& grid = queries.grid();
  this->Evaluate(field, queries.size(), executor,
    [&]
    {
      if (grid)
      {
        field.evaluate(*grid, grid->wholeExtent(), output, executor);
      }
      else
      {
        field.evaluate(queries.samples(), output, executor);
      }
      this->EvaluateMore(field, queries, executor);
      executor.setShare(progress, progress);
      winding::Run run = this->MakeRun(executor);
      const winding::SideCounts counts = sides.counts(static_cast<std::size_t>(queries.size()));
      this->SourceIsInsideOut =
        winding::warnOfSides(field, counts, this->GetInsideTest(), run).isInsideOut;
    });
}

/// Warns of samples that are nowhere.
void vtkWindingNumberProbeAlgorithm::WarnOfNotFinite(const winding::ProbeQueries& queries)
{
  vtkIdType count = 0;
  for (vtkIdType i = 0; !queries.grid() && i < queries.size(); ++i)
  {
    count += queries.position(static_cast<std::size_t>(i)).allFinite() ? 0 : 1;
  }
  if (count > 0)
  {
    vtkWarningMacro(<< winding::lineOf(winding::messageOf(winding::Sentence::queriesNotFinite,
                      {std::to_string(count), std::to_string(queries.size())})));
  }
}

/// Warns where none of many samples is inside of an open source, though they lie within its bounds.
void vtkWindingNumberProbeAlgorithm::WarnOfOutside(const winding::Field& field,
  const winding::ProbeQueries& queries, const winding::ResultArrays& results)
{
  constexpr std::size_t many = 100;
  std::size_t within = 0;
  const winding::FieldInfo& info = field.info();
  const bool isClosed = info.isSurface && info.netBoundaryEdges == 0;
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  executor.setShare(1, 1);
  const bool isQuiet = isClosed || this->KeepsPart() || this->SourceIsInsideOut ||
                       info.openings.areWide() || results.countInside() != 0 ||
                       field.diagnosis().hasNoSides(executor);
  const auto count = static_cast<std::size_t>(isQuiet ? 0 : queries.size());
  for (std::size_t i = 0; i < count && within < many; ++i)
  {
    within += info.bounds.contains(queries.position(i));
  }
  if (within == many && this->GetRanks().isAlone())
  {
    vtkWarningMacro(<< winding::lineOf(
                      winding::messageOf(this->GetInsideTest().hasHighThreshold()
                                           ? winding::Sentence::noSampleIsAboveThreshold
                                           : winding::Sentence::noSampleIsInside)));
  }
}

/// Warns of an empty result. A source without primitives, or inside out, has been warned of before.
void vtkWindingNumberProbeAlgorithm::WarnOfEmpty()
{
  if (!this->SourceIsInsideOut && this->GetNumberOfPrimitives() > 0)
  {
    const std::string sample = this->SamplesCells() ? "cell center" : "point";
    vtkWarningMacro(<< winding::lineOf(winding::messageOf(winding::Sentence::emptyPart,
                      {sample, this->InsideOut ? "outside" : "inside"})));
  }
}

void vtkWindingNumberProbeAlgorithm::EvaluateMore(
  const winding::Field&, const winding::ProbeQueries&, winding::SmpExecutor&)
{
}

void vtkWindingNumberProbeAlgorithm::AddLeafArrays(vtkDataSet*, const winding::ProbeLeaf&) const {}

void vtkWindingNumberProbeAlgorithm::FinishSamples(
  const winding::Field&, const winding::ProbeQueries&, const unsigned char*)
{
}

void vtkWindingNumberProbeAlgorithm::AddArrays(
  const winding::ResultArrays&, vtkDataSetAttributes*) const
{
}

vtkSmartPointer<vtkDataSet> vtkWindingNumberProbeAlgorithm::AnswerTo(
  const winding::ProbeQueries& queries, const winding::ProbeLeaf& leaf, vtkDataSetAttributes* ofAll)
{
  auto answer = vtkSmartPointer<vtkDataSet>::Take(leaf.data->NewInstance());
  answer->ShallowCopy(leaf.data);
  vtkDataSetAttributes* attributes = answer->GetPointData();
  if (this->SamplesCells())
  {
    attributes = answer->GetCellData();
  }
  queries.addPart(leaf, ofAll, attributes);
  this->AddLeafArrays(answer, leaf);
  if (this->KeepsPart())
  {
    answer = this->PartOf(answer, leaf, this->InsideFlags->GetPointer(0) + leaf.first);
  }
  this->DescribeMethod(answer);
  return answer;
}

void vtkWindingNumberProbeAlgorithm::WriteOutput(vtkDataObject* input,
  const winding::ProbeQueries& queries, const winding::ResultArrays& results, vtkDataObject* output)
{
  vtkNew<vtkPointData> ofAll;
  this->AddArrays(results, ofAll);
  auto* tree = vtkDataObjectTree::SafeDownCast(input);
  if (!tree)
  {
    output->ShallowCopy(this->AnswerTo(queries, queries.leaves().front(), ofAll));
    return;
  }
  auto* outputTree = vtkDataObjectTree::SafeDownCast(output);
  outputTree->CopyStructure(tree);
  outputTree->GetFieldData()->PassData(tree->GetFieldData());
  auto leaf = queries.leaves().begin();
  auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(tree->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkDataObject* data = iterator->GetCurrentDataObject();
    const bool isProbed = vtkDataSet::SafeDownCast(data) != nullptr;
    outputTree->SetDataSet(
      iterator, isProbed ? this->AnswerTo(queries, *leaf++, ofAll).Get() : data);
  }
  this->DescribeMethod(output);
}

void vtkWindingNumberProbeAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InsideOut: " << this->InsideOut << "\n";
}
