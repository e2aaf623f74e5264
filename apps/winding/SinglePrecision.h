#pragma once

class vtkPointSet;

/// What single precision makes of points.
enum class SinglePrecision
{
  holds,
  movesPoints,     ///< by more than a ten-thousandth of the longest side of their bounds
  collapsesPoints, ///< by more than a tenth of that
  isExceeded       ///< their places, or the differences between them, are beyond its range
};

SinglePrecision singlePrecisionOf(vtkPointSet* points);
