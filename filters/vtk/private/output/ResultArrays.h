// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "field/Field.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindingABINamespace.h"

#include <optional>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSetAttributes;
VTK_ABI_NAMESPACE_END

namespace winding
{

class ContentHash;

///@{
/// The names of the arrays with the shares of cells, the shares of voxels, and distances.
constexpr const char* fractionName = "Fraction";
constexpr const char* coverageName = "Coverage";
constexpr const char* distanceName = "SignedDistance";
///@}

struct ResultOptions
{
  bool withValues = true;     ///< an array of w
  bool withInside = false;    ///< an array of 1 inside and 0 outside
  bool showsInside = false;   ///< whether that is active instead of w
  bool withDistances = false; ///< the array "SignedDistance"
  bool withCoverage = false;  ///< the array "Coverage", of floats
  bool withFraction = false;  ///< the array of cells named fractionName, which the filter makes
  bool withNearest = false;   ///< whether others make ids of nearest cells (NearestAttributes.h)
  int scalarType = VTK_FLOAT; ///< type of w and of distances: VTK_FLOAT or VTK_DOUBLE
  std::string name;           ///< name of the array of w; empty for "WindingNumber"
  std::string insideName = "Inside";
  std::vector<Remedy> remedies = {largerVoxels(), inPieces()}; ///< where memory is short
};

/// Returns the memory of `samples` samples: of the arrays, and of the evaluation meanwhile.
double bytesOf(const ResultOptions& options, vtkIdType samples);

/// Adds what decides on the arrays to `hash`.
void addTo(ContentHash& hash, const ResultOptions& options);

/// An array of one number for each sample, which are not set, in large pages of memory where the
/// system has them: touching fresh memory in small pages for the first time takes several times as
/// long as filling it.
vtkSmartPointer<vtkDataArray> makeResultArray(int type, const std::string& name, vtkIdType samples);

/// The arrays that a filter adds to its output.
class ResultArrays
{
public:
  /// Throws Refusal for options that make no array or two of one name, and OutOfMemory, with the
  /// numbers, for too many samples.
  ResultArrays(vtkIdType samples, const ResultOptions& options);

  /// Pointers into the arrays.
  FieldOutput output(const InsideTest& isInside) const;

  /// The array of w; null if there is none.
  vtkDataArray* values() const { return values_; }

  ///@{
  /// The array of this name; null if it was not asked for.
  vtkUnsignedCharArray* inside() const { return inside_; }
  vtkFloatArray* coverage() const { return coverage_; }
  ///@}

  /// Returns how many samples the array of what is inside has a 1 for; nothing without that array.
  std::optional<vtkIdType> countInside() const;

  /// Returns whether a sample is inside, by the first of these that there is: the array of what is
  /// inside, values compared by the rule, distances below 0.
  bool isInside(std::size_t sample, const InsideTest& isInside) const;

  /// Adds the arrays. The first becomes the active scalars, or what is inside where that shows.
  void addTo(vtkDataSetAttributes* attributes) const;

private:
  bool showsInside_;
  vtkSmartPointer<vtkDataArray> values_;
  vtkSmartPointer<vtkUnsignedCharArray> inside_;
  vtkSmartPointer<vtkFloatArray> coverage_;
  vtkSmartPointer<vtkDataArray> distances_;
};

} // namespace winding
