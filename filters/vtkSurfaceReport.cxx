#include "vtkSurfaceReport.h"

#include "InputViews.h"
#include "Refusal.h"
#include "SmpExecutor.h"
#include "SourceParts.h"
#include "SourceReport.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <new>

vtkStandardNewMacro(vtkSurfaceReport);

vtkSurfaceReport::vtkSurfaceReport() = default;

vtkSurfaceReport::~vtkSurfaceReport()
{
  this->SetNormalsArray(nullptr);
}

int vtkSurfaceReport::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkSurfaceReport::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  winding::askForAll(inputs[0]->GetInformationObject(0));
  return 1;
}

int vtkSurfaceReport::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Report->Initialize();
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  if (outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1;
  }
  vtkDataObject* source = vtkDataObject::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outInfo);
  winding::InputOptions options;
  options.estimateNormals = true; // points without any are no error: the report says so
  options.normalsArray = this->NormalsArray ? this->NormalsArray : "";
  try
  {
    winding::SmpExecutor executor(this, 0);
    winding::InputViews views(source, options);
    this->Report->ShallowCopy(winding::reportOn(views, executor));
    output->ShallowCopy(winding::asPolyData(source));
  }
  catch (const winding::Interrupted&)
  {
    return 1;
  }
  catch (const winding::Refusal& refusal)
  {
    vtkErrorMacro(<< refusal.what());
    return 0;
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorMacro(<< "there is not enough memory to look at this source; look at a part of it");
    return 0;
  }
  for (int i = 0; i < this->Report->GetNumberOfArrays(); ++i)
  {
    output->GetFieldData()->AddArray(this->Report->GetAbstractArray(i));
  }
  return 1;
}

vtkFieldData* vtkSurfaceReport::GetReport()
{
  return this->Report;
}

double vtkSurfaceReport::GetNumber(const char* name)
{
  vtkDataArray* array = this->Report->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 ? array->GetTuple1(0) : 0;
}

vtkIdType vtkSurfaceReport::GetCount(const char* name)
{
  return static_cast<vtkIdType>(this->GetNumber(name)); // a double holds what fits into memory
}

const char* vtkSurfaceReport::GetAdvice()
{
  auto* advice = vtkStringArray::SafeDownCast(this->Report->GetAbstractArray("advice"));
  return advice ? advice->GetValue(0).c_str() : "";
}

bool vtkSurfaceReport::GetSourceIsSurface()
{
  return this->Report->HasArray("triangles");
}

bool vtkSurfaceReport::GetClosed()
{
  return this->GetNumber("closed") != 0;
}

vtkIdType vtkSurfaceReport::GetNumberOfTriangles()
{
  return this->GetCount("triangles");
}

vtkIdType vtkSurfaceReport::GetNumberOfBoundaryEdges()
{
  return this->GetCount("boundary_edges");
}

vtkIdType vtkSurfaceReport::GetNumberOfBoundaryLoops()
{
  return this->GetCount("boundary_loops");
}

vtkIdType vtkSurfaceReport::GetNumberOfNonManifoldEdges()
{
  return this->GetCount("nonmanifold_edges");
}

vtkIdType vtkSurfaceReport::GetNumberOfInconsistentEdges()
{
  return this->GetCount("inconsistent_edges");
}

vtkIdType vtkSurfaceReport::GetNumberOfComponents()
{
  return this->GetCount("components_edge");
}

vtkIdType vtkSurfaceReport::GetNumberOfDuplicateFaces()
{
  return this->GetCount("duplicate_faces");
}

double vtkSurfaceReport::GetVolume()
{
  return this->GetNumber("volume");
}

double vtkSurfaceReport::GetArea()
{
  return this->GetNumber("area");
}

vtkIdType vtkSurfaceReport::GetNumberOfPoints()
{
  return this->GetCount("points");
}

vtkIdType vtkSurfaceReport::GetNumberOfDuplicatePoints()
{
  return this->GetCount("duplicates");
}

vtkIdType vtkSurfaceReport::GetNumberOfZeroNormals()
{
  return this->GetCount("zero_normals");
}

bool vtkSurfaceReport::GetHasNormals()
{
  return this->GetNumber("normals") != 0;
}

double vtkSurfaceReport::GetMedianSpacing()
{
  return this->GetNumber("spacing_median");
}

double vtkSurfaceReport::GetOppositeNeighbors()
{
  return this->GetNumber("opposite_neighbors");
}

double vtkSurfaceReport::GetOutwardShare()
{
  return this->GetNumber("outward_share");
}

double vtkSurfaceReport::GetInwardShare()
{
  return this->GetNumber("inward_share");
}

vtkIdType vtkSurfaceReport::GetNumberOfNonFinite()
{
  return this->GetCount("non_finite");
}

void vtkSurfaceReport::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NormalsArray: " << (this->NormalsArray ? this->NormalsArray : "") << "\n";
  os << indent << "Advice: " << this->GetAdvice() << "\n";
}
