#include "commands/OpenOnFirstRank.h"

#include "commands/FilesToKeep.h"
#include "options/Options.h"
#include "output/OutputFile.h"
#include "program/ParallelRun.h"

std::unique_ptr<OutputFile> openOnFirstRank(const Options& options)
{
  std::unique_ptr<OutputFile> file;
  parallel::agreeOnFirst(
    [&] { file = std::make_unique<OutputFile>(options.output, filesToKeep(options)); });
  return file;
}
