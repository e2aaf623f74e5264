// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImplicitWindingNumber.h"

#include "base/Executor.h"
#include "base/Refusal.h"
#include "base/Views.h"
#include "messages/Options.h"
#include "messages/PropertyChecks.h"
#include "pipeline/ErrorReports.h"
#include "pipeline/SmpExecutor.h"
#include "private/source/ModifiedTime.h"
#include "private/source/SourceProperties.h"

#include "vtkAbstractTransform.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArrayRange.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkImplicitWindingNumber);

namespace
{

/// A data object and, if it is composite, all in it, containers before what they hold. That of a
/// composite does not ask those in it when it was modified.
std::vector<vtkDataObject*> partsOf(vtkDataObject* object)
{
  std::vector<vtkDataObject*> parts;
  if (object)
  {
    parts.push_back(object);
  }
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(object))
  {
    auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    if (auto* inTree = vtkDataObjectTreeIterator::SafeDownCast(iterator))
    {
      inTree->VisitOnlyLeavesOff();
    }
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      parts.push_back(iterator->GetCurrentDataObject());
    }
  }
  return parts;
}

/// All threads, or this one where it may be one of them: vtkSMPTools may have it do other work
/// while it waits for the blocks that it gave away, and that work may wait for what is built here.
std::unique_ptr<winding::Executor> newExecutor()
{
  if (vtkSMPTools::IsParallelScope())
  {
    return std::make_unique<winding::SerialExecutor>();
  }
  return std::make_unique<winding::SmpExecutor>(nullptr, 0);
}

double windingNumberAt(const double x[3], const winding::Field& field)
{
  double w = 0;
  winding::FieldOutput output;
  output.doubleValues = &w;
  winding::SerialExecutor serial;
  field.evaluate(winding::VectorsView(x, 1), output, serial);
  return w;
}

vtkSmartPointer<vtkDoubleArray> inDouble(vtkDataArray* array)
{
  vtkSmartPointer<vtkDoubleArray> result = vtkDoubleArray::SafeDownCast(array);
  if (!result)
  {
    result = vtkSmartPointer<vtkDoubleArray>::New();
    result->DeepCopy(array);
  }
  return result;
}

/// The time of the function itself. GetMTime() also counts the transform, which does not change
/// the field.
vtkMTimeType ownTime(vtkObject* function)
{
  return function->vtkObject::GetMTime();
}

} // namespace

/// The field that was built, and the state of the function and its input that it was built for. It
/// is never changed.
struct vtkImplicitWindingNumber::Built
{
  const winding::Field* Field;       ///< null if there cannot be one
  vtkMTimeType Time;                 ///< the latest of all modifications
  std::vector<vtkDataObject*> Parts; ///< of the input
};

struct vtkImplicitWindingNumber::Internals
{
  winding::SourceField Source;

  std::mutex Mutex; ///< for whoever builds
  std::atomic<const Built*> Current{nullptr};
  /// A thread may still be finding out that the one before is not current any longer. It has found
  /// out by the next modification, since nothing may be modified while values are asked for.
  std::unique_ptr<const Built> Last, BeforeLast;
};

vtkImplicitWindingNumber::vtkImplicitWindingNumber()
  : Field(vtkWindingNumberField::New())
  , Internal(std::make_unique<Internals>())
{
}

vtkImplicitWindingNumber::~vtkImplicitWindingNumber()
{
  this->Field->Delete();
}

void vtkImplicitWindingNumber::SetInput(vtkDataObject* input)
{
  if (this->Input != input)
  {
    this->Input = input;
    this->Modified();
  }
}

vtkDataObject* vtkImplicitWindingNumber::GetInput()
{
  return this->Input;
}

vtkMTimeType vtkImplicitWindingNumber::GetMTime()
{
  vtkMTimeType time = std::max(this->Superclass::GetMTime(), this->Field->GetMTime());
  for (vtkDataObject* part : partsOf(this->Input))
  {
    time = std::max(time, winding::modifiedTimeOf(part));
  }
  return time;
}

/// Asks in an order in which each part that is asked is still there: who lets one go is modified.
bool vtkImplicitWindingNumber::IsCurrent(const Built* built)
{
  return built && ownTime(this) <= built->Time && this->Field->GetMTime() <= built->Time &&
         std::all_of(built->Parts.begin(), built->Parts.end(),
           [built](vtkDataObject* part) { return winding::modifiedTimeOf(part) <= built->Time; });
}

/// The field, built if need be; null if there cannot be one.
const winding::Field* vtkImplicitWindingNumber::CurrentField()
{
  Internals& internal = *this->Internal;
  const Built* built = internal.Current.load(std::memory_order_acquire);
  if (this->IsCurrent(built))
  {
    return built->Field;
  }
  const std::lock_guard<std::mutex> lock(internal.Mutex);
  if (!this->IsCurrent(internal.Last.get()))
  {
    auto next = std::make_unique<Built>();
    next->Parts = partsOf(this->Input);
    next->Time = std::max(ownTime(this), this->Field->GetMTime());
    for (vtkDataObject* part : next->Parts)
    {
      next->Time = std::max(next->Time, winding::modifiedTimeOf(part));
    }
    next->Field = this->PrepareField();
    internal.BeforeLast = std::move(internal.Last);
    internal.Last = std::move(next);
    internal.Current.store(internal.Last.get(), std::memory_order_release);
  }
  return internal.Last->Field;
}

/// Null, after an error, if there cannot be a field.
const winding::Field* vtkImplicitWindingNumber::PrepareField()
{
  const winding::Field* field = nullptr;
  winding::reportErrors(this, this->Field->GetNamesInMessages(),
    {"not enough memory for this input"}, [this, &field]() { field = &this->MakeField(); });
  return field;
}

const winding::Field& vtkImplicitWindingNumber::MakeField()
{
  winding::checkProperty(winding::Parameter::windingThreshold, this->Field->GetWindingThreshold());
  winding::checkProperty(
    winding::Parameter::insideRule, this->Field->GetInsideRule(), 2); // without ODD
  winding::SourceOptions options = winding::sourceOptions(*this->Field, true);
  if (!this->Input)
  {
    throw winding::Refusal("set a surface or a point cloud (SetInput): there is no input");
  }
  vtkInformation* facts = this->Input->GetInformation();
  if (facts->Get(vtkDataObject::DATA_NUMBER_OF_PIECES()) > 1)
  {
    throw winding::Refusal(
      "update the input as a whole (UpdatePiece(0, 1, 0)), or use Winding Number Probe, which "
      "works on many ranks: an implicit function is serial, and the input is piece " +
      std::to_string(facts->Get(vtkDataObject::DATA_PIECE_NUMBER())) + " of " +
      std::to_string(facts->Get(vtkDataObject::DATA_NUMBER_OF_PIECES())));
  }
  if (options.field.method == winding::Method::automatic)
  {
    // A filter knows how many samples it has, and whether so few are worth a hierarchy. Here they
    // come one by one, in unknown number.
    options.field.method = winding::Method::hierarchical;
  }
  else if (options.field.method == winding::Method::rows)
  {
    throw winding::Refusal(winding::Message("rows needs all samples at once",
      {{"", {{winding::Parameter::method, vtkWindingNumberField::AUTOMATIC}}}},
      "an implicit function gets them one by one"));
  }
  const auto executor = newExecutor();
  winding::Ranks alone(nullptr);
  const winding::Field& field =
    this->Internal->Source.prepare(this->Input, options, *executor, alone, false);
  const double anywhere[3] = {0, 0, 0};
  field.prepare(winding::VectorsView(anywhere, 1), *executor);
  const winding::FieldInfo& info = this->Internal->Source.info();
  if (!info.warnings.empty())
  {
    vtkWarningMacro(<< winding::lineOf(info.warnings));
  }
  if (info.primitives == 0)
  {
    vtkWarningMacro(<< "the input has no triangles and no points to sum over; its field is 0");
  }
  return field;
}

bool vtkImplicitWindingNumber::BuildField()
{
  return this->CurrentField() != nullptr;
}

double vtkImplicitWindingNumber::ValueOf(double w) const
{
  return this->Field->GetWindingThreshold() -
         (this->Field->GetInsideRule() == vtkWindingNumberField::ABSOLUTE ? std::abs(w) : w);
}

double vtkImplicitWindingNumber::EvaluateFunction(double x[3])
{
  const winding::Field* field = this->CurrentField();
  return this->ValueOf(field ? windingNumberAt(x, *field) : 0);
}

void vtkImplicitWindingNumber::EvaluateGradient(double x[3], double g[3])
{
  const winding::Field* field = this->CurrentField();
  if (!field)
  {
    std::fill_n(g, 3, 0.0);
    return;
  }
  winding::SerialExecutor serial;
  field->gradient(winding::VectorsView(x, 1), g, serial);
  const bool isOfNegative = this->Field->GetInsideRule() == vtkWindingNumberField::ABSOLUTE &&
                            windingNumberAt(x, *field) < 0;
  const double sign = isOfNegative ? 1 : -1;
  std::transform(g, g + 3, g, [sign](double component) { return sign * component; });
}

void vtkImplicitWindingNumber::EvaluateFunction(vtkDataArray* input, vtkDataArray* output)
{
  std::vector<double> values(static_cast<std::size_t>(input->GetNumberOfTuples()));
  if (values.empty() || !this->EvaluateAll(input, values))
  {
    std::fill(values.begin(), values.end(), 0.0);
  }
  output->SetNumberOfComponents(1);
  output->SetNumberOfTuples(input->GetNumberOfTuples());
  std::transform(values.begin(), values.end(), vtk::DataArrayValueRange<1>(output).begin(),
    [this](double w) { return this->ValueOf(w); });
}

/// False, after an error, if there are no values.
bool vtkImplicitWindingNumber::EvaluateAll(vtkDataArray* positions, std::vector<double>& values)
{
  const winding::Field* field = this->CurrentField();
  if (!field)
  {
    return false;
  }
  if (positions->GetNumberOfComponents() != 3)
  {
    vtkErrorMacro(<< "points have 3 coordinates, and these have "
                  << positions->GetNumberOfComponents());
    return false;
  }
  const auto evaluate = [&]()
  {
    const auto view = inDouble(positions);
    winding::FieldOutput output;
    output.doubleValues = values.data();
    field->evaluate(
      winding::VectorsView(view->GetPointer(0), values.size()), output, *newExecutor());
  };
  const std::string withoutMemory =
    "there is not enough memory for " + std::to_string(values.size()) + " points";
  return winding::reportErrors(this, this->Field->GetNamesInMessages(), withoutMemory, evaluate) ==
         winding::Outcome::done;
}

void vtkImplicitWindingNumber::FunctionValue(vtkDataArray* input, vtkDataArray* output)
{
  if (!this->Transform)
  {
    this->EvaluateFunction(input, output);
    return;
  }
  vtkNew<vtkDoubleArray> transformed;
  transformed->DeepCopy(input);
  for (vtkIdType i = 0; i < transformed->GetNumberOfTuples(); ++i)
  {
    double* const point = transformed->GetPointer(3 * i);
    this->Transform->TransformPoint(point, point);
  }
  this->EvaluateFunction(transformed, output);
}

void vtkImplicitWindingNumber::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Input: " << this->Input.Get() << "\n";
  os << indent << "Field:\n";
  this->Field->PrintSelf(os, indent.GetNextIndent());
}
