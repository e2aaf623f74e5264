// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "field/Field.h"
#include "support/RowValues.h"

#include <stdexcept>
#include <utility>

namespace shapes
{

/// A field on one grid that is 1 or 0 at its samples, as they are given: solids that no source has
/// to be made for. It answers nothing but values on that grid and gradients, which are 0.
class BitField final : public winding::Field
{
public:
  std::vector<unsigned char> inside; ///< by sample number

  const winding::Diagnosis& diagnosis() const override
  {
    throw std::logic_error("a field of bits has no source");
  }
  const winding::FieldInfo& info() const override { return info_; }
  void gradient(
    const winding::VectorsView& samples, double* gradients, winding::Executor&) const override
  {
    std::fill_n(gradients, 3 * samples.size(), 0.0);
  }
  double area() const override { return 0; }
  std::size_t expectedBytes(std::size_t) const override { return 0; }
  double reference(const Eigen::Vector3d&) const override { return 0; }
  double jumpWithin(const Eigen::Vector3d&, double) const override { return 0; }
  PointOnSource pointOnSource() const override { return {}; }

protected:
  void evaluateValues(const winding::Grid&, const winding::Extent& extent,
    const winding::FieldOutput& output, winding::Executor&) const override
  {
    if (winding::sampleCount(extent) != inside.size())
    {
      throw std::logic_error("only the whole grid has values");
    }
    const std::vector<double> values(inside.begin(), inside.end());
    output.write(values.data(), 0, values.size());
  }
  std::shared_ptr<const winding::Field> makeTurned(winding::Executor&) const override
  {
    throw std::logic_error("a field of bits has no source");
  }
  std::unique_ptr<const winding::DistanceTree> makeDistanceTree(winding::Executor&) const override
  {
    throw std::logic_error("a field of bits has no source");
  }
  const winding::Evaluator& evaluator() const override
  {
    throw std::logic_error("a field of bits has no evaluator");
  }
  const winding::GradientEvaluator& gradientEvaluator() const override
  {
    throw std::logic_error("a field of bits has no evaluator");
  }

private:
  winding::FieldInfo info_;
};

} // namespace shapes
