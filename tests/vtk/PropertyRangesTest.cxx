// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"
#include "vtk/SphereCloud.h"

#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkImplicitWindingNumber.h"
#include "vtkNew.h"
#include "vtkPointData.h"
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
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace
{

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A value out of range, and how the error speaks of it.
template <class Value> using BadValues = std::vector<std::pair<Value, std::string>>;

const std::string number = "; it must be a finite number";
const std::string positive = "; it must be 0 or more";
const std::string finitePositive = "; it must be a finite number, 0 or more";

const BadValues<double> notFinite = {{nan, "nan" + number}, {infinity, "inf" + number}};
const BadValues<double> notPositive = {
  {-1e-9, "-1e-09" + positive}, {nan, "nan" + finitePositive}, {infinity, "inf" + finitePositive}};
const BadValues<int> negative = {{-1, "-1" + positive}};

/// Numbers that are none of the choices, and the choices.
BadValues<int> choices(const std::string& names, int beyond, int before = -1)
{
  const std::string range = "; it must be " + names;
  return {{before, std::to_string(before) + range}, {beyond, std::to_string(beyond) + range}};
}

const BadValues<int> methods =
  choices("AUTOMATIC (0), ROWS (1), HIERARCHICAL (2), DIRECT (3) or PARITY (4)", 5);
const BadValues<int> areaMethods = choices("VORONOI (0), MESH (1), CONSTANT (2) or ARRAY (3)", 4);
const BadValues<int> estimations =
  choices("ESTIMATION_AUTOMATIC (0), SPANNING_TREE (1) or WINDING_CONSISTENT (2)", 3);
const BadValues<int> insideRules = choices("SIGNED (0), ABSOLUTE (1) or ODD (2)", 3);
const BadValues<int> scalarTypes = choices("VTK_FLOAT (10) or VTK_DOUBLE (11)", 12, 9);
const BadValues<int> neighborCounts = {
  {2, "2; it must be 3 to 1000"}, {1001, "1001; it must be 3 to 1000"}};
const BadValues<double> regularizations = {{-0.5, "-0.5; it must be 0 to 4"},
  {4.5, "4.5; it must be 0 to 4"}, {nan, "nan; it must be a finite number, 0 to 4"}};

/// Returns whether the output of a filter is a data set without points.
bool isEmpty(vtkAlgorithm* filter)
{
  auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  return output && output->GetNumberOfPoints() == 0;
}

/// Whether something was made, without an error.
void expectWorking(vtkAlgorithm* filter)
{
  ErrorLog log(filter);
  filter->Update();
  EXPECT_EQ(log.errors(), "");
  EXPECT_FALSE(isEmpty(filter));
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

/// Every bad value is kept by its setter, reported in one line, and leaves the output empty; and
/// then the value from before works again.
template <class Filter, class Class, class Value>
void expectRefused(Filter* filter, const std::string& property, void (Class::*set)(Value),
  Value (Class::*get)(), const BadValues<Value>& badValues)
{
  SCOPED_TRACE(property);
  const Value before = (filter->*get)();
  for (const auto& [value, rest] : badValues)
  {
    ErrorLog log(filter);
    (filter->*set)(value);
    EXPECT_TRUE((filter->*get)() == value || value != value);
    filter->Update();
    EXPECT_NE(log.errors().find("): " + property + " is " + rest + "\n"), std::string::npos)
      << log.errors();
    EXPECT_EQ(linesOf(log.errors()), 1u) << log.errors();
    EXPECT_TRUE(isEmpty(filter));
    filter->RemoveAllObservers();
  }
  (filter->*set)(before);
}

#define EXPECT_REFUSED(filter, property, badValues)                                                \
  expectRefused(filter, #property, &std::decay_t<decltype(*(filter))>::Set##property,              \
    &std::decay_t<decltype(*(filter))>::Get##property, badValues)

template <class Filter> void expectCommonPropertiesRefused(Filter* filter)
{
  EXPECT_REFUSED(filter, Method, methods);
  EXPECT_REFUSED(filter, Tolerance, notPositive);
  EXPECT_REFUSED(filter, PointAreaMethod, areaMethods);
  EXPECT_REFUSED(filter, NormalEstimation, estimations);
  EXPECT_REFUSED(filter, NumberOfNeighbors, neighborCounts);
  EXPECT_REFUSED(filter, PointArea, notPositive);
  EXPECT_REFUSED(filter, Regularization, regularizations);
  EXPECT_REFUSED(filter, WindingThreshold, notFinite);
  EXPECT_REFUSED(filter, InsideRule, insideRules);
  EXPECT_REFUSED(filter, NumberOfThreads, negative);
  EXPECT_REFUSED(filter, LongestExpectedTime, notPositive);
}

template <class Filter> void expectPropertiesOfGridsRefused(Filter* filter)
{
  EXPECT_REFUSED(filter, Resolution, (BadValues<int>{{0, "0; it must be 1 or more"}}));
  EXPECT_REFUSED(filter, VoxelSize, notPositive);
  EXPECT_REFUSED(filter, Padding, notPositive);
  EXPECT_REFUSED(filter, VerifySamples, negative);
  ErrorLog log(filter);
  filter->SetSamplingDimensions(4, 4, 0);
  filter->Update();
  EXPECT_NE(
    log.errors().find("SamplingDimensions is 0 along z; it must be 1 or more"), std::string::npos)
    << log.errors();
  EXPECT_TRUE(isEmpty(filter));
  filter->SetSamplingDimensions(0, 0, 0);
  filter->RemoveAllObservers();
}

template <class Filter> void expectPropertiesOfImagesRefused(Filter* filter)
{
  expectCommonPropertiesRefused(filter);
  expectPropertiesOfGridsRefused(filter);
  EXPECT_REFUSED(filter, OutputAssociation, choices("POINTS (0) or CELLS (1)", 2));
  EXPECT_REFUSED(filter, Coverage, choices("CENTER (0), ANY (1) or FRACTION (2)", 3));
  EXPECT_REFUSED(filter, CoverageSamples,
    (BadValues<int>{{0, "0; it must be 1 to 10"}, {11, "11; it must be 1 to 10"}}));
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
  vtkWindingNumberField* filter = field;
  expectPropertiesOfImagesRefused(filter);
  EXPECT_REFUSED(filter, OutputScalarType, scalarTypes);
  EXPECT_REFUSED(filter, DistanceBand, notPositive);
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::REFUSED);
  expectWorking(field);
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::DONE);
}

TEST_F(PropertyRanges, OfTheLabels)
{
  vtkNew<vtkWindingNumberLabels> labels;
  labels->SetInputConnection(sphere->GetOutputPort());
  labels->SetResolution(6);
  vtkWindingNumberLabels* filter = labels;
  expectPropertiesOfImagesRefused(filter);
  EXPECT_REFUSED(filter, OverlapRule,
    choices("FIRST (0), LAST (1), LARGEST_WINDING_NUMBER (2) or SMALLEST_VOLUME (3)", 4));
  EXPECT_REFUSED(filter, CoverageArrays, choices("TWO_LARGEST (0) or EACH_LABEL (1)", 2));
  EXPECT_REFUSED(filter, LabelOffset,
    (BadValues<int>{{-65536, "-65536; it must be -65535 to 65535"},
      {65536, "65536; it must be -65535 to 65535"}}));
  EXPECT_EQ(labels->GetStatus(), vtkWindingNumberLabels::REFUSED);
  expectWorking(labels);
}

TEST_F(PropertyRanges, OfTheSurface)
{
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputConnection(sphere->GetOutputPort());
  surface->SetResolution(6);
  vtkWindingNumberSurface* filter = surface;
  expectCommonPropertiesRefused(filter);
  expectPropertiesOfGridsRefused(filter);
  EXPECT_REFUSED(filter, OutputPointsPrecision,
    choices("SINGLE_PRECISION (0), DOUBLE_PRECISION (1) or DEFAULT_PRECISION (2)", 3));
  EXPECT_REFUSED(filter, Features, choices("SMOOTH (0), SHARP (1) or VOXELS (2)", 3));
  EXPECT_REFUSED(filter, FidelitySamples, negative);
  expectWorking(surface);
}

TEST_F(PropertyRanges, OfTheBoolean)
{
  vtkNew<vtkWindingNumberBoolean> boolean;
  boolean->SetInputConnection(0, sphere->GetOutputPort());
  boolean->SetInputConnection(1, sphere->GetOutputPort());
  boolean->SetResolution(6);
  vtkWindingNumberBoolean* filter = boolean;
  expectCommonPropertiesRefused(filter);
  expectPropertiesOfGridsRefused(filter);
  EXPECT_REFUSED(filter, Operation,
    choices("UNION (0), INTERSECTION (1), DIFFERENCE (2) or SYMMETRIC_DIFFERENCE (3)", 4));
  EXPECT_REFUSED(filter, Features, choices("SMOOTH (0), SHARP (1) or VOXELS (2)", 3));
  expectWorking(boolean);
}

TEST_F(PropertyRanges, OfTheProbe)
{
  vtkNew<vtkWindingNumberProbe> probe;
  sphere->Update();
  probe->SetInputData(sphere->GetOutput());
  probe->SetSourceConnection(sphere->GetOutputPort());
  vtkWindingNumberProbe* filter = probe;
  expectCommonPropertiesRefused(filter);
  EXPECT_REFUSED(filter, OutputScalarType, scalarTypes);
  EXPECT_REFUSED(filter, ProbeAssociation, choices("POINTS (0) or CELLS (1)", 2));
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
  vtkWindingNumberClip* filter = clip;
  expectCommonPropertiesRefused(filter);
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
  vtkWindingNumberVoxels* filter = voxels;
  EXPECT_REFUSED(filter, WindingThreshold, notFinite);
  EXPECT_REFUSED(filter, InsideRule, insideRules);
  expectWorking(voxels);
}

TEST_F(PropertyRanges, OfNormals)
{
  vtkNew<vtkWindingNumberNormals> areas;
  areas->SetInputData(sphereCloud(100, 1));
  vtkWindingNumberNormals* filter = areas;
  EXPECT_REFUSED(filter, PointAreaMethod, choices("VORONOI (0), MESH (1) or CONSTANT (2)", 3));
  EXPECT_REFUSED(filter, NumberOfNeighbors, neighborCounts);
  EXPECT_REFUSED(filter, PointArea, notPositive);
  EXPECT_REFUSED(filter, NormalEstimation, estimations);
  EXPECT_REFUSED(filter, NumberOfThreads, negative);
  expectWorking(areas);
}

template <class Class, class Value>
void expectNoField(vtkImplicitWindingNumber* function, const std::string& property,
  void (Class::*set)(Value), Value (Class::*get)(), const BadValues<Value>& badValues)
{
  SCOPED_TRACE(property);
  const Value before = (function->*get)();
  for (const auto& [value, rest] : badValues)
  {
    ErrorLog log(function);
    (function->*set)(value);
    EXPECT_FALSE(function->BuildField());
    function->FunctionValue(0, 0, 0);
    EXPECT_NE(log.errors().find("): " + property + " is " + rest + "\n"), std::string::npos)
      << log.errors();
    EXPECT_EQ(linesOf(log.errors()), 1u) << "reported once";
    function->RemoveAllObservers();
  }
  (function->*set)(before);
}

#define EXPECT_NO_FIELD(function, property, badValues)                                             \
  expectNoField(function, #property, &vtkImplicitWindingNumber::Set##property,                     \
    &vtkImplicitWindingNumber::Get##property, badValues)

TEST_F(PropertyRanges, OfTheImplicitFunction)
{
  vtkNew<vtkImplicitWindingNumber> function;
  sphere->Update();
  function->SetInput(sphere->GetOutput());
  EXPECT_NO_FIELD(function, Method, methods);
  EXPECT_NO_FIELD(function, Tolerance, notPositive);
  EXPECT_NO_FIELD(function, PointAreaMethod, areaMethods);
  EXPECT_NO_FIELD(function, NormalEstimation, estimations);
  EXPECT_NO_FIELD(function, NumberOfNeighbors, neighborCounts);
  EXPECT_NO_FIELD(function, PointArea, notPositive);
  EXPECT_NO_FIELD(function, Regularization, regularizations);
  EXPECT_NO_FIELD(function, WindingThreshold, notFinite);
  EXPECT_NO_FIELD(function, InsideRule, choices("SIGNED (0) or ABSOLUTE (1)", 2));
  ErrorLog log(function);
  EXPECT_NEAR(function->FunctionValue(0, 0, 0), -0.5, 1e-6);
  EXPECT_NEAR(function->FunctionValue(9, 0, 0), 0.5, 1e-6);
  EXPECT_EQ(log.errors(), "");
}

TEST_F(PropertyRanges, NameChoicesAsThePanelsOfParaViewDo)
{
  using Filter = vtkWindingNumberAlgorithm;
  Filter::SetNamesInMessages(Filter::PARAVIEW_NAMES);
  vtkNew<vtkWindingNumberField> field;
  const ErrorLog log(field);
  field->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  field->SetMethod(9);
  field->Update();
  Filter::SetNamesInMessages(Filter::CXX_NAMES);
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
  vtkWindingNumberField* filter = field;
  EXPECT_REFUSED(filter, Resolution, (BadValues<int>{{-1, "-1; it must be 1 or more"}}));
  // User interfaces take these from the input, and an empty one has inverted bounds.
  field->SetSamplingBounds(1, -1, 1, -1, 1, -1);
  expectWorking(field);
}

} // namespace
