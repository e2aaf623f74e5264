/**
 * @class   vtkWindingNumberField
 * @brief   winding-number field of a surface or an oriented point cloud on a regular grid
 *
 * Takes a source (see vtkWindingNumberAlgorithm) and gives vtkImageData with the array
 * "WindingNumber" and, if asked for, "Inside". Contour the field at 0.5 for a smooth surface, or
 * threshold it, or hand it to vtkWindingNumberVoxels for a voxel surface.
 *
 * @code
 *   vtkNew<vtkWindingNumberField> field;
 *   field->SetInputConnection(reader->GetOutputPort());
 *   field->SetResolution(128);
 *   vtkNew<vtkContourFilter> contour;
 *   contour->SetInputConnection(field->GetOutputPort());
 *   contour->SetValue(0, 0.5);
 * @endcode
 *
 * **Grid.** The samples are the centres of voxels that fill a box: the input's bounds and a padding
 * around them, or SamplingBounds. Voxels are cubic, their size given by VoxelSize or by Resolution,
 * and then the box grows to a whole number of them, evenly on both sides; or SamplingDimensions
 * says how many there are along each axis, and they fill the box exactly.
 *
 * **Pipeline.** Streams: any sub-extent can be asked for, and has the very bits that the whole has.
 * The whole source is read for each. The grid is laid when the pipeline's information is asked for,
 * over the source as it is then; for geometry that moves with time, set SamplingBounds.
 * Progress is that of the evaluation. Abort is obeyed within a fraction of a second, while preparing
 * too; then the output is empty.
 *
 * **On the surface.** Method rows: a sample exactly on a closed surface gets the value beside it,
 * towards +y, or if that is on the surface too towards +z, or +x. Sums (direct, clouds, the caps of open
 * surfaces): a sample exactly in the plane of a triangle gets the mean of both sides from it, 0.5 on
 * a face of a closed mesh; one that is there only up to rounding gets one of the sides.
 *
 * Errors, each one line through vtkErrorMacro: properties or bounds that give no grid, clouds
 * without normals, sources of which no primitive is usable, and results larger than the free
 * memory, which are refused before anything is allocated.
 *
 * @sa vtkWindingNumberProbe vtkWindingNumberVoxels vtkContourFilter vtkThreshold
 */
#ifndef vtkWindingNumberField_h
#define vtkWindingNumberField_h

#include "vtkWindingNumberAlgorithm.h"

namespace winding
{
struct Grid;
}
class vtkDataArray;
class vtkImageData;

class VTKFILTERSWINDING_EXPORT vtkWindingNumberField : public vtkWindingNumberAlgorithm
{
public:
  static vtkWindingNumberField* New();
  vtkTypeMacro(vtkWindingNumberField, vtkWindingNumberAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What the samples are in the image.
  enum OutputAssociationType
  {
    POINTS = 0, ///< its points: n per axis, at the voxel centres. Contour these.
    CELLS = 1   ///< its cells: n per axis, the voxels themselves. Threshold these.
  };

  ///@{
  /// Cubic voxels along the longest side. Used where neither SamplingDimensions nor VoxelSize is
  /// set. At least 1, default 64.
  vtkSetMacro(Resolution, int);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /// Side of the cubic voxels, in the unit of the input; 0: from Resolution. Default 0.
  vtkSetMacro(VoxelSize, double);
  vtkGetMacro(VoxelSize, double);
  ///@}

  ///@{
  /// Voxels along each axis, which need not be cubic then; 0 0 0: cubic voxels. Default 0 0 0.
  vtkSetVector3Macro(SamplingDimensions, int);
  vtkGetVector3Macro(SamplingDimensions, int);
  ///@}

  ///@{
  /// Lay the grid over the bounds of the input, with Padding, instead of SamplingBounds. Default
  /// on.
  vtkSetMacro(UseInputBounds, vtkTypeBool);
  vtkGetMacro(UseInputBounds, vtkTypeBool);
  vtkBooleanMacro(UseInputBounds, vtkTypeBool);
  ///@}

  ///@{
  /// The outer faces of the voxels: xmin, xmax, ymin, ymax, zmin, zmax. Used as they are, without
  /// padding, where UseInputBounds is off or the input is empty. Default 0 1 0 1 0 1.
  vtkSetVector6Macro(SamplingBounds, double);
  vtkGetVector6Macro(SamplingBounds, double);
  ///@}

  ///@{
  /// Margin around the input's bounds on each side, as a fraction of their longest side. 0 or more,
  /// default 0.05.
  vtkSetMacro(Padding, double);
  vtkGetMacro(Padding, double);
  ///@}

  ///@{
  /// Default POINTS. The values are the same for both.
  vtkSetClampMacro(OutputAssociation, int, POINTS, CELLS);
  vtkGetMacro(OutputAssociation, int);
  void SetOutputAssociationToPoints() { this->SetOutputAssociation(POINTS); }
  void SetOutputAssociationToCells() { this->SetOutputAssociation(CELLS); }
  ///@}

  ///@{
  /// Compare this many random samples, and as many within two voxels of the source, with the direct
  /// sum done one triangle after the other in double precision; not for parity. Default 0.
  vtkSetClampMacro(VerifySamples, int, 0, VTK_INT_MAX);
  vtkGetMacro(VerifySamples, int);
  ///@}

  ///@{
  /// What the last execution's verification found: largest and root-mean-square error over the
  /// random samples, and the largest over those near the source; and how many samples there were,
  /// of the two together. When streaming: those of the extent that was executed last.
  vtkGetMacro(MaxError, double);
  vtkGetMacro(RMSError, double);
  vtkGetMacro(NearMaxError, double);
  vtkGetMacro(NumberOfVerifiedSamples, vtkIdType);
  vtkGetMacro(NumberOfNearVerifiedSamples, vtkIdType);
  ///@}

  vtkImageData* GetOutput();

protected:
  vtkWindingNumberField();
  ~vtkWindingNumberField() override;

  vtkWindingNumberField(const vtkWindingNumberField&) = delete;
  void operator=(const vtkWindingNumberField&) = delete;

  bool EvaluatesGrid() const override { return true; }
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;

  void GiveInformation(vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void AskForUpdate(vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void GiveData(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  int Resolution = 64;
  double VoxelSize = 0;
  int SamplingDimensions[3] = {0, 0, 0};
  vtkTypeBool UseInputBounds = 1;
  double SamplingBounds[6] = {0, 1, 0, 1, 0, 1};
  double Padding = 0.05;
  int OutputAssociation = POINTS;
  int VerifySamples = 0;
  double MaxError = 0;
  double RMSError = 0;
  double NearMaxError = 0;
  vtkIdType NumberOfVerifiedSamples = 0;
  vtkIdType NumberOfNearVerifiedSamples = 0;

private:
  void UpdateSource(vtkInformation* outInfo);
  void LayOutGrid(vtkDataObject* source);
  void Verify(const winding::Field& field, const int samples[6], vtkDataArray* values);

  std::unique_ptr<winding::Grid> Sampling; ///< the grid that the pipeline was told about
};

#endif
