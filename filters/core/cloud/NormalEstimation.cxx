#include "cloud/NormalEstimation.h"

#include "base/Bounds.h"
#include "cloud/NeighborSearch.h"
#include "source/UnitScale.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

namespace winding
{

namespace
{

/// The nearest other places of each place: `most` of them, or all if there are fewer.
class NeighborGraph
{
public:
  NeighborGraph(std::size_t places, std::size_t most)
    : most_(std::min(most, places - 1))
    , neighbors_(places * most_)
  {
  }

  void set(std::size_t place, const std::vector<Neighbor>& neighbors)
  {
    std::transform(neighbors.begin(), neighbors.begin() + static_cast<std::ptrdiff_t>(most_),
      neighbors_.begin() + static_cast<std::ptrdiff_t>(place * most_),
      [](const Neighbor& neighbor) { return neighbor.place; });
  }

  const std::uint32_t* begin(std::size_t place) const { return neighbors_.data() + place * most_; }
  const std::uint32_t* end(std::size_t place) const { return this->begin(place) + most_; }

private:
  std::size_t most_;
  std::vector<std::uint32_t> neighbors_;
};

/// The direction in which a place and its neighbours spread least.
Eigen::Vector3d normalOf(
  const DistinctPoints& places, std::size_t place, const std::vector<Neighbor>& neighbors)
{
  // Offsets are taken in units of the neighbourhood's size, so that squares stay within range.
  const Eigen::Vector3d center = places.positions()[place];
  double size = 0;
  for (const Neighbor& neighbor : neighbors)
  {
    size = std::max(size, (places.positions()[neighbor.place] - center).cwiseAbs().maxCoeff());
  }
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (const Neighbor& neighbor : neighbors)
  {
    const Eigen::Vector3d offset = (places.positions()[neighbor.place] - center) / size;
    sum += offset;
    squares += offset * offset.transpose();
  }
  const double count = static_cast<double>(neighbors.size() + 1);
  squares -= sum * sum.transpose() / count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(squares);
  const Eigen::Vector3d normal = spread.eigenvectors().col(0).normalized();
  return normal.allFinite() ? normal : Eigen::Vector3d(0, 0, 1);
}

/// A step along the graph; the most certain step is the greatest.
struct Step
{
  float doubt;
  std::uint32_t from, to;

  bool operator<(const Step& other) const
  {
    return std::tie(doubt, from, to) > std::tie(other.doubt, other.from, other.to);
  }
};

/// Finds, for each place, the places that it is a neighbour of but that are none of its own
/// neighbours. They make neighbourhood mutual: a far place may be no other's neighbour, though it
/// has neighbours itself.
std::vector<std::vector<std::uint32_t>> mutual(const NeighborGraph& graph, std::size_t places)
{
  std::vector<std::vector<std::uint32_t>> back(places);
  for (std::size_t place = 0; place < places; ++place)
  {
    for (const std::uint32_t* other = graph.begin(place); other != graph.end(place); ++other)
    {
      if (std::find(graph.begin(*other), graph.end(*other), place) == graph.end(*other))
      {
        back[*other].push_back(static_cast<std::uint32_t>(place));
      }
    }
  }
  return back;
}

void orient(
  const DistinctPoints& places, const NeighborGraph& graph, std::vector<Eigen::Vector3d>& normals)
{
  const auto back = mutual(graph, places.size());
  // Starts go from the top down, so that a piece begins at its highest place.
  std::vector<std::uint32_t> starts(places.size());
  for (std::size_t i = 0; i < starts.size(); ++i)
  {
    starts[i] = static_cast<std::uint32_t>(i);
  }
  std::sort(starts.begin(), starts.end(),
    [&](std::uint32_t a, std::uint32_t b)
    {
      const double za = places.positions()[a][2], zb = places.positions()[b][2];
      return za > zb || (za == zb && a < b);
    });
  std::vector<unsigned char> isDone(places.size());
  std::priority_queue<Step> steps;
  const auto finish = [&](std::uint32_t place)
  {
    isDone[place] = 1;
    const auto add = [&](std::uint32_t other)
    {
      if (!isDone[other])
      {
        // A place that lies along the normals rather than across them belongs to another sheet.
        const Eigen::Vector3d along =
          (places.positions()[other] - places.positions()[place]).normalized();
        const double cosine = std::abs(normals[place].dot(normals[other]));
        const double climb =
          std::abs(normals[place].dot(along)) + std::abs(normals[other].dot(along));
        steps.push({static_cast<float>(1 - cosine + climb / 2), place, other});
      }
    };
    std::for_each(graph.begin(place), graph.end(place), add);
    std::for_each(back[place].begin(), back[place].end(), add);
  };
  for (const std::uint32_t start : starts)
  {
    if (isDone[start])
    {
      continue;
    }
    normals[start] *= normals[start][2] < 0 ? -1 : 1;
    finish(start);
    while (!steps.empty())
    {
      const Step step = steps.top();
      steps.pop();
      if (!isDone[step.to])
      {
        normals[step.to] *= normals[step.from].dot(normals[step.to]) < 0 ? -1 : 1;
        finish(step.to);
      }
    }
  }
}

} // namespace

std::vector<Eigen::Vector3d> estimateNormals(
  const std::vector<Eigen::Vector3d>& positions, int neighbors, Executor& executor)
{
  Bounds bounds;
  for (const Eigen::Vector3d& position : positions)
  {
    bounds.extend(position);
  }
  const DistinctPoints places(positions, unitScale(bounds), executor);
  std::vector<Eigen::Vector3d> ofPlaces(places.size(), Eigen::Vector3d(0, 0, 1));
  if (places.size() > 1)
  {
    // Steps go to the nearest neighbours only: farther ones help to find the plane, but are not
    // next to a place.
    constexpr std::size_t mostSteps = 10, placesPerBlock = 512;
    const NeighborSearch search(places);
    const auto count = static_cast<std::size_t>(std::max(neighbors, 3));
    NeighborGraph graph(places.size(), std::min(mostSteps, count));
    runBlocks(
      places.size(), placesPerBlock,
      [&](std::size_t, std::size_t first, std::size_t last)
      {
        std::vector<Neighbor> found;
        NeighborSearch::Last lastSearch;
        for (std::size_t place = first; place < last; ++place)
        {
          search.find(place, count, found, lastSearch);
          ofPlaces[place] = normalOf(places, place, found);
          graph.set(place, found);
        }
      },
      executor);
    orient(places, graph, ofPlaces);
  }
  std::vector<Eigen::Vector3d> normals(positions.size());
  for (std::size_t place = 0; place < places.size(); ++place)
  {
    for (const std::uint32_t* point = places.begin(place); point != places.end(place); ++point)
    {
      normals[*point] = ofPlaces[place];
    }
  }
  return normals;
}

} // namespace winding
