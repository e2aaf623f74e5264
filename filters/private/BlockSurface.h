#pragma once

#include "vtkIdList.h"
#include "vtkNew.h"

#include <array>
#include <vector>

class vtkAlgorithm;
class vtkCellArray;
class vtkImageData;
class vtkPoints;

namespace winding
{

/// The voxels of an image, each of which is inside or not.
struct VoxelSides
{
  std::vector<unsigned char> inside; ///< 1 inside and 0 outside, along x first
  int dimensions[3];
  /// The continuous index of the image at which voxel (0, 0, 0) begins.
  double firstIndex[3];

  vtkIdType number(int i, int j, int k) const
  {
    return (static_cast<vtkIdType>(k) * dimensions[1] + j) * dimensions[0] + i;
  }

  /// Whether voxel (i, j, k) is there and inside.
  bool isInside(int i, int j, int k) const;
};

/**
 * The faces between inside and outside voxels, as quads that look outward. A voxel at the border of
 * the image has nothing but outside beyond that border, so that the surface is closed.
 */
class BlockSurface
{
public:
  /// Keeps references to all of them.
  BlockSurface(
    const VoxelSides& sides, vtkImageData* image, vtkPoints* points, vtkCellArray* quads);

  /// The number of quads that build() will make.
  static vtkIdType countFaces(const VoxelSides& sides);

  /// The memory that so many quads take, their corners and voxels included, in bytes.
  static double bytesOf(vtkIdType faces);

  /// Adds the quads and their corners. Throws Interrupted if the filter is aborted.
  void build(vtkAlgorithm* filter);

  /// The inside voxel of each quad.
  vtkIdList* voxels() const { return voxels_; }

private:
  void addFacesOf(int i, int j, int k);
  void addQuad(bool lowSideIsInside, std::array<vtkIdType, 4> corners);
  vtkIdType corner(int i, int j, int k, int up);

  const VoxelSides& sides_;
  vtkImageData* image_;
  vtkPoints* points_;
  vtkCellArray* quads_;
  bool isMirrored_; ///< whether the image's axes are, which turns all faces round
  std::vector<vtkIdType> lower_, upper_; ///< ids of the corners in two layers; −1 for none yet
  vtkNew<vtkIdList> voxels_;
};

} // namespace winding
