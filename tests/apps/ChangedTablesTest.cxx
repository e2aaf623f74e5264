/// Tables of queries that something happens to. Their rows are handed on from the file, which stays
/// open.

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

  /// Runs a probe, and does this to the queries when the source is opened: they have been read.
  Outcome probe(const char* action, const std::string& out) const
  {
    return this->probe(action, out, "source.off", 1);
  }

  /// Runs a probe, and does this to the queries when the reader opens them: their first bytes have
  /// been looked at, and the checksums taken.
  Outcome probeDisturbed(const char* action) const
  {
    return this->probe(action, "out.csv", "q.csv", 3);
  }

  const TemporaryFolder folder;

private:
  Outcome probe(const char* action, const std::string& out, const char* opened, int opening) const
  {
    const std::string source = folder.write("source.off", asOff(sphere(1)));
    const std::string queries = folder.write("q.csv", "x,y,z,name\n0,0,0,a\n0,0,9,\"b\"");
    const std::string other = folder.write("other", "x,y,z,name\n0,0,9,c\n0,0,0,\"d\"");
    setenv("LD_PRELOAD", WINDING_FILE_FAULTS, 1);
    setenv("FAULT_FILE", opened, 1);
    setenv("FAULT_OPENING", std::to_string(opening).c_str(), 1);
    setenv("FAULT_ACTION", action, 1);
    setenv("FAULT_VICTIM", queries.c_str(), 1);
    setenv("FAULT_OTHER", other.c_str(), 1);
    Outcome run = runProgram({"probe", source, queries, "-o", folder.path(out)});
    unsetenv("FAULT_VICTIM");
    unsetenv("LD_PRELOAD");
    return run;
  }
};

const std::string whole = "x,y,z,name,WindingNumber,Inside\n0,0,0,a,1,1\n0,0,9,\"b\",0,0\n";

TEST_F(ChangedTables, AreRefused)
{
  const Outcome run = this->probe("truncate", "out.csv");
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(run.saysInOneLine({"q.csv: has changed since it was read"})) << run;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"other", "q.csv", "source.off"}));
}

/// The rows that were read are still there.
TEST_F(ChangedTables, MayBeRemovedReplacedTouchedOrGrow)
{
  for (const char* action : {"unlink", "replace", "touch", "append"})
  {
    const Outcome run = this->probe(action, "out.csv");
    ASSERT_EQ(run.status, 0) << action << run;
    EXPECT_EQ(contentsOf(folder.path("out.csv")), whole) << action;
  }
}

TEST_F(ChangedTables, AreRefusedWhereTheReaderFindsAnother)
{
  for (const char* action : {"replace", "alter"})
  {
    const Outcome run = this->probeDisturbed(action);
    EXPECT_EQ(run.status, 2) << action;
    EXPECT_TRUE(run.saysInOneLine({"q.csv: has changed since it was read"})) << action << run;
  }
  const Outcome touched = this->probeDisturbed("touch");
  ASSERT_EQ(touched.status, 0) << touched;
  EXPECT_EQ(contentsOf(folder.path("out.csv")), whole);
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
