#include "bench/BenchCommand.h"
#include "commands/Commands.h"
#include "options/CommandLine.h"
#include "program/Failure.h"
#include "program/Interrupt.h"
#include "program/LastResort.h"
#include "program/Messages.h"
#include "program/Threads.h"

#include <csignal>
#include <map>
#include <new>

namespace
{

int fail(ExitStatus status, const std::string& message)
{
  printLine("winding: " + (status == INTERRUPTED ? message : "error: " + message));
  return status;
}

void run(const Options& options)
{
  const std::map<std::string, void (*)(const Options&, Messages&)> commands = {{"field", runField},
    {"surface", runSurface}, {"voxels", runVoxels}, {"probe", runProbe}, {"check", runCheck},
    {"bench", runBench}};
  Messages& messages = Messages::install(options.quiet);
  limitThreads(options.threads);
  try
  {
    commands.at(options.command)(options, messages);
  }
  catch (const std::bad_alloc&)
  {
    throw Failure(NO_MEMORY, options.input, outOfMemoryAdvice());
  }
}

} // namespace

int main(int argc, char** argv)
{
  interrupt::install();
  installLastResort();
  // A limit on the size of files, or a reader of messages that has gone away, is to be an error of
  // writing, not the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  try
  {
    if (const auto options = parseCommandLine(argc, argv))
    {
      run(*options);
    }
    return DONE;
  }
  catch (const Failure& failure)
  {
    return fail(failure.status, failure.what());
  }
  catch (const std::bad_alloc&)
  {
    leaveWithoutMemory();
  }
  catch (const std::exception& error)
  {
    return fail(REFUSED, std::string("unexpected: ") + error.what());
  }
}
