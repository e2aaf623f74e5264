// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/Folder.h"

#include "program/Failure.h"

#include <filesystem>

namespace
{

bool isInFolder(const std::string& file, const std::string& folder)
{
  std::error_code error;
  const std::filesystem::path path = std::filesystem::canonical(file, error);
  return !error && std::filesystem::equivalent(path.parent_path(), folder, error);
}

} // namespace

Folder::Folder(const std::string& folder, const std::string& file, const std::string& parts)
  : folder_(folder)
  , file_(file)
  , parts_(parts)
{
  std::error_code error;
  isNew_ = std::filesystem::create_directory(folder, error);
  if (error || !std::filesystem::is_directory(folder))
  {
    throw Failure(EXIT_REFUSED, file,
      "needs the folder " + folder + " for its " + parts +
        ", which cannot be made: " + error.message() + "; give another name");
  }
}

Folder::~Folder()
{
  if (isNew_)
  {
    std::error_code error;
    std::filesystem::remove(folder_, error); // a folder that has files stays
  }
}

void Folder::refuseInputs(const std::vector<std::string>& inputs) const
{
  for (const std::string& input : inputs)
  {
    if (isInFolder(input, folder_))
    {
      throw Failure(EXIT_REFUSED, file_,
        "needs the folder " + folder_ + " for its " + parts_ + ", which holds the input " + input +
          "; give another name, or say --overwrite");
    }
  }
}

void Folder::refuseOtherFiles() const
{
  throw Failure(EXIT_REFUSED, file_,
    "needs the folder " + folder_ + " for its " + parts_ +
      ", which is there and holds other files; give another name");
}
