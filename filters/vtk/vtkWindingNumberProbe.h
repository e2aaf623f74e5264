// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindingNumberProbe
 * @brief   winding number at the points or cells of any data set
 *
 * Port 0 takes the data set that says where to evaluate, any vtkDataSet or a composite of them.
 * Port 1 takes the source, a surface or an oriented point cloud (see vtkWindingNumberAlgorithm).
 * The output is a shallow copy of port 0 with the array "WindingNumber" and, if asked for,
 * "Inside", "SignedDistance", and the cell array "Fraction"; ExtractInside keeps only the part of
 * it that is inside. The ports are as for vtkPointInterpolator. The filter does what
 * vtkSelectEnclosedPoints does, but on surfaces that need not be closed.
 *
 * @code
 *   vtkNew<vtkWindingNumberProbe> probe;
 *   probe->SetInputConnection(points->GetOutputPort());
 *   probe->SetSourceConnection(surface->GetOutputPort());
 *   probe->GenerateInsideOn();
 * @endcode
 *
 * Points that are NaN or infinite get NaN, as value and as distance, and are neither inside nor
 * outside. vtkWindingNumberProbeAlgorithm says what samples are evaluated together, and what
 * composite data gives: each data set in it gets its arrays.
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

#include "vtkNew.h" // for arrays of samples
#include "vtkWindingABINamespace.h"
#include "vtkWindingNumberProbeAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkFloatArray;
class vtkPointData;

class VTKFILTERSWINDING_EXPORT vtkWindingNumberProbe : public vtkWindingNumberProbeAlgorithm
{
public:
  static vtkWindingNumberProbe* New();
  vtkTypeMacro(vtkWindingNumberProbe, vtkWindingNumberProbeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Where w is evaluated.
  enum ProbeAssociationType
  {
    POINTS = 0, ///< at the points; the result is point data
    CELLS = 1   ///< at the parametric centres of the cells; the result is cell data
  };

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
  const char* GetProbeAssociationAsString() const;
  ///@}

  ///@{
  /// Whether to add the array of w. Default on.
  vtkSetMacro(GenerateWindingNumber, vtkTypeBool);
  vtkGetMacro(GenerateWindingNumber, vtkTypeBool);
  vtkBooleanMacro(GenerateWindingNumber, vtkTypeBool);
  ///@}

  ///@{
  /// Whether to add the array "Inside" (unsigned char, 1 inside and 0 outside). Default off.
  vtkSetMacro(GenerateInside, vtkTypeBool);
  vtkGetMacro(GenerateInside, vtkTypeBool);
  vtkBooleanMacro(GenerateInside, vtkTypeBool);
  ///@}

  ///@{
  /// Whether to add the array "SignedDistance", as vtkWindingNumberField has it. Its sign follows
  /// from w, threshold and rule, whatever InsideOut is. Default off.
  vtkSetMacro(GenerateSignedDistance, vtkTypeBool);
  vtkGetMacro(GenerateSignedDistance, vtkTypeBool);
  vtkBooleanMacro(GenerateSignedDistance, vtkTypeBool);
  ///@}

  ///@{
  /// Whether to add the cell array "Fraction" (float): the share of the volume of each cell that is
  /// inside, or outside if InsideOut is on, whatever ProbeAssociation is.
  ///
  /// Cells may be linear ones of any type, polyhedra, convex sets of points, and the cells of
  /// images and grids; ghost cells stay as they are. Faces that are not planar count as the
  /// triangles around the mean of their corners, and cells with curved faces as straight between
  /// their corners, which a warning says. A cell without volume has 1 or 0, as its middle is inside
  /// or not, which a warning says, too. Empty cells, polyhedra with a face that is missing or
  /// turned, and cells at points that are not finite have NaN.
  ///
  /// For closed surfaces fractions are exact up to rounding to float, however many solids overlap,
  /// so that fractions times volumes add up to the volume of what is inside. For others the level
  /// of w is taken to be planar in about a sixteenth of a cell, which costs a thousand samples in
  /// each cell at holes of a surface or on a cloud. Default off.
  vtkSetMacro(GenerateFraction, vtkTypeBool);
  vtkGetMacro(GenerateFraction, vtkTypeBool);
  vtkBooleanMacro(GenerateFraction, vtkTypeBool);
  ///@}

  ///@{
  /// Whether to add the array "NearestCell" (vtkIdType): the id, in its data set, of the source's
  /// cell that is nearest to each point or centre of a cell, or of a cloud's point; -1 where there
  /// is none. With composite sources "NearestBlock" (int) has the flat index of the data set.
  /// Equally near cells, and parallel programs, are as in vtkWindingNumberSurfaceAlgorithm. Each
  /// execution searches anew. Default off.
  vtkSetMacro(GenerateNearestCells, vtkTypeBool);
  vtkGetMacro(GenerateNearestCells, vtkTypeBool);
  vtkBooleanMacro(GenerateNearestCells, vtkTypeBool);
  ///@}

  ///@{
  /// The name of the array of w. Default "WindingNumber".
  vtkSetStringMacro(ResultArrayName);
  vtkGetStringMacro(ResultArrayName);
  ///@}

  ///@{
  /// The type of the arrays of w and of distances, VTK_FLOAT or VTK_DOUBLE. Default VTK_FLOAT.
  vtkSetMacro(OutputScalarType, int);
  vtkGetMacro(OutputScalarType, int);
  void SetOutputScalarTypeToFloat() { this->SetOutputScalarType(VTK_FLOAT); }
  void SetOutputScalarTypeToDouble() { this->SetOutputScalarType(VTK_DOUBLE); }
  const char* GetOutputScalarTypeAsString() const;
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

protected:
  vtkWindingNumberProbe();
  ~vtkWindingNumberProbe() override;

  vtkWindingNumberProbe(const vtkWindingNumberProbe&) = delete;
  void operator=(const vtkWindingNumberProbe&) = delete;

  void CheckProperties() override;
  void FinishSamples(const winding::Field& field, const winding::ProbeQueries& queries,
    const unsigned char* inside) override;

  bool WantsDistances() const override { return this->GenerateSignedDistance != 0; }
  bool SamplesCells() const override { return this->ProbeAssociation == CELLS; }
  bool KeepsPart() const override { return this->ExtractInside != 0; }
  bool UsesCells() const override { return this->KeepsPart() || this->GenerateFraction != 0; }
  const winding::ProbeWords& GetWords() const override;
  winding::ResultOptions GetResultOptions() const override;
  vtkSmartPointer<vtkDataObject> NewOutput(vtkDataObject* input) const override;
  double GetProgressOfSamples() const override { return this->GenerateFraction ? 0.3 : 1; }
  std::size_t GetAdditionalBytes(const winding::Field& field, vtkIdType samples) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void EvaluateMore(const winding::Field& field, const winding::ProbeQueries& queries,
    winding::SmpExecutor& executor) override;
  void AddLeafArrays(vtkDataSet* answer, const winding::ProbeLeaf& leaf) const override;
  void AddArrays(const winding::ResultArrays& results, vtkDataSetAttributes* ofAll) const override;
  vtkSmartPointer<vtkDataSet> PartOf(
    vtkDataSet* data, const winding::ProbeLeaf& leaf, const unsigned char* inside) override;

  int ProbeAssociation = POINTS;
  vtkTypeBool GenerateWindingNumber = 1;
  vtkTypeBool GenerateInside = 0;
  vtkTypeBool GenerateSignedDistance = 0;
  vtkTypeBool GenerateFraction = 0;
  vtkTypeBool GenerateNearestCells = 0;
  char* ResultArrayName = nullptr;
  int OutputScalarType = VTK_FLOAT;
  vtkTypeBool ExtractInside = 0;
  char* InsideArrayName = nullptr;

private:
  vtkIdType CellsToFill = 0;                ///< of the input, if they get fractions
  vtkSmartPointer<vtkFloatArray> Fractions; ///< of the cells of all data sets; null between updates
  vtkNew<vtkPointData> NearestCells;        ///< of all samples of the execution at hand
};
VTK_ABI_NAMESPACE_END

#endif
