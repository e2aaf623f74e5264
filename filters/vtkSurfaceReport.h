/**
 * @class   vtkSurfaceReport
 * @brief   the health of a surface or an oriented point cloud, as far as winding numbers are concerned
 *
 * Takes a source as vtkWindingNumberAlgorithm does (polydata, the outer surface of any other mesh, a
 * cloud of points, or composite data of these, of which all leaves are one source) and counts what is
 * wrong with it. The first output is the source as polydata, with the counts as field data:
 * - polydata comes out as it is (a shallow copy),
 * - of another mesh its outer surface, and of a cloud that is no polydata its points, each with a
 *   vertex cell and its point data,
 * - the leaves of a composite, each as above, appended to each other, with the arrays that all have.
 *
 * Ghost cells and points pass through, but are not counted.
 *
 * The second output shows what is wrong with a surface: a multi-block dataset with the blocks Boundary
 * (the loops of edges that do not cancel, as closed polylines, with the cell data Loop, Edges and
 * Multiplicity), Caps (the triangles that the field closes these loops with, with the cell data Loop),
 * NonManifoldEdges (lines, with the cell data Triangles: how many meet there), and InconsistentEdges
 * (lines). For clouds, and where nothing is wrong, they are empty.
 *
 * With FixOrientation, the polygons of a surface are turned round so that it has an outside, and the
 * report and both outputs are about the surface that comes out:
 * -# Polygons that share an edge with no third one are made to agree about it. Parts that admit it are
 *    turned such that less than half of their area is; those that do not, Möbius strips say, stay as
 *    they are. Where more than two polygons meet, parts are turned as long as that makes more of them
 *    cancel.
 * -# Closed components then get a positive volume: they are turned outward. Those that lie inside an
 *    odd number of other closed components are cavities, and are turned inward. So is what a cap of at
 *    most half of its own area closes; but that makes no cavity of anything that is really closed.
 *
 * Nothing else changes: points, other cells and all data, normals too, stay as they are. The strips of a
 * surface in which something is turned become triangles, each with the cell data of its strip. A warning
 * says what has been turned, and what could not be.
 *
 * The arrays of the field data have one value each, unless said otherwise. For all sources:
 * | array       | |
 * |-------------|-|
 * | kind        | "surface" or "points" |
 * | non_finite  | triangles or points left out: a coordinate or normal is NaN or infinite |
 * | bbox        | one tuple of six: the lowest x, y, z, and the highest; no tuple if nothing is finite |
 * | advice      | what all this means, and what could be done: one line |
 *
 * Surfaces, of which points with equal coordinates are one vertex:
 * | array                 | |
 * |-----------------------|-|
 * | triangles             | polygons are fans |
 * | vertices              | points as they came in |
 * | vertices_merged       | different ones |
 * | unreferenced_vertices | of these, those without a triangle |
 * | closed                | 1 if the uses of every edge cancel: winding numbers are integers; else 0 |
 * | boundary_edges        | used by one triangle |
 * | boundary_loops        | connected pieces of boundary edges |
 * | nonmanifold_edges     | used by more than two triangles |
 * | inconsistent_edges    | used by two triangles in the same direction |
 * | net_boundary_edges    | used more often in one direction than in the other |
 * | components_vertex     | pieces connected through vertices |
 * | components_edge       | pieces connected through edges |
 * | closed_components     | parts with no boundary of their own. Parts are what is connected through edges that two triangles share; those that are open are joined where more than two meet |
 * | inverted_components   | of these, those with negative volume, unless they are the walls of cavities: inside an odd number of others, which wind round each of their vertices |
 * | nested_solids         | of these, those with positive volume inside an odd number of others: w is 2 there, or a cavity is inside out |
 * | one_sided_components  | connected through edges that two triangles share, and impossible to orient |
 * | duplicate_faces       | triangles beyond the first with the same vertices |
 * | degenerate            | triangles left out: two of their vertices are one |
 * | zero_area             | triangles with three vertices on a line |
 * | invalid_ids           | triangles left out: a point does not exist |
 * | euler                 | vertices − edges + triangles |
 * | volume                | enclosed, negative if inside out; means nothing for open surfaces |
 * | area                  | |
 * | fractional_share      | the share (0 to 1) of samples whose w is farther than 0.1 from an integer: how open it is. 0 if it is closed. The samples: cubic voxels, 32 along the longest side of the bounds with a twentieth added on each side; no tuple if the bounds admit none |
 * | flipped_triangles     | with FixOrientation only: turned round; polygons are fans |
 * | flipped_components    | with FixOrientation only: parts with a triangle that is turned round |
 *
 * Clouds:
 * | array             | |
 * |-------------------|-|
 * | points            | |
 * | duplicates        | points beyond the first at their position |
 * | normals           | 1 if there are any; else 0 |
 * | zero_normals      | normals of length 0 |
 * | non_unit_normals  | other normals not of unit length |
 * | spacing_min, spacing_median, spacing_mean, spacing_max | distances to the nearest other position |
 * | opposite_neighbors | the share (0 to 1) of near points whose normals are more than 90° apart: ½ where normals point to either side at random, little where they agree |
 * | w_behind, w_before | the median of the field two spacings behind the points, against their normals, and before them: 1 and 0 for closed clouds outward, 0 and −1 inward; no tuple without usable normals |
 * | outward_share, inward_share | the shares (0 to 1) of points with such a field; no tuple without usable normals |
 *
 * What is no source is an error, and so is a surface that has bad triangles only. Works on the whole
 * source: with several pieces, all is in the first. Aborted, the output is empty.
 *
 * @sa vtkWindingNumberField
 */
#ifndef vtkSurfaceReport_h
#define vtkSurfaceReport_h

#include "vtkFiltersWindingModule.h" // for export macro
#include "vtkNew.h"                  // for the report
#include "vtkPolyDataAlgorithm.h"

class vtkFieldData;
class vtkMultiBlockDataSet;

class VTKFILTERSWINDING_EXPORT vtkSurfaceReport : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceReport* New();
  vtkTypeMacro(vtkSurfaceReport, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The point array with the normals of a cloud; empty, the default, for the active normals.
  vtkSetStringMacro(NormalsArray);
  vtkGetStringMacro(NormalsArray);
  ///@}

  ///@{
  /// Whether to turn polygons round, see above. Default: off.
  vtkSetMacro(FixOrientation, bool);
  vtkGetMacro(FixOrientation, bool);
  vtkBooleanMacro(FixOrientation, bool);
  ///@}

  /// The second output.
  vtkMultiBlockDataSet* GetFaults();

  /// The arrays above, in the order in which people read them, and none that the source had. Empty
  /// before the first execution, and after one that failed or was aborted.
  vtkFieldData* GetReport();

  ///@{
  /// What the report says: 0, false or empty where it says nothing about that.
  const char* GetAdvice();
  bool GetSourceIsSurface();
  bool GetClosed();
  vtkIdType GetNumberOfTriangles();
  vtkIdType GetNumberOfBoundaryEdges();
  vtkIdType GetNumberOfBoundaryLoops();
  vtkIdType GetNumberOfNonManifoldEdges();
  vtkIdType GetNumberOfInconsistentEdges();
  vtkIdType GetNumberOfComponents(); ///< connected through edges
  vtkIdType GetNumberOfClosedComponents();
  vtkIdType GetNumberOfInvertedComponents();
  vtkIdType GetNumberOfNestedSolids();
  vtkIdType GetNumberOfOneSidedComponents();
  vtkIdType GetNumberOfFlippedTriangles();
  vtkIdType GetNumberOfFlippedComponents();
  double GetFractionalShare();
  vtkIdType GetNumberOfDuplicateFaces();
  double GetVolume();
  double GetArea();
  vtkIdType GetNumberOfPoints(); ///< of a cloud
  vtkIdType GetNumberOfDuplicatePoints();
  vtkIdType GetNumberOfZeroNormals();
  bool GetHasNormals();
  double GetMedianSpacing();
  double GetOppositeNeighbors();
  double GetOutwardShare();
  double GetInwardShare();
  vtkIdType GetNumberOfNonFinite(); ///< triangles or points
  ///@}

protected:
  vtkSurfaceReport();
  ~vtkSurfaceReport() override;

  vtkSurfaceReport(const vtkSurfaceReport&) = delete;
  void operator=(const vtkSurfaceReport&) = delete;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  /// Sets the report and both outputs. Throws what the core throws, and has set nothing then.
  void MakeReport(vtkDataObject* source, vtkPolyData* output);

  /// The only value of an array of the report.
  double GetNumber(const char* name);
  vtkIdType GetCount(const char* name);

  char* NormalsArray = nullptr;
  bool FixOrientation = false;
  vtkNew<vtkFieldData> Report;
};

#endif
