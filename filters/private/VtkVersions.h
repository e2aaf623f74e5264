#pragma once

#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 0)
#include "vtkMarchingCellsContourCases.h"
#else
#include "vtkMarchingCubesTriangleCases.h"
#endif

/**
 * @file
 * The differences between the VTK versions that this project builds with (9.1 and newer) have their
 * place here.
 */
namespace winding
{

/// Whether a filter was told to stop. vtkAlgorithm::CheckAbort came between VTK 9.2 and 9.3; where
/// it exists, it also asks the filters downstream.
template <class Algorithm> auto isAborted(Algorithm* filter, int) -> decltype(filter->CheckAbort())
{
  return filter->CheckAbort();
}

template <class Algorithm> bool isAborted(Algorithm* filter, long)
{
  return filter->GetAbortExecute() != 0;
}

template <class Algorithm> bool isAborted(Algorithm* filter)
{
  return isAborted(filter, 0) || filter->GetAbortExecute() != 0;
}

/// The triangles of marching cubes. Corners and edges are numbered as those of vtkHexahedron.
class MarchingCubesTable
{
public:
  /// The edges on which the corners of triangles lie, three for each triangle, and −1 after the
  /// last. Bit i of the index says whether corner i of the cube is inside.
  const int* operator[](int cornersInside) const
  {
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 0)
    return cases_[cornersInside];
#else
    return cases_[cornersInside].edges;
#endif
  }

private:
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 0)
  const vtkMarchingCellsContourCases::HexahedronCase* cases_ =
    vtkMarchingCellsContourCases::GetHexahedronCases();
#else
  const vtkMarchingCubesTriangleCases* cases_ = vtkMarchingCubesTriangleCases::GetCases();
#endif
};

} // namespace winding
