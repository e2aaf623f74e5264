// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtk/ErrorLog.h"

#include "vtkDataSet.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkWindingNumberBoolean.h"
#include "vtkWindingNumberClip.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberLabels.h"
#include "vtkWindingNumberNormals.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberSurface.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

/// Connects all inputs of a filter that may be surfaces.
void connect(vtkAlgorithm* filter, vtkAlgorithmOutput* source)
{
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    const char* type =
      filter->GetInputPortInformation(port)->Get(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
    if (std::string(type) != "vtkImageData")
    {
      filter->SetInputConnection(port, source);
    }
  }
}

template <class Filter> class Status : public testing::Test
{
};

using Filters =
  testing::Types<vtkWindingNumberNormals, vtkWindingNumberBoolean, vtkWindingNumberClip,
    vtkWindingNumberField, vtkWindingNumberLabels, vtkWindingNumberProbe, vtkWindingNumberSurface>;

/// Names tests after filters.
struct Names
{
  template <class Filter> static std::string GetName(int)
  {
    return vtkNew<Filter>()->GetClassName();
  }
};

TYPED_TEST_SUITE(Status, Filters, Names);

TYPED_TEST(Status, IsNotRunUntilTheFilterIsExecuted)
{
  using Algorithm = vtkWindingNumberAlgorithm;
  vtkNew<TypeParam> filter;
  EXPECT_EQ(filter->GetStatus(), Algorithm::NOT_RUN) << "nothing was asked for";
  vtkNew<vtkSphereSource> sphere;
  connect(filter, sphere->GetOutputPort());
  filter->UpdateInformation();
  EXPECT_EQ(filter->GetStatus(), Algorithm::NOT_RUN) << "information alone";
  filter->Update();
  EXPECT_EQ(filter->GetStatus(), Algorithm::DONE);
  filter->Update();
  EXPECT_EQ(filter->GetStatus(), Algorithm::DONE) << "nothing has changed";
  filter->UpdateInformation();
  EXPECT_EQ(filter->GetStatus(), Algorithm::DONE) << "nothing has changed";
}

TYPED_TEST(Status, IsNotDoneAfterAReaderUpstreamHasFailed)
{
  using Algorithm = vtkWindingNumberAlgorithm;
  vtkNew<TypeParam> filter;
  const ErrorLog log(filter);
  vtkNew<vtkSphereSource> sphere;
  connect(filter, sphere->GetOutputPort());
  filter->Update();
  ASSERT_EQ(filter->GetStatus(), Algorithm::DONE);
  vtkNew<vtkOBJReader> reader;
  const ErrorLog ofReader(reader);
  const ErrorLog ofExecutive(reader->GetExecutive());
  reader->SetFileName("no such file.obj");
  connect(filter, reader->GetOutputPort());
  filter->Update();
  EXPECT_NE(ofReader.errors(), "");
  const bool isRefused = filter->GetStatus() == Algorithm::REFUSED && log.errors() != "";
  EXPECT_TRUE(isRefused || filter->GetStatus() == Algorithm::NOT_RUN) << filter->GetStatus();
  connect(filter, sphere->GetOutputPort());
  filter->Update();
  EXPECT_EQ(filter->GetStatus(), Algorithm::DONE);
}

} // namespace
