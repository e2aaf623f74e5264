// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/PlyNumbers.h"

#include <type_traits>

namespace winding
{

namespace
{

struct OneNumber
{
  template <class Number, bool isSwapped> double run() const
  {
    return static_cast<double>(numberAt<Number, isSwapped>(at));
  }

  const char* at;
};

template <class To> struct CopyOfNumbers
{
  template <class Number, bool isSwapped> void run() const
  {
    const char* from = column.from;
    To* to = into;
    for (std::size_t i = 0; i < column.count; ++i, from += column.stride, to += stride)
    {
      *to = static_cast<To>(numberAt<Number, isSwapped>(from));
    }
  }

  const PlyColumn& column;
  To* into;
  std::size_t stride;
};

/// Ids that are not from 0 up to `end` become −1, which is beyond as well.
template <class Number> std::int64_t idOf(Number number, std::int64_t end)
{
  if constexpr (std::is_floating_point<Number>::value)
  {
    const bool exists = number >= 0 && static_cast<double>(number) < static_cast<double>(end);
    return exists ? static_cast<std::int64_t>(number) : -1;
  }
  else
  {
    static_cast<void>(end); // whole numbers are compared by the caller
    return static_cast<std::int64_t>(number);
  }
}

struct CopyOfIds
{
  template <class Number, bool isSwapped> bool run() const
  {
    bool allExist = true;
    const char* from = column.from;
    std::int64_t* to = into;
    for (std::size_t i = 0; i < column.count; ++i, from += column.stride, to += stride)
    {
      const std::int64_t id = idOf(numberAt<Number, isSwapped>(from), end);
      *to = id;
      allExist &= static_cast<std::uint64_t>(id) < static_cast<std::uint64_t>(end);
    }
    return allExist;
  }

  const PlyColumn& column;
  std::int64_t* into;
  std::size_t stride;
  std::int64_t end;
};

struct Comparison
{
  template <class Number, bool isSwapped> bool run() const
  {
    const auto number = static_cast<Number>(value);
    bool isSame = true;
    const char* from = column.from;
    for (std::size_t i = 0; i < column.count; ++i, from += column.stride)
    {
      isSame &= numberAt<Number, isSwapped>(from) == number;
    }
    return isSame;
  }

  const PlyColumn& column;
  double value;
};

} // namespace

double plyNumberAt(PlyNumber type, PlyEncoding encoding, const char* at)
{
  const OneNumber number{at};
  return withType(type, encoding, number);
}

void copyColumn(const PlyColumn& column, double* into, std::size_t stride)
{
  const CopyOfNumbers<double> copy{column, into, stride};
  withType(column.type, column.encoding, copy);
}

void copyColumn(const PlyColumn& column, float* into, std::size_t stride)
{
  const CopyOfNumbers<float> copy{column, into, stride};
  withType(column.type, column.encoding, copy);
}

void copyColumn(const PlyColumn& column, std::uint8_t* into, std::size_t stride)
{
  const CopyOfNumbers<std::uint8_t> copy{column, into, stride};
  withType(column.type, column.encoding, copy);
}

bool copyIds(const PlyColumn& column, std::int64_t* into, std::size_t stride, std::int64_t end)
{
  const CopyOfIds copy{column, into, stride, end};
  return withType(column.type, column.encoding, copy);
}

bool areAll(const PlyColumn& column, double value)
{
  const Comparison comparison{column, value};
  return withType(column.type, column.encoding, comparison);
}

} // namespace winding
