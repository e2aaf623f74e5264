// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/ThreeMfReader.h"

#include "files/ReaderEvents.h"
#include "files/ThreeMfModel.h"
#include "files/ZipArchive.h"
#include "program/AvailableMemory.h"
#include "program/Failure.h"

#include "vtkCommand.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(ThreeMfReader);

namespace
{

/// How deep components may lie in each other.
constexpr int deepest = 1000;

/// How many bytes a byte of a package may stand for. Meshes come down to a twentieth.
constexpr double bytesPerByte = 64;

/// How many triangles a build may have.
constexpr double mostTriangles = 1 << 28;

/// The memory that a triangle and an object take here and in the program, in bytes.
constexpr double bytesOfTriangle = 150, bytesOfObject = 18000;

/// How many bytes of a file take as much memory and time to read as an object.
constexpr double fileBytesOfObject = 48;

/// The numbers of triangles and objects in a build or an object, with repetitions.
struct Size
{
  double triangles = 0, objects = 0;
};

/// Returns some triangles of a mesh by their numbers, with their points.
MeshBlock partOf(const MeshBlock& mesh, const std::vector<std::size_t>& chosen)
{
  MeshBlock part;
  std::map<vtkIdType, vtkIdType> numbers;
  for (const std::size_t i : chosen)
  {
    std::array<vtkIdType, 3> triangle = mesh.triangles[i];
    for (vtkIdType& corner : triangle)
    {
      if (corner < 0 || static_cast<std::size_t>(corner) >= mesh.points.size())
      {
        continue; // is found later, with all others of its kind
      }
      const auto next = static_cast<vtkIdType>(part.points.size());
      const auto [place, isNew] = numbers.emplace(corner, next);
      if (isNew)
      {
        part.points.push_back(mesh.points[static_cast<std::size_t>(corner)]);
        if (!mesh.colors.empty())
        {
          part.colors.push_back(mesh.colors[static_cast<std::size_t>(corner)]);
        }
      }
      corner = place->second;
    }
    part.triangles.push_back(triangle);
  }
  return part;
}

/// Returns the triangles of a mesh that are in each range, and last the ones in none; nothing where
/// ranges contradict the mesh or each other.
std::vector<std::vector<std::size_t>> trianglesIn(
  const std::vector<SlicerPart>& ranges, std::size_t triangles)
{
  std::vector<std::size_t> ofTriangle(triangles, ranges.size());
  for (std::size_t n = 0; n < ranges.size(); ++n)
  {
    const long long first = ranges[n].firstTriangle, last = ranges[n].lastTriangle;
    if (first < 0 || last < first || static_cast<std::size_t>(last) >= triangles)
    {
      return {};
    }
    for (auto i = static_cast<std::size_t>(first); i <= static_cast<std::size_t>(last); ++i)
    {
      if (ofTriangle[i] != ranges.size())
      {
        return {};
      }
      ofTriangle[i] = n;
    }
  }
  std::vector<std::vector<std::size_t>> numbers(ranges.size() + 1);
  for (std::size_t i = 0; i < triangles; ++i)
  {
    numbers[ofTriangle[i]].push_back(i);
  }
  return numbers;
}

/// The first of some names that is not empty.
std::string firstThatIs(std::initializer_list<std::string> names)
{
  for (const std::string& name : names)
  {
    if (!name.empty())
    {
      return name;
    }
  }
  return "";
}

struct Count
{
  int number;
  const char *one, *several;
};

/// Names the things that there are any of, with their numbers.
std::string counted(std::initializer_list<Count> counts)
{
  std::string words;
  for (const Count& count : counts)
  {
    if (count.number > 0)
    {
      words += (words.empty() ? "" : ", ") + std::to_string(count.number) + ' ' +
               (count.number == 1 ? count.one : count.several);
    }
  }
  return words;
}

/// Makes blocks of the build of a package.
class Build
{
public:
  explicit Build(const std::string& fileName)
    : fileName_(fileName)
    , archive_(fileName)
    , first_(firstPartOf(archive_))
  {
    try
    {
      slicerObjects_ = readSlicerObjects(archive_);
    }
    catch (const Failure& failure)
    {
      const std::string words = failure.what();
      notes_.push_back(words.substr(fileName.size() + 2) + ", so parts of a slicer are not known");
    }
  }

  double unpackedBytes() const { return archive_.unpackedBytes(bytesPerByte); }

  /// Reads all model parts, and returns what the build is made of. Refuses what is too much.
  Size size()
  {
    Size all;
    for (const ThreeMfPlace& item : this->items())
    {
      this->addSize(item, first_, 0, all);
    }
    if (all.triangles > mostTriangles || all.objects > mostObjects)
    {
      refuseRepetitions(archive_);
    }
    if (bytesOfTriangle * all.triangles + bytesOfObject * all.objects > availableMemory())
    {
      throw Failure(EXIT_NO_MEMORY, fileName_, "does not fit into memory; use a smaller one");
    }
    return all;
  }

  void addTo(vtkMultiBlockDataSet* output)
  {
    output_ = output;
    for (const auto& [part, whole] : models_)
    {
      for (const auto& [id, colors] : whole.colors)
      {
        isAnyClear_ = isAnyClear_ || areAnyClear(colors);
      }
    }
    for (const ThreeMfPlace& item : this->items())
    {
      if (!item.isPrinted)
      {
        used_.insert({item.part.empty() ? first_ : item.part, item.id});
        ++unprinted_;
        continue;
      }
      this->add(item, first_, Eigen::Matrix4d::Identity(), "");
    }
  }

  /// The lines for the user, once all is added.
  std::vector<std::string> notes()
  {
    const ThreeMfModel& model = this->model(first_);
    if (model.millimetres != 1)
    {
      notes_.push_back("its numbers are " + model.unit + ", not millimetres");
    }
    if (const std::string leftOut = this->leftOut(); !leftOut.empty())
    {
      notes_.push_back("left out: " + leftOut);
    }
    if (contradictions_ > 0)
    {
      notes_.push_back("the parts that a slicer notes contradict " +
                       std::to_string(contradictions_) + " of its meshes, and are not looked at");
    }
    return notes_;
  }

  /// Names what was not added, with numbers; empty for nothing.
  std::string leftOut() const
  {
    int unused = 0;
    for (const auto& [part, whole] : models_)
    {
      for (const auto& [id, object] : whole.objects)
      {
        unused += object.mesh.triangles.empty() || used_.count({part, id}) > 0 ? 0 : 1;
      }
    }
    return counted({{supports_, "support", "supports"},
      {modifiers_, "modifier or negative of a slicer", "modifiers or negatives of a slicer"},
      {unprinted_, "item that is not to be printed", "items that are not to be printed"},
      {empty_, "object without triangles", "objects without triangles"},
      {unused, "object outside of its build", "objects outside of its build"}});
  }

private:
  /// A model part, which is read once.
  const ThreeMfModel& model(const std::string& part)
  {
    const auto [place, isNew] = models_.try_emplace(part);
    if (isNew)
    {
      place->second = readThreeMfModel(archive_, part);
    }
    return place->second;
  }

  /// The items of the build; without any, the objects that are components of no other.
  std::vector<ThreeMfPlace> items()
  {
    const ThreeMfModel& model = this->model(first_);
    if (!model.items.empty())
    {
      return model.items;
    }
    std::set<std::string> below;
    for (const auto& [id, object] : model.objects)
    {
      for (const ThreeMfPlace& component : object.components)
      {
        if (component.part.empty() || component.part == first_)
        {
          below.insert(component.id);
        }
      }
    }
    std::vector<ThreeMfPlace> tops;
    for (const auto& [id, object] : model.objects)
    {
      if (below.count(id) == 0)
      {
        tops.emplace_back().id = id;
      }
    }
    return tops;
  }

  const ThreeMfObject& objectAt(const ThreeMfPlace& place, const std::string& part)
  {
    const ThreeMfModel& model = this->model(part);
    const auto found = model.objects.find(place.id);
    if (found == model.objects.end())
    {
      archive_.refuse("refers to an object " + place.id + " that is not there; it is damaged");
    }
    return found->second;
  }

  /// Adds the size of an object that a model part places. Each object is counted once.
  void addSize(const ThreeMfPlace& place, const std::string& placedBy, int depth, Size& to)
  {
    const std::string part = place.part.empty() ? placedBy : place.part;
    const auto [count, isNew] = sizes_.try_emplace({part, place.id}, Size{-1, 0});
    const auto addFound = [&to, &found = count->second]
    {
      to.triangles += found.triangles;
      to.objects += found.objects;
    };
    if (!isNew && count->second.triangles >= 0)
    {
      addFound();
      return;
    }
    if (!isNew || depth > deepest)
    {
      archive_.refuse(isNew
                        ? "its components lie deeper than " + std::to_string(deepest) + " levels"
                        : "its object " + place.id + " is a component of itself; it is damaged");
    }
    const ThreeMfObject& object = this->objectAt(place, part);
    Size sum{static_cast<double>(object.mesh.triangles.size()), 1};
    for (const ThreeMfPlace& component : object.components)
    {
      this->addSize(component, part, depth + 1, sum);
    }
    count->second = sum;
    addFound();
  }

  /// A slicer's notes on an object. Objects of other model parts have none.
  const SlicerObject& notedOn(const std::string& part, const std::string& id) const
  {
    static const SlicerObject nothing;
    const auto found = slicerObjects_.find(id);
    return part == first_ && found != slicerObjects_.end() ? found->second : nothing;
  }

  /// The unit of a model part in the one of the first.
  double scaleOf(const std::string& part)
  {
    return this->model(part).millimetres / this->model(first_).millimetres;
  }

  /// Adds the meshes of an object that a model part places. `name` is the one of its place.
  void add(const ThreeMfPlace& place, const std::string& placedBy, const Eigen::Matrix4d& outer,
    const std::string& name)
  {
    const std::string part = place.part.empty() ? placedBy : place.part;
    const ThreeMfObject& object = this->objectAt(place, part);
    used_.insert({part, place.id});
    if (object.purpose != ThreeMfPurpose::solid)
    {
      ++(object.purpose == ThreeMfPurpose::support ? supports_ : modifiers_);
      return;
    }
    Eigen::Matrix4d inner = place.transform;
    inner.topRightCorner<3, 1>() *= this->scaleOf(placedBy);
    const Eigen::Matrix4d transform = outer * inner;
    const SlicerObject& noted = this->notedOn(part, place.id);
    const std::string own = firstThatIs({noted.name, object.mesh.name, name});
    empty_ += object.mesh.triangles.empty() && object.components.empty() ? 1 : 0;
    this->addMesh(object.mesh, noted.ranges, this->scaleOf(part), transform, own);
    for (const ThreeMfPlace& component : object.components)
    {
      const auto& parts = noted.components;
      const auto of = std::find_if(parts.begin(), parts.end(),
        [&component](const SlicerPart& one) { return one.component == component.id; });
      if (of != parts.end() && of->purpose != ThreeMfPurpose::solid)
      {
        used_.insert({component.part.empty() ? part : component.part, component.id});
        ++modifiers_;
        continue;
      }
      const std::string placeName = of == parts.end() ? "" : of->name;
      this->add(component, part, transform, firstThatIs({placeName, own}));
    }
  }

  void addMesh(const MeshBlock& mesh, const std::vector<SlicerPart>& ranges, double scale,
    const Eigen::Matrix4d& transform, const std::string& name)
  {
    if (ranges.empty())
    {
      this->addBlock(mesh, scale, transform, name);
      return;
    }
    const auto parts = trianglesIn(ranges, mesh.triangles.size());
    if (parts.empty())
    {
      contradictions_ += mesh.triangles.empty() ? 0 : 1;
      this->addBlock(mesh, scale, transform, name);
      return;
    }
    for (std::size_t n = 0; n < parts.size(); ++n)
    {
      if (n < ranges.size() && ranges[n].purpose != ThreeMfPurpose::solid)
      {
        ++modifiers_;
        continue;
      }
      const std::string own = n < ranges.size() ? ranges[n].name : "";
      this->addBlock(partOf(mesh, parts[n]), scale, transform, firstThatIs({own, name}));
    }
  }

  void addBlock(
    MeshBlock block, double scale, const Eigen::Matrix4d& transform, const std::string& name)
  {
    if (block.triangles.empty())
    {
      return;
    }
    block.name = name;
    const Eigen::Matrix3d turn = scale * transform.topLeftCorner<3, 3>();
    const Eigen::Vector3d shift = transform.topRightCorner<3, 1>();
    for (Eigen::Vector3d& point : block.points)
    {
      point = turn * point + shift;
    }
    if (turn.determinant() < 0)
    {
      for (auto& triangle : block.triangles)
      {
        std::swap(triangle[1], triangle[2]);
      }
    }
    appendBlock(block, isAnyClear_, output_);
  }

  using ObjectKey = std::pair<std::string, std::string>; ///< a model part, and an id in it

  std::string fileName_;
  ZipArchive archive_;
  std::string first_;                                 ///< the path of the first model part
  std::map<std::string, SlicerObject> slicerObjects_; ///< of the first model part, by id
  std::map<std::string, ThreeMfModel> models_;        ///< by the paths of parts
  std::map<ObjectKey, Size> sizes_;                   ///< -1 triangles while they are counted
  std::set<ObjectKey> used_;
  vtkMultiBlockDataSet* output_ = nullptr;
  std::vector<std::string> notes_;
  int supports_ = 0, modifiers_ = 0, unprinted_ = 0, empty_ = 0, contradictions_ = 0;
  bool isAnyClear_ = false; ///< whether colors have an opacity
};

} // namespace

ThreeMfReader::ThreeMfReader()
{
  this->SetNumberOfInputPorts(0);
}

int ThreeMfReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  Build build(fileName_);
  double bytes = build.unpackedBytes();
  this->InvokeEvent(moreBytesEvent, &bytes);
  const Size size = build.size();
  bytes += size.triangles + fileBytesOfObject * size.objects; // a triangle is as much as a byte
  this->InvokeEvent(moreBytesEvent, &bytes);
  auto* const output = vtkMultiBlockDataSet::GetData(outputs, 0);
  build.addTo(output);
  if (const std::string leftOut = build.leftOut();
      output->GetNumberOfBlocks() == 0 && !leftOut.empty())
  {
    throw Failure(
      EXIT_REFUSED, fileName_, "has nothing to be made, only " + leftOut + "; give another file");
  }
  for (std::string& note : build.notes())
  {
    this->InvokeEvent(vtkCommand::MessageEvent, note.data());
  }
  return 1;
}
