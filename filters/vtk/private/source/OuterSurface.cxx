#include "private/source/OuterSurface.h"

#include "private/source/CellChecks.h"
#include "private/source/CellTypes.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkExtractCells.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace winding
{

namespace
{

/// Whether a data set has cells of two dimensions and of three. Polydata has none with volume.
bool isMixed(vtkPointSet* mesh)
{
  bool hasFaces = false, hasVolumes = false;
  const vtkIdType cells = vtkUnstructuredGrid::SafeDownCast(mesh) ? mesh->GetNumberOfCells() : 0;
  for (vtkIdType cell = 0; cell < cells && !(hasFaces && hasVolumes); ++cell)
  {
    const int dimension = dimensionOf(mesh->GetCellType(cell));
    hasFaces |= dimension == 2;
    hasVolumes |= dimension == 3;
  }
  return hasFaces && hasVolumes;
}

/// Returns the number of corners of a face, whose other nodes come after them.
vtkIdType cornersOf(vtkCell* face)
{
  return face->IsLinear() ? face->GetNumberOfPoints() : face->GetNumberOfEdges();
}

/// The faces of a cell, by the ids of their corners in the order around them.
using CellFaces = std::vector<std::vector<vtkIdType>>;

CellFaces cornersOfFaces(vtkCell* cell)
{
  CellFaces faces;
  for (int i = 0; i < cell->GetNumberOfFaces(); ++i)
  {
    vtkCell* face = cell->GetFace(i);
    const vtkIdType* ids = face->GetPointIds()->GetPointer(0);
    faces.emplace_back(ids, ids + cornersOf(face));
    if (face->GetCellType() == VTK_PIXEL)
    {
      std::swap(faces.back()[2], faces.back()[3]);
    }
  }
  return faces;
}

/// Orients the faces of a polyhedron like the first one that they hang together with. Edges of more
/// than two faces say nothing.
void orientLikeEachOther(CellFaces& faces)
{
  struct Use
  {
    std::size_t face;
    bool isForward;
  };
  std::map<std::pair<vtkIdType, vtkIdType>, std::vector<Use>> edges;
  const auto forEachEdge = [&faces](std::size_t face, const auto& visit)
  {
    const std::vector<vtkIdType>& ids = faces[face];
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      const vtkIdType from = ids[i], to = ids[(i + 1) % ids.size()];
      visit(std::minmax(from, to), from < to);
    }
  };
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    forEachEdge(face,
      [&](std::pair<vtkIdType, vtkIdType> edge, bool isForward) {
        edges[edge].push_back({face, isForward});
      });
  }
  std::vector<char> isReached(faces.size(), 0), isTurned(faces.size(), 0);
  std::vector<std::size_t> waiting;
  for (std::size_t first = 0; first < faces.size(); ++first)
  {
    if (!isReached[first])
    {
      isReached[first] = 1;
      waiting.push_back(first);
    }
    while (!waiting.empty())
    {
      const std::size_t face = waiting.back();
      waiting.pop_back();
      forEachEdge(face,
        [&](std::pair<vtkIdType, vtkIdType> edge, bool isForward)
        {
          const std::vector<Use>& uses = edges[edge];
          if (uses.size() != 2)
          {
            return;
          }
          const Use& other = uses[uses[0].face == face ? 1 : 0];
          if (!isReached[other.face])
          {
            isReached[other.face] = 1;
            isTurned[other.face] = isTurned[face] != (other.isForward == isForward);
            waiting.push_back(other.face);
          }
        });
    }
  }
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    if (isTurned[face])
    {
      std::reverse(faces[face].begin(), faces[face].end());
    }
  }
}

Eigen::Vector3d pointOf(vtkPointSet* mesh, vtkIdType id)
{
  Eigen::Vector3d point;
  mesh->GetPoint(id, point.data());
  return point;
}

/// Returns six times the volume within faces, which is negative where they look inward.
double volumeWithin(const CellFaces& faces, vtkPointSet* mesh)
{
  const Eigen::Vector3d origin = pointOf(mesh, faces.front().front());
  double volume = 0;
  for (const std::vector<vtkIdType>& face : faces)
  {
    const Eigen::Vector3d first = pointOf(mesh, face[0]) - origin;
    for (std::size_t i = 2; i < face.size(); ++i)
    {
      volume +=
        first.dot((pointOf(mesh, face[i - 1]) - origin).cross(pointOf(mesh, face[i]) - origin));
    }
  }
  return volume;
}

/// Says which polygons of an outer surface look into their own cell.
class FaceSenses
{
public:
  explicit FaceSenses(vtkPointSet* mesh)
    : mesh_(mesh)
    , ofCells_(static_cast<std::size_t>(mesh->GetNumberOfCells()), Sense::unknown)
  {
  }

  /// Returns whether a polygon of a cell is to be turned, by the points of the mesh that it has.
  bool isInward(vtkIdType cell, const std::vector<vtkIdType>& polygon)
  {
    const int type = mesh_->GetCellType(cell);
    if (dimensionOf(type) < 3)
    {
      return false;
    }
    // Surfaces have the polygons of these cells in the order of the cells' own faces. Of wedges,
    // that depends on VTK's version, and of prisms it is not so.
    const bool isInOrder =
      type == VTK_TETRA || type == VTK_VOXEL || type == VTK_HEXAHEDRON || type == VTK_PYRAMID;
    Sense& sense = ofCells_[static_cast<std::size_t>(cell)];
    if (isInOrder && sense != Sense::unknown)
    {
      return sense == Sense::inward;
    }
    if (cell != last_)
    {
      last_ = cell;
      mesh_->GetCell(cell, generic_);
      faces_ = cornersOfFaces(generic_);
      if (!isInOrder)
      {
        orientLikeEachOther(faces_);
      }
      sense = !faces_.empty() && volumeWithin(faces_, mesh_) < 0 ? Sense::inward : Sense::outward;
    }
    return (sense == Sense::inward) != (!isInOrder && this->isReversed(polygon));
  }

private:
  enum class Sense : char
  {
    unknown,
    outward,
    inward
  };

  /// Returns whether a polygon goes round the other way than the face of the last cell that it is.
  bool isReversed(const std::vector<vtkIdType>& polygon) const
  {
    const auto face = std::find_if(faces_.begin(), faces_.end(),
      [&polygon](const std::vector<vtkIdType>& ids)
      {
        return ids.size() == polygon.size() &&
               std::is_permutation(ids.begin(), ids.end(), polygon.begin());
      });
    if (face == faces_.end())
    {
      return false;
    }
    const auto first = std::find(face->begin(), face->end(), polygon[0]) - face->begin();
    return (*face)[static_cast<std::size_t>(first + 1) % face->size()] != polygon[1];
  }

  vtkPointSet* mesh_;
  std::vector<Sense> ofCells_;
  vtkIdType last_ = -1; ///< the cell that was looked at last
  CellFaces faces_;     ///< of that cell, oriented like each other
  vtkNew<vtkGenericCell> generic_;
};

/// Returns the outer surface of cells without curves, as VTK finds it.
vtkSmartPointer<vtkPolyData> straightSurfaceOf(vtkPointSet* mesh)
{
  vtkNew<vtkDataSetSurfaceFilter> filter;
  filter->SetInputData(mesh);
  filter->PassThroughCellIdsOn();
  filter->PassThroughPointIdsOn();
  filter->Update();
  return filter->GetOutput();
}

/// The polygons of a surface that straightSurfaceOf() has made.
class OuterPolygons
{
public:
  explicit OuterPolygons(vtkPolyData* surface)
    : polygons_(surface->GetPolys())
    , before_(surface->GetNumberOfVerts() + surface->GetNumberOfLines())
    , cells_(idsIn(surface->GetCellData(), "vtkOriginalCellIds"))
    , points_(idsIn(surface->GetPointData(), "vtkOriginalPointIds"))
  {
  }

  /// Returns the number of polygons whose cells are known: of all, or of none.
  vtkIdType count() const { return cells_ && points_ ? polygons_->GetNumberOfCells() : 0; }

  /// Returns the cell of the mesh that a polygon is a face of.
  vtkIdType owner(vtkIdType polygon) const { return cells_->GetValue(before_ + polygon); }

  /// Returns the points of the mesh that a polygon has.
  std::vector<vtkIdType> points(vtkIdType polygon) const
  {
    vtkIdType size;
    const vtkIdType* ids;
    polygons_->GetCellAtId(polygon, size, ids);
    std::vector<vtkIdType> points(ids, ids + size);
    std::transform(points.begin(), points.end(), points.begin(),
      [this](vtkIdType id) { return points_->GetValue(id); });
    return points;
  }

private:
  static vtkIdTypeArray* idsIn(vtkDataSetAttributes* arrays, const char* name)
  {
    return vtkIdTypeArray::SafeDownCast(arrays->GetArray(name));
  }

  vtkCellArray* polygons_;
  vtkIdType before_;
  vtkIdTypeArray* cells_;
  vtkIdTypeArray* points_;
};

/// Turns the polygons of an outer surface that look into their own cell.
void turnOutward(vtkPointSet* mesh, vtkPolyData* surface, CellCounts& counts)
{
  const OuterPolygons polygons(surface);
  FaceSenses senses(mesh);
  std::vector<char> isTurned(static_cast<std::size_t>(mesh->GetNumberOfCells()), 0);
  for (vtkIdType i = 0; i < polygons.count(); ++i)
  {
    const vtkIdType owner = polygons.owner(i);
    if (senses.isInward(owner, polygons.points(i)))
    {
      surface->GetPolys()->ReverseCellAtId(i);
      counts.turned += !std::exchange(isTurned[static_cast<std::size_t>(owner)], 1);
    }
  }
}

bool hasCurvedCells(vtkPointSet* mesh)
{
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    if (isCurved(mesh->GetCellType(cell)))
    {
      return true;
    }
  }
  return false;
}

/// Returns the same mesh with straight edges between the corners of its cells.
vtkSmartPointer<vtkUnstructuredGrid> straightened(vtkUnstructuredGrid* mesh)
{
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result->SetPoints(mesh->GetPoints());
  result->Allocate(mesh->GetNumberOfCells());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const int type = mesh->GetCellType(cell), straight = straightTypeOf(type);
    if (type == VTK_POLYHEDRON)
    {
      mesh->GetFaceStream(cell, ids);
      result->InsertNextCell(type, ids);
      continue;
    }
    mesh->GetCellPoints(cell, ids);
    if (type == VTK_QUADRATIC_POLYGON)
    {
      // Each corner is followed by the middle of its edge.
      const vtkIdType corners = ids->GetNumberOfIds() / 2;
      std::vector<vtkIdType> around;
      for (vtkIdType i = 0; i < corners; ++i)
      {
        around.insert(around.end(), {ids->GetId(i), ids->GetId(corners + i)});
      }
      result->InsertNextCell(straight, 2 * corners, around.data());
      continue;
    }
    result->InsertNextCell(straight,
      straight == type ? ids->GetNumberOfIds() : fewestPointsOf(straight), ids->GetPointer(0));
  }
  return result;
}

/// The curved face of a mesh that has some corners; none where it is straight.
class CurvedFaces
{
public:
  explicit CurvedFaces(vtkUnstructuredGrid* mesh)
    : mesh_(mesh)
  {
  }

  /// Returns the face of `cell`, or the cell that is a face; null if it is straight.
  vtkCell* find(vtkIdType cell, const std::vector<vtkIdType>& corners)
  {
    if (!isCurved(mesh_->GetCellType(cell)) || corners.size() > 4)
    {
      return nullptr;
    }
    if (cell != cell_)
    {
      cell_ = cell;
      mesh_->GetCell(cell, generic_);
    }
    if (generic_->GetCellDimension() < 3)
    {
      return generic_;
    }
    for (int i = 0; i < generic_->GetNumberOfFaces(); ++i)
    {
      vtkCell* face = generic_->GetFace(i);
      const vtkIdType* ids = face->GetPointIds()->GetPointer(0);
      if (static_cast<std::size_t>(cornersOf(face)) == corners.size() &&
          std::is_permutation(corners.begin(), corners.end(), ids))
      {
        return face->IsLinear() ? nullptr : face;
      }
    }
    return nullptr;
  }

private:
  vtkUnstructuredGrid* mesh_;
  vtkIdType cell_ = -1; ///< the last one that was looked at
  vtkNew<vtkGenericCell> generic_;
};

/// Returns the largest distance of a curved face's nodes from the straight face of its corners.
double bulgeOf(vtkCell* face)
{
  const double* parameters = face->GetParametricCoords();
  const auto node = [face](vtkIdType i)
  {
    Eigen::Vector3d point;
    face->GetPoints()->GetPoint(i, point.data());
    return point;
  };
  const vtkIdType corners = cornersOf(face);
  double largest = 0;
  for (vtkIdType i = corners; parameters && i < face->GetNumberOfPoints(); ++i)
  {
    const double r = parameters[3 * i], s = parameters[3 * i + 1];
    const Eigen::Vector3d straight =
      corners == 3
        ? ((1 - r - s) * node(0) + r * node(1) + s * node(2)).eval()
        : ((1 - r) * ((1 - s) * node(0) + s * node(3)) + r * ((1 - s) * node(1) + s * node(2)))
            .eval();
    largest = std::max(largest, (node(i) - straight).norm());
  }
  return largest;
}

/// Returns the number of pieces that its nodes divide the edges of a curved face into.
int degreeOf(vtkCell* face)
{
  int degree = 1;
  for (int i = 0; i < face->GetNumberOfEdges(); ++i)
  {
    degree = std::max(degree, static_cast<int>(face->GetEdge(i)->GetNumberOfPoints()) - 1);
  }
  return degree;
}

/// Returns the number of pieces to divide the edges of all curved faces into. The distance of
/// chords from a curve falls with its square. Counts the faces that are still too far from theirs.
int divisionsFor(
  vtkUnstructuredGrid* mesh, const OuterPolygons& polygons, bool keepsPoints, CellCounts& counts)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  const double diagonal =
    Eigen::Vector3d(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]).norm();
  constexpr double share = 1e-3;
  CurvedFaces faces(mesh);
  std::vector<double> bulges;
  int degree = 1;
  for (vtkIdType i = 0; i < polygons.count(); ++i)
  {
    if (vtkCell* face = faces.find(polygons.owner(i), polygons.points(i)))
    {
      degree = std::max(degree, degreeOf(face));
      bulges.push_back(bulgeOf(face));
    }
  }
  constexpr int most = 32;
  const auto distance = [](double bulge, int divisions)
  {
    return bulge / (static_cast<double>(divisions) * divisions);
  };
  const double largest = bulges.empty() ? 0 : *std::max_element(bulges.begin(), bulges.end());
  int divisions = degree;
  // Nodes need not be where a bulge is largest, so that half the distance is asked for.
  while (
    !keepsPoints && 2 * divisions <= most && distance(largest, divisions) > share / 2 * diagonal)
  {
    divisions *= 2;
  }
  counts.flat += static_cast<std::size_t>(std::count_if(bulges.begin(), bulges.end(),
    [&](double bulge) { return !keepsPoints && distance(bulge, divisions) > share * diagonal; }));
  return divisions;
}

/// Makes a surface of straight faces, and of triangles of curved ones. Faces that share an edge
/// share the points on it.
class DividedSurface
{
public:
  DividedSurface(vtkUnstructuredGrid* mesh, int divisions)
    : mesh_(mesh)
    , divisions_(divisions)
    , faces_(mesh)
    , newIds_(static_cast<std::size_t>(mesh->GetNumberOfPoints()), -1)
  {
    points_->SetDataType(mesh->GetPoints()->GetDataType());
    surface_->GetPointData()->CopyAllocate(mesh->GetPointData());
    surface_->GetCellData()->CopyAllocate(mesh->GetCellData());
  }

  /// Adds the face of `owner` that has these corners, in the order in which it is to have them.
  void add(vtkIdType owner, const std::vector<vtkIdType>& corners)
  {
    vtkCell* face = faces_.find(owner, corners);
    if (!face)
    {
      std::vector<vtkIdType> ids;
      std::transform(corners.begin(), corners.end(), std::back_inserter(ids),
        [this](vtkIdType id) { return this->nodeId(id); });
      this->insert(owner, std::move(ids), false);
      return;
    }
    const vtkIdType* own = face->GetPointIds()->GetPointer(0);
    const auto count = corners.size();
    const auto first = static_cast<std::size_t>(std::find(own, own + count, corners[0]) - own);
    const bool isTurned = own[(first + 1) % count] != corners[1];
    weights_.resize(static_cast<std::size_t>(face->GetNumberOfPoints()));
    const int n = divisions_;
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; j < (count == 3 ? n - i : n); ++j)
      {
        const vtkIdType a = this->pointId(face, i, j), b = this->pointId(face, i + 1, j),
                        c = this->pointId(face, i, j + 1);
        this->insert(owner, {a, b, c}, isTurned);
        if (count == 4 || i + j + 1 < n)
        {
          this->insert(owner, {b, this->pointId(face, i + 1, j + 1), c}, isTurned);
        }
      }
    }
    inFace_.clear();
  }

  vtkSmartPointer<vtkPolyData> take()
  {
    surface_->SetPoints(points_);
    surface_->SetPolys(polygons_);
    surface_->GetFieldData()->ShallowCopy(mesh_->GetFieldData());
    return surface_;
  }

private:
  using Key = std::array<vtkIdType, 3>;

  void insert(vtkIdType owner, std::vector<vtkIdType> ids, bool isTurned)
  {
    if (isTurned)
    {
      std::reverse(ids.begin(), ids.end());
    }
    const vtkIdType cell =
      polygons_->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    surface_->GetCellData()->CopyData(mesh_->GetCellData(), owner, cell);
  }

  /// Returns the id of a point of the mesh in the surface.
  vtkIdType nodeId(vtkIdType node)
  {
    vtkIdType& id = newIds_[static_cast<std::size_t>(node)];
    if (id < 0)
    {
      id = points_->InsertNextPoint(pointOf(mesh_, node).data());
      surface_->GetPointData()->CopyData(mesh_->GetPointData(), node, id);
    }
    return id;
  }

  /// Returns the id of a point of the lattice in a face, `i` steps from the first corner to the
  /// second and `j` to the last.
  vtkIdType pointId(vtkCell* face, int i, int j)
  {
    const int n = divisions_;
    const vtkIdType* ids = face->GetPointIds()->GetPointer(0);
    if (cornersOf(face) == 3)
    {
      if (j == 0)
      {
        return this->edgePointId(face, ids[0], ids[1], i, i, j);
      }
      if (i == 0)
      {
        return this->edgePointId(face, ids[0], ids[2], j, i, j);
      }
      if (i + j == n)
      {
        return this->edgePointId(face, ids[1], ids[2], j, i, j);
      }
    }
    else
    {
      if (j == 0)
      {
        return this->edgePointId(face, ids[0], ids[1], i, i, j);
      }
      if (j == n)
      {
        return this->edgePointId(face, ids[3], ids[2], i, i, j);
      }
      if (i == 0)
      {
        return this->edgePointId(face, ids[0], ids[3], j, i, j);
      }
      if (i == n)
      {
        return this->edgePointId(face, ids[1], ids[2], j, i, j);
      }
    }
    return this->pointId(inFace_, {i, j, 0}, face, i, j);
  }

  /// Returns the id of the point that is `step` steps from one corner to another.
  vtkIdType edgePointId(vtkCell* face, vtkIdType from, vtkIdType to, int step, int i, int j)
  {
    if (step == 0 || step == divisions_)
    {
      return this->nodeId(step == 0 ? from : to);
    }
    const bool isForward = from < to;
    return this->pointId(onEdges_,
      {std::min(from, to), std::max(from, to), isForward ? step : divisions_ - step}, face, i, j);
  }

  /// Returns the id of a point that faces share by a key, and makes the point if nobody has.
  vtkIdType pointId(std::map<Key, vtkIdType>& known, const Key& key, vtkCell* face, int i, int j)
  {
    const auto [entry, isNew] = known.try_emplace(key, -1);
    if (isNew)
    {
      entry->second = this->makePoint(face, i, j);
    }
    return entry->second;
  }

  vtkIdType makePoint(vtkCell* face, int i, int j)
  {
    const double n = divisions_;
    const double parameters[3] = {i / n, j / n, 0};
    // A node stays what it is.
    const double* ofNodes = face->GetParametricCoords();
    for (vtkIdType node = 0; ofNodes && node < face->GetNumberOfPoints(); ++node)
    {
      constexpr double rounding = 1e-9; // of parameters, which are 0 to 1
      if (std::abs(ofNodes[3 * node] - parameters[0]) < rounding &&
          std::abs(ofNodes[3 * node + 1] - parameters[1]) < rounding)
      {
        return this->nodeId(face->GetPointId(static_cast<int>(node)));
      }
    }
    int part = 0;
    double point[3];
    face->EvaluateLocation(part, parameters, point, weights_.data());
    const vtkIdType id = points_->InsertNextPoint(point);
    surface_->GetPointData()->InterpolatePoint(
      mesh_->GetPointData(), id, face->GetPointIds(), weights_.data());
    return id;
  }

  vtkUnstructuredGrid* mesh_;
  int divisions_;
  CurvedFaces faces_;
  vtkSmartPointer<vtkPolyData> surface_ = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> polygons_;
  std::vector<vtkIdType> newIds_; ///< of the points of the mesh; −1: not in the surface yet
  std::map<Key, vtkIdType> onEdges_, inFace_;
  std::vector<double> weights_;
};

} // namespace

std::vector<Message> notesOn(const CellCounts& counts)
{
  std::vector<Message> notes;
  if (counts.leftOut > 0)
  {
    notes.push_back(
      {"cells with and without volume are mixed", {{"choose which", {Parameter::surfaceCells}}},
        std::to_string(counts.leftOut) + " cells of the other kind are left out"});
  }
  if (counts.flat > 0)
  {
    notes.push_back({"curved cells are cut off", {{"divide them finer first", {}}},
      std::to_string(counts.flat) + " are farther than a thousandth of the mesh's diagonal from "
                                    "their triangles"});
  }
  return notes;
}

bool isGhostCell(vtkUnsignedCharArray* flags, vtkIdType cell)
{
  constexpr int ghost = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL |
                        vtkDataSetAttributes::REFINEDCELL;
  return flags && cell < flags->GetNumberOfTuples() && (flags->GetValue(cell) & ghost) != 0;
}

vtkSmartPointer<vtkPointSet> ownCellsOf(
  vtkPointSet* mesh, bool takesFaces, const std::string& name, CellCounts& counts)
{
  vtkUnsignedCharArray* flags = mesh->GetCellGhostArray();
  const int unwanted = !isMixed(mesh) ? -1 : takesFaces ? 3 : 2;
  if (!flags && unwanted < 0)
  {
    return mesh;
  }
  const vtkIdType cells = mesh->GetNumberOfCells();
  vtkNew<vtkIdList> own;
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    if (isGhostCell(flags, cell))
    {
      continue;
    }
    if (unwanted > 0 && dimensionOf(mesh->GetCellType(cell)) == unwanted)
    {
      ++counts.leftOut;
      continue;
    }
    own->InsertNextId(cell);
  }
  if (own->GetNumberOfIds() == cells)
  {
    return mesh;
  }
  checkCells(mesh, name);
  checkArrays(mesh, name);
  vtkNew<vtkExtractCells> extract;
  extract->SetInputData(mesh);
  extract->SetCellList(own);
  extract->Update();
  if (!vtkPolyData::SafeDownCast(mesh))
  {
    return extract->GetOutput();
  }
  // The cells of polydata stay polydata.
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputConnection(extract->GetOutputPort());
  surface->Update();
  return surface->GetOutput();
}

vtkSmartPointer<vtkPolyData> outerSurfaceOf(vtkPointSet* mesh, bool keepsPoints, CellCounts& counts)
{
  auto* curved = vtkUnstructuredGrid::SafeDownCast(mesh);
  curved = curved && hasCurvedCells(curved) ? curved : nullptr;
  const vtkSmartPointer<vtkPointSet> straight = curved ? straightened(curved) : nullptr;
  vtkPointSet* cells = curved ? straight.Get() : mesh;
  vtkSmartPointer<vtkPolyData> surface = straightSurfaceOf(cells);
  turnOutward(cells, surface, counts);
  if (curved)
  {
    const OuterPolygons polygons(surface);
    DividedSurface divided(curved, divisionsFor(curved, polygons, keepsPoints, counts));
    for (vtkIdType i = 0; i < polygons.count(); ++i)
    {
      divided.add(polygons.owner(i), polygons.points(i));
    }
    return divided.take();
  }
  surface->GetCellData()->RemoveArray("vtkOriginalCellIds");
  surface->GetPointData()->RemoveArray("vtkOriginalPointIds");
  return surface;
}

} // namespace winding
