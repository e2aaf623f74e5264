#include "Commands.h"
#include "Failure.h"
#include "Messages.h"
#include "Options.h"
#include "ReadInput.h"
#include "Report.h"
#include "Triangles.h"

#include "Refusal.h"
#include "SurfaceReport.h"

#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

Json boxOf(const winding::Bounds& bounds)
{
  if (bounds.isEmpty())
  {
    return nullptr;
  }
  Json box;
  for (const Eigen::Vector3d& corner : {bounds.min(), bounds.max()})
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      box.push_back(corner[axis]);
    }
  }
  return box;
}

/// How many different points there are, and of these, how many that no triangle has for a corner.
std::pair<std::size_t, std::size_t> countPoints(const Triangles& triangles, std::size_t used)
{
  std::vector<std::array<double, 3>> points;
  for (std::size_t id = 0; id < triangles.points(); ++id)
  {
    const double* point = &triangles.coordinates[3 * id];
    if (std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]))
    {
      points.push_back({point[0], point[1], point[2]});
    }
  }
  std::sort(points.begin(), points.end());
  const auto end = std::unique(points.begin(), points.end());
  const auto different = static_cast<std::size_t>(end - points.begin());
  return {different, different - std::min(used, different)};
}

Json describeSurface(const std::string& fileName, const Triangles& triangles)
{
  winding::SerialExecutor executor;
  const winding::Surface surface = winding::sanitize({triangles.view()}, executor);
  const winding::SurfaceReport report = winding::reportOn(surface);
  const winding::EdgeCounts& edges = report.edges;
  const auto [merged, unreferenced] = countPoints(triangles, surface.vertices.size());
  return {{"file", fileName}, {"kind", "surface"}, {"triangles", triangles.triangles()},
    {"vertices", triangles.points()}, {"vertices_merged", merged},
    {"closed", edges.isClosed() && !surface.triangles.empty()}, {"boundary_edges", edges.boundary},
    {"boundary_loops", edges.boundaryLoops}, {"nonmanifold_edges", edges.nonManifold},
    {"inconsistent_edges", edges.inconsistent}, {"net_boundary_edges", edges.netBoundary},
    {"components_vertex", report.vertexComponents}, {"components_edge", edges.components},
    {"duplicate_faces", report.duplicateTriangles}, {"degenerate", surface.collapsedTriangles},
    {"zero_area", report.zeroAreaTriangles}, {"unreferenced_vertices", unreferenced},
    {"euler", report.eulerCharacteristic}, {"volume", report.volume}, {"area", report.area},
    {"bbox", boxOf(surface.bounds)}, {"non_finite", surface.nonFiniteTriangles},
    {"invalid_ids", surface.invalidIdTriangles}};
}

Json describeCloud(const std::string& fileName, vtkPointSet* data)
{
  vtkDataArray* normals = data->GetPointData()->GetNormals();
  std::size_t nonFinite = 0, zero = 0, notUnit = 0;
  winding::Bounds bounds;
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
  {
    Eigen::Vector3d point, normal(0, 0, 1);
    data->GetPoint(id, point.data());
    if (normals)
    {
      normals->GetTuple(id, normal.data());
    }
    if (!point.allFinite() || !normal.allFinite())
    {
      ++nonFinite;
      continue;
    }
    bounds.extend(point);
    const double length = normal.stableNorm();
    zero += length == 0;
    // Normals as float are unit to about 1e-7, as text to 1e-6 or worse.
    notUnit += length != 0 && std::abs(length - 1) > 1e-3;
  }
  return {{"file", fileName}, {"kind", "points"}, {"points", data->GetNumberOfPoints()},
    {"normals", normals != nullptr}, {"zero_normals", zero}, {"non_unit_normals", notUnit},
    {"non_finite", nonFinite}, {"bbox", boxOf(bounds)}};
}

std::string countOf(const Json& report, const char* name, const char* what)
{
  return std::to_string(report[name].get<long long>()) + " " + what;
}

/// What the counts of a surface mean for its winding numbers, and what could be done.
std::string adviceOnSurface(const Json& report)
{
  if (report["triangles"] == 0)
  {
    return "nothing to evaluate: there are no triangles, so the field is 0";
  }
  if (report["closed"] == true)
  {
    return report["volume"].get<double>() < 0 ? "closed, but inside out (negative volume): every "
                                                "winding number is an integer; turn the faces "
                                                "round, or use --rule absolute"
                                              : "closed: every winding number is an integer";
  }
  if (report["inconsistent_edges"] > 0)
  {
    const bool one = report["inconsistent_edges"] == 1;
    return countOf(report, "inconsistent_edges", one ? "edge is" : "edges are") +
           " inconsistently oriented: parts cancel each other; orient the faces first";
  }
  return "open: " + countOf(report, "boundary_edges", "boundary edges in ") +
         countOf(report, "boundary_loops", "loops; near them winding numbers are between integers");
}

std::string adviceOnCloud(const Json& report)
{
  if (report["points"] == 0)
  {
    return "nothing to evaluate: there are no points";
  }
  if (report["normals"] == false)
  {
    return "no normals: compute oriented ones first, for instance by vtkPCANormalEstimation with "
           "NormalOrientation set to graph traversal";
  }
  return "oriented points: winding numbers are approximate, and best away from the points";
}

std::string aligned(const Json& report, const std::string& advice)
{
  std::string text;
  for (const auto& [name, value] : report.items())
  {
    if (name == "advice")
    {
      continue;
    }
    std::string label = name;
    std::replace(label.begin(), label.end(), '_', ' ');
    label.resize(std::max<std::size_t>(label.size(), 22), ' ');
    text += label + " ";
    if (value.is_array())
    {
      for (const Json& number : value)
      {
        text += shown(number.get<double>(), 9) + " ";
      }
      text.pop_back();
    }
    else if (value.is_boolean())
    {
      text += value.get<bool>() ? "yes" : "no";
    }
    else if (value.is_number_float())
    {
      text += shown(value.get<double>(), 9);
    }
    else
    {
      text += value.is_string() ? value.get<std::string>() : value.is_null() ? "-" : value.dump();
    }
    text += "\n";
  }
  return text + advice;
}

} // namespace

void runCheck(const Options& options, Messages& messages)
{
  const auto data = readInput(options.input, options, messages);
  const Triangles triangles = trianglesOf(data);
  messages.throwIfError(options.input);
  const bool isSurface = triangles.triangles() > 0;
  Json report;
  try
  {
    report =
      isSurface ? describeSurface(options.input, triangles) : describeCloud(options.input, data);
  }
  catch (const winding::Refusal& refusal)
  {
    throw Failure(REFUSED, options.input, refusal.what());
  }
  report["advice"] = isSurface ? adviceOnSurface(report) : adviceOnCloud(report);
  if (options.json)
  {
    print(report);
  }
  else
  {
    print(aligned(report, report["advice"].get<std::string>()));
  }
}
