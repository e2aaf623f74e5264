// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/DisjointSets.h"
#include "cloud/NeighborGraph.h"

#include <cstdint>
#include <vector>

namespace winding
{

/**
 * Patches of a cloud whose normals agree among themselves beyond doubt: places that steps of little
 * doubt join. They grow as more doubt is allowed. The result does not depend on the executor.
 */
class NormalPatches
{
public:
  /// The normals may have any sense. Takes about 100 bytes per place. Throws Interrupted.
  NormalPatches(const DistinctPoints& places, const NeighborGraph& graph,
    const std::vector<Eigen::Vector3d>& normals, Executor& executor);

  /// Joins all places that steps of up to `doubt` lead to.
  void grow(float doubt);

  /// The largest patches of now, down to some places and up to some patches, and in order of size:
  /// the places of each, from starts[p] up to, without, starts[p + 1] in `places`.
  struct Largest
  {
    std::vector<std::uint32_t> places;
    std::vector<std::size_t> starts;

    std::size_t count() const { return starts.size() - 1; }
  };
  Largest largest(std::size_t fewestPlaces, std::size_t mostPatches) const;

  /// Whether each place has to be turned for the normals of its patch to agree with the normal of
  /// the patch's first place.
  std::vector<unsigned char> areOpposite() const;

  /// The patches that all places follow: their own, or the one that the steps of least doubt lead
  /// to. Places that no step joins to any patch follow one more, which has the last number.
  struct Followers
  {
    std::vector<std::uint32_t> patchOf;     ///< by place
    std::vector<unsigned char> areOpposite; ///< whether to turn a place to agree with its patch
  };
  Followers followersOf(const Largest& patches) const;

  /// Hands senses on to all places from the patches that they follow. isTurned: for the places of
  /// these patches, whether their normals are to be turned. Other places' entries are set.
  void propagate(const Largest& patches, std::vector<unsigned char>& isTurned) const;

  /// A step and whether its normals have opposite senses. Both ends are neighbours of each other
  /// mostly, and have one link then.
  struct Link
  {
    float doubt;
    std::uint32_t from;
    std::uint32_t to : 31;
    std::uint32_t areOpposite : 1;
  };

  /// All steps, in order of their doubt.
  const std::vector<Link>& links() const { return links_; }

private:
  std::vector<Link> links_;
  std::size_t joined_ = 0;  ///< links that have been looked at
  mutable SensedSets sets_; ///< finding a set shortens the way to it for the next time
  std::size_t places_;
};

} // namespace winding
