// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct zip;

/// The files of a .zip. Throws Failure for an archive that is damaged.
class ZipArchive
{
public:
  explicit ZipArchive(const std::string& fileName);

  /// Returns whether there is a file of this name, a path without a slash in front. Capitals count
  /// where there are two names that differ by them.
  bool has(const std::string& name) const;

  /// Hands on the bytes of a file, in parts. Throws Failure where there is none of that name.
  void read(const std::string& name, const std::function<void(std::string_view)>& take) const;

  /// Returns the bytes that all files say they have. A packed byte counts `most` at most.
  double unpackedBytes(double most) const;

  /// Throws Failure about the archive.
  [[noreturn]] void refuse(const std::string& what) const;

private:
  std::optional<std::uint64_t> find(const std::string& name) const;

  std::string fileName_;
  std::unique_ptr<zip, void (*)(zip*)> archive_;
  std::map<std::string, std::uint64_t> indices_; ///< by names as they are, and in small letters
};

/// Returns a path in an archive without a slash in front, detours, backslashes and percent codes.
std::string plainPath(const std::string& path);
