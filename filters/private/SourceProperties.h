#pragma once

#include "private/SourceField.h"

#include "vtkIndent.h"

#include <ostream>
#include <string>

/**
 * @file
 * The properties by which VTK's objects say how the field of a source is made, of which
 * vtkWindingNumberAlgorithm.h has the list and the meaning. Objects of any class that has them will do.
 */
namespace winding
{

/// Throws Refusal unless it is a vtkWindingNumberAlgorithm::MethodType.
Method coreMethod(int method);

/// Throws Refusal unless it is a vtkWindingNumberAlgorithm::PointAreaMethodType.
PointAreaMethod corePointAreaMethod(int method);

/// Where the input says which areas its points have, if that is the method.
AreaSource areaSource(int pointAreaMethod);

/// Of a property that may be null.
inline std::string textOf(const char* text)
{
  return text ? text : "";
}

/// scattered: see FieldOptions. Throws Refusal. The object is not changed; VTK's getters are not const.
template <class Object> SourceOptions sourceOptions(Object& object, bool scattered)
{
  SourceOptions options;
  options.input.asPoints = object.GetSourceAsPoints() != 0;
  options.input.normalsArray = textOf(object.GetNormalsArray());
  options.input.estimateNormals = object.GetEstimateNormals() != 0;
  options.input.areas = areaSource(object.GetPointAreaMethod());
  options.input.areaArray = textOf(object.GetAreaArray());
  options.field.method = coreMethod(object.GetMethod());
  options.field.tolerance = object.GetTolerance();
  options.field.estimateNormals = object.GetEstimateNormals() != 0;
  options.field.pointAreaMethod = corePointAreaMethod(object.GetPointAreaMethod());
  options.field.pointArea = object.GetPointArea();
  options.field.neighbors = object.GetNumberOfNeighbors();
  options.field.regularization = object.GetRegularization();
  options.field.scattered = scattered;
  return options;
}

/// For PrintSelf().
template <class Object>
void printSourceProperties(Object& object, std::ostream& os, vtkIndent indent)
{
  os << indent << "Method: " << object.GetMethod() << "\n";
  os << indent << "Tolerance: " << object.GetTolerance() << "\n";
  os << indent << "SourceAsPoints: " << object.GetSourceAsPoints() << "\n";
  os << indent << "NormalsArray: " << textOf(object.GetNormalsArray()) << "\n";
  os << indent << "EstimateNormals: " << object.GetEstimateNormals() << "\n";
  os << indent << "NumberOfNeighbors: " << object.GetNumberOfNeighbors() << "\n";
  os << indent << "PointAreaMethod: " << object.GetPointAreaMethod() << "\n";
  os << indent << "PointArea: " << object.GetPointArea() << "\n";
  os << indent << "AreaArray: " << textOf(object.GetAreaArray()) << "\n";
  os << indent << "Regularization: " << object.GetRegularization() << "\n";
}

} // namespace winding
