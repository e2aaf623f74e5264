// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "diagnosis/ThinParts.h"
#include "field/Field.h"
#include "report/InputUnits.h"
#include "report/UnusedOptions.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace winding
{

/// A number of solids, and the first few of their names.
class NamedSolids
{
public:
  void add(const std::string& name)
  {
    constexpr std::size_t mostNames = 3;
    ++count_;
    if (count_ <= mostNames)
    {
      names_ += (names_.empty() ? "'" : ", '") + name + "'";
    }
    else if (count_ == mostNames + 1)
    {
      names_ += ", ...";
    }
  }

  std::size_t count() const { return count_; }

  /// "2 of 10 solids ('a', 'b')".
  std::string outOf(std::size_t solids) const
  {
    return std::to_string(count_) + " of " + std::to_string(solids) +
           (solids == 1 ? " solid (" : " solids (") + names_ + ")";
  }

private:
  std::size_t count_ = 0;
  std::string names_;
};

/// Facts about the solids of one execution.
struct LabelFacts
{
  FieldInfo source; ///< sums over all solids; method, reason and kind are the largest solid's
  std::size_t largest = 0;       ///< primitives of the solid that has most
  std::size_t expected = 0;      ///< number of all solids
  std::size_t solids = 0;        ///< number of those that were added
  NamedSolids empty;             ///< solids without primitives
  NamedSolids open;              ///< surfaces with net boundary edges
  NamedSolids openParts;         ///< others that are open inside of closed ones
  NamedSolids insideOut;         ///< those where w is negative and nothing is inside
  NamedSolids missed;            ///< those that the grid misses
  NamedSolids thin;              ///< others without a voxel inside, which do not look inward
  NamedSolids lostInPart;        ///< those with parts that are thinner than a voxel
  ThinParts largestLoss;         ///< of these, the one with the largest share
  NamedSolids partlyInsideOut;   ///< those where w is negative in part, and something is inside
  NamedSolids warned;            ///< those with a warning
  std::vector<Message> warnings; ///< of the first solid that has some
  std::vector<std::pair<Message, NamedSolids>> mends; ///< of the first solid, by what was done
  UnusedOptions unused;                               ///< for which no solid has a use
  std::vector<NamedBounds> bounds;                    ///< of all solids that were added

  void add(const FieldInfo& info, const std::string& name, bool isOpenPart)
  {
    ++solids;
    unused.add(info);
    bounds.push_back({name, info.bounds});
    if (solids == 1 || info.primitives > largest)
    {
      FieldInfo sums = info;
      addCounts(sums, source);
      source = sums;
      largest = info.primitives;
    }
    else
    {
      addCounts(source, info);
    }
    if (info.primitives == 0)
    {
      empty.add(name);
    }
    else if (info.isSurface && info.netBoundaryEdges > 0 &&
             info.added == 0) // sheets are to be open
    {
      (isOpenPart ? openParts : open).add(name);
    }
    if (!info.warnings.empty())
    {
      warnings = warned.count() == 0 ? info.warnings : warnings;
      warned.add(name);
    }
  }

  /// Adds a note that a solid was mended.
  void addMend(const Message& note, const std::string& name)
  {
    auto found = std::find_if(mends.begin(), mends.end(),
      [&note](const auto& mend) { return mend.first.fault == note.fault; });
    if (found == mends.end())
    {
      mends.emplace_back(note, NamedSolids());
      found = mends.end() - 1;
    }
    found->second.add(name);
  }

private:
  static void addCounts(FieldInfo& sums, const FieldInfo& more)
  {
    sums.inputPrimitives += more.inputPrimitives;
    sums.primitives += more.primitives;
    sums.distinct += more.distinct;
    sums.dropped += more.dropped;
    sums.weldedVertices += more.weldedVertices;
    sums.boundaryEdges += more.boundaryEdges;
    sums.netBoundaryEdges += more.netBoundaryEdges;
    sums.capTriangles += more.capTriangles;
    sums.bounds.extend(more.bounds);
  }
};

} // namespace winding
