/**
 * @class   vtkWindingNumberProbe
 * @brief   winding number at the points or cells of any data set
 *
 * Port 0 takes the data set that says where, any vtkDataSet or a composite one of them; port 1 the
 * source, a surface or an oriented point cloud (see vtkWindingNumberAlgorithm). The output is a shallow
 * copy of port 0 with the array "WindingNumber" and, if asked for, "Inside" and "SignedDistance"; or, with ExtractInside,
 * what of it is inside. The ports are those of vtkPointInterpolator; what the filter is for is what
 * vtkSelectEnclosedPoints is for, on surfaces that need not be closed.
 *
 * @code
 *   vtkNew<vtkWindingNumberProbe> probe;
 *   probe->SetInputConnection(points->GetOutputPort());
 *   probe->SetSourceConnection(surface->GetOutputPort());
 *   probe->GenerateInsideOn();
 * @endcode
 *
 * For a closed surface values are integers, and right ones off the surface (method ROWS, which AUTOMATIC
 * takes then). Else the value of a point depends on the other points within the Tolerance only; with
 * method DIRECT, or Tolerance 0, not at all. Points that are NaN or infinite get NaN, as value and as
 * distance, and are neither inside nor outside.
 *
 * Of a composite data set the output has the same structure: every vtkDataSet in it gets its arrays, all
 * of them evaluated at once; what is empty, or another kind of data, stays. Field data that says how
 * the result came about is added to the output and to every data set in it. (AMR data goes through the
 * filter block by block.)
 *
 * **Instead of vtkSelectEnclosedPoints.** These edits make it a replacement, for whatever reads the
 * output, IsInside() included:
 * @code
 *   vtkNew<vtkWindingNumberProbe> select;         // another class
 *   select->SetInputConnection(points->GetOutputPort());
 *   select->SetSurfaceConnection(surface->GetOutputPort());
 *   select->InsideOutOn();                        // if there was one
 *   select->GenerateInsideOn();                   // the array of 0 and 1 ...
 *   select->SetInsideArrayName("SelectedPoints"); // ... has this name there ...
 *   select->GenerateWindingNumberOff();           // ... and is the only one, and the active scalars
 * @endcode
 * CheckSurface has no counterpart, for the surface need not be closed. Take SetTolerance() out: here it
 * bounds the error of w, and the default is good. Instead of Initialize(), IsInsideSurface() and
 * Complete() there is vtkImplicitWindingNumber. Surfaces whose triangles are oriented inward have w = −1
 * inside; use InsideRule ABSOLUTE where that may be so.
 *
 * @sa vtkWindingNumberField vtkImplicitWindingNumber vtkSelectEnclosedPoints
 */
#ifndef vtkWindingNumberProbe_h
#define vtkWindingNumberProbe_h

#include "vtkSmartPointer.h" // for what IsInside() knows
#include "vtkWindingNumberAlgorithm.h"

namespace winding
{
class ProbeQueries;
struct ProbeLeaf;
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
  /// The same, by the names that vtkSelectEnclosedPoints has for it.
  void SetSurfaceConnection(vtkAlgorithmOutput* surface) { this->SetSourceConnection(surface); }
  void SetSurfaceData(vtkDataObject* surface) { this->SetSourceData(surface); }
  ///@}

  ///@{
  /// Default POINTS.
  vtkSetClampMacro(ProbeAssociation, int, POINTS, CELLS);
  vtkGetMacro(ProbeAssociation, int);
  void SetProbeAssociationToPoints() { this->SetProbeAssociation(POINTS); }
  void SetProbeAssociationToCells() { this->SetProbeAssociation(CELLS); }
  ///@}

  ///@{
  /// Take what is outside for inside, and the other way round: in the array "Inside", for IsInside()
  /// and for ExtractInside. w and distances stay what they are. Default off.
  vtkSetMacro(InsideOut, vtkTypeBool);
  vtkGetMacro(InsideOut, vtkTypeBool);
  vtkBooleanMacro(InsideOut, vtkTypeBool);
  ///@}

  ///@{
  /// Keep only what is inside: cells whose points are all inside, or, with CELLS, whose centre is. A
  /// data set without cells, or with poly-vertices only, is taken as points, which get a vertex each.
  /// Polydata stays vtkPolyData, any other data set becomes vtkUnstructuredGrid; arrays are kept.
  /// Default off.
  vtkSetMacro(ExtractInside, vtkTypeBool);
  vtkGetMacro(ExtractInside, vtkTypeBool);
  vtkBooleanMacro(ExtractInside, vtkTypeBool);
  ///@}

  ///@{
  /// Name of the array of GenerateInside; unlike that of any other array of the result. Default, and
  /// where it is empty, "Inside".
  vtkSetStringMacro(InsideArrayName);
  vtkGetStringMacro(InsideArrayName);
  ///@}

  /// Whether a point of the last input (with CELLS: a cell) is inside, whatever arrays were asked for;
  /// 0 for one that there is not. In composite data, numbers go on from one data set to the next.
  int IsInside(vtkIdType queryId);

  /// Null for composite data, which GetOutputDataObject(0) has.
  vtkDataSet* GetOutput();

protected:
  vtkWindingNumberProbe();
  ~vtkWindingNumberProbe() override;

  vtkWindingNumberProbe(const vtkWindingNumberProbe&) = delete;
  void operator=(const vtkWindingNumberProbe&) = delete;

  bool EvaluatesGrid() const override { return false; }
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;

  void GiveDataObject(vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void GiveInformation(vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void AskForUpdate(vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void GiveData(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  int ProbeAssociation = POINTS;
  vtkTypeBool InsideOut = 0;
  vtkTypeBool ExtractInside = 0;
  char* InsideArrayName = nullptr;

private:
  /// Of one data set, with its part of the arrays of all.
  vtkSmartPointer<vtkDataSet> AnswerTo(const winding::ProbeQueries& queries,
    const winding::ProbeLeaf& leaf, vtkDataSetAttributes* ofAll);
  void WriteOutput(vtkDataObject* input, const winding::ProbeQueries& queries,
    const winding::ResultArrays& results, vtkDataObject* output);

  vtkSmartPointer<vtkUnsignedCharArray> InsideFlags; ///< of all queries; null before the first
};

#endif
