// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause

// Measures readers of files: the module's on one thread and on all, and VTK's where there is
// one.
//
// Usage: readers_bench [--points <folder>] <file…>. A line for each file and reader says the best
// of several rounds in milliseconds and MB/s, and the processor time of all threads, which other
// work on the machine changes less. With --points the coordinates that each reader gave are left in
// the folder as doubles, <file>.<reader>, for readers_peers.py to compare.

#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSTLReader.h"
#include "vtkSmartPointer.h"
#include "vtkWindingNumberReader.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>

namespace
{

using Data = vtkSmartPointer<vtkPolyData>;

constexpr int rounds = 7;
std::filesystem::path folderOfPoints; ///< empty where coordinates are not wanted

template <class Reader> Data readBy(const std::string& fileName)
{
  vtkNew<Reader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  return reader->GetOutput();
}

Data readByVtkStl(const std::string& fileName)
{
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->MergingOff(); // the module's reader leaves points apart, too
  reader->Update();
  return reader->GetOutput();
}

void keepPoints(vtkPolyData* data, const std::string& name)
{
  std::ofstream file(folderOfPoints / name, std::ios::binary);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double point[3];
    data->GetPoint(i, point);
    file.write(reinterpret_cast<const char*>(point), sizeof point);
  }
}

/// Reads a file several times, and prints the line on it.
template <class Read> void measure(const std::string& fileName, const std::string& who, Read read)
{
  const std::string name = std::filesystem::path(fileName).filename().string();
  double wall = 1e300, processor = 1e300;
  Data data;
  for (int round = 0; round < rounds; ++round)
  {
    data = nullptr;
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t processorStart = std::clock();
    data = read(fileName);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    wall = std::min(wall, seconds.count());
    processor =
      std::min(processor, static_cast<double>(std::clock() - processorStart) / CLOCKS_PER_SEC);
  }
  const double megabytes = 1e-6 * static_cast<double>(std::filesystem::file_size(fileName));
  std::printf("%-30s  %8.1f MB  %-18s  %8.2f ms  %7.0f MB/s  processor %8.2f ms  %10lld points\n",
    name.c_str(), megabytes, who.c_str(), 1e3 * wall, megabytes / wall, 1e3 * processor,
    static_cast<long long>(data->GetNumberOfPoints()));
  std::fflush(stdout);
  if (!folderOfPoints.empty())
  {
    keepPoints(data, name + "." + who);
  }
}

template <class Read> void measureOnThreads(const std::string& fileName, int all, Read read)
{
  for (const int threads : {1, all})
  {
    vtkSMPTools::Initialize(threads);
    measure(fileName, "module, " + std::to_string(threads) + " threads", read);
  }
}

void measureFile(const std::string& fileName, int all)
{
  const std::string suffix = std::filesystem::path(fileName).extension().string();
  measureOnThreads(fileName, all, readBy<vtkWindingNumberReader>);
  if (suffix == ".obj")
  {
    measure(fileName, "VTK", readBy<vtkOBJReader>);
  }
  else if (suffix == ".ply")
  {
    measure(fileName, "VTK", readBy<vtkPLYReader>);
  }
  else if (suffix == ".stl")
  {
    measure(fileName, "VTK", readByVtkStl);
  }
}

} // namespace

int main(int count, char** arguments)
{
  const int all = vtkSMPTools::GetEstimatedNumberOfThreads();
  int first = 1;
  if (count > 2 && std::strcmp(arguments[1], "--points") == 0)
  {
    folderOfPoints = arguments[2];
    first = 3;
  }
  for (int i = first; i < count; ++i)
  {
    measureFile(arguments[i], all);
  }
}
