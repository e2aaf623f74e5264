#include "Field.h"

#include "DirectSum.h"
#include "PointAreas.h"
#include "RayParity.h"
#include "ReferenceSum.h"
#include "Refusal.h"
#include "SurfaceReport.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace winding
{

namespace
{

/**
 * Samples per block of work: many, so that what is done per block costs nothing, but few enough
 * that a block over all primitives ends in a fraction of a second and an interrupt is answered
 * soon.
 */
std::size_t samplesPerBlock(std::size_t primitives)
{
  constexpr std::size_t pairsPerBlock = 50'000'000;
  const std::size_t samples = pairsPerBlock / std::max<std::size_t>(primitives, 1);
  // Multiples of 16 fill the widest vectors.
  return std::clamp<std::size_t>(samples / 16 * 16, 16, SampleBlock::capacity);
}

void writeValues(
  const double* values, std::size_t first, std::size_t count, const FieldOutput& output)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const float rounded = static_cast<float>(values[i]);
    if (output.values)
    {
      output.values[first + i] = rounded;
    }
    if (output.doubleValues)
    {
      output.doubleValues[first + i] = values[i];
    }
    if (output.inside)
    {
      const double stored = output.doubleValues ? values[i] : rounded;
      output.inside[first + i] = isInside(stored, output.rule, output.threshold);
    }
  }
}

/// Nowhere is not a place: samples that are NaN or infinite get NaN from every method.
void markNonFinite(const SampleBlock& block, double* values)
{
  for (std::size_t i = 0; i < block.count; ++i)
  {
    if (!std::isfinite(block.x[i]) || !std::isfinite(block.y[i]) || !std::isfinite(block.z[i]))
    {
      values[i] = std::numeric_limits<double>::quiet_NaN();
    }
  }
}

std::string droppedWarning(std::size_t dropped, std::size_t input, const std::string& details)
{
  return dropped == 0 ? std::string()
                      : std::to_string(dropped) + " of " + std::to_string(input) +
                          " primitives were unusable and left out (" + details + ")";
}

class SurfaceField final : public Field
{
public:
  SurfaceField(const std::vector<TrianglesView>& views, const FieldOptions& options)
    : surface_(sanitize(views))
  {
    const EdgeCounts edges = countEdges(surface_);
    info_.inputPrimitives = surface_.inputTriangles;
    info_.primitives = surface_.triangles.size();
    info_.dropped = surface_.dropped();
    info_.weldedVertices = surface_.vertices.size();
    info_.boundaryEdges = edges.boundary;
    info_.netBoundaryEdges = edges.netBoundary;
    info_.bounds = surface_.bounds;
    info_.warning = droppedWarning(surface_.dropped(), surface_.inputTriangles,
      std::to_string(surface_.nonFiniteTriangles) + " with NaN or infinite coordinates, " +
        std::to_string(surface_.invalidIdTriangles) + " with ids of points that do not exist");
    if (options.method == Method::parity)
    {
      info_.method = Method::parity;
      info_.why = edges.isClosed() ? "asked for" : "asked for, though the surface is not closed";
      evaluator_ = std::make_unique<RayParity>(surface_);
    }
    else
    {
      info_.why =
        options.method == Method::direct ? "asked for" : "exact for every surface, open or closed";
      evaluator_ = std::make_unique<TriangleSum>(surface_);
    }
    cumulativeAreas_.reserve(surface_.triangles.size());
    double area = 0;
    for (const Triangle& t : surface_.triangles)
    {
      const Eigen::Vector3d& a = surface_.vertices[t[0]];
      area += (surface_.vertices[t[1]] - a).cross(surface_.vertices[t[2]] - a).stableNorm();
      cumulativeAreas_.push_back(area);
    }
  }

  const FieldInfo& info() const override { return info_; }

  double reference(const Eigen::Vector3d& sample) const override
  {
    return referenceSum<double>(surface_, sample);
  }

  Eigen::Vector3d pointOnSource(double u, double v, double t) const override
  {
    const auto found = std::upper_bound(
      cumulativeAreas_.begin(), cumulativeAreas_.end(), t * cumulativeAreas_.back());
    const std::size_t i = std::min<std::size_t>(
      static_cast<std::size_t>(found - cumulativeAreas_.begin()), surface_.triangles.size() - 1);
    const Triangle& triangle = surface_.triangles[i];
    const double root = std::sqrt(u);
    return (1 - root) * surface_.vertices[triangle[0]] +
           root * (1 - v) * surface_.vertices[triangle[1]] +
           root * v * surface_.vertices[triangle[2]];
  }

protected:
  const Evaluator& evaluator() const override { return *evaluator_; }

private:
  Surface surface_;
  FieldInfo info_;
  std::unique_ptr<Evaluator> evaluator_;
  std::vector<double> cumulativeAreas_;
};

class CloudField final : public Field
{
public:
  CloudField(const std::vector<OrientedPointsView>& views, const FieldOptions& options)
    : cloud_(sanitize(views))
  {
    if (options.method == Method::parity)
    {
      throw Refusal("parity needs triangles and this is a point cloud; choose another method");
    }
    if (!(options.pointArea >= 0) || !std::isfinite(options.pointArea))
    {
      throw Refusal("the point area is " + std::to_string(options.pointArea) +
                    "; it must be more than 0, or 0 to be estimated");
    }
    info_.isSurface = false;
    info_.inputPrimitives = cloud_.inputPoints;
    info_.primitives = cloud_.positions.size();
    info_.dropped = cloud_.dropped();
    info_.weldedVertices = cloud_.positions.size();
    info_.bounds = cloud_.bounds;
    info_.why =
      options.method == Method::direct ? "asked for" : "exact for every cloud with given areas";
    info_.warning = droppedWarning(cloud_.dropped(), cloud_.inputPoints,
      std::to_string(cloud_.nonFinitePoints) + " with NaN or infinite values, " +
        std::to_string(cloud_.zeroNormalPoints) + " with normals of length 0, " +
        std::to_string(cloud_.badAreaPoints) + " with negative areas");
    if (cloud_.areas.empty())
    {
      info_.pointArea = options.pointArea > 0 ? options.pointArea : meanPointArea(cloud_);
      cloud_.areas.assign(cloud_.positions.size(), info_.pointArea);
      if (info_.pointArea == 0 && !cloud_.positions.empty())
      {
        info_.warning +=
          std::string(info_.warning.empty() ? "" : "; ") +
          "the area of the points cannot be estimated, so the field is 0; set a point area";
      }
    }
    evaluator_ = std::make_unique<DipoleSum>(cloud_, cloud_.areas);
  }

  const FieldInfo& info() const override { return info_; }

  double reference(const Eigen::Vector3d& sample) const override
  {
    return referenceSum<double>(cloud_, cloud_.areas, sample);
  }

  Eigen::Vector3d pointOnSource(double, double, double t) const override
  {
    const std::size_t i = static_cast<std::size_t>(t * cloud_.positions.size());
    return cloud_.positions[std::min(i, cloud_.positions.size() - 1)];
  }

protected:
  const Evaluator& evaluator() const override { return *evaluator_; }

private:
  PointCloud cloud_;
  FieldInfo info_;
  std::unique_ptr<Evaluator> evaluator_;
};

} // namespace

const char* nameOf(Method method)
{
  switch (method)
  {
  case Method::automatic:
    return "automatic";
  case Method::direct:
    return "direct";
  case Method::parity:
    return "parity";
  }
  return "";
}

std::shared_ptr<const Field> Field::build(
  const std::vector<TrianglesView>& views, const FieldOptions& options)
{
  return std::make_shared<SurfaceField>(views, options);
}

std::shared_ptr<const Field> Field::build(
  const std::vector<OrientedPointsView>& views, const FieldOptions& options)
{
  return std::make_shared<CloudField>(views, options);
}

template <class PositionOf>
bool Field::evaluateBlocks(std::size_t samples, const PositionOf& positionOf,
  const FieldOutput& output, Executor& executor) const
{
  const std::size_t blockSize = samplesPerBlock(this->info().primitives);
  const Evaluator& method = this->evaluator();
  return executor.run((samples + blockSize - 1) / blockSize,
    [&](std::size_t number)
    {
      const std::size_t first = number * blockSize;
      SampleBlock block;
      block.count = std::min(blockSize, samples - first);
      for (std::size_t i = 0; i < block.count; ++i)
      {
        const Eigen::Vector3d position = positionOf(first + i);
        block.x[i] = position[0];
        block.y[i] = position[1];
        block.z[i] = position[2];
      }
      double values[SampleBlock::capacity];
      method.evaluate(block, values);
      markNonFinite(block, values);
      writeValues(values, first, block.count, output);
    });
}

bool Field::evaluate(
  const Grid& grid, const Extent& extent, const FieldOutput& output, Executor& executor) const
{
  return this->evaluateBlocks(
    sampleCount(extent),
    [&](std::size_t n)
    {
      const Eigen::Vector3i index = sampleIndex(extent, n);
      return grid.sample(index[0], index[1], index[2]);
    },
    output, executor);
}

bool Field::evaluate(
  const VectorsView& samples, const FieldOutput& output, Executor& executor) const
{
  return this->evaluateBlocks(
    samples.size(), [&](std::size_t n) { return samples[n]; }, output, executor);
}

} // namespace winding
