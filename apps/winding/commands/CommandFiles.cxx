// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/CommandFiles.h"

#include "files/Formats.h"
#include "files/Text.h"
#include "input/PieceFiles.h"
#include "input/ReadInput.h"
#include "options/Options.h"
#include "output/OutputFile.h"
#include "program/Failure.h"
#include "program/Messages.h"
#include "program/ParallelRun.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkWindingNumberAlgorithm.h"
#include "vtkWindingNumberImageAlgorithm.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace
{

/// Reads a file on the first rank; the others get a data set without points.
vtkSmartPointer<vtkDataObject> readOnFirstRank(
  const std::string& fileName, const Options& options, Messages& messages)
{
  vtkSmartPointer<vtkDataObject> data = vtkSmartPointer<vtkPolyData>::New();
  parallel::agreeOnFirst(
    [&] {
      data = readInput(fileName, messages, {options.columns, options.transferAttributes});
    });
  return data;
}

/// Throws Failure, with the name of its file, for an image that no result can lie on.
void checkLike(vtkImageData* image, const std::string& fileName)
{
  if (image->GetNumberOfPoints() == 0)
  {
    throw Failure(EXIT_REFUSED, fileName, "has no voxels to lie on; give another image");
  }
  if (!vtkWindingNumberImageAlgorithm::HasRightAngles(image))
  {
    throw Failure(EXIT_REFUSED, fileName,
      "its axes are not at right angles; resample it first, or probe it instead (winding probe)");
  }
}

/// Gives all ranks the place of an image that the first one has. Collective.
void shareFirst(vtkImageData* image)
{
  struct
  {
    int extent[6];
    double origin[3], spacing[3], directions[9];
  } place = {};
  if (parallel::isFirst())
  {
    image->GetExtent(place.extent);
    image->GetOrigin(place.origin);
    image->GetSpacing(place.spacing);
    std::copy_n(image->GetDirectionMatrix()->GetData(), 9, place.directions);
    for (int rank = 1; rank < parallel::count(); ++rank)
    {
      parallel::send(&place, sizeof place, rank);
    }
    return;
  }
  parallel::receive(&place, sizeof place, 0);
  image->SetExtent(place.extent);
  image->SetOrigin(place.origin);
  image->SetSpacing(place.spacing);
  image->SetDirectionMatrix(place.directions);
}

} // namespace

std::vector<std::string> filesToKeep(const Options& options)
{
  if (options.overwrite)
  {
    return {};
  }
  std::vector<std::string> files = options.inputs;
  for (const std::string& file : {options.queries, options.towardFile, options.like})
  {
    if (!file.empty())
    {
      files.push_back(file);
    }
  }
  for (const std::string& file : std::vector<std::string>(files))
  {
    for (const Piece& piece : piecesOf(file))
    {
      files.push_back(piece.file);
    }
  }
  return files;
}

PlacedImage readLike(const Options& options, Messages& messages)
{
  PlacedImage place;
  if (options.like.empty())
  {
    return place;
  }
  parallel::agreeOnFirst(
    [&]
    {
      place = readPlace(options.like, messages);
      checkLike(place.image, options.like);
    });
  if (!parallel::isFirst())
  {
    place.image = vtkSmartPointer<vtkImageData>::New();
  }
  shareFirst(place.image);
  return place;
}

std::unique_ptr<OutputFile> openOnFirstRank(const Options& options)
{
  std::unique_ptr<OutputFile> file;
  parallel::agreeOnFirst(
    [&] { file = std::make_unique<OutputFile>(options.output, filesToKeep(options)); });
  return file;
}

void readToward(Options& options, Messages& messages)
{
  if (options.towardFile.empty())
  {
    return;
  }
  const auto positions = readPoints(options.towardFile, messages);
  for (vtkIdType i = 0; i < positions->GetNumberOfPoints(); ++i)
  {
    const double* const position = positions->GetPoint(i);
    if (std::all_of(position, position + 3, [](double at) { return std::isfinite(at); }))
    {
      options.toward += (options.toward.empty() ? "" : ";") + exact(position, ' ');
    }
  }
  if (options.toward.empty())
  {
    throw Failure(EXIT_REFUSED, options.towardFile, "has no positions; give some");
  }
}

vtkSmartPointer<vtkDataObject> readSource(const Options& options, Messages& messages)
{
  const std::vector<std::string>& files = options.inputs;
  if (files.size() == 1)
  {
    return readOnFirstRank(files[0], options, messages);
  }
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (const std::string& file : files)
  {
    const unsigned int block = blocks->GetNumberOfBlocks();
    blocks->SetBlock(block, readOnFirstRank(file, options, messages));
    blocks->GetMetaData(block)->Set(
      vtkCompositeDataSet::NAME(), std::filesystem::path(unpackedName(file)).stem().c_str());
  }
  messages.setSubject(options.input); // what follows is about all of them
  const std::string advice = vtkWindingNumberAlgorithm::GetUnitAdvice(blocks);
  if (!advice.empty())
  {
    messages.warn(advice);
  }
  return blocks;
}
