// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/MeshSkin.h"

#include "mesh/CellTypes.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

namespace
{

using Ids = std::vector<std::int64_t>;

constexpr std::uint8_t hexahedron = 12, polyhedron = winding::polyhedronType;

/// A mesh, and its skin: all faces that one cell has.
struct SkinnedMesh
{
  std::vector<Eigen::Vector3d> points;
  std::vector<std::uint8_t> types;
  Ids corners, offsets = {0};
  Ids skinCorners, skinOffsets = {0}, owners, origins;

  void add(std::uint8_t type, const Ids& ids)
  {
    types.push_back(type);
    corners.insert(corners.end(), ids.begin(), ids.end());
    offsets.push_back(static_cast<std::int64_t>(corners.size()));
  }

  /// Finds the skin. `turns` says which of its polygons go round the other way than their cells'.
  template <class Turns> void findSkin(const Turns& turns)
  {
    std::map<Ids, std::vector<std::pair<std::int64_t, Ids>>> faces; // by sorted corners
    for (std::size_t cell = 0; cell < types.size(); ++cell)
    {
      const std::int64_t* const own = &corners[static_cast<std::size_t>(offsets[cell])];
      std::vector<Ids> ofCell(1);
      for (const int corner : winding::facesOf(hexahedron))
      {
        if (corner < 0)
        {
          ofCell.emplace_back();
          continue;
        }
        ofCell.back().push_back(own[corner]);
      }
      ofCell.pop_back();
      for (const Ids& face : ofCell)
      {
        Ids key = face;
        std::sort(key.begin(), key.end());
        faces[key].emplace_back(static_cast<std::int64_t>(cell), face);
      }
    }
    for (const auto& [key, users] : faces)
    {
      if (users.size() == 1)
      {
        Ids face = users[0].second;
        if (turns())
        {
          std::reverse(face.begin(), face.end());
        }
        skinCorners.insert(skinCorners.end(), face.begin(), face.end());
        skinOffsets.push_back(static_cast<std::int64_t>(skinCorners.size()));
        owners.push_back(users[0].first);
      }
    }
    for (std::size_t point = 0; point < points.size(); ++point)
    {
      origins.push_back(static_cast<std::int64_t>(point));
    }
  }

  winding::MeshView mesh() const
  {
    return {{points[0].data(), points.size()}, types.data(), {corners.data(), corners.size()},
      {offsets.data(), offsets.size()}};
  }

  winding::SkinView skin() const
  {
    return {{points[0].data(), points.size()}, {skinCorners.data(), skinCorners.size()},
      {skinOffsets.data(), skinOffsets.size()}, {owners.data(), owners.size()},
      {origins.data(), origins.size()}};
  }

  double volumeWithin(const winding::OutwardPolygons& polygons) const
  {
    double volume = 0;
    for (std::size_t polygon = 0; polygon < polygons.polygons.size(); ++polygon)
    {
      const auto at = [&](std::int64_t corner)
      {
        return points[static_cast<std::size_t>(polygons.corners[static_cast<std::size_t>(corner)])];
      };
      const std::int64_t first = polygons.offsets[polygon], end = polygons.offsets[polygon + 1];
      for (std::int64_t i = first + 2; i < end; ++i)
      {
        volume += at(first).dot(at(i - 1).cross(at(i))) / 6;
      }
    }
    return volume;
  }
};

/// Returns a block of 2 x 2 x 2 unit hexahedra, with the nodes of some in an order that turns them
/// inside out. They share no points if `areApart`.
SkinnedMesh blockOf(bool areApart, std::mt19937& random)
{
  SkinnedMesh mesh;
  std::map<std::array<int, 3>, std::int64_t> known;
  for (int cell = 0; cell < 8; ++cell)
  {
    Ids ids;
    for (const auto& [x, y, z] : {std::array{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1},
           {1, 0, 1}, {1, 1, 1}, {0, 1, 1}})
    {
      const std::array<int, 3> place = {cell % 2 + x, cell / 2 % 2 + y, cell / 4 + z};
      const auto next = static_cast<std::int64_t>(mesh.points.size());
      const auto [found, isNew] = known.emplace(place, next);
      if (isNew || areApart)
      {
        mesh.points.emplace_back(place[0], place[1], place[2]);
      }
      ids.push_back(areApart ? next : found->second);
    }
    if (random() % 2 != 0)
    {
      std::rotate(ids.begin(), ids.begin() + 4, ids.end());
    }
    mesh.add(hexahedron, ids);
  }
  return mesh;
}

} // namespace

TEST(MeshSkin, LooksOutwardWhateverTheOrderOfNodesAndCorners)
{
  std::mt19937 random(4711);
  for (int round = 0; round < 20; ++round)
  {
    SkinnedMesh block = blockOf(false, random);
    block.findSkin([&] { return random() % 2 != 0; });
    winding::CellCounts counts;
    const auto polygons = outwardPolygons(block.mesh(), block.skin(), counts);
    EXPECT_EQ(polygons.polygons.size(), 24u);
    EXPECT_NEAR(block.volumeWithin(polygons), 8, 1e-12) << "round " << round;
    EXPECT_GT(counts.turned, 0u);
    const Ids& before = block.skinCorners;
    for (std::size_t i = 0; i < before.size(); i += 4)
    {
      EXPECT_EQ(polygons.corners[i], before[i]) << "a turned polygon keeps its first corner";
    }
  }
}

TEST(MeshSkin, HasNoSeamsBetweenCellsThatShareNoPoints)
{
  std::mt19937 random(4712);
  SkinnedMesh block = blockOf(true, random);
  block.findSkin([&] { return random() % 2 != 0; });
  ASSERT_EQ(block.owners.size(), 48u);
  winding::CellCounts counts;
  const auto polygons = outwardPolygons(block.mesh(), block.skin(), counts);
  EXPECT_EQ(polygons.polygons.size(), 24u);
  EXPECT_NEAR(block.volumeWithin(polygons), 8, 1e-12);
  EXPECT_TRUE(std::is_sorted(polygons.polygons.begin(), polygons.polygons.end()));
}

TEST(MeshSkin, TurnsFacesOfPolyhedraThatDoNotAgree)
{
  std::mt19937 random(4713);
  SkinnedMesh block = blockOf(false, random);
  block.findSkin([] { return false; });
  Ids faces, offsets = {0};
  for (std::size_t cell = 0; cell < block.types.size(); ++cell)
  {
    faces.push_back(6);
    Ids face;
    for (const int corner : winding::facesOf(hexahedron))
    {
      if (corner >= 0)
      {
        face.push_back(block.corners[static_cast<std::size_t>(block.offsets[cell] + corner)]);
        continue;
      }
      if (random() % 2 != 0)
      {
        std::reverse(face.begin(), face.end());
      }
      faces.push_back(static_cast<std::int64_t>(face.size()));
      faces.insert(faces.end(), face.begin(), face.end());
      face.clear();
    }
    offsets.push_back(static_cast<std::int64_t>(faces.size()));
  }
  block.types.assign(block.types.size(), polyhedron);
  block.corners = faces;
  block.offsets = offsets;
  winding::CellCounts counts;
  EXPECT_NEAR(block.volumeWithin(outwardPolygons(block.mesh(), block.skin(), counts)), 8, 1e-12);
}

TEST(MeshSkin, IsHalvedUntilChordsAreNearTheirArcs)
{
  // Strips along arcs of a circle of radius 1, with rises of 1 - cos(angle / 2).
  const auto stripOf = [](double angle, int pieces)
  {
    SkinnedMesh strip;
    for (int i = 0; i <= pieces; ++i)
    {
      for (const double z : {0.0, angle})
      {
        strip.points.emplace_back(std::cos(angle * i / pieces), std::sin(angle * i / pieces), z);
      }
    }
    for (std::int64_t i = 0; i < pieces; ++i)
    {
      strip.skinCorners.insert(strip.skinCorners.end(), {2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
      strip.skinOffsets.push_back(4 * i + 4);
      strip.owners.push_back(0);
    }
    return strip;
  };
  for (const double angle : {0.02, 0.3, 0.8, 1.5})
  {
    winding::CellCounts counts;
    const SkinnedMesh once = stripOf(angle, 2), twice = stripOf(angle, 4);
    const int halvings = halvingsOf(once.skin(), twice.skin(), 1, 1, counts);
    const auto rise = [angle](int level)
    {
      return 1 - std::cos(angle / std::pow(2, level + 1));
    };
    EXPECT_LE(rise(halvings), 1.1e-3) << angle;
    if (halvings > 1)
    {
      EXPECT_GT(rise(halvings - 1), 0.7e-3) << angle;
    }
    EXPECT_EQ(counts.flat, 0u);
  }
  winding::CellCounts counts;
  EXPECT_EQ(halvingsOf(stripOf(3, 2).skin(), stripOf(3, 4).skin(), 1, 0.01, counts), 5);
  EXPECT_EQ(counts.flat, 1u);
}

TEST(CellCounts, LeaveOutGhostsAndCellsOfTheOtherKind)
{
  const std::vector<std::uint8_t> types = {12, 9, 3, 1, 12, 5};
  const std::uint8_t ghosts[] = {0, 0, 0, 0, 32, 1};
  for (const bool takesFaces : {false, true})
  {
    winding::CellCounts counts;
    const std::vector<char> own = ownCellsOf(types, ghosts, takesFaces, counts);
    EXPECT_EQ(own,
      takesFaces ? std::vector<char>({0, 1, 1, 1, 0, 0}) : std::vector<char>({1, 0, 1, 1, 0, 0}));
    EXPECT_EQ(counts.leftOut, 1u);
    countLoose(types, counts);
    EXPECT_EQ(counts.loose, 2u);
    EXPECT_EQ(notesOn(counts).size(), 2u);
  }
}
