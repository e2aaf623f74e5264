#pragma once

#include "base/Executor.h"
#include "level/DualMesh.h"
#include "level/SharpVertices.h"

#include "vtkSmartPointer.h"

#include <cstdint>
#include <vector>

class vtkCellArray;
class vtkFloatArray;
class vtkPoints;

namespace winding
{

/**
 * The surface between the inside and the outside samples of a grid, with sharp edges and corners:
 * the quads of a DualMesh, between SharpVertices, which face outward.
 *
 * A quad begins with a corner of the diagonal that it is to be cut along (QuadSplit.h), so that
 * whoever cuts it into a fan of triangles does so along the better one. Where neither diagonal is
 * good there are four triangles instead, around a vertex of their own on the edge of the grid;
 * these vertices come after all others, in the order of the edges.
 *
 * The result is the same for every executor; every function that takes one throws Interrupted.
 */
class SharpContour
{
public:
  /// Keeps references. The roots must be done. areTriangles: whether to cut all quads.
  SharpContour(const Field& field, const Grid& grid, const LevelEdges& edges,
    const LevelRoots& roots, bool areTriangles, Executor& executor);

  vtkSmartPointer<vtkPoints> points(int type, Executor& executor) const;

  vtkSmartPointer<vtkCellArray> polygons(Executor& executor) const;

  /// Unit normals of the polygons, which point outward; 0 for a polygon without area.
  vtkSmartPointer<vtkFloatArray> normals(Executor& executor) const;

private:
  /// The numbers of what comes before a block of edges.
  struct Start
  {
    std::size_t polygon = 0, corner = 0, fan = 0;
  };

  template <class Visit> void forPolygons(std::size_t block, const Visit& visit) const;
  std::size_t blocks() const { return starts_.size() - 1; }
  Eigen::Vector3d placeOf(std::size_t vertex) const;

  const Grid& grid_;
  const LevelEdges& edges_;
  bool areTriangles_;
  DualMesh mesh_;
  SharpVertices vertices_;
  std::vector<QuadSplit> splits_;   ///< by edge
  std::vector<std::uint32_t> fans_; ///< edges with a vertex of their own, ascending
  std::vector<Start> starts_;       ///< by block of edges, and of all
};

} // namespace winding
