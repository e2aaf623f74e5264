// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// Threads and blocks change nothing in what the parser of PLY finds, and interruption ends it.

#include "files/PlyFiles.h"
#include "support/Interruption.h"
#include "support/ShuffledThreads.h"

#include "files/PlyFile.h"

using namespace plyfiles;
using namespace winding;

namespace
{

/// Meshes of many blocks: of triangles; with one other face at the end; of faces of all sizes.
std::vector<std::vector<Ids>> largeMeshes()
{
  constexpr std::int64_t count = 60000;
  std::vector<Ids> triangles, any;
  for (std::int64_t i = 0; i < count; ++i)
  {
    triangles.push_back({i, (i + 1) % count, (i * i) % count});
    any.emplace_back(static_cast<std::size_t>(i % 6), i);
  }
  std::vector<Ids> almost = triangles;
  almost.push_back({0, 1, 2, 3});
  return {triangles, almost, any};
}

TEST(LargePlyFiles, AreTheSameForAllExecutorsAndFormats)
{
  for (const std::vector<Ids>& faces : largeMeshes())
  {
    const MeshArrays serial = parsed(readPly, meshFile(formats[1], 60000, faces));
    ASSERT_EQ(serial.polygons.count(), faces.size());
    for (const std::size_t i : {std::size_t(0), std::size_t(4), faces.size() / 2, faces.size() - 1})
    {
      const auto first = static_cast<std::size_t>(serial.polygons.offsets[i]);
      const auto last = static_cast<std::size_t>(serial.polygons.offsets[i + 1]);
      const std::int64_t* const ids = serial.polygons.connectivity.data();
      EXPECT_EQ(Ids(ids + first, ids + last), faces[i]);
    }
    for (const std::string format : formats)
    {
      const std::string file = meshFile(format, 60000, faces);
      for (const unsigned seed : {1U, 2U})
      {
        shapes::ShuffledThreads threads(seed);
        const MeshArrays mesh = parsed(readPly, file, threads);
        EXPECT_EQ(pointsOf(mesh), pointsOf(serial));
        expectCells(
          mesh.polygons, vectorOf(serial.polygons.offsets), vectorOf(serial.polygons.connectivity));
      }
    }
  }
}

TEST(LargePlyFiles, AreRefusedForTheFirstFault)
{
  for (std::vector<Ids> faces : largeMeshes())
  {
    faces[20003][1] = 99990;
    faces[50003][1] = 99991;
    for (const std::string format : formats)
    {
      const std::string file = meshFile(format, 60000, faces);
      for (const unsigned seed : {1U, 2U})
      {
        shapes::ShuffledThreads threads(seed);
        const std::string refusal = refusalOf(readPly, file, threads);
        EXPECT_NE(refusal.find("vertex 99990 does not exist; there are 60000"), std::string::npos)
          << refusal;
      }
    }
  }
}

/// An item whose list is longer than a block.
TEST(LargePlyFiles, ListsOfAnyLength)
{
  for (const std::string format : formats)
  {
    for (const std::size_t second : {std::size_t(700000), std::size_t(3)})
    {
      Body body(format);
      body.addList("int", "short", Ids(700000, 5)).endItem();
      body.addList("int", "short", Ids(second, 6)).endItem();
      body.add<float>(1).add<float>(2).add<float>(3).endItem();
      const std::string other = "element other 2\nproperty list int short values\n";
      const MeshArrays mesh = parsed(readPly, head(format, other + vertexHead(1)) + body.bytes());
      EXPECT_EQ(pointsOf(mesh), (std::vector<double>{1, 2, 3}));
    }
  }
}

TEST(InterruptedPlyFiles, GiveNothing)
{
  for (const std::string format : formats)
  {
    for (const int runs : {0, 1})
    {
      shapes::Interruption executor(runs);
      EXPECT_THROW(parsed(readPly, meshFile(format, 3, {{0, 1, 2}}), executor), Interrupted);
    }
  }
}

} // namespace
