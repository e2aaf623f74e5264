// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/OuterSurface.h"

#include "base/Executor.h"
#include "mesh/CellTypes.h"
#include "mesh/MeshSkin.h"
#include "private/source/CellChecks.h"
#include "source/SnappedPoints.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkExplicitStructuredGridToUnstructuredGrid.h"
#include "vtkExtractCells.h"
#include "vtkIdList.h"
#include "vtkLongLongArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <Eigen/Core>

#include <algorithm>
#include <numeric>

namespace winding
{

namespace
{

constexpr char ownersName[] = "winding number owners";

/// Returns the types of cells; none for polydata, which has no cells with volume.
std::vector<std::uint8_t> typesOf(vtkPointSet* mesh)
{
  std::vector<std::uint8_t> types;
  if (!vtkPolyData::SafeDownCast(mesh))
  {
    types.resize(static_cast<std::size_t>(mesh->GetNumberOfCells()));
    for (std::size_t cell = 0; cell < types.size(); ++cell)
    {
      types[cell] = static_cast<std::uint8_t>(mesh->GetCellType(static_cast<vtkIdType>(cell)));
    }
  }
  return types;
}

/// Returns the cells of a mesh, in an unstructured grid where VTK's surfaces have no numbers of
/// cells.
vtkSmartPointer<vtkPointSet> withoutExplicitStructure(vtkPointSet* mesh)
{
  if (!vtkExplicitStructuredGrid::SafeDownCast(mesh))
  {
    return mesh;
  }
  vtkNew<vtkExplicitStructuredGridToUnstructuredGrid> cells;
  cells->SetInputData(mesh);
  cells->Update();
  return cells->GetOutput();
}

/// Returns a mesh with its points moved, in double precision.
vtkSmartPointer<vtkPointSet> movedBy(const Eigen::Vector3d& way, vtkPointSet* mesh)
{
  const auto moved = vtkSmartPointer<vtkPointSet>::Take(mesh->NewInstance());
  moved->ShallowCopy(mesh);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    Eigen::Vector3d place;
    mesh->GetPoint(point, place.data());
    place += way;
    points->SetPoint(point, place.data());
  }
  moved->SetPoints(points);
  return moved;
}

/// The polygons of a mesh's surface as VTK extracts it, and the view of them.
class Skin
{
public:
  /// Curved edges are halved `halvings` times; 0 has them straight between their corners. VTK
  /// rounds points on curved faces to float, so that it is given coordinates from the middle, and
  /// points that differ by that rounding are made one. Halved once, points are nodes of the mesh,
  /// except in Bézier cells, whose nodes are off their faces.
  Skin(vtkPointSet* mesh, int halvings, bool hasBezierCells)
  {
    const bool areNodes = halvings == 1 && !hasBezierCells;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    if (halvings > 0)
    {
      mesh->GetCenter(middle.data());
    }
    vtkNew<vtkDataSetSurfaceFilter> filter;
    filter->SetInputData(halvings > 0 ? movedBy(-middle, mesh).Get() : mesh);
    filter->SetNonlinearSubdivisionLevel(halvings);
    filter->Update();
    surface_ = filter->GetOutput();
    const vtkIdType points = surface_->GetNumberOfPoints(), polygons = surface_->GetNumberOfPolys();
    auto* const owners =
      vtkLongLongArray::SafeDownCast(surface_->GetCellData()->GetArray(ownersName));
    auto* const origins =
      vtkLongLongArray::SafeDownCast(surface_->GetPointData()->GetArray(ownersName));
    if (!owners || !origins || points == 0)
    {
      return;
    }
    coordinates_.resize(3 * static_cast<std::size_t>(points));
    for (vtkIdType point = 0; point < points; ++point)
    {
      Eigen::Map<Eigen::Vector3d> place(&coordinates_[3 * static_cast<std::size_t>(point)]);
      surface_->GetPoint(point, place.data());
      place += middle;
      if (areNodes)
      {
        mesh->GetPoint(static_cast<vtkIdType>(origins->GetValue(point)), place.data());
      }
    }
    if (halvings > 0 && !areNodes)
    {
      constexpr double rounding = 4e-7; // of floats, with some operations
      SerialExecutor serial;
      const VectorsView rounded(coordinates_.data(), static_cast<std::size_t>(points));
      coordinates_ = snappedPoints({rounded}, rounding * mesh->GetLength(), serial).front();
    }
    if (halvings > 0)
    {
      vtkNew<vtkPoints> places;
      places->SetDataTypeToDouble();
      places->SetNumberOfPoints(points);
      for (vtkIdType point = 0; point < points; ++point)
      {
        places->SetPoint(point, &coordinates_[3 * static_cast<std::size_t>(point)]);
      }
      surface_->SetPoints(places);
    }
    offsets_.push_back(0);
    for (vtkIdType polygon = 0; polygon < polygons; ++polygon)
    {
      vtkIdType size;
      const vtkIdType* ids;
      surface_->GetPolys()->GetCellAtId(polygon, size, ids);
      corners_.insert(corners_.end(), ids, ids + size);
      offsets_.push_back(static_cast<std::int64_t>(corners_.size()));
    }
    owners_.assign(
      owners->GetPointer(this->before()), owners->GetPointer(this->before()) + polygons);
    view_.points = {coordinates_.data(), static_cast<std::size_t>(points)};
    view_.corners = {corners_.data(), corners_.size()};
    view_.offsets = {offsets_.data(), offsets_.size()};
    view_.owners = {owners_.data(), owners_.size()};
    origins_.assign(origins->GetPointer(0), origins->GetPointer(0) + points);
    view_.origins = {origins_.data(), origins_.size()};
  }

  const SkinView& view() const { return view_; }

  /// Returns the surface with the polygons that bound the mesh, and the other cells as they are.
  vtkSmartPointer<vtkPolyData> with(const OutwardPolygons& outward)
  {
    surface_->GetPointData()->RemoveArray(ownersName);
    surface_->GetCellData()->RemoveArray(ownersName);
    if (view_.owners.empty())
    {
      return surface_;
    }
    vtkNew<vtkCellArray> polygons;
    for (std::size_t polygon = 0; polygon < outward.polygons.size(); ++polygon)
    {
      const auto first = static_cast<std::size_t>(outward.offsets[polygon]);
      const auto end = static_cast<std::size_t>(outward.offsets[polygon + 1]);
      polygons->InsertNextCell(static_cast<int>(end - first));
      for (std::size_t at = first; at < end; ++at)
      {
        polygons->InsertCellPoint(outward.corners[at]);
      }
    }
    auto result = vtkSmartPointer<vtkPolyData>::New();
    result->ShallowCopy(surface_);
    result->SetPolys(polygons);
    if (outward.polygons.size() < owners_.size())
    {
      vtkNew<vtkIdList> cells;
      const auto add = [&cells](vtkIdType first, vtkIdType count)
      {
        for (vtkIdType cell = first; cell < first + count; ++cell)
        {
          cells->InsertNextId(cell);
        }
      };
      add(0, this->before());
      for (const std::int64_t polygon : outward.polygons)
      {
        cells->InsertNextId(this->before() + polygon);
      }
      add(this->before() + surface_->GetNumberOfPolys(), surface_->GetNumberOfStrips());
      vtkCellData* const data = result->GetCellData();
      data->Initialize();
      data->CopyAllocate(surface_->GetCellData(), cells->GetNumberOfIds());
      for (vtkIdType cell = 0; cell < cells->GetNumberOfIds(); ++cell)
      {
        data->CopyData(surface_->GetCellData(), cells->GetId(cell), cell);
      }
    }
    return result;
  }

private:
  vtkIdType before() const { return surface_->GetNumberOfVerts() + surface_->GetNumberOfLines(); }

  vtkSmartPointer<vtkPolyData> surface_;
  std::vector<double> coordinates_;
  std::vector<std::int64_t> corners_, offsets_, owners_, origins_;
  SkinView view_;
};

/// The cells of a mesh that own polygons of a skin; others are empty.
struct OwnersView : MeshView
{
  OwnersView(vtkPointSet* mesh, const SkinView& skin, const std::vector<std::uint8_t>& allTypes)
  {
    std::vector<char> isOwner(allTypes.size(), 0);
    for (std::size_t polygon = 0; polygon < skin.polygons(); ++polygon)
    {
      isOwner[static_cast<std::size_t>(skin.owners[polygon])] = 1;
    }
    coordinates.resize(3 * static_cast<std::size_t>(mesh->GetNumberOfPoints()));
    for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
    {
      mesh->GetPoint(point, &coordinates[3 * static_cast<std::size_t>(point)]);
    }
    auto* const grid = vtkUnstructuredGrid::SafeDownCast(mesh);
    vtkNew<vtkIdList> own;
    begins.push_back(0);
    for (std::size_t cell = 0; cell < allTypes.size(); ++cell)
    {
      if (isOwner[cell] && allTypes[cell] == polyhedronType)
      {
        appendFaces(grid, static_cast<vtkIdType>(cell), ids);
      }
      else if (isOwner[cell])
      {
        mesh->GetCellPoints(static_cast<vtkIdType>(cell), own);
        ids.insert(ids.end(), own->begin(), own->end());
      }
      begins.push_back(static_cast<std::int64_t>(ids.size()));
    }
    points = {coordinates.data(), coordinates.size() / 3};
    types = allTypes.data();
    corners = {ids.data(), ids.size()};
    offsets = {begins.data(), begins.size()};
  }

  std::vector<double> coordinates;
  std::vector<std::int64_t> ids, begins;
};

} // namespace

void countLoose(vtkPointSet* mesh, CellCounts& counts)
{
  if (auto* polyData = vtkPolyData::SafeDownCast(mesh))
  {
    counts.loose +=
      static_cast<std::size_t>(polyData->GetNumberOfLines() + polyData->GetNumberOfVerts());
    return;
  }
  countLoose(typesOf(mesh), counts);
}

bool isGhostCell(vtkUnsignedCharArray* flags, vtkIdType cell)
{
  return flags && cell < flags->GetNumberOfTuples() && (flags->GetValue(cell) & ghostCellBits) != 0;
}

vtkSmartPointer<vtkPointSet> ownCellsOf(
  vtkPointSet* mesh, bool takesFaces, const std::string& name, CellCounts& counts)
{
  vtkUnsignedCharArray* const flags = mesh->GetCellGhostArray();
  if (!flags && vtkPolyData::SafeDownCast(mesh))
  {
    return mesh;
  }
  std::vector<std::uint8_t> types = typesOf(mesh);
  types.resize(static_cast<std::size_t>(mesh->GetNumberOfCells()), VTK_POLYGON);
  std::vector<std::uint8_t> ghosts(types.size(), 0);
  if (flags)
  {
    const auto known = std::min(mesh->GetNumberOfCells(), flags->GetNumberOfTuples());
    std::copy(flags->GetPointer(0), flags->GetPointer(0) + known, ghosts.begin());
  }
  const std::vector<char> isOwn = ownCellsOf(types, ghosts.data(), takesFaces, counts);
  if (std::all_of(isOwn.begin(), isOwn.end(), [](char own) { return own != 0; }))
  {
    return mesh;
  }
  vtkNew<vtkIdList> own;
  for (std::size_t cell = 0; cell < isOwn.size(); ++cell)
  {
    if (isOwn[cell])
    {
      own->InsertNextId(static_cast<vtkIdType>(cell));
    }
  }
  checkCells(mesh, name);
  checkArrays(mesh, name);
  vtkNew<vtkExtractCells> extract;
  extract->SetInputData(mesh);
  extract->SetCellList(own);
  extract->Update();
  if (!vtkPolyData::SafeDownCast(mesh))
  {
    return extract->GetOutput();
  }
  // The cells of polydata stay polydata.
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputConnection(extract->GetOutputPort());
  surface->Update();
  return surface->GetOutput();
}

vtkSmartPointer<vtkPointSet> withNumbers(vtkPointSet* mesh, const char* name)
{
  const auto copy = vtkSmartPointer<vtkPointSet>::Take(mesh->NewInstance());
  copy->ShallowCopy(mesh);
  const auto number = [name](vtkDataSetAttributes* attributes, vtkIdType count)
  {
    vtkNew<vtkLongLongArray> numbers; // VTK leaves out ids where it interpolates
    numbers->SetName(name);
    numbers->SetNumberOfValues(count);
    std::iota(numbers->GetPointer(0), numbers->GetPointer(0) + count, 0LL);
    attributes->AddArray(numbers);
  };
  number(copy->GetCellData(), mesh->GetNumberOfCells());
  number(copy->GetPointData(), mesh->GetNumberOfPoints());
  return copy;
}

vtkSmartPointer<vtkPolyData> outerSurfaceOf(vtkPointSet* mesh, bool keepsPoints, CellCounts& counts)
{
  const auto cells = withNumbers(withoutExplicitStructure(mesh), ownersName);
  const std::vector<std::uint8_t> types = typesOf(cells);
  const bool isBezier =
    std::any_of(types.begin(), types.end(), [](int type) { return type >= firstBezierType; });
  int halvings = std::any_of(types.begin(), types.end(), isCurved) ? 1 : 0;
  if (halvings > 0 && !keepsPoints)
  {
    halvings = halvingsOf(Skin(cells, 1, isBezier).view(), Skin(cells, 2, isBezier).view(),
      types.size(), cells->GetLength(), counts);
  }
  Skin skin(cells, halvings, isBezier);
  return skin.with(outwardPolygons(OwnersView(cells, skin.view(), types), skin.view(), counts));
}

} // namespace winding
