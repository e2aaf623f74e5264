#pragma once

#include "base/Bounds.h"
#include "farfield/SplitTriangles.h"
#include "source/PointCloud.h"
#include "source/Surface.h"
#include "sums/DirectSumKernels.h"
#include "sums/GradientKernels.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace winding
{

/// Items begin … end − 1.
struct ItemRange
{
  std::uint32_t begin, end;
};

/**
 * What a far field is made of: items that are summed exactly near by and are distributions of dipoles
 * far away. Coordinates are those of the caller times `scale`, a power of two that brings the sources
 * to about unit size.
 */
class FarFieldSources
{
public:
  virtual ~FarFieldSources() = default;

  double scale() const { return scale_; }

  virtual std::vector<Eigen::Vector3d> centers() const = 0;

  /// Puts item order[i] at place i. inSingle: points may be summed in single precision, with offsets
  /// in double; triangles never are, for a sample's side of them hangs on the last bits.
  virtual void arrange(const std::vector<std::uint32_t>& order, bool inSingle) = 0;

  struct Dipole
  {
    Eigen::Vector3d position;
    Eigen::Vector3d moment; ///< normal · area / 4π
  };

  /// Appends dipoles that have the moments of the items up to the given order, exactly.
  virtual void appendDipoles(ItemRange items, int order, std::vector<Dipole>& dipoles) const = 0;

  /// The farthest distance of any point of the items from a centre.
  virtual double reach(ItemRange items, const Eigen::Vector3d& center) const = 0;

  /// The largest length over which an item is spread (SolidAngle.h): only several of them away its sum
  /// and gradient are those of the dipoles that stand for it. 0 for none.
  virtual double spread(ItemRange items) const = 0;

  /**
   * The sum of some items at a block of samples, whose coordinates are scaled, exact up to rounding.
   * With isSuspect, it is set where a sample lies on an item within rounding; true if on any.
   */
  virtual bool sum(const std::vector<ItemRange>& items, const SampleBlock& samples, double* values,
    bool* isSuspect) const = 0;

  /// Adds the gradients of some items, exact up to rounding.
  virtual void addGradients(
    const std::vector<ItemRange>& items, const SampleBlock& samples, GradientSums& sums) const = 0;

  /// About what one item costs at one sample.
  virtual double secondsPerPair() const = 0;

  /// About what eight cells cost more than the one that they are cut from, for each coefficient of an
  /// expansion; measured. A sum of triangles has more to begin and to end.
  virtual double secondsPerCutAndCoefficient() const = 0;

  /// Items of a leaf that suit the cost.
  virtual std::size_t leafSize() const = 0;

protected:
  explicit FarFieldSources(double scale)
    : scale_(scale)
  {
  }

private:
  double scale_;
};

/// Points are spread over the lengths that the cloud has, if any.
std::unique_ptr<FarFieldSources> farFieldSources(
  const PointCloud& cloud, const std::vector<double>& areas);

/// Triangles with sides longer than the rule allows are cut in pieces first.
std::unique_ptr<FarFieldSources> farFieldSources(const std::vector<Eigen::Vector3d>& vertices,
  const std::vector<Triangle>& triangles, const Bounds& bounds, const SplitRule& rule);

} // namespace winding
