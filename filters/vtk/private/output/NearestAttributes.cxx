// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/output/NearestAttributes.h"

#include "base/Refusal.h"
#include "pipeline/FreeMemory.h"
#include "pipeline/Ranks.h"
#include "private/source/SourceParts.h"
#include "tasks/Sentences.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace winding
{

namespace
{

/// The number of places that are held at once.
constexpr std::size_t placesAtOnce = std::size_t{1} << 20;

/// Whether an array is taken for colours.
bool isOfColors(vtkAbstractArray* array)
{
  const int components = array->GetNumberOfComponents();
  return array->GetDataType() == VTK_UNSIGNED_CHAR && (components == 3 || components == 4);
}

/// Whether an array has values in between: floats, and colours.
bool isContinuous(vtkAbstractArray* array)
{
  return array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE ||
         isOfColors(array);
}

/// Whether the items of an array may be written by several threads at once.
bool isThreadSafe(vtkAbstractArray* array)
{
  return vtkDataArray::SafeDownCast(array) && array->GetDataType() != VTK_BIT;
}

/// Returns an array of `count` items as `model` has.
vtkSmartPointer<vtkAbstractArray> arrayLike(vtkAbstractArray* model, vtkIdType count)
{
  // The same class as an implicit array's could not be written.
  auto array =
    vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(model->GetDataType()));
  array->SetName(model->GetName());
  array->SetNumberOfComponents(model->GetNumberOfComponents());
  array->CopyComponentNames(model);
  array->SetNumberOfTuples(count);
  return array;
}

/// Returns the array of names that belongs to an array of numbers, "ObjectNames" to "ObjectIds".
vtkStringArray* namesOf(vtkFieldData* fields, const std::string& ids)
{
  constexpr std::size_t suffix = 3; // of "Ids"
  const bool isOfIds = ids.size() > suffix && ids.compare(ids.size() - suffix, suffix, "Ids") == 0;
  return isOfIds ? vtkStringArray::SafeDownCast(fields->GetAbstractArray(
                     (ids.substr(0, ids.size() - suffix) + "Names").c_str()))
                 : nullptr;
}

bool areSameTexts(vtkStringArray* a, vtkStringArray* b)
{
  bool areSame = !a == !b && (!a || a->GetNumberOfValues() == b->GetNumberOfValues());
  for (vtkIdType n = 0; areSame && a && n < a->GetNumberOfValues(); ++n)
  {
    areSame = a->GetValue(n) == b->GetValue(n);
  }
  return areSame;
}

/// Whether numbers of an array stay what they are in a longer list of names.
bool hasRoomForNames(vtkAbstractArray* array)
{
  const int type = array->GetDataType();
  return array->GetNumberOfComponents() == 1 &&
         (type == VTK_INT || type == VTK_LONG || type == VTK_LONG_LONG || type == VTK_ID_TYPE);
}

/// Returns the array that has the name of another, or colours by the name for three components or
/// four; null if there is none.
vtkAbstractArray* sameIn(vtkDataSetAttributes* attributes, vtkAbstractArray* array)
{
  const std::string name = array->GetName();
  vtkAbstractArray* const same = attributes->GetAbstractArray(name.c_str());
  const char* const other = name == "RGB" ? "RGBA" : name == "RGBA" ? "RGB" : nullptr;
  return same || !other || !isOfColors(array) ? same : attributes->GetAbstractArray(other);
}

/// Appends a name to a list, each once.
void addName(std::vector<std::string>& names, const std::string& name)
{
  if (std::find(names.begin(), names.end(), name) == names.end())
  {
    names.push_back(name);
  }
}

std::string listOf(const std::vector<std::string>& names)
{
  std::string list;
  for (const std::string& name : names)
  {
    list += (list.empty() ? "" : ", ") + name;
  }
  return list;
}

} // namespace

/// A part of the source that a view shows.
struct NearestAttributes::Part
{
  vtkPointSet* data;
  unsigned block;
  std::vector<vtkIdType> cells; ///< by triangle; empty where they follow each other
  vtkIdType firstCell;

  vtkDataSetAttributes* attributes(bool ofPoints) const
  {
    return ofPoints ? static_cast<vtkDataSetAttributes*>(data->GetPointData())
                    : data->GetCellData();
  }
};

struct NearestAttributes::Transfer
{
  vtkAbstractArray* model;                ///< the first of the parts'
  std::vector<vtkAbstractArray*> ofParts; ///< null for parts without colours
  bool interpolates;
  int active; ///< type of the attribute that the array is in the source, or -1
  vtkSmartPointer<vtkStringArray> names; ///< of the numbers that the array has; may be null
  /// Numbers of the names of each part in `names`; empty where these are the part's own.
  std::vector<std::vector<vtkIdType>> united;

  /// Unites the names of parts, null for none. Returns whether all have some that go together.
  bool unite(const std::vector<vtkStringArray*>& ofEachPart);

  /// Writes item `n` of an array: the mean of items by their weights, or the one of largest weight.
  void write(vtkAbstractArray* to, vtkIdType n, std::size_t part, const vtkIdType* items,
    const std::array<double, 3>& weights, std::size_t count) const;

  /// Writes item `n` of an array where nothing is near.
  void writeNothing(vtkAbstractArray* to, vtkIdType n) const;
};

bool NearestAttributes::Transfer::unite(const std::vector<vtkStringArray*>& ofEachPart)
{
  const auto isSame = [&](vtkStringArray* other)
  {
    return areSameTexts(ofEachPart.front(), other);
  };
  if (std::all_of(ofEachPart.begin(), ofEachPart.end(), isSame))
  {
    names = ofEachPart.front();
    return true;
  }
  const bool haveAll = std::find(ofEachPart.begin(), ofEachPart.end(), nullptr) == ofEachPart.end();
  if (!haveAll || !hasRoomForNames(model))
  {
    return false;
  }
  names = vtkSmartPointer<vtkStringArray>::New();
  names->SetName(ofEachPart.front()->GetName());
  std::map<std::string, vtkIdType> known;
  for (vtkStringArray* own : ofEachPart)
  {
    std::vector<vtkIdType>& ofPart = united.emplace_back();
    for (vtkIdType n = 0; n < own->GetNumberOfValues(); ++n)
    {
      const auto [found, isNew] = known.emplace(own->GetValue(n), names->GetNumberOfValues());
      ofPart.push_back(found->second);
      if (isNew)
      {
        names->InsertNextValue(own->GetValue(n));
      }
    }
  }
  return true;
}

void NearestAttributes::Transfer::write(vtkAbstractArray* to, vtkIdType n, std::size_t part,
  const vtkIdType* items, const std::array<double, 3>& weights, std::size_t count) const
{
  const bool areBytes = to->GetDataType() == VTK_UNSIGNED_CHAR;
  if (!interpolates || (count == 1 && !areBytes))
  {
    std::size_t best = 0;
    for (std::size_t i = 1; i < count; ++i)
    {
      const bool isBetter =
        weights[i] > weights[best] || (weights[i] == weights[best] && items[i] < items[best]);
      best = isBetter ? i : best;
    }
    to->SetTuple(n, items[best], ofParts[part]);
    if (!united.empty())
    {
      auto* const ids = static_cast<vtkDataArray*>(to);
      const double id = ids->GetComponent(n, 0);
      const std::vector<vtkIdType>& ofPart = united[part];
      const bool isNamed = id >= 0 && id < static_cast<double>(ofPart.size());
      ids->SetComponent(
        n, 0, isNamed ? static_cast<double>(ofPart[static_cast<std::size_t>(id)]) : -1);
    }
    return;
  }
  auto* const from = static_cast<vtkDataArray*>(ofParts[part]);
  auto* const numbers = static_cast<vtkDataArray*>(to);
  const int known = from ? from->GetNumberOfComponents() : 0;
  for (int component = 0; component < numbers->GetNumberOfComponents(); ++component)
  {
    constexpr double half = 0.5, most = 255;
    double sum = component < known ? 0 : most; // colours are white and opaque unless they say more
    for (std::size_t i = 0; i < count && component < known; ++i)
    {
      // A corner without weight may have no number.
      const double weight = count == 1 ? 1 : weights[i];
      sum += weight > 0 ? weight * from->GetComponent(items[i], component) : 0;
    }
    numbers->SetComponent(n, component, areBytes ? std::min(std::floor(sum + half), most) : sum);
  }
}

void NearestAttributes::Transfer::writeNothing(vtkAbstractArray* to, vtkIdType n) const
{
  auto* const numbers = vtkDataArray::SafeDownCast(to);
  const bool areReal = to->GetDataType() == VTK_FLOAT || to->GetDataType() == VTK_DOUBLE;
  for (int component = 0; numbers && component < to->GetNumberOfComponents(); ++component)
  {
    numbers->SetComponent(n, component, areReal ? std::numeric_limits<double>::quiet_NaN() : 0);
  }
}

NearestAttributes::NearestAttributes(vtkDataObject* source, const SourceOptions& options,
  const NearestOptions& nearest, Executor& executor)
  : options_(nearest)
  , isComposite_(vtkCompositeDataSet::SafeDownCast(source) != nullptr)
  , views_((refuseNearestOfMixed(source, options.input), source), options.input, &executor, true)
{
  if (views_.isSurface() || views_.isEmpty())
  {
    triangles_ = views_.triangles();
    const std::vector<ViewedPart> shown = views_.viewedParts();
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < shown.size(); ++i)
    {
      vtkPolyData* const data = shown[i].data;
      Part part = {data, shown[i].block, {}, data->GetNumberOfVerts() + data->GetNumberOfLines()};
      part.firstCell += shown[i].areStrips ? data->GetNumberOfPolys() : 0;
      vtkCellArray* const cells = shown[i].areStrips ? data->GetStrips() : data->GetPolys();
      triangles += triangles_[i].triangles.size();
      if (shown[i].areStrips || triangles_[i].isContinued)
      {
        part.cells.reserve(triangles_[i].triangles.size());
        for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
        {
          const vtkIdType pieces = std::max<vtkIdType>(cells->GetCellSize(cell) - 2, 0);
          part.cells.insert(
            part.cells.end(), static_cast<std::size_t>(pieces), part.firstCell + cell);
        }
      }
      parts_.push_back(std::move(part));
    }
    refuseBeyondFreeMemory(static_cast<double>(bytesFor(true, triangles)),
      "the search for the nearest of " + std::to_string(triangles) + " triangles", {});
    places_ = std::make_unique<InputPlaces>(triangles_, options.field.mirror, executor);
  }
  else
  {
    const std::vector<OrientedPointsView> points = views_.orientedPoints();
    std::size_t count = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      parts_.push_back({views_.pointSets()[i], views_.blocksOfPoints()[i], {}, 0});
      count += points[i].positions.size();
    }
    refuseBeyondFreeMemory(static_cast<double>(bytesFor(false, count)),
      "the search for the nearest of " + std::to_string(count) + " points", {});
    places_ = std::make_unique<InputPlaces>(points, options.field.mirror, executor);
  }
  if (options_.withAttributes)
  {
    this->findArrays(true, ofPoints_);
    if (!triangles_.empty())
    {
      this->findArrays(false, ofCells_);
    }
  }
}

NearestAttributes::~NearestAttributes() = default;

std::size_t NearestAttributes::bytesFor(bool isSurface, std::size_t primitives)
{
  return InputPlaces::bytesFor(isSurface, primitives) +
         std::min(placesAtOnce, primitives) * sizeof(InputPlace);
}

/// Finds the arrays that all parts have, and the names of all others.
void NearestAttributes::findArrays(bool ofPoints, std::vector<Transfer>& transfers)
{
  std::set<std::string> names = {vtkDataSetAttributes::GhostArrayName(),
    InputViews::nameOfNumbers(), "vtkOriginalCellIds", "vtkOriginalPointIds"};
  for (const Part& part : parts_)
  {
    vtkDataSetAttributes* const attributes = part.attributes(ofPoints);
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* const array = attributes->GetAbstractArray(i);
      if (!array->GetName() || !names.insert(array->GetName()).second)
      {
        continue;
      }
      Transfer transfer = {
        array, {}, isContinuous(array), attributes->IsArrayAnAttribute(i), {}, {}};
      std::vector<vtkStringArray*> namesOfParts;
      bool areLike = true, haveAll = true;
      for (const Part& other : parts_)
      {
        vtkAbstractArray* const same = sameIn(other.attributes(ofPoints), array);
        if (isOfColors(array))
        {
          areLike = areLike && (!same || isOfColors(same));
          const bool hasMore =
            same && same->GetNumberOfComponents() > transfer.model->GetNumberOfComponents();
          transfer.model = hasMore ? same : transfer.model;
          names.insert(same ? same->GetName() : array->GetName());
        }
        else
        {
          areLike = areLike && same && same->GetDataType() == array->GetDataType() &&
                    same->GetNumberOfComponents() == array->GetNumberOfComponents();
        }
        haveAll = haveAll && same;
        transfer.ofParts.push_back(same);
        namesOfParts.push_back(namesOf(other.data->GetFieldData(), array->GetName()));
      }
      if (areLike && !haveAll)
      {
        addName(filled_, transfer.model->GetName());
      }
      if (areLike && transfer.unite(namesOfParts))
      {
        transfers.push_back(std::move(transfer));
      }
      else
      {
        addName(leftOut_, array->GetName());
      }
    }
  }
}

/// Whether the result has an array of a name already, or gets one of its own.
bool NearestAttributes::isTaken(const std::string& name, vtkDataSetAttributes* to) const
{
  return to->HasArray(name.c_str()) ||
         (options_.withNumbers &&
           (name == "NearestCell" || (isComposite_ && name == "NearestBlock")));
}

/// Notes the arrays whose names the result has already, and whether there are others. Normals are
/// its own, as any surface's.
void NearestAttributes::noteTaken(bool ofPoints, vtkDataSetAttributes* to) const
{
  vtkDataArray* const normals = to->GetNormals();
  const std::string own = normals && normals->GetName() ? normals->GetName() : "";
  for (const Transfer& transfer : ofPoints ? ofPoints_ : ofCells_)
  {
    const std::string name = transfer.model->GetName();
    addsAny_ = addsAny_ || !this->isTaken(name, to);
    if (transfer.active != vtkDataSetAttributes::NORMALS && name != own && this->isTaken(name, to))
    {
      addName(taken_, name);
    }
  }
}

/// Returns the index of the cell of a part that has a place.
vtkIdType NearestAttributes::cellOf(const InputPlace& place) const
{
  const Part& part = parts_[place.view];
  return part.cells.empty() ? part.firstCell + place.primitive : part.cells[place.primitive];
}

NearestAttributes::FindPlaces NearestAttributes::searchAt(
  const PositionOf& positionOf, Executor& executor) const
{
  return [this, &positionOf, &executor](std::size_t first, std::size_t count, InputPlace* places)
  {
    places_->find(
      count, [&](std::size_t n) { return positionOf(first + n); }, places, executor);
  };
}

void NearestAttributes::addNumbers(
  const Grid& grid, const Extent& extent, vtkDataSetAttributes* to, Executor& executor) const
{
  // Whole layers are found at once.
  const std::size_t count = sampleCount(extent);
  const auto layers = static_cast<std::size_t>(std::max(extent[5] - extent[4] + 1, 1));
  const std::size_t ofLayer = std::max<std::size_t>(count / layers, 1);
  const std::size_t layersAtOnce = std::max<std::size_t>(placesAtOnce / ofLayer, 1);
  this->add(
    true, count, layersAtOnce * ofLayer,
    [&](std::size_t first, std::size_t some, InputPlace* places)
    {
      Extent part = extent;
      part[4] += static_cast<int>(first / ofLayer);
      part[5] = part[4] + static_cast<int>(some / ofLayer) - 1;
      places_->findOnGrid(grid, part, places, executor);
    },
    to, executor);
}

void NearestAttributes::addNumbers(std::size_t count, const PositionOf& positionOf,
  vtkDataSetAttributes* to, Executor& executor) const
{
  std::vector<double> positions;
  this->add(
    true, count, placesAtOnce,
    [&](std::size_t first, std::size_t some, InputPlace* places)
    {
      positions.resize(3 * some);
      for (std::size_t n = 0; n < some; ++n)
      {
        Eigen::Vector3d::Map(&positions[3 * n]) = positionOf(first + n);
      }
      places_->findAt({positions.data(), some}, places, executor);
    },
    to, executor);
}

void NearestAttributes::add(bool ofPoints, std::size_t count, std::size_t atOnce,
  const FindPlaces& find, vtkDataSetAttributes* to, Executor& executor) const
{
  const bool areCells = !triangles_.empty();
  const auto items = static_cast<vtkIdType>(count);
  vtkNew<vtkIdTypeArray> cells;
  vtkNew<vtkIntArray> blocks;
  cells->SetName("NearestCell");
  blocks->SetName("NearestBlock");
  cells->SetNumberOfValues(options_.withNumbers ? items : 0);
  blocks->SetNumberOfValues(options_.withNumbers && isComposite_ ? items : 0);
  std::vector<std::pair<const Transfer*, vtkSmartPointer<vtkAbstractArray>>> arrays;
  for (const Transfer& transfer : ofPoints ? ofPoints_ : ofCells_)
  {
    if (!this->isTaken(transfer.model->GetName(), to))
    {
      arrays.emplace_back(&transfer, arrayLike(transfer.model, items));
    }
  }
  std::vector<InputPlace> places(std::min(count, atOnce));
  const auto write = [&](std::size_t n, const InputPlace& place, bool byThreads)
  {
    const auto item = static_cast<vtkIdType>(n);
    vtkIdType ids[3] = {place.primitive, 0, 0};
    std::size_t corners = 1;
    if (place.exists() && areCells && ofPoints)
    {
      corners = 3;
      for (std::size_t corner = 0; corner < corners; ++corner)
      {
        ids[corner] = triangles_[place.view].triangles(place.primitive, corner);
      }
    }
    else if (place.exists() && areCells)
    {
      ids[0] = this->cellOf(place);
    }
    for (const auto& [transfer, array] : arrays)
    {
      if (isThreadSafe(array) != byThreads)
      {
        continue;
      }
      if (place.exists())
      {
        transfer->write(array, item, place.view, ids, place.weights, corners);
      }
      else
      {
        transfer->writeNothing(array, item);
      }
    }
    if (options_.withNumbers && byThreads)
    {
      vtkIdType number = -1;
      if (place.exists())
      {
        number = InputViews::numberOf(parts_[place.view].attributes(!areCells),
          areCells ? this->cellOf(place) : static_cast<vtkIdType>(place.primitive));
      }
      cells->SetValue(item, number);
      if (isComposite_)
      {
        blocks->SetValue(item, place.exists() ? static_cast<int>(parts_[place.view].block) : -1);
      }
    }
  };
  const bool isSerialAny = std::any_of(
    arrays.begin(), arrays.end(), [](const auto& pair) { return !isThreadSafe(pair.second); });
  for (std::size_t first = 0; first < count; first += atOnce)
  {
    const std::size_t some = std::min(atOnce, count - first);
    find(first, some, places.data());
    forEachItem(
      some, [&](std::size_t n) { write(first + n, places[n], true); }, executor);
    for (std::size_t n = 0; n < some && isSerialAny; ++n)
    {
      write(first + n, places[n], false);
    }
  }
  for (const auto& [transfer, array] : arrays)
  {
    to->AddArray(array);
    if (transfer->active >= 0 && !to->GetAbstractAttribute(transfer->active))
    {
      to->SetActiveAttribute(array->GetName(), transfer->active);
    }
  }
  if (options_.withNumbers)
  {
    to->AddArray(cells);
    if (isComposite_)
    {
      to->AddArray(blocks);
    }
  }
}

void NearestAttributes::addPointData(std::size_t count, const PositionOf& positionOf,
  vtkDataSetAttributes* to, Executor& executor) const
{
  this->add(true, count, placesAtOnce, this->searchAt(positionOf, executor), to, executor);
}

void NearestAttributes::addCellData(std::size_t count, const PositionOf& positionOf,
  vtkDataSetAttributes* to, Executor& executor) const
{
  this->add(false, count, placesAtOnce, this->searchAt(positionOf, executor), to, executor);
}

void NearestAttributes::addTo(vtkPolyData* surface, Executor& executor) const
{
  this->noteTaken(true, surface->GetPointData());
  this->noteTaken(false, surface->GetCellData());
  if (options_.withNumbers || !ofPoints_.empty())
  {
    this->addPointData(
      static_cast<std::size_t>(surface->GetNumberOfPoints()),
      [surface](std::size_t n)
      {
        Eigen::Vector3d position;
        surface->GetPoints()->GetPoint(static_cast<vtkIdType>(n), position.data());
        return position;
      },
      surface->GetPointData(), executor);
  }
  if (options_.withNumbers || !ofCells_.empty())
  {
    this->addCellData(
      static_cast<std::size_t>(surface->GetNumberOfCells()),
      [surface](std::size_t n)
      {
        vtkIdType corners = 0;
        const vtkIdType* ids = nullptr;
        surface->GetPolys()->GetCellAtId(static_cast<vtkIdType>(n), corners, ids);
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (vtkIdType i = 0; i < corners; ++i)
        {
          Eigen::Vector3d position;
          surface->GetPoints()->GetPoint(ids[i], position.data());
          sum += position / static_cast<double>(corners);
        }
        return sum;
      },
      surface->GetCellData(), executor);
  }
  for (const std::vector<Transfer>* transfers : {&ofPoints_, &ofCells_})
  {
    for (const Transfer& transfer : *transfers)
    {
      if (transfer.names && !surface->GetFieldData()->HasArray(transfer.names->GetName()))
      {
        surface->GetFieldData()->AddArray(transfer.names);
      }
    }
  }
}

std::vector<Message> NearestAttributes::notes() const
{
  std::vector<Message> notes;
  const auto are = [](const std::vector<std::string>& names)
  {
    return names.size() == 1 ? std::string("is") : std::string("are");
  };
  if (!leftOut_.empty())
  {
    const std::string own = taken_.empty() ? ""
                                           : ", nor " + are(taken_) + " " + listOf(taken_) +
                                               ", which the result has of its own";
    notes.push_back(
      messageOf(Sentence::otherArrays, {listOf(leftOut_) + " " + are(leftOut_), own}));
  }
  else if (!taken_.empty())
  {
    notes.push_back(messageOf(Sentence::arraysOfResult, {listOf(taken_) + " " + are(taken_)}));
  }
  if (!filled_.empty())
  {
    notes.push_back(messageOf(Sentence::noColorsOfSome, {listOf(filled_) + " " + are(filled_)}));
  }
  if (options_.withAttributes && !parts_.empty() && !addsAny_ && notes.empty())
  {
    notes.push_back(messageOf(Sentence::noArrays));
  }
  return notes;
}

void refuseNearestOfMixed(vtkDataObject* source, const InputOptions& options)
{
  auto* const composite = vtkCompositeDataSet::SafeDownCast(source);
  if (!composite || options.asPoints)
  {
    return;
  }
  bool hasSurfaces = false, hasClouds = false;
  auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    auto* const leaf = vtkPointSet::SafeDownCast(iterator->GetCurrentDataObject());
    if (leaf && leaf->GetNumberOfPoints() > 0)
    {
      const bool isSurface = hasFaces(leaf);
      hasSurfaces = hasSurfaces || isSurface;
      hasClouds = hasClouds || (!isSurface && !isOfLines(leaf));
    }
  }
  if (hasSurfaces && hasClouds)
  {
    throw Refusal(Message("surfaces and clouds have no common nearest cells",
      {{"take inputs of one kind", {}},
        {"leave them out",
          {{Parameter::transferAttributes, 0}, {Parameter::generateNearestCells, 0}}}}));
  }
}

void refuseNearestOfOtherRanks(const Ranks& ranks, SourceDistribution distribution)
{
  if (!ranks.isAlone() && distribution != SourceDistribution::replicated)
  {
    throw Refusal(messageOf(Sentence::cellsOfOtherRanks));
  }
}

} // namespace winding
