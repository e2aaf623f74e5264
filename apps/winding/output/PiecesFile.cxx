// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/PiecesFile.h"

#include "files/Text.h"
#include "output/Folder.h"
#include "output/OutputFile.h"
#include "output/TemporaryFile.h"
#include "output/WriteOutput.h"
#include "output/XmlNames.h"
#include "program/Interrupt.h"
#include "program/ParallelRun.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>

namespace
{

std::string textOf(const int (&extent)[6])
{
  std::string text;
  for (const int number : extent)
  {
    text += (text.empty() ? "" : " ") + std::to_string(number);
  }
  return text;
}

std::string textOf(const PiecesFile::Extent& extent)
{
  int numbers[6];
  std::copy(extent.begin(), extent.end(), numbers);
  return textOf(numbers);
}

const char* typeInXml(vtkDataArray* array)
{
  switch (array->GetDataType())
  {
  case VTK_DOUBLE:
    return "Float64";
  case VTK_UNSIGNED_CHAR:
    return "UInt8";
  case VTK_UNSIGNED_SHORT:
    return "UInt16";
  case VTK_INT:
    return "Int32";
  case VTK_ID_TYPE:
    return sizeof(vtkIdType) == sizeof(int) ? "Int32" : "Int64";
  default:
    return "Float32";
  }
}

std::string describe(vtkDataSetAttributes* arrays, const std::string& element)
{
  vtkDataArray* const scalars = arrays->GetScalars();
  std::string text = "    <" + element;
  if (scalars)
  {
    text += " Scalars=\"" + escapedForXml(scalars->GetName()) + "\"";
  }
  text += ">\n";
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = arrays->GetArray(i);
    text += std::string("      <PDataArray type=\"") + typeInXml(array) + "\" Name=\"" +
            escapedForXml(array->GetName()) + "\"/>\n";
  }
  return text + "    </" + element + ">\n";
}

/// The number of a piece by the name of its file, which is the folder's and the number.
std::optional<std::size_t> numberOfPiece(
  const std::filesystem::path& file, const std::string& folderName)
{
  const std::string stem = file.stem().string(), start = folderName + "_";
  const std::string digits = stem.rfind(start, 0) == 0 ? stem.substr(start.size()) : "";
  const bool isNumber = !digits.empty() && digits.size() < 10 &&
                        digits.find_first_not_of("0123456789") == std::string::npos;
  if (!isNumber || file.extension() != ".vti")
  {
    return {};
  }
  return std::strtoul(digits.c_str(), nullptr, 10);
}

/// Returns whether a folder holds nothing but pieces of an earlier run.
bool hasPiecesOnly(const std::filesystem::path& folder)
{
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
  {
    if (!numberOfPiece(entry->path(), folder.filename().string()))
    {
      return false;
    }
  }
  return !error;
}

} // namespace

PiecesFile::PiecesFile(const std::string& name, const std::vector<std::string>& inputs)
  : name_(name)
  , folder_(std::filesystem::path(name).replace_extension().string())
  , inputs_(inputs)
{
  parallel::agreeOnFirst(
    [this]
    {
      // The folder and the file go away again: a run that is killed before it writes leaves none.
      const Folder folder(folder_, name_, "pieces");
      TemporaryFile::clear(folder_);
      if (!hasPiecesOnly(folder_))
      {
        folder.refuseOtherFiles();
      }
      folder.refuseInputs(inputs_);
      const OutputFile index(name_, inputs_);
    });
}

void PiecesFile::write(const Extent& whole, const std::vector<Extent>& pieces,
  std::size_t firstPiece, std::size_t rounds, const MakePiece& makePiece, Messages& messages) const
{
  std::unique_ptr<Folder> folder;
  std::vector<std::unique_ptr<OutputFile>> files;
  std::string text;
  try
  {
    parallel::agreeOnFirst([&] { folder = std::make_unique<Folder>(folder_, name_, "pieces"); });
    for (std::size_t round = 0; round < rounds; ++round)
    {
      vtkImageData* const image = makePiece(round);
      parallel::agree(
        [&]
        {
          if (image)
          {
            files.push_back(
              std::make_unique<OutputFile>(this->pieceName(firstPiece + round), inputs_));
            writeImage(image, *files.back(), messages);
          }
          if (parallel::isFirst() && round == 0)
          {
            text = this->index(whole, pieces, image);
          }
        });
    }
    std::unique_ptr<OutputFile> indexFile;
    parallel::agreeOnFirst(
      [&]
      {
        indexFile = std::make_unique<OutputFile>(name_, inputs_);
        std::ofstream stream(indexFile->temporaryName(), std::ios::binary);
        stream << text;
        stream.close();
        if (!stream)
        {
          indexFile->refuseWriting();
        }
        indexFile->checkIsWhole();
        interrupt::check();
        std::error_code error;
        std::filesystem::remove(name_, error); // commit() reports where that is not allowed
      });
    parallel::agree(
      [&]
      {
        for (const auto& file : files)
        {
          file->commit();
        }
      });
    parallel::agreeOnFirst(
      [&]
      {
        indexFile->commit();
        this->removeLaterPieces(pieces.size());
      });
  }
  catch (const AgreedFailure&)
  {
    files.clear();
    parallel::barrier(); // the folder is removed when the files of all ranks are
    throw;
  }
}

std::string PiecesFile::pieceName(std::size_t number) const
{
  const std::filesystem::path folder(folder_);
  return (folder / (folder.filename().string() + "_" + std::to_string(number) + ".vti")).string();
}

std::string PiecesFile::index(
  const Extent& whole, const std::vector<Extent>& pieces, vtkImageData* image) const
{
  double origin[3], spacing[3];
  image->GetOrigin(origin);
  image->GetSpacing(spacing);
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PImageData\" version=\"1.0\" "
                     "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n  <PImageData "
                     "WholeExtent=\"" +
                     textOf(whole) + "\" GhostLevel=\"0\" Origin=\"" + exact(origin, ' ') +
                     "\" Spacing=\"" + exact(spacing, ' ') + "\">\n";
  text += describe(image->GetPointData(), "PPointData");
  text += describe(image->GetCellData(), "PCellData");
  for (std::size_t n = 0; n < pieces.size(); ++n)
  {
    const std::filesystem::path path(this->pieceName(n));
    const std::string relative = (path.parent_path().filename() / path.filename()).string();
    text += "    <Piece Extent=\"" + textOf(pieces[n]) + "\" Source=\"" + escapedForXml(relative) +
            "\"/>\n";
  }
  return text + "  </PImageData>\n</VTKFile>\n";
}

/// Removes pieces that an earlier run has left and that the index does not name.
void PiecesFile::removeLaterPieces(std::size_t count) const
{
  const std::filesystem::path folder(folder_);
  std::vector<std::filesystem::path> later;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
  {
    const auto number = numberOfPiece(entry->path(), folder.filename().string());
    if (number && *number >= count)
    {
      later.push_back(entry->path());
    }
  }
  for (const std::filesystem::path& path : later)
  {
    std::filesystem::remove(path, error);
  }
}
