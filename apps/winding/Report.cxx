#include "Report.h"

#include "Failure.h"
#include "Options.h"

#include "vtkSMPTools.h"
#include "vtkWindingNumberAlgorithm.h"

#include <algorithm>
#include <iostream>
#include <sstream>
#include <thread>

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
      input["clear_share"] = filter.GetClearShare();
    }
  }
  return input;
}

long long peakMemory()
{
  struct rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return 1024LL * usage.ru_maxrss;
}

int threadsOf(const Options& options)
{
  const int available = vtkSMPTools::GetEstimatedNumberOfThreads();
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  return options.threads > 0 ? std::min(options.threads, cores) : available;
}

void print(const std::string& text)
{
  std::cout << text << std::endl;
  if (!std::cout)
  {
    throw Failure(REFUSED, "standard output cannot be written to; is the disk full?");
  }
}

void print(const Json& object)
{
  // File names may hold any bytes, JSON only UTF-8.
  print(object.dump(2, ' ', false, Json::error_handler_t::replace));
}

std::string shown(double value, int digits)
{
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return text.str();
}
