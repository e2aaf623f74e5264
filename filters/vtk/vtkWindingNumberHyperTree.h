// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindingNumberHyperTree
 * @brief   winding-number field on a grid that is fine at the surface only, as a hyper tree grid
 *
 * The filter makes what vtkWindingNumberField makes, of the same source, on the same grid, but as a
 * vtkHyperTreeGrid: voxels with the same numbers share a cell. Its size grows with the surface, in
 * voxels, not with the volume: a grid of 4096³ voxels, which would take 54 GB as an image, takes
 * some hundreds of MB, and never more than a small part of it is in memory as voxels.
 *
 * @code
 *   vtkNew<vtkWindingNumberHyperTree> field;
 *   field->SetInputConnection(reader->GetOutputPort());
 *   field->SetResolution(2048);
 *   field->GenerateWindingNumberOff();
 *   field->GenerateInsideOn();
 *   vtkNew<vtkXMLHyperTreeGridWriter> writer;
 *   writer->SetInputConnection(field->GetOutputPort());
 * @endcode
 *
 * **Cells.** Values belong to cells. The smallest cells are the voxels of the grid, the boxes of
 * one spacing around the samples; larger ones are cubes of 8, 64, 512 … voxels. The grid is cut
 * into bricks, cubes with a power of two voxels a side, each of them a tree with branch factor
 * 2. The last bricks may reach beyond the grid: what lies there is masked. Grids whose dimensions
 * are multiples of 32 need the fewest cells for that; grids of one voxel along an axis are welcome.
 *
 * **Values.** "Inside" and "Coverage" are vtkWindingNumberField's at every voxel. So is w,
 * bit for bit, where it is an integer everywhere: for a closed surface with method ROWS, which is
 * what AUTOMATIC takes for it. Elsewhere voxels share a cell where their w differ by MergeTolerance
 * at most, and lie on the same side of WindingThreshold by InsideRule; the cell has the middle, so
 * that w is off by half the tolerance at most. Then the output says so: field data "MergeTolerance"
 * has the tolerance, and is absent where nothing was lost. A cell that is divided has the means of
 * its voxels, and in "Inside" 1 where half of them or more are inside.
 *
 * There are no signed distances, which have no equal neighbours.
 *
 * **Pipeline.** The grid is laid over the source as it is at each execution. The filter works on
 * the whole: where several pieces are asked for, the first has everything. Progress, abort and the
 * behaviour on the surface are vtkWindingNumberField's. The result has the same bits for any
 * number of threads. Memory is the result's, and about 130 MB for voxels at work.
 *
 * **Files.** vtkXMLHyperTreeGridWriter takes up to 16 bytes of memory for each vertex. Before VTK
 * 9.3 nobody can read what it writes of several arrays in appended mode, which is its default: call
 * SetDataModeToBinary(). Readers before VTK 9.4 leave the field data out.
 *
 * Errors, each one line through vtkErrorMacro, are vtkWindingNumberField's. Results larger
 * than the free memory are refused by an estimate before anything is allocated.
 *
 * @sa vtkWindingNumberField vtkHyperTreeGridThreshold vtkXMLHyperTreeGridWriter
 */
#ifndef vtkWindingNumberHyperTree_h
#define vtkWindingNumberHyperTree_h

#include "vtkWindingABINamespace.h"
#include "vtkWindingNumberGridAlgorithm.h"
#include "vtkWindingNumberImageAlgorithm.h" // for the choices

namespace winding
{
struct ResultOptions;
struct VoxelTreeOptions;
} // namespace winding
VTK_ABI_NAMESPACE_BEGIN
class vtkHyperTreeGrid;

class VTKFILTERSWINDING_EXPORT vtkWindingNumberHyperTree : public vtkWindingNumberGridAlgorithm
{
public:
  static vtkWindingNumberHyperTree* New();
  vtkTypeMacro(vtkWindingNumberHyperTree, vtkWindingNumberGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Whether to add the array of w. Default on.
  vtkSetMacro(GenerateWindingNumber, vtkTypeBool);
  vtkGetMacro(GenerateWindingNumber, vtkTypeBool);
  vtkBooleanMacro(GenerateWindingNumber, vtkTypeBool);
  ///@}

  ///@{
  /// Whether to add the array "Inside" (1 inside and 0 outside). Default off.
  vtkSetMacro(GenerateInside, vtkTypeBool);
  vtkGetMacro(GenerateInside, vtkTypeBool);
  vtkBooleanMacro(GenerateInside, vtkTypeBool);
  ///@}

  ///@{
  /// The name of the array of w. Default "WindingNumber".
  vtkSetStringMacro(ResultArrayName);
  vtkGetStringMacro(ResultArrayName);
  ///@}

  ///@{
  /// The type of the array of w, VTK_FLOAT or VTK_DOUBLE. Default VTK_FLOAT.
  vtkSetMacro(OutputScalarType, int);
  vtkGetMacro(OutputScalarType, int);
  void SetOutputScalarTypeToFloat() { this->SetOutputScalarType(VTK_FLOAT); }
  void SetOutputScalarTypeToDouble() { this->SetOutputScalarType(VTK_DOUBLE); }
  const char* GetOutputScalarTypeAsString() const;
  ///@}

  ///@{
  /// The rule by which a voxel is inside, one of vtkWindingNumberField::CoverageType. Default
  /// CENTER (0). ANY (1) and FRACTION (2) add the array "Inside", FRACTION also "Coverage".
  vtkSetMacro(Coverage, int);
  vtkGetMacro(Coverage, int);
  void SetCoverageToCenter() { this->SetCoverage(vtkWindingNumberImageAlgorithm::CENTER); }
  void SetCoverageToAny() { this->SetCoverage(vtkWindingNumberImageAlgorithm::ANY); }
  void SetCoverageToFraction() { this->SetCoverage(vtkWindingNumberImageAlgorithm::FRACTION); }
  const char* GetCoverageAsString() const;
  ///@}

  ///@{
  /// The number of samples along each axis of a voxel, for FRACTION. 1 to 10, default 4.
  vtkSetMacro(CoverageSamples, int);
  vtkGetMacro(CoverageSamples, int);
  ///@}

  ///@{
  /// The largest difference of w between voxels that share a cell, where w is not an integer
  /// everywhere. 0 loses nothing, but then no voxels share a cell where w is smooth. Below the
  /// errors that Tolerance admits it divides cells for these errors. 0 or more, default 0.01.
  vtkSetMacro(MergeTolerance, double);
  vtkGetMacro(MergeTolerance, double);
  ///@}

  ///@{
  /// Whether cells that are not inside are masked, so that what is seen are the voxels inside.
  /// Default off.
  vtkSetMacro(MaskOutside, vtkTypeBool);
  vtkGetMacro(MaskOutside, vtkTypeBool);
  vtkBooleanMacro(MaskOutside, vtkTypeBool);
  ///@}

  ///@{
  /// The numbers of the last result: cells that are not divided and not masked; and all vertices of
  /// the trees, divided and masked ones included; each has a place in the arrays.
  vtkGetMacro(NumberOfLeaves, vtkIdType);
  vtkGetMacro(NumberOfVertices, vtkIdType);
  ///@}

  /// The number of voxels inside, of the last result: as "Inside" says, by coverage too, whether or
  /// not that array is made.
  vtkGetMacro(NumberOfInsideSamples, vtkIdType);

  /// The output of port 0.
  vtkHyperTreeGrid* GetOutput();

protected:
  vtkWindingNumberHyperTree();
  ~vtkWindingNumberHyperTree() override;

  vtkWindingNumberHyperTree(const vtkWindingNumberHyperTree&) = delete;
  void operator=(const vtkWindingNumberHyperTree&) = delete;

  int FillOutputPortInformation(int port, vtkInformation* info) override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void CheckProperties() override;
  void HashProperties(winding::ContentHash& hash) override;

  bool WorksOnFirstRank() const override { return true; }
  double GetResultBytes(vtkIdType samples) const override;
  std::size_t GetAdditionalBytes(const winding::Field& field, vtkIdType samples) override;
  bool MayTouchVoxels() const override { return this->Coverage == 0; }
  bool TakesTouchedVoxels() const override { return this->Coverage == 1; }

  vtkTypeBool GenerateWindingNumber = 1;
  vtkTypeBool GenerateInside = 0;
  char* ResultArrayName = nullptr;
  int OutputScalarType = VTK_FLOAT;
  int Coverage = 0;
  int CoverageSamples = 4;
  double MergeTolerance = 0.01;
  vtkTypeBool MaskOutside = 0;
  vtkIdType NumberOfLeaves = 0;
  vtkIdType NumberOfVertices = 0;
  vtkIdType NumberOfInsideSamples = 0;

private:
  winding::ResultOptions GetResultOptions() const;
  winding::VoxelTreeOptions GetTreeOptions() const;
  void MakeTrees(const winding::Field& field, vtkHyperTreeGrid* output);
  void TellTolerance(const winding::Field& field, vtkHyperTreeGrid* output) const;
};
VTK_ABI_NAMESPACE_END

#endif
