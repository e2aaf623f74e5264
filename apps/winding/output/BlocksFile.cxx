// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/BlocksFile.h"

#include "output/Folder.h"
#include "output/OutputFile.h"
#include "output/TemporaryFile.h"
#include "output/WriteOutput.h"
#include "output/XmlNames.h"
#include "program/Interrupt.h"
#include "program/Messages.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"

#include <filesystem>
#include <fstream>
#include <memory>

#include <unistd.h> // access

namespace
{

/// The beginning of a file, which is all of an index; empty where there is no file.
std::string indexText(const std::string& name)
{
  std::ifstream file(name, std::ios::binary);
  std::string text(10000, ' ');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

/// Whether a text is an index that another run has left, whose blocks may be replaced.
bool isIndex(const std::string& text)
{
  return text.find("vtkMultiBlockDataSet") != std::string::npos;
}

/// How an index names a block's file.
std::string reference(const std::string& folder, const std::string& block)
{
  const std::filesystem::path path = std::filesystem::path(folder).filename() / (block + ".vtp");
  return "name=\"" + escapedForXml(block) + "\" file=\"" + escapedForXml(path.string()) + "\"";
}

/// Removes the files of blocks that an index named and another one does not name any more. Says so
/// where a file, such as a write-protected one, stays.
void removeStale(
  const std::string& folder, const std::string& before, const std::string& now, Messages& messages)
{
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
  {
    const std::string named = reference(folder, entry.path().stem().string());
    const bool isStale = entry.path().extension() == ".vtp" &&
                         before.find(named) != std::string::npos &&
                         now.find(named) == std::string::npos;
    if (isStale &&
        (access(entry.path().c_str(), W_OK) != 0 || !std::filesystem::remove(entry.path(), error)))
    {
      messages.warn("remove " + entry.path().string() +
                    " yourself, which cannot be removed: it is of an earlier run, and this one "
                    "found no such fault");
    }
  }
}

} // namespace

BlocksFile::BlocksFile(const std::string& name, const std::vector<std::string>& inputs)
  : name_(name)
  , folder_(std::filesystem::path(name).replace_extension().string())
  , inputs_(inputs)
{
  // The folder and the file go away again here: a run that is killed before it writes leaves none.
  const Folder folder(folder_, name, "blocks");
  TemporaryFile::clear(folder_);
  std::error_code error;
  if (!folder.isNew() && !std::filesystem::is_empty(folder_, error) && !isIndex(indexText(name)))
  {
    folder.refuseOtherFiles();
  }
  folder.refuseInputs(inputs);
  const OutputFile index(name, inputs);
}

void BlocksFile::write(vtkMultiBlockDataSet* blocks, Messages& messages) const
{
  const Folder folder(folder_, name_, "blocks");
  const std::string before = indexText(name_);
  std::vector<std::unique_ptr<OutputFile>> files;
  std::string index = "<?xml version=\"1.0\"?>\n<VTKFile type=\"vtkMultiBlockDataSet\" "
                      "version=\"1.0\" byte_order=\"LittleEndian\">\n  <vtkMultiBlockDataSet>\n";
  for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
  {
    auto* surface = vtkPolyData::SafeDownCast(blocks->GetBlock(i));
    if (!surface)
    {
      continue;
    }
    const std::string block = blocks->GetMetaData(i)->Get(vtkCompositeDataSet::NAME());
    const std::filesystem::path path = std::filesystem::path(folder_) / (block + ".vtp");
    files.push_back(std::make_unique<OutputFile>(path.string(), inputs_));
    writeSurface(surface, *files.back(), messages);
    index +=
      "    <DataSet index=\"" + std::to_string(i) + "\" " + reference(folder_, block) + "/>\n";
  }
  index += "  </vtkMultiBlockDataSet>\n</VTKFile>\n";
  files.push_back(std::make_unique<OutputFile>(name_, inputs_));
  std::ofstream stream(files.back()->temporaryName(), std::ios::binary);
  stream << index;
  stream.close();
  if (!stream)
  {
    files.back()->refuseWriting();
  }
  files.back()->checkIsWhole();
  interrupt::check();
  for (const auto& file : files)
  {
    file->commit();
  }
  removeStale(folder_, before, index, messages);
}
