// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/ReaderChild.h"

#include "files/Formats.h"
#include "files/ReaderEvents.h"
#include "input/DataStream.h"
#include "input/Leaves.h"
#include "input/LegacyVtkCounts.h"
#include "program/Failure.h"

#include "vtkAlgorithm.h"
#include "vtkAppendDataSets.h"
#include "vtkCellType.h"
#include "vtkCommand.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointSet.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <new>
#include <stdexcept>
#include <string_view>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

namespace
{

class PipeSink : public ByteSink
{
public:
  explicit PipeSink(int pipe)
    : pipe_(pipe)
  {
  }
  using ByteSink::put;

  void put(const void* bytes, std::size_t count) override
  {
    constexpr std::size_t atOnce = std::size_t(1) << 16;
    if (kept_.size() + count > atOnce)
    {
      this->flush();
    }
    if (count > atOnce)
    {
      this->send(static_cast<const char*>(bytes), count);
      return;
    }
    kept_.append(static_cast<const char*>(bytes), count);
  }

  void flush()
  {
    this->send(kept_.data(), kept_.size());
    kept_.clear();
  }

private:
  void send(const char* next, std::size_t count) const
  {
    while (count > 0)
    {
      const ssize_t written = write(pipe_, next, count);
      if (written < 0)
      {
        _exit(EXIT_REFUSED); // nobody listens
      }
      next += written;
      count -= static_cast<std::size_t>(written);
    }
  }

  int pipe_;
  std::string kept_; ///< many small parts go at once
};

/// Whether a warning of VTK's readers is about something that the data does not need.
bool isHarmless(std::string_view warning)
{
  const char* const harmless[] = {"Could not locate key", "tagged as an IdType",
    "with older reader version", "is higher than", "No topology read",
    "Number of texture coordinates", "attempting binary"};
  return std::any_of(std::begin(harmless), std::end(harmless),
    [warning](const char* part) { return warning.find(part) != std::string_view::npos; });
}

/// Sends what VTK reports. VTK reports some errors as warnings. The first error ends the process:
/// all that follows is its consequence, and may be a crash or an endless loop.
class ReportWindow : public vtkOutputWindow
{
public:
  static ReportWindow* New();
  vtkTypeMacro(ReportWindow, vtkOutputWindow);

  void setSink(PipeSink& sink) { sink_ = &sink; }

  void DisplayText(const char* text) override { this->DisplayWarningText(text); }
  void DisplayErrorText(const char* text) override
  {
    sink_->put(ReaderMessage::error);
    sink_->put(std::string(text));
    sink_->flush();
    _exit(EXIT_REFUSED);
  }
  void DisplayWarningText(const char* text) override
  {
    if (!isHarmless(text))
    {
      this->DisplayErrorText(text);
    }
  }
  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }
  void DisplayDebugText(const char*) override {}

protected:
  ReportWindow() = default;
  ~ReportWindow() override = default;

private:
  PipeSink* sink_ = nullptr;
};

vtkStandardNewMacro(ReportWindow);

struct ProgressSender
{
  PipeSink& sink;

  void send(vtkObject* reader, unsigned long, void*)
  {
    sink.put(ReaderMessage::progress);
    sink.put(vtkAlgorithm::SafeDownCast(reader)->GetProgress());
    sink.flush();
  }
};

struct NoteSender
{
  ByteSink& sink;

  void send(vtkObject*, unsigned long, void* note)
  {
    sink.put(ReaderMessage::note);
    sink.put(std::string(static_cast<const char*>(note)));
  }
};

/// Buffers and all else that does not depend on the file take less than this number of bytes.
constexpr std::uintmax_t fixedBytes = std::uintmax_t(1) << 28;

/// A byte of a packed file holds less than this number of bytes, unless they are constants.
constexpr std::uintmax_t bytesPerByte = 256;

/// The slowest readers take a tenth of these seconds, most of them much less.
constexpr double fixedSeconds = 0.5;
constexpr double secondsPerByte = 1e-6;

/// The address space in use, in bytes; 0 where the system does not say.
std::uintmax_t usedBytes()
{
  std::uintmax_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uintmax_t>(sysconf(_SC_PAGESIZE));
}

void limitMemory(std::uintmax_t bytes)
{
  const std::uintmax_t used = usedBytes();
  struct rlimit limit = {};
  if (used > 0 && getrlimit(RLIMIT_AS, &limit) == 0)
  {
    static const rlim_t ofUser = limit.rlim_cur;
    limit.rlim_cur = std::min<std::uintmax_t>(ofUser, used + bytes);
    setrlimit(RLIMIT_AS, &limit);
  }
}

void limitTime(double seconds)
{
  struct itimerval timer = {};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec =
    static_cast<suseconds_t>(1e6 * (seconds - static_cast<double>(timer.it_value.tv_sec)));
  setitimer(ITIMER_PROF, &timer, nullptr);
}

/// Limits this process to what reading a file of `fileSize` bytes can need. Memory beyond that is
/// refused with std::bad_alloc; after too much processor time the process is ended by SIGPROF.
void limitToReading(std::uintmax_t fileSize)
{
  limitMemory(fixedBytes + bytesPerByte * fileSize);
  limitTime(fixedSeconds + secondsPerByte * static_cast<double>(fileSize));
}

struct LimitRaiser
{
  std::uintmax_t fileSize;

  void raise(vtkObject*, unsigned long, void* moreBytes)
  {
    limitToReading(fileSize + static_cast<std::uintmax_t>(*static_cast<const double*>(moreBytes)));
  }
};

/// Throws Failure for a source that holds anything but surfaces, unstructured grids or points.
void checkKind(vtkDataObject* data, const std::string& fileName)
{
  bool isEmpty = true;
  forEachLeaf(data,
    [&](vtkDataObject* leaf)
    {
      isEmpty = false;
      if (!leaf || (!leaf->IsA("vtkPolyData") && !leaf->IsA("vtkUnstructuredGrid") &&
                     !leaf->IsA("vtkStructuredGrid")))
      {
        throw Failure(EXIT_REFUSED, fileName,
          std::string("holds ") + (leaf ? leaf->GetClassName() : "nothing") +
            "; a surface, an unstructured grid or points are needed");
      }
    });
  if (isEmpty)
  {
    throw Failure(EXIT_REFUSED, fileName, "has no surface and no points in it; give another file");
  }
}

/// Drops faces of a grid without polyhedra. VTK 9.1 allocates the cells of a .pvtu with types that
/// are not set yet, which now and then look like polyhedra.
void dropStrayFaces(vtkUnstructuredGrid* grid)
{
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
  vtkUnsignedCharArray* const types = grid ? grid->GetCellTypesArray() : nullptr;
  if (types && grid->GetFaces() &&
      std::none_of(types->GetPointer(0), types->GetPointer(0) + types->GetNumberOfValues(),
        [](unsigned char type) { return type == VTK_POLYHEDRON; }))
  {
    grid->SetCells(types, grid->GetCells());
  }
#else
  (void)grid;
#endif
}

/// Returns data with each partitioned data set as one data set, and with a collection of these as
/// blocks. Readers of VTKHDF give them from VTK 9.3 on.
vtkSmartPointer<vtkDataObject> withoutPartitions(vtkDataObject* data)
{
  if (auto* const collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
    {
      blocks->SetBlock(i, withoutPartitions(collection->GetPartitionedDataSet(i)));
      if (collection->HasMetaData(i))
      {
        blocks->GetMetaData(i)->Copy(collection->GetMetaData(i));
      }
    }
    return blocks;
  }
  auto* const partitions = vtkPartitionedDataSet::SafeDownCast(data);
  if (!partitions || partitions->IsA("vtkMultiPieceDataSet"))
  {
    return data;
  }
  vtkNew<vtkAppendDataSets> append;
  forEachLeaf(partitions,
    [&append](vtkDataObject* leaf)
    {
      append->SetOutputDataSetType(leaf->GetDataObjectType());
      append->AddInputData(leaf);
    });
  append->Update();
  return append->GetOutput();
}

vtkSmartPointer<vtkDataObject> read(
  const std::string& fileName, const VtkFormat& format, std::uintmax_t size, PipeSink& sink)
{
  const vtkSmartPointer<vtkAlgorithm> reader = format.makeReader(fileName);
  ProgressSender progress{sink};
  reader->AddObserver(vtkCommand::ProgressEvent, &progress, &ProgressSender::send);
  NoteSender notes{sink};
  reader->AddObserver(vtkCommand::MessageEvent, &notes, &NoteSender::send);
  LimitRaiser limits{size};
  reader->AddObserver(moreBytesEvent, &limits, &LimitRaiser::raise);
  reader->UpdateInformation();
  if (const int steps =
        reader->GetOutputInformation(0)->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
      steps > 1)
  {
    std::string note = "has " + std::to_string(steps) + " time steps; the first one is read";
    notes.send(nullptr, 0, note.data());
  }
  reader->Update();
  if (reader->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw Failure(EXIT_REFUSED, fileName,
      std::string("cannot be read: ") +
        vtkErrorCode::GetStringFromErrorCode(reader->GetErrorCode()));
  }
  vtkSmartPointer<vtkDataObject> data = withoutPartitions(reader->GetOutputDataObject(0));
  dropStrayFaces(vtkUnstructuredGrid::SafeDownCast(data));
  if (format.isSource)
  {
    checkKind(data, fileName);
  }
  else if (!vtkDataSet::SafeDownCast(data))
  {
    throw Failure(EXIT_REFUSED, fileName, "holds no image and no grid; give another file");
  }
  if (reader->IsA("vtkDataSetReader")) // it trusts the counts of a legacy file
  {
    checkLegacyVtkCounts(fileName, vtkPointSet::SafeDownCast(data));
  }
  return data;
}

/// The failure for a file that asks for more memory than there is.
Failure outOfMemory(const std::string& fileName, std::uintmax_t fileSize)
{
  // A small file that asks for all memory is not to be believed.
  const bool isSmall = fileSize < (std::uintmax_t(1) << 28);
  return isSmall ? Failure(EXIT_REFUSED, fileName,
                     "its counts ask for more memory than there is; it is damaged")
                 : Failure(EXIT_NO_MEMORY, fileName, "does not fit into memory; use a smaller one");
}

/// Reads with all exceptions as Failure.
vtkSmartPointer<vtkDataObject> readOrFail(
  const std::string& fileName, const VtkFormat& format, std::uintmax_t size, PipeSink& sink)
{
  try
  {
    limitToReading(size);
    return read(fileName, format, size, sink);
  }
  catch (const std::length_error&)
  {
    throw Failure(
      EXIT_REFUSED, fileName, "its counts ask for more than there can be; it is damaged");
  }
  catch (const std::bad_alloc&)
  {
    throw outOfMemory(fileName, size);
  }
}

} // namespace

void readAndSend(
  const std::string& fileName, const VtkFormat& format, std::uintmax_t size, int pipe)
{
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  PipeSink sink(pipe);
  try
  {
    // The threads of the program are none of this process, and would be waited for.
    vtkSMPTools::SetBackend("Sequential");
    vtkNew<ReportWindow> window;
    window->setSink(sink);
    vtkOutputWindow::SetInstance(window);
    const auto data = readOrFail(fileName, format, size, sink);
    sink.put(ReaderMessage::data);
    sendData(data, sink);
  }
  catch (const Failure& failure)
  {
    sink.put(ReaderMessage::failure);
    sink.put(static_cast<int>(failure.status));
    sink.put(std::string(failure.what()));
  }
  sink.flush();
  _exit(EXIT_DONE); // without the ends of libraries, which belong to the program
}
