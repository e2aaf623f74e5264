#include "vtkSurfaceMeshReader.h"

#include "files/ObjFile.h"
#include "files/PlyFile.h"
#include "files/StlFile.h"
#include "private/output/MeshFiles.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkSurfaceMeshReader);

namespace
{

/// Reads the format that the suffix of the file's name says.
winding::MeshArrays readBySuffix(const winding::InputFile& file, winding::Executor& executor)
{
  const std::string suffix = winding::suffixOf(file);
  if (suffix == ".obj")
  {
    return winding::readObj(file, executor);
  }
  if (suffix == ".ply")
  {
    return winding::readPly(file, executor);
  }
  if (suffix == ".stl")
  {
    return winding::readStl(file, executor);
  }
  file.refuse("has a suffix that is not known; give one of .obj .ply .stl");
}

} // namespace

vtkSurfaceMeshReader::vtkSurfaceMeshReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkSurfaceMeshReader::~vtkSurfaceMeshReader()
{
  this->SetFileName(nullptr);
}

int vtkSurfaceMeshReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  return winding::readMeshFile(
    this, this->FileName, this->ErrorCode, readBySuffix, vtkPolyData::GetData(outputs));
}

void vtkSurfaceMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
