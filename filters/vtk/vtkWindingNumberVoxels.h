// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindingNumberVoxels
 * @brief   surface of the voxels that are inside, as quads
 *
 * The filter takes the image of vtkWindingNumberField (or any vtkImageData with a scalar array) and
 * gives the "block" surface of its inside voxels: one quad for every face between an inside voxel
 * and an outside one, or the edge of the image, facing outwards. Quads share their vertices; there
 * are no faces inside, no duplicate points and no unused points.
 *
 * Samples may be the image's points (a voxel around each, of the size of the spacing) or its cells.
 * InsideRule and WindingThreshold say which voxels are inside; NaN is outside. If the image has an
 * array "Coverage", each quad carries the value of its voxel, as cell data to colour it by.
 *
 * **Labels.** ByLabel says whether the array has labels, as from vtkWindingNumberLabels: integers
 * from 0, outside, to 65535. There is one quad for every face between voxels of different labels.
 * So the surfaces of neighbours meet without gaps, and the surface of each label, of all quads that
 * have it on a side, is closed. A quad looks outside, or from the smaller label to the larger. Its
 * cell data give both: "BoundaryLabels", with the components "From", the label that it looks away
 * from, and "To", the one that it looks to, 0 outside; and "Label", the former alone, which is
 * active. InsideRule and WindingThreshold have no effect then.
 *
 * **Attributes.** Port 1 may have the source that the image was made of, a surface or points. With
 * TransferAttributes or GenerateNearestCells points and quads then get what is nearest in it, as
 * surfaces do (vtkWindingNumberSurfaceAlgorithm). Without a source they have no effect.
 *
 * SetInputArrayToProcess(0, …) picks the array; if it picks none, the active scalars of the points
 * are taken, or else the cells'. Time is linear in voxels and quads; working memory is a
 * byte for each voxel and 9 for each quad, or with labels 2 bytes and 10. The order of points and
 * quads depends on the input only. The filter works on the whole image: where several pieces are
 * asked for, the first has everything. When it is aborted, its output is empty.
 *
 * @sa vtkWindingNumberField vtkWindingNumberLabels vtkThreshold
 */
#ifndef vtkWindingNumberVoxels_h
#define vtkWindingNumberVoxels_h

#include "vtkFiltersWindingModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkWindingABINamespace.h"
#include "vtkWindingNumberAlgorithm.h" // for the choices

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;

class VTKFILTERSWINDING_EXPORT vtkWindingNumberVoxels : public vtkPolyDataAlgorithm
{
public:
  static vtkWindingNumberVoxels* New();
  vtkTypeMacro(vtkWindingNumberVoxels, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The names that messages give properties, of vtkWindingNumberAlgorithm::NamesInMessagesType.
  /// Default CXX_NAMES.
  vtkSetMacro(NamesInMessages, int);
  vtkGetMacro(NamesInMessages, int);
  ///@}

  ///@{
  /// The value that InsideRule compares w with; a finite number. Default 0.5.
  vtkSetMacro(WindingThreshold, double);
  vtkGetMacro(WindingThreshold, double);
  ///@}

  ///@{
  /// The rule by which a voxel is inside, one of vtkWindingNumberAlgorithm::InsideRuleType. Default
  /// SIGNED.
  vtkSetMacro(InsideRule, int);
  vtkGetMacro(InsideRule, int);
  void SetInsideRuleToSigned() { this->SetInsideRule(vtkWindingNumberAlgorithm::SIGNED); }
  void SetInsideRuleToAbsolute() { this->SetInsideRule(vtkWindingNumberAlgorithm::ABSOLUTE); }
  void SetInsideRuleToOdd() { this->SetInsideRule(vtkWindingNumberAlgorithm::ODD); }
  const char* GetInsideRuleAsString() const;
  ///@}

  /// The values of ByLabel.
  enum ByLabelType
  {
    LABELS_OFF = 0,
    LABELS_ON = 1,
    LABELS_AUTOMATIC = 2 ///< on for integers from 0 to 65535 with the name "Label"
  };

  ///@{
  /// Whether the array has labels, so that there are quads between voxels of different ones.
  /// Default LABELS_AUTOMATIC.
  vtkSetMacro(ByLabel, int);
  vtkGetMacro(ByLabel, int);
  vtkBooleanMacro(ByLabel, int);
  void SetByLabelToOff() { this->SetByLabel(LABELS_OFF); }
  void SetByLabelToOn() { this->SetByLabel(LABELS_ON); }
  void SetByLabelToAutomatic() { this->SetByLabel(LABELS_AUTOMATIC); }
  const char* GetByLabelAsString() const;
  ///@}

  ///@{
  /// The source that attributes come from, on port 1. Default: none.
  void SetSourceConnection(vtkAlgorithmOutput* source) { this->SetInputConnection(1, source); }
  void SetSourceData(vtkDataObject* source) { this->SetInputDataObject(1, source); }
  ///@}

  ///@{
  /// Whether points and quads take over the arrays of the source. Default off.
  vtkSetMacro(TransferAttributes, vtkTypeBool);
  vtkGetMacro(TransferAttributes, vtkTypeBool);
  vtkBooleanMacro(TransferAttributes, vtkTypeBool);
  ///@}

  ///@{
  /// Whether to add "NearestCell" and "NearestBlock" to points and quads. Default off.
  vtkSetMacro(GenerateNearestCells, vtkTypeBool);
  vtkGetMacro(GenerateNearestCells, vtkTypeBool);
  vtkBooleanMacro(GenerateNearestCells, vtkTypeBool);
  ///@}

  ///@{
  /// The planes of symmetry of a source that is one side of them, as
  /// vtkWindingNumberAlgorithm::Mirror. Default: none.
  vtkSetStringMacro(Mirror);
  vtkGetStringMacro(Mirror);
  ///@}

  /// Returns the names of the labels of the last execution, as vtkWindingNumberLabels does; empty
  /// where the input has none.
  const char* GetLabelLegend() const { return this->LabelLegend.c_str(); }

protected:
  vtkWindingNumberVoxels();
  ~vtkWindingNumberVoxels() override;

  vtkWindingNumberVoxels(const vtkWindingNumberVoxels&) = delete;
  void operator=(const vtkWindingNumberVoxels&) = delete;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  int NamesInMessages = 0; // vtkWindingNumberAlgorithm::CXX_NAMES
  double WindingThreshold = 0.5;
  int InsideRule = 0;
  int ByLabel = LABELS_AUTOMATIC;
  vtkTypeBool TransferAttributes = 0;
  vtkTypeBool GenerateNearestCells = 0;
  char* Mirror = nullptr;

private:
  /// The array that separates inside from outside; sets whether it is of the points or of the
  /// cells. Throws a refusal if there is none.
  vtkDataArray* FindValues(vtkImageData* image, int& association);
  void MakeSurface(vtkImageData* image, vtkPolyData* output);
  void AddNearest(vtkDataObject* source, vtkPolyData* output);
  void WarnOfNegative(vtkDataArray* values);

  std::string LabelLegend;
};
VTK_ABI_NAMESPACE_END

#endif
