// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/FarFieldChoice.h"
#include "field/Field.h"
#include "support/Fields.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>


namespace
{

using namespace shapes;
using winding::Field;
using winding::Method;

TEST(ExpectedMemory, HasTreesAndCapsInAddition)
{
  constexpr std::size_t samples = 64 * 64 * 64;
  const Mesh closed = icosphere(4), open = closed.part(0, 2560);
  const std::size_t direct = fieldOf(closed, Method::direct)->expectedBytes(samples);
  EXPECT_EQ(direct, 5120 * winding::bytesPerPrimitive);
  EXPECT_GT(fieldOf(closed, Method::rows)->expectedBytes(samples), direct);
  EXPECT_GT(fieldOf(closed, Method::hierarchical)->expectedBytes(samples), 2 * direct);
  EXPECT_GT(fieldOf(open, Method::rows)->expectedBytes(samples),
    fieldOf(closed, Method::rows)->expectedBytes(samples) / 2);
  EXPECT_GT(fieldOf(closed, Method::rows, true)->expectedBytes(2 * samples),
    fieldOf(closed, Method::rows, true)->expectedBytes(samples) + 40 * samples)
    << "scattered samples are sorted";
}

TEST(ExpectedMemory, GrowsWithTheOrder)
{
  std::size_t before = 0;
  for (const winding::Primitive kind : {winding::Primitive::point, winding::Primitive::triangle})
  {
    for (const int order : {3, 5, 7, 9})
    {
      const std::size_t bytes = winding::bytesOfFarField(kind, 10'000, order);
      EXPECT_GT(bytes, before);
      before = bytes;
    }
    before = 0;
  }
}

TEST(ExpectedMemory, OfDistancesIsThatOfTheirTree)
{
  constexpr std::size_t samples = 1000;
  const Mesh mesh = icosphere(3);
  const auto onGrid = fieldOf(mesh, Method::rows), scattered = fieldOf(mesh, Method::rows, true);
  EXPECT_GT(onGrid->expectedBytesOfDistances(samples), 1280 * winding::bytesPerPrimitive);
  EXPECT_GT(
    scattered->expectedBytesOfDistances(samples), onGrid->expectedBytesOfDistances(samples));
  EXPECT_EQ(fieldOf(Mesh(), Method::rows)->expectedBytesOfDistances(samples), 0u);
}

} // namespace
