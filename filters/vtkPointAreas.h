/**
 * @class   vtkPointAreas
 * @brief   the area that each point of an oriented cloud stands for
 *
 * Gives its input with a point data array of areas (double, one per point, in squared units of the
 * coordinates): what vtkWindingNumberField and vtkWindingNumberProbe find for a cloud on their own,
 * to be looked at, changed, or used by other filters. With their point area method ARRAY downstream
 * of this filter they give the very same field as with the method of this filter.
 *
 * The input is any vtkPointSet. Points need normals; a mesh is taken as the cloud of its points,
 * which have the area-weighted mean of their triangles' normals where they have none of their own.
 * The leaves of composite data are one cloud, as they are one source for the other filters: where
 * scans overlap, their points share the area. In a pipeline that asks for pieces, each piece is a
 * cloud of its own.
 *
 * The output is of the input's type and shares its arrays. The array has as many tuples as there
 * are points. Area 0 have:
 * - points with NaN or infinite values or a normal of length 0; a warning counts them,
 * - ghost points, for which another piece of the data answers,
 * - the inner points of a mesh with volume cells. Points that its outer surface has several times,
 *   such as those on the edges of a structured grid, have the areas of all of them. Areas of points
 *   that only the outer surface has, as VTK makes them for Lagrange and Bézier cells, are left out,
 *   with a warning.
 *
 * Errors leave the output empty. They are: points without normals, method MESH for points without
 * triangles, an array that is not there, no usable point at all, a PointAreaMethod or PointArea
 * that there cannot be. Points that are all at one place have area 0, with a warning.
 *
 * Threads are those of vtkWindingNumberAlgorithm; areas have the same bits for any number of them.
 * Aborted, the output is empty.
 *
 * @sa vtkWindingNumberField vtkWindingNumberProbe
 */
#ifndef vtkPointAreas_h
#define vtkPointAreas_h

#include "vtkFiltersWindingModule.h" // for export macro
#include "vtkPassInputTypeAlgorithm.h"

namespace winding
{
class Executor;
struct PointCloud;
} // namespace winding

class VTKFILTERSWINDING_EXPORT vtkPointAreas : public vtkPassInputTypeAlgorithm
{
public:
  static vtkPointAreas* New();
  vtkTypeMacro(vtkPointAreas, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Where areas come from; the numbers are those of vtkWindingNumberAlgorithm.
  enum PointAreaMethodType
  {
    VORONOI = 0, ///< each point's cell among its neighbours, in its tangent plane
    MESH = 1,    ///< a third of every triangle around the point; in total the area of the mesh
    CONSTANT = 2 ///< PointArea for every point
  };

  ///@{
  /// Default VORONOI.
  vtkSetMacro(PointAreaMethod, int);
  vtkGetMacro(PointAreaMethod, int);
  ///@}

  ///@{
  /// How many neighbours of a point tell its area, and its normal where that is estimated. 3 to
  /// 1000, default 20.
  vtkSetClampMacro(NumberOfNeighbors, int, 3, 1000);
  vtkGetMacro(NumberOfNeighbors, int);
  ///@}

  ///@{
  /// Method CONSTANT: the area of every point. 0 takes the mean of what VORONOI gives. 0 or more,
  /// default 0.
  vtkSetMacro(PointArea, double);
  vtkGetMacro(PointArea, double);
  ///@}

  ///@{
  /// The point data array of normals, which need not have unit length. Default: none named, so the
  /// active normals.
  vtkSetStringMacro(NormalsArray);
  vtkGetStringMacro(NormalsArray);
  ///@}

  ///@{
  /// Points without normals: estimate them from the neighbours of each point. They are used for the
  /// areas only, and not added to the output. Default off: such points are refused.
  vtkSetMacro(EstimateNormals, vtkTypeBool);
  vtkGetMacro(EstimateNormals, vtkTypeBool);
  vtkBooleanMacro(EstimateNormals, vtkTypeBool);
  ///@}

  ///@{
  /// Name of the array of areas. Default "Area".
  vtkSetStringMacro(ResultArrayName);
  vtkGetStringMacro(ResultArrayName);
  ///@}

  ///@{
  /// Most threads to use; 0 leaves it to vtkSMPTools. Default 0. Does not change the result.
  vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  /// The sum of all areas of the last execution; 0 if it failed.
  vtkGetMacro(TotalArea, double);

protected:
  vtkPointAreas();
  ~vtkPointAreas() override;

  vtkPointAreas(const vtkPointAreas&) = delete;
  void operator=(const vtkPointAreas&) = delete;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  int PointAreaMethod = VORONOI;
  int NumberOfNeighbors = 20;
  double PointArea = 0;
  char* NormalsArray = nullptr;
  vtkTypeBool EstimateNormals = 0;
  char* ResultArrayName = nullptr;
  int NumberOfThreads = 0;
  double TotalArea = 0;

private:
  void AddAreas(vtkDataObject* data);
  void ChooseAreas(winding::PointCloud& cloud, winding::Executor& executor) const;
};

#endif
