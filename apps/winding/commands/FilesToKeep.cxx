#include "commands/FilesToKeep.h"

#include "options/Options.h"

std::vector<std::string> filesToKeep(const Options& options)
{
  if (options.overwrite)
  {
    return {};
  }
  if (!options.inputs.empty())
  {
    return options.inputs;
  }
  return options.queries.empty() ? std::vector<std::string>{options.input}
                                 : std::vector<std::string>{options.input, options.queries};
}
