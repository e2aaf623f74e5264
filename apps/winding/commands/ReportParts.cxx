// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/ReportParts.h"

#include "input/ReaderProcess.h"

#include "vtkWindingNumberAlgorithm.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>

#include <sys/resource.h>

Json describeInput(const std::string& fileName, const vtkWindingNumberAlgorithm& filter)
{
  Json input = {{"file", fileName}, {"kind", filter.GetSourceIsSurface() ? "surface" : "points"},
    {"primitives", filter.GetNumberOfPrimitives()},
    {"welded_vertices", filter.GetNumberOfWeldedVertices()},
    {"boundary_edges", filter.GetNumberOfBoundaryEdges()},
    {"net_boundary_edges", filter.GetNumberOfNetBoundaryEdges()},
    {"dropped", filter.GetNumberOfDroppedPrimitives()}};
  if (!filter.GetSourceIsSurface())
  {
    input["mean_area"] = filter.GetMeanPointArea();
    input["normals_estimated"] = filter.GetNormalsWereEstimated();
    if (filter.GetNormalsWereEstimated())
    {
      input["normal_estimation"] = filter.GetNormalEstimationUsed();
      input["clear_share"] = filter.GetClearShare();
    }
  }
  return input;
}

namespace
{

/// Returns the most memory that this process has held, in KiB. What getrusage() gives on Linux is
/// at least what the process held that started the program.
long long peakOfProcess()
{
  std::ifstream status("/proc/self/status");
  const std::string name = "VmHWM:";
  for (std::string line; std::getline(status, line);)
  {
    if (line.compare(0, name.size(), name) == 0)
    {
      return std::atoll(line.c_str() + name.size());
    }
  }
  struct rusage own = {};
  getrusage(RUSAGE_SELF, &own);
  return own.ru_maxrss;
}

} // namespace

long long peakMemory()
{
  return std::max(1024 * peakOfProcess(), peakMemoryOfReaders());
}

long long largestMemory(const std::vector<double>& peaks)
{
  return static_cast<long long>(*std::max_element(peaks.begin(), peaks.end()));
}

void addRanks(Json& report, const std::vector<double>& peaks)
{
  if (peaks.size() > 1)
  {
    report["ranks"] = peaks.size();
    report["peak_memory_of_ranks"] = Json::array();
    for (const double peak : peaks)
    {
      report["peak_memory_of_ranks"].push_back(static_cast<long long>(peak));
    }
  }
}
