// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// Tables of points: what they give, what they refuse, and that threads and blocks change nothing.

#include "files/Parsing.h"
#include "support/Interruption.h"
#include "support/KeptTexts.h"
#include "support/ShuffledThreads.h"

#include "files/TableFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

using namespace winding;

namespace
{

using Numbers = std::vector<double>;
using Texts = std::vector<std::string>;

struct Table : PointTable
{
  std::map<std::size_t, Texts> texts; ///< by the places of their columns
};

/// The way in which a table is read.
struct Way
{
  bool withOthers = false; ///< columns without a meaning, and rows
  bool withNormals = true;
  char separator = ',';
  std::size_t bytesPerBlock = LineBlocks::usualBytes;
};

constexpr Way withOthers = {true};

Table read(const InputFile& file, const Way& way, Executor& executor)
{
  KeptTexts texts;
  TableOptions options;
  options.separator = way.separator;
  options.normalsAndAreas = way.withNormals;
  options.rows = way.withOthers;
  options.texts = way.withOthers ? &texts : nullptr;
  options.bytesPerBlock = way.bytesPerBlock;
  Table table = {readPointTable(file, options, executor), {}};
  table.texts = texts.all();
  return table;
}

Table read(const std::string& contents, const Way& way, Executor& executor)
{
  const TemporaryFile file(contents);
  return read(InputFile(file.name()), way, executor);
}

Table read(const std::string& contents, const Way& way = {})
{
  SerialExecutor serial;
  return read(contents, way, serial);
}

/// The points of a table, as parsers of meshes give them.
template <char separator> MeshArrays readPoints(const InputFile& file, Executor& executor)
{
  Way way;
  way.separator = separator;
  return std::move(read(file, way, executor).points);
}

std::string refusalOf(const std::string& contents)
{
  return ::refusalOf(readPoints<','>, contents);
}

void expectSameTable(const Table& a, const Table& b)
{
  expectSame(a.points, b.points);
  EXPECT_EQ(vectorOf(a.points.areas), vectorOf(b.points.areas));
  EXPECT_EQ(a.rows, b.rows);
  EXPECT_EQ(a.header, b.header);
  EXPECT_EQ(a.names, b.names);
  EXPECT_EQ(a.texts, b.texts);
  ASSERT_EQ(a.columns.size(), b.columns.size());
  for (std::size_t i = 0; i < a.columns.size(); ++i)
  {
    EXPECT_EQ(a.columns[i].name, b.columns[i].name);
    EXPECT_EQ(vectorOf(a.columns[i].numbers), vectorOf(b.columns[i].numbers));
  }
}

TEST(TableFile, PositionsNormalsAndAreas)
{
  const Table table =
    read("nz,x,area,y,z,nx,ny\n1,2,3,4,5,6,7\n\n +8 , -.5,1e3,0.1,nan,\"9\",-inf\n");
  EXPECT_EQ(table.points.points.doubles.size(), 6u);
  EXPECT_EQ(Numbers(table.points.points.doubles.begin(), table.points.points.doubles.begin() + 5),
    (Numbers{2, 4, 5, -0.5, 0.1}));
  EXPECT_TRUE(std::isnan(table.points.points.doubles[5]));
  EXPECT_EQ(vectorOf(table.points.normals.doubles), (Numbers{6, 7, 1, 9, -INFINITY, 8}));
  EXPECT_EQ(vectorOf(table.points.areas), (Numbers{3, 1e3}));
  expectCells(table.points.vertices, {0, 2}, {0, 1});
  EXPECT_TRUE(table.columns.empty());
  EXPECT_TRUE(table.rows.empty());
}

TEST(TableFile, NamesOfColumns)
{
  const Table table = read("\"Points:2\",POINTS:0,Points:1,Normals:0,NORMALS:1,normals:2\n"
                           "3,1,2,4,5,6\n");
  EXPECT_EQ(vectorOf(table.points.points.doubles), (Numbers{1, 2, 3}));
  EXPECT_EQ(vectorOf(table.points.normals.doubles), (Numbers{4, 5, 6}));
  EXPECT_EQ(table.names.front(), "Points:2");
  const Table twice = read("x,y,z,X\n1,2,3,4\n", withOthers);
  EXPECT_EQ(vectorOf(twice.points.points.doubles), (Numbers{1, 2, 3})) << "the first counts";
  ASSERT_EQ(twice.columns.size(), 1u);
  EXPECT_EQ(twice.columns[0].name, "X");
  EXPECT_EQ(read("x,y,z,nx,ny\n1,2,3,4,5\n").points.normals.count(), 0u)
    << "a component is missing";
}

/// ParaView saves arrays of any names with the points, in any order.
TEST(TableFile, NamesOfParaViewAndOthersAreNotMixed)
{
  const Table table = read("x,nx,Points:0,Points:1,Points:2\n9,8,1,2,3\n", withOthers);
  EXPECT_EQ(vectorOf(table.points.points.doubles), (Numbers{1, 2, 3}));
  EXPECT_EQ(table.points.normals.count(), 0u);
  ASSERT_EQ(table.columns.size(), 2u);
  EXPECT_EQ(table.columns[0].name, "x");
  const Table both = read("x,y,z,Points:0,Points:1,Points:2\n9,9,9,1,2,3\n", withOthers);
  EXPECT_EQ(vectorOf(both.points.points.doubles), (Numbers{1, 2, 3}));
  const Table partly = read("x,y,z,nx,ny,nz,Points:0,Normals:1\n1,2,3,4,5,6,7,8\n", withOthers);
  EXPECT_EQ(vectorOf(partly.points.points.doubles), (Numbers{1, 2, 3}));
  EXPECT_EQ(vectorOf(partly.points.normals.doubles), (Numbers{4, 5, 6}));
  EXPECT_NE(refusalOf("x,Points:1,Points:2\n1,2,3\n"), "");
}

TEST(TableFile, OtherColumnsAreNumbersOrTexts)
{
  const Table table =
    read(",x,y,z,t,name,area,\"a, \"\"b\"\"\"\n1,0,0,0,7,\"p\nq\",2,\n2,0,0,0,8e400,r,3,4\n"
         "3,0,0,0,-8e-400, s ,4,5\" pipe\n",
      withOthers);
  ASSERT_EQ(table.columns.size(), 4u);
  EXPECT_EQ(table.columns[0].name, "Column 1");
  EXPECT_EQ(vectorOf(table.columns[0].numbers), (Numbers{1, 2, 3}));
  EXPECT_EQ(table.texts.at(1), (Texts{"7", "8e400", "-8e-400"})) << "no double holds 8e400";
  EXPECT_EQ(table.texts.at(2), (Texts{"p\nq", "r", "s"}));
  EXPECT_TRUE(table.columns[2].numbers.empty());
  EXPECT_EQ(table.columns[3].name, "a, \"b\"");
  EXPECT_EQ(table.texts.at(3), (Texts{"", "4", "5\" pipe"}));
  EXPECT_EQ(vectorOf(table.points.areas), (Numbers{2, 3, 4}));
}

TEST(TableFile, OtherColumnsHaveNamesOfTheirOwn)
{
  const auto namesFor = [](const std::string& header, bool withNormals)
  {
    Way way = withOthers;
    way.withNormals = withNormals;
    Texts names;
    for (const TableColumn& column : read(header + "\n", way).columns)
    {
      names.push_back(column.name);
    }
    return names;
  };
  EXPECT_EQ(namesFor("t,x,y,z,t,,Column 6,t 5", true),
    (Texts{"t", "t 5 5", "Column 6 6", "Column 6", "t 5"}));
  EXPECT_EQ(namesFor("x,y,z,area,Area,nx,ny,nz,Normals", true), (Texts{"Area 5", "Normals 9"}));
  EXPECT_EQ(namesFor("x,y,z,nx,ny,Normals,Area", true), (Texts{"nx", "ny", "Normals"}));
  EXPECT_EQ(namesFor("x,y,z,area,Area,Normals", false), (Texts{"area", "Area", "Normals"}));
  EXPECT_EQ(namesFor(std::string("x,y,z,a\0b,a\0c", 13), true), (Texts{"a", "a 5"}));
}

TEST(TableFile, NormalsAndAreasMayBeColumnsAsAllOthers)
{
  Way way = withOthers;
  way.withNormals = false;
  const Table table = read("x,y,z,nx,ny,nz,area\n1,2,3,4,5,6,north\n", way);
  EXPECT_EQ(table.points.normals.count(), 0u);
  EXPECT_TRUE(table.points.areas.empty());
  ASSERT_EQ(table.columns.size(), 4u);
  EXPECT_EQ(vectorOf(table.columns[2].numbers), (Numbers{6}));
  EXPECT_EQ(table.texts.at(3), (Texts{"north"}));
}

TEST(TableFile, KeepsRows)
{
  const std::string header = "x,y,z,\"a\nb\"\r\n", first = " 1,2,3,\"\r\n\"", second = "4,5,6,7 ";
  const std::string contents = "\xEF\xBB\xBF\n" + header + first + "\r\n\r\n  \n" + second;
  const Table table = read(contents, withOthers);
  EXPECT_EQ(table.header, header);
  EXPECT_EQ(table.names, (Texts{"x", "y", "z", "a\nb"}));
  EXPECT_EQ(table.rows, (std::vector<std::string_view>{first, second}));
}

TEST(TableFile, LinesMayEndWithCarriageReturns)
{
  const Table table =
    read("x,y,z,nx,ny,nz,t\r1,2,3,0,0,1,\"a,\r\nb\"\r4,5,6,0,0,1,7\r", withOthers);
  EXPECT_EQ(vectorOf(table.points.points.doubles), (Numbers{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(table.header, "x,y,z,nx,ny,nz,t\n");
  EXPECT_EQ(
    table.rows, (std::vector<std::string_view>{"1,2,3,0,0,1,\"a,\r\nb\"", "4,5,6,0,0,1,7"}));
}

TEST(TableFile, TabsSeparate)
{
  Way way = withOthers;
  way.separator = '\t';
  const Table table = read("x\ty\tz\tt\n1\t 2\t3\ta,b\n4\t5\t6\t\n", way);
  EXPECT_EQ(vectorOf(table.points.points.doubles), (Numbers{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(table.texts.at(0), (Texts{"a,b", ""}));
  way.withOthers = false;
  const Table gaps = read("x\ty\tz\n1\t2\t3\n\t\t\n \n", way);
  ASSERT_EQ(gaps.points.points.count(), 2u) << "a row of empty fields is one";
  EXPECT_TRUE(std::isnan(gaps.points.points.doubles[3]));
  EXPECT_EQ(::refusalOf(readPoints<'\t'>, "x\ty\tz\n1,5,2\t2\t3\n"),
    "line 2: \"1,5,2\" in column x is no number; write a decimal point");
}

/// Excel and R write what is usual in their country, whatever the suffix is.
TEST(TableFile, OtherLettersMaySeparate)
{
  for (const char preferred : {',', '\t'})
  {
    Way way = withOthers;
    way.separator = preferred;
    for (const std::string text : {"x;y;z;t\n1.5;2;3;7\n", "x;y;z;t\n1,5;2;3;7\n",
           "\"x\";\"y\";\"z\";\"t\"\n1,5;\"2,0\";3;7,0\n", "x,y,z,t\n1.5,2,3,7\n",
           "\"x\",\"y\",\"z\",\"t\"\n\"1.5\",2,3,7\n", "x\ty\tz\tt\n1.5\t2\t3\t7\n",
           "x\ty\tz\tt\n1,5\t2,0\t3\t7\n", "sep=;\r\nx;y;z;t\n1,5;2;3;7\n",
           "sep=,\nx,y,z,t\n1.5,2,3,7\n"})
    {
      const Table table = read(text, way);
      EXPECT_EQ(vectorOf(table.points.points.doubles), (Numbers{1.5, 2, 3})) << text;
      EXPECT_EQ(vectorOf(table.columns.at(0).numbers), (Numbers{7})) << text;
      EXPECT_NE(text.find(table.separator), std::string::npos) << text;
      EXPECT_EQ(table.hasDecimalCommas, text.find("1,5") != std::string::npos) << text;
    }
  }
}

TEST(TableFile, ThousandsAreNoDecimals)
{
  EXPECT_NE(::refusalOf(readPoints<'\t'>, "x\ty\tz\n31,145\t354,375\t0.5\n")
              .find("has decimal commas and decimal points"),
    std::string::npos);
}

TEST(TableFile, TextOfCloudCompare)
{
  for (const std::string count : {"", "2\n"})
  {
    const Table table = read("//X;Y;Z;R;Nx;Ny;Nz\n" + count + "1;2;3;9;0;0;1\n4;5;6;9;0;1;0\n");
    EXPECT_EQ(vectorOf(table.points.points.doubles), (Numbers{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(vectorOf(table.points.normals.doubles), (Numbers{0, 0, 1, 0, 1, 0}));
    EXPECT_EQ(table.header, "//X;Y;Z;R;Nx;Ny;Nz\n");
  }
}

TEST(TableFile, NamesOfSurveyors)
{
  for (const std::string names : {"Easting,Northing,Elevation", "east,north,height",
         "EASTING (m),NORTHING (m),ALTITUDE[m]", "X [ft],northing,Height", "x,y,elevation"})
  {
    EXPECT_EQ(
      vectorOf(read("id," + names + "\n7,1,2,3\n").points.points.doubles), (Numbers{1, 2, 3}))
      << names;
  }
  EXPECT_EQ(vectorOf(read("northing,easting,height,z\n1,2,3,4\n").points.points.doubles),
    (Numbers{2, 1, 4}))
    << "z is a height of its own name";
}

TEST(TableFile, EmptyFieldsAreNoNumbers)
{
  const Table table = read("t,x,y,z,nx,ny,nz,area\n<1,1,2,3,0,0,1,\n,, ,,,,,\n,1,\"\",3,,,,2\n");
  const auto isNan = [](double number)
  {
    return std::isnan(number);
  };
  const auto count = [&isNan](const PlainArray<double>& numbers)
  {
    return std::count_if(numbers.begin(), numbers.end(), isNan);
  };
  EXPECT_EQ(count(table.points.points.doubles), 4);
  EXPECT_EQ(count(table.points.normals.doubles), 6);
  EXPECT_EQ(count(table.points.areas), 2);
}

TEST(TableFile, WithoutRows)
{
  for (const std::string end : {"", "\n", "\r\n", "\n\n  \n"})
  {
    const Table table = read("x,y,z,nx,ny,nz,area,t" + end, withOthers);
    EXPECT_EQ(table.points.points.count(), 0u);
    EXPECT_EQ(table.points.vertices.count(), 0u);
    EXPECT_EQ(table.header, "x,y,z,nx,ny,nz,area,t" + (end == "\r\n" ? end : "\n"));
    EXPECT_EQ(table.columns.size(), 1u);
  }
}

TEST(TableFile, Refusals)
{
  const auto expect = [](const std::string& text, const std::string& words)
  {
    EXPECT_EQ(refusalOf(text), words) << text;
  };
  const std::string missing = "has no columns x, y and z";
  const std::string none = missing + "; name them in the first line, separated by commas";
  const std::string mark = "a quotation mark is not closed, or not at the end of its field";
  expect("", "is empty");
  expect("\n \n", none);
  expect("\xEF\xBB\xBF", none);
  expect("x y z\n1 2 3\n", missing + ", since blanks separate its fields; give it the suffix .xyz");
  const std::string rows =
    ", but the header names 3; give each row a field for every column, and decimal points to "
    "numbers";
  const std::string words = " is no number; correct it, or leave it empty";
  expect("x,y\n1,2\n", none);
  expect("1,2,3\n4,5,6\n", none);
  expect("x,y,z\n1,2\n", "line 2: has 2 fields" + rows);
  expect("\nx,y,z\n1,2,3\n\n1,2,3,4\n", "line 5: has 4 fields" + rows);
  expect("x,y,z\n1\n", "line 2: has 1 field" + rows);
  expect("x,y,z\n1,5,2,5,3,5\n", "line 2: has 6 fields" + rows);
  expect("x,y,z\n1,two,3\n", "line 2: \"two\" in column y" + words);
  expect("x,y,z\n1,1e400,3\n", "line 2: \"1e400\" in column y" + words);
  expect("X,y,z\n0x10,2,3\n", "line 2: \"0x10\" in column X" + words);
  expect("x,y,z,Area\n1,2,3,4 m\n", "line 2: \"4 m\" in column Area" + words);
  expect("x,y,z\n1,\"a\nb\",3\n", "line 2: \"a?b\" in column y" + words);
  expect("x,y,z\n1,\"2,5\",3\n", "line 2: \"2,5\" in column y is no number; write a decimal point");
  expect("x,y,z\n1,-,3,4\n", "line 2: has 4 fields" + rows);
  expect("x,y,z\n1,a,\"b\n", "line 2: " + mark);
  expect("x,y,\"z\n1,2,3\n", "line 1: " + mark);
  expect("x,y,z,t\n1,2,3,\"a\nb\n5,6,7,8\n", "line 2: " + mark);
  expect("x,y,z,t\n1,2,3,4\n1,2,3,\"a\"b\n", "line 3: " + mark);
  expect("x,y,z,t\n1,2,3,\"a\nb\"c\n", "line 2: " + mark);
  expect("x,y,z,t\n\"1\" 2,2,3,4\n", "line 2: " + mark);
  expect(std::string("x,y,z\n1,\0,3\n", 12), "line 2: \"?\" in column y" + words);
}

/// The first fault is told, though a quotation mark further on is found before.
TEST(TableFile, TheFirstFaultIsToldBeforeQuotationMarks)
{
  const std::string broken = "1,2,3,\"c\"d\n1,2\n", open = "1,2,3,\"c\n1,2\n";
  for (const std::string& late : {broken, open})
  {
    EXPECT_EQ(refusalOf("x,y,z,t\n1,2,3,a\n1,2\n" + late).substr(0, 20), "line 3: has 2 fields");
    EXPECT_EQ(
      refusalOf("x,y,z,t\n1,2,3,a\n1,two,3,\"4\"\n" + late).substr(0, 13), "line 3: \"two\"");
    EXPECT_EQ(refusalOf("x,y,z,t\n1,2,3,a\n" + late).substr(0, 24), "line 3: a quotation mark");
  }
}

/// An executor that notes whether work ever has an earlier share than the work before, and the most
/// blocks that were run at once.
class Watched final : public Executor
{
public:
  void run(std::size_t count, const std::function<void(std::size_t)>& work) override
  {
    most = std::max(most, count);
    isForward = isForward && share_.first >= last_;
    last_ = share_.first;
    SerialExecutor serial;
    serial.run(count, work);
  }

  void setShare(double first, double last) override { share_ = {first, last}; }

  std::pair<double, double> share() const override { return share_; }

  bool isForward = true;
  std::size_t most = 0;

private:
  std::pair<double, double> share_ = {0, 1};
  double last_ = 0; ///< the beginning of the share of the last work
};

TEST(TableFile, ProgressNeverGoesBack)
{
  std::string contents = "x,y,z,t\n";
  for (int row = 0; row < 100; ++row)
  {
    contents += "1,2,3,a\n";
  }
  Way way = withOthers;
  way.bytesPerBlock = 32;
  for (const std::string last : {"1,2,3,a\n", "1,2,3,\"a\"\n"})
  {
    Watched watched;
    read(contents + last, way, watched);
    EXPECT_TRUE(watched.isForward) << last;
  }
}

/// Blocks stay as small as they are meant to be, so that all threads have some.
TEST(TableFile, BlocksStaySmall)
{
  std::string backslashes = "x,y,z,t\n",
              blanks = "x,y,z,t\n1,2,3,\"a\"\n" + std::string(9000, '\n');
  for (int row = 0; row < 1000; ++row)
  {
    backslashes += "1,2,3,a\\\n";
  }
  Way way = withOthers;
  way.bytesPerBlock = 100;
  for (const std::string& contents : {backslashes, blanks + "4,5,6,b\n"})
  {
    Watched watched;
    read(contents, way, watched);
    EXPECT_GE(watched.most, 80u); // 91 and 84
  }
}

/// Tables of random rows, with quotation marks in some or none.
std::string randomTable(std::mt19937& random)
{
  const bool mayBeQuoted = random() % 2 == 0;
  const std::string end = random() % 2 == 0 ? "\n" : "\r\n";
  const auto field = [&]
  {
    const std::string number = std::to_string(static_cast<int>(random() % 2000) - 1000) + ".25";
    const std::string spaces(random() % 8 == 0 ? 1 : 0, ' ');
    return spaces + (mayBeQuoted && random() % 9 == 0 ? '"' + number + '"' : number) + spaces;
  };
  const auto text = [&]
  {
    std::string inner = std::string(random() % 7, 'a') + (random() % 5 == 0 ? "7" : "");
    if (mayBeQuoted && random() % 3 == 0)
    {
      const char* const middles[] = {"\"\"", "\n", "\r\n", ",", "\\\n", "\"\"\n\"\""};
      return '"' + inner + middles[random() % 6] + inner + '"';
    }
    return inner;
  };
  std::string table = "t,x,y,z,n" + end;
  for (auto rows = random() % 40; rows > 0; --rows)
  {
    table += text() + ',' + field() + ',' + field() + ',' + field() + ',' + field() +
             (rows == 1 && random() % 2 == 0 ? "" : end);
    table += random() % 7 == 0 ? " " + end : "";
  }
  return table;
}

TEST(TableFile, ThreadsAndBlocksChangeNothing)
{
  std::mt19937 random(17);
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    const std::string contents = randomTable(random);
    SCOPED_TRACE("table " + std::to_string(seed) + ":\n" + contents);
    Way way = withOthers;
    const Table whole = read(contents, way);
    shapes::ShuffledThreads threads(seed);
    way.bytesPerBlock = 64;
    expectSameTable(read(contents, way, threads), whole);
    way.bytesPerBlock = 3; // starting threads for all of them takes long
    SerialExecutor serial;
    Executor& executor = seed % 6 == 0 ? static_cast<Executor&>(threads) : serial;
    expectSameTable(read(contents, way, executor), whole);
    if (testing::Test::HasFailure())
    {
      return;
    }
  }
}

TEST(TableFile, TheFirstFaultIsToldForAnyThreadsAndBlocks)
{
  std::string contents = "x,y,z\n";
  for (int row = 0; row < 100; ++row)
  {
    contents += row == 40 ? "1,2\n" : row == 70 ? "1,two,3\n" : "1,2,3\n";
  }
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    Way way;
    way.bytesPerBlock = 10;
    shapes::ShuffledThreads threads(seed);
    try
    {
      read(contents, way, threads);
      FAIL() << "nothing was refused";
    }
    catch (const FileRefusal& refusal)
    {
      EXPECT_NE(std::string(refusal.what()).find("line 42: has 2 fields"), std::string::npos)
        << refusal.what();
    }
  }
}

TEST(TableFile, EndsWhenInterrupted)
{
  for (const std::string mark : {"", "\""})
  {
    std::string contents = "x,y,z,t\n";
    for (int row = 0; row < 20; ++row)
    {
      contents += "1,2,3," + mark + "a" + mark + "\n";
    }
    Way way = withOthers;
    way.bytesPerBlock = 32;
    int runs = 0;
    for (bool cameToPass = true; cameToPass; ++runs)
    {
      shapes::Interruption interruption(runs, 1);
      bool isThrown = false;
      try
      {
        read(contents, way, interruption);
      }
      catch (const Interrupted&)
      {
        isThrown = true;
      }
      cameToPass = interruption.cameToPass();
      EXPECT_EQ(isThrown, cameToPass);
    }
    EXPECT_GE(runs, 3) << "rows, numbers and texts";
  }
}

/// Writes other contents into a file after `runs` runs.
class ChangingFile final : public Executor
{
public:
  ChangingFile(const TemporaryFile& file, int runs, std::string contents)
    : file_(file)
    , runs_(runs)
    , contents_(std::move(contents))
  {
  }

  void run(std::size_t count, const std::function<void(std::size_t)>& work) override
  {
    if (runs_-- == 0)
    {
      file_.write(contents_);
    }
    SerialExecutor serial;
    serial.run(count, work);
  }

private:
  const TemporaryFile& file_;
  int runs_;
  std::string contents_;
};

TEST(TableFile, ChangesMeanwhileAreRefused)
{
  const std::string contents = "x,y,z,t\n1,2,3,a\n4,5,6,b\n";
  const std::string one = "x,y,z,t\n1,2,3,a4,5,6,bb\n", open = "x,y,z,t\n1,2,3,\"a\n4,5,6b\n";
  const std::string three = "x,y,z,t\n1,2,3,a\n4,5,6\n,\n", brief = "x,y\n";
  // The first run finds the rows, the second reads numbers, the third texts.
  const auto wordsFor = [&](const std::string& other, int run)
  {
    const TemporaryFile file(contents);
    ChangingFile changing(file, run, other);
    try
    {
      read(InputFile(file.name()), withOthers, changing);
    }
    catch (const FileRefusal& refusal)
    {
      return std::string(refusal.what()).substr(std::string(file.name()).size() + 2);
    }
    return std::string("nothing");
  };
  const std::string changed = "has changed while it was read; read it again";
  for (const std::string& other : {one, open, three})
  {
    EXPECT_EQ(wordsFor(other, 2), changed) << other;
  }
  EXPECT_EQ(wordsFor(one, 1).substr(0, 20), "line 2: has 7 fields");
  EXPECT_EQ(wordsFor(open, 1).substr(0, 24), "line 2: a quotation mark");
  EXPECT_EQ(wordsFor(three, 1).substr(0, 20), "line 3: has 3 fields");
  EXPECT_EQ(wordsFor(brief, 1), "cannot be read to its end");
  EXPECT_EQ(wordsFor(brief, 2), "cannot be read to its end");
}

Table readChosen(const std::string& contents, const std::string& columns)
{
  SerialExecutor serial;
  TableOptions options;
  KeptTexts texts;
  options.columns = ColumnChoice(columns);
  options.texts = &texts;
  const TemporaryFile file(contents);
  return {readPointTable(InputFile(file.name()), options, serial), texts.all()};
}

TEST(ChosenColumns, AreTakenByNamesAndNumbers)
{
  const Numbers expected = {1, 2, 3};
  for (const auto& [contents, columns] : std::vector<std::pair<std::string, std::string>>{
         {"East (m),North (m),z\n1,2,3\n", "x=East (m) y=North (m)"},
         {"E,N,H\n1,2,3\n", "x=e y=n, z=h"}, {"id,E,N,H\n9,1,2,3\n", "x=2;y=3;z=4"},
         {"9,1,2,3\n", "x=2 y=3 z=4"}, {"9;1,0;2,0;3,0\n", "x=2 y=3 z=4"},
         {"\n3\t2\t1\n", "x=3 y=2 z=1"}, {"sep=;\n1;2;3\n", "x=1 y=2 z=3"},
         {"\"x\",2,3,1\n1,2,3,7\n", "x=x y=2 z=3"}})
  {
    const Table table = readChosen(contents, columns);
    EXPECT_EQ(vectorOf(table.points.points.doubles), expected) << contents << columns;
  }
  const Table table = readChosen("1;2;3;0;0;1;8;text\n", "x=1 y=2 z=3 nx=4 ny=5 nz=6 area=7");
  EXPECT_EQ(vectorOf(table.points.normals.doubles), (Numbers{0, 0, 1}));
  EXPECT_EQ(vectorOf(table.points.areas), (Numbers{8}));
  EXPECT_TRUE(table.points.viewpoints.empty());
  const Table seen = readChosen("x,y,z,VP_x,VP_y,VP_z,vx,vy,vz\n1,2,3,4,5,6,7,8,9\n", "");
  EXPECT_EQ(vectorOf(seen.points.viewpoints), (Numbers{4, 5, 6}));
  EXPECT_EQ(seen.columns.size(), 3U) << "velocities";
  const Table chosen = readChosen("1,2,3,4,5,6\n", "x=1 y=2 z=3 vx=4 vy=5 vz=6");
  EXPECT_EQ(vectorOf(chosen.points.viewpoints), (Numbers{4, 5, 6}));
  ASSERT_EQ(table.columns.size(), 1U);
  EXPECT_EQ(table.columns[0].name, "Column 8");
  EXPECT_EQ(
    table.header, "Column 1;Column 2;Column 3;Column 4;Column 5;Column 6;Column 7;Column 8\n");
}

TEST(ChosenColumns, ThatMakeNoSenseAreRefused)
{
  const auto refusal = [](const std::string& columns)
  {
    try
    {
      readChosen("x,y,z,nx,a b\n1,2,3,4,5\n", columns);
    }
    catch (const Refusal& refused)
    {
      return std::string(refused.what());
    }
    return std::string("nothing");
  };
  EXPECT_EQ(refusal("x=a b"), "nothing");
  for (const char* const text : {"x", "=a", "x=", "w=1", "a x=1", "x=1 x=2"})
  {
    EXPECT_NE(refusal(text).find("x=Easting"), std::string::npos) << text << refusal(text);
  }
  EXPECT_NE(
    refusal("x=c").find("no column c for x; its columns are x, y, z, nx, a b"), std::string::npos);
  EXPECT_NE(refusal("x=0").find("no column 0"), std::string::npos);
  EXPECT_NE(refusal("x=6").find("no column 6"), std::string::npos);
  EXPECT_NE(refusal("x=y").find("column y is taken twice"), std::string::npos);
  EXPECT_NE(refusal("nx=nx").find("no columns for all of nx, ny and nz"), std::string::npos);
  EXPECT_NE(refusal("vx=nx").find("no columns for all of vx, vy and vz"), std::string::npos);
}

} // namespace
