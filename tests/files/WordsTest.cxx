// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/Words.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <random>

using namespace winding;

namespace
{

using Double = std::numeric_limits<double>;

bool isSame(double a, double b)
{
  return a == b && std::signbit(a) == std::signbit(b);
}

TEST(Words, NumbersAreThoseThatWerePrinted)
{
  std::mt19937_64 random(3);
  for (int i = 0; i < 20000; ++i)
  {
    const std::uint64_t bits = random();
    double number;
    std::memcpy(&number, &bits, sizeof number);
    if (!std::isfinite(number))
    {
      continue;
    }
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", number);
    double found = 0;
    ASSERT_TRUE(parseNumber(text, found)) << text;
    ASSERT_TRUE(isSame(found, number)) << text;
    const std::string line = "  " + std::string(text) + "\tx";
    const char* at = line.data();
    ASSERT_TRUE(takeNumber(at, line.data() + line.size(), found)) << text;
    ASSERT_TRUE(isSame(found, number)) << text;
    ASSERT_EQ(*at, '\t');
  }
}

TEST(Words, NumbersAtTheEndsOfTheRange)
{
  const std::pair<const char*, double> words[] = {{"+1.5", 1.5}, {"-.5", -0.5}, {"2.", 2},
    {"1E3", 1000}, {"0e-99999", 0}, {"4.9406564584124654e-324", Double::denorm_min()},
    {"1.7976931348623157e308", Double::max()}, {"1e-400", 0}, {"-1e-400", -0.0},
    {"0.5e-99999999999999999999", 0}, {"inf", Double::infinity()}, {"-INF", -Double::infinity()},
    {"infinity", Double::infinity()}};
  for (const auto& [word, number] : words)
  {
    double found = 7;
    EXPECT_TRUE(parseNumber(word, found)) << word;
    EXPECT_EQ(found, number) << word;
    EXPECT_EQ(std::signbit(found), std::signbit(number)) << word;
  }
  double found = 7;
  EXPECT_TRUE(parseNumber("0." + std::string(400, '0') + "1", found));
  EXPECT_EQ(found, 0);
  EXPECT_TRUE(parseNumber("nan", found) && std::isnan(found));
}

TEST(Words, AllElseIsNoNumber)
{
  for (const std::string word : {"", "+", "-", "++1", "+-1", "-+1", ".", "e5", "1e", "1,5", "0x10",
         "1e400", "-1e400", "1e99999999999999999999", "1.5m", "infe-5", "nane-5", "one"})
  {
    double found = 0;
    EXPECT_FALSE(parseNumber(word, found)) << word;
    const char* at = word.data();
    EXPECT_FALSE(takeNumber(at, at + word.size(), found)) << word;
    EXPECT_EQ(at, word.data());
  }
  double found = 0;
  EXPECT_FALSE(parseNumber(std::string(400, '1'), found));
}

TEST(Words, Integers)
{
  std::int64_t found = 0;
  EXPECT_TRUE(parseInteger("-9223372036854775808", found));
  EXPECT_EQ(found, std::numeric_limits<std::int64_t>::min());
  EXPECT_TRUE(parseInteger("+7", found));
  EXPECT_EQ(found, 7);
  for (const char* word : {"", "+", "+-7", "9223372036854775808", "1.0", "1e3", "7x"})
  {
    EXPECT_FALSE(parseInteger(word, found)) << word;
  }
}

TEST(Words, OfALine)
{
  const std::string line = "\t one  two\v3 ";
  const char* at = line.data();
  const char* end = at + line.size();
  EXPECT_EQ(countWords(at, end), 3u);
  EXPECT_EQ(takeWord(at, end), "one");
  EXPECT_EQ(takeWord(at, end), "two");
  EXPECT_EQ(takeWord(at, end), "3");
  EXPECT_EQ(takeWord(at, end), "");
  EXPECT_EQ(at, end);
}

TEST(Words, AreShownShortAndPrintable)
{
  EXPECT_EQ(shown("abc"), "\"abc\"");
  EXPECT_EQ(shown("a\x01\xff"), "\"a??\"");
  EXPECT_EQ(shown(std::string(30, 'x')), "\"" + std::string(20, 'x') + "...\"");
}

} // namespace
