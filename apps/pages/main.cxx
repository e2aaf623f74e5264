// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pages.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

namespace
{

void write(const std::filesystem::path& path, const std::string& text)
{
  std::filesystem::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file)
  {
    throw std::runtime_error("cannot write " + path.string());
  }
}

} // namespace

/// Writes the man pages of the program and its completions into a folder: into man1, bash, zsh and
/// fish, by the names that they are installed by. Arguments: folder, date of the pages, version.
int main(int argc, char** argv)
{
  if (argc != 4)
  {
    std::cerr << "usage: winding_pages FOLDER DATE VERSION\n";
    return 1;
  }
  try
  {
    const std::filesystem::path folder = argv[1];
    const CommandEntry program = describeProgram();
    write(folder / "man1/winding.1", manPageOfProgram(program, argv[2], argv[3]));
    for (const CommandEntry& command : program.commands)
    {
      write(folder / "man1" / ("winding-" + command.name + ".1"),
        manPageOfCommand(command, argv[2], argv[3]));
    }
    write(folder / "bash/winding", completionsForBash(program));
    write(folder / "zsh/_winding", completionsForZsh(program));
    write(folder / "fish/winding.fish", completionsForFish(program));
  }
  catch (const std::exception& error)
  {
    std::cerr << "winding_pages: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
