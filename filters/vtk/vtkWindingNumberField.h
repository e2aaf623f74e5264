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
 * The grid is laid by vtkWindingNumberGridAlgorithm, and the image by
 * vtkWindingNumberImageAlgorithm, which says how the filter streams.
 *
 * **Coverage.** "Inside" says whether the centre of a voxel, which is the box of one spacing
 * around its sample, is inside; or, so that nothing thin is lost, whether any of the voxel is; or
 * whether half of it is. The winding number is always the centre's. ANY and FRACTION add
 * "Inside" even if GenerateInside is off, and FRACTION adds the array "Coverage", of floats: the
 * share of each voxel. vtkWindingNumberVoxels gives the surface of all voxels beyond another share
 * from that array.
 *
 * **On the surface.** Method ROWS gives a sample exactly on a closed surface the neighbouring
 * value, towards +y, or if that is on the surface too towards +z, or +x. Sums (method DIRECT,
 * clouds, the caps of open surfaces) give a sample exactly in the plane of a triangle the mean of
 * both sides, 0.5 on a face of a closed mesh, and a sample that lies there only up to rounding one
 * of the sides. Sums of triangles give a vertex of a closed mesh the share of directions that lead
 * inside, if no other triangle passes there.
 *
 * Errors, each one line through vtkErrorMacro: properties or bounds that give no grid, clouds
 * without normals, sources without a usable primitive, and results larger than the free
 * memory, which are refused before anything is allocated.
 *
 * @sa vtkWindingNumberSurface vtkWindingNumberProbe vtkWindingNumberVoxels vtkThreshold
 */
#ifndef vtkWindingNumberField_h
#define vtkWindingNumberField_h

#include "vtkWindingNumberImageAlgorithm.h"

class VTKFILTERSWINDING_EXPORT vtkWindingNumberField : public vtkWindingNumberImageAlgorithm
{
public:
  static vtkWindingNumberField* New();
  vtkTypeMacro(vtkWindingNumberField, vtkWindingNumberImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The reach of "SignedDistance", in units of the longest side of a voxel: samples that are
  /// farther from the source get that distance, with their sign, and take little time. 0 stands for
  /// all distances. 0 or more, default 0.
  vtkSetMacro(DistanceBand, double);
  vtkGetMacro(DistanceBand, double);
  ///@}

protected:
  vtkWindingNumberField() = default;
  ~vtkWindingNumberField() override = default;

  vtkWindingNumberField(const vtkWindingNumberField&) = delete;
  void operator=(const vtkWindingNumberField&) = delete;

  void CheckProperties() override;
  void HashProperties(winding::ContentHash& hash) override;

  int GetActiveScalarType() const override;
  void MakeImage(vtkDataObject* source, const int samples[6], vtkImageData* image,
    vtkDataSetAttributes* attributes) override;
  double GetDistanceLimit() const override;
  winding::ResultOptions GetResultOptions() const override;

  double DistanceBand = 0;

private:
  void EvaluateVoxels(
    const winding::Field& field, const int samples[6], const winding::ResultArrays& results);
};

#endif
