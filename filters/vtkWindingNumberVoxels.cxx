#include "vtkWindingNumberVoxels.h"

#include "base/Executor.h"
#include "base/InsideRule.h"
#include "base/Refusal.h"
#include "private/ErrorReports.h"
#include "private/InsideOutAdvice.h"
#include "private/SourceParts.h"
#include "private/SourceProperties.h"
#include "private/VtkVersions.h"

#include "vtkArrayDispatch.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArrayRange.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace
{

struct Classify
{
  template <class Array>
  void operator()(Array* values, winding::InsideRule rule, double threshold,
    std::vector<unsigned char>& inside) const
  {
    const auto range = vtk::DataArrayValueRange<1>(values);
    inside.reserve(static_cast<std::size_t>(range.size()));
    for (const auto value : range)
    {
      inside.push_back(winding::isInside(static_cast<double>(value), rule, threshold));
    }
  }
};

/// 1 for each value that is inside, and 0 for any other.
std::vector<unsigned char> classify(
  vtkDataArray* values, winding::InsideRule rule, double threshold)
{
  std::vector<unsigned char> inside;
  if (!vtkArrayDispatch::Dispatch::Execute(values, Classify{}, rule, threshold, inside))
  {
    Classify{}(values, rule, threshold, inside);
  }
  return inside;
}

bool isAny(const std::vector<unsigned char>& inside)
{
  return std::find(inside.begin(), inside.end(), 1) != inside.end();
}

/**
 * Walks the corners of the voxels layer by layer, from low z to high z, and makes a quad for every
 * face between inside and outside. Corner ids are needed for two layers of corners at a time only.
 */
class BlockSurface
{
public:
  /// Voxel (0, 0, 0) begins at this continuous index of the image.
  BlockSurface(const std::vector<unsigned char>& inside, const int* dimensions, vtkImageData* image,
    const double* firstIndex, vtkPoints* points, vtkCellArray* quads)
    : inside_(inside)
    , n_{dimensions[0], dimensions[1], dimensions[2]}
    , image_(image)
    , firstIndex_{firstIndex[0], firstIndex[1], firstIndex[2]}
    , points_(points)
    , quads_(quads)
  {
    // An image whose axes are mirrored turns all faces inside out.
    const double* spacing = image->GetSpacing();
    mirrored_ =
      image->GetDirectionMatrix()->Determinant() * spacing[0] * spacing[1] * spacing[2] < 0;
    const std::size_t corners =
      static_cast<std::size_t>(n_[0] + 1) * static_cast<std::size_t>(n_[1] + 1);
    lower_.assign(corners, -1);
    upper_.assign(corners, -1);
  }

  /// The voxels that the quads are faces of.
  vtkIdList* voxels() const { return voxels_; }

  /// Throws Interrupted if the filter is aborted.
  void build(vtkAlgorithm* filter)
  {
    for (int k = 0; k <= n_[2]; ++k)
    {
      filter->UpdateProgress(static_cast<double>(k) / (n_[2] + 1));
      if (winding::isAborted(filter))
      {
        throw winding::Interrupted();
      }
      // Layer k: the faces across z at its bottom, and the upright faces of its voxels.
      for (int j = 0; j <= n_[1]; ++j)
      {
        for (int i = 0; i <= n_[0]; ++i)
        {
          this->facesAt(i, j, k);
        }
      }
      lower_.swap(upper_);
      upper_.assign(upper_.size(), -1);
    }
  }

private:
  bool isInside(int i, int j, int k) const
  {
    if (i < 0 || j < 0 || k < 0 || i >= n_[0] || j >= n_[1] || k >= n_[2])
    {
      return false;
    }
    return inside_[static_cast<std::size_t>(this->number(i, j, k))] != 0;
  }

  vtkIdType number(int i, int j, int k) const
  {
    return (static_cast<vtkIdType>(k) * n_[1] + j) * n_[0] + i;
  }

  /// The three faces on the low sides of voxel (i, j, k).
  void facesAt(int i, int j, int k)
  {
    const bool here = this->isInside(i, j, k);
    const bool left = this->isInside(i - 1, j, k);
    const bool front = this->isInside(i, j - 1, k);
    const bool below = this->isInside(i, j, k - 1);
    const vtkIdType voxel = this->number(i, j, k);
    if (here != left)
    {
      voxels_->InsertNextId(here ? voxel : this->number(i - 1, j, k));
      this->addQuad(left, {this->id(i, j, k, 0), this->id(i, j + 1, k, 0), this->id(i, j + 1, k, 1),
                            this->id(i, j, k, 1)});
    }
    if (here != front)
    {
      voxels_->InsertNextId(here ? voxel : this->number(i, j - 1, k));
      this->addQuad(front, {this->id(i, j, k, 0), this->id(i, j, k, 1), this->id(i + 1, j, k, 1),
                             this->id(i + 1, j, k, 0)});
    }
    if (here != below)
    {
      voxels_->InsertNextId(here ? voxel : this->number(i, j, k - 1));
      this->addQuad(below, {this->id(i, j, k, 0), this->id(i + 1, j, k, 0),
                             this->id(i + 1, j + 1, k, 0), this->id(i, j + 1, k, 0)});
    }
  }

  /// The corners run counter-clockwise seen from the high side, where the face looks if the voxel
  /// on its low side is the inside one.
  void addQuad(bool lowSideIsInside, std::array<vtkIdType, 4> corners)
  {
    if (lowSideIsInside == mirrored_)
    {
      std::swap(corners[1], corners[3]);
    }
    quads_->InsertNextCell(4, corners.data());
  }

  /// Id of the corner (i, j, k + up), made when first asked for.
  vtkIdType id(int i, int j, int k, int up)
  {
    std::vector<vtkIdType>& layer = up ? upper_ : lower_;
    vtkIdType& known = layer[static_cast<std::size_t>(j) * (n_[0] + 1) + i];
    if (known < 0)
    {
      double position[3];
      image_->TransformContinuousIndexToPhysicalPoint(
        firstIndex_[0] + i, firstIndex_[1] + j, firstIndex_[2] + k + up, position);
      known = points_->InsertNextPoint(position);
    }
    return known;
  }

  const std::vector<unsigned char>& inside_;
  int n_[3];
  vtkImageData* image_;
  double firstIndex_[3];
  bool mirrored_;
  vtkPoints* points_;
  vtkCellArray* quads_;
  std::vector<vtkIdType> lower_, upper_;
  vtkNew<vtkIdList> voxels_;
};

} // namespace

vtkStandardNewMacro(vtkWindingNumberVoxels);

vtkWindingNumberVoxels::vtkWindingNumberVoxels()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS, vtkDataSetAttributes::SCALARS);
}

int vtkWindingNumberVoxels::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkWindingNumberVoxels::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  winding::askForAll(inputs[0]->GetInformationObject(0));
  return 1;
}

int vtkWindingNumberVoxels::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  if (outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1;
  }
  const winding::Outcome outcome = winding::reportErrors(this,
    "there is not enough memory for the surface of so many voxels",
    [&]() { this->MakeSurface(vtkImageData::GetData(inputs[0]), vtkPolyData::GetData(outInfo)); });
  return outcome == winding::Outcome::done || outcome == winding::Outcome::interrupted;
}

vtkDataArray* vtkWindingNumberVoxels::FindValues(vtkImageData* image, int& association)
{
  association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* values = this->GetInputArrayToProcess(0, image, association);
  if (!values)
  {
    // ParaView asks for an array of no name where it does not know the image's arrays yet.
    values = image->GetPointData()->GetScalars();
    association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  }
  if (!values)
  {
    values = image->GetCellData()->GetScalars();
    association = vtkDataObject::FIELD_ASSOCIATION_CELLS;
  }
  if (!values || values->GetNumberOfComponents() != 1)
  {
    throw winding::Refusal(
      "the image has no scalar array to tell inside from outside by; compute one with "
      "vtkWindingNumberField or choose it by SetInputArrayToProcess");
  }
  return values;
}

void vtkWindingNumberVoxels::MakeSurface(vtkImageData* image, vtkPolyData* output)
{
  winding::checkFinite("WindingThreshold", this->WindingThreshold);
  const winding::InsideRule rule = winding::coreInsideRule(this->InsideRule);
  if (image->GetNumberOfPoints() == 0)
  {
    return;
  }
  int association;
  vtkDataArray* values = this->FindValues(image, association);
  const bool asCells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  int extent[6];
  image->GetExtent(extent);
  int dimensions[3];
  double firstIndex[3];
  vtkIdType voxelCount = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    // A flat image has a layer of cells, too.
    const int points = extent[2 * axis + 1] - extent[2 * axis] + 1;
    dimensions[axis] = asCells ? std::max(1, points - 1) : points;
    firstIndex[axis] = extent[2 * axis] - (asCells ? 0.0 : 0.5);
    voxelCount *= dimensions[axis];
  }
  if (values->GetNumberOfTuples() != voxelCount)
  {
    throw winding::Refusal("the array '" + winding::textOf(values->GetName()) + "' has " +
                           std::to_string(values->GetNumberOfTuples()) + " values for " +
                           std::to_string(voxelCount) +
                           " voxels; choose an array of the points or the cells");
  }

  const std::vector<unsigned char> inside = classify(values, rule, this->WindingThreshold);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> quads;
  if (!isAny(inside) && rule == winding::InsideRule::signedThreshold &&
      this->WindingThreshold > 0 &&
      isAny(classify(values, winding::InsideRule::absoluteThreshold, this->WindingThreshold)))
  {
    vtkWarningMacro(<< winding::insideOutAdvice("faces or normals"));
  }
  BlockSurface surface(inside, dimensions, image, firstIndex, points, quads);
  surface.build(this);
  output->SetPoints(points);
  output->SetPolys(quads);
  vtkDataSetAttributes* attributes = image->GetPointData();
  if (asCells)
  {
    attributes = image->GetCellData();
  }
  vtkDataArray* coverage = attributes->GetArray("Coverage");
  if (coverage && coverage->GetNumberOfTuples() == voxelCount)
  {
    const auto shares = vtkSmartPointer<vtkDataArray>::Take(coverage->NewInstance());
    shares->SetName(coverage->GetName());
    shares->SetNumberOfComponents(coverage->GetNumberOfComponents());
    shares->SetNumberOfTuples(surface.voxels()->GetNumberOfIds());
    coverage->GetTuples(surface.voxels(), shares);
    output->GetCellData()->SetScalars(shares);
  }
}

void vtkWindingNumberVoxels::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WindingThreshold: " << this->WindingThreshold << "\n";
  os << indent << "InsideRule: " << this->InsideRule << "\n";
}
