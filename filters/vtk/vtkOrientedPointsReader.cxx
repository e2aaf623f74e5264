#include "vtkOrientedPointsReader.h"

#include "files/PointsFile.h"
#include "private/output/MeshFiles.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkOrientedPointsReader);

vtkOrientedPointsReader::vtkOrientedPointsReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkOrientedPointsReader::~vtkOrientedPointsReader()
{
  this->SetFileName(nullptr);
}

int vtkOrientedPointsReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  return winding::readMeshFile(
    this, this->FileName, this->ErrorCode, winding::readPoints, vtkPolyData::GetData(outputs));
}

void vtkOrientedPointsReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
