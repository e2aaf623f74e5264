#include "ResultArrays.h"

#include "FreeMemory.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace winding
{

namespace
{

/// Asks for large pages where the system hands them out on request only. Touching fresh memory in
/// small pages for the first time takes several times as long as filling it.
void adviseLargePages(vtkDataArray* array)
{
#ifdef MADV_HUGEPAGE
  constexpr std::uintptr_t largePage = 2u << 20;
  const auto begin = reinterpret_cast<std::uintptr_t>(array->GetVoidPointer(0));
  const std::uintptr_t end =
    begin + static_cast<std::uintptr_t>(array->GetNumberOfValues()) * array->GetDataTypeSize();
  const std::uintptr_t first = (begin + largePage - 1) / largePage * largePage;
  if (first < end)
  {
    madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
  }
#else
  (void)array;
#endif
}

vtkSmartPointer<vtkDataArray> makeArray(int type, const std::string& name, vtkIdType samples)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName(name.c_str());
  array->SetNumberOfTuples(samples);
  adviseLargePages(array);
  return array;
}

} // namespace

vtkIdType bytesPerSample(const ResultOptions& options)
{
  return (options.withValues ? vtkDataArray::GetDataTypeSize(options.scalarType) : 0) +
         (options.withInside ? 1 : 0) + (options.withCoverage ? sizeof(float) : 0);
}

ResultArrays::ResultArrays(vtkIdType samples, const ResultOptions& options)
{
  if (options.scalarType != VTK_FLOAT && options.scalarType != VTK_DOUBLE)
  {
    throw Refusal("the output scalar type is " + std::to_string(options.scalarType) +
                  "; it must be VTK_FLOAT or VTK_DOUBLE");
  }
  if (!options.withValues && !options.withInside)
  {
    throw Refusal("neither the winding number nor Inside is to be generated; turn one of them on");
  }
  const std::string name = options.name.empty() ? "WindingNumber" : options.name;
  if (options.withValues && ((options.withInside && name == options.insideName) ||
                              (options.withCoverage && name == "Coverage")))
  {
    throw Refusal("the array of w cannot have the name '" + name +
                  "' of the array beside it; rename one of them");
  }
  refuseBeyondFreeMemory(
    static_cast<double>(bytesPerSample(options)) * static_cast<double>(samples),
    "the result of " + std::to_string(samples) + " samples",
    "choose larger voxels or write it in pieces");
  if (options.withValues)
  {
    values_ = makeArray(options.scalarType, name, samples);
  }
  if (options.withInside)
  {
    inside_ =
      vtkUnsignedCharArray::SafeDownCast(makeArray(VTK_UNSIGNED_CHAR, options.insideName, samples));
  }
  if (options.withCoverage)
  {
    coverage_ = vtkFloatArray::SafeDownCast(makeArray(VTK_FLOAT, "Coverage", samples));
  }
}

FieldOutput ResultArrays::output(InsideRule rule, double threshold) const
{
  FieldOutput output;
  if (auto* floats = vtkFloatArray::SafeDownCast(values_))
  {
    output.values = floats->GetPointer(0);
  }
  else if (auto* doubles = vtkDoubleArray::SafeDownCast(values_))
  {
    output.doubleValues = doubles->GetPointer(0);
  }
  output.inside = inside_ ? inside_->GetPointer(0) : nullptr;
  output.rule = rule;
  output.threshold = threshold;
  return output;
}

void ResultArrays::addTo(vtkDataSetAttributes* attributes) const
{
  // SetScalars() would throw the array out that was active until now.
  if (coverage_)
  {
    attributes->AddArray(coverage_);
  }
  if (inside_)
  {
    attributes->AddArray(inside_);
    attributes->SetActiveScalars(inside_->GetName());
  }
  if (values_)
  {
    attributes->AddArray(values_);
    attributes->SetActiveScalars(values_->GetName());
  }
}

} // namespace winding
