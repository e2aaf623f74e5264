// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "field/CloudField.h"

#include "base/Digits.h"
#include "base/Refusal.h"
#include "cloud/CloudOrientation.h"
#include "cloud/OutwardNormals.h"
#include "cloud/PointAreas.h"
#include "diagnosis/MendNotes.h"
#include "distance/DistanceTree.h"
#include "distance/PrimitivesNear.h"
#include "farfield/FarFieldChoice.h"
#include "farfield/GridCells.h"
#include "field/SheetMessages.h"
#include "source/Sanitize.h"
#include "source/UnitNormal.h"
#include "sums/ReferenceSum.h"
#include "surface/Mirror.h"
#include "surface/SheetSide.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace winding
{

CloudField::CloudField(
  const std::vector<OrientedPointsView>& views, const FieldOptions& given, Executor& executor)
  : options_(given)
  , cloud_(sanitize(views, executor))
{
  const bool areNormalsGiven = std::any_of(views.begin(), views.end(),
    [](const OrientedPointsView& view) { return !view.normals.empty(); });
  if (options_.mendsSource && !options_.estimateNormals && !cloud_.positions.empty() &&
      (!areNormalsGiven || options_.lookAtViewpoints))
  {
    options_.estimateNormals = true;
    info_.warnings.push_back(estimatedNote());
  }
  const FieldOptions& options = options_;
  if (options.method == Method::parity || options.method == Method::rows)
  {
    throw Refusal(
      Message(std::string(nameOf(options.method)) + " needs triangles, not a point cloud",
        {{"", {{Parameter::method, static_cast<int>(Method::automatic)}}}}));
  }
  const Mirror mirror(options.mirror, options.weldTolerance);
  info_.normalsAreEstimated =
    options.lookAtViewpoints || cloud_.normals.size() < cloud_.positions.size();
  const bool areSeen = options.lookAtViewpoints || !options.toward.empty();
  const bool isOfHalf =
    info_.normalsAreEstimated && options.estimateNormals && areSeen && !mirror.isNone();
  if (isOfHalf)
  {
    // Viewpoints are of the half that was seen, and so are normals.
    const std::vector<double> areas = cloud_.areas;
    this->estimateNormals(options, executor);
    cloud_.areas = areas;
  }
  mirror.addTo(cloud_);
  info_.isSurface = false;
  info_.inputPrimitives = cloud_.inputPoints;
  info_.primitives = cloud_.positions.size();
  info_.distinct = info_.primitives;
  info_.dropped = cloud_.dropped();
  info_.weldedVertices = cloud_.positions.size();
  info_.bounds = cloud_.bounds;
  info_.isScattered = options.scattered;
  info_.tolerance = options.tolerance;
  if (cloud_.dropped() > 0)
  {
    info_.warnings.emplace_back(
      std::to_string(cloud_.dropped()) + " of " + std::to_string(cloud_.inputPoints) +
      " points were unusable and left out (" + std::to_string(cloud_.nonFinitePoints) +
      " with NaN or infinite values, " + std::to_string(cloud_.zeroNormalPoints) +
      " with normals of length 0, " + std::to_string(cloud_.badAreaPoints) +
      " with negative areas)");
  }
  this->warnOfUnused(options);
  if (options.neighbors < 3)
  {
    throw Refusal(Message(Parameter::numberOfNeighbors,
      "is " + std::to_string(options.neighbors) + "; it must be 3 or more"));
  }
  if (info_.normalsAreEstimated && !options.estimateNormals)
  {
    throw Refusal(missingNormals(areNormalsGiven && !options.lookAtViewpoints));
  }
  if (!info_.normalsAreEstimated)
  {
    if (const auto except = equalNormalsExcept(cloud_, executor))
    {
      info_.warnings.push_back(equalNormals(*except));
      areNormalsEqual_ = true;
    }
  }
  this->findNormalsAndAreas(options, isOfHalf, executor);
  this->regularize(options.regularization);
  sum_ = std::make_unique<DipoleSum>(cloud_, cloud_.areas);
  this->chooseMethod(options, executor);
  diagnosis_ = std::make_unique<Diagnosis>(cloud_, areNormalsEqual_, info_.normalsAreEstimated);
}

CloudField::~CloudField() = default;

/// Notes the options that these points have no use for.
void CloudField::warnOfUnused(const FieldOptions& options)
{
  const std::pair<Setting, bool> ofFaces[] = {{{Parameter::orientFaces, 0}, options.orientFaces},
    {{Parameter::ignoreOpenParts, 0}, options.ignoreOpenParts},
    {Parameter::flatBase, !options.flatBase.empty()}};
  for (const auto& [setting, isGiven] : ofFaces)
  {
    if (isGiven)
    {
      info_.addUnused(setting.parameter,
        {"points have no faces to turn, close or leave out", {{"do without", {setting}}}}, options);
    }
  }
  if (options.estimateNormals && options.warnsOfKeptNormals && !info_.normalsAreEstimated &&
      info_.primitives > 0)
  {
    info_.addUnused(Parameter::estimateNormals, keptNormals(), options);
  }
}

/// Gives the points normals and areas. Returns whether the normals may be wrong.
bool CloudField::estimateNormals(const FieldOptions& options, Executor& executor)
{
  const OutwardNormals found =
    giveOutwardNormals(cloud_, options.normalEstimation, Viewpoints(options.toward),
      {options.pointAreaMethod, options.pointArea, options.neighbors}, executor);
  info_.normalEstimation = found.estimation;
  info_.orientation = found.orientation;
  if (found.opposed > OutwardNormals::fewOpposed)
  {
    info_.warnings.push_back(opposedNormals(found.opposed));
  }
  return found.isUnsure();
}

/// Turns the points so that what lies on one side of them is inside, as turnSheets() turns faces.
/// Returns whether they are a sheet.
bool CloudField::turnSheet(const FieldOptions& options)
{
  const Eigen::Vector3d side = sheetSideIn(options.sheetSide);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double area = 0, moment = 0;
  for (std::size_t i = 0; i < cloud_.positions.size() && !side.isZero(); ++i)
  {
    sum += cloud_.areas[i] * cloud_.normals[i];
    area += cloud_.areas[i];
    moment += cloud_.areas[i] * side.dot(cloud_.positions[i]);
  }
  if (!(area > 0))
  {
    return false;
  }
  constexpr double closed = 0.1, leastShare = 0.05; // of the area
  if (sum.norm() < closed * area)
  {
    info_.addUnused(Parameter::sheetSide, noOpenPart(), options);
    return false;
  }
  if (std::abs(sum.dot(side)) < leastShare * area)
  {
    info_.warnings.push_back(alongSheet());
  }
  if (sum.dot(side) > 0)
  {
    for (Eigen::Vector3d& normal : cloud_.normals)
    {
      normal = 0.0 - normal.array();
    }
  }
  info_.added = 0.5; // by a half sphere at infinity
  info_.sheetHeight = moment / area;
  return true;
}

/// Estimates normals where there are none, unless `isOfHalf` says that they are there as images of
/// half a cloud, chooses areas, and warns where the field is 0 or does not separate inside from
/// outside clearly.
void CloudField::findNormalsAndAreas(const FieldOptions& options, bool isOfHalf, Executor& executor)
{
  checkPointArea(options.pointArea);
  const std::size_t points = cloud_.positions.size();
  areAreasGiven_ = !cloud_.areas.empty();
  const PointAreaOptions areas = {options.pointAreaMethod, options.pointArea, options.neighbors};
  bool areNormalsUnsure = false;
  if (info_.normalsAreEstimated && !isOfHalf)
  {
    areNormalsUnsure = this->estimateNormals(options, executor);
    // Normals that were stored and come back are made unit vectors in the same way.
    for (Eigen::Vector3d& normal : cloud_.normals)
    {
      normal = unitNormal(normal).array() + 0.0;
    }
  }
  else if (!areAreasGiven_)
  {
    cloud_.areas = pointAreas(cloud_, areas, executor);
  }
  const bool isSheet = this->turnSheet(options);
  if (info_.normalsAreEstimated && (isSheet || isOfHalf))
  {
    info_.orientation = orientationOf(cloud_, executor, info_.added);
    areNormalsUnsure = areNormalsUnsure && !info_.orientation.isClear();
  }
  double sum = 0;
  for (const double area : cloud_.areas)
  {
    sum += area / static_cast<double>(points);
  }
  info_.pointArea = sum;
  if (sum == 0 && points > 0 && areAreasGiven_)
  {
    info_.warnings.emplace_back("the field is 0, as all areas of points are",
      std::vector<Remedy>{{"give other areas", {Parameter::areaArray}}});
  }
  else if (sum == 0 && points > 0)
  {
    info_.warnings.push_back(missingPointArea("the field is 0"));
  }
  else if (areNormalsUnsure)
  {
    info_.warnings.push_back(adviceOnNormals(info_.orientation));
  }
}

/// Spreads every point over a length in units of its spacing.
void CloudField::regularize(double spacings)
{
  if (!(spacings >= 0 && spacings <= mostRegularization))
  {
    throw Refusal(Message(Parameter::regularization,
      "is " + inDigits(spacings) + " spacings; it must be 0 (none) to 4"));
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
  farField_ =
    std::make_unique<FarField>(farFieldSources(cloud_, cloud_.areas, executor), accuracy, executor);
}

void CloudField::evaluateValues(
  const Grid& grid, const Extent& extent, const FieldOutput& output, Executor& executor) const
{
  if (this->usesFarField(grid))
  {
    farField_->evaluate(grid, extent, output, executor);
    return;
  }
  Field::evaluateValues(grid, extent, output, executor);
}

void CloudField::evaluateValues(
  const VectorsView& samples, const FieldOutput& output, Executor& executor) const
{
  if (this->usesFarField(samples.size()))
  {
    farField_->evaluate(samples, output, executor);
    return;
  }
  Field::evaluateValues(samples, output, executor);
}

void CloudField::gradient(const VectorsView& samples, double* gradients, Executor& executor) const
{
  if (this->usesFarField(samples.size()))
  {
    farField_->gradient(samples, gradients, executor);
    return;
  }
  Field::gradient(samples, gradients, executor);
}

bool CloudField::usesFarField(const Grid& grid) const
{
  return this->usesFarField(sampleCount(grid.wholeExtent())) &&
         isInReachOfSingles(grid, info_.bounds, farField_->scale());
}

/// Returns whether `samples` samples take the far field, which was built with the cloud: the direct
/// sum is faster for few samples, but a far field that the user asked for is used for any.
bool CloudField::usesFarField(std::size_t samples) const
{
  return farField_ && (isAskedFor_ || !isCheaperDirectly(Primitive::point, info_.primitives,
                                        samples, farField_->order(), FarFieldState::built));
}

std::size_t CloudField::expectedBytes(std::size_t samples) const
{
  return this->usesFarField(samples)
           ? bytesOfFarField(Primitive::point, info_.primitives, farField_->order())
           : bytesPerPrimitive * info_.primitives;
}

double CloudField::area() const
{
  return info_.pointArea * static_cast<double>(info_.primitives);
}

std::shared_ptr<const Field> CloudField::makeTurned(Executor& executor) const
{
  FieldOptions options = options_;
  // These have done their work.
  options.lookAtViewpoints = false;
  options.toward.clear();
  options.mirror.clear();
  options.sheetSide.clear();
  const bool isInward = diagnosis_->orientation(executor).isMostlyInward();
  options.estimateNormals = !isInward;
  std::vector<Eigen::Vector3d> normals(isInward ? cloud_.normals.size() : 0);
  std::transform(cloud_.normals.begin(), cloud_.normals.begin() + normals.size(), normals.begin(),
    [](const Eigen::Vector3d& normal) -> Eigen::Vector3d { return 0.0 - normal.array(); });
  OrientedPointsView view;
  if (!cloud_.positions.empty())
  {
    view.positions = VectorsView(cloud_.positions.front().data(), cloud_.positions.size());
  }
  if (!normals.empty())
  {
    view.normals = VectorsView(normals.front().data(), normals.size());
  }
  if (areAreasGiven_ || isInward)
  {
    view.areas = ScalarsView(cloud_.areas.data(), cloud_.areas.size(), 1);
  }
  auto turned =
    std::make_shared<CloudField>(std::vector<OrientedPointsView>{view}, options, executor);
  if (!isInward && !turned->info_.orientation.isClear())
  {
    return nullptr;
  }
  turned->info_.isOriented = true;
  return turned;
}

std::unique_ptr<const DistanceTree> CloudField::makeDistanceTree(Executor& executor) const
{
  return std::make_unique<const DistanceTree>(cloud_, executor);
}

double CloudField::reference(const Eigen::Vector3d& sample) const
{
  return referenceSum<double>(cloud_, cloud_.areas, sample) + info_.added;
}

double CloudField::jumpWithin(const Eigen::Vector3d& sample, double distance) const
{
  const bool isSmooth = !cloud_.regularizationLengths.empty();
  return isSmooth || pointsNear(cloud_, sample, distance) == 0
           ? 0
           : std::numeric_limits<double>::infinity();
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
