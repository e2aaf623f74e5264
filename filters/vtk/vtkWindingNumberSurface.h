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
 * Errors, each one line through vtkErrorMacro, are vtkWindingNumberField's, and grids with
 * only one voxel along an axis.
 *
 * @sa vtkWindingNumberField vtkWindingNumberVoxels
 */
#ifndef vtkWindingNumberSurface_h
#define vtkWindingNumberSurface_h

#include "vtkWindingNumberSurfaceAlgorithm.h"

#include <string>

class VTKFILTERSWINDING_EXPORT vtkWindingNumberSurface : public vtkWindingNumberSurfaceAlgorithm
{
public:
  static vtkWindingNumberSurface* New();
  vtkTypeMacro(vtkWindingNumberSurface, vtkWindingNumberSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

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
   * - `SelfIntersections`: pairs of the surface's triangles that pass through each other.
   */
  vtkSetMacro(FidelitySamples, int);
  vtkGetMacro(FidelitySamples, int);
  ///@}

  /// Returns what the last execution measured by FidelitySamples, in two lines for people, and ""
  /// if it measured nothing.
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

  vtkTypeBool GenerateDistanceToInput = 0;
  int FidelitySamples = 0;

private:
  void MakeSurface(const winding::Field& field, vtkPolyData* output);
  void CompareWithSource(const winding::Field& field, vtkPolyData* output);
  void VerifyWholeGrid(const winding::Field& field);

  std::string FidelityInWords;
};

#endif
