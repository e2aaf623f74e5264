#include "files/InputFile.h"

#include "files/PlainArray.h"

#include <algorithm>
#include <cerrno>
#include <string_view>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace winding
{

namespace
{

constexpr std::size_t bytesAtOnce = 1 << 18;

} // namespace

InputFile::InputFile(const char* name)
  : name_(name ? name : "")
{
  if (name_.empty())
  {
    throw FileRefusal(FileFault::noName, "no file name is set; call SetFileName");
  }
  struct stat about = {};
  if (stat(name_.c_str(), &about) != 0)
  {
    const bool isMissing = errno == ENOENT || errno == ENOTDIR;
    this->refuse(isMissing ? "no such file" : "cannot be opened; check its permissions",
      isMissing ? FileFault::notFound : FileFault::cannotOpen);
  }
  if (S_ISDIR(about.st_mode))
  {
    this->refuse("is a directory, not a file", FileFault::cannotOpen);
  }
  if (!S_ISREG(about.st_mode))
  {
    // Opening a pipe would wait until somebody writes into it.
    this->refuse("is a pipe, a device or a socket; give a regular file", FileFault::cannotOpen);
  }
  descriptor_ = open(name_.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0)
  {
    const bool isMissing = errno == ENOENT;
    this->refuse(isMissing ? "no such file" : "cannot be opened; check its permissions",
      isMissing ? FileFault::notFound : FileFault::cannotOpen);
  }
  // The size belongs to the file that was opened, which may be another one by now.
  size_ = fstat(descriptor_, &about) == 0 && about.st_size > 0
            ? static_cast<std::size_t>(about.st_size)
            : 0;
  if (size_ == 0)
  {
    close(descriptor_);
    this->refuse("is empty", FileFault::ends);
  }
}

InputFile::~InputFile()
{
  close(descriptor_);
}

void InputFile::read(std::size_t offset, char* bytes, std::size_t count) const
{
  while (count > 0)
  {
    const ssize_t taken = pread(descriptor_, bytes, count, static_cast<off_t>(offset));
    if (taken < 0 && errno == EINTR)
    {
      continue;
    }
    if (taken <= 0)
    {
      this->refuse("cannot be read to its end", FileFault::ends);
    }
    offset += static_cast<std::size_t>(taken);
    bytes += taken;
    count -= static_cast<std::size_t>(taken);
  }
}

std::size_t InputFile::textStart() const
{
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  char first[mark.size()] = {};
  this->read(0, first, std::min(sizeof first, size_));
  return std::string_view(first, sizeof first) == mark ? mark.size() : 0;
}

std::size_t InputFile::lineOf(std::size_t offset) const
{
  PlainArray<char> bytes(std::min(bytesAtOnce, size_));
  std::size_t line = 1;
  for (std::size_t first = 0; first < offset; first += bytes.size())
  {
    const std::size_t count = std::min(bytes.size(), offset - first);
    this->read(first, bytes.data(), count);
    line += static_cast<std::size_t>(std::count(bytes.data(), bytes.data() + count, '\n'));
  }
  return line;
}

void InputFile::refuse(const std::string& message, FileFault fault) const
{
  throw FileRefusal(fault, name_ + ": " + message);
}

void InputFile::refuseLine(std::size_t offset, const std::string& message) const
{
  this->refuse("line " + std::to_string(this->lineOf(offset)) + ": " + message);
}

void InputFile::refuseEnd(const std::string& message) const
{
  this->refuse(
    "ends at line " + std::to_string(this->lineOf(size_ - 1)) + ": " + message, FileFault::ends);
}

void InputFile::refuseChanged() const
{
  this->refuse("has changed while it was read; read it again");
}

} // namespace winding
