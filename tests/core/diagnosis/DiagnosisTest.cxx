// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "diagnosis/Diagnosis.h"

#include "field/Field.h"
#include "support/Fields.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/Shuffled.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace
{

using namespace shapes;
using winding::Field;

/// The faults and facts of a source, one line each.
std::string faultsOf(const Field& field)
{
  std::string lines;
  for (const winding::Message& message : field.diagnosis().ofSource(serial))
  {
    lines += message.fault + "; " + message.facts + "\n";
  }
  return lines;
}

std::string faultsOf(const Mesh& mesh)
{
  return faultsOf(*fieldOf(mesh));
}

/// The mesh with some of its triangles once more, over the same points, turned round or not.
Mesh withAgain(Mesh mesh, std::size_t first, std::size_t last, bool isTurned)
{
  for (std::size_t i = first; i < last; ++i)
  {
    auto triangle = mesh.triangles[i];
    if (isTurned)
    {
      std::swap(triangle[1], triangle[2]);
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

/// A plane square at the height z, of 2 · n² triangles.
Mesh sheet(double z, int n, double low = 0.1, double high = 0.9)
{
  Mesh mesh;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      mesh.points.emplace_back(low + (high - low) * i / n, low + (high - low) * j / n, z);
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const int a = j * (n + 1) + i, b = a + n + 1;
      mesh.triangles.push_back({a, a + 1, b + 1});
      mesh.triangles.push_back({a, b + 1, b});
    }
  }
  return mesh;
}

} // namespace

TEST(Diagnosis, FindsNothingWrongWithSolids)
{
  for (const Mesh& solid : {icosphere(4), cube(), torus(50, 30), surfaceOf(lShape()),
         surfaceOf(randomCells(5, 3)), icosphere(3).with(icosphere(3).moved({0.3, 0.2, 0.1})),
         icosphere(4).part(0, 5000), openCube(), icosphere(3).reversed()})
  {
    EXPECT_EQ(faultsOf(solid), "");
  }
  EXPECT_EQ(faultsOf(Mesh()), "");
}

TEST(Diagnosis, FindsFacesThatAreThereTwice)
{
  const Mesh ball = icosphere(3);
  const std::string fault = "faces are there more than once: they add up, or cancel; ";
  EXPECT_EQ(faultsOf(withAgain(ball, 0, 100, false)), fault + "100 of 1380 triangles\n");
  EXPECT_EQ(faultsOf(withAgain(ball, 0, 1280, true)),
    "every face is there with both senses; nothing is left of them\n");
  EXPECT_EQ(faultsOf(withAgain(ball, 0, 1280, false)), fault + "1280 of 2560 triangles\n")
    << "a whole solid is there twice";
  EXPECT_EQ(faultsOf(withAgain(ball, 0, 400, true)), fault + "400 of 1680 triangles\n");
  // Walls between solids that touch cancel, as they should.
  const Mesh stack = cube().with(cube().moved({0, 0, 1})).with(cube().moved({0, 0, 2}));
  EXPECT_EQ(faultsOf(stack), "");
  // A core that fills the void of its shell.
  const Mesh core = cube({0.3, 0.3, 0.3}, {0.7, 0.7, 0.7});
  EXPECT_EQ(faultsOf(cube().with(core.reversed()).with(core)), "");
  // Bars that overlap and share faces have w = 2 where they do.
  const Mesh bars =
    surfaceOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}).with(surfaceOf({{1, 0, 0}, {1, 1, 0}, {1, 2, 0}}));
  EXPECT_EQ(faultsOf(bars), "");
}

TEST(Diagnosis, FindsManySingleFacesWithBothSenses)
{
  Mesh confetti;
  for (int i = 0; i < 800; ++i)
  {
    const auto first = static_cast<std::int32_t>(confetti.points.size());
    for (const Point& corner : {Point(0, 0, 0), Point(0.3, 0.1, 0), Point(0, 0.2, 0.4)})
    {
      confetti.points.push_back(corner + Point(i % 10, i / 10 % 10, i / 100));
    }
    confetti.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(faultsOf(withAgain(confetti, 0, 800, true)),
    "every face is there with both senses; nothing is left of them\n");
}

TEST(Diagnosis, FindsFacesThatContradictEachOther)
{
  Mesh ball = icosphere(3);
  for (std::size_t i = 0; i < 300; ++i)
  {
    std::swap(ball.triangles[i][1], ball.triangles[i][2]);
  }
  const std::string fault = "faces contradict each other, so that parts cancel; two have the same";
  EXPECT_EQ(faultsOf(ball).rfind(fault, 0), 0u) << faultsOf(ball);
  EXPECT_EQ(faultsOf(moebiusStrip(20)), "1 part has one side only, and no orientation; \n");
  // One triangle of many, where nothing else is wrong.
  Mesh one = icosphere(4);
  std::swap(one.triangles[7][1], one.triangles[7][2]);
  EXPECT_EQ(faultsOf(one), fault + " sense at 3 edges\n");
  // A needle that looks the other way.
  Mesh needle = cube();
  const auto side = needle.triangles[0];
  const auto middle = static_cast<std::int32_t>(needle.points.size());
  const Point &a = needle.points[static_cast<std::size_t>(side[0])],
              &b = needle.points[static_cast<std::size_t>(side[1])],
              &c = needle.points[static_cast<std::size_t>(side[2])];
  needle.points.push_back((a + b) / 2 + 1e-9 * (c - (a + b) / 2));
  needle.triangles[0] = {middle, side[1], side[2]};
  needle.triangles.push_back({side[0], middle, side[2]});
  needle.triangles.push_back({side[0], middle, side[1]}); // should run the other way
  EXPECT_EQ(faultsOf(needle), "");
}

TEST(Diagnosis, FindsOpenPartsThatChangeWhatIsInside)
{
  const std::string fault =
    "open parts lie inside of closed ones; w changes around them, which are";
  const Mesh box = cube();
  Mesh baffles = box, piercing = box;
  for (const double z : {0.2, 0.35, 0.5, 0.65, 0.8})
  {
    baffles = baffles.with(sheet(z, 4));
    piercing = piercing.with(sheet(z, 4).moved({0.15, 0, 0}));
  }
  EXPECT_EQ(faultsOf(baffles).rfind(fault, 0), 0u) << faultsOf(baffles);
  EXPECT_EQ(faultsOf(piercing).find("open parts lie"), std::string::npos)
    << "none is inside as a whole, so that none can be left out: " << faultsOf(piercing);
  EXPECT_EQ(faultsOf(box.with(sheet(0.5, 4))), "") << "w is more than 1/2 beside a single sheet";
  EXPECT_EQ(faultsOf(box.with(sheet(0.5, 4).moved({2, 0, 0}))), "") << "it lies outside";
}

TEST(Diagnosis, FindsPartsThatLookInward)
{
  const Mesh large = icosphere(4), small = icosphere(1).moved({40, 0, 0});
  const auto looksInward = [&](const Mesh& mesh, std::size_t negative)
  {
    winding::SideCounts sides;
    sides.samples = 10000;
    sides.inside = 4000;
    sides.negative = negative;
    return fieldOf(mesh)->diagnosis().facing(sides, winding::InsideTest(), serial).looksInward;
  };
  EXPECT_TRUE(looksInward(large.with(small.reversed()), 1)) << "small parts are meant";
  EXPECT_FALSE(looksInward(large.with(small), 1)) << "pockets are not";
  EXPECT_FALSE(looksInward(
    large.with(large.mapped([](const Point& p) { return Point(p / 2); }).reversed()), 1))
    << "a cavity looks inward";
  // An open source looks inward if most of a part does.
  EXPECT_TRUE(looksInward(large.part(0, 5000).reversed(), 1000));
  EXPECT_FALSE(looksInward(large.part(0, 5000), 1000));
  EXPECT_TRUE(looksInward(large.with(large.moved({5, 0, 0}).part(0, 5000).reversed()), 1000));
}

TEST(Diagnosis, IsTheSameForAnyOrder)
{
  Mesh baffles = cube();
  for (const double z : {0.2, 0.35, 0.5, 0.65, 0.8})
  {
    baffles = baffles.with(sheet(z, 4));
  }
  for (const Mesh& mesh : {withAgain(icosphere(4), 0, 1000, true), baffles,
         withAgain(icosphere(2), 10, 20, false), triangleSoup(3000, 4)})
  {
    const std::string faults = faultsOf(mesh);
    for (const unsigned seed : {1u, 2u, 3u})
    {
      Random random(seed);
      const Mesh other = shuffled(mesh, [&random](std::size_t n) { return random.bits() % n; });
      EXPECT_EQ(faultsOf(other), faults) << seed;
    }
  }
}

TEST(Diagnosis, MayBeAskedByManyThreads)
{
  const auto field = fieldOf(withAgain(icosphere(5), 0, 2000, false));
  std::vector<std::string> found(4);
  std::vector<std::thread> threads;
  for (std::string& own : found)
  {
    threads.emplace_back([&own, &field] { own = faultsOf(*field); });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const std::string& own : found)
  {
    EXPECT_EQ(own, faultsOf(*field));
    EXPECT_FALSE(own.empty());
  }
}

TEST(Diagnosis, IsInterrupted)
{
  class Interrupting final : public winding::Executor
  {
  public:
    void run(std::size_t, const std::function<void(std::size_t)>&) override
    {
      throw winding::Interrupted();
    }
  };
  const auto field = fieldOf(withAgain(icosphere(3), 0, 100, false));
  Interrupting interrupting;
  EXPECT_THROW(field->diagnosis().ofSource(interrupting), winding::Interrupted);
  EXPECT_NE(faultsOf(*field), "") << "the next one finds what there is";
}
