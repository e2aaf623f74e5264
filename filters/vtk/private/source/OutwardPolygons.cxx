// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/OutwardPolygons.h"

#include "private/source/CellTypes.h"
#include "private/source/OuterPolygons.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace winding
{

namespace
{

/// The faces of a cell, by the ids of their corners in the order around them. Faces of fewer than
/// three corners, which polyhedra may have, are left out.
using CellFaces = std::vector<std::vector<vtkIdType>>;

CellFaces cornersOfFaces(vtkCell* cell)
{
  CellFaces faces;
  for (int i = 0; i < cell->GetNumberOfFaces(); ++i)
  {
    vtkCell* face = cell->GetFace(i);
    if (cornersOf(face) < 3)
    {
      continue;
    }
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
  FaceSenses(vtkPointSet* mesh, const OuterPolygons& polygons)
    : mesh_(mesh)
    , polygons_(polygons)
    , ofCells_(static_cast<std::size_t>(mesh->GetNumberOfCells()), Sense::unknown)
  {
  }

  /// Returns whether a polygon is to be turned.
  bool isInward(vtkIdType polygon)
  {
    const vtkIdType cell = polygons_.owner(polygon);
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
    return (sense == Sense::inward) != (!isInOrder && this->isReversed(polygons_.points(polygon)));
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
  const OuterPolygons& polygons_;
  std::vector<Sense> ofCells_;
  vtkIdType last_ = -1; ///< the cell that was looked at last
  CellFaces faces_;     ///< of that cell, oriented like each other
  vtkNew<vtkGenericCell> generic_;
};

} // namespace

std::size_t turnOutward(vtkPointSet* mesh, vtkPolyData* surface)
{
  const OuterPolygons polygons(surface);
  FaceSenses senses(mesh, polygons);
  std::size_t cells = 0;
  std::vector<char> isTurned(static_cast<std::size_t>(mesh->GetNumberOfCells()), 0);
  for (vtkIdType i = 0; i < polygons.count(); ++i)
  {
    if (senses.isInward(i))
    {
      surface->GetPolys()->ReverseCellAtId(i);
      cells += !std::exchange(isTurned[static_cast<std::size_t>(polygons.owner(i))], 1);
    }
  }
  return cells;
}

} // namespace winding
