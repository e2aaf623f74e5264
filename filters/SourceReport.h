#pragma once

#include "vtkSmartPointer.h"

class vtkFieldData;

namespace winding
{

class Executor;
class InputViews;

/// The arrays of vtkSurfaceReport, in the order in which people read them: counts as vtkIdType, yes or
/// no as unsigned char, measures as double, words as strings. Throws what the core throws.
vtkSmartPointer<vtkFieldData> reportOn(InputViews& source, Executor& executor);

} // namespace winding
