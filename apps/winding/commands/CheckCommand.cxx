// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/CommandFiles.h"
#include "commands/Commands.h"
#include "input/ReadInput.h"
#include "options/Options.h"
#include "output/BlocksFile.h"
#include "output/OutputFile.h"
#include "output/WriteOutput.h"
#include "program/Failure.h"
#include "program/Interrupt.h"
#include "program/Messages.h"
#include "program/Print.h"
#include "program/Progress.h"

#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindingNumberAlgorithm.h"
#include "vtkWindingNumberReport.h"

#include <algorithm>
#include <optional>

namespace
{

/// The value of an array of the report: numbers and words unchanged, a byte as true or false, null
/// for an empty array.
Json valueOf(vtkAbstractArray* array)
{
  if (array->GetNumberOfValues() == 0)
  {
    return nullptr;
  }
  if (auto* text = vtkStringArray::SafeDownCast(array))
  {
    return text->GetValue(0);
  }
  if (auto* count = vtkIdTypeArray::SafeDownCast(array))
  {
    return count->GetValue(0);
  }
  if (auto* flag = vtkUnsignedCharArray::SafeDownCast(array))
  {
    return flag->GetValue(0) != 0;
  }
  auto* measures = vtkDoubleArray::SafeDownCast(array);
  if (measures->GetNumberOfValues() == 1)
  {
    return measures->GetValue(0);
  }
  return std::vector<double>(
    measures->GetPointer(0), measures->GetPointer(measures->GetNumberOfValues()));
}

/// A value of the report for people.
std::string textOf(const Json& value)
{
  if (value.is_null())
  {
    return "-";
  }
  if (value.is_array())
  {
    std::string text;
    for (const Json& number : value)
    {
      text += (text.empty() ? "" : " ") + textOf(number);
    }
    return text;
  }
  if (value.is_boolean())
  {
    return value.get<bool>() ? "yes" : "no";
  }
  if (value.is_number_float())
  {
    return shown(value.get<double>(), 9);
  }
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// The report for people: the points of the advice, a line for each value, then the files.
std::string aligned(const Json& report, vtkWindingNumberReport& filter)
{
  std::string text;
  for (int i = 0; i < filter.GetNumberOfAdvice(); ++i)
  {
    text += std::string(filter.GetAdvice(i)) + "\n";
  }
  text += text.empty() ? "" : "\n";
  for (const auto& [name, value] : report.items())
  {
    if (!value.is_object() && name != "advice")
    {
      std::string label = name;
      std::replace(label.begin(), label.end(), '_', ' ');
      label.resize(std::max<std::size_t>(label.size(), 22), ' ');
      text += label + " " + textOf(value) + "\n";
    }
  }
  for (const char* written : {"output", "blocks"})
  {
    if (report.contains(written))
    {
      text += "wrote " + report[written]["file"].get<std::string>() + "\n";
    }
  }
  text.pop_back(); // print() ends the line
  return text;
}

/// Throws Failure for options that are for surfaces where the input is none.
void requireSurface(bool isSurface, const Options& options)
{
  if (!isSurface && !options.faults.empty())
  {
    throw Failure(
      EXIT_REFUSED, options.input, "has no faces, and --blocks is for surfaces; leave it out");
  }
}

Json describe(vtkPolyData* surface, const std::string& file)
{
  return {{"file", file}, {"points", surface->GetNumberOfPoints()},
    {"cells", surface->GetNumberOfCells()}};
}

Json describe(vtkMultiBlockDataSet* blocks, const std::string& file)
{
  Json cells = {{"Boundary", 0}, {"Caps", 0}, {"NonManifoldEdges", 0}, {"InconsistentEdges", 0}};
  for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
  {
    if (auto* block = vtkPolyData::SafeDownCast(blocks->GetBlock(i)))
    {
      cells[blocks->GetMetaData(i)->Get(vtkCompositeDataSet::NAME())] = block->GetNumberOfCells();
    }
  }
  return {{"file", file}, {"cells", cells}};
}

} // namespace

void runCheck(const Options& options, Messages& messages)
{
  std::optional<OutputFile> output;
  std::optional<BlocksFile> faults;
  const std::vector<std::string> kept = filesToKeep(options);
  if (!options.faults.empty())
  {
    faults.emplace(options.faults, kept);
  }
  if (!options.output.empty())
  {
    output.emplace(options.output, kept);
  }
  vtkNew<vtkWindingNumberReport> filter;
  filter->SetNamesInMessages(vtkWindingNumberAlgorithm::PROGRAM_NAMES);
  filter->SetInputDataObject(readSource(options, messages));
  filter->SetUseSurfaceCells(options.surfaceCells);
  filter->SetMirror(options.mirror.c_str());
  filter->SetFlatBase(options.flatBase.c_str());
  filter->SetWeldTolerance(options.weldTolerance);
  filter->SetFixOrientation(options.fixOrientation);
  {
    const Progress progress(filter, Phase::evaluating, messages.isQuiet(), "checking");
    filter->Update();
  }
  interrupt::check();
  messages.throwIfError(options.input);
  requireSurface(filter->GetSourceIsSurface(), options);
  Json report = {{"file", options.input}};
  vtkFieldData* arrays = filter->GetReport();
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    report[arrays->GetArrayName(i)] = valueOf(arrays->GetAbstractArray(i));
  }
  if (output)
  {
    writeSurface(filter->GetOutput(), *output, messages);
    report["output"] = describe(filter->GetOutput(), options.output);
  }
  if (faults)
  {
    faults->write(filter->GetFaults(), messages);
    report["blocks"] = describe(filter->GetFaults(), options.faults);
  }
  if (output)
  {
    output->commit();
  }
  if (options.json)
  {
    print(report);
  }
  else
  {
    print(aligned(report, *filter));
  }
}
