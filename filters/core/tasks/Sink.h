// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace winding
{

/// The arrays that tasks make (Outputs.def).
enum class Output
{
#define WINDING_OUTPUT(id, components, name) id,
#include "tasks/Outputs.def"
#undef WINDING_OUTPUT
};

/// The types of their numbers.
enum class NumberType
{
  uint8,
  int32,
  int64,
  float32,
  float64
};

/// Returns the number of components of each tuple of an array.
constexpr int componentsOf(Output output)
{
  constexpr int components[] = {
#define WINDING_OUTPUT(id, components, name) components,
#include "tasks/Outputs.def"
#undef WINDING_OUTPUT
  };
  return components[static_cast<int>(output)];
}

/// Returns the name of an array in data sets.
constexpr const char* nameOf(Output output)
{
  constexpr const char* names[] = {
#define WINDING_OUTPUT(id, components, name) name,
#include "tasks/Outputs.def"
#undef WINDING_OUTPUT
  };
  return names[static_cast<int>(output)];
}

/// The place where results of a task go: memory of the front end.
class Sink
{
public:
  virtual ~Sink() = default;

  /// Returns memory for `tuples` tuples of an array, which the task fills.
  template <class Number> Number* array(Output output, std::size_t tuples)
  {
    return static_cast<Number*>(this->memoryOf(output, typeOf<Number>(), tuples));
  }

protected:
  /// Returns memory for tuples of componentsOf() numbers each. It stays where it is until the task
  /// has ended.
  virtual void* memoryOf(Output output, NumberType type, std::size_t tuples) = 0;

private:
  template <class Number> static constexpr NumberType typeOf()
  {
    if constexpr (std::is_floating_point_v<Number>)
    {
      return sizeof(Number) == sizeof(float) ? NumberType::float32 : NumberType::float64;
    }
    else
    {
      return sizeof(Number) == 1   ? NumberType::uint8
             : sizeof(Number) == 4 ? NumberType::int32
                                   : NumberType::int64;
    }
  }
};

} // namespace winding
