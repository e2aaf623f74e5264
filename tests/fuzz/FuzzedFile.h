// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace fuzz
{

/// A file in memory, if there is a file system there, whose content is that of the case at hand. It
/// goes away with this object.
class FuzzedFile
{
public:
  explicit FuzzedFile(const std::string& suffix);
  ~FuzzedFile();
  FuzzedFile(const FuzzedFile&) = delete;
  void operator=(const FuzzedFile&) = delete;

  void write(const std::uint8_t* data, std::size_t size) const;
  const std::string& name() const { return name_; }

private:
  std::string name_;
};

} // namespace fuzz
