// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindingNumberNormals.h"

#include "base/Progress.h"
#include "base/Refusal.h"
#include "base/Views.h"
#include "cloud/OutwardNormals.h"
#include "messages/Options.h"
#include "messages/PropertyChecks.h"
#include "pipeline/ErrorReports.h"
#include "pipeline/Ranks.h"
#include "pipeline/SmpExecutor.h"
#include "private/source/ContentHash.h"
#include "private/source/InputViews.h"
#include "private/source/NumberedPoints.h"
#include "private/source/PointArrays.h"
#include "private/source/SourceField.h"
#include "private/source/SourceMemory.h"
#include "private/source/SourceProperties.h"
#include "source/Sanitize.h"
#include "tasks/Sentences.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkSmartPointer.h"
#include "vtkWindingNumberAlgorithm.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkWindingNumberNormals);

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

/// Adds one area for each point.
void addAreas(const std::string& name, const double* areas, vtkPointSet* pointSet)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->SetNumberOfTuples(pointSet->GetNumberOfPoints());
  std::copy_n(areas, array->GetNumberOfTuples(), array->GetPointer(0));
  pointSet->GetPointData()->AddArray(array);
}

/// Sets the active normals. vtkSignedDistance refuses normals that are not single.
void setNormals(const Eigen::Vector3d* normals, vtkPointSet* pointSet)
{
  vtkNew<vtkFloatArray> array;
  array->SetName("Normals");
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(pointSet->GetNumberOfPoints());
  for (vtkIdType point = 0; point < array->GetNumberOfTuples(); ++point)
  {
    array->SetTuple(point, normals[point].data());
  }
  pointSet->GetPointData()->SetNormals(array);
}

} // namespace

vtkWindingNumberNormals::vtkWindingNumberNormals()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
  this->SetResultArrayName("Area");
}

vtkWindingNumberNormals::~vtkWindingNumberNormals()
{
  this->SetNormalsArray(nullptr);
  this->SetToward(nullptr);
  this->SetResultArrayName(nullptr);
}

void vtkWindingNumberNormals::SetController(vtkMultiProcessController* controller)
{
  if (controller != this->Controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkWindingNumberNormals::GetController() const
{
  return this->Controller;
}

int vtkWindingNumberNormals::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

/// Answers the first request after a change of the pipeline, which may fail before it has data.
int vtkWindingNumberNormals::RequestDataObject(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Status = vtkWindingNumberAlgorithm::NOT_RUN;
  return this->Superclass::RequestDataObject(request, inputs, outputs);
}

int vtkWindingNumberNormals::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* output = vtkDataObject::GetData(outputs);
  this->TotalArea = 0;
  this->ClearShare = 0;
  this->NormalEstimationUsed = "";
  const winding::Outcome outcome = winding::reportErrors(this, this->NamesInMessages,
    {"not enough memory for the areas of the points"},
    [&]()
    {
      winding::Ranks ranks(this->Controller);
      ranks.barrier();
      ranks.agree(
        [&]
        {
          copyShallowly(vtkDataObject::GetData(inputs[0]), output);
          this->AddAreas(output, ranks);
        });
    });
  this->Status = static_cast<int>(outcome);
  this->ErrorCode = winding::errorCodeOf(outcome);
  if (outcome != winding::Outcome::done)
  {
    output->Initialize();
  }
  return 1;
}

void vtkWindingNumberNormals::AddAreas(vtkDataObject* data, winding::Ranks& ranks)
{
  winding::checkProperty(
    winding::Parameter::pointAreaMethod, this->PointAreaMethod, 3); // without ARRAY
  winding::coreNormalEstimation(this->NormalEstimation);
  winding::Viewpoints(winding::textOf(this->Toward));
  winding::checkCloudProperties(*this);
  winding::checkProperty(winding::Parameter::numberOfThreads, this->NumberOfThreads);
  const std::vector<vtkPointSet*> pointSets = pointSetsOf(data);
  const winding::NumberedPoints points(pointSets);
  winding::InputOptions options;
  options.asPoints = true;
  options.normalsArray = winding::textOf(this->NormalsArray);
  options.estimateNormals = this->EstimateNormals != 0;
  options.areas =
    this->PointAreaMethod == MESH ? winding::AreaSource::mesh : winding::AreaSource::none;
  winding::SourceOptions properties;
  properties.input = options;
  properties.distribution = winding::sourceDistribution(this->SourceDistribution);
  properties.field.estimateNormals = options.estimateNormals;
  properties.field.neighbors = this->NumberOfNeighbors;
  properties.field.pointArea = this->PointArea;
  properties.field.normalEstimation = winding::coreNormalEstimation(this->NormalEstimation);
  properties.field.toward = winding::textOf(this->Toward);
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
  winding::refuseHugeSource(input,
    winding::withNormals(
      winding::bytesOfAreas, winding::mayFindConsistentNormals(properties.field)),
    "the areas", ranks);
  std::vector<winding::OrientedPointsView> own = input.orientedPoints();
  input.gather(ranks);
  std::vector<winding::OrientedPointsView> all = input.isGathered() ? input.orientedPoints() : own;
  winding::PointCloud cloud = winding::sanitize(all, executor);
  const bool lookAtViewpoints = input.lookAtViewpoints();
  const bool estimates = lookAtViewpoints || cloud.normals.size() < cloud.positions.size();
  if (estimates)
  {
    if (this->EstimateNormals == 0)
    {
      throw winding::Refusal(winding::missingNormals(true));
    }
    for (std::vector<winding::OrientedPointsView>* views : {&own, &all})
    {
      for (winding::OrientedPointsView& view : *views)
      {
        view.normals = lookAtViewpoints ? view.normals : winding::VectorsView();
      }
    }
  }
  else if (this->EstimateNormals != 0 && winding::isEstimateAsked() && !cloud.positions.empty())
  {
    vtkWarningMacro(<< winding::lineOf(winding::keptNormals()));
  }
  this->FindNormalsAndAreas(cloud, estimates, executor);
  const auto getsNormals = [&](vtkPointSet* pointSet)
  {
    return estimates ||
           (this->EstimateNormals != 0 && !winding::normalsOf(pointSet, options.normalsArray));
  };
  const bool addsNormals = std::any_of(pointSets.begin(), pointSets.end(), getsNormals);

  const std::size_t before = input.isGathered() ? usablePoints(all, ranks.rank()) : 0;
  const auto [areas, normals, lost] =
    winding::findingsByNumber(points, input, own, cloud, before, addsNormals);
  const std::string name = winding::textOf(this->ResultArrayName);
  for (std::size_t i = 0; i < pointSets.size(); ++i)
  {
    if (getsNormals(pointSets[i]))
    {
      setNormals(normals.data() + points.start(i), pointSets[i]);
    }
    addAreas(name.empty() ? "Area" : name, areas.data() + points.start(i), pointSets[i]);
  }
  this->TotalArea = std::accumulate(areas.cbegin(), areas.cend(), 0.0);
  if (cloud.dropped() > 0)
  {
    vtkWarningMacro(<< winding::lineOf(winding::messageOf(winding::Sentence::unusablePoints,
                      {std::to_string(cloud.dropped()), std::to_string(cloud.inputPoints),
                        std::to_string(cloud.nonFinitePoints),
                        std::to_string(cloud.zeroNormalPoints)})));
  }
  if (lost > 0)
  {
    vtkWarningMacro(<< "the outer surface of curved cells has " << lost
                    << " points that the input does not have, and their areas are left out; "
                       "tessellate the cells first");
  }
  if (this->TotalArea == 0 && !areas.empty())
  {
    vtkWarningMacro(<< winding::lineOf(winding::missingPointArea("theirs are 0")));
  }
}

/// Areas of a mesh come in with its points.
void vtkWindingNumberNormals::FindNormalsAndAreas(
  winding::PointCloud& cloud, bool estimates, winding::Executor& executor)
{
  const winding::PointAreaOptions options = {this->PointAreaMethod == CONSTANT
                                               ? winding::PointAreaMethod::constant
                                               : winding::PointAreaMethod::voronoi,
    this->PointArea, this->NumberOfNeighbors};
  if (estimates)
  {
    const winding::OutwardNormals found =
      winding::giveOutwardNormals(cloud, winding::coreNormalEstimation(this->NormalEstimation),
        winding::Viewpoints(winding::textOf(this->Toward)), options, executor);
    this->NormalEstimationUsed = winding::nameOf(found.estimation);
    this->ClearShare = found.orientation.outward;
    const bool hasAreas =
      std::any_of(cloud.areas.begin(), cloud.areas.end(), [](double area) { return area > 0; });
    if (hasAreas && found.isUnsure())
    {
      vtkWarningMacro(<< winding::lineOf(winding::adviceOnNormals(found.orientation)));
    }
  }
  else if (cloud.areas.empty())
  {
    winding::ShownExecutor shown(executor);
    cloud.areas = winding::pointAreas(cloud, options, shown);
  }
}

const char* vtkWindingNumberNormals::GetNormalEstimationUsed() const
{
  return this->NormalEstimationUsed;
}

double vtkWindingNumberNormals::GetClearShare() const
{
  return this->ClearShare;
}

const char* vtkWindingNumberNormals::GetSourceDistributionAsString() const
{
  return winding::nameOfChoice(winding::Parameter::sourceDistribution, this->SourceDistribution);
}

const char* vtkWindingNumberNormals::GetNormalEstimationAsString() const
{
  return winding::nameOfChoice(winding::Parameter::normalEstimation, this->NormalEstimation);
}

const char* vtkWindingNumberNormals::GetPointAreaMethodAsString() const
{
  return winding::nameOfChoice(winding::Parameter::pointAreaMethod, this->PointAreaMethod);
}

void vtkWindingNumberNormals::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NamesInMessages: " << this->NamesInMessages << "\n";
  os << indent << "PointAreaMethod: " << this->PointAreaMethod << "\n";
  os << indent << "NumberOfNeighbors: " << this->NumberOfNeighbors << "\n";
  os << indent << "PointArea: " << this->PointArea << "\n";
  os << indent << "NormalsArray: " << winding::textOf(this->NormalsArray) << "\n";
  os << indent << "EstimateNormals: " << this->EstimateNormals << "\n";
  os << indent << "NormalEstimation: " << this->NormalEstimation << "\n";
  os << indent << "Toward: " << winding::textOf(this->Toward) << "\n";
  os << indent << "ResultArrayName: " << winding::textOf(this->ResultArrayName) << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "Controller: " << this->Controller.Get() << "\n";
  os << indent << "SourceDistribution: " << this->SourceDistribution << "\n";
  os << indent << "Status: " << this->Status << "\n";
  os << indent << "TotalArea: " << this->TotalArea << "\n";
  os << indent << "NormalEstimationUsed: " << this->NormalEstimationUsed << "\n";
  os << indent << "ClearShare: " << this->ClearShare << "\n";
}
