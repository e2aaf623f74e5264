// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/RunProgram.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

std::string quoted(const std::string& word)
{
  std::string text = "'";
  for (const char c : word)
  {
    text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return text + "'";
}

} // namespace

TemporaryFolder::TemporaryFolder()
{
  std::string name = (std::filesystem::temp_directory_path() / "winding-test-XXXXXX").string();
  path_ = mkdtemp(name.data());
}

TemporaryFolder::~TemporaryFolder()
{
  std::error_code error;
  std::filesystem::remove_all(path_, error);
}

std::string TemporaryFolder::write(const std::string& name, const std::string& contents) const
{
  std::ofstream(this->path(name), std::ios::binary) << contents;
  return this->path(name);
}

std::vector<std::string> TemporaryFolder::names() const
{
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_))
  {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

std::string contentsOf(const std::string& fileName)
{
  std::ostringstream text;
  text << std::ifstream(fileName, std::ios::binary).rdbuf();
  return text.str();
}

bool Outcome::saysInOneLine(const std::vector<std::string>& parts) const
{
  bool all = err.rfind("winding: error: ", 0) == 0 && err.find('\n') == err.size() - 1;
  for (const std::string& part : parts)
  {
    all = all && err.find(part) != std::string::npos;
  }
  return all;
}

std::ostream& operator<<(std::ostream& stream, const Outcome& run)
{
  return stream << "exit status " << run.status << "\nstandard output: " << run.out
                << "\nstandard error: " << run.err;
}

Outcome runProgram(const std::vector<std::string>& arguments, const std::string& before)
{
  const TemporaryFolder folder;
  // A limit on files would cut off the counts of coverage, too; both they and what is said about
  // them go nowhere then.
  const std::string counts =
    before.empty() ? "" : "env GCOV_PREFIX=/dev/null GCOV_ERROR_FILE=/dev/null ";
  std::string command = before + counts + quoted(WINDING_PROGRAM);
  for (const std::string& argument : arguments)
  {
    command += " " + quoted(argument);
  }
  command += " >" + quoted(folder.path("out")) + " 2>" + quoted(folder.path("err"));
  const int status = std::system(command.c_str());
  Outcome run;
  run.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.out = contentsOf(folder.path("out"));
  run.err = contentsOf(folder.path("err"));
  return run;
}

int startProgram(const std::vector<std::string>& arguments)
{
  std::vector<std::string> words = arguments;
  words.insert(words.begin(), WINDING_PROGRAM);
  std::vector<char*> pointers;
  for (std::string& word : words)
  {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  const int process = fork();
  if (process == 0)
  {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    execv(WINDING_PROGRAM, pointers.data());
    _exit(127);
  }
  return process;
}
