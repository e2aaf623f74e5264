// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/Slits.h"

#include "base/UninitializedVector.h"
#include "source/CompareCoordinates.h"
#include "source/SourceTree.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numeric>
#include <utility>

namespace winding
{

namespace
{

using Eigen::Vector3d;

/// An edge as its triangle runs along it, in scaled coordinates.
struct DirectedEdge
{
  Vector3d from, to;

  Vector3d direction() const { return to - from; }
};

/// The dot product, with the sum in a fixed order: if no factor falls, the result does not either.
double dot(const Vector3d& a, const Vector3d& b)
{
  return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}

/// Returns the squared distance of a point from an edge. The nearer end is where offsets are taken
/// from, so that distances far below the edge's length keep their digits.
double squaredDistance(const DirectedEdge& edge, const Vector3d& point)
{
  const Vector3d toFrom = edge.from - point, toTo = edge.to - point;
  const Vector3d direction = edge.direction();
  const double length = direction.squaredNorm();
  const double along = -dot(toFrom, direction), back = dot(toTo, direction);
  if (along <= 0)
  {
    return toFrom.squaredNorm();
  }
  if (back <= 0)
  {
    return toTo.squaredNorm();
  }
  return along < back ? (toFrom + along / length * direction).squaredNorm()
                      : (toTo - back / length * direction).squaredNorm();
}

/// The squared distance of a point from an opposite edge, and the larger squared distance between
/// ends of the edge that the point is on and ends of the other.
struct Opposite
{
  double squared = std::numeric_limits<double>::infinity();
  double squaredOfEnds = std::numeric_limits<double>::infinity();

  bool operator<(const Opposite& other) const
  {
    return squared != other.squared ? squared < other.squared : squaredOfEnds < other.squaredOfEnds;
  }
};

/// The numbers of the boundary edges that meet in a vertex.
struct IncidentEdges
{
  const std::uint32_t *begin, *end;
};

/// The boundary edges that meet in each vertex.
class EdgesOfVertices
{
public:
  EdgesOfVertices(const std::vector<SurfaceEdges::Rim>& rims, std::size_t vertices)
    : starts_(vertices + 2)
    , edges_(2 * rims.size())
  {
    for (const SurfaceEdges::Rim& rim : rims)
    {
      ++starts_[static_cast<std::size_t>(rim.low) + 2];
      ++starts_[static_cast<std::size_t>(rim.high) + 2];
    }
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    for (std::size_t i = 0; i < rims.size(); ++i)
    {
      edges_[starts_[static_cast<std::size_t>(rims[i].low) + 1]++] = static_cast<std::uint32_t>(i);
      edges_[starts_[static_cast<std::size_t>(rims[i].high) + 1]++] = static_cast<std::uint32_t>(i);
    }
  }

  IncidentEdges operator[](std::int32_t vertex) const
  {
    const std::size_t* starts = starts_.data() + vertex;
    return {edges_.data() + starts[0], edges_.data() + starts[1]};
  }

private:
  std::vector<std::size_t> starts_;
  std::vector<std::uint32_t> edges_;
};

/// A part of an edge, from a share of its length to another.
struct Piece
{
  std::uint32_t edge;
  float first, last;
};

/// Cuts edges that are longer than the median times 1.3 into pieces of equal length: boxes around
/// long edges overlap, and a point would lie in very many of them. There are at most four times as
/// many pieces as edges.
std::vector<Piece> piecesOf(const std::vector<DirectedEdge>& edges)
{
  constexpr double unitsPerSize = 4'294'967'296.0; // integers have the same sum in any order
  std::uint64_t sum = 0;
  std::vector<double> lengths;
  lengths.reserve(edges.size());
  for (const DirectedEdge& edge : edges)
  {
    lengths.push_back(edge.direction().norm());
    sum += static_cast<std::uint64_t>(std::ceil(unitsPerSize * lengths.back()));
  }
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  const double median = edges.empty() ? 0 : *middle;
  const double most = std::max(1.3 * median,
    static_cast<double>(sum) / unitsPerSize / (3 * static_cast<double>(edges.size())));
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const double share = std::max(1.0, std::ceil(edges[i].direction().norm() / most));
    const auto count = static_cast<std::uint32_t>(share);
    for (std::uint32_t n = 0; n < count; ++n)
    {
      pieces.push_back(
        {static_cast<std::uint32_t>(i), static_cast<float>(n) / static_cast<float>(count),
          static_cast<float>(n + 1) / static_cast<float>(count)});
    }
  }
  return pieces;
}

/// Edges in a hierarchy of boxes around their pieces and around their directions.
class OppositeEdges
{
public:
  OppositeEdges(std::vector<DirectedEdge> edges, Executor& executor)
    : edges_(std::move(edges))
  {
    const std::vector<Piece> pieces = piecesOf(edges_);
    const auto placeOn = [this](const Piece& piece, float share) -> Vector3d
    {
      const DirectedEdge& edge = edges_[piece.edge];
      return share == 1 ? edge.to : Vector3d(edge.from + share * edge.direction());
    };
    std::vector<Vector3d> middles(pieces.size());
    forEachItem(
      pieces.size(),
      [&](std::size_t i)
      { middles[i] = placeOn(pieces[i], (pieces[i].first + pieces[i].last) / 2); },
      executor);
    tree_.emplace(middles, piecesPerLeaf, executor,
      [&](std::uint32_t a, std::uint32_t b)
      {
        const DirectedEdge &edge = edges_[pieces[a].edge], &other = edges_[pieces[b].edge];
        const int order = compareCoordinates(edge.from, other.from);
        return order != 0 ? order < 0 : compareCoordinates(edge.to, other.to) < 0;
      });
    const std::vector<SourceNode>& nodes = tree_->nodes();
    boxes_.resize(nodes.size());
    ofPieces_.resize(pieces.size());
    for (std::size_t n = boxes_.size(); n-- > 0;) // children stand behind their parents
    {
      const SourceNode& node = nodes[n];
      for (std::uint32_t i = 0; i < node.children; ++i)
      {
        boxes_[n].places.extend(boxes_[node.firstChild + i].places);
        boxes_[n].directions.extend(boxes_[node.firstChild + i].directions);
      }
      for (std::uint32_t i = node.begin; node.children == 0 && i < node.end; ++i)
      {
        const Piece& piece = pieces[tree_->order()[i]];
        ofPieces_[i] = edges_[piece.edge];
        if (piece.first == 0)
        {
          order_.push_back(piece.edge);
        }
        boxes_[n].places.extend(placeOn(piece, piece.first)).extend(placeOn(piece, piece.last));
        boxes_[n].directions.extend(edges_[piece.edge].direction());
      }
    }
    rounding_ = boxes_.empty()
                  ? 0
                  : 8 * std::numeric_limits<double>::epsilon() * boxes_[0].places.sizes().norm();
  }

  const DirectedEdge& operator[](std::size_t number) const { return edges_[number]; }

  /// The numbers of all edges, in an order in which those that follow each other are mostly near.
  const std::vector<std::uint32_t>& order() const { return order_; }

  /// Returns the opposite of an edge that is nearest to one of its points, after `mostLooks` at
  /// boxes and pieces at most. It looks first among the `likely` ones, unless these are many, for a
  /// limit to the others, and no further once the squared distance is at most `enough`.
  Opposite nearest(const DirectedEdge& edge, const Vector3d& point,
    std::initializer_list<IncidentEdges> likely, double enough) const
  {
    Query query = {edge, edge.direction(), point, enough};
    constexpr std::ptrdiff_t many = 16;
    for (const IncidentEdges& edges : likely)
    {
      const bool areFew = edges.end - edges.begin <= many;
      for (const std::uint32_t* other = edges.begin; areFew && other != edges.end; ++other)
      {
        this->compare(query, edges_[*other]);
      }
    }
    if (!boxes_.empty())
    {
      this->look(query, 0);
    }
    return query.found;
  }

private:
  /// Leaves of 4 and 8 pieces are as fast, and 8 make half as many nodes.
  static constexpr std::size_t piecesPerLeaf = 8;

  /// Where more boxes and pieces of edges are about as near as the nearest, they are a tangle
  /// without slits. On scans, CAD and fractures a search looks at 189 of them at most.
  static constexpr std::size_t mostLooks = 500;

  struct Boxes
  {
    Bounds places, directions;
  };

  struct Query
  {
    const DirectedEdge& edge;
    const Vector3d direction;
    const Vector3d point;
    const double enough;
    std::size_t left = mostLooks; ///< boxes and pieces that it may still look at
    Opposite found = {};
    double limit =
      std::numeric_limits<double>::infinity(); ///< squared, beyond which nothing counts
  };

  /// Whether an edge in a node may run opposite to a direction.
  bool mayOppose(std::uint32_t node, const Vector3d& direction) const
  {
    const Bounds& directions = boxes_[node].directions;
    return dot((direction.array() < 0).select(directions.max(), directions.min()), direction) < 0;
  }

  double squaredFrom(std::uint32_t node, const Vector3d& point) const
  {
    const Bounds& box = boxes_[node].places;
    return (box.min() - point).cwiseMax(point - box.max()).cwiseMax(0).squaredNorm();
  }

  void look(Query& query, std::uint32_t number) const
  {
    if (query.found.squared <= query.enough || query.left == 0)
    {
      return;
    }
    --query.left;
    const SourceNode& node = tree_->nodes()[number];
    if (node.children == 0)
    {
      for (std::uint32_t i = node.begin; i < node.end && query.left > 0; ++i, --query.left)
      {
        this->compare(query, ofPieces_[i]);
      }
      return;
    }
    // The child with the nearest box comes first, since it lowers the limit for the others.
    std::pair<double, std::uint32_t> children[4];
    std::size_t count = 0;
    for (std::uint32_t child = node.firstChild; child < node.firstChild + node.children; ++child)
    {
      const double squared = this->squaredFrom(child, query.point);
      if (squared <= query.limit && this->mayOppose(child, query.direction))
      {
        std::size_t place = count++;
        for (; place > 0 && squared < children[place - 1].first; --place)
        {
          children[place] = children[place - 1];
        }
        children[place] = {squared, child};
      }
    }
    for (std::size_t i = 0; i < count && children[i].first <= query.limit; ++i)
    {
      this->look(query, children[i].second);
    }
  }

  void compare(Query& query, const DirectedEdge& edge) const
  {
    if (dot(edge.direction(), query.direction) >= 0)
    {
      return;
    }
    const Opposite other = {
      squaredDistance(edge, query.point), std::max((edge.to - query.edge.from).squaredNorm(),
                                            (edge.from - query.edge.to).squaredNorm())};
    if (other < query.found)
    {
      // An edge just beyond the limit may be computed to be nearer.
      const double limit = std::sqrt(other.squared) + rounding_;
      query.found = other;
      query.limit = limit * limit;
    }
  }

  std::vector<DirectedEdge> edges_;
  std::optional<SourceTree> tree_; ///< of pieces
  std::vector<DirectedEdge>
    ofPieces_; ///< edges of pieces, in the tree's order: leaves lie together
  std::vector<std::uint32_t> order_;
  std::vector<Boxes> boxes_;
  double rounding_ = 0; ///< no distance is rounded by more
};

/// Returns whether a triangle runs along an edge of it from `from` to `to`.
bool runsAlong(const Triangle& triangle, std::int32_t from, std::int32_t to)
{
  return (triangle[0] == from && triangle[1] == to) || (triangle[1] == from && triangle[2] == to) ||
         (triangle[2] == from && triangle[0] == to);
}

/// Edges as their triangles run along them, with the vertices at their ends.
struct DirectedRims
{
  std::vector<DirectedEdge> edges;
  std::vector<std::array<std::int32_t, 2>> ends;
};

DirectedRims directedRims(const Surface& surface, const SurfaceEdges& edges, double scale)
{
  DirectedRims result;
  result.edges.reserve(edges.rims.size());
  result.ends.reserve(edges.rims.size());
  for (const SurfaceEdges::Rim& rim : edges.rims)
  {
    const bool rises = runsAlong(surface.triangles[rim.triangle], rim.low, rim.high);
    const std::int32_t from = rises ? rim.low : rim.high, to = rises ? rim.high : rim.low;
    result.edges.push_back({scale * surface.vertices[from], scale * surface.vertices[to]});
    result.ends.push_back({from, to});
  }
  return result;
}

} // namespace

std::optional<double> Slits::widest() const
{
  return widths.empty() ? std::nullopt
                        : std::optional<double>(*std::max_element(widths.begin(), widths.end()));
}

Slits slitsOf(const Surface& surface, const SurfaceEdges& edges, Executor& executor)
{
  const double scale = unitScale(surface.bounds);
  DirectedRims directed = directedRims(surface, edges, scale);
  const EdgesOfVertices atVertices(edges.rims, surface.vertices.size());
  const OppositeEdges rims(std::move(directed.edges), executor);
  const double diagonal = surface.bounds.isEmpty() ? 0 : (scale * surface.bounds.sizes()).norm();
  const auto lengthOf = [&](double squared)
  {
    return std::min(std::sqrt(squared), diagonal) / scale;
  };
  Slits slits;
  slits.widths.resize(edges.rims.size());
  slits.endDistances.resize(edges.rims.size());
  constexpr std::size_t edgesPerBlock = 1024;
  runBlocks(
    edges.rims.size(), edgesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t place = first; place < last; ++place)
      {
        const std::uint32_t i = rims.order()[place];
        const DirectedEdge& edge = rims[i];
        const IncidentEdges atFrom = atVertices[directed.ends[i][0]],
                            atTo = atVertices[directed.ends[i][1]];
        const Opposite middle = rims.nearest(edge, (edge.from + edge.to) / 2, {atFrom, atTo}, -1);
        double squared = middle.squared;
        squared = std::max(squared, rims.nearest(edge, edge.from, {atFrom}, squared).squared);
        squared = std::max(squared, rims.nearest(edge, edge.to, {atTo}, squared).squared);
        slits.widths[i] = lengthOf(squared);
        slits.endDistances[i] = lengthOf(middle.squaredOfEnds);
      }
    },
    executor);
  return slits;
}

std::optional<double> widestAlong(
  const BoundaryLoop& loop, const SurfaceEdges& edges, const Slits& slits)
{
  std::optional<double> widest;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const std::pair<std::int32_t, std::int32_t> edge =
      std::minmax(loop[i], loop[(i + 1) % loop.size()]);
    const auto found = std::lower_bound(edges.rims.begin(), edges.rims.end(), edge,
      [](const SurfaceEdges::Rim& rim, const std::pair<std::int32_t, std::int32_t>& other)
      { return std::make_pair(rim.low, rim.high) < other; });
    if (found != edges.rims.end() && found->low == edge.first && found->high == edge.second)
    {
      const double width = slits.widths[static_cast<std::size_t>(found - edges.rims.begin())];
      widest = std::max(widest.value_or(width), width);
    }
  }
  return widest;
}

double medianEdgeLength(const Surface& surface, const SurfaceEdges& edges, Executor& executor)
{
  if (edges.size() == 0)
  {
    return 0;
  }
  const double scale = unitScale(surface.bounds);
  UninitializedVector<double> squared(edges.size());
  const auto measure = [&](const auto& list, std::size_t start)
  {
    forEachItem(
      list.size(),
      [&, start](std::size_t i)
      {
        squared[start + i] =
          (scale * surface.vertices[list[i].high] - scale * surface.vertices[list[i].low])
            .squaredNorm();
      },
      executor);
  };
  measure(edges.rims, 0);
  measure(edges.pairs, edges.rims.size());
  measure(edges.crowds, edges.rims.size() + edges.pairs.size());
  const auto middle = squared.begin() + static_cast<std::ptrdiff_t>(squared.size() / 2);
  std::nth_element(squared.begin(), middle, squared.end());
  return std::sqrt(*middle) / scale;
}

} // namespace winding
