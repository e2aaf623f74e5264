// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/NumberedPoints.h"

#include "source/Sanitize.h"

#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <numeric>

namespace winding
{

namespace
{

constexpr char name[] = "vtkWindingNumberNormals number";

} // namespace

NumberedPoints::NumberedPoints(const std::vector<vtkPointSet*>& pointSets)
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
    std::iota(first, first + numbers->GetNumberOfTuples(), static_cast<vtkIdType>(this->start(i)));
    pointSets_[i]->GetPointData()->AddArray(numbers);
  }
}

NumberedPoints::~NumberedPoints()
{
  for (vtkPointSet* set : pointSets_)
  {
    set->GetPointData()->RemoveArray(name);
  }
}

const vtkIdType* NumberedPoints::numbersOf(vtkPointSet* made)
{
  return vtkIdTypeArray::SafeDownCast(made->GetPointData()->GetArray(name))->GetPointer(0);
}

bool NumberedPoints::isPoint(vtkIdType number, const Eigen::Vector3d& position) const
{
  if (number < 0 || static_cast<std::size_t>(number) >= points_.size())
  {
    return false;
  }
  const std::size_t set = points_.viewOf(static_cast<std::size_t>(number));
  Eigen::Vector3d own;
  pointSets_[set]->GetPoint(number - static_cast<vtkIdType>(this->start(set)), own.data());
  return own == position;
}

NumberedFindings findingsByNumber(const NumberedPoints& points, const InputViews& input,
  const std::vector<OrientedPointsView>& views, const PointCloud& cloud, std::size_t first,
  bool withNormals)
{
  NumberedFindings result;
  result.areas.resize(points.size());
  result.normals.resize(withNormals ? points.size() : 0, Eigen::Vector3d::Zero());
  std::size_t found = first;
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    const vtkIdType* numbers = NumberedPoints::numbersOf(input.pointSets()[i]);
    for (std::size_t j = 0; j < views[i].positions.size(); ++j)
    {
      if (!isUsable(views[i], j))
      {
        continue;
      }
      if (points.isPoint(numbers[j], views[i].positions[j]))
      {
        const auto number = static_cast<std::size_t>(numbers[j]);
        result.areas[number] += cloud.areas[found];
        if (withNormals)
        {
          result.normals[number] = cloud.normals[found];
        }
      }
      else
      {
        ++result.lost;
      }
      ++found;
    }
  }
  return result;
}

} // namespace winding
