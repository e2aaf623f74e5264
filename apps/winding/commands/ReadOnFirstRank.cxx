#include "commands/ReadOnFirstRank.h"

#include "input/ReadInput.h"
#include "program/ParallelRun.h"

#include "vtkPolyData.h"

vtkSmartPointer<vtkPointSet> readOnFirstRank(const std::string& fileName, Messages& messages)
{
  vtkSmartPointer<vtkPointSet> data = vtkSmartPointer<vtkPolyData>::New();
  parallel::agreeOnFirst([&] { data = readInput(fileName, messages); });
  return data;
}
