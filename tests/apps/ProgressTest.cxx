// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
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

/// The words and percentages of the bars, in the order in which they were shown.
std::vector<std::pair<std::string, int>> barsIn(const std::string& shown)
{
  const std::regex bar(R"(\r(\w+) *\[[#.]{40}\] +(\d+) %)");
  std::vector<std::pair<std::string, int>> bars;
  for (auto at = std::sregex_iterator(shown.begin(), shown.end(), bar);
       at != std::sregex_iterator(); ++at)
  {
    bars.emplace_back((*at)[1], std::stoi((*at)[2]));
  }
  return bars;
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
  std::vector<int> percents;
  for (const auto& [word, percent] : barsIn(shown))
  {
    EXPECT_TRUE(
      word == "reading" || word == "preparing" || word == "evaluating" || word == "writing")
      << word;
    percents.push_back(percent);
    EXPECT_TRUE(word != "evaluating" || percents.back() >= 40) << "after reading and preparing";
  }
  ASSERT_GT(percents.size(), 3u) << shown;
  EXPECT_TRUE(std::is_sorted(percents.begin(), percents.end())) << shown;
  EXPECT_GT(percents.back(), 80) << shown; // measured: 97
  EXPECT_LE(percents.back(), 100) << shown;
  EXPECT_NE(shown.find("\r\033[K"), std::string::npos) << "the bar does not go away";
}

TEST(Progress, RisesWhileNormalsAreEstimated)
{
  // Nested spheres, on which the spanning tree fails: two seconds or more.
  const TemporaryFolder folder;
  std::string points;
  for (const double radius : {1.0, 0.7})
  {
    for (const auto& at : sphere(6).points)
    {
      for (const double x : at)
      {
        points += std::to_string(radius * x) + " ";
      }
      points += "\n";
    }
  }
  const std::string cloud = folder.write("cloud.xyz", points);
  for (const std::vector<std::string>& run :
    {std::vector<std::string>{"field", cloud, "--estimate-normals", "-o", folder.path("f.vti")},
      {"normals", cloud, "-o", folder.path("n.ply")}})
  {
    const auto bars = barsIn(shownBy(run));
    int last = 0, most = 0, steps = 0;
    for (const auto& [word, percent] : bars)
    {
      EXPECT_GE(percent, last);
      if (word == "preparing" || word == "orienting")
      {
        most = percent;
        steps += percent > last ? 1 : 0;
      }
      last = percent;
    }
    EXPECT_GT(most, 50) << run[0]; // measured: 59 and 89
    EXPECT_GT(steps, 5) << run[0]; // measured: 24 and 30
  }
}

TEST(Progress, IsNotShownByAQuietProgram)
{
  const TemporaryFolder folder;
  const std::string mesh = folder.write("sphere.off", asOff(sphere(5)));
  EXPECT_EQ(shownBy({"field", mesh, "--method", "direct", "--resolution", "32", "--quiet", "-o",
              folder.path("out.vti")}),
    "");
}
