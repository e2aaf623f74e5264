#pragma once

#include "Report.h"

#include "vtkNew.h"
#include "vtkWindingNumberField.h"

class Messages;
class OutputFile;
struct Options;
class vtkImageData;

/**
 * One run of the field filter over the input of a command, with the figures that it reports: what
 * field, surface and voxels have in common.
 */
class FieldRun
{
public:
  /// Reads the input and lays out the grid.
  FieldRun(const Options& options, Messages& messages);
  ~FieldRun();

  /// Evaluates the whole field.
  vtkImageData* update();

  /// Writes the field, and evaluates it piece by piece where update() was not called.
  void write(OutputFile& file);

  /// The report so far; call it when the output is written.
  Json report();

  /// The same in a line or two for people.
  std::string summary(const Json& report) const;

private:
  void check();
  void checkExecutions();
  void addExecution();
  Json describeGrid() const;
  void addErrors(Json& report) const;

  const Options& options_;
  Messages& messages_;
  vtkNew<vtkWindingNumberField> filter_;
  unsigned long observer_ = 0;
  Stopwatch stopwatch_;

  int status_ = vtkWindingNumberAlgorithm::DONE; ///< of the first execution that was not DONE
  double readSeconds_ = 0;
  // Sums over the executions, one for each piece.
  double prepareSeconds_ = 0;
  double evaluateSeconds_ = 0;
  double maxError_ = 0;
  double nearMaxError_ = 0;
  double sumOfSquares_ = 0;
  vtkIdType verified_ = 0;
  vtkIdType nearVerified_ = 0;
};
