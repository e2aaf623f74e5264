// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/WriteField.h"

#include "commands/FieldRun.h"
#include "files/Formats.h"
#include "options/Options.h"
#include "output/ImageFile.h"
#include "output/MeshFile.h"
#include "output/OutputFile.h"
#include "output/PiecesFile.h"
#include "output/WriteOutput.h"
#include "program/Messages.h"
#include "program/ParallelRun.h"
#include "program/Progress.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <functional>
#include <string>

namespace
{

/// Writes one file by `write` on the first rank, and notes the time.
void writeOnFirst(FieldRun& run, OutputFile* file, const std::function<void()>& write)
{
  const Stopwatch writing;
  parallel::agreeOnFirst(
    [&]
    {
      write();
      file->commit();
    });
  run.report().setWriteSeconds(writing.seconds());
}

/// Warns of arrays that were asked for and that the format of the output does not hold.
void warnOfLostArrays(vtkPolyData* surface, FieldRun& run)
{
  const Options& options = run.options();
  std::string names;
  for (const std::string& name : arraysLostIn(suffixOf(options.output), surface))
  {
    names += (names.empty() ? "" : ", ") + name;
  }
  if (!names.empty() && (options.transferAttributes || options.nearestCells))
  {
    run.messages().warn(
      options.output + ": the format does not hold " + names + "; .vtp holds all arrays");
  }
}

} // namespace

void writeField(FieldRun& run, OutputFile& file)
{
  if (isMedical(suffixOf(file.name())))
  {
    writeResult(run, vtkImageData::SafeDownCast(run.filter().GetOutputDataObject(0)), &file);
    return;
  }
  const int pieces = run.pieces();
  Progress::setPieces(pieces);
  const Progress progress(&run.filter(), Phase::evaluating, run.messages().isQuiet());
  const Stopwatch writing;
  const double before = run.executionSeconds();
  writeImage(
    run.filter().GetOutputPort(), pieces, file, run.messages(), [&run] { run.checkExecutions(); });
  file.commit();
  run.report().setWriteSeconds(writing.seconds() - (run.executionSeconds() - before));
}

void writeFieldPieces(FieldRun& run, const PiecesFile& file)
{
  const Stopwatch writing;
  const double before = run.executionSeconds();
  const auto perRank = static_cast<std::size_t>(run.options().pieces);
  const std::vector<SlabExtent> slabs =
    run.slabs(perRank * static_cast<std::size_t>(parallel::count()), true);
  // Every rank makes as many slabs, for an execution is collective. A rank's own follow each other.
  const std::size_t ranks = static_cast<std::size_t>(parallel::count());
  const std::size_t rounds = (slabs.size() + ranks - 1) / ranks;
  const std::size_t first = rounds * static_cast<std::size_t>(parallel::rank());
  Progress::setPieces(static_cast<int>(rounds));
  SlabExtent whole = slabs.front();
  whole[5] = slabs.back()[5];
  file.write(
    whole, slabs, first, rounds,
    [&](std::size_t round) { return run.makeSlab(slabs, first + round); }, run.messages());
  run.report().setWriteSeconds(writing.seconds() - (run.executionSeconds() - before));
}

vtkSmartPointer<vtkImageData> gatherImage(FieldRun& run)
{
  if (parallel::isAlone())
  {
    run.update();
    return vtkImageData::SafeDownCast(run.filter().GetOutputDataObject(0));
  }
  const std::vector<SlabExtent> slabs =
    run.slabs(static_cast<std::size_t>(parallel::count()), false);
  vtkImageData* const own = run.makeSlab(slabs, static_cast<std::size_t>(parallel::rank()));
  return gatheredImage(own, slabs);
}

void writeResult(FieldRun& run, vtkImageData* image, OutputFile* file)
{
  writeOnFirst(run, file,
    [&]
    {
      if (isMedical(suffixOf(file->name())))
      {
        // The formats have one array.
        const Options& options = run.options();
        const bool isField = options.command == "field" && !options.insideOnly;
        const std::string array = options.command == "labels" ? "Label"
                                  : isField                   ? options.array
                                                              : "Inside";
        image->GetPointData()->SetActiveScalars(array.c_str());
        writeMedicalImage(run.placed(image), *file);
      }
      else
      {
        writeImage(image, *file, run.messages());
      }
    });
}

void writeResult(FieldRun& run, vtkPolyData* surface, OutputFile* file)
{
  writeOnFirst(run, file,
    [&]
    {
      warnOfLostArrays(surface, run);
      writeSurface(surface, *file, run.messages());
      Json output = {{"file", file->name()}, {"points", surface->GetNumberOfPoints()},
        {"cells", surface->GetNumberOfCells()}};
      vtkFieldData* const facts = surface->GetFieldData();
      if (vtkDataArray* cavities = facts->GetArray("FilledCavities"))
      {
        output["filled_cavities"] = static_cast<int>(cavities->GetTuple1(0));
      }
      if (vtkDataArray* parts = facts->GetArray("Parts"))
      {
        output["closed"] = facts->GetArray("Closed")->GetTuple1(0) != 0;
        output["parts"] = static_cast<vtkIdType>(parts->GetTuple1(0));
        // NaN becomes null.
        output["volume"] = facts->GetArray("Volume")->GetTuple1(0);
        vtkDataArray* const ofInput = facts->GetArray("InputVolume");
        output["input_volume"] = ofInput ? Json(ofInput->GetTuple1(0)) : Json(nullptr);
      }
      if (vtkAbstractArray* from = facts->GetAbstractArray("DistancesFrom"))
      {
        output["distances_from"] = from->GetVariantValue(0).ToString();
      }
      run.report().setOutput(output);
      run.report().takeFidelity(surface);
    });
}
