#include "vtkWindingNumberProbe.h"

#include "Field.h"
#include "ResultArrays.h"
#include "SmpExecutor.h"
#include "SourceParts.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <vector>

namespace
{

std::vector<double> pointsOf(vtkDataSet* queries)
{
  std::vector<double> positions(3 * static_cast<std::size_t>(queries->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < queries->GetNumberOfPoints(); ++i)
  {
    queries->GetPoint(i, &positions[3 * static_cast<std::size_t>(i)]);
  }
  return positions;
}

std::vector<double> cellCentersOf(vtkDataSet* queries)
{
  std::vector<double> positions(3 * static_cast<std::size_t>(queries->GetNumberOfCells()));
  std::vector<double> weights(static_cast<std::size_t>(queries->GetMaxCellSize()));
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType i = 0; i < queries->GetNumberOfCells(); ++i)
  {
    queries->GetCell(i, cell);
    double* center = &positions[3 * static_cast<std::size_t>(i)];
    if (cell->GetCellType() == VTK_EMPTY_CELL)
    {
      center[0] = center[1] = center[2] = vtkMath::Nan();
      continue;
    }
    double parametric[3];
    int subId = cell->GetParametricCenter(parametric);
    cell->EvaluateLocation(subId, parametric, center, weights.data());
  }
  return positions;
}

} // namespace

vtkStandardNewMacro(vtkWindingNumberProbe);

vtkWindingNumberProbe::vtkWindingNumberProbe()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(1);
}

void vtkWindingNumberProbe::SetSourceConnection(vtkAlgorithmOutput* source)
{
  this->SetInputConnection(1, source);
}

void vtkWindingNumberProbe::SetSourceData(vtkDataObject* source)
{
  this->SetInputDataObject(1, source);
}

vtkDataSet* vtkWindingNumberProbe::GetOutput()
{
  return vtkDataSet::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkWindingNumberProbe::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  }
  else
  {
    FillSourcePortInformation(info);
  }
  return 1;
}

int vtkWindingNumberProbe::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataSet");
  return 1;
}

/// The output is of the very class of the queries.
void vtkWindingNumberProbe::GiveDataObject(
  vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataSet* queries = vtkDataSet::GetData(inputs[0]);
  vtkDataSet* output = vtkDataSet::GetData(outputs);
  if (queries && (!output || !output->IsA(queries->GetClassName())))
  {
    auto fresh = vtkSmartPointer<vtkDataSet>::Take(queries->NewInstance());
    outputs->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), fresh);
  }
}

void vtkWindingNumberProbe::GiveInformation(
  vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  this->LookAtSource(vtkDataObject::GetData(inputs[1]));
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  // Without time steps in its information the pipeline would ask a moving source once only.
  for (vtkInformationVector* input : {inputs[1], inputs[0]})
  {
    vtkInformation* info = input->GetInformationObject(0);
    if (info->Has(Pipeline::TIME_STEPS()) || info->Has(Pipeline::TIME_RANGE()))
    {
      outInfo->CopyEntry(info, Pipeline::TIME_STEPS());
      outInfo->CopyEntry(info, Pipeline::TIME_RANGE());
      return;
    }
  }
}

void vtkWindingNumberProbe::AskForUpdate(vtkInformationVector** inputs, vtkInformationVector*)
{
  winding::askForAll(inputs[1]->GetInformationObject(0));
}

void vtkWindingNumberProbe::GiveData(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataSet* queries = vtkDataSet::GetData(inputs[0]);
  vtkDataSet* output = vtkDataSet::GetData(outputs);
  const bool atCells = this->ProbeAssociation == CELLS;

  const vtkIdType count = atCells ? queries->GetNumberOfCells() : queries->GetNumberOfPoints();
  const winding::ResultArrays results = this->MakeResults(count);
  const std::vector<double> positions = atCells ? cellCentersOf(queries) : pointsOf(queries);
  const winding::VectorsView samples(positions.data(), static_cast<std::size_t>(count));
  const winding::Field* field = this->PrepareField(vtkDataObject::GetData(inputs[1]), count,
    [&samples](const winding::Field& built, winding::Executor& executor)
    { return built.prepare(samples, executor); });
  const auto evaluate = [&](winding::Executor& executor)
  {
    return field->evaluate(samples, this->OutputTo(results), executor);
  };
  if (!field || !this->Evaluate(evaluate))
  {
    output->Initialize();
    return;
  }
  output->ShallowCopy(queries);
  vtkDataSetAttributes* attributes = output->GetPointData();
  if (atCells)
  {
    attributes = output->GetCellData();
  }
  this->AddResults(results, output, attributes);
}

void vtkWindingNumberProbe::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ProbeAssociation: " << this->ProbeAssociation << "\n";
}
