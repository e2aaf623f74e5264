// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/SourceMoments.h"
#include "base/Pi.h"

#include "farfield/Expansions.h"
#include "source/Surface.h"
#include "support/FarFields.h"
#include "support/Serial.h"

#include <algorithm>

namespace
{

using namespace shapes;
using winding::Expansion;
using winding::FarFieldAccuracy;
using winding::FarFieldSources;
using winding::SourceMoments;
using winding::SourceTree;

FarFieldAccuracy accuracyOf(int order)
{
  return {order, 0.5f, 1e-3f};
}

/// The dipoles that stand for a source, item by item, in scaled coordinates; made without
/// FarFieldSources.
using Items = std::vector<std::vector<FarFieldSources::Dipole>>;

/// Cuts a triangle in four again and again, and appends a dipole in each centroid. The error of
/// degree 9 falls with 4^-levels.
void appendFine(const Point& a, const Point& b, const Point& c, int levels,
  std::vector<FarFieldSources::Dipole>& dipoles)
{
  if (levels == 0)
  {
    dipoles.push_back({(a + b + c) / 3, (b - a).cross(c - a) / (8 * winding::pi)});
    return;
  }
  const Point ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
  appendFine(a, ab, ca, levels - 1, dipoles);
  appendFine(ab, b, bc, levels - 1, dipoles);
  appendFine(ca, bc, c, levels - 1, dipoles);
  appendFine(ab, bc, ca, levels - 1, dipoles);
}

Items fineItems(const Mesh& mesh, double scale, int levels)
{
  const winding::Surface surface = clean(mesh);
  Items items;
  for (const winding::Triangle& t : surface.triangles)
  {
    const auto corner = [&](std::size_t i) -> Point
    {
      return scale * surface.vertices[static_cast<std::size_t>(t[i])];
    };
    appendFine(corner(0), corner(1), corner(2), levels, items.emplace_back());
  }
  return items;
}

Items itemsOf(const Cloud& cloud, const std::vector<double>& areas, double scale)
{
  Items items;
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    const double area = areas[i] * scale * scale / (4 * winding::pi);
    items.push_back({{scale * cloud.positions[i], area * cloud.normals[i]}});
  }
  return items;
}

struct Errors
{
  double moments = 0; ///< largest error, relative to the sum of the dipoles' absolute values
  double reach = 0;   ///< largest distance of a dipole from the centre over the radius
};
/// Compares the moments of all nodes with the sums over the dipoles of all of their items.
Errors compare(FarFieldSources& sources, const Items& items, int order, std::size_t leafSize)
{
  const SourceTree tree(sources.centers(serial), leafSize, serial);
  sources.arrange(tree.order(), false, serial);
  const SourceMoments moments(tree, sources, accuracyOf(order), serial);
  Errors errors;
  for (std::size_t n = 0; n < tree.nodes().size(); ++n)
  {
    const double radius = moments.criteria.radius[n];
    Expansion expected(static_cast<std::size_t>(winding::coefficientCount(order)));
    double strength = 0;
    for (std::uint32_t i = tree.nodes()[n].begin; i < tree.nodes()[n].end; ++i)
    {
      for (const FarFieldSources::Dipole& dipole : items[tree.order()[i]])
      {
        const Point offset = dipole.position - moments.centers[n];
        errors.reach = std::max(errors.reach, offset.norm() / radius);
        winding::addDipole(order, offset / radius, dipole.moment / radius, expected);
        strength += dipole.moment.norm() / radius;
      }
    }
    for (std::size_t place = 0; place < expected.size(); ++place)
    {
      const double error = std::abs(moments.of(n)[place] - expected[place]);
      errors.moments = std::max(errors.moments, strength > 0 ? error / strength : error);
    }
  }
  return errors;
}

class SourceMomentsOfOrder : public testing::TestWithParam<int>
{
};

} // namespace

TEST_P(SourceMomentsOfOrder, OfCloudsAreTheSumsOfAllPoints)
{
  SCOPED_TRACE("seeds 351, 352");
  for (const double scale : {1e-30, 1.0, 1e30})
  {
    const Cloud cloud =
      mapped(randomCloud(700, 351), [scale](const Point& p) -> Point { return scale * p; });
    std::vector<double> areas;
    Random random(352);
    for (std::size_t i = 0; i < cloud.positions.size(); ++i)
    {
      areas.push_back(i % 5 == 0 ? 0 : random(0, 0.01) * scale * scale);
    }
    const auto sources = winding::farFieldSources(clean(cloud), areas, serial);
    const Errors errors =
      compare(*sources, itemsOf(cloud, areas, sources->scale()), GetParam(), 10);
    record("moments", errors.moments);
    EXPECT_LT(errors.moments, 1e-6); // measured: 3.8e-8
    EXPECT_LE(errors.reach, 1);
    EXPECT_GT(errors.reach, 0.999);
  }
}

TEST_P(SourceMomentsOfOrder, OfTrianglesAreTheirIntegrals)
{
  SCOPED_TRACE("seed 353");
  for (const double scale : {1e-30, 1.0, 1e30})
  {
    const Mesh mesh = triangleSoup(40, 353).with(tetrahedron()).scaled(scale);
    const winding::Surface surface = clean(mesh);
    const auto sources =
      winding::farFieldSources(surface.vertices, surface.triangles, surface.bounds, {}, serial);
    const Errors errors = compare(*sources, fineItems(mesh, sources->scale(), 5), GetParam(), 4);
    record("moments", errors.moments);
    // The error is the same for every order and scale, since it is the reference's own.
    EXPECT_LT(errors.moments, 5e-5); // measured: 2e-5
    EXPECT_LE(errors.reach, 1);
  }
}

TEST_P(SourceMomentsOfOrder, OfManyEqualPointsKeepTheirDigits)
{
  // The 30 000 equal points make one leaf; sums of that many floats would be off by 1e-5.
  Cloud cloud;
  cloud.positions.assign(30000, Point(0.1, 0.2, 0.3));
  cloud.normals.assign(30000, Point(0, 0.6, 0.8));
  cloud.positions.emplace_back(1, 1, 1);
  cloud.normals.emplace_back(1, 0, 0);
  const std::vector<double> areas(30001, 1e-4);
  const auto sources = winding::farFieldSources(clean(cloud), areas, serial);
  const Errors errors = compare(*sources, itemsOf(cloud, areas, sources->scale()), GetParam(), 24);
  record("moments", errors.moments);
  EXPECT_LT(errors.moments, 2e-7); // measured: 2e-8
}

TEST_P(SourceMomentsOfOrder, OfItemsWithoutAreaAreZero)
{
  const Cloud cloud = randomCloud(100, 354);
  const auto points = winding::farFieldSources(clean(cloud), std::vector<double>(100, 0.0), serial);
  const Mesh flat = triangleSoup(100, 355).mapped([](const Point& p) { return Point(p[0], 0, 0); });
  const winding::Surface surface = clean(flat);
  const auto lines =
    winding::farFieldSources(surface.vertices, surface.triangles, surface.bounds, {}, serial);
  for (const auto& sources : {points.get(), lines.get()})
  {
    const SourceTree tree(sources->centers(serial), 10, serial);
    sources->arrange(tree.order(), false, serial);
    const SourceMoments moments(tree, *sources, accuracyOf(GetParam()), serial);
    for (std::size_t n = 0; n < tree.nodes().size(); ++n)
    {
      EXPECT_TRUE(moments.centers[n].allFinite());
      EXPECT_TRUE(std::isfinite(moments.criteria.radius[n]));
      EXPECT_EQ(moments.criteria.rho[n], 0);
      EXPECT_EQ(moments.criteria.tau[n], 0);
      for (int place = 0; place < winding::coefficientCount(GetParam()); ++place)
      {
        ASSERT_EQ(moments.of(n)[place], 0);
      }
    }
  }
}

TEST_P(SourceMomentsOfOrder, KeepSamplesAsFarAwayAsTheWidestOfTheirPointsIsSpread)
{
  SCOPED_TRACE("seeds 358, 359");
  winding::PointCloud cloud = clean(randomCloud(700, 358));
  Random random(359);
  for (std::size_t i = 0; i < cloud.positions.size(); ++i)
  {
    cloud.regularizationLengths.push_back(random(0, 0.1));
  }
  const auto sources = winding::farFieldSources(cloud, std::vector<double>(700, 1e-6), serial);
  const SourceTree tree(sources->centers(serial), 10, serial);
  sources->arrange(tree.order(), false, serial);
  const FarFieldAccuracy accuracy = accuracyOf(GetParam());
  const SourceMoments moments(tree, *sources, accuracy, serial);
  for (std::size_t n = 0; n < tree.nodes().size(); ++n)
  {
    double widest = 0;
    for (std::uint32_t i = tree.nodes()[n].begin; i < tree.nodes()[n].end; ++i)
    {
      widest = std::max(widest, cloud.regularizationLengths[tree.order()[i]]);
    }
    const double least =
      moments.criteria.radius[n] + accuracy.spreadMargin * sources->scale() * widest;
    EXPECT_GE(moments.criteria.rho[n], least * (1 - 1e-6)) << n;
  }
}

TEST_P(SourceMomentsOfOrder, HaveTheSameBitsOnAnyThreads)
{
  SCOPED_TRACE("seeds 356, 357");
  const auto source = farSource(randomCloud(5000, 356));
  ShuffledThreads threads(357);
  const auto sources = source->sources();
  const SourceTree tree(sources->centers(serial), 10, serial);
  sources->arrange(tree.order(), false, serial);
  const SourceMoments expected(tree, *sources, accuracyOf(GetParam()), serial);
  const SourceMoments moments(tree, *sources, accuracyOf(GetParam()), threads);
  EXPECT_EQ(moments.moments, expected.moments);
  EXPECT_EQ(moments.criteria.radius, expected.criteria.radius);
  EXPECT_EQ(moments.criteria.rho, expected.criteria.rho);
  EXPECT_EQ(moments.criteria.tau, expected.criteria.tau);
  EXPECT_EQ(moments.criteria.x, expected.criteria.x);
  EXPECT_EQ(moments.origin, expected.origin);
}

INSTANTIATE_TEST_SUITE_P(OfOrder, SourceMomentsOfOrder, testing::Values(3, 5, 7, 9));
