// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/Message.h"
#include "field/InputPlaces.h"
#include "private/source/InputViews.h"
#include "private/source/SourceField.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWindingABINamespace.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractArray;
class vtkDataObject;
class vtkDataSetAttributes;
class vtkFieldData;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace winding
{

class Ranks;

/// The arrays that results get from what is nearest in the source.
struct NearestOptions
{
  bool withNumbers = false;    ///< "NearestCell" and, of composite sources, "NearestBlock"
  bool withAttributes = false; ///< the source's own

  bool areAny() const { return withNumbers || withAttributes; }
};

/**
 * Gives the points or cells of results what the source has at the nearest place (InputPlaces.h).
 *
 * "NearestCell" is the id of the cell in its data set as VTK numbers it, of a cloud the id of the
 * point, and -1 where nothing is near; "NearestBlock" the flat index of the data set in a composite
 * source. Where a mesh has an outer surface, ids are of the mesh's cells, not of the surface's.
 *
 * Cell data is copied from that cell, and point data is interpolated between the corners of its
 * triangle: of floats, and of bytes in threes and fours, which are colours. Any other array, as of
 * labels and texts, has no values in between: the corner with the largest weight gives its own.
 * Arrays that the result has already stay. An array that is active in the source, as colours and
 * texture coordinates are, becomes so in the result where it has none.
 *
 * Where a source has several data sets, arrays are taken over that all have in the same type, and
 * colours that some have: the others are white. Where some have an opacity, the others are opaque.
 * Numbers that name regions, as "GroupIds" and the texts "GroupNames" of the field data, are then
 * numbers in one list: the names of the first data set, and new ones of the next. Numbers without
 * a name are −1 there. Where all have the same names, or none, numbers stay what they are.
 */
class NearestAttributes
{
public:
  /// Makes what searches need, and keeps the source. Throws Refusal, OutOfMemory and Interrupted.
  NearestAttributes(vtkDataObject* source, const SourceOptions& options,
    const NearestOptions& nearest, Executor& executor);
  ~NearestAttributes();

  /// A position for each of a number of points or cells.
  using PositionOf = std::function<Eigen::Vector3d(std::size_t)>;

  ///@{
  /// Adds the arrays of the source's points, or of its cells, for `count` items of a result at
  /// positionOf(n), and ids where these are asked for.
  void addPointData(std::size_t count, const PositionOf& positionOf, vtkDataSetAttributes* to,
    Executor& executor) const;
  void addCellData(std::size_t count, const PositionOf& positionOf, vtkDataSetAttributes* to,
    Executor& executor) const;
  ///@}

  ///@{
  /// Adds the ids to samples, which share the search: all of an extent of a grid in space, or
  /// `count` scattered ones at positionOf(n). Arrays of the source were not asked for.
  void addNumbers(
    const Grid& grid, const Extent& extent, vtkDataSetAttributes* to, Executor& executor) const;
  void addNumbers(std::size_t count, const PositionOf& positionOf, vtkDataSetAttributes* to,
    Executor& executor) const;
  ///@}

  /// Adds the arrays of points to the points of a surface, the arrays of cells to its faces, by the
  /// means of their corners, and names of regions to the field data.
  void addTo(vtkPolyData* surface, Executor& executor) const;

  /// Returns what is to be known about arrays that are not taken over, or not from everywhere, once
  /// addTo() has tried.
  std::vector<Message> notes() const;

  /// Returns the expected memory for a source of `primitives` triangles or points, in bytes.
  static std::size_t bytesFor(bool isSurface, std::size_t primitives);

private:
  /// An array of the source in each of its parts, and what becomes of it.
  struct Transfer;
  struct Part;

  void findArrays(bool ofPoints, std::vector<Transfer>& transfers);
  bool isTaken(const std::string& name, vtkDataSetAttributes* to) const;
  void noteTaken(bool ofPoints, vtkDataSetAttributes* to) const;
  /// Finds the places of samples first … first + count − 1.
  using FindPlaces = std::function<void(std::size_t first, std::size_t count, InputPlace* places)>;

  void add(bool ofPoints, std::size_t count, std::size_t atOnce, const FindPlaces& find,
    vtkDataSetAttributes* to, Executor& executor) const;
  FindPlaces searchAt(const PositionOf& positionOf, Executor& executor) const;
  vtkIdType cellOf(const InputPlace& place) const;

  NearestOptions options_;
  bool isComposite_;
  InputViews views_;
  std::vector<TrianglesView> triangles_; ///< none for clouds
  std::vector<Part> parts_;              ///< one for each view
  std::unique_ptr<InputPlaces> places_;
  std::vector<Transfer> ofPoints_, ofCells_;
  std::vector<std::string> leftOut_;
  std::vector<std::string> filled_;        ///< colours that some parts lack
  mutable std::vector<std::string> taken_; ///< names that the result has; set by addTo()
  mutable bool addsAny_ = false;           ///< whether addTo() takes arrays over
};

/// Throws a Refusal where a source has both surfaces and clouds, which are searched one by one.
void refuseNearestOfMixed(vtkDataObject* source, const InputOptions& options);

/// Throws a Refusal where other ranks have parts of the source, whose cells have no numbers here.
void refuseNearestOfOtherRanks(const Ranks& ranks, SourceDistribution distribution);

} // namespace winding
