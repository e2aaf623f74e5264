"""Winding numbers of surfaces that need not be closed, and of oriented points, for VTK.

For NumPy arrays there are winding_number(), contains(), signed_distance(), field() and surface()
(see vtkwinding.arrays), for meshes of PyVista there is mesh.winding (see vtkwinding.accessor). The
filters of VTK, such as vtkWindingNumberField, are in vtkwinding.vtkFiltersWinding.
"""

from . import _vtk
from ._built import VERSION as __version__

_vtk.load()

from ._run import WindingError, WindingWarning  # noqa: E402
from .arrays import (  # noqa: E402
    Grid,
    contains,
    field,
    signed_distance,
    surface,
    winding_number,
)

__all__ = [
    "Grid",
    "WindingError",
    "WindingWarning",
    "__version__",
    "contains",
    "field",
    "signed_distance",
    "surface",
    "winding_number",
]
