// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Views.h"
#include "field/CappedSurface.h"
#include "source/Grid.h"
#include "source/Sanitize.h"
#include "source/Surface.h"
#include "sums/ReferenceSum.h"
#include "support/Samples.h"
#include "support/Serial.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

/**
 * @file
 * Random chains of triangles on a small integer lattice, with a grid whose planes run through them,
 * so that every degeneracy occurs often. The integers tell exactly which samples lie on triangles
 * and edges. All functions are inline, so that programs outside the test suite can use them.
 */
namespace shapes
{

/// Integer coordinates in quarters of a lattice step.
using Quarters = Eigen::Vector3i;

struct LatticeChain
{
  std::vector<Quarters> corners; ///< three per triangle
  double scale = 1;              ///< length of a lattice step
  double shift = 0;              ///< added to all coordinates after scaling
  bool isExact = true;           ///< nothing was rounded when the integers became coordinates
  Quarters firstSample, step;
  winding::Grid grid;
  winding::Surface surface;
};

inline bool isOnTriangle(const Quarters* corner, const Quarters& q)
{
  const Quarters &a = corner[0], &b = corner[1], &c = corner[2];
  if ((q.array() < a.cwiseMin(b).cwiseMin(c).array()).any() ||
      (q.array() > a.cwiseMax(b).cwiseMax(c).array()).any())
  {
    return false;
  }
  const Quarters normal = (b - a).cross(c - a);
  if (normal.isZero())
  {
    // The degenerate triangle is the part of a line in the box of the corners.
    return (b - a).cross(q - a).isZero() && (c - a).cross(q - a).isZero();
  }
  return (b - a).cross(q - a).dot(normal) >= 0 && (c - b).cross(q - b).dot(normal) >= 0 &&
         (a - c).cross(q - c).dot(normal) >= 0 && normal.dot(q - a) == 0;
}

inline bool isOnSurface(const LatticeChain& chain, const Quarters& q)
{
  for (std::size_t i = 0; i < chain.corners.size(); i += 3)
  {
    if (isOnTriangle(&chain.corners[i], q))
    {
      return true;
    }
  }
  return false;
}

/// Whether q lies on an edge of ∂M; only for chains that are exact.
inline bool isOnRim(
  const LatticeChain& chain, const winding::BoundaryChain& boundary, const Quarters& q)
{
  const auto quarters = [&](std::int32_t vertex) -> Quarters
  {
    const Point p = chain.surface.vertices[vertex].array() - chain.shift;
    return (4 / chain.scale * p).cast<int>();
  };
  return std::any_of(boundary.edges.begin(), boundary.edges.end(),
    [&](const winding::BoundaryEdge& edge)
    {
      const Quarters ends[3] = {quarters(edge.from), quarters(edge.to), quarters(edge.to)};
      return isOnTriangle(ends, q);
    });
}

/// A chain that depends on the seed: triangles without relation, or tetrahedra some of whose faces
/// are deleted, duplicated or flipped, or undamaged tetrahedra, which are a closed chain.
inline LatticeChain randomLatticeChain(unsigned seed, int mostTriangles, int largest)
{
  Random random(seed);
  const auto below = [&random](int count)
  {
    return static_cast<int>((random.bits() >> 33) % static_cast<unsigned>(count));
  };
  LatticeChain chain;
  const int size = 1 + below(largest);
  const auto corner = [&]() -> Quarters
  {
    const int x = below(size + 1), y = below(size + 1), z = below(size + 1);
    return 4 * Quarters(x, y, z);
  };
  const int kind = below(4);
  const int triangles = 1 + below(mostTriangles);
  while (chain.corners.size() < 3 * static_cast<std::size_t>(triangles))
  {
    if (kind == 0)
    {
      chain.corners.push_back(corner());
      continue;
    }
    const Quarters v[4] = {corner(), corner(), corner(), corner()};
    for (const auto& [a, b, c] : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})
    {
      // Kinds 1 and 2 are damaged, 2 heavily; kind 3 is closed.
      const int fate = kind == 3 ? 99 : below(kind == 1 ? 20 : 6);
      for (int copies = fate == 0 ? 0 : fate == 1 ? 2 : 1; copies > 0; --copies)
      {
        chain.corners.insert(
          chain.corners.end(), {v[a], fate == 2 ? v[c] : v[b], fate == 2 ? v[b] : v[c]});
      }
    }
    if (chain.corners.empty())
    {
      chain.corners = {v[0], v[1], v[2]};
    }
  }
  const int unit = below(4);
  chain.scale = unit == 0 ? 0.1 : unit == 1 ? 1 / 3.0 : 1;
  const int place = below(5);
  chain.shift = place == 0 ? 1e5 : place == 1 ? -0.7 : 0;
  chain.isExact = chain.scale == 1 && place != 1;

  // Samples lie on the lattice, between its points, or next to it along one axis.
  const int subdivision = 1 + below(2);
  chain.step.setConstant(4 / subdivision);
  chain.firstSample = -chain.step;
  if (below(5) == 0)
  {
    chain.firstSample[below(3)] += 1;
  }
  chain.grid.dimensions.setConstant(size * subdivision + 3);
  const auto coordinates = [&chain](const Quarters& q) -> Point
  {
    return (chain.scale * 0.25 * q.cast<double>()).array() + chain.shift;
  };
  chain.grid.spacing = chain.scale * 0.25 * chain.step.cast<double>();
  chain.grid.firstSample = coordinates(chain.firstSample);

  std::vector<Point> points;
  std::vector<std::int32_t> ids;
  for (const Quarters& q : chain.corners)
  {
    ids.push_back(static_cast<std::int32_t>(points.size()));
    points.push_back(coordinates(q));
  }
  const winding::TrianglesView view{
    {points[0].data(), points.size()}, {ids.data(), ids.size() / 3}};
  chain.surface = winding::sanitize(std::vector<winding::TrianglesView>{view}, serial);
  return chain;
}

/// The findings of a comparison of a chain's field by rows and caps with the direct sum.
struct ChainComparison
{
  std::size_t offSurface = 0, onSurface = 0, onRim = 0;
  /// Samples on the surface that got the direct sum, as they are, within rounding, on both caps.
  std::size_t means = 0;
  double largestError = 0; ///< largest error of samples off the surface
  std::string failure;     ///< message on the last sample that failed; empty if none did
};

/// Compares a chain's field with what it should be: off the surface, the direct sum; on the
/// surface, but not on the rim, the direct sum a small step aside, in the direction in which
/// samples in a plane count as moved, or, by accident, the direct sum right there; on the rim,
/// anything finite. The field may be off by fieldTolerance anyway.
inline ChainComparison compareWithDirectSum(const LatticeChain& chain, double fieldTolerance = 0)
{
  using namespace winding;
  const BoundaryChain boundary = boundaryChain(chain.surface, serial);
  const CappedSurface capped(
    chain.surface, boundary, fieldTolerance, serial, CappedSurface::CapSum::farField);
  const Extent whole = chain.grid.wholeExtent();
  std::vector<double> values(sampleCount(whole), std::nan(""));
  FieldOutput output;
  output.doubleValues = values.data();
  capped.evaluate(chain.grid, whole, output, serial);

  ChainComparison result;
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    const Eigen::Vector3i index = sampleIndex(whole, n);
    const Quarters q = chain.firstSample + index.cwiseProduct(chain.step);
    const Point sample = chain.grid.sample(index);
    double expected = values[n], tolerance = 0;
    if (!isOnSurface(chain, q))
    {
      ++result.offSurface;
      expected = static_cast<double>(referenceSum<long double>(chain.surface, sample));
      tolerance = 1e-9 + fieldTolerance;
      result.largestError = std::max(result.largestError, std::abs(values[n] - expected));
    }
    else
    {
      ++result.onSurface;
      const bool onRim = chain.isExact && isOnRim(chain, boundary, q);
      result.onRim += onRim;
      if (chain.isExact && !onRim)
      {
        const Point moved = sample + 1e-5 * Point(1e-4, 1, 1e-2);
        expected = static_cast<double>(referenceSum<long double>(chain.surface, moved));
        tolerance = 1e-2 + fieldTolerance;
        const double mean = static_cast<double>(referenceSum<long double>(chain.surface, sample));
        if (!(std::abs(values[n] - expected) <= tolerance) &&
            std::abs(values[n] - mean) < 1e-9 + fieldTolerance)
        {
          ++result.means;
          continue;
        }
      }
    }
    if (!(std::abs(values[n] - expected) <= tolerance))
    {
      std::ostringstream text;
      text.precision(17);
      text << "sample " << index.transpose() << " has " << values[n] << ", not " << expected
           << (isOnSurface(chain, q) ? ", on the surface" : "");
      result.failure = text.str();
    }
  }
  return result;
}

} // namespace shapes
