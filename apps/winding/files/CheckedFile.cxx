#include "files/CheckedFile.h"

#include "program/Failure.h"
#include "program/Interrupt.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <functional>

#include <fcntl.h>
#include <unistd.h>

namespace
{

constexpr std::size_t bytesPerBlock = 1 << 18;

bool isSameTime(const struct timespec& a, const struct timespec& b)
{
  return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec;
}

} // namespace

CheckedFile::CheckedFile(const std::string& name, int descriptor)
  : name_(name)
  , descriptor_(descriptor)
  , opened_()
{
}

CheckedFile::CheckedFile(const std::string& name)
  : CheckedFile(name, open(name.c_str(), O_RDONLY | O_CLOEXEC))
{
  if (descriptor_ < 0 || fstat(descriptor_, &opened_) != 0)
  {
    throw Failure(EXIT_REFUSED, name_,
      std::string("cannot be opened: ") + std::strerror(errno) + "; check its permissions");
  }
  size_ = static_cast<std::size_t>(opened_.st_size);
  checksums_.resize((size_ + bytesPerBlock - 1) / bytesPerBlock);
  std::vector<char> bytes(bytesPerBlock);
  for (std::size_t block = 0; block < checksums_.size(); ++block)
  {
    interrupt::check();
    checksums_[block] = this->takeBlock(block, bytes.data());
  }
}

CheckedFile::~CheckedFile()
{
  if (descriptor_ >= 0)
  {
    close(descriptor_);
  }
}

void CheckedFile::checkName() const
{
  struct stat now = {};
  if (stat(name_.c_str(), &now) != 0 || now.st_dev != opened_.st_dev ||
      now.st_ino != opened_.st_ino || now.st_size != opened_.st_size)
  {
    this->refuseChanged();
  }
  if (isSameTime(now.st_mtim, opened_.st_mtim) && isSameTime(now.st_ctim, opened_.st_ctim))
  {
    return;
  }
  std::vector<char> bytes(bytesPerBlock); // times change with a mere touch, too
  for (std::size_t block = 0; block < checksums_.size(); ++block)
  {
    this->checkBlock(block, bytes.data());
  }
}

std::string_view CheckedFile::read(std::size_t offset, std::size_t count)
{
  if (offset > size_ || count > size_ - offset)
  {
    this->refuseChanged();
  }
  if (offset < first_ || offset + count > first_ + bytes_.size())
  {
    // Blocks that are there and go on are kept: most ends of blocks lie in a part that is wanted.
    const std::size_t first = offset - offset % bytesPerBlock;
    const bool goesOn = first_ <= first && first < first_ + bytes_.size();
    bytes_.erase(bytes_.begin(),
      goesOn ? bytes_.begin() + static_cast<std::ptrdiff_t>(first - first_) : bytes_.end());
    first_ = first;
    while (first_ + bytes_.size() < offset + count)
    {
      const std::size_t size = bytes_.size(), block = (first_ + size) / bytesPerBlock;
      bytes_.resize(size + this->sizeOf(block));
      this->checkBlock(block, bytes_.data() + size);
    }
  }
  return {bytes_.data() + (offset - first_), count};
}

std::size_t CheckedFile::sizeOf(std::size_t block) const
{
  return std::min(bytesPerBlock, size_ - block * bytesPerBlock);
}

/// Reads a block again. Throws Failure where it is not what it was.
void CheckedFile::checkBlock(std::size_t block, char* bytes) const
{
  interrupt::check();
  if (this->takeBlock(block, bytes) != checksums_[block])
  {
    this->refuseChanged();
  }
}

/// Reads a block, and gives its checksum.
std::uint64_t CheckedFile::takeBlock(std::size_t block, char* bytes) const
{
  const std::size_t offset = block * bytesPerBlock, count = this->sizeOf(block);
  std::size_t size = 0;
  while (size < count)
  {
    const ssize_t taken =
      pread(descriptor_, bytes + size, count - size, static_cast<off_t>(offset + size));
    if (taken < 0 && errno == EINTR)
    {
      continue;
    }
    if (taken < 0)
    {
      throw Failure(EXIT_REFUSED, name_, std::string("cannot be read: ") + std::strerror(errno));
    }
    if (taken == 0)
    {
      this->refuseChanged();
    }
    size += static_cast<std::size_t>(taken);
  }
  return std::hash<std::string_view>()({bytes, count});
}

void CheckedFile::refuseChanged() const
{
  throw Failure(EXIT_REFUSED, name_, "has changed since it was read; start again");
}
