#include "vtkWindingNumberProbe.h"

#include "messages/PropertyChecks.h"
#include "private/output/ResultArrays.h"
#include "private/probe/InsidePart.h"
#include "private/probe/ProbeQueries.h"
#include "private/probe/ProbeWords.h"
#include "private/source/ContentHash.h"
#include "private/source/SourceProperties.h"

#include "vtkDataSetAttributes.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkWindingNumberProbe);

vtkWindingNumberProbe::vtkWindingNumberProbe()
{
  this->SetResultArrayName("WindingNumber");
  this->SetInsideArrayName("Inside");
}

vtkWindingNumberProbe::~vtkWindingNumberProbe()
{
  this->SetResultArrayName(nullptr);
  this->SetInsideArrayName(nullptr);
}

vtkSmartPointer<vtkDataObject> vtkWindingNumberProbe::NewOutput(vtkDataObject* input) const
{
  if (this->ExtractInside && vtkPolyData::SafeDownCast(input))
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  if (this->ExtractInside && vtkDataSet::SafeDownCast(input))
  {
    return vtkSmartPointer<vtkUnstructuredGrid>::New();
  }
  return this->Superclass::NewOutput(input);
}

const winding::ProbeWords& vtkWindingNumberProbe::GetWords() const
{
  return winding::wordsOfProbe;
}

void vtkWindingNumberProbe::CheckProperties()
{
  this->Superclass::CheckProperties();
  winding::checkProperty(winding::Parameter::probeAssociation, this->ProbeAssociation);
  winding::checkProperty(winding::Parameter::outputScalarType, this->OutputScalarType);
}

winding::ResultOptions vtkWindingNumberProbe::GetResultOptions() const
{
  winding::ResultOptions options;
  options.withValues = this->GenerateWindingNumber != 0;
  options.withInside = this->GenerateInside != 0;
  options.withDistances = this->WantsDistances();
  options.scalarType = this->OutputScalarType;
  options.name = winding::textOf(this->ResultArrayName);
  const std::string insideName = winding::textOf(this->InsideArrayName);
  options.insideName = insideName.empty() ? "Inside" : insideName;
  return options;
}

void vtkWindingNumberProbe::AddArrays(
  const winding::ResultArrays& results, vtkDataSetAttributes* ofAll) const
{
  results.addTo(ofAll);
  if (!this->GenerateInside)
  {
    ofAll->RemoveArray(results.inside()->GetName());
  }
}

vtkSmartPointer<vtkDataSet> vtkWindingNumberProbe::PartOf(
  vtkDataSet* data, const winding::ProbeLeaf&, const unsigned char* inside)
{
  return winding::insidePart(data, inside, this->SamplesCells());
}

void vtkWindingNumberProbe::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ProbeAssociation: " << this->ProbeAssociation << "\n";
  os << indent << "GenerateWindingNumber: " << this->GenerateWindingNumber << "\n";
  os << indent << "GenerateInside: " << this->GenerateInside << "\n";
  os << indent << "GenerateSignedDistance: " << this->GenerateSignedDistance << "\n";
  os << indent << "ResultArrayName: " << winding::textOf(this->ResultArrayName) << "\n";
  os << indent << "OutputScalarType: " << this->OutputScalarType << "\n";
  os << indent << "ExtractInside: " << this->ExtractInside << "\n";
  os << indent << "InsideArrayName: " << winding::textOf(this->InsideArrayName) << "\n";
}
