// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/output/ResultArrays.h"

#include "base/LargePages.h"
#include "base/Refusal.h"
#include "pipeline/FreeMemory.h"
#include "private/source/ContentHash.h"
#include "tasks/Sentences.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace winding
{

namespace
{

void pointInto(vtkDataArray* array, float*& floats, double*& doubles)
{
  if (auto* ofFloats = vtkFloatArray::SafeDownCast(array))
  {
    floats = ofFloats->GetPointer(0);
  }
  else if (auto* ofDoubles = vtkDoubleArray::SafeDownCast(array))
  {
    doubles = ofDoubles->GetPointer(0);
  }
}

/// Arrays, those that there are, and their names.
using Names = std::vector<std::pair<bool, std::string>>;

void checkNames(const Names& names)
{
  std::set<std::string> taken;
  for (const auto& [exists, name] : names)
  {
    if (exists && !taken.insert(name).second)
    {
      throw Refusal(messageOf(Sentence::equalArrayNames, {name}));
    }
  }
}

} // namespace

vtkSmartPointer<vtkDataArray> makeResultArray(int type, const std::string& name, vtkIdType samples)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName(name.c_str());
  array->SetNumberOfTuples(samples);
  adviseLargePages(array->GetVoidPointer(0),
    static_cast<std::size_t>(samples) * static_cast<std::size_t>(array->GetDataTypeSize()));
  return array;
}

double bytesOf(const ResultOptions& options, vtkIdType samples)
{
  const vtkIdType ofNumber = vtkDataArray::GetDataTypeSize(options.scalarType);
  // Signs have to be kept somewhere until distances are there.
  const bool hasSides = options.withInside || (options.withDistances && !options.withValues);
  const vtkIdType perSample = (options.withValues ? ofNumber : 0) +
                              (options.withDistances ? ofNumber : 0) + (hasSides ? 1 : 0) +
                              (options.withCoverage ? sizeof(float) : 0) +
                              (options.withNearest ? sizeof(vtkIdType) + sizeof(int) : 0);
  return static_cast<double>(perSample) * static_cast<double>(samples);
}

void addTo(ContentHash& hash, const ResultOptions& options)
{
  hash.addValue(options.withValues);
  hash.addValue(options.withInside);
  hash.addValue(options.withDistances);
  hash.addValue(options.withCoverage);
  hash.addValue(options.withFraction);
  hash.addValue(options.withNearest);
  hash.addValue(options.scalarType);
  hash.addText(options.name);
  hash.addText(options.insideName);
}

ResultArrays::ResultArrays(vtkIdType samples, const ResultOptions& options)
  : showsInside_(options.withInside && options.showsInside)
{
  if (!options.withValues && !options.withInside && !options.withDistances)
  {
    throw Refusal(messageOf(Sentence::nothingToGenerate));
  }
  const std::string name = options.name.empty() ? "WindingNumber" : options.name;
  checkNames({{options.withValues, name}, {options.withInside, options.insideName},
    {options.withDistances, distanceName}, {options.withCoverage, coverageName},
    {options.withFraction, fractionName}, {options.withNearest, "NearestCell"},
    {options.withNearest, "NearestBlock"}});
  refuseBeyondFreeMemory(bytesOf(options, samples),
    "the result of " + std::to_string(samples) + " samples", options.remedies);
  if (options.withValues)
  {
    values_ = makeResultArray(options.scalarType, name, samples);
  }
  if (options.withInside)
  {
    inside_ = vtkUnsignedCharArray::SafeDownCast(
      makeResultArray(VTK_UNSIGNED_CHAR, options.insideName, samples));
  }
  if (options.withCoverage)
  {
    coverage_ = vtkFloatArray::SafeDownCast(makeResultArray(VTK_FLOAT, coverageName, samples));
  }
  if (options.withDistances)
  {
    distances_ = makeResultArray(options.scalarType, distanceName, samples);
  }
}

FieldOutput ResultArrays::output(const InsideTest& isInside) const
{
  FieldOutput output;
  pointInto(values_, output.values, output.doubleValues);
  pointInto(distances_, output.distances, output.doubleDistances);
  output.inside = inside_ ? inside_->GetPointer(0) : nullptr;
  output.isInside = isInside;
  return output;
}

std::optional<vtkIdType> ResultArrays::countInside() const
{
  if (!inside_)
  {
    return std::nullopt;
  }
  const unsigned char* first = inside_->GetPointer(0);
  return std::count(first, first + inside_->GetNumberOfValues(), 1);
}

bool ResultArrays::isInside(std::size_t sample, const InsideTest& isInside) const
{
  const auto number = static_cast<vtkIdType>(sample);
  if (inside_)
  {
    return inside_->GetValue(number) != 0;
  }
  return values_ ? isInside(values_->GetComponent(number, 0))
                 : distances_->GetComponent(number, 0) < 0;
}

void ResultArrays::addTo(vtkDataSetAttributes* attributes) const
{
  // SetScalars() would throw the array out that was active until now.
  for (vtkDataArray* array : {static_cast<vtkDataArray*>(coverage_), distances_.Get(),
         static_cast<vtkDataArray*>(inside_), values_.Get()})
  {
    if (array)
    {
      attributes->AddArray(array);
      attributes->SetActiveScalars(array->GetName());
    }
  }
  if (showsInside_)
  {
    attributes->SetActiveScalars(inside_->GetName());
  }
}

} // namespace winding
