// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/Shapes.h"
#include "support/ShuffledNumbers.h"

#include <vector>

/**
 * @file
 * The same set of primitives, written in another way. below(n) gives random numbers from 0 to
 * n − 1, which both have type std::size_t.
 */
namespace shapes
{

template <class T>
std::vector<T> inOrder(const std::vector<T>& items, const std::vector<std::size_t>& order)
{
  std::vector<T> result;
  for (const std::size_t i : order)
  {
    result.push_back(items[i]);
  }
  return result;
}

/// The triangles in random order, each from a random corner on, over points in random order.
/// Invalid ids stay.
template <class Below> Mesh shuffled(const Mesh& mesh, const Below& below)
{
  const std::vector<std::size_t> order = shuffledNumbers(mesh.points.size(), below);
  std::vector<std::int32_t> numbers(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    numbers[order[i]] = static_cast<std::int32_t>(i);
  }
  Mesh result;
  result.points = inOrder(mesh.points, order);
  for (const std::size_t t : shuffledNumbers(mesh.triangles.size(), below))
  {
    const std::size_t first = below(3);
    auto& triangle = result.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::int32_t id = mesh.triangles[t][(first + i) % 3];
      const bool isValid = id >= 0 && static_cast<std::size_t>(id) < numbers.size();
      triangle[i] = isValid ? numbers[static_cast<std::size_t>(id)] : id;
    }
  }
  return result;
}

/// The mesh with three points of its own for each triangle. All ids must be valid.
inline Mesh withoutSharedPoints(const Mesh& mesh)
{
  Mesh result;
  for (const auto& triangle : mesh.triangles)
  {
    auto& ids = result.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
    {
      ids[i] = static_cast<std::int32_t>(result.points.size());
      result.points.push_back(mesh.points[static_cast<std::size_t>(triangle[i])]);
    }
  }
  return result;
}

} // namespace shapes
