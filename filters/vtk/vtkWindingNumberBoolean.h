// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindingNumberBoolean
 * @brief   union, intersection or difference of solids, of whatever sources
 *
 * Operands are any sources (see vtkWindingNumberAlgorithm): closed or open surfaces, soups, clouds.
 * Each encloses a solid by its own winding number, InsideRule and WindingThreshold, so that none
 * has to be closed, manifold or free of self-intersections. The result is the surface of the union
 * of these solids, or of what another operation leaves of them.
 *
 * @code
 *   vtkNew<vtkWindingNumberBoolean> boolean;
 *   boolean->SetInputConnection(0, scan->GetOutputPort());
 *   boolean->SetInputConnection(1, box->GetOutputPort());
 *   boolean->SetOperationToDifference();
 *   boolean->SetResolution(256);
 * @endcode
 *
 * The operands are the connections of port 0, and then of port 1, if it has any, in their
 * order. A single connection with composite data has its blocks as operands.
 *
 * All operands are sampled on one grid. A sample is inside of the result if the operation says so.
 * Where that changes along an edge of the grid, the vertex lies on the operand that makes the
 * change: where the operand is closed, exactly. A sharp surface has the edges where operands meet.
 * How the surface is made is vtkWindingNumberSurfaceAlgorithm's. It is a closed 2-manifold but at
 * the border of the grid. An operand that is there twice, and operands that touch or share faces,
 * give no slivers, as each sample has one answer for both.
 *
 * The grid is laid over what the result can reach: the bounds of the first operand for a
 * difference, the common part of all bounds for an intersection, all bounds else. Operands with a
 * threshold below 0.5, and all where a SheetSide is set, reach beyond their sources, and count for
 * no common part. A result that ends at the border of the grid gets a warning.
 *
 * The cell array "Operand" says which operand a face lies on, counted from 0. The field data have
 * their names, "OperandNames".
 *
 * Operands come one after the other. The field of each is kept, for the next execution to take if
 * its source is the same. Facts about the source are sums over all operands, and the method used is
 * the one of the largest.
 *
 * Errors, each one line through vtkErrorMacro, are vtkWindingNumberSurface's, and less than two
 * operands. Lines about an operand begin with its name.
 *
 * @sa vtkWindingNumberSurface vtkWindingNumberLabels
 */
#ifndef vtkWindingNumberBoolean_h
#define vtkWindingNumberBoolean_h

#include "vtkWindingABINamespace.h"
#include "vtkWindingNumberSurfaceAlgorithm.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace winding
{
class BooleanTask;
struct LabelFacts;
} // namespace winding

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiBlockDataSet;

class VTKFILTERSWINDING_EXPORT vtkWindingNumberBoolean : public vtkWindingNumberSurfaceAlgorithm
{
public:
  static vtkWindingNumberBoolean* New();
  vtkTypeMacro(vtkWindingNumberBoolean, vtkWindingNumberSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The operations on the operands.
  enum OperationType
  {
    UNION = 0,               ///< what is inside of any operand
    INTERSECTION = 1,        ///< what is inside of all operands
    DIFFERENCE = 2,          ///< what is inside of the first operand, and of no other
    SYMMETRIC_DIFFERENCE = 3 ///< what is inside of an odd number of operands
  };

  ///@{
  /// The operation on the operands. Default UNION.
  vtkSetMacro(Operation, int);
  vtkGetMacro(Operation, int);
  void SetOperationToUnion() { this->SetOperation(UNION); }
  void SetOperationToIntersection() { this->SetOperation(INTERSECTION); }
  void SetOperationToDifference() { this->SetOperation(DIFFERENCE); }
  void SetOperationToSymmetricDifference() { this->SetOperation(SYMMETRIC_DIFFERENCE); }
  const char* GetOperationAsString() const;
  ///@}

  /// Removes all connections of port 1.
  void RemoveOtherConnections() { this->SetInputConnection(1, nullptr); }

  ///@{
  /// The thresholds of operands, counted from 0. Default: WindingThreshold for all.
  void SetOperandThreshold(int operand, double threshold);
  double GetOperandThreshold(int operand) const;
  void ClearOperandThresholds();
  ///@}

  ///@{
  /// The inside rules of operands, counted from 0. Default: InsideRule for all.
  void SetOperandInsideRule(int operand, int rule);
  int GetOperandInsideRule(int operand) const;
  void ClearOperandInsideRules();
  ///@}

  ///@{
  /// The names of the connections of port 0, counted from 0, for warnings and OperandNames.
  /// Default: "Input 1" for the first operand, and so on; or the name of its block.
  void SetInputName(int connection, const char* name);
  const char* GetInputName(int connection) const;
  void ClearInputNames();
  ///@}

  ///@{
  /// The names of the connections of port 1, in the same way.
  void SetOtherName(int connection, const char* name);
  const char* GetOtherName(int connection) const;
  void ClearOtherNames();
  ///@}

  /// Returns the names of the operands of the last execution, as "OperandNames" has them: a line
  /// for each, of its number in "Operand", a tab and the name.
  const char* GetOperandLegend() const { return this->OperandLegend.c_str(); }

protected:
  vtkWindingNumberBoolean();
  ~vtkWindingNumberBoolean() override;

  vtkWindingNumberBoolean(const vtkWindingNumberBoolean&) = delete;
  void operator=(const vtkWindingNumberBoolean&) = delete;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void CheckProperties() override;
  void HashProperties(winding::ContentHash& hash) override;
  int GetNumberOfSourcePorts() const override { return 2; }
  vtkDataObject* MakeSource() override;
  void HashBounds(winding::ContentHash& hash) override;
  bool GetSourceBounds(vtkDataObject* source, double bounds[6]) override;
  void AddSolids(vtkDataObject* source, winding::WallGrid& grid) override;
  std::size_t GetAdditionalBytes(const winding::Field& field, vtkIdType samples) override;
  const winding::FieldInfo& GetSourceInfo() const override;
  bool HasSeveralSources() const override { return true; }

  int Operation = UNION;

private:
  void SetName(int port, int connection, const char* name);
  const char* GetName(int port, int connection) const;
  bool ReachesBeyondSource(int operand) const;
  void AddOperand(vtkDataObject* source, const std::string& name);
  void MakeResult(vtkPolyData* output);

  std::map<int, double> OperandThresholds;
  std::map<int, int> OperandInsideRules;
  std::map<int, std::string> Names[2]; ///< of connections, by port
  std::string OperandLegend;
  vtkSmartPointer<vtkMultiBlockDataSet> Blocks;
  std::unique_ptr<winding::LabelFacts> Facts;
  std::unique_ptr<winding::BooleanTask> Task;       ///< null unless data are requested
  std::unique_ptr<winding::InsideTest> OperandTest; ///< of the operand that is added
};
VTK_ABI_NAMESPACE_END

#endif
