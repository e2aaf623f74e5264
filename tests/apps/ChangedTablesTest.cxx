// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// Tables of queries that something happens to, whose rows are handed on.

#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace
{

class ChangedTables : public testing::Test
{
protected:
  void SetUp() override
  {
#ifdef WINDING_SANITIZED
    GTEST_SKIP() << "sanitizers want to be loaded before all other libraries";
#endif
  }

  /// Runs a probe, and does this to the queries when the source is opened: they have been read.
  Outcome probe(const char* action) const
  {
    const std::string source = folder.write("source.off", asOff(sphere(1)));
    const std::string queries = folder.write("q.csv", "x,y,z,name\n0,0,0,a\n0,0,9,\"b\"");
    const std::string other = folder.write("other", "x,y,z,name\n0,0,9,c\n0,0,0,\"d\"");
    setenv("LD_PRELOAD", WINDING_FILE_FAULTS, 1);
    setenv("FAULT_FILE", "source.off", 1);
    setenv("FAULT_OPENING", "1", 1);
    setenv("FAULT_ACTION", action, 1);
    setenv("FAULT_VICTIM", queries.c_str(), 1);
    setenv("FAULT_OTHER", other.c_str(), 1);
    Outcome run = runProgram({"probe", source, queries, "-o", folder.path("out.csv")});
    unsetenv("FAULT_VICTIM");
    unsetenv("LD_PRELOAD");
    return run;
  }

  const TemporaryFolder folder;
};

/// The rows that were read are kept.
TEST_F(ChangedTables, MayChangeInAnyWayOnceTheyAreRead)
{
  for (const char* action : {"truncate", "unlink", "replace", "alter", "touch", "append"})
  {
    const Outcome run = this->probe(action);
    ASSERT_EQ(run.status, 0) << action << run;
    EXPECT_EQ(contentsOf(folder.path("out.csv")),
      "x,y,z,name,WindingNumber,Inside\n0,0,0,a,1,1\n0,0,9,\"b\",0,0\n")
      << action;
  }
}

} // namespace
