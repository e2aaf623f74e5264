// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"
#include "vtk_zlib.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

// 3MF: packages of meshes, which the build places, with what slicers note on their parts.

namespace
{

using Files = std::vector<std::pair<std::string, std::string>>;

std::string bytesOf(std::uint64_t number, int count)
{
  std::string bytes;
  for (int i = 0; i < count; ++i, number >>= 8)
  {
    bytes += static_cast<char>(number & 0xFF);
  }
  return bytes;
}

/// A .zip of files as they are.
std::string zipOf(const Files& files)
{
  std::string content, directory;
  for (const auto& [name, text] : files)
  {
    const auto* const bytes = reinterpret_cast<const Bytef*>(text.data());
    const std::string about =
      bytesOf(20, 2) + bytesOf(0, 8) + bytesOf(crc32(0, bytes, static_cast<uInt>(text.size())), 4) +
      bytesOf(text.size(), 4) + bytesOf(text.size(), 4) + bytesOf(name.size(), 2) + bytesOf(0, 2);
    directory +=
      "PK\1\2" + bytesOf(20, 2) + about + bytesOf(0, 10) + bytesOf(content.size(), 4) + name;
    content += "PK\3\4" + about + name + text;
  }
  return content + directory + "PK\5\6" + bytesOf(0, 4) + bytesOf(files.size(), 2) +
         bytesOf(files.size(), 2) + bytesOf(directory.size(), 4) + bytesOf(content.size(), 4) +
         bytesOf(0, 2);
}

/// The mesh of `cubes` unit cubes, each 2 further along x than the one before.
std::string cubesOf(int cubes)
{
  const int corners[] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 1, 3, 7, 1, 7, 5, 3,
    2, 6, 3, 6, 7, 2, 0, 4, 2, 4, 6};
  std::string vertices, triangles;
  for (int cube = 0; cube < cubes; ++cube)
  {
    const auto number = [](int value)
    {
      return '"' + std::to_string(value) + '"';
    };
    for (int i = 0; i < 8; ++i)
    {
      vertices += "<vertex x=" + number(2 * cube + (i & 1)) + " y=" + number(i >> 1 & 1) +
                  " z=" + number(i >> 2) + "/>";
    }
    for (int i = 0; i < 36; i += 3)
    {
      triangles += "<triangle v1=" + number(8 * cube + corners[i]) +
                   " v2=" + number(8 * cube + corners[i + 1]) +
                   " v3=" + number(8 * cube + corners[i + 2]) + "/>";
    }
  }
  return "<mesh><vertices>" + vertices + "</vertices><triangles>" + triangles +
         "</triangles></mesh>";
}

std::string objectOf(const std::string& attributes, const std::string& content)
{
  return "<object " + attributes + ">" + content + "</object>";
}

std::string componentsOf(const std::string& components)
{
  return "<components>" + components + "</components>";
}

/// A model part with objects, items of a build and further attributes.
std::string modelOf(
  const std::string& objects, const std::string& items, const std::string& attributes = "")
{
  return R"(<?xml version="1.0" encoding="UTF-8"?>
<model xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" )" +
         attributes + "><resources>" + objects + "</resources><build>" + items + "</build></model>";
}

/// A package with one model part, and further files.
std::string packageOf(const std::string& model, const Files& others = {})
{
  Files files = {
    {"_rels/.rels",
      R"(<?xml version="1.0"?><Relationships><Relationship Target="/3D/a.model" Id="r" )"
      R"(Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)"},
    {"3D/a.model", model}};
  files.insert(files.end(), others.begin(), others.end());
  return zipOf(files);
}

class ThreeMf : public ::testing::Test
{
protected:
  /// Returns the report on a package, whose messages have `lines` among them.
  nlohmann::json check(const std::string& content, const std::string& lines = "") const
  {
    const Outcome run = runProgram({"check", folder.write("a.3mf", content), "--json"});
    EXPECT_EQ(run.status, 0) << run;
    if (lines.empty())
    {
      EXPECT_EQ(run.err, "");
    }
    EXPECT_NE(run.err.find(lines), std::string::npos) << run;
    return run.status == 0 ? run.json() : nlohmann::json();
  }

  std::vector<std::string> names(const std::string& content) const
  {
    const Outcome run = runProgram(
      {"labels", folder.write("a.3mf", content), "-o", folder.path("out.vti"), "--json"});
    std::vector<std::string> result;
    EXPECT_EQ(run.status, 0) << run;
    const nlohmann::json report = run.json();
    for (const auto& label : report["labels"])
    {
      result.push_back(label["name"]);
    }
    return result;
  }

  void expectRefused(const std::string& content, const std::string& words) const
  {
    const Outcome run = runProgram(
      {"field", folder.write("a.3mf", content), "-o", folder.path("out.vti"), "--quiet"});
    EXPECT_EQ(run.status, 2) << run;
    EXPECT_TRUE(run.saysInOneLine({"a.3mf: ", words})) << run;
  }

  TemporaryFolder folder;
};

TEST_F(ThreeMf, PlacesObjectsAsItsBuildSays)
{
  const std::string objects = objectOf(R"(id="1" name="cube")", cubesOf(1)) +
                              objectOf(R"(id="2" name="pair")",
                                componentsOf(R"(<component objectid="1"/><component objectid="1")"
                                             R"( transform="2 0 0 0 1 0 0 0 1 10 0 0"/>)"));
  const nlohmann::json placed = this->check(packageOf(modelOf(
    objects, R"(<item objectid="2"/><item objectid="1" transform="0 3 0 -1 0 0 0 0 1 0 20 0"/>)")));
  EXPECT_NEAR(placed["volume"], 6, 1e-12);
  EXPECT_EQ(placed["bbox"], (std::vector<double>{-1, 0, 0, 12, 23, 1}));
  EXPECT_EQ(placed["closed"], true);
  // A mirrored cube looks outward, too. What is in no build, and no component, is all there is.
  const nlohmann::json mirrored = this->check(
    packageOf(modelOf(objects, R"(<item objectid="1" transform="-1 0 0 0 1 0 0 0 1 0 0 0"/>)")));
  EXPECT_NEAR(mirrored["volume"], 1, 1e-12);
  EXPECT_NEAR(this->check(packageOf(modelOf(objects, "")))["volume"], 3, 1e-12);
  EXPECT_EQ(this->names(packageOf(modelOf(objects, R"(<item objectid="2"/>)"))),
    (std::vector<std::string>{"cube", "cube (2)"}));
}

TEST_F(ThreeMf, LeavesOutItemsThatAreNotPrinted)
{
  const std::string objects = objectOf(R"(id="1")", cubesOf(1)) + objectOf(R"(id="2")", cubesOf(2));
  for (const char* const no : {"0", "false"})
  {
    const std::string model =
      modelOf(objects, R"(<item objectid="1" printable="1"/><item objectid="2" printable=")" +
                         std::string(no) + R"("/>)");
    const nlohmann::json report =
      this->check(packageOf(model), "a.3mf: left out: 1 item that is not to be printed\n");
    EXPECT_NEAR(report["volume"], 1, 1e-12);
  }
  this->expectRefused(packageOf(modelOf(objects, R"(<item objectid="2" printable="0"/>)")),
    "has nothing to be made, only 1 item that is not to be printed, 1 object outside of its build");
}

/// Colours of groups and of materials stay, of objects, triangles and corners.
TEST_F(ThreeMf, KeepsItsColors)
{
  const std::string groups =
    R"(<m:colorgroup id="7"><m:color color="#FF0000"/><m:color color="#0000fF"/></m:colorgroup>)"
    R"(<basematerials id="8"><base name="a" displaycolor="#00800080"/></basematerials>)";
  const std::string space =
    R"(xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02")";
  std::string corners = cubesOf(1); // the first triangle is blue, of the second a corner
  corners.insert(corners.find("/>", corners.find("<triangle")), R"( pid="7" p1="1")");
  std::size_t second = corners.find("<triangle", corners.find("p1="));
  corners.insert(corners.find("/>", second), R"( pid="7" p1="0" p2="0" p3="1")");
  const std::string model = modelOf(groups + objectOf(R"(id="1" pid="8" pindex="0")", cubesOf(1)) +
                                      objectOf(R"(id="2" pid="7" pindex="0")", corners),
    R"(<item objectid="1"/><item objectid="2" transform="1 0 0 0 1 0 0 0 1 5 0 0"/>)", space);
  const std::string in = folder.write("a.3mf", packageOf(model)), out = folder.path("out.vtp");
  const Outcome run =
    runProgram({"surface", in, "-o", out, "--resolution", "90", "--transfer-attributes"});
  ASSERT_EQ(run.status, 0) << run;
  EXPECT_EQ(run.err.find("warning"), std::string::npos) << run;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(out.c_str());
  reader->Update();
  vtkPolyData* const surface = reader->GetOutput();
  vtkDataArray* const colors = surface->GetPointData()->GetScalars();
  ASSERT_TRUE(colors);
  EXPECT_STREQ(colors->GetName(), "RGBA");
  int mixed = 0;
  for (vtkIdType n = 0; n < surface->GetNumberOfPoints(); ++n)
  {
    double place[3], color[4];
    surface->GetPoint(n, place);
    colors->GetTuple(n, color);
    if (place[0] < 3)
    {
      EXPECT_EQ(std::vector<double>(color, color + 4), (std::vector<double>{0, 128, 0, 128}));
      continue;
    }
    const bool isBelow = place[2] < 1e-3; // where the first two triangles are
    const double x = place[0] - 5, y = place[1], margin = 0.05;
    EXPECT_EQ(color[3], 255);
    if (!isBelow || (x > margin && x < y - margin && y < 1 - margin))
    {
      EXPECT_EQ(color[2], isBelow ? 255 : 0) << x << " " << y << " " << place[2];
    }
    mixed += isBelow && x > y && color[2] > 50 && color[2] < 205 ? 1 : 0;
  }
  EXPECT_GT(mixed, 3); // measured: 6
  this->expectRefused(
    packageOf(modelOf(R"(<basematerials id="8"><base displaycolor="red"/></basematerials>)", "")),
    "'red' for displaycolor");
  this->expectRefused(
    packageOf(modelOf(groups + objectOf(R"(id="1" pid="7" pindex="2")", cubesOf(1)),
      R"(<item objectid="1"/>)", space)),
    "a color that is not there");
}

TEST_F(ThreeMf, SaysItsUnit)
{
  const std::string model =
    modelOf(objectOf(R"(id="1")", cubesOf(1)), R"(<item objectid="1"/>)", R"(unit="inch")");
  EXPECT_NEAR(
    this->check(packageOf(model), "a.3mf: its numbers are inches, not millimetres")["volume"], 1,
    1e-12);
}

TEST_F(ThreeMf, TakesPartsFromOtherModels)
{
  // Slicers write each mesh into a file of its own.
  const std::string attributes =
    R"(requiredextensions="p" )"
    R"(xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06")";
  const std::string model = modelOf(
    objectOf(R"(id="5" p:UUID="u")", componentsOf(R"(<component p:path="/3D/Objects/b.model")"
                                                  R"( objectid="1" transform="1 0 0 0 1 0 0 0 1)"
                                                  R"( 5 0 0"/><component objectid="2")"
                                                  R"( p:path="/3D/Objects/b.model"/>)")),
    R"(<item objectid="5"/>)", attributes);
  const std::string other =
    modelOf(objectOf(R"(id="1")", cubesOf(1)) + objectOf(R"(id="2")", cubesOf(2)), "",
      attributes + R"( unit="centimeter")");
  const Files parts = {{"3D/Objects/b.model", other}};
  const nlohmann::json report = this->check(packageOf(model, parts));
  EXPECT_NEAR(report["volume"], 3000, 1e-9); // centimetres in a model of millimetres
  EXPECT_EQ(report["bbox"], (std::vector<double>{0, 0, 0, 30, 10, 10}));
  // Shifts within a part are in its unit, too.
  const std::string shifted =
    modelOf(objectOf(R"(id="3")", cubesOf(1)) +
              objectOf(R"(id="1")", componentsOf(R"(<component objectid="3")"
                                                 R"( transform="1 0 0 0 1 0 0 0 1 2 0 0"/>)")) +
              objectOf(R"(id="2")", cubesOf(1)),
      "", attributes + R"( unit="centimeter")");
  EXPECT_EQ(this->check(packageOf(model, {{"3D/Objects/b.model", shifted}}))["bbox"],
    (std::vector<double>{0, 0, 0, 35, 10, 10}));
  // The slicer has the names, and modifiers, which are no solids.
  const auto settings = [&](const std::string& kind)
  {
    return Files{{"3D/Objects/b.model", other},
      {"Metadata/model_settings.config",
        R"(<config><object id="5"><metadata key="name" value="both"/><part id="1" )"
        R"(subtype="normal_part"><metadata key="name" value="lid"/></part><part id="2" subtype=")" +
          kind + R"("><metadata key="name" value="box"/></part></object></config>)"}};
  };
  EXPECT_EQ(this->names(packageOf(model, settings("normal_part"))),
    (std::vector<std::string>{"lid", "box"}));
  const nlohmann::json rest = this->check(
    packageOf(model, settings("negative_part")), "left out: 1 modifier or negative of a slicer");
  EXPECT_NEAR(rest["volume"], 1000, 1e-9);
}

TEST_F(ThreeMf, PartsRangesOfTriangles)
{
  const auto settings = [](const std::string& kind)
  {
    return Files{{"Metadata/Slic3r_PE_model.config",
      R"(<config><object id="1" instances_count="1"><metadata type="object" key="name")"
      R"( value="plate"/><volume firstid="0" lastid="11"><metadata type="volume" key="name")"
      R"( value="left"/><metadata type="volume" key="volume_type" value="ModelPart"/></volume>)"
      R"(<volume firstid="12" lastid="23"><metadata type="volume" key="volume_type" value=")" +
        kind + R"("/></volume></object></config>)"}};
  };
  const std::string model = modelOf(objectOf(R"(id="1")", cubesOf(2)), R"(<item objectid="1"/>)");
  EXPECT_EQ(this->names(packageOf(model, settings("ModelPart"))),
    (std::vector<std::string>{"left", "plate"}));
  const nlohmann::json rest = this->check(packageOf(model, settings("ParameterModifier")),
    "left out: 1 modifier or negative of a slicer");
  EXPECT_EQ(rest["triangles"], 12);
}

TEST_F(ThreeMf, KeepsTrianglesThatNoRangeNames)
{
  const auto settings = [](const std::string& ranges)
  {
    return Files{{"Metadata/Slic3r_PE_model.config",
      "<config><object id=\"1\">" + ranges + "</object></config>"}};
  };
  const std::string model =
    modelOf(objectOf(R"(id="1" name="plate")", cubesOf(3)), R"(<item objectid="1"/>)");
  const std::string first = R"(<volume firstid="0" lastid="11"><metadata key="name" value="a"/>)"
                            R"(<metadata key="volume_type" value="Unknown"/></volume>)";
  EXPECT_NEAR(this->check(packageOf(model, settings(first)))["volume"], 3, 1e-12);
  EXPECT_EQ(
    this->names(packageOf(model, settings(first))), (std::vector<std::string>{"a", "plate"}));
  for (const std::string range : {R"(<volume firstid="12" lastid="36"/>)", "<volume/>",
         R"(<volume firstid="5" lastid="3"/>)", R"(<volume firstid="3" lastid="20"/>)"})
  {
    const nlohmann::json report = this->check(packageOf(model, settings(first + range)),
      "the parts that a slicer notes contradict 1 of its meshes, and are not looked at");
    EXPECT_NEAR(report["volume"], 3, 1e-12) << range;
  }
  const nlohmann::json damaged = this->check(packageOf(model, settings("<volume")),
    "its Metadata/Slic3r_PE_model.config is no whole XML; it is damaged, so parts of a slicer are "
    "not known");
  EXPECT_NEAR(damaged["volume"], 3, 1e-12);
}

TEST_F(ThreeMf, NamesAllThatItLeavesOut)
{
  const auto ofCura = [](const std::string& note)
  {
    return "<metadatagroup><metadata name=\"cura:" + note + "\">True</metadata></metadatagroup>";
  };
  const std::string objects =
    objectOf(R"(id="1")", cubesOf(1)) + objectOf(R"(id="2")", ofCura("infill_mesh") + cubesOf(2)) +
    objectOf(R"(id="3")", ofCura("support_mesh") + cubesOf(2)) + objectOf(R"(id="4")", "<mesh/>") +
    objectOf(R"(id="5")", cubesOf(1)) + objectOf(R"(id="6")", cubesOf(1));
  std::string items;
  for (const char* const id : {"1", "2", "3", "4"})
  {
    items += std::string("<item objectid=\"") + id + "\"/>";
  }
  const nlohmann::json report = this->check(packageOf(modelOf(objects, items)),
    "left out: 1 support, 1 modifier or negative of a slicer, 1 object without triangles, 2 "
    "objects outside of its build");
  EXPECT_NEAR(report["volume"], 1, 1e-12);
}

TEST_F(ThreeMf, FindsPartsByAnyNamesForThem)
{
  const std::string model = modelOf(objectOf(R"(id="1")", cubesOf(1)), R"(<item objectid="1"/>)");
  const std::pair<const char*, const char*> names[] = {{"/3D/a.model", "3d/A.model"},
    {"./3D/../3D/a.model", "3D/a.model"}, {"3D\\a.model", "/3D/a.model"},
    {"/3D/a%20b.model", "3D/a b.model"}, {"3D/a.model", "3D\\a.model"}};
  for (const auto& [target, name] : names)
  {
    const std::string content =
      zipOf({{"_rels/.rels", std::string("<R><Relationship Target=\"") + target +
                               "\" Type=\"http://a/3dmodel\"/></R>"},
        {name, model}});
    EXPECT_NEAR(this->check(content)["volume"], 1, 1e-12) << target << " " << name;
  }
  EXPECT_NEAR(this->check(zipOf({{"3D/3dmodel.model", model}}))["volume"], 1, 1e-12);
}

TEST_F(ThreeMf, MayHaveManyParts)
{
  // A small file says much. Each block takes a few messages between processes.
  constexpr int count = 6000;
  std::string items;
  for (int i = 0; i < count; ++i)
  {
    items +=
      R"(<item objectid="1" transform="1 0 0 0 1 0 0 0 1 )" + std::to_string(2 * i) + " 0 0\"/>";
  }
  const std::string cube = objectOf(R"(id="1")", cubesOf(1));
  EXPECT_NEAR(this->check(packageOf(modelOf(cube, items)))["volume"], count, 1e-6);
  // And none says more than there can be.
  std::string pairs = cube;
  for (int i = 2; i < 50; ++i)
  {
    const std::string one = "<component objectid=\"" + std::to_string(i - 1) + "\"/>";
    pairs += objectOf("id=\"" + std::to_string(i) + "\"", componentsOf(one + one));
  }
  this->expectRefused(
    packageOf(modelOf(pairs, R"(<item objectid="49"/>)")), "its build has too many triangles");
  std::string copies;
  for (int i = 0; i < 200000; ++i)
  {
    copies += R"(<item objectid="1"/>)";
  }
  this->expectRefused(packageOf(modelOf(cube, copies)), "or objects, for it repeats objects");
}

TEST_F(ThreeMf, LeavesSupportsOut)
{
  const std::string objects =
    objectOf(R"(id="1")", cubesOf(1)) + objectOf(R"(id="2" type="support")", cubesOf(2));
  const nlohmann::json report =
    this->check(packageOf(modelOf(objects, R"(<item objectid="1"/><item objectid="2"/>)")),
      "left out: 1 support");
  EXPECT_NEAR(report["volume"], 1, 1e-12);
}

TEST_F(ThreeMf, IsRefusedInOneLineWhereItIsDamaged)
{
  const std::string cube = objectOf(R"(id="1")", cubesOf(1)), item = R"(<item objectid="1"/>)";
  const std::string whole = packageOf(modelOf(cube, item));
  for (std::size_t size = 0; size < whole.size(); size += whole.size() / 9)
  {
    this->expectRefused(whole.substr(0, size), "");
  }
  std::string changed = whole; // the sum of the file no longer holds
  changed[changed.find("vertex x=\"1\"") + 10] = '3';
  this->expectRefused(changed, "cannot be unpacked; it is damaged");
  this->expectRefused(packageOf("<model><resources>"), "its 3D/a.model is no whole XML");
  this->expectRefused(zipOf({{"a.stl", "solid"}}), "has no _rels/.rels in it");
  this->expectRefused(packageOf(modelOf(cube, R"(<item objectid="7"/>)")), "an object 7 that");
  this->expectRefused(packageOf(modelOf("", "")), "has no surface and no points in it");
  this->expectRefused(
    packageOf(modelOf(objectOf(R"(id="1")", componentsOf(R"(<component objectid="1"/>)")), item)),
    "is a component of itself");
  this->expectRefused(packageOf(modelOf(cube, item, R"(unit="cubit")")), "the unit 'cubit'");
  this->expectRefused(packageOf(modelOf(cube + cube, item)), "the id 1 twice of <object>");
  for (const std::string number : {"0,5", "0x1", "", "a", "1e400"})
  {
    std::string text = modelOf(cube, item);
    text.replace(text.find("x=\"1\"") + 3, 1, number);
    this->expectRefused(packageOf(text), "'" + number + "' for x of <vertex>");
  }
  std::string tiny = modelOf(cube, item);
  tiny.replace(tiny.find("x=\"0\"") + 3, 1, "1e-400"); // 0, as rounding makes it
  EXPECT_NEAR(this->check(packageOf(tiny))["volume"], 1, 1e-12);
  const std::string turned = R"(<item objectid="1" transform="1 0 0 0 1 0 0 0 1 )";
  this->expectRefused(
    packageOf(modelOf(cube, turned + "2 3\"/>")), "11 numbers, not 12, for transform of <item>");
  this->expectRefused(
    packageOf(modelOf(cube, turned + "1,5 0 0\"/>")), "'1,5' for transform of <item>");
  this->expectRefused(
    packageOf(modelOf(cube, item, R"(requiredextensions="b" xmlns:b="http://a/beamlattice/1")")),
    "needs the extension http://a/beamlattice/1");
  this->expectRefused("solid a\nendsolid a\n", "does not begin like ZIP");
}

} // namespace
