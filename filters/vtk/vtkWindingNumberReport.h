// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindingNumberReport
 * @brief   the health of a surface or an oriented point cloud, with regard to winding numbers
 *
 * The filter takes a source as vtkWindingNumberAlgorithm does (polydata, the outer surface of any
 * other mesh, a cloud of points, or composite data of these, whose leaves are one source) and
 * counts its faults. The first output is the source as polydata, with the counts as field data:
 * - Polydata comes out unchanged, as a shallow copy.
 * - Another mesh comes out as its outer surface. A cloud that is no polydata comes out as its
 *   points, each with a vertex cell and its point data.
 * - The leaves of a composite come out in these ways, appended to each other, with the arrays that
 *   all of them have.
 *
 * Ghost cells and points pass through, but are not counted.
 *
 * The second output shows the faults of a surface. It is a multi-block dataset in which each kind
 * has its place, in this order, which is empty (null) where there is no fault of its kind. Clouds
 * have none.
 * - Caps: the triangles that the field closes the loops of the boundary with, with the cell data
 *   Loop.
 * - Boundary: these loops of edges that do not cancel, as closed polylines, with the cell data
 *   Loop, Edges, Multiplicity and SlitWidth: the largest width of its edges (widest_slit), NaN if
 *   two triangles or more use each of them.
 * - NonManifoldEdges: lines, with the cell data Triangles, the number of triangles that meet there.
 * - InconsistentEdges: lines.
 *
 * All cells have the cell data FaultKind, the place of their block from 0 on, as active scalars.
 *
 * FixOrientation turns polygons of a surface round so that it has an outside. The report and both
 * outputs are then about the surface that comes out. It works in two steps:
 * -# Polygons that share an edge with no third one are made to agree about it. A connected part
 *    that can be made to agree is turned such that less than half of its area is turned; a part
 *    that cannot, such as a Möbius strip, stays as it is. Where more than two polygons meet, parts
 *    are turned as long as that makes more of the polygons cancel.
 * -# Closed components then get a positive volume: they are turned outward. A component inside an
 *    odd number of other closed components is a cavity, and is turned inward. An open component
 *    counts as closed here if a cap of at most half of its own area closes it, but it makes no
 *    cavity of a component that is really closed.
 *
 * Normals of a cloud are turned round where they disagree with its field: such that w is about ½
 * at the points (ConsistentNormals.h). Directions and lengths of normals stay, and points whose
 * normals agree already stay as they are.
 *
 * Nothing else changes: points, other cells and all data, normals too, stay as they are. The strips
 * of a surface in which something is turned become triangles, each with the cell data of its strip.
 * The report says how many triangles were turned, and a warning what could not be.
 *
 * The arrays of the field data have one value each, unless said otherwise. All sources have:
 * - **kind**: "surface" or "points".
 * - **non_finite**: triangles or points that were left out because a coordinate or a normal is NaN
 *   or infinite.
 * - **bbox**: one tuple of six numbers, the lowest x, y, z and the highest; no tuple if nothing is
 *   finite.
 * - **advice**: one line that says what the other figures mean and what could be done.
 *
 * Surfaces have the arrays that follow. Points with equal coordinates are one vertex, and polygons
 * are fans of triangles.
 * - **triangles**: number of triangles.
 * - **vertices**: number of points as they came in.
 * - **vertices_merged**: number of different points.
 * - **unreferenced_vertices**: different points that belong to no triangle.
 * - **closed**: 1 if the uses of every edge cancel, so that winding numbers are integers; else 0.
 * - **boundary_edges**: edges used by one triangle.
 * - **boundary_loops**: connected pieces of boundary edges.
 * - **widest_slit**: the largest width of what boundary edges leave open; no tuple without any. The
 *   width of an edge is the distance of its ends and its middle, the largest of the three, from the
 *   nearest boundary edge that runs the opposite way. That is about the width of a hole, and the
 *   distance of the two sides of a slit.
 * - **nonmanifold_edges**: edges used by more than two triangles.
 * - **inconsistent_edges**: edges used by two triangles in the same direction.
 * - **net_boundary_edges**: edges used more often in one direction than in the other.
 * - **components_vertex**: pieces connected through vertices.
 * - **components_edge**: pieces connected through edges.
 * - **closed_components**: parts with no boundary of their own. A part is what is connected through
 *   edges that two triangles share; open parts are joined where more than two triangles meet.
 * - **inverted_components**: components with negative volume, except the walls of cavities, which
 *   lie inside an odd number of other components that wind round each of their vertices. Open
 *   components count where a cap of at most half their area closes them.
 * - **nested_solids**: closed components with positive volume inside an odd number of others. w is
 *   2 there if it is a solid; it may also be a cavity that is inside out.
 * - **one_sided_components**: parts, connected through edges that two triangles share, that cannot
 *   be oriented.
 * - **open_parts_inside**: open sheets inside of closed or nearly closed parts, as baffles are.
 * - **duplicate_faces**: triangles of faces that are there before, in either sense. Volume and area
 *   leave out those with the same sense.
 * - **degenerate**: triangles that were left out because two of their vertices are one.
 * - **zero_area**: triangles with three vertices on a line.
 * - **invalid_ids**: triangles that were left out because one of their points does not exist.
 * - **euler**: vertices − edges + triangles.
 * - **volume**: the enclosed volume, negative if the surface is inside out; of an open surface, the
 *   volume of the cones from the middle of the bounds.
 * - **area**: the sum of the triangles' areas.
 * - **fractional_share**: the share (0 to 1) of samples whose w is farther than 0.1 from an
 *   integer, which shows how open the surface is; 0 if it is closed. The samples are the centres of
 *   cubic voxels, 32 along the longest side of the bounds with a twentieth added on each side; no
 *   tuple if the bounds admit no grid like that.
 * - **turned_cells**: cells with volume at the outer surface whose nodes are in the other order, so
 *   that their faces were turned away from them.
 * - **left_out_cells**: cells of two dimensions, where there are cells of three, or the latter with
 *   UseSurfaceCells.
 * - **flipped_triangles**, with FixOrientation only: triangles that were turned round.
 * - **flipped_components**, with FixOrientation only: parts with a triangle that was turned round.
 * - **left_out_faces**, with FixOrientation only: polygons that were there before.
 *
 * Clouds have:
 * - **points**: number of points.
 * - **duplicates**: points beyond the first at their position.
 * - **normals**: 1 if there are any; else 0.
 * - **zero_normals**: normals of length 0.
 * - **non_unit_normals**: other normals that are not of unit length.
 * - **spacing_min**, **spacing_median**, **spacing_mean**, **spacing_max**: distances from a
 *   position to the nearest other one.
 * - **opposite_neighbors**: the share (0 to 1) of neighbouring points whose normals are more than
 *   90° apart. It is ½ where normals point to either side at random, and small where they agree.
 * - **w_behind**, **w_before**: the median of the field two spacings behind the points, against
 *   their normals, and two spacings before them. Closed clouds with outward normals have 1 and 0,
 *   with inward normals 0 and −1; no tuple without usable normals.
 * - **outward_share**, **inward_share**: the shares (0 to 1) of points that have this field about
 *   them; no tuple without usable normals.
 * - **flipped_normals**, with FixOrientation only: normals that were turned round.
 *
 * Data that is no source is an error, and so is a surface whose triangles are all unusable. The
 * filter works on the whole source: where several pieces are asked for, the first has everything.
 * In a parallel program every rank has the report on the parts of all, the first has the faults,
 * and the first output is the part of each. Orientation is not fixed there: faces are turned before
 * they are dealt out. An execution is collective, as for vtkWindingNumberAlgorithm.
 * When it is aborted, its outputs are empty.
 *
 * @sa vtkWindingNumberField
 */
#ifndef vtkWindingNumberReport_h
#define vtkWindingNumberReport_h

#include "vtkFiltersWindingModule.h" // for export macro
#include "vtkNew.h"                  // for the report
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the controller
#include "vtkWindingABINamespace.h"
#include "vtkWindingNumberAlgorithm.h" // for the choices

#include <string> // for the advice
#include <vector> // for its points

namespace winding
{
class Ranks;
}
VTK_ABI_NAMESPACE_BEGIN
class vtkFieldData;
class vtkMultiBlockDataSet;
class vtkMultiProcessController;

class VTKFILTERSWINDING_EXPORT vtkWindingNumberReport : public vtkPolyDataAlgorithm
{
public:
  static vtkWindingNumberReport* New();
  vtkTypeMacro(vtkWindingNumberReport, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The names that messages give properties, of vtkWindingNumberAlgorithm::NamesInMessagesType.
  /// Default CXX_NAMES.
  vtkSetMacro(NamesInMessages, int);
  vtkGetMacro(NamesInMessages, int);
  ///@}

  ///@{
  /// Name of the point array with the normals of a cloud. Default: empty, for the active normals;
  /// the name None means the same if no array has it.
  vtkSetStringMacro(NormalsArray);
  vtkGetStringMacro(NormalsArray);
  ///@}

  ///@{
  /// Whether cells of two dimensions are taken, where a mesh has cells of three, too. Default off.
  vtkSetMacro(UseSurfaceCells, bool);
  vtkGetMacro(UseSurfaceCells, bool);
  vtkBooleanMacro(UseSurfaceCells, bool);
  ///@}

  ///@{
  /// Additions to a surface before it is examined, with the meaning and the defaults of
  /// vtkWindingNumberAlgorithm. The report and the second output are about the completed surface,
  /// and the first output is the input.
  vtkSetStringMacro(Mirror);
  vtkGetStringMacro(Mirror);
  vtkSetStringMacro(FlatBase);
  vtkGetStringMacro(FlatBase);
  vtkSetMacro(WeldTolerance, double);
  vtkGetMacro(WeldTolerance, double);
  ///@}

  ///@{
  /// Whether to turn polygons of a surface, or normals of a cloud, round so that it has an outside.
  /// Default off. Points without normals are refused then.
  vtkSetMacro(FixOrientation, bool);
  vtkGetMacro(FixOrientation, bool);
  vtkBooleanMacro(FixOrientation, bool);
  ///@}

  ///@{
  /// The radius of the tubes that the lines of the second output become, so that they can be seen
  /// on the surface, in units of the diagonal of its bounds. Lines stay lines where it is 0, and
  /// where a kind has more than 20 000 edges. 0 to 1, default 0.
  vtkSetMacro(FaultThickness, double);
  vtkGetMacro(FaultThickness, double);
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

  /// The second output: the blocks that show the faults of a surface.
  vtkMultiBlockDataSet* GetFaults();

  ///@{
  /// The points of the advice, what spoils most first; empty for other numbers.
  int GetNumberOfAdvice() const { return static_cast<int>(this->Advice.size()); }
  const char* GetAdvice(int number);
  ///@}

  /// The advice, a new line for each point, broken into lines of at most 44 characters, for panels
  /// that do not break them. The text lives until the next call.
  const char* GetAdviceInLines();

  /// The arrays of the report, in the order in which people read them, without those that the
  /// source had. Empty before the first execution, and after one that failed or was aborted.
  vtkFieldData* GetReport();

  ///@{
  /// Single values of the report; 0, false or empty where the report does not have the value.
  const char* GetAdvice();
  bool GetSourceIsSurface();
  bool GetClosed();
  vtkIdType GetNumberOfTriangles();
  vtkIdType GetNumberOfBoundaryEdges();
  vtkIdType GetNumberOfBoundaryLoops();
  double GetWidestSlit();
  vtkIdType GetNumberOfNonManifoldEdges();
  vtkIdType GetNumberOfInconsistentEdges();
  vtkIdType GetNumberOfComponents(); ///< pieces connected through edges
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
  vtkIdType GetNumberOfPoints(); ///< points of a cloud
  vtkIdType GetNumberOfDuplicatePoints();
  vtkIdType GetNumberOfZeroNormals();
  bool GetHasNormals();
  double GetMedianSpacing();
  double GetOppositeNeighbors();
  double GetOutwardShare();
  double GetInwardShare();
  vtkIdType GetNumberOfNonFinite(); ///< triangles or points left out
  ///@}

protected:
  vtkWindingNumberReport();
  ~vtkWindingNumberReport() override;

  vtkWindingNumberReport(const vtkWindingNumberReport&) = delete;
  void operator=(const vtkWindingNumberReport&) = delete;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  /// Sets the report and both outputs. An exception of the core passes through, and nothing is set
  /// then.
  void MakeReport(vtkDataObject* source, vtkPolyData* output, winding::Ranks& ranks);

  ///@{
  /// The only value of an array of the report; 0 if the array has none.
  double GetNumber(const char* name);
  vtkIdType GetCount(const char* name);
  ///@}

  int NamesInMessages = 0; // vtkWindingNumberAlgorithm::CXX_NAMES
  char* NormalsArray = nullptr;
  char* Mirror = nullptr;
  char* FlatBase = nullptr;
  double WeldTolerance = 0;
  bool UseSurfaceCells = false;
  bool FixOrientation = false;
  double FaultThickness = 0;
  vtkSmartPointer<vtkMultiProcessController> Controller;
  int SourceDistribution = 0;
  vtkNew<vtkFieldData> Report;
  std::vector<std::string> Advice; ///< by point
  std::string AdviceInLines;
};
VTK_ABI_NAMESPACE_END

#endif
