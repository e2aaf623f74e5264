#include "files/OpenFile.h"

#include "program/Failure.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace
{

constexpr std::size_t bytesAtOnce = 1 << 20;

bool isSameFile(const struct stat& a, const struct stat& b)
{
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

bool isUnchanged(const struct stat& before, const struct stat& now)
{
  return before.st_size == now.st_size && before.st_mtim.tv_sec == now.st_mtim.tv_sec &&
         before.st_mtim.tv_nsec == now.st_mtim.tv_nsec;
}

} // namespace

OpenFile::OpenFile(const std::string& name)
  : name_(name)
  , descriptor_(open(name.c_str(), O_RDONLY | O_CLOEXEC))
  , opened_()
{
  if (descriptor_ < 0 || fstat(descriptor_, &opened_) != 0)
  {
    const std::string reason = std::strerror(errno);
    if (descriptor_ >= 0)
    {
      close(descriptor_);
    }
    throw Failure(REFUSED, name_, "cannot be opened: " + reason + "; check its permissions");
  }
}

OpenFile::~OpenFile()
{
  close(descriptor_);
}

void OpenFile::checkName() const
{
  struct stat named = {};
  if (stat(name_.c_str(), &named) != 0 || !isSameFile(opened_, named) ||
      !isUnchanged(opened_, named))
  {
    this->refuseChanged();
  }
}

void OpenFile::checkIsUnchanged() const
{
  struct stat now = {};
  if (fstat(descriptor_, &now) != 0 || !isUnchanged(opened_, now))
  {
    this->refuseChanged();
  }
}

std::string_view OpenFile::read(std::size_t offset, std::size_t count)
{
  if (offset < first_ || offset + count > first_ + bytes_.size())
  {
    bytes_.resize(std::max(bytesAtOnce, count));
    first_ = offset;
    std::size_t size = 0;
    while (size < bytes_.size())
    {
      const ssize_t taken = pread(
        descriptor_, bytes_.data() + size, bytes_.size() - size, static_cast<off_t>(offset + size));
      if (taken < 0 && errno == EINTR)
      {
        continue;
      }
      if (taken <= 0)
      {
        break;
      }
      size += static_cast<std::size_t>(taken);
    }
    bytes_.resize(size);
    if (size < count)
    {
      this->refuseChanged();
    }
  }
  return {bytes_.data() + (offset - first_), count};
}

void OpenFile::refuseChanged() const
{
  throw Failure(REFUSED, name_, "has changed while it was read; start again");
}
