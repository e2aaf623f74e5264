// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzedFile.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include <unistd.h>

namespace fuzz
{

FuzzedFile::FuzzedFile(const std::string& suffix)
{
  const std::filesystem::path memory = "/dev/shm";
  std::error_code error;
  const auto folder =
    std::filesystem::is_directory(memory, error) ? memory : std::filesystem::temp_directory_path();
  name_ = (folder / ("winding_fuzz_" + std::to_string(getpid()) + suffix)).string();
}

FuzzedFile::~FuzzedFile()
{
  std::remove(name_.c_str());
}

void FuzzedFile::write(const std::uint8_t* data, std::size_t size) const
{
  std::FILE* const file = std::fopen(name_.c_str(), "wb");
  const bool isWritten = file && std::fwrite(data, 1, size, file) == size;
  if (!file || std::fclose(file) != 0 || !isWritten)
  {
    std::perror(name_.c_str());
    std::abort();
  }
}

} // namespace fuzz
