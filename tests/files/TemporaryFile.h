// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>
#include <random>
#include <string>

/// A file with some contents, whose name has an ending; removed with the object.
class TemporaryFile
{
public:
  explicit TemporaryFile(const std::string& contents, const std::string& ending = "")
    : name_((std::filesystem::temp_directory_path() /
             ("winding-core-test-" + std::to_string(std::random_device()()) + ending))
              .string())
  {
    this->write(contents);
  }
  ~TemporaryFile() { std::filesystem::remove(name_); }
  TemporaryFile(const TemporaryFile&) = delete;
  void operator=(const TemporaryFile&) = delete;

  /// Replaces the contents; an open file sees the new ones.
  void write(const std::string& contents) const
  {
    std::ofstream(name_, std::ios::binary) << contents;
  }

  const char* name() const { return name_.c_str(); }

private:
  std::string name_;
};
