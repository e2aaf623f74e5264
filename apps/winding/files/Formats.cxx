#include "files/Formats.h"

#include "files/Text.h"

#include "vtkDataSetReader.h"
#include "vtkGLTFReader.h"
#include "vtkSourceReader.h"
#include "vtkXMLMultiBlockDataReader.h"
#include "vtkXMLPPolyDataReader.h"
#include "vtkXMLPUnstructuredGridReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <filesystem>

namespace
{

template <class Reader> vtkSmartPointer<vtkAlgorithm> plain(const std::string& fileName)
{
  const auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(fileName.c_str());
  return reader;
}

vtkSmartPointer<vtkAlgorithm> legacyVtk(const std::string& fileName)
{
  const auto reader = vtkSmartPointer<vtkDataSetReader>::New();
  reader->SetFileName(fileName.c_str());
  // By default the reader takes the first array of each kind only.
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllFieldsOn();
  return reader;
}

vtkSmartPointer<vtkAlgorithm> gltf(const std::string& fileName)
{
  const auto reader = vtkSmartPointer<vtkGLTFReader>::New();
  reader->SetFileName(fileName.c_str());
  reader->ApplyDeformationsToGeometryOn(); // and the places of nodes
  return reader;
}

constexpr VtkFormat formats[] = {
  {".vtp", plain<vtkXMLPolyDataReader>},
  {".vtk", legacyVtk},
  {".vtu", plain<vtkXMLUnstructuredGridReader>},
  {".vtm", plain<vtkXMLMultiBlockDataReader>},
  {".pvtp", plain<vtkXMLPPolyDataReader>},
  {".pvtu", plain<vtkXMLPUnstructuredGridReader>},
  {".gltf", gltf},
  {".glb", gltf},
};

} // namespace

std::string suffixOf(const std::string& fileName)
{
  return inSmallLetters(std::filesystem::path(fileName).extension().string());
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
  std::string suffixes;
  for (const VtkFormat& format : formats)
  {
    suffixes += format.suffix + std::string(" ");
  }
  return suffixes + vtkSourceReader::GetFileExtensions();
}
