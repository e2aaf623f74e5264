/**
 * @class   vtkWindingNumberProbe
 * @brief   winding number at the points or cells of any data set
 *
 * Port 0 takes the data set that says where (any vtkDataSet); port 1 the source, a surface or an
 * oriented point cloud (see vtkWindingNumberAlgorithm). The output is a shallow copy of port 0 with
 * the array "WindingNumber" and, if asked for, "Inside" and "SignedDistance". The ports are those of
 * vtkPointInterpolator; what the filter is for is what vtkSelectEnclosedPoints is for, on surfaces
 * that need not be closed.
 *
 * @code
 *   vtkNew<vtkWindingNumberProbe> probe;
 *   probe->SetInputConnection(points->GetOutputPort());
 *   probe->SetSourceConnection(surface->GetOutputPort());
 *   probe->GenerateInsideOn();
 * @endcode
 *
 * The value of a point depends on the other points within the Tolerance only; with method DIRECT, or
 * Tolerance 0, not at all. Points that are NaN or infinite get
 * NaN, as value and as distance, and are not inside.
 *
 * @sa vtkWindingNumberField vtkSelectEnclosedPoints
 */
#ifndef vtkWindingNumberProbe_h
#define vtkWindingNumberProbe_h

#include "vtkWindingNumberAlgorithm.h"

class vtkDataSet;

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
  /// Default POINTS.
  vtkSetClampMacro(ProbeAssociation, int, POINTS, CELLS);
  vtkGetMacro(ProbeAssociation, int);
  void SetProbeAssociationToPoints() { this->SetProbeAssociation(POINTS); }
  void SetProbeAssociationToCells() { this->SetProbeAssociation(CELLS); }
  ///@}

  vtkDataSet* GetOutput();

protected:
  vtkWindingNumberProbe();
  ~vtkWindingNumberProbe() override = default;

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
};

#endif
