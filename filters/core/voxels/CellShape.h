// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace winding
{

/**
 * A cell as its corners and faces. The corners of a face are numbers of `points`, counter-clockwise
 * seen from outside; a cell whose faces are all the other way round is the same cell.
 */
struct CellShape
{
  std::vector<Eigen::Vector3d> points;
  std::vector<int> faceCorners;    ///< face after face
  std::vector<int> faceEnds = {0}; ///< by face, where its corners begin; and the end of the last
  bool areLinear = false;          ///< whether addFacesOf() has made all faces, which close
  bool isStraightened = false;     ///< whether addFacesOf() was given a curved type

  void clear();
  std::size_t faces() const { return faceEnds.size() - 1; }

  /// Adds a face of `count` corners.
  void addFace(const int* corners, int count);

  /// Whether the faces close: each edge of one is, the other way round, an edge of another. Corners
  /// at one place count as one, and edges are cut at corners that lie on them.
  bool isClosed() const;

  /// Adds the faces of a cell with one of VTK's types, whose points are there in VTK's order. A
  /// curved cell is made straight between its corners: its other points are removed. Returns
  /// whether facesOf() has its faces and there are enough points.
  bool addFacesOf(int type);
};

/// The cells of a mesh, which may be asked for from several threads at once.
class CellShapes
{
public:
  virtual ~CellShapes() = default;
  virtual std::size_t size() const = 0;

  /// Sets `shape` to a cell. A cell of fewer than three dimensions has points and no faces.
  virtual void get(std::size_t cell, CellShape& shape) const = 0;
};

} // namespace winding
