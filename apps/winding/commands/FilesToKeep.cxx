#include "commands/FilesToKeep.h"

#include "options/Options.h"

std::vector<std::string> filesToKeep(const Options& options)
{
  if (options.overwrite)
  {
    return {};
  }
  return options.queries.empty() ? std::vector<std::string>{options.input}
                                 : std::vector<std::string>{options.input, options.queries};
}
