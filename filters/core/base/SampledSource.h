// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace winding
{

enum class Primitive
{
  triangle,
  point
};

/// A source and the samples that are asked for, as far as a choice or the memory depends on them.
struct SampledSource
{
  Primitive kind = Primitive::triangle;
  std::size_t primitives = 0;
  std::size_t samples = 0;
  double area = 0; ///< the area of the source, in squares of the distance between samples
};

/// Every method keeps coordinates and ids, and welds them.
constexpr std::size_t bytesPerPrimitive = 80;

} // namespace winding
