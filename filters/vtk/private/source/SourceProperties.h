// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/InsideRule.h"
#include "cloud/Viewpoints.h"
#include "messages/Options.h"
#include "messages/PropertyChecks.h"
#include "private/source/SourceField.h"
#include "surface/FlatBase.h"
#include "surface/Mirror.h"
#include "surface/SheetSide.h"

#include "vtkIndent.h"

#include <ostream>
#include <string>

/**
 * @file
 * The properties by which VTK's objects say how the field of a source is made, of which
 * vtkWindingNumberAlgorithm.h has the list, the meaning and the ranges. Objects of any class that
 * has them will do. Properties out of range throw Refusal (PropertyChecks.h).
 */
namespace winding
{

/// Returns whether a property has this number for a choice, as filters assert for each of theirs.
template <class Choice> constexpr bool isNumber(Choice choice, int number)
{
  return static_cast<int>(choice) == number;
}

/// The ways to the areas of a cloud's points. The core knows what it has to find itself (voronoi,
/// constant), and InputViews knows what the input has.
enum class PointAreasFrom
{
  voronoi,
  mesh,
  constant,
  array
};

///@{
/// The choice that has this number as a property. vtkWindingNumberAlgorithm.cxx asserts that the
/// numbers of its choices are these.
Method coreMethod(int method);
InsideRule coreInsideRule(int rule);
PointAreasFrom pointAreasFrom(int pointAreaMethod);
NormalEstimation coreNormalEstimation(int estimation);
///@}

/// The method by which the core finds the areas that do not come with the input.
PointAreaMethod corePointAreaMethod(PointAreasFrom areas);

/// The place in the input that the areas come from.
AreaSource areaSource(PointAreasFrom areas);

/// The text of a property that may be null.
inline std::string textOf(const char* text)
{
  return text ? text : "";
}

/// Throws unless the properties about the points of clouds are in range.
template <class Object> void checkCloudProperties(Object& object)
{
  checkProperty(Parameter::numberOfNeighbors, object.GetNumberOfNeighbors());
  checkProperty(Parameter::pointArea, object.GetPointArea());
}

/// Throws unless all properties that sourceOptions() takes are in range.
template <class Object> void checkSourceProperties(Object& object)
{
  coreMethod(object.GetMethod());
  checkProperty(Parameter::tolerance, object.GetTolerance());
  pointAreasFrom(object.GetPointAreaMethod());
  coreNormalEstimation(object.GetNormalEstimation());
  Viewpoints(textOf(object.GetToward()));
  Mirror(textOf(object.GetMirror()));
  FlatBase(textOf(object.GetFlatBase()));
  sheetSideIn(textOf(object.GetSheetSide()));
  checkProperty(Parameter::weldTolerance, object.GetWeldTolerance());
  checkCloudProperties(object);
  checkProperty(Parameter::regularization, object.GetRegularization());
}

/// The options that an object's properties are. FieldOptions says what `scattered` is. The object
/// is not changed, but VTK's getters are not const.
template <class Object> SourceOptions sourceOptions(Object& object, bool scattered)
{
  checkSourceProperties(object);
  const PointAreasFrom areas = pointAreasFrom(object.GetPointAreaMethod());
  SourceOptions options;
  options.input.asPoints = object.GetSourceAsPoints() != 0;
  options.input.takesFaces = object.GetUseSurfaceCells() != 0;
  options.input.normalsArray = textOf(object.GetNormalsArray());
  options.input.estimateNormals = object.GetEstimateNormals() != 0;
  options.input.weldTolerance = object.GetWeldTolerance();
  options.input.areas = areaSource(areas);
  options.input.areaArray = textOf(object.GetAreaArray());
  options.field.orientFaces = object.GetOrientFaces() != 0;
  options.field.ignoreOpenParts = object.GetIgnoreOpenParts() != 0;
  options.field.mirror = textOf(object.GetMirror());
  options.field.weldTolerance = object.GetWeldTolerance();
  options.field.flatBase = textOf(object.GetFlatBase());
  options.field.sheetSide = textOf(object.GetSheetSide());
  options.field.method = coreMethod(object.GetMethod());
  options.field.tolerance = object.GetTolerance();
  options.field.estimateNormals = object.GetEstimateNormals() != 0;
  options.field.warnsOfKeptNormals = isEstimateAsked();
  options.field.normalEstimation = coreNormalEstimation(object.GetNormalEstimation());
  options.field.toward = textOf(object.GetToward());
  options.field.pointAreaMethod = corePointAreaMethod(areas);
  options.field.pointArea = object.GetPointArea();
  options.field.neighbors = object.GetNumberOfNeighbors();
  options.field.regularization = object.GetRegularization();
  options.field.scattered = scattered;
  return options;
}

/// Prints the properties, for PrintSelf().
template <class Object>
void printSourceProperties(Object& object, std::ostream& os, vtkIndent indent)
{
  os << indent << "Method: " << object.GetMethod() << "\n";
  os << indent << "Tolerance: " << object.GetTolerance() << "\n";
  os << indent << "SourceAsPoints: " << object.GetSourceAsPoints() << "\n";
  os << indent << "UseSurfaceCells: " << object.GetUseSurfaceCells() << "\n";
  os << indent << "OrientFaces: " << object.GetOrientFaces() << "\n";
  os << indent << "IgnoreOpenParts: " << object.GetIgnoreOpenParts() << "\n";
  os << indent << "Mirror: " << textOf(object.GetMirror()) << "\n";
  os << indent << "FlatBase: " << textOf(object.GetFlatBase()) << "\n";
  os << indent << "SheetSide: " << textOf(object.GetSheetSide()) << "\n";
  os << indent << "WeldTolerance: " << object.GetWeldTolerance() << "\n";
  os << indent << "NormalsArray: " << textOf(object.GetNormalsArray()) << "\n";
  os << indent << "EstimateNormals: " << object.GetEstimateNormals() << "\n";
  os << indent << "NormalEstimation: " << object.GetNormalEstimation() << "\n";
  os << indent << "Toward: " << textOf(object.GetToward()) << "\n";
  os << indent << "NumberOfNeighbors: " << object.GetNumberOfNeighbors() << "\n";
  os << indent << "PointAreaMethod: " << object.GetPointAreaMethod() << "\n";
  os << indent << "PointArea: " << object.GetPointArea() << "\n";
  os << indent << "AreaArray: " << textOf(object.GetAreaArray()) << "\n";
  os << indent << "Regularization: " << object.GetRegularization() << "\n";
}

} // namespace winding
