#include "private/BlockSurface.h"

#include "base/Executor.h"
#include "private/VtkVersions.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPoints.h"

namespace winding
{

bool VoxelSides::isInside(int i, int j, int k) const
{
  const int* n = dimensions;
  const bool isThere = i >= 0 && j >= 0 && k >= 0 && i < n[0] && j < n[1] && k < n[2];
  return isThere && inside[static_cast<std::size_t>(this->number(i, j, k))] != 0;
}

BlockSurface::BlockSurface(
  const VoxelSides& sides, vtkImageData* image, vtkPoints* points, vtkCellArray* quads)
  : sides_(sides)
  , image_(image)
  , points_(points)
  , quads_(quads)
{
  const double* spacing = image->GetSpacing();
  isMirrored_ =
    image->GetDirectionMatrix()->Determinant() * spacing[0] * spacing[1] * spacing[2] < 0;
  const int* n = sides.dimensions;
  const std::size_t corners =
    (static_cast<std::size_t>(n[0]) + 1) * (static_cast<std::size_t>(n[1]) + 1);
  lower_.assign(corners, -1);
  upper_.assign(corners, -1);
}

vtkIdType BlockSurface::countFaces(const VoxelSides& sides)
{
  const int* n = sides.dimensions;
  const std::vector<unsigned char> outside(static_cast<std::size_t>(n[0]), 0);
  const auto row = [&](int j, int k)
  {
    const bool isThere = j >= 0 && k >= 0 && j < n[1] && k < n[2];
    return isThere ? sides.inside.data() + sides.number(0, j, k) : outside.data();
  };
  const auto countChanges = [](const unsigned char* a, const unsigned char* b, int count)
  {
    vtkIdType changes = 0;
    for (int i = 0; i < count; ++i)
    {
      changes += a[i] != b[i];
    }
    return changes;
  };
  vtkIdType faces = 0;
  for (int k = 0; k <= n[2]; ++k)
  {
    for (int j = 0; j <= n[1]; ++j)
    {
      const unsigned char* here = row(j, k);
      faces += here[0] + here[n[0] - 1] + countChanges(here, here + 1, n[0] - 1);
      faces += countChanges(here, row(j - 1, k), n[0]) + countChanges(here, row(j, k - 1), n[0]);
    }
  }
  return faces;
}

double BlockSurface::bytesOf(vtkIdType faces)
{
  // A face has four ids of corners, its place in the list of those, and its voxel. There are about
  // as many corners as faces.
  constexpr double perFace = 6 * sizeof(vtkIdType) + 3 * sizeof(double);
  return perFace * static_cast<double>(faces);
}

void BlockSurface::build(vtkAlgorithm* filter)
{
  const int* n = sides_.dimensions;
  const vtkIdType faces = countFaces(sides_);
  quads_->AllocateExact(faces, 4 * faces);
  reserve(voxels_.Get(), faces);
  reserve(points_, faces + 2);
  for (int k = 0; k <= n[2]; ++k)
  {
    filter->UpdateProgress(static_cast<double>(k) / (n[2] + 1));
    if (isAborted(filter))
    {
      throw Interrupted();
    }
    // Layer k has the faces across z at its bottom, and the upright faces of its voxels.
    for (int j = 0; j <= n[1]; ++j)
    {
      for (int i = 0; i <= n[0]; ++i)
      {
        this->addFacesOf(i, j, k);
      }
    }
    lower_.swap(upper_);
    upper_.assign(upper_.size(), -1);
  }
  points_->Squeeze();
}

/// Adds the three faces on the low sides of voxel (i, j, k).
void BlockSurface::addFacesOf(int i, int j, int k)
{
  const bool here = sides_.isInside(i, j, k);
  const bool left = sides_.isInside(i - 1, j, k);
  const bool front = sides_.isInside(i, j - 1, k);
  const bool below = sides_.isInside(i, j, k - 1);
  const vtkIdType voxel = sides_.number(i, j, k);
  if (here != left)
  {
    voxels_->InsertNextId(here ? voxel : sides_.number(i - 1, j, k));
    this->addQuad(left, {this->corner(i, j, k, 0), this->corner(i, j + 1, k, 0),
                          this->corner(i, j + 1, k, 1), this->corner(i, j, k, 1)});
  }
  if (here != front)
  {
    voxels_->InsertNextId(here ? voxel : sides_.number(i, j - 1, k));
    this->addQuad(front, {this->corner(i, j, k, 0), this->corner(i, j, k, 1),
                           this->corner(i + 1, j, k, 1), this->corner(i + 1, j, k, 0)});
  }
  if (here != below)
  {
    voxels_->InsertNextId(here ? voxel : sides_.number(i, j, k - 1));
    this->addQuad(below, {this->corner(i, j, k, 0), this->corner(i + 1, j, k, 0),
                           this->corner(i + 1, j + 1, k, 0), this->corner(i, j + 1, k, 0)});
  }
}

/// Adds a quad whose corners run counter-clockwise seen from the high side, where the face looks if
/// the voxel on its low side is the inside one.
void BlockSurface::addQuad(bool lowSideIsInside, std::array<vtkIdType, 4> corners)
{
  if (lowSideIsInside == isMirrored_)
  {
    std::swap(corners[1], corners[3]);
  }
  quads_->InsertNextCell(4, corners.data());
}

/// The id of the corner (i, j, k + up), which is made when it is first asked for.
vtkIdType BlockSurface::corner(int i, int j, int k, int up)
{
  std::vector<vtkIdType>& layer = up ? upper_ : lower_;
  const std::size_t width = static_cast<std::size_t>(sides_.dimensions[0]) + 1;
  vtkIdType& known = layer[static_cast<std::size_t>(j) * width + static_cast<std::size_t>(i)];
  if (known < 0)
  {
    double position[3];
    const double* first = sides_.firstIndex;
    image_->TransformContinuousIndexToPhysicalPoint(
      first[0] + i, first[1] + j, first[2] + k + up, position);
    known = points_->InsertNextPoint(position);
  }
  return known;
}

} // namespace winding
