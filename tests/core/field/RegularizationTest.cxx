// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/Pi.h"
#include "base/Refusal.h"
#include "base/Views.h"
#include "field/Field.h"
#include "source/PointCloud.h"
#include "sums/ReferenceSum.h"
#include "sums/SolidAngle.h"
#include "support/FarFields.h"
#include "support/Fields.h"
#include "support/Serial.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

/**
 * These tests look at clouds whose points are spread over a length: their definition, direct sum
 * and far field. The table has the largest error of a far field among all samples compared here, in
 * units of the tolerance; errors of gradients are in units of tolerance / the larger of the length
 * and the distance to the nearest point. (Among ten times as many samples, gradients far from a
 * sphere have errors up to 7.6, and 4.7 if they are of pure dipoles.)
 *
 *                 1e-2  1e-3  1e-4  1e-5  1e-6
 *   scattered
 *     half        0.28  0.17  0.22  0.11  0.37
 *     one         0.28  0.17  0.22  0.11  0.37
 *     two         0.19  0.18  0.11  0.11  0.20
 *     ten         0.01  0.00  0.00  0.00  0.01
 *     hundred     0.00  0.00  0.00  0.00  0.00
 *     dense       0.48  0.35  0.26  0.23  0.30
 *     random      0.35  0.24  0.25  0.19  0.07
 *     graded      0.15  0.16  0.05  0.14  0.08
 *     heap        0.32  0.37  0.24  0.13  0.63
 *     single      0.00  0.00  0.00  0.01  0.00
 *     tiny        0.21  0.17  0.30  0.17  0.07
 *     huge        0.26  0.09  0.15  0.08  0.11
 *   on grids
 *     half        0.29  0.25  0.17  0.12  0.19
 *     one         0.29  0.25  0.17  0.12  0.19
 *     two         0.34  0.16  0.13  0.08  0.10
 *     ten         0.00  0.00  0.00  0.00  0.01
 *     hundred     0.00  0.00  0.00  0.00  0.00
 *     dense       0.25  0.25  0.31  0.12  0.07
 *     random      0.35  0.27  0.41  0.11  0.00
 *     graded      0.13  0.12  0.08  0.10  0.13
 *     heap        0.34  0.27  0.17  0.08  0.16
 *     single      0.00  0.00  0.00  0.00  0.00
 *     tiny        0.32  0.21  0.14  0.15  0.13
 *     huge        0.32  0.20  0.14  0.15  0.13
 *   gradients
 *     half        0.71  0.46  0.34  0.97  0.82
 *     one         0.63  0.46  0.34  0.97  0.82
 *     two         0.61  0.46  0.34  0.65  0.43
 *     ten         0.00  0.00  0.00  0.00  0.00
 *     hundred     0.00  0.00  0.00  0.00  0.00
 *     dense       0.76  0.79  0.51  1.60  0.91
 *     random      0.48  0.67  0.95  0.66  0.36
 *     graded      0.19  0.13  0.17  0.47  0.13
 *     heap        0.66  0.58  1.57  2.63  0.76
 *     single      0.01  0.02  0.05  0.09  0.07
 *     tiny        0.71  0.61  1.17  1.49  0.83
 *     huge        0.64  0.53  0.59  0.43  0.50
 */

namespace
{

using namespace shapes;
using winding::DipoleSum;
using winding::FarField;
using winding::FarFieldAccuracy;
using winding::Field;
using winding::FieldOptions;
using winding::Method;

struct Case
{
  winding::PointCloud cloud;
  std::vector<double> areas;

  std::vector<double> values(const std::vector<Point>& samples) const
  {
    return valuesOf(DipoleSum(cloud, areas), samples);
  }
};

/// The cloud with points spread over `factor` times their spacings.
Case regularized(const Cloud& cloud, const std::vector<double>& areas, double factor)
{
  Case result{clean(cloud), areas};
  for (const double area : areas)
  {
    result.cloud.regularizationLengths.push_back(factor * std::sqrt(area));
  }
  return result;
}

Case sphere(std::size_t count, double factor, double scale = 1)
{
  return regularized(
    mapped(sphereCloud(count), [scale](const Point& p) -> Point { return scale * p; }),
    std::vector<double>(count, 4 * winding::pi * scale * scale / static_cast<double>(count)),
    factor);
}

/// A cloud whose points are spread over different lengths, and some over none.
Case mixed(unsigned seed)
{
  Random random(seed);
  Case result{clean(randomCloud(500, seed + 1)), {}};
  for (std::size_t i = 0; i < 500; ++i)
  {
    result.areas.push_back(random(0, 0.01));
    result.cloud.regularizationLengths.push_back(i % 5 == 0 ? 0 : std::exp2(random(-10, 1)));
  }
  return result;
}

/// Samples anywhere, and at several distances from points.
std::vector<Point> samplesOf(const Case& one, unsigned seed)
{
  std::vector<Point> samples = randomPoints(200, -2, 2, seed);
  Random random(seed + 1);
  for (const double distance : {1e-1, 1e-2, 1e-4})
  {
    for (int i = 0; i < 50; ++i)
    {
      samples.push_back(one.cloud.positions[random.bits() % one.cloud.positions.size()] +
                        distance * random.direction());
    }
  }
  return samples;
}

double reference(const Case& one, const Point& q)
{
  return static_cast<double>(winding::referenceSum<long double>(one.cloud, one.areas, q));
}

} // namespace

TEST(RegularizedSolidAngle, IsTheDipoleTimesItsShare)
{
  SCOPED_TRACE("seed 930");
  using Long = winding::Vector3<long double>;
  Random random(930);
  double worst = 0;
  for (int i = 0; i < 10'000; ++i)
  {
    const Point normal = random.direction(), d = random.direction();
    const double t = std::exp(random(std::log(1e-8), std::log(30)));
    const long double length = 0.25L, u = static_cast<long double>(t) * t;
    if (u > 9 && u < 41)
    {
      continue; // the series loses too many digits here
    }
    long double sum = 0, power = 1;
    for (int k = 0; k < 80; ++k)
    {
      sum += power / (2 * k + 3);
      power *= -u / (k + 1);
    }
    const long double share = u < 9 ? 2.2567583341910251478L * sum * u * t : 1;
    const Long offset = (d * (t * 0.25)).cast<long double>();
    const Long direction = normal.cast<long double>();
    const long double found =
      winding::regularizedDipoleSolidAngle<long double>(offset, direction, 2.0L, length);
    const long double pure = winding::dipoleSolidAngle<long double>(offset, direction, 2.0L);
    worst = std::max(worst, static_cast<double>(std::abs(found / (share * pure) - 1)));
  }
  record("worst", worst);
  EXPECT_LT(worst, 1e-12); // measured: 9.2e-16
}

TEST(RegularizedSolidAngle, IsOddAndZeroAtThePointAndPureWithoutALength)
{
  const winding::Vector3<double> normal(0, 0.6, 0.8), offset(0.3, -0.2, 0.1);
  for (const double length : {0.0, 1e-100, 0.01, 0.4, 7.0, 1e100})
  {
    const double w = winding::regularizedDipoleSolidAngle<double>(offset, normal, 2, length);
    EXPECT_EQ(winding::regularizedDipoleSolidAngle<double>(-offset, normal, 2, length), -w);
    EXPECT_EQ(winding::regularizedDipoleSolidAngle<double>({0, 0, 0}, normal, 2, length), 0);
  }
  EXPECT_EQ(winding::regularizedDipoleSolidAngle<double>(offset, normal, 2, 0),
    winding::dipoleSolidAngle<double>(offset, normal, 2));
}

TEST(RegularizedDipoleSum, EqualsTheLongDoubleReference)
{
  SCOPED_TRACE("seeds 931 to 934");
  double worst = 0;
  for (const Case& one : {sphere(1000, 1), sphere(1000, 0.1), sphere(100, 5), mixed(931)})
  {
    const std::vector<Point> samples = samplesOf(one, 933);
    const std::vector<double> values = one.values(samples);
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      const double expected = reference(one, samples[i]);
      worst = std::max(worst, std::abs(values[i] - expected) / std::max(1.0, std::abs(expected)));
    }
  }
  record("worst", worst);
  EXPECT_LT(worst, 1e-12); // measured: 3.1e-15
}

TEST(RegularizedDipoleSum, HasTheGradientOfCentralDifferences)
{
  SCOPED_TRACE("seeds 931, 932, 935");
  double worst = 0;
  for (const Case& one : {sphere(300, 1), mixed(931)})
  {
    std::vector<Point> samples = randomPoints(50, -1.5, 1.5, 935);
    // Samples on points that are spread are added.
    samples.insert(samples.end(), one.cloud.positions.begin() + 1, one.cloud.positions.begin() + 5);
    const std::vector<Point> gradients = gradientsOf(DipoleSum(one.cloud, one.areas), samples);
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      const auto at = [&](int axis, long double step)
      {
        winding::PointCloud moved = one.cloud;
        for (Point& p : moved.positions)
        {
          p[axis] -= static_cast<double>(step);
        }
        return winding::referenceSum<long double>(moved, one.areas, samples[i]);
      };
      for (int axis = 0; axis < 3; ++axis)
      {
        constexpr long double h = 0x1p-16L;
        const long double expected =
          (8 * (at(axis, h) - at(axis, -h)) - (at(axis, 2 * h) - at(axis, -2 * h))) / (12 * h);
        worst = std::max(worst,
          std::abs(gradients[i][axis] - static_cast<double>(expected)) / (1 + gradients[i].norm()));
      }
    }
  }
  record("worst", worst);
  EXPECT_LT(worst, 1e-9); // measured: 4.6e-12
}

TEST(RegularizedDipoleSum, OfAPointsOwnPlaceIsTheSumOfTheOthers)
{
  SCOPED_TRACE("seeds 931, 932");
  for (const Case& one : {sphere(500, 1), mixed(931)})
  {
    const std::vector<double> values = one.values(one.cloud.positions);
    for (std::size_t i = 0; i < values.size(); i += 7)
    {
      Case others = one;
      others.areas[i] = 0;
      const double expected = others.values({one.cloud.positions[i]})[0];
      ASSERT_EQ(values[i], expected);
    }
  }
}

TEST(RegularizedDipoleSum, OfASphereHasNoSpikesAtItsPoints)
{
  SCOPED_TRACE("seed 936");
  for (const double factor : {0.5, 1.0})
  {
    const Case one = sphere(10'000, factor);
    const double spacing = std::sqrt(one.areas[0]);
    Random random(936);
    std::vector<Point> samples;
    for (int i = 0; i < 5000; ++i)
    {
      samples.push_back(one.cloud.positions[random.bits() % 10'000] +
                        random(0, 1.5) * spacing * random.direction());
    }
    samples.insert(samples.end(), one.cloud.positions.begin(), one.cloud.positions.begin() + 2000);
    double low = HUGE_VAL, high = -HUGE_VAL, steepest = 0;
    for (const double w : one.values(samples))
    {
      low = std::min(low, w);
      high = std::max(high, w);
    }
    for (const Point& gradient : gradientsOf(DipoleSum(one.cloud, one.areas), samples))
    {
      steepest = std::max(steepest, spacing * gradient.norm());
    }
    std::ostringstream name;
    name << " " << factor;
    record("low" + name.str(), low);
    record("high" + name.str(), high);
    record("steepest" + name.str(), steepest);
    // The three were measured as -0.0013, 1.0006 and 1.2 with a factor of 0.5, and as 0.020, 0.979
    // and 0.57 with 1. Pure dipoles give thousands.
    EXPECT_GT(low, factor < 1 ? -0.05 : 0) << factor;
    EXPECT_LT(high, factor < 1 ? 1.05 : 1) << factor;
    EXPECT_LT(steepest, factor < 1 ? 2 : 1) << factor;
  }
}

TEST(RegularizedDipoleSum, TendsToPureDipoles)
{
  SCOPED_TRACE("seeds 933, 934");
  const Case pure = sphere(1000, 0);
  winding::PointCloud none = pure.cloud;
  none.regularizationLengths.clear();
  std::vector<Point> samples = samplesOf(pure, 933);
  const std::vector<double> expected = valuesOf(DipoleSum(none, pure.areas), samples);
  EXPECT_EQ(pure.values(samples), expected);
  for (const double factor : {1e-4, 1e-8, 1e-100, 1e-300})
  {
    // Values are equal to the bit as soon as the nearest point is many lengths away; samples are at
    // least about 1e-4 away.
    EXPECT_EQ(sphere(1000, factor).values(samples), expected) << factor;
  }
}

TEST(RegularizedDipoleSum, DoesNotDependOnTheUnitOfLength)
{
  SCOPED_TRACE("seeds 933, 934");
  const Case unit = sphere(1000, 1);
  const std::vector<Point> samples = samplesOf(unit, 933);
  const std::vector<double> expected = unit.values(samples);
  double worst = 0;
  for (const double scale : {1e-100, 1e-30, 1e30, 1e100})
  {
    std::vector<Point> scaled;
    for (const Point& q : samples)
    {
      scaled.emplace_back(scale * q);
    }
    Case other = sphere(1000, 1, scale);
    other.cloud.normals = unit.cloud.normals;
    const std::vector<double> values = other.values(scaled);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      worst = std::max(worst, std::abs(values[i] - expected[i]));
    }
  }
  record("worst", worst);
  EXPECT_LT(worst, 1e-12); // measured: 7.2e-16
}

namespace
{

struct Source
{
  std::string name;
  std::unique_ptr<FarSource> source;
};

std::vector<Source> sources()
{
  const auto ofSphere = [](std::size_t count, double radius, double factor)
  {
    return farSource(
      mapped(sphereCloud(count), [radius](const Point& p) -> Point { return radius * p; }),
      std::vector<double>(count, 4 * winding::pi * radius * radius / static_cast<double>(count)),
      factor);
  };
  std::vector<Source> all;
  all.push_back({"half", ofSphere(5000, 1, 0.5)});
  all.push_back({"one", ofSphere(5000, 1, 1)});
  all.push_back({"two", ofSphere(5000, 1, 2)});
  all.push_back({"ten", ofSphere(1500, 1, 10)});
  all.push_back({"hundred", ofSphere(300, 1, 100)});
  all.push_back({"dense", ofSphere(15'000, 1, 1)});
  all.push_back({"random", farSource(randomCloud(5000, 937), std::vector<double>(5000, 0.01), 1)});
  all.push_back({"graded", gradedSource(5000, 938, 1)});
  all.push_back(
    {"heap", farSource(sphereWithHeap(10'000), std::vector<double>(15'000, 0.0025), 1)});
  all.push_back({"single", farSource(Cloud{{{3, 4, 5}}, {{0, 0.6, 0.8}}}, {1}, 1)});
  all.push_back({"tiny", ofSphere(2000, 1e-30, 1)});
  all.push_back({"huge", ofSphere(2000, 1e30, 1)});
  return all;
}

constexpr double tolerances[] = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6};

double sizeOf(const FarSource& source)
{
  const double size = source.bounds().sizes().maxCoeff();
  return size > 0 ? size : 1;
}

/// Samples anywhere, next to points, on them, and far away.
std::vector<Point> samplesOf(const FarSource& source, unsigned seed)
{
  Random random(seed);
  const Point center = source.bounds().center();
  const double size = sizeOf(source);
  std::vector<Point> samples;
  for (int i = 0; i < 100; ++i)
  {
    samples.emplace_back(center + 0.7 * size * random.point(-1, 1));
    samples.emplace_back(center + size * std::exp2(random(0, 9)) * random.direction());
    samples.emplace_back(center + size * random(0.45, 0.55) * random.direction());
  }
  for (const Point& place : source.places(200, seed + 1))
  {
    samples.emplace_back(place + size * std::exp2(random(-12, -1)) * random.direction());
  }
  for (const Point& place : source.places(50, seed + 2))
  {
    samples.push_back(place);
  }
  return samples;
}

} // namespace

TEST(RegularizedFarField, EqualsTheDirectSumAtScatteredSamples)
{
  for (const Source& one : sources())
  {
    SCOPED_TRACE(one.name + ", seeds 937 to 941");
    const std::vector<Point> samples = samplesOf(*one.source, 939);
    for (const double tolerance : tolerances)
    {
      const FarField field(one.source->sources(), FarFieldAccuracy::of(tolerance), serial);
      const double error = largestError(*one.source, samples, valuesAt(field, samples)) / tolerance;
      std::ostringstream name;
      name << one.name << " " << tolerance;
      record(name.str(), error);
      EXPECT_LT(error, 1) << name.str();
    }
  }
}

TEST(RegularizedFarField, EqualsTheDirectSumOnGrids)
{
  for (const Source& one : sources())
  {
    SCOPED_TRACE(one.name + ", seed 942");
    const double size = sizeOf(*one.source);
    const winding::Grid grid = gridOf(one.source->bounds().center() - 0.6 * Point(size, size, size),
      size * Point(1.2 / 43, 1.2 / 28, 1.2 / 35), {44, 29, 36});
    const std::vector<Eigen::Vector3i> at = comparedSamples(*one.source, grid, 150, 942);
    std::vector<Point> samples;
    for (const Eigen::Vector3i& index : at)
    {
      samples.push_back(grid.sample(index));
    }
    for (const double tolerance : tolerances)
    {
      const FarField field(one.source->sources(), FarFieldAccuracy::of(tolerance), serial);
      const std::vector<float> all = valuesOn(field, grid);
      std::vector<float> values;
      for (const Eigen::Vector3i& index : at)
      {
        values.push_back(all[winding::sampleNumber(grid.wholeExtent(), index)]);
      }
      const double error = largestError(*one.source, samples, values) / tolerance;
      std::ostringstream name;
      name << one.name << " " << tolerance;
      record(name.str(), error);
      EXPECT_LT(error, 1) << name.str();
    }
  }
}

TEST(RegularizedFarField, HasGradientsWithinAFewTolerancesOverTheDistance)
{
  for (const Source& one : sources())
  {
    SCOPED_TRACE(one.name + ", seeds 937 to 945");
    const std::vector<Point> samples = samplesOf(*one.source, 943);
    const std::vector<Point> expected = one.source->gradients(samples);
    const std::vector<double> strengths = one.source->strengths(samples);
    for (const double tolerance : tolerances)
    {
      const FarField field(one.source->sources(), FarFieldAccuracy::of(tolerance), serial);
      const std::vector<Point> gradients = gradientsAt(field, samples);
      double largest = 0;
      for (std::size_t i = 0; i < samples.size(); ++i)
      {
        ASSERT_TRUE(gradients[i].allFinite());
        const double error = (gradients[i] - expected[i]).norm() * one.source->distance(samples[i]);
        largest =
          std::max(largest, (error - 0x1p-19 * std::max(strengths[i] - 1, 0.0)) / tolerance);
      }
      std::ostringstream name;
      name << one.name << " " << tolerance;
      record(name.str(), largest);
      EXPECT_LT(largest, 8) << name.str();
    }
  }
}

TEST(RegularizedField, HasLengthsInUnitsOfTheSpacing)
{
  SCOPED_TRACE("seed 946");
  const Cloud cloud = sphereCloud(2000);
  const std::vector<Point> samples = randomPoints(300, -1.2, 1.2, 946);
  const Case expected = sphere(2000, 0.7);
  for (const Method method : {Method::direct, Method::hierarchical})
  {
    FieldOptions options;
    options.method = method;
    options.tolerance = 1e-4;
    options.pointAreaMethod = winding::PointAreaMethod::constant;
    options.pointArea = expected.areas[0];
    options.regularization = 0.7;
    const auto field = fieldOf(cloud, options);
    std::vector<double> values(samples.size());
    winding::FieldOutput output;
    output.doubleValues = values.data();
    field->evaluate(winding::VectorsView(samples[0].data(), samples.size()), output, serial);
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      const double w = reference(expected, samples[i]);
      ASSERT_NEAR(values[i], w, method == Method::direct ? 1e-12 : 1e-4);
      ASSERT_NEAR(field->reference(samples[i]), w, 1e-12);
    }
    options.regularization = 0;
    EXPECT_NE(field->reference(samples[0]), fieldOf(cloud, options)->reference(samples[0]));
  }
}

TEST(RegularizedField, RefusesLengthsThatAreNone)
{
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const double factor : {-1.0, nan, infinity, -infinity})
  {
    EXPECT_THROW(fieldOf(sphereCloud(10), &FieldOptions::regularization, factor), winding::Refusal)
      << factor;
  }
  FieldOptions one, other;
  other.regularization = 1;
  EXPECT_FALSE(one == other);
}
