// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindingNumberLabels
 * @brief   which of several solids each voxel lies in, as an image of labels
 *
 * The filter takes an assembly, such as bones, parts or materials, and gives vtkImageData with the
 * array "Label" (unsigned short): the label of the solid that the voxel lies in, 0 outside of all.
 * A voxel lies in a solid if it is inside by the solid's own winding number, as in the array
 * "Inside" that vtkWindingNumberField makes of that solid alone on the same grid: WindingThreshold,
 * InsideRule and Coverage say what inside is, to the bit. OverlapRule decides where it lies in
 * several.
 *
 * **Solids.**
 * - Of a vtkMultiBlockDataSet every leaf is one, in blocks of blocks, too; a multi-piece counts as
 *   one leaf. Of a vtkPartitionedDataSetCollection every partitioned data set is one, and any
 *   other composite, as a vtkPartitionedDataSet, is one itself. Their labels are 1, 2, … in their
 *   order. A block that is empty or not there has a label, which no voxel gets.
 * - Of several inputs every one is a block, in the order of the connections.
 * - Of a single data set every region is one: the cells with one value of the cell array
 *   RegionArray, an integer or a text. The label of an integer is that value plus LabelOffset.
 *   Texts have the labels 1, 2, … in their order; so have integers where some would give no label
 *   and LabelOffset is 0, with a warning. Polydata has regions of polygons and strips,
 *   other data sets have regions with outer surfaces of their own.
 * - Of a single data set without a RegionArray every part is one that shares edges with no other;
 *   the wall of a cavity, which is oriented inward, belongs to the part around it, and closed parts
 *   that touch are apart. They have the labels 1, 2, … by their volumes, the largest first.
 *   Where a file names them, parts of one name are one, with labels in the order of the names:
 *   the first of objects, solids and groups that do not divide a part, or else materials, if each
 *   part has another one. Names are the cell arrays "ObjectIds", "SolidIds", "GroupIds" and
 *   "MaterialIds" of vtkWindingNumberReader, with "ObjectNames" and so on in the field data.
 *
 * Each solid is a surface or a cloud as vtkWindingNumberAlgorithm says, and need not be closed: its
 * winding number decides.
 *
 * **Output.** In addition to "Label", which is active, there are arrays by GenerateSolidCount and
 * CoverageArrays. The field data has a row for each solid: "LabelValues" (unsigned short),
 * "LabelVolumes" (double), of its voxels in this piece, and "LabelNames" (strings). Names are the
 * blocks', or "Block n" where there is none, the inputs' (SetInputName()), the file's, a region's,
 * which is a text or the array and the integer, or "Part n". A name that occurs again gets a
 * number. For a surface of all labels that meets without gaps see vtkWindingNumberVoxels, or smooth
 * vtkSurfaceNets3D.
 *
 * **Pipeline.** The image is laid by vtkWindingNumberImageAlgorithm, which says how the filter
 * streams. One solid after the other is built, evaluated where it can be inside and forgotten, so
 * that the memory in addition to the input and the image is one solid's, and that of at most 16
 * million of its voxels at a time (or one layer of the grid). Every piece builds all solids again.
 * Results have the same bits for any threads and pieces and for any order of the primitives within
 * solids. In a parallel program every rank has as many blocks, each of them a part of the solid or
 * nothing; or cells of any regions. For parts by connectivity one rank has the whole surface, or
 * all do.
 *
 * Sides are decided on values in float. VerifySamples of each solid are compared, for which its
 * values are made once more; the findings are about all solids together. LongestExpectedTime is
 * compared with what the solids up to one take, and that one is expected to. Facts about the source
 * are sums over all solids, and the method is the one of the solid with the most primitives.
 *
 * Errors, each one line through vtkErrorMacro, are vtkWindingNumberField's, and labels that
 * are not 1 to 65535, blocks without a surface where others have one, and arrays that do not say
 * regions. Warnings, each one line, count solids that are empty, not closed or inside out, and
 * names that occur again. One names an input that seems to be in another unit than another one.
 *
 * @sa vtkWindingNumberField vtkWindingNumberVoxels vtkSurfaceNets3D
 */
#ifndef vtkWindingNumberLabels_h
#define vtkWindingNumberLabels_h

#include "vtkSmartPointer.h" // for several inputs
#include "vtkWindingABINamespace.h"
#include "vtkWindingNumberImageAlgorithm.h"

#include <cstddef> // for std::size_t
#include <map>     // for the names of inputs
#include <string>  // for the names of solids

namespace winding
{
class LabelImage;
class Solids;
struct LabelFacts;
struct LabelImageOptions;
struct LabelOptions;
} // namespace winding

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiBlockDataSet;

class VTKFILTERSWINDING_EXPORT vtkWindingNumberLabels : public vtkWindingNumberImageAlgorithm
{
public:
  static vtkWindingNumberLabels* New();
  vtkTypeMacro(vtkWindingNumberLabels, vtkWindingNumberImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The rules by which a voxel that lies in several solids gets its label.
  enum OverlapRuleType
  {
    FIRST = 0, ///< the label of the first of them, in the order of the labels
    LAST = 1,  ///< the label of the last
    /// The label of the solid with the largest w at the centre, in float, or with the largest |w|
    /// for the inside rule ABSOLUTE; the first of equal ones.
    LARGEST_WINDING_NUMBER = 2,
    /// The label of the solid of the smallest volume, which is exact for closed surfaces and about
    /// right for others (SourceVolume.h); the first of equal ones. So a part within a part shows.
    SMALLEST_VOLUME = 3
  };

  ///@{
  /// The rule by which a voxel that lies in several solids gets its label. Default FIRST.
  vtkSetMacro(OverlapRule, int);
  vtkGetMacro(OverlapRule, int);
  void SetOverlapRuleToFirst() { this->SetOverlapRule(FIRST); }
  void SetOverlapRuleToLast() { this->SetOverlapRule(LAST); }
  void SetOverlapRuleToLargestWindingNumber() { this->SetOverlapRule(LARGEST_WINDING_NUMBER); }
  void SetOverlapRuleToSmallestVolume() { this->SetOverlapRule(SMALLEST_VOLUME); }
  const char* GetOverlapRuleAsString() const;
  ///@}

  ///@{
  /// Whether to add the array "SolidCount" (unsigned short): the number of solids that the voxel
  /// lies in. Default off.
  vtkSetMacro(GenerateSolidCount, vtkTypeBool);
  vtkGetMacro(GenerateSolidCount, vtkTypeBool);
  vtkBooleanMacro(GenerateSolidCount, vtkTypeBool);
  ///@}

  /// The arrays that the coverage FRACTION adds.
  enum CoverageArraysType
  {
    /// The two largest shares of each voxel, "FirstShare" and "SecondShare" (float), and the labels
    /// that have them, "FirstLabel" and "SecondLabel" (unsigned short), 0 for none. Of equal shares
    /// the one of the solid that comes first is the larger.
    TWO_LARGEST = 0,
    /// An array of floats for each solid, "Coverage " and its label: the share of the voxel.
    EACH_LABEL = 1
  };

  ///@{
  /// The arrays that the coverage FRACTION adds. Default TWO_LARGEST.
  vtkSetMacro(CoverageArrays, int);
  vtkGetMacro(CoverageArrays, int);
  void SetCoverageArraysToTwoLargest() { this->SetCoverageArrays(TWO_LARGEST); }
  void SetCoverageArraysToEachLabel() { this->SetCoverageArrays(EACH_LABEL); }
  const char* GetCoverageArraysAsString() const;
  ///@}

  ///@{
  /// The name of the cell array that says of a single data set which cells are a solid. Default: no
  /// name, for the parts by connectivity, where parts that a file names alike are one; the name
  /// None means the same if no array has it. It has no effect for blocks.
  vtkSetStringMacro(RegionArray);
  vtkGetStringMacro(RegionArray);
  ///@}

  ///@{
  /// The number that is added to a region to give its label: 1 for regions that begin with 0, as
  /// vtkConnectivityFilter's do. Default 0.
  vtkSetMacro(LabelOffset, int);
  vtkGetMacro(LabelOffset, int);
  ///@}

  /// Adds an input, which is a solid or has several. Without a pipeline, as SetInputData().
  void AddInputData(vtkDataObject* source) { this->AddInputDataInternal(0, source); }

  ///@{
  /// The names of several inputs, by the numbers of their connections from 0 on. An input without
  /// a name is called "Input 1" and so on. Default: no names.
  void SetInputName(int connection, const char* name);
  const char* GetInputName(int connection) const;
  void ClearInputNames();
  ///@}

  /// The labels and names of the solids of the last execution, as "LabelValues" and "LabelNames"
  /// have them: a line for each, of the label, a tab and the name.
  const char* GetLabelLegend() const { return this->LabelLegend.c_str(); }

  /// Returns a line with the name and the volume of each of the first twenty solids; nothing where
  /// the last execution made a piece of the grid.
  const char* GetVolumesInWords() const { return this->VolumesInWords.c_str(); }

  ///@{
  /// Facts about the last execution: the number of solids, and of those that have no primitives,
  /// those that are surfaces with net boundary edges, and those that are inside out, which is known
  /// as GetSourceIsInsideOut() is.
  vtkIdType GetNumberOfSolids() const;
  vtkIdType GetNumberOfEmptySolids() const;
  vtkIdType GetNumberOfOpenSolids() const;
  vtkIdType GetNumberOfInsideOutSolids() const;
  ///@}

protected:
  vtkWindingNumberLabels();
  ~vtkWindingNumberLabels() override;

  vtkWindingNumberLabels(const vtkWindingNumberLabels&) = delete;
  void operator=(const vtkWindingNumberLabels&) = delete;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkDataObject* MakeSource() override;
  void CheckProperties() override;
  void HashProperties(winding::ContentHash& hash) override;
  void CheckSource(vtkDataObject* source) override;
  void WarnOfFaults(const winding::Field& field) override;
  bool HasSeveralSources() const override { return true; }
  const winding::FieldInfo& GetSourceInfo() const override;
  double GetResultBytes(vtkIdType samples) const override;

  int GetActiveScalarType() const override { return VTK_UNSIGNED_SHORT; }
  void MakeImage(vtkDataObject* source, const std::array<int, 6>& samples, vtkImageData* image,
    vtkDataSetAttributes* attributes) override;
  void UniteTimes(vtkImageData* all, vtkImageData* other) override;

  int OverlapRule = FIRST;
  vtkTypeBool GenerateSolidCount = 0;
  int CoverageArrays = TWO_LARGEST;
  char* RegionArray = nullptr;
  int LabelOffset = 0;

private:
  winding::LabelImageOptions GetImageOptions(std::size_t solids) const;
  winding::LabelOptions GetLabelOptions() const;
  void MergeSolids(const winding::Solids& solids, winding::LabelImage& labels);
  void DescribeSolids(const winding::Solids& solids, vtkImageData* image);
  void MeasureSolids(vtkImageData* image);
  void WarnOfSolids(const winding::Solids& solids);

  std::unique_ptr<winding::LabelFacts> Facts;
  std::string LabelLegend, VolumesInWords;
  std::map<int, std::string> InputNames;
  vtkSmartPointer<vtkMultiBlockDataSet> Blocks; ///< several inputs, as MakeSource() returned them
};
VTK_ABI_NAMESPACE_END

#endif
