// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/CommandFiles.h"
#include "commands/Commands.h"
#include "files/Formats.h"
#include "options/CommandLine.h"
#include "program/Failure.h"
#include "program/Interrupt.h"
#include "program/LastResort.h"
#include "program/Messages.h"
#include "program/ParallelRun.h"
#include "program/Threads.h"

#include <algorithm>
#include <csignal>
#include <map>
#include <new>
#include <optional>

#include <fcntl.h>
#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace
{

void tell(const Failure& failure)
{
  const std::string message = failure.what();
  printLine("winding: " + (failure.status == EXIT_INTERRUPTED ? message : "error: " + message));
}

/// The end of a failure that all ranks know of.
int endTogether(const AgreedFailure& failure)
{
  if (parallel::isFirst())
  {
    tell(failure);
  }
  interrupt::ignore();
  parallel::finish();
  return failure.status;
}

/// The end of a rank whose failure others do not know of and may wait for. mpirun sees that it ends
/// without ending MPI, and ends the others.
int endAlone(const Failure& failure)
{
  tell(failure);
  if (!parallel::isAlone())
  {
    _exit(failure.status);
  }
  return failure.status;
}

/// Lets large blocks of memory go back to the system as soon as they are freed. Otherwise glibc
/// keeps them once it has seen blocks of their size, and a cloud of noisy points, whose normals and
/// areas are found one after the other, takes a sixth more. Work that takes less time than that of
/// normals would be some per cent slower: it waits for fresh memory.
void giveBackFreedMemory()
{
#ifdef __GLIBC__
  constexpr int large = 1 << 20; // bytes
  mallopt(M_MMAP_THRESHOLD, large);
#endif
}

/// Refuses what works on one rank only, and shares the threads of a machine among its ranks.
void adaptToRanks(Options& options)
{
  if (parallel::isAlone())
  {
    return;
  }
  requireUsage(options.command == "field" || options.command == "labels" ||
                 options.command == "probe" || options.command == "surface" ||
                 options.command == "boolean",
    "start it without mpirun: " + options.command +
      " works on one rank; field, surface, boolean, labels and probe work on several");
  requireUsage(options.pieces == 1 || suffixOf(options.output) == ".pvti",
    "give the output the suffix .pvti, or leave --pieces out: several ranks gather the field for a "
    ".vti file");
  if (options.threads == 0)
  {
    options.threads = std::max(1, threadsUsed(0) / parallel::countOnHost());
  }
}

void run(Options options)
{
  const std::map<std::string, void (*)(const Options&, Messages&)> commands = {{"field", runField},
    {"surface", runSurface}, {"boolean", runBoolean}, {"voxels", runVoxels}, {"labels", runLabels},
    {"probe", runProbe}, {"normals", runNormals}, {"check", runCheck}, {"bench", runBench}};
  Messages& messages = Messages::install(options.quiet || !parallel::isFirst());
  limitThreads(options.threads);
  if (options.estimateNormals || options.command == "normals")
  {
    giveBackFreedMemory();
  }
  try
  {
    parallel::agree([&] { readToward(options, messages); });
    commands.at(options.command)(options, messages);
  }
  catch (const std::bad_alloc&)
  {
    throw Failure(EXIT_NO_MEMORY, options.input, outOfMemoryAdvice());
  }
}

/// Takes the places of standard streams that are closed, lest a file or a pipe gets into one and
/// what is meant for the stream goes there. Writing to such a place is an error.
void fillStandardStreams()
{
  int file = STDIN_FILENO;
  while (file >= 0 && file <= STDERR_FILENO)
  {
    file = open("/dev/null", O_RDONLY);
  }
  close(file);
}

} // namespace

int main(int argc, char** argv)
{
  fillStandardStreams();
  interrupt::install();
  installLastResort();
  // A limit on the size of files, or a reader of messages that has gone away, is to be an error of
  // writing, not the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  try
  {
    parallel::start(argc, argv);
    std::optional<Options> options;
    parallel::agree(
      [&]
      {
        options = parseCommandLine(argc, argv);
        if (options)
        {
          adaptToRanks(*options);
        }
      });
    if (options)
    {
      run(*options);
    }
    parallel::finish();
    return EXIT_DONE;
  }
  catch (const AgreedFailure& failure)
  {
    return endTogether(failure);
  }
  catch (const Failure& failure)
  {
    return endAlone(failure);
  }
  catch (const std::bad_alloc&)
  {
    leaveWithoutMemory();
  }
  catch (const std::exception& error)
  {
    return endAlone({EXIT_REFUSED, std::string("unexpected: ") + error.what()});
  }
}
