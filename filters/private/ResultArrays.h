#pragma once

#include "field/Field.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <string>

class vtkDataSetAttributes;

namespace winding
{

struct ResultOptions
{
  bool withValues = true;     ///< an array of w
  bool withInside = false;    ///< the array of what is inside
  bool withDistances = false; ///< the array "SignedDistance"
  bool withCoverage = false;  ///< the array "Coverage", of floats
  int scalarType = VTK_FLOAT; ///< of w and of distances: VTK_FLOAT or VTK_DOUBLE
  std::string name;           ///< of the array of w; empty: "WindingNumber"
  std::string insideName = "Inside";
};

/// What the arrays take for each sample, and, meanwhile, what evaluates them.
vtkIdType bytesPerSample(const ResultOptions& options);

/// The arrays that a filter adds to its output.
class ResultArrays
{
public:
  /// Throws Refusal for options that make no array or two of one name; OutOfMemory, with the numbers, for
  /// too many samples.
  ResultArrays(vtkIdType samples, const ResultOptions& options);

  /// Pointers into the arrays.
  FieldOutput output(InsideRule rule, double threshold) const;

  /// Null if there is no array of w.
  vtkDataArray* values() const { return values_; }

  /// Null if it was not asked for.
  vtkUnsignedCharArray* inside() const { return inside_; }
  vtkFloatArray* coverage() const { return coverage_; }

  /// Whether there is an array of what is inside, and nothing is.
  bool hasNothingInside() const;

  /// Adds them; the first of them becomes the active scalars.
  void addTo(vtkDataSetAttributes* attributes) const;

private:
  vtkSmartPointer<vtkDataArray> values_;
  vtkSmartPointer<vtkUnsignedCharArray> inside_;
  vtkSmartPointer<vtkFloatArray> coverage_;
  vtkSmartPointer<vtkDataArray> distances_;
};

} // namespace winding
