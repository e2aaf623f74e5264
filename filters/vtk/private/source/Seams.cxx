// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/Seams.h"

#include "private/source/CellTypes.h"
#include "source/PlaceHash.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace winding
{

namespace
{

using Place = std::array<double, 3>;

/// The first point at the place of each point, and whether others stand there.
struct SharedPlaces
{
  explicit SharedPlaces(vtkPolyData* surface)
    : firsts(static_cast<std::size_t>(surface->GetNumberOfPoints()))
    , isShared(firsts.size(), 0)
  {
    std::unordered_map<Place, vtkIdType, PlaceHash> places;
    places.reserve(firsts.size());
    for (vtkIdType point = 0; point < surface->GetNumberOfPoints(); ++point)
    {
      Place place;
      surface->GetPoint(point, place.data());
      for (double& coordinate : place)
      {
        coordinate += 0.0; // −0 is 0
      }
      const auto [first, isNew] = places.emplace(place, point);
      firsts[static_cast<std::size_t>(point)] = first->second;
      if (!isNew)
      {
        isShared[static_cast<std::size_t>(first->second)] = 1;
        areAny = true;
      }
    }
  }

  std::vector<vtkIdType> firsts;
  std::vector<char> isShared; ///< by first point
  bool areAny = false;
};

/// A polygon from its lowest corner on, and whether its corners come in the sense in which the
/// second is lower than the last.
std::pair<std::vector<vtkIdType>, bool> withoutSense(std::vector<vtkIdType> corners)
{
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  const bool ascends = corners[1] < corners.back();
  if (!ascends)
  {
    std::reverse(corners.begin() + 1, corners.end());
  }
  return {corners, ascends};
}

/// Finds polygons that are there in both senses: by polygon, whether it is one of a pair.
std::vector<char> pairsOf(vtkPolyData* surface, vtkPointSet* mesh)
{
  std::vector<char> isPaired;
  const SharedPlaces places(surface);
  auto* const owners =
    vtkIdTypeArray::SafeDownCast(surface->GetCellData()->GetArray("vtkOriginalCellIds"));
  if (!places.areAny || !owners)
  {
    return isPaired;
  }
  isPaired.resize(static_cast<std::size_t>(surface->GetNumberOfPolys()), 0);
  const vtkIdType before = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  std::map<std::vector<vtkIdType>, std::array<std::vector<std::size_t>, 2>> open; // by sense
  vtkCellArray* const polygons = surface->GetPolys();
  for (vtkIdType polygon = 0; polygon < surface->GetNumberOfPolys(); ++polygon)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    polygons->GetCellAtId(polygon, size, ids);
    std::vector<vtkIdType> corners;
    for (vtkIdType i = 0; i < size; ++i)
    {
      corners.push_back(places.firsts[static_cast<std::size_t>(ids[i])]);
    }
    const bool mayBe = size >= 3 &&
                       std::all_of(corners.begin(), corners.end(),
                         [&places](vtkIdType corner)
                         { return places.isShared[static_cast<std::size_t>(corner)] != 0; }) &&
                       dimensionOf(mesh->GetCellType(owners->GetValue(before + polygon))) == 3;
    if (!mayBe)
    {
      continue;
    }
    const auto [key, ascends] = withoutSense(std::move(corners));
    auto& [down, up] = open[key];
    std::vector<std::size_t>& others = ascends ? down : up;
    if (others.empty())
    {
      (ascends ? up : down).push_back(static_cast<std::size_t>(polygon));
      continue;
    }
    isPaired[static_cast<std::size_t>(polygon)] = isPaired[others.back()] = 1;
    others.pop_back();
  }
  return isPaired;
}

} // namespace

vtkSmartPointer<vtkPolyData> withoutSeams(vtkPolyData* surface, vtkPointSet* mesh)
{
  const std::vector<char> isPaired = pairsOf(surface, mesh);
  if (std::find(isPaired.begin(), isPaired.end(), 1) == isPaired.end())
  {
    return surface;
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(surface->GetPoints());
  result->GetPointData()->ShallowCopy(surface->GetPointData());
  result->SetVerts(surface->GetVerts());
  result->SetLines(surface->GetLines());
  const vtkIdType before = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  vtkNew<vtkCellArray> polygons;
  vtkCellData* const data = result->GetCellData();
  data->CopyAllocate(surface->GetCellData(), surface->GetNumberOfCells());
  vtkIdType next = 0;
  for (; next < before; ++next)
  {
    data->CopyData(surface->GetCellData(), next, next);
  }
  for (vtkIdType polygon = 0; polygon < surface->GetNumberOfPolys(); ++polygon)
  {
    if (!isPaired[static_cast<std::size_t>(polygon)])
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      surface->GetPolys()->GetCellAtId(polygon, size, ids);
      polygons->InsertNextCell(size, ids);
      data->CopyData(surface->GetCellData(), before + polygon, next++);
    }
  }
  result->SetPolys(polygons);
  return result;
}

} // namespace winding
