// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause

// A fuzzer of readInput() and readQueries() for files of one suffix, which comes from CMake. What
// is read goes through a field, or through a probe where it is no source, so that whatever a reader
// lets through meets a filter.

#include "FuzzedFile.h"

#include "files/Formats.h"
#include "input/ReadInput.h"
#include "program/Failure.h"
#include "program/Messages.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberProbe.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace
{

void checkFinite(vtkDataArray* values)
{
  for (vtkIdType i = 0; values && i < values->GetNumberOfTuples(); ++i)
  {
    if (!std::isfinite(values->GetComponent(i, 0)))
    {
      std::fprintf(stderr, "the field has the value %g\n", values->GetComponent(i, 0));
      std::abort();
    }
  }
}

void checkFieldOf(vtkDataObject* data)
{
  vtkNew<vtkWindingNumberField> field;
  field->SetInputData(data);
  field->SetResolution(3);
  field->Update();
  checkFinite(field->GetOutput()->GetPointData()->GetScalars());
}

void checkProbeAt(vtkDataSet* queries)
{
  constexpr vtkIdType most = 100'000;
  if (queries->GetNumberOfPoints() > most)
  {
    return;
  }
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkWindingNumberProbe> probe;
  probe->SetInputData(queries);
  probe->SetSourceConnection(sphere->GetOutputPort());
  probe->Update();
  if (queries->IsA("vtkImageData")) // coordinates of other grids may be NaN
  {
    checkFinite(probe->GetOutput()->GetPointData()->GetArray("WindingNumber"));
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
    if (imageSuffixes().find(WINDING_FUZZ_SUFFIX) == std::string::npos)
    {
      checkFieldOf(readInput(file.name(), messages));
    }
    else
    {
      checkProbeAt(readQueries(file.name(), messages));
    }
    messages.throwIfError(file.name());
  }
  catch (const Failure&)
  {
  }
  return 0;
}
