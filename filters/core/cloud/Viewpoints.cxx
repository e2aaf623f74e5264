#include "cloud/Viewpoints.h"

#include "base/Progress.h"
#include "base/Refusal.h"
#include "cloud/NormalEstimation.h"
#include "cloud/SearchedPositions.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <locale>
#include <sstream>
#include <utility>

namespace winding
{

namespace
{

/// Numbers in a text, with blanks or commas between them; none where there is anything else.
std::vector<double> numbersIn(std::string text)
{
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream words(text);
  words.imbue(std::locale::classic());
  std::vector<double> numbers;
  double number = 0;
  while (words >> number)
  {
    numbers.push_back(number);
  }
  const bool isRight = words.eof() && std::all_of(numbers.begin(), numbers.end(),
                                        [](double value) { return std::isfinite(value); });
  return isRight ? numbers : std::vector<double>();
}

/// Returns the direction that a word stands for; 0 where it is none.
Eigen::Vector3d directionOf(const std::string& word)
{
  const std::pair<const char*, Eigen::Vector3d> words[] = {{"up", {0, 0, 1}}, {"down", {0, 0, -1}},
    {"+x", {1, 0, 0}}, {"-x", {-1, 0, 0}}, {"+y", {0, 1, 0}}, {"-y", {0, -1, 0}}, {"+z", {0, 0, 1}},
    {"-z", {0, 0, -1}}};
  const auto* const found = std::find_if(std::begin(words), std::end(words),
    [&word](const auto& candidate) { return candidate.first == word; });
  return found == std::end(words) ? Eigen::Vector3d(0, 0, 0) : found->second;
}

[[noreturn]] void refuse()
{
  Message message(Parameter::toward, "is no position and no direction");
  message.remedies = {{"give X Y Z, direction X Y Z, up or down", {}}};
  throw Refusal(std::move(message));
}

Eigen::Vector3d unitOrZero(const Eigen::Vector3d& vector)
{
  const double length = vector.stableNorm();
  return length > 0 && std::isfinite(length) ? Eigen::Vector3d(vector / length)
                                             : Eigen::Vector3d(0, 0, 0);
}

} // namespace

Viewpoints::Viewpoints(const std::string& text)
{
  const std::string blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string::npos)
  {
    return;
  }
  const std::string word = text.substr(first, text.find_last_not_of(blanks) + 1 - first);
  const std::string direction = "direction ";
  direction_ = directionOf(word);
  if (!direction_.isZero())
  {
    return;
  }
  if (word.rfind(direction, 0) == 0)
  {
    const std::vector<double> numbers = numbersIn(word.substr(direction.size()));
    direction_ = numbers.size() == 3 ? unitOrZero({numbers[0], numbers[1], numbers[2]})
                                     : Eigen::Vector3d(0, 0, 0);
    if (direction_.isZero())
    {
      refuse();
    }
    return;
  }
  std::istringstream positions(word);
  for (std::string position; std::getline(positions, position, ';');)
  {
    const std::vector<double> numbers = numbersIn(position);
    if (numbers.size() != 3)
    {
      refuse();
    }
    positions_.emplace_back(numbers[0], numbers[1], numbers[2]);
  }
}

std::string Viewpoints::textAlong(
  const Eigen::Matrix3d& inverseAxes, const Eigen::Vector3d& origin) const
{
  const auto textOf = [](const Eigen::Vector3d& vector)
  {
    char text[100];
    std::snprintf(text, sizeof text, "%.17g %.17g %.17g", vector[0], vector[1], vector[2]);
    return std::string(text);
  };
  if (!direction_.isZero())
  {
    return "direction " + textOf(inverseAxes * direction_);
  }
  std::string text;
  for (const Eigen::Vector3d& position : positions_)
  {
    text += (text.empty() ? "" : "; ") + textOf(inverseAxes * (position - origin));
  }
  return text;
}

std::vector<Eigen::Vector3d> Viewpoints::directionsFrom(
  const DistinctPoints& places, Executor& executor) const
{
  std::vector<Eigen::Vector3d> directions(places.size(), direction_);
  if (positions_.empty())
  {
    return directions;
  }
  // Sorted, so that their order makes no difference to places that are equally near to two.
  std::vector<Eigen::Vector3d> sorted;
  for (const Eigen::Vector3d& position : positions_)
  {
    sorted.emplace_back(position.unaryExpr(
      [&places](double coordinate) { return scaledCoordinate(coordinate, places.scale()); }));
  }
  std::sort(sorted.begin(), sorted.end(),
    [](const Eigen::Vector3d& a, const Eigen::Vector3d& b)
    { return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3); });
  const SearchedPositions searched = {sorted.data(), sorted.size()};
  const SearchedPositions::Tree tree(3, searched, nanoflann::KDTreeSingleIndexAdaptorParams(16));
  forEachItem(
    places.size(),
    [&](std::size_t i)
    {
      std::uint32_t nearest = 0;
      double square = 0;
      const Eigen::Vector3d& place = places.positions()[i];
      tree.knnSearch(place.data(), 1, &nearest, &square);
      directions[i] = unitOrZero(sorted[nearest] - place);
    },
    executor);
  return directions;
}

std::vector<Eigen::Vector3d> normalsToward(
  const Viewpoints& viewpoints, const DistinctPoints& places, int neighbors, Executor& executor)
{
  constexpr double grazing = 0.26; // the sine of 15°
  const std::vector<Eigen::Vector3d> directions = viewpoints.directionsFrom(places, executor);
  if (places.size() < 2)
  {
    std::vector<Eigen::Vector3d> normals = directions;
    for (Eigen::Vector3d& normal : normals)
    {
      normal = normal.isZero() ? Eigen::Vector3d(0, 0, 1) : normal;
    }
    return places.byPoint(normals);
  }
  Progress progress(executor);
  const auto count = static_cast<std::size_t>(std::max(neighbors, 3));
  progress.set(0, 0.5);
  const NeighborGraph graph(places, count, executor);
  progress.set(0.5, 0.6);
  std::vector<Eigen::Vector3d> normals = planeNormals(places, graph, count, executor);
  std::vector<double> clearness(places.size());
  for (std::size_t place = 0; place < places.size(); ++place)
  {
    const double toward = normals[place].dot(directions[place]);
    normals[place] *= toward < 0 ? -1 : 1;
    clearness[place] = std::abs(toward);
  }
  progress.set(0.6, 1);
  orientFrom(places, graph, clearness, grazing, normals, executor);
  return places.byPoint(normals);
}

} // namespace winding
