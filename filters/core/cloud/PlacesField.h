// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "cloud/NormalPatches.h"
#include "farfield/FarFieldSources.h"
#include "source/DistinctPoints.h"
#include "source/PointCloud.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winding
{

using Normals = std::vector<Eigen::Vector3d>;

/// Whether each normal is to be turned round.
using Turns = std::vector<unsigned char>;

Normals turned(Normals normals, const Turns& turns);

/**
 * The winding numbers of the places of a cloud for any normals. A place has the square of its
 * spacing for an area and is spread over some spacings. Values are looked at in some of the places,
 * and summed directly, in parts that take little memory. All results are the same for any executor.
 * All methods throw Interrupted.
 */
class PlacesField
{
public:
  /// Looks at up to 1536 of the places, evenly chosen. spread: the length over which places are
  /// spread, in their spacings. Places and spacings must outlive this.
  PlacesField(const DistinctPoints& places, const std::vector<double>& spacings, double spread,
    Executor& executor);

  /// Looks at the places given.
  PlacesField(const DistinctPoints& places, const std::vector<double>& spacings, double spread,
    std::vector<std::uint32_t> lookedAt, Executor& executor);

  /// Returns the places looked at.
  const std::vector<std::uint32_t>& lookedAt() const { return lookedAt_; }

  /// Returns the share of each patch, by column, in w at the places looked at.
  Eigen::MatrixXd sharesOf(
    const Normals& normals, const Turns& turns, const NormalPatches::Largest& patches) const;

  /// Returns the share of some places in w at the places looked at.
  Eigen::VectorXd sharesOf(
    const Normals& normals, const Turns& turns, const std::vector<std::uint32_t>& some) const;

  /// w at the places looked at.
  Eigen::VectorXd valuesOf(const Normals& normals, const Turns& turns) const;

  /// The gradients of w at some places, which are scaled as the cloud is. Places are
  /// spread half as far again, which sees less of single points.
  Normals gradients(const Normals& normals, const Turns& turns, const Normals& at) const;

private:
  /// The places with numbers first … last − 1 of an order, or of all places where order is null.
  PointCloud part(const Normals& normals, const Turns& turns, const std::uint32_t* order,
    std::size_t first, std::size_t last) const;
  /// Sums over ranges of the places in an order, by column. The ranges follow each other.
  Eigen::MatrixXd sums(const Normals& normals, const Turns& turns, const std::uint32_t* order,
    const std::vector<ItemRange>& ranges) const;

  const DistinctPoints& places_;
  const std::vector<double>& spacings_;
  double spread_;
  Executor& executor_;
  std::vector<std::uint32_t> lookedAt_;
};

} // namespace winding
