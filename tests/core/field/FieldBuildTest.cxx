// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/Pi.h"
#include "field/Field.h"

#include "base/Refusal.h"
#include "base/Views.h"
#include "cloud/PointAreas.h"
#include "sums/ReferenceSum.h"
#include "support/Fields.h"
#include "support/Named.h"
#include "support/Places.h"
#include "support/Refusals.h"
#include "support/Serial.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

// These tests look at what a field is made of: its information, its refusals, and the functions
// that verify it.

namespace
{

using namespace shapes;
using winding::Field;
using winding::FieldInfo;
using winding::FieldOptions;
using winding::FieldOutput;
using winding::Method;

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

double valueAt(const Field& field, const Point& sample)
{
  double value = notANumber;
  FieldOutput output;
  output.doubleValues = &value;
  field.evaluate(winding::VectorsView(sample.data(), 1), output, serial);
  return value;
}

template <class Source>
void expectRefused(const Source& source, const FieldOptions& options, const std::string& mention,
  std::optional<winding::Parameter> parameter = {})
{
  shapes::expectRefused([&] { fieldOf(source, options); }, mention, parameter);
}

} // namespace

TEST(FieldInfo, DescribesASurface)
{
  Mesh mesh = openCube();
  mesh.points.push_back({notANumber, 0, 0});
  mesh.triangles.push_back({0, 1, 8});
  mesh.triangles.push_back({0, 1, 99});
  mesh.triangles.push_back({0, 0, 1});
  const FieldInfo info = fieldOf(mesh)->info();
  EXPECT_TRUE(info.isSurface);
  EXPECT_EQ(info.inputPrimitives, 13u);
  EXPECT_EQ(info.primitives, 10u);
  EXPECT_EQ(info.dropped, 2u);
  EXPECT_EQ(info.weldedVertices, 8u);
  EXPECT_EQ(info.boundaryEdges, 4u);
  EXPECT_EQ(info.netBoundaryEdges, 4u);
  EXPECT_EQ(info.bounds.max(), Point(1, 1, 1));
  ASSERT_EQ(info.warnings.size(), 1u);
  EXPECT_EQ(info.warnings[0].fault.rfind("2 of 13 ", 0), 0u) << info.warnings[0].fault;
  EXPECT_FALSE(info.why.empty());
  EXPECT_TRUE(fieldOf(cube())->info().warnings.empty());
}

TEST(FieldInfo, NamesTheMethodThatWasChosenAndNeverAutomatic)
{
  EXPECT_NE(fieldOf(cube())->info().method, Method::automatic);
  EXPECT_NE(fieldOf(sphereCloud(10))->info().method, Method::automatic);
  EXPECT_EQ(fieldOf(cube(), Method::direct)->info().method, Method::direct);
  EXPECT_EQ(fieldOf(cube(), Method::parity)->info().method, Method::parity);
  EXPECT_STREQ(winding::nameOf(Method::automatic), "automatic");
  EXPECT_STREQ(winding::nameOf(Method::direct), "direct");
  EXPECT_STREQ(winding::nameOf(Method::parity), "parity");
}

TEST(FieldInfo, NamesRowsUnlessACapHasASixthOfTheTrianglesOrMore)
{
  // A cone of r rings has a rim of n edges and (2r - 1) n triangles, and its cap has n - 2. With
  // three rings that is a sixth at n = 12, and nearly a fifth for many edges.
  const auto coneOf = [](int edges, int rings)
  {
    Mesh cone{{Point(0, 0, 1)}, {}};
    const auto vertex = [edges](int ring, int place)
    {
      return 1 + (ring - 1) * edges + place % edges;
    };
    for (int ring = 1; ring <= rings; ++ring)
    {
      for (int i = 0; i < edges; ++i)
      {
        const double angle = 2 * winding::pi * i / edges, radius = double(ring) / rings;
        cone.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 1 - radius);
        if (ring == 1)
        {
          cone.triangles.push_back({0, vertex(1, i), vertex(1, i + 1)});
          continue;
        }
        cone.triangles.push_back({vertex(ring - 1, i), vertex(ring, i), vertex(ring, i + 1)});
        cone.triangles.push_back(
          {vertex(ring - 1, i), vertex(ring, i + 1), vertex(ring - 1, i + 1)});
      }
    }
    return cone;
  };
  const struct
  {
    int edges, rings;
    bool isRows;
  } cases[] = {{40, 4, true}, {40, 3, false}, {13, 3, false}, {12, 3, false}, {11, 3, true}};
  for (const auto& c : cases)
  {
    SCOPED_TRACE(std::to_string(c.edges) + " edges, " + std::to_string(c.rings) + " rings");
    const auto field = fieldOf(coneOf(c.edges, c.rings));
    const FieldInfo& info = field->info();
    EXPECT_EQ(info.capTriangles, static_cast<std::size_t>(c.edges - 2));
    EXPECT_EQ(info.method == Method::rows, c.isRows);
    EXPECT_EQ(6 * info.capTriangles < info.distinct, c.isRows);
  }
}

TEST(Field, EvaluatesTheMethodThatWasAskedFor)
{
  const Mesh two = cube().with(cube({0.5, 0.5, 0.5}, {1.5, 1.5, 1.5}));
  const Point overlap(0.75, 0.75, 0.75);
  EXPECT_NEAR(valueAt(*fieldOf(two), overlap), 2, 1e-14);
  EXPECT_NEAR(valueAt(*fieldOf(two, Method::direct), overlap), 2, 1e-14);
  EXPECT_EQ(valueAt(*fieldOf(two, Method::parity), overlap), 0);
}

TEST(Field, TakesTheAreasOfACloudFromTheCloudOrTheOptionsOrEstimatesThem)
{
  Cloud cloud = sphereCloud(1000);
  const Point center(0, 0, 0);
  const double area = 4 * winding::pi / 1000;
  FieldOptions options;
  options.tolerance = 0;
  const std::vector<double> cells =
    winding::voronoiAreas(clean(cloud), placesOf(clean(cloud).positions), 20, serial);
  const auto voronoi = fieldOf(cloud, options);
  EXPECT_EQ(voronoi->reference(Point(0.1, 0, 0)),
    winding::referenceSum<double>(clean(cloud), cells, Point(0.1, 0, 0)));
  EXPECT_NEAR(valueAt(*voronoi, center), 1, 0.01);

  options.pointAreaMethod = winding::PointAreaMethod::constant;
  const auto estimated = fieldOf(cloud, options);
  EXPECT_NEAR(estimated->info().pointArea,
    winding::meanPointArea(clean(cloud), placesOf(clean(cloud).positions), 20, serial), 1e-15);
  EXPECT_NEAR(valueAt(*estimated, center), estimated->info().pointArea / area, 1e-12);

  options.pointArea = 2 * area;
  const auto given = fieldOf(cloud, options);
  EXPECT_NEAR(given->info().pointArea, 2 * area, 1e-15);
  EXPECT_NEAR(valueAt(*given, center), 2, 1e-12);

  const std::vector<double> areas(1000, 3 * area);
  winding::OrientedPointsView view = cloud.view();
  view.areas = {areas.data(), areas.size()};
  const auto own = Field::build(std::vector<winding::OrientedPointsView>{view}, options, serial);
  EXPECT_NEAR(own->info().pointArea, 3 * area, 1e-15);
  EXPECT_NEAR(valueAt(*own, center), 3, 1e-12);
}

TEST(Field, WithoutPrimitivesIsZero)
{
  const Point sample(0.5, 0.5, 0.5);
  for (const auto& field : {fieldOf(Mesh()), fieldOf(Mesh(), Method::parity), fieldOf(Cloud())})
  {
    EXPECT_EQ(valueAt(*field, sample), 0);
    EXPECT_EQ(field->info().primitives, 0u);
    EXPECT_TRUE(field->info().bounds.isEmpty());
  }
  const Mesh collapsed{{{1, 1, 1}}, {{0, 0, 0}}};
  EXPECT_EQ(valueAt(*fieldOf(collapsed), sample), 0);
}

TEST(Field, OfAPointWithoutAnAreaIsZeroAndWarns)
{
  const auto field = fieldOf(Cloud{{{0, 0, 0}}, {{0, 0, 1}}});
  EXPECT_EQ(valueAt(*field, {0, 0, -1}), 0);
  ASSERT_EQ(field->info().warnings.size(), 1u);
  EXPECT_TRUE(isNamed(field->info().warnings[0], winding::Parameter::pointArea));
}

TEST(Field, IsNoNumberWhereTheSampleIsNone)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const auto& field :
    {fieldOf(cube()), fieldOf(cube(), Method::parity), fieldOf(sphereCloud(100))})
  {
    for (const Point& sample : {Point(notANumber, 0.5, 0.5), Point(0.5, 0.5, notANumber),
           Point(infinity, 0.5, 0.5), Point(0.5, -infinity, 0.5)})
    {
      EXPECT_TRUE(std::isnan(valueAt(*field, sample))) << sample.transpose();
    }
    EXPECT_NEAR(valueAt(*field, {0.25, 0.5, 0.5}), 1, 0.05);
  }
}

TEST(Field, RefusesWhatItCannotServe)
{
  FieldOptions parity;
  parity.method = Method::parity;
  expectRefused(sphereCloud(10), parity, "parity needs triangles", winding::Parameter::method);
  for (const double area : {-1.0, notANumber, std::numeric_limits<double>::infinity()})
  {
    FieldOptions options;
    options.pointArea = area;
    expectRefused(sphereCloud(10), options, "is ", winding::Parameter::pointArea);
  }
  Mesh bad = cube();
  bad.points.assign(8, {notANumber, notANumber, notANumber});
  expectRefused(bad, FieldOptions(), "12 triangles");
}

TEST(FieldReference, IsTheReferenceSum)
{
  SCOPED_TRACE("seeds 111, 112");
  const Mesh mesh = triangleSoup(100, 111);
  const Cloud cloud = sphereCloud(100);
  const auto surfaceField = fieldOf(mesh);
  const auto cloudField = fieldOf(cloud);
  const std::vector<double> areas =
    winding::voronoiAreas(clean(cloud), placesOf(clean(cloud).positions), 20, serial);
  for (const Point& q : randomPoints(20, -1, 1, 112))
  {
    EXPECT_EQ(surfaceField->reference(q), winding::referenceSum<double>(clean(mesh), q));
    EXPECT_EQ(cloudField->reference(q), winding::referenceSum<double>(clean(cloud), areas, q));
  }
}

TEST(FieldPointOnSource, IsEvenlySpreadOverTheSurface)
{
  SCOPED_TRACE("seed 113");
  // Sides of 1, 2 and 4 make faces of areas 2, 4 and 8, two of each.
  const auto field = fieldOf(cube({0, 0, 0}, {1, 2, 4}));
  Random random(113);
  Point onFaces(0, 0, 0), mean(0, 0, 0);
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i)
  {
    const double u = random(0, 1), v = random(0, 1), t = random(0, 1);
    const Point p = field->pointOnSource()(u, v, t);
    // A point is the weighted mean of three corners, with a few roundings, none of them above
    // 4e-16.
    constexpr double rounding = 1e-15;
    const Eigen::Array3d unit = p.array() / Eigen::Array3d(1, 2, 4);
    const Eigen::Array3d fromFace = unit.min(1 - unit);
    ASSERT_GT(fromFace.minCoeff(), -rounding);
    ASSERT_LT(fromFace.minCoeff(), rounding);
    onFaces += (fromFace < rounding).cast<double>().matrix();
    mean += unit.matrix();
  }
  // The standard deviation of the shares is below 0.0036, that of the means below 0.0033; the
  // bounds are four of these.
  EXPECT_LT((onFaces / count - Point(8, 4, 2) / 14).cwiseAbs().maxCoeff(), 0.0145);
  EXPECT_LT((mean / count - Point(0.5, 0.5, 0.5)).cwiseAbs().maxCoeff(), 0.0135);
}

TEST(FieldPointOnSource, OfACloudIsEachOfItsPoints)
{
  const Cloud cloud = sphereCloud(50);
  const auto field = fieldOf(cloud);
  for (std::size_t i = 0; i < 50; ++i)
  {
    EXPECT_EQ(
      field->pointOnSource()(0, 0, (static_cast<double>(i) + 0.5) / 50), cloud.positions[i]);
  }
}
