// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/SmpExecutor.h"
#include "support/FailingAllocations.h"
#include "vtk/Backends.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkWindingNumberBoolean.h"
#include "vtkWindingNumberField.h"
#include "vtkWindingNumberLabels.h"
#include "vtkWindingNumberNormals.h"
#include "vtkWindingNumberProbe.h"
#include "vtkWindingNumberSurface.h"
#include "vtkWindingNumberVoxels.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <new>
#include <string>
#include <utility>

/// @file Exceptions in worker threads end runs in order, on whatever backend.
namespace
{

/// Returns a sphere without its poles, so that methods differ.
vtkSmartPointer<vtkPolyData> openSphere()
{
  constexpr int rings = 24, sectors = 48;
  const double pi = std::acos(-1.0);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  for (int i = 0; i < rings; ++i)
  {
    for (int j = 0; j < sectors; ++j)
    {
      const double theta = pi * (i + 1) / (rings + 1), phi = 2 * pi * j / sectors;
      points->InsertNextPoint(
        std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
      const vtkIdType a = i * sectors + j, b = i * sectors + (j + 1) % sectors;
      if (i + 1 < rings)
      {
        triangles->InsertNextCell({a, a + sectors, b + sectors});
        triangles->InsertNextCell({a, b + sectors, b});
      }
    }
  }
  auto sphere = vtkSmartPointer<vtkPolyData>::New();
  sphere->SetPoints(points);
  sphere->SetPolys(triangles);
  return sphere;
}

/// Appends the bytes of an array.
void append(vtkDataArray* array, std::string& bytes)
{
  if (array)
  {
    bytes.append(static_cast<const char*>(array->GetVoidPointer(0)),
      static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize()));
  }
}

/// Returns the bytes of the points and of all their arrays.
std::string bytesOf(vtkDataObject* data)
{
  std::string bytes;
  if (auto* points = vtkPointSet::SafeDownCast(data); points && points->GetPoints())
  {
    append(points->GetPoints()->GetData(), bytes);
  }
  vtkDataSetAttributes* arrays = data->GetAttributes(vtkDataObject::POINT);
  for (int i = 0; arrays && i < arrays->GetNumberOfArrays(); ++i)
  {
    append(arrays->GetArray(i), bytes);
  }
  return bytes;
}

/// Has the allocations of a filter's worker threads fail, one alone in each run, in about 25 runs.
/// The result is whole, or there is none and the status says why. `set` prepares a new filter for
/// each run, so that it builds its field anew. Returns how many failed.
template <class Filter, class Set> long expectWholeOrNone(const Set& set)
{
  constexpr long plenty = 1L << 40, runs = 25;
  vtkNew<vtkCallbackCommand> deaf;
  const auto run = [&](long left)
  {
    auto filter = vtkSmartPointer<Filter>::New();
    filter->AddObserver(vtkCommand::ErrorEvent, deaf);
    filter->AddObserver(vtkCommand::WarningEvent, deaf);
    filter->SetNumberOfThreads(2);
    set(filter.Get());
    allocations::neverFails = true;
    allocations::left = left;
    filter->Update();
    left = allocations::left;
    allocations::left = -1;
    allocations::neverFails = false;
    return std::pair(filter, left);
  };
  const auto [right, left] = run(plenty);
  EXPECT_EQ(right->GetStatus(), vtkWindingNumberAlgorithm::DONE);
  const std::string whole = bytesOf(right->GetOutputDataObject(0));
  EXPECT_FALSE(whole.empty());
  const long count = plenty - left;
  long failed = 0;
  for (long i = 0; i < count; i += count / runs + 1)
  {
    const auto [filter, leftThen] = run(i);
    failed += leftThen < 0;
    const bool isDone = filter->GetStatus() == vtkWindingNumberAlgorithm::DONE;
    EXPECT_TRUE(
      isDone || (leftThen < 0 && filter->GetStatus() == vtkWindingNumberAlgorithm::OUT_OF_MEMORY))
      << i << " of " << count << ": " << filter->GetStatus();
    EXPECT_EQ(bytesOf(filter->GetOutputDataObject(0)), isDone ? whole : std::string()) << i;
  }
  return failed;
}

} // namespace

TEST(Workers, HandWhatTheyThrowToTheCaller)
{
  onEachBackend(
    [](const char* backend)
    {
      SCOPED_TRACE(backend);
      for (const int threads : {0, 1, 2, 7})
      {
        winding::SmpExecutor executor(nullptr, threads);
        for (const std::size_t bad : {0, 50, 99})
        {
          const auto work = [bad](std::size_t block)
          {
            if (block >= bad)
            {
              throw std::bad_alloc();
            }
          };
          EXPECT_THROW(executor.run(100, work), std::bad_alloc);
          EXPECT_THROW(executor.runBriefly(100, work), std::bad_alloc);
        }
        std::atomic<int> done{0};
        executor.run(100, [&done](std::size_t) { ++done; });
        EXPECT_EQ(done, 100) << "the next run";
      }
    });
}

TEST(Workers, WithoutMemoryLeaveAWholeResultOrNone)
{
  const vtkSmartPointer<vtkPolyData> sphere = openSphere();
  long failed = 0;
  onEachBackend(
    [&](const char* backend)
    {
      SCOPED_TRACE(backend);
      for (const int method : {vtkWindingNumberAlgorithm::ROWS,
             vtkWindingNumberAlgorithm::HIERARCHICAL, vtkWindingNumberAlgorithm::DIRECT})
      {
        SCOPED_TRACE(method);
        failed += expectWholeOrNone<vtkWindingNumberField>(
          [&](vtkWindingNumberField* field)
          {
            field->SetInputData(sphere);
            field->SetResolution(16);
            field->SetMethod(method);
            field->SetGenerateSignedDistance(true);
          });
      }
      for (const bool isSharp : {false, true})
      {
        SCOPED_TRACE(isSharp);
        failed += expectWholeOrNone<vtkWindingNumberSurface>(
          [&](vtkWindingNumberSurface* surface)
          {
            surface->SetInputData(sphere);
            surface->SetResolution(24);
            surface->SetFeatures(isSharp);
            surface->SetOffset(0.05);
          });
      }
      failed += expectWholeOrNone<vtkWindingNumberBoolean>(
        [&](vtkWindingNumberBoolean* both)
        {
          both->SetInputDataObject(0, sphere);
          both->AddInputDataObject(1, sphere);
          both->SetResolution(16);
        });
      failed += expectWholeOrNone<vtkWindingNumberLabels>(
        [&](vtkWindingNumberLabels* labels)
        {
          labels->SetInputData(sphere);
          labels->SetResolution(16);
        });
      failed += expectWholeOrNone<vtkWindingNumberProbe>(
        [&](vtkWindingNumberProbe* probe)
        {
          probe->SetInputData(sphere);
          probe->SetSourceData(sphere);
          probe->SetGenerateSignedDistance(true);
        });
      failed += expectWholeOrNone<vtkWindingNumberNormals>(
        [&](vtkWindingNumberNormals* areas) { areas->SetInputData(sphere); });
    });
  RecordProperty("failed", std::to_string(failed));
  EXPECT_GT(failed, 100);
}
