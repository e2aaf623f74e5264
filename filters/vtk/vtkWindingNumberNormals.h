// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindingNumberNormals
 * @brief   normals and areas of a cloud's points
 *
 * The filter adds a point data array of areas to its input (double, one per point, in squared units
 * of the coordinates): the areas that vtkWindingNumberField and vtkWindingNumberProbe find for a
 * cloud on their own, to be looked at, changed, or used by other filters. With their point area
 * method ARRAY downstream of this filter they give the very same field as with the method of this
 * filter.
 *
 * EstimateNormals gives normals to points that have none: unit vectors that point outward, as the
 * active normals "Normals" (float, for vtkSignedDistance takes no others). They are those that
 * vtkWindingNumberField estimates, for VTK's own filters: vtkSignedDistance with vtkExtractSurface,
 * glyphs, and writers of oriented points.
 *
 * The input is any vtkPointSet. Points need normals, unless they are to be estimated; a mesh is
 * taken as the cloud of its points, which have the area-weighted mean of their triangles' normals
 * where they have none of their own. The leaves of composite data are one cloud, as they are one
 * source for the other filters: where scans overlap, their points share the area. In a pipeline
 * that asks for pieces, each piece is a cloud of its own, but not in a parallel program: there the
 * parts of all ranks are one cloud, and each rank gets the areas of its own points. An execution is
 * collective then, as for vtkWindingNumberAlgorithm.
 *
 * The output is of the input's type and shares its arrays. The array has as many tuples as there
 * are points. The area is 0, as is an estimated normal, for:
 * - points with NaN or infinite values or a normal of length 0; a warning counts them,
 * - ghost points, for which another piece of the data answers,
 * - the inner points of a mesh with volume cells. Points that its outer surface has several times,
 *   such as the points on the edges of a structured grid, have the areas of all of them. Areas of
 *   points that only the outer surface has, as where Bézier cells are divided, are left out, with a
 *   warning.
 *
 * Errors leave the output empty. They are: points without normals, method MESH for points without
 * triangles, an array that is not there, no usable point at all, and a value of PointAreaMethod or
 * PointArea that does not exist. Points that are all at one place have area 0, with a warning.
 *
 * The filter takes its threads as vtkWindingNumberAlgorithm does; areas have the same bits for any
 * number of them, and for any order of the points and triangles. When it is aborted, its output is
 * empty.
 *
 * @sa vtkWindingNumberField vtkWindingNumberProbe
 */
#ifndef vtkWindingNumberNormals_h
#define vtkWindingNumberNormals_h

#include "vtkFiltersWindingModule.h" // for export macro
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkSmartPointer.h" // for the controller
#include "vtkWindingABINamespace.h"
#include "vtkWindingNumberAlgorithm.h" // for the choices

namespace winding
{
class Executor;
class Ranks;
struct PointCloud;
} // namespace winding
VTK_ABI_NAMESPACE_BEGIN
class vtkMultiProcessController;

class VTKFILTERSWINDING_EXPORT vtkWindingNumberNormals : public vtkPassInputTypeAlgorithm
{
public:
  static vtkWindingNumberNormals* New();
  vtkTypeMacro(vtkWindingNumberNormals, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The names that messages give properties, of vtkWindingNumberAlgorithm::NamesInMessagesType.
  /// Default CXX_NAMES.
  vtkSetMacro(NamesInMessages, int);
  vtkGetMacro(NamesInMessages, int);
  ///@}

  /// The ways in which points get their areas; the numbers are vtkWindingNumberAlgorithm's.
  enum PointAreaMethodType
  {
    VORONOI = 0, ///< the area of each point's cell among its neighbours, in its tangent plane
    MESH = 1,    ///< a third of every triangle around the point; in total the area of the mesh
    CONSTANT = 2 ///< PointArea for every point
  };

  ///@{
  /// The way in which points get their areas. Default VORONOI.
  vtkSetMacro(PointAreaMethod, int);
  vtkGetMacro(PointAreaMethod, int);
  void SetPointAreaMethodToVoronoi() { this->SetPointAreaMethod(VORONOI); }
  void SetPointAreaMethodToMesh() { this->SetPointAreaMethod(MESH); }
  void SetPointAreaMethodToConstant() { this->SetPointAreaMethod(CONSTANT); }
  const char* GetPointAreaMethodAsString() const;
  ///@}

  ///@{
  /// The number of neighbours that define the area of a point, and its normal where that is
  /// estimated. 3 to 1000, default 20.
  vtkSetMacro(NumberOfNeighbors, int);
  vtkGetMacro(NumberOfNeighbors, int);
  ///@}

  ///@{
  /// The area of every point, for method CONSTANT. 0 stands for the mean of the areas that VORONOI
  /// gives. 0 or more, default 0.
  vtkSetMacro(PointArea, double);
  vtkGetMacro(PointArea, double);
  ///@}

  ///@{
  /// The name of the point data array with the normals, which need not have unit length. Default:
  /// no name, for the active normals; the name None means the same if no array has it.
  vtkSetStringMacro(NormalsArray);
  vtkGetStringMacro(NormalsArray);
  ///@}

  ///@{
  /// Whether points without normals get estimated ones, which are added to the output. Where some
  /// data sets of a composite one have normals and others have none, all get estimated ones. A
  /// warning says where their field does not separate inside from outside. Points of meshes without
  /// normals get their triangles' then. Default off: points without normals are refused.
  vtkSetMacro(EstimateNormals, vtkTypeBool);
  vtkGetMacro(EstimateNormals, vtkTypeBool);
  vtkBooleanMacro(EstimateNormals, vtkTypeBool);
  ///@}

  ///@{
  /// The way in which normals are estimated; meaning, values and default are as for
  /// vtkWindingNumberAlgorithm.
  vtkSetMacro(NormalEstimation, int);
  vtkGetMacro(NormalEstimation, int);
  void SetNormalEstimationToAutomatic()
  {
    this->SetNormalEstimation(vtkWindingNumberAlgorithm::ESTIMATION_AUTOMATIC);
  }
  void SetNormalEstimationToSpanningTree()
  {
    this->SetNormalEstimation(vtkWindingNumberAlgorithm::SPANNING_TREE);
  }
  void SetNormalEstimationToWindingConsistent()
  {
    this->SetNormalEstimation(vtkWindingNumberAlgorithm::WINDING_CONSISTENT);
  }
  const char* GetNormalEstimationAsString() const;
  ///@}

  ///@{
  /// Where the points were seen from, for the senses of estimated normals; meaning and default are
  /// as for vtkWindingNumberAlgorithm.
  vtkSetStringMacro(Toward);
  vtkGetStringMacro(Toward);
  ///@}

  ///@{
  /// The name of the array of areas. Default "Area".
  vtkSetStringMacro(ResultArrayName);
  vtkGetStringMacro(ResultArrayName);
  ///@}

  ///@{
  /// The largest number of threads to use; 0 leaves it to vtkSMPTools. The number does not change
  /// the result. Default 0.
  vtkSetMacro(NumberOfThreads, int);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /// The controller of the ranks that hold the input, and the way in which they hold it; meaning,
  /// values and defaults are vtkWindingNumberAlgorithm's.
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  vtkSetMacro(SourceDistribution, int);
  vtkGetMacro(SourceDistribution, int);
  void SetSourceDistributionToAutomatic()
  {
    this->SetSourceDistribution(vtkWindingNumberAlgorithm::DISTRIBUTION_AUTOMATIC);
  }
  void SetSourceDistributionToDistributed()
  {
    this->SetSourceDistribution(vtkWindingNumberAlgorithm::DISTRIBUTED);
  }
  void SetSourceDistributionToReplicated()
  {
    this->SetSourceDistribution(vtkWindingNumberAlgorithm::REPLICATED);
  }
  const char* GetSourceDistributionAsString() const;
  ///@}

  /// The way in which the last execution has ended, of vtkWindingNumberAlgorithm::StatusType.
  vtkGetMacro(Status, int);

  /// The sum of all areas of the last execution, on this rank; 0 if it failed.
  vtkGetMacro(TotalArea, double);

  ///@{
  /// How the last execution has estimated normals, "spanning tree" or "winding consistent", or
  /// nothing where it has not; and the share of the points with a field of about 1 behind and 0
  /// before them then, which is 1 for a closed cloud that is sampled well.
  const char* GetNormalEstimationUsed() const;
  double GetClearShare() const;
  ///@}

protected:
  vtkWindingNumberNormals();
  ~vtkWindingNumberNormals() override;

  vtkWindingNumberNormals(const vtkWindingNumberNormals&) = delete;
  void operator=(const vtkWindingNumberNormals&) = delete;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  int NamesInMessages = 0; // vtkWindingNumberAlgorithm::CXX_NAMES
  int PointAreaMethod = VORONOI;
  int NumberOfNeighbors = 20;
  double PointArea = 0;
  char* NormalsArray = nullptr;
  vtkTypeBool EstimateNormals = 0;
  int NormalEstimation = 0;
  char* Toward = nullptr;
  char* ResultArrayName = nullptr;
  int NumberOfThreads = 0;
  int Status = 4; // vtkWindingNumberAlgorithm::NOT_RUN
  double TotalArea = 0;
  const char* NormalEstimationUsed = "";
  double ClearShare = 0;
  vtkSmartPointer<vtkMultiProcessController> Controller;
  int SourceDistribution = 0;

private:
  void AddAreas(vtkDataObject* data, winding::Ranks& ranks);
  void FindNormalsAndAreas(winding::PointCloud& cloud, bool estimates, winding::Executor& executor);
};
VTK_ABI_NAMESPACE_END

#endif
