#include "Commands.h"
#include "Failure.h"
#include "Interrupt.h"
#include "Messages.h"
#include "Options.h"
#include "Progress.h"
#include "ReadInput.h"
#include "Report.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkStringArray.h"
#include "vtkSurfaceReport.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace
{

/// An array of the report: numbers and words as they are, bytes as yes or no, no value as null.
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

std::string textOf(const Json& value)
{
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
  return value.is_string() ? value.get<std::string>() : value.is_null() ? "-" : value.dump();
}

/// A line for each value, then the advice.
std::string aligned(const Json& report)
{
  std::string text;
  for (const auto& [name, value] : report.items())
  {
    if (name != "advice")
    {
      std::string label = name;
      std::replace(label.begin(), label.end(), '_', ' ');
      label.resize(std::max<std::size_t>(label.size(), 22), ' ');
      text += label + " " + textOf(value) + "\n";
    }
  }
  return text + report["advice"].get<std::string>();
}

} // namespace

void runCheck(const Options& options, Messages& messages)
{
  vtkNew<vtkSurfaceReport> filter;
  filter->SetInputDataObject(readInput(options.input, options, messages));
  {
    const Progress progress(filter, "check", options.quiet);
    filter->Update();
  }
  interrupt::check();
  messages.throwIfError(options.input);
  Json report = {{"file", options.input}};
  vtkFieldData* arrays = filter->GetReport();
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    report[arrays->GetArrayName(i)] = valueOf(arrays->GetAbstractArray(i));
  }
  if (options.json)
  {
    print(report);
  }
  else
  {
    print(aligned(report));
  }
}
