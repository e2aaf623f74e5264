# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Winding for pipelines of VTK: the filters are in vtkwinding_native.vtkFiltersWinding, and the
reader in vtkwinding_native.vtkIOWinding.

They work with the minor version of VTK that they were built for. With any other, the import says
which one is needed. The package vtkwinding needs none of them.
"""

from . import _vtk
from ._built import VERSION as __version__

_vtk.load()

__all__ = ["__version__"]
