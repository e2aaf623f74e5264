#include "input/VtkReaders.h"

#include "input/LegacyVtkCounts.h"

#include "vtkDataSetReader.h"
#include "vtkPointSet.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

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

constexpr VtkFormat formats[] = {
  {".vtp", plain<vtkXMLPolyDataReader>, nullptr},
  {".vtu", plain<vtkXMLUnstructuredGridReader>, nullptr},
  {".vtk", legacyVtk, checkLegacyVtkCounts},
};

} // namespace

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
