# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Loads VTK and then the compiled modules, which fit the minor version they were built against."""

import importlib

from ._built import VTK_MINOR

# The modules of VTK that the compiled ones depend on, as filters/*/vtk.module name them. Their
# libraries have to be loaded before it where the system does not look next to VTK's wrappers.
DEPENDENCIES = (
    "vtkCommonCore",
    "vtkCommonDataModel",
    "vtkCommonExecutionModel",
    "vtkCommonMisc",
    "vtkFiltersCore",
    "vtkFiltersExtraction",
    "vtkFiltersGeneral",
    "vtkFiltersGeometry",
    "vtkParallelCore",
)

MODULES = ("vtkFiltersWinding", "vtkIOWinding")

_REMEDY = f"this vtk-winding-native needs VTK {VTK_MINOR} (with pip: vtk=={VTK_MINOR}.*)"


def load():
    """Imports what the package needs, and raises an ImportError that says which VTK is missing."""
    try:
        from vtkmodules.vtkCommonCore import vtkVersion
    except ImportError as error:
        raise ImportError(f"{_REMEDY}: there is none here ({error})") from error
    found = f"{vtkVersion.GetVTKMajorVersion()}.{vtkVersion.GetVTKMinorVersion()}"
    if found != VTK_MINOR:
        raise ImportError(f"{_REMEDY}: the one here is {vtkVersion.GetVTKVersion()}")
    try:
        for name in DEPENDENCIES:
            importlib.import_module("vtkmodules." + name)
        for name in MODULES:
            importlib.import_module("." + name, __package__)
    except ImportError as error:
        raise ImportError(
            f"{_REMEDY}: it does not fit {vtkVersion.GetVTKVersion()} ({error})") from error
