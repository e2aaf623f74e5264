#include "InputViews.h"

#include "ContentHash.h"
#include "FlatTriangles.h"
#include "Refusal.h"
#include "SourceParts.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace winding
{

InputViews::InputViews(vtkDataObject* source, const InputOptions& options)
  : options_(options)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(source);
  if (composite)
  {
    auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      this->addLeaf(iterator->GetCurrentDataObject(),
        "block " + std::to_string(iterator->GetCurrentFlatIndex()));
    }
  }
  else if (source)
  {
    this->addLeaf(source, "the source");
  }
}

InputViews::~InputViews() = default;

void InputViews::addLeaf(vtkDataObject* leaf, const std::string& name)
{
  auto* points = vtkPointSet::SafeDownCast(leaf);
  if (!points)
  {
    throw Refusal(name + " is a " + std::string(leaf->GetClassName()) +
                  "; a source is a surface or points (vtkPointSet)");
  }
  if (points->GetNumberOfPoints() == 0)
  {
    return;
  }
  const bool isSurface = !options_.asPoints && hasFaces(points);
  const auto own = withoutGhosts(points, isSurface || options_.asPoints);
  if (own->GetNumberOfPoints() == 0)
  {
    return;
  }
  if (!leaves_.empty() && isSurface != isSurface_)
  {
    throw Refusal("the source mixes surfaces and point clouds; extract the blocks of one kind");
  }
  isSurface_ = isSurface;
  leaves_.push_back(own);
  identity_.emplace_back(points, points->GetMTime());
}

std::uint64_t InputViews::fingerprint() const
{
  ContentHash hash;
  hash.addValue(isSurface_);
  for (vtkPointSet* leaf : leaves_)
  {
    hash.addArray(leaf->GetPoints()->GetData());
    if (auto* polyData = vtkPolyData::SafeDownCast(leaf))
    {
      hash.addCells(polyData->GetPolys());
      hash.addCells(polyData->GetStrips());
    }
    else
    {
      // Cells of volume meshes have many forms; any change of the data set counts as one of them.
      hash.addValue(leaf->GetMTime());
    }
    if (!isSurface_)
    {
      hash.addArray(this->normalsOf(leaf, true));
      hash.addArray(this->areasOf(leaf));
    }
  }
  return hash.value();
}

/// The named point array, or the active normals for no name; null if there is none.
vtkDataArray* InputViews::findArray(
  vtkPointSet* leaf, const std::string& name, int components) const
{
  vtkPointData* data = leaf->GetPointData();
  vtkDataArray* array = name.empty() ? data->GetNormals() : data->GetArray(name.c_str());
  if (array && array->GetNumberOfComponents() != components)
  {
    throw Refusal("the point array '" + std::string(array->GetName() ? array->GetName() : "") +
                  "' has " + std::to_string(array->GetNumberOfComponents()) + " components, not " +
                  std::to_string(components) + "; choose another array");
  }
  if (!array && !name.empty())
  {
    throw Refusal("there is no point array '" + name + "'; choose another array");
  }
  return array;
}

vtkDataArray* InputViews::normalsOf(vtkPointSet* leaf, bool mayBeMissing) const
{
  vtkDataArray* normals = this->findArray(leaf, options_.normalsArray, 3);
  if (!normals && !mayBeMissing)
  {
    throw Refusal("the points have no normals, and without them nothing tells inside from outside; "
                  "compute oriented normals first, for instance by vtkPCANormalEstimation with "
                  "NormalOrientation set to graph traversal");
  }
  return normals;
}

vtkDataArray* InputViews::areasOf(vtkPointSet* leaf) const
{
  if (!options_.areasFromArray)
  {
    return nullptr;
  }
  if (options_.areaArray.empty())
  {
    throw Refusal("areas are to come from an array but none is named; name it");
  }
  return this->findArray(leaf, options_.areaArray, 1);
}

template <class View> View InputViews::viewOf(vtkDataArray* array)
{
  const auto count = static_cast<std::size_t>(array->GetNumberOfTuples());
  if (auto* floats = vtkAOSDataArrayTemplate<float>::FastDownCast(array))
  {
    return View(floats->GetPointer(0), count);
  }
  auto* doubles = vtkAOSDataArrayTemplate<double>::FastDownCast(array);
  if (!doubles)
  {
    auto copy = vtkSmartPointer<vtkDoubleArray>::New();
    copy->DeepCopy(array);
    doubles = copy;
    copies_.emplace_back(copy);
  }
  return View(doubles->GetPointer(0), count);
}

VectorsView InputViews::vectorsOf(vtkDataArray* array)
{
  return this->viewOf<VectorsView>(array);
}

ScalarsView InputViews::scalarsOf(vtkDataArray* array)
{
  return this->viewOf<ScalarsView>(array);
}

TriangleIdsView InputViews::idsOf(vtkCellArray* polygons)
{
  if (polygons->IsHomogeneous() == 3)
  {
    const auto count = static_cast<std::size_t>(polygons->GetNumberOfCells());
    if (polygons->IsStorage64Bit())
    {
      // vtkTypeInt64 may be another 64 bit type than std::int64_t, with the same representation.
      return {
        reinterpret_cast<const std::int64_t*>(polygons->GetConnectivityArray64()->GetPointer(0)),
        count};
    }
    return {polygons->GetConnectivityArray32()->GetPointer(0), count};
  }
  ids_.push_back(trianglesOfPolygons(polygons));
  return {ids_.back().data(), ids_.back().size() / 3};
}

/// The polygons of a data set: its own, or the outer surface of volume cells.
vtkPolyData* InputViews::skinOf(vtkPointSet* leaf)
{
  if (auto* polyData = vtkPolyData::SafeDownCast(leaf))
  {
    return polyData;
  }
  checkCellIds(leaf);
  vtkNew<vtkDataSetSurfaceFilter> skin;
  skin->SetInputData(leaf);
  skin->Update();
  skins_.emplace_back(skin->GetOutput());
  return skin->GetOutput();
}

void InputViews::addTriangles(vtkPointSet* leaf, std::vector<TrianglesView>& views)
{
  vtkPolyData* polyData = this->skinOf(leaf);
  if (polyData->GetNumberOfPoints() == 0)
  {
    return;
  }
  const VectorsView points = this->vectorsOf(polyData->GetPoints()->GetData());
  if (polyData->GetNumberOfPolys() > 0)
  {
    views.push_back({points, this->idsOf(polyData->GetPolys())});
  }
  if (polyData->GetNumberOfStrips() > 0)
  {
    ids_.push_back(trianglesOfStrips(polyData->GetStrips()));
    views.push_back({points, {ids_.back().data(), ids_.back().size() / 3}});
  }
}

std::vector<TrianglesView> InputViews::triangles()
{
  std::vector<TrianglesView> views;
  for (vtkPointSet* leaf : leaves_)
  {
    this->addTriangles(leaf, views);
  }
  return views;
}

/// Normals of a mesh's points: the sum of the area vectors of the triangles around each.
VectorsView InputViews::meshNormalsOf(vtkPointSet* leaf)
{
  std::vector<TrianglesView> views;
  this->addTriangles(leaf, views);
  std::vector<double> normals(3 * static_cast<std::size_t>(leaf->GetNumberOfPoints()));
  for (const TrianglesView& view : views)
  {
    for (std::size_t t = 0; t < view.triangles.size(); ++t)
    {
      std::size_t id[3];
      bool valid = true;
      for (std::size_t i = 0; i < 3; ++i)
      {
        id[i] = static_cast<std::size_t>(view.triangles(t, i));
        valid = valid && id[i] < view.points.size() && 3 * id[i] < normals.size();
      }
      if (!valid)
      {
        continue;
      }
      const Eigen::Vector3d a = view.points[id[0]];
      const Eigen::Vector3d areaVector = (view.points[id[1]] - a).cross(view.points[id[2]] - a);
      for (std::size_t corner : id)
      {
        Eigen::Map<Eigen::Vector3d>(&normals[3 * corner]) += areaVector;
      }
    }
  }
  normals_.push_back(std::move(normals));
  return {normals_.back().data(), normals_.back().size() / 3};
}

std::vector<OrientedPointsView> InputViews::orientedPoints()
{
  std::vector<OrientedPointsView> views;
  for (vtkPointSet* source : leaves_)
  {
    // Points inside of a volume mesh are no points of its surface.
    vtkPointSet* leaf = options_.asPoints && hasFaces(source) ? this->skinOf(source) : source;
    if (leaf->GetNumberOfPoints() == 0)
    {
      continue;
    }
    OrientedPointsView view;
    view.positions = this->vectorsOf(leaf->GetPoints()->GetData());
    // A mesh that is taken as points may have no normals of its own.
    vtkDataArray* own = this->normalsOf(leaf, options_.asPoints && hasFaces(leaf));
    view.normals = own ? this->vectorsOf(own) : this->meshNormalsOf(leaf);
    if (vtkDataArray* areas = this->areasOf(leaf))
    {
      view.areas = this->scalarsOf(areas);
    }
    views.push_back(view);
  }
  return views;
}

} // namespace winding
