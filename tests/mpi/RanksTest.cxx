// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/Ranks.h"

#include "base/Executor.h"
#include "base/Refusal.h"
#include "pipeline/FreeMemory.h"
#include "pipeline/HostShare.h"

#include "vtkMultiProcessController.h"

#include <gtest/gtest.h>

#include <new>
#include <numeric>
#include <string>

namespace
{

using winding::Ranks;

vtkMultiProcessController* world()
{
  return vtkMultiProcessController::GetGlobalController();
}

/// The line that agreeing on work fails with; empty if it does not.
template <class Work> std::string refusalOf(const Work& work)
{
  Ranks ranks(world());
  try
  {
    ranks.agree([&] { work(ranks); });
    return {};
  }
  catch (const winding::Refusal& refusal)
  {
    return refusal.what();
  }
}

} // namespace

TEST(Ranks, HearWhatTheOthersAnswer)
{
  Ranks ranks(world());
  const int own = ranks.rank();
  const std::vector<Ranks::Number> all =
    ranks.allGather([own] { return static_cast<Ranks::Number>(own * own); });
  ASSERT_EQ(all.size(), static_cast<std::size_t>(ranks.count()));
  for (std::size_t rank = 0; rank < all.size(); ++rank)
  {
    EXPECT_EQ(all[rank], rank * rank);
  }
  EXPECT_TRUE(ranks.allOf([] { return true; }));
  EXPECT_FALSE(ranks.allOf([&] { return ranks.rank() > 0; }));
}

TEST(Ranks, OfAMachineShareIt)
{
  Ranks ranks(world());
  ranks.barrier();
  EXPECT_EQ(winding::ranksOnHost(), ranks.count());
  const auto memory = []
  {
    return winding::HostMemory{16e9, 8e9};
  };
  EXPECT_DOUBLE_EQ(winding::freeBytes(memory), 8e9 / ranks.count());
}

TEST(Ranks, GatherNumbersInRounds)
{
  for (const std::size_t mostNumbers : {1, 5, 8, 1000})
  {
    SCOPED_TRACE(mostNumbers);
    Ranks ranks(world(), mostNumbers);
    // Rank r has 7 r numbers, so that the first has none.
    std::vector<double> own(static_cast<std::size_t>(7 * ranks.rank()));
    std::iota(own.begin(), own.end(), 1000.0 * ranks.rank());
    for (const bool onlyOnFirst : {false, true})
    {
      const winding::OfRanks<double> all = ranks.gather(own, onlyOnFirst);
      for (int rank = 0; rank < ranks.count(); ++rank)
      {
        ASSERT_EQ(all.count(rank), static_cast<std::size_t>(7 * rank));
        for (std::size_t i = 0; (!onlyOnFirst || ranks.rank() == 0) && i < all.count(rank); ++i)
        {
          ASSERT_EQ(all.begin(rank)[i], 1000.0 * rank + static_cast<double>(i));
        }
      }
    }
  }
}

TEST(Ranks, AllRefuseWithTheLineOfTheFirstThatDoes)
{
  const int last = Ranks(world()).count() - 1;
  const std::string of = " (rank " + std::to_string(last) + " of " + std::to_string(last + 1) + ")";
  const std::string expected = "no" + (last > 0 ? of : "");
  EXPECT_EQ(refusalOf(
              [last](Ranks& ranks)
              {
                if (ranks.rank() == last)
                {
                  throw winding::Refusal("no");
                }
              }),
    expected);
  // The others are inside when the last one fails outside, or the other way round.
  for (const bool isInside : {false, true})
  {
    EXPECT_EQ(refusalOf(
                [=](Ranks& ranks)
                {
                  const auto refuse = [&]
                  {
                    if (ranks.rank() == last)
                    {
                      throw winding::Refusal("no");
                    }
                  };
                  if (!isInside)
                  {
                    refuse();
                  }
                  ranks.agree(refuse);
                }),
      expected);
  }
}

TEST(Ranks, TellKindsOfFailuresApart)
{
  Ranks ranks(world());
  const bool isLast = ranks.rank() == ranks.count() - 1;
  EXPECT_THROW(ranks.allOf([=] { return isLast ? throw winding::Interrupted() : true; }),
    winding::Interrupted);
  Ranks others(world());
  EXPECT_THROW(others.allOf([=] { return isLast ? throw winding::OutOfMemory("much") : true; }),
    winding::OutOfMemory);
  Ranks third(world());
  if (third.isAlone())
  {
    EXPECT_THROW(third.agree([] { throw std::bad_alloc(); }), std::bad_alloc);
    return;
  }
  EXPECT_THROW(
    third.allOf([=] { return isLast ? throw std::bad_alloc() : true; }), winding::OutOfMemory);
}

TEST(Ranks, WithOtherPropertiesAreRefused)
{
  const std::string refusal = refusalOf(
    [](Ranks& ranks)
    {
      ranks.requireSame([] { return 7; });
      ranks.requireSame([&ranks] { return ranks.rank() == 0 ? 7 : 8; });
    });
  EXPECT_EQ(refusal.empty(), Ranks(world()).isAlone());
  EXPECT_EQ(
    refusal.find("set the same properties on all ranks"), refusal.empty() ? refusal.npos : 0);
}
