// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/FieldOutput.h"
#include "distance/NearestNumbers.h"
#include "distance/PlaceBuckets.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace winding
{

/// Places as CellDescent.h and OrderedSearch.h want them: a part is a range of them, which gets
/// sorted into halves.
class PlaceSamples
{
public:
  struct Part
  {
    Place* first;
    Place* last;
  };
  using Name = std::size_t;

  PlaceSamples(double scale, const FieldOutput& output, const NumberOutput& numbers = {})
    : scale_(scale)
    , output_(output)
    , numbers_(numbers)
  {
  }

  static std::size_t count(const Part& part)
  {
    return static_cast<std::size_t>(part.last - part.first);
  }

  static Bounds boxOf(const Part& part)
  {
    Bounds box;
    for (const Place* place = part.first; place != part.last; ++place)
    {
      box.extend(place->position);
    }
    return box;
  }

  static bool isAskedFor(const Part& part) { return part.first != part.last; }

  /// Halves a part across the longest side of its box.
  static std::pair<Part, Part> halves(const Part& part)
  {
    int axis;
    boxOf(part).sizes().maxCoeff(&axis);
    Place* const middle = part.first + (part.last - part.first) / 2;
    std::nth_element(part.first, middle, part.last,
      [axis](const Place& a, const Place& b) { return a.position[axis] < b.position[axis]; });
    return {{part.first, middle}, {middle, part.last}};
  }

  template <class Function> static void forEach(const Part& part, const Function& f)
  {
    for (const Place* place = part.first; place != part.last; ++place)
    {
      f(place->position, place->sample);
    }
  }

  void write(double squared, std::uint32_t number, std::size_t sample) const
  {
    if (numbers_.to)
    {
      numbers_.to[sample] = number;
      return;
    }
    output_.writeDistance(std::sqrt(squared) / scale_, sample);
  }

  /// Returns the finder of numbers, which are wanted instead of distances; null for distances.
  const NearestNumbers* numbers() const { return numbers_.numbers; }

private:
  double scale_;
  const FieldOutput& output_;
  NumberOutput numbers_;
};

} // namespace winding
