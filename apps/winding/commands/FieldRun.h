// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "commands/FieldParts.h"
#include "commands/RunReport.h"
#include "files/ImageSpace.h"
#include "program/Stopwatch.h"

#include "vtkSmartPointer.h"
#include "vtkWindingNumberGridAlgorithm.h"

#include <functional>

class Messages;
struct Options;

/**
 * One run of a filter that samples a grid over the input of a command: the commands field, surface,
 * voxels and labels are made of it. WriteField.h writes what it gives. Its functions throw Failure
 * for whatever keeps them from being done. They are collective (ParallelRun.h): the first rank
 * reads and prints.
 */
class FieldRun
{
public:
  /// Reads the inputs and gives them to the filter, with the options. Keeps the references.
  FieldRun(vtkWindingNumberGridAlgorithm& filter, const Options& options, Messages& messages);
  ~FieldRun();

  const Options& options() const { return options_; }
  Messages& messages() const { return messages_; }
  vtkWindingNumberGridAlgorithm& filter() const { return filter_; }
  RunReport& report() { return report_; }

  /// Returns an image of the result with the space and all else of the image that it lies on.
  PlacedImage placed(vtkImageData* image) const;

  /// Makes the whole output of the filter.
  void update();

  /// Returns the number of pieces in which VTK's writer of images may ask for the field. Warns
  /// where the options ask for more.
  int pieces() const;

  /// Cuts the grid into `wanted` slabs (FieldParts.h). Warns where the options ask for more pieces
  /// than there are.
  std::vector<SlabExtent> slabs(std::size_t wanted, bool overlap) const;

  /// Makes the image of the slab of that number. Returns null if there are fewer; then this rank
  /// takes part in the execution with a single voxel.
  vtkImageData* makeSlab(const std::vector<SlabExtent>& slabs, std::size_t number);

  /// Throws Failure where an execution was not done, or the program was interrupted.
  void checkExecutions();

  /// Prints the report, and warns of what all pieces together say of the source.
  void printReport();

  /// Returns the time of all executions.
  double executionSeconds() const { return executionSeconds_; }

private:
  void check();
  void execute(const std::function<void()>& update);
  void startExecution();
  void addExecution();
  void warnOfPieces(std::size_t most) const;
  vtkInformation* imageInformation() const;
  SlabExtent wholeExtent() const;
  void checkPiecesKeepDirections() const;
  void checkOutput() const;

  vtkWindingNumberGridAlgorithm& filter_;
  const Options& options_;
  Messages& messages_;
  RunReport report_;
  PlacedImage like_;
  unsigned long startObserver_ = 0;
  unsigned long endObserver_ = 0;
  Stopwatch execution_;
  double executionSeconds_ = 0;

  /// Status of the first execution that was not DONE.
  int status_ = vtkWindingNumberAlgorithm::DONE;
  bool isIdle_ = false; ///< whether the execution is for the other ranks only
};
