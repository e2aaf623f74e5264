// Measures readers of files: those of the module on one thread and on all, and VTK's where there is
// one.
//
// Usage: readers_bench <file…>. A line for each file and reader says the best of several rounds in
// milliseconds and MB/s, and the processor time of all threads, which other work on the machine
// changes less.

#include "vtkGeomviewOFFReader.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkOrientedPointsReader.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSTLReader.h"
#include "vtkSurfaceMeshReader.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>

namespace
{

constexpr int rounds = 7;

/// Reads a file several times, and prints the line on it.
template <class Reader> void measure(const std::string& fileName, const std::string& who)
{
  double wall = 1e300, processor = 1e300;
  vtkIdType points = 0;
  for (int round = 0; round < rounds; ++round)
  {
    vtkNew<Reader> reader;
    reader->SetFileName(fileName.c_str());
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t processorStart = std::clock();
    reader->Update();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    wall = std::min(wall, seconds.count());
    processor =
      std::min(processor, static_cast<double>(std::clock() - processorStart) / CLOCKS_PER_SEC);
    points = reader->GetOutput()->GetNumberOfPoints();
  }
  const double megabytes = 1e-6 * static_cast<double>(std::filesystem::file_size(fileName));
  std::printf("%-30s %8.1f MB  %-18s %8.1f ms %7.0f MB/s  processor %8.1f ms  %10lld points\n",
    std::filesystem::path(fileName).filename().c_str(), megabytes, who.c_str(), 1e3 * wall,
    megabytes / wall, 1e3 * processor, static_cast<long long>(points));
}

template <class Reader> void measureOnThreads(const std::string& fileName, int all)
{
  for (const int threads : {1, all})
  {
    vtkSMPTools::Initialize(threads);
    measure<Reader>(fileName, "module, " + std::to_string(threads) + " threads");
  }
}

void measureFile(const std::string& fileName, int all)
{
  const std::string suffix = std::filesystem::path(fileName).extension().string();
  if (suffix == ".off")
  {
    measureOnThreads<vtkGeomviewOFFReader>(fileName, all);
  }
  else if (suffix == ".xyz" || suffix == ".pwn")
  {
    measureOnThreads<vtkOrientedPointsReader>(fileName, all);
  }
  else
  {
    measureOnThreads<vtkSurfaceMeshReader>(fileName, all);
  }
  if (suffix == ".obj")
  {
    measure<vtkOBJReader>(fileName, "VTK");
  }
  else if (suffix == ".ply")
  {
    measure<vtkPLYReader>(fileName, "VTK");
  }
  else if (suffix == ".stl")
  {
    measure<vtkSTLReader>(fileName, "VTK");
  }
}

} // namespace

int main(int count, char** arguments)
{
  const int all = vtkSMPTools::GetEstimatedNumberOfThreads();
  for (int i = 1; i < count; ++i)
  {
    measureFile(arguments[i], all);
  }
}
