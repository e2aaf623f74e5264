// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/PieceFiles.h"

#include "files/Formats.h"
#include "files/Text.h"
#include "input/GltfUris.h"
#include "input/ImageHeader.h"
#include "program/Failure.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkXMLParser.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace
{

using Names = std::vector<std::string>;

constexpr std::size_t mostParts = 1000000;
constexpr int mostLevels = 100;

/// Collects the names of files in an index of VTK's XML formats.
class IndexParser : public vtkXMLParser
{
public:
  static IndexParser* New();
  vtkTypeMacro(IndexParser, vtkXMLParser);

  Names names;

protected:
  void StartElement(const char* element, const char** attributes) override
  {
    const std::string_view kind = element;
    const std::string_view wanted = kind == "DataSet" ? "file" : kind == "Piece" ? "Source" : "";
    for (; *attributes; attributes += 2)
    {
      if (wanted == attributes[0])
      {
        names.emplace_back(attributes[1]);
      }
    }
  }
  void EndElement(const char*) override {}
  void ReportXmlParseError() override {} // the reader reports it
};

vtkStandardNewMacro(IndexParser);

Names namesInIndex(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  vtkNew<IndexParser> parser;
  parser->SetStream(&file);
  parser->Parse();
  return parser->names;
}

/// Returns the names of external files in glTF. tinygltf reads a plus sign as a blank.
Names namesInGltf(const std::string& fileName)
{
  Names names = urisInGltf(fileName);
  for (std::string& name : names)
  {
    std::replace(name.begin(), name.end(), '+', ' ');
    name = withoutPercentCodes(name);
  }
  return names;
}

Names namesIn(const std::string& fileName)
{
  std::error_code error;
  const std::string suffix = suffixOf(fileName);
  const auto isOneOf = [&suffix](std::string_view suffixes)
  {
    return !suffix.empty() && suffixes.find(suffix + ' ') != std::string_view::npos;
  };
  if (!std::filesystem::is_regular_file(fileName, error))
  {
    return {};
  }
  if (isOneOf(".vtm .vtmb .vtpc .vtpd .vthb .pvd .pvtp .pvtu .pvti .pvtr .pvts .pvtt "))
  {
    return namesInIndex(fileName);
  }
  if (isOneOf(".gltf .glb "))
  {
    return namesInGltf(fileName);
  }
  return isOneOf(".mha .mhd .nrrd .nhdr ") ? voxelFilesOf(fileName) : Names();
}

/// Knows files by their folder's place and their name there, however they are spelled. Links to
/// files stay apart, as their parts lie next to the link.
class KnownFiles
{
public:
  /// Returns whether `file` is new.
  bool add(const std::filesystem::path& file)
  {
    const std::filesystem::path folder = file.parent_path();
    const auto [place, isNew] = placesOfFolders_.try_emplace(folder.string());
    if (isNew)
    {
      std::error_code error;
      const std::filesystem::path found =
        std::filesystem::canonical(folder.empty() ? "." : folder, error);
      place->second = error ? folder : found; // files in missing folders name no others
    }
    return files_.insert((place->second / file.filename()).string()).second;
  }

private:
  std::unordered_map<std::string, std::filesystem::path> placesOfFolders_;
  std::unordered_set<std::string> files_;
};

} // namespace

std::vector<Piece> piecesOf(const std::string& fileName)
{
  std::vector<Piece> pieces;
  KnownFiles known;
  known.add(fileName);
  const auto add = [&](const std::string& index)
  {
    const VtkFormat* const format = vtkFormatOf(suffixOf(index));
    const bool isRequired = format && suffixOf(index) != ".gltf" && suffixOf(index) != ".glb";
    for (const std::string& name : namesIn(index))
    {
      const std::filesystem::path piece = std::filesystem::path(index).parent_path() / name;
      if (known.add(piece))
      {
        pieces.push_back({piece.string(), isRequired});
      }
      if (pieces.size() > mostParts)
      {
        throw Failure(EXIT_REFUSED, fileName,
          "has more than " + std::to_string(mostParts) + " parts; give some of them");
      }
    }
  };
  add(fileName);
  std::size_t done = 0;
  for (int level = 1; done < pieces.size(); ++level)
  {
    if (level > mostLevels)
    {
      throw Failure(EXIT_REFUSED, fileName,
        "has parts of parts, " + std::to_string(level) + " deep; give one that is less deep");
    }
    for (const std::size_t end = pieces.size(); done < end; ++done)
    {
      add(std::string(pieces[done].file));
    }
  }
  return pieces;
}

void checkPieces(const std::string& fileName, const std::vector<Piece>& pieces)
{
  for (const Piece& piece : pieces)
  {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(piece.file, error);
    const bool isThere = std::filesystem::exists(status);
    if (!isThere ? piece.isRequired : std::filesystem::is_other(status))
    {
      const std::filesystem::path folder = std::filesystem::path(fileName).parent_path();
      const std::string name = std::filesystem::path(piece.file).lexically_proximate(folder);
      throw Failure(EXIT_REFUSED, fileName,
        "its part " + name + ' ' +
          (isThere ? specialFile : "is not there; put all of its files there"));
    }
  }
}
