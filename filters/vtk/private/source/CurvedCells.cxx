// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/CurvedCells.h"

#include "private/source/CellTypes.h"
#include "private/source/OuterPolygons.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace winding
{

namespace
{

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
      // Quadratic polygons are not divided: their edges' middles are corners of the surface.
      const bool isDivided = static_cast<std::size_t>(cornersOf(generic_)) == corners.size();
      return isDivided ? generic_.Get() : nullptr;
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
  vtkUnstructuredGrid* mesh, const OuterPolygons& polygons, bool keepsPoints, std::size_t& flat)
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
  flat = static_cast<std::size_t>(std::count_if(bulges.begin(), bulges.end(),
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
      double point[3];
      mesh_->GetPoint(node, point);
      id = points_->InsertNextPoint(point);
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
    const vtkIdType corners = cornersOf(face);
    if (j == 0)
    {
      return this->edgePointId(face, ids[0], ids[1], i, i, j);
    }
    if (i == 0)
    {
      return this->edgePointId(face, ids[0], ids[corners - 1], j, i, j);
    }
    if (corners == 3 ? i + j == n : i == n)
    {
      return this->edgePointId(face, ids[1], ids[2], j, i, j);
    }
    if (j == n)
    {
      return this->edgePointId(face, ids[3], ids[2], i, i, j);
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

bool hasCurvedCells(vtkUnstructuredGrid* mesh)
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

vtkSmartPointer<vtkPolyData> dividedSurface(
  vtkUnstructuredGrid* mesh, const OuterPolygons& polygons, bool keepsPoints, std::size_t& flat)
{
  DividedSurface divided(mesh, divisionsFor(mesh, polygons, keepsPoints, flat));
  for (vtkIdType i = 0; i < polygons.count(); ++i)
  {
    divided.add(polygons.owner(i), polygons.points(i));
  }
  return divided.take();
}

} // namespace winding
