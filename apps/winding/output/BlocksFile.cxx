#include "output/BlocksFile.h"

#include "output/OutputFile.h"
#include "output/WriteOutput.h"
#include "program/Failure.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"

#include <filesystem>
#include <fstream>

namespace
{

/// Text for an attribute of XML.
std::string escaped(const std::string& text)
{
  std::string result;
  for (const char c : text)
  {
    switch (c)
    {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
    }
  }
  return result;
}

/// Whether a file is an index that another run has left, whose blocks may be replaced.
bool isIndex(const std::string& name)
{
  std::ifstream file(name, std::ios::binary);
  std::string text(200, ' ');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  return text.find("vtkMultiBlockDataSet") != std::string::npos;
}

} // namespace

BlocksFile::BlocksFile(const std::string& name)
  : name_(name)
{
  std::filesystem::path folder(name);
  folder.replace_extension();
  folder_ = folder.string();
  std::error_code error;
  isNew_ = std::filesystem::create_directory(folder, error);
  if (error || !std::filesystem::is_directory(folder))
  {
    throw Failure(REFUSED, name,
      "needs the folder " + folder_ + " for its blocks, which cannot be made: " + error.message() +
        "; give another name");
  }
  if (!isNew_ && !std::filesystem::is_empty(folder, error) && !isIndex(name))
  {
    throw Failure(REFUSED, name,
      "needs the folder " + folder_ +
        " for its blocks, which is there and holds other files; give another name");
  }
  try
  {
    const OutputFile probe(name); // whether the index could be written
  }
  catch (...)
  {
    this->removeFolder();
    throw;
  }
}

BlocksFile::~BlocksFile()
{
  this->removeFolder();
}

void BlocksFile::removeFolder() const
{
  if (isNew_)
  {
    std::error_code error;
    std::filesystem::remove(folder_, error); // a folder that has files stays
  }
}

void BlocksFile::write(vtkMultiBlockDataSet* blocks, Messages& messages) const
{
  const std::filesystem::path folder(folder_);
  std::string index = "<?xml version=\"1.0\"?>\n<VTKFile type=\"vtkMultiBlockDataSet\" "
                      "version=\"1.0\" byte_order=\"LittleEndian\">\n  <vtkMultiBlockDataSet>\n";
  for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
  {
    const std::string block = blocks->GetMetaData(i)->Get(vtkCompositeDataSet::NAME());
    const std::string file = block + ".vtp";
    OutputFile output((folder / file).string());
    writeSurface(vtkPolyData::SafeDownCast(blocks->GetBlock(i)), output, messages);
    index += "    <DataSet index=\"" + std::to_string(i) + "\" name=\"" + escaped(block) +
             "\" file=\"" + escaped((folder.filename() / file).string()) + "\"/>\n";
  }
  index += "  </vtkMultiBlockDataSet>\n</VTKFile>\n";
  OutputFile output(name_);
  std::ofstream stream(output.temporaryName(), std::ios::binary);
  stream << index;
  stream.close();
  if (!stream)
  {
    output.refuseWriting();
  }
  output.commit();
}
