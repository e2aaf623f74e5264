// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/Views.h"
#include "diagnosis/Diagnosis.h"
#include "farfield/FarField.h"
#include "field/Field.h"
#include "source/PointCloud.h"
#include "sums/DirectSum.h"

namespace winding
{

/// The field of oriented points.
class CloudField final : public Field
{
public:
  /// Throws Refusal as Field::build() does, and Interrupted.
  CloudField(
    const std::vector<OrientedPointsView>& views, const FieldOptions& options, Executor& executor);
  ~CloudField() override;

  const FieldInfo& info() const override { return info_; }

  void gradient(const VectorsView& samples, double* gradients, Executor& executor) const override;

  const PointCloud* cloud() const override { return &cloud_; }
  const Diagnosis& diagnosis() const override { return *diagnosis_; }
  std::size_t expectedBytes(std::size_t samples) const override;
  double reference(const Eigen::Vector3d& sample) const override;
  double jumpWithin(const Eigen::Vector3d& sample, double distance) const override;
  PointOnSource pointOnSource() const override;
  double area() const override;

protected:
  void evaluateValues(const Grid& grid, const Extent& extent, const FieldOutput& output,
    Executor& executor) const override;
  void evaluateValues(
    const VectorsView& samples, const FieldOutput& output, Executor& executor) const override;
  std::shared_ptr<const Field> makeTurned(Executor& executor) const override;
  std::unique_ptr<const DistanceTree> makeDistanceTree(Executor& executor) const override;
  const Evaluator& evaluator() const override { return *sum_; }
  const GradientEvaluator& gradientEvaluator() const override { return *sum_; }

private:
  void warnOfUnused(const FieldOptions& options);
  bool estimateNormals(const FieldOptions& options, Executor& executor);
  void findNormalsAndAreas(const FieldOptions& options, bool isOfHalf, Executor& executor);
  bool turnSheet(const FieldOptions& options);
  void regularize(double spacings);
  void chooseMethod(const FieldOptions& options, Executor& executor);

  bool usesFarField(std::size_t samples) const;
  bool usesFarField(const Grid& grid) const;

  FieldOptions options_;
  PointCloud cloud_;
  FieldInfo info_;
  bool areNormalsEqual_ = false, areAreasGiven_ = false;
  std::unique_ptr<const Diagnosis> diagnosis_;
  bool isAskedFor_ = false;                  ///< whether the user chose the method
  std::unique_ptr<const FarField> farField_; ///< null unless the method is hierarchical
  std::unique_ptr<const DipoleSum> sum_;
};

} // namespace winding
