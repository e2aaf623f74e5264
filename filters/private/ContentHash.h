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

/// A 64 bit hash of numbers, for telling sources apart that nobody tries to make collide.
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
  void addBytes(const void* data, std::size_t size)
  {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; i += sizeof(std::uint64_t))
    {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes + i, std::min(sizeof word, size - i));
      hash_ = (hash_ ^ word) * 0x9E3779B97F4A7C15u;
      hash_ ^= hash_ >> 29;
    }
  }

  std::uint64_t hash_ = 0x2545F4914F6CDD1Du;
};

} // namespace winding
