// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/Inputs.h"
#include "apps/RunProgram.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLPImageDataReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <set>
#include <string>
#include <thread>

#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

using namespace std::chrono_literals;

/// Files that lie where the program writes.
class OutputFiles : public testing::Test
{
protected:
  Outcome field(const std::string& out, const std::vector<std::string>& more = {}) const
  {
    std::vector<std::string> arguments = {
      "field", in, "-o", folder.path(out), "--resolution", "4", "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runProgram(arguments);
  }

  /// Starts a run that would take minutes, and waits until its temporary file is there.
  int startLongRun(const std::string& out) const
  {
    const std::size_t before = folder.names().size();
    const int process = startProgram({"field", in, "-o", folder.path(out), "--threads", "1",
      "--resolution", "500", "--method", "direct"});
    for (int i = 0; i < 2000 && folder.names().size() == before; ++i)
    {
      std::this_thread::sleep_for(10ms);
    }
    std::this_thread::sleep_for(50ms); // from the making of the file to its lock
    return process;
  }

  std::vector<std::string> partFiles() const
  {
    std::vector<std::string> names = folder.names();
    const auto isNoPart = [](const std::string& name)
    {
      return name.find(".part.") == std::string::npos;
    };
    names.erase(std::remove_if(names.begin(), names.end(), isNoPart), names.end());
    return names;
  }

  static void end(int process)
  {
    kill(process, SIGKILL);
    int status = 0;
    waitpid(process, &status, 0);
  }

  TemporaryFolder folder;
  std::string in = folder.write("in.off", asOff(sphere(3)));
};

TEST_F(OutputFiles, AnInputIsNotReplaced)
{
  const std::string queries = folder.write("q.csv", "x,y,z\n0,0,0\n");
  ASSERT_EQ(symlink("q.csv", folder.path("link.csv").c_str()), 0);
  ASSERT_EQ(symlink("link.csv", folder.path("chain.csv").c_str()), 0);
  ASSERT_EQ(link(queries.c_str(), folder.path("hard.csv").c_str()), 0);
  std::filesystem::create_directory(folder.path("sub"));
  const std::string before = contentsOf(queries);
  for (const char* read : {"q.csv", "link.csv", "hard.csv"})
  {
    for (const char* out :
      {"q.csv", "link.csv", "chain.csv", "hard.csv", "./q.csv", "sub/../q.csv", "/q.csv"})
    {
      const Outcome run = runProgram({"probe", in, folder.path(read), "-o", folder.path(out)});
      EXPECT_EQ(run.status, 2) << read << " " << out << run;
      EXPECT_TRUE(run.saysInOneLine({out, "is the input", "--overwrite"})) << run;
      EXPECT_EQ(contentsOf(queries), before);
    }
  }
  EXPECT_TRUE(partFiles().empty());

  const std::string mesh = folder.path("mesh.ply");
  ASSERT_EQ(runProgram({"surface", in, "-o", mesh, "--resolution", "8"}).status, 0);
  const std::string scan = contentsOf(mesh);
  for (const std::vector<std::string>& command :
    {std::vector<std::string>{"surface", mesh, "-o", mesh, "--resolution", "4"},
      {"voxels", mesh, "-o", mesh, "--resolution", "4"},
      {"check", mesh, "--fix-orientation", "-o", mesh}, {"normals", mesh, "-o", mesh},
      {"probe", mesh, queries, "-o", folder.path("hard.csv")}})
  {
    const Outcome run = runProgram(command);
    EXPECT_EQ(run.status, 2) << run;
    EXPECT_TRUE(run.saysInOneLine({"is the input", "--overwrite"})) << run;
    EXPECT_EQ(contentsOf(mesh), scan);
  }
}

TEST_F(OutputFiles, AnInputIsReplacedOnRequest)
{
  const std::string queries = folder.write("q.csv", "x,y,z\n0,0,0\n");
  const Outcome run = runProgram({"probe", in, queries, "-o", queries, "--overwrite"});
  EXPECT_EQ(run.status, 0) << run;
  EXPECT_EQ(contentsOf(queries).substr(0, 26), "x,y,z,WindingNumber,Inside");
}

TEST_F(OutputFiles, AnInputAmongTheBlocksIsNotReplaced)
{
  const std::string faults = folder.path("faults.vtm");
  Mesh mesh = sphere(3);
  mesh.triangles.pop_back();
  const std::string open = folder.write("open.off", asOff(mesh));
  ASSERT_EQ(runProgram({"check", open, "--blocks", faults}).status, 0);
  const std::string boundary = folder.path("faults/Boundary.vtp");
  const std::string before = contentsOf(boundary);
  const Outcome run = runProgram({"check", boundary, "--blocks", faults});
  EXPECT_EQ(run.status, 2) << run;
  EXPECT_TRUE(run.saysInOneLine({"faults.vtm", "holds the input", "--overwrite"})) << run;
  EXPECT_EQ(contentsOf(boundary), before);
  EXPECT_EQ(runProgram({"check", open, "--blocks", faults}).status, 0)
    << "their own index is there";
}

TEST_F(OutputFiles, AnInputAmongThePiecesIsNotReplaced)
{
  // Only a link gives a file of the folder a name that its format is known by.
  std::filesystem::create_directory(folder.path("p"));
  const std::string piece = folder.write("p/p_0.vti", asOff(sphere(3)));
  ASSERT_EQ(symlink("p/p_0.vti", folder.path("link.off").c_str()), 0);
  in = folder.path("link.off");
  const Outcome run = field("p.pvti");
  EXPECT_EQ(run.status, 2) << run;
  EXPECT_TRUE(run.saysInOneLine({"p.pvti", "holds the input", "--overwrite"})) << run;
  EXPECT_EQ(contentsOf(piece), asOff(sphere(3)));
  EXPECT_EQ(field("p.pvti", {"--overwrite"}).status, 0);
  EXPECT_NE(contentsOf(piece).find("ImageData"), std::string::npos);
}

TEST_F(OutputFiles, AFolderThatWasThereStaysAfterARefusal)
{
  std::filesystem::create_directory(folder.path("out"));
  for (const bool isThere : {true, false})
  {
    const std::string name = isThere ? "out" : "new";
    for (const std::vector<std::string>& command :
      {std::vector<std::string>{
         "field", folder.path("none.off"), "-o", folder.path(name + ".pvti")},
        {"check", folder.path("none.off"), "--blocks", folder.path(name + ".vtm")}})
    {
      const Outcome run = runProgram(command);
      EXPECT_EQ(run.status, 2) << run;
      EXPECT_EQ(std::filesystem::exists(folder.path(name)), isThere) << run;
    }
  }
}

TEST_F(OutputFiles, BlocksThatAKilledRunHasLeftAreCleared)
{
  std::filesystem::create_directory(folder.path("faults"));
  folder.write("faults/.Boundary.winding-1234.part.vtp", "the beginning of a block");
  const std::string faults = folder.path("faults.vtm");
  const Outcome run = runProgram({"check", in, "--blocks", faults});
  EXPECT_EQ(run.status, 0) << run;
  EXPECT_FALSE(std::filesystem::exists(folder.path("faults/.Boundary.winding-1234.part.vtp")));

  std::filesystem::create_directory(folder.path("others"));
  folder.write("others/notes.txt", "somebody's");
  const Outcome refused = runProgram({"check", in, "--blocks", folder.path("others.vtm")});
  EXPECT_EQ(refused.status, 2) << refused;
  EXPECT_TRUE(refused.saysInOneLine({"others.vtm", "holds other files"})) << refused;
}

TEST_F(OutputFiles, OlderOutputsAreReplaced)
{
  folder.write("out.vti", "what was there before");
  EXPECT_EQ(field("out.vti").status, 0);
  EXPECT_NE(contentsOf(folder.path("out.vti")).find("ImageData"), std::string::npos);
}

TEST_F(OutputFiles, WriteProtectedFilesAreNotReplaced)
{
  const std::string out = folder.write("out.vti", "what was there before");
  ASSERT_EQ(chmod(out.c_str(), 0444), 0);
  ASSERT_EQ(symlink("out.vti", folder.path("link.vti").c_str()), 0);
  for (const char* name : {"out.vti", "link.vti"})
  {
    for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--overwrite"}})
    {
      const Outcome run = field(name, more);
      EXPECT_EQ(run.status, 2) << run;
      EXPECT_TRUE(run.saysInOneLine({name, "write-protected"})) << run;
      EXPECT_EQ(contentsOf(out), "what was there before");
    }
  }
  EXPECT_TRUE(partFiles().empty());
}

TEST_F(OutputFiles, WhatComesToStandThereMeanwhileIsNotReplaced)
{
#ifdef WINDING_SANITIZED
  GTEST_SKIP() << "sanitizers want to be loaded before all other libraries";
#endif
  setenv("LD_PRELOAD", WINDING_FILE_FAULTS, 1);
  setenv("FAULT_FILE", "in.off", 1);
  setenv("FAULT_OPENING", "1", 1);
  setenv("FAULT_ACTION", "pause", 1);
  const int process =
    startProgram({"field", in, "-o", folder.path("out.vti"), "--resolution", "4"});
  unsetenv("LD_PRELOAD");
  for (int i = 0; i < 6000 && partFiles().empty(); ++i)
  {
    std::this_thread::sleep_for(10ms);
  }
  const std::string out = folder.write("out.vti", "somebody's");
  ASSERT_EQ(chmod(out.c_str(), 0444), 0);
  int status = 0;
  waitpid(process, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 2);
  EXPECT_EQ(contentsOf(out), "somebody's");
  EXPECT_TRUE(partFiles().empty());
}

TEST_F(OutputFiles, LongNames)
{
  // A file system that counts characters, or that wants UTF-8, gets no name that is cut in one.
  std::string accents;
  for (int i = 0; i < 125; ++i)
  {
    accents += "\xC3\xA9";
  }
  for (const std::string& name :
    {std::string(251, 'a') + ".vti", accents + "a.vti", "a" + accents + ".vti"})
  {
    ASSERT_EQ(name.size(), 255u);
    EXPECT_EQ(field(name).status, 0) << name;
    EXPECT_NE(contentsOf(folder.path(name)).find("ImageData"), std::string::npos);
  }
  EXPECT_EQ(field(std::string(252, 'a') + ".vti").status, 2);
  const Outcome surface =
    runProgram({"surface", in, "-o", folder.path(std::string(251, 'b') + ".ply")});
  EXPECT_EQ(surface.status, 0) << surface;
  EXPECT_TRUE(partFiles().empty());
}

TEST_F(OutputFiles, KilledRunsLeaveNothingThatTheNextDoesNotClear)
{
  end(startLongRun("big.vti"));
  EXPECT_EQ(partFiles().size(), 1u);
  EXPECT_EQ(field("other.vti").status, 0);
  EXPECT_TRUE(partFiles().empty());
}

TEST_F(OutputFiles, TheFileOfALivingRunStays)
{
  const int living = startLongRun("out.vti");
  const std::vector<std::string> before = partFiles();
  ASSERT_EQ(before.size(), 1u);
  EXPECT_EQ(field("out.vti").status, 0);
  EXPECT_EQ(field("other.vti").status, 0);
  EXPECT_EQ(partFiles(), before);
  end(living);
}

TEST_F(OutputFiles, FilesOfOthersStay)
{
  const std::vector<std::string> names = {".out.vti", ".out.part.vti", ".out.1234.part.vti",
    "out.winding-1234.part.vti", ".out.winding-1234.part", ".out.winding-x.part.vti"};
  for (const std::string& name : names)
  {
    folder.write(name, "somebody's");
  }
  EXPECT_EQ(field("out.vti").status, 0);
  for (const std::string& name : names)
  {
    EXPECT_EQ(contentsOf(folder.path(name)), "somebody's") << name;
  }
}

TEST_F(OutputFiles, PiecesOfAnOlderRunAreClearedThoughThereIsButOneMore)
{
  for (const int count : {5, 4, 1, 3, 2})
  {
    const Outcome run = runProgram({"field", in, "-o", folder.path("p.pvti"), "--resolution", "8",
      "--pieces", std::to_string(count)});
    EXPECT_EQ(run.status, 0) << run;
    std::set<std::string> names, expected;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path("p")))
    {
      names.insert(entry.path().filename().string());
    }
    for (int piece = 0; piece < count; ++piece)
    {
      expected.insert("p_" + std::to_string(piece) + ".vti");
    }
    EXPECT_EQ(names, expected);
  }
}

TEST_F(OutputFiles, NamesWithMarksOfXmlAreReadBack)
{
  for (const std::string name : {"a&b", "a<b>", "a\"b", "a'b", "a &quot; b"})
  {
    const Outcome run = runProgram(
      {"field", in, "-o", folder.path(name + ".pvti"), "--resolution", "8", "--pieces", "2"});
    EXPECT_EQ(run.status, 0) << run;
    vtkNew<vtkXMLPImageDataReader> reader;
    reader->SetFileName(folder.path(name + ".pvti").c_str());
    reader->Update();
    EXPECT_EQ(reader->GetErrorCode(), 0u) << name;
    EXPECT_NE(reader->GetOutput()->GetPointData()->GetArray("WindingNumber"), nullptr) << name;
  }
}

TEST_F(OutputFiles, MorePiecesThanThereAreIsFewerWithAWord)
{
  struct Case
  {
    std::vector<std::string> grid;
    const char* most;
  };
  for (const Case& c : {Case{{"--dims", "2", "2", "2", "--cells"}, "2"},
         Case{{"--dims", "5", "2", "3"}, "4"}, Case{{"--dims", "1", "1", "1"}, "1"}})
  {
    std::vector<std::string> arguments = {
      "field", in, "-o", folder.path("out.vti"), "--pieces", "1000000000"};
    arguments.insert(arguments.end(), c.grid.begin(), c.grid.end());
    const Outcome run = runProgram(arguments, "timeout 20 ");
    EXPECT_EQ(run.status, 0) << run;
    EXPECT_NE(run.err.find(std::string("it is written in ") + c.most + "\n"), std::string::npos)
      << run;
    EXPECT_EQ(contentsOf(folder.path("out.vti")).find("0 -1 0 -1"), std::string::npos)
      << "no piece is empty";
    arguments[5] = c.most;
    // All pieces together are looked at as the whole is, and have too few voxels.
    const std::string words = runProgram(arguments).err;
    EXPECT_NE(words.find("the source is thinner"), std::string::npos) << words;
    EXPECT_EQ(std::count(words.begin(), words.end(), '\n'), 1) << words;
  }
}

} // namespace
