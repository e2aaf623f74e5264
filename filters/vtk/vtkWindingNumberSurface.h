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
 * The samples of a grid, which are inside or outside, give the triangles, as marching cubes does
 * (vtkMarchingCubes). Every vertex then goes to where the true w crosses the threshold on its edge
 * of the grid. So the steps that a contour of a field of 0 and 1 shows do not come about: where the
 * source is closed, vertices lie on it. Vertices next to a sample stay 2⁻¹² of an edge away from
 * it, so that no two have the same place.
 *
 * **Sharp edges.** With Features SHARP the surface is made by dual contouring instead (Ju et al.,
 * Dual contouring of Hermite data, 2002). Every cell of eight samples has a vertex for each piece
 * of surface in it, where the planes of the source's triangles meet that cross the cell's edges; so
 * edges and corners stay sharp, if the cell sees the faces that meet there. Where no triangle
 * crosses, planes follow the gradient of w. Every crossed edge of the grid has a quad between the
 * four vertices around it. The surface is 2-manifold, also where two pieces of surface pass one
 * cell; in these cells triangles may pass through each other, and in no others.
 *
 * Triangles face outward, share their vertices, and leave no gaps but at the border of the grid. A
 * solid may reach beyond it: there the surface ends, or is closed if CloseBorder is on. Details
 * finer than a voxel may be lost, and edges of the source are cut off inside of voxels. Where all
 * samples are inside, or none is, the surface is empty, and a warning says what to do.
 *
 * **Pipeline.** The grid is laid over the source as it is at each execution. The filter works on
 * the whole: where several pieces are asked for, the first has everything. Progress and abort are
 * vtkWindingNumberField's. The result has the same bits for any number of threads, and for
 * any order of the source's triangles and points. It takes the memory of the triangles and 13 bytes
 * for each row of the grid. For a source that is not closed the field passes through memory in
 * slabs of about 100 MB; it is kept as a whole only to be verified.
 *
 * Errors, each one line through vtkErrorMacro, are vtkWindingNumberField's, and grids with
 * only one voxel along an axis.
 *
 * @sa vtkWindingNumberField vtkWindingNumberVoxels
 */
#ifndef vtkWindingNumberSurface_h
#define vtkWindingNumberSurface_h

#include "vtkWindingNumberGridAlgorithm.h"

#include <string>

class vtkPolyData;

namespace winding
{
class LevelEdges;
class LevelRoots;
class SmpExecutor;
} // namespace winding

class VTKFILTERSWINDING_EXPORT vtkWindingNumberSurface : public vtkWindingNumberGridAlgorithm
{
public:
  static vtkWindingNumberSurface* New();
  vtkTypeMacro(vtkWindingNumberSurface, vtkWindingNumberGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The ways to make the surface of what is inside.
  enum FeaturesType
  {
    SMOOTH = 0, ///< marching cubes; edges of the source are cut off inside of voxels
    SHARP = 1   ///< dual contouring; edges and corners of the source stay sharp
  };

  ///@{
  /// Whether edges and corners of the source stay sharp, as described above. Default SMOOTH.
  vtkSetMacro(Features, int);
  vtkGetMacro(Features, int);
  ///@}

  ///@{
  /// Whether all polygons of a sharp surface are triangles; a smooth one has no others. Default
  /// off: the sharp surface has quads, and four triangles where no diagonal of a quad is good.
  vtkSetMacro(GenerateTriangles, vtkTypeBool);
  vtkGetMacro(GenerateTriangles, vtkTypeBool);
  vtkBooleanMacro(GenerateTriangles, vtkTypeBool);
  ///@}

  ///@{
  /// Whether to close the surface where the solid reaches the border of the grid, by faces on the
  /// outer sides of the voxels, as vtkWindingNumberVoxels does. Default off: all of the surface is
  /// the level set, and parts that SamplingBounds cut off are missing.
  vtkSetMacro(CloseBorder, vtkTypeBool);
  vtkGetMacro(CloseBorder, vtkTypeBool);
  vtkBooleanMacro(CloseBorder, vtkTypeBool);
  ///@}

  ///@{
  /// Whether to add point normals, which point outward. A vertex has the normal of the source's
  /// triangle on which it lies, so that edges and details which voxels blur show in the shading. A
  /// vertex off the source's triangles, and any vertex of a cloud's surface, has the mean of the
  /// normals of the surface's own triangles around it, weighted by area. A sharp surface gets
  /// normals of its faces as cell data instead. Default on.
  vtkSetMacro(GenerateNormals, vtkTypeBool);
  vtkGetMacro(GenerateNormals, vtkTypeBool);
  vtkBooleanMacro(GenerateNormals, vtkTypeBool);
  ///@}

  ///@{
  /// The precision of the points: vtkAlgorithm::SINGLE_PRECISION, DOUBLE_PRECISION or
  /// DEFAULT_PRECISION, which takes double only where single could not separate places to a
  /// ten-thousandth of a voxel: far from the origin, on very fine grids, and beyond the range of
  /// single precision. Default DEFAULT_PRECISION.
  vtkSetMacro(OutputPointsPrecision, int);
  vtkGetMacro(OutputPointsPrecision, int);
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
   * - `SelfIntersections`: pairs of the surface's triangles that pass through each other.
   */
  vtkSetMacro(FidelitySamples, int);
  vtkGetMacro(FidelitySamples, int);
  ///@}

  /// Returns what the last execution measured by FidelitySamples, in two lines for people, and ""
  /// if it measured nothing.
  const char* GetFidelityInWords() const;

  /// The output of port 0.
  vtkPolyData* GetOutput();

protected:
  vtkWindingNumberSurface() = default;
  ~vtkWindingNumberSurface() override = default;

  vtkWindingNumberSurface(const vtkWindingNumberSurface&) = delete;
  void operator=(const vtkWindingNumberSurface&) = delete;

  int FillOutputPortInformation(int port, vtkInformation* info) override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void CheckProperties() override;
  void HashProperties(winding::ContentHash& hash) override;
  bool WorksOnFirstRank() const override { return true; }
  bool MayCloseBorder() const override { return !this->CloseBorder; }
  std::size_t GetAdditionalBytes(const winding::Field& field, vtkIdType samples) override;
  double GetResultBytes(vtkIdType samples) const override;

  int Features = SMOOTH;
  vtkTypeBool GenerateTriangles = 0;
  vtkTypeBool CloseBorder = 0;
  vtkTypeBool GenerateNormals = 1;
  int OutputPointsPrecision = DEFAULT_PRECISION;
  vtkTypeBool GenerateDistanceToInput = 0;
  int FidelitySamples = 0;

private:
  bool NeedsDoublePoints() const;
  void MakeSurface(const winding::Field& field, vtkPolyData* output);
  void FindEdges(
    winding::LevelEdges& edges, const winding::Field& field, winding::SmpExecutor& executor);
  void FindRoots(winding::LevelRoots& roots, winding::SmpExecutor& executor) const;
  void MakeSmooth(const winding::Field& field, const winding::LevelEdges& edges,
    winding::SmpExecutor& executor, vtkPolyData* output);
  void MakeSharp(const winding::Field& field, const winding::LevelEdges& edges,
    winding::SmpExecutor& executor, vtkPolyData* output);
  void CompareWithSource(const winding::Field& field, vtkPolyData* output);
  void VerifyWholeGrid(const winding::Field& field);

  std::string FidelityInWords;
};

#endif
