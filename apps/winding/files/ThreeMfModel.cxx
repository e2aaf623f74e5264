#include "files/ThreeMfModel.h"

#include "files/Text.h"
#include "files/ZipArchive.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkXMLParser.h"

#include <cstdlib>
#include <functional>
#include <limits>
#include <string_view>

namespace
{

bool endsWith(std::string_view text, std::string_view end)
{
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

/// The attributes of an element.
class Attributes
{
public:
  explicit Attributes(const char** pairs)
    : pairs_(pairs)
  {
  }

  /// The value of an attribute; null where there is none.
  const char* find(std::string_view name) const
  {
    for (const char** pair = pairs_; *pair; pair += 2)
    {
      if (name == *pair)
      {
        return pair[1];
      }
    }
    return nullptr;
  }

  std::string text(std::string_view name) const
  {
    const char* const value = this->find(name);
    return value ? value : "";
  }

  double number(std::string_view name) const
  {
    const char* const value = this->find(name);
    return value ? std::strtod(value, nullptr) : std::numeric_limits<double>::quiet_NaN();
  }

  /// A whole number; -1 where there is none.
  vtkIdType index(std::string_view name) const
  {
    long long number = -1;
    const char* const value = this->find(name);
    return value && parseInteger(value, number) ? static_cast<vtkIdType>(number) : -1;
  }

  /// The path of a part, by the production extension; else empty.
  std::string pathOfPart() const
  {
    for (const char** pair = pairs_; *pair; pair += 2)
    {
      if (endsWith(*pair, ":path"))
      {
        return pair[1];
      }
    }
    return "";
  }

private:
  const char** pairs_;
};

/// Calls a function for each element of a text that begins.
class ElementParser : public vtkXMLParser
{
public:
  static ElementParser* New();
  vtkTypeMacro(ElementParser, vtkXMLParser);

  std::function<void(std::string_view, const Attributes&)> start;

protected:
  void StartElement(const char* name, const char** attributes) override
  {
    start(name, Attributes(attributes));
  }
  void EndElement(const char*) override {}
};

vtkStandardNewMacro(ElementParser);

/// Calls `start` for each element of a file that begins. VTK reports what is no XML.
void forEachElement(const ZipArchive& archive, const std::string& name,
  const std::function<void(std::string_view, const Attributes&)>& start)
{
  vtkNew<ElementParser> parser;
  parser->start = start;
  parser->InitializeParser();
  archive.read(name, [&parser](std::string_view bytes)
    { parser->ParseChunk(bytes.data(), static_cast<unsigned int>(bytes.size())); });
  parser->CleanupParser();
}

/// The matrix of twelve numbers, which the format applies to rows.
Eigen::Matrix4d transformOf(const std::string& text)
{
  Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();
  std::string_view left = text;
  for (Eigen::Index i = 0; i < 12 && !text.empty(); ++i)
  {
    const std::string word(takeWord(left));
    transform(i % 3, i / 3) =
      word.empty() ? std::numeric_limits<double>::quiet_NaN() : std::strtod(word.c_str(), nullptr);
  }
  return transform;
}

/// The name of a part in the archive, without the slash in front.
std::string inArchive(std::string part)
{
  part.erase(0, part.find_first_not_of('/'));
  return part;
}

ThreeMfPlace placeOf(const Attributes& attributes)
{
  ThreeMfPlace place;
  place.part = inArchive(attributes.pathOfPart());
  place.id = attributes.text("objectid");
  place.transform = transformOf(attributes.text("transform"));
  return place;
}

/// Takes the elements of a model part.
class ModelElements
{
public:
  void take(std::string_view name, const Attributes& attributes)
  {
    if (!isBegun_ && endsWith(name, "model"))
    {
      this->begin(name, attributes);
    }
    if (name.substr(0, prefix_.size()) != prefix_)
    {
      return; // of an extension
    }
    name.remove_prefix(prefix_.size());
    if (name == "vertex" && object_)
    {
      object_->mesh.points.emplace_back(
        attributes.number("x"), attributes.number("y"), attributes.number("z"));
    }
    else if (name == "triangle" && object_)
    {
      object_->mesh.triangles.push_back(
        {attributes.index("v1"), attributes.index("v2"), attributes.index("v3")});
    }
    else if (name == "object")
    {
      object_ = &model.objects[attributes.text("id")];
      object_->type = attributes.text("type");
      object_->mesh.name = attributes.text("name");
    }
    else if (name == "component" && object_)
    {
      object_->components.push_back(placeOf(attributes));
    }
    else if (name == "item")
    {
      model.items.push_back(placeOf(attributes));
    }
  }

  ThreeMfModel model;

private:
  void begin(std::string_view name, const Attributes& attributes)
  {
    isBegun_ = true;
    prefix_ = name.substr(0, name.size() - std::string_view("model").size());
    if (attributes.find("unit"))
    {
      model.unit = attributes.text("unit");
    }
    const std::string required = attributes.text("requiredextensions");
    std::string_view left = required;
    for (auto word = takeWord(left); !word.empty(); word = takeWord(left))
    {
      model.extensions.push_back(attributes.text("xmlns:" + std::string(word)));
    }
  }

  std::string prefix_;
  bool isBegun_ = false;
  ThreeMfObject* object_ = nullptr;
};

} // namespace

std::string firstPartOf(const ZipArchive& archive)
{
  std::string part;
  forEachElement(archive, "_rels/.rels",
    [&part](std::string_view, const Attributes& attributes)
    {
      if (part.empty() && endsWith(attributes.text("Type"), "/3dmodel"))
      {
        part = inArchive(attributes.text("Target"));
      }
    });
  return part.empty() ? "3D/3dmodel.model" : part;
}

ThreeMfModel readThreeMfModel(const ZipArchive& archive, const std::string& part)
{
  ModelElements elements;
  forEachElement(archive, part,
    [&elements](std::string_view name, const Attributes& attributes)
    { elements.take(name, attributes); });
  return std::move(elements.model);
}

std::map<std::string, SlicerObject> readSlicerObjects(const ZipArchive& archive)
{
  std::map<std::string, SlicerObject> objects;
  SlicerObject* object = nullptr;
  SlicerPart* part = nullptr;
  const auto take = [&](std::string_view element, const Attributes& attributes)
  {
    if (element == "object")
    {
      object = &objects[attributes.text("id")];
      part = nullptr;
    }
    else if (element == "part" && object)
    {
      part = &object->components.emplace_back();
      part->component = attributes.text("id");
      part->isSolid = attributes.text("subtype") == "normal_part";
    }
    else if (element == "volume" && object)
    {
      part = &object->ranges.emplace_back();
      part->firstTriangle = static_cast<std::size_t>(attributes.index("firstid"));
      part->lastTriangle = static_cast<std::size_t>(attributes.index("lastid"));
    }
    else if (element == "metadata" && object)
    {
      const std::string key = attributes.text("key"), value = attributes.text("value");
      if (key == "name")
      {
        (part ? part->name : object->name) = value;
      }
      const bool isOther =
        (key == "volume_type" && value != "ModelPart") || (key == "modifier" && value == "1");
      if (part && isOther)
      {
        part->isSolid = false;
      }
    }
  };
  for (const char* const name :
    {"Metadata/model_settings.config", "Metadata/Slic3r_PE_model.config"})
  {
    if (archive.has(name))
    {
      forEachElement(archive, name, take);
    }
  }
  return objects;
}
