// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/FieldOutput.h"

#include "support/Samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace
{

using winding::FieldOutput;
using winding::InsideRule;

/// All three arrays, with something in them that no output writes.
struct Arrays
{
  explicit Arrays(std::size_t count)
    : values(count, -99)
    , doubleValues(count, -99)
    , inside(count, 99)
  {
  }
  bool operator==(const Arrays& other) const
  {
    return values == other.values && doubleValues == other.doubleValues && inside == other.inside;
  }
  /// An output to the arrays whose bits are set in mask.
  FieldOutput output(int mask)
  {
    FieldOutput output;
    output.values = mask & 1 ? values.data() : nullptr;
    output.doubleValues = mask & 2 ? doubleValues.data() : nullptr;
    output.inside = mask & 4 ? inside.data() : nullptr;
    return output;
  }

  std::vector<float> values;
  std::vector<double> doubleValues;
  std::vector<unsigned char> inside;
};

constexpr InsideRule rules[] = {
  InsideRule::signedThreshold, InsideRule::absoluteThreshold, InsideRule::odd};

// The values are at and around thresholds, and some reach them only when rounded to float.
const std::vector<double> someValues = {
  0, 1, -1, 2, -3, 0.5, 0.5 - 1e-10, -0.5 + 1e-10, 0.5 + 1e-10, 0.1, 1e-300, 1.5, -1.5, 2.5};

} // namespace

TEST(FieldOutput, WritesTheArraysThatAreThereAndOnlyTheRange)
{
  for (int mask = 0; mask < 8; ++mask)
  {
    Arrays arrays(someValues.size() + 5);
    Arrays expected = arrays;
    arrays.output(mask).write(someValues.data(), 3, someValues.size());
    for (std::size_t i = 0; i < someValues.size(); ++i)
    {
      const double v = someValues[i];
      const double stored = mask & 2 ? v : static_cast<float>(v);
      expected.values[i + 3] = mask & 1 ? static_cast<float>(v) : -99.0f;
      expected.doubleValues[i + 3] = mask & 2 ? v : -99;
      expected.inside[i + 3] = static_cast<unsigned char>(mask & 4 ? stored >= 0.5 : 99);
    }
    EXPECT_TRUE(arrays == expected) << mask;
  }
}

TEST(FieldOutput, FillsAsItWrites)
{
  for (const InsideRule rule : rules)
  {
    for (const double threshold : {0.5, -0.25, 1.0})
    {
      for (const double value : someValues)
      {
        for (int mask = 0; mask < 8; ++mask)
        {
          Arrays filled(9), written(9);
          FieldOutput output = filled.output(mask);
          output.isInside = {rule, threshold};
          output.fill(value, 2, 5);
          output = written.output(mask);
          output.isInside = {rule, threshold};
          output.write(std::vector<double>(5, value).data(), 2, 5);
          ASSERT_TRUE(filled == written) << value << ' ' << mask;
        }
      }
    }
  }
}

TEST(FieldOutput, DecidesInsideOnTheValueAsTheArrayStoresIt)
{
  // The value is the threshold when it is rounded to float.
  const double justBelow = 0.5 - 1e-10;
  unsigned char inside = 99;
  float value;
  double doubleValue;
  FieldOutput output;
  output.inside = &inside;
  output.write(&justBelow, 0, 1);
  EXPECT_EQ(inside, 1);
  output.values = &value;
  output.fill(justBelow, 0, 1);
  EXPECT_EQ(inside, 1);
  output.doubleValues = &doubleValue;
  output.write(&justBelow, 0, 1);
  EXPECT_EQ(inside, 0);
  output.fill(justBelow, 0, 1);
  EXPECT_EQ(inside, 0);
}

TEST(FieldOutput, WritesNothingForNoSamples)
{
  Arrays arrays(3);
  const Arrays before = arrays;
  arrays.output(7).fill(1, 1, 0);
  arrays.output(7).write(static_cast<const double*>(nullptr), 1, 0);
  EXPECT_TRUE(arrays == before);
}

TEST(FieldOutput, WritesTheLargestFloatForWhatFloatCannotHold)
{
  const std::vector<double> large = {1e39, -1e39, 1.7e308, 3.5e38, 1e38};
  constexpr float most = std::numeric_limits<float>::max();
  Arrays arrays(large.size());
  arrays.output(7).write(large.data(), 0, large.size());
  EXPECT_EQ(arrays.values, (std::vector<float>{most, -most, most, most, 1e38f}));
  EXPECT_EQ(arrays.doubleValues, large);
  arrays.output(1).fill(-1e300, 0, 1);
  EXPECT_EQ(arrays.values[0], -most);
  const double nowhere = std::numeric_limits<double>::quiet_NaN();
  arrays.output(1).write(&nowhere, 0, 1);
  EXPECT_TRUE(std::isnan(arrays.values[0]));
}
