#include "ResultArrays.h"

#include "vtkDataSetAttributes.h"

#include <vtksys/SystemInformation.hxx>

#include <cstdio>

namespace winding
{

namespace
{

std::string inGiB(double bytes)
{
  char text[64];
  std::snprintf(text, sizeof text, "%.3g GiB", bytes / (1024.0 * 1024.0 * 1024.0));
  return text;
}

void refuseBeyondMemory(vtkIdType samples, double bytes)
{
  constexpr double smallest = 64.0 * 1024 * 1024; // not worth asking the system for
  if (bytes < smallest)
  {
    return;
  }
  vtksys::SystemInformation system;
  system.RunMemoryCheck();
  const double freeBytes = 1024.0 * (static_cast<double>(system.GetHostMemoryTotal()) -
                                      static_cast<double>(system.GetHostMemoryUsed()));
  if (bytes > freeBytes)
  {
    throw OutOfMemory("the result of " + std::to_string(samples) + " samples needs " +
                      inGiB(bytes) + " of memory and " + inGiB(freeBytes) +
                      " is free; choose larger voxels or write it in pieces");
  }
}

} // namespace

ResultArrays::ResultArrays(
  vtkIdType samples, int scalarType, const std::string& name, bool withInside)
{
  if (scalarType != VTK_FLOAT && scalarType != VTK_DOUBLE)
  {
    throw Refusal("the output scalar type is " + std::to_string(scalarType) +
                  "; it must be VTK_FLOAT or VTK_DOUBLE");
  }
  const double bytesPerSample = (scalarType == VTK_DOUBLE ? 8.0 : 4.0) + (withInside ? 1.0 : 0.0);
  refuseBeyondMemory(samples, bytesPerSample * static_cast<double>(samples));
  values_.TakeReference(vtkDataArray::CreateDataArray(scalarType));
  values_->SetName(name.c_str());
  values_->SetNumberOfTuples(samples);
  if (withInside)
  {
    inside_ = vtkSmartPointer<vtkUnsignedCharArray>::New();
    inside_->SetName("Inside");
    inside_->SetNumberOfTuples(samples);
  }
}

FieldOutput ResultArrays::output(InsideRule rule, double threshold) const
{
  FieldOutput output;
  void* data = values_->GetVoidPointer(0);
  if (values_->GetDataType() == VTK_DOUBLE)
  {
    output.doubleValues = static_cast<double*>(data);
  }
  else
  {
    output.values = static_cast<float*>(data);
  }
  output.inside = inside_ ? inside_->GetPointer(0) : nullptr;
  output.rule = rule;
  output.threshold = threshold;
  return output;
}

void ResultArrays::addTo(vtkDataSetAttributes* attributes) const
{
  // SetScalars() would throw the array out that was active until now.
  attributes->AddArray(values_);
  attributes->SetActiveScalars(values_->GetName());
  if (inside_)
  {
    attributes->AddArray(inside_);
  }
}

} // namespace winding
