// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
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
 * **Active scalars.** They are the winding number. "Inside" is active instead where it says
 * something else than whether w is 0.5 or more: with ANY and FRACTION, and with GenerateInside and
 * another WindingThreshold or InsideRule. So vtkWindingNumberVoxels shows what is inside.
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

#include "vtkWindingABINamespace.h"
#include "vtkWindingNumberImageAlgorithm.h"

namespace winding
{
class ResultArrays;
struct ResultOptions;
} // namespace winding

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSWINDING_EXPORT vtkWindingNumberField : public vtkWindingNumberImageAlgorithm
{
public:
  static vtkWindingNumberField* New();
  vtkTypeMacro(vtkWindingNumberField, vtkWindingNumberImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Whether to add the array of w itself. Default on. Without it, "Inside" and the sign of
  /// "SignedDistance" are made directly, with one byte of memory for each sample; they are what
  /// they would be with an array of floats.
  vtkSetMacro(GenerateWindingNumber, vtkTypeBool);
  vtkGetMacro(GenerateWindingNumber, vtkTypeBool);
  vtkBooleanMacro(GenerateWindingNumber, vtkTypeBool);
  ///@}

  ///@{
  /// Whether to add the array "Inside" (unsigned char, 1 inside and 0 outside), which follows from
  /// the value in the array of w. Default off.
  vtkSetMacro(GenerateInside, vtkTypeBool);
  vtkGetMacro(GenerateInside, vtkTypeBool);
  vtkBooleanMacro(GenerateInside, vtkTypeBool);
  ///@}

  ///@{
  /// Whether to add the array "SignedDistance": the distance to the nearest point of the source's
  /// triangles, or to the nearest point of its cloud, negative inside and 0 on the source. Its size
  /// is exact up to rounding. Its sign follows from w, threshold and rule, whatever coverage
  /// makes of "Inside", and so may change across holes, where nothing is near. A source
  /// without primitives gives the largest number of the array's type. Default off.
  vtkSetMacro(GenerateSignedDistance, vtkTypeBool);
  vtkGetMacro(GenerateSignedDistance, vtkTypeBool);
  vtkBooleanMacro(GenerateSignedDistance, vtkTypeBool);
  ///@}

  ///@{
  /// Whether to add the array "NearestCell" (vtkIdType): the id, in its data set, of the source's
  /// cell that is nearest to each sample, or of a cloud's point; -1 where there
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
  /// The type of the arrays of w and of distances, VTK_FLOAT or VTK_DOUBLE. Methods without
  /// approximation compute in double, and so do distances. Default VTK_FLOAT.
  vtkSetMacro(OutputScalarType, int);
  vtkGetMacro(OutputScalarType, int);
  void SetOutputScalarTypeToFloat() { this->SetOutputScalarType(VTK_FLOAT); }
  void SetOutputScalarTypeToDouble() { this->SetOutputScalarType(VTK_DOUBLE); }
  const char* GetOutputScalarTypeAsString() const;
  ///@}

  ///@{
  /// The reach of "SignedDistance", in units of the longest side of a voxel: samples that are
  /// farther from the source get that distance, with their sign, and take little time. 0 stands for
  /// all distances. 0 or more, default 0.
  vtkSetMacro(DistanceBand, double);
  vtkGetMacro(DistanceBand, double);
  ///@}

  /// The number of samples inside, of the extent that was executed last: as "Inside" says, by
  /// coverage too, whether or not that array is made.
  vtkGetMacro(NumberOfInsideSamples, vtkIdType);

  /// Counts of the extent that was executed last: its samples, NumberOfInsideSamples, and the
  /// samples with w of WindingThreshold or more by the rule, and of −WindingThreshold or less. With
  /// UnionOverAllTimes the first two are of all times, and the last two of the last time.
  vtkGetVector4Macro(SampleCounts, vtkIdType);

  /// Warns of a source that is inside out, and of a grid without samples inside, as an execution of
  /// the whole grid does. It is for a result of one time that was made in pieces, by the sums
  /// `counts` of their SampleCounts, once the last was made. Counted twice, the samples that pieces
  /// share change the shares in the words a little. Collective; the first rank warns.
  void WarnOfPieces(const vtkIdType counts[4]);

protected:
  vtkWindingNumberField();
  ~vtkWindingNumberField() override;

  vtkWindingNumberField(const vtkWindingNumberField&) = delete;
  void operator=(const vtkWindingNumberField&) = delete;

  void CheckProperties() override;
  void HashProperties(winding::ContentHash& hash) override;

  int GetActiveScalarType() const override;
  void MakeImage(vtkDataObject* source, const std::array<int, 6>& samples, vtkImageData* image,
    vtkDataSetAttributes* attributes) override;
  void CheckUnion() const override;
  void UniteTimes(vtkImageData* all, vtkImageData* other) override;
  bool WantsDistances() const override { return this->GenerateSignedDistance != 0; }
  double GetDistanceLimit() const override;
  double GetResultBytes(vtkIdType samples) const override;
  std::size_t GetAdditionalBytes(const winding::Field& field, vtkIdType samples) override;
  /// Returns how many words of bits the samples of voxels have, while times are united.
  std::size_t GetSweptWords(vtkIdType voxels) const;

  vtkTypeBool GenerateWindingNumber = 1;
  vtkTypeBool GenerateInside = 0;
  vtkTypeBool GenerateSignedDistance = 0;
  vtkTypeBool GenerateNearestCells = 0;
  char* ResultArrayName = nullptr;
  int OutputScalarType = VTK_FLOAT;
  double DistanceBand = 0;
  vtkIdType NumberOfInsideSamples = 0;
  vtkIdType SampleCounts[4] = {};

private:
  bool ShowsInside() const;
  winding::ResultOptions GetResultOptions() const;
  void AddNearestCells(
    vtkDataObject* source, const std::array<int, 6>& samples, vtkDataSetAttributes* attributes);
  void EvaluateVoxels(const winding::Field& field, const std::array<int, 6>& samples,
    const winding::ResultArrays& results);
};
VTK_ABI_NAMESPACE_END

#endif
