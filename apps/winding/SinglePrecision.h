#pragma once

class vtkPointSet;

/// What single precision makes of points.
enum class SinglePrecision
{
  holds,
  movesPoints, ///< by more than a ten-thousandth of the longest side of their bounds
  losesPoints  ///< they are too large for it, or so small that they fall together
};

SinglePrecision singlePrecisionOf(vtkPointSet* points);
