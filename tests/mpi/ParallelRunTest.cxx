// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/ParallelRun.h"

#include <gtest/gtest.h>

#include <functional>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

/**
 * @file
 * The ranks of the program agree on failures and numbers, and send bytes to each other. The
 * program's own start makes the ranks.
 */

namespace
{

/// The status and the line that agreeing on work fails with; EXIT_DONE if it does not.
struct Failed
{
  ExitStatus status = EXIT_DONE;
  std::string line;
};

Failed failureOf(const std::function<void()>& work)
{
  try
  {
    parallel::agree(work);
    return {};
  }
  catch (const AgreedFailure& failure)
  {
    return {failure.status, failure.what()};
  }
}

bool isLast()
{
  return parallel::rank() == parallel::count() - 1;
}

} // namespace

TEST(ParallelRun, TellsNumbersOfAllRanks)
{
  ASSERT_GT(parallel::count(), 1);
  EXPECT_EQ(parallel::isFirst(), parallel::rank() == 0);
  EXPECT_FALSE(parallel::isAlone());
  EXPECT_EQ(parallel::countOnHost(), parallel::count());
  std::vector<double> expected(static_cast<std::size_t>(parallel::count()));
  std::iota(expected.begin(), expected.end(), 0.5);
  EXPECT_EQ(parallel::allGather(parallel::rank() + 0.5), expected);
  EXPECT_EQ(parallel::maximum(-parallel::rank()), 0);
  EXPECT_EQ(parallel::sum(parallel::rank()), parallel::count() * (parallel::count() - 1) / 2);
}

TEST(ParallelRun, AllFailWithTheStatusAndTheLineOfTheFirstThatDoes)
{
  EXPECT_EQ(failureOf([] {}).status, EXIT_DONE);
  for (const ExitStatus status : {EXIT_USAGE, EXIT_REFUSED, EXIT_NO_MEMORY, EXIT_INTERRUPTED})
  {
    const Failed ofLast = failureOf(
      [status]
      {
        if (isLast())
        {
          throw Failure(status, "the last");
        }
      });
    EXPECT_EQ(ofLast.status, status);
    EXPECT_EQ(ofLast.line, "the last");
    const Failed ofAll =
      failureOf([status] { throw Failure(status, "rank " + std::to_string(parallel::rank())); });
    EXPECT_EQ(ofAll.status, status);
    EXPECT_EQ(ofAll.line, "rank 0");
  }
}

TEST(ParallelRun, TellsMissingMemoryFromOtherFaults)
{
  const Failed noMemory = failureOf(
    []
    {
      if (isLast())
      {
        throw std::bad_alloc();
      }
    });
  EXPECT_EQ(noMemory.status, EXIT_NO_MEMORY);
  EXPECT_NE(noMemory.line.find("memory"), std::string::npos) << noMemory.line;
  const Failed other = failureOf(
    []
    {
      if (isLast())
      {
        throw std::runtime_error("a bug");
      }
    });
  EXPECT_EQ(other.status, EXIT_REFUSED);
  EXPECT_EQ(other.line, "unexpected: a bug");
}

TEST(ParallelRun, WorkMayAgreeOnFailuresOfItsOwn)
{
  const Failed inner =
    failureOf([] { parallel::agreeOnFirst([] { throw Failure(EXIT_USAGE, "the first"); }); });
  EXPECT_EQ(inner.status, EXIT_USAGE);
  EXPECT_EQ(inner.line, "the first");
}

TEST(ParallelRun, BytesGoFromRankToRank)
{
  const std::string text = "what the first rank sends";
  std::string received(text.size(), ' ');
  if (parallel::isFirst())
  {
    for (int rank = 1; rank < parallel::count(); ++rank)
    {
      parallel::send(text.data(), text.size(), rank);
    }
    return;
  }
  parallel::receive(received.data(), received.size(), 0);
  EXPECT_EQ(received, text);
}

int main(int argc, char** argv)
{
  parallel::start(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  const int status = RUN_ALL_TESTS();
  parallel::finish();
  return status;
}
