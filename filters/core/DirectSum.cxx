#include "DirectSum.h"

#include "DirectSumKernels.h"
#include "UnitScale.h"

#include <algorithm>
#include <cmath>

namespace winding
{

namespace
{

constexpr double pi = 3.14159265358979323846;

void store(const Eigen::Vector3d& from, double (&to)[3])
{
  std::copy_n(from.data(), 3, to);
}

} // namespace

TriangleSum::TriangleSum(const Surface& surface)
  : surface_(surface)
  , scale_(unitScale(surface.bounds))
{
}

void TriangleSum::evaluate(const SampleBlock& block, double* values) const
{
  SampleBlock scaled;
  scaleSamples(block, scale_, scaled);
  AngleProducts products;
  std::fill_n(products.re, scaled.count, 1.0);

  // Packing is repeated for every block: next to a block's worth of sums it costs nothing, and the
  // packed triangles stay in the first-level cache instead of taking 96 bytes each of memory.
  KernelTriangle chunk[kernelChunk];
  const std::size_t total = surface_.triangles.size();
  for (std::size_t first = 0; first < total; first += kernelChunk)
  {
    const std::size_t count = std::min(kernelChunk, total - first);
    for (std::size_t i = 0; i < count; ++i)
    {
      const Triangle& triangle = surface_.triangles[first + i];
      const Eigen::Vector3d a = surface_.vertices[triangle[0]] * scale_;
      const Eigen::Vector3d b = surface_.vertices[triangle[1]] * scale_;
      const Eigen::Vector3d c = surface_.vertices[triangle[2]] * scale_;
      store(a, chunk[i].a);
      store(b, chunk[i].b);
      store(c, chunk[i].c);
      store((b - a).cross(c - a), chunk[i].normal);
    }
    multiplyAngles(chunk, count, scaled, products);
  }
  for (std::size_t i = 0; i < scaled.count; ++i)
  {
    values[i] = products.turns[i] + std::atan2(products.im[i], products.re[i]) / (2 * pi);
  }
}

DipoleSum::DipoleSum(const PointCloud& cloud, const std::vector<double>& areas)
  : cloud_(cloud)
  , areas_(areas)
  , scale_(unitScale(cloud.bounds))
{
}

void DipoleSum::evaluate(const SampleBlock& block, double* values) const
{
  SampleBlock scaled;
  scaleSamples(block, scale_, scaled);
  KernelSums sums;

  KernelDipole chunk[kernelChunk];
  const std::size_t total = cloud_.positions.size();
  for (std::size_t first = 0; first < total; first += kernelChunk)
  {
    const std::size_t count = std::min(kernelChunk, total - first);
    for (std::size_t i = 0; i < count; ++i)
    {
      // Two factors of scale, one after the other: their product alone may leave the range.
      const double weight = areas_[first + i] * scale_ * scale_ / (4 * pi);
      store(cloud_.positions[first + i] * scale_, chunk[i].position);
      store(cloud_.normals[first + i] * weight, chunk[i].moment);
    }
    addDipoles(chunk, count, scaled, sums);
  }
  std::copy_n(sums.sum, scaled.count, values);
}

} // namespace winding
