#include "commands/Commands.h"
#include "commands/FieldRun.h"
#include "commands/FilesToKeep.h"
#include "commands/FilterSettings.h"
#include "files/Suffix.h"
#include "input/ReadInput.h"
#include "options/Options.h"
#include "output/OutputFile.h"
#include "program/Failure.h"
#include "program/Interrupt.h"
#include "program/Messages.h"
#include "program/Progress.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedShortArray.h"
#include "vtkWindingNumberLabels.h"
#include "vtkWindingNumberVoxels.h"

namespace
{

/// The name of a file without folders and suffix.
std::string stemOf(const std::string& fileName)
{
  const std::string name = fileName.substr(fileName.find_last_of('/') + 1);
  return name.substr(0, name.size() - suffixOf(name).size());
}

/// One file as it is, or several as blocks with the names of their files.
vtkSmartPointer<vtkDataObject> readSolids(const std::vector<std::string>& files, Messages& messages)
{
  if (files.size() == 1)
  {
    return readInput(files[0], messages);
  }
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (const std::string& file : files)
  {
    const unsigned int block = blocks->GetNumberOfBlocks();
    blocks->SetBlock(block, readInput(file, messages));
    blocks->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), stemOf(file).c_str());
  }
  return blocks;
}

/// The labels with their names, and with their voxels where the whole image is there.
Json describeLabels(vtkWindingNumberLabels& filter, const Options& options)
{
  vtkImageData* image = filter.GetOutput();
  auto* values =
    vtkUnsignedShortArray::SafeDownCast(image->GetFieldData()->GetArray("LabelValues"));
  auto* names = vtkStringArray::SafeDownCast(image->GetFieldData()->GetAbstractArray("LabelNames"));
  vtkDataSetAttributes* attributes = image->GetPointData();
  if (options.cells)
  {
    attributes = image->GetCellData();
  }
  auto* labels = vtkUnsignedShortArray::SafeDownCast(attributes->GetArray("Label"));
  std::vector<vtkIdType> voxels(65536);
  for (vtkIdType i = 0; labels && options.pieces == 1 && i < labels->GetNumberOfTuples(); ++i)
  {
    ++voxels[labels->GetValue(i)];
  }
  Json result = Json::array();
  for (vtkIdType i = 0; values && names && i < values->GetNumberOfTuples(); ++i)
  {
    Json label = {{"label", values->GetValue(i)}, {"name", names->GetValue(i)}};
    if (options.pieces == 1)
    {
      label["voxels"] = voxels[values->GetValue(i)];
    }
    result.push_back(label);
  }
  return result;
}

/// Makes the surface between voxels of different labels.
void makeSurface(vtkWindingNumberVoxels* voxels, vtkWindingNumberLabels* labels,
  const Options& options, Messages& messages)
{
  voxels->SetInputData(labels->GetOutput());
  voxels->SetInputArrayToProcess(0, 0, 0,
    options.cells ? vtkDataObject::FIELD_ASSOCIATION_CELLS
                  : vtkDataObject::FIELD_ASSOCIATION_POINTS,
    "Label");
  voxels->ByLabelOn();
  {
    const Progress progress(voxels, Phase::evaluating, messages.isQuiet());
    voxels->Update();
  }
  interrupt::check();
  messages.throwIfError(options.input);
}

} // namespace

void runLabels(const Options& options, Messages& messages)
{
  OutputFile output(options.output, filesToKeep(options));
  vtkNew<vtkWindingNumberLabels> filter;
  applyLabels(options, filter);
  FieldRun run(*filter, options, messages, [&] { return readSolids(options.inputs, messages); });
  if (options.pieces == 1)
  {
    run.update();
  }
  if (suffixOf(options.output) == ".vti")
  {
    run.write(output);
  }
  else
  {
    vtkNew<vtkWindingNumberVoxels> voxels;
    makeSurface(voxels, filter, options, messages);
    run.write(voxels->GetOutput(), &output);
  }
  run.addToReport(
    "solids", {{"count", filter->GetNumberOfSolids()}, {"empty", filter->GetNumberOfEmptySolids()},
                {"open", filter->GetNumberOfOpenSolids()},
                {"inside_out", filter->GetNumberOfInsideOutSolids()}});
  run.addToReport("labels", describeLabels(*filter, options));
  run.print();
}
