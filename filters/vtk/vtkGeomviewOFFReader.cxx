#include "vtkGeomviewOFFReader.h"

#include "files/OffFile.h"
#include "private/output/MeshFiles.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkGeomviewOFFReader);

vtkGeomviewOFFReader::vtkGeomviewOFFReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkGeomviewOFFReader::~vtkGeomviewOFFReader()
{
  this->SetFileName(nullptr);
}

int vtkGeomviewOFFReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  return winding::readMeshFile(
    this, this->FileName, this->ErrorCode, winding::readOff, vtkPolyData::GetData(outputs));
}

void vtkGeomviewOFFReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
