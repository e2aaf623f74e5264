// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindingNumberSurface
 * @brief   smooth or sharp surface of the solid that a source encloses: w = WindingThreshold
 *
 * The filter takes a source (see vtkWindingNumberAlgorithm) and gives the surface of its inside, as
 * triangles: where w crosses WindingThreshold or, more generally, where InsideRule changes its
 * answer. Holes of the source are closed by the level set of w, which is smooth there.
 *
 * @code
 *   vtkNew<vtkWindingNumberSurface> surface;
 *   surface->SetInputConnection(reader->GetOutputPort());
 *   surface->SetResolution(128);
 * @endcode
 *
 * How the surface is made, smooth or sharp, is vtkWindingNumberSurfaceAlgorithm's. The field of a
 * source that is not closed is kept as a whole only to be verified.
 *
 * **Offsets and shells.** FillCavities, Offset and Shell change the solid, in this order, before
 * its surface is made. Vertices of a smooth surface lie at the exact distance. It is measured from
 * the source's triangles where all of them bound the solid, and for a centered shell of any open
 * surface. In all other cases it is measured from the surface that the same number of voxels makes
 * of the source alone: of clouds, of solids that overlap, of cavities that are filled, of holes
 * that w closes. The field data say which, as string array "DistancesFrom": "source" or "surface".
 *
 * Errors, each one line through vtkErrorMacro, are vtkWindingNumberField's, and grids with
 * only one voxel along an axis.
 *
 * @sa vtkWindingNumberField vtkWindingNumberVoxels
 */
#ifndef vtkWindingNumberSurface_h
#define vtkWindingNumberSurface_h

#include "vtkWindingABINamespace.h"
#include "vtkWindingNumberSurfaceAlgorithm.h"

#include <memory>
#include <string>

namespace winding
{
class DistanceTree;
} // namespace winding

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSWINDING_EXPORT vtkWindingNumberSurface : public vtkWindingNumberSurfaceAlgorithm
{
public:
  static vtkWindingNumberSurface* New();
  vtkTypeMacro(vtkWindingNumberSurface, vtkWindingNumberSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Whether what the outside does not reach is inside, as in a hollow scan. The outside spreads
  /// from the border of the grid along its axes, from sample to sample, so gaps narrower than a
  /// voxel may be closed. The field data get the number of cavities as int array "FilledCavities".
  /// Default off.
  vtkSetMacro(FillCavities, vtkTypeBool);
  vtkGetMacro(FillCavities, vtkTypeBool);
  vtkBooleanMacro(FillCavities, vtkTypeBool);
  ///@}

  ///@{
  /// The width of openings that do not let the outside into cavities, with FillCavities, as a
  /// length in the source's unit: a model of two walls with pin holes becomes one solid. Voxels
  /// should be half as long at most, and a warning says so. The grid over the source's bounds grows
  /// with it. Default 0.
  vtkSetMacro(GapWidth, double);
  vtkGetMacro(GapWidth, double);
  ///@}

  ///@{
  /// How far the surface moves outward, inward if negative, as a length in the source's unit: it is
  /// the level set of the signed distance. Convex edges become round outward and stay sharp inward.
  /// The grid over the source's bounds grows with it. Default 0.
  vtkSetMacro(Offset, double);
  vtkGetMacro(Offset, double);
  ///@}

  ///@{
  /// The thickness of the shell that replaces the solid, as a length in the source's unit; 0, the
  /// default, for no shell. A shell thinner than a voxel's diagonal may have holes, and a warning
  /// says so.
  vtkSetMacro(Shell, double);
  vtkGetMacro(Shell, double);
  ///@}

  /// The sides of the surface that a shell lies on.
  enum ShellSideType
  {
    INWARD = 0,
    OUTWARD = 1,
    CENTERED = 2 ///< half of the thickness on either side; with its rim, where the source is open
  };

  ///@{
  /// The side of the surface, once moved by Offset, that the shell lies on. CENTERED thickens an
  /// open source as a sheet, unless Offset or FillCavities is set. Default INWARD.
  vtkSetMacro(ShellSide, int);
  vtkGetMacro(ShellSide, int);
  void SetShellSideToInward() { this->SetShellSide(INWARD); }
  void SetShellSideToOutward() { this->SetShellSide(OUTWARD); }
  void SetShellSideToCentered() { this->SetShellSide(CENTERED); }
  const char* GetShellSideAsString() const;
  ///@}

  ///@{
  /// Whether to add distances from the source, point array "DistanceToInput", as active scalars,
  /// in its unit, exact up to rounding. They are 0 where the surface follows the source, and grow
  /// over holes that it closes. Default off.
  vtkSetMacro(GenerateDistanceToInput, vtkTypeBool);
  vtkGetMacro(GenerateDistanceToInput, vtkTypeBool);
  vtkBooleanMacro(GenerateDistanceToInput, vtkTypeBool);
  ///@}

  ///@{
  /**
   * How many points to draw from the source and from the surface, to measure how near they are to
   * each other; 0, the default, measures nothing. The points are the same for every execution. The
   * field data get these arrays of one number, lengths in the unit of the source:
   *
   * - `LargestDistanceFromInput`, `MeanDistanceFromInput`: distances of points of the source from
   *   the surface;
   * - `LargestDistanceToInput`, `MeanDistanceToInput`: distances of points of the surface from the
   *   source;
   * - `InputVolume`, NaN for a source that is not a closed surface, and `Volume`;
   * - `InputComponents`, and `LostComponents`, those which the surface has nothing of: they are
   *   smaller than voxels see, or lie inside of others;
   * - `SelfIntersections`: pairs of the surface's triangles that pass through each other;
   * - `LargestShapeError`, `MeanShapeError`, with Offset or Shell only: by how much points of the
   *   surface are off the distance that these ask for.
   */
  vtkSetMacro(FidelitySamples, int);
  vtkGetMacro(FidelitySamples, int);
  ///@}

  /// Returns what the last execution measured by FidelitySamples, in two or three lines for people,
  /// and "" if it measured nothing.
  const char* GetFidelityInWords() const;

protected:
  vtkWindingNumberSurface() = default;
  ~vtkWindingNumberSurface() override = default;

  vtkWindingNumberSurface(const vtkWindingNumberSurface&) = delete;
  void operator=(const vtkWindingNumberSurface&) = delete;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void CheckProperties() override;
  void HashProperties(winding::ContentHash& hash) override;
  std::size_t GetAdditionalBytes(const winding::Field& field, vtkIdType samples) override;
  double GetReachBeyondSource() const override;
  winding::SurfaceOptions GetSurfaceOptions() const override;

  vtkTypeBool FillCavities = 0;
  double GapWidth = 0;
  double Offset = 0;
  double Shell = 0;
  int ShellSide = INWARD;
  vtkTypeBool GenerateDistanceToInput = 0;
  int FidelitySamples = 0;

private:
  std::shared_ptr<const winding::DistanceTree> MakeSurface(
    const winding::Field& field, vtkPolyData* output);
  void CompareWithSource(
    const winding::Field& field, const winding::DistanceTree* surfaceTree, vtkPolyData* output);
  void VerifyWholeGrid(const winding::Field& field);

  std::string FidelityInWords;
};
VTK_ABI_NAMESPACE_END

#endif
