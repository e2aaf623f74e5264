// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/ImageSpace.h"
#include "program/Print.h"
#include "program/Stopwatch.h"

#include "vtkType.h"
#include "vtkWindingABINamespace.h"

#include <string>
#include <vector>

struct Options;
VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
class vtkWindingNumberGridAlgorithm;
VTK_ABI_NAMESPACE_END

/// The figures of a run of a filter (FieldRun.h) since this was made, and the report on them.
class RunReport
{
public:
  /// Keeps the references.
  RunReport(vtkWindingNumberGridAlgorithm& filter, const Options& options);

  /// Takes the figures of an execution of the filter that took `seconds`.
  void addExecution(double seconds);

  /// Adds to the report.
  void add(const char* key, const Json& value) { additions_[key] = value; }

  /// Sets what was written, unless it is an image.
  void setOutput(const Json& output) { output_ = output; }

  /// Warns of a source that is inside out and of a field without samples inside, if it was made in
  /// pieces: as a whole it has warned of that itself. Collective.
  void warnOfPieces();

  /// Takes how near a surface is to the input from the arrays of FidelitySamples
  /// (vtkWindingNumberSurface.h), if it has any.
  void takeFidelity(vtkPolyData* surface);

  void setReadSeconds(double seconds) { readSeconds_ = seconds; }
  void setWriteSeconds(double seconds) { writeSeconds_ = seconds; }

  /// Prints the report, as JSON or for people, once the output is written. Collective.
  void print();

  /// Takes the image that the result lies on, which the grid is described by then.
  void setLike(const PlacedImage& place) { like_ = place; }

private:
  Json describeLike() const;
  void gatherFigures();
  Json report() const;
  Json describeGrid() const;
  bool isInPieces() const;
  double distanceBand() const;
  void addErrors(Json& report) const;
  std::string errorsInWords(const Json& report) const;
  std::string uncomparedInWords(const Json& report) const;
  std::string summary(const Json& report) const;

  vtkWindingNumberGridAlgorithm& filter_;
  const Options& options_;
  Stopwatch stopwatch_;
  Json additions_ = Json::object(); ///< of add()
  PlacedImage like_;                ///< empty if there is none
  Json fidelity_;                   ///< null unless the options ask for it
  std::string fidelityInWords_;
  Json output_; ///< null for an image
  double readSeconds_ = 0;
  double writeSeconds_ = 0;
  double totalSeconds_ = 0;
  // Each piece is an execution of its own. Times, counts and squares are sums over all executions,
  // errors are maxima, and expectations are of the whole.
  double prepareSeconds_ = 0;
  double expectedSeconds_ = 0;
  vtkIdType expectedMemory_ = 0;
  double evaluateSeconds_ = 0;
  double verifySeconds_ = 0;
  double maxError_ = 0;
  double nearMaxError_ = 0;
  double sumOfSquares_ = 0;
  vtkIdType verified_ = 0;
  vtkIdType nearVerified_ = 0;
  vtkIdType onSurface_ = 0; ///< samples that were not compared
  vtkIdType besidePoints_ = 0;
  double maxErrorBesidePoints_ = 0;
  vtkIdType inside_ = 0;             ///< samples of a field
  vtkIdType sampleCounts_[4] = {};   ///< of vtkWindingNumberField
  std::vector<double> peakMemories_; ///< of all ranks, in bytes
};
