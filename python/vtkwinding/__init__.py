"""Winding numbers of surfaces that need not be closed, and of oriented points, for VTK.

The filters, such as vtkWindingNumberField, are in vtkwinding.vtkFiltersWinding.
"""

from . import _vtk
from ._built import VERSION as __version__

_vtk.load()
