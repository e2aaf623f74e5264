#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSphereSource.h>
#include <vtkWindingNumberField.h>

#include <cmath>
#include <cstdio>

int main()
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkWindingNumberField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetSamplingDimensions(9, 9, 9);
  field->Update();
  const double center = field->GetOutput()->GetScalarComponentAsDouble(4, 4, 4, 0);
  const double corner = field->GetOutput()->GetScalarComponentAsDouble(0, 0, 0, 0);
  std::printf("winding number %g in the sphere, %g outside\n", center, corner);
  return std::abs(center - 1) < 1e-6 && std::abs(corner) < 1e-6 ? 0 : 1;
}
