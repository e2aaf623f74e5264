// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Message.h"
#include "source/Plane.h"
#include "source/PointCloud.h"
#include "source/Surface.h"

#include <cstddef>
#include <string>
#include <vector>

namespace winding
{

/**
 * The planes of symmetry of a whole, for a source that is one side of them, as half a hull. It gets
 * its mirror image at each plane in turn, so that two planes make four of a quarter.
 *
 * Planes are at right angles, up to 1e-4: only then is the whole symmetric at all of them, in
 * whatever order they come. Those that are not quite are turned about their points next to the
 * middle of the source, except the first. Parallel planes make a row instead. Planes that are as
 * near to each other as vertices that are their own images count once.
 *
 * Vertices within a millionth of the bounds' longest side from a plane are their own images, so
 * that both halves meet there. Triangles that lie in the plane, as lids of closed halves, would
 * cancel with their images and are left out.
 */
class Mirror
{
public:
  /// Takes planes as planesIn() does. Vertices up to `tolerance` from a plane are their own images,
  /// too. Throws Refusal for other texts, other angles, and more than three planes.
  explicit Mirror(const std::string& text, double tolerance = 0);

  bool isNone() const { return planes_.empty(); }

  /// Returns the planes of the text.
  const std::vector<Plane>& planes() const { return planes_; }

  /// Returns the planes that a source with these bounds is mirrored at, in turn.
  std::vector<Plane> planesFor(const Bounds& bounds) const;

  /// Returns how often the source is there afterwards, at most.
  std::size_t copies() const { return std::size_t(1) << planes_.size(); }

  /// Returns whether a source reaches across a plane, so that it overlaps its own image.
  bool cuts(const std::vector<Eigen::Vector3d>& positions, const Bounds& bounds) const;

  /// Returns the bounds of a source with these bounds and its images.
  Bounds completed(const Bounds& bounds) const;

  /// Adds the images to a surface, behind its triangles, and to the parts of its polygons, which
  /// may be none. Throws Refusal for more than 2³¹ − 1 triangles or vertices.
  void addTo(Surface& surface, PolygonParts& parts) const;

  /// Adds the images to a cloud, behind its points. Points in a plane have none, unless they have
  /// areas, which are of one side then.
  void addTo(PointCloud& cloud) const;

private:
  double reachOf(const Bounds& bounds) const;
  void addImage(const Plane& plane, Surface& surface, PolygonParts& parts) const;

  std::vector<Plane> planes_;
  double tolerance_;
};

/// Returns what to do about a source that reaches across its plane of symmetry.
Message cutByMirror();

} // namespace winding
