// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/RunProgram.h"
#include "support/MessageList.h"

#include <gtest/gtest.h>

namespace
{

/// Runs a command on a file of tests/messages, and returns what it says of it.
std::string messageOf(const std::string& command, const std::string& file,
  const std::vector<std::string>& options, const std::string& output)
{
  std::vector<std::string> arguments = {command, WINDING_MESSAGES "/" + file, "-o", output};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const std::string text = runProgram(arguments).err;
  const std::string name = WINDING_MESSAGES "/" + file + ": ";
  const std::size_t begin = text.find(name);
  const std::size_t start =
    begin == std::string::npos ? text.find("error: ") + 7 : begin + name.size();
  return text.substr(start, text.find('\n') - start);
}

TEST(MessageWords, AreThoseOfTheProgram)
{
  const TemporaryFolder folder;
  const std::string vti = folder.path("out.vti"), vtp = folder.path("out.vtp");
  const std::vector<std::string> coarse = {"--resolution", "4"};
  auto expected = messagesOf("program");
  EXPECT_EQ(messageOf("field", "bare.xyz", coarse, vti), expected["points without normals"]);
  EXPECT_EQ(messageOf("field", "place.xyz", coarse, vti), expected["bounds of a single point"]);
  EXPECT_EQ(messageOf("field", "place.xyz",
              {"--method", "parity", "--bounds", "0", "1", "0", "1", "0", "1"}, vti),
    expected["a method that points do not have"]);
  EXPECT_EQ(
    messageOf("field", "cube.off", {"--padding", "-1"}, vti), expected["a number out of range"]);
  EXPECT_EQ(messageOf("field", "cube.off", {"--mirror", "y=0", "--mirror", "1 1 0 = 0"}, vti),
    expected["mirror planes at an angle"]);
  EXPECT_EQ(
    messageOf("field", "cube.off", {"--voxel-size", "1e-12"}, vti), expected["too many voxels"]);
  EXPECT_EQ(messageOf("field", "inward.off", coarse, vti), expected["faces that look inward"]);
  EXPECT_EQ(messageOf("field", "loose.off", coarse, vti), expected["lines next to faces"]);
  EXPECT_EQ(messageOf("field", "zeros.xyz", coarse, vti), expected["normals of length 0"]);
  EXPECT_EQ(messageOf("field", "equal.xyz", coarse, vti), expected["normals that are equal"]);
  EXPECT_EQ(messageOf("field", "octahedron.xyz", {"--estimate-normals", "--resolution", "4"}, vti),
    expected["normals where others are wanted"]);
  EXPECT_EQ(
    messageOf("normals", "octahedron.xyz", {}, vtp), expected["normals where others are wanted"]);
  EXPECT_EQ(messageOf("field", "colours.xyz", coarse, vti), expected["columns of colours"]);
  std::vector<std::string> within = {
    "--resolution", "4", "--bounds", "0.4", "0.6", "0.4", "0.6", "0.4", "0.6"};
  EXPECT_EQ(messageOf("surface", "cube.off", within, vtp),
    expected["a solid that is closed at the border"]);
  within.emplace_back("--as-is");
  EXPECT_EQ(messageOf("surface", "cube.off", within, vtp), expected["a grid within the solid"]);
  EXPECT_EQ(messageOf("surface", "inward.off", coarse, vtp), expected["faces that are turned"]);
  EXPECT_EQ(runProgram({"check", WINDING_MESSAGES "/inward.off", "--json"}).json()["advice"],
    expected["the report on faces that look inward"]);
}

} // namespace
