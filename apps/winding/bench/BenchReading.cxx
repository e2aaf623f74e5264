#include "bench/BenchSubjects.h"
#include "bench/Timing.h"
#include "files/Suffix.h"
#include "input/ReadInput.h"
#include "options/Options.h"
#include "program/Interrupt.h"
#include "program/Messages.h"
#include "program/Threads.h"

#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPointSet.h"
#include "vtkSTLReader.h"

#include <algorithm>
#include <filesystem>

namespace
{

template <class Reader> void readWith(const std::string& fileName)
{
  vtkNew<Reader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
}

/// A reader of VTK that reads files which the module reads by itself.
struct VtkReader
{
  const char* suffix;
  void (*read)(const std::string& fileName);
};

constexpr VtkReader vtkReaders[] = {{".obj", readWith<vtkOBJReader>},
  {".ply", readWith<vtkPLYReader>}, {".stl", readWith<vtkSTLReader>}};

/// Millions of bytes in a second.
double rate(double megabytes, double seconds)
{
  return megabytes / std::max(seconds, 1e-6);
}

} // namespace

std::vector<BenchTable> benchReading(const Options& options, Messages& messages)
{
  BenchTable table("reading, " + std::to_string(threadsUsed(options.threads)) + " threads",
    {"s: from the name of a file, which the page cache holds, to its points and cells; the least "
     "of five runs",
      "VTK s: the same for VTK's reader, which keeps single precision; MB: a million bytes"});
  for (std::size_t i = 1; i < options.bench.subjects.size(); ++i)
  {
    const std::string& file = options.bench.subjects[i];
    vtkSmartPointer<vtkPointSet> data;
    const double seconds = secondsOf([&] { data = readInput(file, messages); });
    const double megabytes = 1e-6 * static_cast<double>(std::filesystem::file_size(file));
    Json row = {{"file", std::filesystem::path(file).filename().string()}, {"MB", megabytes},
      {"points", data->GetNumberOfPoints()}, {"cells", data->GetNumberOfCells()}, {"s", seconds},
      {"MB/s", rate(megabytes, seconds)}};
    for (const VtkReader& reader : vtkReaders)
    {
      if (suffixOf(file) == reader.suffix)
      {
        const double vtkSeconds = secondsOf([&] { reader.read(file); });
        row["VTK s"] = vtkSeconds;
        row["VTK MB/s"] = rate(megabytes, vtkSeconds);
        row["times as fast"] = vtkSeconds / std::max(seconds, 1e-6);
      }
    }
    table.add(row);
    messages.throwIfError(file);
    interrupt::check();
  }
  return {table};
}
