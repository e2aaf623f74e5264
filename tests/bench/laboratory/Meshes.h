// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "laboratory/Triangles.h"

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

#include <functional>
#include <string>

class Messages;
struct BenchOptions;
VTK_ABI_NAMESPACE_BEGIN
class vtkPointSet;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

/**
 * The triangles of a data set: polygons as fans from their first vertex and strips unrolled, as the
 * filters take them; other cells through their outer surface. There are none in clouds.
 */
Triangles trianglesOf(vtkPointSet* data);

/// The triangles as a new data set.
vtkSmartPointer<vtkPolyData> polyDataOf(const Triangles& triangles);

/// Calls measure(file, triangles) for each file. Throws Failure for a file without triangles, and
/// where measure() throws Refusal.
void forEachMesh(const BenchOptions& options, Messages& messages,
  const std::function<void(const std::string& file, const Triangles& triangles)>& measure);
