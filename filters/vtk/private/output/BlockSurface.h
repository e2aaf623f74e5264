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

/// The voxels of an image, each of which has a label, 0 outside: unsigned char where they are only
/// inside (1) or not, unsigned short where they are of several solids.
template <class Label> struct VoxelSides
{
  std::vector<Label> labels; ///< along x first
  int dimensions[3];
  /// The continuous index of the image at which voxel (0, 0, 0) begins.
  double firstIndex[3];

  vtkIdType number(int i, int j, int k) const
  {
    return (static_cast<vtkIdType>(k) * dimensions[1] + j) * dimensions[0] + i;
  }

  /// The label of voxel (i, j, k), 0 if it is not there.
  Label label(int i, int j, int k) const;
};

/**
 * The faces between voxels of different labels, as quads. A face at the outside looks there, and
 * one between two solids looks away from the smaller label. A voxel at the border of the image has
 * nothing but outside beyond that border, so that the surface of each label is closed.
 */
template <class Label> class BlockSurface
{
public:
  /// Keeps references to all of them.
  BlockSurface(
    const VoxelSides<Label>& sides, vtkImageData* image, vtkPoints* points, vtkCellArray* quads);

  /// The number of quads that build() will make.
  static vtkIdType countFaces(const VoxelSides<Label>& sides);

  /// The memory that so many quads take, their corners, voxels and labels included, in bytes.
  static double bytesOf(vtkIdType faces);

  /// Adds the quads and their corners. Throws Interrupted if the filter is aborted.
  void build(vtkAlgorithm* filter);

  /// The voxel that each quad looks away from, which is not outside.
  vtkIdList* voxels() const { return voxels_; }

  /// The label that each quad looks to.
  const std::vector<Label>& seenLabels() const { return seenLabels_; }

private:
  void addFacesOf(int i, int j, int k);
  bool addSides(Label low, Label high, vtkIdType lowVoxel, vtkIdType highVoxel);
  void addQuad(bool looksUp, std::array<vtkIdType, 4> corners);
  vtkIdType corner(int i, int j, int k, int up);

  const VoxelSides<Label>& sides_;
  vtkImageData* image_;
  vtkPoints* points_;
  vtkCellArray* quads_;
  bool isMirrored_; ///< whether the image's axes are, which turns all faces round
  std::vector<vtkIdType> lower_, upper_; ///< ids of the corners in two layers; −1 for none yet
  vtkNew<vtkIdList> voxels_;
  std::vector<Label> seenLabels_;
};

} // namespace winding
