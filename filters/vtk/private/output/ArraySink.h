// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tasks/Sink.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

#include <map>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// Gives a task VTK's arrays, with the names that they have in data sets.
class ArraySink final : public Sink
{
public:
  /// Returns an array that the task has asked for; null for others.
  vtkDataArray* array(Output output) const;

  /// Adds the points, polygons, normals and operands that there are to a surface.
  void addTo(vtkPolyData* surface) const;

  using Sink::array;

protected:
  void* memoryOf(Output output, NumberType type, std::size_t tuples) override;

private:
  std::map<Output, vtkSmartPointer<vtkDataArray>> arrays_;
};

} // namespace winding
