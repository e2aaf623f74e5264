// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindingNumberAlgorithm
 * @brief   base class of winding-number filters: source and method
 *
 * The generalized winding number w says how often an oriented surface wraps around a point: 1
 * inside, 0 outside, 2 where two solids overlap, and a smooth value in between near holes. It
 * separates inside from outside for input that ray tests fail on: open scans, triangle soups,
 * self-intersections, non-manifold pieces, oriented point clouds (Jacobson, Kavan, Sorkine-Hornung,
 * Robust inside-outside segmentation using generalized winding numbers, 2013).
 *
 * A **source** is a surface or an oriented point cloud:
 * - vtkPolyData with triangles, quads, polygons or strips. Polygons are fans from their first
 *   vertex, which is exact for planar ones, convex or not. Orientation matters: counter-clockwise
 *   seen from outside gives w = +1 inside.
 * - any other vtkPointSet with cells of two or three dimensions, through its outer surface. Faces
 *   of cells with volume look away from their own cells, whatever the order of nodes, and curved
 *   ones are divided until they are within a thousandth of the mesh's diagonal (OuterSurface.h).
 * - a vtkPointSet without cells of these dimensions, as a cloud of its points, which then need
 * normals.
 * - composite data of the above: the leaves are one source. Surfaces and clouds do not mix.
 *
 * Primitives with NaN or infinite values or ids of points that do not exist are left out; a warning
 * says how many. A source without primitives gives w = 0 everywhere, with a warning.
 *
 * The filter keeps what it built from a source (welded vertices, areas) until a source with other
 * points, cells, normals or areas comes in: threshold, grid, time steps or other attributes never
 * rebuild it. This holds for polydata; any change of another data set counts as a change of its
 * cells. Only triangles that are large compared with the voxels, most often in a cap, are cut anew
 * for another grid.
 *
 * Work is shared among the threads of vtkSMPTools. Where its backend is Sequential only because VTK
 * was built so (as in ParaView), STDThread is used instead; VTK_SMP_BACKEND_IN_USE=Sequential or
 * NumberOfThreads 1 keep it serial. Results have the same bits for any backend and number of
 * threads, and for any order of the source's triangles, points and blocks.
 *
 * **In a parallel program** (MPI) the ranks of the controller hold the source in parts, as
 * SourceDistribution says: each asks upstream for its own piece, and gets the pieces of all others.
 * The result has the same bits as on one rank with the whole source, however its primitives are
 * dealt out; only scattered samples that a far field answers depend on the other samples of their
 * rank, within the tolerance. An execution is collective: all ranks must execute, with the same
 * properties. Where one refuses, all do, with the same line. Memory and threads are shared among
 * the ranks on a machine. docs/scale.md says more.
 *
 * **Data that contradicts itself is refused**, in one line through vtkErrorMacro, before any class
 * of VTK follows it out of its memory: offsets out of their list of ids, ids of points that do not
 * exist, cells of unknown types or with too few points for their type, polyhedra without their
 * faces, and arrays in use that are too short. Only polygons with ids of points that do not exist
 * are no reason to refuse polydata as a source: they are left out and counted
 * (GetNumberOfDroppedPrimitives()). That holds for every class of this module that takes data.
 *
 * **Properties out of range are refused**, by every class of this module and whether they have an
 * effect or not. Setters take any value; the next execution reports one line through vtkErrorMacro
 * with the name of the property, its value and its range, and gives no output. Numbers that are NaN
 * or infinite are in no range.
 */
#ifndef vtkWindingNumberAlgorithm_h
#define vtkWindingNumberAlgorithm_h

#include "vtkAlgorithm.h"
#include "vtkFiltersWindingModule.h" // for export macro
#include "vtkSmartPointer.h"         // for the controller
#include "vtkWindingABINamespace.h"

#include <functional>
#include <memory> // for the field of the source, which is kept
#include <string> // for names of inputs
#include <vector> // for the fields of sources

namespace winding
{
class ContentHash;
class Executor;
class Field;
class Ranks;
class SmpExecutor;
class SourceField;
struct FieldInfo;
struct ImageFrame;
struct InsideTest;
struct Run;
struct SourceOptions;
} // namespace winding
VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkMultiBlockDataSet;
class vtkMultiProcessController;

class VTKFILTERSWINDING_EXPORT vtkWindingNumberAlgorithm : public vtkAlgorithm
{
public:
  vtkTypeMacro(vtkWindingNumberAlgorithm, vtkAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The methods by which w is computed. Their numbers never change, for state files have them.
  enum MethodType
  {
    AUTOMATIC = 0,    ///< the fastest method that keeps the tolerance
    ROWS = 1,         ///< surfaces: whole rows of a grid at once, or a ray from each scattered
                      ///< sample; exact except for a cap over holes
    HIERARCHICAL = 2, ///< near primitives are summed, far ones act through expansions
    DIRECT = 3,       ///< the sum over all primitives, exact up to rounding
    PARITY = 4        ///< ray casting, the classic baseline: 0 or 1, for closed surfaces only
  };

  /// The rules by which a sample counts as inside; t is WindingThreshold.
  enum InsideRuleType
  {
    SIGNED = 0,   ///< w >= t
    ABSOLUTE = 1, ///< |w| >= t, for sources of unknown orientation
    ODD = 2       ///< the integer nearest to w is odd
  };

  /// The ways in which the points of a cloud get their areas.
  enum PointAreaMethodType
  {
    VORONOI = 0,  ///< the area of each point's cell among its neighbours, in its tangent plane
    MESH = 1,     ///< a third of every triangle around the point; for meshes taken as points
    CONSTANT = 2, ///< PointArea for every point
    ARRAY = 3     ///< the values of the point data array AreaArray
  };

  /// The ways in which the normals of points that have none are estimated.
  enum NormalEstimationType
  {
    ESTIMATION_AUTOMATIC = 0, ///< the spanning tree where it is right, else what the field agrees
                              ///< with, walls within other solids included
    SPANNING_TREE = 1,        ///< orientations are handed on from neighbour to neighbour
    WINDING_CONSISTENT = 2    ///< orientations that the winding number agrees with
  };

  /// The ways in which the ranks of a parallel program may hold the source.
  enum SourceDistributionType
  {
    DISTRIBUTION_AUTOMATIC = 0, ///< in parts, unless all ranks have the same data
    DISTRIBUTED = 1,            ///< in parts, whatever they have
    REPLICATED = 2              ///< as a whole, each of them
  };

  /// The names that messages give properties.
  enum NamesInMessagesType
  {
    CXX_NAMES = 0,      ///< setters, such as EstimateNormalsOn()
    PARAVIEW_NAMES = 1, ///< labels of ParaView's panels
    PROGRAM_NAMES = 2,  ///< options of the program winding
    PYTHON_NAMES = 3    ///< keywords of the Python package's own functions
  };

  ///@{
  /// The names that errors, warnings and advice give properties. Front ends set theirs. Default
  /// CXX_NAMES.
  vtkSetMacro(NamesInMessages, int);
  vtkGetMacro(NamesInMessages, int);
  ///@}

  /// Returns how many ranks, this one among them, share the cores and the memory of this machine.
  /// It is 1 until a filter has met others.
  static int GetRanksOnHost();

  /// Returns one line about an input that seems to be in another unit than another one, as inches
  /// are next to millimetres; empty where all fit. The blocks are the inputs, called by their names
  /// or numbers. Bounds are compared: one has the sides of the other times 10 or 25.4, say.
  static std::string GetUnitAdvice(vtkMultiBlockDataSet* inputs);

  /// The kinds of sources.
  enum SourceKindType
  {
    NO_SOURCE = 0,   ///< a source without points, or one that is not there yet
    MESH_SOURCE = 1, ///< a source with cells of two or three dimensions
    CLOUD_SOURCE = 2 ///< a source of points without those cells
  };

  /// The ways in which an execution ends. GetErrorCode() is UserError (vtkErrorCode.h) where it is
  /// REFUSED, and the system's ENOMEM where it is OUT_OF_MEMORY.
  enum StatusType
  {
    DONE = 0,          ///< the result is there
    REFUSED = 1,       ///< input or properties cannot be worked with; an error was reported
    OUT_OF_MEMORY = 2, ///< the result does not fit into memory; an error was reported
    ABORTED = 3,       ///< AbortExecute was set; the output is empty
    NOT_RUN = 4        ///< no execution has followed what the pipeline asked last: nothing was
                       ///< asked, information alone, or a reader upstream has failed
  };

  /// Sets the input of port 0 without a pipeline.
  void SetInputData(vtkDataObject* input) { this->SetInputDataObject(0, input); }

  ///@{
  /// The method by which w is computed. Default AUTOMATIC.
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  void SetMethodToAutomatic() { this->SetMethod(AUTOMATIC); }
  void SetMethodToRows() { this->SetMethod(ROWS); }
  void SetMethodToHierarchical() { this->SetMethod(HIERARCHICAL); }
  void SetMethodToDirect() { this->SetMethod(DIRECT); }
  void SetMethodToParity() { this->SetMethod(PARITY); }
  const char* GetMethodAsString() const;
  ///@}

  ///@{
  /// The largest absolute error of w, at any sample, that an approximation may make: the method
  /// HIERARCHICAL, and ROWS for the values of a cap over holes. There are presets for 1e-2, 1e-3,
  /// 1e-4, 1e-5 and 1e-6; a tolerance between two of them takes the finer one. Below 1e-6, 0
  /// included, nothing is approximated. Single precision adds some 1e-7 of the sum of all shares'
  /// sizes, which is large near the points of a cloud. 0 or more, default 0.001.
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /// Whether a mesh is taken as the cloud of its points. Points without normals get the
  /// area-weighted mean of their triangles' normals. Default off.
  vtkSetMacro(SourceAsPoints, vtkTypeBool);
  vtkGetMacro(SourceAsPoints, vtkTypeBool);
  vtkBooleanMacro(SourceAsPoints, vtkTypeBool);
  ///@}

  ///@{
  /// Whether cells of two dimensions are taken, where a mesh has cells of three, too. A warning
  /// counts the cells of the other kind, which are left out. Default off: the outer surface of
  /// the cells of three dimensions.
  vtkSetMacro(UseSurfaceCells, vtkTypeBool);
  vtkGetMacro(UseSurfaceCells, vtkTypeBool);
  vtkBooleanMacro(UseSurfaceCells, vtkTypeBool);
  ///@}

  ///@{
  /// Whether faces are turned first: neighbours agree then, solids look outward, and the walls
  /// of cavities inward. Faces that are there more than once are taken once. Parts that have one
  /// side only stay as they are. Clouds have no faces. Default off.
  vtkSetMacro(OrientFaces, vtkTypeBool);
  vtkGetMacro(OrientFaces, vtkTypeBool);
  vtkBooleanMacro(OrientFaces, vtkTypeBool);
  ///@}

  ///@{
  /// Whether open parts inside of closed ones, as the baffles of a tank, are left out, after
  /// faces are turned. They bound nothing, but add to w all around them. Default off.
  vtkSetMacro(IgnoreOpenParts, vtkTypeBool);
  vtkGetMacro(IgnoreOpenParts, vtkTypeBool);
  vtkBooleanMacro(IgnoreOpenParts, vtkTypeBool);
  ///@}

  ///@{
  /**
   * The planes of symmetry of a source that is one side of them, as half a hull: "y=0", or several
   * as "x=0 y=0". "1 1 0 = 3" is x + y = 3. The source gets its mirror images, at most at three
   * planes, and so do bounds. Vertices within a millionth of the longest side are in the plane.
   * Default: none.
   */
  vtkSetStringMacro(Mirror);
  vtkGetStringMacro(Mirror);
  ///@}

  ///@{
  /**
   * The flat base of a surface that is open on one side, as scans and terrain are from below.
   * "down", "up", "+x" to "-z" and "direction x y z" put it where the surface ends that way,
   * "down 0.5" that far below; a plane as "z=-5" puts it there. Walls go from the rim to the base.
   * Openings that face the base are closed by it, and others stay (FlatBase.h). A warning says
   * where there is none. Default: no base.
   */
  vtkSetStringMacro(FlatBase);
  vtkGetStringMacro(FlatBase);
  ///@}

  ///@{
  /**
   * The side of open sheets that is inside, as "down" for what lies below a terrain, or "+x" to
   * "-z" and "direction x y z". Faces are turned accordingly. A half is added to w, as a half
   * sphere at infinity does: it is 1 far inside and 0 far outside, and passes 0.5 at the sheet.
   * Beyond the rim of the sheet it passes 0.5 on a surface that goes on smoothly, which is a guess.
   * Closed parts stay as they are. Points are one sheet, unless their normals look to all sides
   * alike. Default: none.
   */
  vtkSetStringMacro(SheetSide);
  vtkGetStringMacro(SheetSide);
  ///@}

  ///@{
  /// The distance, in the unit of the input, up to which points of a surface are made one
  /// (SnappedPoints.h): it closes slits. 0 or more, default 0: equal points only.
  vtkSetMacro(WeldTolerance, double);
  vtkGetMacro(WeldTolerance, double);
  ///@}

  ///@{
  /// The name of the point data array with the normals of a cloud, which need not have unit length.
  /// Default: no name, for the active normals; the name None means the same if no array has it.
  vtkSetStringMacro(NormalsArray);
  vtkGetStringMacro(NormalsArray);
  ///@}

  ///@{
  /// Whether a cloud without normals gets estimated ones: found from the neighbours of each point,
  /// oriented consistently, and turned outward by the field that they give (NormalEstimation.h). A
  /// warning says where that field does not separate inside from outside. Default off: points
  /// without normals are refused.
  vtkSetMacro(EstimateNormals, vtkTypeBool);
  vtkGetMacro(EstimateNormals, vtkTypeBool);
  vtkBooleanMacro(EstimateNormals, vtkTypeBool);
  ///@}

  ///@{
  /// The way in which normals are estimated, where EstimateNormals has it done. SPANNING_TREE takes
  /// the least time, and fails where parts are thin, close to each other or separate.
  /// WINDING_CONSISTENT turns patches of points such that w is 1/2 at them (ConsistentNormals.h);
  /// it takes five to six times as long. Default ESTIMATION_AUTOMATIC.
  vtkSetMacro(NormalEstimation, int);
  vtkGetMacro(NormalEstimation, int);
  void SetNormalEstimationToAutomatic() { this->SetNormalEstimation(ESTIMATION_AUTOMATIC); }
  void SetNormalEstimationToSpanningTree() { this->SetNormalEstimation(SPANNING_TREE); }
  void SetNormalEstimationToWindingConsistent() { this->SetNormalEstimation(WINDING_CONSISTENT); }
  const char* GetNormalEstimationAsString() const;
  ///@}

  ///@{
  /**
   * Where the points were seen from: estimated normals look there, and NormalEstimation has no
   * effect. "x y z" is a position, as a scanner's. "x y z; x y z; ..." are several; each point
   * takes the nearest. "direction x y z" is a direction, and so are "up", "down" and "+x" to
   * "-z"; up is right for points from the air, which see no undersides. Default: none; then points
   * with an array "Viewpoints" look to its places, and the field decides for others.
   */
  vtkSetStringMacro(Toward);
  vtkGetStringMacro(Toward);
  ///@}

  ///@{
  /// The way in which the points of a cloud get their areas. Default VORONOI.
  vtkSetMacro(PointAreaMethod, int);
  vtkGetMacro(PointAreaMethod, int);
  void SetPointAreaMethodToVoronoi() { this->SetPointAreaMethod(VORONOI); }
  void SetPointAreaMethodToMesh() { this->SetPointAreaMethod(MESH); }
  void SetPointAreaMethodToConstant() { this->SetPointAreaMethod(CONSTANT); }
  void SetPointAreaMethodToArray() { this->SetPointAreaMethod(ARRAY); }
  const char* GetPointAreaMethodAsString() const;
  ///@}

  ///@{
  /// The number of neighbours that define the area of a cloud's point, and its normal where that is
  /// estimated. 3 to 1000, default 20.
  vtkSetMacro(NumberOfNeighbors, int);
  vtkGetMacro(NumberOfNeighbors, int);
  ///@}

  ///@{
  /// The area of every point of a cloud, for PointAreaMethod CONSTANT. 0 stands for the mean of the
  /// areas that VORONOI gives. 0 or more, default 0.
  vtkSetMacro(PointArea, double);
  vtkGetMacro(PointArea, double);
  ///@}

  ///@{
  /// The name of the point data array with the areas of a cloud's points, for PointAreaMethod
  /// ARRAY. Default "Area".
  vtkSetStringMacro(AreaArray);
  vtkGetStringMacro(AreaArray);
  ///@}

  ///@{
  /// The length over which each point of a cloud is spread, in units of its spacing, which is the
  /// square root of its area. 0 is the winding number of points as it is defined, which grows
  /// without bounds near them. 1 keeps w about between 0 and 1 there, 0.5 within some tenths of
  /// that, and both change nothing a few spacings away. A point adds 0 at its own position either
  /// way. Method HIERARCHICAL takes about 1.4, 4, 11 and 20 times as long with 1, 2, 3 and 4. 0 to
  /// 4, default 0.
  vtkSetMacro(Regularization, double);
  vtkGetMacro(Regularization, double);
  ///@}

  ///@{
  /// The value t that the inside rules compare w with; a finite number. Default 0.5.
  vtkSetMacro(WindingThreshold, double);
  vtkGetMacro(WindingThreshold, double);
  ///@}

  ///@{
  /// The rule by which a sample counts as inside. Default SIGNED.
  vtkSetMacro(InsideRule, int);
  vtkGetMacro(InsideRule, int);
  void SetInsideRuleToSigned() { this->SetInsideRule(SIGNED); }
  void SetInsideRuleToAbsolute() { this->SetInsideRule(ABSOLUTE); }
  void SetInsideRuleToOdd() { this->SetInsideRule(ODD); }
  const char* GetInsideRuleAsString() const;
  ///@}

  ///@{
  /// The largest number of threads to use, as far as the machine has them; 0 leaves it to
  /// vtkSMPTools. The number does not change the result. Default 0.
  vtkSetMacro(NumberOfThreads, int);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /// The controller of the ranks that hold the source; null for this process alone. Default: the
  /// global one (vtkMultiProcessController::GetGlobalController()).
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  ///@}

  ///@{
  /// The way in which the ranks of a parallel program hold the source. A parallel source must not
  /// be REPLICATED: each rank would take its part for the whole. Default DISTRIBUTION_AUTOMATIC.
  vtkSetMacro(SourceDistribution, int);
  vtkGetMacro(SourceDistribution, int);
  void SetSourceDistributionToAutomatic() { this->SetSourceDistribution(DISTRIBUTION_AUTOMATIC); }
  void SetSourceDistributionToDistributed() { this->SetSourceDistribution(DISTRIBUTED); }
  void SetSourceDistributionToReplicated() { this->SetSourceDistribution(REPLICATED); }
  const char* GetSourceDistributionAsString() const;
  ///@}

  ///@{
  /// The longest time that an execution may be expected to take, in seconds, by ExpectedSeconds.
  /// Longer ones are refused after a second of evaluating, with what would be faster. An execution
  /// that is expected to take more than a minute says so in a warning. 0 stands for no limit. 0 or
  /// more, default 0.
  vtkSetMacro(LongestExpectedTime, double);
  vtkGetMacro(LongestExpectedTime, double);
  ///@}

  ///@{
  /// The kind of the source, even if SourceAsPoints takes it for another; composite data is a mesh
  /// if any leaf is. It is known as soon as the pipeline's information is, for a source that has
  /// been updated by then, so that a user interface can offer what the source needs before anything
  /// is executed; until then it is NO_SOURCE.
  vtkGetMacro(SourceKind, int);
  ///@}

  ///@{
  /// Facts about the last execution: how it ended, the method used and why it was chosen, the
  /// seconds spent on building from the source (none for what was kept) and on evaluating. The
  /// method and its reason are empty before the first execution.
  vtkGetMacro(Status, int);
  const char* GetMethodUsed() const;
  const char* GetMethodReason() const;
  vtkGetMacro(PrepareSeconds, double);
  vtkGetMacro(EvaluateSeconds, double);
  ///@}

  ///@{
  /// Expectations of the last execution about the whole result in one piece. The seconds, from the
  /// source on, are what the clock said last, 1, 2, 4, … s after evaluating began, or what shorter
  /// work took. The bytes, in addition to the source and with the result arrays, are known before
  /// anything is evaluated. In a parallel program the seconds are the slowest rank's, and the bytes
  /// about the share of a rank.
  vtkGetMacro(ExpectedSeconds, double);
  vtkGetMacro(ExpectedMemory, vtkIdType);
  ///@}

  /// The same bytes for people, as "12.5 MiB".
  const char* GetExpectedMemoryInWords();

  ///@{
  /// Facts about the source of the last execution. Boundary edges are used by one triangle. The
  /// uses of net boundary edges do not cancel; a surface without any has an integer w everywhere.
  bool GetSourceIsSurface() const;
  vtkIdType GetNumberOfPrimitives() const;
  vtkIdType GetNumberOfDroppedPrimitives() const;
  vtkIdType GetNumberOfWeldedVertices() const;
  vtkIdType GetNumberOfBoundaryEdges() const;
  vtkIdType GetNumberOfNetBoundaryEdges() const;
  ///@}

  ///@{
  /// Whether the source of the last execution is inside out: with rule SIGNED, more samples had a w
  /// of -WindingThreshold or less than of WindingThreshold or more. A warning has said what to do,
  /// which comes also where that holds for a hundredth of these samples: parts of a surface look
  /// inward then. All samples count, whatever arrays are made, but only where one execution has
  /// them all: it is false after a piece of a grid that is streamed. Near single points of clouds w
  /// grows without bounds, of either sign: most normals must point inward there, too.
  vtkGetMacro(SourceIsInsideOut, bool);
  ///@}

  ///@{
  /// Facts about a cloud: the mean area of a point, whether normals were estimated, and by what:
  /// "spanning tree", "winding consistent", or nothing. The clear share is known where they were:
  /// the share of the points with a field of about 1 behind and 0 before them, which is 1 for a
  /// closed cloud that is sampled well.
  double GetMeanPointArea() const;
  bool GetNormalsWereEstimated() const;
  const char* GetNormalEstimationUsed() const;
  double GetClearShare() const;
  ///@}

  ///@{
  /// The number of triangles of the cap that closes the source for method ROWS; 0 for closed
  /// sources.
  vtkIdType GetNumberOfCapTriangles() const;
  ///@}

  /// Answers the pipeline. What the core throws becomes an error, a Status and an empty output, and
  /// the request counts as answered. An error is reported once, until this or the pipeline before
  /// it changes.
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  vtkWindingNumberAlgorithm();
  ~vtkWindingNumberAlgorithm() override;

  vtkWindingNumberAlgorithm(const vtkWindingNumberAlgorithm&) = delete;
  void operator=(const vtkWindingNumberAlgorithm&) = delete;

  ///@{
  /// The filter's answers to the pipeline's requests. They may throw the core's exceptions:
  /// ProcessRequest() reports these as errors, sets Status and empties the output. An interruption
  /// is no error.
  virtual int RequestDataObject(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs);
  virtual int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) = 0;
  virtual int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) = 0;
  virtual int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) = 0;
  ///@}

  ///@{
  /// Throws a refusal if properties are out of range, or if those that decide on the result differ
  /// between ranks. RequestData() calls it first. Filters with properties of their own add these to
  /// CheckProperties() and HashProperties(). Collective.
  void AgreeOnProperties();
  virtual void CheckProperties();
  virtual void HashProperties(winding::ContentHash& hash);
  ///@}

  /// Whether the filter evaluates a grid, whose rows can share work, or scattered samples.
  virtual bool EvaluatesGrid() const = 0;

  static void FillSourcePortInformation(vtkInformation* info);

  /// Returns the field of a source, built or kept, and prepared for `samples`, a winding::Grid or a
  /// winding::VectorsView. This rank evaluates `ownSamples` of them. Warns about faults of the
  /// source. Throws an interruption if aborted. Collective.
  template <class Samples>
  const winding::Field& PrepareField(
    vtkDataObject* source, const Samples& samples, std::size_t ownSamples);

  /// Chooses the source that all calls from now on are about, by a number, and its name for
  /// warnings, "" for none. Each source keeps a field of its own. Filters with one source need not
  /// choose.
  void ChooseSource(std::size_t number, const std::string& name);

  /// Returns the field of a source, which is kept as long as the source and the options that it
  /// depends on stay the same. Collective.
  const winding::Field& FieldOf(vtkDataObject* source, winding::Executor& executor);

  /// Returns the beginning of a warning about the source that was chosen: its name, if it has one.
  std::string GetSourcePrefix() const;

  /// Warns about faults of a source whose field was prepared.
  virtual void WarnOfFaults(const winding::Field& field);

  /// Whether voxels that the source touches are inside, as is then all of a sheet.
  virtual bool TakesTouchedVoxels() const { return false; }

  /// Returns whether WarnOfFaults() warns of sources that are open on a side: yes, unless tasks do.
  virtual bool WarnsOfOpenSide() const { return true; }

  /// Whether sources are mended, so that solids come out.
  virtual bool MendsSource() const { return false; }

  /// Returns whether several sources have the same options, so that one may be for some of them.
  virtual bool HasSeveralSources() const { return false; }

  /// Returns what the tasks of this filter run with.
  winding::Run MakeRun(winding::Executor& executor);

  winding::InsideTest GetInsideTest() const;

  /// Information on the field that facts are about: the last one, unless a filter with several
  /// sources says otherwise.
  virtual const winding::FieldInfo& GetSourceInfo() const;

  /// Everything that the field of a source depends on apart from the source.
  winding::SourceOptions GetSourceOptions();

  /// Sets SourceKind by looking at a source. Filters call it when they are asked for information.
  void InspectSource(vtkDataObject* source);

  /// The ranks of the request that is being answered.
  winding::Ranks& GetRanks() const { return *this->Ranks; }

  /// Whether ranks answer a request for information together, because it may need the source,
  /// whatever their properties say. They always do for data.
  virtual bool InformationNeedsSource() const { return false; }

  /// Whether the first rank alone makes the result. The others take part in the execution, and get
  /// an empty field from PrepareField().
  virtual bool WorksOnFirstRank() const { return false; }

  /// Whether this is a rank that only takes part.
  bool IsHelper() const;

  /// Asks upstream for the part of the source that this rank is to have.
  void RequestSource(vtkInformation* source) const;

  /// The bounds of a source's usable primitives; false if it has none. Collective.
  virtual bool GetSourceBounds(vtkDataObject* source, double bounds[6]);

  /// Adds field data that says how an output came about.
  void DescribeMethod(vtkDataObject* output) const;

  /// Returns whether signed distances are to be made: no, unless a filter says otherwise.
  virtual bool WantsDistances() const { return false; }

  /// The distance beyond which samples get this number instead of theirs: infinity, unless a filter
  /// says otherwise.
  virtual double GetDistanceLimit() const;

  /// Returns the bytes that the result takes at `samples` samples, for ExpectedMemory.
  virtual double GetResultBytes(vtkIdType samples) const = 0;

  /// Returns the memory that the filter takes in addition to the field, distances and result arrays
  /// of `samples` samples: none, unless a filter says otherwise. May throw a Refusal.
  virtual std::size_t GetAdditionalBytes(const winding::Field& field, vtkIdType samples);

  /// Does `work`, which evaluates `samples` samples of the field by the executor, and sets
  /// EvaluateSeconds and ExpectedSeconds. Throws a Refusal in the first seconds of work that is
  /// expected to take longer than LongestExpectedTime. Collective unless WorksOnFirstRank().
  void Evaluate(const winding::Field& field, vtkIdType samples, winding::SmpExecutor& executor,
    const std::function<void()>& work);

  int NamesInMessages = CXX_NAMES;
  int Method = AUTOMATIC;
  double Tolerance = 1e-3;
  vtkTypeBool SourceAsPoints = 0;
  vtkTypeBool UseSurfaceCells = 0;
  vtkTypeBool OrientFaces = 0;
  vtkTypeBool IgnoreOpenParts = 0;
  char* Mirror = nullptr;
  char* FlatBase = nullptr;
  char* SheetSide = nullptr;
  double WeldTolerance = 0;
  char* NormalsArray = nullptr;
  vtkTypeBool EstimateNormals = 0;
  int NormalEstimation = ESTIMATION_AUTOMATIC;
  char* Toward = nullptr;
  int PointAreaMethod = VORONOI;
  int NumberOfNeighbors = 20;
  double PointArea = 0;
  char* AreaArray = nullptr;
  double Regularization = 0;
  double WindingThreshold = 0.5;
  int InsideRule = SIGNED;
  int NumberOfThreads = 0;
  double LongestExpectedTime = 0;
  int SourceDistribution = DISTRIBUTION_AUTOMATIC;
  int SourceKind = NO_SOURCE;
  int Status = NOT_RUN;
  bool SourceIsInsideOut = false;
  double PrepareSeconds = 0;
  double EvaluateSeconds = 0;
  double ExpectedSeconds = 0;
  vtkIdType ExpectedMemory = 0;
  std::string ExpectedMemoryInWords;
  double EarlierSeconds = 0; ///< taken by sources before this one in the same execution
  double RunsLeft = 1;       ///< how often the execution does this work yet, this time included
  double TakenSeconds = 0;   ///< from the first source on, as for the whole result in one piece

  /// The coordinates of fields and samples: the space's, unless a filter works in an image's.
  std::unique_ptr<winding::ImageFrame> Frame;

private:
  void ExpectMemory(const winding::Field& field, vtkIdType samples);
  double LongestOfRanks(double seconds);
  void CheckExpectedTime(const winding::Field& field);
  int RepeatRefusal(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs);
  bool IsNewError();

  vtkSmartPointer<vtkMultiProcessController> Controller;
  std::unique_ptr<winding::Ranks> Ranks;
  std::vector<std::unique_ptr<winding::SourceField>> Sources;
  winding::SourceField* Source = nullptr; ///< the one that was chosen
  std::string SourceName;                 ///< of the source that was chosen
  bool LongTimeIsAnnounced = false;
  std::size_t SamplesOfResult = 0;  ///< of this rank's share of the whole result
  int InformationStatus = DONE;     ///< how the last request for information ended
  vtkMTimeType TimeOfLastError = 0; ///< of the pipeline when an error was reported; 0: none
};
VTK_ABI_NAMESPACE_END

#endif
