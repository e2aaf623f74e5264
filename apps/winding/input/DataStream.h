// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

#include <cstddef>
#include <string>
#include <type_traits>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
VTK_ABI_NAMESPACE_END

/// Takes bytes, as they are in memory, on their way to another process of this program.
class ByteSink
{
public:
  virtual ~ByteSink() = default;
  virtual void put(const void* bytes, std::size_t count) = 0;

  template <class Value> void put(const Value& value)
  {
    static_assert(std::is_trivially_copyable<Value>::value, "only plain values travel as bytes");
    this->put(&value, sizeof value);
  }
  void put(const std::string& text);
};

/// Gives the bytes that a ByteSink has taken, in their order.
class ByteSource
{
public:
  virtual ~ByteSource() = default;
  /// Throws where there are not as many bytes.
  virtual void take(void* bytes, std::size_t count) = 0;

  template <class Value> Value take()
  {
    static_assert(std::is_trivially_copyable<Value>::value, "only plain values travel as bytes");
    Value value;
    this->take(&value, sizeof value);
    return value;
  }
  std::string takeText();
};

/**
 * Sends vtkPolyData, a vtkUnstructuredGrid or a grid whose cells follow from its extent, with its
 * points, cells and arrays: all bits, names, names of components and active attributes. A
 * vtkMultiBlockDataSet or a vtkMultiPieceDataSet is sent with its names and with what of these it
 * holds. Information keys of arrays stay behind. The function follows neither offsets nor ids,
 * which may be wrong.
 */
void sendData(vtkDataObject* data, ByteSink& sink);

/// Makes the data that sendData() has sent. Throws std::bad_alloc where it does not fit into
/// memory.
vtkSmartPointer<vtkDataObject> receiveData(ByteSource& source);
