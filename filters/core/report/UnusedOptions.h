// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "field/Field.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace winding
{

/// The options that none of several sources has a use for: an option for one of them is right.
class UnusedOptions
{
public:
  /// Adds a source, which counts if it has primitives.
  void add(const FieldInfo& info)
  {
    if (info.primitives == 0)
    {
      return;
    }
    ++sources_;
    surfaces_ += info.isSurface ? 1 : 0;
    for (const UnusedOption& unused : info.unused)
    {
      Count& count = counts_[unused.option];
      ++count.sources;
      count.message = unused.message;
    }
  }

  /// Returns what to say once all sources are there. Surfaces have no use for normals.
  std::vector<Message> messages() const
  {
    std::vector<Message> found;
    for (const auto& [option, count] : counts_)
    {
      const std::size_t others = option == Parameter::estimateNormals ? surfaces_ : 0;
      if (count.sources + others == sources_)
      {
        found.push_back(count.message);
      }
    }
    return found;
  }

private:
  struct Count
  {
    std::size_t sources = 0;
    Message message;
  };

  std::size_t sources_ = 0, surfaces_ = 0;
  std::map<Parameter, Count> counts_;
};

} // namespace winding
