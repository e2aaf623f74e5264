/**
 * @class   vtkWindingNumberProbe
 * @brief   winding number at the points or cells of any data set
 *
 * Port 0 takes the data set that says where to evaluate, any vtkDataSet or a composite of them.
 * Port 1 takes the source, a surface or an oriented point cloud (see vtkWindingNumberAlgorithm).
 * The output is a shallow copy of port 0 with the array "WindingNumber" and, if asked for, "Inside"
 * and "SignedDistance"; ExtractInside keeps only the part of it that is inside. The ports are as
 * for vtkPointInterpolator. The filter does what vtkSelectEnclosedPoints does, but on surfaces that
 * need not be closed.
 *
 * @code
 *   vtkNew<vtkWindingNumberProbe> probe;
 *   probe->SetInputConnection(points->GetOutputPort());
 *   probe->SetSourceConnection(surface->GetOutputPort());
 *   probe->GenerateInsideOn();
 * @endcode
 *
 * A closed surface gives integers, the right ones off the surface (method ROWS, which AUTOMATIC
 * takes then). For any other source the value of a point depends on the other points, but only
 * within the Tolerance, and not at all with method DIRECT or Tolerance 0. Points that are NaN or
 * infinite get NaN, as value and as distance, and are neither inside nor outside.
 *
 * The points or cells of an image that is not turned are evaluated as a grid, as
 * vtkWindingNumberField does: values are the same up to the Tolerance, and come ten times as fast.
 *
 * The output for a composite data set has the same structure. Every vtkDataSet in it gets its
 * arrays, all of them evaluated at once; empty places and other kinds of data stay as they are.
 * Field data that says how the result came about is added to the output and to every data set in
 * it. AMR data goes through the filter block by block.
 *
 * **Instead of vtkSelectEnclosedPoints.** These edits make the filter a replacement, also for
 * readers of the output and callers of IsInside():
 * @code
 *   vtkNew<vtkWindingNumberProbe> select; // another class
 *   select->SetInputConnection(points->GetOutputPort());
 *   select->SetSurfaceConnection(surface->GetOutputPort());
 *   select->InsideOutOn();                        // if it was on
 *   select->GenerateInsideOn();                   // the array of 0 and 1
 *   select->SetInsideArrayName("SelectedPoints"); // has this name there,
 *   select->GenerateWindingNumberOff();           // and is the only one, and active
 * @endcode
 * CheckSurface has no counterpart, for the surface need not be closed. Take SetTolerance() out:
 * here it bounds the error of w, and the default is good. vtkImplicitWindingNumber takes the place
 * of Initialize(), IsInsideSurface() and Complete(). Surfaces whose triangles face inward have w =
 * −1 inside; use InsideRule ABSOLUTE where that may be so.
 *
 * @sa vtkWindingNumberField vtkImplicitWindingNumber vtkSelectEnclosedPoints
 */
#ifndef vtkWindingNumberProbe_h
#define vtkWindingNumberProbe_h

#include "vtkSmartPointer.h" // for the flags that IsInside() reads
#include "vtkWindingNumberAlgorithm.h"

namespace winding
{
class VectorsView;
class ProbeQueries;
class SmpExecutor;
struct ProbeLeaf;
struct ProbeWords;
} // namespace winding
class vtkDataSet;
class vtkUnsignedCharArray;

class VTKFILTERSWINDING_EXPORT vtkWindingNumberProbe : public vtkWindingNumberAlgorithm
{
public:
  static vtkWindingNumberProbe* New();
  vtkTypeMacro(vtkWindingNumberProbe, vtkWindingNumberAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Where w is evaluated.
  enum ProbeAssociationType
  {
    POINTS = 0, ///< at the points; the result is point data
    CELLS = 1   ///< at the parametric centres of the cells; the result is cell data
  };

  ///@{
  /// The surface or cloud whose winding number is asked for: port 1.
  void SetSourceConnection(vtkAlgorithmOutput* source);
  void SetSourceData(vtkDataObject* source);
  ///@}

  ///@{
  /// Synonyms of SetSourceConnection() and SetSourceData(), as vtkSelectEnclosedPoints names them.
  void SetSurfaceConnection(vtkAlgorithmOutput* surface) { this->SetSourceConnection(surface); }
  void SetSurfaceData(vtkDataObject* surface) { this->SetSourceData(surface); }
  ///@}

  ///@{
  /// Whether points or the centres of cells are evaluated. Default POINTS.
  vtkSetMacro(ProbeAssociation, int);
  vtkGetMacro(ProbeAssociation, int);
  void SetProbeAssociationToPoints() { this->SetProbeAssociation(POINTS); }
  void SetProbeAssociationToCells() { this->SetProbeAssociation(CELLS); }
  ///@}

  ///@{
  /// Whether inside and outside change places in the array "Inside", for IsInside() and for
  /// ExtractInside. w and distances stay what they are. Default off.
  vtkSetMacro(InsideOut, vtkTypeBool);
  vtkGetMacro(InsideOut, vtkTypeBool);
  vtkBooleanMacro(InsideOut, vtkTypeBool);
  ///@}

  ///@{
  /// Whether to keep only the part that is inside: the cells whose points are all inside, or, with
  /// CELLS, whose centre is. A data set without cells, or with poly-vertices only, counts as
  /// points, and every point that is kept gets a vertex. Polydata stays vtkPolyData, any other data
  /// set becomes vtkUnstructuredGrid; arrays are kept. Default off.
  vtkSetMacro(ExtractInside, vtkTypeBool);
  vtkGetMacro(ExtractInside, vtkTypeBool);
  vtkBooleanMacro(ExtractInside, vtkTypeBool);
  ///@}

  ///@{
  /// The name of the array of GenerateInside, which no other array of the result may have. Default,
  /// and where it is empty, "Inside".
  vtkSetStringMacro(InsideArrayName);
  vtkGetStringMacro(InsideArrayName);
  ///@}

  /// Whether a point of the last input, or with CELLS a cell, is inside, whatever arrays were asked
  /// for; 0 for a number that is too large. In composite data, numbers go on from one data set to
  /// the next.
  int IsInside(vtkIdType queryId);

  /// Whether Status is REFUSED because of port 0: the data set contradicts itself, for example by
  /// cells with ids of points that do not exist.
  bool GetQueriesWereRefused() const { return this->Status == REFUSED && this->QueriesRefused; }

  /// The output, if it is a data set. Null for composite data, which GetOutputDataObject(0) has.
  vtkDataSet* GetOutput();

protected:
  vtkWindingNumberProbe();
  ~vtkWindingNumberProbe() override;

  vtkWindingNumberProbe(const vtkWindingNumberProbe&) = delete;
  void operator=(const vtkWindingNumberProbe&) = delete;

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
  void CheckProperties() override;
  void HashProperties(winding::ContentHash& hash) override;

  /// Whether the samples are the centres of cells rather than points.
  virtual bool SamplesCells() const { return this->ProbeAssociation == CELLS; }

  /// Whether the output is a part of the data set, so that its cells are used.
  virtual bool KeepsPart() const { return this->ExtractInside != 0; }

  /// How refusals speak of what the filter does.
  virtual const winding::ProbeWords& GetWords() const;

  /// A new output for this input: one of the same class, unless it is a part of a data set.
  virtual vtkSmartPointer<vtkDataObject> NewOutput(vtkDataObject* input) const;

  /// The progress when all samples are evaluated; what a filter does after that has the rest.
  virtual double GetProgressOfSamples() const { return 1; }

  /// The rest of the evaluation, when all samples are evaluated and before any output is written:
  /// nothing, unless a filter says otherwise. `inside` has an entry for each sample.
  virtual void FinishSamples(
    const winding::Field& field, const winding::ProbeQueries& queries, const unsigned char* inside);

  /// Adds the arrays that the output of all samples has.
  virtual void AddArrays(const winding::ResultArrays& results, vtkDataSetAttributes* ofAll) const;

  /// The part of a data set that is kept, with all of its arrays, if KeepsPart(). `inside` has an
  /// entry for each sample of the leaf.
  virtual vtkSmartPointer<vtkDataSet> PartOf(
    vtkDataSet* data, const winding::ProbeLeaf& leaf, const unsigned char* inside);

  int ProbeAssociation = POINTS;
  vtkTypeBool InsideOut = 0;
  vtkTypeBool ExtractInside = 0;
  bool QueriesRefused = false;
  bool QueriesAreGrid = false; ///< of an image, in the last execution
  char* InsideArrayName = nullptr;

private:
  void EvaluateSamples(const winding::Field& field, const winding::ProbeQueries& queries,
    const winding::ResultArrays& results);
  void LookAtSides(const winding::Field& field, const winding::ProbeQueries& queries,
    const winding::ResultArrays& results, winding::SmpExecutor& executor);

  /// The output for one data set, with its part of the arrays of all data sets.
  vtkSmartPointer<vtkDataSet> AnswerTo(const winding::ProbeQueries& queries,
    const winding::ProbeLeaf& leaf, vtkDataSetAttributes* ofAll);
  void WriteOutput(vtkDataObject* input, const winding::ProbeQueries& queries,
    const winding::ResultArrays& results, vtkDataObject* output);

  vtkSmartPointer<vtkUnsignedCharArray> InsideFlags; ///< one for each query; null before the first
};

#endif
