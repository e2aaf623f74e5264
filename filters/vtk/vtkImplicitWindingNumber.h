// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkImplicitWindingNumber
 * @brief   implicit function of the winding number of a surface or an oriented point cloud
 *
 * The value at a point is the field's WindingThreshold − w, w being the generalized winding number
 * of the input there (see vtkWindingNumberAlgorithm, also for the inputs that are possible):
 * negative inside, positive outside. The gradient is −∇w. So VTK's own filters clip, cut, extract
 * and sample with surfaces that need not be closed, with triangle soups and with clouds:
 *
 * @code
 *   vtkNew<vtkImplicitWindingNumber> inside;
 *   inside->SetInput(scan);
 *   inside->GetField()->SetTolerance(1e-4);
 *   vtkNew<vtkClipDataSet> clip;
 *   clip->SetInputConnection(grid->GetOutputPort());
 *   clip->SetClipFunction(inside);
 *   clip->InsideOutOn(); // keep the part that is inside
 * @endcode
 *
 * The function is no distance: across the surface the value jumps by one, and away from holes it is
 * the same everywhere on a side. A filter that interpolates between its points therefore finds the
 * surface in the right cells, about half way through them; fine cells make it smooth. The gradient
 * is the one off the surface, so it is 0 for closed surfaces. For a mesh it is exact, by a sum over
 * the edges of its boundary.
 *
 * Like other implicit functions it has no pipeline: the input is a data object, which its producer
 * must have updated. Nor has it ranks: in a parallel program it is the function of the input that
 * this process has, which must all have been gathered before, if it is held in parts. An input
 * that its producer has made as one of several pieces is refused. GetMTime() says when the input
 * or a property was modified, and the next call works with their new state. SetTransform() has
 * points transformed first.
 *
 * The first call builds the field of the input, or BuildField() does so before. After that, values
 * and gradients may be asked for from any number of threads, without a lock, as long as nobody
 * modifies the function or the input meanwhile; a value's bits depend on the input and the point
 * only. The first call may come from many threads at once, too: one of them builds, alone if it
 * runs in a parallel section of vtkSMPTools, and the others wait. BuildField() has all threads
 * build. It must come before a parallel section if the input has volume cells: VTK's filter for
 * their surface would start another section in it, and TBB may then give the thread that builds a
 * call that waits for the field.
 *
 * One call takes some microseconds for tolerances that leave an approximation; AUTOMATIC then takes
 * a hierarchy for inputs of any size, as though HIERARCHICAL were asked for. DIRECT and PARITY ask
 * every primitive, which takes a hundred times as long for large inputs. Arrays of points
 * (FunctionValue(vtkDataArray*, vtkDataArray*)) are evaluated together, on the threads of
 * vtkSMPTools: the values are the same up to the Tolerance, and with DIRECT and PARITY to the bit.
 *
 * Without an input, or with one that cannot be worked with (w is not defined for points without
 * normals, for example), an error is reported once, and again only after input or properties
 * change; w counts as 0, so that everything is outside. Points that are NaN or infinite have the
 * value NaN.
 *
 * @sa vtkWindingNumberProbe vtkWindingNumberField vtkImplicitPolyDataDistance
 */
#ifndef vtkImplicitWindingNumber_h
#define vtkImplicitWindingNumber_h

#include "vtkFiltersWindingModule.h" // for export macro
#include "vtkImplicitFunction.h"
#include "vtkSmartPointer.h" // for the input
#include "vtkWindingABINamespace.h"
#include "vtkWindingNumberField.h" // for the properties

#include <memory> // for the field that was built
#include <vector> // for values

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;

class VTKFILTERSWINDING_EXPORT vtkImplicitWindingNumber : public vtkImplicitFunction
{
public:
  static vtkImplicitWindingNumber* New();
  vtkTypeMacro(vtkImplicitWindingNumber, vtkImplicitFunction);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The surface or cloud: any vtkPointSet, or composite data of them.
  void SetInput(vtkDataObject* input);
  vtkDataObject* GetInput();
  ///@}

  /// Returns the filter that holds the properties of the source, the method and the inside test.
  /// Its input, grid, arrays, threads and ranks are ignored. The method ROWS is for grids and an
  /// error here, and so is the inside rule ODD, which is no comparison with a threshold.
  vtkGetObjectMacro(Field, vtkWindingNumberField);

  /// Builds the field that the next call would build, unless it is there. Returns false, after an
  /// error, if the input cannot be worked with.
  bool BuildField();

  /// The time of the last modification of this function, its field or its input.
  vtkMTimeType GetMTime() override;

  using vtkImplicitFunction::EvaluateFunction;
  /// The value at a point, which no transform is applied to.
  double EvaluateFunction(double x[3]) override;
  /// The values at all points of an array, evaluated together.
  void EvaluateFunction(vtkDataArray* input, vtkDataArray* output) override;
  /// The gradient −∇w at a point, which no transform is applied to, in 1/length of the input.
  void EvaluateGradient(double x[3], double g[3]) override;

  using vtkImplicitFunction::FunctionValue;
  /// Transforms all points, then evaluates them together, where vtkImplicitFunction would evaluate
  /// transformed points one by one.
  void FunctionValue(vtkDataArray* input, vtkDataArray* output) override;

protected:
  vtkImplicitWindingNumber();
  ~vtkImplicitWindingNumber() override;

  vtkImplicitWindingNumber(const vtkImplicitWindingNumber&) = delete;
  void operator=(const vtkImplicitWindingNumber&) = delete;

  vtkWindingNumberField* Field;

private:
  struct Built;
  struct Internals;

  bool IsCurrent(const Built* built);
  const winding::Field* CurrentField();
  const winding::Field* PrepareField();
  const winding::Field& MakeField();
  bool EvaluateAll(vtkDataArray* positions, std::vector<double>& windingNumbers);
  double ValueOf(double windingNumber) const;

  vtkSmartPointer<vtkDataObject> Input;
  std::unique_ptr<Internals> Internal;
};
VTK_ABI_NAMESPACE_END

#endif
