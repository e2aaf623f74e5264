// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"
#include "vtk/ListedOptions.h"
#include "vtk/SphereCloud.h"

#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkImplicitWindingNumber.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkWindingNumberBoolean.h"
#include "vtkWindingNumberClip.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberLabels.h"
#include "vtkWindingNumberNormals.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberSurface.h"
#include "vtkWindingNumberVoxels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{

std::string inText(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

/// Returns values out of the range that the list gives an option, and how the error speaks of each.
/// A class has the first `choices` choices.
std::vector<std::pair<double, std::string>> badValues(const Listed& option, std::size_t choices)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> values;
  std::string range;
  if (option.kind == "choice")
  {
    for (std::size_t i = 0; i < choices; ++i)
    {
      const auto& [number, constant] = option.choices[i];
      range += (i == 0 ? "" : i + 1 == choices ? " or " : ", ") + constant;
      range += " (" + std::to_string(number) + ")";
    }
    values = {option.choices[0].first - 1.0, option.choices[choices - 1].first + 1.0};
  }
  else if (option.kind == "integer" || option.kind == "number")
  {
    const bool isWhole = option.kind == "integer";
    if (std::isfinite(option.lowest))
    {
      range = inText(option.lowest) + " or more";
      values.push_back(option.lowest - (isWhole ? 1 : 1e-9));
    }
    if (std::isfinite(option.highest))
    {
      range = inText(option.lowest) + " to " + inText(option.highest);
      values.push_back(option.highest + (isWhole ? 1 : 0.5));
    }
    if (!isWhole)
    {
      values.insert(values.end(), {infinity, NAN});
    }
  }
  const std::string finite = range.empty() ? "a finite number" : "a finite number, ";
  std::vector<std::pair<double, std::string>> bad;
  for (const double value : values)
  {
    bad.emplace_back(
      value, inText(value) + "; it must be " + (std::isfinite(value) ? "" : finite) + range);
  }
  return bad;
}

/// Returns whether the output of a filter is a data set without points.
bool isEmpty(vtkAlgorithm* filter)
{
  auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  return output && output->GetNumberOfPoints() == 0;
}

/// Returns whether something is made, which the error code has to agree with.
bool gives(vtkAlgorithm& filter)
{
  filter.Update();
  const bool isMade = !isEmpty(&filter);
  EXPECT_EQ(filter.GetErrorCode() == vtkErrorCode::NoError, isMade);
  EXPECT_EQ(filter.GetErrorCode() == vtkErrorCode::UserError, !isMade);
  return isMade;
}

/// Expects that something is made, without an error.
void expectWorking(vtkAlgorithm* filter)
{
  ErrorLog log(filter);
  EXPECT_TRUE(gives(*filter));
  EXPECT_EQ(log.errors(), "");
  filter->RemoveAllObservers();
}

std::size_t linesOf(const std::string& errors)
{
  std::size_t lines = 0;
  for (std::size_t at = errors.find("ERROR: "); at != std::string::npos; ++lines)
  {
    at = errors.find("ERROR: ", at + 1);
  }
  return lines;
}

bool gives(vtkImplicitWindingNumber& function)
{
  const bool isBuilt = function.BuildField();
  function.FunctionValue(0, 0, 0); // has no error of its own
  return isBuilt;
}

template <class Filter> Filter& propertiesOf(Filter& filter)
{
  return filter;
}

vtkWindingNumberField& propertiesOf(vtkImplicitWindingNumber& function)
{
  return *function.GetField();
}

/// Expects that every bad value is kept by its setter, reported in one line, and leaves nothing.
/// Sets the value from before then. Returns whether the filter has the property and its range.
template <class Property, class Filter>
bool isRefused(Filter& filter, const std::string& name, std::size_t mostChoices)
{
  SCOPED_TRACE(name);
  const Listed& option = listed().at(name);
  auto& properties = propertiesOf(filter);
  const double before = Property::get(properties, 0);
  const auto bad = badValues(option, std::min(mostChoices, option.choices.size()));
  if (std::isnan(before) || bad.empty())
  {
    return false;
  }
  for (const auto& [value, rest] : bad)
  {
    ErrorLog log(&filter);
    EXPECT_TRUE(Property::set(properties, Value(value), 0));
    EXPECT_TRUE(Property::get(properties, 0) == value || value != value);
    EXPECT_FALSE(gives(filter));
    EXPECT_NE(log.errors().find("): " + name + " is " + rest + "\n"), std::string::npos)
      << rest << log.errors();
    EXPECT_EQ(linesOf(log.errors()), 1u) << log.errors();
    filter.RemoveAllObservers();
  }
  Property::set(properties, Value(before), 0);
  return true;
}

/// Expects that the ranges of the list are those of all `count` properties which have one.
/// `choices` has the options of which a class has the first choices only.
template <class Filter>
void expectRefused(
  Filter* filter, int count, const std::map<std::string, std::size_t>& choices = {})
{
  int found = 0;
#define REFUSED(name)                                                                              \
  found += isRefused<Of##name>(*filter, #name, choices.count(#name) ? choices.at(#name) : 99);
  PROPERTIES(REFUSED)
  EXPECT_EQ(found, count);
}

template <class Filter> void expectRefusedOnGrids(Filter* filter, int count)
{
  expectRefused(filter, count);
  ErrorLog log(filter);
  filter->SetSamplingDimensions(4, 4, 0);
  EXPECT_FALSE(gives(*filter));
  EXPECT_NE(
    log.errors().find("SamplingDimensions is 0 along z; it must be 1 or more"), std::string::npos)
    << log.errors();
  filter->SetSamplingDimensions(0, 0, 0);
  filter->RemoveAllObservers();
}

class PropertyRanges : public testing::Test
{
protected:
  vtkNew<vtkSphereSource> sphere;
};

TEST_F(PropertyRanges, OfTheField)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetResolution(6);
  expectRefusedOnGrids(field.Get(), 22);
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::REFUSED);
  expectWorking(field);
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::DONE);
}

TEST_F(PropertyRanges, OfTheLabels)
{
  vtkNew<vtkWindingNumberLabels> labels;
  labels->SetInputConnection(sphere->GetOutputPort());
  labels->SetResolution(6);
  expectRefusedOnGrids(labels.Get(), 23);
  EXPECT_EQ(labels->GetStatus(), vtkWindingNumberLabels::REFUSED);
  expectWorking(labels);
}

TEST_F(PropertyRanges, OfTheSurface)
{
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputConnection(sphere->GetOutputPort());
  surface->SetResolution(6);
  expectRefusedOnGrids(surface.Get(), 24);
  expectWorking(surface);
}

TEST_F(PropertyRanges, OfTheBoolean)
{
  vtkNew<vtkWindingNumberBoolean> boolean;
  boolean->SetInputConnection(0, sphere->GetOutputPort());
  boolean->SetInputConnection(1, sphere->GetOutputPort());
  boolean->SetResolution(6);
  expectRefusedOnGrids(boolean.Get(), 20);
  expectWorking(boolean);
}

TEST_F(PropertyRanges, OfTheProbe)
{
  vtkNew<vtkWindingNumberProbe> probe;
  sphere->Update();
  probe->SetInputData(sphere->GetOutput());
  probe->SetSourceConnection(sphere->GetOutputPort());
  expectRefused(probe.Get(), 15);
  EXPECT_EQ(probe->IsInside(0), 0) << "there is no last result";
  expectWorking(probe);
}

TEST_F(PropertyRanges, OfTheClip)
{
  vtkNew<vtkSphereSource> data;
  data->SetCenter(0.3, 0, 0);
  vtkNew<vtkWindingNumberClip> clip;
  clip->SetInputConnection(data->GetOutputPort());
  clip->SetSourceConnection(sphere->GetOutputPort());
  expectRefused(clip.Get(), 13);
  EXPECT_EQ(clip->GetStatus(), vtkWindingNumberClip::REFUSED);
  expectWorking(clip);
}

TEST_F(PropertyRanges, OfVoxels)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetResolution(6);
  vtkNew<vtkWindingNumberVoxels> voxels;
  voxels->SetInputConnection(field->GetOutputPort());
  expectRefused(voxels.Get(), 2);
  ErrorLog log(voxels);
  voxels->SetByLabel(3);
  EXPECT_FALSE(gives(*voxels));
  EXPECT_NE(log.errors().find(
              "ByLabel is 3; it must be LABELS_OFF (0), LABELS_ON (1) or LABELS_AUTOMATIC (2)"),
    std::string::npos)
    << log.errors();
  voxels->SetByLabelToAutomatic();
  voxels->RemoveAllObservers();
  expectWorking(voxels);
}

TEST_F(PropertyRanges, OfNormals)
{
  vtkNew<vtkWindingNumberNormals> areas;
  areas->SetInputData(sphereCloud(100, 1));
  expectRefused(areas.Get(), 6, {{"PointAreaMethod", 3}}); // without ARRAY
  expectWorking(areas);
}

TEST_F(PropertyRanges, OfTheImplicitFunction)
{
  vtkNew<vtkImplicitWindingNumber> function;
  sphere->Update();
  function->SetInput(sphere->GetOutput());
#define EXPECT_NO_FIELD(name, choices) EXPECT_TRUE(isRefused<Of##name>(*function, #name, choices))
  EXPECT_NO_FIELD(Method, 5);
  EXPECT_NO_FIELD(Tolerance, 0);
  EXPECT_NO_FIELD(WeldTolerance, 0);
  EXPECT_NO_FIELD(NormalEstimation, 3);
  EXPECT_NO_FIELD(PointAreaMethod, 4);
  EXPECT_NO_FIELD(PointArea, 0);
  EXPECT_NO_FIELD(NumberOfNeighbors, 0);
  EXPECT_NO_FIELD(Regularization, 0);
  EXPECT_NO_FIELD(WindingThreshold, 0);
  EXPECT_NO_FIELD(InsideRule, 2); // without ODD
  ErrorLog log(function);
  EXPECT_NEAR(function->FunctionValue(0, 0, 0), -0.5, 1e-6);
  EXPECT_NEAR(function->FunctionValue(9, 0, 0), 0.5, 1e-6);
  EXPECT_EQ(log.errors(), "");
}

TEST_F(PropertyRanges, NameChoicesAsThePanelsOfParaViewDo)
{
  using Filter = vtkWindingNumberAlgorithm;
  vtkNew<vtkWindingNumberField> field;
  const ErrorLog log(field);
  field->SetNamesInMessages(4);
  EXPECT_FALSE(gives(*field));
  EXPECT_NE(log.errors().find("NamesInMessages is 4; it must be 0 to 3"), std::string::npos);
  field->SetNamesInMessages(Filter::PARAVIEW_NAMES);
  field->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  field->SetMethod(9);
  field->Update();
  EXPECT_NE(log.errors().find("Method is 9; it must be Automatic (0), Rows (1), Hierarchical (2), "
                              "Direct Sum (3) or Ray Parity (4)"),
    std::string::npos)
    << log.errors();
}

TEST_F(PropertyRanges, AreCheckedWhereAPropertyHasNoEffectToo)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetVoxelSize(0.25);
  EXPECT_TRUE(isRefused<OfResolution>(*field, "Resolution", -1));
  // User interfaces take these from the input, and an empty one has inverted bounds.
  field->SetSamplingBounds(1, -1, 1, -1, 1, -1);
  expectWorking(field);
}

} // namespace
