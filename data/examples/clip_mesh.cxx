// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause

// The part of a volume mesh that lies inside a surface, which need not be closed.
//
//   clip_mesh surface.obj mesh.vtu part.vtu

#include <vtkClipDataSet.h>
#include <vtkImplicitWindingNumber.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc < 4)
  {
    std::cerr << "usage: clip_mesh surface.obj mesh.vtu part.vtu\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkOBJReader> surface;
  surface->SetFileName(argv[1]);
  surface->Update(); // an implicit function has no pipeline

  vtkNew<vtkImplicitWindingNumber> inside; // negative inside, positive outside
  inside->SetInput(surface->GetOutput());
  if (!inside->BuildField())
  {
    return EXIT_FAILURE; // the function has said why
  }

  vtkNew<vtkXMLUnstructuredGridReader> mesh;
  mesh->SetFileName(argv[2]);

  vtkNew<vtkClipDataSet> clip;
  clip->SetInputConnection(mesh->GetOutputPort());
  clip->SetClipFunction(inside);
  clip->InsideOutOn(); // keeps what is inside
  clip->Update();
  const vtkIdType kept = clip->GetOutput()->GetNumberOfCells();
  std::cout << mesh->GetOutput()->GetNumberOfCells() << " cells, clipped to " << kept << "\n";
  if (kept == 0)
  {
    return EXIT_FAILURE;
  }

  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName(argv[3]);
  writer->SetInputConnection(clip->GetOutputPort());
  return writer->Write() ? EXIT_SUCCESS : EXIT_FAILURE;
}
