#include "cloud/SheetCuts.h"

#include "support/Places.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace
{

using namespace shapes;

struct Sheets
{
  std::vector<Point> positions, smooth;
};

/// Points of unit spheres around the centres, with outward normals.
Sheets spheres(const std::vector<Point>& centers, std::size_t pointsEach)
{
  Sheets sheets;
  Random random(331);
  for (const Point& center : centers)
  {
    for (std::size_t i = 0; i < pointsEach; ++i)
    {
      const Point normal = random.point(-1, 1).normalized();
      sheets.positions.push_back(center + normal);
      sheets.smooth.push_back(normal);
    }
  }
  return sheets;
}

bool isCut(const Sheets& sheets, const std::function<bool(const Point&)>& isTurned)
{
  std::vector<Point> turned = sheets.smooth;
  for (std::size_t i = 0; i < turned.size(); ++i)
  {
    turned[i] *= isTurned(sheets.positions[i]) ? -1 : 1;
  }
  winding::SerialExecutor serial;
  const bool result = winding::cutSheets(placesOf(sheets.positions), sheets.smooth, turned, serial);
  ShuffledThreads threads(332);
  EXPECT_EQ(winding::cutSheets(placesOf(sheets.positions), sheets.smooth, turned, threads), result);
  return result;
}

} // namespace

TEST(SheetCuts, AreWhereWallsInsideOfAnotherSolidAreTurned)
{
  SCOPED_TRACE("seed 331");
  const Point right(1.2, 0, 0);
  const Sheets sheets = spheres({Point(0, 0, 0), right}, 20'000);
  const auto isInsideOfTheOther = [&](const Point& p)
  {
    return p.norm() < 0.999 || (p - right).norm() < 0.999;
  };
  EXPECT_TRUE(isCut(sheets, isInsideOfTheOther));
  EXPECT_TRUE(isCut(sheets, [](const Point& p) { return p[0] < 0; }));
  EXPECT_FALSE(isCut(sheets, [](const Point&) { return false; }));
  EXPECT_FALSE(isCut(sheets, [](const Point&) { return true; }));
}

TEST(SheetCuts, AreNotBetweenParts)
{
  SCOPED_TRACE("seed 331");
  const Sheets sheets = spheres({Point(0, 0, 0), Point(2.1, 0, 0), Point(0, 5, 0)}, 20'000);
  EXPECT_FALSE(isCut(sheets, [](const Point& p) { return p[0] > 1.05; }));
  EXPECT_FALSE(isCut(sheets, [](const Point& p) { return p[1] > 2; }));
}

TEST(SheetCuts, OfFewPointsAreNone)
{
  EXPECT_FALSE(isCut(spheres({}, 0), [](const Point&) { return true; }));
  EXPECT_FALSE(isCut(spheres({Point(0, 0, 0)}, 1), [](const Point&) { return true; }));
}
