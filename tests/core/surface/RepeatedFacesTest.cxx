#include "surface/RepeatedFaces.h"

#include "field/Field.h"
#include "support/EdgesOf.h"
#include "support/Shapes.h"
#include "surface/Orientation.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using namespace shapes;
using winding::FaceKind;
using winding::Orientation;
using winding::PolygonParts;
using winding::RepeatedFaces;
using winding::Surface;

/// Some of the triangles once more, over the same points, with the other sense or the same.
Mesh withRepeated(Mesh mesh, std::size_t first, std::size_t last, bool isTurned)
{
  for (std::size_t i = first; i < last; ++i)
  {
    auto triangle = mesh.triangles[i];
    if (isTurned)
    {
      std::swap(triangle[1], triangle[2]);
    }
    std::rotate(triangle.begin(), triangle.begin() + i % 3, triangle.end());
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

/// The surface of a mesh once it is oriented.
Surface outward(const Mesh& mesh)
{
  Surface surface = clean(mesh);
  winding::SerialExecutor serial;
  apply(orient(surface, edgesOf(surface), {}, serial), surface);
  return surface;
}

double volumeOf(const Surface& surface)
{
  double volume = 0;
  for (const winding::Triangle& t : surface.triangles)
  {
    volume += surface.vertices[t[0]].dot(surface.vertices[t[1]].cross(surface.vertices[t[2]])) / 6;
  }
  return volume;
}

Mesh moved(const Mesh& mesh, const Point& by)
{
  return mesh.mapped([by](const Point& p) { return Point(p + by); });
}

TEST(RepeatedFaces, AreKnownByTheirCornersWhereverTheyBegin)
{
  const Mesh ball = icosphere(1); // 80 triangles
  EXPECT_FALSE(repeatedFaces(clean(ball), {}).areAny());

  const RepeatedFaces twice = repeatedFaces(clean(withRepeated(ball, 0, 80, false)), {});
  EXPECT_EQ(twice.repeated, 80u);
  EXPECT_EQ(twice.single, 80u);
  EXPECT_EQ(twice.pairs, 0u);
  EXPECT_FALSE(twice.cancelAll());

  const RepeatedFaces twoSided = repeatedFaces(clean(withRepeated(ball, 0, 80, true)), {});
  EXPECT_EQ(twoSided.pairs, 80u);
  EXPECT_TRUE(twoSided.cancelAll());
  EXPECT_EQ(std::count(twoSided.kinds.begin(), twoSided.kinds.end(), FaceKind::facing), 80);
  EXPECT_EQ(twoSided.kinds[80], FaceKind::opposite);

  EXPECT_FALSE(repeatedFaces(clean(withRepeated(ball, 0, 79, true)), {}).cancelAll());
}

TEST(RepeatedFaces, PolygonsAreEqualHoweverTheyAreCut)
{
  // The square (0 1 2 3), and round the other way (3 2 1 0), which is cut along the other diagonal.
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {3, 2, 1}, {3, 1, 0}};
  const Surface surface = clean(mesh);
  EXPECT_EQ(repeatedFaces(surface, {0, 1, 0, 1}).pairs, 1u);
  EXPECT_TRUE(repeatedFaces(surface, {0, 1, 0, 1}).cancelAll());
  EXPECT_FALSE(repeatedFaces(surface, {}).areAny());

  // The same corners in another order are another face.
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 1, 3}};
  EXPECT_FALSE(repeatedFaces(clean(mesh), {0, 1, 0, 1}).areAny());
}

TEST(RepeatedFaces, OneOfEachPairGivesTheSolidBack)
{
  const Mesh ball = icosphere(2); // 320 triangles
  const double volume = volumeOf(clean(ball));
  for (const Mesh& solid : {ball, ball.reversed()})
  {
    for (const bool isTurned : {false, true})
    {
      for (const std::size_t last : {1u, 160u, 319u, 320u})
      {
        const Surface surface = outward(withRepeated(solid, 0, last, isTurned));
        EXPECT_EQ(surface.triangles.size(), 320u) << last;
        EXPECT_EQ(surface.vertices.size(), clean(ball).vertices.size());
        EXPECT_NEAR(volumeOf(surface), volume, 1e-12) << last; // measured: 2e-15
      }
    }
  }
  // A ball drawn from both sides, and then its faces once more.
  const Surface thrice = outward(withRepeated(withRepeated(ball, 0, 320, true), 100, 600, false));
  EXPECT_EQ(thrice.triangles.size(), 320u);
  EXPECT_NEAR(volumeOf(thrice), volume, 1e-12);
}

TEST(RepeatedFaces, WallsOfSolidsThatTouchStay)
{
  // Two cubes with a wall in common, which each of them has.
  const Surface stack = outward(cube().with(moved(cube(), {0, 0, 1})));
  EXPECT_EQ(stack.triangles.size(), 24u);
  EXPECT_NEAR(volumeOf(stack), 2, 1e-12);

  // One of them drawn from both sides is a solid by itself.
  const Mesh twoSided = withRepeated(cube(), 0, 12, true);
  const Surface both = outward(moved(cube(), {3, 0, 0}).with(twoSided));
  EXPECT_EQ(both.triangles.size(), 24u);
  EXPECT_NEAR(volumeOf(both), 2, 1e-12);
}

TEST(RepeatedFaces, AWallStaysThoughBothSolidsHaveItInOneSense)
{
  // One of two boxes is inward. All of it cancels at the edges of the wall, and so it stays.
  const Mesh stack = cube().with(moved(cube().reversed(), {0, 0, 1}));
  EXPECT_EQ(repeatedFaces(clean(stack), {}).repeated, 2u);
  EXPECT_EQ(outward(stack).triangles.size(), 24u);
}

TEST(RepeatedFaces, NoWallStaysWhereASolidThatTouchesIsDrawnFromBothSides)
{
  // Five boxes in a column, some of them from both sides, in any order of faces.
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    Mesh block;
    for (int i = 0; i < 5; ++i)
    {
      const Mesh box = moved(cube(), Point(0, 0, i));
      block = block.with(i == 2 || random(0, 1) < 0.5 ? withRepeated(box, 0, 12, true) : box);
    }
    for (std::size_t i = block.triangles.size(); i > 1; --i)
    {
      std::swap(block.triangles[i - 1],
        block.triangles[static_cast<std::size_t>(random(0, 1) * static_cast<double>(i))]);
    }
    EXPECT_NEAR(volumeOf(outward(block)), 5, 1e-12);
  }
}

TEST(RepeatedFaces, TheMajorityOfThreeStands)
{
  const Mesh ball = icosphere(1); // 80 triangles
  const Mesh three = withRepeated(withRepeated(ball, 0, 80, true), 0, 80, false);
  const RepeatedFaces faces = repeatedFaces(clean(three), {});
  EXPECT_EQ(faces.pairs, 0u);
  EXPECT_EQ(faces.single, 80u);
  EXPECT_EQ(faces.repeated, 160u);
  EXPECT_EQ(faces.kinds[0], FaceKind::first);
}

TEST(RepeatedFaces, AnOpenSheetKeepsOneSideUnlessItIsInsideOfASolid)
{
  Mesh sheet;
  sheet.points = {{0.2, 0.2, 0.5}, {0.8, 0.2, 0.5}, {0.8, 0.8, 0.5}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 1}};
  EXPECT_EQ(outward(sheet).triangles.size(), 1u);
  EXPECT_EQ(outward(cube().with(sheet)).triangles.size(), 12u) << "it bounded nothing before";
  EXPECT_EQ(outward(cube().with(moved(sheet, {5, 0, 0}))).triangles.size(), 13u);
}

TEST(RepeatedFaces, AFieldTakesThemOnceIfItIsAskedTo)
{
  const Mesh twoSided = withRepeated(icosphere(2), 0, 320, true);
  const double place[3] = {0.1, 0.2, 0.3};
  winding::SerialExecutor serial;
  winding::FieldOptions options;
  for (const bool orients : {false, true})
  {
    options.orientFaces = orients;
    const auto field = winding::Field::build({twoSided.view()}, options, serial);
    float w = -1;
    winding::FieldOutput output;
    output.values = &w;
    field->evaluate(winding::VectorsView(place, 1), output, serial);
    EXPECT_EQ(w, orients ? 1 : 0);
    EXPECT_EQ(field->info().warnings.size(), orients ? 0u : 1u);
  }
}

} // namespace
