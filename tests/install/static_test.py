# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The modules as static libraries: they build, install, and a program links them by
their package."""

import os

from consumers import ROOT, arguments, build, emptied, run

PROJECT = """\
cmake_minimum_required(VERSION 3.25)
project(consumer LANGUAGES C CXX)
find_package(vtkWinding REQUIRED)
add_executable(program main.cxx)
target_link_libraries(program PRIVATE Winding::FiltersWinding Winding::IOWinding)
"""
# Symmetric about the origin, so that w there is 1 whatever the mesh.
PROGRAM = """\
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkCellArray.h>
#include <vtkWindingNumberReader.h>
#include <vtkWindingNumberField.h>

int main()
{
  const double corners[4][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  vtkNew<vtkPoints> points;
  for (const double* corner : corners)
  {
    points->InsertNextPoint(corner);
  }
  vtkNew<vtkCellArray> faces;
  faces->InsertNextCell({0, 1, 2});
  faces->InsertNextCell({0, 3, 1});
  faces->InsertNextCell({0, 2, 3});
  faces->InsertNextCell({1, 3, 2});
  vtkNew<vtkPolyData> tetrahedron;
  tetrahedron->SetPoints(points);
  tetrahedron->SetPolys(faces);
  vtkNew<vtkWindingNumberField> field;
  field->SetInputData(tetrahedron);
  field->SetSamplingDimensions(5, 5, 5);
  field->Update();
  vtkNew<vtkWindingNumberReader> reader;
  reader->SetFileName("there is none.obj");
  reader->GlobalWarningDisplayOff();
  reader->Update();
  return field->GetOutput()->GetPointData()->GetScalars()->GetComponent(62, 0) != 1 ||
    reader->GetErrorCode() != vtkErrorCode::FileNotFoundError;
}
"""


def main():
    settings = arguments()
    prefix, target = settings.folder / "prefix", settings.folder / "module"
    target.mkdir(parents=True, exist_ok=True)
    run(settings.cmake, "-S", ROOT, "-B", target, "-G", settings.generator,
        f"-DCMAKE_BUILD_TYPE={settings.config}", "-DBUILD_SHARED_LIBS=OFF",
        "-DWINDING_MODULE_ONLY=ON", "-DWINDING_TESTS=OFF", "-DWINDING_PRECOMPILE=ON",
        f"-DCMAKE_CXX_FLAGS={settings.flags}")
    run(settings.cmake, "--build", target, "--parallel", str(os.cpu_count()))
    run(settings.cmake, "--install", target, "--prefix", emptied(prefix))
    settings.prefix = prefix
    consumer = emptied(settings.folder / "consumer")
    (consumer / "CMakeLists.txt").write_text(PROJECT)
    (consumer / "main.cxx").write_text(PROGRAM)
    build(settings, consumer, consumer / "build")
    run(consumer / "build" / "program")
    if list(prefix.rglob("libvtk*Winding.so*")):
        raise SystemExit("a module is a shared library")


if __name__ == "__main__":
    main()
