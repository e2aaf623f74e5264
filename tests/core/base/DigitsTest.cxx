// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/Digits.h"

#include "base/Message.h"
#include "report/Fidelity.h"
#include "source/Grid.h"
#include "support/Refusals.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <limits>
#include <locale>
#include <random>
#include <string>

namespace
{

using winding::inDigits;
using winding::inPlaces;

/// Punctuation as in German, for streams.
struct Commas : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

/// Has commas in streams while it lives.
struct CommaLocale
{
  CommaLocale()
    : before(std::locale::global(std::locale(std::locale::classic(), new Commas)))
  {
  }
  ~CommaLocale() { std::locale::global(before); }

  std::locale before;
};

} // namespace

TEST(Digits, AreThoseOfPrintf)
{
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  std::setlocale(LC_NUMERIC, "C");
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponents(-320, 308), shares(-1, 1);
  const auto check = [](double value)
  {
    for (const int digits : {1, 2, 3, 4, 6, 10, 15, 17})
    {
      char general[64], fixed[400];
      std::snprintf(general, sizeof general, "%.*g", digits, value);
      std::snprintf(fixed, sizeof fixed, "%.*f", digits, value);
      EXPECT_EQ(inDigits(value, digits), general);
      EXPECT_EQ(inPlaces(value, digits), fixed);
    }
  };
  for (int i = 0; i < 2000; ++i)
  {
    check(shares(random) * std::pow(10, exponents(random)));
  }
  for (const double value :
    {0.0, -0.0, 0.5, 9.995, 99999.95, 1e6, 123456789.0, DBL_MAX, -DBL_MAX, DBL_MIN,
      std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::infinity()})
  {
    check(value);
  }
  EXPECT_EQ(inDigits(std::nan("")), "nan");
  std::setlocale(LC_NUMERIC, before.c_str());
}

TEST(Digits, HaveAPointWhereStreamsHaveAComma)
{
  const CommaLocale commas;
  EXPECT_EQ(winding::joined("a ", 1234567, ' ', 0.25, std::string(" b")), "a 1234567 0.25 b");
  EXPECT_EQ(winding::percentOf(0.0123), "1.2 %");
  winding::GridRequest request;
  request.bounds = winding::Bounds(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones());
  request.padding = -1.5;
  shapes::expectRefused([&] { winding::setUpGrid(request); }, "-1.5");
  winding::Fidelity fidelity;
  fidelity.volume = 2.5;
  fidelity.components = 12345;
  const std::string words = inWords(fidelity);
  EXPECT_NE(words.find("volume 2.5"), std::string::npos) << words;
  EXPECT_NE(words.find("of 12345 parts"), std::string::npos) << words;
}
