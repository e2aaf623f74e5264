#include "surface/RepeatedFaces.h"

#include "base/DisjointSets.h"

#include <algorithm>
#include <numeric>

namespace winding
{

namespace
{

/// The corners of all faces, each from its lowest on towards the lower one of its neighbours.
class Faces
{
public:
  Faces(const Surface& surface, const PolygonParts& parts)
  {
    const TriangleList& triangles = surface.triangles;
    for (std::size_t first = 0, last; first < triangles.size(); first = last)
    {
      last = first + 1;
      while (last < triangles.size() && last < parts.size() && parts[last])
      {
        ++last;
      }
      corners_.insert(corners_.end(), triangles[first].begin(), triangles[first].end());
      for (std::size_t i = first + 1; i < last; ++i)
      {
        // A fan goes on from the last corner, unless a triangle between them bounds nothing.
        if (corners_.back() != triangles[i][1])
        {
          corners_.push_back(triangles[i][1]);
        }
        corners_.push_back(triangles[i][2]);
      }
      isForward_.push_back(this->putInOrder(starts_.back()));
      starts_.push_back(corners_.size());
      firstTriangles_.push_back(first);
    }
    firstTriangles_.push_back(triangles.size());
  }

  std::size_t size() const { return isForward_.size(); }
  bool isForward(std::size_t face) const { return isForward_[face] != 0; }
  std::size_t firstTriangle(std::size_t face) const { return firstTriangles_[face]; }

  bool isLess(std::size_t a, std::size_t b) const
  {
    return std::lexicographical_compare(
      this->begin(a), this->begin(a + 1), this->begin(b), this->begin(b + 1));
  }

private:
  using Corner = std::vector<std::int32_t>::const_iterator;

  Corner begin(std::size_t face) const
  {
    return corners_.begin() + static_cast<std::ptrdiff_t>(starts_[face]);
  }

  /// Puts the corners from `start` on in order. Returns whether the face runs as they do.
  bool putInOrder(std::size_t start)
  {
    const auto first = corners_.begin() + static_cast<std::ptrdiff_t>(start);
    std::rotate(first, std::min_element(first, corners_.end()), corners_.end());
    const bool isForward = *(first + 1) <= corners_.back();
    if (!isForward)
    {
      std::reverse(first + 1, corners_.end());
    }
    return isForward;
  }

  std::vector<std::int32_t> corners_;
  std::vector<std::size_t> starts_ = {0};
  std::vector<std::size_t> firstTriangles_;
  std::vector<char> isForward_;
};

/// The uses of an edge by single faces, and by faces to leave out.
struct UsesOfEdge
{
  std::size_t single = 0;
  std::vector<std::int32_t> others; ///< triangles of faces that are there before

  void add(std::int32_t triangle, const RepeatedFaces& faces)
  {
    const FaceKind kind = faces.kinds[static_cast<std::size_t>(triangle)];
    single += kind == FaceKind::single;
    if (kind == FaceKind::opposite || kind == FaceKind::repeated)
    {
      others.push_back(triangle);
    }
  }
};

/// Calls visit(uses) for each edge of faces that are there before.
template <class Visit>
void forEachEdgeOfOthers(const SurfaceEdges& edges, const RepeatedFaces& faces, const Visit& visit)
{
  UsesOfEdge uses;
  const auto visitIfUsed = [&]
  {
    if (!uses.others.empty())
    {
      visit(uses);
    }
    uses = UsesOfEdge();
  };
  for (const SurfaceEdges::Pair& pair : edges.pairs)
  {
    uses.add(pair.triangles[0], faces);
    uses.add(pair.triangles[1], faces);
    visitIfUsed();
  }
  for (const SurfaceEdges::Crowd& crowd : edges.crowds)
  {
    for (const SurfaceEdges::Use* use = edges.begin(crowd); use != edges.end(crowd); ++use)
    {
      uses.add(use->triangle, faces);
    }
    visitIfUsed();
  }
}

} // namespace

RepeatedFaces repeatedFaces(const Surface& surface, const PolygonParts& parts)
{
  const Faces faces(surface, parts);
  std::vector<std::size_t> order(faces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
    [&faces](std::size_t a, std::size_t b) { return faces.isLess(a, b); });

  RepeatedFaces result;
  result.kinds.resize(surface.triangles.size(), FaceKind::single);
  const auto setKind = [&](std::size_t face, FaceKind kind)
  {
    std::fill(result.kinds.begin() + static_cast<std::ptrdiff_t>(faces.firstTriangle(face)),
      result.kinds.begin() + static_cast<std::ptrdiff_t>(faces.firstTriangle(face + 1)), kind);
  };
  for (std::size_t first = 0, last; first < order.size(); first = last)
  {
    std::size_t forward = 0;
    for (last = first; last < order.size() && !faces.isLess(order[first], order[last]); ++last)
    {
      forward += faces.isForward(order[last]);
    }
    const std::size_t count = last - first;
    if (count == 1)
    {
      ++result.single;
      continue;
    }
    const bool isPair = 2 * forward == count;
    const bool isForward = isPair ? faces.isForward(order[first]) : 2 * forward > count;
    bool isFirstThere = false, isOppositeThere = !isPair;
    for (std::size_t i = first; i < last; ++i)
    {
      bool& isThere = faces.isForward(order[i]) == isForward ? isFirstThere : isOppositeThere;
      const FaceKind kind = isThere                     ? FaceKind::repeated
                            : &isThere != &isFirstThere ? FaceKind::opposite
                            : isPair                    ? FaceKind::facing
                                                        : FaceKind::first;
      isThere = true;
      result.repeated += kind == FaceKind::repeated;
      setKind(order[i], kind);
    }
    result.pairs += isPair;
    result.single += !isPair;
  }
  return result;
}

std::vector<char> facesToLeaveOut(
  const Surface& surface, const SurfaceEdges& edges, const RepeatedFaces& faces)
{
  const std::size_t count = surface.triangles.size();
  DisjointSets sets(count);
  forEachEdgeOfOthers(edges, faces,
    [&sets](const UsesOfEdge& uses)
    {
      for (const std::int32_t triangle : uses.others)
      {
        if (uses.single == 0)
        {
          sets.unite(uses.others.front(), triangle);
        }
      }
    });
  std::vector<char> meetsOdd(count, 0), meetsEven(count, 0); // by the first triangle of a set
  forEachEdgeOfOthers(edges, faces,
    [&](const UsesOfEdge& uses)
    {
      for (const std::int32_t triangle : uses.others)
      {
        const std::int32_t set = sets.find(triangle);
        meetsOdd[set] |= static_cast<char>(uses.single % 2 == 1);
        meetsEven[set] |= static_cast<char>(uses.single > 0 && uses.single % 2 == 0);
      }
    });
  std::vector<char> isLeftOut(count, 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::int32_t set = sets.find(static_cast<std::int32_t>(i));
    const bool isThereBefore =
      faces.kinds[i] == FaceKind::repeated || faces.kinds[i] == FaceKind::opposite;
    isLeftOut[i] = isThereBefore && (meetsOdd[set] || !meetsEven[set]);
  }
  return isLeftOut;
}

void leaveOut(Surface& surface, const std::vector<char>& isLeftOut)
{
  if (isLeftOut.empty())
  {
    return;
  }
  constexpr std::int32_t unused = -1;
  std::vector<std::int32_t> numbers(surface.vertices.size(), unused);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    if (!isLeftOut[i])
    {
      surface.triangles[kept] = surface.triangles[i];
      for (const std::int32_t vertex : surface.triangles[kept])
      {
        numbers[vertex] = 0;
      }
      ++kept;
    }
  }
  surface.triangles.resize(kept);
  std::int32_t vertices = 0;
  surface.bounds = Bounds();
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    if (numbers[i] != unused)
    {
      numbers[i] = vertices++;
      surface.vertices[numbers[i]] = surface.vertices[i];
      surface.bounds.extend(surface.vertices[i]);
    }
  }
  surface.vertices.resize(vertices);
  for (Triangle& triangle : surface.triangles)
  {
    for (std::int32_t& vertex : triangle)
    {
      vertex = numbers[vertex];
    }
  }
}

} // namespace winding
