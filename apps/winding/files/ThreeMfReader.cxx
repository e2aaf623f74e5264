#include "files/ThreeMfReader.h"

#include "files/ThreeMfModel.h"
#include "files/ZipArchive.h"
#include "program/Failure.h"

#include "vtkCommand.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(ThreeMfReader);

namespace
{

/// How deep components may lie in each other.
constexpr int deepest = 100;

struct Unit
{
  const char* name;
  const char* many;
  double millimetres;
};

constexpr Unit units[] = {{"micron", "micrometres", 0.001}, {"millimeter", "millimetres", 1},
  {"centimeter", "centimetres", 10}, {"inch", "inches", 25.4}, {"foot", "feet", 304.8},
  {"meter", "metres", 1000}};

/// Returns the part of a mesh that has the triangles from `first` to `last`, and their points.
MeshBlock partOf(const MeshBlock& mesh, std::size_t first, std::size_t last)
{
  MeshBlock part;
  std::map<vtkIdType, vtkIdType> numbers;
  for (std::size_t i = first; i <= last && i < mesh.triangles.size(); ++i)
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
      }
      corner = place->second;
    }
    part.triangles.push_back(triangle);
  }
  return part;
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

/// Makes blocks of the build of a package.
class Build
{
public:
  explicit Build(const std::string& fileName)
    : fileName_(fileName)
    , archive_(fileName)
    , first_(firstPartOf(archive_))
    , slicerObjects_(readSlicerObjects(archive_))
  {
    const ThreeMfModel& model = this->model(first_);
    const Unit& unit = this->unitOf(model);
    if (unit.millimetres != 1)
    {
      notes.push_back(std::string("its numbers are ") + unit.many + ", not millimetres");
    }
    for (const ThreeMfPlace& place : model.items.empty() ? topsOf(model) : model.items)
    {
      this->add(place, first_, Eigen::Matrix4d::Identity(), "", 0);
    }
    this->note(supports_, "is a support and is", "are supports and are");
    this->note(modifiers_, "is a modifier or a negative of a slicer and is",
      "are modifiers or negatives of a slicer and are");
  }

  std::vector<MeshBlock> blocks;
  std::vector<std::string> notes;

private:
  [[noreturn]] void refuse(const std::string& what) const
  {
    throw Failure(EXIT_REFUSED, fileName_, what);
  }

  void note(int count, const char* one, const char* several)
  {
    if (count > 0)
    {
      notes.push_back((count == 1 ? std::string("one of its parts ") + one
                                  : std::to_string(count) + " of its parts " + several) +
                      " left out");
    }
  }

  const Unit& unitOf(const ThreeMfModel& model) const
  {
    const Unit* const unit = std::find_if(std::begin(units), std::end(units),
      [&model](const Unit& known) { return model.unit == known.name; });
    if (unit == std::end(units))
    {
      this->refuse("has the unit '" + model.unit + "', which 3MF does not know; it is damaged");
    }
    return *unit;
  }

  /// A model part, which is read once.
  const ThreeMfModel& model(const std::string& part)
  {
    const auto [place, isNew] = models_.try_emplace(part);
    if (isNew)
    {
      place->second = readThreeMfModel(archive_, part);
      for (const std::string& extension : place->second.extensions)
      {
        const char* const known[] = {"/production/", "/material/", "/trianglesets/", "/slice/"};
        if (std::none_of(std::begin(known), std::end(known),
              [&extension](const char* name) { return extension.find(name) != std::string::npos; }))
        {
          this->refuse(
            "needs the extension " + extension + " of 3MF; export it without, or as .stl");
        }
      }
    }
    return place->second;
  }

  /// The objects that are components of no other.
  static std::vector<ThreeMfPlace> topsOf(const ThreeMfModel& model)
  {
    std::set<std::string> below;
    for (const auto& [id, object] : model.objects)
    {
      for (const ThreeMfPlace& component : object.components)
      {
        below.insert(component.id);
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

  /// Returns the slicer's notes on an object. Objects of other model parts have none.
  const SlicerObject& notedOn(const std::string& part, const std::string& id) const
  {
    static const SlicerObject nothing;
    const auto found = slicerObjects_.find(id);
    return part == first_ && found != slicerObjects_.end() ? found->second : nothing;
  }

  /// Adds the meshes of an object that a model part places. `name` is the one of its place.
  void add(const ThreeMfPlace& place, const std::string& placedBy, const Eigen::Matrix4d& outer,
    const std::string& name, int depth)
  {
    const std::string part = place.part.empty() ? placedBy : place.part;
    const ThreeMfModel& model = this->model(part);
    const auto found = model.objects.find(place.id);
    if (found == model.objects.end())
    {
      this->refuse("refers to an object " + place.id + " that is not there; it is damaged");
    }
    if (depth > deepest)
    {
      this->refuse("its object " + place.id + " is a component of itself; it is damaged");
    }
    const ThreeMfObject& object = found->second;
    if (object.type == "support" || object.type == "solidsupport" || object.type == "other")
    {
      ++supports_;
      return;
    }
    const SlicerObject& noted = this->notedOn(part, place.id);
    const Eigen::Matrix4d transform = outer * place.transform;
    const std::string own = firstThatIs({noted.name, object.mesh.name, name});
    this->addMesh(object.mesh, noted.ranges, this->unitOf(model).millimetres, transform, own);
    for (const ThreeMfPlace& component : object.components)
    {
      const auto& parts = noted.components;
      const auto of = std::find_if(parts.begin(), parts.end(),
        [&component](const SlicerPart& one) { return one.component == component.id; });
      if (of != parts.end() && !of->isSolid)
      {
        ++modifiers_;
        continue;
      }
      const std::string placeName = of == parts.end() ? "" : of->name;
      this->add(component, part, transform, firstThatIs({placeName, own}), depth + 1);
    }
  }

  void addMesh(const MeshBlock& mesh, const std::vector<SlicerPart>& ranges, double unit,
    const Eigen::Matrix4d& transform, const std::string& name)
  {
    const double scale = unit / this->unitOf(models_.at(first_)).millimetres;
    if (ranges.empty() && !mesh.triangles.empty())
    {
      this->addBlock(mesh, scale, transform, name);
    }
    for (const SlicerPart& range : ranges)
    {
      if (!range.isSolid)
      {
        ++modifiers_;
        continue;
      }
      this->addBlock(partOf(mesh, range.firstTriangle, range.lastTriangle), scale, transform,
        firstThatIs({range.name, name}));
    }
  }

  void addBlock(
    MeshBlock block, double scale, const Eigen::Matrix4d& transform, const std::string& name)
  {
    block.name = name;
    const Eigen::Matrix3d turn = transform.topLeftCorner<3, 3>();
    const Eigen::Vector3d shift = transform.topRightCorner<3, 1>();
    for (Eigen::Vector3d& point : block.points)
    {
      point = scale * turn * point + shift;
    }
    if (turn.determinant() < 0)
    {
      for (auto& triangle : block.triangles)
      {
        std::swap(triangle[1], triangle[2]);
      }
    }
    blocks.push_back(std::move(block));
  }

  std::string fileName_;
  ZipArchive archive_;
  std::string first_;                                 ///< the name of the first model part
  std::map<std::string, SlicerObject> slicerObjects_; ///< of the first model part, by id
  std::map<std::string, ThreeMfModel> models_;        ///< by the names of parts
  int supports_ = 0;
  int modifiers_ = 0;
};

} // namespace

ThreeMfReader::ThreeMfReader()
{
  this->SetNumberOfInputPorts(0);
}

int ThreeMfReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkMultiBlockDataSet* const output = vtkMultiBlockDataSet::GetData(outputs, 0);
  Build build(fileName_);
  for (const MeshBlock& block : build.blocks)
  {
    appendBlock(block, output);
  }
  for (std::string& note : build.notes)
  {
    this->InvokeEvent(vtkCommand::MessageEvent, note.data());
  }
  return 1;
}
