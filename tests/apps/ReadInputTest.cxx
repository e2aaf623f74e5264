// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"
#include "apps/RunProgram.h"
#include "support/Gzip.h"

#include <gtest/gtest.h>

#include "vtkVersionMacros.h"

#include <cctype>
#include <filesystem>
#include <random>
#include <regex>
#include <tuple>

#include <sys/stat.h>
#include <unistd.h>

namespace
{

const std::vector<std::string> allSuffixes = {
  "vtp", "vtk", "vtu", "ply", "stl", "obj", "off", "xyz", "pwn", "csv"};

Outcome check(const std::string& fileName)
{
  return runProgram({"check", fileName, "--json"});
}

TEST(ReadInput, EveryFormat)
{
  const TemporaryFolder folder;
  const Mesh mesh = sphere(2);
  for (const std::string& suffix : allSuffixes)
  {
    const Outcome run = check(folder.write("in." + suffix, asFile(mesh, suffix)));
    ASSERT_EQ(run.status, 0) << run;
    EXPECT_EQ(run.err, "");
    const bool isCloud = suffix == "xyz" || suffix == "pwn" || suffix == "csv";
    const nlohmann::json report = run.json();
    EXPECT_EQ(report["kind"], isCloud ? "points" : "surface") << run;
    if (isCloud)
    {
      EXPECT_EQ(report["points"], mesh.points.size());
      EXPECT_EQ(report["normals"], true);
    }
    else
    {
      EXPECT_EQ(report["triangles"], mesh.triangles.size());
      EXPECT_EQ(report["vertices_merged"], mesh.points.size());
      EXPECT_EQ(report["closed"], true);
    }
  }
}

/// Files and pipes must not get into the places of closed streams.
TEST(ReadInput, WithoutStandardStreams)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.vtp", asFile(sphere(1), "vtp"));
  const std::string out = folder.path("out.vti"), alone = folder.path("alone.vti");
  const std::vector<std::string> arguments = {"field", in, "--resolution", "4", "--quiet", "-o"};
  const auto with = [&arguments](const std::string& name)
  {
    std::vector<std::string> all = arguments;
    all.push_back(name);
    return all;
  };
  ASSERT_EQ(runProgram(with(out)).status, 0);
  const Outcome run = runProgram(with(alone), "sh -c 'exec \"$@\" <&- >&- 2>&-' sh ");
  EXPECT_EQ(run.status, 0) << run;
  EXPECT_EQ(contentsOf(alone), contentsOf(out));
}

TEST(ReadInput, TextVariantsOfBinaryFormats)
{
  const TemporaryFolder folder;
  const Mesh mesh = sphere(2);
  for (const std::string& fileName :
    {folder.write("in.ply", asPly(mesh)), folder.write("in.stl", asStl(mesh))})
  {
    const Outcome run = check(fileName);
    ASSERT_EQ(run.status, 0) << run;
    EXPECT_EQ(run.json()["closed"], true);
  }
}

/// Some programs write the words of STL in capitals, or begin them with one.
TEST(ReadInput, StlInLettersOfAnySize)
{
  const TemporaryFolder folder;
  const std::string small = asStl(sphere(1));
  std::string capitals = small, beginnings = small;
  for (std::size_t i = 0; i < small.size(); ++i)
  {
    const char capital = static_cast<char>(std::toupper(static_cast<unsigned char>(small[i])));
    capitals[i] = capital;
    beginnings[i] =
      i == 0 || std::isspace(static_cast<unsigned char>(small[i - 1])) != 0 ? capital : small[i];
  }
  for (const std::string& text : {small, capitals, beginnings})
  {
    const Outcome run = check(folder.write("a.stl", text));
    ASSERT_EQ(run.status, 0) << run;
    EXPECT_EQ(run.json()["triangles"], 32) << text.substr(0, 100);
    EXPECT_EQ(run.json()["closed"], true);
    const Outcome cut = check(folder.write("a.stl", text.substr(0, text.size() - 30)));
    EXPECT_EQ(cut.status, 2) << cut;
  }
}

/// Editors may leave the end of the last line away, and Windows ends lines with two characters.
TEST(ReadInput, LineEnds)
{
  const TemporaryFolder folder;
  const Mesh mesh = sphere(1);
  const std::pair<std::string, std::string> files[] = {{"a.off", asOff(mesh)},
    {"a.obj", asObj(mesh)}, {"a.ply", asPly(mesh)}, {"a.stl", asStl(mesh)}, {"a.vtk", asVtk(mesh)},
    {"a.vtp", asVtp(mesh)}, {"a.xyz", asXyz(mesh)}, {"a.pwn", asPwn(mesh)}, {"a.csv", asCsv(mesh)}};
  for (const auto& [name, text] : files)
  {
    const auto countsOf = [&, &name = name](const std::string& contents)
    {
      const Outcome run = check(folder.write(name, contents));
      EXPECT_EQ(run.status, 0) << run;
      const nlohmann::json report = run.json();
      return report[report["kind"] == "surface" ? "triangles" : "points"];
    };
    EXPECT_EQ(countsOf(text.substr(0, text.size() - 1)), countsOf(text)) << name;
    for (const std::string end : {"\r\n", "\r"})
    {
      const std::string other = std::regex_replace(text, std::regex("\n"), end);
      if (end == "\r\n" || (name != "a.vtk" && name != "a.vtp"))
      {
        EXPECT_EQ(countsOf(other), countsOf(text)) << name;
      }
    }
  }
}

TEST(ReadInput, CloudsKeepTheirNormals)
{
  const TemporaryFolder folder;
  const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float "
    "y\nproperty float z\nproperty float nx\nproperty float ny\nproperty float "
    "nz\nend_header\n0 0 0 0 0 1\n1 0 0 0 0 2\n";
  const Outcome run = check(folder.write("cloud.ply", ply));
  ASSERT_EQ(run.status, 0) << run;
  EXPECT_EQ(run.json()["normals"], true);
  EXPECT_EQ(run.json()["non_unit_normals"], 1);
}

TEST(ReadInput, MissingEmptyOrAFolder)
{
  const TemporaryFolder folder;
  for (const std::string& suffix : allSuffixes)
  {
    const Outcome missing = check(folder.path("missing." + suffix));
    EXPECT_EQ(missing.status, 2) << missing;
    EXPECT_TRUE(missing.saysInOneLine({"missing." + suffix, "no such file"})) << missing;

    const Outcome empty = check(folder.write("empty." + suffix, ""));
    EXPECT_EQ(empty.status, 2) << empty;
    EXPECT_TRUE(empty.saysInOneLine({"empty." + suffix, "is empty"})) << empty;

    mkdir(folder.path("folder." + suffix).c_str(), 0777);
    const Outcome directory = check(folder.path("folder." + suffix));
    EXPECT_EQ(directory.status, 2) << directory;
    EXPECT_TRUE(directory.saysInOneLine({"folder." + suffix, "is a folder"})) << directory;
  }
}

TEST(ReadInput, Unreadable)
{
  if (geteuid() == 0)
  {
    GTEST_SKIP() << "the superuser can read everything";
  }
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere(1)));
  chmod(in.c_str(), 0);
  const Outcome run = check(in);
  EXPECT_EQ(run.status, 2) << run;
  EXPECT_TRUE(run.saysInOneLine({in, "permissions"})) << run;
}

TEST(ReadInput, TextInUtf16IsNamed)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere(1)));
  for (const char* const name : {"a.obj", "a.csv", "a.gltf", "a.vtk", "a.vtp", "a.mhd"})
  {
    std::string wide = "\xFF\xFE";
    for (const char letter : std::string("x,y,z\n0,0,0\n"))
    {
      wide += letter;
      wide += '\0';
    }
    const std::string file = folder.write(name, wide);
    const bool isImage = name == std::string("a.mhd");
    const Outcome run =
      isImage ? runProgram({"field", in, "-o", folder.path("a.vti"), "--like", file}) : check(file);
    EXPECT_EQ(run.status, 2) << run;
    EXPECT_TRUE(run.saysInOneLine({name, "is text in UTF-16; save it as UTF-8"})) << run;
  }
}

/// VTK warns of keys that it does not know.
TEST(ReadInput, WhatIsNotNeededIsNotSaid)
{
  const TemporaryFolder folder;
  std::string file = asVtp(sphere(2));
  const std::string key =
    R"(<InformationKey name="NOTE" location="SomeProgram"> 3 </InformationKey>)";
  const std::size_t end = file.find("</DataArray>");
  ASSERT_NE(end, std::string::npos);
  file.insert(end, key);
  const Outcome run = check(folder.write("in.vtp", file));
  EXPECT_EQ(run.status, 0) << run;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run.json()["closed"], true);
}

/// The first of several time steps is read, and a line says so.
TEST(ReadInput, TheFirstOfTimeSteps)
{
  const TemporaryFolder folder;
  const auto arrayOf = [](int step, const std::string& numbers)
  {
    return R"(<DataArray type="Float64" Name="Points" NumberOfComponents="3" TimeStep=")" +
           std::to_string(step) + "\">" + numbers + "</DataArray>";
  };
  const std::string file = folder.write(
    "steps.vtp", R"(<VTKFile type="PolyData" version="1.0"><PolyData TimeValues="0 1"><Piece)"
                 R"( NumberOfPoints="4" NumberOfPolys="4"><Points>)" +
                   arrayOf(0, "0 0 0 1 0 0 0 1 0 0 0 1") + arrayOf(1, "0 0 0 3 0 0 0 3 0 0 0 3") +
                   R"(</Points><Polys><DataArray type="Int64" Name="connectivity">)"
                   R"(0 2 1 0 1 3 0 3 2 1 2 3</DataArray><DataArray type="Int64" Name="offsets">)"
                   R"(3 6 9 12</DataArray></Polys></Piece></PolyData></VTKFile>)");
  const Outcome run = check(file);
  ASSERT_EQ(run.status, 0) << run;
  EXPECT_NEAR(run.json()["volume"], 1 / 6.0, 1e-12);
  EXPECT_NE(run.err.find("steps.vtp: has 2 time steps; the first one is read\n"), std::string::npos)
    << run;
}

TEST(ReadInput, UnknownSuffix)
{
  const TemporaryFolder folder;
  const Outcome run = check(folder.write("in.step", "whatever"));
  EXPECT_EQ(run.status, 2) << run;
  EXPECT_TRUE(run.saysInOneLine({"in.step", "suffix", ".off"})) << run;
}

TEST(ReadInput, TruncatedAnywhere)
{
  const TemporaryFolder folder;
  const Mesh mesh = sphere(1);
  for (const std::string& suffix : allSuffixes)
  {
    const std::string whole = asFile(mesh, suffix);
    for (const double part : {0.003, 0.1, 0.35, 0.6, 0.8, 0.99})
    {
      // The cut is within a number or a word, not between lines: half of an .xyz is a good .xyz.
      std::size_t length = static_cast<std::size_t>(part * static_cast<double>(whole.size()));
      while (length > 1 && (whole[length - 1] == '\n' || whole[length] == '\n'))
      {
        --length;
      }
      const Outcome run =
        check(folder.write("cut." + suffix, whole.substr(0, std::max<std::size_t>(1, length))));
      // These formats may be cut within the last number of a line, where nobody can tell.
      const bool cannotTell =
        suffix == "xyz" || suffix == "pwn" || suffix == "csv" || suffix == "obj";
      EXPECT_TRUE(run.status == 2 || (cannotTell && run.status == 0)) << suffix << part << run;
      EXPECT_TRUE(run.status == 0 || run.saysInOneLine({"cut." + suffix})) << part << run;
    }
  }
}

TEST(ReadInput, GarbageUnderEverySuffix)
{
  const TemporaryFolder folder;
  std::mt19937 random(5);
  std::string garbage;
  for (int i = 0; i < 5000; ++i)
  {
    garbage += static_cast<char>(random());
  }
  for (const std::string& suffix : allSuffixes)
  {
    for (const std::string& contents : {garbage, std::string("hello world\n")})
    {
      const Outcome run = check(folder.write("garbage." + suffix, contents));
      EXPECT_EQ(run.status, 2) << run;
      EXPECT_TRUE(run.saysInOneLine({"garbage." + suffix})) << run;
    }
  }
}

/// The suffix promises one format and the file holds another.
/// An XML file of a format that VTK does not know yet: half of the versions, and polyhedra, which
/// have another layout from 2.3 on.
TEST(ReadInput, FilesOfNewerVersionsOfVtkAreSaidToBeThat)
{
  const TemporaryFolder folder;
  const std::string cells =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"9.7\"><UnstructuredGrid>"
    "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><Points><DataArray type=\"Float64\" "
    "NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Cells>"
    "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 3</DataArray>"
    "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">4</DataArray>"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">TYPE</DataArray>"
    "</Cells></Piece></UnstructuredGrid></VTKFile>\n";
  const auto withType = [&cells](const std::string& type)
  {
    std::string text = cells;
    return text.replace(text.find("TYPE"), 4, type);
  };
  const Outcome tetrahedron = check(folder.write("a.vtu", withType("10")));
  EXPECT_EQ(tetrahedron.status, 0) << tetrahedron;
  EXPECT_EQ(tetrahedron.json()["triangles"], 4);
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
  const Outcome polyhedron = check(folder.write("b.vtu", withType("42")));
  EXPECT_EQ(polyhedron.status, 2) << polyhedron;
  EXPECT_TRUE(polyhedron.saysInOneLine(
    {"b.vtu: was written by a newer VTK, format 9.7; save its surface there, as .ply"}))
    << polyhedron;
#endif
  std::string broken = withType("10");
  broken.replace(broken.find("0 0 0 1"), 7, "0 0 0 x");
  const Outcome unknown = check(folder.write("c.vtu", broken));
  EXPECT_EQ(unknown.status, 2) << unknown;
  EXPECT_TRUE(unknown.saysInOneLine({"c.vtu: was written by a newer VTK, format 9.7"})) << unknown;
}

/// Files as people have them, which lie next to the shared meshes.
TEST(ReadInput, SharedCases)
{
  const std::string cases = std::string(WINDING_SHARED_DATA) + "/../cases/";
  if (!std::filesystem::exists(cases))
  {
    GTEST_SKIP() << cases << " is not there";
  }
  const std::tuple<const char*, int, const char*> expected[] = {
    {"c02_xyzrgb.xyz", 0, "columns 4 to 6 are taken for colours"},
    {"c02_comma.xyz", 0, ""},
    {"c03_cc.csv", 0, ""},
    {"c03_enu.csv", 0, ""},
    {"c03_q_name.csv", 0, ""},
    {"c07_blank.stl", 0, ""},
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
    {"c11_polyh.vtu", 2, "written by a newer VTK, format 2.3"},
#else
    {"c11_polyh.vtu", 0, ""},
#endif
    {"c17_ncoff.off", 0, ""},
    {"c18_tristrips.ply", 0, ""},
    {"c35_unref_nan.obj", 0, ""},
    {"c44_splats.ply", 0, ""}
  };
  for (const auto& [name, status, words] : expected)
  {
    const Outcome run = check(cases + name);
    EXPECT_EQ(run.status, status) << run;
    EXPECT_NE(run.err.find(words), std::string::npos) << run;
  }
  EXPECT_NEAR(check(cases + "c18_tristrips.ply").json()["volume"], 4.0, 0.2);
}

TEST(ReadInput, WrongSuffix)
{
  const TemporaryFolder folder;
  const Mesh mesh = sphere(1);
  const Outcome plyAsStl = check(folder.write("a.stl", asBinaryPly(mesh)));
  EXPECT_EQ(plyAsStl.status, 2);
  EXPECT_TRUE(plyAsStl.saysInOneLine({"is not stl", "begins like PLY", ".ply"})) << plyAsStl;
  for (const std::string& suffix : allSuffixes)
  {
    for (const std::string& content : allSuffixes)
    {
      const bool arePoints = content == "xyz" || content == "pwn" || content == "csv";
      const bool fits = suffix == content || ((suffix == "pwn" || suffix == "xyz") && arePoints);
      if (!fits)
      {
        const Outcome run = check(folder.write("wrong." + suffix, asFile(mesh, content)));
        EXPECT_EQ(run.status, 2) << suffix << " holds " << content << " " << run;
        EXPECT_TRUE(run.saysInOneLine({"wrong." + suffix})) << content << run;
      }
    }
  }
}

TEST(ReadInput, Compressed)
{
  const TemporaryFolder folder;
  const Outcome run = check(folder.write("in.stl", std::string("\x1f\x8b\x08\x00", 4) + "packed"));
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(run.saysInOneLine({"gzip", "unpack", ".stl.gz"})) << run;

  const Mesh mesh = sphere(2);
  for (const std::string suffix : {"obj", "stl", "ply", "off"})
  {
    const Outcome packed = check(folder.write("in." + suffix + ".gz", gzip(asFile(mesh, suffix))));
    ASSERT_EQ(packed.status, 0) << packed;
    EXPECT_EQ(packed.json()["triangles"], mesh.triangles.size());
  }
  const std::string in = folder.path("in.obj.gz"), out = folder.path("out.csv");
  const std::string queries = folder.write("at.csv.gz", gzip("x,y,z\n0,0,0\n"));
  EXPECT_EQ(runProgram({"probe", in, queries, "-o", out}).err, "");
  EXPECT_EQ(contentsOf(out), "x,y,z,WindingNumber,Inside\n0,0,0,1,1\n");
  EXPECT_TRUE(check(folder.write("in.vtp.gz", gzip(asVtp(mesh))))
                .saysInOneLine({"suffix that is not known", "packed as .gz"}));
  EXPECT_EQ(runProgram({"surface", in, "-o", folder.path("out.ply.gz")}).status, 1);
}

/// Packers that nothing is unpacked of are named by the marks of their files.
TEST(ReadInput, CompressedByOthers)
{
  const TemporaryFolder folder;
  const std::string magic[] = {std::string("PK\x03\x04\x14\0", 6), "BZh91AY&SY\x01\x02",
    std::string("\xFD") + "7zXZ" + std::string("\0\0\x04", 3)};
  const std::string names[] = {"zip", "bzip2", "xz"};
  for (std::size_t n = 0; n < 3; ++n)
  {
    for (const std::string suffix : {"obj", "stl", "xyz"})
    {
      const Outcome run = check(folder.write("in." + suffix, magic[n] + std::string(100, '\x02')));
      EXPECT_EQ(run.status, 2) << run;
      EXPECT_TRUE(run.saysInOneLine({"compressed with " + names[n], "unpack it first"})) << run;
    }
  }
  // A text may begin with the letters.
  const Outcome text = check(folder.write("in.obj", "BZh91\nv 0 0 0\n"));
  EXPECT_EQ(text.err.find("bzip2"), std::string::npos) << text;
}

/// Counts that no file of that size can hold must not be believed.
TEST(ReadInput, HugeAndNegativeCounts)
{
  const TemporaryFolder folder;
  const auto replaced = [](std::string text, const std::string& from, const std::string& to)
  {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  };
  const Mesh mesh = sphere(1);
  for (const std::string number : {"99999999999", "-18"})
  {
    const std::pair<std::string, std::string> files[] = {
      {"a.off", replaced(asOff(mesh), "OFF\n18", "OFF\n" + number)},
      {"a.ply", replaced(asPly(mesh), "vertex 18", "vertex " + number)},
      {"b.ply", replaced(asBinaryPly(mesh), "face 32", "face " + number)},
      {"a.pwn", replaced(asPwn(mesh), "18\n", number + "\n")},
      {"a.vtk", replaced(asVtk(mesh), "POINTS 18", "POINTS " + number)},
      {"b.vtk", replaced(asVtk(mesh), "POLYGONS 32", "POLYGONS " + number)},
      {"a.vtp", replaced(asVtp(mesh), "NumberOfPoints=\"18", "NumberOfPoints=\"" + number)},
      {"a.vtu", replaced(asVtu(mesh), "NumberOfCells=\"32", "NumberOfCells=\"" + number)},
    };
    for (const auto& [name, contents] : files)
    {
      const Outcome run = check(folder.write(name, contents));
      EXPECT_EQ(run.status, 2) << run;
      EXPECT_TRUE(run.saysInOneLine({name})) << run;
    }
  }
  std::string stl = asBinaryStl(mesh);
  stl[83] = '\x7f';
  const Outcome run = check(folder.write("a.stl", stl));
  EXPECT_EQ(run.status, 2) << run;
  EXPECT_TRUE(run.saysInOneLine({"a.stl", "triangles but holds 32"})) << run;
}

TEST(ReadInput, IndicesOutOfRange)
{
  const TemporaryFolder folder;
  Mesh mesh = sphere(1);
  mesh.triangles[20][1] = 5000;
  for (const std::string suffix : {"off", "obj", "ply", "vtu"})
  {
    const Outcome run = check(folder.write("bad." + suffix, asFile(mesh, suffix)));
    EXPECT_EQ(run.status, 2) << run;
    EXPECT_TRUE(run.saysInOneLine({"bad." + suffix})) << run;
  }
  // VTK's own formats are read, and the triangle is left out and counted.
  for (const std::string suffix : {"vtp", "vtk"})
  {
    const Outcome run = check(folder.write("bad." + suffix, asFile(mesh, suffix)));
    ASSERT_EQ(run.status, 0) << run;
    EXPECT_EQ(run.json()["invalid_ids"], 1);
  }
}

TEST(ReadInput, BrokenTables)
{
  const TemporaryFolder folder;
  const std::pair<std::string, std::string> cases[] = {
    {"a,b,c\n1,2,3\n", "columns x, y and z"},
    {"x,y,z\n1,2\n", "line 2: has 2 fields"},
    {"x,y,z\n1,2,3\n4,five,6\n", "line 3: \"five\" in column y"},
  };
  for (const auto& [contents, part] : cases)
  {
    const Outcome run = check(folder.write("in.csv", contents));
    EXPECT_EQ(run.status, 2) << run;
    EXPECT_TRUE(run.saysInOneLine({"in.csv", part})) << run;
  }
}

TEST(ReadInput, WarningsAreOneLineEachAndQuietDropsThem)
{
  const TemporaryFolder folder;
  Mesh mesh = sphere(1);
  mesh.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  const std::string in = folder.write("in.off", asOff(mesh));
  const Outcome loud = runProgram({"field", in, "-o", folder.path("a.vti"), "--resolution", "8"});
  EXPECT_EQ(loud.status, 0) << loud;
  EXPECT_EQ(loud.err.rfind("winding: warning: " + in, 0), 0u) << loud;
  EXPECT_EQ(loud.err.find('\n'), loud.err.size() - 1) << loud;
  const Outcome quiet =
    runProgram({"field", in, "-o", folder.path("a.vti"), "--resolution", "8", "--quiet"});
  EXPECT_EQ(quiet.err, "");
  EXPECT_EQ(quiet.out, "");
}

} // namespace
