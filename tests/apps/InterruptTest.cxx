// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <limits>
#include <thread>

#include <sys/wait.h>

namespace
{

using namespace std::chrono_literals;

/// Starts a run that would take minutes, waits until it has begun to write, and stops it.
void interruptRun(
  int signal, const std::vector<std::string>& more, const std::string& output = "out.vti")
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere(5)));
  std::vector<std::string> arguments = {"field", in, "-o", folder.path(output), "--threads", "1",
    "--resolution", "500", "--method", "direct"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const int process = startProgram(arguments);
  for (int i = 0; i < 2000 && folder.names().size() < 2; ++i)
  {
    std::this_thread::sleep_for(10ms);
  }
  EXPECT_EQ(folder.names().size(), 2u) << "the temporary file is there";
  std::this_thread::sleep_for(700ms);
  const auto start = std::chrono::steady_clock::now();
  kill(process, signal);
  int status = 0;
  waitpid(process, &status, 0);
  // An end was measured to take 0.1 s; a loaded machine is slower.
  EXPECT_LT(std::chrono::steady_clock::now() - start, 5s);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"in.off"});
}

/// A run that hangs where it makes its temporary file, and looks for no signal any more.
class Hanging : public testing::Test
{
protected:
  void SetUp() override
  {
#ifdef WINDING_SANITIZED
    GTEST_SKIP() << "sanitizers want to be loaded before all other libraries";
#endif
    start();
  }

  void start()
  {
    setenv("LD_PRELOAD", WINDING_FILE_FAULTS, 1);
    setenv("FAULT_FILE", ".part.vti", 1);
    setenv("FAULT_OPENING", "2", 1); // the file has been made when the writer opens it
    setenv("FAULT_ACTION", "hang", 1);
    process = startProgram({"field", in, "-o", folder.path("out.vti"), "--resolution", "4"});
    unsetenv("LD_PRELOAD");
    for (int i = 0; i < 2000 && folder.names().size() < 2; ++i)
    {
      std::this_thread::sleep_for(10ms);
    }
    EXPECT_EQ(folder.names().size(), 2u) << "the temporary file is there";
    std::this_thread::sleep_for(500ms);
  }

  /// Seconds until the run has ended, with status 130.
  double secondsToEnd() const
  {
    const auto start = std::chrono::steady_clock::now();
    int status = 0;
    for (int i = 0; i < 1000 && waitpid(process, &status, WNOHANG) == 0; ++i)
    {
      std::this_thread::sleep_for(10ms);
    }
    kill(process, SIGKILL); // if it has not ended
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  TemporaryFolder folder;
  std::string in = folder.write("in.off", asOff(sphere(2)));
  int process = 0;
};

TEST_F(Hanging, EndsASecondAfterASignal)
{
  kill(process, SIGTERM);
  const double seconds = secondsToEnd();
  EXPECT_GT(seconds, 0.9);
  EXPECT_LT(seconds, 5);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"in.off"});
}

TEST_F(Hanging, EndsAtTheSecondSignal)
{
  double least = std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < 3 && !(least < 0.9); ++attempt) // the machine may be busy
  {
    if (attempt > 0)
    {
      start();
    }
    kill(process, SIGINT);
    std::this_thread::sleep_for(50ms); // two of a kind that wait become one
    kill(process, SIGINT);
    least = std::min(least, secondsToEnd());
  }
  EXPECT_LT(least, 0.9);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"in.off"});
}

/// The status of a run to which a hangup is sent while it pauses to read its input.
int statusAfterHangup(void (*before)(int))
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere(2)));
  setenv("LD_PRELOAD", WINDING_FILE_FAULTS, 1);
  setenv("FAULT_FILE", "in.off", 1);
  setenv("FAULT_OPENING", "1", 1);
  setenv("FAULT_ACTION", "pause", 1);
  const auto own = std::signal(SIGHUP, before);
  const int process =
    startProgram({"field", in, "-o", folder.path("out.vti"), "--resolution", "4"});
  std::signal(SIGHUP, own);
  unsetenv("LD_PRELOAD");
  for (int i = 0; i < 6000 && folder.names().size() < 2; ++i)
  {
    std::this_thread::sleep_for(10ms);
  }
  kill(process, SIGHUP);
  int status = 0;
  waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST(Interrupt, HangupThatIsIgnoredStaysIgnored)
{
#ifdef WINDING_SANITIZED
  GTEST_SKIP() << "sanitizers want to be loaded before all other libraries";
#endif
  EXPECT_EQ(statusAfterHangup(SIG_DFL), 130);
  EXPECT_EQ(statusAfterHangup(SIG_IGN), 0);
}

TEST(Interrupt, FieldInMemory)
{
  interruptRun(SIGINT, {});
}

TEST(Interrupt, FieldInPieces)
{
  interruptRun(SIGTERM, {"--pieces", "40"});
}

} // namespace
