// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWindingNumberGridAlgorithm
 * @brief   base class of winding-number filters that sample a regular grid: the grid
 *
 * **Grid.** The samples are the centres of voxels that fill a box: the input's bounds and a padding
 * around them, or SamplingBounds. Voxels are cubic, their size given by VoxelSize or by Resolution,
 * and then the box grows to a whole number of them, evenly on both sides; or SamplingDimensions
 * says how many there are along each axis, and they fill the box exactly.
 *
 * **Time.** The grid follows a source that moves or grows with time: at every time step it lies
 * over the source as it is then. One grid for all times is laid by SamplingBounds, with
 * UseInputBounds off.
 *
 * Bounds that give no grid are refused in one line through vtkErrorMacro. SamplingBounds are
 * checked only where they are used, for a user interface may fill them from an input that is empty.
 *
 * @sa vtkWindingNumberField vtkWindingNumberSurface
 */
#ifndef vtkWindingNumberGridAlgorithm_h
#define vtkWindingNumberGridAlgorithm_h

#include "vtkWindingABINamespace.h"
#include "vtkWindingNumberAlgorithm.h"

#include <array>      // for extents
#include <cstddef>    // for std::size_t
#include <functional> // for the values to verify
#include <string>     // for reasons
#include <vector>     // for bounds

namespace winding
{
struct Grid;
struct GridRequest;
struct ResultOnGrid;
struct Verification;
class WallGrid;
} // namespace winding
VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;

class VTKFILTERSWINDING_EXPORT vtkWindingNumberGridAlgorithm : public vtkWindingNumberAlgorithm
{
public:
  vtkTypeMacro(vtkWindingNumberGridAlgorithm, vtkWindingNumberAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether to make a solid of a source, where a warning would say that it is none. Faces that
   * contradict each other, look inward or are there more than once are turned, as OrientFaces does;
   * points without normals get estimated ones, and normals that look inward are turned. Open sheets
   * that bound nothing become a plate of three voxels, and surfaces are closed at the border of the
   * grid. A warning says what was done. Other properties win: nothing is turned where OrientFaces,
   * SheetSide, another InsideRule or WindingThreshold is given, and no plate is made with another
   * shape or Coverage ANY. Default on, off in vtkWindingNumberField, where w would be another one:
   * there a plate changes Inside and Coverage.
   */
  vtkSetMacro(MendSource, vtkTypeBool);
  vtkGetMacro(MendSource, vtkTypeBool);
  vtkBooleanMacro(MendSource, vtkTypeBool);
  ///@}

  ///@{
  /// The number of cubic voxels along the longest side, where neither SamplingDimensions nor
  /// VoxelSize is set. With 0 there are 128, or up to 286 where walls of the source are thinner
  /// than one and a half voxels (GetResolutionReason()). Walls do not count with SamplingBounds,
  /// and on several ranks. Default: 0 where a surface is made, and 128 for images.
  vtkSetMacro(Resolution, int);
  vtkGetMacro(Resolution, int);
  ///@}

  /// Returns why the last execution chose more voxels than 128; an empty text where it did not.
  const char* GetResolutionReason() const { return this->ResolutionReason.c_str(); }

  ///@{
  /// The side of the cubic voxels, in the unit of the input; 0 leaves it to Resolution. 0 or more,
  /// default 0.
  vtkSetMacro(VoxelSize, double);
  vtkGetMacro(VoxelSize, double);
  ///@}

  ///@{
  /// The number of voxels along each axis, 1 or more, which need not be cubic then; 0 0 0 leaves it
  /// to VoxelSize and Resolution. Default 0 0 0.
  vtkSetVector3Macro(SamplingDimensions, int);
  vtkGetVector3Macro(SamplingDimensions, int);
  ///@}

  ///@{
  /// Whether to lay the grid over the bounds of the input, with Padding, instead of SamplingBounds.
  /// Default on.
  vtkSetMacro(UseInputBounds, vtkTypeBool);
  vtkGetMacro(UseInputBounds, vtkTypeBool);
  vtkBooleanMacro(UseInputBounds, vtkTypeBool);
  ///@}

  ///@{
  /// Whether UseInputBounds takes the bounds of the input over all of its times, so that all times
  /// have one grid. It brings the input up to date for each time, and again after a change.
  /// Default off.
  vtkSetMacro(BoundsOverAllTimes, vtkTypeBool);
  vtkGetMacro(BoundsOverAllTimes, vtkTypeBool);
  vtkBooleanMacro(BoundsOverAllTimes, vtkTypeBool);
  ///@}

  ///@{
  /// The outer faces of the voxels: xmin, xmax, ymin, ymax, zmin, zmax. They are used as they are,
  /// without padding, where UseInputBounds is off or the input is empty. Default 0 1 0 1 0 1.
  vtkSetVector6Macro(SamplingBounds, double);
  vtkGetVector6Macro(SamplingBounds, double);
  ///@}

  ///@{
  /// The margin around the input's bounds on each side, as a fraction of their longest side. With
  /// SamplingDimensions it is a fraction of each axis's own side, unless that is 0. Unless it is 0,
  /// it is a voxel at least, so that surfaces of few voxels close. 0 or more, default 0.05.
  vtkSetMacro(Padding, double);
  vtkGetMacro(Padding, double);
  ///@}

  ///@{
  /// The number of random samples, and of samples within two voxels of the source, to compare with
  /// the direct sum, done one primitive after the other in double precision; not for parity. 0 or
  /// more, default 0.
  vtkSetMacro(VerifySamples, int);
  vtkGetMacro(VerifySamples, int);
  ///@}

  ///@{
  /// The findings of the last execution's verification: the largest and the root-mean-square error
  /// over the random samples, the largest over those near the source, and how many samples of each
  /// kind were compared. When streaming, they belong to the extent that was executed last.
  vtkGetMacro(MaxError, double);
  vtkGetMacro(RMSError, double);
  vtkGetMacro(NearMaxError, double);
  vtkGetMacro(NumberOfVerifiedSamples, vtkIdType);
  vtkGetMacro(NumberOfNearVerifiedSamples, vtkIdType);
  ///@}

  ///@{
  /// The number of samples, of both kinds together, that the last execution's verification did not
  /// compare. They lie on the surface as far as coordinates can decide, where the values of both
  /// sides are right; or at a point of a cloud that is not regularized, where w has no value. A
  /// value that no side explains counts as an error even there.
  vtkGetMacro(NumberOfSamplesOnSurface, vtkIdType);
  ///@}

  ///@{
  /// The number of samples, of both kinds together, that the last execution's verification compared
  /// apart, and the largest error there. They lie so near to a point of a cloud that is not
  /// regularized, nearer than √(area/4π), that this point alone may give 1 or more. w grows without
  /// bounds there, and single precision rounds it by 6e-8 of its size, whatever the Tolerance.
  vtkGetMacro(NumberOfSamplesBesidePoints, vtkIdType);
  vtkGetMacro(MaxErrorBesidePoints, double);
  ///@}

  /// The grid that was laid last: voxels per axis, the first sample, and the spacing of the
  /// samples. 0 voxels before the first. On a turned image, coordinates are along its axes.
  void GetGrid(int dimensions[3], double firstSample[3], double spacing[3]) const;

protected:
  vtkWindingNumberGridAlgorithm();
  ~vtkWindingNumberGridAlgorithm() override;

  vtkWindingNumberGridAlgorithm(const vtkWindingNumberGridAlgorithm&) = delete;
  void operator=(const vtkWindingNumberGridAlgorithm&) = delete;

  bool EvaluatesGrid() const override { return true; }
  bool InformationNeedsSource() const override { return true; }
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void CheckProperties() override;
  void HashProperties(winding::ContentHash& hash) override;

  /// The number of input ports that sources come from, counted from 0: one, unless a filter says
  /// otherwise.
  virtual int GetNumberOfSourcePorts() const { return 1; }

  /// Returns the connections of these ports, in their order.
  std::vector<vtkAlgorithmOutput*> GetSourceConnections();

  /// Returns the source as the inputs hold it now, which may be null, or makes blocks of several
  /// inputs, which live until the next call.
  virtual vtkDataObject* MakeSource();

  /// Brings the source up to date, whole, for the time that `outInfo` asks for, if it asks for one.
  /// Throws a refusal if it fails.
  void UpdateSource(vtkInformation* outInfo);

  /// Finds what BoundsOverAllTimes wants, and has the source at the time that `outInfo` asks for
  /// again, or at the first. To be called in RequestInformation(), by all ranks.
  void FindBoundsOverAllTimes(vtkInformation* outInfo);

  /// Has the source at each of its times and calls `work`, which gets the number of the time and
  /// how many there are. Then has the source as FindBoundsOverAllTimes() does. Returns false, and
  /// calls nothing, where the source has no times. Collective.
  bool ForEachTime(vtkInformation* outInfo,
    const std::function<void(std::size_t number, std::size_t count)>& work);

  /// Returns whether the source has steps of time. Throws a refusal where it has a range alone.
  bool HasTimeSteps();

  /// Returns whether the result is one of all times: no, unless a filter says otherwise.
  virtual bool IsOfAllTimes() const { return false; }

  /// Adds everything to a hash that GetSourceBounds() depends on, except the source itself.
  virtual void HashBounds(winding::ContentHash& hash);

  /// Adds all solids whose walls decide about the grid; `source` is one unless a filter says
  /// otherwise.
  virtual void AddSolids(vtkDataObject* source, winding::WallGrid& grid);

  /// Lays the grid that the properties want over a source.
  void SetUpGrid(vtkDataObject* source);

  /// Lays the grid of the last SetUpGrid() over a source whose bounds may have changed since. It
  /// keeps its number of voxels along each axis, and these stay cubic unless SamplingDimensions are
  /// set. An empty source leaves the grid where it was.
  void MoveGrid(vtkDataObject* source);
  const winding::Grid& GetSampling() const { return *this->Sampling; }

  /// Lays a grid that is given, which a source does not move.
  void UseGrid(const winding::Grid& grid);

  /// PrepareField() for that grid; each rank evaluates about its share, unless the first
  /// does all.
  const winding::Field& PrepareGridField(vtkDataObject* source);

  /// PrepareGridField() for one of several solids; what is refused has its name.
  const winding::Field& PrepareGridFieldOf(vtkDataObject* source, const std::string& name);

  /// Warns of what a result on the whole grid shows of a field, and sets SourceIsInsideOut. Sets
  /// what `result` says of voxels that the source touches.
  void WarnOfResult(const winding::Field& field, winding::ResultOnGrid result);

  /// Whether voxels that the source touches could count as inside, but do not.
  virtual bool MayTouchVoxels() const { return false; }

  /// Returns by how much the result reaches beyond the source: the grid over the source's bounds
  /// grows by this length on all sides.
  virtual double GetReachBeyondSource() const { return 0; }

  /// Throws a refusal if samples are to be verified and cannot be; `hasValues` says whether there
  /// will be an array of w.
  void CheckVerification(bool hasValues) const;

  ///@{
  /// Verifies the values of an extent, if VerifySamples asks for it. valueOf(n) is the value of its
  /// n-th sample.
  void Verify(const winding::Field& field, const std::array<int, 6>& samples, vtkDataArray* values);
  void Verify(const winding::Field& field, const std::array<int, 6>& samples,
    const std::function<double(std::size_t)>& valueOf);
  ///@}

  /// Verifies an extent of the field of one of several sources, if VerifySamples asks for it, and
  /// adds the findings to those that are set. Computes the values for it.
  void VerifyAnother(const winding::Field& field, const std::array<int, 6>& samples);

  /// Takes over the findings of a verification; a default object stands for none.
  void SetVerification(const winding::Verification& found);

  bool MendsSource() const override { return this->MendSource != 0; }

  vtkTypeBool MendSource = 1;
  int Resolution = 128;
  double VoxelSize = 0;
  int SamplingDimensions[3] = {0, 0, 0};
  vtkTypeBool UseInputBounds = 1;
  vtkTypeBool BoundsOverAllTimes = 0;
  double SamplingBounds[6] = {0, 1, 0, 1, 0, 1};
  double Padding = 0.05;
  int VerifySamples = 0;
  double MaxError = 0;
  double RMSError = 0;
  double NearMaxError = 0;
  vtkIdType NumberOfVerifiedSamples = 0;
  vtkIdType NumberOfNearVerifiedSamples = 0;
  vtkIdType NumberOfSamplesOnSurface = 0;
  vtkIdType NumberOfSamplesBesidePoints = 0;
  double MaxErrorBesidePoints = 0;

private:
  struct Times;
  Times GetTimes();
  void AgreeOnTimes(const Times& times);
  void Visit(const Times& times, vtkInformation* outInfo, const std::function<void()>& work);
  void UpdateConnection(vtkAlgorithmOutput* connection, vtkInformation* outInfo);
  winding::GridRequest GetGridRequest(vtkDataObject* source);
  int GetWallResolution(vtkDataObject* source);
  bool GetBoundsOfGrid(vtkDataObject* source, double bounds[6]);

  std::string ResolutionReason;
  double WallSeconds = 0;               ///< for preparing sources whose walls were measured
  std::vector<double> BoundsOfTimes;    ///< empty without BoundsOverAllTimes, and without times
  unsigned long long SourceOfTimes = 0; ///< hash of the source and the options that gave them
  std::unique_ptr<winding::GridRequest> Request; ///< of the last SetUpGrid()
  std::unique_ptr<winding::Grid> LaidOut;        ///< grid of the last SetUpGrid()
  std::unique_ptr<winding::Grid> Sampling;       ///< grid of SetUpGrid() or MoveGrid()
};
VTK_ABI_NAMESPACE_END

#endif
