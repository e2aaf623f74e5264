/**
 * @class   vtkWindingNumberField
 * @brief   winding-number field of a surface or an oriented point cloud on a regular grid
 *
 * The filter takes a source (see vtkWindingNumberAlgorithm) and gives vtkImageData with the array
 * "WindingNumber" and, if asked for, "Inside", "SignedDistance" and "Coverage". Threshold the
 * field, or hand it to vtkWindingNumberVoxels for a voxel surface; vtkWindingNumberSurface makes
 * the smooth one.
 *
 * @code
 *   vtkNew<vtkWindingNumberField> field;
 *   field->SetInputConnection(reader->GetOutputPort());
 *   field->SetResolution(128);
 *   vtkNew<vtkWindingNumberVoxels> voxels;
 *   voxels->SetInputConnection(field->GetOutputPort());
 * @endcode
 *
 * The grid is that of vtkWindingNumberGridAlgorithm.
 *
 * **Coverage.** "Inside" tells whether the centre of a voxel, which is the box of one spacing
 * around its sample, is inside; or, so that nothing thin is lost, whether any of the voxel is; or
 * whether half of it is. The winding number is always that of the centre.
 *
 * **Pipeline.** The filter streams: any sub-extent can be asked for, and has the very bits that the
 * whole has. The whole source is read for each. The grid is laid when the pipeline's information is
 * asked for, over the source as it is then. At other time steps the grid keeps its dimensions, so
 * that pieces fit together, and its origin and spacing follow the source.
 * Progress is that of the evaluation. Abort is obeyed within a fraction of a second, also while the
 * filter prepares; the output is then empty.
 *
 * **On the surface.** Method ROWS gives a sample exactly on a closed surface the value beside it,
 * towards +y, or if that is on the surface too towards +z, or +x. Sums (method DIRECT, clouds, the
 * caps of open surfaces) give a sample exactly in the plane of a triangle the mean of both sides,
 * 0.5 on a face of a closed mesh, and a sample that lies there only up to rounding one of the
 * sides.
 *
 * Errors, each one line through vtkErrorMacro: properties or bounds that give no grid, clouds
 * without normals, sources of which no primitive is usable, and results larger than the free
 * memory, which are refused before anything is allocated.
 *
 * @sa vtkWindingNumberSurface vtkWindingNumberProbe vtkWindingNumberVoxels vtkThreshold
 */
#ifndef vtkWindingNumberField_h
#define vtkWindingNumberField_h

#include "vtkWindingNumberGridAlgorithm.h"

namespace winding
{
struct VoxelEvaluation;
}
class vtkImageData;

class VTKFILTERSWINDING_EXPORT vtkWindingNumberField : public vtkWindingNumberGridAlgorithm
{
public:
  static vtkWindingNumberField* New();
  vtkTypeMacro(vtkWindingNumberField, vtkWindingNumberGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The place of the samples in the image.
  enum OutputAssociationType
  {
    POINTS = 0, ///< points of the image: n per axis, at the voxel centres. Contour these.
    CELLS = 1   ///< cells of the image: n per axis, the voxels themselves. Threshold these.
  };

  ///@{
  /// Whether samples are points or cells of the image; their values are the same. Default POINTS.
  vtkSetMacro(OutputAssociation, int);
  vtkGetMacro(OutputAssociation, int);
  void SetOutputAssociationToPoints() { this->SetOutputAssociation(POINTS); }
  void SetOutputAssociationToCells() { this->SetOutputAssociation(CELLS); }
  ///@}

  /// The rules by which a voxel is inside in the array "Inside". ANY and FRACTION add that array
  /// even if GenerateInside is off.
  enum CoverageType
  {
    /// The centre of the voxel is inside.
    CENTER = 0,
    /**
     * The voxel overlaps the solid or its surface: the centre is inside, or a triangle or a point
     * of the source touches the voxel, its boundary included, or, with open surfaces and clouds, a
     * corner is inside. So the voxels hold all of the surface that lies in the grid, and all voxels
     * of CENTER are among them.
     */
    ANY = 1,
    /**
     * At least half of the voxel is inside. This adds the array "Coverage", of floats: the share
     * that is inside of CoverageSamples³ samples, evenly spaced in the voxel. Samples are counted,
     * for a mean of w would be no share of the voxel beside holes, where w fades, or where solids
     * overlap. vtkWindingNumberVoxels gives the surface of all voxels beyond another share from
     * that array. It takes the time of a few fields for closed surfaces, of a field of as many
     * samples otherwise.
     */
    FRACTION = 2
  };

  ///@{
  /// The rule by which a voxel is inside. Default CENTER.
  vtkSetMacro(Coverage, int);
  vtkGetMacro(Coverage, int);
  void SetCoverageToCenter() { this->SetCoverage(CENTER); }
  void SetCoverageToAny() { this->SetCoverage(ANY); }
  void SetCoverageToFraction() { this->SetCoverage(FRACTION); }
  ///@}

  ///@{
  /// The number of samples along each axis of a voxel, for FRACTION. 1 to 10, default 4, with which
  /// shares are multiples of 1/64.
  vtkSetMacro(CoverageSamples, int);
  vtkGetMacro(CoverageSamples, int);
  ///@}

  ///@{
  /// The reach of "SignedDistance", in units of the longest side of a voxel: samples that are
  /// farther from the source get that distance, with their sign, and take little time. 0 stands for
  /// all distances. 0 or more, default 0.
  vtkSetMacro(DistanceBand, double);
  vtkGetMacro(DistanceBand, double);
  ///@}

  /// The output of port 0.
  vtkImageData* GetOutput();

protected:
  vtkWindingNumberField() = default;
  ~vtkWindingNumberField() override = default;

  vtkWindingNumberField(const vtkWindingNumberField&) = delete;
  void operator=(const vtkWindingNumberField&) = delete;

  int FillOutputPortInformation(int port, vtkInformation* info) override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void CheckProperties() override;
  void HashProperties(winding::ContentHash& hash) override;
  bool InformationNeedsSource() const override { return true; }

  double GetDistanceLimit() const override;
  winding::EvaluationCost GetAdditionalCost(
    const winding::Field& field, vtkIdType samples) override;
  winding::ResultOptions GetResultOptions() const override;

  int OutputAssociation = POINTS;
  int Coverage = CENTER;
  int CoverageSamples = 4;
  double DistanceBand = 0;

private:
  void TellGrid(vtkInformation* outInfo) const;
  winding::VoxelEvaluation GetVoxelEvaluation() const;
  void EvaluateVoxels(
    const winding::Field& field, const int samples[6], const winding::ResultArrays& results);
  void UpdateSource(vtkInformation* outInfo);
};

#endif
