// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Evaluator.h"
#include "base/Executor.h"
#include "base/Lazy.h"
#include "base/Views.h"
#include "diagnosis/Diagnosis.h"
#include "farfield/FarFieldChoice.h"
#include "farfield/TriangleFarField.h"
#include "field/CappedSurface.h"
#include "field/Field.h"
#include "rays/PointCrossings.h"
#include "source/Surface.h"
#include "surface/BoundaryGradient.h"

namespace winding
{

/// The field of triangles: chooses between the methods for surfaces.
class SurfaceField final : public Field
{
public:
  /// Throws Refusal as Field::build() does, and Interrupted.
  SurfaceField(
    const std::vector<TrianglesView>& views, const FieldOptions& options, Executor& executor);
  ~SurfaceField() override;

  const FieldInfo& info() const override { return info_; }

  /// Adds to what is to be said of the source.
  void addNote(const Message& note) { info_.warnings.push_back(note); }

  void prepare(const Grid& grid, Executor& executor) const override;
  void prepare(const VectorsView& samples, Executor& executor) const override;

  const Surface* surface() const override { return &surface_; }
  const Surface* distinctSurface() const override { return distinct_; }
  const Diagnosis& diagnosis() const override { return *diagnosis_; }
  const RowCrossings* integerRows() const override;
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
  const Evaluator& evaluator() const override { return *evaluator_; }
  const GradientEvaluator& gradientEvaluator() const override { return *boundaryGradient_; }

private:
  void complete(const FieldOptions& options, Executor& executor);
  void mergeEqual(const BoundaryChain& chain);
  void describe(const BoundaryChain& chain, const FieldOptions& options);
  SurfaceFacts takeFacts(BoundaryChain& chain, const FieldOptions& options) const;
  void chooseMethod(const FieldOptions& options, const BoundaryChain& chain, Executor& executor);
  void chooseFarField(const FieldOptions& options, const std::string& why);
  void makeFarField(double tolerance);

  bool usesFarField(std::size_t samples) const;
  FarFieldGain gainOfFarField() const;
  bool usesCapAtPoints(std::size_t samples) const;
  bool usesFarField(const Grid& grid) const;

  FieldOptions options_;
  Surface surface_;
  PolygonParts parts_;                  ///< of the surface
  Surface merged_;                      ///< the surface with equal triangles taken together, if any
  const Surface* distinct_ = &surface_; ///< the one of the two that is summed
  FieldInfo info_;
  bool hasTurned_ = false; ///< whether orienting turned faces or left some out
  std::unique_ptr<const Diagnosis> diagnosis_;
  Lazy<double> area_;               ///< the area of the surface
  Lazy<FarFieldGain> gain_;         ///< what a far field may save
  bool isFarFieldAskedFor_ = false; ///< whether the user chose method hierarchical
  bool isRowsAskedFor_ = false;     ///< whether the user chose method rows
  int order_ = 0;                   ///< order of expansions; 0 where the tolerance admits none
  std::unique_ptr<const BoundaryGradient> boundaryGradient_;
  /// Evaluates grids, and scattered samples of an open surface, with method rows.
  std::unique_ptr<const CappedSurface> capped_;
  /// Evaluates scattered samples of a closed surface with method rows.
  std::unique_ptr<const PointCrossings> crossings_;
  /// Evaluates all samples with method hierarchical, and scattered samples of an open surface that
  /// are too few for the cap.
  std::unique_ptr<const TriangleFarField> farField_;
  std::unique_ptr<const Evaluator> evaluator_; ///< evaluates all that the others leave
};

} // namespace winding
