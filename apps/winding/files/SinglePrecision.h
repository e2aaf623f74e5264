#pragma once

class vtkPointSet;

/// Tells how well single precision holds the coordinates of points.
enum class SinglePrecision
{
  holds,           ///< rounding moves points by less than what follows
  movesPoints,     ///< by more than a ten-thousandth of the longest side of their bounds
  collapsesPoints, ///< by more than a tenth of the longest side of their bounds
  isExceeded       ///< coordinates, or differences between them, are beyond its range
};

/// The answer for points by their bounds; `holds` if there are none.
SinglePrecision singlePrecisionOf(vtkPointSet* points);
