#pragma once

#include "base/Executor.h"
#include "level/LevelEdges.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkCellArray;
class vtkFloatArray;
class vtkPoints;

namespace winding
{

/**
 * The triangles between the inside and the outside samples of a grid, by marching cubes: every edge
 * between two samples of which one is inside has a vertex. Triangles face outward. The result is
 * the same for every executor; every function that takes one throws Interrupted.
 *
 * VTK's own filters look at every cell of a grid. Here only cells with vertices are looked at.
 */
class GridContour
{
public:
  /// Keeps references. The grid and its border together have two samples or more along each axis.
  GridContour(const Grid& grid, const LevelEdges& edges, Executor& executor);

  /// The vertices, in the order of the edges, at these fractions of them: 0 at the first sample, 1
  /// at the second, but kept a little away from both so that no two vertices coincide.
  vtkSmartPointer<vtkPoints> place(
    const std::vector<double>& fractions, int type, Executor& executor) const;

  vtkCellArray* triangles() const { return triangles_; }

  /// Unit normals of placed vertices, which point outward: the known normals, turned if need be. A
  /// vertex whose known normal is 0 gets the mean of the triangles around it, weighted by area, or
  /// 0 where those cancel.
  vtkSmartPointer<vtkFloatArray> normalsOf(
    vtkPoints* points, const std::vector<Eigen::Vector3f>& known, Executor& executor) const;

private:
  std::vector<Eigen::Vector3d> areasAround(vtkPoints* points, Executor& executor) const;
  template <class Real>
  void addAreas(
    const Real* coordinates, std::vector<Eigen::Vector3d>& sums, Executor& executor) const;

  const Grid& grid_;
  const LevelEdges& edges_;
  std::vector<vtkIdType> layerStarts_; ///< first triangle between each layer and the next
  vtkSmartPointer<vtkCellArray> triangles_;
};

} // namespace winding
