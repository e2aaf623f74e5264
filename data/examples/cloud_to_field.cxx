// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause

// Points, with normals or without, become a field of winding numbers and of what is inside.
//
//   cloud_to_field cloud.xyz field.vti [resolution]

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkWindingNumberField.h>
#include <vtkWindingNumberReader.h>
#include <vtkXMLImageDataWriter.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc < 3)
  {
    std::cerr << "usage: cloud_to_field cloud.xyz field.vti [resolution]\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkWindingNumberReader> reader; // lines of x y z or x y z nx ny nz
  reader->SetFileName(argv[1]);

  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(reader->GetOutputPort());
  field->SetResolution(argc > 3 ? std::atoi(argv[3]) : 128); // voxels along the longest side
  field->EstimateNormalsOn();                                // where the points have none
  field->SetRegularization(1);                               // no spikes beside the points
  field->GenerateInsideOn();
  field->Update();
  if (field->GetStatus() != vtkWindingNumberAlgorithm::DONE)
  {
    return EXIT_FAILURE; // the reader or the filter has said why
  }
  std::cout << field->GetNumberOfPrimitives() << " points of mean area "
            << field->GetMeanPointArea() << "\n";
  if (field->GetNormalsWereEstimated())
  {
    std::cout << "normals were estimated; the field is clear at " << 100 * field->GetClearShare()
              << " % of the points\n";
  }

  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetFileName(argv[2]);
  writer->SetInputConnection(field->GetOutputPort());
  return writer->Write() ? EXIT_SUCCESS : EXIT_FAILURE;
}
