#pragma once

#include "EdgeCrossings.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkCellArray;
class vtkFloatArray;
class vtkPoints;
class vtkUnsignedCharArray;

namespace winding
{

/**
 * The triangles between the inside and the outside samples of a grid, by marching cubes: every vertex
 * lies on an edge between two samples, of which one is inside. Triangles face outward. The same for
 * every executor; all that takes one throws Interrupted.
 *
 * VTK's own filters look at every cell of a grid. Here the vertices are found by comparing rows, and
 * only cells with vertices are looked at.
 */
class GridContour
{
public:
  /// inside: 1 or 0 for every sample of the grid. withBorder: as if there were samples around the grid,
  /// all of them outside; without, it has two or more along each axis.
  GridContour(const Grid& grid, vtkUnsignedCharArray* inside, bool withBorder, Executor& executor);

  /// The edges of the grid that have a vertex, each one.
  std::vector<GridEdge> edges() const;

  /// The vertices, at these fractions of their edges: 0 at the first sample, 1 at the second, but kept a
  /// little away from both so that no two vertices coincide. Those of the border lie half a voxel
  /// outside.
  vtkSmartPointer<vtkPoints> place(
    const std::vector<double>& fractions, int type, Executor& executor) const;

  vtkCellArray* triangles() const { return triangles_; }

  /// Unit normals of placed vertices: the mean of the triangles around, weighted by area; 0 0 0 where
  /// these cancel.
  vtkSmartPointer<vtkFloatArray> normalsOf(vtkPoints* points, Executor& executor) const;

private:
  bool isAtBorder(const GridEdge& vertex) const;

  Grid grid_;
  std::vector<GridEdge> vertices_; ///< those of the border, too
  vtkSmartPointer<vtkCellArray> triangles_;
};

} // namespace winding
