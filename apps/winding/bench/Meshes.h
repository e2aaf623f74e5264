#pragma once

#include "bench/Triangles.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class Messages;
struct Options;
class vtkPointSet;
class vtkPolyData;

/**
 * The triangles of a data set: polygons as fans from their first vertex and strips unrolled, as the
 * filters take them; other cells through their outer surface. There are none in clouds.
 */
Triangles trianglesOf(vtkPointSet* data);

/// The triangles as a new data set.
vtkSmartPointer<vtkPolyData> polyDataOf(const Triangles& triangles);

/// Calls measure(file, triangles) for each file among the subjects of bench, from firstSubject on.
/// Throws Failure for a file without triangles, and where measure() throws Refusal.
void forEachMesh(const Options& options, std::size_t firstSubject, Messages& messages,
  const std::function<void(const std::string& file, const Triangles& triangles)>& measure);
