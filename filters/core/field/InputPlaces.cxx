// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "field/InputPlaces.h"

#include "distance/GridDistances.h"
#include "distance/SampleDistances.h"
#include "source/PointCloud.h"
#include "source/Sanitize.h"
#include "source/Surface.h"
#include "source/UnitScale.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace winding
{

namespace
{

std::size_t sizeOf(const TrianglesView& view)
{
  return view.triangles.size();
}

std::size_t sizeOf(const OrientedPointsView& view)
{
  return view.positions.size();
}

Eigen::Vector3d cornerOf(const TrianglesView& view, std::size_t triangle, std::size_t corner)
{
  return view.points[static_cast<std::size_t>(view.triangles(triangle, corner))];
}

} // namespace

std::array<double, 3> weightsOfNearest(const Eigen::Vector3d& sample, const Eigen::Vector3d& a,
  const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  // The nearest of four points is taken, as in NearestKernels.h, so that no small number decides.
  std::array<double, 3> best = {1, 0, 0};
  double least = (sample - a).squaredNorm();
  const auto take = [&](const std::array<double, 3>& weights)
  {
    const Eigen::Vector3d point = weights[0] * a + (weights[1] * b + weights[2] * c);
    const double squared = (sample - point).squaredNorm();
    if (squared < least)
    {
      least = squared;
      best = weights;
    }
  };
  const auto along = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to)
  {
    const Eigen::Vector3d side = to - from;
    const double length = side.squaredNorm();
    return length > 0 ? std::clamp((sample - from).dot(side) / length, 0.0, 1.0) : 0;
  };
  const double ab = along(a, b), ac = along(a, c), bc = along(b, c);
  take({1 - ab, ab, 0});
  take({1 - ac, 0, ac});
  take({0, 1 - bc, bc});
  const Eigen::Vector3d sideB = b - a, sideC = c - a, normal = sideB.cross(sideC);
  const double area = normal.squaredNorm();
  if (area > 0)
  {
    const Eigen::Vector3d offset = sample - a;
    const double v = offset.cross(sideC).dot(normal) / area;
    const double w = sideB.cross(offset).dot(normal) / area;
    if (v >= 0 && w >= 0 && v + w <= 1)
    {
      take({1 - v - w, v, w});
    }
  }
  return best;
}

InputPlaces::InputPlaces(
  const std::vector<TrianglesView>& views, const std::string& mirror, Executor& executor)
  : triangles_(views)
  , tree_(
      [&]
      {
        const Surface surface = sanitize(views, executor);
        planes_ = Mirror(mirror).planesFor(surface.bounds);
        this->numberUsable(views, surface.triangles.size());
        return DistanceTree(surface, executor);
      }())
  , numbers_(tree_)
{
}

InputPlaces::InputPlaces(
  const std::vector<OrientedPointsView>& views, const std::string& mirror, Executor& executor)
  : tree_(
      [&]
      {
        const PointCloud cloud = sanitize(views, executor);
        planes_ = Mirror(mirror).planesFor(cloud.bounds);
        this->numberUsable(views, cloud.positions.size());
        return DistanceTree(cloud, executor);
      }())
  , numbers_(tree_)
{
}

/// Gives the usable primitives of views the numbers that they have in a clean source.
template <class View>
void InputPlaces::numberUsable(const std::vector<View>& views, std::size_t usable)
{
  std::size_t all = 0;
  for (const View& view : views)
  {
    all += sizeOf(view);
  }
  std::size_t number = 0;
  for (const View& view : views)
  {
    starts_.push_back(number);
    if (all == usable)
    {
      number += sizeOf(view);
      continue;
    }
    for (std::size_t i = 0; i < sizeOf(view); ++i)
    {
      if (isUsable(view, i))
      {
        primitives_.push_back(static_cast<std::uint32_t>(i));
        ++number;
      }
    }
  }
}

std::size_t InputPlaces::bytesFor(bool areTriangles, std::size_t primitives)
{
  // The clean source is there until the tree is made.
  constexpr std::size_t perTriangle = 40, perPoint = 56, perNode = 4;
  return DistanceTree::bytesFor(areTriangles, primitives) +
         ((areTriangles ? perTriangle : perPoint) + perNode) * primitives;
}

/// Returns the place on the primitive of a number, without weights.
InputPlace InputPlaces::placeOf(std::uint32_t number) const
{
  InputPlace place;
  if (number != NearestNumbers::none)
  {
    const auto next = std::upper_bound(starts_.begin(), starts_.end(), number);
    const auto view = static_cast<std::size_t>(next - starts_.begin()) - 1;
    place.view = static_cast<std::uint32_t>(view);
    place.primitive = primitives_.empty() ? static_cast<std::uint32_t>(number - starts_[view])
                                          : primitives_[number];
  }
  return place;
}

InputPlace InputPlaces::placeOf(
  const NearestNumbers::Answer& answer, const Eigen::Vector3d& image) const
{
  InputPlace place = this->placeOf(answer.number);
  if (place.exists() && !triangles_.empty())
  {
    const std::size_t view = place.view;
    const double scale = tree_.scale();
    const auto corner = [&](std::size_t n) -> Eigen::Vector3d
    {
      return scale * cornerOf(triangles_[view], place.primitive, n);
    };
    place.weights = weightsOfNearest(image, corner(0), corner(1), corner(2));
  }
  return place;
}

/// Sets `images` to a sample and its images at the planes of symmetry, in the tree's coordinates.
void InputPlaces::findImages(
  const Eigen::Vector3d& sample, std::vector<Eigen::Vector3d>& images) const
{
  const double scale = tree_.scale();
  images.assign(1, sample);
  // The last images of the source go back first.
  for (auto plane = planes_.rbegin(); plane != planes_.rend(); ++plane)
  {
    for (std::size_t i = 0, before = images.size(); i < before; ++i)
    {
      images.push_back(plane->mirrored(images[i]));
    }
  }
  for (Eigen::Vector3d& image : images)
  {
    image = {scaledCoordinate(image[0], scale), scaledCoordinate(image[1], scale),
      scaledCoordinate(image[2], scale)};
  }
}

void InputPlaces::find(std::size_t count,
  const std::function<Eigen::Vector3d(std::size_t)>& positionOf, InputPlace* places,
  Executor& executor) const
{
  constexpr std::size_t samplesPerBlock = 1024;
  executor.run((count + samplesPerBlock - 1) / samplesPerBlock,
    [&](std::size_t block)
    {
      std::uint32_t guess = NearestNumbers::none;
      std::vector<Eigen::Vector3d> images;
      const std::size_t first = block * samplesPerBlock;
      for (std::size_t n = first; n < std::min(count, first + samplesPerBlock); ++n)
      {
        const Eigen::Vector3d sample = positionOf(n);
        places[n] = InputPlace();
        if (sample.allFinite())
        {
          this->findImages(sample, images);
          const NearestNumbers::Answer answer = numbers_.find(images.data(), images.size(), guess);
          guess = answer.item;
          places[n] = this->placeOf(answer, images[answer.place]);
        }
      }
    });
}

/// Describes the places of samples by the numbers that are nearest to them.
void InputPlaces::describe(
  const std::vector<std::uint32_t>& numbers, InputPlace* places, Executor& executor) const
{
  forEachItem(
    numbers.size(), [&](std::size_t n) { places[n] = this->placeOf(numbers[n]); }, executor);
}

void InputPlaces::findOnGrid(
  const Grid& grid, const Extent& extent, InputPlace* places, Executor& executor) const
{
  if (!planes_.empty())
  {
    this->find(
      sampleCount(extent), [&](std::size_t n) { return grid.sample(extent, n); }, places, executor);
    return;
  }
  std::vector<std::uint32_t> numbers(sampleCount(extent), NearestNumbers::none);
  const FieldOutput noDistances;
  GridDistances(tree_, grid, extent, noDistances)
    .findNumbers({&numbers_, numbers.data()}, executor);
  this->describe(numbers, places, executor);
}

void InputPlaces::findAt(const VectorsView& samples, InputPlace* places, Executor& executor) const
{
  if (!planes_.empty())
  {
    this->find(
      samples.size(), [&](std::size_t n) { return samples[n]; }, places, executor);
    return;
  }
  std::vector<std::uint32_t> numbers(samples.size(), NearestNumbers::none);
  findNearestNumbers(tree_, samples, {&numbers_, numbers.data()}, executor);
  this->describe(numbers, places, executor);
}

} // namespace winding
