/**
 * @class   vtkWindingNumberAlgorithm
 * @brief   what winding-number filters have in common: source, method, result arrays
 *
 * The generalized winding number w says how often an oriented surface wraps around a point: 1
 * inside, 0 outside, 2 where two solids overlap, and a smooth value in between near holes. It tells
 * inside from outside for input that ray tests fail on: open scans, triangle soups,
 * self-intersections, non-manifold pieces, oriented point clouds (Jacobson, Kavan, Sorkine-Hornung,
 * Robust inside-outside segmentation using generalized winding numbers, 2013).
 *
 * A **source** is a surface or an oriented point cloud:
 * - vtkPolyData with triangles, quads, polygons or strips. Polygons are fans from their first
 *   vertex, which is exact for planar ones, convex or not. Orientation matters: counter-clockwise
 *   seen from outside gives w = +1 inside.
 * - any other vtkPointSet with cells of two or three dimensions, through its outer surface.
 * - a vtkPointSet without such cells, as a cloud of its points, which then need normals.
 * - composite data of the above: the leaves are one source. Surfaces and clouds do not mix.
 *
 * Primitives with NaN or infinite values or ids of points that do not exist are left out; a warning
 * says how many. A source without primitives gives w = 0 everywhere, with a warning.
 *
 * What is built from a source (welded vertices, areas) is kept until a source with other points,
 * cells, normals or areas comes in: threshold, grid, time steps or other attributes never rebuild
 * it (for polydata; any change of another data set counts as a change of its cells). Only where
 * triangles are large beside the voxels, those of a cap most often, another grid has them cut anew.
 *
 * Threads are those of vtkSMPTools. Where its backend is Sequential only because VTK was built so
 * (as in ParaView), STDThread is used instead; VTK_SMP_BACKEND_IN_USE=Sequential or NumberOfThreads
 * 1 keep it serial. Results have the same bits for any backend and number of threads.
 */
#ifndef vtkWindingNumberAlgorithm_h
#define vtkWindingNumberAlgorithm_h

#include "vtkAlgorithm.h"
#include "vtkFiltersWindingModule.h" // for export macro

#include <functional> // for work handed to the threads
#include <memory>     // for the private source field

namespace winding
{
enum class InsideRule;
class Executor;
class Field;
class ResultArrays;
class SmpExecutor;
class SourceField;
struct FieldInfo;
struct FieldOutput;
struct ResultOptions;
struct SourceOptions;
} // namespace winding
class vtkDataObject;
class vtkDataSet;
class vtkDataSetAttributes;

class VTKFILTERSWINDING_EXPORT vtkWindingNumberAlgorithm : public vtkAlgorithm
{
public:
  vtkTypeMacro(vtkWindingNumberAlgorithm, vtkAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How w is computed. The numbers are kept for state files.
  enum MethodType
  {
    AUTOMATIC = 0,    ///< the fastest that keeps the tolerance
    ROWS = 1,         ///< grids of surfaces, whole rows at once: exact but for a cap over holes;
                      ///< closed surfaces at scattered samples, too
    HIERARCHICAL = 2, ///< near primitives summed, far ones through expansions, within Tolerance
    DIRECT = 3,       ///< sum over all primitives, exact up to rounding
    PARITY = 4        ///< ray casting, the classic baseline: 0 or 1, for closed surfaces only
  };

  /// When a sample counts as inside; t is WindingThreshold.
  enum InsideRuleType
  {
    SIGNED = 0,   ///< w >= t
    ABSOLUTE = 1, ///< |w| >= t, for sources of unknown orientation
    ODD = 2       ///< the integer nearest to w is odd
  };

  /// Where the areas of the points of a cloud come from.
  enum PointAreaMethodType
  {
    VORONOI = 0,  ///< each point's cell among its neighbours, in its tangent plane
    MESH = 1,     ///< a third of every triangle around the point; for meshes taken as points
    CONSTANT = 2, ///< PointArea for every point
    ARRAY = 3     ///< the point data array AreaArray
  };

  /// What a source is.
  enum SourceKindType
  {
    NO_SOURCE = 0,   ///< without points, or not there yet
    MESH_SOURCE = 1, ///< with cells of two or three dimensions
    CLOUD_SOURCE = 2 ///< points without such cells
  };

  /// How the last execution ended.
  enum StatusType
  {
    DONE = 0,
    REFUSED = 1,       ///< input or properties cannot be worked with; an error was reported
    OUT_OF_MEMORY = 2, ///< the result does not fit into memory; an error was reported
    ABORTED = 3        ///< AbortExecute; the output is empty
  };

  /// Input of port 0 without a pipeline.
  void SetInputData(vtkDataObject* input) { this->SetInputDataObject(0, input); }

  ///@{
  /// Default AUTOMATIC.
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /// Largest absolute error of w, at any sample, that an approximation may make: by the method
  /// HIERARCHICAL, and by ROWS for what it gets from a cap over holes. The presets behind it are 1e-2,
  /// 1e-3, 1e-4, 1e-5 and 1e-6; what lies between takes the finer one. Below 1e-6, and so with 0,
  /// nothing is approximated. 0 or more, default 0.001.
  vtkSetClampMacro(Tolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /// Take a mesh as the cloud of its points. Points without normals get the area-weighted mean of
  /// their triangles' normals. Default off.
  vtkSetMacro(SourceAsPoints, vtkTypeBool);
  vtkGetMacro(SourceAsPoints, vtkTypeBool);
  vtkBooleanMacro(SourceAsPoints, vtkTypeBool);
  ///@}

  ///@{
  /// Clouds: the point data array of normals, which need not have unit length. Default: none named,
  /// so the active normals.
  vtkSetStringMacro(NormalsArray);
  vtkGetStringMacro(NormalsArray);
  ///@}

  ///@{
  /// Clouds without normals: estimate them from the neighbours of each point, orient them consistently,
  /// and outward by the field that they give (NormalEstimation.h). A warning says where that gives no
  /// clear inside and outside. Default off: points without normals are refused.
  vtkSetMacro(EstimateNormals, vtkTypeBool);
  vtkGetMacro(EstimateNormals, vtkTypeBool);
  vtkBooleanMacro(EstimateNormals, vtkTypeBool);
  ///@}

  ///@{
  /// Clouds: where areas come from. Default VORONOI.
  vtkSetMacro(PointAreaMethod, int);
  vtkGetMacro(PointAreaMethod, int);
  ///@}

  ///@{
  /// Clouds: how many neighbours of a point tell its area, and its normal where that is estimated. 3 to
  /// 1000, default 20.
  vtkSetClampMacro(NumberOfNeighbors, int, 3, 1000);
  vtkGetMacro(NumberOfNeighbors, int);
  ///@}

  ///@{
  /// Clouds, method CONSTANT: the area of every point. 0 takes the mean of what VORONOI gives. 0 or
  /// more, default 0.
  vtkSetMacro(PointArea, double);
  vtkGetMacro(PointArea, double);
  ///@}

  ///@{
  /// Clouds, method ARRAY: the point data array of areas. Default "Area".
  vtkSetStringMacro(AreaArray);
  vtkGetStringMacro(AreaArray);
  ///@}

  ///@{
  /// Clouds: over which length each point is spread, in units of its spacing, the square root of its
  /// area. 0 is the winding number of points as it is defined, which grows without bounds beside them;
  /// 1 keeps it about between 0 and 1 there, 0.5 within some tenths of that, and both change nothing a
  /// few spacings away. At a point itself the point adds 0 either way. Method HIERARCHICAL takes about
  /// 1.4, 4, 11 and 20 times as long with 1, 2, 3 and 4. 0 to 4, default 0.
  vtkSetMacro(Regularization, double);
  vtkGetMacro(Regularization, double);
  ///@}

  ///@{
  /// Finite. Default 0.5.
  vtkSetMacro(WindingThreshold, double);
  vtkGetMacro(WindingThreshold, double);
  ///@}

  ///@{
  /// Default SIGNED.
  vtkSetClampMacro(InsideRule, int, SIGNED, ODD);
  vtkGetMacro(InsideRule, int);
  ///@}

  ///@{
  /// Add the array of w itself. Default on. Without it, "Inside" (and the sign of "SignedDistance") is made
  /// directly, and takes a byte for each sample; it is what it would be with an array of floats.
  vtkSetMacro(GenerateWindingNumber, vtkTypeBool);
  vtkGetMacro(GenerateWindingNumber, vtkTypeBool);
  vtkBooleanMacro(GenerateWindingNumber, vtkTypeBool);
  ///@}

  ///@{
  /// Add the array "Inside" (unsigned char, 1 inside and 0 outside), which follows from the value
  /// in the result array. Default off.
  vtkSetMacro(GenerateInside, vtkTypeBool);
  vtkGetMacro(GenerateInside, vtkTypeBool);
  vtkBooleanMacro(GenerateInside, vtkTypeBool);
  ///@}

  ///@{
  /// Add the array "SignedDistance": the distance from the nearest point of the source's triangles, or
  /// from the nearest point of its cloud, negative inside. Its sign is that of the sample by w, threshold and
  /// rule, as "Inside" has it (whatever coverage or turning inside out make of that), and so may change
  /// across holes, where nothing is near; its size is exact up to rounding. 0 on the source.
  /// Without anything to be far from, it is the largest number of its type. Default off.
  vtkSetMacro(GenerateSignedDistance, vtkTypeBool);
  vtkGetMacro(GenerateSignedDistance, vtkTypeBool);
  vtkBooleanMacro(GenerateSignedDistance, vtkTypeBool);
  ///@}

  ///@{
  /// Name of the array of w. Default "WindingNumber".
  vtkSetStringMacro(ResultArrayName);
  vtkGetStringMacro(ResultArrayName);
  ///@}

  ///@{
  /// VTK_FLOAT or VTK_DOUBLE, of w and of distances; methods without approximation compute in double, and
  /// so do distances. Default VTK_FLOAT.
  vtkSetMacro(OutputScalarType, int);
  vtkGetMacro(OutputScalarType, int);
  void SetOutputScalarTypeToFloat() { this->SetOutputScalarType(VTK_FLOAT); }
  void SetOutputScalarTypeToDouble() { this->SetOutputScalarType(VTK_DOUBLE); }
  ///@}

  ///@{
  /// Most threads to use, as far as the machine has them; 0 leaves it to vtkSMPTools. Default 0. Does
  /// not change the result.
  vtkSetClampMacro(NumberOfThreads, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /// What the source is, even if SourceAsPoints takes it for something else; composite data is a mesh
  /// if any leaf is. Known as soon as the pipeline's information is, for a source that has been
  /// updated by then, so that a user interface can offer what the source needs before anything is
  /// executed. NO_SOURCE until then.
  vtkGetMacro(SourceKind, int);
  ///@}

  ///@{
  /// About the last execution: how it ended, the method used and why it was chosen, the seconds
  /// spent on building from the source (what was kept takes none) and on evaluating.
  vtkGetMacro(Status, int);
  const char* GetMethodUsed() const;
  const char* GetMethodReason() const;
  vtkGetMacro(PrepareSeconds, double);
  vtkGetMacro(EvaluateSeconds, double);
  ///@}

  ///@{
  /// What the whole result, made in one piece, was expected to take before the last execution, by the
  /// cost model that AUTOMATIC chooses by: seconds from the source on, if all threads are free, and
  /// bytes beside the source but with the result arrays. Estimates.
  vtkGetMacro(ExpectedSeconds, double);
  vtkGetMacro(ExpectedMemory, vtkIdType);
  ///@}

  ///@{
  /// About the source of the last execution. Boundary edges are those used by one triangle; net
  /// boundary edges those whose uses do not cancel; without any, w is an integer everywhere.
  bool GetSourceIsSurface() const;
  vtkIdType GetNumberOfPrimitives() const;
  vtkIdType GetNumberOfDroppedPrimitives() const;
  vtkIdType GetNumberOfWeldedVertices() const;
  vtkIdType GetNumberOfBoundaryEdges() const;
  vtkIdType GetNumberOfNetBoundaryEdges() const;
  ///@}

  ///@{
  /// Clouds: the mean area of a point, and whether normals were estimated. Then a share of the points,
  /// 1 for a closed cloud that is sampled well, has a field of about 1 behind and 0 before it.
  double GetMeanPointArea() const;
  bool GetNormalsWereEstimated() const;
  double GetClearShare() const;
  ///@}

  ///@{
  /// Method rows: triangles of the cap that closes the source; 0 for closed sources.
  vtkIdType GetNumberOfCapTriangles() const;
  ///@}

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  vtkWindingNumberAlgorithm();
  ~vtkWindingNumberAlgorithm() override;

  vtkWindingNumberAlgorithm(const vtkWindingNumberAlgorithm&) = delete;
  void operator=(const vtkWindingNumberAlgorithm&) = delete;

  ///@{
  /// What a filter does for the pipeline's requests. They may throw what the core throws: it is
  /// reported as an error, sets Status and fails the request.
  virtual void GiveDataObject(vtkInformationVector** inputs, vtkInformationVector* outputs);
  virtual void GiveInformation(vtkInformationVector** inputs, vtkInformationVector* outputs) = 0;
  virtual void AskForUpdate(vtkInformationVector** inputs, vtkInformationVector* outputs) = 0;
  virtual void GiveData(vtkInformationVector** inputs, vtkInformationVector* outputs) = 0;
  ///@}

  /// Whether the filter evaluates a grid, whose rows can share work, or scattered samples.
  virtual bool EvaluatesGrid() const = 0;

  static void FillSourcePortInformation(vtkInformation* info);

  /// The field of a source, built or kept, and prepared for samples; warns about what is wrong with
  /// the source. Null, with Status set, if aborted.
  const winding::Field* PrepareField(vtkDataObject* source, vtkIdType samples,
    const std::function<bool(const winding::Field&, winding::Executor&)>& prepareSamples);

  /// Finds out what a source is, for SourceKind. Filters do it when they are asked for information.
  void LookAtSource(vtkDataObject* source);

  /// The bounds of a source's usable primitives; false if it has none.
  bool GetSourceBounds(vtkDataObject* source, double bounds[6]);

  /// InsideRule for the core.
  winding::InsideRule GetCoreInsideRule() const;

  /// What result arrays the properties want.
  virtual winding::ResultOptions GetResultOptions() const;

  ///@{
  /// Result arrays as the properties want them, where the core writes to in them, and their way
  /// into the output, together with what DescribeMethod() adds.
  winding::ResultArrays MakeResults(vtkIdType samples) const;
  winding::FieldOutput OutputTo(const winding::ResultArrays& results) const;
  void AddResults(const winding::ResultArrays& results, vtkDataSet* output,
    vtkDataSetAttributes* attributes) const;
  ///@}

  /// Field data that says how an output came about.
  void DescribeMethod(vtkDataObject* output) const;

  /// Whether signed distances are to be made: those of result arrays, unless a filter says otherwise.
  virtual bool WantsDistances() const;

  /// What farther samples get instead of their distance: infinity, unless a filter says otherwise.
  virtual double GetDistanceLimit() const;

  /// Bytes that the filter takes for the result at so many samples, for ExpectedMemory: of result
  /// arrays, unless a filter says otherwise.
  virtual double GetResultBytes(vtkIdType samples) const;

  /// Runs and times an evaluation on this filter's threads. False, with Status set, if aborted.
  bool Evaluate(const std::function<bool(winding::SmpExecutor&)>& evaluation);

  int Method = AUTOMATIC;
  double Tolerance = 1e-3;
  vtkTypeBool SourceAsPoints = 0;
  char* NormalsArray = nullptr;
  vtkTypeBool EstimateNormals = 0;
  int PointAreaMethod = VORONOI;
  int NumberOfNeighbors = 20;
  double PointArea = 0;
  char* AreaArray = nullptr;
  double Regularization = 0;
  double WindingThreshold = 0.5;
  int InsideRule = SIGNED;
  vtkTypeBool GenerateWindingNumber = 1;
  vtkTypeBool GenerateInside = 0;
  vtkTypeBool GenerateSignedDistance = 0;
  char* ResultArrayName = nullptr;
  int OutputScalarType = VTK_FLOAT;
  int NumberOfThreads = 0;
  int SourceKind = NO_SOURCE;
  int Status = DONE;
  double PrepareSeconds = 0;
  double EvaluateSeconds = 0;
  double ExpectedSeconds = 0;
  vtkIdType ExpectedMemory = 0;

private:
  winding::SourceOptions GetSourceOptions();
  const winding::FieldInfo& GetSourceInfo() const;

  std::unique_ptr<winding::SourceField> Source;
};

#endif
