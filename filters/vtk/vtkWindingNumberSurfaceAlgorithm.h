// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindingNumberSurfaceAlgorithm
 * @brief   base of filters that make surfaces of solids from where grids cross them
 *
 * The samples of a grid, which are inside or outside, give the triangles, as marching cubes does
 * (vtkMarchingCubes). Every vertex then goes to where the solid ends on its edge of the grid. So
 * the steps that a contour of a field of 0 and 1 shows do not come about: where the source is
 * closed, vertices lie on it. Vertices next to a sample stay 2⁻¹² of an edge away from it, so that
 * no two have the same place.
 *
 * **Sharp edges.** With Features SHARP the surface is made by dual contouring instead (Ju et al.,
 * Dual contouring of Hermite data, 2002). Every cell of eight samples has a vertex for each piece
 * of surface in it, where the planes of the source's triangles meet that cross the cell's edges; so
 * edges and corners stay sharp, if the cell sees the faces that meet there. Where no triangle
 * crosses, planes follow the gradient of w. Every crossed edge of the grid has a quad between the
 * four vertices around it. The surface is 2-manifold, also where two pieces of surface pass one
 * cell; in these cells triangles may pass through each other, and in no others.
 *
 * **Voxels.** With Features VOXELS the surface has the quads that vtkWindingNumberVoxels makes of
 * the samples: the sides of the boxes of one spacing around the inside ones. Where voxels touch at
 * an edge or a corner only, it is 2-manifold all the same, with two vertices in one place.
 *
 * Triangles face outward, share their vertices, and leave no gaps but at the border of the grid. A
 * solid may reach beyond it: there the surface ends, or is closed if CloseBorder is on. Details
 * finer than a voxel may be lost, and edges of the source are cut off inside of voxels. Where all
 * samples are inside, or none is, the surface is empty, and a warning says what to do.
 *
 * **Pipeline.** The grid is laid over the source as it is at each execution. The filter works on
 * the whole: where several pieces are asked for, the first has everything. Progress and abort are
 * vtkWindingNumberField's. The result has the same bits for any number of threads, and for
 * any order of the source's triangles and points. It takes the memory of the triangles and 13 bytes
 * for each row of the grid. For a source that is not closed the field passes through memory in
 * slabs of about 100 MB. What is inside is also there as an image, with GenerateImage.
 *
 * @sa vtkWindingNumberSurface vtkWindingNumberBoolean
 */
#ifndef vtkWindingNumberSurfaceAlgorithm_h
#define vtkWindingNumberSurfaceAlgorithm_h

#include "vtkWindingABINamespace.h"
#include "vtkWindingNumberGridAlgorithm.h"

#include <string>

namespace winding
{
class ArraySink;
struct SurfaceOptions;
} // namespace winding

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkPolyData;

class VTKFILTERSWINDING_EXPORT vtkWindingNumberSurfaceAlgorithm
  : public vtkWindingNumberGridAlgorithm
{
public:
  vtkTypeMacro(vtkWindingNumberSurfaceAlgorithm, vtkWindingNumberGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The ways to make the surface of what is inside.
  enum FeaturesType
  {
    SMOOTH = 0, ///< marching cubes; edges of the source are cut off inside of voxels
    SHARP = 1,  ///< dual contouring; edges and corners of the source stay sharp
    VOXELS = 2  ///< the sides of the voxels around the samples that are inside
  };

  ///@{
  /// The kind of the surface, as described above. Default SMOOTH.
  vtkSetMacro(Features, int);
  vtkGetMacro(Features, int);
  void SetFeaturesToSmooth() { this->SetFeatures(SMOOTH); }
  void SetFeaturesToSharp() { this->SetFeatures(SHARP); }
  void SetFeaturesToVoxels() { this->SetFeatures(VOXELS); }
  const char* GetFeaturesAsString() const;
  ///@}

  ///@{
  /// Whether all polygons of a sharp surface, or of one of voxels, are triangles; a smooth one has
  /// no others. Default off: a surface of voxels has quads, and a sharp one has quads, and four
  /// triangles where no diagonal of a quad is good.
  vtkSetMacro(GenerateTriangles, vtkTypeBool);
  vtkGetMacro(GenerateTriangles, vtkTypeBool);
  vtkBooleanMacro(GenerateTriangles, vtkTypeBool);
  ///@}

  ///@{
  /// Whether to close the surface where the solid reaches the border of the grid, by faces on the
  /// outer sides of the voxels, as vtkWindingNumberVoxels does. Default off: all of the surface is
  /// the level set, and parts that SamplingBounds cut off are missing.
  vtkSetMacro(CloseBorder, vtkTypeBool);
  vtkGetMacro(CloseBorder, vtkTypeBool);
  vtkBooleanMacro(CloseBorder, vtkTypeBool);
  ///@}

  ///@{
  /// Whether to add point normals, which point outward. A vertex has the normal of the source's
  /// triangle on which it lies, so that edges and details which voxels blur show in the shading. A
  /// vertex off the source's triangles, and any vertex of a cloud's surface, has the mean of the
  /// normals of the surface's own triangles around it, weighted by area. A sharp surface
  /// or one of voxels gets normals of its faces as cell data instead. Default on.
  vtkSetMacro(GenerateNormals, vtkTypeBool);
  vtkGetMacro(GenerateNormals, vtkTypeBool);
  vtkBooleanMacro(GenerateNormals, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Whether the surface takes over what the source has, so that a coloured scan gives a coloured
   * surface. A vertex gets point data, interpolated within the nearest triangle or copied from the
   * nearest point of a cloud; a face gets cell data, copied from the cell nearest to its middle.
   * Floats and colours (three or four bytes) are interpolated; any other array, as of labels, has
   * nothing in between, and the nearest corner gives its own. Arrays that the surface has already
   * stay, and what is active in the source becomes active where the surface has none. Names of
   * regions come along as field data. Of several data sets those arrays are taken that all have,
   * and colours that some have, white elsewhere; a warning names others. Default off.
   */
  vtkSetMacro(TransferAttributes, vtkTypeBool);
  vtkGetMacro(TransferAttributes, vtkTypeBool);
  vtkBooleanMacro(TransferAttributes, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Whether vertices and faces get the cells of the source that are nearest to them and to their
   * middles: the array "NearestCell" (vtkIdType) has the id of the cell in its data set, or of the
   * point of a cloud, and -1 where the source is empty. With composite or several sources
   * "NearestBlock" (int) has the flat index of the data set; several sources count as blocks of
   * one. Distances that differ by rounding only are equal, and of equally near cells the first in
   * the first data set counts. Cells of a source that is mirrored stand for their images. In a
   * parallel program all ranks need the whole source (REPLICATED). Default off.
   */
  vtkSetMacro(GenerateNearestCells, vtkTypeBool);
  vtkGetMacro(GenerateNearestCells, vtkTypeBool);
  vtkBooleanMacro(GenerateNearestCells, vtkTypeBool);
  ///@}

  ///@{
  /// The precision of the points: vtkAlgorithm::SINGLE_PRECISION, DOUBLE_PRECISION or
  /// DEFAULT_PRECISION, which takes double only where single could not separate places to a
  /// ten-thousandth of a voxel: far from the origin, on very fine grids, and beyond the range of
  /// single precision. Default DEFAULT_PRECISION.
  vtkSetMacro(OutputPointsPrecision, int);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /// Whether port 1 has an image of the samples, with the point array "Inside" (unsigned char): 1
  /// inside of the result and 0 outside. Its grid is known before the execution, as in
  /// vtkWindingNumberField. Default off: the image is empty.
  vtkSetMacro(GenerateImage, vtkTypeBool);
  vtkGetMacro(GenerateImage, vtkTypeBool);
  vtkBooleanMacro(GenerateImage, vtkTypeBool);
  ///@}

  /// Returns what the last surface encloses, for people: "1 part, volume 0.5 (input 0.51)". The
  /// field data have the numbers, as "Closed", "Parts", "Volume" and "InputVolume".
  const char* GetSolidInWords() const { return this->SolidInWords.c_str(); }

  /// The output of port 0.
  vtkPolyData* GetOutput();

  /// The output of port 1.
  vtkImageData* GetImage();

protected:
  vtkWindingNumberSurfaceAlgorithm();
  ~vtkWindingNumberSurfaceAlgorithm() override = default;

  vtkWindingNumberSurfaceAlgorithm(const vtkWindingNumberSurfaceAlgorithm&) = delete;
  void operator=(const vtkWindingNumberSurfaceAlgorithm&) = delete;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void CheckProperties() override;
  void HashProperties(winding::ContentHash& hash) override;
  bool WorksOnFirstRank() const override { return true; }
  bool WarnsOfOpenSide() const override { return false; }
  double GetResultBytes(vtkIdType) const override { return 0; } // tasks say what they need

  /// Returns the information of the output that a request is about.
  static vtkInformation* GetRequestedOutput(vtkInformation* request, vtkInformationVector* outputs);

  /// Whether a request is for a piece that stays empty: the first has everything.
  bool IsLaterPiece(vtkInformation* output) const;

  /// Lays the grid over a source: anew, or where the grid of the image has been announced.
  void SetUpGridOver(vtkDataObject* source);

  virtual winding::SurfaceOptions GetSurfaceOptions() const;

  /// Adds the arrays of a task to the output, and to the image if there is one.
  void AddResult(const winding::ArraySink& result, vtkPolyData* output);

  /// Adds what TransferAttributes and GenerateNearestCells ask for.
  void AddNearest(vtkDataObject* source, vtkPolyData* output);

  /// Returns the memory that this takes for the source of a field, in bytes.
  std::size_t GetBytesOfNearest(const winding::Field& field) const;

  int Features = SMOOTH;
  vtkTypeBool GenerateTriangles = 0;
  vtkTypeBool CloseBorder = 0;
  vtkTypeBool GenerateNormals = 1;
  vtkTypeBool TransferAttributes = 0;
  vtkTypeBool GenerateNearestCells = 0;
  vtkTypeBool GenerateImage = 0;
  int OutputPointsPrecision = DEFAULT_PRECISION;

private:
  std::string SolidInWords;
};
VTK_ABI_NAMESPACE_END

#endif
