#include "commands/CommandFiles.h"

#include "input/ReadInput.h"
#include "options/Options.h"
#include "output/OutputFile.h"
#include "program/ParallelRun.h"

#include "vtkPolyData.h"

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

std::unique_ptr<OutputFile> openOnFirstRank(const Options& options)
{
  std::unique_ptr<OutputFile> file;
  parallel::agreeOnFirst(
    [&] { file = std::make_unique<OutputFile>(options.output, filesToKeep(options)); });
  return file;
}

vtkSmartPointer<vtkPointSet> readOnFirstRank(const std::string& fileName, Messages& messages)
{
  vtkSmartPointer<vtkPointSet> data = vtkSmartPointer<vtkPolyData>::New();
  parallel::agreeOnFirst([&] { data = readInput(fileName, messages); });
  return data;
}
