// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/ContentHash.h"

#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>

namespace
{

std::uint64_t hashOf(vtkDataArray* array)
{
  winding::ContentHash hash;
  hash.addArray(array);
  return hash.value();
}

} // namespace

TEST(ContentHash, EveryByteCounts)
{
  // Long arrays are hashed in steps of 32 bytes, and what is left of them as short ones are.
  for (const vtkIdType size : {1, 8, 31, 255, 256, 300, 1027})
  {
    vtkNew<vtkUnsignedCharArray> array;
    array->SetNumberOfValues(size);
    array->Fill(7);
    std::set<std::uint64_t> hashes = {hashOf(array)};
    for (vtkIdType i = 0; i < size; ++i)
    {
      array->SetValue(i, 8);
      hashes.insert(hashOf(array));
      array->SetValue(i, 7);
    }
    EXPECT_EQ(hashes.size(), static_cast<std::size_t>(size) + 1) << size << " bytes";
  }
}

TEST(ContentHash, OrderCounts)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetNumberOfValues(1024);
  array->Fill(7);
  std::set<std::uint64_t> hashes;
  for (vtkIdType i = 0; i < 1023; ++i)
  {
    array->SetValue(i, 1);
    array->SetValue(i + 1, 2);
    hashes.insert(hashOf(array));
    array->SetValue(i, 2);
    array->SetValue(i + 1, 1);
    hashes.insert(hashOf(array));
    array->SetValue(i, 7);
    array->SetValue(i + 1, 7);
  }
  EXPECT_EQ(hashes.size(), std::size_t(2 * 1023));
}
