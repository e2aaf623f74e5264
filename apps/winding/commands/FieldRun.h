#pragma once

#include "commands/FieldParts.h"
#include "program/Print.h"
#include "program/Stopwatch.h"

#include "vtkSmartPointer.h"
#include "vtkWindingNumberGridAlgorithm.h"

#include <functional>

class Messages;
class OutputFile;
class PiecesFile;
struct Options;
class vtkHyperTreeGrid;
class vtkImageData;
class vtkPolyData;

/**
 * One run of a filter that samples a grid over the input of a command, with the figures that it
 * reports: the commands field, surface and voxels are made of it. Its functions throw Failure for
 * whatever keeps them from being done. They are collective (ParallelRun.h): the first rank reads,
 * prints and writes what is one file, and has the only pointers to files.
 */
class FieldRun
{
public:
  /// Reads the input and gives it to the filter, with the options. Keeps the references.
  FieldRun(vtkWindingNumberGridAlgorithm& filter, const Options& options, Messages& messages);

  /// Does what the other constructor does, with an input that is read in another way.
  FieldRun(vtkWindingNumberGridAlgorithm& filter, const Options& options, Messages& messages,
    const std::function<vtkSmartPointer<vtkDataObject>()>& read);
  ~FieldRun();

  /// Makes the whole output of the filter.
  void update();

  /// Writes the field that the filter gives, and evaluates it piece by piece where update() was not
  /// called. Warns where the grid cannot be cut into as many pieces as the options ask for.
  void write(OutputFile& file);

  /// Makes and writes the field in pieces, as many on each rank as the options ask for.
  void write(const PiecesFile& file);

  /// Makes the image of the whole grid, a slab on each rank. It is null on all ranks but the first.
  /// A single rank has the filter's own.
  vtkSmartPointer<vtkImageData> gather();

  /// Writes an image that was gathered to one file. Both are null on all ranks but the first.
  void write(vtkImageData* image, OutputFile* file);

  /// Writes a surface that was made of the field or by the filter. The file is null on all ranks
  /// but the first.
  void write(vtkPolyData* surface, OutputFile* file);

  /// Writes the field that the filter gave as a hyper tree grid with `leaves` leaves. The file
  /// is null on all ranks but the first.
  void write(vtkHyperTreeGrid* trees, vtkIdType leaves, OutputFile* file);

  /// Adds to the report.
  void addToReport(const char* key, const Json& value) { additions_[key] = value; }

  /// Prints the report on all ranks, as JSON or for people, once the output is written.
  void print();

private:
  void check();
  void checkExecutions();
  void startExecution();
  void addExecution();
  Json report() const;
  Json describeGrid() const;
  int pieces() const;
  std::vector<SlabExtent> slabs(std::size_t wanted, bool overlap) const;
  vtkImageData* makeSlab(const std::vector<SlabExtent>& slabs, std::size_t number);
  void gatherFigures();
  double distanceBand() const;
  void addErrors(Json& report) const;
  std::string errorsInWords(const Json& report) const;
  std::string summary(const Json& report) const;

  const Options& options_;
  Messages& messages_;
  vtkWindingNumberGridAlgorithm* filter_;
  unsigned long startObserver_ = 0;
  unsigned long endObserver_ = 0;
  Stopwatch stopwatch_;

  /// Status of the first execution that was not DONE.
  int status_ = vtkWindingNumberAlgorithm::DONE;
  bool isIdle_ = false; ///< whether the execution is for the other ranks only
  double readSeconds_ = 0;
  double writeSeconds_ = 0;
  double totalSeconds_ = 0;
  Json additions_ = Json::object(); ///< of addToReport()
  Json fidelity_; ///< how near a surface is to the input; null unless the options ask for it
  Json output_;   ///< describes what was written, unless it is an image; null then
  Stopwatch execution_;
  // Each piece is an execution of its own. Times, counts and squares are sums over all executions,
  // errors are maxima, and expectations are of the whole.
  double prepareSeconds_ = 0;
  double expectedSeconds_ = 0;
  vtkIdType expectedMemory_ = 0;
  double evaluateSeconds_ = 0;
  double verifySeconds_ = 0;
  double executionSeconds_ = 0; ///< times of whole executions
  double maxError_ = 0;
  double nearMaxError_ = 0;
  double sumOfSquares_ = 0;
  vtkIdType verified_ = 0;
  vtkIdType nearVerified_ = 0;
  vtkIdType onSurface_ = 0; ///< samples that were not compared
  vtkIdType besidePoints_ = 0;
  double maxErrorBesidePoints_ = 0;
  std::vector<double> peakMemories_; ///< of all ranks, in bytes
};
