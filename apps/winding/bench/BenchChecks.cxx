#include "bench/BenchChecks.h"

#include "options/Options.h"
#include "program/Failure.h"
#include "program/Print.h"

#include "farfield/FarFieldAccuracy.h"

#include <algorithm>
#include <string>

namespace
{

/// Some options are for one subject only, and some subjects need files or a folder.
void checkSubject(const BenchOptions& options)
{
  const std::vector<std::string>& subjects = options.subjects;
  const std::string& subject = subjects.front();
  const auto checkIdle = [&subject](bool isGiven, const char* option, const char* owner)
  {
    requireUsage(!isGiven || subject == owner,
      std::string(option) + " is for bench " + owner + "; leave it out");
  };
  requireUsage(
    options.points.empty() || subject == "vtk" || subject == "expected" || subject == "orientation",
    "--points is for bench vtk, bench expected and bench orientation; leave it out");
  checkIdle(!options.tolerances.empty(), "--tolerance", "hierarchical");
  checkIdle(!options.sources.empty(), "--sources", "hierarchical");
  checkIdle(!options.data.empty(), "--data", "seed");

  for (const char* name : {"hierarchical", "clouds", "vtk", "expected", "orientation"})
  {
    requireUsage(std::count(subjects.begin() + 1, subjects.end(), name) == 0,
      std::string("bench ") + name + " comes before its files; for a file of that name give ./" +
        name);
  }
  requireUsage(subject != "clouds" || subjects.size() > 1,
    "bench clouds needs files: meshes, whose vertices are taken as clouds");
  requireUsage(subject != "vtk" || subjects.size() > 1,
    "bench vtk needs files: surfaces, which VTK's filters are compared at");
  requireUsage(subject != "expected" || subjects.size() > 1,
    "bench expected needs files: surfaces or clouds, whose times are compared with expected ones");
  requireUsage(subject != "orientation" || subjects.size() > 1,
    "bench orientation needs files: surfaces, on which points are put");
  for (const char* name : {"seed", "kernels"})
  {
    requireUsage(subjects.size() == 1 || std::count(subjects.begin(), subjects.end(), name) == 0,
      std::string("bench ") + name + " stands alone; for a file of that name give ./" + name);
  }
  requireUsage(subject != "seed" || !options.data.empty(),
    "bench seed needs --data, the folder with the published meshes");
}

} // namespace

void checkBenchOptions(const BenchOptions& options)
{
  checkSubject(options);
  for (const int resolution : options.resolutions)
  {
    requireUsage(
      resolution >= 1, "--resolution is " + std::to_string(resolution) + "; give 1 or more voxels");
  }
  for (const double tolerance : options.tolerances)
  {
    requireUsage(tolerance >= winding::FarFieldAccuracy::finest,
      "--tolerance is " + shown(tolerance) +
        "; give 1e-6 or more: below that there is no hierarchical method");
  }
  for (const int sources : options.sources)
  {
    requireUsage(sources >= 100,
      "--sources is " + std::to_string(sources) + "; give 100 or more, the spheres are round");
  }
  for (const int points : options.points)
  {
    requireUsage(points >= 1, "--points is " + std::to_string(points) + "; give 1 or more");
  }
}
