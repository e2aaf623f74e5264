// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindingNumberClip
 * @brief   cuts what is inside of a source out of any data set
 *
 * Port 0 takes the data set to be cut, any vtkDataSet or a composite of them. Port 1 takes the
 * source, a surface or an oriented point cloud, which need not be closed (see
 * vtkWindingNumberAlgorithm). The output is the part of port 0 that is inside by WindingThreshold
 * and InsideRule, or outside with InsideOut: whole cells, and pieces of the cells that the end of
 * what is inside passes through.
 *
 * @code
 *   vtkNew<vtkWindingNumberClip> clip;
 *   clip->SetInputConnection(volume->GetOutputPort());
 *   clip->SetSourceConnection(scan->GetOutputPort());
 * @endcode
 *
 * vtkTableBasedClipDataSet cuts the cells, so the output is a vtkUnstructuredGrid for every data
 * set, polydata included, as for ParaView's Clip. Cells without a table in it, such as
 * polygons, polyhedra and cells of higher order, are cut by vtkClipDataSet, through simplices. All
 * arrays of the data set are kept; at new points point data are interpolated. A data set
 * without cells counts as points, and every point that is kept gets a vertex. The output for a
 * composite data set has the same structure.
 *
 * **Accuracy of the cut.** A cell is cut if one of its points is inside and another is not, so what
 * lies between the points is not seen. The cut meets an edge where distances from the end of what
 * is inside, taken with their signs and interpolated linearly between the two points, are 0. For a
 * closed surface they are the distances to its triangles: the cut is exact where the surface is
 * plane near the edge, and off by some h²/R where it has the radius R of curvature and edges have
 * the length h. For open surfaces and clouds they are the smaller one of that distance and of |w −
 * WindingThreshold| / |∇w|, which is the distance from the level, to first order, across holes and
 * between points. Where another part of the source is nearer to one of the two points than what the
 * edge crosses, as at sharp edges, in parts and gaps that are thinner than a cell, and where
 * surfaces overlap, the cut may be off by as much as an edge. Measured on the edges of grids of 40
 * and 100 points along an axis, the mean error is 0.01 to 0.03 of an edge for closed meshes, 0.03
 * for open scans, 0.05 for a cloud, and on 24 points 0.13 for a truck of loose sheets, most of them
 * thinner than a cell. Interpolating w, which jumps by 1 across the surface, gives 0.14
 * to 0.26 for the same ones. The part inside and the part outside have the same points on the cut.
 *
 * No arrays are added. A warning says so where the result is empty. Points that are NaN or infinite
 * are neither inside nor outside; cells that have them are left out.
 *
 * **Pipeline.** w is evaluated at all points, distances and gradients at points of cells that are
 * cut. It takes 23 bytes for each point, 24 more for a data set that stores no coordinates of float
 * or double, and in addition what vtkTableBasedClipDataSet takes. The abort flag is asked all the
 * while, but not while VTK cuts the cells of one data set.
 *
 * @sa vtkWindingNumberProbe vtkImplicitWindingNumber vtkTableBasedClipDataSet
 */
#ifndef vtkWindingNumberClip_h
#define vtkWindingNumberClip_h

#include "vtkWindingABINamespace.h"
#include "vtkWindingNumberProbeAlgorithm.h"

#include <vector> // for the numbers by which cells are cut

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSWINDING_EXPORT vtkWindingNumberClip : public vtkWindingNumberProbeAlgorithm
{
public:
  static vtkWindingNumberClip* New();
  vtkTypeMacro(vtkWindingNumberClip, vtkWindingNumberProbeAlgorithm);

protected:
  vtkWindingNumberClip() = default;
  ~vtkWindingNumberClip() override = default;

  vtkWindingNumberClip(const vtkWindingNumberClip&) = delete;
  void operator=(const vtkWindingNumberClip&) = delete;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  bool KeepsPart() const override { return true; }
  const winding::ProbeWords& GetWords() const override;
  winding::ResultOptions GetResultOptions() const override;
  double GetResultBytes(vtkIdType samples) const override;
  std::size_t GetAdditionalBytes(const winding::Field& field, vtkIdType samples) override;

  vtkSmartPointer<vtkDataObject> NewOutput(vtkDataObject* input) const override;
  double GetProgressOfSamples() const override;
  void FinishSamples(const winding::Field& field, const winding::ProbeQueries& queries,
    const unsigned char* inside) override;
  vtkSmartPointer<vtkDataSet> PartOf(
    vtkDataSet* data, const winding::ProbeLeaf& leaf, const unsigned char* inside) override;

private:
  std::vector<double> CutDistances; ///< one for each sample, while the output is made
  vtkIdType SamplesDone = 0;        ///< samples of the data sets that have been cut
};
VTK_ABI_NAMESPACE_END

#endif
