/// Tables of queries that something happens to between the reading of them and that of the source.
/// Their rows are handed on from the file, which stays open.

#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include <gtest/gtest.h>

#include <algorithm>
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

  /// Runs a probe, and does this to the queries when the source is opened.
  Outcome probe(const char* action, const std::string& out) const
  {
    const std::string source = folder.write("source.off", asOff(sphere(1)));
    const std::string queries = folder.write("q.csv", "x,y,z,name\n0,0,0,a\n0,0,9,\"b\"\n");
    setenv("LD_PRELOAD", WINDING_FILE_FAULTS, 1);
    setenv("FAULT_FILE", "source.off", 1);
    setenv("FAULT_OPENING", "1", 1);
    setenv("FAULT_ACTION", action, 1);
    setenv("FAULT_VICTIM", queries.c_str(), 1);
    Outcome run = runProgram({"probe", source, queries, "-o", folder.path(out)});
    unsetenv("FAULT_VICTIM");
    unsetenv("LD_PRELOAD");
    return run;
  }

  const TemporaryFolder folder;
};

TEST_F(ChangedTables, AreRefused)
{
  const Outcome run = this->probe("truncate", "out.csv");
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(run.saysInOneLine({"q.csv: has changed since it was read"})) << run;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"q.csv", "source.off"}));
}

TEST_F(ChangedTables, MayBeRemoved)
{
  const Outcome run = this->probe("unlink", "out.csv");
  ASSERT_EQ(run.status, 0) << run;
  const std::string text = contentsOf(folder.path("out.csv"));
  EXPECT_EQ(text.rfind("x,y,z,name,WindingNumber,Inside\n0,0,0,a,1,1\n0,0,9,\"b\",", 0), 0u)
    << text;
}

/// The rows that were read are still there.
TEST_F(ChangedTables, MayGrow)
{
  const Outcome run = this->probe("append", "out.csv");
  ASSERT_EQ(run.status, 0) << run;
  const std::string text = contentsOf(folder.path("out.csv"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3) << text;
}

/// Neither the size nor the time of the file tells.
TEST_F(ChangedTables, OfTheSameSizeAndTimeAreRefused)
{
  const Outcome run = this->probe("alter", "out.csv");
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(run.saysInOneLine({"q.csv: has changed since it was read"})) << run;
}

/// Rows are not needed any more where the answer is no table.
TEST_F(ChangedTables, MayChangeWhereTheAnswerIsNone)
{
  EXPECT_EQ(this->probe("truncate", "out.vtp").status, 0);
}

} // namespace
