#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <string>
#include <vector>

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

/// Runs `winding` on a terminal of its own, and returns all that it shows there.
std::string shownBy(std::vector<std::string> words)
{
  words.insert(words.begin(), WINDING_PROGRAM);
  std::vector<char*> arguments;
  for (std::string& word : words)
  {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  int terminal = -1;
  const pid_t program = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (program == 0)
  {
    execv(WINDING_PROGRAM, arguments.data());
    _exit(127);
  }
  std::string shown;
  char text[4096];
  // Reading fails when the other side of the terminal is closed.
  for (ssize_t count = 0; (count = read(terminal, text, sizeof text)) > 0;)
  {
    shown.append(text, static_cast<std::size_t>(count));
  }
  close(terminal);
  int status = -1;
  waitpid(program, &status, 0);
  EXPECT_EQ(status, 0) << shown;
  return shown;
}

} // namespace

TEST(Progress, IsOneBarThatNeverGoesBack)
{
  // The direct sum over 8 192 triangles takes half a second or more, in three pieces.
  const TemporaryFolder folder;
  const std::string mesh = folder.write("sphere.off", asOff(sphere(5)));
  const std::vector<std::string> run = {"field", mesh, "--method", "direct", "--resolution", "48",
    "--pieces", "3", "-o", folder.path("out.vti")};
  const std::string shown = shownBy(run);
  const std::regex bar(R"(\r(\w+) *\[[#.]{40}\] +(\d+) %)");
  std::vector<int> percents;
  for (auto at = std::sregex_iterator(shown.begin(), shown.end(), bar);
       at != std::sregex_iterator(); ++at)
  {
    const std::string word = (*at)[1];
    EXPECT_TRUE(
      word == "reading" || word == "preparing" || word == "evaluating" || word == "writing")
      << word;
    percents.push_back(std::stoi((*at)[2]));
    EXPECT_TRUE(word != "evaluating" || percents.back() >= 40) << "after reading and preparing";
  }
  ASSERT_GT(percents.size(), 3u) << shown;
  EXPECT_TRUE(std::is_sorted(percents.begin(), percents.end())) << shown;
  EXPECT_GT(percents.back(), 80) << shown; // measured: 97
  EXPECT_LE(percents.back(), 100) << shown;
  EXPECT_NE(shown.find("\r\033[K"), std::string::npos) << "the bar does not go away";
}

TEST(Progress, IsNotShownByAQuietProgram)
{
  const TemporaryFolder folder;
  const std::string mesh = folder.write("sphere.off", asOff(sphere(5)));
  EXPECT_EQ(shownBy({"field", mesh, "--method", "direct", "--resolution", "32", "--quiet", "-o",
              folder.path("out.vti")}),
    "");
}
