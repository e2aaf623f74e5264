#include "private/GatheredViews.h"

#include "base/Refusal.h"
#include "private/ContentHash.h"

#include <algorithm>
#include <limits>

namespace winding
{

namespace
{

void append(std::vector<double>& numbers, const VectorsView& vectors)
{
  for (std::size_t i = 0; i < vectors.size(); ++i)
  {
    const Eigen::Vector3d vector = vectors[i];
    numbers.insert(numbers.end(), vector.data(), vector.data() + 3);
  }
}

/// A hash of a part; 0 for an empty one.
template <class... T>
Ranks::Number hashOf(const std::vector<double>& positions, const std::vector<T>&... others)
{
  if (positions.empty())
  {
    return 0;
  }
  ContentHash hash;
  hash.addNumbers(positions);
  (hash.addNumbers(others), ...);
  return hash.value();
}

/// Whether all ranks have the same part, which is not empty.
bool areCopies(const std::vector<Ranks::Number>& hashes)
{
  return hashes.front() != 0 && areEqual(hashes);
}

/// The vectors of a rank.
VectorsView vectorsOf(const OfRanks<double>& numbers, int rank)
{
  return {numbers.begin(rank), numbers.count(rank) / 3};
}

} // namespace

bool GatheredViews::gather(
  Ranks& ranks, const std::vector<TrianglesView>& own, const Gathering& gathering)
{
  std::vector<double> positions;
  std::vector<int> ids;
  const std::vector<Ranks::Number> hashes = ranks.exchange(
    [&]
    {
      std::size_t points = 0;
      for (const TrianglesView& view : own)
      {
        points += view.points.size();
      }
      if (points > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      {
        throw Refusal("use more ranks: a rank has more than 2147483647 points");
      }
      positions.reserve(3 * points);
      for (const TrianglesView& view : own)
      {
        const auto first = static_cast<std::int64_t>(positions.size() / 3);
        const auto count = static_cast<std::int64_t>(view.points.size());
        append(positions, view.points);
        for (std::size_t i = 0; i < view.triangles.size(); ++i)
        {
          for (std::size_t corner = 0; corner < 3; ++corner)
          {
            // An id of no point must not become that of another part's.
            const std::int64_t id = view.triangles(i, corner);
            ids.push_back(id >= 0 && id < count ? static_cast<int>(first + id) : -1);
          }
        }
      }
      return hashOf(positions, ids);
    });
  if (gathering.findsCopies && areCopies(hashes))
  {
    return false;
  }
  positions_ = ranks.gathered(positions, gathering.onlyOnFirst);
  ids_ = ranks.gathered(ids, gathering.onlyOnFirst);
  if (gathering.onlyOnFirst && ranks.rank() > 0)
  {
    return false;
  }
  triangles_.clear();
  for (int rank = 0; rank < ranks.count(); ++rank)
  {
    triangles_.push_back(
      {vectorsOf(positions_, rank), TriangleIdsView(ids_.begin(rank), ids_.count(rank) / 3)});
  }
  return true;
}

bool GatheredViews::gather(
  Ranks& ranks, const std::vector<OrientedPointsView>& own, const Gathering& gathering)
{
  enum Lack : unsigned
  {
    normals = 1,
    areas = 2
  };
  std::vector<double> positions, ownNormals, ownAreas;
  unsigned lacks = 0;
  const std::vector<Ranks::Number> ofRanks = ranks.exchange(
    [&]
    {
      for (const OrientedPointsView& view : own)
      {
        append(positions, view.positions);
        append(ownNormals, view.normals);
        for (std::size_t i = 0; i < view.areas.size(); ++i)
        {
          ownAreas.push_back(view.areas[i]);
        }
      }
      lacks = (ownNormals.size() < positions.size() ? +normals : 0u) |
              (3 * ownAreas.size() < positions.size() ? +areas : 0u);
      return lacks;
    });
  for (const Ranks::Number ofRank : ofRanks)
  {
    lacks |= static_cast<unsigned>(ofRank);
  }
  const std::vector<Ranks::Number> hashes =
    ranks.exchange([&] { return hashOf(positions, ownNormals, ownAreas); });
  if (gathering.findsCopies && areCopies(hashes))
  {
    return false;
  }
  positions_ = ranks.gathered(positions, gathering.onlyOnFirst);
  ownNormals.resize(lacks & normals ? 0 : ownNormals.size());
  ownAreas.resize(lacks & areas ? 0 : ownAreas.size());
  normals_ = ranks.gathered(ownNormals, gathering.onlyOnFirst);
  areas_ = ranks.gathered(ownAreas, gathering.onlyOnFirst);
  if (gathering.onlyOnFirst && ranks.rank() > 0)
  {
    return false;
  }
  points_.clear();
  for (int rank = 0; rank < ranks.count(); ++rank)
  {
    OrientedPointsView view;
    view.positions = vectorsOf(positions_, rank);
    if (normals_.count(rank) > 0)
    {
      view.normals = vectorsOf(normals_, rank);
    }
    if (areas_.count(rank) > 0)
    {
      view.areas = ScalarsView(areas_.begin(rank), areas_.count(rank));
    }
    points_.push_back(view);
  }
  return true;
}

} // namespace winding
