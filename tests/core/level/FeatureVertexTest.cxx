// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/FeatureVertex.h"

#include "support/Samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

using shapes::Point;
using shapes::Random;
using winding::featureVertex;
using winding::HermiteCrossing;

/// Crossings of planes through one point, two with each.
std::vector<HermiteCrossing> crossingsOf(
  const std::vector<Point>& normals, const Point& common, Random& random)
{
  std::vector<HermiteCrossing> crossings;
  for (std::size_t n = 0; n < 2 * normals.size(); ++n)
  {
    const Point& normal = normals[n / 2];
    const Point anywhere = random.point(0, 1);
    // The sense of a normal does not matter.
    crossings.push_back({anywhere - normal * normal.dot(anywhere - common),
      random(0, 1) < 0.5 ? normal : Point(-normal)});
  }
  return crossings;
}

Point vertexOf(const std::vector<HermiteCrossing>& crossings, const Point& size = Point::Ones())
{
  return featureVertex(
    crossings.data(), crossings.size(), winding::Bounds(Point(Point::Zero()), size));
}

} // namespace

TEST(FeatureVertex, IsTheCornerOfThreePlanes)
{
  Random random(1);
  for (int n = 0; n < 10000; ++n)
  {
    const Point corner = random.point(0.1, 0.9);
    const std::vector<Point> normals = {random.direction(), random.direction(), random.direction()};
    if (std::abs(normals[0].dot(normals[1].cross(normals[2]))) < 0.3)
    {
      continue; // flat corners may lose an eigenvalue
    }
    // 3e-15 at most.
    EXPECT_LT((vertexOf(crossingsOf(normals, corner, random)) - corner).norm(), 1e-13);
  }
}

TEST(FeatureVertex, LiesOnTheEdgeOfTwoPlanesBesideTheMeanOfTheCrossings)
{
  Random random(2);
  for (int n = 0; n < 10000; ++n)
  {
    const Point a = random.direction(), b = random.direction();
    const Point along = a.cross(b).normalized();
    const auto crossings = crossingsOf({a, b}, random.point(0.4, 0.6), random);
    Point mean = Point::Zero();
    for (const HermiteCrossing& crossing : crossings)
    {
      mean += 0.25 * crossing.position;
    }
    const Point vertex = vertexOf(crossings);
    const bool isFree = (vertex.array() > 0.01).all() && (vertex.array() < 0.99).all();
    if (a.cross(b).norm() < 0.3 || !isFree)
    {
      continue;
    }
    EXPECT_LT(std::abs(a.dot(vertex - crossings[0].position)), 1e-13);
    EXPECT_LT(std::abs(b.dot(vertex - crossings[2].position)), 1e-13);
    EXPECT_LT(std::abs(along.dot(vertex - mean)), 1e-13);
  }
}

TEST(FeatureVertex, OfParallelPlanesIsBelowTheMeanOfTheCrossings)
{
  const Point normal(0.6, 0, 0.8);
  const std::vector<HermiteCrossing> crossings = {
    {{0.2, 0.3, 0.5}, normal}, {{0.6, 0.7, 0.2}, normal}, {{0.4, 0.5, 0.5}, -normal}};
  const Point vertex = vertexOf(crossings);
  const Point mean(0.4, 0.5, 0.4);
  EXPECT_LT((vertex - mean).cross(normal).norm(), 1e-15);
  EXPECT_NEAR(normal.dot(vertex), (0.52 + 0.52 + 0.64) / 3, 1e-15);
}

/// No point of the cell has a smaller error.
TEST(FeatureVertex, IsTheBestPointOfTheCellWhereThePlanesMeetOutside)
{
  Random random(3);
  for (int n = 0; n < 2000; ++n)
  {
    const Point size{1, random(0.3, 1), random(0.1, 1)};
    const auto crossings = crossingsOf({random.direction(), random.direction(), random.direction()},
      random.point(-3, 4).cwiseProduct(size), random);
    const auto error = [&crossings](const Point& point)
    {
      double sum = 0;
      for (const HermiteCrossing& crossing : crossings)
      {
        sum += std::pow(crossing.normal.dot(point - crossing.position), 2);
      }
      return sum;
    };
    const Point vertex = vertexOf(crossings, size);
    ASSERT_TRUE((vertex.array() > 0).all() && (vertex.array() < size.array()).all());
    Eigen::Matrix3d planes = Eigen::Matrix3d::Zero();
    for (const HermiteCrossing& crossing : crossings)
    {
      planes += crossing.normal * crossing.normal.transpose();
    }
    if (planes.determinant() < 0.1 * std::pow(planes.trace(), 3) / 27)
    {
      continue; // an eigenvalue may be dropped
    }
    for (int other = 0; other < 200; ++other)
    {
      const Point point = random.point(0.001, 0.999).cwiseProduct(size);
      EXPECT_GE(error(point), error(vertex) * (1 - 1e-12));
    }
  }
}

TEST(FeatureVertex, WithoutNormalsIsTheMeanOfTheCrossings)
{
  const std::vector<HermiteCrossing> crossings = {
    {{0, 0.3, 0}, Point::Zero()}, {{0, 0, 0.6}, Point::Zero()}, {{0.9, 0, 0}, Point::Zero()}};
  EXPECT_LT((vertexOf(crossings) - Point(0.3, 0.1, 0.2)).norm(), 1e-15);
}
