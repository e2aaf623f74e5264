#include "input/VtkReaders.h"

#include "files/FileAccess.h"
#include "input/FileGuards.h"

#include "vtkDataSetReader.h"
#include "vtkPLYReader.h"
#include "vtkPointSet.h"
#include "vtkSTLReader.h"
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

vtkSmartPointer<vtkAlgorithm> stl(const std::string& fileName)
{
  guardStl(fileName);
  const auto reader = vtkSmartPointer<vtkSTLReader>::New();
  reader->SetFileName(fileName.c_str());
  reader->MergingOff(); // the filters weld, and count what they weld
  return reader;
}

vtkSmartPointer<vtkAlgorithm> ply(const std::string& fileName)
{
  guardPly(fileName);
  const auto reader = vtkSmartPointer<vtkPLYReader>::New();
  // VTK crashes on text whose last line has no end; bytes after the last item do no harm.
  reader->ReadFromInputStringOn();
  reader->SetInputString(contentsOf(fileName) + "\n");
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
  {".ply", ply, nullptr},
  {".stl", stl, nullptr},
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
