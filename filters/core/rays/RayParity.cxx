// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/RayParity.h"

#include "rays/RayTriangle.h"
#include "source/UnitScale.h"

#include <algorithm>

namespace winding
{

RayParity::RayParity(const Surface& surface)
  : surface_(surface)
  , scale_(unitScale(surface.bounds))
{
}

void RayParity::evaluate(const SampleBlock& block, double* values) const
{
  SampleBlock scaled;
  scaleSamples(block, scale_, scaled);
  bool odd[SampleBlock::capacity] = {};
  for (const Triangle& triangle : surface_.triangles)
  {
    const RayTriangle target(surface_.vertices[triangle[0]] * scale_,
      surface_.vertices[triangle[1]] * scale_, surface_.vertices[triangle[2]] * scale_);
    for (std::size_t i = 0; i < scaled.count; ++i)
    {
      odd[i] ^= target.crossing({scaled.x[i], scaled.y[i], scaled.z[i]}) != 0;
    }
  }
  std::copy_n(odd, scaled.count, values);
}

} // namespace winding
