// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/BinaryNumbers.h"
#include "files/PlyHeader.h"

namespace winding
{

/// Whether the bytes of the numbers stand in the other order than on this machine.
inline bool isSwapped(PlyEncoding encoding)
{
  return (encoding == PlyEncoding::bigEndian) != isBigEndianMachine;
}

/// Returns work.run<Number, isSwapped>() for the C++ type of a number of PLY.
template <bool isSwapped, class Work> decltype(auto) withOrderedType(PlyNumber type, Work& work)
{
  switch (type)
  {
  case PlyNumber::int8:
    return work.template run<std::int8_t, isSwapped>();
  case PlyNumber::uint8:
    return work.template run<std::uint8_t, isSwapped>();
  case PlyNumber::int16:
    return work.template run<std::int16_t, isSwapped>();
  case PlyNumber::uint16:
    return work.template run<std::uint16_t, isSwapped>();
  case PlyNumber::int32:
    return work.template run<std::int32_t, isSwapped>();
  case PlyNumber::uint32:
    return work.template run<std::uint32_t, isSwapped>();
  case PlyNumber::float32:
    return work.template run<float, isSwapped>();
  case PlyNumber::float64:
    break;
  }
  return work.template run<double, isSwapped>();
}

template <class Work> decltype(auto) withType(PlyNumber type, PlyEncoding encoding, Work& work)
{
  return isSwapped(encoding) ? withOrderedType<true>(type, work)
                             : withOrderedType<false>(type, work);
}

/// The number whose bytes begin at `at`.
double plyNumberAt(PlyNumber type, PlyEncoding encoding, const char* at);

/// Numbers of one kind in consecutive items of a binary file, and their way into an array.
struct PlyColumn
{
  const char* from;   ///< the number of the first item
  std::size_t stride; ///< bytes from one item to the next
  std::size_t count;  ///< number of items
  PlyNumber type;
  PlyEncoding encoding;
};

/// Copies a column into every `stride`-th number of `into`.
void copyColumn(const PlyColumn& column, double* into, std::size_t stride);
void copyColumn(const PlyColumn& column, float* into, std::size_t stride);
void copyColumn(const PlyColumn& column, std::uint8_t* into, std::size_t stride);

/// Copies a column of ids, without what is behind their point. False if any is not from 0 up to,
/// without, `end`.
bool copyIds(const PlyColumn& column, std::int64_t* into, std::size_t stride, std::int64_t end);

/// Whether all numbers of a column are `value`.
bool areAll(const PlyColumn& column, double value);

} // namespace winding
