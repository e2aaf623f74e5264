// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/InputViews.h"

#include "base/Executor.h"
#include "base/Refusal.h"
#include "cloud/OutwardNormals.h"
#include "private/source/ArrayViews.h"
#include "private/source/CellChecks.h"
#include "private/source/ContentHash.h"
#include "private/source/ModifiedTime.h"
#include "private/source/PointArrays.h"
#include "private/source/SourceParts.h"
#include "source/Sanitize.h"
#include "source/SnappedPoints.h"
#include "tasks/Sentences.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkLongLongArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <numeric>

namespace winding
{

namespace
{

constexpr char numbersName[] = "winding number in data set";

} // namespace

InputViews::InputViews(
  vtkDataObject* source, const InputOptions& options, Executor* executor, bool keepsNumbers)
  : options_(options)
  , executor_(executor)
  , keepsNumbers_(keepsNumbers)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(source);
  if (composite)
  {
    auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      this->addLeaf(iterator->GetCurrentDataObject(),
        "block " + std::to_string(iterator->GetCurrentFlatIndex()),
        iterator->GetCurrentFlatIndex());
    }
  }
  else if (source)
  {
    this->addLeaf(source, "the source", 0);
  }
  isOfLinesToo_ = true;
  for (const Leaf& leaf : ofLines_)
  {
    if (isSurface_)
    {
      countLoose(leaf.data, counts_);
    }
    else
    {
      this->addLeaf(leaf.data, leaf.name, leaf.block);
    }
  }
}

InputViews::~InputViews() = default;

void InputViews::addLeaf(vtkDataObject* leaf, const std::string& name, unsigned block)
{
  auto* points = vtkPointSet::SafeDownCast(leaf);
  if (!points)
  {
    throw Refusal(messageOf(Sentence::noSurfaceOrPoints, {name, leaf->GetClassName()}));
  }
  if (points->GetNumberOfPoints() == 0)
  {
    return;
  }
  if (vtkPolyData::SafeDownCast(points))
  {
    checkStructure(points, name); // polygons with bad ids are left out and counted (Sanitize.h)
  }
  else
  {
    checkCells(points, name);
    checkArrays(points, name);
  }
  const bool isMesh = hasFaces(points);
  if (!isMesh && !isOfLinesToo_ && isOfLines(points))
  {
    ofLines_.push_back({points, name, block});
    return;
  }
  const bool isSurface = isMesh && !options_.asPoints;
  if (isSurface)
  {
    countLoose(points, counts_);
  }
  const bool mayRenumber = !vtkPolyData::SafeDownCast(points) || points->GetCellGhostArray() ||
                           points->GetPointGhostArray();
  vtkSmartPointer<vtkPointSet> numbered = points;
  if (keepsNumbers_ && mayRenumber)
  {
    numbered = withNumbers(points, numbersName);
  }
  const auto own = ownPartOf(numbered, options_.takesFaces, name, counts_);
  if (own->GetNumberOfPoints() == 0)
  {
    return;
  }
  if (!leaves_.empty() && isSurface != isSurface_)
  {
    throw Refusal("take blocks or files of one kind: the source mixes surfaces and point clouds");
  }
  isSurface_ = isSurface;
  leaves_.push_back(own);
  blocks_.push_back(block);
  identity_.emplace_back(points, modifiedTimeOf(points));
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
      hash.addValue(modifiedTimeOf(leaf));
    }
    if (!isSurface_)
    {
      hash.addArray(normalsOf(leaf, options_.normalsArray));
      hash.addArray(this->areasOf(leaf));
      hash.addArray(this->viewpointsOf(leaf));
    }
  }
  return hash.value();
}

/// Whether there are points without normals, and no triangles that could give them either.
bool InputViews::lacksNormals() const
{
  return std::any_of(leaves_.begin(), leaves_.end(),
    [this](vtkPointSet* leaf)
    { return !hasFaces(leaf) && !normalsOf(leaf, options_.normalsArray); });
}

bool InputViews::hasOnlyLines() const
{
  return !isSurface_ && this->lacksNormals() &&
         std::all_of(leaves_.begin(), leaves_.end(),
           [](vtkPointSet* leaf) { return leaf->GetNumberOfPoints() == 0 || isOfLines(leaf); });
}

vtkDataArray* InputViews::areasOf(vtkPointSet* leaf) const
{
  if (options_.areas != AreaSource::array)
  {
    return nullptr;
  }
  if (options_.areaArray.empty())
  {
    throw Refusal(Message("the array of areas has no name", {{"", {Parameter::areaArray}}}));
  }
  return pointArray(leaf, options_.areaArray, 1);
}

/// Returns the places that points without normals were seen from, if these are to be estimated.
vtkDataArray* InputViews::viewpointsOf(vtkPointSet* leaf) const
{
  vtkDataArray* const array = leaf->GetPointData()->GetArray("Viewpoints");
  const bool isRight = array && array->GetNumberOfComponents() == 3 &&
                       array->GetNumberOfTuples() == leaf->GetNumberOfPoints();
  return isRight && options_.estimateNormals && !hasFaces(leaf) ? array : nullptr;
}

VectorsView InputViews::directionsTo(vtkDataArray* viewpoints, const VectorsView& points)
{
  const VectorsView seenFrom = this->vectorsOf(viewpoints);
  std::vector<double>& directions = directions_.emplace_back();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Eigen::Vector3d direction = seenFrom[i] - points[i];
    directions.insert(directions.end(), direction.data(), direction.data() + 3);
  }
  return {directions.data(), points.size()};
}

VectorsView InputViews::vectorsOf(vtkDataArray* array)
{
  return viewOf<VectorsView>(array, copies_);
}

ScalarsView InputViews::scalarsOf(vtkDataArray* array)
{
  return viewOf<ScalarsView>(array, copies_);
}

TrianglesView InputViews::trianglesOf(const VectorsView& points, vtkCellArray* polygons)
{
  // The array itself says what it is: the kinds of storage of vtkCellArray differ between versions.
  vtkDataArray* ids = polygons->GetConnectivityArray();
  if (polygons->IsHomogeneous() == 3 && ids->HasStandardMemoryLayout())
  {
    const auto count = static_cast<std::size_t>(polygons->GetNumberOfCells());
    if (ids->GetDataTypeSize() == sizeof(std::int64_t))
    {
      return {points, {static_cast<const std::int64_t*>(ids->GetVoidPointer(0)), count}};
    }
    if (ids->GetDataTypeSize() == sizeof(std::int32_t))
    {
      return {points, {static_cast<const std::int32_t*>(ids->GetVoidPointer(0)), count}};
    }
  }
  flat_.push_back(trianglesOfPolygons(polygons));
  const FlatTriangles& flat = flat_.back();
  return {points, {flat.ids.data(), flat.isContinued.size()}, flat.isContinued.data()};
}

/// The polygons of a data set: its own, or the outer surface of volume cells.
vtkPolyData* InputViews::skinOf(vtkPointSet* leaf)
{
  if (auto* polyData = vtkPolyData::SafeDownCast(leaf))
  {
    return polyData;
  }
  vtkSmartPointer<vtkPolyData>& skin = skins_[leaf];
  if (!skin)
  {
    skin = outerSurfaceOf(leaf, options_.asPoints, counts_);
  }
  return skin;
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
    views.push_back(this->trianglesOf(points, polyData->GetPolys()));
  }
  if (polyData->GetNumberOfStrips() > 0)
  {
    flat_.push_back({trianglesOfStrips(polyData->GetStrips()), {}});
    views.push_back({points, {flat_.back().ids.data(), flat_.back().ids.size() / 3}});
  }
}

std::vector<ViewedPart> InputViews::viewedParts()
{
  std::vector<ViewedPart> parts;
  for (std::size_t i = 0; i < leaves_.size(); ++i)
  {
    vtkPolyData* const data = this->skinOf(leaves_[i]);
    if (data->GetNumberOfPoints() > 0 && data->GetNumberOfPolys() > 0)
    {
      parts.push_back({data, false, blocks_[i]});
    }
    if (data->GetNumberOfPoints() > 0 && data->GetNumberOfStrips() > 0)
    {
      parts.push_back({data, true, blocks_[i]});
    }
  }
  return parts;
}

const char* InputViews::nameOfNumbers()
{
  return numbersName;
}

vtkIdType InputViews::numberOf(vtkDataSetAttributes* ofPart, vtkIdType item)
{
  auto* const numbers = vtkLongLongArray::SafeDownCast(ofPart->GetArray(numbersName));
  return numbers ? static_cast<vtkIdType>(numbers->GetValue(item)) : item;
}

std::vector<TrianglesView> InputViews::triangles()
{
  std::vector<TrianglesView> triangles = isGathered_ ? gathered_.triangles() : this->ownTriangles();
  std::vector<VectorsView> points;
  for (const TrianglesView& view : triangles)
  {
    points.push_back(view.points);
  }
  points = this->welded(points);
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    triangles[i].points = points[i];
  }
  return triangles;
}

std::vector<VectorsView> InputViews::welded(const std::vector<VectorsView>& points)
{
  if (options_.weldTolerance == 0 || !isSurface_)
  {
    return points;
  }
  SerialExecutor serial;
  welded_.push_back(snappedPoints(points, options_.weldTolerance, executor_ ? *executor_ : serial));
  std::vector<VectorsView> views;
  for (const std::vector<double>& own : welded_.back())
  {
    views.emplace_back(own.data(), own.size() / 3);
  }
  return views;
}

std::vector<OrientedPointsView> InputViews::orientedPoints()
{
  return isGathered_ ? gathered_.orientedPoints() : this->ownOrientedPoints();
}

std::size_t InputViews::ownElements() const
{
  const int type = isSurface_ ? vtkDataObject::CELL : vtkDataObject::POINT;
  return std::accumulate(leaves_.begin(), leaves_.end(), std::size_t{0},
    [type](std::size_t sum, vtkPointSet* leaf)
    { return sum + static_cast<std::size_t>(leaf->GetNumberOfElements(type)); });
}

void InputViews::compare(Ranks& ranks, SourceDistribution distribution)
{
  if (ranks.isAlone())
  {
    return;
  }
  enum Kind : unsigned
  {
    surface = 1,
    cloud = 2
  };
  const std::vector<Ranks::Number> kinds = ranks.allGather(
    [&]() -> Ranks::Number
    {
      if (isSurface_)
      {
        return surface;
      }
      return leaves_.empty() ? 0u : +cloud;
    });
  const auto has = [&kinds](Kind kind)
  {
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
  };
  if (has(surface) && has(cloud))
  {
    throw Refusal(messageOf(Sentence::surfacesAndCloudsOnRanks));
  }
  isSurface_ = has(surface);
  // Parts of different sizes are no copies, and looking at them takes no time.
  areCopies_ =
    distribution != SourceDistribution::distributed &&
    areEqual(ranks.allGather([this]() -> Ranks::Number { return this->ownElements(); })) &&
    areEqual(ranks.allGather([this]() -> Ranks::Number
      { return isSurface_ ? hashOf(this->ownTriangles()) : hashOf(this->ownOrientedPoints()); }));
  if (distribution == SourceDistribution::replicated && !areCopies_)
  {
    throw Refusal(messageOf(Sentence::notReplicated));
  }
}

void InputViews::gather(Ranks& ranks, bool onlyOnFirst)
{
  if (ranks.isAlone() || areCopies_)
  {
    return;
  }
  ranks.agree(
    [this]
    {
      if (isSurface_)
      {
        this->ownTriangles();
      }
      else
      {
        this->ownOrientedPoints();
      }
    });
  isGathered_ = isSurface_ ? gathered_.gather(ranks, this->ownTriangles(), onlyOnFirst)
                           : gathered_.gather(ranks, this->ownOrientedPoints(), onlyOnFirst);
}

const std::vector<TrianglesView>& InputViews::ownTriangles()
{
  if (!ownTriangles_)
  {
    std::vector<TrianglesView> views;
    for (vtkPointSet* leaf : leaves_)
    {
      this->addTriangles(leaf, views);
    }
    ownTriangles_ = std::move(views);
  }
  return *ownTriangles_;
}

const MeshVertices& InputViews::verticesOf(vtkPointSet* mesh)
{
  std::vector<TrianglesView> views;
  this->addTriangles(mesh, views);
  SerialExecutor serial;
  const auto points = static_cast<std::size_t>(mesh->GetNumberOfPoints());
  vertices_.push_back(
    executor_ ? meshVertices(views, points, *executor_) : meshVertices(views, points, serial));
  return vertices_.back();
}

const std::vector<OrientedPointsView>& InputViews::ownOrientedPoints()
{
  if (!ownPoints_)
  {
    ownPoints_ = this->findOrientedPoints();
  }
  return *ownPoints_;
}

std::vector<OrientedPointsView> InputViews::findOrientedPoints()
{
  const bool withoutNormals = this->lacksNormals();
  if (withoutNormals && !options_.estimateNormals)
  {
    throw Refusal(missingNormals());
  }
  lookAtViewpoints_ =
    withoutNormals && std::all_of(leaves_.begin(), leaves_.end(),
                        [this](vtkPointSet* leaf) { return this->viewpointsOf(leaf) != nullptr; });
  std::vector<OrientedPointsView> views;
  pointSets_.clear();
  blocksOfPoints_.clear();
  for (std::size_t n = 0; n < leaves_.size(); ++n)
  {
    vtkPointSet* const source = leaves_[n];
    // Points inside of a volume mesh are no points of its surface.
    const bool isMesh = hasFaces(source);
    vtkPointSet* leaf = isMesh ? this->skinOf(source) : source;
    if (leaf->GetNumberOfPoints() == 0)
    {
      continue;
    }
    if (options_.areas == AreaSource::mesh && !isMesh)
    {
      throw Refusal(messageOf(Sentence::noAreasFromMesh));
    }
    OrientedPointsView view;
    view.positions = this->vectorsOf(leaf->GetPoints()->GetData());
    vtkDataArray* ownNormals = normalsOf(leaf, options_.normalsArray);
    if (isMesh && ownNormals && !haveDirections(this->vectorsOf(ownNormals)))
    {
      ownNormals = nullptr; // the faces have directions
    }
    const MeshVertices* vertices = isMesh && (!ownNormals || options_.areas == AreaSource::mesh)
                                     ? &this->verticesOf(leaf)
                                     : nullptr;
    // The normals of a part are left out where another part has none, for all points are to be
    // oriented together.
    if (!withoutNormals)
    {
      view.normals = ownNormals ? this->vectorsOf(ownNormals) : vertices->normals();
    }
    else if (lookAtViewpoints_)
    {
      view.normals = this->directionsTo(this->viewpointsOf(leaf), view.positions);
    }
    if (vtkDataArray* areas = this->areasOf(leaf))
    {
      view.areas = this->scalarsOf(areas);
    }
    else if (options_.areas == AreaSource::mesh)
    {
      view.areas = vertices->areas();
    }
    views.push_back(view);
    pointSets_.push_back(leaf);
    blocksOfPoints_.push_back(blocks_[n]);
  }
  return views;
}

Message onlyLines()
{
  return messageOf(Sentence::onlyLines);
}

std::vector<VectorsView> InputViews::points()
{
  std::vector<VectorsView> views;
  if (isGathered_)
  {
    for (const TrianglesView& view : gathered_.triangles())
    {
      views.push_back(view.points);
    }
    for (const OrientedPointsView& view : gathered_.orientedPoints())
    {
      views.push_back(view.positions);
    }
    return this->welded(views);
  }
  for (vtkPointSet* leaf : leaves_)
  {
    vtkPointSet* own = isSurface_ ? this->skinOf(leaf) : leaf;
    if (own->GetNumberOfPoints() > 0)
    {
      views.push_back(this->vectorsOf(own->GetPoints()->GetData()));
    }
  }
  return this->welded(views);
}

} // namespace winding
