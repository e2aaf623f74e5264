// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/ReaderProcess.h"

#include "files/Formats.h"
#include "files/Text.h"
#include "input/DataStream.h"
#include "input/Leaves.h"
#include "input/PieceFiles.h"
#include "input/ReaderChild.h"
#include "program/Failure.h"
#include "program/Interrupt.h"
#include "program/Messages.h"
#include "program/Progress.h"

#include "vtkAlgorithm.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace
{

long long peakOfReaders = 0; // KiB

/// Thrown where the process that reads has ended without a last message.
struct ReaderEnded
{
};

/// Asks that a child does not outlive its parent, and leaves to it signals from the terminal and
/// the files that it has open, with their locks, except for the pipe between them.
void dependOn(pid_t parent, int pipe)
{
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  close_range(STDERR_FILENO + 1, static_cast<unsigned int>(pipe) - 1, 0);
  close_range(static_cast<unsigned int>(pipe) + 1, ~0U, 0);
#endif
  interrupt::forgetTemporaryFiles();
  if (getppid() != parent)
  {
    _exit(EXIT_INTERRUPTED);
  }
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
  {
    std::signal(signal, SIG_IGN);
  }
}

/// A process that reads a file, and the messages from it. It ends with this object at the latest.
class ReaderProcess : public ByteSource
{
public:
  ReaderProcess(const std::string& fileName, const VtkFormat& format, std::uintmax_t size)
  {
    int ends[2];
    if (pipe(ends) != 0)
    {
      refuse(fileName);
    }
    const pid_t parent = getpid();
    // A signal in between would be handled by the child as if it were the program.
    sigset_t all, before;
    sigfillset(&all);
    sigprocmask(SIG_SETMASK, &all, &before);
    child_ = fork();
    if (child_ == 0)
    {
      dependOn(parent, ends[1]);
      sigprocmask(SIG_SETMASK, &before, nullptr);
      readAndSend(fileName, format, size, ends[1]);
    }
    const int error = errno;
    sigprocmask(SIG_SETMASK, &before, nullptr);
    close(ends[1]);
    pipe_ = ends[0];
    if (child_ < 0)
    {
      close(pipe_);
      errno = error;
      refuse(fileName);
    }
#ifdef F_SETPIPE_SZ
    fcntl(pipe_, F_SETPIPE_SZ, 1 << 20); // the processes then wait for each other less often
#endif
  }

  ~ReaderProcess() override
  {
    if (child_ > 0)
    {
      kill(child_, SIGKILL);
      this->waitForEnd();
    }
    close(pipe_);
  }

  ReaderProcess(const ReaderProcess&) = delete;
  void operator=(const ReaderProcess&) = delete;

  using ByteSource::take;

  /// Throws ReaderEnded where there are not as many bytes, and Failure when the program is
  /// interrupted.
  void take(void* bytes, std::size_t count) override
  {
    char* next = static_cast<char*>(bytes);
    while (count > 0)
    {
      this->waitForBytes();
      const ssize_t taken = read(pipe_, next, count);
      if (taken <= 0)
      {
        throw ReaderEnded();
      }
      next += taken;
      count -= static_cast<std::size_t>(taken);
    }
  }

  /// Waits until the process has ended, and gives the status that waitpid() gives.
  int waitForEnd()
  {
    int status = 0;
    struct rusage used = {};
    while (wait4(child_, &status, 0, &used) < 0 && errno == EINTR)
    {
    }
    peakOfReaders = std::max<long long>(peakOfReaders, used.ru_maxrss);
    child_ = 0;
    return status;
  }

private:
  [[noreturn]] static void refuse(const std::string& fileName)
  {
    throw Failure(EXIT_NO_MEMORY, fileName,
      std::string("no process can be started to read it: ") + std::strerror(errno) +
        "; end other programs");
  }

  void waitForBytes() const
  {
    constexpr int milliseconds = 100; // a signal may come right before the wait
    struct pollfd end = {pipe_, POLLIN, 0};
    do
    {
      interrupt::check();
    } while (poll(&end, 1, milliseconds) <= 0);
  }

  pid_t child_ = 0;
  int pipe_ = -1;
};

/// Says in words how a process ended that has sent no last message.
std::string endInWords(int status)
{
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  const std::string reader = "VTK's reader ";
  if (signal == SIGPROF)
  {
    return reader + "comes to no end with it; it is damaged";
  }
  if (signal == SIGKILL)
  {
    return reader + "was killed over it; there may be too little memory";
  }
  return reader + (signal == 0 ? "gives it up" : "crashes on it") + "; it is damaged";
}

/// The newest version of VTK's XML formats that this VTK reads. Another layout of polyhedra came
/// with 2.3, and older readers pass over it in silence.
constexpr bool knowsPolyhedra = VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 4;
constexpr std::pair<int, int> newestFormat = {2, knowsPolyhedra ? 3 : 2};

/// The version of a file of VTK's XML formats if it is newer than what VTK reads; else empty.
std::string newerFormatOf(const std::string& fileName)
{
  const std::string head = beginningOf(fileName, 1024), attribute = " version=\"";
  const std::size_t at = head.find(attribute, std::min(head.find("<VTKFile"), head.size()));
  std::pair<int, int> version;
  const bool isThere = at != std::string::npos && std::sscanf(head.c_str() + at + attribute.size(),
                                                    "%d.%d", &version.first, &version.second) == 2;
  return isThere && version > newestFormat
           ? std::to_string(version.first) + "." + std::to_string(version.second)
           : "";
}

/// Returns the size of a file in bytes; 0 where there is none.
std::uintmax_t sizeOf(const std::string& fileName)
{
  std::error_code error;
  const std::uintmax_t found = std::filesystem::file_size(fileName, error);
  return error ? 0 : found;
}

/// Throws Failure for what cannot be read of a newer format, unless a condition holds.
void requireKnown(bool condition, const std::string& fileName, const std::string& newer)
{
  if (!condition)
  {
    throw Failure(EXIT_REFUSED, fileName,
      "was written by a newer VTK, format " + newer + "; save its surface there, as .ply");
  }
}

/// Throws Failure for a VTKHDF file. VTK's reader says neither what is wrong nor that it does not
/// know the type.
void requireKnownHdf(const std::string& fileName)
{
  if (suffixOf(fileName) == ".vtkhdf")
  {
    throw Failure(EXIT_REFUSED, fileName,
      "cannot be read by the reader of VTK " + std::to_string(VTK_MAJOR_VERSION) + "." +
        std::to_string(VTK_MINOR_VERSION) +
        ", which reads surfaces from 9.3 on; save it as .vtp or .vtu");
  }
}

/// Returns what is wrong with a file, by what VTK's reader says of it.
std::string faultOf(const std::string& words)
{
  const std::string mark = "Error parsing XML in stream at line ";
  const std::size_t at = words.find(mark);
  if (at == std::string::npos)
  {
    return "cannot be read by VTK; it is damaged, or of a kind that this VTK does not know: save "
           "it again, or in another format";
  }
  const std::size_t line = at + mark.size();
  return "is no whole XML at line " + words.substr(line, words.find(',', line) - line) +
         "; it is damaged or cut off, save it again";
}

bool hasPolyhedra(vtkDataObject* data)
{
  bool isAny = false;
  forEachLeaf(data,
    [&isAny](vtkDataObject* leaf)
    {
      auto* const cells = vtkDataSet::SafeDownCast(leaf);
      for (vtkIdType cell = 0; cells && cell < cells->GetNumberOfCells() && !isAny; ++cell)
      {
        isAny = cells->GetCellType(cell) == VTK_POLYHEDRON;
      }
    });
  return isAny;
}

/// Takes messages up to the last one. `newer` is the version of a format that is newer than VTK's,
/// or empty.
vtkSmartPointer<vtkDataObject> receive(
  ReaderProcess& process, const std::string& fileName, const std::string& newer, Messages& messages)
{
  vtkNew<vtkAlgorithm> follower; // has the progress of the reader
  const Progress progress(follower, Phase::reading, messages.isQuiet());
  std::vector<std::string> notes; // shown only if the data comes, for a failure is one line
  for (;;)
  {
    switch (process.take<ReaderMessage>())
    {
    case ReaderMessage::progress:
      follower->UpdateProgress(process.take<double>());
      break;
    case ReaderMessage::note:
      notes.push_back(process.takeText());
      break;
    case ReaderMessage::error:
      requireKnown(newer.empty(), fileName, newer);
      requireKnownHdf(fileName);
      throw Failure(EXIT_REFUSED, fileName, faultOf(process.takeText()));
    case ReaderMessage::failure:
    {
      requireKnown(newer.empty(), fileName, newer);
      const auto status = static_cast<ExitStatus>(process.take<int>());
      throw Failure(status, process.takeText());
    }
    case ReaderMessage::data:
      auto data = receiveData(process);
      requireKnown(newer.empty() || knowsPolyhedra || !hasPolyhedra(data), fileName, newer);
      for (const std::string& note : notes)
      {
        messages.DisplayWarningText(note.c_str());
      }
      return data;
    }
  }
}

} // namespace

vtkSmartPointer<vtkDataObject> readInProcess(
  const std::string& fileName, const VtkFormat& format, Messages& messages)
{
  const std::vector<Piece> pieces = piecesOf(fileName);
  checkPieces(fileName, pieces);
  // The version of the file, or of the first of its parts, that is newer than what VTK reads.
  std::string newer = newerFormatOf(fileName);
  std::uintmax_t size = sizeOf(fileName);
  for (const Piece& piece : pieces)
  {
    newer = newer.empty() && piece.isRequired ? newerFormatOf(piece.file) : newer;
    size += sizeOf(piece.file);
  }
  ReaderProcess process(fileName, format, size);
  try
  {
    return receive(process, fileName, newer, messages);
  }
  catch (const ReaderEnded&)
  {
    requireKnown(newer.empty(), fileName, newer);
    const int status = process.waitForEnd();
    if (WIFEXITED(status) && WEXITSTATUS(status) == EXIT_NO_MEMORY)
    {
      throw Failure(EXIT_NO_MEMORY, fileName,
        "takes more memory to read than there is; end other programs, or is it damaged?");
    }
    throw Failure(EXIT_REFUSED, fileName, endInWords(status));
  }
  catch (const std::bad_alloc&)
  {
    throw Failure(EXIT_NO_MEMORY, fileName, "does not fit into memory; use a smaller one");
  }
}

long long peakMemoryOfReaders()
{
  return 1024 * peakOfReaders;
}
