// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindingNumberProbeAlgorithm
 * @brief   base class of winding-number filters that evaluate the points or cells of a data set
 *
 * Port 0 takes the data set that says where to evaluate, any vtkDataSet or a composite of them.
 * Port 1 takes the source, a surface or an oriented point cloud (see vtkWindingNumberAlgorithm).
 *
 * A closed surface gives integers, the right ones off the surface (method ROWS, which AUTOMATIC
 * takes then). For any other source the value of a point depends on the other points, but only
 * within the Tolerance, and not at all with method DIRECT or Tolerance 0.
 *
 * The points or cells of an image are evaluated as a grid, as vtkWindingNumberField does: values
 * are the same up to the Tolerance, and come ten times as fast. An image with a direction matrix,
 * or with negative spacings, is a grid along its own axes, where these are at right angles up to
 * 1e-5, as NIfTI's are in single precision: distances have that relative error. Axes that are more
 * askew make its samples scattered points.
 *
 * The output for a composite data set has the same structure. All samples of its data sets are
 * evaluated at once; empty places and other kinds of data stay as they are. Field data that says
 * how the result came about is added to the output and to every data set in it. AMR data goes
 * through the filter block by block.
 *
 * @sa vtkWindingNumberProbe vtkWindingNumberClip
 */
#ifndef vtkWindingNumberProbeAlgorithm_h
#define vtkWindingNumberProbeAlgorithm_h

#include "vtkSmartPointer.h" // for the flags that IsInside() reads
#include "vtkWindingABINamespace.h"
#include "vtkWindingNumberAlgorithm.h"

namespace winding
{
class ProbeQueries;
class ResultArrays;
class SmpExecutor;
struct ProbeLeaf;
struct ProbeWords;
struct ResultOptions;
} // namespace winding
VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
class vtkDataSetAttributes;
class vtkUnsignedCharArray;

class VTKFILTERSWINDING_EXPORT vtkWindingNumberProbeAlgorithm : public vtkWindingNumberAlgorithm
{
public:
  vtkTypeMacro(vtkWindingNumberProbeAlgorithm, vtkWindingNumberAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The surface or cloud whose winding number is asked for: port 1.
  void SetSourceConnection(vtkAlgorithmOutput* source);
  void SetSourceData(vtkDataObject* source);
  ///@}

  ///@{
  /// Whether inside and outside change places, also for IsInside(). w and distances stay what they
  /// are. Default off.
  vtkSetMacro(InsideOut, vtkTypeBool);
  vtkGetMacro(InsideOut, vtkTypeBool);
  vtkBooleanMacro(InsideOut, vtkTypeBool);
  ///@}

  /// Whether a sample of the last input is inside, whatever the output is; 0 for a number that is
  /// too large. In composite data, numbers go on from one data set to the next.
  int IsInside(vtkIdType queryId);

  /// Whether Status is REFUSED because of port 0: the data set contradicts itself, for example by
  /// cells with ids of points that do not exist.
  bool GetQueriesWereRefused() const { return this->Status == REFUSED && this->QueriesRefused; }

  /// The output, if it is a data set. Null for composite data, which GetOutputDataObject(0) has.
  vtkDataSet* GetOutput();

protected:
  vtkWindingNumberProbeAlgorithm();
  ~vtkWindingNumberProbeAlgorithm() override = default;

  vtkWindingNumberProbeAlgorithm(const vtkWindingNumberProbeAlgorithm&) = delete;
  void operator=(const vtkWindingNumberProbeAlgorithm&) = delete;

  bool EvaluatesGrid() const override { return this->QueriesAreGrid; }
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;

  int RequestDataObject(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void HashProperties(winding::ContentHash& hash) override;
  double GetResultBytes(vtkIdType samples) const override;

  /// Returns whether the samples are the centres of cells rather than points.
  virtual bool SamplesCells() const { return false; }

  /// Returns whether the output is a part of the data set, so that its cells are used.
  virtual bool KeepsPart() const = 0;

  /// Returns whether anything is done with the cells of the data set.
  virtual bool UsesCells() const { return this->KeepsPart(); }

  /// Returns how refusals speak of what the filter does.
  virtual const winding::ProbeWords& GetWords() const = 0;

  /// Returns the arrays of the result that users ask for. Sides are made even if nobody does.
  virtual winding::ResultOptions GetResultOptions() const = 0;

  /// Makes a new output for `input`: one of the same class, unless it is a part of a data set.
  virtual vtkSmartPointer<vtkDataObject> NewOutput(vtkDataObject* input) const;

  /// Returns the progress when all samples are evaluated. What a filter does after that has the
  /// rest.
  virtual double GetProgressOfSamples() const { return 1; }

  /// Evaluates what else there is, from the progress of samples on, within the limit of time.
  virtual void EvaluateMore(const winding::Field& field, const winding::ProbeQueries& queries,
    winding::SmpExecutor& executor);

  /// Adds to the answer for a leaf what is not an array of samples.
  virtual void AddLeafArrays(vtkDataSet* answer, const winding::ProbeLeaf& leaf) const;

  /// Does the rest of the evaluation, before any output is written. `inside` has an entry for each
  /// sample.
  virtual void FinishSamples(
    const winding::Field& field, const winding::ProbeQueries& queries, const unsigned char* inside);

  /// Adds the arrays that the output of all samples has.
  virtual void AddArrays(const winding::ResultArrays& results, vtkDataSetAttributes* ofAll) const;

  /// Returns the part of a data set that is kept, with all of its arrays, if KeepsPart(). `inside`
  /// has an entry for each sample of the leaf.
  virtual vtkSmartPointer<vtkDataSet> PartOf(
    vtkDataSet* data, const winding::ProbeLeaf& leaf, const unsigned char* inside) = 0;

  vtkTypeBool InsideOut = 0;
  bool QueriesRefused = false;
  bool QueriesAreGrid = false; ///< of an image, in the last execution

private:
  void WarnOfEmpty();
  void WarnOfNotFinite(const winding::ProbeQueries& queries);
  void WarnOfOutside(const winding::Field& field, const winding::ProbeQueries& queries,
    const winding::ResultArrays& results);
  void EvaluateSamples(const winding::Field& field, const winding::ProbeQueries& queries,
    const winding::ResultArrays& results);

  /// The output for one data set, with its part of the arrays of all data sets.
  vtkSmartPointer<vtkDataSet> AnswerTo(const winding::ProbeQueries& queries,
    const winding::ProbeLeaf& leaf, vtkDataSetAttributes* ofAll);
  void WriteOutput(vtkDataObject* input, const winding::ProbeQueries& queries,
    const winding::ResultArrays& results, vtkDataObject* output);

  vtkSmartPointer<vtkUnsignedCharArray> InsideFlags; ///< one for each query; null before the first
};
VTK_ABI_NAMESPACE_END

#endif
