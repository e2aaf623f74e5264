#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include <sys/wait.h>

namespace
{

using namespace std::chrono_literals;

/// Starts a run that would take minutes, waits until it has begun to write, and stops it.
void interruptRun(int signal, const std::vector<std::string>& more)
{
  const TemporaryFolder folder;
  const std::string in = folder.write("in.off", asOff(sphere(5)));
  std::vector<std::string> arguments = {"field", in, "-o", folder.path("out.vti"), "--threads", "1",
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

TEST(Interrupt, FieldInMemory)
{
  interruptRun(SIGINT, {});
}

TEST(Interrupt, FieldInPieces)
{
  interruptRun(SIGTERM, {"--pieces", "40"});
}

} // namespace
