// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/OutputFile.h"

#include "program/Failure.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

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
      throw Failure(EXIT_REFUSED, name, "is a link that leads to itself; give another name");
    }
    path = path.parent_path() / std::filesystem::read_symlink(path, error);
  }
  return path;
}

bool isSameFile(const struct stat& file, const std::string& name)
{
  struct stat other = {};
  return stat(name.c_str(), &other) == 0 && other.st_dev == file.st_dev &&
         other.st_ino == file.st_ino;
}

bool isWriteProtected(const std::filesystem::path& path, const struct stat& file)
{
  // The superuser may write to any file, but one that nobody may write to is meant to stay.
  return (file.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0 ||
         (faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0 &&
           (errno == EACCES || errno == EPERM));
}

/// Throws Failure where a file stands that may not be replaced.
void checkMayBeReplaced(const std::string& name, const std::filesystem::path& target,
  const std::vector<std::string>& inputs)
{
  struct stat file = {};
  if (stat(target.c_str(), &file) != 0)
  {
    return;
  }
  if (!S_ISREG(file.st_mode))
  {
    throw Failure(
      EXIT_REFUSED, name, "is there and is no file that could be replaced; give another name");
  }
  for (const std::string& input : inputs)
  {
    if (isSameFile(file, input))
    {
      throw Failure(EXIT_REFUSED, name,
        (input == name ? "is the input" : "is the input " + input) +
          ", which the result would replace; give another name, or say --overwrite");
    }
  }
  if (isWriteProtected(target, file))
  {
    throw Failure(EXIT_REFUSED, name,
      "is there and is write-protected; give another name or allow writing to it");
  }
}

/// The target, if it may be written to.
std::filesystem::path checkedTarget(const std::string& name, const std::vector<std::string>& inputs)
{
  std::filesystem::path target = behindLinks(name);
  checkMayBeReplaced(name, target, inputs);
  return target;
}

/// Does what may fail because of the file system, and throws Failure, with the advice, if it does.
template <class Work>
decltype(auto) reporting(const std::string& name, const char* advice, const Work& work)
{
  try
  {
    return work();
  }
  catch (const std::system_error& error)
  {
    throw Failure(EXIT_REFUSED, name,
      std::string("cannot be written: ") + std::strerror(error.code().value()) + "; " + advice);
  }
}

} // namespace

OutputFile::OutputFile(const std::string& name, const std::vector<std::string>& inputs)
  : name_(name)
  , inputs_(inputs)
  , target_(checkedTarget(name, inputs))
  , temporary_(
      reporting(name, "choose another folder", [this] { return TemporaryFile(this->target_); }))
{
}

void OutputFile::refuseWriting() const
{
  throw Failure(EXIT_REFUSED, name_,
    canGrow(temporary_.name()) ? "cannot be written; choose another folder"
                               : "cannot be written: no space left; make room or choose another "
                                 "disk");
}

void OutputFile::checkIsWhole() const
{
  if (!canGrow(temporary_.name()))
  {
    this->refuseWriting();
  }
}

void OutputFile::commit()
{
  this->checkIsWhole();
  checkMayBeReplaced(name_, target_, inputs_);
  reporting(name_, "choose another name", [this] { temporary_.become(target_); });
}
