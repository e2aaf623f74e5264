// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "field/SurfaceField.h"

#include "base/Refusal.h"
#include "distance/DistanceTree.h"
#include "distance/PrimitivesNear.h"
#include "farfield/FarFieldChoice.h"
#include "farfield/GridCells.h"
#include "field/LooseParts.h"
#include "field/SheetMessages.h"
#include "rays/RayParity.h"
#include "source/CoordinateOrder.h"
#include "source/DistinctTriangles.h"
#include "source/Sanitize.h"
#include "source/SourceArea.h"
#include "source/UnitScale.h"
#include "sums/DirectSum.h"
#include "sums/ReferenceSum.h"
#include "surface/Components.h"
#include "surface/FlatBase.h"
#include "surface/Mirror.h"
#include "surface/OpenParts.h"
#include "surface/Orientation.h"
#include "surface/RepeatedFaces.h"
#include "surface/SheetSide.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace winding
{

SurfaceField::SurfaceField(
  const std::vector<TrianglesView>& views, const FieldOptions& options, Executor& executor)
  : options_(options)
  , surface_(sanitize(views, executor))
  , parts_(polygonPartsOf(views))
{
  this->complete(options, executor);
  if (options.ignoreOpenParts)
  {
    leaveOut(surface_, openPartsInside(surface_, edgesOf(surface_, executor), executor).isInside);
    parts_.clear();
  }
  BoundaryChain chain = boundaryChain(surface_, executor);
  this->mergeEqual(chain);
  this->describe(chain, options);
  this->chooseMethod(options, chain, executor);
  diagnosis_ = std::make_unique<Diagnosis>(this->takeFacts(chain, options));
  boundaryGradient_ = std::make_unique<BoundaryGradient>(surface_, std::move(chain.edges));
}

SurfaceField::~SurfaceField() = default;

/// Adds what the surface lacks by its owner's word, and turns its faces.
void SurfaceField::complete(const FieldOptions& options, Executor& executor)
{
  const Mirror mirror(options.mirror, options.weldTolerance);
  const FlatBase base(options.flatBase);
  const Eigen::Vector3d side = sheetSideIn(options.sheetSide);
  if (mirror.cuts(surface_.vertices, surface_.bounds))
  {
    info_.warnings.push_back(cutByMirror());
  }
  mirror.addTo(surface_, parts_);
  const auto orientNow = [&]
  {
    const Orientation found = orient(surface_, parts_, executor);
    apply(found, surface_);
    hasTurned_ |= found.triangles > 0 || !found.isLeftOut.empty();
    if (!found.isLeftOut.empty())
    {
      parts_.clear();
    }
  };
  if (options.orientFaces)
  {
    orientNow();
  }
  if (!base.isNone())
  {
    const BasedOpenings openings = base.addTo(surface_, executor);
    parts_.resize(parts_.empty() ? 0 : surface_.triangles.size(), 0);
    if (options.orientFaces)
    {
      orientNow(); // the base decides where the outside is
    }
    for (const Message& note : notesOn(openings))
    {
      if (openings.closed == 0)
      {
        info_.addUnused(Parameter::flatBase, note, options);
      }
      else
      {
        info_.warnings.push_back(note);
      }
    }
  }
  if (!side.isZero())
  {
    const Sheets sheets = turnSheets(surface_, parts_, side, executor);
    constexpr double ofHalfSphere = 0.5;
    info_.added = sheets.count > 0 ? ofHalfSphere : 0;
    info_.sheetHeight = sheets.height;
    if (sheets.count > 0 && options.method == Method::parity)
    {
      throw Refusal(Message("rays find no sides of sheets",
        {{"", {{Parameter::method, static_cast<int>(Method::automatic)}}}}));
    }
    if (sheets.areStacked)
    {
      info_.warnings.emplace_back("sheets lie over each other, and add up",
        std::vector<Remedy>{{"give each alone, or all as solids of labels", {}}});
    }
    if (sheets.unclear > 0)
    {
      info_.warnings.push_back(alongSheet());
    }
    if (sheets.count == 0)
    {
      info_.addUnused(Parameter::sheetSide, noOpenPart(), options);
    }
  }
}

/// Fills in the information on the source, with a warning of triangles that were left out.
void SurfaceField::describe(const BoundaryChain& chain, const FieldOptions& options)
{
  info_.inputPrimitives = surface_.inputTriangles;
  info_.primitives = surface_.triangles.size();
  info_.dropped = surface_.dropped();
  info_.weldedVertices = surface_.vertices.size();
  info_.bounds = surface_.bounds;
  info_.isScattered = options.scattered;
  info_.isOriented = options.orientFaces;
  info_.tolerance = options.tolerance;
  if (surface_.dropped() > 0)
  {
    info_.warnings.emplace_back(
      std::to_string(surface_.dropped()) + " of " + std::to_string(surface_.inputTriangles) +
      " triangles were unusable and left out (" + std::to_string(surface_.nonFiniteTriangles) +
      " with NaN or infinite coordinates, " + std::to_string(surface_.invalidIdTriangles) +
      " with ids of points that do not exist)");
  }
  info_.boundaryEdges = chain.edgesOfOneTriangle;
  info_.contradictingEdges = chain.contradictions.size();
  info_.netBoundaryEdges = chain.edges.size();
  info_.distinct = distinct_->triangles.size();
  if (!chain.edges.empty() && info_.added == 0)
  {
    info_.openings = openingsOf(chain.edges, surface_, this->area());
  }
}

/// Returns the facts for a diagnosis, and moves the contradictions of `chain` into them.
SurfaceFacts SurfaceField::takeFacts(BoundaryChain& chain, const FieldOptions& options) const
{
  SurfaceFacts facts;
  facts.surface = &surface_;
  facts.distinct = distinct_;
  facts.netBoundaryEdges = info_.netBoundaryEdges;
  facts.hasRims = info_.boundaryEdges > 0;
  facts.hasNoSides = !merged_.multiplicities.empty() && merged_.multiplicities.back() == 0;
  facts.hasManyCrowds = 10 * chain.crowdedVertices.size() > surface_.vertices.size();
  facts.contradictions = std::move(chain.contradictions);
  facts.openings = info_.openings;
  facts.isOriented = options.orientFaces;
  facts.isSheet = info_.added != 0;
  return facts;
}

/// Makes the surface that is summed another one, where triangles are equal to each other.
void SurfaceField::mergeEqual(const BoundaryChain& chain)
{
  // The two sides of a single face, which no other touches, are looked for in small surfaces, and
  // where faces share few vertices though all edges cancel.
  constexpr std::size_t few = 1000;
  const bool mayBePairs =
    surface_.triangles.size() <= few ||
    (chain.edges.empty() && surface_.vertices.size() >= surface_.triangles.size());
  std::vector<char> mayRepeat(surface_.vertices.size(), static_cast<char>(mayBePairs));
  for (const std::int32_t vertex : chain.crowdedVertices)
  {
    mayRepeat[vertex] = 1;
  }
  std::optional<DistinctTriangles> distinct;
  if (mayBePairs || !chain.crowdedVertices.empty())
  {
    distinct = distinctTriangles(surface_.triangles, mayRepeat);
  }
  if (distinct)
  {
    merged_.vertices = surface_.vertices;
    merged_.triangles = std::move(distinct->triangles);
    merged_.multiplicities = std::move(distinct->multiplicities);
    // Any of the triangles that cancel entirely may stand for them, and so may either sense: the
    // coordinates choose one.
    for (std::size_t i = 0; i < merged_.triangles.size() && merged_.multiplicities[i] == 0; ++i)
    {
      Triangle& triangle = merged_.triangles[i];
      triangle = lowestFirst(merged_.vertices, triangle);
      if (compareCoordinates(merged_.vertices[triangle[2]], merged_.vertices[triangle[1]]) < 0)
      {
        std::swap(triangle[1], triangle[2]);
      }
    }
    merged_.bounds = surface_.bounds;
    distinct_ = &merged_;
  }
}

void SurfaceField::chooseMethod(
  const FieldOptions& options, const BoundaryChain& chain, Executor& executor)
{
  const Method asked = options.method;
  isFarFieldAskedFor_ = asked == Method::hierarchical;
  isRowsAskedFor_ = asked == Method::rows;
  if (options.tolerance >= FarFieldAccuracy::finest)
  {
    order_ = FarFieldAccuracy::of(options.tolerance).order;
  }
  if (asked == Method::parity)
  {
    info_.method = Method::parity;
    info_.why = chain.edges.empty() ? "asked for" : "asked for, though the surface is not closed";
    evaluator_ = std::make_unique<RayParity>(surface_);
    return;
  }
  evaluator_ = std::make_unique<TriangleSum>(*distinct_);
  if (asked == Method::direct)
  {
    info_.why = "asked for";
    return;
  }
  if (asked == Method::hierarchical)
  {
    this->chooseFarField(options, "asked for");
    return;
  }
  const std::string triangles = std::to_string(info_.primitives) + " triangles";
  if (chain.edges.empty())
  {
    crossings_ = std::make_unique<PointCrossings>(*distinct_);
  }
  if (options.scattered && !crossings_ && asked != Method::rows &&
      (order_ == 0 || isCheaperDirectly(Primitive::triangle, info_.distinct, order_)))
  {
    this->chooseFarField(options, "scattered samples of " + triangles);
    return;
  }
  if (options.scattered && crossings_)
  {
    info_.method = Method::rows;
    info_.why = "closed after welding: integers, by counting what lies ahead of each sample";
    return;
  }

  const std::string prefix = asked == Method::rows ? "rows asked for, but " : "";
  const std::size_t edges = chain.edges.size();
  if (edges > 0 && 2 * edges >= info_.distinct)
  {
    // Each triangle of a cap has three sides, and each boundary edge is one of them. So this cap
    // has a sixth, too. It need not be made, which takes soups longer than the sum of 50 samples.
    this->chooseFarField(options, prefix + "a cap over " + std::to_string(edges) +
                                    " boundary edges would have a sixth of the surface's " +
                                    "triangles or more");
    return;
  }

  capped_ = std::make_unique<CappedSurface>(*distinct_, chain, options.tolerance, executor);
  info_.capTriangles = capped_->capTriangles();
  const std::string cap = std::to_string(info_.capTriangles) + " triangles over " +
                          std::to_string(edges) + " boundary edges";
  if (info_.capTriangles > 0 && 6 * info_.capTriangles >= info_.distinct)
  {
    // Method rows would sum the cap at every sample, method hierarchical the surface. A cap's sum
    // has to look out for samples on the cap, and so takes up to three times as long for a
    // triangle. Caps of up to a third let 3 of 10 000 random soups take longer than Field.h
    // promises, caps of up to a sixth 1. Scans with a tenth of their faces missing have caps of a
    // tenth, and both methods take equally long for them.
    capped_ = nullptr;
    const std::string why = "a cap would have " + cap + ", a sixth of the surface's or more";
    this->chooseFarField(options, prefix + why);
    return;
  }
  info_.method = Method::rows;
  info_.why = chain.edges.empty() ? "closed after welding: integers, found for whole rows"
                                  : std::string("open: ") + (options.scattered ? "rays" : "rows") +
                                      " find the integer part, a cap of " + cap + " gives the rest";
  if (!crossings_)
  {
    // Few scattered samples may be cheaper without the cap; no tree is built before they come.
    this->makeFarField(options.tolerance);
  }
}

/// Chooses the far field where the tolerance admits it and it was asked for or is faster than the
/// direct sum; otherwise the direct sum.
void SurfaceField::chooseFarField(const FieldOptions& options, const std::string& why)
{
  info_.why = why;
  if (options.tolerance < FarFieldAccuracy::finest)
  {
    info_.why += "; a tolerance below 1e-6 leaves the direct sum only";
    return;
  }
  if (!isFarFieldAskedFor_ && isCheaperDirectly(Primitive::triangle, info_.distinct, order_))
  {
    info_.why += "; so few are summed directly";
    return;
  }
  info_.method = Method::hierarchical;
  this->makeFarField(options.tolerance);
}

/// Makes a far field of all triangles, if the tolerance admits one.
void SurfaceField::makeFarField(double tolerance)
{
  if (tolerance >= FarFieldAccuracy::finest)
  {
    farField_ = std::make_unique<TriangleFarField>(
      distinct_->vertices, *distinct_, distinct_->bounds, FarFieldAccuracy::of(tolerance));
  }
}

/// Returns whether `samples` samples are worth a tree; they always are where the user asked for it.
bool SurfaceField::usesFarField(std::size_t samples) const
{
  return farField_ &&
         (isFarFieldAskedFor_ || !isCheaperDirectly(Primitive::triangle, info_.distinct, samples,
                                   order_, FarFieldState::toBuild, this->gainOfFarField()));
}

/// Returns whether `samples` scattered samples of an open surface get their values by rays and the
/// cap. A tolerance that admits no far field leaves the direct sum, unless rows are asked for: so
/// values depend on the number of samples within the tolerance only.
bool SurfaceField::usesCapAtPoints(std::size_t samples) const
{
  if (!capped_ || isRowsAskedFor_)
  {
    return capped_ != nullptr;
  }
  if (!farField_ || samples <= 1)
  {
    return false;
  }
  SampledSource cap = this->sampledSource(samples);
  cap.primitives = info_.capTriangles;
  cap.area = this->area() > 0 ? cap.area / this->area() * capped_->capArea() : 0;
  const double ofCap = capped_->usesFarFieldAtPoints(samples)
                         ? weightOfFarField(cap, order_)
                         : weightOfDirectSum(cap.primitives, samples);
  return capped_->points().weight(samples) + ofCap < weightOfDirectSum(info_.distinct, samples);
}

bool SurfaceField::usesFarField(const Grid& grid) const
{
  return this->usesFarField(sampleCount(grid.wholeExtent())) &&
         isInReachOfSingles(grid, info_.bounds, unitScale(info_.bounds));
}

const RowCrossings* SurfaceField::integerRows() const
{
  return capped_ && capped_->capTriangles() == 0 ? &capped_->rows() : nullptr;
}

std::size_t SurfaceField::expectedBytes(std::size_t samples) const
{
  const auto bytesOf = [this](std::size_t triangles, bool usesFarField)
  {
    return usesFarField ? bytesOfFarField(Primitive::triangle, triangles, order_)
                        : bytesPerPrimitive * triangles;
  };
  if (info_.method == Method::rows && !capped_)
  {
    return crossings_->bytes(samples);
  }
  if (info_.isScattered && this->usesCapAtPoints(samples))
  {
    return capped_->points().bytes(samples) +
           bytesOf(info_.capTriangles, capped_->usesFarFieldAtPoints(samples)) +
           sizeof(float) * samples;
  }
  if (info_.method == Method::rows && !info_.isScattered)
  {
    constexpr std::size_t bytesOfRows = bytesPerPrimitive + 20;
    return bytesOfRows * (info_.distinct + info_.capTriangles) +
           bytesOf(info_.capTriangles, info_.capTriangles > 0 && capped_->usesFarField(samples));
  }
  return bytesOf(info_.distinct, this->usesFarField(samples));
}

FarFieldGain SurfaceField::gainOfFarField() const
{
  return gain_.get([this]
    { return winding::gainOfFarField(distinct_->vertices, distinct_->triangles, info_.bounds); });
}

double SurfaceField::area() const
{
  return area_.get([this] { return approximateAreaOf(distinct_->vertices, distinct_->triangles); });
}

void SurfaceField::prepare(const Grid& grid, Executor& executor) const
{
  if (capped_)
  {
    capped_->prepare(grid, executor);
  }
  else if (this->usesFarField(grid))
  {
    farField_->suiting(grid, executor);
  }
}

void SurfaceField::prepare(const VectorsView& samples, Executor& executor) const
{
  if (this->usesCapAtPoints(samples.size()))
  {
    capped_->prepare(samples, executor);
  }
  else if (!crossings_ && this->usesFarField(samples.size()))
  {
    farField_->suiting(samples, executor);
  }
}

void SurfaceField::evaluateValues(
  const Grid& grid, const Extent& extent, const FieldOutput& output, Executor& executor) const
{
  if (capped_)
  {
    capped_->evaluate(grid, extent, output, executor);
  }
  else if (this->usesFarField(grid))
  {
    farField_->suiting(grid, executor)->evaluate(grid, extent, output, executor);
  }
  else
  {
    Field::evaluateValues(grid, extent, output, executor);
  }
}

void SurfaceField::evaluateValues(
  const VectorsView& samples, const FieldOutput& output, Executor& executor) const
{
  if (crossings_)
  {
    crossings_->evaluate(samples, output, executor);
  }
  else if (this->usesCapAtPoints(samples.size()))
  {
    capped_->evaluate(samples, output, executor);
  }
  else if (this->usesFarField(samples.size()))
  {
    farField_->suiting(samples, executor)->evaluate(samples, output, executor);
  }
  else
  {
    Field::evaluateValues(samples, output, executor);
  }
}

std::shared_ptr<const Field> SurfaceField::makeTurned(Executor& executor) const
{
  if (info_.turnedLooseParts)
  {
    return nullptr;
  }
  FieldOptions options = options_;
  options.orientFaces = !info_.isOriented;
  // These have done their work.
  options.mirror.clear();
  options.flatBase.clear();
  options.sheetSide.clear();
  const auto fieldOf = [&](const Surface& surface)
  {
    TrianglesView view;
    if (!surface.triangles.empty())
    {
      view.points = VectorsView(surface.vertices.front().data(), surface.vertices.size());
      view.triangles = TriangleIdsView(surface.triangles.front().data(), surface.triangles.size());
      view.isContinued = parts_.empty() ? nullptr : parts_.data();
    }
    auto result =
      std::make_shared<SurfaceField>(std::vector<TrianglesView>{view}, options, executor);
    result->info_.isOriented = true;
    return result;
  };
  if (!info_.isOriented)
  {
    const auto oriented = fieldOf(surface_);
    if (oriented->hasTurned_)
    {
      return oriented;
    }
  }
  Surface turned = surface_;
  if (!turnLooseParts(turned, parts_, executor))
  {
    return nullptr;
  }
  options.orientFaces = false;
  const auto result = fieldOf(turned);
  result->info_.turnedLooseParts = true;
  return result;
}

std::unique_ptr<const DistanceTree> SurfaceField::makeDistanceTree(Executor& executor) const
{
  return std::make_unique<const DistanceTree>(*distinct_, executor);
}

double SurfaceField::reference(const Eigen::Vector3d& sample) const
{
  return referenceSum<double>(surface_, sample) + info_.added;
}

double SurfaceField::jumpWithin(const Eigen::Vector3d& sample, double distance) const
{
  return static_cast<double>(trianglesNear(surface_, sample, distance));
}

Field::PointOnSource SurfaceField::pointOnSource() const
{
  return pointOnTriangles(surface_.vertices, surface_.triangles);
}

} // namespace winding
