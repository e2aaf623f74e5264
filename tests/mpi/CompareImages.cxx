// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLPImageDataReader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{

template <class Reader> vtkSmartPointer<vtkImageData> readBy(const std::string& name)
{
  vtkNew<Reader> reader;
  reader->SetFileName(name.c_str());
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkImageData> read(const std::string& name)
{
  const bool isIndex = name.size() > 5 && name.substr(name.size() - 5) == ".pvti";
  return isIndex ? readBy<vtkXMLPImageDataReader>(name) : readBy<vtkXMLImageDataReader>(name);
}

bool haveSameGrid(vtkImageData* a, vtkImageData* b)
{
  bool isSame = true;
  for (int n = 0; n < 6; ++n)
  {
    isSame = isSame && a->GetExtent()[n] == b->GetExtent()[n];
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    isSame = isSame && a->GetOrigin()[axis] == b->GetOrigin()[axis] &&
             a->GetSpacing()[axis] == b->GetSpacing()[axis];
  }
  for (int n = 0; n < 9; ++n)
  {
    isSame =
      isSame && a->GetDirectionMatrix()->GetData()[n] == b->GetDirectionMatrix()->GetData()[n];
  }
  return isSame;
}

/// The largest difference of arrays; infinite where there is no such array on the other side.
double largestDifference(vtkDataSetAttributes* a, vtkDataSetAttributes* b)
{
  double largest = a->GetNumberOfArrays() == b->GetNumberOfArrays() ? 0 : HUGE_VAL;
  for (int n = 0; n < a->GetNumberOfArrays(); ++n)
  {
    vtkDataArray* const values = a->GetArray(n);
    vtkDataArray* const others = b->GetArray(values->GetName());
    if (!others || others->GetDataType() != values->GetDataType() ||
        others->GetNumberOfValues() != values->GetNumberOfValues())
    {
      return HUGE_VAL;
    }
    for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
    {
      largest = std::max(largest, std::abs(values->GetTuple1(i) - others->GetTuple1(i)));
    }
  }
  return largest;
}

} // namespace

/// compare_images A B: prints the largest difference between the values of two images, .vti or
/// .pvti, and fails where their grids or arrays differ.
int main(int argc, char** argv)
{
  if (argc != 3)
  {
    return EXIT_FAILURE;
  }
  const auto a = read(argv[1]), b = read(argv[2]);
  if (!haveSameGrid(a, b))
  {
    std::cerr << "the grids differ\n";
    return EXIT_FAILURE;
  }
  const double difference = std::max(largestDifference(a->GetPointData(), b->GetPointData()),
    largestDifference(a->GetCellData(), b->GetCellData()));
  std::cout << difference << "\n";
  return std::isfinite(difference) ? EXIT_SUCCESS : EXIT_FAILURE;
}
