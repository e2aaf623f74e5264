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

/// The uses of an edge by faces of two kinds.
struct UsesOfEdge
{
  std::size_t counted = 0;
  std::vector<std::int32_t> listed; ///< triangles
};

/// Calls visit(uses) for each edge with listed faces. `add` puts a triangle into the uses.
template <class Add, class Visit>
void forEachEdgeOfListed(const SurfaceEdges& edges, const Add& add, const Visit& visit)
{
  UsesOfEdge uses;
  const auto visitIfUsed = [&]
  {
    if (!uses.listed.empty())
    {
      visit(uses);
    }
    uses = UsesOfEdge();
  };
  for (const SurfaceEdges::Rim& rim : edges.rims)
  {
    add(rim.triangle, uses);
    visitIfUsed();
  }
  for (const SurfaceEdges::Pair& pair : edges.pairs)
  {
    add(pair.triangles[0], uses);
    add(pair.triangles[1], uses);
    visitIfUsed();
  }
  for (const SurfaceEdges::Crowd& crowd : edges.crowds)
  {
    for (const SurfaceEdges::Use* use = edges.begin(crowd); use != edges.end(crowd); ++use)
    {
      add(use->triangle, uses);
    }
    visitIfUsed();
  }
}

/// Connected sets of listed faces, and how other faces meet their edges.
class ListedSets
{
public:
  /// Sets go on through edges that other faces meet only if `areOnePastOthers`.
  template <class Add>
  ListedSets(
    const SurfaceEdges& edges, std::size_t triangles, const Add& add, bool areOnePastOthers)
    : sets_(triangles)
    , meetsOdd_(triangles, 0)
    , meetsEven_(triangles, 0)
  {
    forEachEdgeOfListed(edges, add,
      [&](const UsesOfEdge& uses)
      {
        for (const std::int32_t triangle : uses.listed)
        {
          if (uses.counted == 0 || areOnePastOthers)
          {
            sets_.unite(uses.listed.front(), triangle);
          }
        }
      });
    forEachEdgeOfListed(edges, add,
      [&](const UsesOfEdge& uses)
      {
        for (const std::int32_t triangle : uses.listed)
        {
          const std::int32_t set = sets_.find(triangle);
          meetsOdd_[set] |= static_cast<char>(uses.counted % 2 == 1);
          meetsEven_[set] |= static_cast<char>(uses.counted > 0 && uses.counted % 2 == 0);
        }
      });
  }

  /// Returns whether a triangle is of a wall: even numbers of other faces meet the set's edges.
  bool isOfWall(std::size_t triangle)
  {
    const std::int32_t set = sets_.find(static_cast<std::int32_t>(triangle));
    return meetsEven_[set] && !meetsOdd_[set];
  }

private:
  DisjointSets sets_;
  std::vector<char> meetsOdd_, meetsEven_; ///< by the first triangle of a set
};

/// Leaves out walls where solids that were drawn from both sides touch others.
void leaveOutWalls(
  const SurfaceEdges& edges, const RepeatedFaces& faces, std::vector<char>& isLeftOut)
{
  if (std::find(faces.isOfMany.begin(), faces.isOfMany.end(), 1) == faces.isOfMany.end())
  {
    return;
  }
  const auto add = [&](std::int32_t triangle, UsesOfEdge& uses)
  {
    if (!isLeftOut[triangle] && faces.isOfMany[triangle])
    {
      uses.listed.push_back(triangle);
    }
    else
    {
      uses.counted += !isLeftOut[triangle];
    }
  };
  ListedSets kept(edges, isLeftOut.size(), add, true);
  for (std::size_t i = 0; i < isLeftOut.size(); ++i)
  {
    isLeftOut[i] |= static_cast<char>(faces.isOfMany[i] && kept.isOfWall(i));
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
  result.isOfMany.resize(surface.triangles.size(), 0);
  const auto fill = [&faces](auto& ofTriangles, std::size_t face, auto value)
  {
    std::fill(ofTriangles.begin() + static_cast<std::ptrdiff_t>(faces.firstTriangle(face)),
      ofTriangles.begin() + static_cast<std::ptrdiff_t>(faces.firstTriangle(face + 1)), value);
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
      fill(result.kinds, order[i], kind);
      fill(result.isOfMany, order[i], static_cast<char>(count > 2));
    }
    result.pairs += isPair;
    result.single += !isPair;
  }
  return result;
}

std::vector<char> facesToLeaveOut(
  const Surface& surface, const SurfaceEdges& edges, const RepeatedFaces& faces)
{
  const auto isThereBefore = [&faces](std::size_t triangle)
  {
    const FaceKind kind = faces.kinds[triangle];
    return kind == FaceKind::repeated || kind == FaceKind::opposite;
  };
  const auto add = [&](std::int32_t triangle, UsesOfEdge& uses)
  {
    uses.counted += faces.kinds[triangle] == FaceKind::single;
    if (isThereBefore(static_cast<std::size_t>(triangle)))
    {
      uses.listed.push_back(triangle);
    }
  };
  const std::size_t count = surface.triangles.size();
  ListedSets others(edges, count, add, false);
  std::vector<char> isLeftOut(count, 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    isLeftOut[i] = isThereBefore(i) && !others.isOfWall(i);
  }
  leaveOutWalls(edges, faces, isLeftOut);
  return isLeftOut;
}

SurfacePart::SurfacePart(const Surface& surface, const std::vector<char>& isChosen, bool choice)
{
  chain.vertices = surface.vertices;
  chain.bounds = surface.bounds;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    if ((isChosen[i] != 0) == choice)
    {
      chain.triangles.push_back(surface.triangles[i]);
      numbers.push_back(i);
    }
  }
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
