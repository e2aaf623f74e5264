// A fuzzer of readInput() for files of one suffix, which comes from CMake. What is read goes
// through a field, so that whatever a reader lets through meets a filter.

#include "FuzzedFile.h"

#include "input/ReadInput.h"
#include "program/Failure.h"
#include "program/Messages.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkWindingNumberField.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace
{

void checkFieldOf(vtkDataObject* data)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputData(data);
  field->SetResolution(3);
  field->Update();
  vtkDataArray* const values = field->GetOutput()->GetPointData()->GetScalars();
  for (vtkIdType i = 0; values && i < values->GetNumberOfTuples(); ++i)
  {
    if (!std::isfinite(values->GetComponent(i, 0)))
    {
      std::fprintf(stderr, "the field has the value %g\n", values->GetComponent(i, 0));
      std::abort();
    }
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const fuzz::FuzzedFile file(WINDING_FUZZ_SUFFIX);
  static Messages& messages = Messages::install(true);
  file.write(data, size);
  try
  {
    checkFieldOf(readInput(file.name(), messages));
    messages.throwIfError(file.name());
  }
  catch (const Failure&)
  {
  }
  return 0;
}
