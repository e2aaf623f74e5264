// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/DisjointSets.h"

#include "support/Samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace
{

using shapes::Random;
using winding::DisjointSets;
using winding::SensedSets;

/// Sets that are united by relabelling, the slow way.
struct NaiveSets
{
  std::vector<int> labels;
  std::vector<bool> senses; ///< comparable among items with the same label

  explicit NaiveSets(int count)
    : senses(static_cast<std::size_t>(count), false)
  {
    for (int i = 0; i < count; ++i)
    {
      labels.push_back(i);
    }
  }

  bool unite(std::size_t a, std::size_t b, bool areOpposite)
  {
    if (labels[a] == labels[b])
    {
      return (senses[a] != senses[b]) == areOpposite;
    }
    const int from = labels[b], to = labels[a];
    const bool turn = (senses[a] != senses[b]) != areOpposite;
    for (std::size_t i = 0; i < labels.size(); ++i)
    {
      if (labels[i] == from)
      {
        labels[i] = to;
        senses[i] = senses[i] != turn;
      }
    }
    return true;
  }
};

} // namespace

TEST(DisjointSets, AreThoseOfRelabelling)
{
  SCOPED_TRACE("seed 501");
  Random random(501);
  for (int run = 0; run < 50; ++run)
  {
    constexpr int count = 60;
    DisjointSets sets(count);
    SensedSets sensed(count);
    NaiveSets naive(count);
    for (int step = 0; step < 80; ++step)
    {
      const auto a = static_cast<std::int32_t>(random.bits() % count);
      const auto b = static_cast<std::int32_t>(random.bits() % count);
      const bool areOpposite = random.bits() % 2 == 1;
      const bool wereApart = naive.labels[a] != naive.labels[b];
      EXPECT_EQ(sets.unite(a, b), wereApart);
      EXPECT_EQ(sensed.unite(a, b, areOpposite),
        naive.unite(static_cast<std::size_t>(a), static_cast<std::size_t>(b), areOpposite));
    }
    for (std::int32_t a = 0; a < count; ++a)
    {
      const auto lowest = static_cast<std::int32_t>(
        std::find(naive.labels.begin(), naive.labels.end(), naive.labels[a]) -
        naive.labels.begin());
      EXPECT_EQ(sets.find(a), lowest);
      EXPECT_EQ(sensed.find(a).representative, lowest);
      EXPECT_EQ(sensed.find(a).isOpposite, naive.senses[a] != naive.senses[lowest]);
    }
  }
}
