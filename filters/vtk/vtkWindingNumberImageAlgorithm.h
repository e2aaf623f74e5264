// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindingNumberImageAlgorithm
 * @brief   base class of winding-number filters that give an image
 *
 * The samples of the grid (see vtkWindingNumberGridAlgorithm) are the points or the cells of a
 * vtkImageData. What the image has is said by the classes vtkWindingNumberField and
 * vtkWindingNumberLabels.
 *
 * **Pipeline.** The filter streams: any sub-extent can be asked for, and has the very bits that the
 * whole has. The whole source is read for each. The grid is laid when the pipeline's information is
 * asked for, over the source as it is then. At other time steps the grid keeps its dimensions, so
 * that pieces fit together, and its origin and spacing follow the source.
 *
 * **Like.** With an image on port 1 the result has the extent, origin, spacing and direction matrix
 * of this image. Properties of the grid count for nothing then. The filter uses the pipeline's
 * information on the image, and needs no data of it. Images that are turned or mirrored take no
 * longer than straight ones: they are grids along their own axes, which have to be at right angles
 * up to 1e-3, as direction cosines of four digits are (HasRightAngles()). Samples lie at the places
 * of the image, and signed distances have that relative error.
 *
 * Progress follows the evaluation. Abort is obeyed within a fraction of a second, also while the
 * filter prepares; the output is then empty.
 *
 * @sa vtkWindingNumberField vtkWindingNumberLabels
 */
#ifndef vtkWindingNumberImageAlgorithm_h
#define vtkWindingNumberImageAlgorithm_h

#include "vtkWindingABINamespace.h"
#include "vtkWindingNumberGridAlgorithm.h"

#include <cstdint>  // for bits of samples
#include <optional> // for the same
#include <vector>   // for the same

namespace winding
{
struct VoxelEvaluation;
}
VTK_ABI_NAMESPACE_BEGIN
class vtkDataSetAttributes;
class vtkImageData;

class VTKFILTERSWINDING_EXPORT vtkWindingNumberImageAlgorithm : public vtkWindingNumberGridAlgorithm
{
public:
  vtkTypeMacro(vtkWindingNumberImageAlgorithm, vtkWindingNumberGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The image that the result is to lie on: port 1, optional. With CELLS, samples are the centres
  /// of its cells.
  void SetLikeConnection(vtkAlgorithmOutput* image);
  void SetLikeData(vtkImageData* image);
  ///@}

  /// Returns whether the axes of an image are at right angles up to 1e-3, so that results can lie
  /// on it.
  static bool HasRightAngles(vtkImageData* image);

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
  const char* GetOutputAssociationAsString() const;
  ///@}

  /// The rules by which a voxel, which is the box of one spacing around its sample, is inside.
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
     * At least half of the voxel is inside, by the share that is inside of CoverageSamples³
     * samples, evenly spaced in the voxel. Samples are counted, for a mean of w would be no share
     * of the voxel near holes, where w fades, or where solids overlap. It takes the time of a few
     * fields for closed surfaces, of a field of as many samples otherwise.
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
  const char* GetCoverageAsString() const;
  ///@}

  ///@{
  /// The number of samples along each axis of a voxel, for FRACTION. 1 to 10, default 4, with which
  /// shares are multiples of 1/64.
  vtkSetMacro(CoverageSamples, int);
  vtkGetMacro(CoverageSamples, int);
  ///@}

  ///@{
  /**
   * Whether the result is the union over all steps of time of the source: the volume that it
   * sweeps. The grid lies over the bounds of all times, unless it is given, and the output has no
   * times. Sources with a range of times without steps are refused.
   *
   * A sample is inside where it is at any time. It has w of the time at which it is farthest inside
   * by the rule, so that the contour of w bounds the union. Distances are the least: exact outside,
   * and inside at most as far as the surface of the union is. "Coverage" of a field is the share of
   * a voxel's samples that are inside at any time, and makes the voxel inside from half on. A voxel
   * keeps the label of the first time at which it has one; each label's share and the counts of
   * solids are the largest of any time, and the two largest shares come from the time with the
   * largest first one. Solids have to be the same at all times at which there are any. Nearest
   * cells are refused.
   *
   * Facts about the execution, of its verification too, are about the last time. Warnings come at
   * the end, and say at how many of the times. The source is brought up to date for each time, for
   * each piece of the image, and at the end for its own time. Default off.
   */
  vtkSetMacro(UnionOverAllTimes, vtkTypeBool);
  vtkGetMacro(UnionOverAllTimes, vtkTypeBool);
  vtkBooleanMacro(UnionOverAllTimes, vtkTypeBool);
  ///@}

  /// The output of port 0.
  vtkImageData* GetOutput();

protected:
  vtkWindingNumberImageAlgorithm();
  ~vtkWindingNumberImageAlgorithm() override = default;

  vtkWindingNumberImageAlgorithm(const vtkWindingNumberImageAlgorithm&) = delete;
  void operator=(const vtkWindingNumberImageAlgorithm&) = delete;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void CheckProperties() override;
  void HashProperties(winding::ContentHash& hash) override;
  std::size_t GetAdditionalBytes(const winding::Field& field, vtkIdType samples) override;
  bool MayTouchVoxels() const override { return this->Coverage == CENTER; }
  bool TakesTouchedVoxels() const override { return this->Coverage == ANY; }
  bool IsOfAllTimes() const override { return this->UnionOverAllTimes != 0; }

  /// The type of the active scalars that the image will have.
  virtual int GetActiveScalarType() const = 0;

  /// Throws a refusal for a source that the filter cannot work with, before the grid is laid.
  virtual void CheckSource(vtkDataObject*) {}

  /// Makes the arrays of an extent of samples, and adds them to these attributes of the image,
  /// whose extent, origin and spacing are set. The grid has been laid over the source.
  virtual void MakeImage(vtkDataObject* source, const std::array<int, 6>& samples,
    vtkImageData* image, vtkDataSetAttributes* attributes) = 0;

  /// Throws a refusal for arrays that a union of times cannot have.
  virtual void CheckUnion() const {}

  /// Takes the arrays of another time into `all`, which has earlier times. May throw a Refusal.
  virtual void UniteTimes(vtkImageData* all, vtkImageData* other) = 0;

  /// Returns the attributes of an image that get the arrays.
  vtkDataSetAttributes* GetAttributes(vtkImageData* image) const;

  /// How voxels are evaluated, by Coverage; what they are written to is left to the caller.
  winding::VoxelEvaluation GetVoxelEvaluation() const;

  int OutputAssociation = POINTS;
  int Coverage = CENTER;
  int CoverageSamples = 4;
  vtkTypeBool UnionOverAllTimes = 0;
  /// Bits of samples that were inside at earlier times, while times are united.
  std::optional<std::vector<std::uint64_t>> SweptSamples;

private:
  bool MakeUnion(vtkInformation* outInfo, const std::array<int, 6>& samples, vtkImageData* image);
  void SetUpGridOverSource(vtkInformation* outInfo);
  void InspectLike(vtkInformationVector* like);
  void CheckLike(vtkImageData* image) const;
  void SetUpGridLike();
  void AnnounceGrid(vtkInformation* outInfo) const;

  vtkSmartPointer<vtkImageData> Like; ///< place of the image to lie on, without arrays; may be null
};
VTK_ABI_NAMESPACE_END

#endif
