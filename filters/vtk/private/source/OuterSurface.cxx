// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/OuterSurface.h"

#include "base/Executor.h"
#include "mesh/CellTypes.h"
#include "mesh/MeshSkin.h"
#include "private/source/ArrayViews.h"
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

/// Returns the types of the cells of an unstructured grid. Other meshes have cells of one dimension
/// with straight edges, and no types here.
std::vector<std::uint8_t> typesOf(vtkPointSet* mesh)
{
  std::vector<std::uint8_t> types;
  if (auto* const grid = vtkUnstructuredGrid::SafeDownCast(mesh))
  {
    types.resize(static_cast<std::size_t>(grid->GetNumberOfCells()));
    for (std::size_t cell = 0; cell < types.size(); ++cell)
    {
      types[cell] = static_cast<std::uint8_t>(grid->GetCellType(static_cast<vtkIdType>(cell)));
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

/// A mesh whose cells and points have numbers (withNumbers()).
struct NumberedMesh
{
  explicit NumberedMesh(vtkPointSet* mesh)
    : cells(withNumbers(withoutExplicitStructure(mesh), ownersName))
  {
    const std::vector<std::uint8_t> types = typesOf(cells);
    isCurved = std::any_of(types.begin(), types.end(), winding::isCurved);
    hasBezierCells =
      std::any_of(types.begin(), types.end(), [](int type) { return type >= firstBezierType; });
    if (isCurved)
    {
      cells->GetCenter(middle.data());
      fromMiddle = movedBy(-middle, cells);
    }
  }

  vtkSmartPointer<vtkPointSet> cells;
  bool isCurved, hasBezierCells;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  vtkSmartPointer<vtkPointSet> fromMiddle; ///< the mesh with its middle at the origin, if curved
};

/// The cells of a mesh that own polygons of a skin; others are empty.
struct OwnersView : MeshView
{
  OwnersView(vtkPointSet* mesh, const SkinView& skin)
    : ownTypes(static_cast<std::size_t>(mesh->GetNumberOfCells()), VTK_EMPTY_CELL)
  {
    for (std::size_t polygon = 0; polygon < skin.polygons(); ++polygon)
    {
      const vtkIdType owner = skin.owners[polygon];
      ownTypes[static_cast<std::size_t>(owner)] =
        static_cast<std::uint8_t>(mesh->GetCellType(owner));
    }
    auto* const grid = vtkUnstructuredGrid::SafeDownCast(mesh);
    vtkNew<vtkIdList> own;
    begins.push_back(0);
    for (std::size_t cell = 0; cell < ownTypes.size(); ++cell)
    {
      if (ownTypes[cell] == polyhedronType)
      {
        appendFaces(grid, static_cast<vtkIdType>(cell), ids);
      }
      else if (ownTypes[cell] != VTK_EMPTY_CELL)
      {
        mesh->GetCellPoints(static_cast<vtkIdType>(cell), own);
        ids.insert(ids.end(), own->begin(), own->end());
      }
      begins.push_back(static_cast<std::int64_t>(ids.size()));
    }
    points = viewOf<VectorsView>(mesh->GetPoints()->GetData(), copies);
    types = ownTypes.data();
    corners = {ids.data(), ids.size()};
    offsets = {begins.data(), begins.size()};
  }

  std::vector<std::uint8_t> ownTypes;
  std::vector<std::int64_t> ids, begins;
  std::vector<vtkSmartPointer<vtkDataArray>> copies; ///< of points that no view can show
};

/// The polygons of a mesh's surface as VTK extracts it, and the view of them.
class Skin
{
public:
  /// Curved edges are halved `halvings` times; 0 has them straight between their corners. VTK
  /// rounds points on curved faces to float, so that it is given coordinates from the middle, and
  /// points that differ by that rounding are made one. Halved once, points are nodes of the mesh,
  /// except in Bézier cells, whose nodes are off their faces.
  Skin(const NumberedMesh& mesh, int halvings)
  {
    vtkNew<vtkDataSetSurfaceFilter> filter;
    filter->SetInputData(halvings > 0 ? mesh.fromMiddle : mesh.cells);
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
    origins_.assign(origins->GetPointer(0), origins->GetPointer(0) + points);
    areRounded_ = halvings > 1 || (halvings == 1 && mesh.hasBezierCells);
    if (halvings > 0)
    {
      this->setPlaces(this->placesIn(mesh));
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
    view_.points = this->points();
    view_.corners = {corners_.data(), corners_.size()};
    view_.offsets = {offsets_.data(), offsets_.size()};
    view_.owners = {owners_.data(), owners_.size()};
    view_.origins = {origins_.data(), origins_.size()};
  }

  const SkinView& view() const { return view_; }

  /// Returns the surface with the polygons that bound the mesh, and the other cells as they are.
  vtkSmartPointer<vtkPolyData> lookingOutward(const NumberedMesh& mesh, CellCounts& counts)
  {
    if (areRounded_)
    {
      constexpr double rounding = 4e-7; // of floats, with some operations
      SerialExecutor serial;
      this->setPlaces(
        snappedPoints({view_.points}, rounding * mesh.cells->GetLength(), serial).front());
      view_.points = this->points();
    }
    const std::size_t turned = counts.turned;
    const OutwardPolygons outward = outwardPolygons(OwnersView(mesh.cells, view_), view_, counts);
    surface_->GetPointData()->RemoveArray(ownersName);
    surface_->GetCellData()->RemoveArray(ownersName);
    if (outward.polygons.size() == owners_.size() && counts.turned == turned)
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

  VectorsView points() { return viewOf<VectorsView>(surface_->GetPoints()->GetData(), copies_); }

  /// Returns the places in space of the points of a skin that was extracted from the middle.
  std::vector<double> placesIn(const NumberedMesh& mesh) const
  {
    std::vector<double> places(3 * origins_.size());
    for (std::size_t point = 0; point < origins_.size(); ++point)
    {
      Eigen::Map<Eigen::Vector3d> place(&places[3 * point]);
      if (!areRounded_)
      {
        mesh.cells->GetPoint(static_cast<vtkIdType>(origins_[point]), place.data());
        continue;
      }
      surface_->GetPoint(static_cast<vtkIdType>(point), place.data());
      place += mesh.middle;
    }
    return places;
  }

  void setPlaces(const std::vector<double>& places)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(surface_->GetNumberOfPoints());
    for (vtkIdType point = 0; point < points->GetNumberOfPoints(); ++point)
    {
      points->SetPoint(point, &places[3 * static_cast<std::size_t>(point)]);
    }
    surface_->SetPoints(points);
  }

  vtkSmartPointer<vtkPolyData> surface_;
  std::vector<vtkSmartPointer<vtkDataArray>> copies_; ///< of points that no view can show
  std::vector<std::int64_t> corners_, offsets_, owners_, origins_;
  bool areRounded_ = false; ///< whether points are near their places only
  SkinView view_;
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
  std::vector<std::uint8_t> types = typesOf(mesh);
  if (!flags && types.empty())
  {
    return mesh;
  }
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
  const NumberedMesh numbered(mesh);
  Skin skin(numbered, numbered.isCurved ? 1 : 0);
  if (numbered.isCurved && !keepsPoints)
  {
    Skin twice(numbered, 2);
    const int halvings = halvingsOf(skin.view(), twice.view(),
      static_cast<std::size_t>(numbered.cells->GetNumberOfCells()), numbered.cells->GetLength(),
      counts);
    if (halvings == 2)
    {
      return twice.lookingOutward(numbered, counts);
    }
    if (halvings > 2)
    {
      return Skin(numbered, halvings).lookingOutward(numbered, counts);
    }
  }
  return skin.lookingOutward(numbered, counts);
}

} // namespace winding
