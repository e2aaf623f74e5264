// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/LevelEdges.h"
#include "base/Executor.h"
#include "support/Fields.h"
#include "support/Interruption.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using namespace shapes;
using winding::Field;
using winding::GridEdge;
using winding::InsideRule;
using winding::InsideTest;
using winding::LevelEdges;

struct Subject
{
  const char* name;
  std::shared_ptr<const Field> field;
  bool isInteger;
};

std::vector<Subject> subjects()
{
  const auto shrunk = [](const Point& p) -> Point
  {
    return 0.5 * p + Point(0.1, 0.2, 0.3);
  };
  const Mesh ball = icosphere(3), nested = ball.with(ball.mapped(shrunk));
  const Mesh lattice =
    surfaceOf(randomCells(3, 7))
      .mapped([](const Point& p) -> Point { return 0.6 * p - Point::Constant(0.9); });
  const Mesh open = ball.part(0, 1000);
  const Cloud cloud = sphereCloud(500);
  return {{"closed", fieldOf(ball), true}, {"nested", fieldOf(nested), true},
    {"lattice", fieldOf(lattice), true}, {"open", fieldOf(open), false},
    {"far field", fieldOf(nested, winding::Method::hierarchical), false},
    {"parity", fieldOf(ball, winding::Method::parity), false}, {"cloud", fieldOf(cloud), false},
    {"nothing", fieldOf(Mesh()), true}};
}

/// The samples of a whole grid; all samples around it are outside.
struct Samples
{
  Samples(const Field& field, const winding::Grid& grid, const InsideTest& isInside)
    : extent(grid.wholeExtent())
    , values(winding::sampleCount(extent))
    , inside(values.size())
  {
    winding::FieldOutput output;
    output.values = values.data();
    output.inside = inside.data();
    output.isInside = isInside;
    field.evaluate(grid, extent, output, serial);
  }

  bool isIn(const std::array<int, 3>& sample) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (sample[axis] < 0 || sample[axis] > extent[2 * axis + 1])
      {
        return false;
      }
    }
    return true;
  }
  std::size_t number(const std::array<int, 3>& s) const
  {
    return winding::sampleNumber(extent, s[0], s[1], s[2]);
  }
  bool isInside(const std::array<int, 3>& s) const { return isIn(s) && inside[number(s)] != 0; }

  winding::Extent extent;
  std::vector<float> values;
  std::vector<unsigned char> inside;
};

/// Compares the edges with those found by looking at every sample of the whole grid. Returns their
/// number.
std::size_t expectAllEdges(
  const LevelEdges& edges, const Samples& samples, int border, bool hasValues)
{
  std::size_t next = 0;
  const winding::Extent& e = samples.extent;
  for (int k = -border; k <= e[5] + border; ++k)
  {
    for (int j = -border; j <= e[3] + border; ++j)
    {
      EXPECT_EQ(edges.beginsInside(j, k), samples.isInside({-border, j, k})) << j << " " << k;
      for (int axis = 0; axis < 3; ++axis)
      {
        const std::size_t first = next;
        for (int i = -border; i <= e[1] + border; ++i)
        {
          const std::array<int, 3> here = {i, j, k};
          std::array<int, 3> there = here;
          ++there[axis];
          const bool isInGrid = samples.isIn(here) && samples.isIn(there);
          const bool isEdge =
            samples.isInside(here) != samples.isInside(there) && (isInGrid || border > 0);
          EXPECT_EQ(edges.find(here, axis), isEdge ? next : edges.size());
          if (!isEdge)
          {
            continue;
          }
          if (next >= edges.size())
          {
            ADD_FAILURE() << "edges are missing";
            return next;
          }
          const GridEdge& edge = edges[next];
          EXPECT_EQ(edge.sample, here);
          EXPECT_EQ(edge.axis, axis);
          EXPECT_EQ(edge.firstIsInside, samples.isInside(here));
          EXPECT_EQ(edges.isAtBorder(edge), !isInGrid);
          const std::array<float, 2>* values = edges.values(next);
          EXPECT_EQ(values != nullptr, hasValues);
          if (values && isInGrid)
          {
            EXPECT_EQ((*values)[0], samples.values[samples.number(here)]);
            EXPECT_EQ((*values)[1], samples.values[samples.number(there)]);
          }
          ++next;
        }
        EXPECT_EQ(edges.inRow(axis, j, k), std::pair(first, next));
        if (testing::Test::HasFailure())
        {
          return next;
        }
      }
    }
  }
  EXPECT_EQ(next, edges.size());
  return next;
}

void advance(LevelEdges& edges, winding::Executor& executor)
{
  double last = -1;
  while (!edges.isDone())
  {
    EXPECT_GT(edges.progress(), last);
    last = edges.progress();
    const double next = edges.nextProgress();
    edges.advance(executor);
    EXPECT_EQ(edges.progress(), next);
  }
  EXPECT_EQ(edges.progress(), 1);
}

class LevelEdgesOf : public testing::TestWithParam<std::size_t>
{
protected:
  Subject subject = subjects()[GetParam()];
};

TEST_P(LevelEdgesOf, AreThoseBetweenAllSamplesInOneSlabOrMany)
{
  // The grids lie around the source, or cut it off, and have layers enough for three slabs, or one
  // layer only.
  for (const auto& [corner, dimensions] : {std::pair<double, Eigen::Vector3i>{-1.2, {11, 12, 40}},
         {-0.55, {7, 9, 33}}, {-1.2, {5, 4, 1}}})
  {
    winding::Grid grid;
    grid.dimensions = dimensions;
    grid.spacing = (-2 * corner) * dimensions.cast<double>().cwiseInverse();
    grid.firstSample = Eigen::Vector3d::Constant(corner) + 0.5 * grid.spacing;
    std::size_t count = 0;
    for (const InsideRule rule :
      {InsideRule::signedThreshold, InsideRule::absoluteThreshold, InsideRule::odd})
    {
      const Samples samples(*subject.field, grid, {rule});
      for (const int border : {0, 1})
      {
        for (const double slabBytes : {0.0, LevelEdges::usualSlabBytes})
        {
          SCOPED_TRACE(std::string(subject.name) + ", border " + std::to_string(border));
          LevelEdges edges(*subject.field, grid, {rule}, border > 0, slabBytes);
          ShuffledThreads threads(3);
          advance(edges, threads);
          const std::size_t found =
            expectAllEdges(edges, samples, border, !subject.isInteger && edges.size() > 0);
          count += found;
        }
      }
    }
    EXPECT_EQ(count > 0, subject.field->info().primitives > 0) << subject.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Subjects, LevelEdgesOf, testing::Range<std::size_t>(0, 8),
  [](const auto& number)
  {
    std::string name = subjects()[number.param].name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
  });

TEST(LevelEdges, AreInterruptedWithoutAnAdvance)
{
  winding::Grid grid;
  grid.dimensions = {8, 8, 8};
  Interruption interruption(0);
  for (const Subject& subject : subjects())
  {
    if (subject.field->info().primitives == 0)
    {
      continue;
    }
    LevelEdges edges(*subject.field, grid, InsideTest(), false);
    EXPECT_THROW(edges.advance(interruption), winding::Interrupted) << subject.name;
    EXPECT_FALSE(edges.isDone());
  }
}

} // namespace
