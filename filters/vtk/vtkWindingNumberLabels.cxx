// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindingNumberLabels.h"

#include "base/Refusal.h"
#include "field/Field.h"
#include "messages/Options.h"
#include "messages/PropertyChecks.h"
#include "pipeline/SmpExecutor.h"
#include "private/output/LabelImage.h"
#include "private/output/Legends.h"
#include "private/output/TimeUnion.h"
#include "private/source/ContentHash.h"
#include "private/source/NamedBlocks.h"
#include "private/source/SolidBlocks.h"
#include "private/source/Solids.h"
#include "private/source/SourceProperties.h"
#include "report/Verify.h"
#include "source/Grid.h"
#include "tasks/LabelTask.h"
#include "tasks/Sentences.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <string>
#include <vector>

namespace
{

// The property becomes the helper's choice by its number.
using winding::isNumber;
using Filter = vtkWindingNumberLabels;
static_assert(isNumber(winding::OverlapRule::first, Filter::FIRST));
static_assert(isNumber(winding::OverlapRule::last, Filter::LAST));
static_assert(isNumber(winding::OverlapRule::largestWindingNumber, Filter::LARGEST_WINDING_NUMBER));
static_assert(isNumber(winding::OverlapRule::smallestVolume, Filter::SMALLEST_VOLUME));

} // namespace

vtkStandardNewMacro(vtkWindingNumberLabels);

vtkWindingNumberLabels::vtkWindingNumberLabels()
  : Facts(std::make_unique<winding::LabelFacts>())
{
}

vtkWindingNumberLabels::~vtkWindingNumberLabels()
{
  this->SetRegionArray(nullptr);
}

int vtkWindingNumberLabels::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

void vtkWindingNumberLabels::SetInputName(int connection, const char* name)
{
  std::string& own = this->InputNames[connection];
  if (own != winding::textOf(name))
  {
    own = winding::textOf(name);
    this->Modified();
  }
}

const char* vtkWindingNumberLabels::GetInputName(int connection) const
{
  const auto found = this->InputNames.find(connection);
  return found == this->InputNames.end() ? "" : found->second.c_str();
}

void vtkWindingNumberLabels::ClearInputNames()
{
  if (!this->InputNames.empty())
  {
    this->InputNames.clear();
    this->Modified();
  }
}

vtkDataObject* vtkWindingNumberLabels::MakeSource()
{
  const int count = this->GetNumberOfInputConnections(0);
  if (count < 2)
  {
    return this->Superclass::MakeSource();
  }
  std::vector<std::pair<vtkSmartPointer<vtkDataObject>, std::string>> sources;
  for (int i = 0; i < count; ++i)
  {
    sources.emplace_back(this->GetInputDataObject(0, i), this->GetInputName(i));
  }
  this->Blocks = winding::namedBlocksOf(sources);
  return this->Blocks;
}

void vtkWindingNumberLabels::CheckProperties()
{
  this->LabelLegend.clear();
  this->VolumesInWords.clear();
  this->Superclass::CheckProperties();
  winding::checkProperty(winding::Parameter::overlapRule, this->OverlapRule);
  winding::checkProperty(winding::Parameter::coverageArrays, this->CoverageArrays);
  winding::checkProperty(winding::Parameter::labelOffset, this->LabelOffset);
}

void vtkWindingNumberLabels::HashProperties(winding::ContentHash& hash)
{
  this->Superclass::HashProperties(hash);
  hash.addValue(this->OverlapRule);
  hash.addValue(this->GenerateSolidCount);
  hash.addValue(this->CoverageArrays);
  hash.addValue(this->LabelOffset);
  hash.addText(winding::textOf(this->RegionArray));
  for (const auto& [connection, name] : this->InputNames)
  {
    hash.addValue(connection);
    hash.addText(name);
  }
}

void vtkWindingNumberLabels::CheckSource(vtkDataObject* source)
{
  this->GetRanks().agree([&] { winding::checkSolids(source, this->SourceAsPoints != 0); });
}

void vtkWindingNumberLabels::WarnOfFaults(const winding::Field&)
{
  // WarnOfSolids() counts what would be a line for each solid.
}

const winding::FieldInfo& vtkWindingNumberLabels::GetSourceInfo() const
{
  return this->Facts->source;
}

vtkIdType vtkWindingNumberLabels::GetNumberOfSolids() const
{
  return static_cast<vtkIdType>(this->Facts->solids);
}

vtkIdType vtkWindingNumberLabels::GetNumberOfEmptySolids() const
{
  return static_cast<vtkIdType>(this->Facts->empty.count());
}

vtkIdType vtkWindingNumberLabels::GetNumberOfOpenSolids() const
{
  return static_cast<vtkIdType>(this->Facts->open.count() + this->Facts->openParts.count());
}

vtkIdType vtkWindingNumberLabels::GetNumberOfInsideOutSolids() const
{
  return static_cast<vtkIdType>(this->Facts->insideOut.count());
}

winding::LabelImageOptions vtkWindingNumberLabels::GetImageOptions(std::size_t solids) const
{
  winding::LabelImageOptions options;
  options.withCounts = this->GenerateSolidCount != 0;
  options.withLargestTwo = this->Coverage == FRACTION && this->CoverageArrays == TWO_LARGEST;
  options.withShares = this->Coverage == FRACTION && this->CoverageArrays == EACH_LABEL;
  options.withBest = this->OverlapRule == LARGEST_WINDING_NUMBER;
  options.solids = solids;
  return options;
}

winding::LabelOptions vtkWindingNumberLabels::GetLabelOptions() const
{
  winding::LabelOptions options;
  options.voxels = this->GetVoxelEvaluation();
  options.voxels.output.isInside = this->GetInsideTest();
  options.overlapRule = static_cast<winding::OverlapRule>(this->OverlapRule);
  options.mendsSource = this->MendsSource();
  return options;
}

double vtkWindingNumberLabels::GetResultBytes(vtkIdType samples) const
{
  const winding::LabelImageOptions image = this->GetImageOptions(this->Facts->expected);
  return winding::bytesPerSample(image) * static_cast<double>(samples) +
         winding::LabelTask::bytes(this->GetLabelOptions(), static_cast<std::size_t>(samples));
}

void vtkWindingNumberLabels::MakeImage(vtkDataObject* source, const winding::Extent& samples,
  vtkImageData* image, vtkDataSetAttributes* attributes)
{
  this->CheckVerification(true);
  this->SetVerification(winding::Verification());
  *this->Facts = winding::LabelFacts();
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  winding::SolidOptions options;
  options.regionArray = winding::textOf(this->RegionArray);
  options.labelOffset = this->LabelOffset;
  options.asPoints = this->SourceAsPoints != 0;
  options.takesFaces = this->UseSurfaceCells != 0;
  options.ignoresOpenParts = this->IgnoreOpenParts != 0;
  options.weldTolerance = this->WeldTolerance;
  const winding::Solids solids(source, options, this->GetRanks(), executor);
  this->Facts->expected = solids.size();

  winding::LabelImage labels(samples, this->GetImageOptions(solids.size()));
  this->MergeSolids(solids, labels);
  labels.addTo(attributes);
  this->InspectSource(source);
  this->SourceIsInsideOut = this->Facts->insideOut.count() > 0;
  this->DescribeSolids(solids, image);
  this->DescribeMethod(image);
  this->WarnOfSolids(solids);
}

void vtkWindingNumberLabels::UniteTimes(vtkImageData* all, vtkImageData* other)
{
  const std::string legend = winding::legendOfLabels(other->GetFieldData());
  const std::string known = winding::legendOfLabels(all->GetFieldData());
  this->LabelLegend = known.empty() ? legend : known;
  if (known.empty())
  {
    all->ShallowCopy(other);
  }
  else if (legend == known)
  {
    winding::uniteLabels(this->GetAttributes(all), this->GetAttributes(other));
    this->MeasureSolids(all);
  }
  else if (!legend.empty())
  {
    throw winding::Refusal(winding::messageOf(winding::Sentence::otherSolidsAtTimes));
  }
}

void vtkWindingNumberLabels::MergeSolids(const winding::Solids& solids, winding::LabelImage& labels)
{
  const winding::Extent& extent = labels.arrays().extent;
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  winding::Run run = this->MakeRun(executor);
  winding::LabelTask task(
    this->GetSampling(), labels.arrays(), this->GetLabelOptions(), *this->Facts, run);
  double prepareSeconds = 0, evaluateSeconds = 0;
  vtkIdType memory = 0;
  const double earlierSeconds = this->EarlierSeconds;
  const auto all = static_cast<double>(solids.size());
  const double shift = this->GetProgressShift(), scale = this->GetProgressScale();
  // The loop is collective: each solid is built of the parts of all ranks, in the same order.
  for (std::size_t i = 0; i < solids.size(); ++i)
  {
    // Progress is a share of all solids, of this time or of the request.
    this->SetProgressShiftScale(shift + static_cast<double>(i) / all * scale, scale / all);
    const winding::Field& field = this->PrepareGridFieldOf(solids.source(i), solids.name(i));
    const winding::FieldInfo& info = this->vtkWindingNumberGridAlgorithm::GetSourceInfo();
    prepareSeconds += this->PrepareSeconds;
    memory = std::max(memory, this->ExpectedMemory);
    this->Evaluate(field, static_cast<vtkIdType>(winding::sampleCount(extent)), executor,
      [&]
      {
        executor.setShare(0, 1);
        task.add(field, info,
          {solids.label(i), solids.name(i), solids.isOpenPart(i),
            labels.addSharesOf(solids.label(i))},
          run);
      });
    this->EarlierSeconds = this->TakenSeconds;
    evaluateSeconds += this->EvaluateSeconds;
    this->VerifyAnother(field, extent);
  }
  // Regions and blocks of one data set have one unit.
  task.warn(this->GetNumberOfInputConnections(0) < 2, run);
  this->PrepareSeconds = prepareSeconds;
  this->EvaluateSeconds = evaluateSeconds;
  this->ExpectedMemory = memory;
  this->EarlierSeconds = earlierSeconds;
}

void vtkWindingNumberLabels::DescribeSolids(const winding::Solids& solids, vtkImageData* image)
{
  vtkNew<vtkUnsignedShortArray> values;
  vtkNew<vtkStringArray> names;
  values->SetName("LabelValues");
  names->SetName("LabelNames");
  for (std::size_t i = 0; i < solids.size(); ++i)
  {
    values->InsertNextValue(solids.label(i));
    names->InsertNextValue(solids.name(i));
  }
  image->GetFieldData()->AddArray(values);
  image->GetFieldData()->AddArray(names);
  this->LabelLegend = winding::legendOfLabels(image->GetFieldData());
  this->MeasureSolids(image);
}

void vtkWindingNumberLabels::MeasureSolids(vtkImageData* image)
{
  winding::addLabelVolumes(image, this->GetAttributes(image));
  const winding::Extent whole = this->GetSampling().wholeExtent();
  const bool isWhole =
    image->GetNumberOfPoints() >= static_cast<vtkIdType>(winding::sampleCount(whole));
  this->VolumesInWords = isWhole ? winding::volumesInWords(image->GetFieldData()) : "";
}

void vtkWindingNumberLabels::WarnOfSolids(const winding::Solids& solids)
{
  const winding::LabelFacts& facts = *this->Facts;
  const std::size_t count = solids.size();
  if (facts.warned.count() > 0)
  {
    vtkWarningMacro(<< winding::lineOf(facts.warnings) << " (" << facts.warned.outOf(count) << ")");
  }
  if (const auto unused = facts.unused.messages(); !unused.empty())
  {
    vtkWarningMacro(<< winding::lineOf(unused));
  }
  if (const auto notes = winding::notesOn(solids.cellCounts()); !notes.empty())
  {
    vtkWarningMacro(<< winding::lineOf(notes));
  }
  if (solids.areNumbered())
  {
    vtkWarningMacro(<< winding::lineOf(winding::messageOf(winding::Sentence::regionsAreNumbered)));
  }
  if (this->LabelOffset != 0 && count > 0 && !solids.areOffset())
  {
    vtkWarningMacro(<< winding::lineOf(winding::messageOf(winding::Sentence::solidsAreNumbered)));
  }
  if (!solids.dividingNames().empty())
  {
    vtkWarningMacro(<< winding::lineOf(winding::messageOf(
                      winding::Sentence::namesDivideSolids, {solids.dividingNames()})));
  }
  if (solids.repeatedNames() > 0)
  {
    vtkWarningMacro(<< winding::lineOf(winding::messageOf(winding::Sentence::equalNames,
                      {std::to_string(solids.repeatedNames()), std::to_string(count)})));
  }
}

const char* vtkWindingNumberLabels::GetOverlapRuleAsString() const
{
  return winding::nameOfChoice(winding::Parameter::overlapRule, this->OverlapRule);
}

const char* vtkWindingNumberLabels::GetCoverageArraysAsString() const
{
  return winding::nameOfChoice(winding::Parameter::coverageArrays, this->CoverageArrays);
}

void vtkWindingNumberLabels::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OverlapRule: " << this->OverlapRule << "\n";
  os << indent << "GenerateSolidCount: " << this->GenerateSolidCount << "\n";
  os << indent << "CoverageArrays: " << this->CoverageArrays << "\n";
  os << indent << "RegionArray: " << winding::textOf(this->RegionArray) << "\n";
  os << indent << "LabelOffset: " << this->LabelOffset << "\n";
  os << indent << "InputNames: " << this->InputNames.size() << "\n";
  os << indent << "VolumesInWords: " << this->VolumesInWords << "\n";
  os << indent << "LabelLegend: " << this->LabelLegend.size() << " bytes\n";
  os << indent << "NumberOfSolids: " << this->GetNumberOfSolids() << "\n";
  os << indent << "NumberOfEmptySolids: " << this->GetNumberOfEmptySolids() << "\n";
  os << indent << "NumberOfOpenSolids: " << this->GetNumberOfOpenSolids() << "\n";
  os << indent << "NumberOfInsideOutSolids: " << this->GetNumberOfInsideOutSolids() << "\n";
}
