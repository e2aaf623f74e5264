// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/ThreeMfModel.h"

#include "files/Text.h"
#include "files/ZipArchive.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkXMLParser.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <exception>
#include <iterator>
#include <string_view>
#include <utility>

namespace
{

/// An element of a part, with its attributes, from its begin to its end.
struct Element
{
  const ZipArchive& archive;
  std::string_view part;
  std::string_view name;
  const char** attributes;

  /// The value of an attribute without blanks at its ends; empty where there is none.
  std::string_view value(std::string_view attribute) const
  {
    for (const char** pair = attributes; *pair; pair += 2)
    {
      if (attribute == *pair)
      {
        return trimmed(pair[1]);
      }
    }
    return {};
  }

  std::string text(std::string_view attribute) const { return std::string(this->value(attribute)); }

  double number(std::string_view attribute) const
  {
    return this->numberIn(this->value(attribute), attribute);
  }

  /// Reads the number that is all of a word, or refuses the file.
  double numberIn(std::string_view word, std::string_view attribute) const
  {
    double number = 0;
    if (!parseNumber(word, number))
    {
      this->refuse("'" + std::string(word.substr(0, 30)) + "' for " + std::string(attribute));
    }
    return number;
  }

  /// A whole number; -1 where there is none.
  long long index(std::string_view attribute) const
  {
    long long number = -1;
    return parseInteger(this->value(attribute), number) ? number : -1;
  }

  [[noreturn]] void refuse(const std::string& what) const
  {
    archive.refuse("its " + std::string(part) + " has " + what + " of <" + std::string(name) +
                   ">; it is damaged");
  }
};

/// Takes the elements of a part one after the other.
class ElementTaker
{
public:
  virtual ~ElementTaker() = default;
  virtual void begin(const Element& element) = 0;
  /// The text stands before the end, behind all other elements.
  virtual void end(std::string_view name, const std::string& text) = 0;
};

/// Hands elements on. What a taker throws is kept, for it must not go through the parser's C.
class ElementParser : public vtkXMLParser
{
public:
  static ElementParser* New();
  vtkTypeMacro(ElementParser, vtkXMLParser);

  ElementTaker* taker = nullptr;
  const ZipArchive* archive = nullptr;
  std::string part;
  std::exception_ptr fault;
  bool isDamaged = false;

protected:
  void StartElement(const char* name, const char** attributes) override
  {
    text_.clear();
    this->keepFault([&] { taker->begin({*archive, part, name, attributes}); });
  }
  void EndElement(const char* name) override
  {
    this->keepFault([&] { taker->end(name, text_); });
    text_.clear();
  }
  void CharacterDataHandler(const char* text, int length) override
  {
    constexpr std::size_t most = 100; // nothing longer is looked at
    text_.append(
      text, std::min(static_cast<std::size_t>(length), most - std::min(most, text_.size())));
  }
  void ReportXmlParseError() override { isDamaged = true; }

private:
  template <class Work> void keepFault(const Work& work)
  {
    try
    {
      if (!fault)
      {
        work();
      }
    }
    catch (...)
    {
      fault = std::current_exception();
    }
  }

  std::string text_;
};

vtkStandardNewMacro(ElementParser);

/// Gives the elements of a part to a taker. Throws Failure for a part that is no whole XML.
void takeElements(const ZipArchive& archive, const std::string& part, ElementTaker& taker)
{
  vtkNew<ElementParser> parser;
  parser->taker = &taker;
  parser->archive = &archive;
  parser->part = part;
  parser->InitializeParser();
  const auto check = [&]
  {
    if (parser->fault)
    {
      std::rethrow_exception(parser->fault);
    }
    if (parser->isDamaged)
    {
      archive.refuse("its " + part + " is no whole XML; it is damaged");
    }
  };
  archive.read(part,
    [&](std::string_view bytes)
    {
      parser->ParseChunk(bytes.data(), static_cast<unsigned int>(bytes.size()));
      check();
    });
  parser->CleanupParser();
  check();
}

struct Unit
{
  const char* name;
  const char* many;
  double millimetres;
};

constexpr Unit units[] = {{"micron", "micrometres", 0.001}, {"millimeter", "millimetres", 1},
  {"centimeter", "centimetres", 10}, {"inch", "inches", 25.4}, {"foot", "feet", 304.8},
  {"meter", "metres", 1000}};

/// Reads the relationships of a package.
class Relationships : public ElementTaker
{
public:
  void begin(const Element& element) override
  {
    if (first.empty() && endsWith(element.text("Type"), "/3dmodel"))
    {
      first = plainPath(element.text("Target"));
    }
  }
  void end(std::string_view, const std::string&) override {}

  std::string first;
};

using CornerColors = std::array<MeshColor, 3>; ///< of a triangle

/// Gives points the colors that the corners of triangles have, and adds a copy of a point for each
/// further color there. The last triangles are white where `corners` are fewer.
void giveColors(const std::vector<CornerColors>& corners, MeshBlock& mesh)
{
  if (corners.empty())
  {
    return;
  }
  const std::size_t count = mesh.points.size();
  std::map<std::pair<vtkIdType, MeshColor>, vtkIdType> copies;
  std::vector<char> isColored(count, 0);
  mesh.colors.assign(count, white);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      vtkIdType& id = mesh.triangles[i][corner];
      const MeshColor color = i < corners.size() ? corners[i][corner] : white;
      const auto point = static_cast<std::size_t>(id);
      if (id < 0 || point >= count)
      {
        continue; // is found later, with all others of its kind
      }
      if (!isColored[point])
      {
        isColored[point] = 1;
        mesh.colors[point] = color;
      }
      else if (mesh.colors[point] != color)
      {
        const auto next = static_cast<vtkIdType>(mesh.points.size());
        const auto [place, isNew] = copies.emplace(std::pair(id, color), next);
        if (isNew)
        {
          mesh.points.push_back(Eigen::Vector3d(mesh.points[point]));
          mesh.colors.push_back(color);
        }
        id = place->second;
      }
    }
  }
}

/// Reads a model part.
class ModelElements : public ElementTaker
{
public:
  void begin(const Element& element) override
  {
    std::string_view name = element.name;
    if (!isBegun_ && endsWith(name, "model"))
    {
      this->beginModel(element);
    }
    this->takeColor(element);
    if (!startsWith(name, prefix_))
    {
      return; // of an extension
    }
    name.remove_prefix(prefix_.size());
    if (name == "vertex" && object_)
    {
      object_->mesh.points.emplace_back(
        element.number("x"), element.number("y"), element.number("z"));
    }
    else if (name == "triangle" && object_)
    {
      object_->mesh.triangles.push_back(
        {element.index("v1"), element.index("v2"), element.index("v3")});
      this->colorTriangle(element);
    }
    else if (name == "object")
    {
      this->beginObject(element);
    }
    else if (name == "component" && object_)
    {
      object_->components.push_back(this->placeOf(element));
    }
    else if (name == "item")
    {
      model.items.push_back(this->placeOf(element));
      const std::string_view isPrinted = element.value("printable"); // of slicers
      model.items.back().isPrinted = isPrinted != "0" && isPrinted != "false";
    }
    else if (name == "metadata")
    {
      note_ = element.text("name");
    }
  }

  void end(std::string_view name, const std::string& text) override
  {
    if (name == prefix_ + "object" && object_)
    {
      giveColors(cornerColors_, object_->mesh);
      object_ = nullptr;
    }
    else if (name == prefix_ + "metadata")
    {
      this->takeNote(std::string(trimmed(text)));
    }
  }

  ThreeMfModel model;

private:
  void beginModel(const Element& element)
  {
    isBegun_ = true;
    prefix_ = element.name.substr(0, element.name.size() - std::string_view("model").size());
    const std::string name = element.text("unit");
    const Unit* const unit = std::find_if(std::begin(units), std::end(units),
      [&name](const Unit& known) { return name == known.name; });
    if (unit != std::end(units))
    {
      model.unit = unit->many;
      model.millimetres = unit->millimetres;
    }
    else if (!name.empty())
    {
      element.refuse("the unit '" + name.substr(0, 30) + "', which 3MF does not know,");
    }
    const std::string required = element.text("requiredextensions");
    std::string_view left = required;
    for (auto word = takeWord(left); !word.empty(); word = takeWord(left))
    {
      requireKnown(element, std::string(word));
    }
    for (const char** pair = element.attributes; *pair; pair += 2)
    {
      if (startsWith(*pair, "xmlns:") &&
          std::string_view(pair[1]).find("/production/") != std::string_view::npos)
      {
        path_ = *pair + std::string_view("xmlns:").size() + std::string(":path");
      }
    }
  }

  static void requireKnown(const Element& element, const std::string& prefix)
  {
    const std::string space = element.text("xmlns:" + prefix);
    const char* const known[] = {"/production/", "/material/", "/trianglesets/", "/slice/"};
    if (std::none_of(std::begin(known), std::end(known),
          [&space](const char* name) { return space.find(name) != std::string::npos; }))
    {
      element.archive.refuse("needs the extension " + (space.empty() ? prefix : space) +
                             " of 3MF; export it without, or as .stl");
    }
  }

  void beginObject(const Element& element)
  {
    const std::string id = element.text("id"), type = element.text("type");
    const auto [place, isNew] = model.objects.emplace(id, ThreeMfObject());
    if (id.empty() || !isNew)
    {
      element.refuse(id.empty() ? "no id" : "the id " + id + " twice");
    }
    object_ = &place->second;
    const std::string name = element.text("name");
    object_->mesh.name = name.empty() ? element.text("partnumber") : name;
    const bool isNext = type == "support" || type == "solidsupport" || type == "other";
    object_->purpose = isNext ? ThreeMfPurpose::support : ThreeMfPurpose::solid;
    group_ = element.text("pid");
    color_ = element.index("pindex");
    cornerColors_.clear();
  }

  /// Takes a group of colors or materials, or the color of one in it.
  void takeColor(const Element& element)
  {
    const std::string_view name = element.name.substr(element.name.find(':') + 1);
    if (name == "colorgroup" || name == "basematerials")
    {
      colors_ = &model.colors[element.text("id")];
    }
    else if (colors_ && (name == "color" || name == "base"))
    {
      colors_->push_back(colorOf(element, name == "color" ? "color" : "displaycolor"));
    }
  }

  /// Reads a color like #FF8000, with an opacity behind it or not.
  static MeshColor colorOf(const Element& element, std::string_view attribute)
  {
    const std::string_view text = element.value(attribute);
    MeshColor color = white;
    bool isColor = (text.size() == 7 || text.size() == 9) && text[0] == '#';
    for (std::size_t i = 0; isColor && 2 * i + 1 < text.size(); ++i)
    {
      const char* const end = text.data() + 2 * i + 3;
      const auto read = std::from_chars(end - 2, end, color[i], 16);
      isColor = read.ec == std::errc() && read.ptr == end;
    }
    if (!isColor)
    {
      element.refuse("'" + std::string(text.substr(0, 30)) + "' for " + std::string(attribute));
    }
    return color;
  }

  /// Gives the last triangle its colors, or its object's. Textures and mixtures are none.
  void colorTriangle(const Element& element)
  {
    const std::string_view own = element.value("pid");
    const auto group = model.colors.find(own.empty() ? std::string_view(group_) : own);
    if (group == model.colors.end())
    {
      return;
    }
    const long long first = element.index("p1");
    cornerColors_.resize(object_->mesh.triangles.size(), {white, white, white});
    std::size_t corner = 0;
    for (const char* const name : {"p1", "p2", "p3"})
    {
      const long long other = element.index(name);
      const long long number = first < 0 ? color_ : other < 0 ? first : other;
      if (number < 0 || static_cast<std::size_t>(number) >= group->second.size())
      {
        element.refuse("a color that is not there");
      }
      cornerColors_.back()[corner++] = group->second[static_cast<std::size_t>(number)];
    }
  }

  /// Takes a note of Cura on the object at hand.
  void takeNote(const std::string& value)
  {
    const bool isSet = inSmallLetters(value) == "true";
    if (object_ && isSet && (note_ == "cura:support_mesh" || note_ == "cura:anti_overhang_mesh"))
    {
      object_->purpose = ThreeMfPurpose::support;
    }
    else if (object_ && isSet && (note_ == "cura:infill_mesh" || note_ == "cura:cutting_mesh"))
    {
      object_->purpose = ThreeMfPurpose::modifier;
    }
  }

  ThreeMfPlace placeOf(const Element& element)
  {
    if (++places_ > mostObjects)
    {
      refuseRepetitions(element.archive);
    }
    ThreeMfPlace place;
    place.part = path_.empty() ? "" : plainPath(element.text(path_));
    place.id = element.text("objectid");
    const std::string text = element.text("transform");
    std::string_view left = text;
    Eigen::Index count = 0;
    for (auto word = takeWord(left); !word.empty(); word = takeWord(left), ++count)
    {
      if (count < 12) // the format applies the matrix to rows
      {
        place.transform(count % 3, count / 3) = element.numberIn(word, "transform");
      }
    }
    if (count != 0 && count != 12)
    {
      element.refuse(std::to_string(count) + " numbers, not 12, for transform");
    }
    return place;
  }

  std::string prefix_; ///< of names of the core specification
  std::string path_;   ///< the attribute of the production extension; empty where there is none
  std::string note_;   ///< the name of the note at hand
  bool isBegun_ = false;
  int places_ = 0;
  ThreeMfObject* object_ = nullptr;
  std::string group_;                        ///< of the colors of the object at hand
  long long color_ = -1;                     ///< of the object at hand, in its group
  std::vector<CornerColors> cornerColors_;   ///< of its first triangles
  std::vector<MeshColor>* colors_ = nullptr; ///< of the group at hand
};

/// Reads what slicers note. Parts of a kind that is not known are solids, as slicers have it.
class SlicerElements : public ElementTaker
{
public:
  void begin(const Element& element) override
  {
    if (element.name == "object")
    {
      object_ = &objects[element.text("id")];
      part_ = nullptr;
    }
    else if (element.name == "part" && object_)
    {
      part_ = &object_->components.emplace_back();
      part_->component = element.text("id");
      this->setPurpose(element.text("subtype"));
    }
    else if (element.name == "volume" && object_)
    {
      part_ = &object_->ranges.emplace_back();
      part_->firstTriangle = element.index("firstid");
      part_->lastTriangle = element.index("lastid");
    }
    else if (element.name == "metadata" && object_)
    {
      this->takeNote(element.text("key"), element.text("value"));
    }
  }

  void end(std::string_view name, const std::string&) override
  {
    object_ = name == "object" ? nullptr : object_;
    part_ = name == "object" || name == "part" || name == "volume" ? nullptr : part_;
  }

  std::map<std::string, SlicerObject> objects;

private:
  void takeNote(const std::string& key, const std::string& value)
  {
    if (key == "name")
    {
      (part_ ? part_->name : object_->name) = value;
    }
    else if (part_ && key == "volume_type")
    {
      this->setPurpose(value);
    }
    else if (part_ && key == "modifier" && value == "1")
    {
      part_->purpose = ThreeMfPurpose::modifier;
    }
  }

  void setPurpose(const std::string& kind) const
  {
    const char* const modifiers[] = {"negative_part", "modifier_part", "support_enforcer",
      "support_blocker", "ParameterModifier", "NegativeVolume", "SupportEnforcer",
      "SupportBlocker"};
    if (std::find(std::begin(modifiers), std::end(modifiers), kind) != std::end(modifiers))
    {
      part_->purpose = ThreeMfPurpose::modifier;
    }
  }

  SlicerObject* object_ = nullptr;
  SlicerPart* part_ = nullptr;
};

} // namespace

void refuseRepetitions(const ZipArchive& archive)
{
  archive.refuse("its build has too many triangles or objects, for it repeats objects very often");
}

std::string firstPartOf(const ZipArchive& archive)
{
  const char* const usual = "3D/3dmodel.model";
  Relationships relationships;
  if (archive.has("_rels/.rels") || !archive.has(usual))
  {
    takeElements(archive, "_rels/.rels", relationships);
  }
  return relationships.first.empty() ? usual : relationships.first;
}

ThreeMfModel readThreeMfModel(const ZipArchive& archive, const std::string& part)
{
  ModelElements elements;
  takeElements(archive, part, elements);
  return std::move(elements.model);
}

std::map<std::string, SlicerObject> readSlicerObjects(const ZipArchive& archive)
{
  SlicerElements elements;
  for (const char* const name :
    {"Metadata/model_settings.config", "Metadata/Slic3r_PE_model.config"})
  {
    if (archive.has(name))
    {
      takeElements(archive, name, elements);
    }
  }
  return std::move(elements.objects);
}
