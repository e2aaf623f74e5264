# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""What find_package(vtkWinding) and pkg-config give to programs, and what they refuse."""

import os
import subprocess

from consumers import arguments, build, emptied, run, version

PROJECT = """\
cmake_minimum_required(VERSION 3.25)
project(consumer LANGUAGES C CXX)
find_package(vtkWinding REQUIRED @COMPONENTS@)
add_executable(program main.cxx)
target_link_libraries(program PRIVATE Winding::FiltersWinding)
"""
PROGRAM = """\
#include <vtkNew.h>
#include <vtkWindingNumberField.h>
#include <vtkWindingVersion.h>

#include <cstring>

static_assert(VTK_WINDING_VERSION_MAJOR * 10000 + VTK_WINDING_VERSION_MINOR * 100 +
  VTK_WINDING_VERSION_PATCH == @NUMBER@, "the header has the version of the package");

int main()
{
  vtkNew<vtkWindingNumberField> field;
  field->SetMethodToRows();
  return std::strcmp(field->GetMethodAsString(), "Rows") != 0 ||
    std::strcmp(VTK_WINDING_VERSION, "@VERSION@") != 0;
}
"""
OTHER_VTK = """\
set(VTK_VERSION 9.99.0)
set(VTK_MAJOR_VERSION 9)
set(VTK_MINOR_VERSION 99)
set(VTK_FOUND TRUE)
"""


def project(folder, components=""):
    emptied(folder)
    (folder / "CMakeLists.txt").write_text(PROJECT.replace("@COMPONENTS@", components))
    major, minor, patch = version().split(".")
    number = str(int(major) * 10000 + int(minor) * 100 + int(patch))
    (folder / "main.cxx").write_text(
        PROGRAM.replace("@VERSION@", version()).replace("@NUMBER@", number))
    return folder


def refusal(settings, source, *options):
    """What CMake says when it cannot configure a project."""
    done = subprocess.run(
        [settings.cmake, "-S", source, "-B", emptied(source / "build"), "-G", settings.generator,
         f"-DCMAKE_PREFIX_PATH={settings.prefix}", f"-DVTK_DIR={settings.vtk}", *options],
        capture_output=True, text=True)
    if done.returncode == 0:
        raise SystemExit(f"{source}: it was configured\n{done.stdout}")
    return " ".join(done.stderr.split())


def require(text, part):
    if part not in text:
        raise SystemExit(f"'{part}' is not in: {text}")


def main():
    settings = arguments()
    # Programs in C++ need nothing of Python, whatever else was built.
    found = project(settings.folder / "found")
    build(settings, found, found / "build", "-DCMAKE_DISABLE_FIND_PACKAGE_Python3=ON")
    run(found / "build" / "program")

    require(refusal(settings, project(settings.folder / "components", "COMPONENTS Nonsense")),
            "it has no components, and one is asked for: Nonsense")

    other = project(settings.folder / "other")
    (other / "VTKConfig.cmake").write_text(OTHER_VTK)
    (other / "VTKConfigVersion.cmake").write_text(
        "set(PACKAGE_VERSION 9.99.0)\nset(PACKAGE_VERSION_COMPATIBLE TRUE)\n")
    text = refusal(settings, other, f"-DVTK_DIR={other}")
    require(text, f"and VTK 9.99.0 is in {other}; build it against this one")

    folder = next(settings.prefix.rglob("vtkWinding.pc")).parent
    flags = subprocess.run(
        ["pkg-config", "--cflags", "--libs", "vtkWinding"], check=True, capture_output=True,
        text=True, env={**os.environ, "PKG_CONFIG_PATH": str(folder)})
    words = flags.stdout.split()
    folders = [f"-Wl,-rpath,{word[2:]}" for word in words if word.startswith("-L")]
    run("c++", *settings.flags.split(), "-std=c++17", "main.cxx", "-o", "program", *words, *folders,
        folder=found)
    run(found / "program")

    if not list(settings.prefix.rglob("LICENSE")):
        raise SystemExit("the licence is not installed")


if __name__ == "__main__":
    main()
