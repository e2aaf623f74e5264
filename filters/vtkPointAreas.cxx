#include "vtkPointAreas.h"

#include "base/Concatenation.h"
#include "base/Views.h"
#include "cloud/NormalEstimation.h"
#include "cloud/PointAreas.h"
#include "private/ContentHash.h"
#include "private/ErrorReports.h"
#include "private/InputViews.h"
#include "private/PropertyChecks.h"
#include "private/Ranks.h"
#include "private/SmpExecutor.h"
#include "private/SourceField.h"
#include "private/SourceMemory.h"
#include "private/SourceProperties.h"
#include "source/Sanitize.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPointAreas);

namespace
{

/// Calls work(leaf, iterator) for the leaves of composite data.
template <class Work> void forEachLeaf(vtkCompositeDataSet* composite, const Work& work)
{
  auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    work(iterator->GetCurrentDataObject(), iterator);
  }
}

/// Shares all arrays, but no data set, so that arrays can be added.
void copyShallowly(vtkDataObject* input, vtkDataObject* output)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    output->ShallowCopy(input);
    return;
  }
  auto* copy = vtkCompositeDataSet::SafeDownCast(output);
  copy->CopyStructure(composite);
  copy->GetFieldData()->PassData(composite->GetFieldData());
  forEachLeaf(composite,
    [copy](vtkDataObject* leaf, vtkCompositeDataIterator* iterator)
    {
      auto fresh = vtkSmartPointer<vtkDataObject>::Take(leaf->NewInstance());
      fresh->ShallowCopy(leaf);
      copy->SetDataSet(iterator, fresh);
    });
}

std::vector<vtkPointSet*> pointSetsOf(vtkDataObject* data)
{
  std::vector<vtkPointSet*> pointSets;
  const auto add = [&pointSets](vtkDataObject* leaf, vtkCompositeDataIterator* = nullptr)
  {
    if (auto* pointSet = vtkPointSet::SafeDownCast(leaf))
    {
      pointSets.push_back(pointSet);
    }
  };
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    forEachLeaf(composite, add);
  }
  else
  {
    add(data);
  }
  return pointSets;
}

/**
 * The points of some data sets under one range of numbers. While it lives, the data sets have these
 * numbers as point data. Point data comes along when VTK makes outer surfaces or leaves out ghosts,
 * and so tells where a point comes from.
 */
class NumberedPoints
{
public:
  explicit NumberedPoints(const std::vector<vtkPointSet*>& pointSets)
    : pointSets_(pointSets)
    , points_(pointSets,
        [](vtkPointSet* set) { return static_cast<std::size_t>(set->GetNumberOfPoints()); })
  {
    for (std::size_t i = 0; i < pointSets_.size(); ++i)
    {
      vtkNew<vtkIdTypeArray> numbers;
      numbers->SetName(name);
      numbers->SetNumberOfTuples(pointSets_[i]->GetNumberOfPoints());
      vtkIdType* first = numbers->GetPointer(0);
      std::iota(first, first + numbers->GetNumberOfTuples(), static_cast<vtkIdType>(start(i)));
      pointSets_[i]->GetPointData()->AddArray(numbers);
    }
  }
  ~NumberedPoints()
  {
    for (vtkPointSet* set : pointSets_)
    {
      set->GetPointData()->RemoveArray(name);
    }
  }

  NumberedPoints(const NumberedPoints&) = delete;
  void operator=(const NumberedPoints&) = delete;

  std::size_t size() const { return points_.size(); }
  std::size_t start(std::size_t pointSet) const { return points_.start(pointSet); }

  static const vtkIdType* numbersOf(vtkPointSet* made)
  {
    return vtkIdTypeArray::SafeDownCast(made->GetPointData()->GetArray(name))->GetPointer(0);
  }

  /// Whether a point is the one with a number: surfaces of curved cells have points of their own,
  /// with point data that is interpolated.
  bool isPoint(vtkIdType number, const Eigen::Vector3d& position) const
  {
    if (number < 0 || static_cast<std::size_t>(number) >= points_.size())
    {
      return false;
    }
    const std::size_t set = points_.viewOf(static_cast<std::size_t>(number));
    Eigen::Vector3d own;
    pointSets_[set]->GetPoint(number - static_cast<vtkIdType>(start(set)), own.data());
    return own == position;
  }

private:
  static constexpr char name[] = "vtkPointAreas number";

  std::vector<vtkPointSet*> pointSets_;
  winding::Concatenation points_;
};

struct NumberedAreas
{
  std::vector<double> areas; ///< 0 for points that none was found for
  std::size_t lost = 0;      ///< points of the cloud that are none of these
};

/// The areas of a cloud's points for the points that these come from.
NumberedAreas areasByNumber(const NumberedPoints& points, const winding::InputViews& input,
  const std::vector<winding::OrientedPointsView>& views, const double* areasOfCloud)
{
  NumberedAreas result;
  result.areas.resize(points.size());
  const double* area = areasOfCloud;
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    const vtkIdType* numbers = NumberedPoints::numbersOf(input.pointSets()[i]);
    for (std::size_t j = 0; j < views[i].positions.size(); ++j)
    {
      if (!winding::isUsable(views[i], j))
      {
        continue;
      }
      if (points.isPoint(numbers[j], views[i].positions[j]))
      {
        result.areas[static_cast<std::size_t>(numbers[j])] += *area;
      }
      else
      {
        ++result.lost;
      }
      ++area;
    }
  }
  return result;
}

/// The points of the first views that a cloud has.
std::size_t usablePoints(const std::vector<winding::OrientedPointsView>& views, int count)
{
  std::size_t points = 0;
  for (int i = 0; i < count; ++i)
  {
    const winding::OrientedPointsView& view = views[static_cast<std::size_t>(i)];
    for (std::size_t j = 0; j < view.positions.size(); ++j)
    {
      points += winding::isUsable(view, j);
    }
  }
  return points;
}

/// One value for each point.
void addArray(const std::string& name, const double* values, vtkPointSet* pointSet)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->SetNumberOfTuples(pointSet->GetNumberOfPoints());
  std::copy_n(values, array->GetNumberOfTuples(), array->GetPointer(0));
  pointSet->GetPointData()->AddArray(array);
}

} // namespace

vtkPointAreas::vtkPointAreas()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
  this->SetResultArrayName("Area");
}

vtkPointAreas::~vtkPointAreas()
{
  this->SetNormalsArray(nullptr);
  this->SetResultArrayName(nullptr);
}

void vtkPointAreas::SetController(vtkMultiProcessController* controller)
{
  if (controller != this->Controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkPointAreas::GetController() const
{
  return this->Controller;
}

int vtkPointAreas::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkPointAreas::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* output = vtkDataObject::GetData(outputs);
  this->TotalArea = 0;
  const winding::Outcome outcome =
    winding::reportErrors(this, "there is not enough memory for the areas of so many points",
      [&]()
      {
        winding::Ranks ranks(this->Controller);
        ranks.meet();
        ranks.agree(
          [&]
          {
            copyShallowly(vtkDataObject::GetData(inputs[0]), output);
            this->AddAreas(output, ranks);
            return true;
          });
      });
  if (outcome != winding::Outcome::done)
  {
    output->Initialize();
  }
  return 1;
}

void vtkPointAreas::AddAreas(vtkDataObject* data, winding::Ranks& ranks)
{
  winding::checkChoice("PointAreaMethod", this->PointAreaMethod, {"VORONOI", "MESH", "CONSTANT"});
  winding::checkCloudProperties(*this);
  winding::checkRange("NumberOfThreads", this->NumberOfThreads, 0);
  const std::vector<vtkPointSet*> pointSets = pointSetsOf(data);
  const NumberedPoints points(pointSets);
  winding::InputOptions options;
  options.asPoints = true;
  options.normalsArray = winding::textOf(this->NormalsArray);
  options.estimateNormals = this->EstimateNormals != 0;
  options.areas =
    this->PointAreaMethod == MESH ? winding::AreaSource::mesh : winding::AreaSource::none;
  winding::SourceOptions properties;
  properties.input = options;
  properties.distribution = winding::sourceDistribution(this->SourceDistribution);
  properties.field.neighbors = this->NumberOfNeighbors;
  properties.field.pointArea = this->PointArea;
  ranks.requireSame(
    [&]
    {
      winding::ContentHash hash;
      hash.addValue(winding::hashOf(properties));
      hash.addValue(this->PointAreaMethod);
      hash.addText(winding::textOf(this->ResultArrayName));
      return hash.value();
    });
  winding::SmpExecutor executor(this, this->NumberOfThreads);
  winding::InputViews input(data, options, &executor);
  input.compare(ranks, properties.distribution);
  winding::refuseHugeSource(input, winding::bytesOfAreas, "the areas", ranks);
  const std::vector<winding::OrientedPointsView> own = input.orientedPoints();
  input.gather(ranks);
  const std::vector<winding::OrientedPointsView> all =
    input.isGathered() ? input.orientedPoints() : own;
  winding::PointCloud cloud = winding::sanitize(all, executor);
  this->ChooseAreas(cloud, executor);

  const std::size_t before = input.isGathered() ? usablePoints(all, ranks.rank()) : 0;
  const auto [areas, lost] = areasByNumber(points, input, own, cloud.areas.data() + before);
  const std::string name = winding::textOf(this->ResultArrayName);
  for (std::size_t i = 0; i < pointSets.size(); ++i)
  {
    addArray(name.empty() ? "Area" : name, areas.data() + points.start(i), pointSets[i]);
  }
  this->TotalArea = std::accumulate(areas.cbegin(), areas.cend(), 0.0);
  if (cloud.dropped() > 0)
  {
    vtkWarningMacro(<< cloud.dropped() << " of " << cloud.inputPoints
                    << " points are unusable and have area 0 (" << cloud.nonFinitePoints
                    << " with NaN or infinite values, " << cloud.zeroNormalPoints
                    << " with normals of length 0)");
  }
  if (lost > 0)
  {
    vtkWarningMacro(<< "the outer surface of curved cells has " << lost
                    << " points that the input does not have, and their areas are left out; "
                       "tessellate the cells first");
  }
  if (this->TotalArea == 0 && !areas.empty())
  {
    vtkWarningMacro(
      << "set a point area (Point Area): points at one place tell none, so theirs are 0");
  }
}

void vtkPointAreas::ChooseAreas(winding::PointCloud& cloud, winding::Executor& executor) const
{
  const bool isConstant = this->PointAreaMethod == CONSTANT;
  if (this->PointAreaMethod == MESH)
  {
    return; // as they came in
  }
  const bool needsNormals = !isConstant || this->PointArea == 0;
  if (needsNormals && cloud.normals.empty())
  {
    cloud.normals = winding::estimateNormals(cloud.positions, this->NumberOfNeighbors, executor);
  }
  const winding::PointAreaMethod method =
    isConstant ? winding::PointAreaMethod::constant : winding::PointAreaMethod::voronoi;
  cloud.areas =
    winding::pointAreas(cloud, method, this->PointArea, this->NumberOfNeighbors, executor);
}

void vtkPointAreas::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PointAreaMethod: " << this->PointAreaMethod << "\n";
  os << indent << "NumberOfNeighbors: " << this->NumberOfNeighbors << "\n";
  os << indent << "PointArea: " << this->PointArea << "\n";
  os << indent << "NormalsArray: " << winding::textOf(this->NormalsArray) << "\n";
  os << indent << "EstimateNormals: " << this->EstimateNormals << "\n";
  os << indent << "ResultArrayName: " << winding::textOf(this->ResultArrayName) << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "Controller: " << this->Controller.Get() << "\n";
  os << indent << "SourceDistribution: " << this->SourceDistribution << "\n";
  os << indent << "TotalArea: " << this->TotalArea << "\n";
}
