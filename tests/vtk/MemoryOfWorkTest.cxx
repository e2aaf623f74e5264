// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/FreeMemory.h"
#include "vtk/ErrorLog.h"
#include "vtk/HowTo.h"
#include "vtk/Spheres.h"

#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkWindingNumberClip.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberNormals.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberReport.h"
#include "vtkWindingNumberSurface.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <limits>
#include <random>

namespace
{

using winding::Parameter;

/// A sphere that says that it has far more points and cells than fit into any memory.
class HugeSphere : public vtkPolyData
{
public:
  static HugeSphere* New();
  vtkTypeMacro(HugeSphere, vtkPolyData);

  vtkIdType GetNumberOfElements(int) override { return vtkIdType(1) << 50; }
};
vtkStandardNewMacro(HugeSphere);

template <class Filter> std::string errorsOf(Filter* filter)
{
  ErrorLog log(filter);
  filter->Update();
  return log.errors();
}

/// Expects that memory is short for `what`, and that the error names a parameter.
template <class Filter>
void expectRefused(Filter* filter, Parameter parameter, const std::string& what)
{
  const std::string errors = errorsOf(filter);
  EXPECT_NE(errors.find("): not enough memory: "), std::string::npos) << errors;
  EXPECT_NE(errors.find(what), std::string::npos) << errors;
  EXPECT_NE(errors.find(howTo(parameter)), std::string::npos) << errors;
}

TEST(MemoryOfWork, HugeSourcesAreRefusedBeforeAnythingIsAllocated)
{
  vtkNew<vtkSphereSource> source;
  source->Update();
  vtkNew<HugeSphere> sphere;
  sphere->ShallowCopy(source->GetOutput());
  const char* const words = "take a part of the source";

  vtkNew<vtkWindingNumberField> field;
  field->SetInputData(sphere);
  EXPECT_NE(errorsOf(field.Get()).find(words), std::string::npos);
  EXPECT_EQ(field->GetStatus(), vtkWindingNumberField::OUT_OF_MEMORY);
  EXPECT_EQ(field->GetErrorCode(), static_cast<unsigned long>(ENOMEM));

  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputData(sphere);
  EXPECT_NE(errorsOf(surface.Get()).find(words), std::string::npos);

  vtkNew<vtkWindingNumberProbe> probe;
  probe->SetInputConnection(source->GetOutputPort());
  probe->SetSourceData(sphere);
  EXPECT_NE(errorsOf(probe.Get()).find(words), std::string::npos);

  vtkNew<vtkWindingNumberReport> report;
  report->SetInputData(sphere);
  EXPECT_NE(errorsOf(report.Get()).find("of 1125899906842624 cells needs"), std::string::npos);

  vtkNew<vtkWindingNumberNormals> areas;
  areas->SetInputData(sphere);
  EXPECT_NE(errorsOf(areas.Get()).find(words), std::string::npos);
  EXPECT_EQ(areas->GetStatus(), vtkWindingNumberAlgorithm::OUT_OF_MEMORY);
}

TEST(MemoryOfWork, HugeQueriesAreRefused)
{
  vtkNew<vtkSphereSource> source;
  vtkNew<vtkImageData> image;
  image->SetDimensions(100'000, 100'000, 1'000); // 240 TB of positions
  vtkNew<vtkWindingNumberProbe> probe;
  probe->SetInputData(image);
  probe->SetSourceConnection(source->GetOutputPort());
  EXPECT_NE(errorsOf(probe.Get()).find("probe a part of the data set"), std::string::npos);
  EXPECT_EQ(probe->GetStatus(), vtkWindingNumberProbe::OUT_OF_MEMORY);
  vtkNew<vtkWindingNumberClip> clip;
  clip->SetInputData(image);
  clip->SetSourceConnection(source->GetOutputPort());
  EXPECT_NE(errorsOf(clip.Get()).find("clip a part of the data set"), std::string::npos);
  EXPECT_EQ(clip->GetStatus(), vtkWindingNumberClip::OUT_OF_MEMORY);
}

TEST(MemoryOfWork, SurfacesAreRefusedByTheirVertices)
{
  // A flat grid: rows take 3 MB, the vertices on the sides of the slab terabytes.
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputData(sphereOf(32, 32));
  surface->SetSamplingDimensions(2'000'000'000, 100, 100);
  expectRefused(surface.Get(), Parameter::voxelSize, "; the surface needs");
  EXPECT_EQ(surface->GetStatus(), vtkWindingNumberSurface::OUT_OF_MEMORY);
}

TEST(MemoryOfWork, ComparisonsAreRefusedByTheirPoints)
{
  constexpr int most = std::numeric_limits<int>::max(); // 140 GB
  if (winding::hostMemory().total > 100e9)
  {
    GTEST_SKIP() << "the machine may have the memory";
  }
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkWindingNumberSurface> surface;
  surface->SetInputConnection(sphere->GetOutputPort());
  surface->SetResolution(8);
  surface->SetFidelitySamples(most);
  expectRefused(surface.Get(), Parameter::fidelitySamples,
    "; the comparison of the surface with its source needs");
  EXPECT_EQ(surface->GetStatus(), vtkWindingNumberSurface::OUT_OF_MEMORY);
}

} // namespace
