#pragma once

#include "Report.h"

#include "vtkWindingNumberGridAlgorithm.h"

class Messages;
class OutputFile;
struct Options;
class vtkPolyData;

/**
 * One run of a filter that samples a grid over the input of a command, with the figures that it
 * reports: what field, surface and voxels have in common.
 */
class FieldRun
{
public:
  /// Reads the input and gives it to the filter, with the options. References are kept.
  FieldRun(vtkWindingNumberGridAlgorithm& filter, const Options& options, Messages& messages);
  ~FieldRun();

  /// Makes the whole output of the filter.
  void update();

  /// Writes the field that the filter gives, and evaluates it piece by piece where update() was not
  /// called.
  void write(OutputFile& file);

  /// Writes a surface that was made of the field or by the filter.
  void write(vtkPolyData* surface, OutputFile& file);

  /// The report so far; call it when the output is written.
  Json report();

  /// The same in a line or two for people.
  std::string summary(const Json& report) const;

private:
  void check();
  void checkExecutions();
  void startExecution();
  void addExecution();
  Json describeGrid() const;
  double distanceBand() const;
  void addErrors(Json& report) const;

  const Options& options_;
  Messages& messages_;
  vtkWindingNumberGridAlgorithm* filter_;
  unsigned long startObserver_ = 0;
  unsigned long endObserver_ = 0;
  Stopwatch stopwatch_;

  int status_ = vtkWindingNumberAlgorithm::DONE; ///< of the first execution that was not DONE
  double readSeconds_ = 0;
  double writeSeconds_ = 0;
  Stopwatch execution_;
  // Sums over the executions, one for each piece.
  double prepareSeconds_ = 0;
  double expectedSeconds_ = 0;
  vtkIdType expectedMemory_ = 0;
  double evaluateSeconds_ = 0;
  double verifySeconds_ = 0;
  double executionSeconds_ = 0; ///< all of these, and the little around them
  double maxError_ = 0;
  double nearMaxError_ = 0;
  double sumOfSquares_ = 0;
  vtkIdType verified_ = 0;
  vtkIdType nearVerified_ = 0;
};
