// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/Formats.h"

#include "files/GltfReader.h"
#include "files/LegacyVtkReader.h"
#include "files/LoadedReaders.h"
#include "files/Text.h"
#include "program/Failure.h"

#include "vtkWindingNumberReader.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLMultiBlockDataReader.h"
#include "vtkXMLPPolyDataReader.h"
#include "vtkXMLPUnstructuredGridReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLRectilinearGridReader.h"
#include "vtkXMLStructuredGridReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <filesystem>

#include <dlfcn.h>

namespace
{

template <class Reader> vtkSmartPointer<vtkAlgorithm> plain(const std::string& fileName)
{
  const auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(fileName.c_str());
  return reader;
}

/// Makes a reader of the library that is loaded for it, and stays loaded.
vtkSmartPointer<vtkAlgorithm> loaded(const std::string& fileName)
{
  void* const library = dlopen(loadedReaders, RTLD_NOW | RTLD_LOCAL);
  const auto make = library ? reinterpret_cast<ReaderMaker>(dlsym(library, readerMaker)) : nullptr;
  if (!make)
  {
    throw Failure(EXIT_REFUSED, fileName,
      std::string("cannot be read here: the library ") + loadedReaders +
        " of winding is missing; install it anew, or save the file as .vtp or .ply");
  }
  auto reader =
    vtkSmartPointer<vtkAlgorithm>::Take(make(suffixOf(fileName).c_str(), fileName.c_str()));
  if (!reader)
  {
    throw Failure(EXIT_REFUSED, fileName,
      "cannot be read here: this VTK has no reader of VTKHDF; save it as .vtp or .vtu");
  }
  return reader;
}

constexpr VtkFormat formats[] = {
  {".vtp", true, plain<vtkXMLPolyDataReader>},
  {".vtk", true, plain<LegacyVtkReader>},
  {".vtu", true, plain<vtkXMLUnstructuredGridReader>},
  {".vtm", true, plain<vtkXMLMultiBlockDataReader>},
  {".pvtp", true, plain<vtkXMLPPolyDataReader>},
  {".pvtu", true, plain<vtkXMLPUnstructuredGridReader>},
  {".vtkhdf", true, loaded},
  {".gltf", true, plain<GltfReader>},
  {".glb", true, plain<GltfReader>},
  {".3mf", true, loaded},
  {".vti", false, plain<vtkXMLImageDataReader>},
  {".vtr", false, plain<vtkXMLRectilinearGridReader>},
  {".vts", false, plain<vtkXMLStructuredGridReader>},
};

/// The suffixes of VTK's formats that may hold a source, or may not, each with a blank behind it.
std::string suffixesWhere(bool isSource)
{
  std::string suffixes;
  for (const VtkFormat& format : formats)
  {
    suffixes += format.isSource == isSource ? format.suffix + std::string(" ") : "";
  }
  return suffixes;
}

} // namespace

std::string suffixOf(const std::string& fileName)
{
  const std::filesystem::path path(fileName);
  const std::string suffix = inSmallLetters(path.extension().string());
  const bool isPacked =
    suffix == ".gz" && inSmallLetters(path.stem().extension().string()) == ".nii";
  return isPacked ? ".nii.gz" : suffix;
}

std::string unpackedName(const std::string& fileName)
{
  const std::string packed = ".gz";
  const std::string rest = fileName.substr(0, fileName.size() - packed.size());
  return suffixOf(fileName) == packed && !vtkFormatOf(suffixOf(rest)) ? rest : fileName;
}

bool isTable(const std::string& fileName)
{
  const std::string suffix = suffixOf(fileName);
  return suffix == ".csv" || suffix == ".tsv";
}

bool hasColumns(const std::string& fileName)
{
  const std::string name = unpackedName(fileName), suffix = suffixOf(name);
  return isTable(name) || suffix == ".xyz" || suffix == ".pwn";
}

char separatorOf(const std::string& fileName)
{
  return suffixOf(fileName) == ".tsv" ? '\t' : ',';
}

const VtkFormat* vtkFormatOf(const std::string& suffix)
{
  for (const VtkFormat& format : formats)
  {
    if (suffix == format.suffix)
    {
      return &format;
    }
  }
  return nullptr;
}

std::string inputSuffixes()
{
  return suffixesWhere(true) + vtkWindingNumberReader::GetFileExtensions();
}

std::string imageSuffixes()
{
  return suffixesWhere(false) + ".mha .mhd .nrrd .nhdr .nii .nii.gz";
}
