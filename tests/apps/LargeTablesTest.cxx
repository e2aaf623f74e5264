// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// Tables with enough rows for several threads to read them.

#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>
#include <vector>

namespace
{

class LargeTables : public testing::Test
{
protected:
  static constexpr int count = 40'000; // 2.6 MB: ten parts

  static std::vector<std::string> rows()
  {
    std::vector<std::string> rows = {"x,y,z,row"};
    for (int i = 1; i <= count; ++i)
    {
      const double angle = i;
      std::ostringstream row;
      row.precision(17);
      row << std::cos(angle) << ',' << std::sin(angle) << ',' << i / 1e5 << ',' << i;
      rows.push_back(row.str());
      rows.resize(rows.size() + i % 3); // blank lines, too
    }
    return rows;
  }

  static std::string joined(const std::vector<std::string>& rows)
  {
    std::string text;
    for (const std::string& row : rows)
    {
      text += row + '\n';
    }
    return text;
  }

  Outcome probe(
    const std::string& queries, const std::string& out, const std::string& threads) const
  {
    const std::string source = folder.write("source.off", asOff(sphere(1)));
    return runProgram({"probe", source, folder.write("q.csv", queries), "-o", folder.path(out),
      "--overwrite", "--threads", threads});
  }

  const TemporaryFolder folder;
};

TEST_F(LargeTables, AreTheSameForAnyThreadsAndWithQuotedFields)
{
  std::vector<std::string> plain = this->rows();
  ASSERT_EQ(this->probe(joined(plain), "one.csv", "1").status, 0);
  ASSERT_EQ(this->probe(joined(plain), "two.csv", "2").status, 0);
  const std::string expected = contentsOf(folder.path("one.csv"));
  EXPECT_EQ(std::count(expected.begin(), expected.end(), '\n'), count + 1);
  EXPECT_TRUE(expected == contentsOf(folder.path("two.csv")));
  // One thread reads all rows where there is a quotation mark anywhere.
  plain.front() = "x,y,z,\"row\"";
  plain.back() = "0,0,0,\"\n\"";
  ASSERT_EQ(this->probe(joined(plain), "quoted.csv", "2").status, 0);
  const std::string quoted = contentsOf(folder.path("quoted.csv"));
  const auto body = [](const std::string& text)
  {
    const std::size_t first = text.find('\n');
    return text.substr(first, 1'000'000);
  };
  EXPECT_TRUE(body(expected) == body(quoted));
  EXPECT_NE(quoted.find("\n0,0,0,\"\n\",1,1\n"), std::string::npos);
}

TEST_F(LargeTables, MayHaveOtherEndsOfLinesAndNoLastOne)
{
  const std::string plain = joined(this->rows());
  ASSERT_EQ(this->probe(plain, "plain.csv", "2").status, 0);
  std::string text = std::regex_replace(plain, std::regex("\n"), "\r\n");
  text.resize(text.size() - 2);
  ASSERT_EQ(this->probe(text, "other.csv", "2").status, 0);
  const std::string other = contentsOf(folder.path("other.csv"));
  EXPECT_TRUE(
    std::regex_replace(other, std::regex("\r\n"), "\n") == contentsOf(folder.path("plain.csv")));
}

/// Rows that are handed on lie far from each other in the file, and one is longer than any block.
TEST_F(LargeTables, GiveTheRowsThatAreInside)
{
  const std::string note(700'000, 'n');
  std::string text = "x,y,z,note\n", inside = "x,y,z,note,WindingNumber,Inside\n";
  for (int i = 0; i < 60'000; ++i)
  {
    const bool isInside = i % 20'000 == 7'000;
    const std::string row = std::string(isInside ? "0,0,0,\"" : "9,9,9,\"") +
                            (i == 27'000 ? note : std::to_string(i)) + '"';
    text += row + '\n';
    inside += isInside ? row + ",1,1\n" : "";
  }
  const std::string source = folder.write("source.off", asOff(sphere(1)));
  const std::string queries = folder.write("q.csv", text);
  const Outcome run =
    runProgram({"probe", source, queries, "-o", folder.path("in.csv"), "--extract"});
  ASSERT_EQ(run.status, 0) << run;
  EXPECT_TRUE(contentsOf(folder.path("in.csv")) == inside);
}

TEST_F(LargeTables, OfWrongRowsAloneAreRefusedForTheFirst)
{
  std::string text = "x y z\n";
  while (text.size() < 4'000'000)
  {
    text += "1,5;2,5;3,5\n";
  }
  const Outcome run = this->probe(text, "out.csv", "2");
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(run.saysInOneLine({"has no columns x, y and z", "blanks", "suffix .xyz"})) << run;
  const Outcome fields = this->probe("x,y,z\n" + text.substr(6), "out.csv", "2");
  EXPECT_EQ(fields.status, 2);
  EXPECT_TRUE(fields.saysInOneLine({"line 2: has 4 fields, but the header names 3"})) << fields;
}

TEST_F(LargeTables, AreRefusedForTheFirstFaultInTheFile)
{
  const std::vector<std::string> sound = this->rows();
  const std::size_t early = sound.size() / 3, late = sound.size() - 1;
  for (const std::string threads : {"1", "2"})
  {
    std::vector<std::string> rows = sound;
    rows[early] = "1,2";
    rows[late] = "1";
    Outcome run = this->probe(joined(rows), "out.csv", threads);
    EXPECT_EQ(run.status, 2);
    EXPECT_TRUE(run.saysInOneLine({"line " + std::to_string(early + 1) + ": has 2 fields"})) << run;
    rows[early] = "1,two,3,4";
    rows[late] = "1,2,three,4";
    run = this->probe(joined(rows), "out.csv", threads);
    EXPECT_EQ(run.status, 2);
    EXPECT_TRUE(run.saysInOneLine(
      {"line " + std::to_string(early + 1) + ": \"two\" in column y is no number"}))
      << run;
  }
}

} // namespace
