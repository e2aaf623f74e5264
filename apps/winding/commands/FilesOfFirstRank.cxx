#include "commands/FilesOfFirstRank.h"

#include "commands/FilesToKeep.h"
#include "input/ReadInput.h"
#include "options/Options.h"
#include "output/OutputFile.h"
#include "program/ParallelRun.h"

#include "vtkPolyData.h"

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
