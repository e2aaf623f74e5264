// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/CommandFiles.h"
#include "commands/Commands.h"
#include "commands/FieldRun.h"
#include "commands/FilterSettings.h"
#include "commands/WriteField.h"
#include "files/Formats.h"
#include "options/Options.h"
#include "output/OutputFile.h"
#include "output/PiecesFile.h"
#include "program/Failure.h"
#include "program/Interrupt.h"
#include "program/Messages.h"
#include "program/ParallelRun.h"
#include "program/Progress.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedShortArray.h"
#include "vtkWindingNumberLabels.h"
#include "vtkWindingNumberVoxels.h"

#include <algorithm>

namespace
{

/// The labels with their names, and with their voxels where the image is the whole one.
Json describeLabels(vtkImageData* image, bool isWhole, bool asCells)
{
  auto* values =
    vtkUnsignedShortArray::SafeDownCast(image->GetFieldData()->GetArray("LabelValues"));
  auto* names = vtkStringArray::SafeDownCast(image->GetFieldData()->GetAbstractArray("LabelNames"));
  vtkDataArray* const volumes = image->GetFieldData()->GetArray("LabelVolumes");
  vtkDataSetAttributes* attributes = image->GetPointData();
  if (asCells)
  {
    attributes = image->GetCellData();
  }
  auto* labels = vtkUnsignedShortArray::SafeDownCast(attributes->GetArray("Label"));
  std::vector<vtkIdType> voxels(65536);
  for (vtkIdType i = 0; labels && isWhole && i < labels->GetNumberOfTuples(); ++i)
  {
    ++voxels[labels->GetValue(i)];
  }
  Json result = Json::array();
  for (vtkIdType i = 0; values && names && i < values->GetNumberOfTuples(); ++i)
  {
    Json label = {{"label", values->GetValue(i)}, {"name", names->GetValue(i)}};
    if (isWhole)
    {
      label["voxels"] = voxels[values->GetValue(i)];
      label["volume"] = volumes->GetComponent(i, 0);
    }
    result.push_back(label);
  }
  return result;
}

/// Makes the surface between voxels of different labels.
void makeSurface(
  vtkWindingNumberVoxels* voxels, vtkImageData* labels, const Options& options, Messages& messages)
{
  voxels->SetInputData(labels);
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

/// Warns where the output has no place for names of labels that say more than their numbers.
void warnOfNames(const Json& labels, const Options& options, Messages& messages)
{
  const std::string suffix = suffixOf(options.output);
  const bool haveNames = std::any_of(labels.begin(), labels.end(),
    [](const Json& label) { return label["name"] != std::to_string(label["label"].get<int>()); });
  if (haveNames && (suffix == ".nii" || suffix == ".nii.gz"))
  {
    messages.warn(
      options.output +
      ": NIfTI has no place for the names of the labels; give it the suffix .nrrd, .mha "
      "or .vti, or take them from --json");
  }
}

/// Adds to the report what the solids are, and prints it. The image is the filter's own, or the
/// whole one that the first rank has gathered.
void report(
  FieldRun& run, vtkWindingNumberLabels& filter, vtkImageData* image, const Options& options)
{
  const bool isWhole = options.pieces == 1 && suffixOf(options.output) != ".pvti";
  run.report().add(
    "solids", {{"count", filter.GetNumberOfSolids()}, {"empty", filter.GetNumberOfEmptySolids()},
                {"open", filter.GetNumberOfOpenSolids()},
                {"inside_out", filter.GetNumberOfInsideOutSolids()}});
  if (image)
  {
    const Json labels = describeLabels(image, isWhole, options.cells);
    warnOfNames(labels, options, run.messages());
    run.report().add("labels", labels);
  }
  run.printReport();
}

void writePieces(vtkWindingNumberLabels& filter, const Options& options, Messages& messages)
{
  const PiecesFile output(options.output, filesToKeep(options));
  FieldRun run(filter, options, messages);
  writeFieldPieces(run, output);
  report(run, filter, filter.GetOutput(), options);
}

/// Writes labels that one rank makes, in pieces where the options ask for them.
void writeAlone(vtkWindingNumberLabels& filter, const Options& options, Messages& messages)
{
  OutputFile output(options.output, filesToKeep(options));
  FieldRun run(filter, options, messages);
  if (options.pieces == 1)
  {
    run.update();
  }
  writeField(run, output);
  report(run, filter, filter.GetOutput(), options);
}

/// Writes the labels, or the surface between them, from an image that is there as a whole.
void writeWhole(vtkWindingNumberLabels& filter, const Options& options, Messages& messages)
{
  const auto output = openOnFirstRank(options);
  FieldRun run(filter, options, messages);
  const vtkSmartPointer<vtkImageData> image = gatherImage(run);
  if (isImage(suffixOf(options.output)))
  {
    writeResult(run, image, output.get());
  }
  else
  {
    vtkNew<vtkWindingNumberVoxels> voxels;
    voxels->SetNamesInMessages(vtkWindingNumberAlgorithm::PROGRAM_NAMES);
    parallel::agreeOnFirst([&] { makeSurface(voxels, image, options, messages); });
    writeResult(run, voxels->GetOutput(), output.get());
  }
  report(run, filter, image, options);
}

} // namespace

void runLabels(const Options& options, Messages& messages)
{
  vtkNew<vtkWindingNumberLabels> filter;
  applyLabels(options, filter);
  const std::string suffix = suffixOf(options.output);
  if (suffix == ".pvti")
  {
    writePieces(*filter, options, messages);
  }
  else if (isImage(suffix) && parallel::isAlone())
  {
    writeAlone(*filter, options, messages);
  }
  else
  {
    writeWhole(*filter, options, messages);
  }
}
