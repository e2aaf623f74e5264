"""Winding numbers of surfaces that need not be closed, and of oriented points.

For NumPy arrays there is Field, which is built once and asked often, and functions for one question:
winding_number(), contains(), signed_distance(), field() and surface() (see vtkwinding.fields and
vtkwinding.arrays). They need NumPy alone. For meshes of PyVista there is mesh.winding (see
vtkwinding.accessor), and the filters of VTK, such as vtkWindingNumberField, are in
vtkwinding.vtkFiltersWinding: both need the VTK that the package was built for.
"""

from . import _vtk
from ._built import VERSION as __version__

_vtk.load_if_it_fits()

from ._errors import WindingError, WindingWarning  # noqa: E402
from .arrays import contains, field, signed_distance, surface, winding_number  # noqa: E402
from .fields import (  # noqa: E402
    Field,
    Grid,
    estimate_normals,
    fix_orientation,
    labels,
    point_areas,
    read,
    report,
)

__all__ = [
    "Field",
    "Grid",
    "WindingError",
    "WindingWarning",
    "__version__",
    "contains",
    "estimate_normals",
    "field",
    "fix_orientation",
    "labels",
    "point_areas",
    "read",
    "report",
    "signed_distance",
    "surface",
    "winding_number",
]
