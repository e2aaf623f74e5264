// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindingNumberBoolean.h"

#include "base/BooleanOperation.h"
#include "base/Bounds.h"
#include "base/Refusal.h"
#include "diagnosis/GridAdvice.h"
#include "field/Field.h"
#include "messages/Options.h"
#include "messages/PropertyChecks.h"
#include "pipeline/Ranks.h"
#include "pipeline/SmpExecutor.h"
#include "private/output/ArraySink.h"
#include "private/output/Legends.h"
#include "private/output/NearestAttributes.h"
#include "private/source/ContentHash.h"
#include "private/source/NamedBlocks.h"
#include "private/source/SourceProperties.h"
#include "report/InputUnits.h"
#include "report/LabelFacts.h"
#include "report/Verify.h"
#include "source/Grid.h"
#include "tasks/Sentences.h"
#include "tasks/SurfaceTask.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <set>
#include <utility>

namespace
{

// The property becomes the core's choice by its number.
using winding::isNumber;
using Filter = vtkWindingNumberBoolean;
static_assert(isNumber(winding::BooleanOperation::unite, Filter::UNION));
static_assert(isNumber(winding::BooleanOperation::intersect, Filter::INTERSECTION));
static_assert(isNumber(winding::BooleanOperation::subtract, Filter::DIFFERENCE));
static_assert(isNumber(winding::BooleanOperation::exclude, Filter::SYMMETRIC_DIFFERENCE));

} // namespace

vtkStandardNewMacro(vtkWindingNumberBoolean);

vtkWindingNumberBoolean::vtkWindingNumberBoolean()
  : Facts(std::make_unique<winding::LabelFacts>())
  , OperandTest(std::make_unique<winding::InsideTest>())
{
  this->SetNumberOfInputPorts(2);
}

vtkWindingNumberBoolean::~vtkWindingNumberBoolean() = default;

int vtkWindingNumberBoolean::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

void vtkWindingNumberBoolean::SetOperandThreshold(int operand, double threshold)
{
  this->OperandThresholds[operand] = threshold;
  this->Modified();
}

double vtkWindingNumberBoolean::GetOperandThreshold(int operand) const
{
  const auto found = this->OperandThresholds.find(operand);
  return found == this->OperandThresholds.end() ? this->WindingThreshold : found->second;
}

void vtkWindingNumberBoolean::ClearOperandThresholds()
{
  this->OperandThresholds.clear();
  this->Modified();
}

void vtkWindingNumberBoolean::SetOperandInsideRule(int operand, int rule)
{
  this->OperandInsideRules[operand] = rule;
  this->Modified();
}

int vtkWindingNumberBoolean::GetOperandInsideRule(int operand) const
{
  const auto found = this->OperandInsideRules.find(operand);
  return found == this->OperandInsideRules.end() ? this->InsideRule : found->second;
}

void vtkWindingNumberBoolean::ClearOperandInsideRules()
{
  this->OperandInsideRules.clear();
  this->Modified();
}

void vtkWindingNumberBoolean::SetName(int port, int connection, const char* name)
{
  this->Names[port][connection] = winding::textOf(name);
  this->Modified();
}

const char* vtkWindingNumberBoolean::GetName(int port, int connection) const
{
  const auto found = this->Names[port].find(connection);
  return found == this->Names[port].end() ? "" : found->second.c_str();
}

void vtkWindingNumberBoolean::SetInputName(int connection, const char* name)
{
  this->SetName(0, connection, name);
}

const char* vtkWindingNumberBoolean::GetInputName(int connection) const
{
  return this->GetName(0, connection);
}

void vtkWindingNumberBoolean::ClearInputNames()
{
  this->Names[0].clear();
  this->Modified();
}

void vtkWindingNumberBoolean::SetOtherName(int connection, const char* name)
{
  this->SetName(1, connection, name);
}

const char* vtkWindingNumberBoolean::GetOtherName(int connection) const
{
  return this->GetName(1, connection);
}

void vtkWindingNumberBoolean::ClearOtherNames()
{
  this->Names[1].clear();
  this->Modified();
}

void vtkWindingNumberBoolean::CheckProperties()
{
  this->OperandLegend.clear();
  this->Superclass::CheckProperties();
  winding::checkProperty(winding::Parameter::booleanOperation, this->Operation);
  for (const auto& [operand, threshold] : this->OperandThresholds)
  {
    winding::checkProperty(winding::Parameter::windingThreshold, threshold);
  }
  for (const auto& [operand, rule] : this->OperandInsideRules)
  {
    winding::coreInsideRule(rule);
  }
}

void vtkWindingNumberBoolean::HashProperties(winding::ContentHash& hash)
{
  this->Superclass::HashProperties(hash);
  hash.addValue(this->Operation);
  for (const auto& [operand, threshold] : this->OperandThresholds)
  {
    hash.addValue(operand);
    hash.addValue(threshold);
  }
  hash.addValue(this->OperandThresholds.size()); // ends one list, and begins the next
  for (const auto& [operand, rule] : this->OperandInsideRules)
  {
    hash.addValue(operand);
    hash.addValue(rule);
  }
  hash.addValue(this->OperandInsideRules.size());
  for (const auto& names : this->Names)
  {
    for (const auto& [connection, name] : names)
    {
      hash.addValue(connection);
      hash.addText(name);
    }
    hash.addValue(names.size());
  }
}

const winding::FieldInfo& vtkWindingNumberBoolean::GetSourceInfo() const
{
  return this->Facts->source;
}

/// Returns the operands as blocks with names.
vtkDataObject* vtkWindingNumberBoolean::MakeSource()
{
  std::vector<std::pair<vtkSmartPointer<vtkDataObject>, std::string>> sources;
  for (int port = 0; port < this->GetNumberOfSourcePorts(); ++port)
  {
    for (int i = 0; i < this->GetNumberOfInputConnections(port); ++i)
    {
      sources.emplace_back(this->GetInputDataObject(port, i), this->GetName(port, i));
    }
  }
  vtkSmartPointer<vtkMultiBlockDataSet> blocks;
  if (sources.size() == 1)
  {
    blocks = vtkMultiBlockDataSet::SafeDownCast(winding::asBlock(sources.front().first));
  }
  if (blocks)
  {
    sources.clear();
    for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
    {
      const bool isNamed =
        blocks->HasMetaData(i) && blocks->GetMetaData(i)->Has(vtkCompositeDataSet::NAME());
      sources.emplace_back(blocks->GetBlock(i),
        isNamed ? winding::textOf(blocks->GetMetaData(i)->Get(vtkCompositeDataSet::NAME())) : "");
    }
  }
  this->Blocks = winding::namedBlocksOf(sources);
  return this->Blocks;
}

/// Returns whether the solid of an operand may reach beyond its source: with a low threshold it
/// does, and beyond the rim of a sheet.
bool vtkWindingNumberBoolean::ReachesBeyondSource(int operand) const
{
  constexpr double withinHull = 0.5; // w is less outside of the convex hull
  return !winding::textOf(this->SheetSide).empty() ||
         (this->GetOperandInsideRule(operand) != ODD &&
           this->GetOperandThreshold(operand) < withinHull);
}

void vtkWindingNumberBoolean::HashBounds(winding::ContentHash& hash)
{
  this->Superclass::HashBounds(hash);
  constexpr int anyOther = -1;
  std::set<int> operands = {anyOther};
  for (const auto& [operand, threshold] : this->OperandThresholds)
  {
    operands.insert(operand);
  }
  for (const auto& [operand, rule] : this->OperandInsideRules)
  {
    operands.insert(operand);
  }
  hash.addValue(this->Operation);
  for (const int operand : operands)
  {
    hash.addValue(operand);
    hash.addValue(this->ReachesBeyondSource(operand));
  }
}

/// Finds the bounds of what the result can reach. Operands that reach beyond their sources set no
/// limit to the others.
bool vtkWindingNumberBoolean::GetSourceBounds(vtkDataObject* source, double bounds[6])
{
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(source);
  winding::Bounds first, all, common;
  bool hasCommon = false;
  for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
  {
    this->ChooseSource(i, "");
    double own[6];
    winding::Bounds box;
    if (this->Superclass::GetSourceBounds(blocks->GetBlock(i), own))
    {
      box.extend(Eigen::Vector3d(own[0], own[2], own[4]));
      box.extend(Eigen::Vector3d(own[1], own[3], own[5]));
    }
    first = i == 0 ? box : first;
    if (!this->ReachesBeyondSource(static_cast<int>(i)))
    {
      common = hasCommon ? common.intersection(box) : box;
      hasCommon = true;
    }
    all.extend(box);
  }
  if (this->Operation == DIFFERENCE && !first.isEmpty())
  {
    all = first;
  }
  else if (this->Operation == INTERSECTION && !common.isEmpty())
  {
    all = common;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = all.min()[axis];
    bounds[2 * axis + 1] = all.max()[axis];
  }
  return !all.isEmpty();
}

void vtkWindingNumberBoolean::AddSolids(vtkDataObject* source, winding::WallGrid& grid)
{
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(source);
  for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
  {
    this->ChooseSource(i, blocks->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()));
    this->Superclass::AddSolids(blocks->GetBlock(i), grid);
  }
  this->ChooseSource(0, "");
}

std::size_t vtkWindingNumberBoolean::GetAdditionalBytes(const winding::Field& field, vtkIdType)
{
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  winding::Run run = this->MakeRun(executor);
  return static_cast<std::size_t>(this->Task->claim(field, *this->OperandTest, run)) +
         this->GetBytesOfNearest(field);
}

int vtkWindingNumberBoolean::RequestData(
  vtkInformation* request, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (this->IsLaterPiece(GetRequestedOutput(request, outputs)))
  {
    return 1;
  }
  this->AgreeOnProperties();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(this->MakeSource());
  const unsigned int count = blocks->GetNumberOfBlocks();
  if (count < 2)
  {
    throw winding::Refusal(winding::messageOf(winding::Sentence::fewerThanTwoSolids));
  }
  if (this->TransferAttributes || this->GenerateNearestCells)
  {
    winding::refuseNearestOfMixed(blocks, this->GetSourceOptions().input);
  }
  this->SetUpGridOver(blocks);
  if (!this->CloseBorder)
  {
    winding::refuseFlatGrid(this->GetSampling());
  }
  this->CheckVerification(true);
  this->SetVerification(winding::Verification());
  *this->Facts = winding::LabelFacts();
  this->Facts->expected = count;
  this->Task = std::make_unique<winding::BooleanTask>(this->GetSampling(),
    static_cast<winding::BooleanOperation>(this->Operation), this->GetSurfaceOptions());
  this->EarlierSeconds = 0;
  double prepareSeconds = 0, evaluateSeconds = 0;
  vtkNew<vtkStringArray> names;
  names->SetName("OperandNames");
  // The loop is collective: each operand is built of the parts of all ranks, in the same order.
  for (unsigned int i = 0; i < count; ++i)
  {
    const std::string name = blocks->GetMetaData(i)->Get(vtkCompositeDataSet::NAME());
    const int number = static_cast<int>(i);
    *this->OperandTest = {winding::coreInsideRule(this->GetOperandInsideRule(number)),
      this->GetOperandThreshold(number)};
    this->ChooseSource(i, name);
    this->SetProgressShiftScale(static_cast<double>(i) / (count + 1), 1.0 / (count + 1));
    this->AddOperand(blocks->GetBlock(i), name);
    this->Facts->add(this->Superclass::GetSourceInfo(), name, false);
    prepareSeconds += this->PrepareSeconds;
    evaluateSeconds += this->EvaluateSeconds;
    names->InsertNextValue(name);
  }
  this->PrepareSeconds = prepareSeconds;
  this->EvaluateSeconds = evaluateSeconds;
  this->EarlierSeconds = 0;
  this->ChooseSource(0, "");
  this->InspectSource(blocks);
  if (this->IsHelper())
  {
    return 1;
  }
  if (const auto unused = this->Facts->unused.messages(); !unused.empty())
  {
    vtkWarningMacro(<< winding::lineOf(unused));
  }
  this->SetProgressShiftScale(static_cast<double>(count) / (count + 1), 1.0 / (count + 1));
  this->MakeResult(output);
  this->AddNearest(blocks, output);
  output->GetFieldData()->AddArray(names);
  this->OperandLegend = winding::legendOf(output->GetFieldData(), nullptr, "OperandNames");
  this->DescribeMethod(output);
  return 1;
}

void vtkWindingNumberBoolean::AddOperand(vtkDataObject* source, const std::string& name)
{
  const winding::Field& field = this->PrepareGridFieldOf(source, name);
  if (this->IsHelper())
  {
    return;
  }
  const winding::Extent extent = this->GetSampling().wholeExtent();
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  winding::Run run = this->MakeRun(executor);
  this->Evaluate(field, static_cast<vtkIdType>(winding::sampleCount(extent)), executor,
    [&] { this->SourceIsInsideOut = this->Task->add(field, *this->OperandTest, run).isInsideOut; });
  this->EarlierSeconds = this->TakenSeconds;
  this->VerifyAnother(field, extent);
}

void vtkWindingNumberBoolean::MakeResult(vtkPolyData* output)
{
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  winding::Run run = this->MakeRun(executor);
  winding::ArraySink result;
  this->Task->run(result, run);
  this->Task.reset();
  this->AddResult(result, output);
  const auto units = winding::unitAdvice(this->Facts->bounds);
  // Blocks of one data set have one unit.
  if (units && this->GetSourceConnections().size() > 1)
  {
    vtkWarningMacro(<< winding::lineOf(*units));
  }
}

const char* vtkWindingNumberBoolean::GetOperationAsString() const
{
  return winding::nameOfChoice(winding::Parameter::booleanOperation, this->Operation);
}

void vtkWindingNumberBoolean::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OperandLegend: " << this->OperandLegend.size() << " bytes\n";
  os << indent << "Operation: " << this->Operation << "\n";
  os << indent << "OperandThresholds: " << this->OperandThresholds.size() << "\n";
  os << indent << "OperandInsideRules: " << this->OperandInsideRules.size() << "\n";
}
