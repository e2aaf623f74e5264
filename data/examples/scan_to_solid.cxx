// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause

// A scan, holes and all, becomes a solid that can be printed.
//
//   scan_to_solid scan.obj solid.stl [resolution]

#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPolyData.h>
#include <vtkSTLWriter.h>
#include <vtkWindingNumberSurface.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc < 3)
  {
    std::cerr << "usage: scan_to_solid scan.obj solid.stl [resolution]\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(argv[1]);

  vtkNew<vtkWindingNumberSurface> surface; // of what the scan encloses, closed over its holes
  surface->SetInputConnection(reader->GetOutputPort());
  surface->SetResolution(argc > 3 ? std::atoi(argv[3]) : 128); // voxels along the longest side
  surface->Update();
  const vtkIdType triangles = surface->GetOutput()->GetNumberOfCells();
  if (surface->GetStatus() != vtkWindingNumberAlgorithm::DONE || triangles == 0)
  {
    return EXIT_FAILURE; // the reader or the filter has said why
  }
  std::cout << triangles << " triangles; method " << surface->GetMethodUsed() << ", "
            << surface->GetMethodReason() << "\n";

  vtkNew<vtkSTLWriter> writer;
  writer->SetFileName(argv[2]);
  writer->SetFileTypeToBinary();
  writer->SetInputConnection(surface->GetOutputPort());
  return writer->Write() ? EXIT_SUCCESS : EXIT_FAILURE;
}
