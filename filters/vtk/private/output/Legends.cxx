// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/output/Legends.h"

#include "base/Digits.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace winding
{

namespace
{

vtkStringArray* textsOf(vtkFieldData* facts, const char* name)
{
  return vtkStringArray::SafeDownCast(facts->GetAbstractArray(name));
}

} // namespace

std::string legendOf(vtkFieldData* facts, const char* values, const char* names)
{
  vtkStringArray* const texts = textsOf(facts, names);
  vtkDataArray* const numbers = values ? facts->GetArray(values) : nullptr;
  const vtkIdType count = texts && (numbers || !values) ? texts->GetNumberOfValues() : 0;
  std::string legend;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const long number = numbers ? std::lround(numbers->GetComponent(i, 0)) : i;
    legend += std::to_string(number) + "\t" + texts->GetValue(i) + "\n";
  }
  return legend;
}

std::string legendOfLabels(vtkFieldData* facts)
{
  return legendOf(facts, "LabelValues", "LabelNames");
}

void addLabelVolumes(vtkImageData* image, vtkDataSetAttributes* attributes)
{
  auto* const labels = vtkUnsignedShortArray::SafeDownCast(attributes->GetArray("Label"));
  vtkDataArray* const values = image->GetFieldData()->GetArray("LabelValues");
  std::vector<vtkIdType> voxels(65536);
  for (vtkIdType i = 0; i < labels->GetNumberOfTuples(); ++i)
  {
    ++voxels[labels->GetValue(i)];
  }
  const double* const spacing = image->GetSpacing();
  const double voxel = std::abs(spacing[0] * spacing[1] * spacing[2]);
  vtkNew<vtkDoubleArray> volumes;
  volumes->SetName("LabelVolumes");
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const auto label = static_cast<std::size_t>(values->GetComponent(i, 0));
    volumes->InsertNextValue(voxel * static_cast<double>(voxels[label]));
  }
  image->GetFieldData()->AddArray(volumes);
}

std::string volumesInWords(vtkFieldData* facts, int most)
{
  vtkStringArray* const names = textsOf(facts, "LabelNames");
  vtkDataArray* const volumes = facts->GetArray("LabelVolumes");
  const vtkIdType count = names && volumes ? names->GetNumberOfValues() : 0;
  std::string words;
  for (vtkIdType i = 0; i < std::min<vtkIdType>(count, most); ++i)
  {
    words +=
      (i > 0 ? "\n" : "") + names->GetValue(i) + ": " + inDigits(volumes->GetComponent(i, 0), 4);
  }
  return count > most ? words + "\nand " + std::to_string(count - most) + " more" : words;
}

} // namespace winding
