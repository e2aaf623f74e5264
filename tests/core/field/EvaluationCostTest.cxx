#include "base/Views.h"
#include "cloud/CloudCost.h"
#include "distance/DistanceCost.h"
#include "farfield/FarFieldCost.h"
#include "field/Field.h"
#include "rays/CrossingCost.h"
#include "source/SourceArea.h"
#include "sums/DirectSumCost.h"
#include "support/Shapes.h"
#include "surface/SurfaceCost.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace
{

using namespace shapes;
using winding::EvaluationCost;
using winding::Field;
using winding::FieldOptions;
using winding::Method;
using winding::Primitive;
using winding::SampledSource;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A source whose area is about that of a ball in the box of the samples.
SampledSource sourceOf(
  Primitive kind, std::size_t primitives, std::size_t samples, bool isGrid = true)
{
  SampledSource source;
  source.kind = kind;
  source.primitives = primitives;
  source.samples = samples;
  source.isGrid = isGrid;
  source.area = 2.5 * std::pow(static_cast<double>(samples), 2.0 / 3);
  return source;
}

std::shared_ptr<const Field> fieldOf(const Mesh& mesh, const FieldOptions& options = {})
{
  winding::SerialExecutor serial;
  return Field::build(std::vector<winding::TrianglesView>{mesh.view()}, options, serial);
}

std::shared_ptr<const Field> fieldOf(
  const winding::OrientedPointsView& cloud, const FieldOptions& options = {})
{
  winding::SerialExecutor serial;
  return Field::build(std::vector<winding::OrientedPointsView>{cloud}, options, serial);
}

double secondsOf(const Field& field, std::size_t samples)
{
  return field.expectedCost(samples).seconds;
}

/// The mean of values at equal ratios may be off by as much.
void expectAbout(double value, double expected)
{
  EXPECT_GT(value, expected / 1.2);
  EXPECT_LT(value, expected * 1.2);
}

} // namespace

TEST(EvaluationCost, GrowsWithWhatThereIsToDo)
{
  for (const Primitive kind : {Primitive::triangle, Primitive::point})
  {
    double direct = 0, far = 0;
    for (std::size_t samples = 1000; samples <= 1'000'000'000; samples *= 10)
    {
      const EvaluationCost sum = winding::costOfDirectSum(sourceOf(kind, 10'000, samples));
      const EvaluationCost tree = winding::costOfFarField(sourceOf(kind, 10'000, samples), 5);
      EXPECT_GT(sum.seconds, direct);
      EXPECT_GT(tree.seconds, far);
      EXPECT_GT(tree.bytes, sum.bytes) << "a tree takes memory";
      direct = sum.seconds;
      far = tree.seconds;
    }
    double before = 0;
    for (const int order : {3, 5, 7, 9})
    {
      const double seconds =
        winding::costOfFarField(sourceOf(kind, 10'000, 1'000'000), order).seconds;
      EXPECT_GT(seconds, before);
      before = seconds;
    }
  }
  for (const std::size_t samples : {1000, 100'000, 1'000'000})
  {
    EXPECT_LT(winding::costOfCrossings(100'000, samples).seconds,
      winding::costOfFarField(sourceOf(Primitive::triangle, 100'000, samples, false), 5).seconds);
  }
  EXPECT_LT(winding::costOfRows(sourceOf(Primitive::triangle, 100'000, 10'000'000)).seconds,
    winding::costOfFarField(sourceOf(Primitive::triangle, 100'000, 10'000'000), 3).seconds);
  // Most triangles smaller than voxels lie between the rows.
  SampledSource large = sourceOf(Primitive::triangle, 20'000'000, 1'000'000), small = large;
  large.area = 20'000'000;
  small.area = 200'000;
  EXPECT_LT(1.5 * winding::costOfRows(small).seconds, winding::costOfRows(large).seconds);
}

TEST(EvaluationCost, OfTheDirectSumIsThatOfItsTerms)
{
  for (const Primitive kind : {Primitive::triangle, Primitive::point})
  {
    const double one = winding::costOfDirectSum(sourceOf(kind, 1000, 1000)).seconds;
    expectAbout(winding::costOfDirectSum(sourceOf(kind, 10'000, 1000)).seconds, 10 * one);
    expectAbout(winding::costOfDirectSum(sourceOf(kind, 1000, 10'000)).seconds, 10 * one);
  }
}

TEST(EvaluationCost, OfTheFarFieldIsThatOfTheTreeTheSamplesAndThoseNearTheSource)
{
  const auto secondsOf = [](SampledSource source, double area)
  {
    source.area = area;
    return winding::costOfFarField(source, 5).seconds;
  };
  for (const Primitive kind : {Primitive::triangle, Primitive::point})
  {
    // Many primitives at few samples take the time of a tree, whatever the area.
    const double tree = secondsOf(sourceOf(kind, 1'000'000, 10), 10);
    expectAbout(secondsOf(sourceOf(kind, 10'000'000, 10), 10), 10 * tree);
    // An area twice as large has twice as many samples near it.
    const SampledSource many = sourceOf(kind, 100'000, 100'000);
    const double none = secondsOf(many, 0);
    expectAbout(secondsOf(many, 20'000) - none, 2 * (secondsOf(many, 10'000) - none));
    // Samples that are far away take time, too, and more where they are not on a grid.
    expectAbout(secondsOf(sourceOf(kind, 10, 2'000'000), 10),
      2 * secondsOf(sourceOf(kind, 10, 1'000'000), 10));
    EXPECT_GT(secondsOf(sourceOf(kind, 10, 1'000'000, false), 10),
      2 * secondsOf(sourceOf(kind, 10, 1'000'000), 10));
  }
  // Large triangles are cut, so that few of them are near to as many samples; few points are not.
  const double many = secondsOf(sourceOf(Primitive::triangle, 20'000, 1'000'000), 20'000);
  const double few = secondsOf(sourceOf(Primitive::triangle, 200, 1'000'000), 20'000);
  expectAbout(few, many);
  // No sample is near to more triangles than there are.
  const SampledSource two = sourceOf(Primitive::triangle, 2, 1'000'000);
  EXPECT_EQ(secondsOf(two, 1e10), secondsOf(two, 1e9));
  EXPECT_LT(secondsOf(two, 1e9), 2 * winding::costOfDirectSum(two).seconds);
  EXPECT_LT(secondsOf(sourceOf(Primitive::point, 20, 1'000'000), 20'000),
    0.7 * secondsOf(sourceOf(Primitive::point, 20'000, 1'000'000), 20'000));
}

TEST(EvaluationCost, OfDistancesIsThatOfTheBandWhereThereIsOne)
{
  for (const Primitive kind : {Primitive::triangle, Primitive::point})
  {
    const SampledSource source = sourceOf(kind, 10'000, 1'000'000);
    const double all = winding::costOfDistances(source).seconds;
    double before = 0;
    for (const double band : {1.0, 3.0, 9.0})
    {
      const double seconds = winding::costOfDistances(source, band).seconds;
      EXPECT_GT(seconds, before);
      EXPECT_LT(seconds, all);
      before = seconds;
    }
    EXPECT_EQ(winding::costOfDistances(source, 1e9).seconds, all);
    // Primitives that are finer than the grid cost more than samples; scattered samples, each of
    // them alone, cost more than those of a grid.
    expectAbout(winding::costOfDistances(sourceOf(kind, 10'000'000, 1000)).seconds,
      10 * winding::costOfDistances(sourceOf(kind, 1'000'000, 1000)).seconds);
    EXPECT_GT(winding::costOfDistances(sourceOf(kind, 10'000, 1'000'000, false)).seconds, 3 * all);
  }
}

TEST(EvaluationCost, OfPreparingIsThatOfTrianglesAndPointsAndMoreBeyondTheCaches)
{
  const double merged = winding::secondsToPrepareSurface(10'000, 5'000, 0);
  const double apart = winding::secondsToPrepareSurface(10'000, 30'000, 0);
  EXPECT_GT(apart, 1.5 * merged) << "every point is welded";
  expectAbout(winding::secondsToPrepareSurface(40'000, 20'000, 0), 4 * merged);
  const double huge = winding::secondsToPrepareSurface(10'000'000, 5'000'000, 0);
  EXPECT_GT(huge, 1500 * merged);
  EXPECT_LT(huge, 3000 * merged);
  const double open = winding::secondsToPrepareSurface(10'000, 5'000, 1'000);
  EXPECT_GT(open, 2 * merged) << "boundaries take more time than triangles";
  EXPECT_EQ(winding::slowdownByCacheMisses(0), 1);
  EXPECT_EQ(winding::slowdownByCacheMisses(10'000), 1);
}

TEST(EvaluationCost, OfCloudsIsThatOfAreasAndNormalsWhereTheyAreNotGiven)
{
  using winding::NormalWork;
  const double given = winding::secondsToPrepareCloud(100'000, 20, false, NormalWork::none);
  const double areas = winding::secondsToPrepareCloud(100'000, 20, true, NormalWork::none);
  const double both = winding::secondsToPrepareCloud(100'000, 20, true, NormalWork::tree);
  EXPECT_GT(areas, 5 * given);
  EXPECT_GT(both, 2 * areas);
  EXPECT_GT(winding::secondsToPrepareCloud(100'000, 20, true, NormalWork::patches), 8 * both);
  expectAbout(winding::secondsToPrepareCloud(200'000, 20, true, NormalWork::tree), 2 * both);
  EXPECT_GT(winding::secondsToPrepareCloud(100'000, 200, true, NormalWork::none), 10 * areas)
    << "cells of many neighbours";
  EXPECT_EQ(winding::secondsToPrepareCloud(10, 200, true, NormalWork::tree),
    winding::secondsToPrepareCloud(10, 10, true, NormalWork::tree))
    << "there are no more than the points";
}

TEST(EvaluationCost, OfFieldsHasAllThatTheyNeed)
{
  constexpr std::size_t samples = 64 * 64 * 64;
  const auto closed = fieldOf(icosphere(4)); // 5120 triangles
  EXPECT_GT(secondsOf(*closed, samples), closed->expectedCostOfValues(samples).seconds);
  EXPECT_GT(secondsOf(*closed, 8 * samples), secondsOf(*closed, samples));
  // A cap over holes is summed at all samples, and a large one takes longer.
  const auto withHole = fieldOf(icosphere(4).part(0, 5119));
  const auto half = fieldOf(icosphere(4).part(0, 2560));
  EXPECT_GT(secondsOf(*withHole, samples), 1.3 * secondsOf(*closed, samples));
  EXPECT_GT(secondsOf(*half, samples), 2 * secondsOf(*withHole, samples));

  const Cloud cloud = sphereCloud(5000);
  const std::vector<double> areas(5000, 0.0025);
  winding::OrientedPointsView withAreas = cloud.view(), withoutNormals = cloud.view();
  withAreas.areas = winding::ScalarsView(areas.data(), areas.size());
  withoutNormals.normals = {};
  FieldOptions estimating;
  estimating.estimateNormals = true;
  FieldOptions constant;
  constant.pointAreaMethod = winding::PointAreaMethod::constant;
  const double ofAreas = secondsOf(*fieldOf(cloud.view()), 1000);
  EXPECT_GT(ofAreas, 2 * secondsOf(*fieldOf(withAreas), 1000));
  EXPECT_GT(secondsOf(*fieldOf(withoutNormals, estimating), 1000), 1.5 * ofAreas);
  EXPECT_NEAR(secondsOf(*fieldOf(cloud.view(), constant), 1000), ofAreas, 0.1 * ofAreas)
    << "the mean of the same areas";
  constant.pointArea = 0.0025;
  EXPECT_LT(secondsOf(*fieldOf(cloud.view(), constant), 1000), 0.5 * ofAreas);
  FieldOptions regularized;
  regularized.regularization = 2;
  EXPECT_GT(secondsOf(*fieldOf(withAreas, regularized), samples),
    2 * secondsOf(*fieldOf(withAreas), samples));
}

TEST(EvaluationCost, OfFieldsDependsOnTheSamplesButNotOnTheUnit)
{
  constexpr std::size_t samples = 100'000;
  for (const Method method : {Method::rows, Method::hierarchical, Method::direct})
  {
    FieldOptions options;
    options.method = method;
    const Mesh sphere = icosphere(3);
    const auto field = fieldOf(sphere, options);
    for (const double scale : {0x1p-300, 0x1p300})
    {
      const auto scaled =
        fieldOf(sphere.mapped([&](const Point& p) -> Point { return scale * p; }), options);
      expectAbout(secondsOf(*scaled, samples), secondsOf(*field, samples));
      expectAbout(scaled->expectedCostOfDistances(samples, 0.1 * scale).seconds,
        field->expectedCostOfDistances(samples, 0.1).seconds);
    }
    EXPECT_LT(field->expectedCostOfDistances(samples, 0.1).seconds,
      field->expectedCostOfDistances(samples).seconds);
  }
  FieldOptions scattered;
  scattered.scattered = true;
  EXPECT_GT(fieldOf(icosphere(3), scattered)->expectedCostOfDistances(samples).seconds,
    2 * fieldOf(icosphere(3))->expectedCostOfDistances(samples).seconds);
  // Nothing is expected of nothing but its values.
  EXPECT_LT(secondsOf(*fieldOf(Mesh()), samples), 1e-3);
  EXPECT_LT(fieldOf(Mesh())->expectedCostOfDistances(samples, infinity).seconds, 0.1);
}

TEST(SourceArea, IsThatOfTheTriangles)
{
  const winding::Surface surface = clean(cube({1, 1, 1}, {2, 3, 4}));
  EXPECT_DOUBLE_EQ(winding::areaOf(surface.vertices, surface.triangles), 22);
  EXPECT_EQ(winding::areaOf(surface.vertices, {}), 0);
}

TEST(SourceArea, IsNearlyThatOfTheTrianglesWhereSomeOfManyAreAsked)
{
  const winding::Surface few = clean(icosphere(3)), many = clean(icosphere(7));
  EXPECT_EQ(winding::approximateAreaOf(few.vertices, few.triangles),
    winding::areaOf(few.vertices, few.triangles));
  EXPECT_EQ(winding::approximateAreaOf(few.vertices, {}), 0);
  ASSERT_GT(many.triangles.size(), 4 * 65536u);
  const double area = winding::areaOf(many.vertices, many.triangles);
  EXPECT_NEAR(winding::approximateAreaOf(many.vertices, many.triangles), area, 0.01 * area);
}

TEST(SourceArea, HasSamplesInTheBoundsAndATwentiethAround)
{
  const winding::Bounds bounds(Point(1, 1, 1), Point(2, 3, 5));
  EXPECT_NEAR(
    winding::distanceBetweenSamples(bounds, 1000), std::cbrt(1.4 * 2.4 * 4.4 / 1000), 1e-12);
  const winding::Bounds flat(Point(0, 0, 0), Point(1e200, 1e200, 0));
  EXPECT_NEAR(
    winding::distanceBetweenSamples(flat, 1000), std::cbrt(1.1 * 1.1 * 0.1 / 1000) * 1e200, 1e188);
  EXPECT_EQ(winding::distanceBetweenSamples(bounds, 0), 0);
  EXPECT_EQ(winding::distanceBetweenSamples(winding::Bounds(), 1000), 0);
}

TEST(EvaluationCost, HasFewPrimitivesAndFewSamplesSummedDirectly)
{
  for (const Primitive kind : {Primitive::triangle, Primitive::point})
  {
    EXPECT_TRUE(winding::isCheaperDirectly(kind, 1, 5));
    EXPECT_TRUE(winding::isCheaperDirectly(kind, 10, 5));
    EXPECT_FALSE(winding::isCheaperDirectly(kind, 100, 5)) << "measured: from 27 and 37 on";
    EXPECT_FALSE(winding::isCheaperDirectly(kind, 1'000'000, 9));
    EXPECT_TRUE(winding::isCheaperDirectly(kind, 1'000'000, 10, 5)) << "ten samples need no tree";
    EXPECT_FALSE(winding::isCheaperDirectly(kind, 1'000'000, 100'000, 5));
    EXPECT_FALSE(winding::isCheaperDirectly(kind, 1'000'000, 10, 5, winding::FarFieldState::built));
    EXPECT_TRUE(winding::isCheaperDirectly(kind, 100, 10, 5, winding::FarFieldState::built));
  }
}
