// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Views.h"
#include "private/source/FlatTriangles.h"
#include "private/source/OuterSurface.h"
#include "private/source/SourceDistribution.h"
#include "source/MeshVertices.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWindingABINamespace.h"

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkCellArray;
class vtkDataArray;
class vtkDataObject;
class vtkDataSetAttributes;
class vtkPointSet;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace winding
{

class Executor;

/// The places in a source that hold the areas of its points.
enum class AreaSource
{
  none,
  mesh, ///< its triangles (MeshVertices.h)
  array
};

/// The choices that decide how a source is seen: as a mesh or as points, and with which arrays.
struct InputOptions
{
  bool asPoints = false;        ///< whether a mesh is seen as the cloud of its points
  bool takesFaces = false;      ///< of a mesh that has cells with volume, too (OuterSurface.h)
  bool estimateNormals = false; ///< whether points may lack normals; views do not find any
  std::string normalsArray;     ///< name; empty or None for the active normals
  AreaSource areas = AreaSource::none; ///< for clouds only
  std::string areaArray;               ///< name, for AreaSource::array
  double weldTolerance = 0; ///< up to which points of a surface are made one (SnappedPoints.h)

  bool operator==(const InputOptions& other) const
  {
    return asPoints == other.asPoints && takesFaces == other.takesFaces &&
           normalsArray == other.normalsArray && estimateNormals == other.estimateNormals &&
           areas == other.areas && areaArray == other.areaArray &&
           weldTolerance == other.weldTolerance;
  }
};

/// The polydata that a view shows, with the cells and arrays of its leaf.
struct ViewedPart
{
  vtkPolyData* data = nullptr; ///< the views keep it
  bool areStrips = false;      ///< whether it shows strips, not polygons
  unsigned block = 0;          ///< flat index of the leaf; 0 for a source that is no composite
};

/**
 * A VTK source as the core's views. Finding out what a source is takes a look at its cells; views
 * are made on request, over VTK's own memory wherever its layout allows that, and live as long as
 * this object.
 *
 * Throws Refusal, with a line for the user, for data that is no source, and for data that
 * contradicts itself (CellChecks.h). Only polygons with ids of points that do not exist are no
 * reason to refuse polydata: the core leaves them out.
 */
class InputViews
{
public:
  /// The data sets that a source is made of, and the times of their last modification.
  using Identity = std::vector<std::pair<const void*, vtkMTimeType>>;

  /// `executor`, if it is not null, runs what takes long, and lives as long as this object.
  /// `keepsNumbers` has numberOf() know the numbers of all cells and points in their data sets.
  InputViews(vtkDataObject* source, const InputOptions& options, Executor* executor = nullptr,
    bool keepsNumbers = false);
  ~InputViews();

  bool isSurface() const { return isSurface_; }
  const Identity& identity() const { return identity_; }

  /// Whether there is nothing to sum over: no points at all.
  bool isEmpty() const { return leaves_.empty() && !isGathered_; }

  bool isGathered() const { return isGathered_; }

  /// The cells of a surface, or the points of a cloud, that this rank has.
  std::size_t ownElements() const;

  /// Finds out whether the source is a surface, and whether all ranks have a copy of it. Throws a
  /// Refusal on all ranks where some have surfaces and others clouds, and where a source that is to
  /// be replicated is not. Collective.
  void compare(Ranks& ranks, SourceDistribution distribution);

  /// Whether compare() has found that all ranks have a copy of the source.
  bool areCopies() const { return areCopies_; }

  /// Brings the parts of all ranks together, on all of them or on the first, unless compare(),
  /// which goes before, has found copies. From then on this is about the whole source, except for
  /// what describes data sets. Collective.
  void gather(Ranks& ranks, bool onlyOnFirst = false);

  /// A hash of all that a field is built from. Two sources with different identities may still have
  /// the same content: a reader, for example, gives new objects for every time step, though only
  /// attributes change.
  std::uint64_t fingerprint() const;

  /// The triangles of a surface. Points are moved by the weld tolerance, if there is one.
  std::vector<TrianglesView> triangles();
  std::vector<OrientedPointsView> orientedPoints();

  /// The data sets whose points orientedPoints() has given, one for each view, with the point
  /// data of the source. They are its leaves, or the outer surfaces of these, without ghosts.
  const std::vector<vtkPointSet*>& pointSets() const { return pointSets_; }

  /// The parts that triangles() of this rank shows, one for each view.
  std::vector<ViewedPart> viewedParts();

  /// Returns the flat index of the leaf of each view of orientedPoints().
  const std::vector<unsigned>& blocksOfPoints() const { return blocksOfPoints_; }

  /// Returns the number that the cell or point of a part has in its own data set, which an outer
  /// surface and a part without ghosts are made of. The views keep numbers.
  static vtkIdType numberOf(vtkDataSetAttributes* ofPart, vtkIdType item);

  /// The name of the array of these numbers.
  static const char* nameOfNumbers();

  /// Returns whether normals of orientedPoints() only look to where each point was seen from, as an
  /// array "Viewpoints" says of points whose normals are to be estimated.
  bool lookAtViewpoints() const { return lookAtViewpoints_; }

  /// All points of the source, those without triangles too.
  std::vector<VectorsView> points();

  /// Whether the points of this rank's part belong to lines, and have no normals.
  bool hasOnlyLines() const;

  /// Counts of the cells of this rank's part; what views show is known once they are made.
  const CellCounts& cellCounts() const { return counts_; }

private:
  /// A leaf of the source.
  struct Leaf
  {
    vtkSmartPointer<vtkPointSet> data;
    std::string name;
    unsigned block;
  };

  void addLeaf(vtkDataObject* leaf, const std::string& name, unsigned block);
  vtkDataArray* areasOf(vtkPointSet* leaf) const;
  vtkDataArray* viewpointsOf(vtkPointSet* leaf) const;
  VectorsView directionsTo(vtkDataArray* viewpoints, const VectorsView& points);
  VectorsView vectorsOf(vtkDataArray* array);
  ScalarsView scalarsOf(vtkDataArray* array);
  TrianglesView trianglesOf(const VectorsView& points, vtkCellArray* polygons);
  const std::vector<TrianglesView>& ownTriangles();
  std::vector<VectorsView> welded(const std::vector<VectorsView>& points);
  const std::vector<OrientedPointsView>& ownOrientedPoints();
  std::vector<OrientedPointsView> findOrientedPoints();
  bool lacksNormals() const;
  const MeshVertices& verticesOf(vtkPointSet* mesh);
  vtkPolyData* skinOf(vtkPointSet* leaf);
  void addTriangles(vtkPointSet* leaf, std::vector<TrianglesView>& views);

  InputOptions options_;
  Executor* executor_;
  bool isSurface_ = false;
  bool lookAtViewpoints_ = false;
  bool keepsNumbers_;
  /// Data sets of lines alone. They are clouds only where nothing has faces.
  std::vector<Leaf> ofLines_;
  bool isOfLinesToo_ = false; ///< whether addLeaf() takes them
  std::vector<vtkSmartPointer<vtkPointSet>> leaves_;
  std::vector<unsigned> blocks_; ///< flat indices of the leaves
  Identity identity_;
  std::vector<vtkPointSet*> pointSets_;
  std::vector<unsigned> blocksOfPoints_; ///< of pointSets_
  CellCounts counts_;

  std::optional<std::vector<TrianglesView>> ownTriangles_;
  std::optional<std::vector<OrientedPointsView>> ownPoints_;

  bool areCopies_ = false;
  bool isGathered_ = false;
  GatheredViews gathered_;

  // Views point into these where VTK's own memory would not do.
  std::deque<std::vector<std::vector<double>>> welded_; ///< points, moved by the weld tolerance
  std::deque<std::vector<double>> directions_;          ///< to viewpoints
  std::vector<vtkSmartPointer<vtkDataArray>> copies_;
  std::map<vtkPointSet*, vtkSmartPointer<vtkPolyData>> skins_;
  std::vector<FlatTriangles> flat_;
  std::vector<MeshVertices> vertices_;
};

/// Returns what users of a source of lines can do.
Message onlyLines();

} // namespace winding
