#pragma once

#include "Field.h"
#include "Refusal.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <string>

class vtkDataSetAttributes;

namespace winding
{

/// Thrown before anything is allocated that would not fit.
class OutOfMemory : public Refusal
{
public:
  using Refusal::Refusal;
};

/// The arrays that a filter adds to its output.
class ResultArrays
{
public:
  /// scalarType is VTK_FLOAT or VTK_DOUBLE. Throws OutOfMemory, with the numbers.
  ResultArrays(vtkIdType samples, int scalarType, const std::string& name, bool withInside);

  /// Pointers into the arrays.
  FieldOutput output(InsideRule rule, double threshold) const;

  vtkDataArray* values() const { return values_; }

  /// Adds them; the values become the active scalars.
  void addTo(vtkDataSetAttributes* attributes) const;

private:
  vtkSmartPointer<vtkDataArray> values_;
  vtkSmartPointer<vtkUnsignedCharArray> inside_;
};

} // namespace winding
