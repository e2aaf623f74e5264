#include "output/OutputFile.h"

#include "program/Failure.h"
#include "program/Interrupt.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace
{

/**
 * Whether the file can grow; it cannot when the disk is full. Some writers of VTK do not look at
 * their stream's state: they stop in the middle then, and say nothing. Leaves the file unchanged.
 */
bool canGrow(const std::string& path)
{
  const int file = open(path.c_str(), O_WRONLY | O_APPEND);
  struct stat before = {};
  if (file < 0 || fstat(file, &before) != 0)
  {
    return false;
  }
  // The bytes are more than what may be left in the last block of the file.
  const std::vector<char> block(1 << 16);
  const bool grown = write(file, block.data(), block.size()) == static_cast<ssize_t>(block.size());
  const bool restored = ftruncate(file, before.st_size) == 0;
  return close(file) == 0 && grown && restored && before.st_size > 0;
}

/// The file that a name leads to, whether it exists or not. Throws Failure for a circle of links.
std::filesystem::path behindLinks(const std::string& name)
{
  std::filesystem::path path(name);
  std::error_code error;
  for (int links = 0; std::filesystem::is_symlink(path, error); ++links)
  {
    constexpr int most = 40; // systems follow no more, either
    if (links == most)
    {
      throw Failure(REFUSED, name, "is a link that leads to itself; give another name");
    }
    path = path.parent_path() / std::filesystem::read_symlink(path, error);
  }
  return path;
}

} // namespace

OutputFile::OutputFile(const std::string& name)
  : name_(name)
{
  std::error_code error;
  const std::filesystem::path path = behindLinks(name);
  target_ = path.string();
  if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error))
  {
    throw Failure(
      REFUSED, name, "is there and is no file that could be replaced; give another name");
  }
  // The suffix stands at the end: VTK's PLY writer would put one there otherwise.
  const std::string temporary = "." + path.stem().string() + "." + std::to_string(getpid()) +
                                ".part" + path.extension().string();
  temporary_ = (path.parent_path() / temporary).string();
  const int file = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0666);
  if (file < 0)
  {
    throw Failure(REFUSED, name,
      std::string("cannot be written: ") + std::strerror(errno) + "; choose another folder");
  }
  close(file);
  interrupt::setTemporaryFile(temporary_);
}

OutputFile::~OutputFile()
{
  if (!temporary_.empty())
  {
    unlink(temporary_.c_str());
    interrupt::setTemporaryFile("");
  }
}

void OutputFile::refuseWriting() const
{
  throw Failure(REFUSED, name_,
    canGrow(temporary_) ? "cannot be written; choose another folder"
                        : "cannot be written: no space left; make room or choose another disk");
}

void OutputFile::commit()
{
  if (!canGrow(temporary_))
  {
    refuseWriting();
  }
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0)
  {
    throw Failure(REFUSED, name_,
      std::string("cannot be written: ") + std::strerror(errno) + "; choose another name");
  }
  interrupt::setTemporaryFile("");
  temporary_.clear();
}
