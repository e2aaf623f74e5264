#include "CloudField.h"

#include "PointAreas.h"
#include "ReferenceSum.h"
#include "Refusal.h"

#include <algorithm>
#include <cmath>

namespace winding
{

CloudField::CloudField(
  const std::vector<OrientedPointsView>& views, const FieldOptions& options, Executor& executor)
  : cloud_(sanitize(views, executor))
{
  if (options.method == Method::parity || options.method == Method::rows)
  {
    throw Refusal(std::string(nameOf(options.method)) +
                  " needs triangles and this is a point cloud; choose another method");
  }
  info_.isSurface = false;
  info_.inputPrimitives = cloud_.inputPoints;
  info_.primitives = cloud_.positions.size();
  info_.dropped = cloud_.dropped();
  info_.weldedVertices = cloud_.positions.size();
  info_.bounds = cloud_.bounds;
  if (cloud_.dropped() > 0)
  {
    info_.warning = std::to_string(cloud_.dropped()) + " of " + std::to_string(cloud_.inputPoints) +
                    " points were unusable and left out (" +
                    std::to_string(cloud_.nonFinitePoints) + " with NaN or infinite values, " +
                    std::to_string(cloud_.zeroNormalPoints) + " with normals of length 0, " +
                    std::to_string(cloud_.badAreaPoints) + " with negative areas)";
  }
  this->chooseAreas(options.pointArea, executor);
  this->regularize(options.regularization);
  sum_ = std::make_unique<DipoleSum>(cloud_, cloud_.areas);
  this->chooseMethod(options, executor);
}

CloudField::~CloudField() = default;

void CloudField::chooseAreas(double constantArea, Executor& executor)
{
  if (!(constantArea >= 0) || !std::isfinite(constantArea))
  {
    throw Refusal("the point area is " + std::to_string(constantArea) +
                  "; it must be more than 0, or 0 to be estimated");
  }
  if (!cloud_.areas.empty())
  {
    return;
  }
  info_.pointArea = constantArea > 0 ? constantArea : meanPointArea(cloud_, executor);
  cloud_.areas.assign(cloud_.positions.size(), info_.pointArea);
  if (info_.pointArea == 0 && !cloud_.positions.empty())
  {
    info_.warning += std::string(info_.warning.empty() ? "" : "; ") +
                     "the area of the points cannot be estimated, so the field is 0; set a point "
                     "area";
  }
}

/// Spreads every point over so many of its spacings.
void CloudField::regularize(double spacings)
{
  if (!(spacings >= 0) || !std::isfinite(spacings))
  {
    throw Refusal("the regularization is " + std::to_string(spacings) +
                  "; it must be more than 0, or 0 for none");
  }
  if (spacings == 0)
  {
    return;
  }
  cloud_.regularizationLengths.resize(cloud_.areas.size());
  std::transform(cloud_.areas.begin(), cloud_.areas.end(), cloud_.regularizationLengths.begin(),
    [spacings](double area) { return spacings * std::sqrt(area); });
}

void CloudField::chooseMethod(const FieldOptions& options, Executor& executor)
{
  const bool isAutomatic = options.method == Method::automatic;
  isAskedFor_ = !isAutomatic;
  info_.why = isAutomatic ? std::to_string(info_.primitives) + " points" : "asked for";
  if (options.method == Method::direct)
  {
    return;
  }
  if (options.tolerance < FarFieldAccuracy::finest)
  {
    info_.why += "; a tolerance below 1e-6 leaves the direct sum only";
    return;
  }
  const FarFieldAccuracy accuracy = FarFieldAccuracy::of(options.tolerance);
  if (isAutomatic && isCheaperDirectly(Primitive::point, info_.primitives, accuracy.order))
  {
    info_.why += "; so few are summed directly";
    return;
  }
  info_.method = Method::hierarchical;
  farField_ = std::make_unique<FarField>(farFieldSources(cloud_, cloud_.areas), accuracy, executor);
}

bool CloudField::evaluate(
  const Grid& grid, const Extent& extent, const FieldOutput& output, Executor& executor) const
{
  return farField_ ? farField_->evaluate(grid, extent, output, executor)
                   : Field::evaluate(grid, extent, output, executor);
}

bool CloudField::evaluate(
  const VectorsView& samples, const FieldOutput& output, Executor& executor) const
{
  return this->usesFarField(samples.size()) ? farField_->evaluate(samples, output, executor)
                                            : Field::evaluate(samples, output, executor);
}

bool CloudField::gradient(const VectorsView& samples, double* gradients, Executor& executor) const
{
  return this->usesFarField(samples.size()) ? farField_->gradient(samples, gradients, executor)
                                            : Field::gradient(samples, gradients, executor);
}

/// For few samples the direct sum is faster even where there is a tree, unless that was asked for.
bool CloudField::usesFarField(std::size_t samples) const
{
  return farField_ && (isAskedFor_ || !isCheaperDirectly(Primitive::point, info_.primitives,
                                        samples, farField_->order()));
}

EvaluationCost CloudField::expectedCost(std::size_t samples) const
{
  return this->usesFarField(samples)
           ? costOfFarField(Primitive::point, info_.primitives, samples, farField_->order())
           : costOfDirectSum(Primitive::point, info_.primitives, samples);
}

double CloudField::reference(const Eigen::Vector3d& sample) const
{
  return referenceSum<double>(cloud_, cloud_.areas, sample);
}

Field::PointOnSource CloudField::pointOnSource() const
{
  return [this](double, double, double t)
  {
    const auto i = static_cast<std::size_t>(t * static_cast<double>(cloud_.positions.size()));
    return cloud_.positions[std::min(i, cloud_.positions.size() - 1)];
  };
}

} // namespace winding
