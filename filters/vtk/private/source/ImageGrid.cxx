#include "private/source/ImageGrid.h"

#include "base/Refusal.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"

namespace winding
{

std::optional<Grid> gridOfImage(vtkDataSet* data, bool atCells)
{
  auto* image = vtkImageData::SafeDownCast(data);
  if (!image || image->GetNumberOfPoints() == 0 || !image->GetDirectionMatrix()->IsIdentity())
  {
    return std::nullopt;
  }
  const int* const extent = image->GetExtent();
  Grid grid;
  grid.spacing = Eigen::Vector3d(image->GetSpacing());
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.firstSample[axis] = image->GetOrigin()[axis] + extent[2 * axis] * grid.spacing[axis];
    grid.dimensions[axis] = extent[2 * axis + 1] - extent[2 * axis] + 1;
    if (atCells && grid.dimensions[axis] > 1)
    {
      grid.firstSample[axis] += 0.5 * grid.spacing[axis];
      --grid.dimensions[axis];
    }
  }
  // A layer of samples has no spacing across, whatever an image says.
  const Eigen::Array<bool, 3, 1> isLayer = grid.dimensions.array() == 1;
  const double widest = isLayer.select(0, grid.spacing).maxCoeff();
  grid.spacing = isLayer.select(widest > 0 ? widest : 1, grid.spacing);
  try
  {
    checkGrid(grid);
  }
  catch (const Refusal&)
  {
    return std::nullopt;
  }
  return grid;
}

} // namespace winding
