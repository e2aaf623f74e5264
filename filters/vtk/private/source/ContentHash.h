// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

namespace winding
{

/// A 64 bit hash of numbers, for distinguishing sources that nobody tries to make collide.
class ContentHash
{
public:
  template <class T> void addValue(const T& value) { this->addBytes(&value, sizeof value); }

  void addText(const std::string& text)
  {
    this->addValue(text.size());
    this->addBytes(text.data(), text.size());
  }

  void addArray(vtkDataArray* array)
  {
    if (!array)
    {
      this->addValue(-1);
      return;
    }
    this->addValue(array->GetDataType());
    this->addValue(array->GetNumberOfValues());
    if (array->HasStandardMemoryLayout())
    {
      this->addBytes(
        array->GetVoidPointer(0), static_cast<std::size_t>(array->GetNumberOfValues()) *
                                    static_cast<std::size_t>(array->GetDataTypeSize()));
      return;
    }
    for (const double value : vtk::DataArrayValueRange(array))
    {
      this->addValue(value);
    }
  }

  void addCells(vtkCellArray* cells)
  {
    // Cells of one size need no offsets, and since VTK 9.6 these may be an array without memory.
    const vtkIdType size = cells->IsHomogeneous();
    this->addValue(size);
    if (size < 0)
    {
      this->addArray(cells->GetOffsetsArray());
    }
    this->addArray(cells->GetConnectivityArray());
  }

  std::uint64_t value() const { return hash_; }

private:
  // A multiplication waits for the one before, so that four chains side by side take a quarter of
  // the time of one. Only long arrays are worth that.
  void addBytes(const void* data, std::size_t size)
  {
    constexpr std::size_t lanes = 4;
    constexpr std::size_t step = lanes * sizeof(std::uint64_t);
    const auto* bytes = static_cast<const unsigned char*>(data);
    std::size_t done = 0;
    if (size >= 8 * step)
    {
      std::uint64_t chains[lanes] = {1, 2, 3, 4};
      for (; size - done >= step; done += step)
      {
        std::uint64_t words[lanes];
        std::memcpy(words, bytes + done, step);
        for (std::size_t lane = 0; lane < lanes; ++lane)
        {
          chains[lane] = mixed(chains[lane], words[lane]);
        }
      }
      for (const std::uint64_t chain : chains)
      {
        hash_ = mixed(hash_, chain);
      }
    }
    for (; done < size; done += sizeof(std::uint64_t))
    {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes + done, std::min(sizeof word, size - done));
      hash_ = mixed(hash_, word);
    }
  }

  static std::uint64_t mixed(std::uint64_t hash, std::uint64_t word)
  {
    hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
    return hash ^ (hash >> 29);
  }

  std::uint64_t hash_ = 0x2545F4914F6CDD1Du;
};

} // namespace winding
