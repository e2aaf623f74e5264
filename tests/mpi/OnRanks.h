// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpi/Deals.h"
#include "vtk/ErrorLog.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <utility>
#include <vector>

/**
 * @file
 * Filters on this rank and what they are compared with, for tests whose source is dealt out to the
 * ranks of a parallel program: the results are the same as on one rank that has the whole
 * source, to the bit.
 */
namespace onranks
{

using shapes::Mesh;

inline const Deal whole = {"whole", [](std::size_t, std::size_t, int)
  {
    return 0;
  }};

inline vtkMultiProcessController* world()
{
  return vtkMultiProcessController::GetGlobalController();
}

inline int rank()
{
  return world()->GetLocalProcessId();
}

inline int ranks()
{
  return world()->GetNumberOfProcesses();
}

/// The filter of this rank's part, or of the whole without the others.
template <class Filter> vtkSmartPointer<Filter> filterOf(vtkDataObject* source, bool isAlone)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(source);
  if (isAlone)
  {
    filter->SetController(nullptr);
  }
  return filter;
}

inline void expectSame(vtkDataArray* found, vtkDataArray* expected)
{
  ASSERT_NE(found, nullptr);
  ASSERT_NE(expected, nullptr);
  ASSERT_EQ(found->GetNumberOfValues(), expected->GetNumberOfValues());
  EXPECT_EQ(std::memcmp(found->GetVoidPointer(0), expected->GetVoidPointer(0),
              static_cast<std::size_t>(found->GetNumberOfValues()) *
                static_cast<std::size_t>(found->GetDataTypeSize())),
    0)
    << found->GetName();
}

inline Mesh openSphere()
{
  const Mesh sphere = shapes::icosphere(3);
  return sphere.part(100, sphere.triangles.size());
}

/// A closed and an open surface, a soup, and another one for the far field.
inline std::vector<std::pair<std::string, Mesh>> meshes()
{
  return {{"closed", shapes::icosphere(3)}, {"open", openSphere()},
    {"soup", shapes::triangleSoup(300, 811)}, {"torus", shapes::torus(30, 20)}};
}

/// The piece of a filter's output that is this rank's.
inline void updatePiece(vtkAlgorithm* filter)
{
  filter->UpdatePiece(rank(), ranks(), 0);
}

/// Expects that ranks refuse because a filter's properties differ between them; one alone has no
/// others that they could differ from.
inline void expectDifferentProperties(vtkAlgorithm* filter)
{
  const ErrorLog log(filter);
  updatePiece(filter);
  EXPECT_EQ(log.errors().find("set the same properties") == std::string::npos, ranks() == 1)
    << log.errors();
}

} // namespace onranks
