#include <vtkClipDataSet.h>
#include <vtkImageData.h>
#include <vtkImplicitWindingNumber.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPolyData.h>
#include <vtkTrivialProducer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkWindingNumberSurface.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdio>
#include <fstream>

int main()
{
  std::ofstream("scan.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                               "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  vtkNew<vtkImageData> cubes;
  cubes->SetDimensions(20, 20, 20);
  cubes->SetSpacing(0.1, 0.1, 0.1);
  vtkNew<vtkTrivialProducer> mesh;
  mesh->SetOutput(cubes);

#include "README.inc"

  clip->Update();
  const vtkIdType triangles = surface->GetOutput()->GetNumberOfCells();
  const vtkIdType kept = clip->GetOutput()->GetNumberOfCells();
  std::printf("%lld triangles, and %lld of %lld cells inside\n", static_cast<long long>(triangles),
    static_cast<long long>(kept), static_cast<long long>(cubes->GetNumberOfCells()));
  return triangles > 1000 && kept > 100 && kept < cubes->GetNumberOfCells() &&
             std::ifstream("solid.vtp")
           ? 0
           : 1;
}
