#include "files/FileAccess.h"

#include "program/Failure.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace
{

std::string read(const std::string& fileName, std::size_t most)
{
  std::error_code error;
  if (!std::filesystem::exists(fileName, error))
  {
    throw Failure(REFUSED, fileName, "no such file; check its name and folder");
  }
  if (std::filesystem::is_directory(fileName, error))
  {
    throw Failure(REFUSED, fileName, "is a folder; give a file");
  }
  std::ifstream file(fileName, std::ios::binary);
  if (!file)
  {
    throw Failure(REFUSED, fileName,
      std::string("cannot be opened: ") + std::strerror(errno) + "; check its permissions");
  }
  const std::uintmax_t size = std::filesystem::file_size(fileName, error);
  if (error)
  {
    throw Failure(REFUSED, fileName, "is not a regular file; give one");
  }
  std::string text(std::min<std::uintmax_t>(size, most), '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (text.empty() || !file)
  {
    throw Failure(REFUSED, fileName,
      text.empty() ? "is empty; give another file" : "cannot be read to its end");
  }
  return text;
}

} // namespace

std::string contentsOf(const std::string& fileName)
{
  return read(fileName, SIZE_MAX);
}

std::string beginningOf(const std::string& fileName, std::size_t bytes)
{
  return read(fileName, bytes);
}
