#pragma once

#include "base/Views.h"
#include "source/MeshVertices.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkCellArray;
class vtkDataArray;
class vtkDataObject;
class vtkPointSet;
class vtkPolyData;

namespace winding
{

/// Where a source says which areas its points have.
enum class AreaSource
{
  none,
  mesh, ///< in its triangles (MeshVertices.h)
  array
};

/// Which arrays of a source to use, and as what.
struct InputOptions
{
  bool asPoints = false;               ///< a mesh as the cloud of its points
  bool estimateNormals = false;        ///< points need none: it is not for the views to find them
  std::string normalsArray;            ///< empty: the active normals
  AreaSource areas = AreaSource::none; ///< of clouds
  std::string areaArray;               ///< for areas from an array

  bool operator==(const InputOptions& other) const
  {
    return asPoints == other.asPoints && normalsArray == other.normalsArray &&
           estimateNormals == other.estimateNormals && areas == other.areas &&
           areaArray == other.areaArray;
  }
};

/**
 * A VTK source as the core's views. Finding out what a source is costs nothing; views are made on
 * request, over VTK's own memory wherever its layout allows that, and live as long as this object.
 *
 * Throws Refusal, with a line for the user, for data that is no source.
 */
class InputViews
{
public:
  /// Which data sets a source is made of and when they were last modified.
  using Identity = std::vector<std::pair<const void*, vtkMTimeType>>;

  InputViews(vtkDataObject* source, const InputOptions& options);
  ~InputViews();

  bool isSurface() const { return isSurface_; }
  const Identity& identity() const { return identity_; }

  /// A hash of all that a field is built from. Two sources with different identities may still be
  /// the same: what a reader gives for every time step, say, when only attributes change.
  std::uint64_t fingerprint() const;

  std::vector<TrianglesView> triangles();
  std::vector<OrientedPointsView> orientedPoints();

  /// The data sets whose points the last orientedPoints() gave, one for each view, with the point data
  /// of the source: its leaves, or what they have been reduced to (outer surfaces; without ghosts).
  const std::vector<vtkPointSet*>& pointSets() const { return pointSets_; }

  /// All points of the source, those without triangles too.
  std::vector<VectorsView> points();

private:
  void addLeaf(vtkDataObject* leaf, const std::string& name);
  vtkDataArray* findArray(vtkPointSet* leaf, const std::string& name, int components) const;
  vtkDataArray* normalsOf(vtkPointSet* leaf) const;
  vtkDataArray* areasOf(vtkPointSet* leaf) const;
  VectorsView vectorsOf(vtkDataArray* array);
  ScalarsView scalarsOf(vtkDataArray* array);
  template <class View> View viewOf(vtkDataArray* array);
  TriangleIdsView idsOf(vtkCellArray* polygons);
  bool lacksNormals() const;
  const MeshVertices& verticesOf(vtkPointSet* mesh);
  vtkPolyData* skinOf(vtkPointSet* leaf);
  void addTriangles(vtkPointSet* leaf, std::vector<TrianglesView>& views);

  InputOptions options_;
  bool isSurface_ = false;
  std::vector<vtkSmartPointer<vtkPointSet>> leaves_;
  Identity identity_;
  std::vector<vtkPointSet*> pointSets_;

  // What views point into where VTK's own memory would not do.
  std::vector<vtkSmartPointer<vtkDataArray>> copies_;
  std::map<vtkPointSet*, vtkSmartPointer<vtkPolyData>> skins_;
  std::vector<std::vector<std::int64_t>> ids_;
  std::vector<MeshVertices> vertices_;
};

} // namespace winding
