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
    throw Failure(EXIT_REFUSED, fileName, "no such file; check its name and folder");
  }
  if (std::filesystem::is_directory(fileName, error))
  {
    throw Failure(EXIT_REFUSED, fileName, "is a folder; give a file");
  }
  if (!std::filesystem::is_regular_file(fileName, error))
  {
    // Opening a pipe would wait until somebody writes into it.
    throw Failure(EXIT_REFUSED, fileName, "is a pipe, a device or a socket; give a regular file");
  }
  std::ifstream file(fileName, std::ios::binary);
  if (!file)
  {
    throw Failure(EXIT_REFUSED, fileName,
      std::string("cannot be opened: ") + std::strerror(errno) + "; check its permissions");
  }
  const std::uintmax_t size = std::filesystem::file_size(fileName, error);
  std::string text(error ? 0 : std::min<std::uintmax_t>(size, most), '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (text.empty() || !file)
  {
    throw Failure(EXIT_REFUSED, fileName,
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
