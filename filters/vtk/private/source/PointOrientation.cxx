// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/PointOrientation.h"

#include "base/Refusal.h"
#include "cloud/ConsistentNormals.h"
#include "private/source/PointArrays.h"
#include "tasks/Sentences.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace winding
{

namespace
{

/// The normals of a leaf that has points. Negative numbers stand for floating-point types.
vtkDataArray* realNormalsOf(vtkPolyData* leaf, const std::string& name)
{
  vtkDataArray* const normals = normalsOf(leaf, name);
  if (!normals)
  {
    throw Refusal(messageOf(Sentence::noNormalsToTurn));
  }
  if (normals->GetDataType() != VTK_FLOAT && normals->GetDataType() != VTK_DOUBLE)
  {
    throw Refusal(Message(
      "normals of type " + std::string(normals->GetDataTypeAsString()) + " cannot all be turned",
      {{"give them as float or double", {}}, {"", {{Parameter::fixOrientation, 0}}}}));
  }
  return normals;
}

/// The points of all leaves.
struct AllPoints
{
  std::vector<Eigen::Vector3d> positions, normals;
  std::vector<std::pair<std::size_t, vtkIdType>> origins; ///< leaf and point
};

AllPoints pointsOf(
  const std::vector<vtkSmartPointer<vtkPolyData>>& leaves, const std::string& normalsArray)
{
  AllPoints all;
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf)
  {
    const vtkIdType count = leaves[leaf]->GetNumberOfPoints();
    vtkDataArray* const normals = count > 0 ? realNormalsOf(leaves[leaf], normalsArray) : nullptr;
    for (vtkIdType point = 0; point < count; ++point)
    {
      Eigen::Vector3d position, normal;
      leaves[leaf]->GetPoint(point, position.data());
      normals->GetTuple(point, normal.data());
      all.positions.push_back(position);
      all.normals.push_back(normal);
      all.origins.emplace_back(leaf, point);
    }
  }
  return all;
}

/// A copy of a leaf whose normals are a copy, too.
vtkSmartPointer<vtkPolyData> withOwnNormals(vtkPolyData* leaf, const std::string& normalsArray)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(leaf);
  vtkDataArray* const normals = normalsOf(copy, normalsArray);
  const auto own = vtkSmartPointer<vtkDataArray>::Take(normals->NewInstance());
  own->DeepCopy(normals);
  const bool areActive = copy->GetPointData()->GetNormals() == normals;
  if (areActive)
  {
    copy->GetPointData()->SetNormals(own);
  }
  else
  {
    copy->GetPointData()->AddArray(own);
  }
  return copy;
}

} // namespace

OrientedPointSets orientNormals(const std::vector<vtkSmartPointer<vtkPolyData>>& leaves,
  const std::string& normalsArray, Executor& executor)
{
  const AllPoints all = pointsOf(leaves, normalsArray);
  const std::vector<unsigned char> turns = normalsToTurn(all.positions, all.normals, executor);
  OrientedPointSets result;
  result.leaves = leaves;
  for (std::size_t i = 0; i < turns.size(); ++i)
  {
    if (!turns[i])
    {
      continue;
    }
    const auto [leaf, point] = all.origins[i];
    if (result.leaves[leaf] == leaves[leaf])
    {
      result.leaves[leaf] = withOwnNormals(leaves[leaf], normalsArray);
    }
    vtkDataArray* const normals = normalsOf(result.leaves[leaf], normalsArray);
    double normal[3];
    normals->GetTuple(point, normal);
    normals->SetTuple3(point, -normal[0], -normal[1], -normal[2]);
    ++result.points;
  }
  return result;
}

} // namespace winding
